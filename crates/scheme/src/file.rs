//! Scheme files, `*.scheme.toml`: a scheme, where it comes from, and what is expected of it.

use std::collections::BTreeMap;

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use crate::diagnostic::Diagnostic;
use crate::scheme::Scheme;
use crate::substitution::Substitution;

/// A scheme file. The format is in `docs/scheme-files.md`.
#[derive(Clone, Debug)]
pub struct SchemeFile {
    /// The scheme, with the name and the source that the file gives it.
    pub scheme: Scheme,
    /// What the file says about its parameters, for people.
    pub parameters: BTreeMap<String, String>,
    /// What is expected of it.
    pub expectations: Vec<Expectation>,
}

/// What is expected of a scheme, after some parameters are set; whatever is left out is not expected.
#[derive(Clone, PartialEq, Eq, Debug, Default, Deserialize, JsonSchema)]
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
    #[serde(default, deserialize_with = "two_ends")]
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

/// TOML's reader of pairs passes over what is too much.
fn two_ends<'de, D: Deserializer<'de>>(reader: D) -> Result<Option<[i64; 2]>, D::Error> {
    let ends = Vec::<i64>::deserialize(reader)?;
    let count = ends.len();
    let pair = ends.try_into().map_err(|_| D::Error::invalid_length(count, &"two indices"))?;
    Ok(Some(pair))
}

/// Where C^n holds over one parameter.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize, JsonSchema)]
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

/// A scheme, where it comes from, and what is expected of it.
#[derive(Deserialize, JsonSchema)]
#[schemars(title = "Scheme file of Refinable")]
#[serde(deny_unknown_fields)]
struct Fields {
    /// The name under which the scheme is printed.
    name: String,
    /// The number of new points for each old one, of masks that do not know theirs.
    #[serde(default = "two")]
    arity: usize,
    /// The scheme in any notation of the command line but a file: a name, a construction, a mask, rules, a symbol.
    mask: String,
    /// Parameters that are set once and for all, as `w=1/16`.
    #[serde(default)]
    set: Vec<String>,
    /// Where the scheme comes from.
    source: Option<String>,
    /// What there is to say about each parameter, for people.
    #[serde(default)]
    parameters: BTreeMap<String, String>,
    /// What is expected, any number of times.
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
    /// assert!(error.to_string().contains("\n2 | msk = '[1/2, 1, 1/2]'\n  | ^^^\n"));
    /// ```
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let fields: Fields = toml::from_str(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or_default();
            let hint = "docs/scheme-files.md describes the format";
            let error_of_file = Diagnostic::new("file", message).with_hint(hint);
            error_of_file.at(text, error.span().unwrap_or(0..0))
        })?;
        let mut substitutions = Vec::new();
        for set in &fields.set {
            substitutions.push(Substitution::parse(set)?);
        }
        let scheme = Scheme::resolve_with(&fields.mask, fields.arity, &substitutions)?;
        Ok(SchemeFile {
            scheme: scheme.renamed(fields.name).with_source(fields.source),
            parameters: fields.parameters,
            expectations: fields.expect,
        })
    }

    /// The JSON Schema, draft 2020-12, of what [`parse`](Self::parse) reads, seen as JSON; with a final newline. It
    /// knows the fields and their types, not the notation of masks, numbers and settings.
    pub fn json_schema() -> String {
        let settings =
            SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
        let mut generator = settings.with_transform(RecursiveTransform(plain)).into_generator();
        let mut schema = generator.root_schema_for::<Fields>();
        // People read the head first.
        let fields = schema.ensure_object();
        for key in ["description", "title", "$schema"] {
            if let Some(value) = fields.shift_remove(key) {
                fields.shift_insert(0, key.into(), value);
            }
        }
        format!("{:#}\n", schema.to_value())
    }
}

/// Takes away what the schema of a type says about Rust and not about files: that something left out is null, which
/// TOML does not have, and the widths of integers.
fn plain(schema: &mut Schema) {
    let Some(fields) = schema.as_object_mut() else {
        return;
    };
    fields.shift_remove("format");
    if fields.get("default").is_some_and(Value::is_null) {
        fields.shift_remove("default");
    }
    if let Some(types) = fields.get_mut("type")
        && let Some([only, Value::String(null)]) = types.as_array().map(Vec::as_slice)
        && null == "null"
    {
        *types = only.clone();
    }
}
