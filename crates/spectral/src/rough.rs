//! From below: where the product along a word has spectral radius at least one.

use std::slice;

use refinable_algebra::{Integer, Matrix, Polynomial, Rational, Ring};
use refinable_reals::{Interval, Region, real_roots};

use crate::pencil::is_mirrored;
use crate::schur::{inner_determinant, is_schur_stable};
use crate::word::Word;

/// The product along a word, up to the factor `D^l` for the common denominator `D` of the pencil.
#[derive(Clone, Debug)]
pub(crate) struct Product {
    matrix: Matrix<Polynomial<Integer>>,
    factor: Integer,
    /// `J Π_u` and its factor, if the matrices are mirrored and the word is `u` followed by its mirror
    /// image: then `Π_w = (J Π_u)²`.
    root: Option<(Matrix<Polynomial<Integer>>, Integer)>,
}

impl Product {
    /// The product of the cleared matrices along the word.
    pub fn new(cleared: &(Integer, Vec<Matrix<Polynomial<Integer>>>), word: &Word) -> Self {
        let (denominator, matrices) = cleared;
        let d = matrices[0].shape().0;
        let along = |letters: &[u8]| {
            let factors = letters.iter().map(|&letter| &matrices[usize::from(letter)]);
            factors.fold(Matrix::identity(d), |product, m| m.times(&product))
        };
        let factor = |length: usize| denominator.power(length as u32);
        let letters = word.letters();
        let half = &letters[..letters.len() / 2];
        let root = (is_mirrored(matrices) && word.is_its_mirror_image(matrices.len())).then(|| {
            let product = along(half);
            let turned = Matrix::from_fn(d, d, |i, j| product.entry(d - 1 - i, j).clone());
            (turned, factor(half.len()))
        });
        Product { matrix: along(letters), factor: factor(letters.len()), root }
    }

    /// Polynomials whose product is `det(I - sign Π_w)`, up to a positive factor.
    pub fn determinants(&self, sign: i32) -> Vec<Polynomial<Integer>> {
        match &self.root {
            // 1 - λ² = (1 - λ)(1 + λ)
            Some((root, factor)) if sign > 0 => {
                [1, -1].iter().flat_map(|&sign| determinants(root, factor, sign)).collect()
            }
            _ => determinants(&self.matrix, &self.factor, sign),
        }
    }

    /// A matrix with a factor of which an eigenvalue is outside the unit disc if and only if one of the
    /// product is.
    fn smallest(&self) -> (&Matrix<Polynomial<Integer>>, &Integer) {
        self.root.as_ref().map_or((&self.matrix, &self.factor), |(root, factor)| (root, factor))
    }
}

/// Polynomials whose product is `det(factor I - sign M)`.
fn determinants(
    matrix: &Matrix<Polynomial<Integer>>,
    factor: &Integer,
    sign: i32,
) -> Vec<Polynomial<Integer>> {
    let determinant = |block: &Matrix<Polynomial<Integer>>| {
        let (d, _) = block.shape();
        let shifted = Matrix::from_fn(d, d, |i, j| {
            let entry = block.entry(i, j);
            let entry = if sign > 0 { entry.negated() } else { entry.clone() };
            if i == j { entry.plus(&Polynomial::constant(factor.clone())) } else { entry }
        });
        shifted.determinant()
    };
    blocks(matrix).iter().map(determinant).collect()
}

/// `det(λ factor I - M)` as a polynomial in `λ`.
fn characteristic(
    matrix: &Matrix<Polynomial<Integer>>,
    factor: &Integer,
) -> Polynomial<Polynomial<Integer>> {
    let p = matrix.characteristic_polynomial();
    let scaled = p.coefficients().iter().enumerate();
    Polynomial::new(scaled.map(|(k, c)| c.scaled(&factor.power(k as u32))).collect())
}

