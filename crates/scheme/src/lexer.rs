//! Tokens of the notation for expressions, lists and substitutions.
//!
//! ```text
//! token   = number | name | "\frac" | mark
//! number  = digits [ "." digits ]
//! name    = letter { Latin letter | digit | "_" } | "\" Greek name
//! mark    = "+" | "-" | "*" | "/" | "^" | "(" | ")" | "[" | "]" | "," | "@" | "=" | ":" | ";" | "{" | "}"
//! ```

use std::borrow::Cow;
use std::ops::Range;

use winnow::ascii::{alpha0, digit0, digit1};
use winnow::combinator::{alt, eof, opt, preceded, repeat};
use winnow::error::EmptyError;
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location};
use winnow::token::{any, one_of, take_while};

use crate::diagnostic::Diagnostic;

/// The longest text that is read, in bytes.
const LONGEST_TEXT: usize = 1 << 20;
/// The largest number of digits of one number.
const MOST_DIGITS: usize = 10_000;

/// The kinds of tokens; a number is read off its span.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Token<'t> {
    Number,
    Name(Cow<'t, str>),
    Mark(char),
    /// `\frac`, before two groups in braces.
    Fraction,
    End,
    /// What is no token; nothing is read behind it.
    Unreadable(Box<Diagnostic>),
}

/// A token with its bytes, and whether a blank stands before it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Lexed<'t> {
    pub token: Token<'t>,
    pub span: Range<usize>,
    pub after_blank: bool,
}

/// So that `'+'` is the parser of a plus.
impl PartialEq<char> for Lexed<'_> {
    fn eq(&self, mark: &char) -> bool {
        self.token == Token::Mark(*mark)
    }
}

/// So that `"odd"` is the parser of that name.
impl PartialEq<&str> for Lexed<'_> {
    fn eq(&self, name: &&str) -> bool {
        matches!(&self.token, Token::Name(found) if found == name)
    }
}

impl Location for Lexed<'_> {
    fn previous_token_end(&self) -> usize {
        self.span.end
    }

    fn current_token_start(&self) -> usize {
        self.span.start
    }
}

impl From<Diagnostic> for Token<'_> {
    fn from(error: Diagnostic) -> Self {
        Token::Unreadable(Box::new(error))
    }
}

type Text<'t> = LocatingSlice<&'t str>;
type Lexing<'t> = Result<Token<'t>, EmptyError>;

pub(crate) fn syntax(message: impl Into<String>) -> Diagnostic {
    Diagnostic::new("syntax", message)
}

/// Whether the text is LaTeX: it has a backslash, which nothing else has.
pub(crate) fn is_latex(text: &str) -> bool {
    text.contains('\\')
}

/// The tokens of a text; the last one, and no other, is `End` or `Unreadable`.
///
/// # Errors
/// `budget` if the text is longer than 1 MiB.
pub(crate) fn tokens(text: &str) -> Result<Vec<Lexed<'_>>, Diagnostic> {
    if text.len() > LONGEST_TEXT {
        let message = format!("the text has {} bytes; at most 1 MiB is read", text.len());
        return Err(Diagnostic::new("budget", message));
    }
    let is_latex = is_latex(text);
    let mut next = (blanks(is_latex).take(), token(is_latex).with_span());
    let (mut rest, mut tokens) = (LocatingSlice::new(text), Vec::new());
    loop {
        let (blanks, (token, span)) = next.parse_next(&mut rest).expect("there is always a token");
        let after_blank = !blanks.is_empty();
        let token = match token {
            Token::Unreadable(error) => error.at(text, span.clone()).into(),
            token => token,
        };
        let is_last = matches!(token, Token::End | Token::Unreadable(_));
        tokens.push(Lexed { token, span, after_blank });
        if is_last {
            return Ok(tokens);
        }
    }
}

/// Blanks, and in LaTeX what only spaces, aligns or sizes things.
fn blanks<'t>(is_latex: bool) -> impl Parser<Text<'t>, (), EmptyError> {
    let blank = take_while(1.., char::is_whitespace);
    let spacing = one_of([',', ';', ':', '!', ' ', '\\']).take();
    let command = preceded(one_of('\\'), alt((spacing, "left", "right", "quad", "qquad")));
    let mark = one_of(['~', '$', '&']).verify(move |_| is_latex).take();
    repeat(0.., alt((blank, command, mark)))
}

fn token<'t>(is_latex: bool) -> impl Parser<Text<'t>, Token<'t>, EmptyError> {
    // U+2212 is what a minus becomes when it is copied from a typeset page.
    let mark = alt((one_of("+-*/^()[],@=:;".as_bytes()), one_of('\u{2212}').value('-')));
    let brace = one_of(['{', '}']).verify(move |_| is_latex);
    alt((
        number,
        alt((mark, brace)).map(Token::Mark),
        name,
        command,
        eof.value(Token::End),
        any.map(unexpected),
    ))
}

/// Digits, then perhaps a point and more digits.
fn number<'t>(text: &mut Text<'t>) -> Lexing<'t> {
    let number = (digit1, opt(('.', digit0))).take().parse_next(text)?;
    if number.ends_with('.') {
        let short = if number.len() <= 20 { number } else { "1." };
        let hint = format!("write `{short}0`");
        return Ok(syntax("a decimal needs digits after the point").with_hint(hint).into());
    }
    if number.len() > MOST_DIGITS {
        let length = number.len();
        let message = format!("a number of {length} digits; at most {MOST_DIGITS} are read");
        return Ok(Diagnostic::new("budget", message).into());
    }
    Ok(Token::Number)
}

/// A letter, Latin or Greek, then Latin letters, digits and underscores.
fn name<'t>(text: &mut Text<'t>) -> Lexing<'t> {
    let latin = one_of(|c: char| c.is_ascii_alphabetic()).value(None);
    let letter = alt((latin, any.verify_map(english).map(Some)));
    let rest = take_while(0.., |c: char| c.is_ascii_alphanumeric() || c == '_');
    let ((letter, rest), written) = (letter, rest).with_taken().parse_next(text)?;
    Ok(Token::Name(letter.map_or(written.into(), |english| format!("{english}{rest}").into())))
}

/// A command of LaTeX: a fraction, a product, a Greek letter.
fn command<'t>(text: &mut Text<'t>) -> Lexing<'t> {
    let name: &str = preceded(one_of('\\'), alpha0).parse_next(text)?;
    Ok(match name {
        "frac" | "dfrac" | "tfrac" => Token::Fraction,
        "cdot" | "times" => Token::Mark('*'),
        _ if GREEK.iter().any(|(_, english)| *english == name) => Token::Name(name.into()),
        _ => syntax(format!("`\\{name}` is not read here"))
            .with_hint("of LaTeX, Greek letters, `\\frac{…}{…}`, `\\cdot` and spaces are read")
            .into(),
    })
}

fn unexpected<'t>(c: char) -> Token<'t> {
    let error = syntax(format!("unexpected `{}`", c.escape_debug()));
    let error = match c {
        '·' | '×' | '⋅' | '∗' => error.with_hint("write `*` for a product"),
        '÷' | '⁄' | '∕' => error.with_hint("write `/` for a quotient"),
        '–' | '—' => error.with_hint("that is a dash; write `-`"),
        '²' | '³' => error.with_hint("write `^2`, `^3`"),
        '√' => error.with_hint("write `sqrt(...)`"),
        '.' => error.with_hint("decimals are written `0.5`"),
        '{' | '}' => error.with_hint("group with `(` and `)`, lists with `[` and `]`"),
        '$' | '&' => error.with_hint("paste the mask alone"),
        _ => error,
    };
    error.into()
}

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
