//! What is wrong with an input, where, and what to do about it.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str};
use unicode_width::UnicodeWidthChar;

/// How wide an excerpt is at most, and how many characters of a value a message quotes.
const WINDOW: usize = 100;
/// How many characters are marked at most; of more, the excerpt shows both ends.
const MOST_MARKED: usize = 200;

/// An error about undefined input: a stable code, a message, and where known a hint and the place.
///
/// `Display` writes it whole: code and message, the line with carets below the place, and the hint.
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
/// assert_eq!(
///     error.with_hint("write `1/16*a`").to_string(),
///     "error[syntax]: a product needs `*`\n  |\n1 | 1/16a\n  |     ^\nhint: write `1/16*a`",
/// );
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    code: &'static str,
    message: String,
    hint: Option<String>,
    excerpt: Option<Box<Excerpt>>,
}

/// The offending text, the bytes of it that are wrong, and the file whose contents it is.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Excerpt {
    text: String,
    span: Range<usize>,
    file: Option<String>,
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
        self.excerpt
            .get_or_insert_with(|| Box::new(Excerpt { text: text.to_string(), span, file: None }));
        self
    }

    /// The same, with `place`, where the input was found, in front of the message.
    #[must_use]
    pub fn within(mut self, place: &str) -> Self {
        self.message = format!("{place}: {}", self.message);
        self
    }

    /// The same, in the file `path` with the text `contents`: there if the offending text stands in it once, and
    /// otherwise with the path in front of the message.
    #[must_use]
    pub fn in_file(mut self, path: &str, contents: &str) -> Self {
        let Some(excerpt) = &mut self.excerpt else {
            return self.within(path);
        };
        let mut places = contents.match_indices(&excerpt.text);
        let (Some((at, _)), None) = (places.next(), places.next()) else {
            return self.within(path);
        };
        let span = at + excerpt.span.start..at + excerpt.span.end;
        **excerpt = Excerpt { text: contents.to_string(), span, file: Some(path.to_string()) };
        self
    }

    /// The same as `Display` with the colours of a terminal.
    pub fn styled(&self) -> String {
        self.rendered(&Renderer::styled())
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
        self.excerpt.as_ref().map(|excerpt| (excerpt.text.as_str(), excerpt.span.clone()))
    }
}

impl Diagnostic {
    fn rendered(&self, renderer: &Renderer) -> String {
        let title = Level::ERROR.primary_title(visible(&self.message)).id(self.code);
        let mut error = Group::with_title(title);
        if let Some(Excerpt { text, span, file }) = self.excerpt.as_deref() {
            let (before, rest) = text.split_at(span.start);
            let marked = first_characters(&rest[..span.len()], MOST_MARKED);
            let (before, shown) = (visible(before), visible(marked));
            let place = before.len()..before.len() + shown.len();
            let source = before + &shown + &visible(&rest[marked.len()..]);
            let snippet = Snippet::source(source).path(file.as_deref().map(harmless));
            error = error.element(snippet.annotation(AnnotationKind::Primary.span(place)));
        }
        let renderer = renderer.clone().term_width(WINDOW);
        // The hint by itself: as a second group it would be tied to the first by a bar.
        let hint = self.hint.as_ref().map(|hint| {
            let title = Level::HELP.with_name("hint").secondary_title(harmless(hint));
            format!("\n{}", renderer.render(&[Group::with_title(title)]))
        });
        renderer.render(&[error]) + &hint.unwrap_or_default()
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.rendered(&Renderer::plain()))
    }
}

impl std::error::Error for Diagnostic {}

/// A value as a message quotes it: cut after as many characters as an excerpt is wide.
pub(crate) fn shortened(value: impl fmt::Display) -> String {
    let text = value.to_string();
    let shown = first_characters(&text, WINDOW);
    let cut = if shown.len() < text.len() { "…" } else { "" };
    format!("{shown}{cut}")
}

