//! The commands beside the figures of the committed report, run as they stand there.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

#[test]
fn figures_can_be_drawn_by_the_commands_beside_them() {
    let figures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports/figures");
    let folder = TempDir::new().expect("a folder");
    for entry in fs::read_dir(&figures).expect("the figures") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|end| end == "csv") {
            let copy = folder.path().join(path.file_name().expect("a file"));
            fs::copy(&path, copy).expect("writable");
        }
    }
    let page = fs::read_to_string(figures.join("README.md")).expect("readable");
    let commands: Vec<&str> =
        page.lines().filter_map(|line| line.strip_prefix("refinable ")).collect();
    for command in &commands {
        let words: Vec<&str> = command.split(' ').collect();
        let mut program = Command::new(env!("CARGO_BIN_EXE_refinable"));
        let output = program.args(&words).current_dir(folder.path()).output().expect("it runs");
        let problem = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{command}: {problem}");
        if let Some(k) = words.iter().position(|word| *word == "-o") {
            let drawn = fs::read_to_string(folder.path().join(words[k + 1])).expect("a picture");
            assert!(drawn.starts_with("<svg"), "{command}");
        }
    }
    // Every figure has some.
    assert_eq!(page.matches("\n```sh\nrefinable ").count(), page.matches("\n## ").count());
    assert!(commands.len() > 80, "{}", commands.len());
}
