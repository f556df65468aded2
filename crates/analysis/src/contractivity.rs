//! Contractivity of difference schemes by norms: the exact set of parameters a level proves.

use std::collections::HashSet;

use refinable_algebra::{Ordered, Parameter, Rational, Ring};
use refinable_reals::{RealAlgebraic, Region, common_roots, simple_roots};
use refinable_scheme::{Diagnostic, Normalised};

use crate::budget::Budget;
use crate::difference::{ClearedSymbol, DifferenceSymbol};
use crate::piecewise::RowCondition;
use crate::power::Powers;
use crate::sublevel::sublevel_set;

/// What the norms `‖c_n^L‖` up to some level prove about C^n over one parameter.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NormRange {
    /// The order `n`.
    pub continuity: usize,
    /// The free parameter.
    pub parameter: Parameter,
    /// For `L = 1, 2, …` the exact set where `c_n` exists and `‖c_n^L‖ < 1`.
    pub levels: Vec<Region>,
    /// Their union: C^n is proved there.
    pub proved: Region,
    /// The poles of the family: there is no scheme at these values.
    pub poles: Vec<RealAlgebraic>,
    /// The values at which alone `σ^(n+1)` divides the symbol; `None` if it divides identically.
    pub divisible_at: Option<Vec<RealAlgebraic>>,
    /// What it took.
    pub work: Work,
}

/// Deterministic counters of the work done.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Work {
    /// Distinct rows of all norms.
    pub rows: usize,
    /// Intervals examined.
    pub nodes: usize,
    /// Rows that an enclosure on such an interval showed to be below the bound.
    pub enclosed: usize,
    /// Rows that one polynomial inequality settled.
    pub solved: usize,
}

/// The set of values of `parameter` for which `‖c_n^L‖ < 1` for some `L ≤ max_level`, exactly: a
/// finite union of open intervals with real algebraic ends, or of points where `σ^(n+1)` divides
/// the symbol at isolated values only. There `S_a` is C^n.
///
/// # Errors
/// Code `budget` if the level is too large, `parameters` if another parameter is free.
///
/// # Cost
/// The size of `c_n^L` times the length of `c_n`, and a root isolation for the few rows that bound
/// the set. All other rows are settled by enclosures.
///
/// # Source
/// N. Dyn, *Subdivision schemes in computer-aided geometric design*, 1992; Theorem 2.2 of Hameed
/// and Mustafa. The exact solution is ours: see [`RowCondition::region`].
pub fn norm_range(
    mask: &Normalised,
    parameter: &Parameter,
    continuity: usize,
    max_level: u32,
    budget: Budget,
) -> Result<NormRange, Diagnostic> {
    let symbol = DifferenceSymbol::new(mask, continuity);
    let symbol = ClearedSymbol::new(&symbol, parameter).ok_or_else(|| {
        Diagnostic::new("parameters", format!("{parameter} is not the only free parameter"))
            .with_hint("set the others with --set NAME=VALUE")
    })?;
    let degree = symbol.parameter_degree() as u64;
    budget.admit_degree(degree, max_level)?;
    budget.admit(symbol.arity, symbol.length(), max_level, |l| degree * u64::from(l) + 1)?;
    let conditions = &symbol.remainder;
    let mut divisible_at = (!conditions.is_empty()).then(|| common_roots(conditions));
    if let Some(points) = &mut divisible_at {
        // At a pole there is no symbol to be divided.
        points.retain(|t| t.sign_of(&symbol.denominator).is_ne());
    }
    let mut work = Work::default();
    let levels = level_sets(&symbol, divisible_at.as_deref(), max_level, &mut work);
    Ok(NormRange {
        continuity,
        parameter: parameter.clone(),
        proved: Region::union_of(levels.iter().cloned()).simplified(),
        levels,
        poles: simple_roots(&symbol.denominator),
        divisible_at,
        work,
    })
}

/// The exact sets on which the norms of the levels `1, …, max_level` are below 1, within the points at
/// which alone the symbol exists if these are given.
pub(crate) fn level_sets(
    symbol: &ClearedSymbol,
    points: Option<&[RealAlgebraic]>,
    max_level: u32,
    work: &mut Work,
) -> Vec<Region> {
    let mut levels = Vec::new();
    let mut powers = Powers::new(symbol.numerator.clone(), symbol.arity);
    let mut d = symbol.denominator.clone();
    for level in 1..=max_level {
        if level > 1 {
            powers.advance();
            d = d.times(&symbol.denominator);
        }
        let rows = distinct_rows(&powers);
        work.rows += rows.len();
        levels.push(match points {
            None => sublevel_set(&rows, &d, work),
            Some(points) => {
                let proved = |t: &&RealAlgebraic| rows.iter().all(|row| row.holds_at(&d, t));
                Region::points(points.iter().filter(proved).cloned())
            }
        });
    }
    levels
}

