//! The data of a certificate, field by field as `docs/certificates.md` has it.

use serde::{Deserialize, Serialize};

use crate::number::Number;

/// The only value of [`Certificate::format`].
pub const FORMAT: &str = "refinable-certificate";
/// The only value of [`Certificate::version`].
pub const VERSION: u32 = 1;

/// A theorem about one family, and the lemmas it follows from.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// [`FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// What the theorem is about.
    pub family: Family,
    /// The theorem.
    pub conclusion: Conclusion,
    /// The reasons, in any order.
    pub lemmas: Vec<Lemma>,
}

/// Ascending coefficients.
pub type Coefficients = Vec<Number>;

/// A family of masks that is affine in at most one parameter.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Family {
    /// What it is called; not checked.
    pub name: String,
    /// The arity `m`.
    pub arity: usize,
    /// The parameter `t`, if there is one.
    #[serde(deserialize_with = "Option::deserialize")]
    pub parameter: Option<String>,
    /// `k`, with `σ^k` dividing the symbol identically.
    pub order: usize,
    /// The exponent of the first coefficient.
    pub lowest: i64,
    /// The coefficients as polynomials in `t`.
    pub mask: Vec<Coefficients>,
    /// How another family runs along this one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<Curve>,
}

/// A family in another parameter `s` that runs along the line of masks.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Curve {
    /// The parameter `s`.
    pub parameter: String,
    /// The numerators of its mask.
    pub mask: Vec<Coefficients>,
    /// Their common denominator.
    pub denominator: Coefficients,
    /// `t` as a function of `s`.
    pub line: Quotient,
}

/// A rational function.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quotient {
    /// The numerator.
    pub numerator: Coefficients,
    /// The denominator.
    pub denominator: Coefficients,
}

/// A finite end of an interval.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(untagged)]
pub enum End {
    /// A rational number.
    Rational(Number),
    /// A real algebraic number.
    Algebraic(Root),
}

/// The only root of a polynomial in an open interval.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Root {
    /// The polynomial.
    pub root_of: Coefficients,
    /// The interval.
    pub between: [Number; 2],
}

/// An interval; an infinite end is `None`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Interval {
    /// The lower end.
    #[serde(deserialize_with = "Option::deserialize")]
    pub from: Option<End>,
    /// The upper end.
    #[serde(deserialize_with = "Option::deserialize")]
    pub to: Option<End>,
    /// `"[]"`, `"[)"`, `"(]"` or `"()"`.
    pub ends: String,
}

/// What a certificate proves.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
#[expect(clippy::large_enum_variant, reason = "there is one in a certificate")]
pub enum Conclusion {
    /// Where the scheme is C^n and where it is not.
    Continuity {
        /// The order `n`.
        continuity: usize,
        /// C^n holds for every parameter in these.
        proved: Vec<Interval>,
        /// C^n fails for every parameter in these.
        refuted: Vec<Interval>,
    },
    /// The Hölder regularity of one stable scheme.
    Regularity {
        /// `ρ ≤ 1/from`.
        from: End,
        /// `ρ ≥ 1/to`.
        to: End,
        /// Bounds for the Hölder regularity.
        holder: [Number; 2],
    },
}

/// What the variable of a pencil is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pencil {
    /// The parameter of the family; the matrices are divided by the bound `m^(k-1-n)`.
    Parameter,
    /// A factor of the matrices of a family without parameter.
    Scale,
}

