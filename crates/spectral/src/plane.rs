//! Sets of matrices that are polynomials in two variables.

use nalgebra::DMatrix;
use refinable_algebra::{Matrix, Rational};

use crate::float::approximate;
use crate::geometry::Place;
use crate::pencil::is_mirrored;

/// The matrices `B_ε(x, y) = Σ x^i y^j B_ε^{ij}`, all of one size.
#[derive(Clone, Debug)]
pub struct PlanePencil {
    /// `i`, `j` and the matrices, rounded: they only ever search.
    terms: Vec<(usize, usize, Vec<DMatrix<f64>>)>,
    degree: usize,
    mirrored: bool,
}

impl PlanePencil {
    /// The set with the given coefficients `(i, j, B^{ij})`.
    ///
    /// # Panics
    /// If there are no matrices.
    pub fn new(terms: &[(u32, u32, Vec<Matrix<Rational>>)]) -> Self {
        assert!(terms.iter().any(|(_, _, set)| !set.is_empty()), "a set of matrices is not empty");
        let mirrored = terms.iter().all(|(_, _, set)| is_mirrored(set));
        let rounded = |matrix: &Matrix<Rational>| {
            let (rows, columns) = matrix.shape();
            DMatrix::from_fn(rows, columns, |i, j| approximate(matrix.entry(i, j)))
        };
        let terms: Vec<_> = terms
            .iter()
            .map(|(i, j, set)| (*i as usize, *j as usize, set.iter().map(rounded).collect()))
            .collect();
        let degree = terms.iter().map(|(i, j, _)| i + j).max().unwrap_or(0);
        PlanePencil { terms, degree, mirrored }
    }

    /// The number of matrices.
    pub(crate) fn letters(&self) -> usize {
        self.terms[0].2.len()
    }

    /// Whether `B_{m-1-ε} = J B_ε J` for the reversal `J` of coordinates.
    pub(crate) fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// The matrices at a point.
    pub(crate) fn at(&self, place: Place) -> Vec<DMatrix<f64>> {
        self.polar(&vec![place; self.degree])
    }

    /// The matrices at all control points of a polygon one after the other: the values of the polar
    /// form at the multisets of its corners.
    pub(crate) fn controls(&self, corners: &[Place]) -> Vec<Vec<DMatrix<f64>>> {
        let sets = multisets(corners.len(), self.degree).into_iter();
        sets.map(|set| self.polar(&set.into_iter().map(|i| corners[i]).collect::<Vec<_>>()))
            .collect()
    }

    /// The polar form at as many points as the degree says.
    fn polar(&self, places: &[Place]) -> Vec<DMatrix<f64>> {
        let weights = elementary(places);
        let mut sum: Vec<DMatrix<f64>> = self.terms[0].2.iter().map(|m| m * 0.0).collect();
        for (i, j, set) in &self.terms {
            let weight = weights[*i][*j] / multinomial(self.degree, *i, *j);
            for (s, matrix) in sum.iter_mut().zip(set) {
                s.zip_apply(matrix, |s, x| *s += weight * x);
            }
        }
        sum
    }
}

/// The coefficients of `X^i Y^j` in `Π (X x_k + Y y_k + 1)`.
fn elementary(places: &[Place]) -> Vec<Vec<f64>> {
    let n = places.len();
    let mut product = vec![vec![0.0; n + 1]; n + 1];
    product[0][0] = 1.0;
    for (k, [x, y]) in places.iter().enumerate() {
        for i in (0..=k).rev() {
            for j in (0..=k - i).rev() {
                let c = product[i][j];
                product[i + 1][j] += c * x;
                product[i][j + 1] += c * y;
            }
        }
    }
    product
}

/// `n! / (i! j! (n-i-j)!)`.
fn multinomial(n: usize, i: usize, j: usize) -> f64 {
    let factorial = |k: usize| (1..=k).map(|k| k as f64).product::<f64>();
    factorial(n) / (factorial(i) * factorial(j) * factorial(n - i - j))
}

/// All multisets of so many of the numbers below `count`, in the order of the certificate.
fn multisets(count: usize, size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    let longer = |set: Vec<usize>| {
        let from = set.last().copied().unwrap_or(0);
        (from..count).map(move |i| [&set[..], &[i]].concat())
    };
    multisets(count, size - 1).into_iter().flat_map(longer).collect()
}
