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
    /// Reads `7`, `-0.05`, `1/3` or `2.5e-3`; `None` for anything else, infinities included.
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
        // Twenty digits decide the nearest float but for ties that no mask has.
        decimal(x, 20).parse().unwrap_or(0.0)
    }

    fn product(weight: &Self, x: &Self) -> Self {
        weight * x
    }

    fn add_product(&mut self, weight: &Self, x: &Self) {
        *self += weight * x;
    }

    fn parse(text: &str) -> Option<Self> {
        let is_decimal = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
        if text.chars().all(is_decimal) {
            return text.parse().ok().filter(|x: &f64| x.is_finite());
        }
        parse_rational(text).map(|x| f64::from_rational(&x)).filter(|x| x.is_finite())
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

    fn parse(text: &str) -> Option<Self> {
        let text = text.strip_prefix('+').unwrap_or(text);
        let Some((mantissa, exponent)) = text.split_once(['e', 'E']) else {
            return parse_rational(text);
        };
        let exponent: i32 = exponent.parse().ok().filter(|e: &i32| e.abs() <= LARGEST_EXPONENT)?;
        let ten = rational(if mantissa.contains('/') { return None } else { 10 }, 1);
        let power = ten.power(exponent.unsigned_abs());
        parse_rational(mantissa).map(|x| if exponent < 0 { x / power } else { x * power })
    }

    fn text(&self) -> String {
        self.to_string()
    }

    fn bytes(steps: u32, bits: u64) -> u64 {
        // Two big integers, a numerator and a denominator of some words more each step.
        64 + 2 * (u64::from(steps) * bits).div_ceil(8)
    }
}
