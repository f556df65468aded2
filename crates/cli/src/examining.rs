//! Words read as a command as far as that goes without work and without a file.

use std::ffi::OsString;

use clap::Parser;
use refinable_report::{Quantity, Scan};
use refinable_scheme::Substitution;

use crate::arguments::{Arguments, Command, InterproximateArguments, SchemeArguments};
use crate::commands::{fineness, resolve, resolve_text, sharpness};
use crate::drawing::{factors, member};
use crate::failure::Failure;

/// Reads words, the first of which is the name of the program, as it reads what was typed: the command and its
/// options, the schemes with what is set, grids, gaps and tensions. Nothing is computed from them, and no file is
/// opened; a scheme in a file is left alone.
///
/// # Errors
/// What the program would print: help as well, where that was asked for.
pub fn examine(words: &[OsString]) -> Result<(), String> {
    let arguments = Arguments::try_parse_from(words).map_err(|error| error.to_string())?;
    if words.iter().any(|word| word.to_string_lossy().contains(".toml")) {
        return Ok(());
    }
    understand(&arguments.command).map_err(|failure| failure.to_string())
}

fn understand(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Range { scheme, gap, .. } => {
            resolve(scheme)?;
            sharpness(gap).map(drop)
        }
        Command::Map { scheme, map, drawing, .. } => {
            resolve(scheme)?;
            fineness(&map.fineness)?;
            Ok(drawing.curves.iter().try_for_each(|curve| Substitution::parse(curve).map(drop))?)
        }
        Command::Explore { scheme, fineness: fine, .. } => {
            resolve(scheme)?;
            fineness(fine).map(drop)
        }
        // Of all quantities this one needs nothing in advance.
        Command::Scan { scheme, grid, .. } => {
            Ok(Scan::new(&resolve(scheme)?, grid, Quantity::Generation).map(drop)?)
        }
        Command::Surface(arguments) => factors(arguments).map(drop),
        Command::Interproximate(arguments) => tensions(arguments),
        Command::Compare { schemes, arity, .. } => {
            schemes.iter().try_for_each(|text| resolve_text(text, *arity, &[]).map(drop))
        }
        other => scheme_of(other).map_or(Ok(()), |scheme| resolve(scheme).map(drop)),
    }
}

/// The scheme of a command about a single one.
fn scheme_of(command: &Command) -> Option<&SchemeArguments> {
    match command {
        Command::Show { scheme, .. }
        | Command::Degrees { scheme, .. }
        | Command::Regularity { scheme, .. }
        | Command::Basis { scheme, .. }
        | Command::Certify { scheme, .. }
        | Command::Analyze { scheme, .. }
        | Command::Expect { scheme }
        | Command::Export { scheme, .. }
        | Command::Norm { scheme, .. } => Some(scheme),
        Command::Curve(arguments) => Some(&arguments.scheme),
        _ => None,
    }
}

fn tensions(arguments: &InterproximateArguments) -> Result<(), Failure> {
    let family = resolve(&arguments.scheme)?;
    let given = [&arguments.interpolating, &arguments.approximating];
    given.into_iter().flatten().try_for_each(|text| member(&family, text).map(drop))
}
