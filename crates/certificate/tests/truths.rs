//! Statements of which the truth is known by hand.

mod common;

use common::{accept, certificate, constant_family, family, four_point, nothing, refuse, smooth};
use serde_json::{Value, json};

/// `(1+z)^k / 2^(k-1)`.
fn spline(order: usize) -> Value {
    constant_family(&power_of_sum(order), 1 << (order - 1), order)
}

fn regularity(end: &str, lower: &str, upper: &str) -> Value {
    json!({"kind": "regularity", "from": end, "to": end, "holder": [lower, upper]})
}

/// Contraction by a non-negative symbol, expansion by the word `0`.
fn nonnegative_lemmas(end: &str) -> Value {
    json!([
        {"kind": "nonnegative", "end": end},
        {"kind": "word", "pencil": "scale", "word": "0", "from": end, "to": null},
        {"kind": "stable", "except": []},
    ])
}

#[test]
fn a_spline_has_its_degree_as_regularity() {
    for order in 1..=6 {
        let degree = (order - 1).to_string();
        let good = regularity("1", &degree, &degree);
        accept(&certificate(&spline(order), &good, &nonnegative_lemmas("1")));
        // The same by a polytope: the interval [-1, 1], on which the word 0 stays at its end.
        let polytope = json!({
            "kind": "polytope", "pencil": "scale", "inner": "0", "end": "1", "mirrored": false,
            "bits": 0, "vertices": [[1]],
            "leading": [{"word": "0", "sign": 1, "vertex": 0, "pivot": 0}],
            "weight_bits": 0, "units": [[[0, 1]]],
            "inner_images": [[[], []]], "end_images": [[null, []]],
        });
        let mut lemmas = nonnegative_lemmas("1");
        lemmas[0] = polytope;
        accept(&certificate(&spline(order), &good, &lemmas));
        lemmas[0]["leading"] = json!([]);
        lemmas[0]["end_images"] = json!([[[[0, 1]], []]]);
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
        assert_eq!(common::check(&claim).is_ok(), holds, "{lower} {upper}");
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
}

#[test]
fn norms_of_the_four_point_scheme() {
    // The classical range of level two is 0 < ω < (√5 - 1)/8 = 0.1545….
    let norm = |from: &str, to: &str| json!([{"kind": "norm", "level": 2, "from": from, "to": to}]);
    for (from, to) in [("1/100", "1/8"), ("1/1000000", "77/500"), ("1/16", "1/16")] {
        accept(&certificate(&four_point(), &smooth(1, &[[from, to]]), &norm(from, to)));
    }
    for (from, to) in [("0", "1/8"), ("1/100", "31/200"), ("1/8", "1/100"), ("1/5", "1/5")] {
        let claim = certificate(&four_point(), &nothing(1), &norm(from, to));
        assert!(common::check(&claim).is_err(), "{from} {to}");
    }
    let claim = certificate(&four_point(), &smooth(1, &[["1/101", "1/8"]]), &norm("1/100", "1/8"));
    refuse(&claim, "proved interval 0 is not covered");
    // Two lemmas that meet, and two that leave a number out.
    let two = |to: &str, from: &str| {
        let lemmas = [norm("1/100", to)[0].clone(), norm(from, "1/8")[0].clone()];
        certificate(&four_point(), &smooth(1, &[["1/50", "1/9"]]), &json!(lemmas))
    };
    accept(&two("1/20", "1/20"));
    refuse(&two("1/20", "51/1000"), "not covered");
}

#[test]
fn the_four_point_scheme_is_classified() {
    let valid: Value = serde_json::from_str(common::FOUR_POINT).unwrap();
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
    refuse(&met, "without leading words the end must be rational");
    let mut shifted = valid;
    shifted["lemmas"][1]["leading"][0]["vertex"] = json!(1);
    assert!(common::check(&shifted).is_err());
}

#[test]
fn words_by_real_and_by_complex_eigenvalues() {
    // For the word 0 and C¹ the eigenvalues are 4ω, -2ω and the zeros of λ² - λ + 4ω.
    let word = |n: usize, from: Value, to: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "parameter", "word": "0", "from": from, "to": to});
        certificate(&four_point(), &nothing(n), &json!([lemma]))
    };
    accept(&word(1, json!(null), json!("0")));
    accept(&word(1, json!("1/4"), json!(null)));
    refuse(&word(1, json!(null), json!("1/1000")), "less than one somewhere");
    refuse(&word(1, json!("1/5"), json!("1/5")), "less than one somewhere");
    refuse(&word(1, json!("249/1000"), json!(null)), "less than one somewhere");
    refuse(&word(1, json!(null), json!(null)), "less than one somewhere");
    refuse(&word(1, json!("1"), json!("0")), "an interval is empty");
    let root = json!({"root_of": ["-1", "0", "16"], "between": ["0", "1"]});
    accept(&word(1, root.clone(), root));
    // c = 2 - 3z + 2z²: the eigenvalues of A_0 A_1, [[-9+4, -4], [6, 4]]…, or of A_0, -3 and 2.
    let family = family(&[["2", "-1"], ["-1", "1"], ["-1", "1"], ["2", "-1"]], 1);
    let lemma = |word: &str, from: &str, to: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "parameter", "word": word, "from": from, "to": to});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    accept(&lemma("0", "-5", json!("1")));
    // At t = 2: c = z, A_0 = [[1, 0], [0, 0]].
    accept(&lemma("0", "2", json!("2")));
    refuse(&lemma("0", "5/4", json!("7/4")), "less than one somewhere");
}