/// The norm `‖c_n^L‖` of a scheme without free parameters; `None` if `c_n` does not exist.
///
/// # Errors
/// Codes `budget` and `parameters`, as for [`norm_range`].
pub fn norm_values(
    mask: &Normalised,
    continuity: usize,
    max_level: u32,
    budget: Budget,
) -> Result<Option<Vec<Rational>>, Diagnostic> {
    // Any name serves: no parameter occurs.
    let nothing = Parameter::new("t");
    if let Some(free) = mask.parameters().first() {
        return Err(Diagnostic::new("parameters", format!("the parameter {free} is free"))
            .with_hint(format!("set it: --set {free}=VALUE")));
    }
    let symbol = DifferenceSymbol::new(mask, continuity);
    if !symbol.exists_identically() {
        return Ok(None);
    }
    let symbol = ClearedSymbol::new(&symbol, &nothing).expect("no parameter occurs");
    budget.admit(symbol.arity, symbol.length(), max_level, |_| 1)?;
    let denominator = Rational::from(symbol.denominator.coefficient(0));
    let mut powers = Powers::new(symbol.numerator.clone(), symbol.arity);
    let mut norms = Vec::new();
    for level in 1..=max_level {
        if level > 1 {
            powers.advance();
        }
        let rows = distinct_rows(&powers);
        let largest = rows.iter().map(|row| row.value_at(&Rational::zero())).max();
        let scale = denominator.absolute().power(level);
        norms.push(largest.unwrap_or_else(Rational::zero) / scale);
    }
    Ok(Some(norms))
}

/// The rows of a norm, mirrored and repeated ones once, the fastest growing first.
fn distinct_rows(powers: &Powers) -> Vec<RowCondition> {
    let mut seen = HashSet::new();
    let rows = powers.rows();
    let conditions = rows.iter().map(|row| RowCondition::new(row));
    let mut distinct: Vec<_> = conditions.filter(|row| seen.insert(row.clone())).collect();
    distinct.sort_by_cached_key(|row| std::cmp::Reverse(row.growth()));
    distinct
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;
    use refinable_scheme::Scheme;

    fn range(text: &str, parameter: &str, continuity: usize, level: u32) -> NormRange {
        let scheme = Scheme::resolve(text, 2).unwrap();
        let parameter = Parameter::new(parameter);
        norm_range(scheme.mask(), &parameter, continuity, level, Budget::default()).unwrap()
    }

    #[test]
    fn the_c2_range_of_a4_at_level_one() {
        assert_eq!(range("a4", "alpha", 2, 1).proved.display("alpha"), "(0, 1/16)");
    }

    /// ω = -β: the classical interval 0 < ω < (√5-1)/8 of Dyn, Gregory and Levin.
    #[test]
    fn the_classical_interval_of_the_four_point_scheme() {
        let range = range("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", "w", 1, 2);
        assert_eq!(range.levels[1].display("w"), "(0, (-1+sqrt(5))/8)");
    }

    #[test]
    fn an_isolated_value_is_found_and_proved() {
        let range = range("a2", "alpha", 2, 2);
        assert_eq!(range.divisible_at, Some(vec![rational(1, 8).into()]));
        assert_eq!(range.proved.display("alpha"), "{1/8}");
    }

    #[test]
    fn fixed_schemes_have_norms_as_numbers() {
        // Cubic B-spline: c_2 = 4 (1+z)^4/8 / (1+z)^3 = (1+z)/2 up to z-powers; norm 1/2.
        let scheme = Scheme::resolve("bspline3", 2).unwrap();
        let norms = norm_values(scheme.mask(), 2, 3, Budget::default()).unwrap().unwrap();
        assert_eq!(norms, [rational(1, 2), rational(1, 4), rational(1, 8)]);
        assert_eq!(norm_values(scheme.mask(), 4, 3, Budget::default()).unwrap(), None);
    }

    #[test]
    fn an_absurd_level_is_refused_with_the_largest_possible_one() {
        let scheme = Scheme::resolve("a4", 2).unwrap();
        let parameter = Parameter::new("alpha");
        let error = norm_range(scheme.mask(), &parameter, 0, 60, Budget::default()).unwrap_err();
        assert_eq!(error.code(), "budget");
        assert!(error.hint().unwrap().contains("--level 14"));
    }
}
