//! Maps that are broken, too large or false; by hand, whatever makes them.

use refinable_certificate::{CellVerdict, MapCertificate, Unreadable, verify_map};
use serde_json::{Value, json};

use crate::support::{certificate, constant_family, smooth};

/// `[x, 1/2, 1-2x, 1/2, x]`, whatever `y`: the rows of `c_0` are `|x| + |1/2-x|`, one half for `x` from 0 to 1/2.
fn map() -> Value {
    json!({
        "format": "refinable-map-certificate", "version": 1,
        "family": {
            "name": "test", "arity": 2, "parameters": ["u", "v"], "order": 1, "lowest": -2,
            "mask": [
                [["1", 1, 0]], [["1/2", 0, 0]], [["1", 0, 0], ["-2", 1, 0]], [["1/2", 0, 0]], [["1", 1, 0]],
            ],
        },
        "continuity": 0, "box": [["0", "1/2"], ["0", "1"]], "roots": [0],
        "nodes": [
            {"kind": "cut", "line": ["1", "1", "1"], "below": 1, "above": 2},
            {"kind": "norm"}, {"kind": "undecided"},
        ],
    })
}

/// The verdicts, or why there are none.
fn check(value: &Value) -> Result<Vec<CellVerdict>, String> {
    let map = MapCertificate::read(value.to_string().as_bytes()).map_err(|e| e.to_string())?;
    let cells = verify_map(&map).map_err(|e| e.to_string())?;
    Ok(cells.into_iter().map(|cell| cell.verdict).collect())
}

#[test]
fn a_norm_on_a_piece() {
    assert_eq!(check(&map()), Ok(vec![CellVerdict::Proved, CellVerdict::Undecided]));
}

/// `|x| + |1/2 - x|` is the sum of both rows, and one at `x = 3/4` and `x = -1/4`.
#[test]
fn a_norm_is_below_one_up_to_the_corners() {
    let holds = |ends: [&str; 2]| {
        let mut whole = map();
        whole["box"][0] = json!(ends);
        whole["nodes"] = json!([{"kind": "norm"}]);
        check(&whole)
    };
    assert_eq!(holds(["-24/100", "74/100"]), Ok(vec![CellVerdict::Proved]));
    for ends in [["0", "3/4"], ["-1/4", "0"]] {
        assert!(holds(ends).is_err_and(|error| error.contains("the norm is not below one")));
    }
}

#[test]
fn what_is_not_a_map_is_unreadable() {
    let text = map().to_string();
    for length in 0..text.len() {
        assert!(MapCertificate::read(&text.as_bytes()[..length]).is_err(), "{length}");
    }
    let other = certificate(&json!({}), &json!({}), &json!([])).to_string();
    for (from, to) in [
        ("\"version\":1", "\"version\":2"),
        ("\"norm\"", "\"trust\""),
        ("\"roots\"", "\"root\""),
        ("refinable-map-certificate", "refinable-certificate"),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text);
        let read = MapCertificate::read(changed.as_bytes());
        assert!(matches!(read, Err(Unreadable::Malformed(_))), "{read:?}");
    }
    assert!(
        MapCertificate::is_meant(text.as_bytes()) && !MapCertificate::is_meant(other.as_bytes())
    );
    // The word alone, somewhere in the file, does not make a map.
    let named = json!({"format": "refinable-certificate", "name": "refinable-map-certificate"});
    assert!(!MapCertificate::is_meant(named.to_string().as_bytes()));
}

#[test]
fn other_formats_and_versions_are_not_checked() {
    let valid = MapCertificate::read(map().to_string().as_bytes()).unwrap();
    assert_eq!(MapCertificate::read(valid.to_json().as_bytes()), Ok(valid.clone()));
    let version = MapCertificate { version: 2, ..valid.clone() };
    let format = MapCertificate { format: "refinable-certificate".into(), ..valid };
    for changed in [version, format] {
        let refused = verify_map(&changed).unwrap_err().to_string();
        assert!(refused.contains("format or version"), "{refused}");
    }
}

