//! Determinants of matrices of polynomials, by evaluation at integers and interpolation.

use refinable_algebra::{Integer, Matrix, Polynomial, Rational, Ring, integer};

use crate::family::Letters;
use crate::work::{Check, Work, largest_bits, polynomial_bits, rational_bits};

/// The product of the matrices of a word: `entries(x^stretch) / denominator`.
pub(crate) struct Product {
    /// The size.
    pub dimension: usize,
    /// Row by row.
    pub entries: Vec<Polynomial<Integer>>,
    /// Positive.
    pub denominator: Integer,
    /// The power of `x` that the entries are polynomials in.
    pub stretch: usize,
    /// A bound for the degree of every sum of products of entries in different rows and columns,
    /// as they occur in a determinant.
    pub degree: usize,
}

impl Product {
    /// `Π_w = B_{w_l} … B_{w_1}`.
    pub fn new(letters: &Letters, word: &[usize], work: &mut Work) -> Check<Self> {
        let d = letters.dimension;
        let pure = letters.pairs.iter().all(|[p, _]| p.iter().all(Ring::is_zero));
        let power = |n: usize| letters.denominator.power(n as u32);
        let mut entries: Vec<_> = (0..d * d).map(|k| constant(k % (d + 1) == 0)).collect();
        for (step, &letter) in word.iter().enumerate() {
            let bits = letters.bits();
            work.products(
                2 * d * d * d * if pure { 1 } else { step + 1 },
                bits,
                step as u64 * bits,
            )?;
            let [p, q] = &letters.pairs[letter];
            // A product of multiples of x is the product of the matrices times a power of x.
            entries = if pure {
                multiply(d, |k| Polynomial::constant(q[k].clone()), &entries)
            } else {
                multiply(d, |k| Polynomial::new(vec![p[k].clone(), q[k].clone()]), &entries)
            };
        }
        let (stretch, degree) = if pure {
            entries = entries.iter().map(|e| e.shifted(1)).map(trimmed).collect();
            (word.len(), d)
        } else {
            (1, word.iter().map(|&letter| rank_bound(d, &letters.pairs[letter][1])).sum())
        };
        Ok(Product { dimension: d, entries, denominator: power(word.len()), stretch, degree })
    }

    /// `det(I - sign · Π_w(x))` as a polynomial in `x`, up to a positive factor.
    pub fn determinant(&self, sign: i32, work: &mut Work) -> Check<Polynomial<Integer>> {
        let d = self.dimension;
        let unit = Polynomial::constant(self.denominator.clone());
        let entry = |k: usize| {
            let e = if sign > 0 { self.entries[k].negated() } else { self.entries[k].clone() };
            if k.is_multiple_of(d + 1) { e.plus(&unit) } else { e }
        };
        let matrix: Vec<_> = (0..d * d).map(entry).collect();
        Ok(self.stretched(&determinant(d, &matrix, self.degree, work)?))
    }

    /// The polynomial with `x^stretch` in place of the variable.
    pub fn stretched(&self, polynomial: &Polynomial<Integer>) -> Polynomial<Integer> {
        let n = polynomial.coefficients().len();
        let mut spread = vec![Integer::zero(); n.saturating_sub(1) * self.stretch + n.min(1)];
        for (k, c) in polynomial.coefficients().iter().enumerate() {
            spread[k * self.stretch] = c.clone();
        }
        Polynomial::new(spread)
    }

    /// The numerators of `Π_w` where the entries' variable is `y`.
    pub fn at(&self, y: &Integer, work: &mut Work) -> Check<Matrix<Integer>> {
        let d = self.dimension;
        let longest = self.entries.iter().map(|e| e.coefficients().len()).max().unwrap_or(0);
        let bits = self.entries.iter().map(polynomial_bits).max().unwrap_or(0);
        work.products(d * d * longest, bits + longest as u64 * y.bits(), y.bits())?;
        Ok(Matrix::from_fn(d, d, |i, j| self.entries[i * d + j].evaluate(y)))
    }

    /// `x^stretch`.
    pub fn variable(&self, x: &Rational, work: &mut Work) -> Check<Rational> {
        let bits = rational_bits(x).saturating_mul(self.stretch as u64);
        work.products(8, bits, bits)?;
        Ok(Rational::new(
            x.numer().power(self.stretch as u32),
            x.denom().power(self.stretch as u32),
        ))
    }
}

fn constant(one: bool) -> Polynomial<Integer> {
    if one { Polynomial::one() } else { Polynomial::zero() }
}

fn trimmed(polynomial: Polynomial<Integer>) -> Polynomial<Integer> {
    Polynomial::new(polynomial.coefficients().to_vec())
}

/// `q^degree p(y)` for `y` of denominator `q`.
pub(crate) fn homogeneous(
    polynomial: &Polynomial<Integer>,
    y: &Rational,
    degree: usize,
) -> Integer {
    let mut value = Integer::zero();
    let mut power = y.denom().power((degree + 1 - polynomial.coefficients().len().max(1)) as u32);
    for c in polynomial.coefficients().iter().rev() {
        value = value * y.numer() + c * &power;
        power *= y.denom();
    }
    value
}

