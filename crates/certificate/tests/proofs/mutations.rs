//! One value of a valid certificate is changed. Then either it is refused, or what it states is
//! still true: a lemma may be stronger than needed, and a smaller set is a weaker claim.

use proptest::prelude::*;
use refinable_algebra::{Integer, Polynomial, Rational, parse_rational, rational};
use refinable_certificate::{Certificate, Conclusion, End, Interval, verify};
use serde_json::{Value, json};

use crate::support::{FOUR_POINT, growing_waves, leaning_theorem, turning_theorem, waves};

/// The paths of all numbers and truth values.
fn places(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, v)| places(v, &format!("{path}/{i}"), found));
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(k, v)| places(v, &format!("{path}/{k}"), found));
        }
        Value::Number(_) | Value::Bool(_) => found.push(path.into()),
        Value::String(text) if parse_rational(text).is_some() => found.push(path.into()),
        _ => {}
    }
}

/// Another value of the same type.
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
        Value::Bool(is) => return json!(!is),
        Value::String(text) => text,
        _ => unreachable!("neither a number nor a truth value"),
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

/// A number by a polynomial that is increasing from `from` on, and negative there.
struct Critical {
    polynomial: [i64; 4],
    from: Rational,
}

impl Critical {
    /// `32 ω³ + 4 ω - 1`.
    fn four_point() -> Self {
        Critical { polynomial: [-1, 4, 0, 32], from: rational(-1, 1) }
    }

    /// `√3/2`.
    fn turning() -> Self {
        Critical { polynomial: [-3, 0, 4, 0], from: rational(0, 1) }
    }

    /// `1/√3`.
    fn waves() -> Self {
        Critical { polynomial: [-1, 0, 3, 0], from: rational(0, 1) }
    }

    /// `7/8`.
    fn leaning() -> Self {
        Critical { polynomial: [-7, 8, 0, 0], from: rational(0, 1) }
    }

