//! Expressions in numbers and names, as people type them into masks.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use refinable_algebra::{ParameterFraction, Rational};

use crate::budget::Budget;
use crate::diagnostic::Diagnostic;
use crate::evaluation::Evaluator;
use crate::parser::sum;
use crate::reading::read;

/// The variable of symbols; never a parameter.
pub(crate) const SYMBOL_VARIABLE: &str = "z";
/// The function that only the notation of real numbers knows; never a parameter.
pub(crate) const SQUARE_ROOT: &str = "sqrt";

/// An expression with the text it was read from.
///
/// Numbers are integers or exact decimals; names start with a letter, Greek ones becoming their
/// English names (`α` is `alpha`); operators are `+ - * / ^` with integer exponents; `sqrt(…)` is
/// the only function. Products need their `*`, but for a number and a name side by side, `16a`; `1/16a` is an
/// error that offers both readings.
///
/// ```
/// use refinable_scheme::Expression;
/// let curve = Expression::parse("(8α - 1)/(16(1 - α))").unwrap_err();
/// assert_eq!(curve.hint(), Some("write `16*(1 - α)`"));
/// let curve = Expression::parse("(8α - 1)/(16*(1 - α))").unwrap();
/// assert_eq!(curve.evaluate().unwrap().to_string(), "-(8*alpha - 1)/(16*alpha - 16)");
/// ```
#[derive(Clone, Debug)]
pub struct Expression {
    text: Arc<str>,
    root: Node,
}

/// A part of an expression and the bytes of the text that it stands for.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it is written.
    pub span: Range<usize>,
}

/// The kinds of nodes.
///
/// Sums and products are lists, so that the depth of a tree is the nesting of the text and a chain
/// of a hundred thousand terms is as flat as one of two: `a - b` is the sum of `a` and `Negate(b)`,
/// `a/b*c` the product of `a`, `Reciprocal(b)` and `c`, to be taken from left to right.
#[derive(Clone, Debug)]
pub enum NodeKind {
    /// An integer or an exact decimal, never negative.
    Number(Rational),
    /// A parameter, or the variable `z` of a symbol.
    Name(String),
    /// `-x`.
    Negate(Box<Node>),
    /// `x + y + …`, at least two terms.
    Sum(Vec<Node>),
    /// `x * y * …`, at least two factors.
    Product(Vec<Node>),
    /// `1/x`; occurs only as a factor of a product, and never first.
    Reciprocal(Box<Node>),
    /// `x^exponent`.
    Power(Box<Node>, i32),
    /// `sqrt(x)`.
    SquareRoot(Box<Node>),
}

impl Expression {
    /// Reads `text`, all of it.
    ///
    /// # Errors
    /// `syntax` with the place and, where one is known, another way to write it; `budget` for a text
    /// over 1 MiB, nesting over 200, numbers over 10 000 digits or exponents over 10 000.
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let root = read(text, sum)?;
        Ok(Expression { text: text.into(), root })
    }

    /// The text as it was typed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The tree.
    pub fn root(&self) -> &Node {
        &self.root
    }

    /// The names that occur, `z` included.
    pub fn names(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        self.root.collect_names(&mut names);
        names
    }

    /// The expression as a fraction in lowest terms in its parameters.
    ///
    /// # Errors
    /// `irrational` for a square root, `pole` for a division by something identically zero,
    /// `symbol` if `z` occurs, `budget` if the result or the way to it is too large.
    ///
    /// # Cost
    /// The work of every step is bounded before it is done: about a second at most, and a few seconds
    /// for fractions in several parameters, whose common factors are hard to foresee.
    pub fn evaluate(&self) -> Result<ParameterFraction, Diagnostic> {
        Evaluator::of_parameters(&self.text, &mut Budget::new()).fraction(&self.root)
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.text)
    }
}

impl Node {
    /// Whether the name occurs below this node.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        match &self.kind {
            NodeKind::Number(_) => false,
            NodeKind::Name(found) => found == name,
            _ => self.children().any(|child| child.mentions(name)),
        }
    }

    fn collect_names(&self, names: &mut BTreeSet<String>) {
        if let NodeKind::Name(name) = &self.kind {
            names.insert(name.clone());
        }
        self.children().for_each(|child| child.collect_names(names));
    }

    fn children(&self) -> impl Iterator<Item = &Node> {
        let children = match &self.kind {
            NodeKind::Number(_) | NodeKind::Name(_) => &[],
            NodeKind::Sum(list) | NodeKind::Product(list) => list.as_slice(),
            NodeKind::Negate(inner)
            | NodeKind::Reciprocal(inner)
            | NodeKind::Power(inner, _)
            | NodeKind::SquareRoot(inner) => std::slice::from_ref(inner.as_ref()),
        };
        children.iter()
    }
}
