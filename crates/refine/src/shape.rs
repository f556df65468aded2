//! What limits keep of the shape of their data: signs, monotonicity, convexity, the bounds of a step.
//!
//! Let a scheme converge, `φ` be its basic limit function, `Φ(z) = Σ_j φ(j) z^j` over the integers,
//! `σ = 1 + z + … + z^(m-1)`, `q = a/σ^r`, and `q^L(z) = q(z) q(z^m) … q(z^(m^(L-1)))`.
//!
//! **Theorem.** The limits of all data with `∇^r f ≥ 0` have non-negative `r`-th differences if and only if all
//! coefficients of all `q^L Φ` are non-negative. If the coefficients of one `q^L`, `L ≥ 1`, are, they have.
//!
//! *Proof.* Since `φ(n/m^L) = Σ_i a^L_i φ(n-i)`, the symbol of the values of `φ` at the `n/m^L` is `a^L Φ`. Data with
//! `∇^r f ≥ 0` are a polynomial of degree below `r`, the limit of which is one too because `σ^r` divides `a`,
//! and a locally finite sum, with factors `∇^r f_k`, of shifts of `b_k = C(k+r-1, r-1)` for `k ≥ 0` and 0 before
//! (on any half line; limits are local). The symbol of `b` is `1/(1-z)^r`, so that of the limit of `b` at the
//! `n/m^L` is `a^L Φ / (1-z^(m^L))^r`, and that of its differences `∇^r` there is this times `(1-z)^r`, which is
//! `q^L Φ`, as `(1-z) σ(z) σ(z^m) … = 1-z^(m^L)`. The limit is continuous, and its differences for a step are sums, with
//! positive factors, of those for finer ones. For the second statement, `S_q` refines `r`-th differences: `L` steps
//! keep them non-negative, and so does the limit. ∎
//!
//! `r = 0` is about signs, `r = 1` about monotone data, for which `b` is a step, and `r = 2` about convex data.
//! The limit of a step runs between 0 and 1 if `φ ≥ 0`: it is a partial sum of the `φ(x-k)`, all of which add up
//! to 1. Its values are the partial sums of the coefficients of `q^L Φ` for `r = 1`.

use refinable_algebra::{Laurent, Ordered, Rational, Ring};
use refinable_scheme::{Diagnostic, Normalised};

use crate::limit::BasicLimit;
use crate::weights::constant_coefficients;

/// The most places `n/m^L` between two integers at which limits are looked at.
const FINEST: usize = 32;

/// What is known about a property of all limits.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ShapeVerdict {
    /// All limits have it.
    Proved,
    /// One has not.
    Refuted(Witness),
    /// Neither was shown.
    Undecided,
}

/// Where a limit breaks the shape of its data, and by how much; exact. The limit function is `F(x) = Σ_k f_k φ(x-k)`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Witness {
    /// The first and the last of the equidistant places: `r + 1` for `∇^r`, one for a step that is left.
    pub places: [Rational; 2],
    /// The size of the negative difference, or how far the limit of a step is above 1 or below 0.
    pub amount: Rational,
}

/// Whether limits of data with `∇^r f ≥ 0` have non-negative `r`-th differences; the data of a witness are
/// `f_k = C(k+r-1, r-1)` for `k ≥ 0`, and 0 before.
///
/// The scheme must converge; this is not checked. Undecided without a search if `σ^r` does not divide the symbol.
///
/// # Errors
/// Code `parameters` if a parameter is free; `limit` if the values of `φ` at integers are not determined, which
/// happens to no scheme that converges; `budget` if the support is too wide.
///
/// # Cost
/// Products of polynomials of some `32` times the length of the mask, after one null space of its width.
///
/// # Source
/// The theorem of this module; for the second half, N. Dyn, D. Levin, *Subdivision schemes in geometric
/// modelling*, Acta Numerica 11 (2002), on schemes for differences with non-negative masks.
pub fn preserves(mask: &Normalised, order: usize) -> Result<ShapeVerdict, Diagnostic> {
    let limit = Limit::new(mask)?;
    let (symbol, remainder) = limit.symbol.divide_by_geometric(limit.arity, order);
    if !remainder.is_zero() {
        return Ok(ShapeVerdict::Undecided);
    }
    for (level, power) in limit.powers(symbol).enumerate() {
        if level > 0 && is_nonnegative(&power) {
            return Ok(ShapeVerdict::Proved);
        }
        let differences = power.times(&limit.integers);
        let least = differences.terms().reduce(|a, b| if b.1 < a.1 { b } else { a });
        if let Some((n, value)) = least.filter(|(_, value)| value.compare_to_zero().is_lt()) {
            let places = [n - order as i64, n].map(|n| limit.place(n, level));
            return Ok(ShapeVerdict::Refuted(Witness { places, amount: value.absolute() }));
        }
    }
    Ok(ShapeVerdict::Undecided)
}