/// One step of a proof.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Lemma {
    /// `‖c_n^L‖ < 1` on a closed interval.
    Norm {
        /// The power `L`.
        level: u32,
        /// The lower end.
        from: Number,
        /// The upper end.
        to: Number,
    },
    /// An invariant polytope.
    Polytope(Box<Polytope>),
    /// A product of spectral radius at least one.
    Word {
        /// What the interval is about.
        pencil: Pencil,
        /// The letters, applied from left to right.
        word: String,
        /// The lower end.
        #[serde(deserialize_with = "Option::deserialize")]
        from: Option<End>,
        /// The upper end.
        #[serde(deserialize_with = "Option::deserialize")]
        to: Option<End>,
    },
    /// `σ^order` does not divide the symbol.
    Indivisible {
        /// The power of `σ`.
        order: usize,
        /// The parameter values at which it may.
        except: Vec<End>,
    },
    /// The criterion of contraction is sharp: C^n, `n ≥ 1`, only if the pencil contracts and
    /// `σ^(n+1)` divides.
    Stable {
        /// The parameter values at which it may not be.
        except: Vec<End>,
    },
    /// A symbol that is non-negative on the unit circle.
    Nonnegative {
        /// The end of the interval of scales that it proves.
        end: End,
    },
    /// Lemmas about one member of the family.
    At {
        /// The parameter value.
        value: Number,
        /// The power of `σ` that divides there.
        order: usize,
        /// The lemmas.
        lemmas: Vec<Lemma>,
    },
    /// Lemmas about C^0 in place of C^n: where the scheme converges, and where it does not.
    Convergence {
        /// The lemmas.
        lemmas: Vec<Lemma>,
    },
    /// Lemmas about a mask whose limit function has the same smoothness as that of one member.
    Reduced {
        /// The parameter value.
        value: Number,
        /// `q`; the symbol of the other mask is `a(z) q(z)/q(z²)`.
        factor: Coefficients,
        /// The power of `σ` that divides the other symbol.
        order: usize,
        /// The lemmas.
        lemmas: Vec<Lemma>,
    },
}

impl Lemma {
    /// The lemmas inside this one, if it is of a kind that has any.
    pub fn inside(&self) -> Option<&[Lemma]> {
        match self {
            Lemma::At { lemmas, .. }
            | Lemma::Convergence { lemmas }
            | Lemma::Reduced { lemmas, .. } => Some(lemmas),
            _ => None,
        }
    }
}

/// `Σ (weight / 2^weight_bits) u_index`; `None` where a vertex is met by construction.
pub type Combination = Option<Vec<Term>>;

/// One term of a combination: `[index, re]`, or `[index, re, im]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(from = "Entry", into = "Entry")]
pub struct Term {
    /// Which vertex.
    pub index: usize,
    /// The real part of the weight.
    pub re: i64,
    /// The imaginary part of the weight.
    pub im: i64,
}

/// A term as it is written.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Entry {
    Real(usize, i64),
    Complex(usize, i64, i64),
}

impl From<Entry> for Term {
    fn from(entry: Entry) -> Self {
        match entry {
            Entry::Real(index, re) => Term { index, re, im: 0 },
            Entry::Complex(index, re, im) => Term { index, re, im },
        }
    }
}

impl From<Term> for Entry {
    fn from(Term { index, re, im }: Term) -> Self {
        if im == 0 { Entry::Real(index, re) } else { Entry::Complex(index, re, im) }
    }
}

/// A symmetric polytope that every matrix maps into itself.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polytope {
    /// What the interval is about.
    pub pencil: Pencil,
    /// `x_0`, where all images are inside.
    pub inner: Number,
    /// `x_1`.
    pub end: End,
    /// Whether `x_1` does not belong to the interval.
    pub open: bool,
    /// Whether vertices and weights are complex.
    pub complex: bool,
    /// Whether the mirror images of the vertices belong to it.
    pub mirrored: bool,
    /// Vertices are integers over `2^bits`.
    pub bits: u32,
    /// The vertices; if complex, the real parts of all coordinates and then the imaginary parts.
    pub vertices: Vec<Vec<i64>>,
    /// How the polytope moves on the way to `x_0`, if it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion>,
    /// The words whose eigenvectors are vertices.
    pub leading: Vec<Leading>,
    /// Weights are integers over `2^weight_bits`.
    pub weight_bits: u32,
    /// The unit vectors, nearly.
    pub units: Vec<Combination>,
    /// For each vertex and letter, the image at `x_0`, nearly.
    pub inner_images: Vec<Vec<Combination>>,
    /// For each vertex and letter, the image at `x_1`, nearly.
    pub end_images: Vec<Vec<Combination>>,
}

/// What becomes of a polytope on the way from `x_1` to `x_0`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The vertices at `x_0`.
    pub vertices: Vec<Vec<i64>>,
    /// For each vertex and letter, what is left of the image in the middle, nearly.
    pub rests: Vec<Vec<Combination>>,
}

/// A word whose product has an eigenvalue of modulus one at the end of the interval.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Leading {
    /// The word.
    pub word: String,
    /// The eigenvalue, 1 or -1.
    pub sign: i32,
    /// The first vertex of the orbit.
    pub vertex: usize,
    /// The coordinate in which the integer vector is exact.
    pub pivot: usize,
}
