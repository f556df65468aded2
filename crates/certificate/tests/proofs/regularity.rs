//! Hölder regularity, with non-negative symbols.

use serde_json::{Value, json};

use crate::support::{
    accept, certificate, check, constant_family, four_point, nonnegative_lemmas, refuse,
    regularity, smooth, spline,
};

#[test]
fn a_spline_has_its_degree_as_regularity() {
    for order in 1..=6 {
        let degree = (order - 1).to_string();
        let good = regularity("1", &degree, &degree);
        accept(&certificate(&spline(order), &good, &nonnegative_lemmas("1")));
        // The same by a polytope: the interval [-1, 1], on which the word 0 stays at its end.
        let polytope = json!({
            "kind": "polytope", "pencil": "scale", "inner": "0", "end": "1", "open": true,
            "complex": false, "mirrored": false, "bits": 0, "vertices": [[1]],
            "leading": [{"word": "0", "sign": 1, "vertex": 0, "pivot": 0}],
            "weight_bits": 0, "units": [[[0, 1]]],
            "inner_images": [[[], []]], "end_images": [[null, []]],
        });
        let mut lemmas = nonnegative_lemmas("1");
        lemmas[0] = polytope;
        accept(&certificate(&spline(order), &good, &lemmas));
        // Without the word the image at the end is on the boundary, and exact.
        lemmas[0]["leading"] = json!([]);
        lemmas[0]["end_images"] = json!([[[[0, 1]], []]]);
        accept(&certificate(&spline(order), &good, &lemmas));
        lemmas[0]["open"] = json!(false);
        refuse(&certificate(&spline(order), &good, &lemmas), "is not shown to be inside");
        let better = regularity("1", &order.to_string(), &order.to_string());
        let claim = certificate(&spline(order), &better, &nonnegative_lemmas("1"));
        refuse(&claim, "the lower bound of the regularity does not follow");
    }
}

#[test]
fn a_lower_order_does_not_give_the_regularity() {
    let mut family = spline(4);
    // c = (1+z)²/4 has the joint spectral radius 1/2, which would give 2 instead of 3.
    family["order"] = json!(2);
    let claim = regularity("2", "2", "2");
    refuse(&certificate(&family, &claim, &nonnegative_lemmas("2")), "divisible more often");
}

#[test]
fn regularities_of_nothing() {
    let claim = certificate(&four_point(), &regularity("1", "0", "1"), &json!([]));
    refuse(&claim, "the regularity of a family with a parameter");
    // At the scale -1 the word 0 expands, too.
    let mut lemmas = nonnegative_lemmas("1");
    lemmas[1]["from"] = json!("-1");
    lemmas[1]["to"] = json!("-1");
    let mut claim = certificate(&spline(1), &regularity("1", "0", "0"), &lemmas);
    refuse(&claim, "expansion at the upper end is not covered");
    claim["conclusion"]["to"] = json!("-1");
    refuse(&claim, "the upper end is not positive");
    claim["conclusion"]["from"] = json!("-1");
    refuse(&claim, "an interval is empty");
    // Without one of the three lemmas.
    for (index, words) in [(0, "contraction"), (1, "expansion"), (2, "stable")] {
        let mut lemmas = nonnegative_lemmas("1");
        lemmas.as_array_mut().unwrap().remove(index);
        refuse(&certificate(&spline(1), &regularity("1", "0", "0"), &lemmas), words);
    }
}

/// `c = (2+z)/3` for arity 3 has the matrices 2/3, 1/3 and 0: `r = log_3 3/2 = 0.36907024642854…`
#[test]
fn logarithms_are_to_the_base_of_the_arity() {
    let mut family = constant_family(&[2, 3, 3, 1], 3, 1);
    family["arity"] = json!(3);
    let polytope = json!({
        "kind": "polytope", "pencil": "scale", "inner": "0", "end": "3/2", "open": true,
        "complex": false, "mirrored": false, "bits": 0, "vertices": [[1]],
        "leading": [{"word": "0", "sign": 1, "vertex": 0, "pivot": 0}],
        "weight_bits": 1, "units": [[[0, 2]]],
        "inner_images": [[[], [], []]], "end_images": [[null, [[0, 1]], []]],
    });
    let word = json!({"kind": "word", "pencil": "scale", "word": "0", "from": "3/2", "to": null});
    let lemmas = json!([polytope, word, {"kind": "stable", "except": []}]);
    let claim = |lower, upper| certificate(&family, &regularity("3/2", lower, upper), &lemmas);
    accept(&claim("369070246/1000000000", "369070247/1000000000"));
    refuse(&claim("369070247/1000000000", "1"), "the lower bound of the regularity");
    refuse(&claim("0", "369070246/1000000000"), "the upper bound of the regularity");
}

