//! Files that are broken, or too large, or both.

use std::time::{Duration, Instant};

use refinable_algebra::Integer;
use refinable_certificate::{Certificate, Unreadable, verify};
use serde_json::{Value, json};

use crate::support::{
    FOUR_POINT, certificate, constant_family, four_point, growing_waves, leaning_theorem, nothing,
    smooth, waves,
};

/// Reads and, if that succeeds, verifies; neither may take long.
fn survive(bytes: &[u8]) -> Result<(), String> {
    let start = Instant::now();
    let result = match Certificate::read(bytes) {
        Ok(certificate) => verify(&certificate).map(|_| ()).map_err(|e| e.to_string()),
        Err(unreadable) => Err(unreadable.to_string()),
    };
    assert!(start.elapsed() < Duration::from_secs(60), "{:?} {result:?}", start.elapsed());
    if let Err(reason) = &result {
        assert!(!reason.is_empty() && reason.len() < 400, "{reason}");
    }
    result
}

fn survive_value(value: &Value) -> Result<(), String> {
    survive(value.to_string().as_bytes())
}

fn lemma(lemma: Value) -> Value {
    certificate(&four_point(), &nothing(1), &json!([lemma]))
}

fn too_large(value: &Value) {
    let read = Certificate::read(value.to_string().as_bytes());
    assert!(matches!(read, Err(Unreadable::TooLarge(_))), "{read:?}");
}

#[test]
fn every_truncation_is_unreadable() {
    let bytes = FOUR_POINT.trim_end().as_bytes();
    assert!(survive(bytes).is_ok());
    for length in 0..bytes.len() {
        assert!(Certificate::read(&bytes[..length]).is_err(), "{length}");
    }
}

/// What was not read from a file is looked at in the same way.
#[test]
fn other_formats_and_versions_are_not_checked() {
    let valid = Certificate::read(FOUR_POINT.as_bytes()).unwrap();
    let refused = |certificate: &Certificate| verify(certificate).unwrap_err().to_string();
    let version = Certificate { version: 2, ..valid.clone() };
    let format = Certificate { format: "refinable-map-certificate".into(), ..valid };
    assert!([version, format].iter().all(|changed| refused(changed).contains("format or version")));
}

#[test]
fn bytes_of_any_kind() {
    for bytes in [&b""[..], b"\xff\xfe", b"null", b"[]", b"{}", b"\"", b"{\"format\":", b"1e999999"]
    {
        assert!(survive(bytes).is_err());
    }
    for open in ["[", "{\"a\":", "{\"lemmas\":[{\"kind\":\"at\",\"lemmas\":["] {
        let deep = open.repeat(1_000_000);
        assert!(survive(deep.as_bytes()).unwrap_err().contains("nesting"));
    }
    let digits = "7".repeat(10_000_000);
    for text in [digits.clone(), format!("\"{digits}\""), format!("{{\"version\":{digits}}}")] {
        assert!(survive(text.as_bytes()).unwrap_err().contains("4000"));
    }
    let many = format!("[{}0]", "0,".repeat(20_000_000));
    assert!(survive(many.as_bytes()).unwrap_err().contains("ten million"));
    assert!(survive(&vec![b' '; (64 << 20) + 1]).unwrap_err().contains("64 MiB"));
    assert!(survive(&vec![b'"'; 1 << 20]).is_err());
}

#[test]
fn unknown_missing_and_repeated_fields() {
    let valid = FOUR_POINT.trim_end();
    let with = |from: &str, to: &str| valid.replacen(from, to, 1);
    for text in [
        with("\"version\":1", "\"version\":2"),
        with("\"version\":1", "\"version\":1,\"version\":1"),
        with("\"version\":1", "\"version\":1,\"more\":1"),
        with("refinable-certificate", "refinable"),
        with("\"arity\":2", "\"arity\":2.0"),
        with("\"arity\":2", "\"arity\":-2"),
        with("\"arity\":2", "\"arity\":\"2\""),
        with("\"kind\":\"norm\"", "\"kind\":\"norm\",\"kind\":\"norm\""),
        with("\"kind\":\"norm\"", "\"kind\":\"trust\""),
        with("\"level\":2", "\"level\":2,\"colour\":3"),
        with("\"word\":\"0\",\"from\":null", "\"word\":\"0\""),
        with("\"1/100\"", "\"0.01\""),
        with("\"1/100\"", "\"1/0\""),
        with("\"1/100\"", "0"),
        with("\"1/100\"", "\" 1/100\""),
    ] {
        assert_ne!(text, valid);
        let read = Certificate::read(text.as_bytes());
        assert!(matches!(read, Err(Unreadable::Malformed(_))), "{read:?}");
    }
}

