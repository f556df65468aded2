//! Reading a text with winnow: tokens, what is known while reading, and what is said when it ends.
//!
//! One token decides how to go on, so that a parser either is not meant, and takes nothing, or ends the reading
//! by what it says is wrong.

use std::ops::Range;

use winnow::combinator::{not, peek, terminated};
use winnow::error::ParserError;
use winnow::prelude::*;
use winnow::stream::{Stateful, TokenSlice};
use winnow::token::one_of;

use crate::diagnostic::Diagnostic;
use crate::lexer::{Lexed, Token, is_latex, syntax, tokens};

/// The longest text that an error quotes.
pub(crate) const LONGEST_QUOTE: usize = 60;

/// Tokens, the last of which is never taken, and what has been read so far.
pub(crate) type Input<'t> = Stateful<TokenSlice<'t, Lexed<'t>>, State<'t>>;

/// What the reading of one text keeps in mind.
#[derive(Clone, Debug)]
pub(crate) struct State<'t> {
    pub text: &'t str,
    pub is_latex: bool,
    pub depth: usize,
    pub digit_work: usize,
    /// Whether an entry of a list is being read, outside all parentheses.
    pub at_entry_level: bool,
}

/// Why a parser stops.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// It is not meant here: the next alternative may be.
    NotHere,
    /// It is meant, and this is wrong.
    Wrong(Box<Diagnostic>),
}

pub(crate) type Reading<T> = Result<T, Refusal>;

pub(crate) fn wrong<T>(error: Diagnostic) -> Reading<T> {
    Err(Refusal::Wrong(Box::new(error)))
}

/// More at `span` than the stated limits allow.
pub(crate) fn too_much<T>(message: String, span: Range<usize>, input: &Input<'_>) -> Reading<T> {
    wrong(Diagnostic::new("budget", message).at(input.state.text, span))
}

impl ParserError<Input<'_>> for Refusal {
    type Inner = Refusal;

    fn from_input(_: &Input<'_>) -> Self {
        Refusal::NotHere
    }

    fn is_backtrack(&self) -> bool {
        matches!(self, Refusal::NotHere)
    }

    fn into_inner(self) -> Result<Refusal, Self> {
        Ok(self)
    }
}

/// Reads the whole of a text.
///
/// # Errors
/// What the grammar says is wrong, unless nothing can be read where it says so.
pub(crate) fn read<T>(
    text: &str,
    grammar: impl for<'t> Fn(&mut Input<'t>) -> Reading<T>,
) -> Result<T, Diagnostic> {
    let tokens = tokens(text)?;
    let is_latex = is_latex(text);
    let state = State { text, is_latex, depth: 0, digit_work: 0, at_entry_level: false };
    let mut input = Stateful { input: TokenSlice::new(&tokens), state };
    let result = terminated(grammar, peek(end)).parse_next(&mut input);
    result.map_err(|refusal| match (&input[0].token, refusal) {
        (Token::Unreadable(error), _) => Diagnostic::clone(error),
        (_, Refusal::Wrong(error)) => *error,
        (_, Refusal::NotHere) => unexpected(&input),
    })
}

/// The parser, or an error in its place.
pub(crate) fn need<'t, T>(
    mut parser: impl Parser<Input<'t>, T, Refusal>,
    error: impl Fn(&Input<'t>) -> Diagnostic,
) -> impl Parser<Input<'t>, T, Refusal> {
    move |input: &mut Input<'t>| match parser.parse_next(input) {
        Err(Refusal::NotHere) => wrong(error(input)),
        result => result,
    }
}

/// Nothing, or an error where the parser finds what it looks for.
pub(crate) fn refuse<'t, T>(
    parser: impl Parser<Input<'t>, T, Refusal>,
    error: impl Fn(&Input<'t>) -> Diagnostic,
) -> impl Parser<Input<'t>, (), Refusal> {
    need(not(parser), error)
}

/// A token of the kind that is wanted.
pub(crate) fn one<'t>(
    wanted: fn(&Token<'t>) -> bool,
) -> impl Parser<Input<'t>, &'t Lexed<'t>, Refusal> {
    one_of(move |lexed: &'t Lexed<'t>| wanted(&lexed.token))
}

pub(crate) fn end<'t>(input: &mut Input<'t>) -> Reading<()> {
    one(|token| *token == Token::End).void().parse_next(input)
}

/// An error at the next token.
pub(crate) fn here(input: &Input<'_>, message: impl Into<String>) -> Diagnostic {
    syntax(message).at(input.state.text, input[0].span.clone())
}

/// The same with a hint, for [`need`] and [`refuse`].
pub(crate) fn say<'t>(
    message: &'static str,
    hint: &'static str,
) -> impl Fn(&Input<'t>) -> Diagnostic {
    move |input| here(input, message).with_hint(hint)
}

pub(crate) fn unexpected(input: &Input<'_>) -> Diagnostic {
    let Lexed { token, span, .. } = &input[0];
    let text = &input.state.text;
    // 0,5 where there is no list.
    let beside = [text[..span.start].chars().next_back(), text[span.end..].chars().next()];
    let between_digits = beside.iter().all(|c| c.is_some_and(|c| c.is_ascii_digit()));
    match &text[span.clone()] {
        _ if *token == Token::End => here(input, "the text ends too early"),
        "," if between_digits => here(input, "unexpected `,`")
            .with_hint("decimals are written with a point: 0.5; lists in brackets: [1, 2, 1]"),
        written if written.len() <= LONGEST_QUOTE => here(input, format!("unexpected `{written}`")),
        _ => here(input, "unexpected `…`"),
    }
}
