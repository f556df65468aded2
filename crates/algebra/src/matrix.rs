//! Matrices over a ring, with the two exact algorithms that need no field.

use crate::number::{Integer, Rational, clear_denominators, integer};
use crate::polynomial::Polynomial;
use crate::ring::{Domain, Ring};

/// A matrix, row-major, index origin 0.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Matrix<R> {
    rows: usize,
    columns: usize,
    entries: Vec<R>,
}

impl<R: Ring> Matrix<R> {
    /// The `rows × columns` matrix with entry `f(i, j)`.
    pub fn from_fn(rows: usize, columns: usize, mut f: impl FnMut(usize, usize) -> R) -> Self {
        let entries = (0..rows * columns).map(|k| f(k / columns, k % columns)).collect();
        Matrix { rows, columns, entries }
    }

    /// The identity of size `n`.
    pub fn identity(n: usize) -> Self {
        Matrix::from_fn(n, n, |i, j| if i == j { R::one() } else { R::zero() })
    }

    /// The numbers of rows and columns.
    pub fn shape(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }

    /// The entry in row `i`, column `j`.
    pub fn entry(&self, i: usize, j: usize) -> &R {
        &self.entries[i * self.columns + j]
    }

    /// `self · other`.
    ///
    /// # Panics
    /// If the shapes do not fit.
    pub fn times(&self, other: &Self) -> Self {
        assert_eq!(self.columns, other.rows, "shapes must fit");
        Matrix::from_fn(self.rows, other.columns, |i, j| {
            let mut sum = R::zero();
            for k in 0..self.columns {
                sum.add_product(self.entry(i, k), other.entry(k, j));
            }
            sum
        })
    }

    /// The characteristic polynomial `det(x I - self)`, over any commutative ring.
    ///
    /// # Panics
    /// If the matrix is not square.
    ///
    /// # Cost
    /// `O(n⁴)` ring operations, no division.
    ///
    /// # Source
    /// S. J. Berkowitz, *On computing the determinant in small parallel time using a small number
    /// of processors*, Inf. Process. Lett. 18 (1984).
    pub fn characteristic_polynomial(&self) -> Polynomial<R> {
        assert_eq!(self.rows, self.columns, "only a square matrix has a characteristic polynomial");
        let mut descending = vec![R::one()];
        for size in 1..=self.rows {
            let toeplitz = self.berkowitz_column(size);
            descending = (0..=size)
                .map(|i| {
                    let mut sum = R::zero();
                    for (j, c) in descending.iter().enumerate().take(i + 1) {
                        sum.add_product(&toeplitz[i - j], c);
                    }
                    sum
                })
                .collect();
        }
        descending.reverse();
        Polynomial::new(descending)
    }

    /// With the leading `size × size` block written as `[M S; R a]`, `M` its leading block:
    /// `1, -a, -R S, -R M S, -R M² S, …`.
    fn berkowitz_column(&self, size: usize) -> Vec<R> {
        let last = size - 1;
        let mut column = vec![R::one(), self.entry(last, last).negated()];
        let mut power: Vec<R> = (0..last).map(|i| self.entry(i, last).clone()).collect();
        for _ in 0..last {
            let mut product = R::zero();
            for (k, s) in power.iter().enumerate() {
                product.add_product(self.entry(last, k), s);
            }
            column.push(product.negated());
            power = self.leading_block_times(&power);
        }
        column
    }

    fn leading_block_times(&self, vector: &[R]) -> Vec<R> {
        (0..vector.len())
            .map(|i| {
                let mut sum = R::zero();
                for (k, v) in vector.iter().enumerate() {
                    sum.add_product(self.entry(i, k), v);
                }
                sum
            })
            .collect()
    }
}

impl<R: Domain> Matrix<R> {
    /// The determinant, over a domain; 1 for the empty matrix.
    ///
    /// # Panics
    /// If the matrix is not square.
    ///
    /// # Cost
    /// `O(n³)` ring operations; every intermediate value is a minor.
    ///
    /// # Source
    /// E. H. Bareiss, *Sylvester's identity and multistep integer-preserving Gaussian
    /// elimination*, Math. Comp. 22 (1968).
    pub fn determinant(&self) -> R {
        assert_eq!(self.rows, self.columns, "only a square matrix has a determinant");
        let n = self.rows;
        let mut m = self.clone();
        let mut previous = R::one();
        let mut negative = false;
        for k in 0..n {
            let Some(pivot) = (k..n).find(|&i| !m.entry(i, k).is_zero()) else {
                return R::zero();
            };
            if pivot != k {
                m.swap_rows(pivot, k);
                negative = !negative;
            }
            m.eliminate_below(k, &previous);
            previous = m.entry(k, k).clone();
        }
        if negative { previous.negated() } else { previous }
    }

