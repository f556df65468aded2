//! The grammar of expressions, by recursive descent.
//!
//! ```text
//! sum      = term { ("+" | "-") term }
//! term     = factor { ("*" | "/" | "") factor }
//! factor   = ("+" | "-") factor | power
//! power    = primary [ "^" exponent ]
//! exponent = sign integer | "(" sign integer ")"
//! primary  = number | name | "(" sum ")" | "sqrt" "(" sum ")" | "\frac" "{" sum "}" "{" sum "}"
//! ```
//!
//! Nothing is guessed. A number and a name without a blank between them are a product, `16a`, but neither
//! below a bar, `1/16a`, nor where they may be a power of ten, `1e3`; all other things side by side are
//! errors, and inside a list `1 -2` is neither a difference nor two entries. In LaTeX, where products are
//! written so, things side by side are one, but below a bar.

use std::ops::Range;

use refinable_algebra::{Integer, parse_rational};

use crate::diagnostic::Diagnostic;
use crate::expression::{Node, NodeKind, SQUARE_ROOT};
use crate::lexer::{Lexed, Lexer, Token};

/// The deepest nesting of parentheses and signs.
const DEEPEST: usize = 200;
/// The largest exponent in magnitude.
pub(crate) const LARGEST_EXPONENT: i32 = 10_000;
/// The largest sum of the squares of the lengths of all numbers: reading a decimal is quadratic.
const MOST_DIGIT_WORK: usize = 400_000_000;
/// The longest reading that a hint spells out.
const LONGEST_READING: usize = 60;

/// A parser with one token of lookahead.
pub(crate) struct Parser<'a> {
    pub text: &'a str,
    lexer: Lexer<'a>,
    pub current: Lexed,
    depth: usize,
    digit_work: usize,
    /// Whether an entry of a list is being read, outside all parentheses.
    pub at_entry_level: bool,
}

/// Where the next factor of a term begins: what a hint about a missing `*` needs to know.
struct LastFactor {
    term_start: usize,
    start: usize,
    below_bar: bool,
}

impl<'a> Parser<'a> {
    pub fn new(text: &'a str) -> Result<Self, Diagnostic> {
        let mut lexer = Lexer::new(text)?;
        let current = lexer.next()?;
        Ok(Parser { text, lexer, current, depth: 0, digit_work: 0, at_entry_level: false })
    }

    /// One expression and nothing after it.
    pub fn whole_expression(mut self) -> Result<Node, Diagnostic> {
        let root = self.sum()?;
        self.expect_end()?;
        Ok(root)
    }

    pub fn expect_end(&self) -> Result<(), Diagnostic> {
        match self.current.token {
            Token::End => Ok(()),
            _ => Err(self.unexpected()),
        }
    }

    /// Takes the current token and reads the next one.
    pub fn bump(&mut self) -> Result<Lexed, Diagnostic> {
        let next = self.lexer.next()?;
        Ok(std::mem::replace(&mut self.current, next))
    }

    /// Takes the current token if it is `wanted`.
    pub fn take(&mut self, wanted: &Token) -> Result<bool, Diagnostic> {
        let found = &self.current.token == wanted;
        if found {
            self.bump()?;
        }
        Ok(found)
    }

    /// Whether the text is LaTeX.
    fn is_latex(&self) -> bool {
        self.lexer.is_latex()
    }

    pub fn error(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new("syntax", message).at(self.text, self.current.span.clone())
    }

    pub fn unexpected(&self) -> Diagnostic {
        match self.current.token {
            Token::End => self.error("the text ends too early"),
            _ => self.error(format!("unexpected `{}`", self.shown(&self.current.span))),
        }
    }

    /// The bytes of a span, unless they are too many to quote.
    fn shown(&self, span: &Range<usize>) -> &str {
        let written = &self.text[span.clone()];
        if written.len() <= LONGEST_READING { written } else { "…" }
    }

    fn sum(&mut self) -> Result<Node, Diagnostic> {
        let first = self.term(false)?;
        self.sum_after(first)
    }

    /// The rest of a sum whose first term has been read.
    pub fn sum_after(&mut self, first: Node) -> Result<Node, Diagnostic> {
        let mut terms = vec![first];
        while matches!(self.current.token, Token::Plus | Token::Minus) {
            let operator = self.bump()?;
            self.reject_sign_glued_to_entry(&operator)?;
            let term = self.term(false)?;
            terms.push(match operator.token {
                Token::Minus => {
                    node(operator.span.start..term.span.end, NodeKind::Negate(Box::new(term)))
                }
                _ => term,
            });
        }
        Ok(joined(terms, NodeKind::Sum))
    }

    /// In `[1 -2 1]` the sign may belong to a new entry: refused, not guessed.
    fn reject_sign_glued_to_entry(&self, operator: &Lexed) -> Result<(), Diagnostic> {
        let glued = operator.after_blank && !self.current.after_blank;
        if !(self.at_entry_level && glued) || self.is_latex() {
            return Ok(());
        }
        let sign = &self.text[operator.span.clone()];
        let message = format!("` {sign}` may start a new entry or continue this one");
        Err(Diagnostic::new("syntax", message)
            .with_hint(format!("separate entries by commas, or put a blank after `{sign}`"))
            .at(self.text, operator.span.clone()))
    }

