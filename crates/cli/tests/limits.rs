//! The limits of commands from both sides: what is just admitted, and what is just refused, soon and with a
//! message. Those of the notation and of certificates are tested in their rooms; `docs/robustness.md` lists all.

use std::ffi::OsString;
use std::fs::File;
use std::process::{Command, Output, Stdio};

use refinable_cli::examine;
use tempfile::TempDir;

fn run(arguments: &[&str], stdin: Stdio) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_refinable"));
    command.args(arguments).stdin(stdin).output().expect("the program runs")
}

/// The message of a command that is refused.
fn refused(arguments: &[&str], stdin: Stdio) -> String {
    let output = run(arguments, stdin);
    let message = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    message
}

fn expect(arguments: &[&str], part: &str) {
    let message = refused(arguments, Stdio::null());
    assert!(message.contains(part), "{arguments:?}: {message}");
}

/// Words that are read, though nothing is computed from them.
fn understood(words: &[&str]) -> Result<(), String> {
    let words: Vec<OsString> = ["refinable"].iter().chain(words).map(OsString::from).collect();
    examine(&words)
}

#[test]
fn options_and_grids() {
    let grid = |steps: &str| {
        let grid = format!("alpha=0..1:9999,beta=0..1:{steps}");
        understood(&["scan", "a3", "--grid", &grid])
    };
    assert_eq!(grid("9999"), Ok(()));
    assert!(grid("10000").unwrap_err().contains("more than 100000000"));
    let arity = |arity| understood(&["show", "1+z", "--arity", arity]).unwrap_err();
    assert!(arity("64").contains("not-normalised") && arity("65").contains("2..=64"));
    let nodes = |nodes| understood(&["map", "a3", "-n", "0", "--nodes", nodes]);
    assert!(nodes("100000").is_ok() && nodes("100001").unwrap_err().contains("1..=100000"));
}

/// What is admitted fails for another reason, which is looked at later.
#[test]
fn counts_that_are_looked_at_first() {
    let sweep = |steps| {
        let sweep = format!("alpha=1..0:{steps}");
        refused(&["regularity", "a2", "--sweep", &sweep], Stdio::null())
    };
    assert!(sweep("4096").contains("1 is not less than 0"));
    assert!(sweep("4097").contains("a number from 1 to 4096"));
    expect(&["map", "dd4", "-n", "0..23"], "error[parameters]");
    expect(&["map", "dd4", "-n", "0..24"], "error[continuity]");
}

#[test]
fn points() {
    let dir = TempDir::new().expect("a directory");
    let path = dir.path().join("points.csv");
    let file = path.to_str().expect("text");
    let curve = ["curve", "bspline1", file, "--closed", "-l"];
    let of_dimension = |dimension: usize| {
        std::fs::write(&path, vec!["1"; dimension].join(",")).expect("writable");
        run(&[&curve[..], &["1"]].concat(), Stdio::null())
    };
    assert!(of_dimension(64).status.success());
    assert_eq!(of_dimension(65).status.code(), Some(2));
    std::fs::write(&path, "1\n").expect("writable");
    // A point in floats takes eight bytes: 2^28 of them are 2 GiB, which is admitted but not tried here.
    expect(&[&curve[..], &["29"]].concat(), "error[memory]: the result would take about 4 GiB");
    expect(&[&curve[..], &["48"]].concat(), "error[memory]");
    expect(&[&curve[..], &["49"]].concat(), "error[levels]");
    // A file of zeros that takes no room.
    let large = File::create(dir.path().join("large.csv")).expect("writable");
    large.set_len((256 << 20) + 1).expect("a large file");
    let large = File::open(dir.path().join("large.csv")).expect("readable");
    let message = refused(&["curve", "bspline1"], Stdio::from(large));
    assert!(message.contains("256 MiB are the most"), "{message}");
}

#[test]
fn basic_limit_functions() {
    assert!(run(&["basis", "bspline1", "-l", "12"], Stdio::null()).status.success());
    expect(&["basis", "bspline1", "-l", "13"], "12 levels are the most");
    let moved =
        |by| ["basis".to_string(), format!("shift(bspline1, {by})"), "-l".into(), "0".into()];
    let words = moved(999);
    assert!(run(&words.each_ref().map(String::as_str), Stdio::null()).status.success());
    expect(&moved(1000).each_ref().map(String::as_str), "indices up to 1000 do");
}

/// Nothing is searched for that no checker would read.
#[test]
fn proofs() {
    for words in [
        &["regularity", "dd44"][..],
        &["certify", "dd44", "-n", "1"],
        &["range", "combine(dd44, bspline3, w)", "-n", "1"],
    ] {
        expect(words, "error[budget]: a proof would have matrices of size above 40");
    }
    expect(&["norm", "dd4", "-n", "0", "--level", "20"], "error[budget]: level 20 needs more than");
}