    fn swap_rows(&mut self, i: usize, j: usize) {
        for column in 0..self.columns {
            self.entries.swap(i * self.columns + column, j * self.columns + column);
        }
    }

    fn eliminate_below(&mut self, k: usize, previous: &R) {
        for i in k + 1..self.rows {
            for j in k + 1..self.columns {
                let minor = self
                    .entry(k, k)
                    .times(self.entry(i, j))
                    .minus(&self.entry(i, k).times(self.entry(k, j)));
                self.entries[i * self.columns + j] = minor.quotient(previous);
            }
        }
    }
}

impl Matrix<Rational> {
    /// A basis of the vectors `v` with `self · v = 0`, one for each column without a pivot.
    ///
    /// # Cost
    /// `O(n³)` operations on integers, all of which are minors.
    ///
    /// # Source
    /// Gauss and Jordan, without fractions, after Bareiss (see [`determinant`](Self::determinant)).
    pub fn null_space(&self) -> Vec<Vec<Rational>> {
        let rows = self.entries.chunks(self.columns.max(1));
        let entries = rows.flat_map(|row| clear_denominators(row.iter()).1).collect();
        let mut m = Matrix { rows: self.rows, columns: self.columns, entries };
        let (mut pivots, mut previous) = (Vec::new(), integer(1));
        for column in 0..m.columns {
            let row = pivots.len();
            let Some(at) = (row..m.rows).find(|&i| !m.entry(i, column).is_zero()) else { continue };
            m.swap_rows(at, row);
            m.clear_column(row, column, &previous);
            previous = m.entry(row, column).clone();
            pivots.push(column);
        }
        // All pivots are the last one.
        let free = (0..m.columns).filter(|column| !pivots.contains(column));
        free.map(|column| {
            let mut vector = vec![Rational::zero(); m.columns];
            vector[column] = Rational::one();
            for (row, &pivot) in pivots.iter().enumerate() {
                vector[pivot] = Rational::new(m.entry(row, column).negated(), previous.clone());
            }
            vector
        })
        .collect()
    }
}

impl Matrix<Integer> {
    /// Makes all entries of a column but that of `row` zero; the divisions by the pivot before are exact.
    fn clear_column(&mut self, row: usize, column: usize, previous: &Integer) {
        let pivot = self.entry(row, column).clone();
        for i in (0..self.rows).filter(|&i| i != row) {
            let factor = self.entry(i, column).clone();
            for j in 0..self.columns {
                let minor =
                    self.entry(i, j).times(&pivot).minus(&self.entry(row, j).times(&factor));
                self.entries[i * self.columns + j] = minor.quotient(previous);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational;

    #[test]
    fn a_companion_matrix_has_its_polynomial() {
        // x³ - 2x² + 5x - 7
        let companion = Matrix::from_fn(3, 3, |i, j| {
            integer(match (i, j) {
                (0, 2) => 7,
                (1, 2) => -5,
                (2, 2) => 2,
                _ if i == j + 1 => 1,
                _ => 0,
            })
        });
        let expected = [-7, 5, -2, 1].map(integer).to_vec();
        assert_eq!(companion.characteristic_polynomial(), Polynomial::new(expected));
        assert_eq!(companion.determinant(), integer(7));
    }

    #[test]
    fn determinants_that_need_a_swap() {
        let swap = Matrix::from_fn(2, 2, |i, j| integer(i64::from(i != j)));
        assert_eq!(swap.determinant(), integer(-1));
        let singular = Matrix::from_fn(3, 3, |i, j| integer((i + j) as i64));
        assert_eq!(singular.determinant(), integer(0));
        assert_eq!(Matrix::<Integer>::identity(0).determinant(), integer(1));
    }

    #[test]
    fn null_spaces_are_mapped_to_zero() {
        // Rank 2: the third row is the sum of the others, the second column twice the first.
        let rows = [[1, 2, 0, 3], [2, 4, 1, -1], [3, 6, 1, 2]];
        let m = Matrix::from_fn(3, 4, |i, j| rational(rows[i][j], 1));
        let space = m.null_space();
        let expected = [[-2, 1, 0, 0], [-3, 0, 7, 1]];
        assert_eq!(space, expected.map(|v| v.map(|x| rational(x, 1)).to_vec()));
        assert_eq!(Matrix::<Rational>::identity(3).null_space(), Vec::<Vec<Rational>>::new());
    }
}