    /// Whether the end is at most (`false`: at least) this number, up to `2^-50`.
    fn bounds(&self, end: &End, below: bool) -> bool {
        let polynomial = Polynomial::new(self.polynomial.map(Integer::from).to_vec());
        let tolerance = rational(1, 1 << 50);
        let [lower, upper] = bracket(end);
        if below {
            let x = lower - tolerance;
            x <= self.from || polynomial.sign_at(&x).is_le()
        } else {
            let x = upper + tolerance;
            x > self.from && polynomial.sign_at(&x).is_ge()
        }
    }
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

/// The number with the opposite sign.
fn opposite(end: &End) -> End {
    let mut end = end.clone();
    match &mut end {
        End::Rational(x) => x.0 = -x.0.clone(),
        End::Algebraic(root) => {
            root.root_of.iter_mut().skip(1).step_by(2).for_each(|c| c.0 = -c.0.clone());
            root.between.reverse();
            root.between.iter_mut().for_each(|x| x.0 = -x.0.clone());
        }
    }
    end
}

fn finite(interval: &Interval) -> Option<[&End; 2]> {
    Some([interval.from.as_ref()?, interval.to.as_ref()?])
}

/// The four-point scheme is C¹ exactly on `(0, critical)`. A rational end is not the critical number
/// itself.
fn holds_for_four_points(conclusion: &Conclusion) -> bool {
    let Conclusion::Continuity { continuity: 1, proved, refuted } = conclusion else {
        return false;
    };
    let critical = Critical::four_point();
    let inside = |interval: &Interval| {
        let Some([from, to]) = finite(interval) else { return false };
        bracket(from)[0] > rational(0, 1) && critical.bounds(to, true)
    };
    let outside = |interval: &Interval| {
        let left = interval.to.as_ref().is_some_and(|to| bracket(to)[1] <= rational(0, 1));
        left || interval.from.as_ref().is_some_and(|from| critical.bounds(from, false))
    };
    proved.iter().all(inside) && refuted.iter().all(outside)
}

fn holds_for_turning(conclusion: &Conclusion) -> bool {
    holds_in_the_middle(conclusion, &Critical::turning())
}

fn holds_for_leaning(conclusion: &Conclusion) -> bool {
    holds_in_the_middle(conclusion, &Critical::leaning())
}

/// The ternary family is continuous exactly on `(-critical, critical)`.
fn holds_in_the_middle(conclusion: &Conclusion, critical: &Critical) -> bool {
    let Conclusion::Continuity { continuity: 0, proved, refuted } = conclusion else {
        return false;
    };
    let inside = |interval: &Interval| {
        let Some([from, to]) = finite(interval) else { return false };
        critical.bounds(&opposite(from), true) && critical.bounds(to, true)
    };
    let outside = |interval: &Interval| {
        let left = interval.to.as_ref().is_some_and(|to| critical.bounds(&opposite(to), false));
        left || interval.from.as_ref().is_some_and(|from| critical.bounds(from, false))
    };
    proved.iter().all(inside) && refuted.iter().all(outside)
}

/// The reciprocal of the joint spectral radius is the critical number, and the regularity
/// `1 - log2(3)/2 = 0.20751874963942190927313…`.
fn holds_for_waves(conclusion: &Conclusion) -> bool {
    let Conclusion::Regularity { from, to, holder: [lower, upper] } = conclusion else {
        return false;
    };
    let digits = |last: i64| {
        let n = Integer::from(2_075_187_496_394_219_092_i64) * 10 + last;
        Rational::new(n, Integer::from(10_000_000_000_i64) * 10_000_000_000_i64)
    };
    let critical = Critical::waves();
    critical.bounds(from, true)
        && critical.bounds(to, false)
        && lower.0 <= digits(8)
        && upper.0 >= digits(7)
}

/// A theorem, where its long lemma is, and whether a conclusion about its family is true.
type Theorem = (Value, &'static str, fn(&Conclusion) -> bool);

fn theorem(which: usize) -> Theorem {
    match which {
        0 => {
            let four_point = serde_json::from_str(FOUR_POINT).unwrap();
            (four_point, "/lemmas/1/", holds_for_four_points)
        }
        1 => (turning_theorem(), "/lemmas/0/", holds_for_turning),
        2 => (leaning_theorem(), "/lemmas/0/", holds_for_leaning),
        3 => (waves(), "/lemmas/0/", holds_for_waves),
        _ => (growing_waves(), "/lemmas/0/", holds_for_waves),
    }
}

fn read(value: &Value) -> Option<Certificate> {
    Certificate::read(value.to_string().as_bytes()).ok()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn one_changed_value(
        which in 0_usize..5,
        place in any::<prop::sample::Index>(),
        how in 0_usize..4,
        by in -300_i64..300,
    ) {
        let (valid, long_lemma, is_true) = theorem(which);
        let mut paths = Vec::new();
        places(&valid, "", &mut paths);
        // As often outside the long lists of the polytope as inside.
        let (long, short): (Vec<_>, Vec<_>) = paths.into_iter().partition(|p| p.starts_with(long_lemma));
        let path = place.get(if by % 2 == 0 { &long } else { &short });
        let mut mutated = valid.clone();
        let value = mutated.pointer_mut(path).unwrap();
        *value = changed(value, how, by);
        let Some(certificate) = read(&mutated).filter(|c| verify(c).is_ok()) else { return Ok(()) };
        // The exponent of the first coefficient moves the scheme, and nothing else.
        let original = read(&valid).unwrap();
        let mut family = certificate.family.clone();
        family.lowest = original.family.lowest;
        prop_assert!(family == original.family, "{path}");
        prop_assert!(is_true(&certificate.conclusion), "{path}");
    }
}

#[test]
fn the_truth_is_told_apart() {
    for which in 0..5 {
        let (valid, _, is_true) = theorem(which);
        let holds = |pointer: &str, value: Value| {
            let mut changed = valid.clone();
            *changed.pointer_mut(&format!("/conclusion/{pointer}")).unwrap() = value;
            is_true(&read(&changed).unwrap().conclusion)
        };
        assert!(is_true(&read(&valid).unwrap().conclusion), "{which}");
        let (right, wrong) = match which {
            0 => (
                vec![("proved/0/from", "1/101"), ("refuted/2/from", "1/5")],
                vec![
                    ("proved/0/from", "-1/100"),
                    ("proved/0/to", "1/5"),
                    ("refuted/2/from", "19/100"),
                    ("refuted/1/to", "1/1000"),
                ],
            ),
            1 => (
                vec![("proved/0/from", "-86/100"), ("refuted/0/to", "-87/100")],
                vec![
                    ("proved/0/from", "-87/100"),
                    ("proved/0/to", "87/100"),
                    ("refuted/0/to", "-86/100"),
                    ("refuted/1/from", "86/100"),
                ],
            ),
            2 => (
                vec![("proved/0/from", "-87/100"), ("refuted/0/to", "-88/100")],
                vec![
                    ("proved/0/from", "-88/100"),
                    ("proved/0/to", "88/100"),
                    ("refuted/0/to", "-87/100"),
                    ("refuted/1/from", "87/100"),
                ],
            ),
            _ => (
                vec![("from", "57/100"), ("to", "58/100"), ("holder/0", "1/5")],
                vec![
                    ("from", "58/100"),
                    ("to", "57/100"),
                    ("to", "-1"),
                    ("holder/0", "21/100"),
                    ("holder/1", "1/5"),
                ],
            ),
        };
        for (pointer, value) in right {
            assert!(holds(pointer, json!(value)), "{which} {pointer} {value}");
        }
        for (pointer, value) in wrong {
            assert!(!holds(pointer, json!(value)), "{which} {pointer} {value}");
        }
    }
}
