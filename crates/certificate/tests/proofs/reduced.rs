//! The lemma `reduced`.

use serde_json::{Value, json};

use crate::support::{accept, certificate, check, cubic_like, nothing, refuse, regularity, spline};

/// `(1+z)(1+z³)/2` times `q(z)/q(z²)`, `q = 1+z+z²`, is `(1+z)²/2`: a hat function.
fn hat_lemma() -> Value {
    let word =
        json!({"kind": "word", "pencil": "parameter", "word": "0", "from": "1/2", "to": "1/2"});
    json!({
        "kind": "reduced", "value": "1/2", "factor": ["1", "1", "1"], "order": 2,
        "lemmas": [word, {"kind": "stable", "except": []}],
    })
}

fn refuted_from_one_half(continuity: usize, to: Value, ends: &str) -> Value {
    json!({
        "kind": "continuity", "continuity": continuity, "proved": [],
        "refuted": [{"from": "1/2", "to": to, "ends": ends}],
    })
}

#[test]
fn an_unstable_member_by_a_reduced_mask() {
    let word =
        json!({"kind": "word", "pencil": "parameter", "word": "0", "from": "1/2", "to": null});
    let stable = json!({"kind": "stable", "except": ["1/4", "1/2"]});
    let refuted = refuted_from_one_half(1, json!(null), "[)");
    let valid = certificate(&cubic_like(), &refuted, &json!([word, stable, hat_lemma()]));
    accept(&valid);
    let counts = check(&valid).unwrap().lemmas;
    assert_eq!((counts["reduced"], counts["word"], counts["stable"]), (1, 2, 2));
    let mut without = valid.clone();
    without["lemmas"] = json!([word, stable]);
    refuse(&without, "refuted interval 0 is not shown to be stable");
    // At the value alone it needs no other lemma; the factor counts up to a number.
    let point = refuted_from_one_half(1, json!("1/2"), "[]");
    let mut alone = certificate(&cubic_like(), &point, &json!([hat_lemma()]));
    accept(&alone);
    alone["lemmas"][0]["factor"] = json!(["-2/3", "-2/3", "-2/3", "0"]);
    accept(&alone);
    alone["conclusion"]["refuted"][0]["to"] = json!("51/100");
    refuse(&alone, "refuted interval 0 is not covered");
    // Not C² as the cube of σ does not divide; of any order that divides.
    for order in 1..=2 {
        let mut lemma = hat_lemma();
        lemma["order"] = json!(order);
        lemma["lemmas"][0] = json!({"kind": "indivisible", "order": 3, "except": []});
        let point = refuted_from_one_half(2, json!("1/2"), "[]");
        accept(&certificate(&cubic_like(), &point, &json!([lemma])));
        let weaker = certificate(&cubic_like(), &nothing(1), &json!([lemma]));
        refuse(&weaker, "show neither contraction, expansion nor indivisibility");
    }
}

#[test]
fn reduced_masks_that_are_none() {
    let with = |pointer: &str, value: Value| {
        let mut lemma = hat_lemma();
        *lemma.pointer_mut(pointer).expect(pointer) = value;
        certificate(&cubic_like(), &nothing(1), &json!([lemma]))
    };
    refuse(&with("/factor", json!(["1", "-1", "1"])), "the factor does not divide");
    refuse(&with("/factor", json!(["1", "0", "0", "0", "0", "0", "1"])), "the factor does not");
    refuse(&with("/factor", json!(["0", "1"])), "the factor vanishes at zero or at one");
    refuse(&with("/factor", json!(["1", "-1"])), "the factor vanishes at zero or at one");
    refuse(&with("/factor", json!([])), "the factor vanishes at zero or at one");
    // Another member, or the symbol as it is: 1 + z³ has an orbit.
    refuse(&with("/value", json!("1/3")), "the factor does not divide");
    refuse(&with("/factor", json!(["1"])), "an orbit of roots of unity");
    refuse(&with("/order", json!(3)), "the order is too large");
    refuse(&with("/order", json!(0)), "the order is less than one");
    refuse(&with("/lemmas/0/from", json!("0")), "an end that is not the value");
    let stable = hat_lemma()["lemmas"][1].clone();
    let word = hat_lemma()["lemmas"][0].clone();
    refuse(
        &with("/lemmas", json!([stable])),
        "show neither contraction, expansion nor indivisibility",
    );
    refuse(&with("/lemmas", json!([word])), "do not show stability");
    refuse(&with("/lemmas/1/except", json!(["1/2"])), "an exception but no parameter");
    // The hat is not C¹.
    let norm = json!({"kind": "norm", "level": 1, "from": "1/2", "to": "1/2"});
    refuse(&with("/lemmas/0", norm), "row 0 of the norm is not shown to be less than one");
    let zero = certificate(&cubic_like(), &nothing(0), &json!([hat_lemma()]));
    refuse(&zero, "a `reduced` lemma about C^0");
    let claim = certificate(&spline(2), &regularity("1", "1", "1"), &json!([hat_lemma()]));
    refuse(&claim, "the conclusion is not about continuity");
}
