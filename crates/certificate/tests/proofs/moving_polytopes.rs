//! The lemma `polytope` with vertices that move.

use serde_json::{Value, json};

use crate::support::{
    FOUR_POINT, accept, certificate, family, growing, growing_waves, leaning, leaning_theorem,
    leaning_up_to_the_end, nothing, reflected, refuse, smooth, turning,
};

const OUTSIDE: &str = "is not shown to be inside";
const INTERIOR: &str = "the units do not show that the polytope has an interior";

fn changed(value: &Value, pointer: &str, new: Value) -> Value {
    let mut changed = value.clone();
    *changed.pointer_mut(pointer).expect(pointer) = new;
    changed
}

fn outside(vertex: usize, letter: usize) -> String {
    format!("the image of vertex {vertex} under letter {letter} {OUTSIDE}")
}

/// The body of `u_0 = (0, 1)` and `u_1 = (-2, 2)` at `t = 5/8`, of `u'_0 = (1, 0)` and
/// `u'_1 = (-2, 2)` at `t = -5/8`, where the matrices are
///
/// ```text
/// [[0, 0], [1, 3/4]],        [[1, 3/4], [-1/2, -1/4]], [[-1/2, -1/4], [0, 0]] and
/// [[0, 0], [-1/4, -1/2]],    [[-1/4, -1/2], [3/4, 1]], [[3/4, 1], [0, 0]].
/// ```
///
/// The images of the vertices, as all numbers below exact and in eighths:
///
/// | | `5/8` | | `-5/8` | |
/// |---|---|---|---|---|
/// | `A_0 u_0` | `(0, 6)` | `6 u_0` | `(0, -2)` | `-2 u'_0 - u'_1` |
/// | `A_1 u_0` | `(6, -2)` | `4 u_0 - 3 u_1` | `(-2, 6)` | `4 u'_0 + 3 u'_1` |
/// | `A_2 u_0` | `(-2, 0)` | `-2 u_0 + u_1` | `(6, 0)` | `6 u'_0` |
/// | `A_0 u_1` | `(0, -4)` | `-4 u_0` | `(0, -4)` | `-4 u'_0 - 2 u'_1` |
/// | `A_1 u_1` | `(-4, 4)` | `2 u_1` | `(-4, 4)` | `2 u'_1` |
/// | `A_2 u_1` | `(4, 0)` | `4 u_0 - 2 u_1` | `(4, 0)` | `4 u'_0` |
///
/// Of `A_0(5/8) u'_0 + A_0(-5/8) u_0 = (0, 8 - 4)` the combinations `6 u'_0` and
/// `-2 u_0 - u_1 = (2, -4)` leave `(-8, 8)`, which is `4 u_1` and `4 u'_1`, the rest `ν`: together
/// `6 + 3 + 4 = 13` eighths, less than two. For `A_2 u_0` it is `(8, -8)`, and nothing for the
/// others.
///
/// The units are `(4 u_0 ∓ 2 u_1)/8`, `(1/2, 0)` or `(-1/2, 1)` at the one end and `(1, -1/2)` or
/// `(0, 1/2)` at the other: `δ = 1/2`, `Γ = 3/4`, `κ = 3/2`.
fn body() -> Value {
    json!({
        "kind": "polytope", "pencil": "parameter", "inner": "-5/8", "end": "5/8", "open": false,
        "complex": false, "mirrored": false, "bits": 0, "vertices": [[0, 1], [-2, 2]],
        "motion": {
            "vertices": [[1, 0], [-2, 2]],
            "rests": [[[[1, 4]], [], [[1, -4]]], [[], [], []]],
        },
        "leading": [], "weight_bits": 3,
        "units": [[[0, 4], [1, -2]], [[0, 4], [1, 2]]],
        "inner_images": [
            [[[0, -2], [1, -1]], [[0, 4], [1, 3]], [[0, 6]]],
            [[[0, -4], [1, -2]], [[1, 2]], [[0, 4]]],
        ],
        "end_images": [
            [[[0, 6]], [[0, 4], [1, -3]], [[0, -2], [1, 1]]],
            [[[0, -4]], [[1, 2]], [[0, 4], [1, -2]]],
        ],
    })
}

/// That continuity holds between the ends of the body, which belong to the interval.
fn claim(body: &Value) -> Value {
    certificate(&leaning(), &smooth(0, &[["-5/8", "5/8"]]), &json!([body]))
}

