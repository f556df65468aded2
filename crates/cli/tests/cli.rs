//! The command line as it is used: transcripts in `cmd`, and what needs a directory to work in.

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

fn refinable() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_refinable"));
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

fn run(arguments: &[&str]) -> Output {
    refinable().args(arguments).output().expect("the program runs")
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("text")
}

fn json(arguments: &[&str]) -> Value {
    let output = run(&[arguments, &["--format", "json"]].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn transcripts() {
    trycmd::TestCases::new()
        .register_bin("refinable", Path::new(env!("CARGO_BIN_EXE_refinable")))
        .case("tests/cmd/*.trycmd");
}

/// The fields that scripts rely on.
#[test]
fn the_fields_of_every_document() {
    for (arguments, fields) in [
        (
            vec!["show", "a3"],
            vec!["name", "arity", "parameters", "support", "mask", "type", "support_width"],
        ),
        (vec!["degrees", "a3"], vec!["strata"]),
        (
            vec!["range", "i4", "--continuity", "1", "--level", "2"],
            vec![
                "scheme",
                "parameter",
                "continuity",
                "proved",
                "refuted",
                "undecided",
                "points",
                "exact",
            ],
        ),
        (
            vec!["map", "a3", "--continuity", "0", "--box", "alpha=0..1/4,beta=0..1/4"],
            vec!["scheme", "parameters", "continuity", "box", "coordinates", "cells", "area"],
        ),
        (vec!["tables", "--level", "1", "--table", "masks-a-odd"], vec!["tables"]),
    ] {
        let document = json(&arguments);
        for field in fields {
            assert!(!document[field].is_null(), "{field} of {arguments:?}");
        }
    }
    let stratum = json(&["degrees", "i4"])["strata"][1].clone();
    for field in ["condition", "parameters", "generation", "reproduction", "tau"] {
        assert!(!stratum[field].is_null(), "{field} of a stratum");
    }
    let cell =
        json(&["tables", "--level", "1", "--table", "norms"])["tables"][0]["cells"][0].clone();
    for field in ["row", "column", "claim", "finding", "agreement", "note"] {
        assert!(cell[field].is_string(), "{field} of a cell");
    }
}

/// A number: exact, enclosed, and as a float beside.
#[test]
fn numbers_are_exact_and_enclosed() {
    let range = json(&["range", "i4", "--continuity", "1", "--level", "2"]);
    let end = &range["proved"][0]["lo"];
    assert_eq!(end["exact"], "(1-sqrt(5))/8");
    let bound = |name: &str| fraction(end[name].as_str().expect("text"));
    assert!(bound("lower") < bound("upper") && bound("upper") - bound("lower") <= 1e-12);
    let approximate = end["approx"].as_f64().expect("a number");
    assert!((approximate - (1.0 - 5.0_f64.sqrt()) / 8.0).abs() < 1e-12);
    assert_eq!(range["undecided"][0]["lo"], Value::Null);
    // A cubic end has no radicals here.
    let range = json(&["range", "i4", "--continuity", "1", "--level", "3"]);
    let exact = range["proved"][0]["lo"]["exact"].as_str().expect("text").to_string();
    assert!(exact.starts_with("root(") && exact.contains("beta"), "{exact}");
}

fn fraction(text: &str) -> f64 {
    let number = |text: &str| text.parse::<f64>().expect("an integer");
    let (top, bottom) = text.split_once('/').unwrap_or((text, "1"));
    number(top) / number(bottom)
}

/// All formats of one table carry the same cells.
#[test]
fn every_format_prints_the_value() {
    for format in ["text", "json", "csv", "md", "latex"] {
        let output = run(&["degrees", "i4", "--format", format]);
        assert_eq!(code(&output), 0);
        assert!(stdout(&output).contains("16"), "{format}");
    }
}

#[test]
fn output_does_not_depend_on_the_number_of_threads() {
    let with_threads = |n: &str| {
        let mut command = refinable();
        command.env("RAYON_NUM_THREADS", n);
        command.args(["tables", "--table", "properties-interpolatory", "--level", "2"]);
        command.args(["--format", "json"]).output().expect("it runs")
    };
    let (one, two) = (with_threads("1"), with_threads("2"));
    assert_eq!((code(&one), code(&two)), (0, 0));
    assert!(!one.stdout.is_empty());
    assert!(one.stdout == two.stdout, "the outputs differ");
}

/// The files below a directory, sorted.
fn files(directory: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut todo = vec![directory.to_path_buf()];
    while let Some(next) = todo.pop() {
        for entry in fs::read_dir(next).expect("a directory") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                todo.push(path);
            } else {
                let name = path.strip_prefix(directory).expect("below");
                found.push(name.to_string_lossy().into_owned());
            }
        }
    }
    found.sort();
    found
}