/// Matrices that have the eigenvalues of the matrix together: diagonal entries beside which a first or
/// last row or column is zero, and two of what is left if it is equal to its half turn.
///
/// A symmetric mask has such matrices: `A_0` and `A_1` share all but one row and column, and its
/// half turn exchanges them.
fn blocks(matrix: &Matrix<Polynomial<Integer>>) -> Vec<Matrix<Polynomial<Integer>>> {
    let mut blocks = Vec::new();
    let (mut from, mut to) = (0, matrix.shape().0);
    let part = |from: usize, to: usize| {
        Matrix::from_fn(to - from, to - from, |i, j| matrix.entry(from + i, from + j).clone())
    };
    let is_alone = |k: usize, from: usize, to: usize| {
        let others = || (from..to).filter(move |&i| i != k);
        others().all(|i| matrix.entry(i, k).is_zero())
            || others().all(|i| matrix.entry(k, i).is_zero())
    };
    loop {
        if from < to && is_alone(from, from, to) {
            blocks.push(part(from, from + 1));
            from += 1;
        } else if from < to && is_alone(to - 1, from, to) {
            blocks.push(part(to - 1, to));
            to -= 1;
        } else {
            break;
        }
    }
    let n = to - from;
    let rest = part(from, to);
    if n > 1 && is_mirrored(slice::from_ref(&rest)) {
        // On vectors that are, up to the sign, the same read backwards.
        let (entry, mirror) = (|i, j| rest.entry(i, j), |j: usize| n - 1 - j);
        let half = n.div_ceil(2);
        blocks.push(Matrix::from_fn(half, half, |i, j| {
            if mirror(j) == j { entry(i, j).clone() } else { entry(i, j).plus(entry(i, mirror(j))) }
        }));
        blocks.push(Matrix::from_fn(n / 2, n / 2, |i, j| entry(i, j).minus(entry(i, mirror(j)))));
    } else if n > 0 {
        blocks.push(rest);
    }
    blocks
}

/// Where a real eigenvalue of modulus at least one shows in a sign: `det(I - Π_w) ≤ 0` or
/// `det(I + Π_w) ≤ 0`, with factors of the determinants for `+1` and `-1`.
pub(crate) struct SignSet {
    pub determinants: Vec<(i32, Polynomial<Integer>)>,
    pub region: Region,
}

/// The closed set on which the signs of `det(I ∓ Π_w)` show that `ρ(Π_w) ≥ 1` (each has the sign of
/// `Π (1 ∓ λ)`, which is positive if all real eigenvalues are inside the unit interval).
pub(crate) fn sign_set(product: &Product) -> SignSet {
    let factors = [1, -1].map(|sign| (sign, product.determinants(sign)));
    let region = Region::union_of(factors.iter().map(|(_, factors)| not_positive(factors)));
    let determinants =
        factors.into_iter().flat_map(|(sign, factors)| factors.into_iter().map(move |p| (sign, p)));
    SignSet { determinants: determinants.collect(), region }
}

/// Where the product of the polynomials is zero or negative.
fn not_positive(factors: &[Polynomial<Integer>]) -> Region {
    if factors.iter().any(Ring::is_zero) {
        return Region::line();
    }
    let roots = Region::points(factors.iter().flat_map(real_roots));
    cuts_and_gaps(&roots, |sample| {
        factors.iter().filter(|p| p.sign_at(sample).is_lt()).count() % 2 == 1
    })
}

