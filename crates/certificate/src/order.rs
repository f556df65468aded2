//! The order of rational numbers by cross products.
//!
//! The operators of the number type compare continued fractions by recursion, as deep as two
//! numbers agree: too deep for the stack if they come from a hostile file.

use std::cmp::Ordering;

use refinable_algebra::Rational;

/// The order of two numbers.
pub(crate) fn order(a: &Rational, b: &Rational) -> Ordering {
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// `a < b`.
pub(crate) fn less(a: &Rational, b: &Rational) -> bool {
    order(a, b).is_lt()
}

/// `a = b`.
pub(crate) fn equal(a: &Rational, b: &Rational) -> bool {
    a.numer() == b.numer() && a.denom() == b.denom()
}
