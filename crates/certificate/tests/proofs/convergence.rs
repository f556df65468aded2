//! The lemma `convergence`, alone and beside `reduced`.

use serde_json::{Value, json};

use crate::support::{
    accept, certificate, check, constant_family, cubic_like, nothing, refuse, regularity, smooth,
    spline,
};

/// `(1+z)((1+z²)/2)³`, which is C² though `(1+z)²` does not divide: `q = (1+z)³` reduces it to the
/// cubic spline.
fn dilated_spline() -> Value {
    constant_family(&[1, 1, 3, 3, 3, 3, 1, 1], 8, 1)
}

fn norm(level: u32) -> Value {
    json!({"kind": "norm", "level": level, "from": "0", "to": "0"})
}

/// For the spline `c_2 = (1+z)/2`, with row sums 1/2.
fn smooth_lemma() -> Value {
    json!({
        "kind": "reduced", "value": "0", "factor": ["1", "3", "3", "1"], "order": 4,
        "lemmas": [norm(1)],
    })
}

/// `c_0 = ((1+z²)/2)³`: a row of ones at level 1, and halves at level 2.
fn convergence_lemma(level: u32) -> Value {
    json!({"kind": "convergence", "lemmas": [norm(level)]})
}

#[test]
fn a_scheme_that_converges_to_smooth_functions() {
    let with = |n: usize, lemmas: Value| {
        certificate(&dilated_spline(), &smooth(n, &[["0", "0"]]), &lemmas)
    };
    let both = json!([smooth_lemma(), convergence_lemma(2)]);
    let valid = with(2, both.clone());
    accept(&valid);
    let counts = check(&valid).unwrap().lemmas;
    assert_eq!((counts["reduced"], counts["convergence"], counts["norm"]), (1, 1, 2));
    accept(&with(2, json!([convergence_lemma(2), smooth_lemma()])));
    accept(&with(1, both.clone()));
    refuse(&with(3, both), "row 0 of the norm is not shown to be less than one");
    refuse(&with(2, json!([smooth_lemma()])), "proved interval 0 is not covered");
    refuse(&with(2, json!([convergence_lemma(2)])), "proved interval 0 is not covered");
    refuse(&with(2, json!([smooth_lemma(), convergence_lemma(1)])), "row 0 of the norm");
    // What is proved of one member says nothing of another.
    let wider = certificate(
        &dilated_spline(),
        &smooth(2, &[["0", "1"]]),
        &json!([smooth_lemma(), convergence_lemma(2)]),
    );
    refuse(&wider, "proved interval 0 is not covered");
}

/// `A_0` of `[t, 1/2, 1-2t, 1/2, t]` has the eigenvalues `1-4t` and `2t`, and over the bound 2 of C⁰ the
/// first is -1 at `t = 3/4`.
#[test]
fn divergence_needs_no_stability() {
    let from = |x: &str| {
        let word =
            json!({"kind": "word", "pencil": "parameter", "word": "0", "from": x, "to": null});
        json!([{"kind": "convergence", "lemmas": [word]}])
    };
    let refuted = |x: &str, n: usize| {
        json!({
            "kind": "continuity", "continuity": n, "proved": [],
            "refuted": [{"from": x, "to": null, "ends": "[)"}],
        })
    };
    for n in 0..4 {
        accept(&certificate(&cubic_like(), &refuted("3/4", n), &from("3/4")));
    }
    let early = certificate(&cubic_like(), &refuted("3/4", 1), &from("74/100"));
    refuse(&early, "the spectral radius of the product is less than one");
    let wide = certificate(&cubic_like(), &refuted("74/100", 1), &from("3/4"));
    refuse(&wide, "refuted interval 0 is not covered");
    // For C¹ the bound is 1, and the same word reaches it at 1/2: but there the shifts are not stable.
    let word =
        json!([{"kind": "word", "pencil": "parameter", "word": "0", "from": "1/2", "to": null}]);
    let stable = certificate(&cubic_like(), &refuted("1/2", 1), &word);
    refuse(&stable, "is not shown to be stable");
}

#[test]
fn convergence_proves_nothing_else() {
    let with = |lemma: Value| {
        certificate(
            &cubic_like(),
            &nothing(1),
            &json!([{"kind": "convergence", "lemmas": [lemma]}]),
        )
    };
    refuse(&with(json!({"kind": "stable", "except": ["1/4", "1/2"]})), "about something else");
    refuse(
        &with(json!({"kind": "indivisible", "order": 3, "except": ["1/8"]})),
        "about something else",
    );
    let scale = json!({"kind": "nonnegative", "end": "1"});
    let constant =
        certificate(&spline(3), &nothing(1), &json!([{"kind": "convergence", "lemmas": [scale]}]));
    assert!(check(&constant).is_err());
    let claim = certificate(&spline(2), &regularity("1", "1", "1"), &json!([convergence_lemma(1)]));
    refuse(&claim, "the conclusion is not about continuity");
}
