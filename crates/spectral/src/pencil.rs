//! Sets of matrices that are affine in one variable.

use crate::float::approximate;
use nalgebra::DMatrix;
use refinable_algebra::{Integer, Matrix, Polynomial, Rational, Ring, clear_denominators};

/// The matrices `B_ε(x) = P_ε + x Q_ε`, all of one size `d × d`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Pencil {
    constant: Vec<Matrix<Rational>>,
    slope: Vec<Matrix<Rational>>,
    mirrored: bool,
}

impl Pencil {
    /// The pencil with the given `P_ε` and `Q_ε`.
    ///
    /// # Panics
    /// If there is no matrix, or they are not square and of one size.
    pub fn new(constant: Vec<Matrix<Rational>>, slope: Vec<Matrix<Rational>>) -> Self {
        let shape = constant.first().expect("a set of matrices is not empty").shape();
        assert!(shape.0 == shape.1 && shape.0 > 0, "the matrices are square");
        assert_eq!(constant.len(), slope.len(), "every matrix has a slope");
        assert!(constant.iter().chain(&slope).all(|m| m.shape() == shape), "of one size");
        let mirrored = is_mirrored(&constant) && is_mirrored(&slope);
        Pencil { constant, slope, mirrored }
    }

    /// The size `d`.
    pub fn dimension(&self) -> usize {
        self.constant[0].shape().0
    }

    /// The number of matrices.
    pub fn letters(&self) -> usize {
        self.constant.len()
    }

    /// Whether `B_{m-1-ε} = J B_ε J` for the reversal `J` of coordinates.
    pub fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// The matrices at `x`, rounded.
    pub(crate) fn rounded_at(&self, x: f64) -> Vec<DMatrix<f64>> {
        let d = self.dimension();
        let entry = |m: &Matrix<Rational>, i, j| approximate(m.entry(i, j));
        let pairs = self.constant.iter().zip(&self.slope);
        pairs
            .map(|(p, q)| DMatrix::from_fn(d, d, |i, j| entry(p, i, j) + x * entry(q, i, j)))
            .collect()
    }

    /// A common denominator `D` and the matrices `D B_ε` as polynomials in `x`.
    pub(crate) fn cleared(&self) -> (Integer, Vec<Matrix<Polynomial<Integer>>>) {
        let d = self.dimension();
        let positions =
            (0..self.letters()).flat_map(|e| (0..d * d).map(move |k| (e, k / d, k % d)));
        let entries = positions
            .flat_map(|(e, i, j)| [self.constant[e].entry(i, j), self.slope[e].entry(i, j)]);
        let (denominator, cleared) = clear_denominators(entries);
        let matrices = (0..self.letters())
            .map(|e| {
                Matrix::from_fn(d, d, |i, j| {
                    let at = 2 * (e * d * d + i * d + j);
                    Polynomial::new(cleared[at..at + 2].to_vec())
                })
            })
            .collect();
        (denominator, matrices)
    }
}

/// Whether reversing coordinates exchanges the first matrix and the last, the second and the last but
/// one, and so on: `B_{m-1-ε} = J B_ε J`.
pub(crate) fn is_mirrored<R: Ring>(matrices: &[Matrix<R>]) -> bool {
    let d = matrices[0].shape().0;
    let mirror =
        |m: &Matrix<R>| Matrix::from_fn(d, d, |i, j| m.entry(d - 1 - i, d - 1 - j).clone());
    matrices.iter().zip(matrices.iter().rev()).all(|(a, b)| mirror(a) == *b)
}
