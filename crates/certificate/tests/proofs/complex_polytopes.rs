//! The lemma `polytope` with complex vertices.

use serde_json::{Value, json};

use crate::support::{
    accept, certificate, nothing, refuse, smooth, spline, turning, turning_ball, turning_theorem,
    waves,
};

const OUTSIDE: &str = "is not shown to be inside";

fn changed(certificate: &Value, pointer: &str, value: Value) -> Value {
    let mut changed = certificate.clone();
    *changed.pointer_mut(pointer).expect(pointer) = value;
    changed
}

#[test]
fn a_ball_of_one_vertex_that_turns() {
    let valid = turning_theorem();
    accept(&valid);
    let closed = changed(&valid, "/conclusion/proved/0/ends", json!("[]"));
    refuse(&closed, "proved interval 0 is not covered");
    accept(&changed(&closed, "/lemmas/0/open", json!(false)));
    let ball = |inner: i64, end: i64, open: bool| {
        certificate(&turning(), &nothing(0), &json!([turning_ball(inner, end, open, 12)]))
    };
    // √3/2 = 221.7…/256.
    for (inner, end) in [(-96, 96), (96, 96), (0, 221), (0, -221)] {
        accept(&ball(inner, end, false));
    }
    for (inner, end) in [(0, 222), (0, -222), (222, 0), (250, 0)] {
        refuse(&ball(inner, end, false), OUTSIDE);
    }
    refuse(&ball(96, 96, true), "an interval is empty");
    let claim = |to: &str| {
        let lemmas = json!([turning_ball(-96, 96, false, 4)]);
        certificate(&turning(), &smooth(0, &[["-3/8", to]]), &lemmas)
    };
    accept(&claim("3/8"));
    refuse(&claim("4/8"), "not covered");
}

/// `128² + 222² = 65668` is a little more than `256²`, and `64² + 111²` than `128²`.
#[test]
fn moduli_are_rounded_upwards() {
    let ball = turning_ball(0, 222, true, 8);
    refuse(&certificate(&turning(), &nothing(0), &json!([ball])), OUTSIDE);
}

/// The moduli of `(24 + 18i)/32` and of `(-9 + 12i)/32` are `30/32` and `15/32`.
#[test]
fn exact_moduli_are_not_rounded() {
    let mut ball = turning_ball(0, 0, false, 5);
    ball["pencil"] = json!("scale");
    ball["inner_images"] = json!([[[], [], []]]);
    ball["end"] = json!("3/2");
    ball["end_images"] =
        json!([[[[0, -9, 12], [1, 9, -12]], [[0, 24, 18]], [[0, 9, -12], [1, 9, -12]],]]);
    let at = |ball: &Value| {
        let at = json!([{"kind": "at", "value": "3/8", "order": 1, "lemmas": [ball]}]);
        certificate(&turning(), &smooth(0, &[["3/8", "3/8"]]), &at)
    };
    accept(&at(&ball));
    // A little less exactly.
    let mut wrong = ball.clone();
    wrong["end_images"][0][1] = json!([[0, 25, 18]]);
    refuse(&at(&wrong), OUTSIDE);
    // The radius is 5/8: up to 8/5, but not further.
    wrong = ball;
    wrong["end"] = json!("8/5");
    wrong["open"] = json!(true);
    refuse(&at(&wrong), OUTSIDE);
}

#[test]
fn a_ball_of_two_vertices_with_mirror_images() {
    let valid = waves();
    accept(&valid);
    let upper = json!("20751874963942190927/100000000000000000000");
    refuse(&changed(&valid, "/conclusion/holder/1", upper), "the upper bound");
    let lower = json!("1/1000000");
    refuse(&changed(&valid, "/conclusion/holder/0", lower), "the lower bound");
    let closed = changed(&valid, "/lemmas/0/open", json!(false));
    refuse(&closed, "the image of vertex 0 under letter 1");
    // A sum of one, but not exactly.
    let near = changed(&valid, "/lemmas/0/end_images/0/1", json!([[1, 255], [0, 1]]));
    refuse(&near, "the image of vertex 0 under letter 1");
    let near = changed(&valid, "/lemmas/0/end_images/0/1", json!([[1, 255], [1, 1]]));
    accept(&near);
    // Exactly, but with a sum of more than one.
    let long = changed(&valid, "/lemmas/0/end_images/0/1", json!([[1, 257], [1, -1]]));
    refuse(&long, "the image of vertex 0 under letter 1");
    // Beyond 1/√3 no ball does.
    let beyond = changed(&valid, "/lemmas/0/end", json!("58/100"));
    refuse(&beyond, OUTSIDE);
    // At the inner end the boundary is not allowed.
    let inner = changed(&valid, "/lemmas/0/inner", json!("1/2"));
    let mut inner = changed(&inner, "/lemmas/0/end", json!("49/100"));
    inner["lemmas"][0]["inner_images"] = inner["lemmas"][0]["end_images"].clone();
    refuse(&inner, "the image of vertex 0 under letter 1");
}

