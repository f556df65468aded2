//! Laws that hold for all masks and all expressions.

use proptest::prelude::*;
use refinable_algebra::{
    Laurent, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, rational,
};
use refinable_scheme::{Expression, Mask, Node, NodeKind, Normalised, Rule, Stencil};

fn parameter(name: &str) -> ParameterPolynomial {
    ParameterPolynomial::parameter(&Parameter::new(name))
}

/// `(p + q·u + r·u·v) / (s + t·u)`, often a constant or zero.
fn fraction() -> impl Strategy<Value = ParameterFraction> {
    let small = || prop_oneof![2 => Just(0i64), 3 => -6i64..7];
    (small(), small(), small(), 1i64..5, small()).prop_map(|(p, q, r, s, t)| {
        let (u, v) = (parameter("u"), parameter("v"));
        let int = ParameterPolynomial::from_i64;
        let top = int(p).plus(&int(q).times(&u)).plus(&int(r).times(&u).times(&v));
        ParameterFraction::new(top, &int(s).plus(&int(t).times(&u))).expect("s is not zero")
    })
}

fn mask() -> impl Strategy<Value = Mask> {
    let coefficients = proptest::collection::vec(fraction(), 1..8);
    (2usize..6, -9i64..10, coefficients)
        .prop_filter_map("a mask is not zero", |(arity, first, c)| Mask::new(arity, first, &c).ok())
}

/// The value of a fraction at rational parameters, if it has one.
fn at(fraction: &ParameterFraction, u: &Rational, v: &Rational) -> Option<Rational> {
    let set = |p: &ParameterPolynomial| {
        let p = p.with(&Parameter::new("u"), u).with(&Parameter::new("v"), v);
        p.as_constant().expect("u and v are all there is")
    };
    let below = set(fraction.denominator());
    (!below.is_zero()).then(|| set(fraction.numerator()) / below)
}

fn constant(c: &Rational) -> ParameterFraction {
    ParameterPolynomial::constant(c.clone()).into()
}

/// Expressions in `u` and `v`, fully parenthesised or not.
fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("u".to_string()),
        Just("v".to_string()),
        (0i64..10).prop_map(|n| n.to_string()),
        (0i64..100).prop_map(|n| format!("0.{n:02}")),
    ];
    leaf.prop_recursive(4, 24, 3, |inner| {
        let pair = (inner.clone(), inner.clone());
        prop_oneof![
            pair.clone().prop_map(|(a, b)| format!("{a} + {b}")),
            pair.clone().prop_map(|(a, b)| format!("{a} - ({b})")),
            pair.clone().prop_map(|(a, b)| format!("({a})*({b})")),
            pair.prop_map(|(a, b)| format!("({a})/({b})")),
            (inner.clone(), -2i32..4).prop_map(|(a, n)| format!("({a})^{n}")),
            inner.prop_map(|a| format!("-({a})")),
        ]
    })
}

/// The value of a tree in Q, by nothing but rational arithmetic; `None` where it is undefined.
fn direct(node: &Node, u: &Rational, v: &Rational) -> Option<Rational> {
    let value = |node: &Node| direct(node, u, v);
    let reciprocal = |x: Rational| (!x.is_zero()).then(|| Rational::one() / x);
    match &node.kind {
        NodeKind::Number(c) => Some(c.clone()),
        NodeKind::Name(name) => Some(if name == "u" { u.clone() } else { v.clone() }),
        NodeKind::Negate(inner) => Some(-value(inner)?),
        NodeKind::Sum(terms) => {
            terms.iter().try_fold(Rational::zero(), |sum, t| Some(sum + value(t)?))
        }
        NodeKind::Product(factors) => {
            factors.iter().try_fold(Rational::one(), |product, f| Some(product * value(f)?))
        }
        NodeKind::Reciprocal(inner) => reciprocal(value(inner)?),
        NodeKind::Power(base, exponent) => {
            let base = value(base)?;
            let base = if *exponent < 0 { reciprocal(base)? } else { base };
            Some(base.power(exponent.unsigned_abs()))
        }
        NodeKind::SquareRoot(_) => None,
    }
}

