//! Logarithms, enclosed by repeated squaring with outward rounding.

use refinable_algebra::{Integer, Rational, Ring, bit_length, integer};

use crate::order::equal;
use crate::real::Real;
use crate::work::{Check, Work, ensure};

/// The binary places of the result.
const PLACES: u32 = 96;
/// The binary places of the intermediate numbers: each squaring doubles the relative error.
const WORKING: u32 = 256;

/// Rational numbers below and above `log_base x` for positive `x`, at a distance of at most about
/// `2^-95` times the larger of 1 and the logarithm; equal if `x` is a power of the base with an integer exponent.
pub(crate) fn logarithm(x: &Real, base: usize, work: &mut Work) -> Check<(Rational, Rational)> {
    let base = integer(base as i64);
    if let Some(exponent) = x.as_rational().and_then(|x| exponent_of(x, &base)) {
        return Ok((exponent.clone(), exponent));
    }
    let (lower, upper) = binary_logarithm(x, work)?;
    let (small, large) = binary_logarithm(&Real::Rational(Rational::from(base)), work)?;
    let below = if *lower.numer() < Integer::zero() { &small } else { &large };
    let above = if *upper.numer() < Integer::zero() { &large } else { &small };
    Ok((lower / below, upper / above))
}

/// `e` if the number is the power of the base with this integer exponent.
fn exponent_of(x: &Rational, base: &Integer) -> Option<Rational> {
    let one = integer(1);
    let (mut rest, sign) =
        if *x.denom() == one { (x.numer().clone(), 1) } else { (x.denom().clone(), -1) };
    if sign < 0 && *x.numer() != one {
        return None;
    }
    let mut exponent = 0;
    while rest > one && (&rest % base).is_zero() {
        rest /= base;
        exponent += sign;
    }
    (rest == one).then(|| Rational::from(integer(exponent)))
}

/// Rational numbers below and above `log2 x` for positive `x`, at a distance of at most about
/// `2^-95`; equal if `x` is a rational power of two with an integer exponent.
fn binary_logarithm(x: &Real, work: &mut Work) -> Check<(Rational, Rational)> {
    let positive = x.compare(&Real::Rational(Rational::from(integer(0))), work)?.is_gt();
    ensure(positive, "a logarithm of a number that is not positive")?;
    let mut bits = WORKING;
    loop {
        let (lower, upper) = x.enclosure(bits, work)?;
        // Until the enclosure is narrow against the number.
        let places = (lower.numer().bits() + u64::from(bits)).saturating_sub(lower.denom().bits());
        let narrow = *lower.numer() > Integer::zero() && places + 8 >= u64::from(WORKING);
        if narrow || equal(&lower, &upper) {
            return Ok((bound(&lower, false), bound(&upper, true)));
        }
        bits = bits.saturating_mul(2);
        work.spend(u64::from(bits) * u64::from(bits))?;
    }
}

/// `log2 x` rounded downwards or upwards.
fn bound(x: &Rational, upwards: bool) -> Rational {
    let exponent = floor_logarithm(x);
    // The mantissa x / 2^exponent in [1, 2), in fixed point.
    let (numerator, denominator) = if exponent >= 0 {
        (x.numer() << WORKING, x.denom() << exponent.unsigned_abs())
    } else {
        (x.numer() << (u64::from(WORKING) + exponent.unsigned_abs()), x.denom().clone())
    };
    let one = integer(1) << WORKING;
    let mut mantissa = divide(&numerator, &denominator, upwards);
    if &denominator << WORKING == numerator {
        return Rational::from(integer(exponent));
    }
    let mut digits = Integer::zero();
    for _ in 0..PLACES {
        mantissa = divide(&(&mantissa * &mantissa), &one, upwards);
        digits = &digits * 2;
        if mantissa >= &one * 2 {
            digits += 1;
            mantissa = divide(&mantissa, &integer(2), upwards);
        }
    }
    if upwards {
        digits += 1;
    }
    Rational::from(integer(exponent)) + Rational::new(digits, integer(1) << PLACES)
}

