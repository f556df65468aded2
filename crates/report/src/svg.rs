//! What pictures have in common.

use refinable_algebra::{Rational, decimal};

/// Where ink goes; the decimal text is exact arithmetic.
pub(crate) fn place(x: &Rational) -> f64 {
    decimal(x, 15).parse().unwrap_or(0.0)
}

/// Text that is safe inside of an element.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Digits raised: `2` as `²`; `None` if there is anything else.
pub(crate) fn raised(digits: &str) -> Option<String> {
    let raised = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    digits.chars().map(|c| Some(raised[c.to_digit(10)? as usize])).collect()
}
