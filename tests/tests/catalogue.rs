//! The catalogue's scheme files against their sources, and scheme files that are wrong.

use std::fs;
use std::path::PathBuf;

use refinable_report::{Checked, check, expected_file};
use refinable_scheme::{Scheme, SchemeFile};

fn files() -> Vec<(String, SchemeFile)> {
    let dir = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../crates/scheme/catalogue");
    let mut paths: Vec<PathBuf> = fs::read_dir(dir).unwrap().map(|e| e.unwrap().path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let file = SchemeFile::parse(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        (path.display().to_string(), file)
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn the_catalogue_is_as_its_sources_say() {
    let files = files();
    assert!(files.len() >= 25, "{}", files.len());
    for (path, file) in files {
        assert!(file.scheme.source().is_some(), "{path}");
        let checked = check(&file).unwrap();
        assert!(!checked.is_empty(), "{path} expects nothing");
        for c in checked {
            assert!(c.holds(), "{path}: {}: {} expected, {} found", c.what, c.expected, c.found);
            let source = c.source.unwrap_or_default();
            assert!(
                source.len() > 10 && source != "computed",
                "{path}: {} without a source",
                c.what
            );
        }
    }
}

/// What is written by `expect` is found again, and what is changed is not.
#[test]
fn expectations_are_kept_and_differences_found() {
    for text in ["dd6", "i4", "bspline2", "pseudo(3, 1)", "[1, 1]", "a2"] {
        let written = expected_file(&Scheme::resolve(text, 2).unwrap());
        let file = SchemeFile::parse(&written).unwrap();
        let checked = check(&file).unwrap();
        assert!(checked.len() >= 4 && checked.iter().all(Checked::holds), "{text}: {written}");
    }
    let dd6 = expected_file(&Scheme::resolve("dd6", 2).unwrap());
    for (from, to, what) in [
        ("support = [-5, 5]", "support = [-5, 4]", "support"),
        ("generation = 5", "generation = 4", "generation"),
        ("reproduction = 5", "reproduction = 6", "reproduction"),
        ("continuity = 2", "continuity = 3", "continuity"),
        ("log2(9/8)", "log2(8/9)", "holder"),
        ("\"interpolatory\"", "\"approximating\"", "type"),
    ] {
        assert!(dd6.contains(from), "{dd6}");
        let file = SchemeFile::parse(&dd6.replace(from, to)).unwrap();
        let missed: Vec<String> =
            check(&file).unwrap().into_iter().filter(|c| !c.holds()).map(|c| c.what).collect();
        assert_eq!(missed, [what], "{to}");
    }
}

#[test]
fn scheme_files_that_are_wrong() {
    let head = "name = 'x'\nmask = '[1/2, 1, 1/2]'\n";
    for (text, code, line, message) in [
        ("".to_string(), "file", 1, "missing field `name`"),
        ("name = 'x'".into(), "file", 1, "missing field `mask`"),
        ("name = ".into(), "file", 1, ""),
        (format!("{head}colour = 'red'"), "file", 3, "unknown field `colour`"),
        (format!("{head}[[expect]]\nsmoothness = 3"), "file", 4, "unknown field `smoothness`"),
        (format!("{head}[[expect]]\nsupport = [1]"), "file", 4, ""),
        (format!("{head}[[expect]]\ncontinuity = -1"), "file", 4, ""),
        // The mask is shown alone.
        ("name = 'x'\nmask = '[1/2, 1'".into(), "syntax", 1, "the list is not closed"),
        ("name = 'x'\nmask = '[1, 2, 1]'".into(), "not-normalised", 0, "every stencil"),
        (format!("{head}set = ['w=1']"), "substitution", 0, "the scheme has no parameter `w`"),
    ] {
        let error = SchemeFile::parse(&text).unwrap_err();
        // From one; zero for what is wrong with the whole.
        let place =
            error.excerpt().map_or(0, |(text, span)| text[..span.start].matches('\n').count() + 1);
        assert_eq!((error.code(), place), (code, line), "{text}: {error}");
        assert!(error.message().starts_with(message), "{text}: {error}");
    }
    let file =
        SchemeFile::parse(&format!("{head}[[expect]]\nset = ['w=1']\nsupport = [0, 1]")).unwrap();
    assert_eq!(check(&file).unwrap_err().code(), "substitution");
}
