//! Are all eigenvalues inside the unit circle?

use refinable_algebra::{Integer, Matrix, Ordered, Polynomial, Ring};

/// Whether all complex roots of the polynomial are of modulus less than 1.
///
/// # Source
/// I. Schur, *Über Potenzreihen, die im Innern des Einheitskreises beschränkt sind*, 1917, and A.
/// Cohn, 1922: with `p*` the reversed polynomial, `p` has this property iff `|p_0| < |p_n|` and
/// `(p_n p - p_0 p*) / z` has it.
pub(crate) fn is_schur_stable(polynomial: &Polynomial<Integer>) -> bool {
    let mut p = polynomial.coefficients().to_vec();
    while p.len() > 1 {
        let (first, last) = (p[0].clone(), p[p.len() - 1].clone());
        if first.absolute() >= last.absolute() {
            return false;
        }
        let reduced = (1..p.len()).map(|i| &last * &p[i] - &first * &p[p.len() - 1 - i]);
        p = Polynomial::new(reduced.collect()).primitive_part().coefficients().to_vec();
    }
    !p.is_empty()
}

/// A polynomial whose zeros include all `x` at which two eigenvalues, not necessarily different in
/// value, multiply to 1: `a_n^(n-1) Π_{i<j} (1 - λ_i λ_j)` for `Σ a_k λ^k`.
///
/// # Source
/// E. I. Jury, *Inners and stability of dynamic systems*, 1974.
pub(crate) fn inner_determinant(
    characteristic: &Polynomial<Polynomial<Integer>>,
) -> Polynomial<Integer> {
    let n = characteristic.degree().expect("a characteristic polynomial is not zero");
    let a = |k: usize| characteristic.coefficient(k);
    let size = n.saturating_sub(1);
    let inner = Matrix::from_fn(size, size, |i, j| {
        let upper = if j >= i { a(n - (j - i)) } else { Polynomial::zero() };
        let lower = if i + j + 2 <= n { a(n - 2 - i - j) } else { Polynomial::zero() };
        upper.minus(&lower)
    });
    inner.determinant()
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::integer;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn roots_inside_on_and_outside() {
        assert!(is_schur_stable(&poly(&[1, 0, 2])));
        assert!(!is_schur_stable(&poly(&[1, 0, 1])));
        assert!(!is_schur_stable(&poly(&[2, 0, 1])));
        // (2z-1)(3z+1)(2z²+z+1)
        assert!(is_schur_stable(&poly(&[-1, -2, 3, 4, 12])));
        assert!(is_schur_stable(&poly(&[5])));
    }

    /// Roots 2, 3, x: (1-6)(1-2x)(1-3x).
    #[test]
    fn the_inner_determinant_is_the_product_over_pairs() {
        let constant = |n| poly(&[n]);
        let x = poly(&[0, 1]);
        let linear = |root: Polynomial<Integer>| Polynomial::new(vec![root.negated(), constant(1)]);
        let p = linear(constant(2)).times(&linear(constant(3))).times(&linear(x));
        let expected = constant(-5).times(&poly(&[1, -2])).times(&poly(&[1, -3]));
        assert_eq!(inner_determinant(&p), expected);
    }
}
