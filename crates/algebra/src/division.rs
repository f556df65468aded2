//! Division of polynomials: remainders, content, gcd, resultant, square-free part.
//!
//! Everything is done without fractions, by pseudo-division and the subresultant sequence, so the
//! same code serves Z, Q and polynomials in further parameters; but the gcd over Z has a faster way.
//!
//! Source: H. Cohen, *A Course in Computational Algebraic Number Theory*, Algorithms 3.1.2, 3.3.1
//! and 3.3.7.

use crate::number::Integer;
use crate::polynomial::Polynomial;
use crate::ring::{Domain, GcdDomain, Ring};

impl<R: Ring> Polynomial<R> {
    /// `(q, r)` with `self = q · divisor + r` and `deg r < deg divisor`.
    ///
    /// # Panics
    /// If `divisor` is not monic.
    pub fn divide_by_monic(&self, divisor: &Self) -> (Self, Self) {
        assert_eq!(divisor.leading(), Some(&R::one()), "the divisor must be monic");
        let low = &divisor.coefficients()[..divisor.coefficients().len() - 1];
        let mut rest = self.coefficients().to_vec();
        let mut quotient = vec![R::zero(); rest.len().saturating_sub(low.len())];
        for k in (0..quotient.len()).rev() {
            let leading = rest.pop().expect("the rest is as long as the quotient still to come");
            for (r, c) in rest[k..].iter_mut().zip(low) {
                *r = r.minus(&leading.times(c));
            }
            quotient[k] = leading;
        }
        (Polynomial::new(quotient), Polynomial::new(rest))
    }
}

impl<R: Domain> Polynomial<R> {
    /// `l^(δ+1) self mod divisor` with `l` the leading coefficient of `divisor` and
    /// `δ = deg self - deg divisor`; `self` itself when `δ < 0`.
    ///
    /// # Panics
    /// If `divisor` is zero.
    pub fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let leading = divisor.leading().expect("division by the zero polynomial");
        let length = divisor.coefficients().len();
        let Some(steps) = (self.coefficients().len() + 1).checked_sub(length) else {
            return self.clone();
        };
        let mut rest = self.clone();
        let mut taken = 0;
        while rest.coefficients().len() >= length {
            let shift = rest.coefficients().len() - length;
            let top = rest.leading().expect("not zero: at least as long as the divisor");
            rest = rest.scaled(leading).minus(&divisor.shifted(shift).scaled(top));
            taken += 1;
        }
        rest.scaled(&leading.power((steps - taken) as u32))
    }
}

impl<R: Domain> Domain for Polynomial<R> {
    fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        let leading = divisor.leading().expect("division by the zero polynomial");
        let length = divisor.coefficients().len();
        let mut rest = self.clone();
        let mut quotient = Polynomial::zero();
        while rest.coefficients().len() >= length {
            let shift = rest.coefficients().len() - length;
            let c = rest.leading()?.divide_exactly(leading)?;
            rest = rest.minus(&divisor.shifted(shift).scaled(&c));
            quotient = quotient.plus(&Polynomial::monomial(c, shift));
        }
        rest.is_zero().then_some(quotient)
    }
}

impl<R: GcdDomain> Polynomial<R> {
    /// The normalised gcd of the coefficients; zero for zero.
    pub fn content(&self) -> R {
        let mut content = R::zero();
        for c in self.coefficients() {
            content = content.gcd(c);
            if content == R::one() {
                break;
            }
        }
        content
    }

    /// `self / (content · unit)`: the representative of `self` up to factors from the coefficient
    /// ring. Over Z: primitive with a positive leading coefficient; over a field: monic.
    pub fn primitive_part(&self) -> Self {
        if self.is_zero() {
            return Polynomial::zero();
        }
        let divisor = self.content().times(&self.leading().expect("not zero").unit_part());
        self.map(|c| c.quotient(&divisor))
    }

    /// The resultant with respect to the variable: zero iff the two have a common factor of
    /// positive degree (or one of them is zero).
    ///
    /// # Cost
    /// `O(deg²)` coefficient operations, on coefficients bounded by those of the subresultants.
    pub fn resultant(&self, other: &Self) -> R {
        let (Some(m), Some(n)) = (self.degree(), other.degree()) else {
            return R::zero();
        };
        if m < n {
            let swapped = other.resultant(self);
            return if m * n % 2 == 1 { swapped.negated() } else { swapped };
        }
        let (mut a, mut b) = (self.clone(), other.clone());
        let (mut g, mut h) = (R::one(), R::one());
        let mut negative = false;
        loop {
            let (m, Some(n)) = (a.degree().expect("never zero"), b.degree()) else {
                return R::zero();
            };
            if n == 0 {
                let last = b.leading().expect("not zero").power(m as u32);
                let result = if m == 0 { R::one() } else { last.quotient(&h.power(m as u32 - 1)) };
                return if negative { result.negated() } else { result };
            }
            negative ^= m * n % 2 == 1;
            subresultant_step(&mut a, &mut b, &mut g, &mut h);
        }
    }

