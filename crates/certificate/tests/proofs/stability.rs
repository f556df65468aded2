//! The lemma `stable`.

use serde_json::{Value, json};

use crate::support::{
    self, accept, certificate, constant_family, cubic_like, family, nothing, power_of_sum, product,
    refuse, spline, ternary_hat,
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
    // c = (z+2)(z+4)(t + (1-t)z)/15: c(-z) vanishes at 2 and 4, whatever t is.
    let claim = certificate(&corner_cutting_times(&[8, 6, 1], 15), &nothing(0), &stable);
    refuse(&claim, "c(-z) and c(-z²) have a common factor");
    // For arity 3: c = t + (1-t) z³, and c = (2+z³)(t + (1-t) z)/3.
    let only = [["0", "1"], ["0", "1"], ["0", "1"], ["1", "-1"], ["1", "-1"], ["1", "-1"]];
    refuse(&stable_but_at(&of_arity(3, family(&only, 1)), &json!([])), "all submasks but one");
    let common = [
        ["0", "2/3"],
        ["2/3", "0"],
        ["2/3", "0"],
        ["2/3", "-1/3"],
        ["1/3", "0"],
        ["1/3", "0"],
        ["1/3", "-1/3"],
    ];
    let claim = stable_but_at(&of_arity(3, family(&common, 1)), &json!([]));
    refuse(&claim, "two contrasts have a common factor");
}

/// A family or scheme as one of higher arity.
fn of_arity(arity: usize, mut family: Value) -> Value {
    family["arity"] = json!(arity);
    family
}

fn stable_but_at(family: &Value, except: &Value) -> Value {
    certificate(family, &nothing(0), &json!([{"kind": "stable", "except": except}]))
}

/// Splines are stable. With `φ` that of `a`, the mean of `φ` and `φ(· - 1)` belongs to `a(z) (1+z^m)/(1+z)` for odd `m`; the
/// alternating sum of its shifts is zero.
#[test]
fn schemes_of_higher_arity() {
    let reason = "all but one of the points with the same power";
    for arity in 3..=5 {
        let sigma = vec![1; arity];
        let mut power = vec![1];
        for order in 1..=3_usize {
            power = product(&power, &sigma);
            let denominator = (arity as i64).pow(order as u32 - 1);
            let spline = of_arity(arity, constant_family(&power, denominator, order));
            accept(&stable_but_at(&spline, &json!([])));
            let quotient: Vec<i64> = (0..arity).map(|k| if k % 2 == 0 { 1 } else { -1 }).collect();
            if arity % 2 == 1 {
                let mean = product(&power, &quotient);
                let mean = of_arity(arity, constant_family(&mean, denominator, order));
                refuse(&stable_but_at(&mean, &json!([])), reason);
            }
        }
    }
}

/// `c = t - t z² + z³ (1 + z⁴)/2` for arity 4: the first two contrasts are monomials, `t` and `t z²`, and where they vanish the
/// third does at the zeros of `1 + z⁴`. For arity 5 and 6 likewise.
#[test]
fn contrasts_that_are_monomials() {
    for arity in [4, 5, 6] {
        // c is t - t z^(m-2) + z^(m-1) (1 + z^m)/2.
        let mut parts = [vec![0; 2 * arity], vec![0; 2 * arity]];
        (parts[1][0], parts[1][arity - 2]) = (1, -1);
        (parts[0][arity - 1], parts[0][2 * arity - 1]) = (1, 1);
        let sigma = vec![1; arity];
        let [p, q] = parts.map(|part| product(&part, &sigma));
        let text: Vec<[String; 2]> =
            p.iter().zip(&q).map(|(p, q)| [format!("{p}/2"), q.to_string()]).collect();
        let pairs: Vec<_> = text.iter().map(|pair| pair.each_ref().map(String::as_str)).collect();
        let family = of_arity(arity, family(&pairs, 1));
        accept(&stable_but_at(&family, &json!(["0"])));
        refuse(&stable_but_at(&family, &json!([])), "all but one of the points");
    }
}

/// `c = t + (1-2t) z + t z²`: at `t = 1` it vanishes at `-ω` and `-ω²`, `ω³ = 1`; at 1/3 at `ω` and `ω²`.
#[test]
fn rational_exceptions_of_a_ternary_family() {
    let family = ternary_hat();
    accept(&stable_but_at(&family, &json!(["1/3", "1"])));
    accept(&stable_but_at(&family, &json!(["7", "1", "1/3"])));
    for missing in [json!([]), json!(["1/3"]), json!(["1"]), json!(["-1", "1/3"])] {
        refuse(&stable_but_at(&family, &missing), "all but one of the points");
    }
}

/// The polynomial with the zeros `ζω`, `ζω²` and their conjugates, `ω³ = 1`, `ζ = e^(iθ)`, is
/// `1 + u z + (u² - 1) z² + u z³ + z⁴` with `u = 2 cos θ`. For `u = √2 = t` and over its value at 1, `(1 + t)²`, the coefficients
/// are `3 - 2t` and `3t - 4` in turn, and so they are for `t = -√2`. At `t = 4/3` that is `(1+z+z²)(1-z+z²)/3`.
#[test]
fn irrational_exceptions_of_a_ternary_family() {
    let parts = [[3, -4, 3, -4, 3], [-2, 3, -2, 3, -2]].map(|part| product(&part, &[1, 1, 1]));
    let text = |c: &i64| c.to_string();
    let pairs: Vec<_> = parts[0].iter().zip(&parts[1]).map(|(p, q)| [text(p), text(q)]).collect();
    let pairs: Vec<_> = pairs.iter().map(|pair| [pair[0].as_str(), pair[1].as_str()]).collect();
    let family = of_arity(3, family(&pairs, 1));
    let square = json!(["-2", "0", "1"]);
    let [plus, minus] =
        [["1", "2"], ["-2", "-1"]].map(|b| json!({"root_of": square, "between": b}));
    accept(&stable_but_at(&family, &json!([minus, "4/3", plus])));
    for missing in [json!([minus, "4/3"]), json!([minus, plus]), json!(["4/3", plus])] {
        refuse(&stable_but_at(&family, &missing), "all but one of the points");
    }
}
