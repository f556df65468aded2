//! Killed at any moment.
#![cfg(target_os = "linux")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::refinable;
use crate::writers::{OLD, WRITERS, Writer};

/// How often each command is killed at a moment of its run, beside once when its temporary file appears.
const MOMENTS: usize = 3;

fn command(words: &[String]) -> Command {
    let mut command = refinable();
    command.args(words).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Fractions of one, always the same.
fn fractions() -> impl Iterator<Item = f64> {
    let next = |x: &u64| Some(x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1));
    std::iter::successors(Some(7), next).skip(1).map(|x| (x >> 11) as f64 / (1_u64 << 53) as f64)
}

fn names(dir: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(dir).expect("a directory");
    entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("text")).collect()
}

/// A process killed when the condition holds, if it has not ended before.
fn killed(words: &[String], mut when: impl FnMut() -> bool) {
    let mut child = command(words).spawn().expect("the program runs");
    while !when() && child.try_wait().expect("a process").is_none() {
        std::hint::spin_loop();
    }
    child.kill().and_then(|()| child.wait()).expect("it is killed");
}

/// Killed after this time.
fn killed_after(words: &[String], time: Duration) {
    let mut child = command(words).spawn().expect("the program runs");
    sleep(time);
    child.kill().and_then(|()| child.wait()).expect("it is killed");
}

fn is_temporary(name: &str) -> bool {
    name.starts_with(".refinable-") && name.ends_with(".tmp")
}

/// The old file or the new one, and beside it nothing that can be seen but what a scan keeps.
fn check(writer: &Writer, dir: &Path, new: &[u8]) {
    let words = &writer.words;
    let found = fs::read(dir.join(writer.file())).expect("the file is there");
    assert!(found == OLD || found == new, "{words:?}: {} bytes of {}", found.len(), new.len());
    let kept = ["part", "scan"].map(|end| format!("{}.{end}", writer.file()));
    for name in names(dir) {
        let kept = writer.goes_on() && kept.contains(&name);
        assert!(name == writer.file() || kept || is_temporary(&name), "{words:?} left {name}");
    }
}

#[test]
fn every_writer_leaves_the_old_file_or_the_new_one() {
    let mut fractions = fractions();
    for writer in &WRITERS {
        let dir = TempDir::new().expect("a directory");
        let words = writer.words(dir.path());
        let start = Instant::now();
        assert!(command(&words).status().expect("it runs").success(), "{words:?}");
        let time = start.elapsed();
        let new = fs::read(dir.path().join(writer.file())).expect("written");
        let once = |kill: &dyn Fn(&[String], &Path)| {
            let dir = TempDir::new().expect("a directory");
            fs::write(dir.path().join(writer.file()), OLD).expect("writable");
            let words = writer.words(dir.path());
            kill(&words, dir.path());
            check(writer, dir.path(), &new);
        };
        once(&|words, dir| killed(words, || names(dir).len() > 1));
        for fraction in fractions.by_ref().take(MOMENTS) {
            once(&|words, _| killed_after(words, time.mul_f64(fraction)));
        }
    }
}

/// Killed over and over, a scan goes on each time, and comes to the same file.
#[test]
fn a_scan_that_is_killed_goes_on() {
    let dir = TempDir::new().expect("a directory");
    let file = |name: &str| dir.path().join(name).display().to_string();
    let scan = |name: &str| {
        let grid = "alpha=0..1/8:139,beta=-1/8..0:99";
        ["scan", "a3", "--what", "norm", "--grid", grid, "--resume", "-o", &file(name)]
            .map(String::from)
    };
    let start = Instant::now();
    assert!(command(&scan("whole.csv")).status().expect("it runs").success());
    let time = start.elapsed();
    let whole = fs::read(file("whole.csv")).expect("written");
    let part = file("killed.csv.part");
    // After each chunk once, as soon as the file has grown.
    let size = || fs::metadata(&part).map_or(0, |found| found.len());
    for _ in 0..3 {
        let before = size();
        killed(&scan("killed.csv"), || size() > before.max(100));
    }
    for fraction in fractions().take(4) {
        killed_after(&scan("killed.csv"), time.mul_f64(fraction));
    }
    let finished = fs::read(file("killed.csv"));
    assert!(finished.is_err() || finished.is_ok_and(|found| found == whole));
    assert!(command(&scan("killed.csv")).status().expect("it runs").success());
    assert!(fs::read(file("killed.csv")).expect("written") == whole);
    let visible = names(dir.path()).into_iter().filter(|name| !is_temporary(name));
    assert_eq!(visible.collect::<Vec<_>>(), ["killed.csv", "whole.csv"]);
}
