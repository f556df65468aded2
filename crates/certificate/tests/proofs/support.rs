//! Certificates made by hand.

use refinable_certificate::{Certificate, Invalid, Verified, verify};
use serde_json::{Value, json};

/// The four-point scheme with its parameter: C¹ exactly for `0 < ω < 0.19273…`, the root of
/// `32 ω³ + 4 ω - 1` (Hechler, Mößner and Reif 2009).
pub const FOUR_POINT: &str = include_str!("../data/four_point.json");

/// A certificate from its parts.
pub fn certificate(family: &Value, conclusion: &Value, lemmas: &Value) -> Value {
    json!({
        "format": "refinable-certificate", "version": 1,
        "family": family, "conclusion": conclusion, "lemmas": lemmas,
    })
}

/// Reads and verifies.
pub fn check(value: &Value) -> Result<Verified, Invalid> {
    let read = Certificate::read(value.to_string().as_bytes()).expect("readable");
    let again = Certificate::read(read.to_json().as_bytes()).expect("what is written is readable");
    assert_eq!(read, again);
    verify(&read)
}

/// Asserts that it is valid.
pub fn accept(value: &Value) {
    if let Err(invalid) = check(value) {
        panic!("{invalid}");
    }
}

/// Asserts that it is invalid, and that the message has these words.
pub fn refuse(value: &Value, words: &str) {
    let invalid = check(value).expect_err(words).to_string();
    assert!(invalid.contains(words), "{invalid}");
}

/// A binary family without a parameter: integer coefficients over a common denominator.
pub fn constant_family(mask: &[i64], denominator: i64, order: usize) -> Value {
    let mask: Vec<_> = mask.iter().map(|c| json!([format!("{c}/{denominator}")])).collect();
    json!({
        "name": "test", "arity": 2, "parameter": null, "order": order, "lowest": 0, "mask": mask,
    })
}

/// A binary family in `t`: coefficients as pairs of constant and slope.
pub fn family(mask: &[[&str; 2]], order: usize) -> Value {
    json!({
        "name": "test", "arity": 2, "parameter": "t", "order": order, "lowest": 0, "mask": mask,
    })
}

/// The four-point scheme.
pub fn four_point() -> Value {
    let mask = [["0", "-1"], ["0", "0"], ["1/2", "1"], ["1", "0"], ["1/2", "1"], ["0", "0"]];
    let mut mask = mask.to_vec();
    mask.push(["0", "-1"]);
    family(&mask, 2)
}

/// C^n on closed intervals of rational ends.
pub fn smooth(continuity: usize, proved: &[[&str; 2]]) -> Value {
    let interval = |[from, to]: &[&str; 2]| json!({"from": from, "to": to, "ends": "[]"});
    let proved: Vec<_> = proved.iter().map(interval).collect();
    json!({"kind": "continuity", "continuity": continuity, "proved": proved, "refuted": []})
}

/// A conclusion that claims nothing, for lemmas alone.
pub fn nothing(continuity: usize) -> Value {
    smooth(continuity, &[])
}

/// `(1+z)^k / 2^(k-1)`.
pub fn spline(order: usize) -> Value {
    constant_family(&power_of_sum(order), 1 << (order - 1), order)
}

/// The Hölder regularity where the joint spectral radius is known exactly.
pub fn regularity(end: &str, lower: &str, upper: &str) -> Value {
    json!({"kind": "regularity", "from": end, "to": end, "holder": [lower, upper]})
}

/// Contraction by a non-negative symbol, expansion by the word `0`.
pub fn nonnegative_lemmas(end: &str) -> Value {
    json!([
        {"kind": "nonnegative", "end": end},
        {"kind": "word", "pencil": "scale", "word": "0", "from": end, "to": null},
        {"kind": "stable", "except": []},
    ])
}

/// The product of two polynomials.
pub fn product(a: &[i64], b: &[i64]) -> Vec<i64> {
    let mut product = vec![0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        b.iter().enumerate().for_each(|(j, y)| product[i + j] += x * y);
    }
    product
}