fn multiply(
    d: usize,
    left: impl Fn(usize) -> Polynomial<Integer>,
    right: &[Polynomial<Integer>],
) -> Vec<Polynomial<Integer>> {
    let mut product = vec![Polynomial::zero(); d * d];
    for k in 0..d * d {
        let (i, inner) = (k / d, k % d);
        let factor = left(k);
        if factor.is_zero() {
            continue;
        }
        for j in 0..d {
            product[i * d + j].add_product(&factor, &right[inner * d + j]);
        }
    }
    product
}

/// The smaller of the numbers of rows and of columns that are not zero.
fn rank_bound(d: usize, matrix: &[Integer]) -> usize {
    let rows = (0..d).filter(|i| matrix[i * d..(i + 1) * d].iter().any(|e| !e.is_zero()));
    let columns = (0..d).filter(|&j| (0..d).any(|i| !matrix[i * d + j].is_zero()));
    rows.count().min(columns.count())
}

/// The determinant of a matrix of integer polynomials, of which the degree is known not to exceed
/// `degree`.
pub(crate) fn determinant(
    size: usize,
    entries: &[Polynomial<Integer>],
    degree: usize,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let longest = entries.iter().map(|e| e.coefficients().len()).max().unwrap_or(0);
    let bits = entries.iter().map(polynomial_bits).max().unwrap_or(0);
    let entry_bits = bits + longest as u64 * degree.max(2).ilog2() as u64 + 2;
    let minor_bits = entry_bits * size as u64 / 2;
    work.products((degree + 1) * size * size * longest, entry_bits, 64)?;
    work.products((degree + 1) * size * size * size, minor_bits, minor_bits)?;
    let first = -(degree as i64 / 2);
    let value = |k: usize| {
        let x = integer(first + k as i64);
        Matrix::from_fn(size, size, |i, j| entries[i * size + j].evaluate(&x)).determinant()
    };
    interpolate((0..=degree).map(value).collect(), first, work)
}

/// The integer polynomial of degree at most `n` with the values at `first, first + 1, …, first + n`.
///
/// Newton's form: `n! p(x) = Σ_k Δ^k n!/k! (x - first) ⋯ (x - first - k + 1)`.
pub(crate) fn interpolate(
    mut values: Vec<Integer>,
    first: i64,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let n = values.len() - 1;
    let bits = largest_bits(&values);
    work.products(3 * n * n, bits + 8 * n as u64, 64)?;
    for step in 1..=n {
        for k in (step..=n).rev() {
            let (low, high) = values.split_at_mut(k);
            high[0] -= &low[k - 1];
        }
    }
    let mut factorial = integer(1);
    let mut sum: Vec<Integer> = Vec::with_capacity(n + 1);
    for k in (0..=n).rev() {
        // sum · (x - first - k) + Δ^k n!/k!
        let node = integer(-(first + k as i64));
        sum.push(Integer::zero());
        for j in (0..sum.len()).rev() {
            let below = if j > 0 { sum[j - 1].clone() } else { &values[k] * &factorial };
            sum[j] = &sum[j] * &node + below;
        }
        factorial *= integer(k.max(1) as i64);
    }
    Ok(Polynomial::new(sum.iter().map(|c| c / &factorial).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The letters `[[1, x], [0, 2]]` and `[[x, 0], [1, 1]]`.
    fn letters() -> Letters {
        let integers = |c: [i64; 4]| c.map(integer).to_vec();
        let pairs = [([1, 0, 0, 2], [0, 1, 0, 0]), ([0, 0, 1, 1], [1, 0, 0, 0])];
        let pairs = pairs.map(|(p, q)| [integers(p), integers(q)]).to_vec();
        Letters { dimension: 2, pairs, denominator: integer(3) }
    }

    #[test]
    fn words_are_applied_from_left_to_right() {
        let work = &mut Work::new();
        let product = Product::new(&letters(), &[0, 0, 1], work).unwrap();
        // [[x, 0], [1, 1]] [[1, 3x], [0, 4]] at x = 2.
        let expected = Matrix::from_fn(2, 2, |i, j| integer([[2, 12], [1, 10]][i][j]));
        assert_eq!(product.at(&integer(2), work), Ok(expected));
        assert_eq!((product.denominator.clone(), product.stretch), (integer(27), 1));
        // (27 ∓ x)(27 ∓ (3x + 4)) - 3x² for the two signs.
        let polynomial = |c: [i64; 2]| Polynomial::new(c.map(integer).to_vec());
        assert_eq!(product.determinant(1, work), Ok(polynomial([27 * 23, -81 - 23])));
        assert_eq!(product.determinant(-1, work), Ok(polynomial([27 * 31, 81 + 31])));
    }

    #[test]
    fn interpolation_returns_the_polynomial() {
        let p = Polynomial::new([3, -7, 0, 5, 0, 2].map(integer).to_vec());
        let values = |first: i64, n: i64| (first..=first + n).map(|x| p.evaluate(&integer(x)));
        for (first, n) in [(-2, 5), (0, 5), (-4, 9)] {
            let got = interpolate(values(first, n).collect(), first, &mut Work::new()).unwrap();
            assert_eq!(got, p);
        }
    }
}
