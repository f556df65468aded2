//! Families, members and curves.

use serde_json::{Value, json};

use crate::support::{
    accept, certificate, constant_family, four_point, nothing, refuse, smooth, ternary_hat,
};

#[test]
fn a_curve_along_the_line() {
    // The four-point scheme with ω = s²/(1+s).
    let mut claim = certificate(&four_point(), &nothing(1), &json!([]));
    claim["family"]["curve"] = json!({
        "parameter": "s",
        "mask": [
            ["0", "0", "-2"], [], ["1", "1", "2"], ["2", "2"], ["1", "1", "2"], ["0"], ["0", "0", "-2"],
        ],
        "denominator": ["2", "2"],
        "line": {"numerator": ["0", "0", "1/3"], "denominator": ["1/3", "1/3"]},
    });
    accept(&claim);
    let mut wrong = claim.clone();
    wrong["family"]["curve"]["mask"][2] = json!(["1", "1", "3"]);
    refuse(&wrong, "curve: the curve does not run along the line");
    let mut wrong = claim.clone();
    wrong["family"]["curve"]["denominator"] = json!([]);
    refuse(&wrong, "curve: a denominator is zero");
    let mut wrong = claim;
    wrong["family"]["curve"]["line"]["denominator"] = json!(["0", "0"]);
    refuse(&wrong, "curve: a denominator is zero");
}

#[test]
fn families_that_are_none() {
    let claim = |family: Value| certificate(&family, &nothing(0), &json!([]));
    refuse(&claim(constant_family(&[1, 1, 1], 1, 1)), "a stencil does not sum to one");
    refuse(&claim(constant_family(&[1, 2, 1], 2, 3)), "the order is too large");
    refuse(&claim(constant_family(&[1, 2, 3, 2], 4, 2)), "not divisible as often");
    refuse(&claim(constant_family(&[1, 2, 1], 2, 0)), "the order is less than one");
    let mut unary = constant_family(&[1, 2, 1], 2, 1);
    unary["arity"] = json!(1);
    refuse(&claim(unary), "the arity is less than two");
    let mut varying = four_point();
    varying["parameter"] = json!(null);
    refuse(&claim(varying), "the mask is not constant");
    let mut curved = four_point();
    curved["mask"][0] = json!(["0", "-1", "1"]);
    refuse(&claim(curved), "not affine");
}

#[test]
fn ternary_schemes() {
    // (1+z+z²)²/3: the hat function. c = 1, and for a parameter: c = t + (1-2t) z + t z².
    let family = ternary_hat();
    // d = 1, ρ = max(|t|, |1-2t|): less than three, so continuous, for -1 < t < 2.
    let norm = json!([{"kind": "norm", "level": 1, "from": "-99/100", "to": "199/100"}]);
    accept(&certificate(&family, &smooth(0, &[["-9/10", "19/10"]]), &norm));
    let word = json!([
        {"kind": "word", "pencil": "parameter", "word": "1", "from": "2", "to": null},
        {"kind": "word", "pencil": "parameter", "word": "1", "from": null, "to": "-1"},
    ]);
    let refuted = json!({
        "kind": "continuity", "continuity": 0, "proved": [],
        "refuted": [{"from": null, "to": "-1", "ends": "(]"}, {"from": "2", "to": null, "ends": "[)"}],
    });
    let mut claim = certificate(&family, &refuted, &word);
    accept(&claim);
    claim["conclusion"]["refuted"][0]["to"] = json!("-99/100");
    refuse(&claim, "refuted interval 0 is not covered");
    claim["conclusion"]["refuted"][0]["to"] = json!("-1");
    claim["conclusion"]["continuity"] = json!(1);
    refuse(&claim, "refuted interval 0 is not shown to be stable");
}

