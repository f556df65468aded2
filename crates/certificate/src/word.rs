//! The lemma `word`: a product whose spectral radius is at least one.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Polynomial, Rational, Ring};

use crate::determinant::Product;
use crate::family::Letters;
use crate::jury::Characteristic;
use crate::line::Span;
use crate::real::{Real, between};
use crate::roots::{root_bound, roots_between, sign_at};
use crate::work::{Check, Work, fail};

/// Checks that the spectral radius of the product of the word is at least one on the span, which
/// is closed.
pub(crate) fn check(letters: &Letters, word: &[usize], span: &Span, work: &mut Work) -> Check<()> {
    let product = Product::new(letters, word, work)?;
    let mut undecided = vec![Cell::new(span, work)?];
    // `det(I - Π) ≤ 0`: an eigenvalue in `[1, ∞)`. `det(I + Π) ≤ 0`: one in `(-∞, -1]`.
    for sign in [1, -1] {
        let determinant = product.determinant(sign, work)?;
        let mut positive = Vec::new();
        for cell in undecided {
            positive.extend(cell.where_positive(&determinant, work)?);
        }
        undecided = positive;
        if undecided.is_empty() {
            return Ok(());
        }
    }
    let characteristic = Characteristic::new(&product, work)?;
    let rest = without_witnesses(&product, &characteristic, undecided, work)?;
    check_by_counting(&product, &characteristic, rest, work)
}

/// Part of a closed interval: an open interval without some roots that it has been cut at, or one
/// number in it.
struct Cell {
    low: Option<Real>,
    high: Option<Real>,
    /// The number, if it is one.
    point: Option<Real>,
}

impl Cell {
    /// The whole interval.
    fn new(span: &Span, work: &mut Work) -> Check<Self> {
        let (low, high) = (span.low.number(), span.high.number());
        if let (Some(x), Some(y)) = (low, high)
            && x.compare(y, work)?.is_eq()
        {
            return Ok(Cell { low: None, high: None, point: Some(x.clone()) });
        }
        Ok(Cell { low: low.cloned(), high: high.cloned(), point: None })
    }

    /// The value, if it is one rational number.
    fn as_rational(&self) -> Option<&Rational> {
        self.point.as_ref().and_then(Real::as_rational)
    }

    /// The number, or a rational one that no root separates from it; or one in the interval.
    fn sample(&self, work: &mut Work) -> Check<Rational> {
        match self.as_rational() {
            Some(x) => Ok(x.clone()),
            None => between(self.low.as_ref(), self.high.as_ref(), work),
        }
    }

    /// The roots of a polynomial between the ends, ascending.
    fn roots(&self, polynomial: &Polynomial<Integer>, work: &mut Work) -> Check<Vec<Real>> {
        let bound = root_bound(polynomial);
        let lower = self.low.as_ref().map_or_else(|| -&bound, |x| x.bracket().0.clone());
        let upper = self.high.as_ref().map_or_else(|| bound.clone(), |x| x.bracket().1.clone());
        let mut inside = Vec::new();
        for root in roots_between(polynomial, &lower, &upper, work)? {
            let above = match &self.low {
                Some(x) => root.compare(x, work)?.is_gt(),
                None => true,
            };
            let below = match &self.high {
                Some(x) => root.compare(x, work)?.is_lt(),
                None => true,
            };
            if above && below {
                inside.push(root);
            }
        }
        Ok(inside)
    }

    /// The parts between the roots of a polynomial; the roots are left out. There are none to cut at
    /// if it is zero, and no need to if the cell is one rational number, its own sample.
    fn cut(mut self, polynomial: &Polynomial<Integer>, work: &mut Work) -> Check<Vec<Cell>> {
        if polynomial.is_zero() || self.as_rational().is_some() {
            return Ok(vec![self]);
        }
        let roots = self.roots(polynomial, work)?;
        let Some(x) = self.point.take() else {
            let mut parts = Vec::with_capacity(roots.len() + 1);
            for root in roots {
                let high = Some(root.clone());
                parts.push(Cell { low: self.low.replace(root), high, point: None });
            }
            parts.push(self);
            return Ok(parts);
        };
        for root in roots {
            match root.compare(&x, work)? {
                Ordering::Equal => return Ok(Vec::new()),
                Ordering::Less => self.low = Some(root),
                Ordering::Greater => {
                    self.high = Some(root);
                    break;
                }
            }
        }
        self.point = Some(x);
        Ok(vec![self])
    }

    /// The parts on which a polynomial is positive.
    fn where_positive(self, polynomial: &Polynomial<Integer>, work: &mut Work) -> Check<Vec<Cell>> {
        let mut positive = Vec::new();
        for part in self.cut(polynomial, work)? {
            if sign_at(polynomial, &part.sample(work)?, work)?.is_gt() {
                positive.push(part);
            }
        }
        Ok(positive)
    }
}

/// What is left of the cells where no simple inequality shows an eigenvalue outside of the open unit
/// disc. No inequality is used twice for the same part.
fn without_witnesses(
    product: &Product,
    characteristic: &Characteristic,
    mut cells: Vec<Cell>,
    work: &mut Work,
) -> Check<Vec<Cell>> {
    let mut rest = Vec::new();
    while let Some(cell) = cells.pop() {
        let y = product.variable(&cell.sample(work)?, work)?;
        match characteristic.witness(&y, work)? {
            Some(witness) => cells.extend(cell.where_positive(&product.stretched(&witness), work)?),
            None => rest.push(cell),
        }
    }
    Ok(rest)
}

/// Cuts the cells where a pair of eigenvalues has the product one: between the cuts the number of
/// eigenvalues outside the unit disc is constant.
fn check_by_counting(
    product: &Product,
    characteristic: &Characteristic,
    cells: Vec<Cell>,
    work: &mut Work,
) -> Check<()> {
    let mut parts = cells;
    // A rational number is its own sample.
    if !parts.iter().all(|cell| cell.as_rational().is_some()) {
        let crossing = product.stretched(&characteristic.circle_determinant(work)?);
        let whole = std::mem::take(&mut parts);
        for cell in whole {
            parts.extend(cell.cut(&crossing, work)?);
        }
    }
    for part in parts {
        let y = product.variable(&part.sample(work)?, work)?;
        if characteristic.is_schur_stable(&y, work)? {
            return fail("the spectral radius of the product is less than one somewhere");
        }
    }
    Ok(())
}
