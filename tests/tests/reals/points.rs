//! Signs at points of the plane with two irrational coordinates.

use std::cmp::Ordering;

use proptest::prelude::*;
use refinable_algebra::{Parameter, ParameterPolynomial, Rational, Ring, rational};
use refinable_reals::Point;
use refinable_tests::{NestedSurd, Surd};

use crate::generate::{fraction, in_parameter, irrational, plane, plane_polynomial, real};

fn point(x: &Surd, y: &Surd) -> Point {
    let [px, py] = plane();
    Point::new([(px, real(x)), (py, real(y))])
}

/// The value of `f` at `(x, y)` in `Q(√d)(√e)`, term by term.
fn value(f: &ParameterPolynomial, x: &Surd, y: &Surd) -> NestedSurd {
    let [px, py] = plane();
    let embedded = |rational: Rational, coefficient: Rational| NestedSurd {
        inner: x.constant(rational),
        coefficient: x.constant(coefficient),
        radicand: y.radicand.clone(),
    };
    let constant = |c: Rational| embedded(c, rational(0, 1));
    let x = NestedSurd { inner: x.clone(), ..constant(rational(0, 1)) };
    let y = embedded(y.rational.clone(), y.coefficient.clone());
    let power = |base: &NestedSurd, exponent: u32| {
        (0..exponent).fold(constant(rational(1, 1)), |power, _| power.times(base))
    };
    f.terms().fold(constant(rational(0, 1)), |sum, (m, c)| {
        let powers = power(&x, m.exponent(&px)).times(&power(&y, m.exponent(&py)));
        sum.plus(&constant(c.clone()).times(&powers))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn signs_at_two_irrational_coordinates_are_those_of_the_value(
        f in plane_polynomial(),
        x in irrational(),
        y in irrational(),
    ) {
        prop_assert_eq!(point(&x, &y).sign_of(&f), value(&f, &x, &y).sign());
    }

    #[test]
    fn signs_in_the_ideal_of_the_point_are_zero(
        f in plane_polynomial(),
        g in plane_polynomial(),
        x in irrational(),
        y in irrational(),
    ) {
        let [px, py] = plane();
        let at_x = in_parameter(&x.quadratic(), &px);
        let at_y = in_parameter(&y.quadratic(), &py);
        let combined = f.times(&at_x).plus(&g.times(&at_y));
        prop_assert_eq!(point(&x, &y).sign_of(&combined), Ordering::Equal);
    }

    #[test]
    fn signs_see_a_relation_between_the_coordinates(
        f in plane_polynomial(),
        x in irrational(),
        slope in fraction(),
        offset in fraction(),
        error in (12u32..=140, -1i64..=1),
    ) {
        // y = slope · x + offset, or next to it.
        let error = rational(error.1, 1) / rational(2, 1).power(error.0);
        let scaled = x.times(&x.constant(slope.clone()));
        let y = scaled.plus(&x.constant(&offset + &error));
        let [px, py] = plane().map(|p: Parameter| ParameterPolynomial::parameter(&p));
        let line = py.minus(&px.scaled(&slope)).minus(&ParameterPolynomial::constant(offset));
        let here = point(&x, &y);
        prop_assert_eq!(here.sign_of(&line), error.cmp(&rational(0, 1)));
        let product = line.times(&f);
        prop_assert_eq!(here.sign_of(&product), value(&product, &x, &y).sign());
    }
}

#[test]
fn three_coordinates_with_a_relation() {
    let names = ["x", "y", "z"].map(Parameter::new);
    let sqrt = |n: i64| real(&Surd::new(rational(0, 1), rational(1, 1), rational(n, 1)));
    let coordinates = names.iter().cloned().zip([2, 3, 6].map(sqrt));
    let here = Point::new(coordinates);
    let [x, y, z] = names.map(|p| ParameterPolynomial::parameter(&p));
    let relation = x.times(&y).minus(&z);
    assert_eq!(here.sign_of(&relation), Ordering::Equal);
    let tiny = ParameterPolynomial::constant(rational(1, 1 << 40));
    assert_eq!(here.sign_of(&relation.plus(&tiny)), Ordering::Greater);
    assert_eq!(here.sign_of(&relation.minus(&tiny)), Ordering::Less);
    assert_eq!(here.sign_of(&x.plus(&y).minus(&z)), Ordering::Greater);
}