/// `⌊log2 x⌋` for positive `x`.
fn floor_logarithm(x: &Rational) -> i64 {
    let guess = bit_length(x.numer()) as i64 - bit_length(x.denom()) as i64;
    // 2^(guess-1) < x < 2^(guess+1)
    let (left, right) = if guess >= 0 {
        (x.numer().clone(), x.denom() << guess.unsigned_abs())
    } else {
        (x.numer() << guess.unsigned_abs(), x.denom().clone())
    };
    if left >= right { guess } else { guess - 1 }
}

/// The quotient of positive integers, rounded.
fn divide(a: &Integer, b: &Integer, upwards: bool) -> Integer {
    if upwards { (a + b - 1) / b } else { a / b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn enclose(p: i64, q: i64) -> (Rational, Rational) {
        binary_logarithm(&Real::Rational(rational(p, q)), &mut Work::new()).unwrap()
    }

    #[test]
    fn powers_of_two_are_exact() {
        assert_eq!(enclose(8, 1), (rational(3, 1), rational(3, 1)));
        assert_eq!(enclose(1, 32), (rational(-5, 1), rational(-5, 1)));
        assert_eq!(enclose(1, 1), (rational(0, 1), rational(0, 1)));
    }

    /// `log_3 2 = 0.630929753571457…` and `log_3 1/2`, whose bounds are divided by the other bound of `log2 3`;
    /// powers of three exactly, also those of which the denominator is no power.
    #[test]
    fn logarithms_to_other_bases() {
        let enclose = |p, q, base| {
            logarithm(&Real::Rational(rational(p, q)), base, &mut Work::new()).unwrap()
        };
        let known = |n: i64| rational(630_929_753_571_457 + n, 1_000_000_000_000_000);
        let near = rational(1, 1 << 62) * rational(1, 1 << 30);
        let (lower, upper) = enclose(2, 1, 3);
        assert!(known(0) < lower && lower < upper && upper < known(1) && &upper - &lower < near);
        let (lower, upper) = enclose(1, 2, 3);
        assert!(-known(1) < lower && lower < upper && upper < -known(0) && &upper - &lower < near);
        for (p, q, base, exponent) in [(27, 1, 3, 3), (1, 9, 3, -2), (1, 36, 6, -2), (1, 1, 5, 0)] {
            assert_eq!(enclose(p, q, base), (rational(exponent, 1), rational(exponent, 1)));
        }
        // No powers: 18, 2/9 and 1/18 have other factors.
        for (p, q) in [(18, 1), (2, 9), (1, 18)] {
            let (lower, upper) = enclose(p, q, 3);
            assert!(lower < upper && upper - lower < near, "{p}/{q}");
        }
    }

    #[test]
    fn the_logarithm_of_three_is_enclosed() {
        // 1.58496250072115618145373894394781650875981440769248…
        let text =
            |n: i64| Rational::new(integer(1_584_962_500_721_156_181) + n, integer(10).power(18));
        for (shift, (lower, upper)) in [(1, enclose(3, 1)), (-1, enclose(3, 4))] {
            let moved = |x: Rational| x + rational(1 - shift, 1);
            let (lower, upper) = (moved(lower), moved(upper));
            assert!(text(0) < lower && lower < upper && upper < text(1));
            assert!(upper - lower < rational(1, 1 << 62) * rational(1, 1 << 30));
        }
    }

    #[test]
    fn whole_parts_and_quotients_are_rounded_as_they_should() {
        for (p, q) in (1..40).flat_map(|p| (1..40).map(move |q| (p, q))) {
            let floor = floor_logarithm(&rational(p, q));
            // 2^floor ≤ p/q < 2^(floor+1).
            let sides = |e: i64| (p << -e.min(0), q << e.max(0));
            let [(left, below), (beside, above)] = [sides(floor), sides(floor + 1)];
            assert!(left >= below && beside < above, "{p}/{q}");
            let [down, up] = [false, true].map(|up| divide(&integer(p), &integer(q), up));
            assert_eq!([down, up], [integer(p / q), integer(-(-p).div_euclid(q))]);
        }
    }
}
