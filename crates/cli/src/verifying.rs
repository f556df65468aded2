//! `verify`: certificates of either kind.

use std::path::PathBuf;
use std::process::ExitCode;

use refinable_certificate::{Certificate, MapCertificate, verify, verify_map};
use refinable_report::{proof_text, statement};

use crate::failure::Failure;
use crate::{files, output};

/// Checks one file after the other; the worst of them decides the exit code.
///
/// # Errors
/// A file that cannot be read, an output that cannot be written.
pub fn run(paths: &[PathBuf]) -> Result<ExitCode, Failure> {
    let mut worst = 0;
    for path in paths {
        let bytes = files::read_limited(path)?;
        let (code, verdict) = verdict_on(&bytes);
        worst = worst.max(code);
        output::print_text(&format!("{}: {verdict}\n", path.display()))?;
    }
    Ok(ExitCode::from(worst))
}

/// The exit code and the verdict on the bytes of a certificate, of either kind: 0 and `valid: …`, 1 and
/// `invalid: …`, 2 and `unreadable: …`.
///
/// # Cost
/// Bounded for each lemma, or piece of a map, by the limits in `docs/certificates.md`.
pub fn verdict_on(bytes: &[u8]) -> (u8, String) {
    let checked = if MapCertificate::is_meant(bytes) {
        MapCertificate::read(bytes).map(|map| {
            let statement = format!("map of C^{} of {}", map.continuity, map.family.name);
            verify_map(&map).map(|cells| format!("{statement}; {} pieces", cells.len()))
        })
    } else {
        Certificate::read(bytes).map(|certificate| {
            // A statement has no meaning before its ends are checked.
            let stated = |_| format!("{}; {}", statement(&certificate), proof_text(&certificate));
            verify(&certificate).map(stated)
        })
    };
    match checked {
        Ok(Ok(statement)) => (0, format!("valid: {statement}")),
        Ok(Err(invalid)) => (1, format!("invalid: {invalid}")),
        Err(unreadable) => (2, format!("unreadable: {unreadable}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ends that are no numbers are refused before anything is said about them.
    #[test]
    fn ends_of_strangers() {
        for (polynomial, between) in [
            (r#"["1","0","1"]"#, r#"["0","1"]"#),
            (r#"["-2","0","1"]"#, r#"["2","1"]"#),
            ("[]", r#"["0","1"]"#),
            (r#"["0"]"#, r#"["0","1"]"#),
            (r#"["2","-3","1"]"#, r#"["0","3"]"#),
        ] {
            let end = format!(r#"{{"root_of":{polynomial},"between":{between}}}"#);
            let text = format!(
                r#"{{"format":"refinable-certificate","version":1,"family":{{"name":"refinable-map-certificate",
                "arity":2,"parameter":"t","order":2,"lowest":0,"mask":[["1/4"],["3/4"],["3/4"],["1/4"]]}},
                "conclusion":{{"kind":"continuity","continuity":1,"proved":[{{"from":{end},"to":null,
                "ends":"[)"}}],"refuted":[]}},"lemmas":[{{"kind":"norm","level":1,"from":"0","to":"1"}}]}}"#
            );
            let (code, verdict) = verdict_on(text.as_bytes());
            assert!(code == 1 && verdict.starts_with("invalid: "), "{verdict}");
        }
    }

    /// A family that stays at one place of the line, or whose line is given by more than is needed, or by much more than
    /// is worked with: it is stated in the coordinate of the line.
    #[test]
    fn lines_of_strangers() {
        let verdict = |line: &str, from: &str| {
            let text = format!(
                r#"{{"format":"refinable-certificate","version":1,"family":{{"name":"x","arity":2,"parameter":"t",
                "order":3,"lowest":0,"mask":[["1/4"],["3/4"],["3/4"],["1/4"]],"curve":{{"parameter":"s",
                "mask":[["1/4"],["3/4"],["3/4"],["1/4"]],"denominator":["1"],"line":{line}}}}},"conclusion":
                {{"kind":"continuity","continuity":2,"proved":[],"refuted":[{{"from":{from},"to":{from},"ends":"[]"}}]}},
                "lemmas":[{{"kind":"word","pencil":"parameter","word":"0","from":null,"to":null}},
                {{"kind":"stable","except":[]}}]}}"#
            );
            let (code, verdict) = verdict_on(text.as_bytes());
            assert_eq!(code, 0, "{verdict}");
            verdict
        };
        let long = format!(r#"["1",{}"1"]"#, r#""0","#.repeat(1000));
        let root = r#"{"root_of":["-5","1"],"between":["4","6"]}"#;
        for (numerator, denominator, from) in [
            (r#"["5"]"#, r#"["1"]"#, r#""5""#),
            (r#"["5"]"#, r#"["1"]"#, root),
            ("[]", r#"["1"]"#, r#""0""#),
            (r#"["0","5"]"#, r#"["0","1"]"#, r#""5""#),
            (&long, r#"["1"]"#, r#""5""#),
        ] {
            let line = format!(r#"{{"numerator":{numerator},"denominator":{denominator}}}"#);
            let stated = verdict(&line, from);
            assert!(
                stated.contains("refuted on t = ") && stated.contains("in the coordinate"),
                "{stated}"
            );
        }
        // t = s²/s is s.
        let reducible = r#"{"numerator":["0","0","1"],"denominator":["0","1"]}"#;
        assert!(verdict(reducible, r#""5""#).contains("refuted on s = 5"));
    }
}
