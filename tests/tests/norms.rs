//! Norms as formulas in the parameters, against norms by refining data at rational points.

use std::collections::BTreeMap;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, rational,
};
use refinable_analysis::{Budget, Comparison, Norm, PointwiseNorm, norm_values};
use refinable_scheme::{Expression, Mask, Scheme, Substitution};
use refinable_tests::{difference_symbol, iterated_norm};

/// Families, their arity, and the largest order whose difference scheme exists.
const FAMILIES: [(&str, usize, usize); 6] = [
    ("a3", 2, 1),
    ("a5", 2, 3),
    ("i4", 2, 1),
    ("i6", 2, 3),
    ("1/9*z^-4*(1+z+z^2)^3*(u+v*z+(1-u-v)*z^2)", 3, 2),
    ("1/3*z^-3*(1+z+z^2)^2*(u*v+(1-u)*z+(u-u*v)*z^2)", 3, 1),
];

fn point(scheme: &Scheme, values: &[Rational]) -> BTreeMap<Parameter, Rational> {
    scheme.mask().parameters().into_iter().zip(values.iter().cloned()).collect()
}

/// The mask at a point.
fn at(scheme: &Scheme, point: &BTreeMap<Parameter, Rational>) -> Vec<Rational> {
    let coefficient = |c: ParameterFraction| {
        let value = point.iter().fold(c, |c, (name, x)| {
            c.substitute(name, &ParameterPolynomial::constant(x.clone()).into()).unwrap()
        });
        value.as_constant().expect("every parameter has a value")
    };
    scheme.mask().coefficients().map(|(_, c)| coefficient(c)).collect()
}

fn norm(text: &str, arity: usize, continuity: usize, level: u32) -> Norm {
    let scheme = Scheme::resolve(text, arity).unwrap();
    Norm::of_difference(scheme.mask(), continuity, level, Budget::default()).unwrap()
}

fn pointwise(scheme: &Scheme, continuity: usize, level: u32) -> PointwiseNorm {
    PointwiseNorm::new(scheme.mask(), continuity, level, Budget::default()).unwrap()
}

fn printed(rows: &[&[&str]]) -> Norm {
    let polynomial = |text: &&str| {
        let value = Expression::parse(text).unwrap().evaluate().unwrap();
        value.as_polynomial().expect("a polynomial").clone()
    };
    let rows: Vec<Vec<_>> = rows.iter().map(|row| row.iter().map(polynomial).collect()).collect();
    Norm::new(&rows, ParameterPolynomial::one())
}

fn number() -> impl Strategy<Value = Rational> {
    (-30i64..=30, 1i64..=40).prop_map(|(p, q)| rational(p, q))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_formula_has_the_values_of_the_norm(
        family in 0..FAMILIES.len(),
        order in 0usize..=3,
        level in 1u32..=3,
        values in vec(number(), 2),
    ) {
        let (text, arity, highest) = FAMILIES[family];
        let order = order.min(highest);
        let scheme = Scheme::resolve(text, arity).unwrap();
        let point = point(&scheme, &values);
        let symbol = difference_symbol(&at(&scheme, &point), arity, order).unwrap();
        let expected = iterated_norm(&symbol, arity, level as usize);
        let found = norm(text, arity, order, level).value_at(&point);
        prop_assert_eq!(found.as_ref(), Some(&expected), "{} {} {}", text, order, level);
        let found = pointwise(&scheme, order, level).value_at(&point);
        prop_assert_eq!(found, Some(expected), "{} {} {}, pointwise", text, order, level);
    }

    /// The same norms where nothing is symbolic.
    #[test]
    fn norms_of_fixed_schemes(
        family in 0..FAMILIES.len(),
        order in 0usize..=3,
        values in vec(number(), 2),
    ) {
        let (text, arity, highest) = FAMILIES[family];
        let order = order.min(highest);
        let family = Scheme::resolve(text, arity).unwrap();
        let point = point(&family, &values);
        let set: Vec<_> = point
            .iter()
            .map(|(name, x)| Substitution::parse(&format!("{name}={x}")).unwrap())
            .collect();
        let scheme = family.with(&set).unwrap();
        let symbol = difference_symbol(&at(&family, &point), arity, order).unwrap();
        let expected: Vec<_> = (1..=4).map(|l| iterated_norm(&symbol, arity, l)).collect();
        let found = norm_values(scheme.mask(), order, 4, Budget::default()).unwrap();
        prop_assert_eq!(found, Some(expected), "{} {}", text, order);
    }

    /// A difference that is found is one: the two values are those of the norms at the witness.
    #[test]
    fn a_witness_is_a_witness(p in -5i64..=5, q in -5i64..=5, level in 1u32..=2) {
        let ours = norm("i4", 2, 0, level);
        let half = "1/2".to_string();
        let other = printed(&[&[&half, &format!("{p}*beta"), &format!("{q}*beta")]]);
        match ours.compare(&other) {
            Comparison::Equal => prop_assert!(level == 1 && p.abs() + q.abs() == 2),
            Comparison::Differ { at, left, right } => {
                prop_assert_ne!(&left, &right);
                prop_assert_eq!(Some(left), ours.value_at(&at));
                prop_assert_eq!(Some(right), other.value_at(&at));
                prop_assert!(level != 1 || p.abs() + q.abs() != 2);
            }
            Comparison::Unknown => prop_assert!(false, "two families of straight lines"),
        }
    }
}

