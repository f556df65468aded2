//! Masks typed in place: lists of coefficients, or symbols in `z`.
//!
//! ```text
//! mask  = list | sum | rules
//! list  = [ term "*" ] "[" sum { "," sum } "]" [ "@" index ]
//! rules = class ":" list { ";" class ":" list }
//! class = "even" | "odd" | integer
//! ```

use std::collections::BTreeSet;
use std::ops::Range;

use refinable_algebra::{Rational, Ring};
use winnow::combinator::{alt, delimited, fail, not, opt, peek, preceded, separated, terminated};
use winnow::prelude::*;
use winnow::token::any;

use crate::budget::{Budget, FARTHEST_INDEX, MOST_TERMS, at_most_terms};
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::expression::{Node, NodeKind, SYMBOL_VARIABLE};
use crate::mask::{Mask, check_arity};
use crate::parser::{integer, sum, sum_after, term};
use crate::quotient::Quotient;
use crate::reading::{Input, Reading, end, here, need, read, refuse, too_much, unexpected};

/// A mask as it was typed.
enum Typed {
    /// An expression in `z`.
    Symbol(Node),
    /// Coefficients.
    List(List),
    /// Stencils, `even` and `odd` or by their numbers.
    Rules(Vec<(u64, List)>),
}

struct List {
    factor: Option<Node>,
    entries: Vec<Node>,
    first: Option<i64>,
}

impl Mask {
    /// Reads a list `[a, b, …]`, perhaps with a scalar factor in front and the index of its first entry
    /// behind, `1/16*[-1, 0, 9, 16, 9, 0, -1] @ -3`, or a symbol, `1/8*z^-2*(1+z)^4`.
    ///
    /// Without an index the list is centred: the first entry has index `-⌊length/2⌋`, which makes a
    /// symmetric list primal if its length is odd and dual if it is even. The mask need not be
    /// normalised.
    ///
    /// Or rules, `even: [a, 1-2a, a]; odd: [1/2, 1/2]`: the weights of `f'_{mi}, f'_{mi+1}, …`, as many as the
    /// arity, by their numbers `0: …; 1: …; 2: …` as well. Without an index behind it a list of odd length is
    /// centred at `f_i`, and one of even length between `f_i` and `f_{i+1}`; an index is that of the first weight.
    ///
    /// A row pasted from a table in LaTeX, `\frac{1}{2}[2\alpha, 1, 2-4\alpha, 1, 2\alpha]`, is read as well.
    ///
    /// # Errors
    /// `syntax`, `symbol`, `pole`, `irrational`, `zero-mask`, `arity`, `budget`.
    pub fn parse(text: &str, arity: usize) -> Result<Self, Diagnostic> {
        let mut budget = Budget::new();
        let symbol = match read(text, mask)? {
            Typed::Symbol(root) => symbol_value(text, &root, &mut budget)?,
            Typed::List(list) => list.value(text, &mut budget)?,
            Typed::Rules(rules) => rules_value(text, &rules, arity, &mut budget)?,
        };
        Mask::of_quotient(arity, symbol, &mut budget).map_err(|error| error.at(text, 0..text.len()))
    }
}

fn symbol_value(text: &str, root: &Node, budget: &mut Budget) -> Result<Quotient, Diagnostic> {
    if !root.mentions(SYMBOL_VARIABLE) {
        let message = "this is neither a list `[...]` nor a symbol, an expression in `z`";
        return Err(Diagnostic::new("symbol", message)
            .with_hint("write coefficients in brackets, as in `[1/2, 1, 1/2]`")
            .at(text, root.span.clone()));
    }
    Evaluator::of_symbol(text, budget).evaluate(root)
}

/// `Σ_ε z^ε Σ_j w_j z^(-mj)`.
fn rules_value(
    text: &str,
    rules: &[(u64, List)],
    arity: usize,
    budget: &mut Budget,
) -> Result<Quotient, Diagnostic> {
    check_arity(arity).map_err(|error| error.at(text, 0..text.len()))?;
    let numbers: BTreeSet<u64> = rules.iter().map(|(class, _)| *class).collect();
    if rules.len() != arity || !numbers.iter().copied().eq(0..arity as u64) {
        let message =
            format!("a scheme of arity {arity} has the rules 0 to {}, once each", arity - 1);
        let hint = match arity {
            2 => "write `even: [...]; odd: [...]`, or name the arity",
            _ => "write `0: [...]; 1: [...]; 2: [...]` and so on, or name another arity",
        };
        return Err(Diagnostic::new("arity", message).with_hint(hint).at(text, 0..text.len()));
    }
    let mut parts = Vec::new();
    for (class, list) in rules {
        parts.push(list.stencil(text, *class as i64, arity as i64, budget)?);
    }
    let mut parts = parts.into_iter();
    let first = parts.next().expect("an arity is not zero");
    parts.try_fold(first, |sum, part| sum.plus(&part, budget))
}

impl List {
    /// The part of the symbol that the weights of a class make up.
    fn stencil(
        &self,
        text: &str,
        class: i64,
        arity: i64,
        budget: &mut Budget,
    ) -> Result<Quotient, Diagnostic> {
        let length = self.entries.len() as i64;
        at_most_terms(((length - 1) * arity).unsigned_abs() + 1)
            .map_err(|error| error.at(text, 0..text.len()))?;
        let first = self.first.unwrap_or(-(length - 1) / 2);
        // Backwards, with gaps: the weight of `f_{i+j}` is the coefficient of `z^(ε - mj)`.
        let zero = Node { kind: NodeKind::Number(Rational::zero()), span: 0..0 };
        let gaps = vec![zero; arity as usize - 1];
        let reversed = self.entries.iter().rev().cloned();
        let spread: Vec<Node> =
            reversed.flat_map(|w| std::iter::once(w).chain(gaps.clone())).collect();
        let lowest = class - arity * (first + length - 1);
        let list = List { factor: self.factor.clone(), entries: spread, first: Some(lowest) };
        list.value(text, budget)
    }

