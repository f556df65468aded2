//! Bernstein forms in fixed point, with a known error: fast enclosures for searches whose answers
//! are then solved exactly.

use refinable_algebra::{Integer, Polynomial, binomial, bit_length};

use crate::bernstein::Bernstein;

/// Bernstein coefficients as multiples of a unit; the unit and a bound for the error of every
/// coefficient, in units, are common to all forms that were rounded together.
#[derive(Clone, Debug)]
pub struct RoundedBernstein {
    coefficients: Vec<i128>,
}

/// Bits that a coefficient may have at first, which leaves room for the conversion and for sums.
const BITS: i64 = 96;
/// The highest degree for which the direct conversion keeps that room.
const LARGEST_DEGREE: usize = 20;

impl RoundedBernstein {
    /// The forms of several polynomials on `[0, 2^radius]`, or with `mirrored` on `[-2^radius, 0]`, from
    /// left to right, all of formal degree `degree`, and their error; `None` above degree 20.
    ///
    /// With `p = Σ a_k u^k` on `[0, 1]`, `b_j = Σ_k C(j,k)/C(n,k) a_k`. Both divisions are rounded,
    /// which costs less than 2 units for each `k`, in all at most `2 Σ C(j,k) ≤ 2^(n+1)`.
    pub fn around_zero(
        polynomials: &[&Polynomial<Integer>],
        degree: usize,
        radius: i64,
        mirrored: bool,
    ) -> Option<(Vec<Self>, i128)> {
        if degree > LARGEST_DEGREE {
            return None;
        }
        let terms = polynomials.iter().flat_map(|p| p.coefficients().iter().enumerate());
        let bits = terms.map(|(k, c)| bit_length(c) as i64 + radius * k as i64).max().unwrap_or(0);
        let shift = BITS - bits;
        let binomials: Vec<Integer> =
            (0..=degree as u32).map(|k| binomial(degree as u32, k)).collect();
        let form = |p: &&Polynomial<Integer>| {
            let mut b = vec![0_i128; degree + 1];
            for (k, c) in p.coefficients().iter().enumerate() {
                let a = small(&(shifted(c, radius * k as i64 + shift) / &binomials[k]));
                b[k] = if mirrored && k % 2 == 1 { -a } else { a };
            }
            // Σ_k C(j,k) b_k by repeated addition.
            for start in (0..degree).rev() {
                for k in start + 1..=degree {
                    b[k] += b[k - 1];
                }
            }
            if mirrored {
                b.reverse();
            }
            RoundedBernstein { coefficients: b }
        };
        Some((polynomials.iter().map(form).collect(), 2 << degree))
    }

    /// Exact forms on one interval, rounded together, and their error.
    pub fn of_exact(forms: &[Bernstein]) -> (Vec<Self>, i128) {
        let all = forms.iter().flat_map(Bernstein::coefficients);
        let shift = BITS - all.map(bit_length).max().unwrap_or(0) as i64;
        let rounded = |form: &Bernstein| RoundedBernstein {
            coefficients: form.coefficients().iter().map(|b| small(&shifted(b, shift))).collect(),
        };
        (forms.iter().map(rounded).collect(), 1)
    }

    /// The coefficients in units.
    pub fn coefficients(&self) -> &[i128] {
        &self.coefficients
    }

    /// The forms on the two halves of the interval (de Casteljau), in the same unit; the error grows
    /// by at most one unit for each of the `n` averages a coefficient goes through.
    pub fn split(&self) -> (Self, Self) {
        let n = self.coefficients.len();
        let mut right = self.coefficients.clone();
        let mut left = Vec::with_capacity(n);
        for end in (0..n).rev() {
            left.push(right[0]);
            for k in 0..end {
                right[k] = (right[k] + right[k + 1]) >> 1;
            }
        }
        (RoundedBernstein { coefficients: left }, RoundedBernstein { coefficients: right })
    }
}

/// `⌊c · 2^exponent⌋`.
fn shifted(c: &Integer, exponent: i64) -> Integer {
    if exponent >= 0 { c << exponent } else { c >> -exponent }
}

fn small(c: &Integer) -> i128 {
    i128::try_from(c).expect("the shift keeps coefficients small")
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{Ordered, Rational, integer, rational};

    /// Against the exact forms, for a polynomial with coefficients of very different size: the
    /// ratio of the two is one number, within the error.
    #[test]
    fn rounded_coefficients_stay_within_their_error() {
        let p = Polynomial::new([-7, 1 << 40, 3, -(1 << 50), 11].map(integer).to_vec());
        for mirrored in [false, true] {
            let ends = if mirrored { [(-1, 8), (0, 1)] } else { [(0, 1), (1, 8)] };
            let [lower, upper] = ends.map(|(p, q)| rational(p, q));
            let exact = Bernstein::new(&p, 4, &lower, &upper);
            let direct = RoundedBernstein::around_zero(&[&p], 4, -3, mirrored).unwrap();
            // The largest a_k, 2^50/8^3, has 42 bits: a unit is 2^(42-96); and n! q^n = 24 · 8^4.
            let unit = rational(1, 24 * 4096) * integer(1 << 54);
            check(&exact, direct.0[0].clone(), direct.1, &unit);
            let (rounded, error) = RoundedBernstein::of_exact(std::slice::from_ref(&exact));
            let largest = exact.coefficients().iter().map(bit_length).max().unwrap();
            let unit = Rational::from(integer(1) << (96 - largest));
            check(&exact, rounded[0].clone(), error, &unit);
        }
    }

    fn check(exact: &Bernstein, form: RoundedBernstein, error: i128, unit: &Rational) {
        let (mut exact, mut form, mut unit) = (exact.clone(), form, unit.clone());
        for depth in 0..5 {
            let allowed = Rational::from(Integer::from(error + 4 * depth));
            for (rounded, b) in form.coefficients().iter().zip(exact.coefficients()) {
                let off = Rational::from(b.clone()) * &unit - Integer::from(*rounded);
                assert!(off.absolute() <= allowed, "{off} at depth {depth}");
            }
            form = form.split().1;
            exact = exact.split().1;
            unit /= integer(16);
        }
    }

    #[test]
    fn degrees_beyond_the_room_are_refused() {
        let p = Polynomial::new([1, 1].map(integer).to_vec());
        let made = |degree| RoundedBernstein::around_zero(&[&p], degree, 0, false).is_some();
        assert!(made(1) && made(LARGEST_DEGREE));
        assert!(!made(LARGEST_DEGREE + 1) && !made(LARGEST_DEGREE + 7));
    }
}
