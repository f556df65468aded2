//! Vertices that are eigenvectors of leading words: their existence, and how far the integer
//! vectors are from them.
//!
//! Everything is in fixed point, with bounds for the norms of all errors.

use refinable_algebra::{Integer, Matrix, Ordered, Ring};

use crate::determinant::Product;
use crate::family::Letters;
use crate::fixed::{SCALE, divide_up, one, shift_up, times_up};
use crate::position::{Position, norm_by_rows};
use crate::real::Real;
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// A leading word with its letters read, and its vertices.
pub(crate) struct Orbit<'a> {
    /// The letters.
    pub word: Vec<usize>,
    /// The eigenvalue, 1 or -1.
    pub sign: i32,
    /// The coordinate in which the first vector is exact.
    pub pivot: usize,
    /// The integer vectors, as many as letters, over `2^bits`.
    pub vertices: &'a [Vec<i64>],
    /// The binary places of the vectors.
    pub bits: u32,
}

impl Orbit<'_> {
    /// Checks that the product of the word has the eigenvalue `sign` at `x`.
    pub fn check_eigenvalue(&self, letters: &Letters, x: &Real, work: &mut Work) -> Check<()> {
        let is_eigenvalue = match x.as_rational() {
            Some(rational) => {
                let position = Position::exact(letters, rational, work)?;
                self.defect(&position, letters.dimension, work)?.is_zero()
            }
            None => {
                let product = Product::new(letters, &self.word, work)?;
                let determinant = product.determinant(self.sign, work)?;
                determinant.is_zero() || x.is_root_of(&determinant, work)?
            }
        };
        ensure(is_eigenvalue, "a leading word does not have its eigenvalue at the end")
    }

    /// `det(I - sign · Π)` up to a positive factor, exactly.
    fn defect(&self, position: &Position, d: usize, work: &mut Work) -> Check<Integer> {
        let bits = position.denominator.bits() + norm_bits(&position.matrices);
        let length = self.word.len();
        work.products(length * d.pow(3), bits * length as u64, bits)?;
        work.products(d.pow(3), bits * (length * d) as u64, bits * (length * d) as u64)?;
        let matrix = |letter: usize| {
            let entries = &position.matrices[letter];
            Matrix::from_fn(d, d, |i, j| entries[i * d + j].clone())
        };
        let identity = Matrix::identity(d);
        let product = self.word.iter().fold(identity, |p, &letter| matrix(letter).times(&p));
        let unit = position.denominator.power(length as u32);
        let entry = |i: usize, j: usize| {
            let e = if self.sign > 0 { -product.entry(i, j) } else { product.entry(i, j).clone() };
            if i == j { e + &unit } else { e }
        };
        Ok(Matrix::from_fn(d, d, entry).determinant())
    }

    /// Bounds in fixed point for the distances of the vectors from the true ones, in the maximum
    /// norm. The position is in fixed point.
    pub fn errors(&self, position: &Position, d: usize, work: &mut Work) -> Check<Vec<Integer>> {
        let places = 2 * SCALE + norm_bits(&position.matrices);
        work.products((self.word.len() + 3) * d.pow(3), places, places)?;
        let mut error = self.first_error(position, d)?;
        let mut errors = Vec::with_capacity(self.word.len());
        for (step, &letter) in self.word.iter().enumerate() {
            errors.push(error.clone());
            let Some(next) = self.vertices.get(step + 1) else { break };
            let matrix = &position.matrices[letter];
            let size = self.size(&self.vertices[step]);
            let norm = norm_by_rows(d, matrix) + &position.error;
            let image = apply(d, matrix, &self.vertices[step]);
            let miss =
                image.iter().zip(next).map(|(a, &b)| (a - (Integer::from(b) << SCALE)).absolute());
            let miss = shift_up(&miss.max().unwrap_or_default(), u64::from(self.bits));
            error = times_up(&norm, &error) + miss + times_up(&position.error, &size);
        }
        Ok(errors)
    }

    /// The maximum norm of a vector in fixed point.
    fn size(&self, vector: &[i64]) -> Integer {
        let largest = vector.iter().map(|x| x.unsigned_abs()).max().unwrap_or(0);
        Integer::from(largest) << (SCALE - u64::from(self.bits))
    }

    /// Bounds the error of the first vector by a nearly inverse matrix of the equations for its
    /// coordinates other than the pivot.
    fn first_error(&self, position: &Position, d: usize) -> Check<Integer> {
        let (matrix, error) = self.equations(position, d);
        let inverse = approximate_inverse(d, self.pivot, &matrix)?;
        let norm = norm_by_rows(d, &inverse);
        // ‖1 - G K‖, the column of the pivot left out.
        let product = multiply(d, &inverse, &matrix);
        let unit = |k: usize| {
            let (i, j) = (k / d, k % d);
            if i == j { &product[k] - (one() << SCALE) } else { product[k].clone() }
        };
        let defect: Vec<Integer> =
            (0..d * d)
                .map(|k| {
                    if k % d == self.pivot || k / d == self.pivot {
                        Integer::zero()
                    } else {
                        unit(k)
                    }
                })
                .collect();
        let contraction = shift_up(&norm_by_rows(d, &defect), SCALE) + times_up(&norm, &error);
        let gap = one() - contraction;
        ensure(
            gap > Integer::zero(),
            "the eigenvector of a leading word is not shown to be unique",
        )?;
        let residual = apply(d, &matrix, &self.vertices[0]);
        let correction = (0..d).map(|i| {
            let row = &inverse[i * d..(i + 1) * d];
            row.iter().zip(&residual).map(|(g, r)| g * r).sum::<Integer>().absolute()
        });
        let correction = correction.max().unwrap_or_default();
        let step = shift_up(&correction, SCALE + u64::from(self.bits))
            + times_up(&times_up(&norm, &error), &self.size(&self.vertices[0]));
        Ok(divide_up(&(step << SCALE), &gap))
    }

    /// `I - sign · Π` in fixed point, with a bound for the norm of its error by rows.
    fn equations(&self, position: &Position, d: usize) -> (Vec<Integer>, Integer) {
        let unit = |k: usize| if k.is_multiple_of(d + 1) { one() } else { Integer::zero() };
        let mut product: Vec<Integer> = (0..d * d).map(unit).collect();
        let mut error = Integer::zero();
        for &letter in &self.word {
            let matrix = &position.matrices[letter];
            let before = norm_by_rows(d, &product) + &error;
            // (B + δ)(Π + ε) - BΠ = Bε + δ(Π + ε), and the rounding of each entry.
            error = times_up(&norm_by_rows(d, matrix), &error)
                + times_up(&position.error, &before)
                + Integer::from(d);
            product = multiply(d, matrix, &product).iter().map(|e| e >> SCALE).collect();
        }
        let entry =
            |(k, e): (usize, Integer)| if self.sign > 0 { unit(k) - e } else { unit(k) + e };
        (product.into_iter().enumerate().map(entry).collect(), error)
    }
}

