//! From below: where the product along a word has spectral radius at least one.

use refinable_algebra::{Integer, Matrix, Polynomial, Rational, Ring};
use refinable_reals::{Bound, RealAlgebraic, Region, real_roots, sample_between};

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
        let root =
            (are_mirrored(matrices) && word.is_its_mirror_image(matrices.len())).then(|| {
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
                [1, -1].map(|sign| determinant(root, factor, sign)).to_vec()
            }
            _ => vec![determinant(&self.matrix, &self.factor, sign)],
        }
    }

    /// `det(λ D^l I - D^l Π_w)` as a polynomial in `λ`.
    fn characteristic(&self) -> Polynomial<Polynomial<Integer>> {
        let p = self.matrix.characteristic_polynomial();
        let scaled = p.coefficients().iter().enumerate();
        Polynomial::new(scaled.map(|(k, c)| c.scaled(&self.factor.power(k as u32))).collect())
    }
}

/// `det(factor I - sign M)`.
fn determinant(
    matrix: &Matrix<Polynomial<Integer>>,
    factor: &Integer,
    sign: i32,
) -> Polynomial<Integer> {
    let (d, _) = matrix.shape();
    let shifted = Matrix::from_fn(d, d, |i, j| {
        let entry = matrix.entry(i, j);
        let entry = if sign > 0 { entry.negated() } else { entry.clone() };
        if i == j { entry.plus(&Polynomial::constant(factor.clone())) } else { entry }
    });
    shifted.determinant()
}

/// Whether `B_{m-1-ε} = J B_ε J`.
fn are_mirrored(matrices: &[Matrix<Polynomial<Integer>>]) -> bool {
    let d = matrices[0].shape().0;
    let mirror = |m: &Matrix<Polynomial<Integer>>| {
        Matrix::from_fn(d, d, |i, j| m.entry(d - 1 - i, d - 1 - j).clone())
    };
    matrices.iter().zip(matrices.iter().rev()).all(|(a, b)| mirror(a) == *b)
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
    let roots = Region::points(factors.iter().flat_map(real_roots)).ends();
    union_of_gaps(&roots, |sample| {
        factors.iter().filter(|p| p.sign_at(sample).is_lt()).count() % 2 == 1
    })
}

/// The closed set on which `ρ(Π_w(x)) ≥ 1`, exactly.
///
/// Its boundary lies on the zeros of `det(I - Π) det(I + Π) Π_{i<j} (1 - λ_i λ_j)`: an eigenvalue
/// crosses the unit circle at 1, at -1, or in a conjugate pair. At every such zero some eigenvalue
/// has modulus at least one; between them one rational sample decides, by Schur's test.
pub(crate) fn rough_set(product: &Product) -> Region {
    let characteristic = product.characteristic();
    let mut cuts = Region::empty();
    let real = [product.determinants(1), product.determinants(-1)].concat();
    for p in real.into_iter().chain([inner_determinant(&characteristic)]) {
        if p.is_zero() {
            return Region::line();
        }
        cuts = cuts.union(&Region::points(real_roots(&p)));
    }
    union_of_gaps(&cuts.ends(), |sample| {
        let at = characteristic.coefficients().iter().map(|c| c.value_at(sample));
        !is_schur_stable(&Polynomial::new(at.collect::<Vec<Rational>>()).cleared().1)
    })
}

/// The cuts, and the open intervals between them whose samples satisfy a condition.
fn union_of_gaps(cuts: &[RealAlgebraic], holds: impl Fn(&Rational) -> bool) -> Region {
    let open = |x: Option<&RealAlgebraic>| x.map_or(Bound::Infinite, |x| Bound::Open(x.clone()));
    let gaps = (0..=cuts.len()).filter_map(|i| {
        let (lower, upper) = (i.checked_sub(1).map(|i| &cuts[i]), cuts.get(i));
        holds(&sample_between(lower, upper)).then(|| Region::interval(open(lower), open(upper)))
    });
    Region::union_of(gaps.chain([Region::points(cuts.iter().cloned())]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pencil::Pencil;
    use refinable_algebra::rational;

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
