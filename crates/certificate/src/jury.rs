//! Eigenvalues and the unit circle.

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, binomial, integer};

use crate::determinant::{Product, determinant, homogeneous, interpolate};
use crate::gcd::primitive;
use crate::work::{Check, Work, largest_bits, polynomial_bits, rational_bits};

/// The characteristic polynomial of the product of a word up to a positive factor, by ascending
/// powers of `λ`; each coefficient is a polynomial in the variable of the entries.
pub(crate) struct Characteristic {
    coefficients: Vec<Polynomial<Integer>>,
    /// A bound for the degree of each coefficient.
    degree: usize,
}

impl Characteristic {
    /// From its values at integers.
    pub fn new(product: &Product, work: &mut Work) -> Check<Self> {
        let first = -(product.degree as i64 / 2);
        let mut values = vec![Vec::with_capacity(product.degree + 1); product.dimension + 1];
        for k in 0..=product.degree {
            let y = integer(first + k as i64);
            let polynomial = characteristic_value(product, &y, work)?;
            for (k, of) in values.iter_mut().enumerate() {
                of.push(polynomial.coefficient(k));
            }
        }
        let coefficients = values.into_iter().map(|of| interpolate(of, first, work));
        Ok(Characteristic {
            coefficients: coefficients.collect::<Check<_>>()?,
            degree: product.degree,
        })
    }

    /// `Π_{i<j} (1 - λ_i λ_j)` over the eigenvalues, up to a positive factor: the determinant of
    /// Jury's inner matrix, of order `d-1`.
    pub fn circle_determinant(&self, work: &mut Work) -> Check<Polynomial<Integer>> {
        let entries = inner_matrix(&self.coefficients);
        let size = self.coefficients.len() - 2;
        determinant(size, &entries, size * self.degree, work)
    }

    /// The polynomial where the entries' variable is `y`, up to a positive factor.
    fn at(&self, y: &Rational, work: &mut Work) -> Check<Polynomial<Integer>> {
        let bits = largest_bits(self.coefficients.iter().flat_map(Polynomial::coefficients));
        let size = bits.saturating_add((self.degree as u64).saturating_mul(rational_bits(y)));
        let products = 3 * self.coefficients.len() * (self.degree + 1);
        work.products(products, size, rational_bits(y))?;
        let value = |c: &Polynomial<Integer>| homogeneous(c, y, self.degree);
        Ok(Polynomial::new(self.coefficients.iter().map(value).collect()))
    }

    /// A polynomial that is positive wherever all eigenvalues are inside the open unit disc, but not
    /// at `y`, if it is easily found: one of [`inequalities`].
    pub fn witness(&self, y: &Rational, work: &mut Work) -> Check<Option<Polynomial<Integer>>> {
        let value = self.at(y, work)?;
        let d = self.coefficients.len() - 1;
        let bits = polynomial_bits(&value);
        for weights in inequalities(d as u32) {
            work.products(d + 1, bits, largest_bits(&weights))?;
            let sum: Integer = weights.iter().zip(value.coefficients()).map(|(w, c)| w * c).sum();
            if sum.compare_to_zero().is_gt() {
                continue;
            }
            work.products((d + 1) * (self.degree + 1), bits, largest_bits(&weights))?;
            let terms = weights.iter().zip(&self.coefficients).map(|(w, c)| c.scaled(w));
            return Ok(Some(terms.fold(Polynomial::zero(), |sum, term| sum.plus(&term))));
        }
        Ok(None)
    }