/// Each limit from both sides: what is just read, and what is just too large.
#[test]
fn at_the_limits_of_size() {
    let word = |letters: usize| {
        let word = "0".repeat(letters);
        lemma(json!({"kind": "word", "pencil": "parameter", "word": word, "from": "0", "to": "0"}))
    };
    let norm =
        |level: usize| lemma(json!({"kind": "norm", "level": level, "from": "0", "to": "0"}));
    let root = |degree: usize| {
        let root = json!({"root_of": vec!["1"; degree + 1], "between": ["0", "1"]});
        lemma(json!({"kind": "nonnegative", "end": root}))
    };
    let family = |mask: &[i64], order| {
        certificate(&constant_family(mask, 1, order), &nothing(0), &json!([]))
    };
    // Of arity two the matrices are as large as the degree of what is left of the symbol.
    let matrices = |size: usize| family(&vec![1; size + 2], 1);
    let coefficients = |count: usize| family(&vec![1; count], 970);
    let lemmas = |count: usize| {
        let stable = json!({"kind": "stable", "except": []});
        certificate(&four_point(), &nothing(1), &json!(vec![stable; count]))
    };
    let denominators = |bits: usize| {
        let parts = [bits / 4, bits / 4, bits / 4, bits - 3 * (bits / 4)];
        let mut family = constant_family(&[1, 1, 1, 1], 1, 1);
        family["mask"] = json!(parts.map(|k| [format!("1/{}", Integer::from(1) << k)]));
        certificate(&family, &nothing(0), &json!([]))
    };
    let limits: [(&dyn Fn(usize) -> Value, usize); 7] = [
        (&word, 32),
        (&norm, 12),
        (&root, 1200),
        (&matrices, 40),
        (&coefficients, 1000),
        (&lemmas, 5000),
        (&denominators, 14_000),
    ];
    for (sized, most) in limits {
        let read = Certificate::read(sized(most).to_string().as_bytes());
        assert!(read.is_ok(), "{most}: {:?}", read.err());
        too_large(&sized(most + 1));
    }
    let fits = |value: Value| serde_json::from_value::<Certificate>(value).unwrap().family.fits();
    assert_eq!(fits(matrices(40)), Ok(()));
    assert_eq!(fits(matrices(41)), Err("matrices of size above 40"));
    assert_eq!(fits(denominators(14_001)), Err("denominators of more than 4000 digits"));
}

