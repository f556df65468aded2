//! The value of an expression, within a budget.

use refinable_algebra::{Laurent, Parameter, ParameterFraction, ParameterPolynomial, Ring};

use crate::budget::{Budget, Size};
use crate::diagnostic::Diagnostic;
use crate::expression::{Node, NodeKind, SYMBOL_VARIABLE};
use crate::quotient::Quotient;

/// The work charged for looking at a node, in nanoseconds.
const NODE: u64 = 5_000;

/// Evaluates the nodes of one text.
pub(crate) struct Evaluator<'a> {
    text: &'a str,
    budget: &'a mut Budget,
    in_symbol: bool,
}

impl<'a> Evaluator<'a> {
    /// For expressions in parameters, where `z` is an error.
    pub fn of_parameters(text: &'a str, budget: &'a mut Budget) -> Self {
        Evaluator { text, budget, in_symbol: false }
    }

    /// For symbols, Laurent polynomials in `z`.
    pub fn of_symbol(text: &'a str, budget: &'a mut Budget) -> Self {
        Evaluator { text, budget, in_symbol: true }
    }

    /// The value of a node.
    ///
    /// # Errors
    /// Those of [`Expression::evaluate`](crate::Expression::evaluate), pointing at the smallest node
    /// that causes them.
    pub fn evaluate(&mut self, node: &Node) -> Result<Quotient, Diagnostic> {
        self.value(node).map_err(|error| error.at(self.text, node.span.clone()))
    }

    /// The value of a node free of `z`, in lowest terms.
    pub fn fraction(&mut self, node: &Node) -> Result<ParameterFraction, Diagnostic> {
        let value = self.evaluate(node)?;
        if value.has_denominator() {
            // `coefficient` looks for common factors once more.
            self.budget
                .spend_on_gcd(&Size::of_symbol(value.numerator()), &Size::of(value.denominator()))
                .map_err(|error| error.at(self.text, node.span.clone()))?;
        }
        Ok(value.coefficient(0))
    }

    fn value(&mut self, node: &Node) -> Result<Quotient, Diagnostic> {
        self.budget.spend(NODE)?;
        match &node.kind {
            NodeKind::Number(value) => Ok(Quotient::constant(value.clone().into())),
            NodeKind::Name(name) => self.name(name),
            NodeKind::Negate(inner) => Ok(self.evaluate(inner)?.negated()),
            NodeKind::Sum(terms) => self.sum(terms),
            NodeKind::Product(factors) => self.product(factors),
            NodeKind::Reciprocal(_) => unreachable!("only a product has it, and never first"),
            NodeKind::Power(base, exponent) => self.evaluate(base)?.power(*exponent, self.budget),
            NodeKind::SquareRoot(_) => {
                Err(Diagnostic::new("irrational", "a square root is not a rational expression")
                    .with_hint("masks and substitutions are exact and rational"))
            }
        }
    }

    fn name(&self, name: &str) -> Result<Quotient, Diagnostic> {
        if name != SYMBOL_VARIABLE {
            let parameter = Parameter::new(name);
            return Ok(Quotient::constant(ParameterPolynomial::parameter(&parameter)));
        }
        if !self.in_symbol {
            let message = "`z` is the variable of symbols, it cannot be a parameter";
            return Err(Diagnostic::new("symbol", message));
        }
        let z = Laurent::monomial(ParameterPolynomial::one(), 1);
        Ok(Quotient::polynomial(z))
    }

    /// Added in pairs, so that a long sum of short terms copies each of them a few times only.
    fn sum(&mut self, terms: &[Node]) -> Result<Quotient, Diagnostic> {
        let mut values =
            terms.iter().map(|term| self.evaluate(term)).collect::<Result<Vec<_>, _>>()?;
        while values.len() > 1 {
            values = values
                .chunks(2)
                .map(|pair| match pair {
                    [a, b] => a.plus(b, self.budget),
                    _ => Ok(pair[0].clone()),
                })
                .collect::<Result<_, _>>()?;
        }
        Ok(values.pop().expect("a sum has terms"))
    }

    /// From left to right, as `a/b*c` is read.
    fn product(&mut self, factors: &[Node]) -> Result<Quotient, Diagnostic> {
        let mut value = self.evaluate(&factors[0])?;
        for factor in &factors[1..] {
            let step = match &factor.kind {
                NodeKind::Reciprocal(divisor) => {
                    let divisor = self.evaluate(divisor)?;
                    value.divided_by(&divisor, self.budget)
                }
                _ => {
                    let factor = self.evaluate(factor)?;
                    value.times(&factor, self.budget)
                }
            };
            value = step.map_err(|error| error.at(self.text, factor.span.clone()))?;
        }
        Ok(value)
    }
}
