//! Laurent polynomials in `z`, dense, over any ring: the symbols of subdivision schemes.

use crate::polynomial::Polynomial;
use crate::ring::Ring;

/// `z^lowest · polynomial(z)`; the polynomial has a nonzero constant term (`lowest = 0` for zero).
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Laurent<R> {
    lowest: i64,
    polynomial: Polynomial<R>,
}

impl<R: Ring> Laurent<R> {
    /// `Σ_k coefficients[k] z^(lowest + k)`; zeros at both ends are cut.
    pub fn new(lowest: i64, coefficients: Vec<R>) -> Self {
        let zeros = coefficients.iter().take_while(|c| c.is_zero()).count();
        if zeros == coefficients.len() {
            return Laurent { lowest: 0, polynomial: Polynomial::zero() };
        }
        let kept = coefficients.into_iter().skip(zeros).collect();
        Laurent { lowest: lowest + zeros as i64, polynomial: Polynomial::new(kept) }
    }

    /// `c z^exponent`.
    pub fn monomial(c: R, exponent: i64) -> Self {
        Laurent::new(exponent, vec![c])
    }

    /// The exponents `[lo, hi]` of the first and last nonzero coefficient; `None` for zero.
    pub fn support(&self) -> Option<(i64, i64)> {
        let degree = self.polynomial.degree()?;
        Some((self.lowest, self.lowest + degree as i64))
    }

    /// The exponent of the first nonzero coefficient; 0 for zero.
    pub fn lowest(&self) -> i64 {
        self.lowest
    }

    /// The coefficients from `lowest()` on.
    pub fn coefficients(&self) -> &[R] {
        self.polynomial.coefficients()
    }

    /// The polynomial `z^(-lowest) · self`.
    pub fn polynomial(&self) -> &Polynomial<R> {
        &self.polynomial
    }

    /// The coefficient of `z^exponent`.
    pub fn coefficient(&self, exponent: i64) -> R {
        usize::try_from(exponent - self.lowest)
            .map_or_else(|_| R::zero(), |k| self.polynomial.coefficient(k))
    }

    /// The pairs `(exponent, coefficient)` over the support, zeros inside included.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (i64, &R)> {
        self.coefficients().iter().enumerate().map(|(k, c)| (self.lowest + k as i64, c))
    }

    /// `z^k · self`.
    pub fn shifted(&self, k: i64) -> Self {
        if self.is_zero() {
            self.clone()
        } else {
            Laurent { lowest: self.lowest + k, ..self.clone() }
        }
    }

    /// `self(z^k)` for `k ≥ 1`: the symbol on a lattice `k` times as coarse.
    ///
    /// # Panics
    /// If `k` is zero.
    pub fn dilated(&self, k: usize) -> Self {
        assert!(k > 0, "z^0 is not a variable");
        let Some(degree) = self.polynomial.degree() else {
            return self.clone();
        };
        let mut spread = vec![R::zero(); degree * k + 1];
        for (i, c) in self.coefficients().iter().enumerate() {
            spread[i * k] = c.clone();
        }
        Laurent::new(self.lowest * k as i64, spread)
    }

    /// `self(1/z)`: the mask reversed about index 0.
    pub fn reversed(&self) -> Self {
        let Some((_, highest)) = self.support() else {
            return self.clone();
        };
        Laurent::new(-highest, self.coefficients().iter().rev().cloned().collect())
    }

    /// The derivative `d/dz`.
    pub fn derivative(&self) -> Self {
        let scaled = self.terms().map(|(k, c)| c.times(&R::from_i64(k))).collect();
        Laurent::new(self.lowest - 1, scaled)
    }

    /// `c · self`.
    pub fn scaled(&self, c: &R) -> Self {
        self.map(|a| a.times(c))
    }

    /// The Laurent polynomial with `f` applied to every coefficient.
    pub fn map<S: Ring>(&self, f: impl FnMut(&R) -> S) -> Laurent<S> {
        Laurent::new(self.lowest, self.coefficients().iter().map(f).collect())
    }

    /// Division by `σ(z)^times` with `σ(z) = 1 + z + … + z^(arity-1)`: `(q, r)` with
    /// `self = q · σ^times + r`; `q` starts at the same exponent as `self`, and `z^(-lowest) r` is
    /// a polynomial of degree below `times · (arity - 1)`. `r = 0` iff `σ^times` divides.
    ///
    /// # Cost
    /// At most `times` passes over the coefficients, additions only.
    pub fn divide_by_geometric(&self, arity: usize, times: usize) -> (Self, Self) {
        let sigma = Polynomial::new(vec![R::one(); arity]);
        let mut quotient = self.polynomial.clone();
        let mut remainder = Polynomial::zero();
        let mut power = Polynomial::one();
        for _ in 0..times {
            if quotient.is_zero() {
                break;
            }
            let (q, r) = quotient.divide_by_monic(&sigma);
            remainder.add_product(&power, &r);
            power = power.times(&sigma);
            quotient = q;
        }
        let back = |p: Polynomial<R>| Laurent::new(self.lowest, p.coefficients().to_vec());
        (back(quotient), back(remainder))
    }

    /// The largest `k` for which `σ^k` divides, as above, with an arity of at least two; `None` for zero.
    ///
    /// # Cost
    /// `k + 1` passes over the coefficients, additions only.
    pub fn geometric_order(&self, arity: usize) -> Option<usize> {
        if self.is_zero() {
            return None;
        }
        let sigma = Polynomial::new(vec![R::one(); arity]);
        let (mut rest, mut order) = (self.polynomial.clone(), 0);
        loop {
            let (quotient, remainder) = rest.divide_by_monic(&sigma);
            if !remainder.is_zero() {
                return Some(order);
            }
            (rest, order) = (quotient, order + 1);
        }
    }
}