/// Nothing is written beside the sources when a law fails; the failing case is printed.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn mask_rule_and_text_are_views_of_one_thing(mask in mask()) {
        let rule = mask.rule();
        prop_assert_eq!(rule.arity(), mask.arity());
        prop_assert_eq!(&rule.mask().unwrap(), &mask);
        prop_assert_eq!(&rule.mask().unwrap().rule(), &rule);
        prop_assert_eq!(&Mask::parse(&mask.to_string(), mask.arity()).unwrap(), &mask);
        let (first, _) = mask.support();
        let coefficients: Vec<_> = mask.coefficients().map(|(_, c)| c).collect();
        prop_assert_eq!(&Mask::new(mask.arity(), first, &coefficients).unwrap(), &mask);
        prop_assert!(mask.check_invariants());
    }

    #[test]
    fn stencils_written_as_rules_are_the_mask(mask in mask()) {
        let stencil = |stencil: &Stencil| {
            let weights: Vec<String> = stencil.weights().iter().map(ToString::to_string).collect();
            let weights = if weights.is_empty() { "0".to_string() } else { weights.join(", ") };
            format!("[{weights}] @ {}", stencil.first())
        };
        let stencils: Vec<String> = mask.rule().stencils().iter().map(stencil).collect();
        let numbered = |k: usize| format!("{k}: {}", stencils[k]);
        let rules: Vec<String> = (0..mask.arity()).rev().map(numbered).collect();
        prop_assert_eq!(&Mask::parse(&rules.join("; "), mask.arity()).unwrap(), &mask);
        if let [even, odd] = &stencils[..] {
            let rules = format!("even: {even}; odd: {odd}");
            prop_assert_eq!(&Mask::parse(&rules, 2).unwrap(), &mask);
        }
    }

    #[test]
    fn a_rule_weighs_what_the_mask_says(mask in mask(), e in 0usize..5, j in -12i64..13) {
        prop_assume!(e < mask.arity());
        let rule = mask.rule();
        let found = rule.stencils()[e].terms().find(|(at, _)| *at == j).map(|(_, w)| w.clone());
        let weight = mask.coefficient(e as i64 - mask.arity() as i64 * j);
        prop_assert_eq!(found.unwrap_or_else(|| constant(&Rational::zero())), weight);
    }

    #[test]
    fn a_stencil_sums_to_the_sum_of_its_weights(mask in mask()) {
        for (stencil, sum) in mask.rule().stencils().iter().zip(mask.stencil_sums()) {
            prop_assert_eq!(stencil.sum(), sum);
        }
    }

    #[test]
    fn dividing_by_the_stencil_sum_normalises(mask in mask()) {
        let stencils: Option<Vec<_>> = mask.rule().stencils().iter().map(|stencil| {
            let sum = stencil.sum();
            let scaled: Result<Vec<_>, _> =
                stencil.weights().iter().map(|w| w.divided_by(&sum)).collect();
            scaled.ok().filter(|w| !w.is_empty()).map(|w| Stencil::new(stencil.first(), w))
        }).collect();
        prop_assume!(stencils.is_some());
        match Rule::new(stencils.unwrap()).mask() {
            Ok(scaled) => prop_assert!(Normalised::new(scaled).is_ok()),
            // Five stencils may bring five denominators of degree five.
            Err(error) => prop_assert_eq!(error.code(), "budget"),
        }
        prop_assert_eq!(Normalised::new(mask.clone()).is_ok(), mask.stencil_sums().iter()
            .all(|sum| sum.as_constant() == Some(Rational::one())));
    }

    #[test]
    fn substitution_is_evaluation(mask in mask(), u in -4i64..5, v in -4i64..5) {
        let (u, v) = (rational(u, 3), rational(v, 2));
        let substituted = mask
            .substitute(&Parameter::new("u"), &constant(&u))
            .and_then(|m| m.substitute(&Parameter::new("v"), &constant(&v)));
        let values: Option<Vec<_>> = mask.coefficients().map(|(_, c)| at(&c, &u, &v)).collect();
        match (substituted, values) {
            (Ok(m), Some(values)) => {
                let expected = Laurent::new(mask.support().0, values);
                prop_assert_eq!(m.numerator().map(|c| c.as_constant().unwrap()), expected);
            }
            (Err(error), None) => prop_assert_eq!(error.code(), "pole"),
            (Err(error), Some(values)) => {
                prop_assert_eq!(error.code(), "zero-mask");
                prop_assert!(values.iter().all(Ring::is_zero));
            }
            (Ok(m), None) => prop_assert!(false, "no pole was seen in {m}"),
        }
    }

    #[test]
    fn an_expression_has_the_value_of_its_tree(
        text in expression(), u in -20i64..20, v in -20i64..20
    ) {
        let (u, v) = (rational(u, 7), rational(v, 5));
        let expression = Expression::parse(&text).unwrap();
        match expression.evaluate() {
            Ok(fraction) => {
                if let Some(expected) = direct(expression.root(), &u, &v) {
                    prop_assert_eq!(at(&fraction, &u, &v), Some(expected));
                }
            }
            Err(error) if error.code() == "pole" => {
                prop_assert_eq!(direct(expression.root(), &u, &v), None);
            }
            Err(error) => prop_assert_eq!(error.code(), "budget"),
        }
    }

    #[test]
    fn a_symbol_means_the_list_of_its_coefficients(
        c in proptest::collection::vec(-9i64..10, 1..9), first in -9i64..10
    ) {
        prop_assume!(c.iter().any(|c| *c != 0));
        let list: Vec<_> = c.iter().map(|c| format!("{c}/7 + {c}*w")).collect();
        let list = format!("[{}] @ {first}", list.join(", "));
        let terms = (first..).zip(&c).map(|(k, c)| format!("({c}*z^{k}/7 + w*{c}*z^({k}))"));
        let symbol = terms.collect::<Vec<_>>().join(" + ");
        prop_assert_eq!(Mask::parse(&list, 2).unwrap(), Mask::parse(&symbol, 2).unwrap());
    }
}
