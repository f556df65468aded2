//! What can be wrong with a certificate.

use std::fmt;

use thiserror::Error;

/// Why a file was not read.
#[derive(Clone, PartialEq, Eq, Debug, Error)]
pub enum Unreadable {
    /// It is larger than a limit allows; the text says which.
    #[error("too large: {0}")]
    TooLarge(String),
    /// It is not JSON of the right shape.
    #[error("not a certificate: {0}")]
    Malformed(String),
}

/// Why a certificate proves nothing.
#[derive(Clone, PartialEq, Eq, Debug, Error)]
#[error("{part}: {reason}")]
pub struct Invalid {
    /// What fails.
    pub part: Part,
    /// Why, in a short sentence.
    pub reason: String,
}

/// A part of a certificate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Part {
    /// The family.
    Family,
    /// The curve of the family.
    Curve,
    /// A lemma.
    Lemma {
        /// Its place in the list, from zero.
        index: usize,
        /// Its kind.
        kind: &'static str,
        /// For a lemma inside an `at`, `reduced` or `convergence`: its place there and its kind.
        inside: Option<(usize, &'static str)>,
    },
    /// The conclusion.
    Conclusion,
    /// The box of a map, and how it is cut.
    Box,
    /// The stability of a map.
    Stability,
    /// A node of a map.
    Node(usize),
    /// A section of a map.
    Section(usize),
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Part::Family => f.write_str("family"),
            Part::Curve => f.write_str("curve"),
            Part::Lemma { index, kind, inside: None } => write!(f, "lemma {index} ({kind})"),
            Part::Lemma { index, kind, inside: Some((inner, inner_kind)) } => {
                write!(f, "lemma {index} ({kind}), inside it lemma {inner} ({inner_kind})")
            }
            Part::Conclusion => f.write_str("conclusion"),
            Part::Box => f.write_str("box"),
            Part::Stability => f.write_str("stability"),
            Part::Node(index) => write!(f, "node {index}"),
            Part::Section(index) => write!(f, "section {index}"),
        }
    }
}
