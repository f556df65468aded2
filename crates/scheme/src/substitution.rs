//! Values for parameters.

use std::fmt;

use refinable_algebra::{Parameter, ParameterFraction};
use winnow::combinator::{peek, preceded};
use winnow::prelude::*;
use winnow::token::any;

use crate::budget::Budget;
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::expression::{Node, SQUARE_ROOT, SYMBOL_VARIABLE};
use crate::parser::{any_name, sum};
use crate::reading::{Input, Reading, need, read, unexpected, wrong};

/// A parameter and the number or expression that takes its place.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Substitution {
    parameter: Parameter,
    value: ParameterFraction,
}

impl Substitution {
    /// `parameter = value`.
    pub fn new(parameter: Parameter, value: ParameterFraction) -> Self {
        Substitution { parameter, value }
    }

    /// Reads `name=value`, the value a rational expression, perhaps in further parameters.
    ///
    /// ```
    /// use refinable_scheme::Substitution;
    /// let curve = Substitution::parse("beta = (8*alpha-1)/(16*(1-alpha))").unwrap();
    /// assert_eq!(curve.parameter().name(), "beta");
    /// assert_eq!(curve.value().to_string(), "-(8*alpha - 1)/(16*alpha - 16)");
    /// ```
    ///
    /// # Errors
    /// `syntax`, `substitution` for the names `z` and `sqrt`, and those of
    /// [`Expression::evaluate`](crate::Expression::evaluate).
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let (name, root) = read(text, substitution)?;
        let value = Evaluator::of_parameters(text, &mut Budget::new()).fraction(&root)?;
        Ok(Substitution::new(Parameter::new(&name), value))
    }

    /// The parameter that is replaced.
    pub fn parameter(&self) -> &Parameter {
        &self.parameter
    }

    /// What replaces it.
    pub fn value(&self) -> &ParameterFraction {
        &self.value
    }
}

/// `alpha=1/8`, as [`Substitution::parse`] reads it.
impl fmt::Display for Substitution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{}={}", self.parameter, self.value))
    }
}

/// `name "=" sum`
fn substitution(input: &mut Input<'_>) -> Reading<(String, Node)> {
    let shape = |input: &Input<'_>| {
        unexpected(input).with_hint("a substitution is written `name=value`, as in `alpha=1/8`")
    };
    let name = need(peek(any_name), shape).parse_next(input)?;
    if name == SYMBOL_VARIABLE || name == SQUARE_ROOT {
        let error = Diagnostic::new("substitution", format!("`{name}` cannot be a parameter"));
        return wrong(error.at(input.state.text, input[0].span.clone()));
    }
    let value = preceded((any, need('=', shape)), sum).parse_next(input)?;
    Ok((name, value))
}
