//! Ring laws, and evaluation as a ring homomorphism.

use std::collections::BTreeMap;

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use refinable_algebra::{
    Laurent, Parameter, ParameterPolynomial, Polynomial, Rational, Ring, integer, rational,
};

use crate::expression::evaluate;
use crate::generate::{
    NAMES, Values, fraction, laurent, nonzero_fraction, parameter_polynomial, polynomial, short,
    value, values, whole,
};

fn commutative_ring<R: Ring>(a: &R, b: &R, c: &R, n: i64) -> Result<(), TestCaseError> {
    let (zero, one) = (R::zero(), R::one());
    prop_assert_eq!(a.plus(b), b.plus(a));
    prop_assert_eq!(a.plus(b).plus(c), a.plus(&b.plus(c)));
    prop_assert_eq!(&a.plus(&zero), a);
    prop_assert_eq!(a.plus(&a.negated()), zero.clone());
    prop_assert_eq!(a.minus(b), a.plus(&b.negated()));
    prop_assert_eq!(a.times(b), b.times(a));
    prop_assert_eq!(a.times(b).times(c), a.times(&b.times(c)));
    prop_assert_eq!(&a.times(&one), a);
    prop_assert_eq!(a.times(&zero), zero.clone());
    prop_assert_eq!(a.times(&b.plus(c)), a.times(b).plus(&a.times(c)));
    prop_assert_eq!(a.is_zero(), *a == zero);
    prop_assert_eq!(a.minus(b).is_zero(), a == b);
    derived_operations(a, b, c, n)
}

/// What a ring may override must agree with its definition.
fn derived_operations<R: Ring>(a: &R, b: &R, c: &R, n: i64) -> Result<(), TestCaseError> {
    let mut sum = a.clone();
    sum.add_product(b, c);
    prop_assert_eq!(sum, a.plus(&b.times(c)));
    let mut cancelled = b.times(c).negated();
    cancelled.add_product(b, c);
    prop_assert!(cancelled.is_zero());
    prop_assert_eq!(a.power(0), R::one());
    prop_assert_eq!(a.power(3), a.times(a).times(a));
    let counted = (0..n.abs()).fold(R::zero(), |sum, _| sum.plus(&R::one()));
    let expected = if n < 0 { counted.negated() } else { counted };
    prop_assert_eq!(R::from_i64(n), expected);
    Ok(())
}

/// `Σ c_k z^k` for a nonzero `z`, term by term.
fn laurent_value(a: &Laurent<Rational>, z: &Rational) -> Rational {
    let power = |k: i64| {
        let step = if k < 0 { rational(1, 1) / z } else { z.clone() };
        step.power(k.unsigned_abs() as u32)
    };
    a.terms().fold(rational(0, 1), |sum, (k, c)| sum + c * power(k))
}

