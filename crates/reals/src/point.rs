//! Points of parameter space with real algebraic coordinates.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use refinable_algebra::{
    Integer, Ordered, Parameter, ParameterPolynomial, Polynomial, Rational, Ring,
};

use crate::algebraic::RealAlgebraic;

/// A value for each of finitely many parameters.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Point {
    coordinates: BTreeMap<Parameter, RealAlgebraic>,
}

/// A closed interval with rational ends.
pub(crate) type Enclosure = (Rational, Rational);

impl Point {
    /// The point with these coordinates.
    pub fn new(coordinates: impl IntoIterator<Item = (Parameter, RealAlgebraic)>) -> Self {
        Point { coordinates: coordinates.into_iter().map(|(p, x)| (p, x.simplified())).collect() }
    }

    /// The coordinates, by parameter.
    pub fn coordinates(&self) -> &BTreeMap<Parameter, RealAlgebraic> {
        &self.coordinates
    }

    /// The coordinates in the order of the parameters; `None` unless all are there and rational.
    pub fn rational_coordinates(&self, parameters: &[Parameter]) -> Option<Vec<Rational>> {
        parameters.iter().map(|p| self.coordinates.get(p)?.as_rational().cloned()).collect()
    }

    /// The exact sign of `polynomial` here.
    ///
    /// # Panics
    /// If a parameter of the polynomial has no coordinate.
    ///
    /// # Cost
    /// With at most one irrational coordinate, that of [`RealAlgebraic::sign_of`]. With more, the
    /// polynomial whose roots are all conjugates of the value is found by resultants, once the
    /// value is too small to be told from zero by enclosures.
    pub fn sign_of(&self, polynomial: &ParameterPolynomial) -> Ordering {
        let mut rest = polynomial.clone();
        for (parameter, x) in &self.coordinates {
            if let Some(x) = x.as_rational() {
                rest = rest.with(parameter, x);
            }
        }
        let unknown: Vec<Parameter> = rest.parameters().into_iter().collect();
        match unknown.as_slice() {
            [] => rest.as_constant().expect("no parameter is left").compare_to_zero(),
            [parameter] => {
                let (_, p) = rest.cleared_univariate(parameter).expect("one parameter is left");
                self.coordinate(parameter).sign_of(&p)
            }
            _ => self.sign_of_several(&rest, &unknown),
        }
    }

    fn coordinate(&self, parameter: &Parameter) -> &RealAlgebraic {
        self.coordinates.get(parameter).expect("the point has a coordinate for every parameter")
    }

    /// Shrinks the box around the point until the sign shows, or until the value is closer to zero
    /// than any nonzero conjugate of it can be.
    fn sign_of_several(&self, polynomial: &ParameterPolynomial, unknown: &[Parameter]) -> Ordering {
        let mut here: BTreeMap<_, _> =
            unknown.iter().map(|p| (p.clone(), self.coordinate(p).clone())).collect();
        let mut gap = None;
        for step in 0.. {
            let (lower, upper) = enclose(polynomial, &here);
            if lower.compare_to_zero().is_gt() || upper.compare_to_zero().is_lt() {
                return lower.compare_to_zero();
            }
            if step == 16 {
                gap = Some(root_gap(&self.value_polynomial(polynomial, unknown)));
            }
            if let Some(gap) = &gap
                && lower > -gap.clone()
                && upper < *gap
            {
                return Ordering::Equal;
            }
            for x in here.values_mut() {
                *x = x.halved();
            }
        }
        unreachable!("enclosures shrink to the value")
    }

    /// A polynomial in `w` with the root `polynomial(point)`: the resultants of `w - polynomial` with
    /// the defining polynomials of the coordinates, one after the other.
    fn value_polynomial(
        &self,
        polynomial: &ParameterPolynomial,
        unknown: &[Parameter],
    ) -> Polynomial<Integer> {
        // A name no parameter can have.
        let w = Parameter::new("value of the polynomial");
        let mut eliminated = ParameterPolynomial::parameter(&w).minus(polynomial);
        for parameter in unknown {
            let own = self.coordinate(parameter).polynomial();
            let own = own.map(|c| ParameterPolynomial::constant(Rational::from(c.clone())));
            eliminated = own.resultant(&eliminated.collected(parameter));
        }
        eliminated.cleared_univariate(&w).expect("only w is left").1
    }
}

/// A positive number below the size of every nonzero root (Cauchy's bound for the reversed
/// polynomial).
fn root_gap(polynomial: &Polynomial<Integer>) -> Rational {
    let nonzero = polynomial.coefficients().iter().find(|c| !c.is_zero());
    let lowest = nonzero.expect("the polynomial is monic in w, up to a constant").absolute();
    let largest = polynomial.coefficients().iter().map(Ordered::absolute).max().expect("not zero");
    Rational::new(lowest.clone(), lowest + largest)
}

/// Encloses the value over a box, by Horner's rule in interval arithmetic.
fn enclose(
    polynomial: &ParameterPolynomial,
    here: &BTreeMap<Parameter, RealAlgebraic>,
) -> Enclosure {
    if let Some(c) = polynomial.as_constant() {
        return (c.clone(), c);
    }
    let parameter = polynomial.parameters().into_iter().next().expect("not constant");
    let x = here[&parameter].bounds();
    let collected = polynomial.collected(&parameter);
    let zero = (Rational::zero(), Rational::zero());
    collected.coefficients().iter().rev().fold(zero, |sum, c| {
        let (lower, upper) = enclosed_product(&sum, &x);
        let c = enclose(c, here);
        (lower + c.0, upper + c.1)
    })
}

/// The interval of the products of the numbers of two intervals.
pub(crate) fn enclosed_product(a: &Enclosure, b: &Enclosure) -> Enclosure {
    let corners = [&a.0 * &b.0, &a.0 * &b.1, &a.1 * &b.0, &a.1 * &b.1];
    let lower = corners.iter().min().expect("four corners").clone();
    (lower, corners.into_iter().max().expect("four corners"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::isolate::real_roots;
    use refinable_algebra::integer;

    fn sqrt(n: i64) -> RealAlgebraic {
        real_roots(&Polynomial::new([-n, 0, 1].map(integer).to_vec())).pop().unwrap()
    }

    #[test]
    fn signs_at_two_irrational_coordinates() {
        let (x, y) = (Parameter::new("x"), Parameter::new("y"));
        let point = Point::new([(x.clone(), sqrt(2)), (y.clone(), sqrt(3))]);
        let [x, y] = [x, y].map(|p| ParameterPolynomial::parameter(&p));
        let int = ParameterPolynomial::from_i64;
        // x²y² = 6, and xy = √6 > 2.449
        assert_eq!(point.sign_of(&x.times(&y).power(2).minus(&int(6))), Ordering::Equal);
        let c = ParameterPolynomial::constant(refinable_algebra::rational(2449, 1000));
        assert_eq!(point.sign_of(&x.times(&y).minus(&c)), Ordering::Greater);
        assert_eq!(point.sign_of(&x.minus(&y)), Ordering::Less);
    }

    #[test]
    fn roots_that_are_not_zero_keep_their_distance() {
        // x² (2 - 3x) and x (x² - 2^40).
        let gap = |c: &[i64]| root_gap(&Polynomial::new(c.iter().map(|&c| integer(c)).collect()));
        assert_eq!(gap(&[0, 0, 2, -3]), refinable_algebra::rational(2, 5));
        assert_eq!(gap(&[0, -1 << 40, 0, 1]), refinable_algebra::rational(1, 2));
        assert_eq!(gap(&[1, -1]), refinable_algebra::rational(1, 2));
    }
}
