//! The numbers that points consist of.

use std::fmt::Debug;

use refinable_algebra::{Rational, Ring, decimal, parse_rational, rational};

/// A coordinate of a point: `f64` for drawing, [`Rational`] where every digit counts. One generic
/// code refines both.
pub trait Coordinate: Clone + PartialEq + Debug + Send + Sync + 'static {
    /// Whether no digit is ever lost.
    const EXACT: bool;

    /// Zero.
    fn origin() -> Self;
    /// The rational number, or the float nearest to it.
    fn from_rational(x: &Rational) -> Self;
    /// `weight · x`.
    fn product(weight: &Self, x: &Self) -> Self;
    /// `self += weight · x`.
    fn add_product(&mut self, weight: &Self, x: &Self);
    /// Whether it is a number; sums of floats may be infinite, or not even that.
    fn is_finite(&self) -> bool;
    /// Reads `7`, `-0.05`, `.5`, `1.`, `+1/3` or `2.5e-3`; `None` for anything else, infinities included, and for a
    /// fraction, or any number that is kept exactly, of more than 2000 characters.
    fn parse(text: &str) -> Option<Self>;
    /// As text that [`parse`](Self::parse) reads back without a loss.
    fn text(&self) -> String;
    /// The bytes that a coordinate takes after so many steps with weights whose common denominator
    /// has so many bits; about, for numbers that grow.
    fn bytes(steps: u32, bits: u64) -> u64;
}

impl Coordinate for f64 {
    const EXACT: bool = false;

    fn origin() -> Self {
        0.0
    }

    fn from_rational(x: &Rational) -> Self {
        // By twenty digits: the nearest float, or, for a number beside the middle of two, the other one.
        decimal(x, 20).parse().unwrap_or(0.0)
    }

    fn product(weight: &Self, x: &Self) -> Self {
        weight * x
    }

    fn add_product(&mut self, weight: &Self, x: &Self) {
        *self += weight * x;
    }

    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn parse(text: &str) -> Option<Self> {
        if text.contains('/') {
            let exact = parse_rational(unsigned_plus(text)?)?;
            return Some(f64::from_rational(&exact)).filter(Coordinate::is_finite);
        }
        let is_decimal = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
        let decimal = text.chars().all(is_decimal).then_some(text)?;
        decimal.parse().ok().filter(|x: &f64| x.is_finite())
    }

    fn text(&self) -> String {
        // The shortest text that reads back as the same float; never a negative zero.
        format!("{}", self + 0.0)
    }

    fn bytes(_: u32, _: u64) -> u64 {
        8
    }
}

/// The largest power of ten that is read.
const LARGEST_EXPONENT: i32 = 400;

impl Coordinate for Rational {
    const EXACT: bool = true;

    fn origin() -> Self {
        Ring::zero()
    }

    fn from_rational(x: &Rational) -> Self {
        x.clone()
    }

    fn product(weight: &Self, x: &Self) -> Self {
        weight * x
    }

    fn add_product(&mut self, weight: &Self, x: &Self) {
        *self += weight * x;
    }

    fn is_finite(&self) -> bool {
        true
    }

    fn parse(text: &str) -> Option<Self> {
        let text = unsigned_plus(text)?;
        let Some((mantissa, exponent)) = text.split_once(['e', 'E']) else {
            return parse_decimal(text);
        };
        let exponent: i32 = exponent.parse().ok().filter(|e: &i32| e.abs() <= LARGEST_EXPONENT)?;
        let mantissa = parse_decimal(mantissa).filter(|_| !mantissa.contains('/'))?;
        let power = rational(10, 1).power(exponent.unsigned_abs());
        Some(if exponent < 0 { mantissa / power } else { mantissa * power })
    }

    fn text(&self) -> String {
        self.to_string()
    }

    fn bytes(steps: u32, bits: u64) -> u64 {
        // Two big integers, a numerator and a denominator of some words more each step.
        64 + 2 * (u64::from(steps) * bits).div_ceil(8)
    }
}

/// The longest number that is read exactly; time grows with the square of its length.
pub(crate) const LONGEST: usize = 2000;

/// The text without a plus before it; `None` for two signs, and for a text that is too long.
fn unsigned_plus(text: &str) -> Option<&str> {
    match text.strip_prefix('+') {
        _ if text.len() > LONGEST => None,
        Some(rest) => (!rest.starts_with(['+', '-'])).then_some(rest),
        None => Some(text),
    }
}

/// Decimals may begin or end with their point.
fn parse_decimal(text: &str) -> Option<Rational> {
    let (sign, digits) = text.strip_prefix('-').map_or(("", text), |digits| ("-", digits));
    if digits == "." {
        return None;
    }
    let before = if digits.starts_with('.') { "0" } else { "" };
    let after = if digits.ends_with('.') { "0" } else { "" };
    parse_rational(&format!("{sign}{before}{digits}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_of_numbers_read_the_same_texts() {
        for text in
            ["7", "-0.05", ".5", "-.5", "1.", "+1/3", "-1/4", "2.5e-3", "1e+2", "+2", "00.10"]
        {
            let exact = Rational::parse(text).unwrap_or_else(|| panic!("{text}"));
            let float = f64::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(f64::from_rational(&exact), float, "{text}");
        }
        for text in [
            "", ".", "-", "+", "+-5", "--5", "1e", "e5", "1/0", "1/2e3", "nan", "inf", "0x1",
            "1_0", "1 2",
        ] {
            assert_eq!(Rational::parse(text), None, "{text}");
            assert_eq!(f64::parse(text), None, "{text}");
        }
    }
}