/// `(1+z)^order`.
pub fn power_of_sum(order: usize) -> Vec<i64> {
    (0..order).fold(vec![1], |p, _| product(&p, &[1, 1]))
}

/// `(1+z+z²)²/3 · c` for arity 3 with `c = t + (1-2t) z + t z²`: the hat function times three coefficients.
pub fn ternary_hat() -> Value {
    let mut family = family(
        &[
            ["0", "1/3"],
            ["1/3", "0"],
            ["2/3", "0"],
            ["1", "-2/3"],
            ["2/3", "0"],
            ["1/3", "0"],
            ["0", "1/3"],
        ],
        2,
    );
    family["arity"] = json!(3);
    family
}

/// The mask `[t, 1/2, 1-2t, 1/2, t]`: the cubic spline at 1/8, `(1+z)(1+z³)/2` at 1/2.
pub fn cubic_like() -> Value {
    family(&[["0", "1"], ["1/2", "0"], ["1", "-2"], ["1/2", "0"], ["0", "1"]], 2)
}

/// The ternary family with `c(z) = -t + z/2 + z³/2 + t z⁴`: `A_1` is the multiplication by
/// `1/2 + it` in the plane, and the other two matrices are
///
/// ```text
/// A_0 = [[0, 0], [1/2, -t]],  A_2 = [[t, 1/2], [0, 0]].
/// ```
///
/// The complex ball of the vertex `(1, -i)` is mapped by each to one of radius `|1/2 + it|`, which
/// is so the joint spectral radius: continuous exactly for `|t| < √3/2`.
pub fn turning() -> Value {
    let mask = [["0", "-1"], ["1/2", "-1"], ["1/2", "-1"], ["1", "0"], ["1/2", "1"], ["1/2", "1"]];
    let mut mask = mask.to_vec();
    mask.push(["0", "1"]);
    let mut family = family(&mask, 1);
    family["arity"] = json!(3);
    family
}

/// The ball of `(1, -i)` for the parameters between two 256ths, with weights over `2^bits`.
pub fn turning_ball(inner: i64, end: i64, open: bool, bits: u32) -> Value {
    // (1, 0) = (u + ū)/2, (0, 1) = i (u - ū)/2.
    let (half, quarter) = (1_i64 << (bits - 1), 1_i64 << (bits - 2));
    let images = |t: i64| {
        let t = (t << bits) / 256;
        let first = json!([[0, -t / 2, quarter], [1, t / 2, -quarter]]);
        let last = json!([[0, t / 2, -quarter], [1, t / 2, -quarter]]);
        json!([[first, [[0, half, t]], last]])
    };
    json!({
        "kind": "polytope", "pencil": "parameter",
        "inner": format!("{inner}/256"), "end": format!("{end}/256"), "open": open,
        "complex": true, "mirrored": false, "bits": 0, "vertices": [[1, 0, 0, -1]],
        "leading": [], "weight_bits": bits,
        "units": [[[0, half], [1, half]], [[0, 0, half], [1, 0, -half]]],
        "inner_images": images(inner), "end_images": images(end),
    })
}

/// Continuity of the ternary family on `[-220/256, 220/256)`, and failure outside of `√3/2`.
pub fn turning_theorem() -> Value {
    let root = |between: [&str; 2]| json!({"root_of": ["-3", "0", "4"], "between": between});
    let (left, right) = (root(["-1", "0"]), root(["0", "1"]));
    let word = |from: &Value, to: &Value| json!({"kind": "word", "pencil": "parameter", "word": "1", "from": from, "to": to});
    let infinite = json!(null);
    let conclusion = json!({
        "kind": "continuity", "continuity": 0,
        "proved": [{"from": "-55/64", "to": "55/64", "ends": "[)"}],
        "refuted": [
            {"from": null, "to": left, "ends": "(]"},
            {"from": right, "to": null, "ends": "[)"},
        ],
    });
    let lemmas =
        json!(
            [turning_ball(-220, 220, true, 12), word(&infinite, &left), word(&right, &infinite),]
        );
    certificate(&turning(), &conclusion, &lemmas)
}