#[test]
fn deslauriers_and_dubuc() {
    // Four points: the regularity is exactly 2.
    let four = constant_family(&[-1, 0, 9, 16, 9, 0, -1], 16, 4);
    accept(&certificate(&four, &regularity("1/2", "2", "2"), &nonnegative_lemmas("1/2")));
    let claim = certificate(&four, &regularity("2/3", "2", "3"), &nonnegative_lemmas("2/3"));
    refuse(&claim, "lemma 0 (nonnegative): the determinant has a root between zero and the end");
    // Six points: 3 - log2(9/8) = 6 - 2 log2 3 = 2.8300749985576876371…
    let six = constant_family(&[3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3], 256, 6);
    let digits = |last: i64| format!("{}/100000000000000000", 283_007_499_855_768_763 + last);
    for (lower, upper, holds) in [(0, 1, true), (-5, 5, true), (1, 2, false), (-2, 0, false)] {
        let claim = regularity("2/9", &digits(lower), &digits(upper));
        let claim = certificate(&six, &claim, &nonnegative_lemmas("2/9"));
        assert_eq!(check(&claim).is_ok(), holds, "{lower} {upper}");
    }
}

/// `(1+z)(1 + 2z + 4z² + 2z³ + z⁴)/10`: `ρ = (3+√5)/10`, of which the reciprocal is a root of
/// `x² - 15x + 25`.
#[test]
fn an_irrational_joint_spectral_radius() {
    let family = constant_family(&[1, 3, 6, 6, 3, 1], 10, 1);
    let claim = |between: [&str; 2], last: i64, lemmas_end: Value| {
        let end = json!({"root_of": ["25", "-15", "1"], "between": between});
        let digits = |n: i64| format!("9334442676261277{:04}/100000000000000000000", 4439 + n);
        let bounds = [digits(last), digits(last + 1)];
        let conclusion = json!({"kind": "regularity", "from": end, "to": end, "holder": bounds});
        let mut lemmas = nonnegative_lemmas("1");
        lemmas[0]["end"] = lemmas_end.clone();
        lemmas[1]["from"] = lemmas_end;
        certificate(&family, &conclusion, &lemmas)
    };
    // The same number in two guises.
    let other = json!({"root_of": ["-100", "85", "-19", "1"], "between": ["19/10", "2"]});
    accept(&claim(["1", "2"], 0, other.clone()));
    refuse(&claim(["1", "2"], 1, other.clone()), "the lower bound");
    refuse(&claim(["1", "2"], -1, other.clone()), "the upper bound");
    refuse(&claim(["13", "14"], 0, other), "contraction up to the lower end");
    let half = json!({"root_of": ["25", "-15", "1"], "between": ["13", "14"]});
    refuse(&claim(["1", "2"], 0, half), "lemma 0 (nonnegative)");
}

#[test]
fn a_symbol_that_is_negative_somewhere_is_refused() {
    // c = 2 - 3z + 2z² has c(1) = 1 and the modulus -3 + 4 cos θ.
    let family = constant_family(&[2, -1, -1, 2], 1, 1);
    let lemmas = json!([{"kind": "nonnegative", "end": "1/9"}]);
    let claim = certificate(&family, &smooth(0, &[]), &lemmas);
    refuse(&claim, "the difference symbol is negative somewhere");
    let refuse_for = |family: &Value, words: &str| {
        let lemmas = json!([{"kind": "nonnegative", "end": "1/9"}]);
        refuse(&certificate(family, &smooth(0, &[]), &lemmas), words);
    };
    // 1 + 2 cos 2θ is negative in the middle only.
    refuse_for(&constant_family(&[1; 6], 3, 1), "the difference symbol is negative somewhere");
    // c = 2 - z², c = (1+z)/2, and a ternary scheme with c = 1.
    refuse_for(&constant_family(&[2, 2, -1, -1], 1, 1), "is not symmetric");
    refuse_for(&constant_family(&[1, 2, 1], 2, 1), "is odd");
    let mut ternary = constant_family(&[1, 2, 3, 2, 1], 3, 2);
    ternary["arity"] = json!(3);
    refuse_for(&ternary, "for arity two only");
}
