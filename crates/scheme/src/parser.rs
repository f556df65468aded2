//! The grammar of expressions.
//!
//! ```text
//! sum      = term { ("+" | "-") term }
//! term     = factor { ("*" | "/" | "") factor }
//! factor   = ("+" | "-") factor | power
//! power    = primary [ "^" exponent ]
//! exponent = sign integer | "(" sign integer ")" | "{" sign integer "}"
//! primary  = number | name | "(" sum ")" | "sqrt" "(" sum ")" | "\frac" "{" sum "}" "{" sum "}"
//! ```
//!
//! Nothing is guessed. A number and a name without a blank between them are a product, `16a`, but neither
//! below a bar, `1/16a`, nor where they may be a power of ten, `1e3`; all other things side by side are
//! errors, and inside a list `1 -2` is neither a difference nor two entries. In LaTeX, where products are
//! written so, things side by side are one, but below a bar.

use std::ops::Range;

use refinable_algebra::{Integer, parse_rational};
use winnow::combinator::{alt, delimited, empty, fail, opt, peek, preceded, repeat, terminated};
use winnow::prelude::*;
use winnow::token::{any, one_of};

use crate::diagnostic::Diagnostic;
use crate::expression::{Node, NodeKind, SQUARE_ROOT};
use crate::lexer::{Lexed, Token, syntax};
use crate::reading::{
    Input, LONGEST_QUOTE, Reading, Refusal, here, need, one, refuse, say, too_much, unexpected,
    wrong,
};

/// The deepest nesting of parentheses and signs.
const DEEPEST: usize = 200;
/// The largest exponent in magnitude.
const LARGEST_EXPONENT: i32 = 10_000;
/// The largest sum of the squares of the lengths of all numbers: reading a decimal is quadratic.
const MOST_DIGIT_WORK: usize = 400_000_000;

/// A sum, the root of an expression.
pub(crate) fn sum(input: &mut Input<'_>) -> Reading<Node> {
    let first = term(false).parse_next(input)?;
    sum_after(first, input)
}

/// The rest of a sum whose first term has been read.
pub(crate) fn sum_after(first: Node, input: &mut Input<'_>) -> Reading<Node> {
    let plus = preceded(operator('+'), term(false));
    let minus = preceded(operator('-'), term(false)).with_span().map(negated);
    let mut terms = vec![first];
    terms.extend(repeat::<_, _, Vec<_>, _, _>(0.., alt((plus, minus))).parse_next(input)?);
    Ok(joined(terms, NodeKind::Sum))
}

/// In `[1 -2 1]` the sign may belong to a new entry: refused, not guessed.
fn operator<'t>(sign: char) -> impl Parser<Input<'t>, (), Refusal> {
    move |input: &mut Input<'t>| {
        let operator = one_of(|lexed: &'t Lexed<'t>| *lexed == sign).parse_next(input)?;
        let glued = operator.after_blank && !input[0].after_blank;
        if !(input.state.at_entry_level && glued) || input.state.is_latex {
            return Ok(());
        }
        let text = input.state.text;
        let sign = &text[operator.span.clone()];
        let message = format!("` {sign}` may start a new entry or continue this one");
        let hint = format!("separate entries by commas, or put a blank after `{sign}`");
        wrong(syntax(message).with_hint(hint).at(text, operator.span.clone()))
    }
}

/// A term; with `before_list` it ends where the list that it is a factor of begins.
pub(crate) fn term<'t>(before_list: bool) -> impl Parser<Input<'t>, Node, Refusal> {
    move |input: &mut Input<'t>| {
        let mut factors = vec![factor(input)?];
        while !(before_list && peek(list_head).parse_next(input).is_ok()) {
            let last = &factors[factors.len() - 1];
            let Some(factor) = opt(further_factor(last)).parse_next(input)? else {
                refuse(one(is_beside), |i| missing_operator(i, &factors)).parse_next(input)?;
                break;
            };
            factors.push(factor);
        }
        Ok(joined(factors, NodeKind::Product))
    }
}

/// What begins a list behind its factor; LaTeX has no `*` there.
fn list_head(input: &mut Input<'_>) -> Reading<()> {
    let is_latex = input.state.is_latex;
    (alt(('*'.void(), empty.verify(move |()| is_latex))), '[').void().parse_next(input)
}

/// One more factor of a term, behind the factor `last`.
fn further_factor<'t>(last: &Node) -> impl Parser<Input<'t>, Node, Refusal> + use<'t> {
    let times = ('*', refuse('*', say("unexpected `**`", "powers are written `^`")));
    alt((
        preceded(tacit_product(last), power),
        preceded(times, factor),
        preceded('/', factor).map(reciprocal),
    ))
}

/// Whether a token behind a factor begins another, or a list.
fn is_beside(token: &Token<'_>) -> bool {
    matches!(token, Token::Number | Token::Name(_) | Token::Fraction | Token::Mark('(' | '{' | '['))
}

