//! Masks typed in place: lists of coefficients, or symbols in `z`.
//!
//! ```text
//! mask = [ term "*" ] "[" sum { "," sum } "]" [ "@" index ]
//!      | sum
//! ```

use crate::budget::{Budget, FARTHEST_INDEX, MOST_TERMS};
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::expression::{Node, SYMBOL_VARIABLE};
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
    /// # Errors
    /// `syntax`, `symbol`, `pole`, `irrational`, `zero-mask`, `arity`, `budget`.
    pub fn parse(text: &str, arity: usize) -> Result<Self, Diagnostic> {
        let mut budget = Budget::new();
        let symbol = match Parser::new(text)?.mask()? {
            Typed::Symbol(root) => symbol_value(text, &root, &mut budget)?,
            Typed::List(list) => list.value(text, &mut budget)?,
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

impl List {
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
        if self.current.token == Token::OpenList {
            return self.list(None);
        }
        let first = self.term(true)?;
        // The term has taken the `*` in front of the bracket, otherwise it would have failed.
        if self.current.token == Token::OpenList {
            return self.list(Some(first));
        }
        let root = self.sum_after(first)?;
        self.expect_end()?;
        Ok(Typed::Symbol(root))
    }

    /// From the bracket on.
    fn list(mut self, factor: Option<Node>) -> Result<Typed, Diagnostic> {
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
        self.expect_end()?;
        Ok(Typed::List(List { factor, entries, first }))
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