    /// A term; with `before_list` a final `*` in front of `[` is taken and ends it.
    pub fn term(&mut self, before_list: bool) -> Result<Node, Diagnostic> {
        let first = self.factor()?;
        let mut last =
            LastFactor { term_start: first.span.start, start: first.span.start, below_bar: false };
        let mut factors = vec![first];
        loop {
            if self.is_tacit_product(&factors[factors.len() - 1], last.below_bar) {
                let factor = self.power()?;
                last.start = factor.span.start;
                factors.push(factor);
                continue;
            }
            if before_list && self.is_latex() && self.current.token == Token::OpenList {
                return Ok(joined(factors, NodeKind::Product));
            }
            if !matches!(self.current.token, Token::Star | Token::Slash) {
                break;
            }
            let operator = self.bump()?;
            if operator.token == Token::Star && self.current.token == Token::Star {
                return Err(self.error("unexpected `**`").with_hint("powers are written `^`"));
            }
            last.below_bar = operator.token == Token::Slash;
            if before_list && !last.below_bar && self.current.token == Token::OpenList {
                return Ok(joined(factors, NodeKind::Product));
            }
            let factor = self.factor()?;
            last.start = factor.span.start;
            factors.push(if last.below_bar {
                node(factor.span.clone(), NodeKind::Reciprocal(Box::new(factor)))
            } else {
                factor
            });
        }
        match self.current.token {
            Token::Number | Token::Name(_) | Token::Open | Token::OpenBrace | Token::Fraction => {
                Err(self.missing_operator(&last))
            }
            Token::OpenList => Err(self
                .error("an operator is missing here")
                .with_hint("write the factor as in `1/16*[...]`")),
            _ => Ok(joined(factors, NodeKind::Product)),
        }
    }

    /// Whether what stands beside the last factor, without an operator, is one more.
    fn is_tacit_product(&self, last: &Node, below_bar: bool) -> bool {
        let begins = matches!(
            self.current.token,
            Token::Number | Token::Name(_) | Token::Open | Token::OpenBrace | Token::Fraction
        );
        if below_bar || !begins {
            return false;
        }
        if self.is_latex() {
            // Two numbers side by side are a slip of the pen.
            return self.current.token != Token::Number;
        }
        let is_number = is_signed_number(last) && last.span.end == self.current.span.start;
        match &self.current.token {
            Token::Name(name) => is_number && !is_power_of_ten(name),
            _ => false,
        }
    }

    /// Two factors side by side: says how each reading would be written.
    fn missing_operator(&mut self, last: &LastFactor) -> Diagnostic {
        let place = self.current.span.clone();
        let error = self.error("an operator is missing here");
        let is_entry = self.at_entry_level && self.current.after_blank;
        let text = self.text;
        let quoted = |span: Range<usize>| text[span].trim();
        let left = quoted(last.term_start..place.start);
        let right = match self.power() {
            Ok(power) => quoted(power.span),
            Err(_) => quoted(place.clone()),
        };
        let mut readings = Vec::new();
        if is_entry {
            readings.push(format!("`{left}, {right}`"));
        }
        readings.push(format!("`{left}*{right}`"));
        if last.below_bar {
            let above = quoted(last.term_start..last.start);
            let below = quoted(last.start..place.start);
            readings.push(format!("`{above}({below}*{right})`"));
        }
        if left.len() + right.len() > LONGEST_READING {
            error.with_hint("write `*` for a product")
        } else {
            error.with_hint(format!("write {}", readings.join(" or ")))
        }
    }

    fn factor(&mut self) -> Result<Node, Diagnostic> {
        if !matches!(self.current.token, Token::Plus | Token::Minus) {
            return self.power();
        }
        self.deeper()?;
        let sign = self.bump()?;
        let inner = self.factor()?;
        self.depth -= 1;
        let span = sign.span.start..inner.span.end;
        Ok(match sign.token {
            Token::Minus => node(span, NodeKind::Negate(Box::new(inner))),
            _ => node(span, inner.kind),
        })
    }

    fn deeper(&mut self) -> Result<(), Diagnostic> {
        self.depth += 1;
        if self.depth <= DEEPEST {
            return Ok(());
        }
        let message = format!("nested deeper than {DEEPEST} levels");
        Err(Diagnostic::new("budget", message).at(self.text, self.current.span.clone()))
    }

    fn power(&mut self) -> Result<Node, Diagnostic> {
        let base = self.primary()?;
        if !self.take(&Token::Caret)? {
            return Ok(base);
        }
        let (exponent, end) = self.exponent()?;
        if self.current.token == Token::Caret {
            return Err(self
                .error("`a^b^c` has two readings")
                .with_hint("write `(a^b)^c`, or the exponent as one number"));
        }
        let span = base.span.start..end;
        Ok(node(span, NodeKind::Power(Box::new(base), exponent)))
    }

