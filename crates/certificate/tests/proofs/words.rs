//! The lemma `word`.

use serde_json::{Value, json};

use crate::support::{
    accept, certificate, constant_family, family, four_point, nothing, refuse, waves,
};

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
fn ends_that_are_no_numbers() {
    let word = |pencil: &str, root_of: &[&str], between: [&str; 2]| {
        let end = json!({"root_of": root_of, "between": between});
        let lemma = json!({"kind": "word", "pencil": pencil, "word": "0", "from": end, "to": null});
        certificate(&four_point(), &nothing(1), &json!([lemma]))
    };
    let refuse_root = |root_of: &[&str], between: [&str; 2], words: &str| {
        refuse(&word("parameter", root_of, between), words);
    };
    accept(&word("parameter", &["-2", "0", "1"], ["1", "2"]));
    refuse_root(&["-2", "0", "1"], ["2", "1"], "the interval around a root is empty");
    refuse_root(&["-2", "0", "1"], ["1", "1"], "the interval around a root is empty");
    refuse_root(&["-2", "0", "1"], ["-2", "2"], "does not contain exactly one");
    refuse_root(&["-2", "0", "1"], ["2", "3"], "does not contain exactly one");
    refuse_root(&["2", "-3", "1"], ["1", "3"], "vanishes at an end");
    refuse_root(&["2", "-3", "1"], ["0", "2"], "vanishes at an end");
    refuse_root(&["0", "0"], ["1", "2"], "every number is a root");
    // A double root is one.
    accept(&word("parameter", &["1", "-2", "1"], ["0", "3"]));
    let scale = word("scale", &["-2", "0", "1"], ["1", "2"]);
    refuse(&scale, "the scale of a family with a parameter");
}

#[test]
fn an_eigenvalue_that_does_not_move() {
    // c = 1 + tz - tz² and c = -1 + tz + (2-t)z²: A_0 = [[t, 0], [c_2, ±1]].
    let one = [["1", "0"], ["1", "1"], ["0", "0"], ["0", "-1"]];
    let minus_one = [["-1", "0"], ["-1", "1"], ["2", "0"], ["2", "-1"]];
    let claim = |mask: &[[&str; 2]], word: &str| {
        let lemma =
            json!({"kind": "word", "pencil": "parameter", "word": word, "from": null, "to": null});
        certificate(&family(mask, 1), &nothing(0), &json!([lemma]))
    };
    accept(&claim(&one, "0"));
    accept(&claim(&minus_one, "0"));
    // Of A_1 = [[-t, 1], [0, t]] and [[2-t, -1], [0, t]] only the second always has one.
    refuse(&claim(&one, "1"), "less than one somewhere");
    accept(&claim(&minus_one, "1"));
}

#[test]
fn words_at_scales() {
    // c = 2 - 2z + z²: the word 01 has complex eigenvalues of modulus 2√2, at the scale x
    // of modulus 2√2 x².
    let family = constant_family(&[2, 0, -1, 1], 1, 1);
    let word = |from: &str, to: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "scale", "word": "01", "from": from, "to": to});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    // 8^(-1/4) = 0.59460…
    accept(&word("59461/100000", json!(null)));
    accept(&word("3/5", json!("3/5")));
    for from in ["1/2", "5946/10000"] {
        refuse(&word(from, json!(null)), "less than one somewhere");
        refuse(&word(from, json!(from)), "less than one somewhere");
    }
    refuse(&word("-1", json!("1")), "less than one somewhere");
}

/// The eigenvalues of the word `0` are `-t` and zero, or `t` and zero.
#[test]
fn eigenvalues_beyond_one_and_minus_one() {
    let negative = [["0", "0"], ["0", "-1"], ["1", "0"], ["1", "1"]];
    let positive = [["0", "0"], ["0", "1"], ["1", "0"], ["1", "-1"]];
    for mask in [negative, positive] {
        let word = |from: &str, to: &str| {
            let lemma =
                json!({"kind": "word", "pencil": "parameter", "word": "0", "from": from, "to": to});
            certificate(&family(&mask, 1), &nothing(0), &json!([lemma]))
        };
        for (from, to) in [("1", "23/20"), ("1", "1"), ("-23/20", "-1"), ("1", "10"), ("5", "5")] {
            accept(&word(from, to));
        }
        for (from, to) in [("9/10", "23/20"), ("-23/20", "-9/10"), ("99/100", "10"), ("0", "0")] {
            refuse(&word(from, to), "less than one somewhere");
        }
    }
}

/// The eigenvalues of the word `0` are `±x` and `(1 ± i√2) x`, of modulus `√3 x`, where the sums and
/// products of few of them are small.
#[test]
fn complex_eigenvalues_at_scales() {
    let family = waves()["family"].clone();
    let word = |word: &str, from: Value, to: Value| {
        let lemma =
            json!({"kind": "word", "pencil": "scale", "word": word, "from": from, "to": to});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    let root =
        |square: [&str; 2]| json!({"root_of": [square[0], "0", square[1]], "between": ["0", "1"]});
    // 1/√3 = 0.57735…
    for letters in ["0", "00", "000", "1"] {
        for (from, to) in [("5774/10000", "62/100"), ("-62/100", "-5774/10000"), ("3/5", "3/5")] {
            accept(&word(letters, json!(from), json!(to)));
        }
        for (from, to) in [("55/100", "62/100"), ("-62/100", "-55/100"), ("57/100", "57/100")] {
            refuse(&word(letters, json!(from), json!(to)), "less than one somewhere");
        }
        for square in [["-1", "3"], ["-2", "5"], ["-100", "299"]] {
            accept(&word(letters, root(square), root(square)));
        }
        for square in [["-100", "301"], ["-3", "10"]] {
            refuse(&word(letters, root(square), root(square)), "less than one somewhere");
        }
        refuse(&word(letters, root(["-100", "301"]), json!(null)), "less than one somewhere");
        accept(&word(letters, root(["-1", "3"]), json!(null)));
    }
}

/// At one irrational number an eigenvalue is one: the reciprocal of `(3+√5)/10`.
#[test]
fn a_real_eigenvalue_at_an_irrational_number() {
    let family = constant_family(&[1, 3, 6, 6, 3, 1], 10, 1);
    let claim = |root_of: [&str; 3]| {
        let root = json!({"root_of": root_of, "between": ["1", "2"]});
        let lemma =
            json!({"kind": "word", "pencil": "scale", "word": "0", "from": root, "to": root});
        certificate(&family, &nothing(0), &json!([lemma]))
    };
    accept(&claim(["25", "-15", "1"]));
    accept(&claim(["2501", "-1500", "100"]));
    refuse(&claim(["2499", "-1500", "100"]), "less than one somewhere");
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
