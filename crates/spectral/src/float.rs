//! From exact numbers to floats and back. Floats only ever search; what they find is checked.

use refinable_algebra::{Integer, Rational, Ring, bit_length, integer};
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
    if *x == Rational::zero().into() {
        return 0.0;
    }
    let (lower, upper) = x.relative_enclosure(80);
    approximate(&((lower + upper) / integer(2)))
}

/// `x` rounded to so many leading bits, 53 at the most; `None` if it is zero, not finite or so small that a float
/// has fewer bits for it.
pub(crate) fn leading_bits(x: f64, bits: i32) -> Option<Rational> {
    if !x.is_normal() {
        return None;
    }
    // As a float has it: `2^exponent ≤ |x| < 2^(exponent + 1)`.
    let exponent = (x.to_bits() >> 52 & 0x7ff) as i32 - 1023;
    let mantissa = (x * 2f64.powi(-exponent) * 2f64.powi(bits - 1)).round();
    let mantissa = Rational::from(Integer::from(mantissa as i64));
    let power = exponent - (bits - 1);
    let scale = Rational::from(integer(1) << power.unsigned_abs());
    Some(if power < 0 { mantissa / scale } else { mantissa * scale })
}

/// The multiple of `2^-bits` nearest to `x`.
pub(crate) fn dyadic(x: f64, bits: u32) -> Rational {
    let scaled = x * 2f64.powi(bits as i32);
    match leading_bits(x, 53) {
        // It is one itself.
        Some(exact) if scaled.abs() >= 2f64.powi(53) => exact,
        _ => Rational::new(Integer::from(scaled.round() as i64), integer(1) << bits as usize),
    }
}

/// A short dyadic number within `tolerance` of `x`.
///
/// # Panics
/// If `tolerance` is not positive.
pub(crate) fn short_dyadic(x: f64, tolerance: f64) -> Rational {
    assert!(tolerance > 0.0, "only the number itself is within nothing of it");
    let bits = (-tolerance.log2()).ceil().max(0.0) as u32;
    dyadic(x, bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{Ordered, Polynomial, rational};
    use refinable_reals::real_roots;

    fn power_of_ten(exponent: i32) -> Rational {
        let size = rational(10, 1).power(exponent.unsigned_abs());
        if exponent < 0 { size.recip() } else { size }
    }

    #[test]
    fn leading_bits_are_kept_whatever_the_size() {
        assert_eq!(leading_bits(0.625, 3), Some(rational(5, 8)));
        assert_eq!(leading_bits(-0.625, 2), Some(rational(-3, 4)));
        assert_eq!(leading_bits(1023.0, 4), Some(rational(1024, 1)));
        for exponent in [-307, -100, -20, 0, 20, 100, 308] {
            let exact = power_of_ten(exponent);
            let float = format!("1e{exponent}").parse().expect("a number");
            let found = leading_bits(float, 50).expect("a normal number");
            let error = (&found - &exact) / &exact;
            assert!(error.absolute() < rational(1, 1 << 48), "10^{exponent}");
        }
        for x in [0.0, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE / 2.0] {
            assert_eq!(leading_bits(x, 50), None, "{x}");
        }
    }

    #[test]
    fn roots_are_as_accurate_as_numbers() {
        // x² = 2 / 10^80.
        let square = Polynomial::new(vec![
            -rational(2, 1) * power_of_ten(-80),
            Rational::zero(),
            Rational::one(),
        ]);
        let root = real_roots(&square.cleared().1).pop().expect("two roots");
        assert!((approximate_root(&root) * 1e40 - 2f64.sqrt()).abs() < 1e-15);
        assert_eq!(approximate_root(&Rational::zero().into()), 0.0);
    }

    #[test]
    fn large_numbers_are_multiples_of_small_powers() {
        assert_eq!(dyadic(1e20, 300), power_of_ten(20));
        assert_eq!(dyadic(0.3, 2), rational(1, 4));
        assert_eq!(short_dyadic(-1e20, 1e-300), -power_of_ten(20));
    }

    #[test]
    #[should_panic(expected = "within nothing")]
    fn no_tolerance_at_all() {
        short_dyadic(0.1, 0.0);
    }
}
