//! Manual pages and completions, made of the same definitions as the help texts.

use std::collections::BTreeMap;

use clap::builder::Resettable;
use clap::{Command, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use crate::arguments::Arguments;

/// The program with all its commands, their full names filled in.
fn program() -> Command {
    let mut program = Arguments::command().disable_help_subcommand(true);
    program.build();
    program
}

/// The script by which a shell completes what is typed.
pub fn completions(shell: Shell) -> String {
    let mut script = Vec::new();
    generate(shell, &mut program(), "refinable", &mut script);
    String::from_utf8(script).expect("completions are text")
}

/// A manual page for the program and for each of its commands by its file name: `refinable.1`,
/// `refinable-range.1`, `refinable-report-build.1`.
pub fn pages() -> BTreeMap<String, String> {
    let mut pages = BTreeMap::new();
    let mut todo = vec![program()];
    while let Some(command) = todo.pop() {
        todo.extend(command.get_subcommands().cloned());
        let examples = command.get_after_help().map(ToString::to_string);
        let command = command.after_help(Resettable::Reset);
        let man = Man::new(command).source(concat!("refinable ", env!("CARGO_PKG_VERSION")));
        let mut page = Vec::new();
        man.render(&mut page).expect("memory can be written");
        let page = String::from_utf8(page).expect("pages are text");
        let examples = examples.as_deref().map_or_else(String::new, section_of_examples);
        pages.insert(man.get_filename(), page + &examples);
    }
    pages
}

/// Examples line by line, as they are typed: what stands below a help text would be filled like a paragraph.
fn section_of_examples(help: &str) -> String {
    let lines = help.lines().filter(|line| line.starts_with(' '));
    let mut section = Roff::new();
    section.control("SH", ["EXAMPLES"]).control("nf", []);
    section.text(lines.map(|line| roman(format!("{line}\n"))).collect::<Vec<_>>());
    // A straight quotation mark, as the rest of the page has it.
    section.control("fi", []).to_roff().replace('\'', "\\*(Aq")
}