impl<R: Ring> Ring for Laurent<R> {
    fn zero() -> Self {
        Laurent::new(0, Vec::new())
    }
    fn one() -> Self {
        Laurent::monomial(R::one(), 0)
    }
    fn from_i64(n: i64) -> Self {
        Laurent::monomial(R::from_i64(n), 0)
    }
    fn is_zero(&self) -> bool {
        self.polynomial.is_zero()
    }
    fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let lowest = self.lowest.min(other.lowest);
        let raised = |s: &Self| s.polynomial.shifted((s.lowest - lowest) as usize);
        Laurent::new(lowest, raised(self).plus(&raised(other)).coefficients().to_vec())
    }
    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }
    fn times(&self, other: &Self) -> Self {
        let product = self.polynomial.times(&other.polynomial);
        Laurent::new(self.lowest + other.lowest, product.coefficients().to_vec())
    }
    fn negated(&self) -> Self {
        Laurent { lowest: self.lowest, polynomial: self.polynomial.negated() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Integer, integer};

    fn laurent(lowest: i64, coefficients: &[i64]) -> Laurent<Integer> {
        Laurent::new(lowest, coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn zeros_at_both_ends_are_cut() {
        let a = laurent(-2, &[0, 0, 1, 0, 2, 0]);
        assert_eq!(a.support(), Some((0, 2)));
        assert_eq!(laurent(5, &[0, 0]), Laurent::zero());
        assert_eq!(Laurent::<Integer>::zero().shifted(3), Laurent::zero());
    }

    #[test]
    fn derivative_sees_negative_exponents() {
        // d/dz (z^-2 + 3 + z) = -2 z^-3 + 1
        assert_eq!(laurent(-2, &[1, 0, 3, 1]).derivative(), laurent(-3, &[-2, 0, 0, 1]));
    }

    #[test]
    fn ternary_division_leaves_a_short_remainder() {
        let sigma = laurent(0, &[1, 1, 1]);
        let quotient = laurent(-4, &[2, -1, 5]);
        let remainder = laurent(-4, &[7, 0, 3, 1]);
        let a = quotient.times(&sigma.power(2)).plus(&remainder);
        assert_eq!(a.divide_by_geometric(3, 2), (quotient, remainder));
    }
}