fn norm_bits(matrices: &[Vec<Integer>]) -> u64 {
    largest_bits(matrices.iter().flatten())
}

/// The matrix times the vector.
pub(crate) fn apply(d: usize, matrix: &[Integer], vector: &[i64]) -> Vec<Integer> {
    let row = |entries: &[Integer]| {
        let terms = entries.iter().zip(vector).filter(|(e, x)| **x != 0 && !e.is_zero());
        terms.map(|(e, &x)| e * x).sum()
    };
    matrix.chunks(d).map(row).collect()
}

fn multiply(d: usize, left: &[Integer], right: &[Integer]) -> Vec<Integer> {
    let entry = |k: usize| {
        let (i, j) = (k / d, k % d);
        (0..d).map(|l| &left[i * d + l] * &right[l * d + j]).sum()
    };
    (0..d * d).map(entry).collect()
}

/// A matrix `G` whose product with the given one is nearly the identity outside the row and the
/// column of the pivot, by the method of Gauss and Jordan; one row is not used, the row of the pivot
/// in `G` is zero.
fn approximate_inverse(d: usize, pivot: usize, matrix: &[Integer]) -> Check<Vec<Integer>> {
    let unit = |i: usize, j: usize| if i == j { one() } else { Integer::zero() };
    // Each row is followed by the row of the transformation.
    let row = |i: usize| {
        let transformation = (0..d).map(move |j| unit(i, j));
        matrix[i * d..(i + 1) * d].iter().cloned().chain(transformation).collect()
    };
    let mut rows: Vec<Vec<Integer>> = (0..d).map(row).collect();
    let mut used: Vec<Option<usize>> = vec![None; d];
    for column in (0..d).filter(|&j| j != pivot) {
        let free = (0..d).filter(|&i| used[i].is_none());
        let best = free.max_by_key(|&i| rows[i][column].absolute());
        let Some(best) = best.filter(|&i| !rows[i][column].is_zero()) else {
            return fail("the eigenvector of a leading word is not shown to be unique");
        };
        used[best] = Some(column);
        let divisor = rows[best][column].clone();
        let leading: Vec<Integer> = rows[best].iter().map(|e| (e << SCALE) / &divisor).collect();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != best) {
            let factor = row[column].clone();
            for (e, l) in row.iter_mut().zip(&leading) {
                *e -= (&factor * l) >> SCALE;
            }
        }
        rows[best] = leading;
    }
    let mut inverse = vec![Integer::zero(); d * d];
    for (row, column) in rows.iter().zip(&used) {
        let Some(column) = column else { continue };
        for j in (0..d).filter(|&j| used[j].is_some()) {
            inverse[column * d + j] = row[d + j].clone();
        }
    }
    Ok(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `p/q` in fixed point.
    fn fixed(p: i64, q: i64) -> Integer {
        (Integer::from(p) << SCALE) / q
    }

    /// The matrices `diag(2, 1/2)` and `diag(1/2, 1/2)`, of which the product `diag(1, 1/4)` fixes
    /// `(1, 0)`: errors of an orbit of which the second coordinates, zero, are given as `1/8` and
    /// `3/8`.
    fn errors(position_error: Integer) -> Check<Vec<Integer>> {
        let diagonal = |a: Integer, b: Integer| vec![a, Integer::zero(), Integer::zero(), b];
        let matrices = vec![diagonal(fixed(2, 1), fixed(1, 2)), diagonal(fixed(1, 2), fixed(1, 2))];
        let position = Position { matrices, denominator: one(), error: position_error };
        let vertices = [vec![8, 1], vec![16, 3]];
        let orbit = Orbit { word: vec![0, 1], sign: 1, pivot: 0, vertices: &vertices, bits: 3 };
        orbit.errors(&position, 2, &mut Work::new())
    }

    /// `[[-1, 0], [5/4, 1/4]]` maps `(1, -1)` to its opposite, and fixes nothing that is not zero.
    #[test]
    fn an_orbit_that_ends_at_the_opposite() {
        let matrix = vec![fixed(-1, 1), Integer::zero(), fixed(5, 4), fixed(1, 4)];
        let zero = Integer::zero();
        let position = Position { matrices: vec![matrix], denominator: one(), error: zero };
        let error = |second: i64| {
            let vertices = [vec![8, second]];
            let orbit = Orbit { word: vec![0], sign: -1, pivot: 0, vertices: &vertices, bits: 3 };
            orbit.errors(&position, 2, &mut Work::new()).unwrap().remove(0)
        };
        for (second, exact) in [(-8, fixed(0, 1)), (-7, fixed(1, 8)), (0, fixed(1, 1))] {
            let error = error(second);
            assert!(error >= exact && error - exact < one() >> 180_u32, "{second}");
        }
    }

    fn assert_close(errors: Check<Vec<Integer>>, expected: [Integer; 2]) {
        for (error, exact) in errors.unwrap().iter().zip(&expected) {
            assert!(error >= exact && error - exact < one() >> 180_u32, "{error} {exact}");
        }
    }

    #[test]
    fn errors_grow_along_an_orbit() {
        // Twice the first one, and the second vector misses the image (2, 1/16) by 5/16.
        assert_close(errors(Integer::zero()), [fixed(1, 8), fixed(9, 16)]);
    }

    #[test]
    fn errors_of_the_matrices_count() {
        // With the error e = 1/8 that of the product is e/2 + e (2 + e) = 21/64, so 1 - q = 9/16
        // with the inverse 4/3 of 1 - 1/4. The first error is (1/8 + q) / (1 - q) = 1, the second
        // (2 + e) 1 + 5/16 + e.
        assert_close(errors(fixed(1, 8)), [fixed(1, 1), fixed(41, 16)]);
        assert!(errors(fixed(5, 16)).unwrap_err().0.contains("unique"));
    }
}