/// The committed certificates: to check them takes seconds, to search for them minutes.
const KNOWN: [&str; 2] = ["--certificates", "../../reports/certificates"];

fn report(action: &str, directory: &Path) -> Output {
    let mut command = refinable();
    command.args(["report", action]).arg(directory).args(["--level", "1"]).args(KNOWN);
    command.output().expect("the program runs")
}

#[test]
fn a_report_is_built_checked_and_tampered_with() {
    let directory = TempDir::new().expect("a directory");
    let place = directory.path().join("new/report");
    // Nothing to check yet.
    let missing = report("check", &place);
    assert_eq!(code(&missing), 2);
    assert!(stderr(&missing).contains("report build"), "{}", stderr(&missing));
    assert_eq!(code(&report("build", &place)), 0);
    let built = files(&place);
    assert!(built.iter().any(|name| name.ends_with(".json")), "{built:?}");
    let fresh = report("check", &place);
    assert_eq!((code(&fresh), stdout(&fresh).as_str()), (0, ""));
    // Building again changes nothing, and leaves files written by hand alone.
    fs::write(place.join("NOTES.md"), "by hand\n").expect("writable");
    assert_eq!(code(&report("build", &place)), 0);
    assert_eq!(fs::read_to_string(place.join("NOTES.md")).expect("readable"), "by hand\n");

    // One file with another line, one cut short, one missing, one too many.
    let changed = "tables/continuity-a-even.csv";
    let text = fs::read_to_string(place.join(changed)).expect("readable");
    let third = text.lines().nth(2).expect("three lines");
    fs::write(place.join(changed), text.replacen(third, "something else", 1)).expect("writable");
    let short = place.join("tables/norms.csv");
    let text = fs::read_to_string(&short).expect("readable");
    fs::write(&short, text.trim_end()).expect("writable");
    fs::remove_file(place.join("tables/norms.md")).expect("removable");
    fs::write(place.join("tables/stray.csv"), "").expect("writable");
    let tampered = report("check", &place);
    assert_eq!(code(&tampered), 1);
    let lines = stdout(&tampered);
    assert!(lines.starts_with(&format!("{changed}: line 3\n")), "{lines}");
    assert!(lines.contains("something else") && lines.contains(third), "{lines}");
    assert!(lines.contains("tables/norms.csv: "), "{lines}");
    assert!(lines.contains("tables/norms.md: missing\n"), "{lines}");
    assert!(lines.contains("tables/stray.csv: not part of the report\n"), "{lines}");
}

/// A directory that is a file, so that no permission is needed to make it fail.
#[test]
fn an_unwritable_directory_is_left_alone() {
    let directory = TempDir::new().expect("a directory");
    let place = directory.path().join("report");
    fs::write(&place, "a file").expect("writable");
    let output = report("build", &place);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).starts_with("error[file]: "), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&place).expect("readable"), "a file");
    assert_eq!(files(directory.path()), ["report"]);
}

/// The obstacle is met half way: no file has been written by then, nor is one left over.
#[test]
fn a_failure_half_way_writes_nothing() {
    let directory = TempDir::new().expect("a directory");
    fs::write(directory.path().join("tables"), "in the way").expect("writable");
    let output = report("build", directory.path());
    assert_eq!(code(&output), 2);
    assert_eq!(files(directory.path()), ["tables"]);
}

#[cfg(unix)]
#[test]
fn an_argument_that_is_no_text_is_bad_usage() {
    use std::os::unix::ffi::OsStringExt;
    let argument = OsString::from_vec(vec![b'a', 0xff, b'4']);
    let output = refinable().arg("show").arg(argument).output().expect("the program runs");
    assert_eq!(code(&output), 2);
    assert!(output.stdout.is_empty() && !output.stderr.is_empty());
}