fn refuse_with(pointer: &str, value: Value, words: &str) {
    refuse(&claim(&changed(&body(), pointer, value)), words);
}

/// No body at rest would do: `A_0(5/8) A_2(-5/8) = [[0, 0], [3/4, 1]]` has the eigenvalue one.
#[test]
fn a_body_that_leans_over() {
    accept(&claim(&body()));
    accept(&claim(&reflected(&body())));
    let open = changed(&body(), "/open", json!(true));
    refuse(&claim(&open), "proved interval 0 is not covered");
    let mut still = body();
    still.as_object_mut().unwrap().remove("motion");
    refuse(&claim(&still), OUTSIDE);
    still["inner"] = json!("5/8");
    still["inner_images"] = still["end_images"].clone();
    accept(&certificate(&leaning(), &smooth(0, &[["5/8", "5/8"]]), &json!([still])));
    // The ends the wrong way round, for the matrices or for the vertices.
    let mut turned = body();
    (turned["inner"], turned["end"]) = (json!("5/8"), json!("-5/8"));
    refuse(&claim(&turned), OUTSIDE);
    let images = turned["inner_images"].take();
    turned["inner_images"] = turned["end_images"].take();
    turned["end_images"] = images;
    refuse(&claim(&turned), OUTSIDE);
    let vertices = turned["vertices"].take();
    turned["vertices"] = turned["motion"]["vertices"].take();
    turned["motion"]["vertices"] = vertices;
    accept(&claim(&turned));
}

#[test]
fn rests_that_are_not_what_is_left() {
    refuse_with("/motion/rests/0/0", json!([]), &outside(0, 0));
    refuse_with("/motion/rests/0/2", json!([]), &outside(0, 2));
    refuse_with("/motion/rests/0/0", json!([[1, -4]]), &outside(0, 0));
    refuse_with("/motion/rests/0/0", json!([[0, 4]]), &outside(0, 0));
    refuse_with("/motion/rests/1/1", json!([[0, 8]]), &outside(1, 1));
    refuse_with("/motion/rests/0/0", json!([[2, 4]]), "an index that is no vertex");
    refuse_with("/motion/rests/0/0", json!([[1, 4, 1]]), "a weight of a real polytope is not real");
    refuse_with("/motion/rests/0/0", json!(null), "a rest is null");
    // 2 u_1 and 3 u_1 leave (-4, 4) and (-2, 2): 9 + 2 + 12 and 9 + 3 + 6 eighths.
    refuse_with("/motion/rests/0/0", json!([[1, 2]]), &outside(0, 0));
    refuse_with("/motion/rests/0/0", json!([[1, 3]]), &outside(0, 0));
    // Of different vertices at the ends: 4 u_0 leaves (0, -4) or (-4, 0) of nothing at A_1 u_1,
    // 4 + 4 + 6 eighths, and 5 u_0 so 4 + 5 + 7.5, more than two.
    accept(&claim(&changed(&body(), "/motion/rests/1/1", json!([[0, 4]]))));
    refuse_with("/motion/rests/1/1", json!([[0, 5]]), &outside(1, 1));
}

/// `2 u_1` by weights of which the sum is one: on the way there is more room, `8 + 2` eighths.
#[test]
fn the_ends_are_checked_as_well() {
    let long = json!([[1, 2], [0, 3], [0, -3]]);
    refuse_with("/end_images/1/1", long.clone(), &outside(1, 1));
    refuse_with("/inner_images/1/1", long, &outside(1, 1));
    let less = json!([[1, 2], [0, 3], [0, -2]]);
    let shorter = json!([[1, 2], [0, 2], [0, -2]]);
    for list in ["/end_images/1/1", "/inner_images/1/1"] {
        refuse_with(list, less.clone(), &outside(1, 1));
        accept(&claim(&changed(&body(), list, shorter.clone())));
    }
}

