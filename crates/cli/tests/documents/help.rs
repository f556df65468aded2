//! Help texts, manual pages and completions.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use tempfile::TempDir;

use crate::{printed, root, shell};

/// The commands that a help text lists, with what stands before them; but for `help` itself.
fn commands(of: &str) -> Vec<String> {
    let help = printed(&format!("refinable {of} --help"), &root());
    let list = help.split_once("\nCommands:\n").map_or("", |(_, rest)| rest);
    let lines = list.lines().take_while(|line| !line.is_empty());
    let names = lines.filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(|name| format!("{of} {name}").trim().into()).collect()
}

/// Every command, those of `report` as well.
fn all_commands() -> Vec<String> {
    let mut all = commands("");
    assert!(all.contains(&"range".to_string()), "{all:?}");
    let nested: Vec<String> = all.iter().flat_map(|name| commands(name)).collect();
    all.extend(nested);
    all
}

/// Work of a minute and more.
const LONG: [&str; 3] = ["report", "report build", "report check"];

/// A short text, a longer one, and examples that run.
#[test]
fn every_help_has_examples_that_run() {
    let directory = TempDir::new().unwrap();
    fs::create_dir(directory.path().join("examples")).unwrap();
    for entry in fs::read_dir(root().join("examples")).unwrap() {
        let entry = entry.unwrap();
        let place = directory.path().join("examples").join(entry.file_name());
        fs::copy(entry.path(), place).unwrap();
    }
    for name in all_commands().iter().map(String::as_str).chain([""]) {
        let help = printed(&format!("refinable {name} --help"), directory.path());
        let (text, examples) = help.split_once("\nExamples:\n").expect(name);
        let about = text.split("\n\n").take_while(|part| !part.starts_with("Usage:"));
        assert_eq!(about.count(), 2, "{name}: a short description and a longer one\n{text}");
        assert!(examples.contains(&format!("refinable {name}")), "{name}: {examples}");
        if !LONG.contains(&name) {
            printed(examples, directory.path());
        }
    }
}

#[test]
fn every_command_has_a_manual_page() {
    let directory = TempDir::new().unwrap();
    let place = directory.path().join("man1");
    printed(&format!("refinable man {}", place.display()), &root());
    let pages: BTreeSet<String> = fs::read_dir(&place)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let page = |name: &str| format!("refinable-{}.1", name.replace(' ', "-"));
    let mut expected: BTreeSet<String> = all_commands().iter().map(|name| page(name)).collect();
    expected.insert("refinable.1".into());
    assert_eq!(pages, expected);
    for name in pages {
        let text = fs::read_to_string(place.join(&name)).unwrap();
        for section in
            [".TH refinable", ".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH EXAMPLES"]
        {
            assert!(text.contains(section), "{name}: {section}");
        }
    }
    // A file in the way: nothing is written.
    let file = directory.path().join("file");
    fs::write(&file, "in the way").unwrap();
    let output = shell(&format!("refinable man {}", file.display()), &root());
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(fs::read_to_string(&file).unwrap(), "in the way");
}

#[test]
fn completions_name_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = printed(&format!("refinable completions {shell}"), &root());
        for command in all_commands() {
            let name = command.split(' ').next_back().expect("a name");
            assert!(script.contains(name), "{shell}: {command}");
        }
    }
    let accepted = |shell: &str| {
        let script = printed(&format!("refinable completions {shell}"), &root());
        let mut command = Command::new(shell);
        command.args(["-n", "-c", &script]).status().is_ok_and(|status| status.success())
    };
    for shell in ["bash", "zsh", "fish"] {
        if Command::new(shell).arg("--version").output().is_ok() {
            assert!(accepted(shell), "{shell} does not read its completions");
        }
    }
}
