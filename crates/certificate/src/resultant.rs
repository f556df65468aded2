//! Resultants of polynomials in `z` of which the coefficients are polynomials in the parameter.

use refinable_algebra::{Integer, Polynomial, Ring};

use crate::determinant::determinant;
use crate::work::{Check, Work, polynomial_bits};

/// Ascending coefficients in `z`, as many as the degree says, though the last may be zero.
pub(crate) type Coefficients = Vec<Polynomial<Integer>>;

/// The resultant of two polynomials up to its sign, the second padded with zeros to the degree `n`
/// of the first: the determinant of Bezout's matrix. (For each zero it is multiplied by the leading
/// coefficient of the first.) It is 1 for two constants, even where both vanish.
///
/// The matrix has the entries of `(a(x) b(y) - a(y) b(x)) / (x - y)`.
pub(crate) fn resultant(
    a: &Coefficients,
    b: &Coefficients,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let n = a.len().saturating_sub(1);
    let (length_a, bits_a) = size(a);
    let (length_b, bits_b) = size(b);
    work.products(n * n * length_a * length_b, bits_a, bits_b)?;
    let zero = Polynomial::zero();
    let b = |k: usize| b.get(k).unwrap_or(&zero);
    let mut matrix = vec![Polynomial::zero(); n * n];
    for i in 0..n {
        for j in i..n {
            // All a_p b_q - a_q b_p with p + q = i + j + 1, q ≤ i.
            let mut entry = a[j + 1].times(b(i)).minus(&a[i].times(b(j + 1)));
            if i > 0 && j + 1 < n {
                entry = entry.plus(&matrix[(i - 1) * n + j + 1]);
            }
            matrix[j * n + i] = entry.clone();
            matrix[i * n + j] = entry;
        }
    }
    let degree = n * (length_a.saturating_sub(1) + length_b.saturating_sub(1));
    determinant(n, &matrix, degree, work)
}

/// The polynomial of the same degree of which the roots are the squares of those of `f`: up to the
/// sign `f(z) f(-z)`, as a polynomial in `z²`.
pub(crate) fn of_squares(f: &Coefficients, work: &mut Work) -> Check<Coefficients> {
    let (length, bits) = size(f);
    work.products(f.len() * f.len() * length * length, bits, bits)?;
    let mut squares = vec![Polynomial::zero(); f.len()];
    for (i, a) in f.iter().enumerate() {
        for (j, b) in f.iter().enumerate().filter(|(j, _)| (i + j).is_multiple_of(2)) {
            let product = a.times(b);
            let product = if j.is_multiple_of(2) { product } else { product.negated() };
            let sum = &mut squares[(i + j) / 2];
            *sum = sum.plus(&product);
        }
    }
    Ok(squares)
}

/// The largest number of coefficients in the parameter, and of bits.
fn size(f: &Coefficients) -> (usize, u64) {
    let length = f.iter().map(|c| c.coefficients().len()).max().unwrap_or(0);
    (length, f.iter().map(polynomial_bits).max().unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::integer;

    /// The coefficients of `lead Π (z - r)`, each root a polynomial in `t`.
    fn from_roots(lead: i64, roots: &[&[i64]]) -> Coefficients {
        let mut product = vec![polynomial(&[lead])];
        for root in roots {
            let root = polynomial(root);
            let mut next = vec![Polynomial::zero()];
            next.extend(product.iter().cloned());
            for (c, p) in next.iter_mut().zip(&product) {
                *c = c.minus(&root.times(p));
            }
            product = next;
        }
        product
    }

    fn polynomial(c: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(c.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn resultants_are_products_over_the_roots() {
        let (r, s) = ([&[1, 2][..], &[0, -1], &[5]], [&[0, 1][..], &[3, 0, 1], &[-2]]);
        for count in 0..=3 {
            let (a, b) = (from_roots(3, &r), from_roots(2, &s[..count]));
            // 3^3 2^3 Π (r_i - s_j): for each missing root the leading coefficient counts.
            let mut expected = polynomial(&[27 * 8]);
            for (r, s) in r.iter().flat_map(|r| s[..count].iter().map(move |s| (r, s))) {
                expected = expected.times(&polynomial(r).minus(&polynomial(s)));
            }
            let got = resultant(&a, &b, &mut Work::new()).unwrap();
            assert!(got == expected || got.negated() == expected, "{count}");
        }
    }

    #[test]
    fn the_roots_are_squared() {
        let f = from_roots(3, &[&[1, 2], &[0, -1], &[5]]);
        let squares = from_roots(-9, &[&[1, 4, 4], &[0, 0, 1], &[25]]);
        assert_eq!(of_squares(&f, &mut Work::new()), Ok(squares));
        assert_eq!(
            of_squares(&vec![polynomial(&[7])], &mut Work::new()),
            Ok(vec![polynomial(&[49])])
        );
    }
}
