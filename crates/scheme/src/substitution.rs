//! Values for parameters.

use std::fmt;

use refinable_algebra::{Parameter, ParameterFraction};

use crate::budget::Budget;
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::expression::{SQUARE_ROOT, SYMBOL_VARIABLE};
use crate::lexer::Token;
use crate::parser::Parser;

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
        let mut parser = Parser::new(text)?;
        let Token::Name(name) = parser.current.token.clone() else {
            return Err(shape(parser.unexpected()));
        };
        if name == SYMBOL_VARIABLE || name == SQUARE_ROOT {
            let message = format!("`{name}` cannot be a parameter");
            let span = parser.current.span.clone();
            return Err(Diagnostic::new("substitution", message).at(text, span));
        }
        parser.bump()?;
        if !parser.take(&Token::Equals)? {
            return Err(shape(parser.unexpected()));
        }
        let root = parser.whole_expression()?;
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

fn shape(error: Diagnostic) -> Diagnostic {
    error.with_hint("a substitution is written `name=value`, as in `alpha=1/8`")
}