/// A change at a place, and what is said of it.
#[test]
fn hostile_parts() {
    let long = format!("1/1{}", "0".repeat(200));
    let huge = json!(u64::MAX);
    let word = |radius: &Value, word: &str| json!({"kind": "word", "word": word, "block": 0, "eigenvalue": "positive", "radius": radius});
    let ellipsoids = |memory: u64, corners: Value| json!({"kind": "ellipsoids", "memory": memory, "corners": corners});
    let form = |entry: i64| json!([[entry, 0, 0, entry, 0, entry]]);
    let section = json!({
        "origin": [long.as_str(), "0"], "direction": ["0", "0"],
        "certificate": certificate(
            &json!({"name": "", "arity": 2, "parameter": null, "order": 1, "lowest": 0, "mask": [["1"], ["1"]]}),
            &json!({"kind": "continuity", "continuity": 0, "proved": [], "refuted": []}),
            &json!([]),
        ),
    });
    let changes: Vec<(&str, Value, &str)> = vec![
        ("/continuity", huge.clone(), "the continuity is not less than the order"),
        ("/continuity", json!(1), "the continuity is not less than the order"),
        ("/family/arity", json!(11), "above ten"),
        ("/family/arity", huge.clone(), "above ten"),
        ("/family/order", huge.clone(), "too large"),
        ("/family/order", json!(0), "too small"),
        ("/family/order", json!(3), "not divisible"),
        ("/family/mask", json!([]), "too short"),
        ("/family/mask", json!(vec![json!([["1/100", 0, 0]]); 201]), "too long"),
        ("/family/mask/0", json!([["1", 7, 0]]), "degree above 6"),
        ("/family/mask/0", json!([["1", u32::MAX, 0]]), "degree above 6"),
        ("/family/mask/0", json!([["1", 4, 4]]), "degree above 6"),
        ("/family/mask/0", json!([["1", 6, 1]]), "degree above 6"),
        ("/family/mask/0", json!(vec![json!(["1/100", 1, 0]); 101]), "more than 100 terms"),
        ("/family/mask/0", json!([["2", 1, 0]]), "does not sum to one"),
        ("/family/denominator", json!(vec![json!(["1", 1, 0]); 101]), "more than 100 terms"),
        ("/box/0", json!(["3/4", "1"]), "the norm is not below one"),
        ("/box/0", json!(["1", "0"]), "not below the upper one"),
        ("/box/0", json!(["1/2", "1/2"]), "not below the upper one"),
        ("/box/1", json!(["0", "0"]), "not below the upper one"),
        ("/box/0/1", json!(long), "512 bits"),
        ("/stable_at", json!([long, "0"]), "512 bits"),
        ("/stable_at", json!(["1/4", "0"]), "not shown to be stable"),
        ("/roots", json!([1]), "reached"),
        ("/roots", json!([]), "one root"),
        ("/roots", json!([u64::MAX]), "does not exist"),
        ("/nodes/0/below", json!(0), "reached twice"),
        ("/nodes/0/above", json!(1), "reached twice"),
        ("/nodes/0/above", huge.clone(), "does not exist"),
        ("/nodes/0/line", json!(["0", "0", "1"]), "no line"),
        ("/nodes/0/line", json!(["1", "1", "7"]), "misses"),
        ("/nodes/1", word(&huge, "01"), "not shown to hold"),
        ("/nodes/1", word(&json!(0), "01"), "below one"),
        ("/nodes/1", word(&json!(1), ""), "empty"),
        ("/nodes/1", word(&json!(1), "2"), "no matrix"),
        ("/nodes/1", word(&json!(1), &"0".repeat(13)), "too long"),
        ("/nodes/1", word(&json!(1), "٣"), "no matrix"),
        ("/nodes/1", ellipsoids(u64::from(u32::MAX), json!([])), "more than 64"),
        ("/nodes/1", ellipsoids(0, json!([])), "the wrong number"),
        ("/nodes/1", ellipsoids(0, json!(vec![form(i64::MIN); 4])), "too large"),
        ("/nodes/1", ellipsoids(0, json!(vec![form(0); 4])), "positive definite"),
        ("/nodes/1", json!({"kind": "indivisible"}), "divides the symbol"),
        ("/sections", json!(vec![section.clone(); 51]), "more than 50"),
        ("/sections", json!([section]), "512 bits"),
    ];
    for (place, part, because) in changes {
        let mut changed = map();
        let (parent, name) = place.rsplit_once('/').expect("a path");
        match changed.pointer_mut(place) {
            Some(old) => *old = part,
            None => changed.pointer_mut(parent).expect("a parent")[name] = part,
        }
        let found = check(&changed);
        assert!(found.as_ref().is_err_and(|error| error.contains(because)), "{place}: {found:?}");
    }
}

