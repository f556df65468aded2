//! Curves.

use refinable_scheme::Diagnostic;

use crate::cascade::Cascade;
use crate::coordinate::Coordinate;
use crate::ends::Ends;
use crate::memory;
use crate::polygon::Polygon;
use crate::weights::Weights;

/// The polygon after some levels: rules are applied one after the other, `rules[0]` first, each of
/// them `f'_{mi+ε} = Σ_k w_k f_{i+first+k}`. For a stationary scheme all of them are the same.
///
/// A closed polygon stays closed, and its point `0` is the first of the result; an open one is treated
/// as [`Ends`] says.
///
/// # Errors
/// Code `points` if there are too few for the stencils, `levels` and `memory` if there would be too
/// many.
///
/// # Cost
/// Linear in the points of the result, with weights of each stencil for a factor; memory for the result
/// alone. Runs on all cores; the result does not depend on their number.
///
/// ```
/// use refinable_refine::{Ends, Polygon, Weights, refine};
/// use refinable_scheme::Scheme;
/// let chaikin = Weights::new(Scheme::resolve("bspline2", 2).unwrap().mask()).unwrap();
/// let corner = Polygon::new(2, vec![0.0, 0.0, 4.0, 0.0, 4.0, 4.0], false).unwrap();
/// let cut = refine(&corner, &[&chaikin], Ends::Trim).unwrap();
/// assert_eq!(cut.values(), [1.0, 0.0, 3.0, 0.0, 4.0, 1.0, 4.0, 3.0]);
/// ```
pub fn refine<T: Coordinate>(
    polygon: &Polygon<T>,
    rules: &[&Weights<T>],
    ends: Ends,
) -> Result<Polygon<T>, Diagnostic> {
    descend(polygon, cascade(polygon, rules, ends)?, ends)
}

/// As [`refine`], and then, from the points of the last level, one polygon by each of the rules of `last`:
/// all of them have the same points, those that each of these rules determines. With the rules of
/// [`BasicLimit::rule`](crate::BasicLimit::rule) they are limit points and their derivatives.
///
/// # Errors
/// Those of [`refine`].
pub fn refine_to<T: Coordinate>(
    polygon: &Polygon<T>,
    rules: &[&Weights<T>],
    last: &[&Weights<T>],
    ends: Ends,
) -> Result<Vec<Polygon<T>>, Diagnostic> {
    let chains = last.iter().map(|rule| [rules, &[*rule]].concat());
    let cascades = chains.map(|chain| cascade(polygon, &chain, ends));
    let cascades: Vec<Cascade<T>> = cascades.collect::<Result<_, _>>()?;
    let start = cascades.iter().map(|c| c.last().start).max().unwrap_or(0);
    let end = cascades.iter().map(|c| c.last().end).min().unwrap_or(0);
    if start >= end && !cascades.is_empty() {
        let message = format!("too few points for the stencils of the scheme: {}", polygon.count());
        let hint = "give more, close the polygon, or continue it beyond its ends";
        return Err(Diagnostic::new("points", message).with_hint(hint));
    }
    let common = cascades.into_iter().map(|cascade| cascade.restricted(start..end));
    common.map(|cascade| descend(polygon, cascade, ends)).collect()
}

fn cascade<'a, T: Coordinate>(
    polygon: &Polygon<T>,
    rules: &[&'a Weights<T>],
    ends: Ends,
) -> Result<Cascade<'a, T>, Diagnostic> {
    let cascade = Cascade::new(rules.to_vec(), polygon.count(), polygon.is_closed(), ends)?;
    memory::check(rules, (cascade.count() as u64).saturating_mul(polygon.dimension() as u64))?;
    Ok(cascade)
}

fn descend<T: Coordinate>(
    polygon: &Polygon<T>,
    cascade: Cascade<'_, T>,
    ends: Ends,
) -> Result<Polygon<T>, Diagnostic> {
    let (width, closed) = (polygon.dimension(), polygon.is_closed());
    let control = ends.extend(polygon.values(), width, closed, &cascade.control());
    Polygon::new(width, cascade.descend(&control, width), closed)
}
