//! Masks typed in place: lists of coefficients, or symbols in `z`.
//!
//! ```text
//! mask  = list | sum | rules
//! list  = [ term "*" ] "[" sum { "," sum } "]" [ "@" index ]
//! rules = class ":" list { ";" class ":" list }
//! class = "even" | "odd" | integer
//! ```

use std::collections::BTreeSet;

use refinable_algebra::{Rational, Ring};

use crate::budget::{Budget, FARTHEST_INDEX, MOST_TERMS};
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::expression::{Node, NodeKind, SYMBOL_VARIABLE};
use crate::lexer::Token;
use crate::mask::Mask;
use crate::parser::Parser;
use crate::quotient::Quotient;

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
        let symbol = match Parser::new(text)?.mask()? {
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
    let numbers: BTreeSet<u64> = rules.iter().map(|(class, _)| *class).collect();
    if rules.len() != arity || !numbers.iter().copied().eq(0..arity as u64) {
        let message =
            format!("a scheme of arity {arity} has the rules 0 to {}, once each", arity - 1);
        let hint = "write `even: [...]; odd: [...]`, or name the arity";
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

impl Parser<'_> {
    fn mask(mut self) -> Result<Typed, Diagnostic> {
        if self.text.contains(':') {
            return self.rules();
        }
        if self.current.token == Token::OpenList {
            return self.whole_list(None);
        }
        let first = self.term(true)?;
        // The term has taken the `*` in front of the bracket, otherwise it would have failed.
        if self.current.token == Token::OpenList {
            return self.whole_list(Some(first));
        }
        let root = self.sum_after(first)?;
        self.expect_end()?;
        Ok(Typed::Symbol(root))
    }

    fn whole_list(mut self, factor: Option<Node>) -> Result<Typed, Diagnostic> {
        let list = self.list(factor)?;
        if self.current.token == Token::Semicolon {
            return Err(self.unexpected().with_hint("entries are separated by commas"));
        }
        self.expect_end()?;
        Ok(Typed::List(list))
    }

    fn rules(mut self) -> Result<Typed, Diagnostic> {
        let mut rules = Vec::new();
        loop {
            let class = self.class()?;
            let factor = match self.current.token {
                Token::OpenList => None,
                _ => Some(self.term(true)?),
            };
            if self.current.token != Token::OpenList {
                return Err(
                    self.error("a rule is a list of weights, as in `even: [1/8, 3/4, 1/8]`")
                );
            }
            let list = self.list(factor)?;
            rules.push((class, list));
            if !self.take(&Token::Semicolon)? {
                break;
            }
            if self.current.token == Token::End {
                break;
            }
        }
        self.expect_end()?;
        Ok(Typed::Rules(rules))
    }

    /// `even:`, `odd:` or a number and a colon.
    fn class(&mut self) -> Result<u64, Diagnostic> {
        let class = match &self.current.token {
            Token::Name(name) if name == "even" => Some(0),
            Token::Name(name) if name == "odd" => Some(1),
            Token::Number => u64::try_from(self.integer(&self.current)?).ok(),
            _ => None,
        };
        let error = self.error("a rule begins with `even:`, `odd:` or its number and `:`");
        let class = class.ok_or(error)?;
        self.bump()?;
        if !self.take(&Token::Colon)? {
            return Err(self.error("the name of a rule is followed by `:`"));
        }
        Ok(class)
    }

    /// From the bracket on.
    fn list(&mut self, factor: Option<Node>) -> Result<List, Diagnostic> {
        let open = self.bump()?.span;
        let mut entries = Vec::new();
        loop {
            entries.push(self.entry(entries.len())?);
            if entries.len() as u64 > MOST_TERMS {
                let message = format!("a list has at most {MOST_TERMS} entries");
                return Err(Diagnostic::new("budget", message).at(self.text, open));
            }
            match self.current.token {
                Token::Comma => self.bump()?,
                Token::CloseList => break,
                Token::End => return Err(self.error("the list is not closed: `]` is missing")),
                _ => {
                    return Err(self.unexpected().with_hint("entries are separated by commas"));
                }
            };
        }
        self.bump()?;
        let first = self.first_index()?;
        if matches!(self.current.token, Token::Star | Token::Slash) {
            return Err(self
                .unexpected()
                .with_hint("write the factor in front, as in `1/16*[...]`"));
        }
        Ok(List { factor, entries, first })
    }

    fn entry(&mut self, index: usize) -> Result<Node, Diagnostic> {
        match self.current.token {
            Token::CloseList if index == 0 => return Err(self.error("the list is empty")),
            Token::CloseList => return Err(self.error("an entry is missing after the last comma")),
            Token::Comma => return Err(self.error("an entry is missing before this comma")),
            Token::End => return Err(self.error("the list is not closed: `]` is missing")),
            _ => {}
        }
        self.at_entry_level = true;
        let first = self.term(false)?;
        let entry = self.sum_after(first)?;
        self.at_entry_level = false;
        Ok(entry)
    }

    /// What follows `@`, if that follows.
    fn first_index(&mut self) -> Result<Option<i64>, Diagnostic> {
        if !self.take(&Token::At)? {
            return Ok(None);
        }
        let negative = self.take(&Token::Minus)?;
        if self.current.token != Token::Number {
            return Err(self.error("`@` is followed by the integer index of the first entry"));
        }
        let number = self.bump()?;
        let size = self.integer(&number)?;
        match i64::try_from(size) {
            Ok(size) if size <= FARTHEST_INDEX => Ok(Some(if negative { -size } else { size })),
            _ => {
                let message = format!("indices go up to {FARTHEST_INDEX} in magnitude");
                Err(Diagnostic::new("budget", message).at(self.text, number.span))
            }
        }
    }
}