/// At `x = 1/8` the mask is that of cubic B-splines.
#[test]
fn sections_are_about_the_masks_at_their_points() {
    let norm = json!([{"kind": "norm", "level": 1, "from": "0", "to": "1"}]);
    let section = |mask: &[i64], origin: &str| {
        let family = constant_family(mask, 8, 1);
        let certificate = certificate(&family, &smooth(0, &[["0", "1"]]), &norm);
        json!({"origin": [origin, "0"], "direction": ["0", "0"], "certificate": certificate})
    };
    let with = |mut section: Value, lowest: i64| {
        let mut changed = map();
        section["certificate"]["family"]["lowest"] = json!(lowest);
        changed["sections"] = json!([section]);
        check(&changed).map(|_| ())
    };
    let (cubic, linear) = ([1, 4, 6, 4, 1], [0, 4, 8, 4, 0]);
    assert_eq!(with(section(&cubic, "1/8"), -2), Ok(()));
    assert_eq!(with(section(&linear, "0"), -2), Ok(()));
    for (section, lowest) in
        [(section(&cubic, "1/7"), -2), (section(&linear, "1/8"), -2), (section(&cubic, "1/8"), -1)]
    {
        let error = with(section, lowest).expect_err("other masks");
        assert!(error.contains("other masks than those of the line"), "{error}");
    }
}

/// Without a proof nothing is claimed, however absurd the order.
#[test]
fn nothing_is_proved_of_an_absurd_order() {
    let mut changed = map();
    changed["continuity"] = json!(usize::MAX);
    changed["nodes"] = json!([{"kind": "undecided"}]);
    assert_eq!(check(&changed), Ok(vec![CellVerdict::Undecided]));
}

/// `[x, y/2, y-2x, y/2, x]` over `y`: the mask of `map` at `x/y`, on a box as a whole.
fn quotient(window: [[&str; 2]; 2], node: Value) -> Value {
    let mut quotient = map();
    quotient["family"]["mask"] = json!([
        [["1", 1, 0]],
        [["1/2", 0, 1]],
        [["1", 0, 1], ["-2", 1, 0]],
        [["1/2", 0, 1]],
        [["1", 1, 0]],
    ]);
    quotient["family"]["denominator"] = json!([["1", 0, 1]]);
    quotient["box"] = json!(window);
    quotient["nodes"] = json!([node]);
    quotient
}

#[test]
fn norms_on_both_sides_of_a_pole_but_not_across() {
    let norm = || json!({"kind": "norm"});
    let narrow = ["-1/100", "1/100"];
    for [low, high] in [["1/20", "1"], ["-1", "-1/20"]] {
        assert_eq!(check(&quotient([narrow, [low, high]], norm())), Ok(vec![CellVerdict::Proved]));
    }
    // At all corners the norm is small.
    for across in [["-1", "1"], ["0", "1"], ["-1", "0"]] {
        let found = check(&quotient([narrow, across], norm()));
        assert!(found.is_err_and(|error| error.contains("the norm is not below one")));
    }
}