/// The closed set on which `ρ(Π_w(x)) ≥ 1`, exactly.
///
/// Its boundary lies on the zeros of `det(I - Π) det(I + Π) Π_{i<j} (1 - λ_i λ_j)`: an eigenvalue
/// crosses the unit circle at 1, at -1, or in a conjugate pair, of one block. At every such zero some
/// eigenvalue has modulus at least one; between them one rational sample decides, by Schur's test.
pub(crate) fn rough_set(product: &Product) -> Region {
    let (matrix, factor) = product.smallest();
    let characteristics: Vec<_> =
        blocks(matrix).iter().map(|block| characteristic(block, factor)).collect();
    let real = [1, -1].into_iter().flat_map(|sign| determinants(matrix, factor, sign));
    let complex = characteristics.iter().map(inner_determinant);
    let mut cuts = Region::empty();
    for p in real.chain(complex) {
        if p.is_zero() {
            return Region::line();
        }
        cuts = cuts.union(&Region::points(real_roots(&p)));
    }
    let is_stable = |characteristic: &Polynomial<Polynomial<Integer>>, sample: &Rational| {
        let at = characteristic.coefficients().iter().map(|c| c.value_at(sample));
        is_schur_stable(&Polynomial::new(at.collect::<Vec<Rational>>()).cleared().1)
    };
    cuts_and_gaps(&cuts, |sample| !characteristics.iter().all(|c| is_stable(c, sample)))
}

/// The cuts, and the open intervals between them whose samples satisfy a condition.
fn cuts_and_gaps(cuts: &Region, holds: impl Fn(&Rational) -> bool) -> Region {
    Interval::LINE.gaps_where(&cuts.ends(), holds).union(cuts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pencil::Pencil;
    use refinable_algebra::{integer, rational};

    /// `[[0, -x], [x, 0]]`: a complex pair of modulus |x|, invisible to the signs of determinants.
    #[test]
    fn complex_pairs_are_seen() {
        let zero = Matrix::from_fn(2, 2, |_, _| Rational::zero());
        let turn = Matrix::from_fn(2, 2, |i, j| rational(i as i64 - j as i64, 1));
        let pencil = Pencil::new(vec![zero], vec![turn]);
        let word = &Word::necklaces(1, 1, false)[0];
        let product = Product::new(&pencil.cleared(), word);
        assert!(sign_set(&product).region.is_empty());
        assert_eq!(rough_set(&product).display("x"), "(-∞, -1] ∪ [1, ∞)");
    }

    /// Any matrix, and one that is equal to its half turn with a row or column of zeros around it.
    #[test]
    fn blocks_have_the_eigenvalues_of_the_matrix() {
        let x = |c: i64| Polynomial::new(vec![integer(c), integer(c * c % 7 - 3)]);
        for n in 1..7 {
            let plain = Matrix::from_fn(n, n, |i, j| x((3 * i * i + 5 * j + i * j) as i64 % 11));
            let turned = Matrix::from_fn(n, n, |i, j| {
                plain.entry(i, j).plus(plain.entry(n - 1 - i, n - 1 - j))
            });
            let framed = Matrix::from_fn(n + 2, n + 2, |i, j| match (i, j) {
                (i, j) if (1..=n).contains(&i) && (1..=n).contains(&j) => {
                    turned.entry(i - 1, j - 1).clone()
                }
                (0, j) if j > 0 => Polynomial::zero(),
                (i, j) if i != j && j == n + 1 => Polynomial::zero(),
                (i, j) => x((i + 2 * j) as i64),
            });
            for (matrix, parts) in [(plain, 1), (turned, 2), (framed, 4)] {
                let blocks = blocks(&matrix);
                assert!(blocks.len() >= if n == 1 { 1 } else { parts });
                let one = Polynomial::constant(Polynomial::constant(integer(1)));
                let product = blocks
                    .iter()
                    .fold(one, |product, block| product.times(&block.characteristic_polynomial()));
                assert_eq!(product, matrix.characteristic_polynomial(), "{n}");
            }
        }
    }

    #[test]
    fn a_scalar_is_rough_from_its_ends_on() {
        let entry = |n| Matrix::from_fn(1, 1, |_, _| rational(n, 2));
        let pencil = Pencil::new(vec![entry(1)], vec![entry(4)]);
        let word = &Word::necklaces(1, 1, false)[0];
        let product = Product::new(&pencil.cleared(), word);
        assert_eq!(sign_set(&product).region.display("x"), "(-∞, -3/4] ∪ [1/4, ∞)");
        assert_eq!(rough_set(&product), sign_set(&product).region);
    }
}
