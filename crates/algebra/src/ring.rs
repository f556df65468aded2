//! The laws that the algorithms of this crate rely on.

use std::cmp::Ordering;
use std::fmt::Debug;

use crate::division::gcd_by_subresultants;
use crate::polynomial::Polynomial;

/// A commutative ring with one.
///
/// The operations are methods on references, not operators, so that one generic algorithm serves
/// machine integers, big numbers and polynomials without bounds on reference types.
pub trait Ring: Clone + PartialEq + Debug + Send + Sync {
    /// The neutral element of addition.
    fn zero() -> Self;
    /// The neutral element of multiplication.
    fn one() -> Self;
    /// The image of `n` under the only ring homomorphism from Z.
    fn from_i64(n: i64) -> Self;
    /// Whether `self` is zero.
    fn is_zero(&self) -> bool;
    /// `self + other`.
    fn plus(&self, other: &Self) -> Self;
    /// `self - other`.
    fn minus(&self, other: &Self) -> Self;
    /// `self · other`.
    fn times(&self, other: &Self) -> Self;
    /// `-self`.
    fn negated(&self) -> Self;

    /// `self += a · b`, the inner step of every product; rings with storage override it.
    fn add_product(&mut self, a: &Self, b: &Self) {
        *self = self.plus(&a.times(b));
    }

    /// `self^exponent` by repeated squaring.
    fn power(&self, exponent: u32) -> Self {
        let (mut result, mut square, mut rest) = (Self::one(), self.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = result.times(&square);
            }
            rest /= 2;
            if rest > 0 {
                square = square.times(&square);
            }
        }
        result
    }
}

/// A commutative ring without zero divisors, in which divisibility can be decided.
pub trait Domain: Ring {
    /// The `q` with `q · divisor = self`, if there is one.
    ///
    /// # Panics
    /// If `divisor` is zero.
    fn divide_exactly(&self, divisor: &Self) -> Option<Self>;

    /// The quotient of a division known to be exact, as in Bareiss elimination and subresultants.
    ///
    /// # Panics
    /// If `divisor` does not divide `self`.
    fn quotient(&self, divisor: &Self) -> Self {
        self.divide_exactly(divisor).expect("the theorem behind this step makes the division exact")
    }
}

/// A domain with greatest common divisors.
pub trait GcdDomain: Domain {
    /// The normalised greatest common divisor; `gcd(0, 0) = 0`.
    fn gcd(&self, other: &Self) -> Self;
    /// The unit `u` such that `self / u` is the chosen representative of its associates:
    /// the sign in Z, the number itself in a field. One for zero.
    fn unit_part(&self) -> Self;

    /// The normalised gcd of two primitive polynomials over this ring that are not zero.
    fn primitive_gcd(a: &Polynomial<Self>, b: &Polynomial<Self>) -> Polynomial<Self> {
        gcd_by_subresultants(a, b)
    }
}

/// An ordered ring.
pub trait Ordered: Ring + Ord {
    /// The sign of `self`: `Less`, `Equal` or `Greater` than zero.
    fn compare_to_zero(&self) -> Ordering;

    /// `|self|`.
    fn absolute(&self) -> Self {
        if self.compare_to_zero() == Ordering::Less { self.negated() } else { self.clone() }
    }
}
