//! Tokens of the notation for expressions, lists and substitutions.

use std::ops::Range;

use crate::diagnostic::Diagnostic;

/// The longest text that is read, in bytes.
const LONGEST_TEXT: usize = 1 << 20;
/// The largest number of digits of one number.
const MOST_DIGITS: usize = 10_000;

/// The kinds of tokens; a number is read off its span.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Token {
    Number,
    Name(String),
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Open,
    Close,
    OpenList,
    CloseList,
    Comma,
    At,
    Equals,
    Colon,
    Semicolon,
    /// `\frac`, before two groups in braces.
    Fraction,
    OpenBrace,
    CloseBrace,
    End,
}

/// A token with its bytes, and whether a blank stands before it.
#[derive(Clone, Debug)]
pub(crate) struct Lexed {
    pub token: Token,
    pub span: Range<usize>,
    pub after_blank: bool,
}

/// Reads tokens one by one.
pub(crate) struct Lexer<'a> {
    text: &'a str,
    position: usize,
    is_latex: bool,
}

impl<'a> Lexer<'a> {
    /// # Errors
    /// `budget` if the text is longer than 1 MiB.
    pub fn new(text: &'a str) -> Result<Self, Diagnostic> {
        if text.len() > LONGEST_TEXT {
            let message = format!("the text has {} bytes; at most 1 MiB is read", text.len());
            return Err(Diagnostic::new("budget", message));
        }
        Ok(Lexer { text, position: 0, is_latex: text.contains('\\') })
    }

    /// Whether the text is LaTeX: it has a backslash, which nothing else has.
    pub fn is_latex(&self) -> bool {
        self.is_latex
    }

    /// The next token; `End` again and again at the end.
    pub fn next(&mut self) -> Result<Lexed, Diagnostic> {
        let blanks = self.skip_blanks();
        let start = self.position;
        let Some(c) = self.peek() else {
            return Ok(self.lexed(Token::End, start, blanks > 0));
        };
        let token = if c.is_ascii_digit() {
            self.number()?
        } else if let Some(name) = self.name() {
            Token::Name(name)
        } else if c == '\\' {
            self.command()?
        } else if let Some(token) = brace(c).filter(|_| self.is_latex) {
            self.position += 1;
            token
        } else {
            self.position += c.len_utf8();
            let span = start..self.position;
            punctuation(c).ok_or_else(|| unexpected(c).at(self.text, span))?
        };
        Ok(self.lexed(token, start, blanks > 0))
    }

    fn lexed(&self, token: Token, start: usize, after_blank: bool) -> Lexed {
        Lexed { token, span: start..self.position, after_blank }
    }

    fn peek(&self) -> Option<char> {
        self.text[self.position..].chars().next()
    }

    /// Skips while `wanted` holds and returns the number of bytes skipped.
    fn skip(&mut self, wanted: impl Fn(char) -> bool) -> usize {
        let rest = &self.text[self.position..];
        let length = rest.find(|c| !wanted(c)).unwrap_or(rest.len());
        self.position += length;
        length
    }

    /// Skips blanks, and in LaTeX what only spaces, aligns or sizes things.
    fn skip_blanks(&mut self) -> usize {
        let start = self.position;
        loop {
            self.skip(char::is_whitespace);
            let rest = &self.text[self.position..];
            let blank = LATEX_BLANKS
                .iter()
                .filter(|blank| rest.starts_with(**blank))
                .max_by_key(|b| b.len());
            match blank.filter(|_| self.is_latex) {
                Some(blank) => self.position += blank.len(),
                None => return self.position - start,
            }
        }
    }

    /// A command of LaTeX: a fraction, a product, a Greek letter.
    fn command(&mut self) -> Result<Token, Diagnostic> {
        let start = self.position;
        self.position += 1;
        self.skip(|c| c.is_ascii_alphabetic());
        let name = &self.text[start + 1..self.position];
        match name {
            "frac" | "dfrac" | "tfrac" => Ok(Token::Fraction),
            "cdot" | "times" => Ok(Token::Star),
            _ if GREEK.iter().any(|(_, english)| *english == name) => Ok(Token::Name(name.into())),
            _ => {
                let end = self.position.max(start + 1);
                let message = format!("`{}` is not read here", &self.text[start..end]);
                let hint = "of LaTeX, Greek letters, `\\frac{…}{…}`, `\\cdot` and spaces are read";
                Err(Diagnostic::new("syntax", message).with_hint(hint).at(self.text, start..end))
            }
        }
    }