#[test]
fn complex_eigenvalues_are_counted() {
    // c = 1 + s z - s z² …: A_0 = [[c_1, c_{-1}], [c_3, c_1]]…; of order four the word 01 turns.
    // c = t - t z + z²: A_0 = [[-t, 0], [1, t]], A_1 = [[1, t], [0, -t]], and
    // A_1 A_0 = [[0, t²], [-t, -t²]] with the characteristic polynomial λ² + t² λ + t³.
    let family = family(&[["0", "1"], ["0", "0"], ["1", "-1"], ["1", "0"]], 1);
    let word = |from: &str, to: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "parameter", "word": "01", "from": from, "to": to});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    // For 1 < t < 4 the eigenvalues are complex, of modulus t^(3/2).
    accept(&word("1", json!("3")));
    accept(&word("2", json!("2")));
    accept(&word("1", json!(null)));
    refuse(&word("999/1000", json!("3")), "less than one somewhere");
    refuse(&word("1/2", json!("1/2")), "less than one somewhere");
    let root = |between: [&str; 2]| json!({"root_of": ["-2", "0", "1"], "between": between});
    let at_root = |end: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "parameter", "word": "01", "from": end, "to": end});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    accept(&at_root(root(["1", "2"])));
    // √2/2
    let half = json!({"root_of": ["-1", "0", "2"], "between": ["0", "1"]});
    refuse(&at_root(half), "less than one somewhere");
}

/// The family of `(1+z)(t + (1-t) z)`, of which the joint spectral radius is the larger of `|t|` and
/// `|1-t|`: continuous exactly for `0 < t < 1`.
fn corner_cutting() -> (Value, Value) {
    let family = family(&[["0", "1"], ["1", "0"], ["1", "-1"]], 1);
    let polytope = |end: &str, word: &str, images: Value| {
        json!({
            "kind": "polytope", "pencil": "parameter", "inner": "1/2", "end": end,
            "mirrored": true, "bits": 0, "vertices": [[1]],
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
    assert!(common::check(&wrong).is_err());
    // Inside, up to an end that is included: nothing is met.
    let mut closed = valid.clone();
    closed["conclusion"]["proved"][0] = json!({"from": "1/2", "to": "3/4", "ends": "[]"});
    closed["lemmas"][0]["end"] = json!("3/4");
    closed["lemmas"][0]["leading"] = json!([]);
    closed["lemmas"][0]["weight_bits"] = json!(2);
    closed["lemmas"][0]["units"] = json!([[[0, 4]]]);
    closed["lemmas"][0]["inner_images"] = json!([[[[0, 2]], [[0, 2]]]]);
    closed["lemmas"][0]["end_images"] = json!([[[[0, 3]], [[0, 1]]]]);
    accept(&closed);
    closed["conclusion"]["proved"][0]["to"] = json!("4/5");
    refuse(&closed, "proved interval 0 is not covered");
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
    let wrong = json!([{"kind": "at", "value": "1/15", "order": 4, "lemmas": []}]);
    refuse(&certificate(&four_point(), &nothing(1), &wrong), "not divisible as often");
    let other = json!({"kind": "norm", "level": 2, "from": "1/15", "to": "1/15"});
    let wrong = json!([{"kind": "at", "value": "1/16", "order": 4, "lemmas": [other]}]);
    let claim = certificate(&four_point(), &nothing(1), &wrong);
    refuse(&claim, "lemma 0 (at), inside it lemma 0 (norm): an end that is not the value");
}

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

fn product(a: &[i64], b: &[i64]) -> Vec<i64> {
    let mut product = vec![0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        b.iter().enumerate().for_each(|(j, y)| product[i + j] += x * y);
    }
    product
}

/// `(1+z)^order`.
fn power_of_sum(order: usize) -> Vec<i64> {
    (0..order).fold(vec![1], |p, _| product(&p, &[1, 1]))
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
    let moving = common::family(&[["0", "1"], ["0", "1"], ["1", "-1"], ["1", "-1"]], 1);
    refuse(&stable(&moving, json!([])), "opposite zeros that move with the parameter");
    // Two submasks of which one is constant: 2t (1+w) and 1 - 4t.
    accept(&stable(&cubic_like(), json!(["1/4", "1/2"])));
    refuse(&stable(&cubic_like(), json!(["1/2"])), "at a root of unity of even order");
    refuse(&stable(&cubic_like(), json!(["1/4"])), "an orbit of roots of unity");
}

/// The mask `[t, 1/2, 1-2t, 1/2, t]`: the cubic spline at 1/8, `(1+z)(1+z³)/2` at 1/2.
fn cubic_like() -> Value {
    family(&[["0", "1"], ["1/2", "0"], ["1", "-2"], ["1/2", "0"], ["0", "1"]], 2)
}

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
    let counts = common::check(&valid).unwrap().lemmas;
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
        refuse(&weaker, "show neither expansion nor indivisibility");
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
    refuse(&with("/lemmas", json!([stable])), "show neither expansion nor indivisibility");
    refuse(&with("/lemmas", json!([word])), "do not show stability");
    refuse(&with("/lemmas/1/except", json!(["1/2"])), "an exception but no parameter");
    let norm = json!({"kind": "norm", "level": 1, "from": "1/2", "to": "1/2"});
    refuse(&with("/lemmas/0", norm), "inside a `reduced` lemma is one that proves C^n");
    let zero = certificate(&cubic_like(), &nothing(0), &json!([hat_lemma()]));
    refuse(&zero, "a `reduced` lemma about C^0");
    let claim = certificate(&spline(2), &regularity("1", "1", "1"), &json!([hat_lemma()]));
    refuse(&claim, "the conclusion is not about continuity");
}

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
