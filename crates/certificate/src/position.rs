//! The matrices of a pencil at one number, exactly or enclosed.

use refinable_algebra::{Integer, Ordered, Rational};

use crate::family::Letters;
use crate::fixed::{SCALE, ratio_up, times_up, up};
use crate::real::Real;
use crate::work::{Check, Work, rational_bits};

/// Integer matrices over a common denominator, near the true ones.
pub(crate) struct Position {
    /// The numerators for each letter, row by row.
    pub matrices: Vec<Vec<Integer>>,
    /// The denominator, positive.
    pub denominator: Integer,
    /// A bound for the norm of the error, by rows and by columns, in fixed point.
    pub error: Integer,
}

impl Position {
    /// The matrices at a rational number.
    pub fn exact(letters: &Letters, x: &Rational, work: &mut Work) -> Check<Self> {
        spend(letters, x, work)?;
        let all = (0..letters.pairs.len()).map(|letter| letters.at(letter, x).0);
        let denominator = &letters.denominator * x.denom();
        Ok(Position { matrices: all.collect(), denominator, error: Integer::from(0) })
    }

    /// The matrices at a real number in fixed point.
    pub fn fixed(letters: &Letters, x: &Real, work: &mut Work) -> Check<Self> {
        let (lower, upper) = x.enclosure(SCALE as u32 + 8, work)?;
        let width = up(&(upper - &lower));
        let mut position = Position::exact(letters, &lower, work)?;
        for entry in position.matrices.iter_mut().flatten() {
            *entry = (&*entry << SCALE) / &position.denominator;
        }
        position.denominator = Integer::from(1) << SCALE;
        let d = letters.dimension;
        let slopes =
            letters.pairs.iter().map(|[_, q]| norm_by_rows(d, q).max(norm_by_columns(d, q)));
        let slope = ratio_up(&slopes.max().unwrap_or_default(), &letters.denominator);
        // Each entry is rounded by less than the last place.
        position.error = times_up(&width, &slope) + d;
        Ok(position)
    }

    /// The matrices in fixed point where they are wanted for combinations: exact if possible.
    pub fn best(letters: &Letters, x: &Real, work: &mut Work) -> Check<Self> {
        match x.as_rational() {
            Some(x) => Position::exact(letters, x, work),
            None => Position::fixed(letters, x, work),
        }
    }

    /// An upper bound for the largest absolute column sum of the true matrices, in fixed point.
    pub fn column_norm(&self, d: usize) -> Integer {
        let largest = self.matrices.iter().map(|matrix| norm_by_columns(d, matrix)).max();
        ratio_up(&largest.unwrap_or_default(), &self.denominator) + &self.error
    }
}

fn spend(letters: &Letters, x: &Rational, work: &mut Work) -> Check<()> {
    let count = letters.pairs.len() * letters.dimension * letters.dimension;
    work.products(4 * count, letters.bits(), rational_bits(x))
}

/// The largest absolute row sum.
pub(crate) fn norm_by_rows(d: usize, matrix: &[Integer]) -> Integer {
    let sums = matrix.chunks(d).map(|row| row.iter().map(Ordered::absolute).sum::<Integer>());
    sums.max().unwrap_or_default()
}

/// The largest absolute column sum.
pub(crate) fn norm_by_columns(d: usize, matrix: &[Integer]) -> Integer {
    let column = |j: usize| matrix.iter().skip(j).step_by(d).map(Ordered::absolute);
    (0..d).map(|j| column(j).sum::<Integer>()).max().unwrap_or_default()
}
