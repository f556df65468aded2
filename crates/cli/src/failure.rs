//! Errors as they are printed.

use std::fmt;
use std::io;
use std::path::Path;

use refinable_papers::ClaimsError;
use refinable_scheme::Diagnostic;

/// Something wrong with usage, input or files: exit code 2.
#[derive(Debug)]
pub struct Failure(Diagnostic);

impl Failure {
    /// An error with a hint.
    pub fn new(code: &'static str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Failure(Diagnostic::new(code, message).with_hint(hint))
    }

    /// A file or directory that cannot be read or written.
    pub fn file(path: &Path, error: &io::Error) -> Self {
        let diagnostic = Diagnostic::new("file", format!("{}: {error}", path.display()));
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "relative paths begin where the program is run",
            io::ErrorKind::PermissionDenied => "choose another place, or ask who owns this one",
            io::ErrorKind::StorageFull => "make room, or choose another disk",
            _ => return Failure(diagnostic),
        };
        Failure(diagnostic.with_hint(hint))
    }
}

/// `error[code]: message`, the place, then `hint:`, with the colours of a terminal.
impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.0.styled())
    }
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Self {
        Failure(diagnostic)
    }
}

impl From<ClaimsError> for Failure {
    fn from(error: ClaimsError) -> Self {
        Failure::new("claims", error.to_string(), "docs/claims.md describes the format")
    }
}
