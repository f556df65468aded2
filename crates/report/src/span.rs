//! Requests such as `NAME=A..B`.

use refinable_algebra::{Rational, parse_rational};

/// What stands before and behind the first `=`.
///
/// # Errors
/// A message if there is none.
pub(crate) fn named(request: &str) -> Result<(&str, &str), String> {
    let (name, rest) = request.split_once('=').ok_or_else(|| format!("`{request}` has no `=`"))?;
    Ok((name.trim(), rest))
}

/// The ends of `A..B`, in any order.
///
/// # Errors
/// A message if it is no interval of rational numbers.
pub(crate) fn parse_span(text: &str) -> Result<[Rational; 2], String> {
    let ends = text
        .split_once("..")
        .and_then(|(a, b)| Some([parse_rational(a.trim())?, parse_rational(b.trim())?]));
    ends.ok_or_else(|| format!("`{text}` is no interval of rational numbers"))
}

/// The ends of `A..B` with `A < B`.
///
/// # Errors
/// A message if it is no such interval.
pub(crate) fn parse_ascending_span(text: &str) -> Result<[Rational; 2], String> {
    let [from, to] = parse_span(text)?;
    if from >= to {
        return Err(format!("{from} is not less than {to}"));
    }
    Ok([from, to])
}
