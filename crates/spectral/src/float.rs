//! From exact numbers to floats and back. Floats only ever search; what they find is checked.

use refinable_algebra::{Integer, Rational, bit_length, integer};
use refinable_reals::RealAlgebraic;

/// The rational number, rounded to about 60 bits and then to a float.
pub(crate) fn approximate(x: &Rational) -> f64 {
    if *x.numer() == integer(0) {
        return 0.0;
    }
    // Shift the quotient to between 61 and 63 bits.
    let shift = 62 - (bit_length(x.numer()) as i64 - bit_length(x.denom()) as i64);
    let quotient = if shift >= 0 {
        (x.numer() << shift as usize) / x.denom()
    } else {
        x.numer() / (x.denom() << (-shift) as usize)
    };
    let mantissa = i64::try_from(&quotient).expect("63 bits") as f64;
    mantissa * 2f64.powi(-(shift as i32))
}

/// The real algebraic number as a float.
pub(crate) fn approximate_root(x: &RealAlgebraic) -> f64 {
    let (lower, upper) = x.bounds();
    let width = (&upper - &lower) + Rational::new(integer(1), integer(1) << 80usize);
    // Relative accuracy, for numbers not absurdly small.
    let fine = width.min(Rational::new(integer(1), integer(1) << 80usize));
    let (lower, upper) = x.enclosure(&fine);
    approximate(&((lower + upper) / integer(2)))
}

/// The multiple of `2^-bits` nearest to `x`.
pub(crate) fn dyadic(x: f64, bits: u32) -> Rational {
    let scaled = (x * 2f64.powi(bits as i32)).round();
    Rational::new(Integer::from(scaled as i128), integer(1) << bits as usize)
}

/// A short dyadic number within `tolerance > 0` of `x`.
pub(crate) fn short_dyadic(x: f64, tolerance: f64) -> Rational {
    let bits = (-tolerance.log2()).ceil().max(0.0) as u32;
    dyadic(x, bits)
}
