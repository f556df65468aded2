//! Exact scalars. The only file of the project that names the `num-*` crates.

use std::cmp::Ordering;

use num_integer::Integer as _;
use num_traits::{One, Pow, Signed, Zero};

use crate::modular_gcd::gcd_by_images;
use crate::polynomial::Polynomial;
use crate::ring::{Domain, GcdDomain, Ordered, Ring};

/// An integer of any size.
pub use num_bigint::BigInt as Integer;
/// A rational number in lowest terms with a positive denominator.
pub use num_rational::BigRational as Rational;

/// The integer `n`.
pub fn integer(n: i64) -> Integer {
    Integer::from(n)
}

/// The rational number `p/q`.
///
/// # Panics
/// If `q` is zero.
pub fn rational(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

/// Reads `7`, `-3/128` or `0.05`, exactly; `None` for anything else, a zero denominator included.
///
/// ```
/// use refinable_algebra::{parse_rational, rational};
/// assert_eq!(parse_rational("-0.05"), Some(rational(-1, 20)));
/// assert_eq!(parse_rational("1/0"), None);
/// ```
pub fn parse_rational(text: &str) -> Option<Rational> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let value = parse_unsigned(digits)?;
    Some(if negative { -value } else { value })
}

fn parse_unsigned(text: &str) -> Option<Rational> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        let denominator = parse_digits(denominator)?;
        let numerator = parse_digits(numerator)?;
        return (!Zero::is_zero(&denominator)).then(|| Rational::new(numerator, denominator));
    }
    match text.split_once('.') {
        None => parse_digits(text).map(Rational::from),
        Some((whole, fraction)) => {
            let scale = Integer::from(10u32).pow(u32::try_from(fraction.len()).ok()?);
            parse_digits(whole).and(parse_digits(fraction))?;
            let digits = parse_digits(&format!("{whole}{fraction}"))?;
            Some(Rational::new(digits, scale))
        }
    }
}

fn parse_digits(text: &str) -> Option<Integer> {
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    text.parse().ok()
}

/// The number of bits of `|n|`; zero for zero.
pub fn bit_length(n: &Integer) -> u64 {
    n.bits()
}

/// `⌊√n⌋` for `n ≥ 0`.
///
/// # Panics
/// If `n` is negative.
pub fn integer_square_root(n: &Integer) -> Integer {
    n.sqrt()
}

/// The least common multiple of two integers, never negative.
pub fn least_common_multiple(a: &Integer, b: &Integer) -> Integer {
    a.lcm(b)
}

/// The binomial coefficient `C(n, k)`.
pub fn binomial(n: u32, k: u32) -> Integer {
    num_integer::binomial(Integer::from(n), Integer::from(k))
}

/// `⌊x · 2^bits⌋ / 2^bits`: the largest dyadic number with that many fractional bits below `x`.
pub fn dyadic_floor(x: &Rational, bits: u32) -> Rational {
    let scale = integer(1) << bits;
    let scaled = (x.numer() * &scale).div_floor(x.denom());
    Rational::new(scaled, scale)
}

/// The common denominator `d > 0` of `values` and the integers `d · values`.
///
/// This is the integer trick of the whole project: clear once, then work in Z.
pub fn clear_denominators<'a>(
    values: impl Iterator<Item = &'a Rational> + Clone,
) -> (Integer, Vec<Integer>) {
    let common = values.clone().fold(integer(1), |d, v| d.lcm(v.denom()));
    let cleared = values.map(|v| v.numer() * (&common / v.denom())).collect();
    (common, cleared)
}

/// `x` rounded half away from zero to `digits ≥ 1` significant decimal digits, as `-0.01982`, or as
/// `1.5e-12` outside 1e-6..1e15. Zeros at the end are cut. The same text on every machine.
///
/// ```
/// use refinable_algebra::{decimal, rational};
/// assert_eq!(decimal(&rational(-2, 3), 5), "-0.66667");
/// assert_eq!(decimal(&rational(1, 1_000_000_000), 5), "1e-9");
/// ```
///
/// # Panics
/// If `digits` is zero.
pub fn decimal(x: &Rational, digits: u32) -> String {
    assert!(digits > 0, "a number has a first digit");
    if Zero::is_zero(x) {
        return "0".into();
    }
    let (mantissa, exponent) = significant(&Signed::abs(x), digits);
    let sign = if Signed::is_negative(x) { "-" } else { "" };
    let text = mantissa.trim_end_matches('0');
    format!("{sign}{}", place_point(text, exponent))
}

/// The first `digits` digits of `x > 0`, rounded, and the decimal exponent of the leading one.
fn significant(x: &Rational, digits: u32) -> (String, i64) {
    let scaled = |exponent: i64| x * power_of_ten(i64::from(digits) - 1 - exponent);
    let whole_digits = |exponent| scaled(exponent).floor().to_integer().to_string().len();
    let mut exponent = (x.numer().bits() as i64 - x.denom().bits() as i64) * 30103 / 100_000;
    while whole_digits(exponent) > digits as usize {
        exponent += 1;
    }
    while scaled(exponent) < power_of_ten(i64::from(digits) - 1) {
        exponent -= 1;
    }
    let rounded = (scaled(exponent) + rational(1, 2)).floor().to_integer().to_string();
    // 9.96 to two digits carries to 10, one digit too many.
    let carry = rounded.len() as i64 - i64::from(digits);
    (rounded[..digits as usize].to_string(), exponent + carry)
}