/// Bad usage prints nothing on standard output and exits with 2.
#[test]
fn failures_go_to_standard_error() {
    for arguments in [
        &["show", "nosuch"][..],
        &["show", "[]"],
        &["show", ""],
        &["show"],
        &["frobnicate"],
        &["range", "a3", "--continuity", "1"],
        &["range", "bspline3", "--continuity", "1"],
        &["range", "i4", "--continuity", "-1"],
        &["range", "i4", "--continuity", "1", "--level", "0"],
        &["range", "i4", "--continuity", "1", "--level", "4000000000"],
        &["range", "i4", "--continuity", "99999"],
        &["degrees", "a99999999999999999999999999"],
        &["show", "i4", "--set", "beta=1/0"],
        &["show", "i4", "--set", "gamma=1"],
        &["show", "i4", "--set", "beta"],
        &["show", "[1/w, 1/2, 1-2/w, 1/2, 1/w]", "--set", "w=0"],
        &["show", "a4", "--arity", "3"],
        &["show", "[1, 1]", "--arity", "1"],
        &["show", "a4", "--format", "yaml"],
        &["tables", "--table", "nosuch"],
        &["tables", "--claims", "no-such-file.toml"],
        &["tables", "--claims", "tests/cmd/malformed.toml"],
        &["report", "check", "no-such-directory"],
    ] {
        let output = run(arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}: {}", stdout(&output));
        assert!(stderr(&output).contains("error"), "{arguments:?}: {}", stderr(&output));
        assert!(!stderr(&output).contains("panicked"), "{arguments:?}: {}", stderr(&output));
    }
}

/// One true claim and one false one about a mask that no catalogue knows.
#[test]
fn claims_about_a_mask_of_ones_own() {
    let document = json(&["tables", "--claims", "tests/cmd/claims.toml", "--level", "2"]);
    let cells = document["tables"][0]["cells"].as_array().expect("cells");
    let verdicts: Vec<_> = cells.iter().map(|cell| cell["agreement"].as_str().unwrap()).collect();
    assert_eq!(verdicts, ["agrees", "disagrees"]);
}

/// Cut off at any byte, a scan goes on to the same file; another scan does not continue it.
#[test]
fn an_interrupted_scan_goes_on() {
    let dir = TempDir::new().unwrap();
    let path = dir.path().join("scan.csv");
    let file = path.to_str().unwrap();
    let scan = |grid: &str, rest: &[&str]| {
        let arguments = ["scan", "a3", "--grid", grid, "-o", file];
        run(&[&arguments[..], rest].concat())
    };
    let grid = "alpha=0..1/4:12,beta=-1/8..1/8:9";
    assert!(scan(grid, &[]).status.success());
    let whole = fs::read(&path).unwrap();
    assert_eq!(whole.iter().filter(|&&byte| byte == b'\n').count(), 1 + 13 * 10);
    let part = dir.path().join("scan.csv.part");
    let note = dir.path().join("scan.csv.scan");
    assert!(!part.exists() && !note.exists());
    // What a scan in progress leaves: some of its rows, and a note of what they are.
    let version = env!("CARGO_PKG_VERSION");
    let signature = format!("{version}: a3 [] arity 2, {grid}, Continuity, lines false\n");
    fs::remove_file(&path).unwrap();
    fs::create_dir(&path).unwrap();
    assert_eq!(code(&scan(grid, &[])), 2);
    assert!(!part.exists() && !note.exists());
    fs::remove_dir(&path).unwrap();
    for length in [0, 5, 30, 31, 200, whole.len() - 1, whole.len()] {
        fs::write(&part, &whole[..length]).unwrap();
        fs::write(&note, &signature).unwrap();
        // Not by accident, and not by another command.
        assert_eq!(scan(grid, &[]).status.code(), Some(2));
        assert_eq!(scan("alpha=0..1/4:12,beta=-1/8..1/8:8", &["--resume"]).status.code(), Some(2));
        let found = scan(grid, &["--resume"]);
        assert!(found.status.success(), "{length}: {found:?}");
        assert_eq!(fs::read(&path).unwrap(), whole, "cut off at {length}");
        assert!(!part.exists() && !note.exists());
    }
}