/// The denominators of a family with a pole go below the bar, and its value there does not exist.
#[test]
fn a_norm_has_no_value_at_a_pole() {
    let mask = Mask::parse("[1/w, 1/2, 1-2/w, 1/2, 1/w]", 2).unwrap();
    let scheme = Scheme::resolve(&mask.to_string(), 2).unwrap();
    let norm = Norm::of_difference(scheme.mask(), 0, 1, Budget::default()).unwrap();
    let pointwise = pointwise(&scheme, 0, 1);
    let at = |w: i64| {
        let point = BTreeMap::from([(Parameter::new("w"), rational(w, 1))]);
        [norm.value_at(&point), pointwise.value_at(&point)]
    };
    assert_eq!(at(0), [None, None]);
    // α = 1/8, the cubic B-spline: c_0 = (1+z)³/8, of norm 1/2.
    assert_eq!(at(8), [Some(rational(1, 2)), Some(rational(1, 2))]);
}

#[test]
fn order_sign_and_splitting_of_terms_make_no_difference() {
    let ours = norm("i4", 2, 0, 1);
    for rows in [
        &[&["beta", "-beta", "1/2"][..]][..],
        &[&["1/4", "2*beta", "-1/4"]],
        &[&["1/2", "2*beta"], &["-2*beta", "-1/2"]],
    ] {
        assert_eq!(ours.compare(&printed(rows)), Comparison::Equal);
        assert_eq!(printed(rows).compare(&ours), Comparison::Equal);
    }
}

/// Two rows swapped, and a row that never is the largest.
#[test]
fn rows_in_another_order_are_the_same_norm() {
    let a = printed(&[&["alpha", "1"], &["beta", "2"]]);
    let b = printed(&[&["2", "beta"], &["1", "alpha"]]);
    assert_eq!(a.compare(&b), Comparison::Equal);
    let idle = printed(&[&["alpha", "1"], &["beta", "2"], &["beta", "1"]]);
    assert!(!matches!(a.compare(&idle), Comparison::Differ { .. }));
}

/// The conditions in the proof of the paper's theorem on C^1, C^3 and C^5: γ, η and χ.
#[test]
fn the_printed_norms_of_the_odd_families() {
    let gamma = printed(&[
        &["2*(2*alpha-4*beta*(1-alpha))"],
        &["4*beta*(1-alpha)", "1+4*beta*(1-alpha)-4*alpha"],
    ]);
    assert_eq!(norm("a3", 2, 1, 1).compare(&gamma), Comparison::Equal);
    let eta = printed(&[
        &["16*beta*(1-alpha)", "2*(-56*beta*(1-alpha)-32*alpha+1/2)"],
        &["2*(-32*beta*(1-alpha)-8*alpha)", "-48*alpha-64*beta*(1-alpha)+2"],
    ]);
    let ours = norm("a5", 2, 3, 1);
    assert_eq!(ours.compare(&eta), Comparison::Equal, "{ours}");
    let chi = printed(&[
        &[
            "64*beta*(1-alpha)",
            "2*(-512*beta*(1-alpha)+192*alpha-3/8)",
            "-19/4-960*beta*(1-alpha)+640*alpha",
        ],
        &["2*(-192*beta*(1-alpha)+32*alpha)", "2*(480*alpha-9/4-832*beta*(1-alpha))"],
    ]);
    let ours = norm("a7", 2, 5, 1);
    assert_eq!(ours.compare(&chi), Comparison::Equal, "{ours}");
}

#[test]
fn a_difference_scheme_that_does_not_exist_is_an_error() {
    let scheme = Scheme::resolve("i4", 2).unwrap();
    let error = Norm::of_difference(scheme.mask(), 2, 1, Budget::default()).unwrap_err();
    assert_eq!(error.code(), "divisibility");
}
