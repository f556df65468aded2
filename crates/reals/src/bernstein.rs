//! Polynomials on an interval in Bernstein form.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, integer};

/// `Σ_k b_k C(n,k) u^k (1-u)^(n-k)`, `u` running from 0 to 1 over the interval, up to a positive
/// factor that depends only on the degree `n` and the interval, so that coefficients of several
/// polynomials on one interval may be added and compared.
///
/// Two facts carry everything: the value lies in the convex hull of the `b_k`; and the number of
/// roots in the open interval, with multiplicity, is at most the number of sign variations of the
/// `b_k` and of the same parity (Descartes' rule after a Möbius transformation).
#[derive(Clone, Debug)]
pub struct Bernstein {
    coefficients: Vec<Integer>,
}

impl Bernstein {
    /// The form of `polynomial` with formal degree `degree` on `[lower, upper]`, scaled by
    /// `degree! · q^degree` with `q` the common denominator of the ends.
    ///
    /// # Panics
    /// If `degree` is below the degree of the polynomial.
    ///
    /// # Cost
    /// `degree²/2` products in Z with the numerator of the lower end, none if that is zero; `degree²` additions, and
    /// a few products for each coefficient.
    pub fn new(
        polynomial: &Polynomial<Integer>,
        degree: usize,
        lower: &Rational,
        upper: &Rational,
    ) -> Self {
        assert!(polynomial.degree().is_none_or(|d| d <= degree), "the formal degree is too low");
        let (origin, width, scale) = integer_ends(lower, upper);
        // In y = q x the coefficients are c_k q^(n-k); then y = origin + width · u.
        let mut c: Vec<Integer> = Vec::with_capacity(degree + 1);
        let mut power = integer(1);
        for k in (0..=degree).rev() {
            c.push(polynomial.coefficient(k) * &power);
            power *= &scale;
        }
        c.reverse();
        taylor_shift(&mut c, &origin);
        scale_argument(&mut c, &width);
        Bernstein { coefficients: bernstein_from_monomial(c) }
    }

    /// The coefficients `b_0, …, b_n`; `b_0` and `b_n` are the values at the ends.
    pub fn coefficients(&self) -> &[Integer] {
        &self.coefficients
    }

    /// The number of sign changes in the sequence of the nonzero coefficients.
    pub fn variations(&self) -> usize {
        let mut signs = self.coefficients.iter().map(Ordered::compare_to_zero);
        let mut last = Ordering::Equal;
        let mut count = 0;
        for sign in signs.by_ref().filter(|s| s.is_ne()) {
            count += usize::from(last.is_ne() && last != sign);
            last = sign;
        }
        count
    }

    /// The sign on the closed interval, if all coefficients show the same strict one.
    pub fn constant_sign(&self) -> Option<Ordering> {
        let first = self.coefficients.first()?.compare_to_zero();
        let same = self.coefficients.iter().all(|b| b.compare_to_zero() == first);
        (first.is_ne() && same).then_some(first)
    }

    /// The forms on the two halves of the interval (de Casteljau), both scaled by `2^n`.
    pub fn split(&self) -> (Self, Self) {
        let n = self.coefficients.len() - 1;
        let mut row = self.coefficients.clone();
        let (mut left, mut right) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
        for k in 0..=n {
            // `row` holds sums of 2^k coefficients; a factor 2^(n-k) levels the scales.
            left.push(&row[0] << (n - k));
            right.push(&row[row.len() - 1] << (n - k));
            row = row.windows(2).map(|pair| &pair[0] + &pair[1]).collect();
        }
        right.reverse();
        (Bernstein { coefficients: left }, Bernstein { coefficients: right })
    }
}

/// `(a, w, q)` with `lower = a/q`, `upper = (a+w)/q`.
fn integer_ends(lower: &Rational, upper: &Rational) -> (Integer, Integer, Integer) {
    let (scale, ends) = refinable_algebra::clear_denominators([lower, upper].into_iter());
    let width = &ends[1] - &ends[0];
    (ends[0].clone(), width, scale)
}

/// `p(y) → p(y + a)`, by repeated synthetic division.
fn taylor_shift(c: &mut [Integer], a: &Integer) {
    if a.is_zero() {
        return;
    }
    for start in 0..c.len() {
        for k in (start..c.len().saturating_sub(1)).rev() {
            let carry = &c[k + 1] * a;
            c[k] += carry;
        }
    }
}

/// `p(u) → p(w u)`.
fn scale_argument(c: &mut [Integer], w: &Integer) {
    let mut power = integer(1);
    for c in c.iter_mut() {
        *c *= &power;
        power *= w;
    }
}

/// From `Σ a_k u^k` to `n! b_j = Σ_k C(j,k) · k! (n-k)! a_k`, the sums by repeated addition.
fn bernstein_from_monomial(mut a: Vec<Integer>) -> Vec<Integer> {
    let n = a.len().saturating_sub(1);
    let mut factorials = vec![integer(1)];
    for k in 1..=n {
        let next = &factorials[k - 1] * integer(k as i64);
        factorials.push(next);
    }
    for (k, a) in a.iter_mut().enumerate() {
        *a *= &factorials[k] * &factorials[n - k];
    }
    for start in (0..n).rev() {
        for k in start + 1..=n {
            let below = a[k - 1].clone();
            a[k] += below;
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn the_square_on_an_interval() {
        // u² on [-1, 3]: x = 4u - 1, x² has Bernstein coefficients 1, -3, 9; scaled by 2!.
        let form = Bernstein::new(&poly(&[0, 0, 1]), 2, &rational(-1, 1), &rational(3, 1));
        assert_eq!(form.coefficients(), [integer(2), integer(-6), integer(18)]);
        assert_eq!(form.variations(), 2);
    }

    #[test]
    fn degree_elevation_keeps_the_polynomial() {
        // 1 + 2x on [0,1] as a cubic: 1, 5/3, 7/3, 3, times 3! = 6.
        let form = Bernstein::new(&poly(&[1, 2]), 3, &rational(0, 1), &rational(1, 1));
        assert_eq!(form.coefficients(), [6, 10, 14, 18].map(integer));
    }

    #[test]
    fn halves_agree_with_fresh_forms() {
        let p = poly(&[3, -7, 0, 5, 1]);
        let (lo, mid, hi) = (rational(-2, 3), rational(1, 6), rational(1, 1));
        let (left, right) = Bernstein::new(&p, 4, &lo, &hi).split();
        for (half, a, b) in [(left, &lo, &mid), (right, &mid, &hi)] {
            let fresh = Bernstein::new(&p, 4, a, b);
            let ratio =
                Rational::new(half.coefficients()[0].clone(), fresh.coefficients()[0].clone());
            assert!(ratio > rational(0, 1));
            for (x, y) in half.coefficients().iter().zip(fresh.coefficients()) {
                assert_eq!(Rational::from(x.clone()), &ratio * Rational::from(y.clone()));
            }
        }
    }
}
