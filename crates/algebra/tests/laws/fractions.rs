//! The field of quotients of parameter polynomials.

use proptest::prelude::*;
use refinable_algebra::{
    GcdDomain, Parameter, ParameterFraction, ParameterPolynomial, Pole, Rational, Ring,
};

use crate::expression::evaluate;
use crate::generate::{
    NAMES, Values, nonzero_parameter_polynomial, parameter_polynomial, value, values,
};

fn quotient() -> impl Strategy<Value = ParameterFraction> {
    (parameter_polynomial(2, 3), nonzero_parameter_polynomial(2, 2))
        .prop_map(|(top, bottom)| ParameterFraction::new(top, &bottom).unwrap())
}

/// The value at a point; `None` at a pole.
fn fraction_value(f: &ParameterFraction, values: &Values) -> Option<Rational> {
    let bottom = value(f.denominator(), values);
    (!bottom.is_zero()).then(|| value(f.numerator(), values) / bottom)
}

fn zero() -> ParameterFraction {
    ParameterPolynomial::zero().into()
}

fn one() -> ParameterFraction {
    ParameterPolynomial::one().into()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn a_fraction_is_in_lowest_terms_over_a_primitive_denominator(f in quotient()) {
        let gcd = f.numerator().gcd(f.denominator());
        prop_assert!(gcd == ParameterPolynomial::one());
        prop_assert_eq!(f.denominator().unit_part(), ParameterPolynomial::one());
    }

    #[test]
    fn equal_fractions_have_equal_parts(
        f in quotient(),
        factor in nonzero_parameter_polynomial(2, 2),
    ) {
        let top = f.numerator().times(&factor);
        prop_assert_eq!(ParameterFraction::new(top, &f.denominator().times(&factor)), Ok(f));
    }

    #[test]
    fn fractions_form_a_field(f in quotient(), g in quotient(), h in quotient()) {
        prop_assert_eq!(f.plus(&g), g.plus(&f));
        prop_assert_eq!(f.times(&g), g.times(&f));
        prop_assert_eq!(f.plus(&g).plus(&h), f.plus(&g.plus(&h)));
        prop_assert_eq!(f.times(&g).times(&h), f.times(&g.times(&h)));
        prop_assert_eq!(f.times(&g.plus(&h)), f.times(&g).plus(&f.times(&h)));
        prop_assert_eq!(&f.plus(&zero()), &f);
        prop_assert_eq!(&f.times(&one()), &f);
        prop_assert_eq!(f.minus(&f), zero());
        prop_assert_eq!(f.minus(&g), f.plus(&g.negated()));
        if f == zero() {
            prop_assert_eq!(one().divided_by(&f), Err(Pole));
        } else {
            prop_assert_eq!(f.times(&one().divided_by(&f).unwrap()), one());
            prop_assert_eq!(g.divided_by(&f).unwrap().times(&f), g);
        }
    }

    #[test]
    fn operations_on_fractions_are_operations_on_values(
        f in quotient(),
        g in quotient(),
        values in values(),
    ) {
        let at = |f: &ParameterFraction| fraction_value(f, &values);
        prop_assume!(at(&f).is_some() && at(&g).is_some());
        let (x, y) = (at(&f).unwrap(), at(&g).unwrap());
        prop_assert_eq!(at(&f.plus(&g)), Some(&x + &y));
        prop_assert_eq!(at(&f.minus(&g)), Some(&x - &y));
        prop_assert_eq!(at(&f.times(&g)), Some(&x * &y));
        if !y.is_zero() {
            prop_assert_eq!(at(&f.divided_by(&g).unwrap()), Some(x / y));
        }
    }

    #[test]
    fn substitution_commutes_with_evaluation(
        f in quotient(),
        g in quotient(),
        values in values(),
    ) {
        let parameter = Parameter::new(NAMES[0]);
        let inner = fraction_value(&g, &values);
        prop_assume!(inner.is_some());
        let mut moved = values.clone();
        moved.insert(NAMES[0].into(), inner.unwrap());
        let expected = fraction_value(&f, &moved);
        prop_assume!(expected.is_some());
        // Where the value exists, the substitution has no pole everywhere.
        let substituted = f.substitute(&parameter, &g);
        prop_assert!(substituted.is_ok());
        let value = fraction_value(&substituted.unwrap(), &values);
        prop_assert_eq!(value, expected);
    }

    #[test]
    fn substitution_of_a_root_of_the_denominator_is_a_pole(
        top in nonzero_parameter_polynomial(2, 2),
        root in parameter_polynomial(1, 2),
    ) {
        // top / (beta - root(alpha)) at beta = root(alpha)
        let beta = Parameter::new(NAMES[1]);
        let bottom = ParameterPolynomial::parameter(&beta).minus(&root);
        let f = ParameterFraction::new(top, &bottom).unwrap();
        let substituted = f.substitute(&beta, &root.into());
        prop_assert_eq!(substituted.is_err(), f.as_polynomial().is_none());
    }

    #[test]
    fn a_printed_fraction_has_its_value(f in quotient(), values in values()) {
        let expected = fraction_value(&f, &values);
        prop_assume!(expected.is_some());
        prop_assert_eq!(Some(evaluate(&f.to_string(), &values)), expected);
    }

    #[test]
    fn polynomials_and_constants_are_recognised(f in quotient()) {
        prop_assert_eq!(f.as_polynomial().is_some(), f.denominator().as_constant().is_some());
        prop_assert_eq!(f.as_constant().is_some(), f.parameters().is_empty());
    }
}