    /// Digits, then perhaps a point and more digits.
    fn number(&mut self) -> Result<Token, Diagnostic> {
        let start = self.position;
        self.skip(|c| c.is_ascii_digit());
        if self.peek() == Some('.') {
            self.position += 1;
            if self.skip(|c| c.is_ascii_digit()) == 0 {
                let error = Diagnostic::new("syntax", "a decimal needs digits after the point");
                let written = &self.text[start..self.position];
                let short = if written.len() <= 20 { written } else { "1." };
                let hint = format!("write `{short}0`");
                return Err(error.with_hint(hint).at(self.text, start..self.position));
            }
        }
        let length = self.position - start;
        if length > MOST_DIGITS {
            let message = format!("a number of {length} digits; at most {MOST_DIGITS} are read");
            return Err(Diagnostic::new("budget", message).at(self.text, start..self.position));
        }
        Ok(Token::Number)
    }

    /// A letter, Latin or Greek, then Latin letters, digits and underscores.
    fn name(&mut self) -> Option<String> {
        let c = self.peek()?;
        let mut name = match english(c) {
            Some(english) => english.to_string(),
            None if c.is_ascii_alphabetic() => c.to_string(),
            None => return None,
        };
        self.position += c.len_utf8();
        let rest = self.position;
        self.skip(|c| c.is_ascii_alphanumeric() || c == '_');
        name.push_str(&self.text[rest..self.position]);
        Some(name)
    }
}

fn punctuation(c: char) -> Option<Token> {
    Some(match c {
        '+' => Token::Plus,
        // U+2212 is what a minus becomes when it is copied from a typeset page.
        '-' | '\u{2212}' => Token::Minus,
        '*' => Token::Star,
        '/' => Token::Slash,
        '^' => Token::Caret,
        '(' => Token::Open,
        ')' => Token::Close,
        '[' => Token::OpenList,
        ']' => Token::CloseList,
        ',' => Token::Comma,
        '@' => Token::At,
        '=' => Token::Equals,
        ':' => Token::Colon,
        ';' => Token::Semicolon,
        _ => return None,
    })
}

fn unexpected(c: char) -> Diagnostic {
    let error = Diagnostic::new("syntax", format!("unexpected `{}`", c.escape_debug()));
    match c {
        '·' | '×' | '⋅' | '∗' => error.with_hint("write `*` for a product"),
        '÷' | '⁄' | '∕' => error.with_hint("write `/` for a quotient"),
        '–' | '—' => error.with_hint("that is a dash; write `-`"),
        '²' | '³' => error.with_hint("write `^2`, `^3`"),
        '√' => error.with_hint("write `sqrt(...)`"),
        '.' => error.with_hint("decimals are written `0.5`"),
        '{' | '}' => error.with_hint("group with `(` and `)`, lists with `[` and `]`"),
        '$' | '&' => error.with_hint("paste the mask alone"),
        _ => error,
    }
}

fn brace(c: char) -> Option<Token> {
    match c {
        '{' => Some(Token::OpenBrace),
        '}' => Some(Token::CloseBrace),
        _ => None,
    }
}

/// What LaTeX has between the parts of a formula that means nothing.
const LATEX_BLANKS: [&str; 13] = [
    "\\,", "\\;", "\\:", "\\!", "\\ ", "\\\\", "\\left", "\\right", "\\quad", "\\qquad", "~", "$",
    "&",
];

/// The English name of a Greek letter, so that `α`, `\alpha` and `alpha` are one parameter.
fn english(c: char) -> Option<&'static str> {
    GREEK.iter().find(|(letters, _)| letters.contains(c)).map(|(_, english)| *english)
}

/// Greek letters with their English names.
const GREEK: [(&str, &str); 34] = [
    ("α", "alpha"),
    ("β", "beta"),
    ("γ", "gamma"),
    ("δ", "delta"),
    ("εϵ", "epsilon"),
    ("ζ", "zeta"),
    ("η", "eta"),
    ("θϑ", "theta"),
    ("ι", "iota"),
    ("κϰ", "kappa"),
    ("λ", "lambda"),
    ("μµ", "mu"),
    ("ν", "nu"),
    ("ξ", "xi"),
    ("ο", "omicron"),
    ("π", "pi"),
    ("ρϱ", "rho"),
    ("σς", "sigma"),
    ("τ", "tau"),
    ("υ", "upsilon"),
    ("φϕ", "phi"),
    ("χ", "chi"),
    ("ψ", "psi"),
    ("ω", "omega"),
    ("Γ", "Gamma"),
    ("Δ", "Delta"),
    ("Θ", "Theta"),
    ("Λ", "Lambda"),
    ("Ξ", "Xi"),
    ("Π", "Pi"),
    ("Σ", "Sigma"),
    ("Φ", "Phi"),
    ("Ψ", "Psi"),
    ("Ω", "Omega"),
];
