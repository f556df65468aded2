//! The symbols `c^L(z) = Π_{k<L} c(z^(m^k))` of repeated refinement, over any ring.

use refinable_algebra::{Integer, Laurent, Ordered, Polynomial, Ring, bit_length};

/// `c^(L+1)(z) = c(z) · c^L(z^m)`.
///
/// # Cost
/// `length(c)` ring products for every coefficient of `c^L`.
pub fn next_power<R: Ring>(c: &Laurent<R>, power: &Laurent<R>, arity: usize) -> Laurent<R> {
    // The spread-out factor first: products skip the zeros of their left operand.
    power.dilated(arity).times(c)
}

/// The coefficients of `c^L` by residue modulo `m^L`: row `j` holds those with index
/// `≡ j`, counted from the lowest exponent. The norm `‖c^L‖_∞` is the largest sum of their sizes.
pub fn residue_rows<R: Clone>(coefficients: &[R], modulus: usize) -> Vec<Vec<R>> {
    let rows = modulus.min(coefficients.len());
    (0..rows).map(|j| coefficients[j..].iter().step_by(modulus).cloned().collect()).collect()
}

/// The symbols `c, c², …, c^max_level` over Z[t], in machine integers as long as an a-priori bound
/// allows: the sum of the sizes of all coefficients is submultiplicative, so `2^126` bounds every
/// coefficient of `c^L` as soon as it bounds the L-th power of that sum.
pub struct Powers {
    arity: usize,
    small: Option<Laurent<Polynomial<i128>>>,
    /// Bits of the bound for one factor.
    bits: u64,
    symbol: Laurent<Polynomial<Integer>>,
    current: Current,
    level: u64,
}

enum Current {
    Small(Laurent<Polynomial<i128>>),
    Big(Laurent<Polynomial<Integer>>),
}

impl Powers {
    /// The sequence that starts with `c^1 = symbol`.
    pub fn new(symbol: Laurent<Polynomial<Integer>>, arity: usize) -> Self {
        let sizes = symbol.coefficients().iter().flat_map(Polynomial::coefficients);
        let sum = sizes.fold(Integer::zero(), |sum, c| sum + c.absolute());
        let bits = bit_length(&sum);
        let small = (bits < SMALL_BITS).then(|| symbol.map(|p| p.map(to_small)));
        let current = match &small {
            Some(small) => Current::Small(small.clone()),
            None => Current::Big(symbol.clone()),
        };
        Powers { arity, small, bits, symbol, current, level: 1 }
    }

    /// The coefficients of the current power in rows by residue modulo `m^L`.
    pub fn rows(&self) -> Vec<Vec<Polynomial<Integer>>> {
        let modulus = self.arity.pow(self.level as u32);
        match &self.current {
            Current::Big(power) => residue_rows(power.coefficients(), modulus),
            Current::Small(power) => residue_rows(power.coefficients(), modulus)
                .into_iter()
                .map(|row| row.iter().map(|p| p.map(|c| Integer::from(*c))).collect())
                .collect(),
        }
    }

    /// Moves on to the next level.
    pub fn advance(&mut self) {
        self.level += 1;
        let fits = self.bits * self.level < SMALL_BITS;
        self.current = match (&self.current, &self.small) {
            (Current::Small(power), Some(small)) if fits => {
                Current::Small(next_power(small, power, self.arity))
            }
            (Current::Small(power), _) => {
                let power = power.map(|p| p.map(|c| Integer::from(*c)));
                Current::Big(next_power(&self.symbol, &power, self.arity))
            }
            (Current::Big(power), _) => Current::Big(next_power(&self.symbol, power, self.arity)),
        };
    }
}

/// Bits that a machine integer may use, one spared for the sum of two.
const SMALL_BITS: u64 = 126;

fn to_small(c: &Integer) -> i128 {
    i128::try_from(c).expect("the bound was checked")
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::integer;

    fn constants(values: &[i64]) -> Laurent<Polynomial<Integer>> {
        Laurent::new(0, values.iter().map(|&v| Polynomial::constant(integer(v))).collect())
    }

    /// `(1+z)(1+z²)(1+z⁴) = 1 + z + … + z⁷`.
    #[test]
    fn powers_of_the_haar_symbol_are_all_ones() {
        let mut powers = Powers::new(constants(&[1, 1]), 2);
        powers.advance();
        powers.advance();
        let rows = powers.rows();
        assert_eq!(rows.len(), 8);
        assert!(rows.iter().all(|row| row == &[Polynomial::constant(integer(1))]));
    }

    /// Past 126 bits the sequence goes on in big integers with the same values.
    #[test]
    fn the_change_to_big_integers_is_seamless() {
        let big = 1_i64 << 40;
        let mut powers = Powers::new(constants(&[big, 3, -big]), 2);
        for _ in 0..4 {
            powers.advance();
        }
        assert_eq!(powers.rows()[0][0], Polynomial::constant(Integer::from(big).pow(5)));
    }
}
