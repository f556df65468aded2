//! Faults of the machine: a process that is killed, a disk that is full, an output that nobody reads. A file is
//! written whole or not at all, and the program says what went wrong.
//!
//! Only on Linux, where shells can limit the size of files and `/dev/full` is always full.
#![cfg_attr(not(target_os = "linux"), allow(dead_code, unused_imports))]

mod full;
mod killed;
mod writers;

use std::process::Command;

/// The program, at the root of the package.
fn refinable() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_refinable"));
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

#[cfg(not(target_os = "linux"))]
#[test]
fn skipped() {
    eprintln!("the faults are tested on Linux only");
}
