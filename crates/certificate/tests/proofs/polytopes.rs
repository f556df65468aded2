//! The lemma `polytope` with real vertices.

use serde_json::{Value, json};

use crate::support::{
    FOUR_POINT, accept, certificate, check, constant_family, family, leaning,
    leaning_up_to_the_end, nonnegative_lemmas, nothing, refuse, regularity, spline,
};

#[test]
fn the_four_point_scheme_is_classified() {
    let valid: Value = serde_json::from_str(FOUR_POINT).unwrap();
    accept(&valid);
    let mut closed = valid.clone();
    closed["conclusion"]["proved"][0]["ends"] = json!("[]");
    refuse(&closed, "proved interval 0 is not covered");
    let mut unstable = valid.clone();
    unstable["conclusion"]["refuted"][0]["ends"] = json!("(]");
    refuse(&unstable, "refuted interval 0 is not shown to be stable");
    let mut listed = valid.clone();
    listed["lemmas"][5]["except"] = json!([]);
    refuse(&listed, "an orbit of roots of unity consists of zeros of the symbol");
    // The same number in another guise.
    listed["lemmas"][5]["except"] =
        json!([{"root_of": ["-1", "0", "4"], "between": ["-2", "0"]}, "7"]);
    accept(&listed);
    let mut strict = valid.clone();
    strict["lemmas"][3]["from"] = json!("19/100");
    refuse(&strict, "lemma 3 (word)");
    let mut met = valid.clone();
    met["lemmas"][1]["leading"] = json!([]);
    refuse(&met, "a combination is null where none is met");
    met["lemmas"][1]["open"] = json!(false);
    refuse(&met, "an end that belongs to the interval must be rational");
    let mut near = valid.clone();
    near["lemmas"][1]["end"]["root_of"] = json!(["-1000000000", "4000000000", "0", "32000000001"]);
    refuse(&near, "a leading word does not have its eigenvalue at the end");
    for field in ["inner_images", "end_images"] {
        let mut short = valid.clone();
        short["lemmas"][1][field].as_array_mut().unwrap().pop();
        refuse(&short, "the wrong number of images");
        let mut short = valid.clone();
        short["lemmas"][1][field][3].as_array_mut().unwrap().pop();
        refuse(&short, "a vertex does not have an image for each letter");
    }
    let mut shifted = valid;
    shifted["lemmas"][1]["leading"][0]["vertex"] = json!(1);
    assert!(check(&shifted).is_err());
}

/// The family of `(1+z)(t + (1-t) z)`, of which the joint spectral radius is the larger of `|t|` and
/// `|1-t|`: continuous exactly for `0 < t < 1`.
fn corner_cutting() -> (Value, Value) {
    let family = family(&[["0", "1"], ["1", "0"], ["1", "-1"]], 1);
    let polytope = |end: &str, word: &str, images: Value| {
        json!({
            "kind": "polytope", "pencil": "parameter", "inner": "1/2", "end": end,
            "open": true, "complex": false, "mirrored": true, "bits": 0, "vertices": [[1]],
            "leading": [{"word": word, "sign": 1, "vertex": 0, "pivot": 0}],
            "weight_bits": 1, "units": [[[0, 2]]],
            "inner_images": [[[[0, 1]], [[1, 1]]]], "end_images": images,
        })
    };
    let word = |word: &str, from: Option<&str>, to: Option<&str>| json!({"kind": "word", "pencil": "parameter", "word": word, "from": from, "to": to});
    let mut lemmas = [
        polytope("1", "0", json!([[null, []]])),
        polytope("0", "1", json!([[[], null]])),
        word("0", Some("1"), None),
        word("1", None, Some("0")),
    ];
    // The symbol is symmetric at one half only.
    lemmas.iter_mut().take(2).for_each(|p| {
        p["mirrored"] = json!(false);
        p["inner_images"] = json!([[[[0, 1]], [[0, 1]]]]);
    });
    (family, json!(lemmas))
}

#[test]
fn an_end_on_either_side() {
    let (family, lemmas) = corner_cutting();
    let conclusion = json!({
        "kind": "continuity", "continuity": 0,
        "proved": [{"from": "0", "to": "1", "ends": "()"}],
        "refuted": [{"from": null, "to": "0", "ends": "(]"}, {"from": "1", "to": null, "ends": "[)"}],
    });
    let valid = certificate(&family, &conclusion, &lemmas);
    accept(&valid);
    for (interval, ends) in [(0, "[)"), (0, "(]")] {
        let mut wrong = valid.clone();
        wrong["conclusion"]["proved"][interval]["ends"] = json!(ends);
        refuse(&wrong, "proved interval 0 is not covered");
    }
    let mut wrong = valid.clone();
    wrong["lemmas"][0]["mirrored"] = json!(true);
    refuse(&wrong, "lemma 0 (polytope): the difference symbol is not symmetric");
    let mut wrong = valid.clone();
    wrong["lemmas"][0]["end_images"] = json!([[null, null]]);
    refuse(&wrong, "a combination is null where none is met");
    let mut wrong = valid.clone();
    wrong["lemmas"][0]["leading"][0]["sign"] = json!(-1);
    refuse(&wrong, "a leading word does not have its eigenvalue at the end");
    let mut wrong = valid.clone();
    wrong["lemmas"][0]["vertices"] = json!([[0]]);
    refuse(&wrong, "the pivot of a leading word");
    let mut wrong = valid.clone();
    wrong["lemmas"][0]["inner"] = json!("1");
    assert!(check(&wrong).is_err());
    // Inside, up to an end that is included: nothing is met.
    let mut closed = valid.clone();
    closed["conclusion"]["proved"][0] = json!({"from": "1/2", "to": "3/4", "ends": "[]"});
    closed["lemmas"][0]["end"] = json!("3/4");
    closed["lemmas"][0]["open"] = json!(false);
    refuse(&closed, "a leading word at an end that belongs to the interval");
    closed["lemmas"][0]["leading"] = json!([]);
    closed["lemmas"][0]["weight_bits"] = json!(2);
    closed["lemmas"][0]["units"] = json!([[[0, 4]]]);
    closed["lemmas"][0]["inner_images"] = json!([[[[0, 2]], [[0, 2]]]]);
    closed["lemmas"][0]["end_images"] = json!([[[[0, 3]], [[0, 1]]]]);
    accept(&closed);
    // An open end there is as good, as far as it goes.
    closed["lemmas"][0]["open"] = json!(true);
    refuse(&closed, "proved interval 0 is not covered");
    closed["conclusion"]["proved"][0]["ends"] = json!("[)");
    accept(&closed);
    closed["conclusion"]["proved"][0]["to"] = json!("4/5");
    refuse(&closed, "proved interval 0 is not covered");
}