#[test]
fn the_sum_of_all_weights_is_less_than_two() {
    let rest = |weights: Value| changed(&body(), "/motion/rests/0/0", weights);
    // 13 eighths, and 2 or 4.
    accept(&claim(&rest(json!([[1, 4], [0, 1], [0, -1]]))));
    refuse(&claim(&rest(json!([[1, 4], [0, 2], [0, -2]]))), &outside(0, 0));
    // Two exactly.
    refuse(&claim(&rest(json!([[1, 4], [0, 2], [0, -1], [0, -1]]))), &outside(0, 0));
    let mut fine = finer(&body());
    fine["motion"]["rests"][0][0] = json!([[1, 8], [0, 3], [0, -3]]);
    refuse(&claim(&fine), &outside(0, 0));
    fine["motion"]["rests"][0][0] = json!([[1, 8], [0, 3], [0, -2], [0, 1], [0, -1], [0, -1]]);
    refuse(&claim(&fine), &outside(0, 0));
    fine["motion"]["rests"][0][0] = json!([[1, 8], [0, 2], [0, -1], [0, -1]]);
    accept(&claim(&fine));
    // The weights of the images at either end count here, too: less than one, together 4/8 more.
    let weights = json!([[0, 6], [1, 0], [0, 0]]);
    accept(&claim(&changed(&body(), "/end_images/0/0", weights)));
    for (list, image) in [
        ("end_images", json!([[0, 12], [1, 1], [1, -1]])),
        ("inner_images", json!([[0, -4], [1, -2], [0, 1], [0, -1]])),
    ] {
        let mut fine = finer(&body());
        fine[list][0][0] = image;
        accept(&claim(&fine));
        fine["motion"]["rests"][0][0] = json!([[1, 8], [0, 2], [0, -2]]);
        refuse(&claim(&fine), &outside(0, 0));
    }
}

/// The same body with weights in 16ths.
fn finer(body: &Value) -> Value {
    fn double(value: &mut Value) {
        match value.as_array_mut() {
            Some(term) if term.first().is_some_and(Value::is_number) => {
                term[1] = json!(2 * term[1].as_i64().unwrap());
            }
            Some(items) => items.iter_mut().for_each(double),
            None => {}
        }
    }
    let mut fine = body.clone();
    fine["weight_bits"] = json!(4);
    for list in ["/units", "/inner_images", "/end_images", "/motion/rests"] {
        double(fine.pointer_mut(list).unwrap());
    }
    fine
}

/// The units as 16ths `8 u_0 - 5 u_1` are `(5/8, -1/8)` at the one end and `(9/8, -5/8)` at the
/// other: `δ = 1/2` or `3/4`, so `κ = 13/8` or `13/4`. With seven 16ths of `u_1` as the rest, what is
/// left of it is `(1, -1)/8`: `18 + 7 = 25` 16ths and a quarter of `κ`, less than two only for the
/// smaller one.
#[test]
fn the_gauge_is_that_of_both_ends() {
    let mut fine = finer(&body());
    fine["motion"]["rests"][0][0] = json!([[1, 7]]);
    accept(&claim(&fine));
    accept(&claim(&reflected(&fine)));
    fine["units"][0] = json!([[0, 8], [1, -5]]);
    refuse(&claim(&fine), &outside(0, 0));
    fine["motion"]["rests"][0][0] = json!([[1, 8]]);
    accept(&claim(&fine));
    // The other way round: (1/2 - 1/8, 1/8) and so on.
    fine["motion"]["rests"][0][0] = json!([[1, 7]]);
    fine["units"][0] = json!([[0, 8], [1, -3]]);
    refuse(&claim(&fine), &outside(0, 0));
    fine["motion"]["rests"][0][0] = json!([[1, 8]]);
    accept(&claim(&fine));
}

#[test]
fn vertices_that_are_no_body() {
    refuse_with("/motion/vertices", json!([[0, 0], [0, 0]]), INTERIOR);
    refuse_with("/motion/vertices", json!([[2, -2], [-2, 2]]), INTERIOR);
    // A body, but with the vertices on the other sides: smaller on the way.
    refuse_with("/motion/vertices", json!([[-1, 0], [2, -2]]), INTERIOR);
    refuse_with("/motion/vertices", json!([[-2, 2], [1, 0]]), INTERIOR);
    refuse_with("/vertices", json!([[0, 0], [0, 0]]), INTERIOR);
    refuse_with("/motion/vertices", json!([[1, 0], [-2, 3]]), OUTSIDE);
}