/// What an inequality says of `(x, y)` it says of `(-x, -y)`: nothing where the scheme converges, `1/16 ≤ x/y ≤ 1/4`,
/// and for some words that it diverges where `x/y ≥ 1` or `x/y ≤ -1`.
#[test]
fn inequalities_on_both_sides_of_a_pole() {
    let negative = |[low, high]: [&str; 2]| [high, low].map(|x| format!("-{x}").replace("--", ""));
    let holds = |window: [[&str; 2]; 2], word: &str, block: usize, eigenvalue: &str| {
        let word = json!({
            "kind": "word", "word": word, "block": block, "eigenvalue": eigenvalue, "radius": 1,
        });
        match check(&quotient(window, word)) {
            Ok(_) => true,
            Err(error) if ["not shown", "no such block"].iter().any(|s| error.contains(s)) => false,
            Err(error) => panic!("{error}"),
        }
    };
    for (x, converges) in [(["1/16", "1/8"], true), (["2", "3"], false), (["-3", "-2"], false)] {
        let y = if converges { ["1/2", "1"] } else { ["1", "2"] };
        let (minus_x, minus_y) = (negative(x), negative(y));
        let opposite = [&minus_x, &minus_y].map(|ends| ends.each_ref().map(String::as_str));
        let mut found = 0;
        for word in ["0", "1", "001"] {
            for (block, eigenvalue) in
                [(0, "positive"), (0, "negative"), (1, "positive"), (1, "negative")]
            {
                let there = holds([x, y], word, block, eigenvalue);
                assert_eq!(there, holds(opposite, word, block, eigenvalue), "{word} {block}");
                found += usize::from(there);
            }
        }
        assert_eq!(found == 0, converges);
    }
}

/// `(1+z) (-x + (1+2x) z - x z²)`, whose matrices are `[[1+2x, 0], [-x, -x]]` and its half turn, with a proof on the
/// box of `x`.
fn of_two_rows(ends: [&str; 2], proof: Value) -> Result<Vec<CellVerdict>, String> {
    let mut changed = map();
    let outer = json!([["-1", 1, 0]]);
    let inner = json!([["1", 0, 0], ["1", 1, 0]]);
    changed["family"]["mask"] = json!([outer, inner, inner, outer]);
    changed["box"][0] = json!(ends);
    changed["nodes"] = json!([proof]);
    check(&changed)
}

/// `1 - A A^T` is positive definite for `x = -1/4`, where `A A^T = [[4, 2], [2, 2]]/16`, and `A` turned round has the
/// same.
#[test]
fn the_unit_disc_shrinks() {
    let discs = |form: [i64; 3]| {
        let corners = vec![[form]; 4];
        json!({"kind": "ellipsoids", "memory": 0, "corners": corners})
    };
    assert_eq!(of_two_rows(["-1/4", "-1/8"], discs([1, 0, 1])), Ok(vec![CellVerdict::Proved]));
    for (ends, form) in [(["0", "1/8"], [1, 0, 1]), (["-1/4", "-1/8"], [64, 0, 1])] {
        let error = of_two_rows(ends, discs(form)).expect_err("it does not shrink");
        assert!(error.contains("mapped below"), "{error}");
    }
}

/// For `x = 1/2` the form `P = [[-2, 1], [1, 4]]` is more than `A P A^T`, by the diagonal 6, 3; so `A`, with the eigenvalue
/// 2, grows.
#[test]
fn a_form_that_is_negative_somewhere_grows() {
    let grows = |form: [i64; 3], vector: [i64; 2]| {
        let corners = vec![[form]; 4];
        json!({"kind": "expansion", "word": "0", "vector": vector, "corners": corners})
    };
    let refuted = Ok(vec![CellVerdict::Refuted { if_stable: false }]);
    let ends = ["1/2", "9/16"];
    for vector in [[1, 0], [3, 1]] {
        assert_eq!(of_two_rows(ends, grows([-2, 1, 4], vector)), refuted);
    }
    for (ends, form, vector, because) in [
        (ends, [-2, 1, 4], [1, 2], "not negative at the vector"),
        (ends, [-2, 1, 4], [2, 1], "not negative at the vector"),
        (ends, [-2, 1, -4], [1, 0], "mapped below"),
        (ends, [-2, 5, 4], [1, 0], "mapped below"),
        (["-1/4", "-1/8"], [-2, 1, 4], [1, 0], "mapped below"),
    ] {
        let error = of_two_rows(ends, grows(form, vector)).expect_err("it does not grow");
        assert!(error.contains(because), "{error}");
    }
}

