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
        let all = (0..letters.pairs.len()).map(|letter| letters.numerators_at(letter, x));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{End, Root};
    use crate::number::Number;
    use refinable_algebra::{integer, rational};

    /// One matrix `[[1, -2], [3, 5]] + x [[0, 7], [-4, 0]]`, the slope `2^40` times as large.
    fn letters() -> Letters {
        let constant = [1, -2, 3, 5].map(integer).to_vec();
        let slope = [0, 7, -4, 0].map(|q| integer(q) << 40).to_vec();
        Letters { dimension: 2, pairs: vec![[constant, slope]], denominator: integer(1) }
    }

    fn distance(a: &Position, b: &Position) -> Rational {
        let entry =
            |p: &Position, k: usize| Rational::new(p.matrices[0][k].clone(), p.denominator.clone());
        let row = |i: usize| {
            (0..2)
                .map(|j| entry(a, 2 * i + j) - entry(b, 2 * i + j))
                .map(|x| if x < rational(0, 1) { -x } else { x })
                .sum::<Rational>()
        };
        row(0).max(row(1))
    }

    #[test]
    fn the_error_of_rounding_is_bounded() {
        let (letters, work) = (letters(), &mut Work::new());
        let third = rational(1, 3);
        let exact = Position::exact(&letters, &third, work).unwrap();
        let fixed = Position::fixed(&letters, &Real::Rational(third), work).unwrap();
        let distance = distance(&exact, &fixed);
        assert!(distance > rational(0, 1));
        assert!(distance <= Rational::new(fixed.error, integer(1) << SCALE));
    }

    #[test]
    fn the_error_of_an_enclosure_is_bounded() {
        let (letters, work) = (letters(), &mut Work::new());
        let root_of = [-2, 0, 1].map(|c| Number(rational(c, 1))).to_vec();
        let between = [1, 2].map(|c| Number(rational(c, 1)));
        let root = Real::new(&End::Algebraic(Root { root_of, between }), work).unwrap();
        let fixed = Position::fixed(&letters, &root, work).unwrap();
        // An enclosure that is as good as exact.
        let (near, _) = root.enclosure(400, work).unwrap();
        let near = Position::exact(&letters, &near, work).unwrap();
        let distance = distance(&near, &fixed);
        assert!(distance > rational(4, 1) / Rational::from(integer(1) << SCALE));
        assert!(distance <= Rational::new(fixed.error, integer(1) << SCALE));
    }

    #[test]
    fn the_norm_is_that_by_columns() {
        let matrices =
            vec![[1, -2, -3, 5].map(integer).to_vec(), [9, 0, 0, 0].map(integer).to_vec()];
        let position = Position { matrices, denominator: integer(4), error: integer(1) };
        assert_eq!(position.column_norm(2), ratio_up(&integer(9), &integer(4)) + 1);
        let position =
            Position { matrices: vec![[1, -2, -3, 5].map(integer).to_vec()], ..position };
        assert_eq!(position.column_norm(2), ratio_up(&integer(7), &integer(4)) + 1);
    }
}
