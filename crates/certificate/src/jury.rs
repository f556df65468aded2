//! Eigenvalues and the unit circle.

use refinable_algebra::{Integer, Matrix, Ordered, Polynomial, Rational, Ring, integer};

use crate::determinant::{Product, interpolate};
use crate::gcd::primitive;
use crate::work::{Check, Work, polynomial_bits};

/// `Π_{i<j} (1 - λ_i λ_j)` over the eigenvalues of the product of a word, as a polynomial in `x`,
/// up to a positive factor: the determinant of Jury's inner matrix.
pub(crate) fn circle_determinant(product: &Product, work: &mut Work) -> Check<Polynomial<Integer>> {
    // Each coefficient of the characteristic polynomial has at most the degree of the product.
    let degree = product.degree * (product.dimension - 1);
    let first = -(degree as i64 / 2);
    let mut values = Vec::with_capacity(degree + 1);
    for k in 0..=degree {
        let y = Rational::from(integer(first + k as i64));
        values.push(inner_determinant(&characteristic(product, &y, work)?, work)?);
    }
    Ok(product.stretched(&interpolate(values, first, work)?))
}

/// Whether all eigenvalues are inside the open unit disc where the entries' variable is `y`, by
/// the test of Schur and Cohn.
pub(crate) fn is_schur_stable(product: &Product, y: &Rational, work: &mut Work) -> Check<bool> {
    let mut p = characteristic(product, y, work)?;
    while let Some(degree) = p.degree().filter(|&n| n > 0) {
        p = primitive(&p, work)?;
        let (low, high) = (p.coefficient(0), p.coefficient(degree));
        if low.absolute() >= high.absolute() {
            return Ok(false);
        }
        let bits = polynomial_bits(&p);
        work.products(2 * degree, bits, bits)?;
        // (a_n p - a_0 p*) / λ, with p* the reversed polynomial.
        let step =
            (1..=degree).map(|k| &high * p.coefficient(k) - &low * p.coefficient(degree - k));
        p = Polynomial::new(step.collect());
    }
    Ok(true)
}

/// The characteristic polynomial of the product of a word, up to a positive factor.
fn characteristic(product: &Product, y: &Rational, work: &mut Work) -> Check<Polynomial<Integer>> {
    let (matrix, denominator) = product.at(y, work)?;
    let d = product.dimension;
    let bits = (0..d * d).map(|k| matrix.entry(k / d, k % d).bits()).max().unwrap_or(0);
    work.products(d.pow(4), bits * d as u64, bits)?;
    let polynomial = matrix.characteristic_polynomial();
    let mut power = integer(1);
    let mut coefficients = Vec::with_capacity(d + 1);
    for c in polynomial.coefficients() {
        coefficients.push(c * &power);
        power *= &denominator;
    }
    Ok(Polynomial::new(coefficients))
}

/// `det(X - Y)` with `X[i][j] = a_{d-j+i}`, `Y[i][j] = a_{d-2-i-j}`, of order `d-1`.
fn inner_determinant(p: &Polynomial<Integer>, work: &mut Work) -> Check<Integer> {
    let d = p.degree().expect("a characteristic polynomial is not zero");
    let size = d.saturating_sub(1);
    let bits = polynomial_bits(p) * d as u64 / 2;
    work.products(size.pow(3), bits, bits)?;
    let entry = |i: usize, j: usize| {
        let upper = if j >= i { p.coefficient(d - (j - i)) } else { Integer::zero() };
        let lower = (d - 2).checked_sub(i + j).map_or_else(Integer::zero, |k| p.coefficient(k));
        upper - lower
    };
    Ok(Matrix::from_fn(size, size, entry).determinant())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from_roots(roots: &[i64]) -> Polynomial<Integer> {
        let factor = |&r: &i64| Polynomial::new(vec![integer(-r), integer(1)]);
        roots.iter().map(factor).fold(Polynomial::one(), |p, f| p.times(&f))
    }

    #[test]
    fn the_inner_determinant_is_the_product_over_pairs() {
        for roots in [&[2, 3][..], &[2, 3, -5], &[1, -2, 4, 7], &[3, -3, 2, 5, -1], &[4]] {
            let mut expected = integer(1);
            for (i, a) in roots.iter().enumerate() {
                for b in &roots[..i] {
                    expected *= integer(1 - a * b);
                }
            }
            let got = inner_determinant(&from_roots(roots), &mut Work::new()).unwrap();
            assert_eq!(got, expected, "{roots:?}");
        }
    }
}
