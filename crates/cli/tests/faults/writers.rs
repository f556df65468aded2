//! All commands that write files.

use std::path::Path;

use crate::refinable;

/// What stood there before.
pub const OLD: &[u8] = b"what was there before\n";

/// A command that writes a file: what comes before the file's name, and the end of the name.
pub struct Writer {
    pub words: &'static [&'static str],
    pub end: &'static str,
}

const fn writer(words: &'static [&'static str], end: &'static str) -> Writer {
    Writer { words, end }
}

const BRACKET: &str = "../../examples/bracket.csv";
const VESSEL: &str = "../../examples/vessel.csv";

/// One for each option that names a file to be written, small enough to take some hundredths of a second.
pub const WRITERS: [Writer; 14] = [
    writer(&["show", "a3", "-o"], "svg"),
    writer(&["show", "a3", "-o"], "png"),
    writer(&["regularity", "a2", "--sweep", "alpha=0..1/4:2", "-o"], "svg"),
    writer(
        &["map", "a3", "-n", "0", "--box", "alpha=0..1/4,beta=0..1/4", "--nodes", "9", "-o"],
        "svg",
    ),
    writer(
        &[
            "map",
            "a3",
            "-n",
            "0",
            "--box",
            "alpha=0..1/4,beta=0..1/4",
            "--nodes",
            "9",
            "--certificate",
        ],
        "json",
    ),
    writer(&["explore", "dd4", "-o"], "html"),
    writer(&["curve", "bspline3", BRACKET, "--closed", "-l", "6", "-o"], "csv"),
    writer(&["curve", "bspline3", BRACKET, "--closed", "-o"], "svg"),
    writer(&["surface", "bspline3", VESSEL, "--closed", "rows", "-l", "3", "-o"], "stl"),
    writer(&["basis", "dd4", "-l", "4", "-o"], "json"),
    writer(
        &["interproximate", "a5", BRACKET, "--approximating", "alpha=1/8,beta=0", "--closed", "-o"],
        "csv",
    ),
    writer(&["certify", "dd4", "-o"], "json"),
    writer(&["export", "a5", "--to", "sympy", "-o"], "py"),
    writer(
        &["scan", "a3", "--grid", "alpha=0..1/8:70,beta=-1/8..0:70", "--what", "norm", "-o"],
        "csv",
    ),
];

impl Writer {
    /// The name of its file in a directory.
    pub fn file(&self) -> String {
        format!("file.{}", self.end)
    }

    /// All words, with the file in the directory.
    pub fn words(&self, dir: &Path) -> Vec<String> {
        let file = dir.join(self.file()).display().to_string();
        self.words.iter().map(ToString::to_string).chain([file]).collect()
    }

    /// Whether it keeps what it has written so far beside the file.
    pub fn goes_on(&self) -> bool {
        self.words[0] == "scan"
    }
}

/// What the list leaves out writes a whole directory: its writer is killed in a unit test.
#[test]
fn no_writer_is_left_out() {
    let help = |words: &[&str]| {
        let output = refinable().args(words).arg("--help").output().expect("it runs");
        String::from_utf8(output.stdout).expect("text")
    };
    let overview = help(&[]);
    let commands = overview.lines().skip_while(|line| *line != "Commands:").skip(1);
    let commands = commands.take_while(|line| !line.is_empty());
    // Lines that go on are indented more.
    let names = commands.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names: Vec<&str> = names.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.contains(&"export") && names.contains(&"report"), "{names:?}");
    for name in names {
        let options = help(&[name]);
        for option in ["--output", "--certificate "] {
            let writes = options.contains(option);
            let short = if option == "--output" { "-o" } else { option.trim_end() };
            let found = |w: &Writer| w.words[0] == name && w.words.last() == Some(&short);
            assert_eq!(writes, WRITERS.iter().any(found), "{name} {option}");
        }
    }
}