    /// The square-free part: the product of the distinct irreducible factors of positive degree,
    /// primitive and normalised. One for a nonzero constant.
    ///
    /// # Panics
    /// If the polynomial is zero.
    pub fn square_free_part(&self) -> Self {
        let primitive = self.primitive_part();
        let repeated = primitive.gcd(&primitive.derivative());
        primitive.quotient(&repeated).primitive_part()
    }
}

/// One step of the subresultant sequence: `(a, b) ← (b, prem(a, b) / (g h^δ))`.
fn subresultant_step<R: GcdDomain>(
    a: &mut Polynomial<R>,
    b: &mut Polynomial<R>,
    g: &mut R,
    h: &mut R,
) {
    let delta = (a.coefficients().len() - b.coefficients().len()) as u32;
    let remainder = a.pseudo_remainder(b);
    let divisor = g.times(&h.power(delta));
    *a = std::mem::replace(b, remainder.map(|c| c.quotient(&divisor)));
    *g = a.leading().expect("the old divisor is not zero").clone();
    if delta > 0 {
        *h = g.power(delta).quotient(&h.power(delta - 1));
    }
}

/// The primitive gcd of primitive polynomials that are not zero, from their subresultants.
pub(crate) fn gcd_by_subresultants<R: GcdDomain>(
    a: &Polynomial<R>,
    b: &Polynomial<R>,
) -> Polynomial<R> {
    let (a, b) = if a.degree() < b.degree() { (b, a) } else { (a, b) };
    let (mut a, mut b) = (a.clone(), b.clone());
    let (mut g, mut h) = (R::one(), R::one());
    while !b.is_constant() {
        subresultant_step(&mut a, &mut b, &mut g, &mut h);
    }
    if b.is_zero() { a.primitive_part() } else { Polynomial::one() }
}

impl<R: GcdDomain> GcdDomain for Polynomial<R> {
    fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            let nonzero = if self.is_zero() { other } else { self };
            return nonzero.primitive_part().scaled(&nonzero.content());
        }
        let content = self.content().gcd(&other.content());
        R::primitive_gcd(&self.primitive_part(), &other.primitive_part()).scaled(&content)
    }

    fn unit_part(&self) -> Self {
        Polynomial::constant(self.leading().map_or_else(R::one, R::unit_part))
    }
}

/// A nonzero integer polynomial that is square-free and primitive, with a positive leading
/// coefficient: the precondition of root isolation, as a type.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct SquareFree(Polynomial<Integer>);

impl SquareFree {
    /// The square-free part of `polynomial`, which has the same roots, each once.
    ///
    /// # Panics
    /// If the polynomial is zero.
    pub fn part_of(polynomial: &Polynomial<Integer>) -> Self {
        let result = SquareFree(polynomial.square_free_part());
        debug_assert!(result.check_invariants());
        result
    }

    /// The polynomial itself.
    pub fn polynomial(&self) -> &Polynomial<Integer> {
        &self.0
    }

    /// Whether the promise of the type holds.
    pub fn check_invariants(&self) -> bool {
        let p = &self.0;
        p.sign_at_infinity().is_gt()
            && p.content() == Integer::one()
            && p.gcd(&p.derivative()).is_constant()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::integer;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn gcd_keeps_content_and_common_factor() {
        // 6(x-1)(x+2) and 4(x-1)(x²+1)
        let a = poly(&[-12, 6, 6]);
        let b = poly(&[-4, 4, -4, 4]);
        assert_eq!(a.gcd(&b), poly(&[-2, 2]));
        assert_eq!(poly(&[]).gcd(&poly(&[-3])), poly(&[3]));
    }

    #[test]
    fn resultants_of_known_pairs() {
        // Res(x²-2, x-1) = (1)²-2 up to the sign (-1)^(mn) = 1.
        assert_eq!(poly(&[-2, 0, 1]).resultant(&poly(&[-1, 1])), integer(-1));
        // Res(2x+1, 3x+5) = 2·5 - 1·3
        assert_eq!(poly(&[1, 2]).resultant(&poly(&[5, 3])), integer(7));
        // A constant: Res(7, x³) = 7³; and two constants.
        assert_eq!(poly(&[7]).resultant(&poly(&[0, 0, 0, 1])), integer(343));
        assert_eq!(poly(&[7]).resultant(&poly(&[3])), integer(1));
        // The discriminant of x³+px+q is -(4p³+27q²) = -Res(f, f').
        let f = poly(&[5, -3, 0, 1]);
        assert_eq!(f.resultant(&f.derivative()), integer(4 * -27 + 27 * 25));
    }

    #[test]
    fn square_free_part_drops_multiplicities() {
        // -4 (x-1)²(2x+3)³
        let double = poly(&[-1, 1]);
        let triple = poly(&[3, 2]);
        let p = double.power(2).times(&triple.power(3)).scaled(&integer(-4));
        assert_eq!(SquareFree::part_of(&p).polynomial(), &double.times(&triple));
        assert_eq!(SquareFree::part_of(&poly(&[-9])).polynomial(), &poly(&[1]));
    }

    #[test]
    fn monic_division_has_a_short_remainder() {
        let (q, r) = poly(&[1, 2, 3, 4]).divide_by_monic(&poly(&[1, 1, 1]));
        assert_eq!((q, r), (poly(&[-1, 4]), poly(&[2, -1])));
    }
}
