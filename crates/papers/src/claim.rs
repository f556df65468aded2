//! The kinds of claims a cell can make.

use serde::{Deserialize, Deserializer, de::Error as _};

/// One claim of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Claim {
    /// A statement about a scheme, which a computation can confirm or refute.
    Checkable(Assertion),
    /// Something no computation can decide, and why.
    NotChecked {
        /// Why it is not checked.
        reason: String,
    },
}

/// A statement about a scheme, some of whose parameters may be fixed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assertion {
    /// The scheme's catalogue name, such as `a2`, or an inline mask or symbol.
    pub scheme: String,
    /// Substitutions `name=expression`, applied in this order before the statement is read.
    pub set: Vec<String>,
    /// What a reader of the cell should know besides.
    pub note: Option<String>,
    /// What is said of the scheme.
    pub statement: Statement,
}

/// What a claim says of its scheme.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Statement {
    /// The scheme has this mask.
    Mask {
        /// The whole mask as a list centred at index 0, with or without a factor in front.
        mask: String,
    },
    /// The scheme is C^n, at least; on an interval or where every parameter is fixed.
    Continuity(ClaimedContinuity),
    /// The largest n for which some parameter value gives C^n.
    MaxContinuity {
        /// The order n.
        value: u32,
        /// Whether the order is exact.
        #[serde(default)]
        bound: Bound,
    },
    /// The degree of polynomial generation.
    Generation(ClaimedDegree),
    /// The degree of polynomial reproduction.
    Reproduction(ClaimedDegree),
    /// The width of the support of the basic limit function.
    SupportWidth {
        /// The width.
        value: u32,
    },
    /// The number of free parameters.
    ParameterCount {
        /// The number.
        value: u32,
    },
    /// The scheme is of all these types.
    Type {
        /// The types claimed, which need not be all the scheme has; at least one.
        #[serde(deserialize_with = "non_empty")]
        traits: Vec<Trait>,
    },
    /// The maximum norm of a power of the difference scheme of C^n.
    Norm {
        /// The order n of the continuity the norm decides.
        continuity: u32,
        /// The power, that is the number of subdivision steps.
        level: u32,
        /// The norm is the maximum over the rows of the sum of the absolute values in a row;
        /// at least one row, and no row is empty.
        #[serde(deserialize_with = "non_empty_rows")]
        rows: Vec<Vec<String>>,
    },
}

/// A claimed order of continuity, a lower bound.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "ContinuityFields")]
pub struct ClaimedContinuity {
    /// The order n of C^n.
    pub order: u32,
    /// Where the one free parameter may lie; absent where every parameter is fixed.
    pub interval: Option<Interval>,
}

/// An open interval of parameter values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The parameter that runs through it.
    pub parameter: String,
    /// The left end, a constant expression. A misprint may put it right of the right end.
    pub left: String,
    /// The right end, a constant expression.
    pub right: String,
}

/// A claimed degree of polynomials.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClaimedDegree {
    /// The degree.
    pub value: u32,
    /// At which parameter values.
    #[serde(default)]
    pub over: Over,
    /// Whether the degree is exact.
    #[serde(default)]
    pub bound: Bound,
}

/// The parameter values a degree is claimed for, once the substitutions are made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Over {
    /// Generic values: the degree that all values share.
    #[default]
    All,
    /// Special values: the largest degree that any value attains.
    Some,
}

/// How a claimed number bounds the true one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bound {
    /// The true number is the claimed one.
    #[default]
    Equal,
    /// The true number is the claimed one or larger.
    AtLeast,
}

/// A type of subdivision scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Trait {
    /// `a(z) = a(1/z)`: a new point for each old vertex and each old edge.
    Primal,
    /// `z a(z) = a(1/z)`: two new points for each old edge.
    Dual,
    /// Every old point is kept.
    Interpolatory,
    /// Old points are not kept.
    Approximating,
    /// Interpolatory at some parameter values, approximating at others.
    Combined,
    /// One rule uses more points than the other, and the old points may move.
    Relaxed,
}

/// The fields of a continuity claim as a file spells them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ContinuityFields {
    continuity: u32,
    parameter: Option<String>,
    range: Option<[String; 2]>,
}

impl TryFrom<ContinuityFields> for ClaimedContinuity {
    type Error = &'static str;

    fn try_from(fields: ContinuityFields) -> Result<Self, Self::Error> {
        let interval = match (fields.parameter, fields.range) {
            (None, None) => None,
            (Some(parameter), Some([left, right])) => Some(Interval { parameter, left, right }),
            (Some(_), None) => return Err("field `parameter` needs the field `range`"),
            (None, Some(_)) => return Err("field `range` needs the field `parameter`"),
        };
        Ok(Self { order: fields.continuity, interval })
    }
}

/// The fields every claim about a scheme has besides its statement.
#[derive(Deserialize)]
struct Common {
    scheme: String,
    #[serde(default)]
    set: Vec<String>,
    note: Option<String>,
}

impl Common {
    const NAMES: [&str; 3] = ["scheme", "set", "note"];
}

/// The fields of a claim that is not checked.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NotChecked {
    reason: String,
}

impl Claim {
    /// Reads a claim off the fields a file gives it.
    pub(crate) fn from_fields(mut fields: toml::Table) -> Result<Self, toml::de::Error> {
        if fields.get("kind").and_then(toml::Value::as_str) == Some("not-checked") {
            fields.remove("kind");
            let NotChecked { reason } = fields.try_into()?;
            return Ok(Self::NotChecked { reason });
        }
        // serde cannot both flatten shared fields and deny unknown ones: so they are split here.
        let (common, statement): (toml::Table, toml::Table) =
            fields.into_iter().partition(|(name, _)| Common::NAMES.contains(&name.as_str()));
        let Common { scheme, set, note } = common.try_into()?;
        let statement = statement.try_into()?;
        Ok(Self::Checkable(Assertion { scheme, set, note, statement }))
    }
}

/// Reads a list that says nothing when it is empty.
fn non_empty<'de, D, T>(deserializer: D) -> Result<Vec<T>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let list = Vec::deserialize(deserializer)?;
    if list.is_empty() {
        return Err(D::Error::custom("the list is empty"));
    }
    Ok(list)
}

/// Reads the rows of a norm, none of which may be empty.
fn non_empty_rows<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<Vec<String>>, D::Error> {
    let rows: Vec<Vec<String>> = non_empty(deserializer)?;
    if rows.iter().any(Vec::is_empty) {
        return Err(D::Error::custom("a row is empty"));
    }
    Ok(rows)
}
