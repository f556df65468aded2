//! Sets of matrices that are polynomials in two variables.

use nalgebra::DMatrix;
use refinable_algebra::{Matrix, Rational};

use crate::float::approximate;
use crate::geometry::Place;
use crate::pencil::is_mirrored;

/// The matrices `B_ε(x, y) = Σ x^i y^j B_ε^{ij} / d(x, y)`, all of one size.
#[derive(Clone, Debug)]
pub struct PlanePencil {
    /// `i`, `j` and the matrices, rounded: they only ever search.
    terms: Vec<(i32, i32, Vec<DMatrix<f64>>)>,
    /// `i`, `j` and the coefficients of `d`.
    denominator: Vec<(i32, i32, f64)>,
    mirrored: bool,
}

/// Nearer to zero than this the denominator is taken for it: growth near a pole is large, and finite.
const POLE: f64 = 1e-12;

impl PlanePencil {
    /// The set with the given coefficients `(i, j, B^{ij})`, and the denominator one.
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
            .map(|(i, j, set)| (*i as i32, *j as i32, set.iter().map(rounded).collect()))
            .collect();
        PlanePencil { terms, denominator: vec![(0, 0, 1.0)], mirrored }
    }

    /// The same over the denominator with the given coefficients `(i, j, d^{ij})`.
    pub fn over(self, denominator: &[(u32, u32, Rational)]) -> Self {
        let rounded = |(i, j, c): &(u32, u32, Rational)| (*i as i32, *j as i32, approximate(c));
        PlanePencil { denominator: denominator.iter().map(rounded).collect(), ..self }
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
        let [x, y] = place;
        let power = |i: i32, j: i32| x.powi(i) * y.powi(j);
        let denominator: f64 = self.denominator.iter().map(|(i, j, c)| c * power(*i, *j)).sum();
        let denominator = denominator.abs().max(POLE).copysign(denominator);
        let mut sum: Vec<DMatrix<f64>> = self.terms[0].2.iter().map(|m| m * 0.0).collect();
        for (i, j, set) in &self.terms {
            let weight = power(*i, *j) / denominator;
            for (s, matrix) in sum.iter_mut().zip(set) {
                s.zip_apply(matrix, |s, x| *s += weight * x);
            }
        }
        sum
    }

    /// The matrices `B_ε`, or, if they are mirrored, the `B_ε` and `B_ε J` for `2 ε < m`: their products are
    /// those of the `B_ε`, up to a `J` on the left.
    pub(crate) fn letters_at(&self, place: Place) -> Vec<DMatrix<f64>> {
        let mut matrices = self.at(place);
        if self.mirrored {
            matrices.truncate(self.letters().div_ceil(2));
            let reversed = |m: &DMatrix<f64>| {
                DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(i, m.ncols() - 1 - j)])
            };
            let both = |m: DMatrix<f64>| {
                let reversed = reversed(&m);
                [m, reversed]
            };
            matrices = matrices.into_iter().flat_map(both).collect();
        }
        matrices
    }
}
