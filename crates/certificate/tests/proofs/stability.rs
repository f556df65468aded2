//! The lemma `stable`.

use serde_json::{Value, json};

use crate::support::{
    self, accept, certificate, constant_family, cubic_like, family, nothing, power_of_sum, product,
    refuse, spline,
};

#[test]
fn stable_and_unstable_schemes() {
    let stable = |family: &Value, except: Value| {
        certificate(family, &nothing(0), &json!([{"kind": "stable", "except": except}]))
    };
    for order in 1..=8 {
        accept(&stable(&spline(order), json!([])));
    }
    accept(&stable(&constant_family(&[-1, 0, 9, 16, 9, 0, -1], 16, 4), json!([])));
    // (1+z) ((1+z²)/2)³ vanishes at ±i; 1 + z³ at the points opposite to the cube roots of unity.
    let opposite = constant_family(&[1, 1, 3, 3, 3, 3, 1, 1], 8, 1);
    refuse(&stable(&opposite, json!([])), "at a root of unity of even order");
    refuse(&stable(&constant_family(&[1, 0, 0, 1], 1, 1), json!([])), "an orbit of roots of unity");
    // 1 + z⁵ and 1 + z⁷, of which the orbits of squaring are one and (with conjugates) one.
    for n in [5, 7] {
        let mut mask = vec![0; n + 1];
        mask[0] = 1;
        mask[n] = 1;
        refuse(&stable(&constant_family(&mask, 1, 1), json!([])), "an orbit of roots of unity");
    }
    // A common factor of even and odd part that is nowhere zero on the circle: 1 + 3z² + z⁴.
    let common = constant_family(&[1, 1, 3, 3, 1, 1], 5, 1);
    accept(&stable(&common, json!([])));
    // The same with a parameter in the other factor, (1+z)(t + (1-t)z): symmetric zeros never.
    let with_factor = family(
        &[
            ["0", "1/5"],
            ["1/5", "0"],
            ["1/5", "2/5"],
            ["3/5", "0"],
            ["3/5", "-2/5"],
            ["1/5", "0"],
            ["1/5", "-1/5"],
        ],
        1,
    );
    accept(&stable(&with_factor, json!([])));
}

/// The family of corner cutting, `(1+z)(t + (1-t) z)`, times a factor over a number.
fn corner_cutting_times(factor: &[i64], number: i64) -> Value {
    let parts = [&[0, 1, 1][..], &[1, 0, -1]].map(|part| product(part, factor));
    let text = |c: &i64| format!("{c}/{number}");
    let mask: Vec<_> = parts[0].iter().zip(&parts[1]).map(|(p, q)| [text(p), text(q)]).collect();
    let pairs: Vec<_> = mask.iter().map(|pair| [pair[0].as_str(), pair[1].as_str()]).collect();
    family(&pairs, 1)
}

#[test]
fn opposite_zeros_matter_at_roots_of_unity_only() {
    let stable = |family: &Value, except: Value| {
        certificate(family, &nothing(0), &json!([{"kind": "stable", "except": except}]))
    };
    // w² - 6w/5 + 1 vanishes at (3 ± 4i)/5.
    let free = [5, 0, -6, 0, 5];
    for order in 1..=4 {
        let mask = product(&power_of_sum(order), &free);
        accept(&stable(&constant_family(&mask, 4 << (order - 1), order), json!([])));
    }
    accept(&stable(&corner_cutting_times(&free, 4), json!([])));
    // w² + 1 vanishes at ±i, w² + w + 1 at roots of unity of odd order, which make an orbit.
    let even = ([1, 0, 0, 0, 1], 2, "the submasks have a common zero");
    let odd = ([1, 0, 1, 0, 1], 3, "an orbit of roots of unity");
    for (factor, number, reason) in [even, odd] {
        for order in 1..=4 {
            let mask = product(&power_of_sum(order), &factor);
            let family = constant_family(&mask, number << (order - 1), order);
            refuse(&stable(&family, json!([])), reason);
        }
        refuse(&stable(&corner_cutting_times(&factor, number), json!([])), reason);
    }
    // Expansion then refutes: c_0 = 5/4 is an eigenvalue.
    let family = constant_family(&product(&[1, 2, 1], &free), 8, 2);
    let refuted = json!({
        "kind": "continuity", "continuity": 1, "proved": [],
        "refuted": [{"from": null, "to": null, "ends": "()"}],
    });
    let word = json!({"kind": "word", "pencil": "scale", "word": "0", "from": "1", "to": null});
    let lemmas = json!([word, {"kind": "stable", "except": []}]);
    accept(&certificate(&family, &refuted, &lemmas));
    // A zero that moves: (1+z)(t + (1-t) z²).
    let moving = support::family(&[["0", "1"], ["0", "1"], ["1", "-1"], ["1", "-1"]], 1);
    refuse(&stable(&moving, json!([])), "opposite zeros that move with the parameter");
    // Two submasks of which one is constant: 2t (1+w) and 1 - 4t.
    accept(&stable(&cubic_like(), json!(["1/4", "1/2"])));
    refuse(&stable(&cubic_like(), json!(["1/2"])), "at a root of unity of even order");
    refuse(&stable(&cubic_like(), json!(["1/4"])), "an orbit of roots of unity");
}

#[test]
fn what_is_not_decided() {
    let stable = json!([{"kind": "stable", "except": []}]);
    let mut ternary = constant_family(&[1, 2, 3, 2, 1], 3, 2);
    ternary["arity"] = json!(3);
    let claim = certificate(&ternary, &nothing(0), &stable);
    refuse(&claim, "stability is checked for arity two only");
    // c = (z+2)(z+4)(t + (1-t)z)/15: c(-z) vanishes at 2 and 4, whatever t is.
    let claim = certificate(&corner_cutting_times(&[8, 6, 1], 15), &nothing(0), &stable);
    refuse(&claim, "c(-z) and c(-z²) have a common factor");
}