#[test]
fn sizes_beyond_the_limits() {
    let word = |word: String| {
        lemma(json!({"kind": "word", "pencil": "parameter", "word": word, "from": "0", "to": "0"}))
    };
    too_large(&word("0".repeat(33)));
    let long = word("0".repeat(1_000_000));
    assert!(survive_value(&long).is_err());
    too_large(&lemma(json!({"kind": "norm", "level": 13, "from": "0", "to": "0"})));
    too_large(&lemma(json!({"kind": "norm", "level": u32::MAX, "from": "0", "to": "0"})));
    let root = json!({"root_of": vec!["1"; 1202], "between": ["0", "1"]});
    too_large(&lemma(json!({"kind": "nonnegative", "end": root})));
    too_large(&certificate(&constant_family(&[1; 1001], 1, 1), &nothing(0), &json!([])));
    too_large(&certificate(&constant_family(&[1; 60], 30, 1), &nothing(0), &json!([])));
    let at = json!({"kind": "at", "value": "0", "order": 1, "lemmas": []});
    too_large(&lemma(json!({"kind": "at", "value": "0", "order": 1, "lemmas": [at]})));
    let mut absurd = certificate(
        &constant_family(&[1, 2, 1], 2, 1),
        &nothing(0),
        &json!([{"kind": "indivisible", "order": 3, "except": []}, {"kind": "stable", "except": []}]),
    );
    absurd["conclusion"]["continuity"] = json!(usize::MAX);
    assert!(survive_value(&absurd).is_ok());
    let convergence = |lemmas: Value| json!({"kind": "convergence", "lemmas": lemmas});
    too_large(&lemma(convergence(json!([convergence(json!([]))]))));
    let at = json!({"kind": "at", "value": "0", "order": 1, "lemmas": []});
    too_large(&lemma(convergence(json!([at]))));
    let reduced = |factor: &Value, lemmas: &Value| {
        lemma(
            json!({"kind": "reduced", "value": "0", "factor": factor, "order": 1, "lemmas": lemmas}),
        )
    };
    let nested = reduced(&json!(["1"]), &json!([]))["lemmas"].clone();
    too_large(&reduced(&json!(["1"]), &nested));
    too_large(&reduced(&json!(vec!["1"; 1202]), &json!([])));
    assert!(survive_value(&reduced(&json!(vec!["1"; 1201]), &json!([]))).is_err());
    let norm = json!({"kind": "norm", "level": 1, "from": "0", "to": "0"});
    too_large(&reduced(&json!(["1"]), &json!(vec![norm.clone(); 5000])));
    too_large(&lemma(convergence(json!(vec![norm.clone(); 5000]))));
    too_large(&certificate(&four_point(), &nothing(1), &json!(vec![norm; 5001])));
    let prime = |i: usize| format!("1/{}", 10_u64.pow(17) + 1 + i as u64);
    let mut family = four_point();
    family["mask"] = json!((0..900).map(|i| [prime(i)]).collect::<Vec<_>>());
    too_large(&certificate(&family, &nothing(1), &json!([])));
    let digits = format!("\"{}\"", "7".repeat(2001));
    let text = FOUR_POINT.replacen("\"1/100\"", &digits, 1);
    assert!(Certificate::read(text.as_bytes()).is_err());
}

/// Powers of the arity that no machine word holds, and difference symbols so short that the level is not: the step
/// function of arity 64 is not continuous, whatever the level; and `c_1 = (1+z)/2` of arity 500.
#[test]
fn high_levels_of_large_arities() {
    let family = |arity: usize, mask: Vec<String>, order: usize| {
        let mask: Vec<_> = mask.into_iter().map(|c| json!([c])).collect();
        json!({
            "name": "test", "arity": arity, "parameter": null, "order": order, "lowest": 0, "mask": mask,
        })
    };
    let of_level = |family: &Value, continuity: usize, level: u32| {
        let norm = json!({"kind": "norm", "level": level, "from": "0", "to": "1"});
        survive_value(&certificate(family, &smooth(continuity, &[["0", "1"]]), &json!([norm])))
    };
    let steps = family(64, vec!["1".into(); 64], 1);
    for level in 1..=12 {
        assert!(of_level(&steps, 0, level).unwrap_err().contains("row 0 of the norm"), "{level}");
    }
    // (1 + z) σ² / 1000, by the sums of two neighbours of the triangle 1, 2, …, 500, …, 1.
    let triangle = |i: i64| (500 - (i - 499).abs()).max(0);
    let hats = (0..1000).map(|i| format!("{}/1000", triangle(i) + triangle(i - 1)));
    let hats = family(500, hats.collect(), 2);
    for level in 1..=12 {
        let found = of_level(&hats, 1, level);
        let small = level <= 3;
        assert_eq!(found.is_ok(), small, "{level}");
        assert!(small || found.unwrap_err().contains("within the limits"), "{level}");
    }
}

#[test]
fn hostile_family_numbers() {
    for (field, value) in [
        ("order", json!(u64::MAX)),
        ("order", json!(0)),
        ("arity", json!(u64::MAX)),
        ("arity", json!(0)),
        ("arity", json!(1)),
        ("mask", json!([])),
        ("mask", json!([[]])),
        ("mask", json!([["1"], ["1"]])),
    ] {
        let mut family = four_point();
        family[field] = value;
        assert!(survive_value(&certificate(&family, &nothing(1), &json!([]))).is_err(), "{field}");
    }
    for lowest in [i64::MIN, i64::MAX] {
        let mut family = four_point();
        family["lowest"] = json!(lowest);
        assert!(survive_value(&certificate(&family, &nothing(1), &json!([]))).is_ok());
    }
    let norm = json!([{"kind": "norm", "level": 1, "from": "0", "to": "0"}]);
    assert!(
        survive_value(&certificate(
            &four_point(),
            &json!({"kind": "continuity",
        "continuity": u64::MAX, "proved": [], "refuted": []}),
            &norm
        ))
        .is_err()
    );
}

