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

/// Shades of blue from light to dark, told apart in grey as well.
pub(crate) const SHADES: [&str; 8] =
    ["#dbe9f6", "#bad6eb", "#89bedc", "#539ecd", "#2b7bba", "#0b559f", "#083a73", "#05264d"];

/// Bold text with a white rim, legible on every shade.
pub(crate) fn halo([x, y]: [f64; 2], anchor: &str, text: &str) -> String {
    format!(
        "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\" font-weight=\"bold\" \
         stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\">{text}</text>\n"
    )
}
