//! Sparse polynomials over Q in any number of named parameters.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::number::{Integer, Rational, clear_denominators, integer};
use crate::parameter::{Monomial, Parameter};
use crate::polynomial::{Polynomial, push_term};
use crate::ring::{Domain, GcdDomain, Ring};

/// `Σ coefficient · monomial` over Q. Parameters are identified by name, so polynomials in
/// different parameters combine without further ado.
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct ParameterPolynomial {
    terms: BTreeMap<Monomial, Rational>,
}

impl ParameterPolynomial {
    /// The constant `c`.
    pub fn constant(c: Rational) -> Self {
        ParameterPolynomial::term(c, Monomial::one())
    }

    /// `c · monomial`.
    pub fn term(c: Rational, monomial: Monomial) -> Self {
        let mut result = ParameterPolynomial::default();
        result.add_term(monomial, &c);
        result
    }

    /// The parameter itself.
    pub fn parameter(parameter: &Parameter) -> Self {
        ParameterPolynomial::term(Rational::one(), Monomial::power(parameter.clone(), 1))
    }

    /// The terms, in ascending monomial order.
    pub fn terms(
        &self,
    ) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> + ExactSizeIterator {
        self.terms.iter()
    }

    /// The parameters that occur.
    pub fn parameters(&self) -> BTreeSet<Parameter> {
        self.terms.keys().flat_map(|m| m.factors().iter().map(|(p, _)| p.clone())).collect()
    }

    /// The total degree; `None` for zero.
    pub fn degree(&self) -> Option<u32> {
        self.terms.keys().next_back().map(Monomial::degree)
    }

    /// The value of a constant; `None` if a parameter occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.degree() {
            None => Some(Rational::zero()),
            Some(0) => self.terms.values().next().cloned(),
            Some(_) => None,
        }
    }

    /// The largest bit length of a numerator or denominator.
    pub fn height(&self) -> u64 {
        let bits = |c: &Rational| c.numer().bits().max(c.denom().bits());
        self.terms.values().map(bits).max().unwrap_or(0)
    }

    /// `c · self`.
    pub fn scaled(&self, c: &Rational) -> Self {
        if c.is_zero() {
            return ParameterPolynomial::zero();
        }
        ParameterPolynomial { terms: self.terms.iter().map(|(m, a)| (m.clone(), a * c)).collect() }
    }

    /// The polynomial sorted by powers of `parameter`: `Σ_k p_k · parameter^k`, the `p_k` free of it.
    pub fn collected(&self, parameter: &Parameter) -> Polynomial<ParameterPolynomial> {
        let mut powers: Vec<ParameterPolynomial> = Vec::new();
        for (monomial, c) in &self.terms {
            let exponent = monomial.exponent(parameter) as usize;
            if powers.len() <= exponent {
                powers.resize_with(exponent + 1, ParameterPolynomial::zero);
            }
            powers[exponent].add_term(monomial.without(parameter), c);
        }
        Polynomial::new(powers)
    }

    /// The inverse of [`collected`](Self::collected).
    pub fn from_collected(powers: &Polynomial<ParameterPolynomial>, parameter: &Parameter) -> Self {
        let mut result = ParameterPolynomial::zero();
        for (k, p) in powers.coefficients().iter().enumerate() {
            let power = Monomial::power(parameter.clone(), k as u32);
            for (monomial, c) in &p.terms {
                result.add_term(monomial.times(&power), c);
            }
        }
        result
    }

    /// The polynomial as one in `parameter` alone; `None` if another parameter occurs.
    pub fn univariate(&self, parameter: &Parameter) -> Option<Polynomial<Rational>> {
        let collected = self.collected(parameter);
        let constants: Option<Vec<_>> =
            collected.coefficients().iter().map(ParameterPolynomial::as_constant).collect();
        constants.map(Polynomial::new)
    }

    /// The partial derivative with respect to `parameter`.
    pub fn derivative(&self, parameter: &Parameter) -> Self {
        Self::from_collected(&self.collected(parameter).derivative(), parameter)
    }

    /// The polynomial with `parameter` set to a number.
    pub fn with(&self, parameter: &Parameter, value: &Rational) -> Self {
        self.collected(parameter).evaluate(&ParameterPolynomial::constant(value.clone()))
    }

    /// The value at a point; `None` unless the point gives every parameter a number.
    ///
    /// With the point over a common denominator, `n / d`, the value times `d^degree` is a sum of integers, if the
    /// coefficients are: a fraction is reduced once, not at every operation.
    ///
    /// # Cost
    /// A power and a product of integers for each factor of a term.
    pub fn value_at(&self, point: &BTreeMap<Parameter, Rational>) -> Option<Rational> {
        let (scale, coefficients) = clear_denominators(self.terms.values());
        let (d, cleared) = clear_denominators(point.values());
        let numerators: BTreeMap<&Parameter, Integer> = point.keys().zip(cleared).collect();
        let degree = self.degree().unwrap_or(0);
        let mut sum = integer(0);
        for (monomial, mut product) in self.terms.keys().zip(coefficients) {
            for (parameter, exponent) in monomial.factors() {
                product *= numerators.get(parameter)?.pow(*exponent);
            }
            sum += product * d.pow(degree - monomial.degree());
        }
        Some(Rational::new(sum, scale * d.pow(degree)))
    }

    /// The positive rational `c` and the primitive integer polynomial `p` with `self = ± c · p`
    /// and the leading coefficient of `p` positive; the sign is returned as `true` for minus.
    ///
    /// # Panics
    /// If the polynomial is zero.
    pub fn primitive(&self) -> (bool, Rational, Self) {
        let unit = self.unit_part().as_constant().expect("units of Q[…] are constants");
        let negative = unit < Rational::zero();
        let size = if negative { -unit.clone() } else { unit.clone() };
        (negative, size, self.scaled(&(Rational::one() / unit)))
    }

    /// The square-free part, primitive: the product of the distinct irreducible factors.
    ///
    /// In characteristic 0 a factor of multiplicity `e` divides every partial derivative `e - 1`
    /// times at least, and one in which it occurs exactly that often.
    ///
    /// # Panics
    /// If the polynomial is zero.
    pub fn square_free_part(&self) -> Self {
        let repeated =
            self.parameters().iter().fold(self.clone(), |g, p| g.gcd(&self.derivative(p)));
        self.quotient(&repeated).primitive().2
    }

    fn add_term(&mut self, monomial: Monomial, c: &Rational) {
        use std::collections::btree_map::Entry;
        if c.is_zero() {
            return;
        }
        match self.terms.entry(monomial) {
            Entry::Vacant(free) => {
                free.insert(c.clone());
            }
            Entry::Occupied(mut taken) => {
                *taken.get_mut() += c;
                if taken.get().is_zero() {
                    taken.remove();
                }
            }
        }
    }

    fn write(
        &self,
        f: &mut fmt::Formatter<'_>,
        order: impl Iterator<Item = (Monomial, Rational)>,
    ) -> fmt::Result {
        let mut text = String::new();
        for (monomial, c) in order {
            push_term(&mut text, &c, &monomial.to_string());
        }
        f.pad(if text.is_empty() { "0" } else { &text })
    }
}