#[test]
fn lists_of_wrong_lengths() {
    let vertex = "a vertex has the wrong length";
    for wrong in [json!([]), json!([1]), json!([1, 0, 0]), json!([1, 0, 0, 0])] {
        refuse_with("/motion/vertices/0", wrong.clone(), vertex);
        refuse_with("/motion/vertices/1", wrong, vertex);
    }
    let count = "the wrong number of vertices at the inner end";
    refuse_with("/motion/vertices", json!([]), count);
    refuse_with("/motion/vertices", json!([[1, 0]]), count);
    refuse_with("/motion/vertices", json!([[1, 0], [-2, 2], [0, 1]]), count);
    let images = "the wrong number of images";
    refuse_with("/motion/rests", json!([]), images);
    refuse_with("/motion/rests", json!([[[[1, 4]], [], [[1, -4]]]]), images);
    let each = "a vertex does not have an image for each letter";
    refuse_with("/motion/rests/0", json!([[[1, 4]], []]), each);
    refuse_with("/motion/rests/1", json!([[], [], [], []]), each);
}

/// At both ends, `c = (0, 7, 4, 3, -6)/8` and in the opposite order, all images are inside. In the middle
/// `A_1 = [[5, -3], [-3, 5]]/8` has the eigenvalue one.
#[test]
fn two_ends_without_a_way() {
    let mask = [["-3/8", "3/8"], ["2/8", "5/8"], ["6/8", "5/8"], ["14/8", "0"]];
    let mut mask = mask.to_vec();
    mask.extend([["6/8", "-5/8"], ["2/8", "-5/8"], ["-3/8", "-3/8"]]);
    let mut family = family(&mask, 1);
    family["arity"] = json!(3);
    let mut body = json!({
        "kind": "polytope", "pencil": "parameter", "inner": "-1", "end": "1", "open": false,
        "complex": false, "mirrored": false, "bits": 0, "vertices": [[-2, -2], [0, 1]],
        "leading": [], "weight_bits": 4, "units": [[[0, -4], [1, -8]], [[0, -4], [1, 8]]],
        "inner_images": [
            [[[0, 2], [1, 12]], [[0, 6], [1, -8]], [[0, 8], [1, -4]]],
            [[[0, 7], [1, -6]], [[1, 14]], []],
        ],
        "end_images": [
            [[[0, 8], [1, 4]], [[0, 6], [1, 8]], [[0, 2], [1, -12]]],
            [[], [[1, 14]], [[0, -7], [1, -6]]],
        ],
    });
    let at = |t: i64, vertices: Value, list: &str| {
        let mut still = body.clone();
        still["vertices"] = vertices;
        (still["inner"], still["end"]) = (json!(t.to_string()), json!(t.to_string()));
        let images = body[list].clone();
        (still["inner_images"], still["end_images"]) = (images.clone(), images);
        still["units"][0] = json!([[0, -8], [1, -16]]);
        still["units"][1] = if t > 0 { json!([[1, 16]]) } else { json!([[0, -8], [1, 16]]) };
        if t < 0 {
            still["units"][0] = json!([[1, -16]]);
        }
        let t = t.to_string();
        certificate(&family, &smooth(0, &[[&t, &t]]), &json!([still]))
    };
    let moved = json!([[-2, -2], [-1, 0]]);
    accept(&at(1, body["vertices"].clone(), "end_images"));
    accept(&at(-1, moved.clone(), "inner_images"));
    for i in -16..=16 {
        // (1, -1)/2 and (-1, 1)/2 of the image of the second vertex, the rest a multiple of it.
        let rests = json!([[[], [], []], [[], [[1, i]], []]]);
        body["motion"] = json!({"vertices": moved, "rests": rests});
        refuse(&certificate(&family, &nothing(0), &json!([body])), OUTSIDE);
    }
}

#[test]
fn a_moving_body_up_to_the_end() {
    let valid = leaning_theorem();
    accept(&valid);
    for ends in ["[)", "(]"] {
        let wrong = changed(&valid, "/conclusion/proved/0/ends", json!(ends));
        refuse(&wrong, "proved interval 0 is not covered");
    }
    let body = leaning_up_to_the_end();
    let refuse_with = |pointer: &str, value: Value, words: &str| {
        let wrong = changed(&body, pointer, value);
        refuse(&certificate(&leaning(), &nothing(0), &json!([wrong])), words);
    };
    refuse_with("/leading/0/sign", json!(-1), "does not have its eigenvalue at the end");
    refuse_with("/end", json!("6/8"), "does not have its eigenvalue at the end");
    refuse_with("/end_images/0/0", json!([[0, 64]]), "is not null where a vertex is met");
    refuse_with("/end_images/0/1", json!(null), "a combination is null where none is met");
    // The weight of the vertex that is met is one: 64 + 22 + 32 + 13/8 · 10 = 122.6 and more.
    refuse_with("/motion/rests/0/0", json!([]), &outside(0, 0));
    refuse_with("/motion/rests/0/0", json!([[1, 32], [0, 7], [0, -7]]), &outside(0, 0));
    let mut still = body.clone();
    still.as_object_mut().unwrap().remove("motion");
    refuse(&certificate(&leaning(), &nothing(0), &json!([still])), OUTSIDE);
}