/// Finds nothing but that what stands beside the last factor, without an operator, is one more.
fn tacit_product<'t>(last: &Node) -> impl Parser<Input<'t>, (), Refusal> + use<'t> {
    let (below_bar, is_number, end) = (is_below_bar(last), is_signed_number(last), last.span.end);
    move |input: &mut Input<'t>| {
        let next = peek(one(is_beside)).parse_next(input)?;
        let is_product = match &next.token {
            _ if below_bar => false,
            // Two numbers side by side are a slip of the pen.
            Token::Number | Token::Mark('[') => false,
            _ if input.state.is_latex => true,
            Token::Name(name) => is_number && next.span.start == end && !is_power_of_ten(name),
            _ => false,
        };
        if is_product { Ok(()) } else { fail(input) }
    }
}

/// Two factors side by side: says how each reading would be written.
fn missing_operator(input: &Input<'_>, factors: &[Node]) -> Diagnostic {
    let (text, next) = (input.state.text, &input[0]);
    let error = here(input, "an operator is missing here");
    if *next == '[' {
        return error.with_hint("write the factor as in `1/16*[...]`");
    }
    let quoted = |span: Range<usize>| text[span].trim();
    let (first, last) = (&factors[0], &factors[factors.len() - 1]);
    let left = quoted(first.span.start..next.span.start);
    let power = power(&mut input.clone());
    let right = quoted(power.map_or(next.span.clone(), |power| power.span));
    if left.len() + right.len() > LONGEST_QUOTE {
        return error.with_hint("write `*` for a product");
    }
    let mut readings = Vec::new();
    if input.state.at_entry_level && next.after_blank {
        readings.push(format!("`{left}, {right}`"));
    }
    readings.push(format!("`{left}*{right}`"));
    if is_below_bar(last) {
        let above = quoted(first.span.start..last.span.start);
        let below = quoted(last.span.start..next.span.start);
        readings.push(format!("`{above}({below}*{right})`"));
    }
    let ten = match &next.token {
        Token::Name(name) if is_power_of_ten(name) => "; powers of ten as `1/1000` or `0.001`",
        _ => "",
    };
    error.with_hint(format!("write {}{ten}", readings.join(" or ")))
}

fn factor(input: &mut Input<'_>) -> Reading<Node> {
    match peek(opt(alt(('+', '-')))).parse_next(input)? {
        Some('-') => deeper(preceded(any, factor)).with_span().map(negated).parse_next(input),
        Some(_) => deeper(preceded(any, factor)).with_span().map(widened).parse_next(input),
        None => power(input),
    }
}

/// The parser one level deeper.
fn deeper<'t>(
    mut inner: impl Parser<Input<'t>, Node, Refusal>,
) -> impl Parser<Input<'t>, Node, Refusal> {
    move |input: &mut Input<'t>| {
        input.state.depth += 1;
        if input.state.depth > DEEPEST {
            let message = format!("nested deeper than {DEEPEST} levels");
            return too_much(message, input[0].span.clone(), input);
        }
        let node = inner.parse_next(input)?;
        input.state.depth -= 1;
        Ok(node)
    }
}

fn power(input: &mut Input<'_>) -> Reading<Node> {
    let two_readings = "write `(a^b)^c`, or the exponent as one number";
    let exponent = preceded('^', exponent);
    let tower = refuse('^', say("`a^b^c` has two readings", two_readings));
    let ((base, exponent), span) =
        (primary, opt(terminated(exponent, tower))).with_span().parse_next(input)?;
    Ok(match exponent {
        Some(exponent) => node(span, NodeKind::Power(Box::new(base), exponent)),
        None => base,
    })
}

fn exponent(input: &mut Input<'_>) -> Reading<i32> {
    let no_exponent =
        say("an exponent is an integer, as in `z^-2`", "for a square root write `sqrt(...)`");
    let closing = opt(alt(('('.value(')'), '{'.value('}')))).parse_next(input)?;
    let sign = opt(alt(('+', '-'))).parse_next(input)?;
    let (size, span) = need(integer, &no_exponent).with_span().parse_next(input)?;
    let Some(size) = i32::try_from(size).ok().filter(|size| *size <= LARGEST_EXPONENT) else {
        let message = format!("exponents go up to {LARGEST_EXPONENT} in magnitude");
        return too_much(message, span, input);
    };
    if let Some(closing) = closing {
        need(closing, &no_exponent).parse_next(input)?;
    }
    Ok(if sign == Some('-') { -size } else { size })
}

/// A number, which must be an integer.
pub(crate) fn integer(input: &mut Input<'_>) -> Reading<Integer> {
    let Lexed { span, .. } = one(is_number).parse_next(input)?;
    let text = input.state.text;
    let not_whole = |_| wrong(syntax("an integer is needed here").at(text, span.clone()));
    text[span.clone()].parse().or_else(not_whole)
}