#[test]
fn the_order_of_mirror_images_and_conjugates() {
    let valid = waves();
    // The image of u_0 under A_0/2 is a combination of u_0 and its conjugate u_4.
    for index in [1, 2, 3, 4, 5, 6, 7] {
        let wrong = changed(&valid, "/lemmas/0/end_images/0/0/0/0", json!(index));
        refuse(&wrong, "the image of vertex 0 under letter 0");
    }
    for index in [8, 9, 1_000_000] {
        let wrong = changed(&valid, "/lemmas/0/end_images/0/1/0/0", json!(index));
        refuse(&wrong, "a combination has an index that is no vertex");
    }
    // Without mirror images there are four, and the combinations mean other vertices.
    let wrong = changed(&valid, "/lemmas/0/mirrored", json!(false));
    refuse(&wrong, "a combination has an index that is no vertex");
    // The ternary ball has one vertex and its conjugate.
    let mut ball = turning_ball(0, 96, false, 9);
    ball["units"][0][1][0] = json!(2);
    let claim = certificate(&turning(), &nothing(0), &json!([ball]));
    refuse(&claim, "a combination has an index that is no vertex");
}

#[test]
fn forms_that_are_none() {
    let valid = turning_theorem();
    let ball = |field: &str, value: Value| changed(&valid, &format!("/lemmas/0/{field}"), value);
    for vertex in [json!([1, 0]), json!([1, 0, 0]), json!([1, 0, 0, -1, 0]), json!([])] {
        refuse(&ball("vertices/0", vertex), "a vertex has the wrong length");
    }
    let lead = json!([{"word": "1", "sign": 1, "vertex": 0, "pivot": 0}]);
    refuse(&ball("leading", lead), "a leading word of a complex polytope");
    refuse(&ball("complex", json!(false)), "a vertex has the wrong length");
    let root = json!({"root_of": ["-55", "64"], "between": ["0", "1"]});
    accept(&ball("end", root));
    let root = json!({"root_of": ["-1", "0", "2"], "between": ["0", "1"]});
    let closed = changed(&ball("end", root), "/lemmas/0/open", json!(false));
    refuse(&closed, "an end that belongs to the interval must be rational");
    // The spline of degree 0 has d = 1, and the ball of 1 or of i is the unit disc.
    let disc = |vertex: Value, complex: bool, weight: Value| {
        json!([{
            "kind": "polytope", "pencil": "scale", "inner": "0", "end": "1", "open": true,
            "complex": complex, "mirrored": false, "bits": 0, "vertices": [vertex], "leading": [],
            "weight_bits": 0, "units": [[weight]], "inner_images": [[[], []]],
            "end_images": [[[[0, 1]], []]],
        }])
    };
    let claim = |lemmas: Value| certificate(&spline(1), &nothing(0), &lemmas);
    accept(&claim(disc(json!([1]), false, json!([0, 1]))));
    accept(&claim(disc(json!([1, 0]), true, json!([0, 1]))));
    accept(&claim(disc(json!([0, 1]), true, json!([0, 0, -1]))));
    accept(&claim(disc(json!([0, 1]), true, json!([1, 0, 1]))));
    // The conjugate of -2i, of which the opposite is no number of 64 bits.
    let mut least = disc(json!([0, i64::MIN]), true, json!([1, 0, -1]));
    (least[0]["bits"], least[0]["weight_bits"]) = (json!(62), json!(1));
    least[0]["end_images"] = json!([[[[1, -2]], []]]);
    accept(&claim(least));
    // The image by one half of the vertex, with a residual of one half: no exact one.
    let mut half = disc(json!([1]), false, json!([0, 2]));
    (half[0]["weight_bits"], half[0]["end_images"]) = (json!(1), json!([[[[0, 2]], []]]));
    accept(&claim(half.clone()));
    half[0]["end_images"] = json!([[[[0, 1]], []]]);
    refuse(&claim(half), OUTSIDE);
    let real = claim(disc(json!([1]), false, json!([0, 1, 1])));
    refuse(&real, "a weight of a real polytope is not real");
}

/// A ball up to an irrational end, without a word that leads there: all images are inside.
#[test]
fn an_irrational_end_without_leading_words() {
    // √2/2 = 181.02/256.
    let end = json!({"root_of": ["-1", "0", "2"], "between": ["0", "1"]});
    let theorem = |from: &str| {
        let mut ball = turning_ball(0, 181, true, 12);
        ball["end"] = end.clone();
        let proved = json!({
            "kind": "continuity", "continuity": 0, "refuted": [],
            "proved": [{"from": from, "to": end, "ends": "[)"}],
        });
        certificate(&turning(), &proved, &json!([ball]))
    };
    accept(&theorem("0"));
    refuse(&theorem("-1/1000"), "not covered");
    let closed = changed(&theorem("0"), "/conclusion/proved/0/ends", json!("[]"));
    refuse(&closed, "not covered");
    // √3/2, where the radius is one, with the combinations of 221.7/256 rounded downwards.
    let mut ball = turning_ball(0, 221, true, 12);
    ball["end"] = json!({"root_of": ["-3", "0", "4"], "between": ["0", "1"]});
    refuse(&certificate(&turning(), &nothing(0), &json!([ball])), OUTSIDE);
}
