//! Determinants and characteristic polynomials.

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Integer, Matrix, ParameterPolynomial, Polynomial, Rational, Ring, integer,
};

use crate::generate::{
    fraction, matrix, parameter_polynomial, short, square, value, values, whole,
};

/// `Σ_π sign(π) Π_i m[i][π(i)]`, by expansion along the rows: `row` is the first row not yet used,
/// `free` are the columns not yet used, ascending.
fn leibniz<R: Ring>(m: &Matrix<R>, row: usize, free: &[usize]) -> R {
    if free.is_empty() {
        return R::one();
    }
    let mut sum = R::zero();
    for (k, &column) in free.iter().enumerate() {
        let rest: Vec<usize> = free.iter().copied().filter(|c| *c != column).collect();
        let product = m.entry(row, column).times(&leibniz(m, row + 1, &rest));
        sum = if k % 2 == 0 { sum.plus(&product) } else { sum.minus(&product) };
    }
    sum
}

fn leibniz_determinant<R: Ring>(m: &Matrix<R>) -> R {
    let columns: Vec<usize> = (0..m.shape().1).collect();
    leibniz(m, 0, &columns)
}

/// `x I - m`
fn shifted<R: Ring>(m: &Matrix<R>, x: &R) -> Matrix<R> {
    let (n, _) = m.shape();
    Matrix::from_fn(n, n, |i, j| {
        let diagonal = if i == j { x.clone() } else { R::zero() };
        diagonal.minus(m.entry(i, j))
    })
}

/// `p(m)` by Horner's rule.
fn at_matrix(p: &Polynomial<Integer>, m: &Matrix<Integer>) -> Matrix<Integer> {
    let (n, _) = m.shape();
    let zero = Matrix::from_fn(n, n, |_, _| integer(0));
    p.coefficients().iter().rev().fold(zero, |sum, c| {
        let product = sum.times(m);
        Matrix::from_fn(n, n, |i, j| {
            let constant = if i == j { c.clone() } else { integer(0) };
            product.entry(i, j) + constant
        })
    })
}

proptest! {
    #[test]
    fn the_determinant_is_the_sum_over_permutations(m in matrix(whole(), 4)) {
        prop_assert_eq!(m.determinant(), leibniz_determinant(&m));
    }

    #[test]
    fn the_determinant_over_parameters_is_the_sum_over_permutations(
        m in matrix(parameter_polynomial(2, 2), 3),
    ) {
        prop_assert_eq!(m.determinant(), leibniz_determinant(&m));
    }

    #[test]
    fn the_determinant_is_multiplicative(
        n in 1usize..=5,
        a in vec(short(), 25),
        b in vec(short(), 25),
    ) {
        let (a, b) = (square(n, &a), square(n, &b));
        prop_assert_eq!(a.times(&b).determinant(), a.determinant() * b.determinant());
    }

    #[test]
    fn a_matrix_is_a_zero_of_its_characteristic_polynomial(m in matrix(whole(), 6)) {
        let (n, _) = m.shape();
        let zero = Matrix::from_fn(n, n, |_, _| integer(0));
        prop_assert_eq!(at_matrix(&m.characteristic_polynomial(), &m), zero);
    }

    #[test]
    fn the_characteristic_polynomial_is_the_determinant_at_every_integer(
        m in matrix(whole(), 5),
        x in short(),
    ) {
        let p = m.characteristic_polynomial();
        prop_assert_eq!(p.degree(), Some(m.shape().0));
        prop_assert_eq!(p.evaluate(&x), shifted(&m, &x).determinant());
    }

    #[test]
    fn the_characteristic_polynomial_is_the_sum_over_permutations(
        m in matrix(fraction(), 4),
    ) {
        // The matrix x I - m over Q[x].
        let over_polynomials = Matrix::from_fn(m.shape().0, m.shape().0, |i, j| {
            Polynomial::<Rational>::constant(m.entry(i, j).clone())
        });
        let determinant = leibniz_determinant(&shifted(&over_polynomials, &Polynomial::variable()));
        prop_assert_eq!(m.characteristic_polynomial(), determinant);
    }

    #[test]
    fn the_characteristic_polynomial_commutes_with_substitution(
        m in matrix(parameter_polynomial(2, 2), 4),
        values in values(),
    ) {
        let (n, _) = m.shape();
        let at = |c: &ParameterPolynomial| value(c, &values);
        let numbers = Matrix::from_fn(n, n, |i, j| at(m.entry(i, j)));
        let substituted = m.characteristic_polynomial().map(at);
        prop_assert_eq!(substituted, numbers.characteristic_polynomial());
    }

    #[test]
    fn the_identity_is_neutral(m in matrix(short(), 4)) {
        let one = Matrix::identity(m.shape().0);
        prop_assert_eq!(&m.times(&one), &m);
        prop_assert_eq!(&one.times(&m), &m);
    }
}