impl From<Rational> for ParameterPolynomial {
    fn from(c: Rational) -> Self {
        ParameterPolynomial::constant(c)
    }
}

impl Ring for ParameterPolynomial {
    fn zero() -> Self {
        ParameterPolynomial::default()
    }
    fn one() -> Self {
        ParameterPolynomial::constant(Rational::one())
    }
    fn from_i64(n: i64) -> Self {
        ParameterPolynomial::constant(integer(n).into())
    }
    fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, c) in &other.terms {
            sum.add_term(monomial.clone(), c);
        }
        sum
    }
    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }
    fn times(&self, other: &Self) -> Self {
        let mut product = ParameterPolynomial::zero();
        product.add_product(self, other);
        product
    }
    fn negated(&self) -> Self {
        ParameterPolynomial { terms: self.terms.iter().map(|(m, c)| (m.clone(), -c)).collect() }
    }
    fn add_product(&mut self, a: &Self, b: &Self) {
        for (m, c) in &a.terms {
            for (n, d) in &b.terms {
                self.add_term(m.times(n), &(c * d));
            }
        }
    }
}

impl Domain for ParameterPolynomial {
    fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        if let Some(c) = divisor.as_constant() {
            return Some(self.scaled(&(Rational::one() / c)));
        }
        let parameter = divisor.parameters().into_iter().next()?;
        let quotient = self.collected(&parameter).divide_exactly(&divisor.collected(&parameter))?;
        Some(Self::from_collected(&quotient, &parameter))
    }
}

