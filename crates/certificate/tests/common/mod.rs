//! Certificates made by hand.
#![allow(dead_code, reason = "each test file uses its share")]

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