proptest! {
    #[test]
    fn integer_polynomials_form_a_commutative_ring(
        a in polynomial(whole(), 5),
        b in polynomial(whole(), 5),
        c in polynomial(whole(), 5),
        n in -9i64..=9,
    ) {
        commutative_ring(&a, &b, &c, n)?;
    }

    #[test]
    fn rational_laurent_polynomials_form_a_commutative_ring(
        a in laurent(fraction(), 6),
        b in laurent(fraction(), 6),
        c in laurent(fraction(), 6),
        n in -9i64..=9,
    ) {
        commutative_ring(&a, &b, &c, n)?;
    }

    #[test]
    fn parameter_polynomials_form_a_commutative_ring(
        a in parameter_polynomial(3, 4),
        b in parameter_polynomial(3, 4),
        c in parameter_polynomial(3, 4),
        n in -9i64..=9,
    ) {
        commutative_ring(&a, &b, &c, n)?;
    }

    #[test]
    fn polynomials_over_parameter_polynomials_form_a_commutative_ring(
        a in polynomial(parameter_polynomial(2, 2), 2),
        b in polynomial(parameter_polynomial(2, 2), 2),
        c in polynomial(parameter_polynomial(2, 2), 2),
        n in -9i64..=9,
    ) {
        commutative_ring(&a, &b, &c, n)?;
    }

    #[test]
    fn the_coefficients_of_a_product_are_convolutions(
        a in polynomial(whole(), 6),
        b in polynomial(whole(), 6),
    ) {
        let product = a.times(&b);
        for k in 0..=13 {
            let convolution = (0..=k).fold(integer(0), |sum, i| {
                sum + a.coefficient(i) * b.coefficient(k - i)
            });
            prop_assert_eq!(product.coefficient(k), convolution);
        }
    }

    #[test]
    fn evaluation_of_polynomials_respects_sums_and_products(
        a in polynomial(fraction(), 5),
        b in polynomial(fraction(), 5),
        x in fraction(),
    ) {
        prop_assert_eq!(a.plus(&b).evaluate(&x), a.evaluate(&x) + b.evaluate(&x));
        prop_assert_eq!(a.minus(&b).evaluate(&x), a.evaluate(&x) - b.evaluate(&x));
        prop_assert_eq!(a.times(&b).evaluate(&x), a.evaluate(&x) * b.evaluate(&x));
        prop_assert_eq!(a.shifted(2).evaluate(&x), a.evaluate(&x) * &x * &x);
    }

    #[test]
    fn derivatives_of_polynomials_obey_the_product_rule(
        a in polynomial(whole(), 5),
        b in polynomial(whole(), 5),
    ) {
        let rule = a.derivative().times(&b).plus(&a.times(&b.derivative()));
        prop_assert_eq!(a.times(&b).derivative(), rule);
        prop_assert_eq!(Polynomial::variable().times(&a).derivative(),
            a.plus(&a.derivative().shifted(1)));
    }

    #[test]
    fn the_sign_at_a_rational_point_is_that_of_the_value(
        a in polynomial(whole(), 6),
        x in fraction(),
    ) {
        let over_q = a.map(|c| Rational::from(c.clone()));
        prop_assert_eq!(a.value_at(&x), over_q.evaluate(&x));
        prop_assert_eq!(a.sign_at(&x), over_q.evaluate(&x).cmp(&rational(0, 1)));
    }

    #[test]
    fn clearing_denominators_multiplies_by_a_number(a in polynomial(fraction(), 5)) {
        let (common, cleared) = a.cleared();
        let back = cleared.map(|c| Rational::new(c.clone(), common.clone()));
        prop_assert_eq!(back, a);
    }

    #[test]
    fn a_printed_polynomial_has_its_value(a in polynomial(whole(), 5), x in fraction()) {
        let values = Values::from([("x".to_string(), x.clone())]);
        prop_assert_eq!(evaluate(&a.to_string(), &values), a.value_at(&x));
    }

    #[test]
    fn evaluation_of_laurent_polynomials_respects_the_operations(
        a in laurent(fraction(), 6),
        b in laurent(fraction(), 6),
        z in nonzero_fraction(),
        k in 1usize..=3,
    ) {
        let at = |f: &Laurent<Rational>| laurent_value(f, &z);
        prop_assert_eq!(at(&a.plus(&b)), at(&a) + at(&b));
        prop_assert_eq!(at(&a.times(&b)), at(&a) * at(&b));
        prop_assert_eq!(at(&a.dilated(k)), laurent_value(&a, &z.power(k as u32)));
        prop_assert_eq!(at(&a.reversed()), laurent_value(&a, &(rational(1, 1) / &z)));
        prop_assert_eq!(at(&a.shifted(-2)) * &z * &z, at(&a));
    }

    #[test]
    fn derivatives_of_laurent_polynomials_obey_the_product_rule(
        a in laurent(short(), 6),
        b in laurent(short(), 6),
        k in -9i64..=9,
    ) {
        // The product rule alone allows any multiple of the derivative.
        let power = Laurent::monomial(integer(1), k);
        prop_assert_eq!(power.derivative(), Laurent::monomial(integer(k), k - 1));
        let rule = a.derivative().times(&b).plus(&a.times(&b.derivative()));
        prop_assert_eq!(a.times(&b).derivative(), rule);
    }

    #[test]
    fn a_laurent_polynomial_is_the_sum_of_its_terms(a in laurent(short(), 6)) {
        let sum = a.terms().fold(Laurent::zero(), |sum, (k, c)| {
            sum.plus(&Laurent::monomial(c.clone(), k))
        });
        prop_assert_eq!(&sum, &a);
        let (lowest, highest) = a.support().unwrap_or((0, -1));
        prop_assert_eq!(a.coefficients().len() as i64, highest - lowest + 1);
        for k in lowest - 2..=highest + 2 {
            let own = a.terms().find(|(exponent, _)| *exponent == k);
            prop_assert_eq!(a.coefficient(k), own.map_or(integer(0), |(_, c)| c.clone()));
        }
    }

    #[test]
    fn evaluation_of_parameter_polynomials_respects_the_operations(
        a in parameter_polynomial(3, 4),
        b in parameter_polynomial(3, 4),
        values in values(),
    ) {
        prop_assert_eq!(value(&a.plus(&b), &values), value(&a, &values) + value(&b, &values));
        prop_assert_eq!(value(&a.times(&b), &values), value(&a, &values) * value(&b, &values));
        let set = NAMES.iter().fold(a.clone(), |p, name| {
            p.with(&Parameter::new(name), &values[*name])
        });
        prop_assert_eq!(set.as_constant(), Some(value(&a, &values)));
        let mut point: BTreeMap<Parameter, Rational> =
            values.iter().map(|(name, x)| (Parameter::new(name), x.clone())).collect();
        prop_assert_eq!(a.value_at(&point), Some(value(&a, &values)));
        if let Some(parameter) = a.parameters().first() {
            point.remove(parameter);
            prop_assert_eq!(a.value_at(&point), None);
        }
    }

    #[test]
    fn collecting_by_a_parameter_changes_nothing(a in parameter_polynomial(3, 5)) {
        for parameter in NAMES.map(Parameter::new) {
            let collected = a.collected(&parameter);
            prop_assert_eq!(&ParameterPolynomial::from_collected(&collected, &parameter), &a);
            for c in collected.coefficients() {
                prop_assert!(!c.parameters().contains(&parameter));
            }
        }
    }

    #[test]
    fn partial_derivatives_commute_and_obey_the_product_rule(
        a in parameter_polynomial(2, 4),
        b in parameter_polynomial(2, 4),
    ) {
        let [x, y] = [0, 1].map(|k| Parameter::new(NAMES[k]));
        let rule = a.derivative(&x).times(&b).plus(&a.times(&b.derivative(&x)));
        prop_assert_eq!(a.times(&b).derivative(&x), rule);
        prop_assert_eq!(a.derivative(&x).derivative(&y), a.derivative(&y).derivative(&x));
    }

    #[test]
    fn a_printed_parameter_polynomial_has_its_value_both_ways(
        a in parameter_polynomial(3, 5),
        values in values(),
    ) {
        prop_assert_eq!(evaluate(&a.to_string(), &values), value(&a, &values));
        prop_assert_eq!(evaluate(&format!("{a:#}"), &values), value(&a, &values));
    }
}