/// One more factor `(1+z)/2` and one more order: then a product that grows tells something of schemes with stable shifts
/// only.
#[test]
fn smoothness_is_refuted_where_shifts_are_stable() {
    let forms = vec![[[-2, 1, 4]]; 4];
    let mut changed = map();
    let (outer, inner) = (json!([["-1/2", 1, 0]]), json!([["1/2", 0, 0]]));
    changed["family"]["mask"] = json!([outer, inner, [["1", 0, 0], ["1", 1, 0]], inner, outer]);
    changed["family"]["order"] = json!(2);
    changed["continuity"] = json!(1);
    changed["box"][0] = json!(["1/2", "9/16"]);
    changed["nodes"] =
        json!([{"kind": "expansion", "word": "0", "vector": [1, 0], "corners": forms}]);
    let error = check(&changed).expect_err("nothing is said of the shifts");
    assert!(error.contains("stable shifts are needed"), "{error}");
    changed["stable_at"] = json!(["1", "0"]);
    assert_eq!(check(&changed), Ok(vec![CellVerdict::Refuted { if_stable: true }]));
    // The eigenvalue 4 of two letters together is one of 2 a letter: the scheme may converge still.
    let word = |word: &str| json!({"kind": "word", "word": word, "block": 0, "eigenvalue": "positive", "radius": 1});
    for text in ["0", "00"] {
        changed["nodes"] = json!([word(text)]);
        assert_eq!(check(&changed), Ok(vec![CellVerdict::Refuted { if_stable: true }]), "{text}");
    }
    changed.as_object_mut().expect("fields").remove("stable_at");
    let error = check(&changed).expect_err("nothing is said of the shifts");
    assert!(error.contains("stable shifts are needed"), "{error}");
}

/// In `of_two_rows` the letters are `A` and its mirror image `A J`. Each maps its form below itself, but not below that of the next
/// letter.
#[test]
fn forms_of_a_word_follow_each_other() {
    let grows = |word: &str, forms: &[[i64; 3]]| {
        let corners = vec![forms; 4];
        json!({"kind": "expansion", "word": word, "vector": [1, 0], "corners": corners})
    };
    let (form, other) = ([-20, 13, 40], [-10, 0, -3]);
    let ends = ["3/4", "13/16"];
    let refuted = Ok(vec![CellVerdict::Refuted { if_stable: false }]);
    assert_eq!(of_two_rows(ends, grows("0", &[form])), refuted);
    assert_eq!(of_two_rows(ends, grows("1", &[other])), refuted);
    assert_eq!(of_two_rows(ends, grows("00", &[form, form])), refuted);
    let error = of_two_rows(ends, grows("01", &[form, other])).expect_err("another product");
    assert!(error.contains("mapped below"), "{error}");
}

/// `(1+z) (3/10-x + z/10 + (6/10+x) z²)` is not symmetric: the form is mapped below itself by the first letter and by its mirror
/// image, but not by the second letter.
#[test]
fn all_letters_count_where_masks_are_not_symmetric() {
    let proved = |form: [i64; 3]| {
        let mut changed = map();
        let of = |c: &str, slope: &str| json!([[c, 0, 0], [slope, 1, 0]]);
        changed["family"]["mask"] =
            json!([of("3/10", "-1"), of("2/5", "-1"), of("7/10", "1"), of("3/5", "1")]);
        changed["box"][0] = json!(["0", "1/100"]);
        changed["nodes"] = json!([{"kind": "ellipsoids", "memory": 0, "corners": vec![[form]; 4]}]);
        check(&changed)
    };
    assert_eq!(proved([1, 0, 1]), Ok(vec![CellVerdict::Proved]));
    let error = proved([1, 0, 20]).expect_err("the second letter grows");
    assert!(error.contains("mapped below"), "{error}");
}

