//! Full disks, and outputs that nobody reads.
#![cfg(target_os = "linux")]

use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

use crate::refinable;
use crate::writers::{OLD, WRITERS};

/// Runs the program where no file may grow beyond so many blocks of 512 bytes; writing more is an error.
fn with_small_files(blocks: u32, words: &[String]) -> Output {
    let script = format!("ulimit -f {blocks} && trap '' XFSZ && exec \"$0\" \"$@\"");
    Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_refinable")])
        .args(words)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("a shell")
}

/// Exit code 2 and a message; not a panic, which exits with 101.
fn failed(output: &Output, what: &[String]) -> String {
    let message = String::from_utf8(output.stderr.clone()).expect("text");
    assert_eq!(output.status.code(), Some(2), "{what:?}: {message}");
    assert!(!message.contains("panicked"), "{what:?}: {message}");
    message
}

#[test]
fn on_a_full_disk_the_old_file_stays() {
    for writer in &WRITERS {
        let dir = TempDir::new().expect("a directory");
        let file = dir.path().join(writer.file());
        fs::write(&file, OLD).expect("writable");
        let words = writer.words(dir.path());
        let message = failed(&with_small_files(0, &words), &words);
        assert!(
            message.contains("error[file]: ") && message.contains("File too large"),
            "{message}"
        );
        assert_eq!(fs::read(&file).expect("it is there"), OLD, "{words:?}");
        let count = fs::read_dir(dir.path()).expect("a directory").count();
        assert_eq!(count, 1, "{words:?} left something");
    }
}

/// A disk that is full half way through a scan loses no row of those that are written; with room again it goes on.
#[test]
fn a_scan_goes_on_when_there_is_room_again() {
    let dir = TempDir::new().expect("a directory");
    let scan = |name: &str| {
        let file = dir.path().join(name).display().to_string();
        let grid = "alpha=0..1/8:70,beta=-1/8..0:70";
        ["scan", "a3", "--what", "norm", "--grid", grid, "--resume", "-o", &file].map(String::from)
    };
    let run = |name: &str| refinable().args(scan(name)).output().expect("it runs");
    assert!(run("whole.csv").status.success());
    let whole = fs::read(dir.path().join("whole.csv")).expect("written");
    // Twice: what is there already cannot grow then.
    for _ in 0..2 {
        let message = failed(&with_small_files(100, &scan("full.csv")), &scan("full.csv"));
        assert!(message.contains("full.csv.part"), "{message}");
        let part = fs::read(dir.path().join("full.csv.part")).expect("it is kept");
        assert!(part.len() > 40_000 && whole.starts_with(&part), "{} bytes", part.len());
    }
    assert!(run("full.csv").status.success());
    assert!(fs::read(dir.path().join("full.csv")).expect("written") == whole);
}

/// A command that writes a directory in which one file stands already.
fn changes_nothing(words: &[&str], old: &str, blocks: u32) {
    let dir = TempDir::new().expect("a directory");
    fs::write(dir.path().join(old), OLD).expect("writable");
    let place = dir.path().display().to_string();
    let words = words.iter().map(|word| if *word == "DIR" { &place } else { *word });
    let words: Vec<String> = words.map(String::from).collect();
    failed(&with_small_files(blocks, &words), &words);
    assert_eq!(fs::read(dir.path().join(old)).expect("it is there"), OLD);
    let entries = fs::read_dir(dir.path()).expect("a directory").filter_map(Result::ok);
    assert_eq!(entries.filter(|entry| entry.path().is_file()).count(), 1, "{words:?}");
}

/// Some pages are longer than that, most are not.
#[test]
fn manual_pages_on_a_full_disk_change_nothing() {
    changes_nothing(&["man", "DIR"], "refinable-curve.1", 6);
}

#[test]
#[ignore = "a report takes minutes without optimisation"]
fn a_report_on_a_full_disk_changes_nothing() {
    let known = "../../reports/certificates";
    changes_nothing(&["report", "build", "DIR", "--certificates", known], "README.md", 200);
}

fn full() -> File {
    OpenOptions::new().write(true).open("/dev/full").expect("a device that is always full")
}

/// Everything that is printed, and what is printed about errors.
#[test]
fn a_full_output_is_an_error() {
    for words in [
        &["schemes"][..],
        &["schemes", "--format", "json"],
        &["show", "a4"],
        &["show", "a4", "--derive"],
        &["schema"],
        &["expect", "dd4"],
        &["export", "a5", "--to", "latex"],
        &["certify", "dd4"],
        &["curve", "bspline3", "../../examples/bracket.csv", "--closed"],
        &["scan", "a3", "--grid", "alpha=0..1:2,beta=0..1:2", "--what", "generation"],
        &["verify", "../../fuzz/corpus/certificate/dd2-87eb1575-C1"],
        &["tables", "--table", "masks-a-odd", "--level", "1"],
    ] {
        let output = refinable().args(words).stdout(full()).output().expect("it runs");
        let words: Vec<String> = words.iter().map(ToString::to_string).collect();
        let message = failed(&output, &words);
        assert!(message.contains("error[output]: No space left on device"), "{message}");
    }
    let status = refinable().args(["show", "nosuch"]).stderr(full()).status().expect("it runs");
    assert_eq!(status.code(), Some(2));
}

/// As in `refinable schemes | head -1`.
#[test]
fn a_pipe_that_is_closed_early_is_no_error() {
    for words in [
        &["schemes", "--format", "json"][..],
        &["curve", "bspline3", "../../examples/bracket.csv", "-l", "12"],
    ] {
        let mut child = refinable()
            .args(words)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it runs");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("piped")).read_line(&mut line).expect("a line");
        assert!(!line.is_empty());
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(0), "{words:?}");
        assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}