/// The regularity of the scheme with `c(z) = -1 + z + z² + z³ - z⁴`: the eigenvalues of the word
/// `0` are `±1` and `1 ± i√2`, of modulus `√3`, so at most `1 - log2(3)/2 = 0.2075187…`. The ball of
/// two vertices, their mirror images and conjugates shows that it is positive: `u_1` is the image of
/// `u_0` under `A_1/2`.
pub fn waves() -> Value {
    let family = constant_family(&product(&[1, 2, 1], &[-1, 1, 1, 1, -1]), 2, 2);
    let to = json!({"root_of": ["-1", "0", "3"], "between": ["0", "1"]});
    let conclusion = json!({
        "kind": "regularity", "from": "1/2", "to": to,
        "holder": ["0", "20751874963942190928/100000000000000000000"],
    });
    let ball = json!({
        "kind": "polytope", "pencil": "scale", "inner": "0", "end": "1/2", "open": true,
        "complex": true, "mirrored": true, "bits": 0,
        "vertices": [[6, 0, 6, 0, 0, 8, 0, -4], [-6, 3, 3, 3, 4, 4, -2, -2]],
        "leading": [], "weight_bits": 8,
        "units": [
            [[0, 10, 2], [1, -6, -5], [2, 3, 4], [4, 10, -2], [5, -6, 5], [6, 3, -4]],
            [[0, 0, -11], [2, 7], [4, 0, 11], [6, 7]],
            [[0, 7], [2, 0, -11], [4, 7], [6, 0, 11]],
            [[0, 3, 4], [2, 10, 2], [3, -6, -5], [4, 3, -4], [6, 10, -2], [7, -6, 5]],
        ],
        "inner_images": [[[], []], [[], []]],
        "end_images": [
            [[[0, 128, 181], [4, 0, -11]], [[1, 256]]],
            [
                [[1, 41, -12], [2, -19, -29], [4, 2, 88], [6, 0, 22], [7, 30, 40]],
                [[0, 64], [2, 32, 27], [6, 96, -69]],
            ],
        ],
    });
    let word = json!({"kind": "word", "pencil": "scale", "word": "0", "from": to, "to": null});
    let lemmas = json!([ball, word, {"kind": "stable", "except": []}]);
    certificate(&family, &conclusion, &lemmas)
}

/// The ternary family with `c(z) = (1/8 + t) + (3/8 - t) z + (3/8 + t) z³ + (1/8 - t) z⁴`:
///
/// ```text
/// A_0 = [[0,       0      ], [3/8 + t, 1/8 + t]],
/// A_1 = [[3/8 + t, 1/8 + t], [1/8 - t, 3/8 - t]],
/// A_2 = [[1/8 - t, 3/8 - t], [0,       0      ]].
/// ```
///
/// The eigenvalue `1/8 ± t` of `A_0` and `A_2` is at least one for `|t| ≥ 7/8`. As `t` changes its
/// sign, both coordinates are exchanged, and `A_0` with `A_2`.
pub fn leaning() -> Value {
    let mask = [["1/8", "1"], ["1/2", "0"], ["1/2", "0"], ["3/4", "0"], ["1/2", "0"], ["1/2", "0"]];
    let mut mask = mask.to_vec();
    mask.push(["1/8", "-1"]);
    let mut family = family(&mask, 1);
    family["arity"] = json!(3);
    family
}

