//! Symmetric matrices in orthonormal coordinates, in floats.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use nalgebra::{DMatrix, DVector};

/// The number of coordinates of a symmetric matrix.
pub(crate) fn coordinates(size: usize) -> usize {
    size * (size + 1) / 2
}

/// The places of the upper triangle, row by row.
pub(crate) fn pairs(size: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..size).flat_map(move |i| (i..size).map(move |j| (i, j)))
}

/// The matrix with the given coordinates.
pub(crate) fn symmetric(coordinates: &[f64], size: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(size, size);
    for ((i, j), x) in pairs(size).zip(coordinates) {
        matrix[(i, j)] = if i == j { *x } else { x * FRAC_1_SQRT_2 };
        matrix[(j, i)] = matrix[(i, j)];
    }
    matrix
}

/// Adds `factor tr(P F)` for the unit vectors `F`.
pub(crate) fn add_vector(vector: &mut DVector<f64>, at: usize, factor: f64, p: &DMatrix<f64>) {
    for (a, (i, j)) in pairs(p.nrows()).enumerate() {
        let scale = if i == j { 1.0 } else { SQRT_2 };
        vector[at + a] += factor * scale * p[(i, j)];
    }
}

/// Adds `factor tr(F T G T^T)` for the unit vectors `F`, `G`.
pub(crate) fn add_square(
    matrix: &mut DMatrix<f64>,
    [row, column]: [usize; 2],
    factor: f64,
    t: &DMatrix<f64>,
) {
    let scale = |i: usize, j: usize| if i == j { FRAC_1_SQRT_2 } else { 1.0 };
    for (b, (k, l)) in pairs(t.nrows()).enumerate() {
        let factor = factor * scale(k, l);
        for (a, (i, j)) in pairs(t.nrows()).enumerate() {
            let product = t[(i, k)] * t[(j, l)] + t[(i, l)] * t[(j, k)];
            matrix[(row + a, column + b)] += factor * scale(i, j) * product;
        }
    }
}
