//! One number of a valid certificate is changed. Then either it is refused, or what it states is
//! still true: a lemma may be stronger than needed, and a smaller set is a weaker claim.

mod common;

use common::FOUR_POINT;
use proptest::prelude::*;
use refinable_algebra::{Integer, Polynomial, Rational, parse_rational, rational};
use refinable_certificate::{Certificate, Conclusion, End, Interval, verify};
use serde_json::{Value, json};

/// The paths of all numbers.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, v)| numbers(v, &format!("{path}/{i}"), found));
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(k, v)| numbers(v, &format!("{path}/{k}"), found));
        }
        Value::Number(_) => found.push(path.into()),
        Value::String(text) if parse_rational(text).is_some() => found.push(path.into()),
        _ => {}
    }
}

/// Another number of the same type.
fn changed(value: &Value, how: usize, by: i64) -> Value {
    let text = match value {
        Value::Number(n) => {
            let n = n.as_i64().expect("an integer");
            return json!(match how % 4 {
                0 => n.wrapping_add(by),
                1 => -n,
                2 => n.wrapping_add(by.signum()),
                _ => by,
            });
        }
        Value::String(text) => text,
        _ => unreachable!("not a number"),
    };
    let x = parse_rational(text).expect("a number");
    let y = match how % 4 {
        0 => x + rational(by, 1),
        1 => -x,
        2 => x + rational(by.signum(), 1_000_000_000),
        _ => x * rational(by, 97),
    };
    json!(y.to_string())
}

/// `32 ω³ + 4 ω - 1`, which is increasing.
fn critical() -> Polynomial<Integer> {
    Polynomial::new([-1, 4, 0, 32].map(Integer::from).to_vec())
}

/// Numbers below and above an end, close enough to compare it with the critical one unless equal.
fn bracket(end: &End) -> [Rational; 2] {
    let root = match end {
        End::Rational(x) => return [x.0.clone(), x.0.clone()],
        End::Algebraic(root) => root,
    };
    let [mut lower, mut upper] = root.between.clone().map(|x| x.0);
    let coefficients = root.root_of.iter().map(|c| c.0.clone()).collect();
    let polynomial = Polynomial::new(coefficients).cleared().1;
    for _ in 0..60 {
        let middle = (&lower + &upper) / Integer::from(2);
        if polynomial.sign_at(&middle) == polynomial.sign_at(&lower) {
            lower = middle;
        } else {
            upper = middle;
        }
    }
    [lower, upper]
}

/// Whether the end is at most (`false`: at least) the critical value, up to `2^-50`.
fn on_side(end: &End, below: bool) -> bool {
    let tolerance = rational(1, 1 << 50);
    let [lower, upper] = bracket(end);
    if below {
        critical().sign_at(&(lower - tolerance)).is_le()
    } else {
        critical().sign_at(&(upper + tolerance)).is_ge()
    }
}

/// C¹ exactly on `(0, critical)`. A rational end is not the critical number itself.
fn is_true(conclusion: &Conclusion, lowest: &Rational) -> bool {
    let Conclusion::Continuity { continuity: 1, proved, refuted } = conclusion else {
        return false;
    };
    let zero = rational(0, 1);
    let inside = |interval: &Interval| {
        let (Some(from), Some(to)) = (&interval.from, &interval.to) else { return false };
        bracket(from)[0] >= *lowest && on_side(to, true)
    };
    let outside = |interval: &Interval| {
        let left = interval.to.as_ref().is_some_and(|to| bracket(to)[1] <= zero);
        left || interval.from.as_ref().is_some_and(|from| on_side(from, false))
    };
    proved.iter().all(inside) && refuted.iter().all(outside)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn one_changed_number(place in any::<prop::sample::Index>(), how in 0_usize..4, by in -300_i64..300) {
        let valid: Value = serde_json::from_str(FOUR_POINT).unwrap();
        let mut paths = Vec::new();
        numbers(&valid, "", &mut paths);
        // As often outside the long lists of the polytope as inside.
        let (long, short): (Vec<_>, Vec<_>) = paths.into_iter().partition(|p| p.starts_with("/lemmas/1/"));
        let path = place.get(if by % 2 == 0 { &long } else { &short });
        let mut mutated = valid.clone();
        let number = mutated.pointer_mut(path).unwrap();
        *number = changed(number, how, by);
        let Ok(certificate) = Certificate::read(mutated.to_string().as_bytes()) else { return Ok(()) };
        if verify(&certificate).is_err() {
            return Ok(());
        }
        let original = Certificate::read(FOUR_POINT.as_bytes()).unwrap();
        // The exponent of the first coefficient moves the scheme, and nothing else.
        let mut family = certificate.family.clone();
        family.lowest = original.family.lowest;
        prop_assert!(family == original.family, "{path}");
        prop_assert!(is_true(&certificate.conclusion, &rational(1, 1_000_000)), "{path}");
    }
}

#[test]
fn the_truth_is_told_apart() {
    let read = |text: &str| Certificate::read(text.as_bytes()).unwrap().conclusion;
    let zero = rational(0, 1);
    assert!(is_true(&read(FOUR_POINT), &zero));
    let first = FOUR_POINT.find("\"conclusion\"").unwrap();
    let wrong = |from: &str, to: &str| {
        let (head, tail) = FOUR_POINT.split_at(first);
        read(&format!("{head}{}", tail.replacen(from, to, 1)))
    };
    assert!(!is_true(&wrong("1/100", "-1/100"), &zero));
    assert!(!is_true(&wrong("\"32\"", "\"31\""), &zero));
    assert!(!is_true(&wrong("\"continuity\":1", "\"continuity\":2"), &zero));
}
