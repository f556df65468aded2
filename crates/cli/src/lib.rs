//! The command line: arguments, terminal tables, files and exit codes; no mathematics.
//!
//! The program is [`main()`]. It is a library so that fuzzing can read words and certificates as the program does,
//! without a process for each: [`examine`], [`verdict_on`].

mod arguments;
mod commands;
mod drawing;
mod examining;
mod failure;
mod files;
mod manual;
mod output;
mod scanning;
mod verifying;

use std::process::ExitCode;

use clap::Parser;

use crate::arguments::Arguments;
pub use crate::examining::examine;
pub use crate::verifying::verdict_on;

/// Runs the command with which the process was called. Exit codes: 0 done, holds, agrees; 1 differs; 2 bad
/// usage or input.
pub fn main() -> ExitCode {
    // clap's own errors exit with 2, as ours do.
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => error.exit(),
    };
    match commands::run(&arguments) {
        Ok(code) => code,
        Err(failure) => {
            output::say(&failure.to_string());
            ExitCode::from(2)
        }
    }
}