/// A body for `[-5/8, 7/8)` of which the first vertex moves from `(0, 1)` to `(1, 0)`, the second
/// one stays at `(-5/2, 5/2)`. At `7/8` the matrices are
///
/// ```text
/// [[0, 0], [5/4, 1]], [[5/4, 1], [-3/4, -1/2]] and [[-3/4, -1/2], [0, 0]],
/// ```
///
/// and the first one fixes the first vertex. Weights are 64ths.
pub fn leaning_up_to_the_end() -> Value {
    json!({
        "kind": "polytope", "pencil": "parameter", "inner": "-5/8", "end": "7/8", "open": true,
        "complex": false, "mirrored": false, "bits": 1, "vertices": [[0, 2], [-5, 5]],
        "motion": {
            "vertices": [[2, 0], [-5, 5]],
            "rests": [[[[1, 32]], [], [[1, -32]]], [[], [], []]],
        },
        "leading": [{"word": "0", "sign": 1, "vertex": 0, "pivot": 1}], "weight_bits": 6,
        "units": [[[0, 32], [1, -13]], [[0, 32], [1, 13]]],
        "inner_images": [
            [[[0, -16], [1, -6]], [[0, 32], [1, 19]], [[0, 48]]],
            [[[0, -40], [1, -16]], [[1, 16]], [[0, 40]]],
        ],
        "end_images": [
            [null, [[0, 32], [1, -26]], [[0, -32], [1, 13]]],
            [[[0, -40]], [[1, 16]], [[0, 40], [1, -16]]],
        ],
    })
}

/// The polytope for the family with the opposite parameter: both coordinates and all letters in the
/// opposite order.
pub fn reflected(polytope: &Value) -> Value {
    let mut reflected = polytope.clone();
    for end in ["inner", "end"] {
        let text = polytope[end].as_str().unwrap();
        let opposite = text.strip_prefix('-').map_or_else(|| format!("-{text}"), str::to_owned);
        reflected[end] = json!(opposite);
    }
    let reverse = |list: &mut Value| list.as_array_mut().unwrap().reverse();
    reverse(&mut reflected["units"]);
    for leading in reflected["leading"].as_array_mut().unwrap() {
        leading["word"] = json!(leading["word"].as_str().unwrap().replace('0', "2"));
        leading["pivot"] = json!(1 - leading["pivot"].as_u64().unwrap());
    }
    for lists in ["/vertices", "/motion/vertices", "/motion/rests", "/inner_images", "/end_images"]
    {
        let lists = reflected.pointer_mut(lists).and_then(Value::as_array_mut);
        lists.into_iter().flatten().for_each(reverse);
    }
    reflected
}

/// Continuity exactly for `|t| < 7/8`.
pub fn leaning_theorem() -> Value {
    let conclusion = json!({
        "kind": "continuity", "continuity": 0,
        "proved": [{"from": "-7/8", "to": "7/8", "ends": "()"}],
        "refuted": [
            {"from": null, "to": "-7/8", "ends": "(]"},
            {"from": "7/8", "to": null, "ends": "[)"},
        ],
    });
    let word = |word: &str, from: Option<&str>, to: Option<&str>| json!({"kind": "word", "pencil": "parameter", "word": word, "from": from, "to": to});
    let body = leaning_up_to_the_end();
    let lemmas = json!([
        body,
        reflected(&body),
        word("2", None, Some("-7/8")),
        word("0", Some("7/8"), None)
    ]);
    certificate(&leaning(), &conclusion, &lemmas)
}

/// A body that grows towards `x_0`, by the factor `1 + 1/4`: its images are the same combinations at
/// both ends, and nothing is left of them.
pub fn growing(polytope: &Value) -> Value {
    let scaled = |factor: i64| {
        let mut vertices = polytope["vertices"].clone();
        for vertex in vertices.as_array_mut().unwrap() {
            for x in vertex.as_array_mut().unwrap() {
                *x = json!(x.as_i64().unwrap() * factor);
            }
        }
        vertices
    };
    let mut growing = polytope.clone();
    growing["bits"] = json!(polytope["bits"].as_u64().unwrap() + 2);
    growing["vertices"] = scaled(4);
    let mut rests = polytope["inner_images"].clone();
    let letters = rests.as_array_mut().unwrap().iter_mut();
    letters.flat_map(|of| of.as_array_mut().unwrap()).for_each(|rest| *rest = json!([]));
    growing["motion"] = json!({"vertices": scaled(5), "rests": rests});
    growing
}

/// [`waves`] by a body that grows.
pub fn growing_waves() -> Value {
    let mut waves = waves();
    waves["lemmas"][0] = growing(&waves["lemmas"][0]);
    waves
}
