//! What is written about the program, followed as a reader follows it: from the root of the repository.

mod gallery;
mod help;
mod transcripts;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The root of the repository.
fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.join("../..").canonicalize().expect("the repository")
}

/// Runs lines of a shell, in which `refinable` is the program under test.
fn shell(script: &str, directory: &Path) -> Output {
    let program = Path::new(env!("CARGO_BIN_EXE_refinable")).parent().expect("a directory");
    let path = std::env::var("PATH").expect("a path");
    let mut command = Command::new("sh");
    command.args(["-e", "-c", script]).current_dir(directory);
    command.env("PATH", format!("{}:{path}", program.display())).output().expect("a shell")
}

/// What is printed by a script that succeeds.
fn printed(script: &str, directory: &Path) -> String {
    let output = shell(script, directory);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{script}\n{errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// The blocks between fences of a language in a Markdown file.
fn blocks(markdown: &str, language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    let parts = markdown.split(&fence).skip(1);
    parts.map(|part| part.split("```").next().expect("the block").to_string()).collect()
}
