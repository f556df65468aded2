//! Constants of claims, such as `(-5+3*sqrt(37))/224`, as real algebraic numbers.

use refinable_algebra::{Integer, Ordered, Rational, Ring, bit_length, integer_square_root};
use refinable_reals::RealAlgebraic;
use refinable_scheme::{Diagnostic, Expression, Node, NodeKind};

/// `rational + coefficient · √radicand`.
#[derive(Clone)]
struct Surd {
    rational: Rational,
    coefficient: Rational,
    radicand: Rational,
}

impl From<Rational> for Surd {
    fn from(rational: Rational) -> Self {
        Surd { rational, coefficient: Rational::zero(), radicand: Rational::zero() }
    }
}

/// The value of a constant expression with at most one kind of square root.
///
/// # Errors
/// A syntax error, a parameter, a division by zero, or roots that do not combine.
pub fn constant(text: &str) -> Result<RealAlgebraic, Diagnostic> {
    let surd = evaluate(Expression::parse(text)?.root())
        .ok_or_else(|| unusable(text, "is no constant of the form p + q*sqrt(d)"))?;
    if surd.radicand.compare_to_zero().is_lt() {
        return Err(unusable(text, "has a negative number under the root"));
    }
    Ok(RealAlgebraic::quadratic(&surd.rational, &surd.coefficient, &surd.radicand))
}

fn unusable(text: &str, reason: &str) -> Diagnostic {
    Diagnostic::new("constant", format!("`{text}` {reason}"))
        .with_hint("write a constant such as 3/128 or (2-sqrt(6))/8")
}

fn evaluate(node: &Node) -> Option<Surd> {
    match &node.kind {
        NodeKind::Number(x) => Some(x.clone().into()),
        NodeKind::Name(_) => None,
        NodeKind::Negate(a) => Some(evaluate(a)?.scaled(&Rational::from_i64(-1))),
        NodeKind::Sum(terms) => terms
            .iter()
            .try_fold(Surd::from(Rational::zero()), |sum, term| sum.plus(&evaluate(term)?)),
        NodeKind::Product(factors) => factors
            .iter()
            .try_fold(Surd::from(Rational::one()), |product, f| product.times(&evaluate(f)?)),
        NodeKind::Reciprocal(a) => evaluate(a)?.inverse(),
        NodeKind::Power(base, exponent) => power(&evaluate(base)?, *exponent),
        NodeKind::SquareRoot(inner) => {
            let inner = evaluate(inner)?;
            let radicand = inner.coefficient.is_zero().then_some(inner.rational)?;
            Some(Surd::root(&radicand))
        }
    }
}

/// Exponents beyond this make no sense in a printed constant.
const LARGEST_EXPONENT: u32 = 64;
/// Nor do numbers with more bits.
const LARGEST_BITS: u64 = 4096;

fn power(base: &Surd, exponent: i32) -> Option<Surd> {
    let size = exponent.unsigned_abs();
    let base = if exponent < 0 { base.inverse()? } else { base.clone() };
    (size <= LARGEST_EXPONENT).then_some(())?;
    let step = |power: Surd, _| power.times(&base).filter(Surd::is_small);
    (0..size).try_fold(Surd::from(Rational::one()), step)
}

impl Surd {
    /// `√x`, a rational number if `x` is a square.
    fn root(x: &Rational) -> Self {
        let whole = |n: &Integer| {
            let root = integer_square_root(&n.absolute());
            (&root * &root == *n).then_some(root)
        };
        match (whole(x.numer()), whole(x.denom())) {
            (Some(p), Some(q)) => Rational::new(p, q).into(),
            _ => Surd {
                rational: Rational::zero(),
                coefficient: Rational::one(),
                radicand: x.clone(),
            },
        }
    }

    /// Whether the numbers are of a size that papers print.
    fn is_small(&self) -> bool {
        let parts = [&self.rational, &self.coefficient, &self.radicand];
        parts.iter().all(|x| bit_length(x.numer()).max(bit_length(x.denom())) <= LARGEST_BITS)
    }

    fn scaled(&self, c: &Rational) -> Self {
        Surd {
            rational: &self.rational * c,
            coefficient: &self.coefficient * c,
            radicand: self.radicand.clone(),
        }
    }

    /// The radicand two surds share, if they can be combined.
    fn common_radicand(&self, other: &Self) -> Option<Rational> {
        match (self.coefficient.is_zero(), other.coefficient.is_zero()) {
            (true, _) => Some(other.radicand.clone()),
            (_, true) => Some(self.radicand.clone()),
            _ => (self.radicand == other.radicand).then(|| self.radicand.clone()),
        }
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        Some(Surd {
            rational: &self.rational + &other.rational,
            coefficient: &self.coefficient + &other.coefficient,
            radicand: self.common_radicand(other)?,
        })
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let radicand = self.common_radicand(other)?;
        let roots = &self.coefficient * &other.coefficient * &radicand;
        Some(Surd {
            rational: &self.rational * &other.rational + roots,
            coefficient: &self.rational * &other.coefficient + &self.coefficient * &other.rational,
            radicand,
        })
    }

    /// `(p - q√d) / (p² - q² d)`.
    fn inverse(&self) -> Option<Self> {
        let norm = &self.rational * &self.rational
            - &self.coefficient * &self.coefficient * &self.radicand;
        let conjugate = Surd { coefficient: -self.coefficient.clone(), ..self.clone() };
        (!norm.is_zero()).then(|| conjugate.scaled(&(Rational::one() / norm)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(text: &str) -> String {
        constant(text).unwrap().exact_form().display("x")
    }

    #[test]
    fn constants_as_papers_print_them() {
        assert_eq!(exact("-13/224"), "-13/224");
        assert_eq!(exact("(-5+3*sqrt(37))/224"), "(-5+3*sqrt(37))/224");
        assert_eq!(exact("1/(2-sqrt(6))"), "(-2-sqrt(6))/2");
        assert_eq!(exact("sqrt(49/4)^2 - 1"), "45/4");
        assert_eq!(exact("1/(2+sqrt(4))"), "1/4");
    }

    #[test]
    fn what_is_no_constant_is_refused() {
        for bad in
            ["alpha", "sqrt(2)+sqrt(3)", "1/(1-1)", "sqrt(-1)", "sqrt(sqrt(2))", "((7^64)^64)^64"]
        {
            assert!(constant(bad).is_err(), "{bad}");
        }
    }
}