#[test]
fn hostile_polytopes() {
    let valid: Value = serde_json::from_str(FOUR_POINT).unwrap();
    let change = |pointer: &str, value: Value| {
        let mut changed = valid.clone();
        *changed.pointer_mut(&format!("/lemmas/1/{pointer}")).expect(pointer) = value;
        assert!(survive_value(&changed).is_err(), "{pointer}");
    };
    change("bits", json!(63));
    change("bits", json!(u32::MAX));
    change("weight_bits", json!(63));
    change("vertices", json!([]));
    change("vertices/3", json!([]));
    change("vertices/3/0", json!(i64::MIN));
    change("vertices/0/0", json!(i64::MAX));
    change("units", json!([]));
    change("units/0", json!(null));
    change("units/0", json!([]));
    change("units/0/0/0", json!(u64::MAX));
    change("units/0/0/1", json!(i64::MIN));
    change("inner_images/0", json!([]));
    change("inner_images/0/0", json!(null));
    change("inner_images/0/0", json!(vec![[0, i64::MIN]; 9]));
    change("end_images/1/0", json!([[u64::MAX, 1]]));
    change("end_images/5/0", json!(null));
    change("leading/0/vertex", json!(u64::MAX));
    change("leading/0/vertex", json!(29));
    change("leading/0/pivot", json!(u64::MAX));
    change("leading/0/pivot", json!(4));
    change("leading/0/sign", json!(i32::MIN));
    change("leading/0/sign", json!(0));
    change("leading/0/sign", json!(2));
    change("leading/0/word", json!(""));
    change("leading/0/word", json!("02"));
    change("leading/0/word", json!("0é"));
    change("leading", json!([valid["lemmas"][1]["leading"][0], valid["lemmas"][1]["leading"][0]]));
    change("end", json!({"root_of": [], "between": ["0", "1"]}));
    change("end", json!({"root_of": ["1"], "between": ["0", "1"]}));
    change("end", json!({"root_of": ["-1", "4", "0", "32"], "between": ["1", "0"]}));
    change("end", json!({"root_of": ["0", "1"], "between": ["0", "1"]}));
    change("end", json!("1/0"));
}

#[test]
fn hostile_complex_polytopes() {
    let valid = waves();
    assert_eq!(survive_value(&valid), Ok(()));
    let change = |pointer: &str, value: Value| {
        let mut changed = valid.clone();
        *changed.pointer_mut(&format!("/lemmas/0/{pointer}")).expect(pointer) = value;
        assert!(survive_value(&changed).is_err(), "{pointer}");
    };
    change("vertices/0", json!([]));
    change("vertices/0", json!([6, 0, 6, 0]));
    change("vertices/0", json!([6, 0, 6, 0, 0, 8, 0, -4, 0]));
    change("vertices/0", json!(vec![i64::MIN; 8]));
    change("vertices/0", json!(vec![i64::MAX; 8]));
    change("vertices", json!(vec![[0; 8]; 2]));
    change("vertices", json!(vec![[0; 8]; 20_001]));
    change("units/0", json!([[0, i64::MIN, i64::MIN], [7, i64::MIN, i64::MAX]]));
    change("units/0", json!([[u64::MAX, 1, 1]]));
    change("units/0", json!([[usize::MAX - 1, 1]]));
    change("units/0/0", json!([0, 1, 1, 1]));
    change("units/0/0", json!([0]));
    change("units/0/0", json!([0, 1, "1"]));
    change("units/0/0", json!([0, 1, 1.5]));
    change("units/0/0", json!([0, 1, i64::MIN as u64]));
    change("end_images/0/0", json!(vec![[0, i64::MIN, i64::MIN]; 9]));
    change("end_images/0/0", json!(vec![[0, 1, 1]; 40_001]));
    change("end_images/0/0", json!(vec![[0, 1, 1]; 40_000]));
    change("complex", json!(1));
    change("complex", json!(null));
    change("open", json!(0));
    change("mirrored", json!(null));
    change("bits", json!(63));
    change("weight_bits", json!(63));
    change("end", json!({"root_of": ["-1", "0", "3"], "between": ["0", "1"]}));
    let mut missing = valid.clone();
    for field in ["open", "complex"] {
        let value = missing["lemmas"][0].as_object_mut().unwrap().remove(field).unwrap();
        assert!(survive_value(&missing).unwrap_err().contains("missing field"));
        missing["lemmas"][0][field] = value;
    }
}

