//! What is wrong with an input, where, and what to do about it.

use std::fmt;
use std::ops::Range;

/// How many characters of the offending text an excerpt shows at most.
const WINDOW: usize = 100;
/// How many of them come before the marked place when the text is cut.
const LEAD: usize = 40;

/// An error about undefined input: a stable code, a message, and where known a hint and the place.
///
/// `Display` writes the message and, if there is an excerpt, the text with a line of carets below
/// it. The hint is left to the caller, who prints it after the message.
///
/// | code | meaning |
/// |---|---|
/// | `syntax` | the text is not an expression, a list or a substitution |
/// | `irrational` | a square root where a rational expression is needed |
/// | `pole` | a division by something that is identically zero |
/// | `symbol` | a symbol that is not a Laurent polynomial in `z` |
/// | `budget` | more work, digits or nesting than the stated limits allow |
/// | `arity` | an arity below 2, or one that the scheme does not have |
/// | `zero-mask` | a mask without a nonzero coefficient |
/// | `not-normalised` | a stencil whose weights do not sum to 1 |
/// | `unknown-scheme` | a name that the catalogue does not have |
/// | `substitution` | a parameter that cannot be set |
/// | `construction` | arguments that a construction does not take |
/// | `file` | a scheme file that is not of the format |
/// | `derivation` | a recorded step that does not follow from the one before |
///
/// ```
/// use refinable_scheme::Diagnostic;
/// let error = Diagnostic::new("syntax", "a product needs `*`").at("1/16a", 4..5);
/// assert_eq!(error.to_string(), "a product needs `*`\n1/16a\n    ^");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    code: &'static str,
    message: String,
    hint: Option<String>,
    excerpt: Option<(String, Range<usize>)>,
}

impl Diagnostic {
    /// An error without a hint and without a place.
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Diagnostic { code, message: message.into(), hint: None, excerpt: None }
    }

    /// The same with advice on what to write instead.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// The same, pointing at the bytes `span` of `text`; a place already known is kept, since the
    /// innermost one is the most precise.
    #[must_use]
    pub fn at(mut self, text: &str, span: Range<usize>) -> Self {
        self.excerpt.get_or_insert_with(|| (text.to_string(), span));
        self
    }

    /// The same, with `place`, where the input was found, in front of the message.
    #[must_use]
    pub fn within(mut self, place: &str) -> Self {
        self.message = format!("{place}: {}", self.message);
        self
    }

    /// The stable code, see the table above.
    pub fn code(&self) -> &'static str {
        self.code
    }

    /// The message alone, one line.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to write instead, where that can be said.
    pub fn hint(&self) -> Option<&str> {
        self.hint.as_deref()
    }

    /// The offending text and the byte range in it.
    pub fn excerpt(&self) -> Option<(&str, Range<usize>)> {
        self.excerpt.as_ref().map(|(text, span)| (text.as_str(), span.clone()))
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        let Some((text, span)) = &self.excerpt else {
            return Ok(());
        };
        let (line, carets) = underlined(text, span);
        write!(f, "\n{line}\n{carets}")
    }
}

impl std::error::Error for Diagnostic {}

/// The text, cut to a window around the span, and the carets below it, counted in characters.
fn underlined(text: &str, span: &Range<usize>) -> (String, String) {
    let chars: Vec<char> = text.chars().map(printable).collect();
    let index_of = |byte: usize| text.char_indices().take_while(|(at, _)| *at < byte).count();
    let (start, end) = (index_of(span.start), index_of(span.end));
    let first = if chars.len() <= WINDOW {
        0
    } else {
        start.saturating_sub(LEAD).min(chars.len() - WINDOW)
    };
    let last = chars.len().min(first + WINDOW);
    let before = if first > 0 { "…" } else { "" };
    let after = if last < chars.len() { "…" } else { "" };
    let shown: String = chars[first..last].iter().collect();
    let indent = before.chars().count() + start - first;
    let width = end.min(last).saturating_sub(start).max(1);
    (format!("{before}{shown}{after}"), format!("{}{}", " ".repeat(indent), "^".repeat(width)))
}

/// A value as a message quotes it: cut after as many characters as an excerpt shows.
pub(crate) fn shortened(value: impl fmt::Display) -> String {
    let text = value.to_string();
    match text.char_indices().nth(WINDOW) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// A line break or a tab would move the carets away from what they point at.
fn printable(c: char) -> char {
    if c.is_control() { ' ' } else { c }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carets_count_characters_not_bytes() {
        let error = Diagnostic::new("syntax", "no").at("αβ + γ", 7..9);
        assert_eq!(error.to_string(), "no\nαβ + γ\n     ^");
        let end = Diagnostic::new("syntax", "no").at("1\t+", 3..3);
        assert_eq!(end.to_string(), "no\n1 +\n   ^");
    }

    #[test]
    fn a_long_text_is_cut_around_the_place() {
        let text = format!("{}X{}", "a".repeat(500), "b".repeat(500));
        let shown = Diagnostic::new("syntax", "no").at(&text, 500..501).to_string();
        let lines: Vec<_> = shown.lines().collect();
        let place = lines[2].chars().count() - 1;
        assert_eq!(lines[1].chars().nth(place), Some('X'));
        assert_eq!(lines[1].chars().count(), WINDOW + 2);
        let last = Diagnostic::new("syntax", "no").at(&text, 1001..1001);
        assert!(last.to_string().lines().all(|l| l.chars().count() <= WINDOW + 2));
    }

    #[test]
    fn the_innermost_place_wins() {
        let error = Diagnostic::new("pole", "zero").at("1/0", 2..3).at("outer", 0..5);
        assert_eq!(error.excerpt(), Some(("1/0", 2..3)));
    }
}