fn first_characters(text: &str, count: usize) -> &str {
    text.char_indices().nth(count).map_or(text, |(end, _)| &text[..end])
}

/// The text with a mark in place of what takes no room, such as a control character: a terminal might obey it, and no
/// excerpt would be cut to it. The renderer does the same for ASCII, in titles and excerpts.
fn visible(text: &str) -> String {
    let takes_room = |c: &char| c.is_ascii() || c.width().unwrap_or(0) > 0;
    text.chars().map(|c| if takes_room(&c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}

/// The same for texts that the renderer takes as they are.
fn harmless(text: &str) -> String {
    normalize_untrusted_str(&visible(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, span: Range<usize>) -> Vec<String> {
        let error = Diagnostic::new("syntax", "no").at(text, span).to_string();
        error.lines().map(String::from).collect()
    }

    #[test]
    fn carets_count_columns_not_bytes() {
        let lines = |text: &str, carets: &str| {
            vec![
                "error[syntax]: no".into(),
                "  |".into(),
                format!("1 | {text}"),
                format!("  | {carets}"),
            ]
        };
        assert_eq!(shown("αβ + γ", 7..9), lines("αβ + γ", "     ^"));
        assert_eq!(shown("字+", 3..4), lines("字+", "  ^"));
        assert_eq!(shown("1 +", 3..3), lines("1 +", "   ^"));
    }

    #[test]
    fn a_place_in_a_file_is_shown_there() {
        let error = Diagnostic::new("syntax", "no").at("[1 2]", 3..4);
        let shown = error.clone().in_file("hat.toml", "name = 'hat'\nmask = '[1 2]'\n").to_string();
        let expected =
            "error[syntax]: no\n --> hat.toml:2:12\n  |\n2 | mask = '[1 2]'\n  |            ^";
        assert_eq!(shown, expected);
        // Which of two places is meant is not guessed.
        let twice = error.in_file("hat.toml", "mask = '[1 2]' # [1 2]");
        assert_eq!((twice.message(), twice.excerpt()), ("hat.toml: no", Some(("[1 2]", 3..4))));
    }

    #[test]
    fn a_long_text_is_cut_around_the_place() {
        for (around, width) in [("a", 1), ("字", 2), ("\u{301}", 1), ("\t", 4)] {
            let text = around.repeat(100_000) + "X" + &around.repeat(100_000);
            let start = 100_000 * around.len();
            for span in [
                start..start + 1,
                0..start,
                0..text.len(),
                start..text.len(),
                text.len()..text.len(),
            ] {
                let lines = shown(&text, span.clone());
                assert!(
                    lines.iter().all(|l| l.chars().count() <= 3 * WINDOW + 10),
                    "{around:?} {span:?}"
                );
            }
            let lines = shown(&text, start..start + 1);
            let place = lines[3].find('^').expect("a caret") - 4;
            let (before, _) = lines[2][4..].split_once('X').expect("the place");
            let columns: usize = before.chars().map(|c| c.width().unwrap_or(0)).sum();
            assert_eq!(columns, place, "{around:?} of width {width}");
        }
    }

    /// Escape sequences begin with one of two control characters; a bell rings, and some text runs backwards.
    #[test]
    fn nothing_that_a_terminal_obeys_is_shown() {
        let evil = "\u{1b}[31m\u{9b}31m\u{7}\u{85}\u{202e}\u{200b}\0";
        let error = Diagnostic::new("syntax", evil).with_hint(evil).at(evil, 0..evil.len());
        let shown = error.in_file(evil, evil).to_string();
        assert!(!shown.contains(|c: char| c.is_control() && c != '\n'), "{shown:?}");
        assert!(!shown.contains(['\u{202e}', '\u{200b}']));
    }

    #[test]
    fn the_innermost_place_wins() {
        let error = Diagnostic::new("pole", "zero").at("1/0", 2..3).at("outer", 0..5);
        assert_eq!(error.excerpt(), Some(("1/0", 2..3)));
    }
}