/// `c = (-t, (1+t)/3, (1+t)/3, (1+t)/3)` for arity four: numbers in place of matrices, and the word
/// `0` has the eigenvalue `-1` at `t = 1`.
#[test]
fn a_vertex_that_meets_its_opposite() {
    let mask = [["0", "-1"], ["1/3", "-2/3"], ["2/3", "-1/3"], ["1", "0"], ["1", "1"]];
    let mut mask = mask.to_vec();
    mask.extend([["2/3", "2/3"], ["1/3", "1/3"]]);
    let mut family = family(&mask, 1);
    family["arity"] = json!(4);
    let body = json!({
        "kind": "polytope", "pencil": "parameter", "inner": "1/2", "end": "1", "open": true,
        "complex": false, "mirrored": false, "bits": 0, "vertices": [[4]],
        "motion": {"vertices": [[5]], "rests": [[[], [], [], []]]},
        "leading": [{"word": "0", "sign": -1, "vertex": 0, "pivot": 0}],
        "weight_bits": 8, "units": [[[0, 57]]],
        "inner_images": [[[[0, -128]], [[0, 128]], [[0, 128]], [[0, 128]]]],
        "end_images": [[null, [[0, 171]], [[0, 171]], [[0, 171]]]],
    });
    let claim = |body: &Value| certificate(&family, &nothing(0), &json!([body]));
    accept(&claim(&body));
    let wrong = changed(&body, "/leading/0/sign", json!(1));
    refuse(&claim(&wrong), "does not have its eigenvalue at the end");
    refuse(&claim(&changed(&body, "/inner_images/0/0", json!([[0, 128]]))), &outside(0, 0));
}

/// The theorem about the four-point scheme, of which the bodies grow: leading words at an end that is
/// not rational.
#[test]
fn leading_words_of_a_body_that_grows() {
    let mut valid: Value = serde_json::from_str(FOUR_POINT).unwrap();
    valid["lemmas"][1] = growing(&valid["lemmas"][1]);
    accept(&valid);
    let body = "/lemmas/1";
    for vertex in [0, 1, 4] {
        for coordinate in 0..4 {
            let pointer = format!("{body}/motion/vertices/{vertex}/{coordinate}");
            let wrong = changed(&valid, &pointer, json!(0));
            let x = valid.pointer(&pointer).unwrap().as_i64().unwrap();
            if x.abs() > 1 << 20 {
                refuse(&wrong, OUTSIDE);
            }
        }
    }
}

/// Complex, mirrored and moving: the indices of the images mean other vertices.
#[test]
fn mirror_images_and_conjugates_move_along() {
    let valid = growing_waves();
    accept(&valid);
    let images = |pointer: &str| format!("/lemmas/0/{pointer}");
    // The vertices in the opposite order, and conjugate.
    let reversed = json!([[0, 30, 0, 30, -20, 0, 40, 0], [15, 15, 15, -30, -10, -10, 20, 20]]);
    refuse(&changed(&valid, &images("motion/vertices"), reversed), INTERIOR);
    let conjugate = json!([[30, 0, 30, 0, 0, -40, 0, 20], [-30, 15, 15, 15, -20, -20, 10, 10]]);
    refuse(&changed(&valid, &images("motion/vertices"), conjugate), INTERIOR);
    let short = json!([[30, 0, 30, 0], [-30, 15, 15, 15]]);
    refuse(&changed(&valid, &images("motion/vertices"), short), "a vertex has the wrong length");
    // The way is checked with the same rules: an index that is a conjugate, or none.
    for index in [0, 1, 2, 3, 4, 5, 6, 7] {
        accept(&changed(&valid, &images("motion/rests/0/0"), json!([[index, 1]])));
    }
    let wrong = changed(&valid, &images("motion/rests/0/0"), json!([[8, 1]]));
    refuse(&wrong, "an index that is no vertex");
    let mut real = valid.clone();
    real["lemmas"][0]["complex"] = json!(false);
    refuse(&real, "a vertex has the wrong length");
    let mut half = valid;
    half["lemmas"][0]["mirrored"] = json!(false);
    refuse(&half, "an index that is no vertex");
}