/// What is printed for points that are piped in.
fn piped(arguments: &[&str], input: &[u8]) -> Output {
    use std::io::Write;
    use std::process::Stdio;
    let mut child = refinable()
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    // A program that stops early closes the pipe.
    let _ = child.stdin.take().expect("piped").write_all(input);
    child.wait_with_output().expect("the program ends")
}

#[test]
fn points_from_a_pipe() {
    let chaikin = ["curve", "bspline2", "--levels", "1"];
    let output = piped(&chaikin, b"\xef\xbb\xbf0,0\r\n4,0\r\n4,4\r\n");
    assert_eq!((code(&output), stdout(&output)), (0, "x,y\n1,0\n3,0\n4,1\n4,3\n".into()));
    let from_json = piped(&[&chaikin[..], &["-"]].concat(), b"[[0, 0], [4, 0], [4, 4]]");
    assert_eq!(from_json.stdout, output.stdout);
    for (input, expected) in [
        (&b""[..], "error[points]: there is no point"),
        (b"1,2\n3,nan\n", "error[points]: line 2: `nan` is no number"),
        (b"1,2\n3\n", "error[points]: line 2: 1 numbers, but 2 before"),
        (b"1,2\n\xff\xfe\n", "error[points]: line 2: this is no text"),
        (b"1,2\n", "error[points]: too few points for the stencils of the scheme: 1"),
    ] {
        let output = piped(&chaikin, input);
        assert_eq!(code(&output), 2, "{}", stdout(&output));
        assert!(stderr(&output).starts_with(expected), "{}", stderr(&output));
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn coordinates_beyond_floats_are_refused() {
    let points = b"-1.7e308,0\n1.7e308,0\n1.7e308,0\n-1.7e308,0\n";
    let output = piped(&["curve", "dd4", "--levels", "1"], points);
    assert_eq!((code(&output), stdout(&output)), (2, String::new()));
    assert!(stderr(&output).starts_with("error[overflow]"), "{}", stderr(&output));
    let exact = piped(&["curve", "dd4", "--levels", "1", "--exact"], points);
    assert_eq!(code(&exact), 0);
}

/// Each kind of file by its first bytes; nothing is left behind where writing fails.
#[test]
fn curves_and_surfaces_in_files() {
    let dir = TempDir::new().unwrap();
    let at = |name: &str| dir.path().join(name).display().to_string();
    let curve = ["curve", "bspline3", "../../examples/bracket.csv", "--closed"];
    let surface =
        ["surface", "bspline3", "../../examples/vessel.csv", "--closed", "rows", "-l", "2"];
    let basis = ["basis", "dd4"];
    let cases: [(&[&str], &str, &[u8]); 9] = [
        (&curve, "c.svg", b"<svg "),
        (&curve, "c.png", b"\x89PNG"),
        (&curve, "c.csv", b"x,y\n"),
        (&curve, "c.json", b"{\n  \"scheme\""),
        (&basis, "b.svg", b"<svg "),
        (&surface, "s.png", b"\x89PNG"),
        (&surface, "s.obj", b"v "),
        (&surface, "s.ply", b"ply\nformat binary_little_endian 1.0\n"),
        (&surface, "s.stl", &[0; 80]),
    ];
    for (arguments, name, start) in cases {
        let output = run(&[arguments, &["-o", &at(name)]].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(output.stdout.is_empty());
        assert!(fs::read(at(name)).unwrap().starts_with(start), "{name}");
        let nowhere = at(&format!("none/{name}"));
        let output = run(&[arguments, &["-o", &nowhere]].concat());
        assert_eq!(code(&output), 2);
        assert!(stderr(&output).contains("is no directory"), "{}", stderr(&output));
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), cases.len());
    let curve = json(&[&curve[..], &["--levels", "0"]].concat());
    assert_eq!(curve["points"][2], serde_json::json!([5.0, 5.0]));
    let basis = json(&["basis", "dd4", "--levels", "0"]);
    assert_eq!(basis["values"][3]["values"][0]["exact"], "1");
}