    /// The exponent and the byte after it.
    fn exponent(&mut self) -> Result<(i32, usize), Diagnostic> {
        let closing = match self.current.token {
            Token::Open => Some(Token::Close),
            Token::OpenBrace => Some(Token::CloseBrace),
            _ => None,
        };
        if closing.is_some() {
            self.bump()?;
        }
        let negative = match self.current.token {
            Token::Minus | Token::Plus => self.bump()?.token == Token::Minus,
            _ => false,
        };
        if self.current.token != Token::Number {
            return Err(self.not_an_exponent());
        }
        let number = self.bump()?;
        let size = self.integer(&number)?;
        if size > Integer::from(LARGEST_EXPONENT) {
            let message = format!("exponents go up to {LARGEST_EXPONENT} in magnitude");
            return Err(Diagnostic::new("budget", message).at(self.text, number.span));
        }
        let mut end = number.span.end;
        if let Some(closing) = closing {
            if self.current.token != closing {
                return Err(self.not_an_exponent());
            }
            end = self.bump()?.span.end;
        }
        let size = i32::try_from(size).expect("at most the largest exponent");
        Ok((if negative { -size } else { size }, end))
    }

    fn not_an_exponent(&self) -> Diagnostic {
        self.error("an exponent is an integer, as in `z^-2`")
            .with_hint("for a square root write `sqrt(...)`")
    }

    /// The value of a number token that must be an integer.
    pub fn integer(&self, number: &Lexed) -> Result<Integer, Diagnostic> {
        let written = &self.text[number.span.clone()];
        written.parse().map_err(|_| {
            Diagnostic::new("syntax", "an integer is needed here")
                .at(self.text, number.span.clone())
        })
    }

    fn primary(&mut self) -> Result<Node, Diagnostic> {
        match &self.current.token {
            Token::Number => self.number(),
            Token::Name(name) if name == SQUARE_ROOT => self.square_root(),
            Token::Name(name) => {
                let name = name.clone();
                Ok(node(self.bump()?.span, NodeKind::Name(name)))
            }
            Token::Open | Token::OpenBrace => self.parenthesised(),
            Token::Fraction => self.fraction(),
            Token::OpenList => Err(self
                .error("a list cannot be a part of an expression")
                .with_hint("a single factor may stand in front of it, as in `(1/8 + w)*[...]`")),
            Token::End => Err(self.error("expected a number, a name or `(`")),
            _ => Err(self.unexpected()),
        }
    }

    fn number(&mut self) -> Result<Node, Diagnostic> {
        let span = self.bump()?.span;
        self.digit_work += span.len().pow(2);
        if self.digit_work > MOST_DIGIT_WORK {
            let message = "the numbers of this text have too many digits together";
            return Err(Diagnostic::new("budget", message).at(self.text, span));
        }
        let value = parse_rational(&self.text[span.clone()]);
        let value = value.expect("the lexer accepts the same decimals");
        Ok(node(span, NodeKind::Number(value)))
    }

    fn square_root(&mut self) -> Result<Node, Diagnostic> {
        let start = self.bump()?.span.start;
        if self.current.token != Token::Open {
            return Err(self.error("`sqrt` needs parentheses, as in `sqrt(3)`"));
        }
        let inner = self.parenthesised()?;
        let span = start..inner.span.end;
        Ok(node(span, NodeKind::SquareRoot(Box::new(inner))))
    }

    /// `\frac{…}{…}`.
    fn fraction(&mut self) -> Result<Node, Diagnostic> {
        let start = self.bump()?.span.start;
        let mut part = || {
            if self.current.token != Token::OpenBrace {
                let error = self.error("`\\frac` is followed by two groups in braces");
                return Err(error.with_hint("write `\\frac{1}{2}`"));
            }
            self.parenthesised()
        };
        let (above, below) = (part()?, part()?);
        let span = start..below.span.end;
        let below = node(below.span.clone(), NodeKind::Reciprocal(Box::new(below)));
        Ok(node(span, NodeKind::Product(vec![above, below])))
    }

    fn parenthesised(&mut self) -> Result<Node, Diagnostic> {
        self.deeper()?;
        let at_entry_level = std::mem::replace(&mut self.at_entry_level, false);
        let open = self.bump()?;
        let inner = self.sum()?;
        let (opening, closing, wanted) = match open.token {
            Token::OpenBrace => ('{', '}', Token::CloseBrace),
            _ => ('(', ')', Token::Close),
        };
        let open = open.span;
        if self.current.token != wanted {
            let place = self.column(&open);
            let message = format!("expected `{closing}` for the `{opening}` at character {place}");
            return Err(self.error(message));
        }
        self.at_entry_level = at_entry_level;
        self.depth -= 1;
        let end = self.bump()?.span.end;
        Ok(node(open.start..end, inner.kind))
    }

    /// The place of a span in characters, from 1.
    fn column(&self, span: &Range<usize>) -> usize {
        self.text[..span.start].chars().count() + 1
    }
}

fn node(span: Range<usize>, kind: NodeKind) -> Node {
    Node { kind, span }
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