    fn value(&self, text: &str, budget: &mut Budget) -> Result<Quotient, Diagnostic> {
        let values = self
            .entries
            .iter()
            .map(|entry| Evaluator::of_parameters(text, budget).evaluate(entry))
            .collect::<Result<Vec<_>, _>>()?;
        let constants: Vec<_> =
            values.iter().map(|v| (v.numerator().coefficient(0), v.denominator())).collect();
        let parts = constants.iter().map(|(p, q)| (p, *q));
        let centred = -(self.entries.len() as i64 / 2);
        let first = self.first.unwrap_or(centred);
        let list = Quotient::from_list(first, parts, budget)?;
        match &self.factor {
            None => Ok(list),
            Some(factor) => {
                let factor = Evaluator::of_parameters(text, budget).evaluate(factor)?;
                list.times(&factor, budget)
            }
        }
    }
}

fn mask(input: &mut Input<'_>) -> Reading<Typed> {
    if input.state.text.contains(':') {
        return rules.map(Typed::Rules).parse_next(input);
    }
    let factor = list_factor(input)?;
    let is_list = peek(bracket).parse_next(input).is_ok();
    match factor {
        Some(first) if !is_list => Ok(Typed::Symbol(sum_after(first, input)?)),
        factor => {
            let list = list(factor, input)?;
            refuse(';', separate_entries).parse_next(input)?;
            Ok(Typed::List(list))
        }
    }
}

/// The factor of a list, or the first term of a symbol.
fn list_factor(input: &mut Input<'_>) -> Reading<Option<Node>> {
    opt(preceded(not('['), term(true))).parse_next(input)
}

fn bracket(input: &mut Input<'_>) -> Reading<Range<usize>> {
    preceded(opt('*'), '['.span()).parse_next(input)
}

fn rules(input: &mut Input<'_>) -> Reading<Vec<(u64, List)>> {
    let separator = terminated(';', not(end));
    terminated(separated(1.., rule, separator), opt(';')).parse_next(input)
}

fn rule(input: &mut Input<'_>) -> Reading<(u64, List)> {
    // Taken only when it is understood, so that the error points at it.
    let class = need(terminated(peek(class), any), |input| {
        here(input, "a rule begins with `even:`, `odd:` or its number and `:`")
    });
    let colon = need(':', |input| here(input, "the name of a rule is followed by `:`"));
    let (class, factor) = (terminated(class, colon), list_factor).parse_next(input)?;
    Ok((class, list(factor, input)?))
}

/// `even`, `odd` or a number.
fn class(input: &mut Input<'_>) -> Reading<u64> {
    let number = |input: &mut Input<'_>| match u64::try_from(integer(input)?) {
        Ok(number) => Ok(number),
        Err(_) => fail(input),
    };
    alt(("even".value(0), "odd".value(1), number)).parse_next(input)
}

/// From the bracket on, or the `*` in front of it.
fn list(factor: Option<Node>, input: &mut Input<'_>) -> Reading<List> {
    let no_list = |input: &Input<'_>| {
        here(input, "a rule is a list of weights, as in `even: [1/8, 3/4, 1/8]`")
    };
    let not_empty = refuse(']', |input| here(input, "the list is empty"));
    let bracket = terminated(need(bracket, no_list), not_empty).parse_next(input)?;
    let entries: Vec<Node> =
        separated(1..=MOST_TERMS as usize + 1, entry, ',').parse_next(input)?;
    if entries.len() as u64 > MOST_TERMS {
        let message = format!("a list has at most {MOST_TERMS} entries");
        return too_much(message, bracket, input);
    }
    let closed = preceded(refuse(end, not_closed), need(']', separate_entries));
    let index = opt(preceded('@', index));
    let factor_behind = refuse(alt(('*', '/')), |input| {
        unexpected(input).with_hint("write the factor in front, as in `1/16*[...]`")
    });
    let first = delimited(closed, index, factor_behind).parse_next(input)?;
    Ok(List { factor, entries, first })
}

fn not_closed(input: &Input<'_>) -> Diagnostic {
    here(input, "the list is not closed: `]` is missing")
}

fn separate_entries(input: &Input<'_>) -> Diagnostic {
    unexpected(input).with_hint("entries are separated by commas")
}

fn entry(input: &mut Input<'_>) -> Reading<Node> {
    (
        refuse(']', |input| here(input, "an entry is missing after the last comma")),
        refuse(',', |input| here(input, "an entry is missing before this comma")),
        refuse(end, not_closed),
    )
        .parse_next(input)?;
    input.state.at_entry_level = true;
    let entry = sum(input)?;
    input.state.at_entry_level = false;
    Ok(entry)
}

/// The index of the first entry.
fn index(input: &mut Input<'_>) -> Reading<i64> {
    let no_index =
        |input: &Input<'_>| here(input, "`@` is followed by the integer index of the first entry");
    let (sign, (size, span)) = (opt('-'), need(integer, no_index).with_span()).parse_next(input)?;
    match i64::try_from(size) {
        Ok(size) if size <= FARTHEST_INDEX => Ok(if sign.is_some() { -size } else { size }),
        _ => {
            let message = format!("indices go up to {FARTHEST_INDEX} in magnitude");
            too_much(message, span, input)
        }
    }
}
