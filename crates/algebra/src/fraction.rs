//! Quotients of parameter polynomials.

use std::collections::BTreeSet;
use std::fmt;

use crate::number::Rational;
use crate::parameter::Parameter;
use crate::parameter_polynomial::ParameterPolynomial;
use crate::ring::{Domain, GcdDomain, Ring};

/// `numerator / denominator` in lowest terms; the denominator is an integer polynomial, primitive,
/// with a positive leading coefficient, so equality of fractions is equality of their parts.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct ParameterFraction {
    numerator: ParameterPolynomial,
    denominator: ParameterPolynomial,
}

/// A substitution or division whose denominator vanishes identically.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pole;

impl fmt::Display for Pole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("division by an expression that is identically zero")
    }
}

impl std::error::Error for Pole {}

impl ParameterFraction {
    /// `numerator / denominator` in lowest terms.
    ///
    /// # Errors
    /// [`Pole`] if the denominator is zero.
    pub fn new(
        numerator: ParameterPolynomial,
        denominator: &ParameterPolynomial,
    ) -> Result<Self, Pole> {
        if denominator.is_zero() {
            return Err(Pole);
        }
        let common = numerator.gcd(denominator);
        let reduced = denominator.quotient(&common);
        let unit = reduced.unit_part();
        Ok(ParameterFraction {
            numerator: numerator.quotient(&common).quotient(&unit),
            denominator: reduced.quotient(&unit),
        })
    }

    /// The numerator; it carries the rational content of the fraction.
    pub fn numerator(&self) -> &ParameterPolynomial {
        &self.numerator
    }

    /// The denominator: 1 iff the fraction is a polynomial.
    pub fn denominator(&self) -> &ParameterPolynomial {
        &self.denominator
    }

    /// The fraction as a polynomial, if it is one.
    pub fn as_polynomial(&self) -> Option<&ParameterPolynomial> {
        (self.denominator == ParameterPolynomial::one()).then_some(&self.numerator)
    }

    /// The value of a constant; `None` if a parameter occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        self.as_polynomial().and_then(ParameterPolynomial::as_constant)
    }

    /// The parameters that occur.
    pub fn parameters(&self) -> BTreeSet<Parameter> {
        &self.numerator.parameters() | &self.denominator.parameters()
    }

    /// `self + other`.
    pub fn plus(&self, other: &Self) -> Self {
        let cross = |a: &Self, b: &Self| a.numerator.times(&b.denominator);
        self.over_product(&cross(self, other).plus(&cross(other, self)), other)
    }

    /// `self - other`.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// `self · other`.
    pub fn times(&self, other: &Self) -> Self {
        self.over_product(&self.numerator.times(&other.numerator), other)
    }

    /// `-self`.
    pub fn negated(&self) -> Self {
        ParameterFraction { numerator: self.numerator.negated(), ..self.clone() }
    }

    /// `self / other`.
    ///
    /// # Errors
    /// [`Pole`] if `other` is zero.
    pub fn divided_by(&self, other: &Self) -> Result<Self, Pole> {
        let numerator = self.numerator.times(&other.denominator);
        ParameterFraction::new(numerator, &self.denominator.times(&other.numerator))
    }

    /// The fraction with `parameter` replaced by `value`.
    ///
    /// # Errors
    /// [`Pole`] if the denominator vanishes identically after the substitution.
    pub fn substitute(&self, parameter: &Parameter, value: &Self) -> Result<Self, Pole> {
        let top = substitute_polynomial(&self.numerator, parameter, value);
        let bottom = substitute_polynomial(&self.denominator, parameter, value);
        top.divided_by(&bottom)
    }

    fn over_product(&self, numerator: &ParameterPolynomial, other: &Self) -> Self {
        let denominator = self.denominator.times(&other.denominator);
        ParameterFraction::new(numerator.clone(), &denominator)
            .expect("a product of nonzero denominators is not zero")
    }
}

/// Horner in `parameter`.
fn substitute_polynomial(
    polynomial: &ParameterPolynomial,
    parameter: &Parameter,
    value: &ParameterFraction,
) -> ParameterFraction {
    let powers = polynomial.collected(parameter);
    let zero = ParameterFraction::from(ParameterPolynomial::zero());
    powers
        .coefficients()
        .iter()
        .rev()
        .fold(zero, |sum, c| sum.times(value).plus(&ParameterFraction::from(c.clone())))
}

impl From<ParameterPolynomial> for ParameterFraction {
    fn from(numerator: ParameterPolynomial) -> Self {
        ParameterFraction { numerator, denominator: ParameterPolynomial::one() }
    }
}

/// `(8*alpha - 1)/(16*alpha - 16)`; a polynomial is written without a denominator.
impl fmt::Display for ParameterFraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(polynomial) = self.as_polynomial() {
            return fmt::Display::fmt(polynomial, f);
        }
        let (negative, content, primitive) = if self.numerator.is_zero() {
            (false, Rational::one(), self.numerator.clone())
        } else {
            self.numerator.primitive()
        };
        let top = primitive.scaled(&Rational::from(content.numer().clone()));
        let bottom = self.denominator.scaled(&Rational::from(content.denom().clone()));
        let sign = if negative { "-" } else { "" };
        let bracket = |text: String, needed: bool| if needed { format!("({text})") } else { text };
        let above = bracket(format!("{top:#}"), top.terms().len() > 1);
        // A product below the bar needs brackets too: 1/(2*alpha).
        let below = format!("{bottom:#}");
        let product = below.contains('*');
        let below = bracket(below, product || bottom.terms().len() > 1);
        f.pad(&format!("{sign}{above}/{below}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational;

    fn alpha() -> ParameterPolynomial {
        ParameterPolynomial::parameter(&Parameter::new("alpha"))
    }
    fn int(n: i64) -> ParameterPolynomial {
        ParameterPolynomial::from_i64(n)
    }

    /// The paper's curve β(α) = -(1/16) (8α-1)/(α-1), put into the edge weight β(1-α).
    #[test]
    fn the_curve_of_the_paper_makes_the_edge_weight_polynomial() {
        let top = alpha().scaled(&rational(8, 1)).minus(&int(1));
        let curve =
            ParameterFraction::new(top.scaled(&rational(-1, 16)), &alpha().minus(&int(1))).unwrap();
        assert_eq!(curve.to_string(), "-(8*alpha - 1)/(16*alpha - 16)");
        let beta = Parameter::new("beta");
        let weight = ParameterPolynomial::parameter(&beta).times(&int(1).minus(&alpha()));
        let on_curve = ParameterFraction::from(weight).substitute(&beta, &curve).unwrap();
        assert_eq!(on_curve.as_polynomial(), Some(&top.scaled(&rational(1, 16))));
    }

    #[test]
    fn a_pole_is_an_error_not_a_value() {
        let a = Parameter::new("alpha");
        let inverse = ParameterFraction::new(int(1), &alpha().minus(&int(1))).unwrap();
        let one = ParameterFraction::from(int(1));
        assert_eq!(inverse.substitute(&a, &one), Err(Pole));
        assert_eq!(one.divided_by(&one.minus(&one)), Err(Pole));
    }
}
