//! Bounded effort: every check counts its steps, and stops where there are too many.

use refinable_algebra::{Integer, Polynomial, Rational, bit_length};

/// Why a check fails, in a short sentence.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Reason(pub String);

/// The result of a check.
pub(crate) type Check<T> = Result<T, Reason>;

/// A failed check.
pub(crate) fn fail<T>(reason: impl Into<String>) -> Check<T> {
    Err(Reason(reason.into()))
}

/// Fails with the reason unless the condition holds.
pub(crate) fn ensure(condition: bool, reason: &str) -> Check<()> {
    if condition { Ok(()) } else { fail(reason) }
}

/// What may be spent on one lemma, in products of machine words: a few seconds.
const ALLOWANCE: u64 = 4_000_000_000;

/// The effort that is left for one lemma.
pub(crate) struct Work {
    left: u64,
}

impl Work {
    /// The effort for one lemma.
    pub fn new() -> Self {
        Work { left: ALLOWANCE }
    }

    /// Takes `steps` from what is left.
    pub fn spend(&mut self, steps: u64) -> Check<()> {
        match self.left.checked_sub(steps) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => fail("could not be checked within the limits"),
        }
    }

    /// Takes `count` products of numbers of `a` and `b` bits. The constant stands for the overhead
    /// of one operation on big numbers.
    pub fn products(&mut self, count: usize, a: u64, b: u64) -> Check<()> {
        let one = (a / 64 + 1).saturating_mul(b / 64 + 1).saturating_add(20);
        self.spend((count as u64).saturating_mul(one))
    }
}

/// The largest bit length of the numbers.
pub(crate) fn largest_bits<'a>(numbers: impl IntoIterator<Item = &'a Integer>) -> u64 {
    numbers.into_iter().map(bit_length).max().unwrap_or(0)
}

/// The bit length of a rational number: of the larger of numerator and denominator.
pub(crate) fn rational_bits(x: &Rational) -> u64 {
    bit_length(x.numer()).max(bit_length(x.denom()))
}

/// The largest bit length of the coefficients.
pub(crate) fn polynomial_bits(polynomial: &Polynomial<Integer>) -> u64 {
    largest_bits(polynomial.coefficients())
}