/// The four-point scheme of Dubuc and Deslauriers, `c(z) = (-1 + 4z - z²)/2`: at the scale `1/2` the
/// matrices are
///
/// ```text
/// [[1, 0], [-1/4, -1/4]] and [[-1/4, -1/4], [0, 1]].
/// ```
///
/// The first one fixes `(5, -1)`, and maps `(-1, 5)` to `(-1, -1)`, a quarter of the two with the
/// opposite sign.
#[test]
fn exact_images_at_an_open_end() {
    let family = constant_family(&[-1, 0, 9, 16, 9, 0, -1], 16, 4);
    let polytope = json!({
        "kind": "polytope", "pencil": "scale", "inner": "0", "end": "1/2", "open": true,
        "complex": false, "mirrored": true, "bits": 0, "vertices": [[5, -1]], "leading": [],
        "weight_bits": 2, "units": [[[0, 1]], [[1, 1]]],
        "inner_images": [[[], []]], "end_images": [[[[0, 4]], [[0, -1], [1, -1]]]],
    });
    let mut lemmas = nonnegative_lemmas("1/2");
    lemmas[0] = polytope;
    let valid = certificate(&family, &regularity("1/2", "2", "2"), &lemmas);
    accept(&valid);
    let refuse_with = |field: &str, value: Value, words: &str| {
        let mut wrong = valid.clone();
        *wrong.pointer_mut(&format!("/lemmas/0/{field}")).expect(field) = value;
        refuse(&wrong, words);
    };
    let outside = "the image of vertex 0 under letter 0 is not shown to be inside";
    refuse_with("open", json!(false), outside);
    // On the boundary, but not the image: the residual counts.
    let mut near = valid.clone();
    near["lemmas"][0]["bits"] = json!(20);
    near["lemmas"][0]["vertices"] = json!([[5 << 20, -1 << 20]]);
    accept(&near);
    near["lemmas"][0]["vertices"] = json!([[5 << 20, (-1 << 20) + 1]]);
    refuse(&near, outside);
    refuse_with("end_images/0/0", json!([[0, 3], [1, 1]]), outside);
    refuse_with("end", json!("1/3"), outside);
    // The image, but by weights with a sum of more than one.
    refuse_with("end_images/0/0", json!([[0, 5], [0, -1]]), outside);
    refuse_with("end_images/0/0/0", json!([0, 4, 1]), "a weight of a real polytope is not real");
    refuse_with("units/0/0", json!([0, 1, -1]), "a weight of a real polytope is not real");
    refuse_with("units/1/0", json!([2, 1]), "an index that is no vertex");
    // The matrices 1 and 0 of c = 1 are not mirror images, though every symbol is one here.
    let mut hat = certificate(&spline(2), &nothing(0), &json!([valid["lemmas"][0].clone()]));
    let polytope = &mut hat["lemmas"][0];
    (polytope["vertices"], polytope["units"]) = (json!([[1]]), json!([[[0, 4]]]));
    polytope["end_images"] = json!([[[[0, 2]], []]]);
    refuse(&hat, "the difference symbol is not symmetric about the middle of the matrices");
    hat["lemmas"][0]["mirrored"] = json!(false);
    accept(&hat);
    // Towards zero the boundary is at the inner end.
    let mut reversed = valid.clone();
    let polytope = &mut reversed["lemmas"][0];
    (polytope["inner"], polytope["end"]) = (json!("1/2"), json!("0"));
    let images = polytope["inner_images"].take();
    polytope["inner_images"] = polytope["end_images"].take();
    polytope["end_images"] = images;
    refuse(&reversed, outside);
}

/// The body of [`leaning_up_to_the_end`] at rest, for `[1/2, 7/8)`. The first vertex is given as
/// `(x, 256)/256`, at a distance of `x/256` from the true one.
#[test]
fn a_leading_vertex_is_known_up_to_an_error() {
    let body = |x: i64| {
        let mut body = leaning_up_to_the_end();
        body.as_object_mut().unwrap().remove("motion");
        body["inner"] = json!("1/2");
        (body["bits"], body["vertices"]) = (json!(8), json!([[x, 256], [-640, 640]]));
        body["units"] = json!([[[0, 64], [1, -26]], [[0, 64]]]);
        body["inner_images"] = json!([
            [[[0, 40]], [[0, 32], [1, -16]], [[0, -8], [1, 3]]],
            [[[0, -40]], [[1, 16]], [[0, 40], [1, -16]]],
        ]);
        certificate(&leaning(), &nothing(0), &json!([body]))
    };
    for x in [0, 1, -1] {
        accept(&body(x));
    }
    for x in [3, -3] {
        refuse(&body(x), "the image of vertex 0 under letter 1 is not shown to be inside");
    }
}