/// The ball of `u = 5 (1, -i)` for [`turning`] at `t = 3/8`, and of `u' = φ u` with
/// `φ = (4 + 3i)/5` at `t = -3/8`. With `e_1 = (u + ū)/10`, `e_2 = i (u - ū)/10` the images in 16ths
/// are
///
/// | | `3/8` | `-3/8` |
/// |---|---|---|
/// | `A_0 u = 5 (1/2 + it) e_2` | `(-3 + 4i) (u - ū)` | `(3 + 4i) u' + (3 - 4i) ū'` |
/// | `A_1 u` | `(8 + 6i) u` | `(8 - 6i) u'` |
/// | `A_2 u = 5 (t - i/2) e_1` | `(3 - 4i) (u + ū)` | `(-3 - 4i) u' + (3 - 4i) ū'` |
///
/// since `φ ū = φ² ū'` and `φ² (3 + 4i) = -3 + 4i`. Of the first and the last one `ū (-3 + 9i)/40` is
/// left, nearly `(-4 + 6i)/32` of the conjugate vertex: of which `ū (8 + 6i)/160` or `-ū 14/160` is
/// left. The moduli are `5/16`, twice at each end, and `8/32` (upwards).
///
/// The units `((3 - i) u + (3 + i) ū)/32` and `((1 + 3i) u + (1 - 3i) ū)/32` are
/// `(30, ∓10)/32` and `(±10, 30)/32`: `δ = 12/32`, and `Γ = 8/32` as moduli are rounded upwards. So `κ = 2/5`,
/// and `20/16 + 8/32 + 2/5 · 70/80 = 1.85`.
#[test]
fn a_ball_of_which_the_vertex_turns() {
    let ball = json!({
        "kind": "polytope", "pencil": "parameter", "inner": "-3/8", "end": "3/8", "open": false,
        "complex": true, "mirrored": false, "bits": 0, "vertices": [[5, 0, 0, -5]],
        "motion": {
            "vertices": [[4, 3, 3, -4]], "rests": [[[[1, -4, 6]], [], [[1, -4, 6]]]],
        },
        "leading": [], "weight_bits": 5,
        "units": [[[0, 3, -1], [1, 3, 1]], [[0, 1, 3], [1, 1, -3]]],
        "inner_images": [
            [[[0, 6, 8], [1, 6, -8]], [[0, 16, -12]], [[0, -6, -8], [1, 6, -8]]],
        ],
        "end_images": [
            [[[0, -6, 8], [1, 6, -8]], [[0, 16, 12]], [[0, 6, -8], [1, 6, -8]]],
        ],
    });
    let claim =
        |ball: &Value| certificate(&turning(), &smooth(0, &[["-3/8", "3/8"]]), &json!([ball]));
    accept(&claim(&ball));
    let refuse_with = |pointer: &str, value: Value, words: &str| {
        refuse(&claim(&changed(&ball, pointer, value)), words);
    };
    refuse_with("/motion/rests/0/0", json!([]), &outside(0, 0));
    refuse_with("/motion/rests/0/0", json!([[0, -4, 6]]), &outside(0, 0));
    refuse_with("/motion/rests/0/0", json!([[1, -4, -6]]), &outside(0, 0));
    refuse_with("/motion/rests/0/2", json!([[1, -4, 0]]), &outside(0, 2));
    refuse_with("/motion/rests/0/2", json!([[1, 0, 6]]), &outside(0, 2));
    refuse_with("/motion/rests/0/1", json!([[1, 24]]), &outside(0, 1));
    refuse_with("/motion/rests/0/0", json!([[2, -4, 6]]), "an index that is no vertex");
    refuse_with("/motion/vertices/0", json!([4, -3, -3, -4]), INTERIOR);
    refuse_with("/motion/vertices/0", json!([4, 3]), "a vertex has the wrong length");
    refuse_with("/inner_images/0/0", json!([[0, 6, 8], [0, 6, -8]]), &outside(0, 0));
    refuse_with("/inner_images/0/1", json!([[0, 16, 12]]), &outside(0, 1));
}