fn is_number(token: &Token<'_>) -> bool {
    matches!(token, Token::Number)
}

fn primary(input: &mut Input<'_>) -> Reading<Node> {
    alt((number, square_root, name, group('(', ')'), group('{', '}'), fraction, no_primary))
        .parse_next(input)
}

fn no_primary(input: &mut Input<'_>) -> Reading<Node> {
    wrong(match input[0].token {
        Token::Mark('[') => here(input, "a list cannot be a part of an expression")
            .with_hint("a single factor may stand in front of it, as in `(1/8 + w)*[...]`"),
        Token::End => here(input, "expected a number, a name or `(`"),
        _ => unexpected(input),
    })
}

fn number(input: &mut Input<'_>) -> Reading<Node> {
    let Lexed { span, .. } = one(is_number).parse_next(input)?;
    input.state.digit_work += span.len().pow(2);
    if input.state.digit_work > MOST_DIGIT_WORK {
        let message = "the numbers of this text have too many digits together".into();
        return too_much(message, span.clone(), input);
    }
    let value = parse_rational(&input.state.text[span.clone()]);
    let value = value.expect("the lexer accepts the same decimals");
    Ok(node(span.clone(), NodeKind::Number(value)))
}

fn name(input: &mut Input<'_>) -> Reading<Node> {
    let (name, span) = any_name.with_span().parse_next(input)?;
    Ok(node(span, NodeKind::Name(name)))
}

/// Any name, the ones with a meaning included.
pub(crate) fn any_name(input: &mut Input<'_>) -> Reading<String> {
    let name = |lexed: &Lexed<'_>| match &lexed.token {
        Token::Name(name) => Some(name.to_string()),
        _ => None,
    };
    any.verify_map(name).parse_next(input)
}

fn square_root(input: &mut Input<'_>) -> Reading<Node> {
    let group = need(group('(', ')'), |i| here(i, "`sqrt` needs parentheses, as in `sqrt(3)`"));
    let (inner, span) = preceded(SQUARE_ROOT, group).with_span().parse_next(input)?;
    Ok(node(span, NodeKind::SquareRoot(Box::new(inner))))
}

/// `\frac{…}{…}`.
fn fraction(input: &mut Input<'_>) -> Reading<Node> {
    let no_group = say("`\\frac` is followed by two groups in braces", "write `\\frac{1}{2}`");
    let (above, below) = (need(group('{', '}'), &no_group), need(group('{', '}'), &no_group));
    let parts = preceded(one(|token| *token == Token::Fraction), (above, below.map(reciprocal)));
    let ((above, below), span) = parts.with_span().parse_next(input)?;
    Ok(node(span, NodeKind::Product(vec![above, below])))
}

/// A sum in parentheses or braces.
fn group<'t>(opening: char, closing: char) -> impl Parser<Input<'t>, Node, Refusal> {
    let inner = move |input: &mut Input<'t>| {
        let outside = std::mem::replace(&mut input.state.at_entry_level, false);
        let place = input[0].span.start;
        let not_closed = |input: &Input<'t>| {
            let place = input.state.text[..place].chars().count() + 1;
            let message = format!("expected `{closing}` for the `{opening}` at character {place}");
            here(input, message)
        };
        let inner = delimited(any, sum, need(closing, not_closed)).parse_next(input)?;
        input.state.at_entry_level = outside;
        Ok(inner)
    };
    preceded(peek(opening), deeper(inner)).with_span().map(widened)
}

fn node(span: Range<usize>, kind: NodeKind) -> Node {
    Node { kind, span }
}

fn negated((inner, span): (Node, Range<usize>)) -> Node {
    node(span, NodeKind::Negate(Box::new(inner)))
}

/// The same with a sign or parentheses around.
fn widened((inner, span): (Node, Range<usize>)) -> Node {
    node(span, inner.kind)
}

fn reciprocal(below: Node) -> Node {
    node(below.span.clone(), NodeKind::Reciprocal(Box::new(below)))
}

fn is_below_bar(node: &Node) -> bool {
    matches!(node.kind, NodeKind::Reciprocal(_))
}

fn is_signed_number(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Number(_) => true,
        NodeKind::Negate(inner) => is_signed_number(inner),
        _ => false,
    }
}

/// Whether a name after a number may be meant as a power of ten, as in `1e3`.
fn is_power_of_ten(name: &str) -> bool {
    let digits = name.strip_prefix(['e', 'E']);
    digits.is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()))
}

/// The only element, or all of them under one node.
fn joined(mut nodes: Vec<Node>, kind: fn(Vec<Node>) -> NodeKind) -> Node {
    if nodes.len() == 1 {
        return nodes.pop().expect("it has one element");
    }
    let span = nodes[0].span.start..nodes[nodes.len() - 1].span.end;
    node(span, kind(nodes))
}