#[test]
fn divisibility_at_single_values() {
    // The four-point scheme: (1+z)⁴ divides at 1/16, (1+z)² always, (1+z)³ at 1/16 only.
    let lemma = |order: usize, except: Value| {
        let lemma = json!({"kind": "indivisible", "order": order, "except": except});
        certificate(&four_point(), &nothing(3), &json!([lemma]))
    };
    accept(&lemma(3, json!(["1/16"])));
    accept(&lemma(4, json!([{"root_of": ["-1", "16"], "between": ["0", "1"]}])));
    accept(&lemma(5, json!([])));
    accept(&lemma(1_000_000_000, json!([])));
    refuse(&lemma(3, json!(["1/15"])), "is missing");
    refuse(&lemma(2, json!([])), "the power of σ divides");
    refuse(&lemma(0, json!([])), "the power of σ divides");
}

#[test]
fn one_member_of_a_family() {
    // At 1/16: (1+z)⁴ divides, C¹ by a norm of order 4 and by a non-negative symbol, and not C²:
    // the regularity is exactly 2 without being reached.
    let norm = json!({"kind": "norm", "level": 2, "from": "1/16", "to": "1/16"});
    let nonnegative = json!({"kind": "nonnegative", "end": "1/2"});
    for lemma in [norm, nonnegative] {
        let at = json!([{"kind": "at", "value": "1/16", "order": 4, "lemmas": [lemma]}]);
        accept(&certificate(&four_point(), &smooth(1, &[["1/16", "1/16"]]), &at));
        let wide = certificate(&four_point(), &smooth(1, &[["1/16", "1/15"]]), &at);
        refuse(&wide, "not covered");
        refuse(&certificate(&four_point(), &smooth(4, &[["1/16", "1/16"]]), &at), "the order");
    }
    let word = json!({"kind": "word", "pencil": "scale", "word": "0", "from": "1/2", "to": null});
    let stable = json!({"kind": "stable", "except": []});
    let indivisible = json!({"kind": "indivisible", "order": 3, "except": ["1/16"]});
    let outer = json!({"kind": "stable", "except": ["-1/2", "1/16"]});
    let at = json!({"kind": "at", "value": "1/16", "order": 4, "lemmas": [word, stable]});
    let refuted = json!({
        "kind": "continuity", "continuity": 2, "proved": [],
        "refuted": [{"from": "0", "to": null, "ends": "()"}],
    });
    let mut all = certificate(&four_point(), &refuted, &json!([at, indivisible, outer]));
    accept(&all);
    all["lemmas"][0]["lemmas"] = json!([all["lemmas"][0]["lemmas"][0]]);
    refuse(&all, "refuted interval 0 is not shown to be stable");
    all["lemmas"] = json!([indivisible, outer]);
    refuse(&all, "refuted interval 0 is not covered");
    // An exception at the value itself takes everything.
    let without = |except: Value| {
        let indivisible = json!({"kind": "indivisible", "order": 5, "except": except});
        let stable = json!({"kind": "stable", "except": []});
        let at =
            json!([{"kind": "at", "value": "1/16", "order": 4, "lemmas": [indivisible, stable]}]);
        let refuted = json!({
            "kind": "continuity", "continuity": 4, "proved": [],
            "refuted": [{"from": "1/16", "to": "1/16", "ends": "[]"}],
        });
        certificate(&four_point(), &refuted, &at)
    };
    accept(&without(json!([])));
    accept(&without(json!(["1/15"])));
    refuse(&without(json!(["2/32"])), "refuted interval 0 is not covered");
    let wrong = json!([{"kind": "at", "value": "1/15", "order": 4, "lemmas": []}]);
    refuse(&certificate(&four_point(), &nothing(1), &wrong), "not divisible as often");
    let other = json!({"kind": "norm", "level": 2, "from": "1/15", "to": "1/15"});
    let wrong = json!([{"kind": "at", "value": "1/16", "order": 4, "lemmas": [other]}]);
    let claim = certificate(&four_point(), &nothing(1), &wrong);
    refuse(&claim, "lemma 0 (at), inside it lemma 0 (norm): an end that is not the value");
    let word = |from: Value| json!({"kind": "word", "pencil": "parameter", "word": "0", "from": from, "to": "1/16"});
    for (from, words) in [(json!(null), "an infinite end"), (json!("0"), "not the value")] {
        let wrong = json!([{"kind": "at", "value": "1/16", "order": 2, "lemmas": [word(from)]}]);
        refuse(&certificate(&four_point(), &nothing(1), &wrong), words);
    }
}
