//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    refinable_cli::main()
}
