//! The committed certificates: all hold, and none holds when its statement is changed.

use std::fs;
use std::path::Path;

use refinable_certificate::{
    Certificate, Conclusion, Interval, MapCertificate, verify, verify_map,
};

/// Those of maps, or the others.
fn committed(maps: bool) -> Vec<(String, Vec<u8>)> {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reports/certificates");
    let mut files: Vec<_> = fs::read_dir(dir)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.to_string_lossy().contains("/map-") == maps)
        .map(|path| (path.display().to_string(), fs::read(&path).unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn all_committed_certificates_hold() {
    let files = committed(false);
    assert!(files.len() > 50, "only {} certificates", files.len());
    for (name, bytes) in files {
        let certificate = Certificate::read(&bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
        verify(&certificate).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
    let maps = committed(true);
    assert!(maps.len() > 12, "only {} maps", maps.len());
    for (name, bytes) in maps {
        let map = MapCertificate::read(&bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
        verify_map(&map).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

/// What is proved, claimed to be refuted, and the other way round.
#[test]
fn no_certificate_proves_the_opposite() {
    let small = committed(false).into_iter().filter(|(_, bytes)| bytes.len() < 20_000);
    let mut changed = 0;
    for (name, bytes) in small {
        let mut certificate = Certificate::read(&bytes).unwrap();
        let Conclusion::Continuity { proved, refuted, .. } = &mut certificate.conclusion else {
            continue;
        };
        let long = |intervals: &[Interval]| !intervals.is_empty();
        if !long(proved) && !long(refuted) {
            continue;
        }
        std::mem::swap(proved, refuted);
        changed += 1;
        assert!(verify(&certificate).is_err(), "{name}");
    }
    assert!(changed > 20, "only {changed} certificates were changed");
}
