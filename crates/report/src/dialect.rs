//! Polynomials and fractions in parameters, as any language writes them.

use std::cmp::Ordering;

use refinable_algebra::{
    Monomial, Ordered, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring,
};

/// How a language writes the parts of a formula; the formulas follow.
pub trait Dialect {
    /// Between the terms of a sum: plus, and minus. A first term has a bare `-`.
    const SIGNS: [&str; 2];

    /// A parameter.
    fn name(&self, parameter: &Parameter) -> String;

    /// A number that is not negative; `alone` if it is all of a polynomial.
    fn number(&self, size: &Rational, alone: bool) -> String;

    /// `base^exponent`, the exponent above 1.
    fn power(&self, base: &str, exponent: u32) -> String;

    /// A product of a number, perhaps, and powers of parameters.
    fn product(&self, number: Option<String>, powers: &[String]) -> String;

    /// `top/bottom`.
    fn quotient(&self, top: &str, bottom: &str) -> String;

    /// A polynomial, constant term first, as masks are printed.
    fn polynomial(&self, p: &ParameterPolynomial) -> String {
        let mut terms: Vec<(&Monomial, &Rational)> = p.terms().rev().collect();
        terms.sort_by_key(|(m, _)| m.degree());
        let alone = terms.len() == 1;
        let mut text = String::new();
        for (m, c) in terms {
            text.push_str(match (text.is_empty(), c.compare_to_zero() == Ordering::Less) {
                (true, false) => "",
                (true, true) => "-",
                (false, negative) => Self::SIGNS[usize::from(negative)],
            });
            text.push_str(&self.term(m, &c.absolute(), alone));
        }
        if text.is_empty() { self.number(&Rational::zero(), true) } else { text }
    }

    /// A term without its sign; a coefficient of one is left out.
    fn term(&self, monomial: &Monomial, size: &Rational, alone: bool) -> String {
        if monomial.degree() == 0 {
            return self.number(size, alone);
        }
        let power = |(parameter, exponent): &(Parameter, u32)| match exponent {
            1 => self.name(parameter),
            _ => self.power(&self.name(parameter), *exponent),
        };
        let powers: Vec<String> = monomial.factors().iter().map(power).collect();
        let number = (*size != Rational::one()).then(|| self.number(size, false));
        self.product(number, &powers)
    }

    /// A fraction; a polynomial is written without a denominator.
    fn fraction(&self, f: &ParameterFraction) -> String {
        match f.as_polynomial() {
            Some(p) => self.polynomial(p),
            None => {
                let [top, bottom] = [f.numerator(), f.denominator()].map(|p| self.polynomial(p));
                self.quotient(&top, &bottom)
            }
        }
    }
}
