//! The lemma `word`: a product whose spectral radius is at least one.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Polynomial, Rational, Ring, integer};

use crate::determinant::Product;
use crate::family::Letters;
use crate::jury::{circle_determinant, is_schur_stable};
use crate::line::{Span, sorted};
use crate::real::{Real, between};
use crate::roots::{real_roots, root_bound, roots_between, sign_at};
use crate::work::{Check, Work, fail};

/// Checks that the spectral radius of the product of the word is at least one on the span, which
/// is closed.
pub(crate) fn check(letters: &Letters, word: &[usize], span: &Span, work: &mut Work) -> Check<()> {
    let product = Product::new(letters, word, work)?;
    let plus = product.determinant(1, work)?;
    let minus = product.determinant(-1, work)?;
    if plus.is_zero() || minus.is_zero() {
        return Ok(());
    }
    // Where the first is positive the second must not be.
    let (low, high) = (span.low.number(), span.high.number());
    let mut roots = roots_near(&plus, low, high, work)?;
    let positive = where_positive(&plus, cells(low, high, &roots, work)?, work)?;
    if positive.is_empty() {
        return Ok(());
    }
    roots.extend(roots_near(&minus, low, high, work)?);
    let roots = sorted(&roots, work)?;
    let mut undecided = Vec::new();
    for cell in positive {
        let parts = cell.cut(&roots, work)?;
        undecided.extend(where_positive(&minus, parts, work)?);
    }
    if undecided.is_empty() {
        return Ok(());
    }
    check_by_counting(&product, &undecided, &roots, work)
}

/// A part of a closed interval on which a polynomial has no root: an open interval or one number.
struct Cell {
    low: Option<Real>,
    high: Option<Real>,
    /// The number, if it is one.
    point: Option<Real>,
    /// A rational number in the open interval, or not separated from the number by a root.
    sample: Rational,
}

impl Cell {
    fn new(low: Option<&Real>, high: Option<&Real>, work: &mut Work) -> Check<Self> {
        let sample = between(low, high, work)?;
        Ok(Cell { low: low.cloned(), high: high.cloned(), point: None, sample })
    }

    /// The parts between further roots, sorted.
    fn cut(&self, roots: &[Real], work: &mut Work) -> Check<Vec<Cell>> {
        match &self.point {
            Some(x) => around(x, roots, work),
            None => parts(self.low.as_ref(), self.high.as_ref(), roots, work),
        }
    }
}

/// The parts into which sorted roots cut a closed interval, infinite where an end is `None`; the
/// roots themselves are left out.
fn cells(
    low: Option<&Real>,
    high: Option<&Real>,
    roots: &[Real],
    work: &mut Work,
) -> Check<Vec<Cell>> {
    match (low, high) {
        (Some(x), Some(y)) if x.compare(y, work)?.is_eq() => around(x, roots, work),
        _ => parts(low, high, roots, work),
    }
}

/// The open parts into which sorted roots cut an interval of more than one number.
fn parts(
    low: Option<&Real>,
    high: Option<&Real>,
    roots: &[Real],
    work: &mut Work,
) -> Check<Vec<Cell>> {
    let mut result = Vec::new();
    let mut left = low;
    for root in roots {
        let above = low.map_or(Ok(Ordering::Greater), |x| root.compare(x, work))?.is_gt();
        let below = high.map_or(Ok(Ordering::Less), |x| root.compare(x, work))?.is_lt();
        if above && below {
            result.push(Cell::new(left, Some(root), work)?);
            left = Some(root);
        }
    }
    result.push(Cell::new(left, high, work)?);
    Ok(result)
}

/// One number; nothing if it is a root itself.
fn around(x: &Real, roots: &[Real], work: &mut Work) -> Check<Vec<Cell>> {
    let (mut low, mut high) = (None, None);
    for root in roots {
        match root.compare(x, work)? {
            Ordering::Equal => return Ok(Vec::new()),
            Ordering::Less => low = Some(root),
            Ordering::Greater => high = high.or(Some(root)),
        }
    }
    let mut cell = match x.as_rational() {
        Some(x) => Cell { low: None, high: None, point: None, sample: x.clone() },
        None => Cell::new(low, high, work)?,
    };
    cell.point = Some(x.clone());
    Ok(vec![cell])
}

/// All real roots in the closed interval; for an interval of one number also the neighbours.
fn roots_near(
    polynomial: &Polynomial<Integer>,
    low: Option<&Real>,
    high: Option<&Real>,
    work: &mut Work,
) -> Check<Vec<Real>> {
    let one = Rational::from(integer(1));
    match (low, high) {
        (Some(x), Some(y)) if x.compare(y, work)?.is_eq() => return real_roots(polynomial, work),
        _ => {}
    }
    // Roots at the ends do not cut.
    let bound = root_bound(polynomial);
    let lower = low.map_or_else(|| -&bound - &one, |x| x.bracket().0.clone());
    let upper = high.map_or_else(|| &bound + &one, |x| x.bracket().1.clone());
    roots_between(polynomial, &lower, &upper, work)
}

/// The cells on which the polynomial, which has no root there, is positive.
///
/// `det(I - Π) ≤ 0`: an eigenvalue in `[1, ∞)`. `det(I + Π) ≤ 0`: one in `(-∞, -1]`.
fn where_positive(
    polynomial: &Polynomial<Integer>,
    cells: Vec<Cell>,
    work: &mut Work,
) -> Check<Vec<Cell>> {
    let mut positive = Vec::new();
    for cell in cells {
        if sign_at(polynomial, &cell.sample, work)?.is_gt() {
            positive.push(cell);
        }
    }
    Ok(positive)
}

/// Cuts the cells where a pair of eigenvalues has the product one: between the cuts the number of
/// eigenvalues outside the unit disc is constant.
fn check_by_counting(
    product: &Product,
    undecided: &[Cell],
    roots: &[Real],
    work: &mut Work,
) -> Check<()> {
    let crossing = circle_determinant(product, work)?;
    if crossing.is_zero() {
        return Ok(());
    }
    let mut cuts = real_roots(&crossing, work)?;
    cuts.extend_from_slice(roots);
    let cuts = sorted(&cuts, work)?;
    for cell in undecided {
        for part in cell.cut(&cuts, work)? {
            let y = product.variable(&part.sample, work)?;
            if is_schur_stable(product, &y, work)? {
                return fail("the spectral radius of the product is less than one somewhere");
            }
        }
    }
    Ok(())
}