impl GcdDomain for ParameterPolynomial {
    /// Recursive: collected by one parameter, contents and subresultants live in the others.
    fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() && other.is_zero() {
            return ParameterPolynomial::zero();
        }
        // Beside a constant the contents of the other would be taken in vain, which is much work in many parameters.
        if self.degree() == Some(0) || other.degree() == Some(0) {
            return ParameterPolynomial::one();
        }
        let used = self.parameters();
        let others = other.parameters();
        let parameter = used.union(&others).next().expect("one of the two is not constant");
        // Integer coefficients keep the subresultants small.
        let collected = |p: &Self| {
            let primitive = if p.is_zero() { p.clone() } else { p.primitive().2 };
            primitive.collected(parameter)
        };
        let common = collected(self).gcd(&collected(other));
        Self::from_collected(&common, parameter).primitive().2
    }

    /// The rational number by which to divide so that the result is an integer polynomial, primitive,
    /// with a positive leading coefficient.
    fn unit_part(&self) -> Self {
        let Some((_, leading)) = self.terms.iter().next_back() else {
            return ParameterPolynomial::one();
        };
        let (common, cleared) = clear_denominators(self.terms.values());
        let content = cleared.iter().fold(integer(0), |g, c| GcdDomain::gcd(&g, c));
        let size = Rational::new(content, common);
        let unit = if leading < &Rational::zero() { -size } else { size };
        ParameterPolynomial::constant(unit)
    }
}

/// Plain `{}`: constant first, as masks are printed (`1 - 2*alpha`). Alternate `{:#}`: highest
/// degree first, as equations are printed (`8*alpha - 1`).
impl fmt::Display for ParameterPolynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut terms: Vec<_> = self.terms.iter().map(|(m, c)| (m.clone(), c.clone())).collect();
        terms.reverse();
        if !f.alternate() {
            terms.sort_by_key(|(m, _)| m.degree());
        }
        self.write(f, terms.into_iter())
    }
}

impl fmt::Debug for ParameterPolynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl ParameterPolynomial {
    /// The polynomial in `parameter` alone with integer coefficients and a common denominator:
    /// `self = p / d`. `None` if another parameter occurs.
    pub fn cleared_univariate(
        &self,
        parameter: &Parameter,
    ) -> Option<(Integer, Polynomial<Integer>)> {
        self.univariate(parameter).map(|p| p.cleared())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational;

    fn alpha() -> ParameterPolynomial {
        ParameterPolynomial::parameter(&Parameter::new("alpha"))
    }
    fn beta() -> ParameterPolynomial {
        ParameterPolynomial::parameter(&Parameter::new("beta"))
    }
    fn int(n: i64) -> ParameterPolynomial {
        ParameterPolynomial::from_i64(n)
    }

    #[test]
    fn displays_both_ways() {
        let p = int(1).minus(&alpha().scaled(&rational(3, 2))).plus(&alpha().times(&beta()));
        assert_eq!(p.to_string(), "1 - 3/2*alpha + alpha*beta");
        assert_eq!(format!("{p:#}"), "alpha*beta - 3/2*alpha + 1");
        assert_eq!(int(0).to_string(), "0");
    }

    #[test]
    fn gcd_finds_the_factor_two_variables_share() {
        let shared = alpha().times(&beta()).minus(&int(1));
        let a = shared.times(&alpha().plus(&beta()));
        let b = shared.times(&alpha().minus(&beta()).power(2)).scaled(&rational(-7, 3));
        assert_eq!(a.gcd(&b), shared);
        assert_eq!(alpha().gcd(&beta()), int(1));
        assert_eq!(int(0).gcd(&a.negated()), a);
    }

    #[test]
    fn primitive_splits_off_sign_and_content() {
        let p = int(1).minus(&alpha().scaled(&rational(8, 3)));
        let (negative, size, primitive) = p.primitive();
        assert!(negative);
        assert_eq!(size, rational(1, 3));
        assert_eq!(format!("{primitive:#}"), "8*alpha - 3");
    }

    #[test]
    fn square_free_part_in_two_variables() {
        let f = alpha().minus(&beta());
        let g = alpha().times(&alpha()).plus(&beta());
        let p = f.power(3).times(&g.power(2)).scaled(&rational(5, 7));
        assert_eq!(p.square_free_part(), f.times(&g).primitive().2);
    }

    #[test]
    fn exact_division_fails_where_it_must() {
        let product = alpha().plus(&int(2)).times(&beta().plus(&alpha()));
        assert_eq!(product.divide_exactly(&alpha().plus(&int(2))), Some(beta().plus(&alpha())));
        assert_eq!(product.divide_exactly(&alpha().plus(&int(3))), None);
        assert_eq!(beta().divide_exactly(&alpha()), None);
    }
}