    /// Whether all eigenvalues are inside the open unit disc where the entries' variable is `y`, by
    /// the test of Schur and Cohn.
    pub fn is_schur_stable(&self, y: &Rational, work: &mut Work) -> Check<bool> {
        let mut p = self.at(y, work)?;
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
}

/// Linear inequalities `Σ_k w_k a_k > 0` for the coefficients of a real polynomial `Σ a_k λ^k` of
/// degree `d`, `a_d > 0`, with all roots in the open unit disc: the elementary symmetric functions
/// of the roots are less than binomial coefficients, and there is no root in `[s, ∞)`, nor in
/// `(-∞, -s]`, if `s ≥ 1`.
fn inequalities(d: u32) -> impl Iterator<Item = Vec<Integer>> {
    let symmetric = (1..=d).flat_map(move |k| {
        [1, -1].map(|sign| {
            let mut weights = vec![Integer::zero(); d as usize + 1];
            weights[(d - k) as usize] = integer(sign);
            weights[d as usize] = binomial(d, k);
            weights
        })
    });
    let quarters = [5, 6, 8, 12, 16, 32, 64].into_iter().flat_map(move |s| {
        [1, -1].map(|sign| {
            let weight =
                |k| integer(s).power(k) * integer(4).power(d - k) * integer(sign).power(d - k);
            (0..=d).map(weight).collect()
        })
    });
    symmetric.chain(quarters)
}

/// The characteristic polynomial at one integer up to a positive factor, which is the same for all.
fn characteristic_value(
    product: &Product,
    y: &Integer,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let matrix = product.at(y, work)?;
    let d = product.dimension;
    let bits = (0..d * d).map(|k| matrix.entry(k / d, k % d).bits()).max().unwrap_or(0);
    work.products(d.pow(4), bits * d as u64, bits)?;
    let polynomial = matrix.characteristic_polynomial();
    let mut power = integer(1);
    let mut coefficients = Vec::with_capacity(d + 1);
    for c in polynomial.coefficients() {
        coefficients.push(c * &power);
        power *= &product.denominator;
    }
    Ok(Polynomial::new(coefficients))
}

/// `X - Y` row by row with `X[i][j] = a_{d-j+i}`, `Y[i][j] = a_{d-2-i-j}`, of order `d-1`: the determinant is
/// `a_d^(d-1) Π_{i<j} (1 - λ_i λ_j)` for the roots of `Σ a_k λ^k` (Jury 1974).
pub(crate) fn inner_matrix<R: Ring>(a: &[R]) -> Vec<R> {
    let d = a.len() - 1;
    let size = d - 1;
    let entry = |k: usize| {
        let (i, j) = (k / size, k % size);
        let upper = if j >= i { a[d - (j - i)].clone() } else { R::zero() };
        match (d - 2).checked_sub(i + j) {
            Some(k) => upper.minus(&a[k]),
            None => upper,
        }
    };
    (0..size * size).map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::Letters;

    fn from_roots(roots: &[i64]) -> Polynomial<Integer> {
        let factor = |&r: &i64| Polynomial::new(vec![integer(-r), integer(1)]);
        roots.iter().map(factor).fold(Polynomial::one(), |p, f| p.times(&f))
    }

    /// With all roots but one in the disc, or all.
    #[test]
    fn inequalities_hold_for_stable_polynomials() {
        let holds = |p: &Polynomial<Integer>| {
            let sum = |w: Vec<Integer>| {
                w.iter().zip(p.coefficients()).map(|(w, c)| w * c).sum::<Integer>()
            };
            let d = p.degree().unwrap() as u32;
            inequalities(d).all(|w| sum(w).compare_to_zero().is_gt())
        };
        // Quarters, so that the roots 3/4, ±1, 5/4 and more may occur.
        let quarters = |roots: &[i64]| {
            let factor = |&r: &i64| Polynomial::new(vec![integer(-r), integer(4)]);
            roots.iter().map(factor).fold(Polynomial::one(), |p, f| p.times(&f))
        };
        for stable in
            [&[3][..], &[-3], &[3, 3, 3, 3], &[-3, -3, -3], &[3, -3, 0], &[3, 2, 1, 0, -1]]
        {
            assert!(holds(&quarters(stable)), "{stable:?}");
        }
        for unstable in
            [&[4][..], &[-4], &[4, 4, 4], &[7, 0], &[-7, 0], &[5, 3], &[40, 40], &[30, 4, 4]]
        {
            assert!(!holds(&quarters(unstable)), "{unstable:?}");
        }
    }

    #[test]
    fn its_values_at_one_and_minus_one_are_the_determinants() {
        let integers = |c: [i64; 4]| c.map(integer).to_vec();
        let pairs = [([1, 0, 0, 2], [0, 1, 0, 0]), ([0, 0, 1, 1], [1, 0, 0, 0])];
        let pairs = pairs.map(|(p, q)| [integers(p), integers(q)]).to_vec();
        let letters = Letters { dimension: 2, pairs, denominator: integer(3) };
        let work = &mut Work::new();
        let product = Product::new(&letters, &[0, 1, 0], work).unwrap();
        let [a, b, c] =
            Characteristic::new(&product, work).unwrap().coefficients.try_into().unwrap();
        assert_eq!(product.determinant(1, work), Ok(a.plus(&b).plus(&c)));
        assert_eq!(product.determinant(-1, work), Ok(a.minus(&b).plus(&c)));
    }

    #[test]
    fn stability_is_strict() {
        let stable = |coefficients: &[i64]| {
            let coefficients = coefficients.iter().map(|&c| Polynomial::constant(integer(c)));
            let characteristic = Characteristic { coefficients: coefficients.collect(), degree: 0 };
            characteristic.is_schur_stable(&Rational::from(integer(0)), &mut Work::new()).unwrap()
        };
        assert!(stable(&[-1, 2]) && stable(&[1, 0, 2]) && stable(&[-1, 3, -3, 8]));
        assert!(!stable(&[-1, 1]) && !stable(&[1, 1]) && !stable(&[3, 2]));
        // (λ² + 1)(4λ - 1), (λ² + λ + 1)(4λ - 1), (λ² - 1) 3λ.
        assert!(!stable(&[-1, 4, -1, 4]) && !stable(&[-1, 3, 3, 4]) && !stable(&[0, -3, 0, 3]));
    }

    #[test]
    fn the_circle_determinant_has_its_degree() {
        // (λ - y)(λ - 2y)(λ - 3)
        let polynomial = |c: &[i64]| Polynomial::new(c.iter().map(|&c| integer(c)).collect());
        let coefficients = [&[0, 0, -6][..], &[0, 9, 2], &[-3, -3], &[1]].map(polynomial).to_vec();
        let characteristic = Characteristic { coefficients, degree: 2 };
        let expected = [&[1, 0, -2][..], &[1, -3], &[1, -6]].map(polynomial);
        let expected = expected.iter().fold(Polynomial::one(), |p, f| p.times(f));
        assert_eq!(characteristic.circle_determinant(&mut Work::new()), Ok(expected));
        let value = characteristic.at(&Rational::new(integer(1), integer(2)), &mut Work::new());
        // 4 (λ - 1/2)(λ - 1)(λ - 3)
        assert_eq!(value, Ok(polynomial(&[-6, 20, -18, 4])));
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
            let coefficients = from_roots(roots).coefficients().to_vec();
            let coefficients = coefficients.into_iter().map(Polynomial::constant).collect();
            let characteristic = Characteristic { coefficients, degree: 0 };
            let got = characteristic.circle_determinant(&mut Work::new()).unwrap();
            assert_eq!(got, Polynomial::constant(expected), "{roots:?}");
        }
    }
}