fn power_of_ten(exponent: i64) -> Rational {
    let power = Integer::from(10u32).pow(exponent.unsigned_abs() as u32);
    if exponent < 0 { Rational::new(integer(1), power) } else { power.into() }
}

fn place_point(digits: &str, exponent: i64) -> String {
    match exponent {
        -6..0 => format!("0.{}{digits}", "0".repeat((-exponent - 1) as usize)),
        0..15 => {
            let whole = exponent as usize + 1;
            if digits.len() <= whole {
                format!("{digits}{}", "0".repeat(whole - digits.len()))
            } else {
                format!("{}.{}", &digits[..whole], &digits[whole..])
            }
        }
        _ if digits.len() == 1 => format!("{digits}e{exponent}"),
        _ => format!("{}.{}e{exponent}", &digits[..1], &digits[1..]),
    }
}

/// The ring operations that std's and num's operators already provide.
macro_rules! ring_by_operators {
    ($type:ty, $from:expr) => {
        impl Ring for $type {
            fn zero() -> Self {
                Zero::zero()
            }
            fn one() -> Self {
                One::one()
            }
            fn from_i64(n: i64) -> Self {
                $from(n)
            }
            fn is_zero(&self) -> bool {
                Zero::is_zero(self)
            }
            fn plus(&self, other: &Self) -> Self {
                self + other
            }
            fn minus(&self, other: &Self) -> Self {
                self - other
            }
            fn times(&self, other: &Self) -> Self {
                self * other
            }
            fn negated(&self) -> Self {
                -self
            }
            fn add_product(&mut self, a: &Self, b: &Self) {
                *self += a * b;
            }
        }

        impl Ordered for $type {
            fn compare_to_zero(&self) -> Ordering {
                self.cmp(&<Self as Zero>::zero())
            }
        }
    };
}

ring_by_operators!(Integer, Integer::from);
ring_by_operators!(Rational, |n: i64| Rational::from(Integer::from(n)));
// Used where an a-priori bound keeps every value below 2^127; an overflow would panic.
ring_by_operators!(i128, i128::from);

impl Domain for Integer {
    fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        let (quotient, remainder) = self.div_rem(divisor);
        Zero::is_zero(&remainder).then_some(quotient)
    }
}

impl GcdDomain for Integer {
    fn gcd(&self, other: &Self) -> Self {
        num_integer::Integer::gcd(self, other)
    }
    fn unit_part(&self) -> Self {
        if Signed::is_negative(self) { integer(-1) } else { integer(1) }
    }
    fn primitive_gcd(a: &Polynomial<Self>, b: &Polynomial<Self>) -> Polynomial<Self> {
        gcd_by_images(a, b)
    }
}

impl Domain for Rational {
    fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        Some(self / divisor)
    }
}

impl GcdDomain for Rational {
    fn gcd(&self, other: &Self) -> Self {
        let both_zero = Zero::is_zero(self) && Zero::is_zero(other);
        if both_zero { Zero::zero() } else { One::one() }
    }
    fn unit_part(&self) -> Self {
        if Zero::is_zero(self) { One::one() } else { self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[should_panic(expected = "a first digit")]
    fn no_digits_at_all() {
        decimal(&rational(1, 3), 0);
    }

    #[test]
    fn decimals_round_half_away_and_keep_their_exponent() {
        assert_eq!(decimal(&rational(0, 1), 6), "0");
        assert_eq!(decimal(&rational(47, 5), 1), "9");
        assert_eq!(decimal(&rational(497, 5), 2), "99");
        assert_eq!(decimal(&rational(1999, 1000), 3), "2");
        assert_eq!(decimal(&rational(12345, 1), 3), "12300");
        assert_eq!(decimal(&rational(-1, 8), 17), "-0.125");
        assert_eq!(decimal(&rational(1, 3_000_000), 4), "3.333e-7");
        assert_eq!(decimal(&Rational::from(integer(10).pow(20u32)), 4), "1e20");
    }

    #[test]
    fn parsing_is_exact_and_strict() {
        assert_eq!(parse_rational("-49/1152"), Some(rational(-49, 1152)));
        assert_eq!(parse_rational("0.001"), Some(rational(1, 1000)));
        for bad in ["", "-", "1/", "/2", "1/-2", ".5", "1.", "1e3", "1_000", "+1", "0x1"] {
            assert_eq!(parse_rational(bad), None, "{bad}");
        }
    }

    #[test]
    fn clearing_denominators_scales_by_the_least_common_one() {
        let values = [rational(1, 6), rational(-3, 4), rational(2, 1)];
        let (common, cleared) = clear_denominators(values.iter());
        assert_eq!(common, integer(12));
        assert_eq!(cleared, [integer(2), integer(-9), integer(24)]);
    }

    #[test]
    fn flooring_to_dyadics_is_from_below() {
        assert_eq!(dyadic_floor(&rational(-1, 3), 2), rational(-1, 2));
        assert_eq!(dyadic_floor(&rational(3, 4), 2), rational(3, 4));
    }
}
