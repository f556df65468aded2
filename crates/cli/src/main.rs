//! The command line: arguments, terminal tables, files and exit codes; no mathematics.

mod arguments;
mod commands;
mod drawing;
mod failure;
mod files;
mod manual;
mod output;
mod scanning;

use std::process::ExitCode;

use clap::Parser;

use crate::arguments::Arguments;

/// Runs one command. Exit codes: 0 done, holds, agrees; 1 differs; 2 bad usage or input.
fn main() -> ExitCode {
    // clap's own errors exit with 2, as ours do.
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => error.exit(),
    };
    match commands::run(&arguments) {
        Ok(code) => code,
        Err(failure) => {
            failure.print();
            ExitCode::from(2)
        }
    }
}
