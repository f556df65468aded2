//! Scheme files, `*.scheme.toml`: a scheme, where it comes from, and what is expected of it.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::diagnostic::Diagnostic;
use crate::scheme::Scheme;
use crate::substitution::Substitution;

/// A scheme file. The format is in `docs/scheme-files.md`.
#[derive(Clone, Debug)]
pub struct SchemeFile {
    /// The scheme, with the name that the file gives it.
    pub scheme: Scheme,
    /// Where it comes from.
    pub source: Option<String>,
    /// What the file says about its parameters, for people.
    pub parameters: BTreeMap<String, String>,
    /// What is expected of it.
    pub expectations: Vec<Expectation>,
}

/// What is expected of a scheme, after some parameters are set; whatever is left out is not expected.
#[derive(Clone, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    /// What is set first, as `alpha=1/8`.
    #[serde(default)]
    pub set: Vec<String>,
    /// Who says so.
    pub source: Option<String>,
    /// The same mask, in any notation.
    pub mask: Option<String>,
    /// The first and the last index of the mask.
    pub support: Option<[i64; 2]>,
    /// All words that hold: `primal`, `dual`, `interpolatory`, `approximating`, `combined`, `relaxed`.
    #[serde(rename = "type")]
    pub kind: Option<Vec<String>>,
    /// The degree of generation, for all values of the parameters that are free.
    pub generation: Option<usize>,
    /// The degree of reproduction.
    pub reproduction: Option<usize>,
    /// The largest `n` with C^n; of schemes without free parameters.
    pub continuity: Option<usize>,
    /// Whether it converges; of schemes without free parameters.
    pub converges: Option<bool>,
    /// The Hölder exponent as it is printed, such as `3 - log2(9/8)`; of schemes without free parameters.
    pub holder: Option<String>,
    /// Where C^n holds over the one parameter that is free.
    pub range: Option<ExpectedRange>,
}

/// Where C^n holds over one parameter.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExpectedRange {
    /// `n`.
    pub continuity: usize,
    /// The intervals on which it is proved, as they are printed: `(0, root(32*w^3 + 4*w - 1, 1))`.
    pub proved: String,
    /// Whether it is refuted everywhere else.
    #[serde(default = "yes")]
    pub only: bool,
}

fn yes() -> bool {
    true
}

/// The file as TOML spells it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Fields {
    name: String,
    #[serde(default = "two")]
    arity: usize,
    mask: String,
    #[serde(default)]
    set: Vec<String>,
    source: Option<String>,
    #[serde(default)]
    parameters: BTreeMap<String, String>,
    #[serde(default)]
    expect: Vec<Expectation>,
}

fn two() -> usize {
    2
}

impl SchemeFile {
    /// Reads a file: `name`, `mask` in the notation of [`Scheme::resolve`], and perhaps `arity`, `set`, `source`,
    /// `parameters` and any number of `[[expect]]`.
    ///
    /// # Errors
    /// Code `file` if the text is not TOML or has fields that the format does not know; those of
    /// [`Scheme::resolve_with`] for the mask.
    ///
    /// ```
    /// use refinable_scheme::SchemeFile;
    /// let file = SchemeFile::parse("name = 'hat'\nmask = '[1/2, 1, 1/2]'\n[[expect]]\nsupport = [-1, 1]\n");
    /// assert_eq!(file.unwrap().expectations[0].support, Some([-1, 1]));
    /// let error = SchemeFile::parse("name = 'hat'\nmsk = '[1/2, 1, 1/2]'\n").unwrap_err();
    /// assert!(error.message().starts_with("line 2: unknown field `msk`"));
    /// ```
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let fields: Fields = toml::from_str(text).map_err(|error| {
            let before = error.span().map_or(0, |span| text[..span.start].matches('\n').count());
            let line = before + 1;
            let message = error.message().lines().next().unwrap_or_default();
            Diagnostic::new("file", format!("line {line}: {message}"))
                .with_hint("docs/scheme-files.md describes the format")
        })?;
        let mut substitutions = Vec::new();
        for set in &fields.set {
            substitutions.push(Substitution::parse(set)?);
        }
        let scheme = Scheme::resolve_with(&fields.mask, fields.arity, &substitutions)?;
        Ok(SchemeFile {
            scheme: Scheme::new(fields.name, scheme.mask().clone()),
            source: fields.source,
            parameters: fields.parameters,
            expectations: fields.expect,
        })
    }
}