/// Whether the limit of a step, `f_k = 1` for `k ≥ 0` and 0 before, stays between 0 and 1: no Gibbs phenomenon. A witness is
/// where it is farthest off, among some 32 places between integers.
///
/// The scheme must converge; this is not checked.
///
/// # Errors
/// Those of [`preserves`].
///
/// # Cost
/// That of [`preserves`].
///
/// # Source
/// The theorem of this module.
pub fn keeps_steps(mask: &Normalised) -> Result<ShapeVerdict, Diagnostic> {
    let limit = Limit::new(mask)?;
    if limit.powers(limit.symbol.clone()).skip(1).any(|power| is_nonnegative(&power)) {
        return Ok(ShapeVerdict::Proved);
    }
    // σ divides: stencils sum to 1.
    let (symbol, _) = limit.symbol.divide_by_geometric(limit.arity, 1);
    let Some((level, finest)) = limit.powers(symbol).enumerate().last() else {
        return Ok(ShapeVerdict::Undecided);
    };
    let mut sum = Rational::zero();
    let mut farthest: Option<(i64, Rational)> = None;
    for (n, difference) in finest.times(&limit.integers).terms() {
        sum += difference;
        let excess = (&sum - Rational::one()).max(-&sum);
        if farthest.as_ref().map_or(!excess.compare_to_zero().is_le(), |(_, most)| excess > *most) {
            farthest = Some((n, excess));
        }
    }
    Ok(farthest.map_or(ShapeVerdict::Undecided, |(n, amount)| {
        let place = limit.place(n, level);
        ShapeVerdict::Refuted(Witness { places: [place.clone(), place], amount })
    }))
}

/// A mask of numbers and the values of its basic limit function at the integers.
struct Limit {
    arity: usize,
    symbol: Laurent<Rational>,
    integers: Laurent<Rational>,
}

impl Limit {
    fn new(mask: &Normalised) -> Result<Self, Diagnostic> {
        let coefficients = constant_coefficients(mask)?.into_iter().map(|(_, a)| a).collect();
        let symbol = Laurent::new(mask.support().0, coefficients);
        let values = BasicLimit::new(mask)?.values(&Rational::zero(), 0)?;
        let first = values.first().map_or(0, |(j, _)| *j);
        let integers = Laurent::new(first, values.into_iter().map(|(_, value)| value).collect());
        Ok(Limit { arity: mask.arity(), symbol, integers })
    }

    /// `1, q, q(z) q(z^m), …` up to the finest level.
    fn powers(&self, symbol: Laurent<Rational>) -> impl Iterator<Item = Laurent<Rational>> {
        let arity = self.arity;
        let start = (Laurent::monomial(Rational::one(), 0), 1);
        std::iter::successors(Some(start), move |(power, step)| {
            let next = step * arity;
            (next <= FINEST).then(|| (power.times(&symbol.dilated(*step)), next))
        })
        .map(|(power, _)| power)
    }

    /// `n/m^L`.
    fn place(&self, n: i64, level: usize) -> Rational {
        Rational::from_i64(n) / Rational::from_i64(self.arity as i64).power(level as u32)
    }
}

fn is_nonnegative(symbol: &Laurent<Rational>) -> bool {
    symbol.coefficients().iter().all(|c| !c.compare_to_zero().is_lt())
}