#[test]
fn hostile_moving_polytopes() {
    let real = leaning_theorem();
    let complex = growing_waves();
    for valid in [&real, &complex] {
        assert_eq!(survive_value(valid), Ok(()));
        let length = valid["lemmas"][0]["vertices"][0].as_array().unwrap().len();
        let count = valid["lemmas"][0]["vertices"].as_array().unwrap().len();
        let change = |pointer: &str, value: Value| {
            let mut changed = valid.clone();
            *changed.pointer_mut(&format!("/lemmas/0/motion{pointer}")).expect(pointer) = value;
            assert!(survive_value(&changed).is_err(), "{pointer}");
        };
        change("", json!({}));
        change("", json!([]));
        change("", json!({"vertices": [], "rests": []}));
        change("", json!({"vertices": [], "rests": [], "more": 0}));
        change("/vertices", json!([]));
        change("/vertices", json!(vec![vec![0; length]; count]));
        change("/vertices", json!(vec![vec![1; length]; count]));
        change("/vertices", json!(vec![vec![i64::MIN; length]; count]));
        change("/vertices", json!(vec![vec![1; length]; 20_001]));
        change("/vertices/0", json!([]));
        change("/vertices/0", json!(vec![i64::MAX; length]));
        change("/vertices/0", json!(vec![i64::MIN; length]));
        change("/vertices/1", json!(vec![0; length + 1]));
        change("/vertices/1/0", json!(i64::MIN as u64));
        change("/rests", json!([]));
        change("/rests", json!(vec![json!([[], []]); 20_001]));
        change("/rests/0", json!([]));
        change("/rests/0", json!(null));
        change("/rests/0/0", json!(null));
        change("/rests/0/0", json!([[u64::MAX, 1]]));
        change("/rests/0/0", json!([[usize::MAX - 1, 1]]));
        change("/rests/0/0", json!([[8, 1]]));
        change("/rests/0/0", json!([[0, i64::MIN]]));
        change("/rests/0/0", json!(vec![[0, i64::MIN, i64::MIN]; 9]));
        change("/rests/0/0", json!(vec![[0, 1]; 40_000]));
    }
    for list in ["motion/rests/0/0", "inner_images/0/0", "end_images/0/1", "units/0"] {
        let mut long = real.clone();
        *long.pointer_mut(&format!("/lemmas/0/{list}")).unwrap() = json!(vec![[0, 0]; 40_001]);
        too_large(&long);
    }
    let many = vec![json!([0, 1]); 20_001];
    for list in ["vertices", "motion/vertices"] {
        let mut long = real.clone();
        *long.pointer_mut(&format!("/lemmas/0/{list}")).unwrap() = json!(many);
        too_large(&long);
    }
}

/// A division that is not exact, of which the rests grow with every step.
#[test]
fn a_factor_with_long_coefficients() {
    let mut row = vec![Integer::from(1)];
    for _ in 0..100 {
        row.push(Integer::from(0));
        (1..row.len()).rev().for_each(|i| row[i] = &row[i] + &row[i - 1]);
    }
    row.resize(140, Integer::from(0));
    let mut family = constant_family(&[1, 1], 1, 100);
    let scale = Integer::from(1) << 99;
    family["mask"] = json!(row.iter().map(|c| [format!("{c}/{scale}")]).collect::<Vec<_>>());
    assert_eq!(survive_value(&certificate(&family, &nothing(1), &json!([]))), Ok(()));
    for degree in [1, 2, 20, 60, 139, 140, 1200] {
        let mut factor = vec!["7".repeat(2000); degree];
        factor.push("1".into());
        let reduced =
            json!({"kind": "reduced", "value": "0", "factor": factor, "order": 100, "lemmas": []});
        assert!(survive_value(&certificate(&family, &nothing(1), &json!([reduced]))).is_err());
    }
}

