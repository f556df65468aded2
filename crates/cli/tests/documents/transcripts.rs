//! Transcripts, and what is quoted from files.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::{blocks, printed, root};

#[test]
fn transcripts() {
    // trycmd runs the program where the test runs.
    std::env::set_current_dir(root()).expect("the repository");
    trycmd::TestCases::new()
        .register_bin("refinable", Path::new(env!("CARGO_BIN_EXE_refinable")))
        .case("README.md")
        .case("crates/refinable/src/guide/*.md");
}

/// trycmd takes backslashes for those of paths.
#[test]
fn the_latex_in_the_readme() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let [line] = &blocks(&readme, "latex")[..] else { panic!("one block") };
    let range = "refinable range '[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]' --continuity 1 --format latex";
    assert!(printed(range, &root()).contains(line), "{line}");
}

/// The guide opens a certificate: what it shows stands there.
#[test]
fn the_certificate_in_the_guide_is_the_one_of_the_report() {
    let guide = fs::read_to_string(root().join("crates/refinable/src/guide/proof.md")).unwrap();
    let file = root().join("reports/certificates/a2-b7712da3-C1.json");
    let mut certificate: Value = serde_json::from_slice(&fs::read(file).unwrap()).unwrap();
    let lemmas = certificate.as_object_mut().unwrap().remove("lemmas").unwrap();
    let lemmas = lemmas.as_array().unwrap();
    let shown: Vec<Value> =
        blocks(&guide, "json").iter().map(|block| serde_json::from_str(block).unwrap()).collect();
    let [header, rest @ ..] = &shown[..] else { panic!("it is shown") };
    assert_eq!(header, &certificate);
    let quoted: Vec<&Value> = rest
        .iter()
        .flat_map(|block| match block {
            Value::Array(several) => several.iter().collect(),
            one => vec![one],
        })
        .collect();
    assert!(quoted.iter().all(|lemma| lemmas.contains(lemma)), "{quoted:#?}");
    // All but the second polytope.
    assert_eq!(quoted.len() + 1, lemmas.len());
}
