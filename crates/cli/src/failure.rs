//! Errors as they are printed.

use std::fmt;
use std::io;
use std::path::Path;

use refinable_papers::ClaimsError;
use refinable_scheme::Diagnostic;

/// Something wrong with usage, input or files: exit code 2.
#[derive(Debug)]
pub struct Failure {
    code: &'static str,
    message: String,
    hint: Option<String>,
}

impl Failure {
    /// An error with a hint.
    pub fn new(code: &'static str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Failure { code, message: message.into(), hint: Some(hint.into()) }
    }

    /// A file or directory that cannot be read or written.
    pub fn file(path: &Path, error: &io::Error) -> Self {
        Failure { code: "file", message: format!("{}: {error}", path.display()), hint: None }
    }
}

/// `error[code]: message`, then `hint:`.
impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "error[{}]: {}", self.code, self.message)?;
        self.hint.iter().try_for_each(|hint| writeln!(f, "hint: {hint}"))
    }
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Self {
        Failure {
            code: diagnostic.code(),
            message: diagnostic.to_string(),
            hint: diagnostic.hint().map(String::from),
        }
    }
}

impl From<ClaimsError> for Failure {
    fn from(error: ClaimsError) -> Self {
        Failure::new("claims", error.to_string(), "docs/claims.md describes the format")
    }
}
