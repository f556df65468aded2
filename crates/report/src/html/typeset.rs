//! Formulas in plain notation as inline HTML: Greek letters, indices, exponents, roots.

use maud::{Escaper, Markup, PreEscaped};
use std::fmt::Write;

use crate::latex::greek_letter;

/// Text in which formulas stand, `proved on ((3-sqrt(3))/64, 5/64)` or `S_{a_3} is C^2`, for people to read.
///
/// Only the signs change: names of Greek letters become letters, `^` and `_` raise and lower, `sqrt(3)` is `√3`,
/// products are set with a narrow space, and what stands between backquotes is code.
pub(super) fn typeset(text: &str) -> Markup {
    let mut html = String::with_capacity(2 * text.len());
    let mut rest = text;
    let mut before = None;
    while let Some(c) = rest.chars().next() {
        let taken = piece(&mut html, rest, before).unwrap_or_else(|| {
            escape(&mut html, &rest[..c.len_utf8()]);
            c.len_utf8()
        });
        before = rest[..taken].chars().next_back();
        rest = &rest[taken..];
    }
    PreEscaped(html)
}

/// Writes what begins a text if it is more than a sign that stands for itself, and says how long it is.
fn piece(html: &mut String, text: &str, before: Option<char>) -> Option<usize> {
    let word = word(text);
    if !word.is_empty() {
        return Some(name(html, text, word));
    }
    let mut after = text.chars().skip(1);
    match (text.chars().next()?, after.next()) {
        ('^', _) => shifted(html, "sup", text),
        ('_', _) => shifted(html, "sub", text),
        ('`', _) => {
            let length = text[1..].find('`')?;
            html.push_str("<code>");
            escape(html, &text[1..=length]);
            html.push_str("</code>");
            Some(length + 2)
        }
        ('*', Some(next)) if !next.is_whitespace() && before.is_some_and(|b| b != ' ') => {
            html.push('\u{202f}');
            Some(1)
        }
        ('-', Some(_)) if is_minus(&text[1..], before) => {
            html.push('−');
            Some(1)
        }
        // What belongs together stays on one line: `2048 alpha`, `≈ 0.5`.
        (' ', _) if is_factor(&text[1..], before) => {
            html.push('\u{202f}');
            Some(1)
        }
        (' ', _) if before == Some('≈') => {
            html.push('\u{a0}');
            Some(1)
        }
        _ => None,
    }
}

/// A word: a root, a Greek letter, or as it stands.
fn name(html: &mut String, text: &str, word: &str) -> usize {
    if word == "sqrt"
        && let Some(length) = enclosed(&text[word.len()..], '(', ')')
    {
        let inner = &text[word.len() + 1..word.len() + length - 1];
        let alone = inner.chars().all(|c| c.is_ascii_digit());
        let radicand = if alone { inner } else { &text[word.len()..word.len() + length] };
        html.push('√');
        html.push_str(&typeset(radicand).into_string());
        return word.len() + length;
    }
    html.push_str(greek_letter(word).unwrap_or(word));
    word.len()
}

/// What follows `^` or `_`: a group in braces or brackets, or a run of letters and digits, perhaps with a sign.
fn shifted(html: &mut String, element: &str, text: &str) -> Option<usize> {
    let rest = &text[1..];
    let (inner, length) = match rest.chars().next()? {
        '{' => enclosed(rest, '{', '}').map(|length| (&rest[1..length - 1], length))?,
        '(' => enclosed(rest, '(', ')').map(|length| (&rest[..length], length))?,
        _ => {
            let sign = usize::from(rest.starts_with('-'));
            let run = rest[sign..].find(|c: char| !c.is_ascii_alphanumeric());
            let length = run.map_or(rest.len(), |run| run + sign);
            (&rest[..length], length)
        }
    };
    if inner.is_empty() || inner == "-" {
        return None;
    }
    let _ = write!(html, "<{element}>{}</{element}>", typeset(inner).into_string());
    Some(1 + length)
}

/// The length of the group that a text begins with.
fn enclosed(text: &str, open: char, close: char) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, c) in text.char_indices() {
        if c == open {
            depth += 1;
        } else if c == close {
            depth -= 1;
        }
        if depth == 0 {
            return (at > 0).then_some(at + 1);
        }
    }
    None
}

/// Whether a hyphen is a minus: a quantity follows and no word goes on, or it stands alone.
fn is_minus(after: &str, before: Option<char>) -> bool {
    let quantity = match word(after) {
        "" => after.starts_with(|c: char| c.is_ascii_digit() || "(∞≈".contains(c)),
        name => name == "sqrt" || greek_letter(name).is_some(),
    };
    let alone = before == Some(' ') && after.starts_with(' ');
    alone || quantity && !before.is_some_and(|c| c.is_ascii_alphabetic())
}

/// Whether a space stands between a number and a Greek letter.
fn is_factor(after: &str, before: Option<char>) -> bool {
    before.is_some_and(|c| c.is_ascii_digit()) && greek_letter(word(after)).is_some()
}

/// The letters that a text begins with.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len());
    &text[..end]
}

fn escape(html: &mut String, text: &str) {
    let _ = Escaper::new(html).write_str(text);
}

#[cfg(test)]
mod tests {
    use super::typeset;

    fn html(text: &str) -> String {
        typeset(text).into_string()
    }

    #[test]
    fn formulas() {
        assert_eq!(html("-1/4 < alpha"), "−1/4 &lt; α");
        assert_eq!(html("(3-sqrt(3))/64"), "(3−√3)/64");
        assert_eq!(html("sqrt(1+(x))"), "√(1+(x))");
        assert_eq!(html("‖c_2^1‖"), "‖c<sub>2</sub><sup>1</sup>‖");
        assert_eq!(html("S_{a_{2N+2}}"), "S<sub>a<sub>2N+2</sub></sub>");
        assert_eq!(html("8*alpha - 1"), "8\u{202f}α − 1");
        assert_eq!(html("2-4 alpha ≈ 0.5"), "2−4\u{202f}α ≈\u{a0}0.5");
        assert_eq!(html("10^-5, C^(n+1)"), "10<sup>−5</sup>, C<sup>(n+1)</sup>");
    }

    #[test]
    fn words_stay_as_they_are() {
        let text = "a 4-point scheme, well-known: 2 * 3, not-checked";
        assert_eq!(html(text), text);
    }

    #[test]
    fn code_is_not_typeset_but_escaped() {
        assert_eq!(html("`a_b < alpha` _"), "<code>a_b &lt; alpha</code> _");
    }

    /// What is not well formed is printed as it stands.
    #[test]
    fn unfinished_groups() {
        for text in ["a_{b", "a^", "sqrt(2", "`x", "a^(", "^_", "x_-", "_{}"] {
            assert_eq!(html(text), text);
        }
        assert_eq!(html("a & <b>\"&amp;"), "a &amp; &lt;b&gt;&quot;&amp;amp;");
    }
}
