//! Logarithms of rational numbers.

use refinable_algebra::{Integer, Rational, Ring, bit_length, integer};

/// Bounds `(lower, upper)` for `log_base(x)`, `x > 0`, about `2^-bits` apart; equal if `x` is a power of the base
/// with an integer exponent.
///
/// # Panics
/// If `x` is not positive or `base < 2`.
///
/// # Cost
/// `bits` squarings of numbers of `2 bits` bits.
///
/// # Source
/// The binary digits of `log₂ x`, `1 ≤ x < 2`, are read off by squaring: the digit is 1 if `x² ≥ 2`.
pub fn logarithm(x: &Rational, base: usize, bits: u32) -> (Rational, Rational) {
    assert!(*x > Rational::zero() && base >= 2, "logarithms of positive numbers");
    if let Some(exponent) = exponent_of(x, &integer(base as i64)) {
        return (exponent.clone(), exponent);
    }
    let (lower, upper) = binary(x, bits + 8);
    if base == 2 {
        return (lower, upper);
    }
    let (below, above) = binary(&Rational::from_i64(base as i64), bits + 8);
    // The divisor is positive; which of its bounds counts depends on the sign.
    let quotient = |x: &Rational, small: &Rational, large: &Rational| {
        if *x < Rational::zero() { x / small } else { x / large }
    };
    (quotient(&lower, &below, &above), quotient(&upper, &above, &below))
}

/// `e` with `x = base^e`, if there is such an integer.
fn exponent_of(x: &Rational, base: &Integer) -> Option<Rational> {
    let one = integer(1);
    let (rest, sign) = match (x.numer(), x.denom()) {
        (numerator, denominator) if *denominator == one => (numerator, 1),
        (numerator, denominator) if *numerator == one => (denominator, -1),
        _ => return None,
    };
    let powers = std::iter::successors(Some(one), |power| Some(power * base));
    let (exponent, power) = powers.enumerate().find(|(_, power)| power >= rest)?;
    (power == *rest).then(|| Rational::from_i64(sign * exponent as i64))
}

fn binary(x: &Rational, bits: u32) -> (Rational, Rational) {
    let mut exponent = bit_length(x.numer()) as i64 - bit_length(x.denom()) as i64;
    let scaled = |exponent: i64| {
        let power = Rational::from(integer(1) << exponent.unsigned_abs() as usize);
        if exponent >= 0 { x / power } else { x * power }
    };
    if scaled(exponent) < Rational::one() {
        exponent -= 1;
    }
    let mantissa = scaled(exponent);
    let precision = 2 * bits as usize + 16;
    let fixed = Rational::from(integer(1) << precision) * &mantissa;
    let lower = digits(fixed.floor().to_integer(), bits, precision, false);
    let upper = digits(fixed.ceil().to_integer(), bits, precision, true);
    let unit = Rational::new(integer(1), integer(1) << bits as usize);
    let whole = Rational::from_i64(exponent);
    let upper = if mantissa == Rational::one() {
        Rational::zero()
    } else {
        (upper + Rational::one()) * &unit
    };
    (&whole + lower * unit, whole + upper)
}

/// The first binary digits of `log₂(m / 2^precision)`, rounding squares down or up.
fn digits(mut m: Integer, bits: u32, precision: usize, up: bool) -> Rational {
    let two = integer(1) << (precision + 1);
    let mut sum = Integer::zero();
    for _ in 0..bits {
        let square = &m * &m;
        let floor = &square >> precision;
        m = if up { floor + integer(1) } else { floor };
        sum <<= 1usize;
        if m >= two {
            sum += integer(1);
            m = if up { (m + integer(1)) >> 1usize } else { m >> 1usize };
        }
    }
    Rational::from(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{Ordered, decimal, rational};

    #[test]
    fn known_logarithms() {
        let (lower, upper) = logarithm(&rational(9, 8), 2, 60);
        assert!(lower <= upper && &upper - &lower < rational(1, 1 << 50));
        assert_eq!(decimal(&lower, 12), "0.169925001442");
        assert_eq!(decimal(&upper, 12), "0.169925001442");
        let (lower, upper) = logarithm(&rational(1, 8), 2, 40);
        assert_eq!((lower, upper), (rational(-3, 1), rational(-3, 1)));
        for (x, base, exponent) in [(rational(1, 27), 3, -3), (rational(100, 1), 10, 2)] {
            let exactly = rational(exponent, 1);
            assert_eq!(logarithm(&x, base, 50), (exactly.clone(), exactly));
        }
        for x in [rational(2, 9), rational(6, 1), rational(1, 6)] {
            let (lower, upper) = logarithm(&x, 3, 50);
            assert!(lower < upper && upper - lower < rational(1, 1 << 40), "{x}");
        }
    }

    /// Whether `log_base(x) ≥ p/q`, by powers: `x^q ≥ base^p`.
    fn is_at_least(x: &Rational, base: usize, p: &Integer, q: u32) -> bool {
        let base = Rational::from_i64(base as i64);
        let power = base.power(u32::try_from(p.absolute()).unwrap());
        let power = if *p < integer(0) { Rational::one() / power } else { power };
        x.power(q) >= power
    }

    /// Bounds are as close as they should be, and rounded outwards to fractions of `2^12` they hold the logarithm.
    #[test]
    fn powers_prove_the_bounds() {
        let parts = 1 << 12;
        let numbers = [(3, 2), (9, 8), (2, 9), (6, 1), (1, 6), (1001, 1), (1, 1001), (1023, 1024)];
        for (x, base) in numbers.iter().flat_map(|&(p, q)| [2, 3, 10].map(|b| (rational(p, q), b)))
        {
            for bits in [0, 3] {
                let (lower, upper) = logarithm(&x, base, bits);
                assert!(&upper - &lower <= rational(1, 1 << bits), "{x} {base} {bits}");
                let [below, above] =
                    [(lower * integer(parts)).floor(), (upper * integer(parts)).ceil()];
                assert!(is_at_least(&x, base, below.numer(), parts as u32), "{x} {base} {bits}");
                assert!(!is_at_least(&x, base, above.numer(), parts as u32), "{x} {base} {bits}");
            }
        }
    }
}