/// Small files with a lot of work behind them.
#[test]
fn bombs() {
    let long = |i: usize| format!("{}{i}", "7".repeat(1990));
    let polynomial: Vec<_> = (0..1201).map(|i| long(1000 + i)).collect();
    let root = json!({"root_of": polynomial, "between": ["-1", long(1)]});
    let stable = json!({"kind": "stable", "except": [root]});
    assert!(survive_value(&lemma(stable)).is_err());
    // Roots that agree to hundreds of digits: told apart, and the statement is true.
    let close = |shift: &str| json!({"root_of": [format!("-2{shift}"), "0", format!("1{}0", "0".repeat(shift.len() - 1))], "between": ["0", "2"]});
    let (a, b) = (close(&"0".repeat(900)), close(&format!("{}1", "0".repeat(899))));
    let word = json!({"kind": "word", "pencil": "parameter", "word": "0", "from": a, "to": b});
    assert_eq!(survive_value(&lemma(word)), Ok(()));
    let far = json!({"kind": "word", "pencil": "parameter", "word": "01".repeat(16),
        "from": long(1), "to": long(2)});
    let _ = survive_value(&lemma(far));
    // Rational numbers that agree for thousands of steps of their continued fractions.
    let (mut a, mut b) = (Integer::from(1), Integer::from(1));
    for _ in 0..9000 {
        (a, b) = (b.clone(), a + b);
    }
    let (c, d) = (&a + &b, &a + &b * 2);
    let norm =
        json!({"kind": "norm", "level": 1, "from": format!("{a}/{b}"), "to": format!("{c}/{d}")});
    assert!(survive_value(&lemma(norm)).is_err());
    // A norm with long numbers, and one that is one at an end.
    let fraction = |i: usize| format!("{}/{}", long(i), long(i + 1));
    let norm = json!({"kind": "norm", "level": 12, "from": fraction(1), "to": fraction(3)});
    assert!(survive_value(&lemma(norm)).is_err());
    let norm = json!({"kind": "norm", "level": 12, "from": "0", "to": "1/10"});
    assert!(survive_value(&lemma(norm)).is_err());
    // The largest matrices and the longest words.
    let mut mask = vec![0_i64; 42];
    (0..42).for_each(|i| mask[i] = [3, -5, 2, 7, -1, -4][i % 6]);
    let sums = [0, 1].map(|j| mask.iter().skip(j).step_by(2).sum::<i64>());
    let pairs: Vec<_> = mask
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let constant = if i < 2 { (1 - sums[i] + c).to_string() } else { c.to_string() };
            let slope = if i < 2 { (c - sums[i]).to_string() } else { c.to_string() };
            [constant, slope]
        })
        .collect();
    let family =
        json!({"name": "", "arity": 2, "parameter": "t", "order": 1, "lowest": 0, "mask": pairs});
    let claim = |lemma: &Value| survive_value(&certificate(&family, &nothing(0), &json!([lemma])));
    let word = "01101".repeat(6);
    assert!(
        claim(
            &json!({"kind": "word", "pencil": "parameter", "word": word, "from": null, "to": null})
        )
        .is_err()
    );
    assert!(claim(&json!({"kind": "norm", "level": 12, "from": "0", "to": "1"})).is_err());
    // This is within reach, and true; with long numbers it is not.
    let stable = json!({"kind": "stable", "except": []});
    assert_eq!(claim(&stable), Ok(()));
    let mut long_slopes = family.clone();
    for pair in long_slopes["mask"].as_array_mut().unwrap() {
        let slope = pair[1].as_str().unwrap().to_owned();
        pair[1] = json!(slope + &"0".repeat(1900));
    }
    assert!(survive_value(&certificate(&long_slopes, &nothing(0), &json!([stable]))).is_err());
    // A long mask for which the cyclotomic polynomials are many.
    let mut spread = vec![0; 1000];
    (spread[0], spread[999]) = (1, 1);
    let mut family = constant_family(&spread, 1, 1);
    family["order"] = json!(1);
    too_large(&certificate(&family, &nothing(0), &json!([{"kind": "stable", "except": []}])));
}
