//! The data of a map, field by field as `docs/certificates.md` has it.

use serde::{Deserialize, Serialize};

use crate::model::{Certificate, Coefficients};
use crate::number::Number;

/// The only value of [`MapCertificate::format`].
pub const MAP_FORMAT: &str = "refinable-map-certificate";

/// Where in a box of two parameters a family is C^n, and where it is not.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapCertificate {
    /// [`MAP_FORMAT`].
    pub format: String,
    /// [`VERSION`](crate::VERSION).
    pub version: u32,
    /// What the map is about.
    pub family: PlaneFamily,
    /// The order `n`.
    pub continuity: usize,
    /// The box: the lower and upper end of each parameter.
    #[serde(rename = "box")]
    pub window: [[Number; 2]; 2],
    /// A point of the plane of `(x, y)` at which the shifts are stable for a reason that holds almost
    /// everywhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stable_at: Option<[Number; 2]>,
    /// The first node of each part of the box.
    pub roots: Vec<usize>,
    /// How the parts are cut, and what is proved on each piece.
    pub nodes: Vec<Node>,
    /// What is proved on lines and at points of the plane.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sections: Vec<Section>,
}

/// A family of masks that are polynomials, or rational functions, of two coordinates `x` and `y`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneFamily {
    /// What it is called; not checked.
    pub name: String,
    /// The arity `m`.
    pub arity: usize,
    /// The parameters `u` and `v`.
    pub parameters: [String; 2],
    /// `k`, with `σ^k` dividing the symbol identically.
    pub order: usize,
    /// The exponent of the first coefficient.
    pub lowest: i64,
    /// The coefficients as polynomials in `x` and `y`, or their numerators.
    pub mask: Vec<Terms>,
    /// Their common denominator, if it is not one. Where it vanishes there is no mask, and nothing is claimed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub denominator: Option<Terms>,
    /// What `x` and `y` are, if they are not the parameters themselves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chart: Option<Chart>,
}

/// The coordinates `x = u`, `y = v l(u)`, in which the masks are simpler.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chart {
    /// The coefficients of `l`, affine and not constant.
    pub factor: Coefficients,
    /// The coefficients of the mask as polynomials in `u` and `v`.
    pub mask: Vec<Terms>,
}

/// A polynomial in two variables: `[c, i, j]` stands for `c x^i y^j`.
pub type Terms = Vec<(Number, u32, u32)>;

/// A piece of the plane: cut in two, or with what is proved on it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Node {
    /// The line `a x + b y = c` cuts it into the parts where `a x + b y ≤ c` and where it is `≥ c`.
    Cut {
        /// `a`, `b` and `c`.
        line: [Number; 3],
        /// The node of the part `≤ c`.
        below: usize,
        /// The node of the part `≥ c`.
        above: usize,
    },
    /// C^n holds, since `‖c_n‖ < 1`.
    Norm,
    /// C^n holds, since the matrices map ellipsoids into the interior of each other.
    Ellipsoids(Ellipsoids),
    /// C^n fails wherever the shifts are stable, since the product along a word has a large
    /// eigenvalue; and everywhere if it is so large that the scheme diverges.
    Word(Inequality),
    /// C^n fails wherever the shifts are stable, and everywhere if `n` is zero, since the product along a
    /// word does not shrink.
    Expansion(Expansion),
    /// C^n fails wherever the shifts are stable, but for the common zeros of the remainder of the
    /// division by `σ^(n+1)`.
    Indivisible,
    /// Nothing is claimed.
    Undecided,
}

/// A polynomial inequality that shows an eigenvalue of modulus at least `radius`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Inequality {
    /// The letters, applied from left to right.
    pub word: String,
    /// Which block of the product.
    pub block: usize,
    /// Which eigenvalue.
    pub eigenvalue: Eigenvalue,
    /// The modulus, an integer.
    pub radius: u64,
}

/// Which eigenvalue is large.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Eigenvalue {
    /// A positive one.
    Positive,
    /// A negative one.
    Negative,
    /// One of two.
    Pair,
}

/// Ellipsoids that move with the point of a piece, one for each word of letters of a length: every letter
/// maps the ellipsoid of a word into the interior of that of the word which ends with the letter.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ellipsoids {
    /// The length of the words: how many of the letters applied last an ellipsoid knows.
    pub memory: u32,
    /// For each corner of the piece, for each word in lexicographic order, the upper triangle, row by
    /// row, of the positive definite `Q`: the ellipsoid is `{x : x x^T ≼ Q}`. Only ratios matter.
    pub corners: Vec<Vec<Vec<i64>>>,
}

/// Quadratic forms that move with the point of a piece and show that the product along a word has a
/// spectral radius of at least one.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expansion {
    /// The letters, that applied first first; not those of an inequality but, where matrices are mirrored,
    /// `A_0`, `A_0 J`, `A_1`, … as for ellipsoids.
    pub word: String,
    /// `v` with `v^T P v < 0` for the form before the first letter.
    pub vector: Vec<i64>,
    /// For each corner of the piece, for each letter the form `P` before it, the upper triangle row by row.
    pub corners: Vec<Vec<Vec<i64>>>,
}

/// What is proved on a line, or at a point, of the plane.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// The point of the plane where the parameter of the certificate is zero.
    pub origin: [Number; 2],
    /// How far the point moves while the parameter grows by one; zero if there is no parameter.
    pub direction: [Number; 2],
    /// The certificate of C^n for the family on the line.
    pub certificate: Certificate,
}