/// `[y, 1/2, 1-2y, 1/2, y]` with `y = v (1 - 2u)`: the box of the parameters is one part of the plane, or two where the factor
/// vanishes inside.
fn chart(span: [&str; 2], roots: usize) -> Value {
    let mut changed = map();
    let plane = |c: &str| json!([[c, 0, 1]]);
    let chart = |c: &str, slope: &str| json!([[c, 0, 1], [slope, 1, 1]]);
    let half = json!([["1/2", 0, 0]]);
    let middle = |terms: Value| {
        let mut all = vec![json!(["1", 0, 0])];
        all.extend(terms.as_array().expect("terms").iter().cloned());
        json!(all)
    };
    let [outer, inner] = [plane("1"), middle(plane("-2"))];
    changed["family"]["mask"] = json!([outer, half, inner, half, outer]);
    let [outer, inner] = [chart("1", "-2"), middle(chart("-2", "4"))];
    changed["family"]["chart"] =
        json!({"factor": ["1", "-2"], "mask": [outer, half, inner, half, outer]});
    changed["box"] = json!([span, ["-1/10", "1/10"]]);
    changed["roots"] = (0..roots).collect();
    changed["nodes"] = json!(vec![json!({"kind": "norm"}); roots]);
    changed
}

#[test]
fn boxes_of_a_chart_are_cut_where_its_factor_vanishes() {
    for (span, parts) in [
        (["0", "1"], 2),
        (["0", "1/2"], 1),
        (["1/2", "1"], 1),
        (["0", "2/5"], 1),
        (["3/5", "1"], 1),
        (["-1/10", "7/8"], 2),
    ] {
        assert_eq!(check(&chart(span, parts)), Ok(vec![CellVerdict::Proved; parts]), "{span:?}");
        assert!(check(&chart(span, 3 - parts)).is_err(), "{span:?}");
    }
}

#[test]
fn charts_are_about_the_same_masks() {
    for (place, part, because) in [
        ("factor", json!(["1", "-1"]), "not those in the plane"),
        ("factor", json!(["1"]), "not affine"),
        ("factor", json!(["1", "-2", "1"]), "not affine"),
        ("mask", json!(vec![json!([["1", 0, 0]]); 4]), "different lengths"),
        ("mask", json!(vec![json!([["1", 0, 0]]); 5]), "not those in the plane"),
    ] {
        let mut changed = chart(["0", "2/5"], 1);
        changed["family"]["chart"][place] = part;
        let error = check(&changed).expect_err("another chart");
        assert!(error.contains(because), "{place}: {error}");
    }
}

/// At `x = 0` the difference symbol is `(2 + z²)(2 + z)/9`, whose submasks have the common zero -2, or `1 - z + z²`, of
/// which the cube roots of unity are zeros at `-z`: either is enough to say nothing.
#[test]
fn both_reasons_for_unstable_shifts_are_excluded() {
    let constants = [["4/9", "2/3", "4/9", "1/3", "1/9"], ["1", "0", "0", "1", "0"]];
    for mask in constants {
        // And x (1 - z²)².
        let slopes = ["1", "0", "-2", "0", "1"];
        let terms = mask.iter().zip(slopes).map(|(c, slope)| {
            let both = [(*c, 0), (slope, 1)];
            let occurring = both.iter().filter(|(c, _)| *c != "0");
            json!(occurring.map(|(c, i)| json!([c, i, 0])).collect::<Vec<_>>())
        });
        let mut changed = map();
        changed["family"]["mask"] = terms.collect();
        changed["nodes"] = json!([{"kind": "undecided"}]);
        changed["stable_at"] = json!(["1/7", "0"]);
        assert_eq!(check(&changed), Ok(vec![CellVerdict::Undecided]), "{mask:?}");
        changed["stable_at"] = json!(["0", "0"]);
        let error = check(&changed).expect_err("the shifts may be unstable");
        assert!(error.contains("not shown to be stable"), "{error}");
    }
}
