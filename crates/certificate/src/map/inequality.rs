//! Polynomial inequalities that show that the product along a word has a large eigenvalue.

use refinable_algebra::{Integer, Matrix, Polynomial, Ring, integer};

use crate::family::letters;
use crate::jury::inner_matrix;
use crate::map::family::PlaneScheme;
use crate::map::form::{Form, degree};
use crate::map::model::{Eigenvalue, Inequality};
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// Square matrices of polynomials over a denominator; together they have the eigenvalues of the product
/// along a word, or of a square root of it.
pub(crate) struct Blocks {
    matrices: Vec<Matrix<Form>>,
    denominator: Form,
    /// Of the sign of the denominator, where this does not vanish.
    sign: Form,
    /// How many letters the product has.
    pub length: usize,
}

/// The longest word, and the largest degree of an inequality.
const LONGEST: usize = 12;
const DEGREE: usize = 16;

impl Blocks {
    /// The blocks of the matrices `B_ε` along a word, the bound included.
    pub fn new(
        scheme: &PlaneScheme,
        continuity: usize,
        word: &str,
        work: &mut Work,
    ) -> Check<Self> {
        let letters = letters(word, scheme.arity, LONGEST)?;
        let d = scheme.dimension();
        let matrices = scheme.letters();
        let bits = matrices.iter().flatten().map(bits).max().unwrap_or(0);
        for step in 1..=letters.len() {
            let products = d.pow(3) * term_count(scheme.degree) * term_count(step * scheme.degree);
            work.products(products, bits, step as u64 * bits)?;
        }
        let matrix = |e: usize| Matrix::from_fn(d, d, |i, j| matrices[e][i * d + j].clone());
        let along = |letters: &[usize]| {
            letters.iter().fold(Matrix::identity(d), |product, &e| matrix(e).times(&product))
        };
        let (first, second) = letters.split_at(letters.len() / 2);
        let mirrors = first.iter().zip(second).all(|(a, b)| a + b == scheme.arity - 1);
        // Π_w = (J Π_u)² if the word is u followed by its mirror image.
        let halved = scheme.is_mirrored() && letters.len() % 2 == 0 && mirrors;
        let (product, length) = if halved {
            let product = along(first);
            (Matrix::from_fn(d, d, |i, j| product.entry(d - 1 - i, j).clone()), first.len())
        } else {
            (along(&letters), letters.len())
        };
        let bound = Polynomial::constant(scheme.bound(continuity)?);
        let denominator = scheme.denominator.scaled(&bound).power(length as u32);
        let positive = scheme.is_polynomial() || length.is_multiple_of(2);
        let sign = if positive { Form::one() } else { scheme.denominator.clone() };
        Ok(Blocks { matrices: blocks(product), denominator, sign, length })
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.matrices.len()
    }

    /// A polynomial that is positive wherever the denominator does not vanish and all eigenvalues of a block are
    /// less than the radius in modulus: `det(r I - B)`, `det(r I + B)` or `Π_{i<j} (r² - λ_i λ_j)`, up to a factor that
    /// is positive there, an even power of the denominator.
    pub fn polynomial(
        &self,
        block: usize,
        eigenvalue: Eigenvalue,
        radius: u64,
        work: &mut Work,
    ) -> Check<Form> {
        let Some(matrix) = self.matrices.get(block) else { return fail("there is no such block") };
        ensure(radius >= 1, "a radius below one")?;
        let size = matrix.shape().0;
        let entries = || (0..size * size).map(|k| matrix.entry(k / size, k % size));
        let largest = entries().chain([&self.denominator]).map(degree).max().unwrap_or(0);
        let pairs = eigenvalue == Eigenvalue::Pair;
        ensure(!pairs || size >= 2, "a block with one eigenvalue has no pair")?;
        // The denominator comes in its power `size`, or in an even one.
        let sign = if pairs || size.is_multiple_of(2) { Form::one() } else { self.sign.clone() };
        let weight = if pairs { size * (size - 1) } else { size };
        let total = weight * largest + degree(&sign);
        ensure(total <= DEGREE, "an inequality of degree above 16")?;
        let bits = entries().map(bits).max().unwrap_or(0) + bits(&self.denominator);
        let whole = term_count(total);
        let steps = size.pow(4) * term_count(largest) * whole;
        let minors = if pairs { size.pow(3) * whole * whole } else { 0 };
        work.products(steps + minors, bits * size as u64, bits * size as u64)?;
        let radius = Polynomial::constant(Integer::from(radius));
        let scale = self.denominator.scaled(&radius);
        // det(λ - M) at λ = scale μ, in powers of μ.
        let characteristic = matrix.characteristic_polynomial();
        let coefficients: Vec<Form> = characteristic
            .coefficients()
            .iter()
            .enumerate()
            .map(|(k, c)| c.times(&scale.power(k as u32)))
            .collect();
        let form = match eigenvalue {
            Eigenvalue::Positive => coefficients.iter().fold(Form::zero(), |s, c| s.plus(c)),
            Eigenvalue::Negative => {
                let signed = coefficients.iter().enumerate();
                let sign = |k: usize| if (size - k).is_multiple_of(2) { 1 } else { -1 };
                signed.fold(Form::zero(), |s, (k, c)| {
                    s.plus(&c.scaled(&Polynomial::constant(integer(sign(k)))))
                })
            }
            Eigenvalue::Pair => {
                let entries = inner_matrix(&coefficients);
                let entry = |i: usize, j: usize| entries[i * (size - 1) + j].clone();
                Matrix::from_fn(size - 1, size - 1, entry).determinant()
            }
        };
        Ok(form.times(&sign))
    }
}

/// What an inequality says, as a polynomial; and whether an eigenvalue so large means that the scheme
/// diverges, whatever the shifts: the joint spectral radius is at least `m^(k-1)` then.
pub(crate) fn polynomial(
    scheme: &PlaneScheme,
    continuity: usize,
    inequality: &Inequality,
) -> Check<(Form, bool)> {
    let work = &mut Work::new();
    let blocks = Blocks::new(scheme, continuity, &inequality.word, work)?;
    let Inequality { block, eigenvalue, radius, .. } = *inequality;
    let form = blocks.polynomial(block, eigenvalue, radius, work)?;
    let needed = integer(scheme.arity as i64).power((continuity * blocks.length) as u32);
    Ok((form, Integer::from(radius) >= needed))
}

/// The number of terms of a polynomial of this degree in two variables.
fn term_count(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// The size of the coefficients.
fn bits(form: &Form) -> u64 {
    largest_bits(form.coefficients().iter().flat_map(Polynomial::coefficients))
}

/// Matrices that have the eigenvalues of the matrix together: diagonal entries beside which a first or
/// last row or column is zero, and two of what is left if it is equal to its half turn.
fn blocks(matrix: Matrix<Form>) -> Vec<Matrix<Form>> {
    let mut all = Vec::new();
    let mut rest = matrix;
    while let Some((alone, others)) = without_corner(&rest) {
        all.push(alone);
        rest = others;
    }
    let n = rest.shape().0;
    let centred = (0..n * n).all(|k| {
        let (i, j) = (k / n, k % n);
        rest.entry(i, j) == rest.entry(n - 1 - i, n - 1 - j)
    });
    if n < 2 || !centred {
        all.extend((n > 0).then_some(rest));
        return all;
    }
    // On the vectors that are the same read backwards, and on those that are the opposite.
    let (even, odd) = (n.div_ceil(2), n / 2);
    all.push(Matrix::from_fn(even, even, |i, j| match n - 1 - j {
        k if k == j => rest.entry(i, j).clone(),
        k => rest.entry(i, j).plus(rest.entry(i, k)),
    }));
    all.push(Matrix::from_fn(odd, odd, |i, j| rest.entry(i, j).minus(rest.entry(i, n - 1 - j))));
    all
}

/// A first or last diagonal entry that is an eigenvalue, and the matrix without its row and column.
fn without_corner(matrix: &Matrix<Form>) -> Option<(Matrix<Form>, Matrix<Form>)> {
    let n = matrix.shape().0;
    let alone = |k: usize| {
        let others = || (0..n).filter(move |&i| i != k);
        others().all(|i| matrix.entry(i, k).is_zero())
            || others().all(|i| matrix.entry(k, i).is_zero())
    };
    let corner = [0, n.checked_sub(1)?].into_iter().find(|&k| alone(k))?;
    let skip = usize::from(corner == 0);
    let entry = Matrix::from_fn(1, 1, |_, _| matrix.entry(corner, corner).clone());
    let others = |i: usize, j: usize| matrix.entry(i + skip, j + skip).clone();
    Some((entry, Matrix::from_fn(n - 1, n - 1, others)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn constant(c: i64) -> Form {
        Form::constant(Polynomial::constant(integer(c)))
    }

    fn characteristic(matrix: &Matrix<Form>) -> Polynomial<Form> {
        matrix.characteristic_polynomial()
    }

    /// A matrix equal to its half turn, with a frame of zeros around it.
    #[test]
    fn blocks_have_the_eigenvalues_of_the_matrix() {
        for n in 0..6 {
            let plain = |i: usize, j: usize| ((3 * i * i + 5 * j + i * j) % 11) as i64;
            let matrix = Matrix::from_fn(n + 2, n + 2, |i, j| match (i, j) {
                (i, j) if (1..=n).contains(&i) && (1..=n).contains(&j) => {
                    constant(plain(i - 1, j - 1) + plain(n - i, n - j))
                }
                (0, j) if j > 0 => constant(0),
                (i, j) if i != j && j == n + 1 => constant(0),
                (i, j) => constant((i + 2 * j) as i64),
            });
            let blocks = blocks(matrix.clone());
            let product = blocks.iter().map(characteristic);
            let one = Polynomial::constant(constant(1));
            let product = product.fold(one, |p: Polynomial<Form>, q| p.times(&q));
            assert_eq!(product, characteristic(&matrix), "{n}");
            assert!(blocks.len() >= if n < 2 { n + 2 } else { 4 });
        }
    }

    /// One entry is changed in a matrix equal to its half turn.
    #[test]
    fn matrices_that_are_not_equal_to_their_half_turn_stay_whole() {
        for n in 2..7 {
            for changed in 0..n * n {
                let plain = |i: usize, j: usize| ((3 * i * i + 5 * j + i * j) % 11 + 1) as i64;
                let matrix = Matrix::from_fn(n, n, |i, j| {
                    let extra = i64::from(i * n + j == changed);
                    constant(plain(i, j) + plain(n - 1 - i, n - 1 - j) + extra)
                });
                let is_middle = 2 * changed + 1 == n * n;
                let blocks = blocks(matrix.clone());
                assert_eq!(blocks.len(), if is_middle { 2 } else { 1 }, "{n} {changed}");
                let one = Polynomial::constant(constant(1));
                let product = blocks.iter().map(characteristic);
                let product = product.fold(one, |p: Polynomial<Form>, q| p.times(&q));
                assert_eq!(product, characteristic(&matrix), "{n} {changed}");
            }
        }
    }

    /// A polynomial has the sign of the denominator if this comes in an odd power: not for pairs, nor for two rows.
    #[test]
    fn signs_of_denominators() {
        let value = |entries: &[&[i64]], eigenvalue, sign: i64| {
            let n = entries.len();
            let matrix = Matrix::from_fn(n, n, |i, j| constant(entries[i][j]));
            let blocks = Blocks {
                matrices: vec![matrix],
                denominator: constant(2),
                sign: constant(sign),
                length: 1,
            };
            blocks
                .polynomial(0, eigenvalue, 1, &mut Work::new())
                .unwrap()
                .coefficient(0)
                .coefficient(0)
        };
        let two: [&[i64]; 2] = [&[1, 1], &[0, -1]];
        let three: [&[i64]; 3] = [&[1, 1, 0], &[0, -1, 1], &[0, 0, 1]];
        for eigenvalue in [Eigenvalue::Positive, Eigenvalue::Negative] {
            assert_eq!(value(&two, eigenvalue, -1), value(&two, eigenvalue, 1));
            assert_eq!(value(&three, eigenvalue, -1), -value(&three, eigenvalue, 1));
        }
        for entries in [&two[..], &three] {
            assert_eq!(value(entries, Eigenvalue::Pair, -1), value(entries, Eigenvalue::Pair, 1));
        }
    }

    /// The eigenvalues 3, -5 and 2 of a triangular matrix, over the denominator 2.
    #[test]
    fn signs_tell_large_eigenvalues() {
        let entries = [[3, 1, 4], [0, -5, 1], [0, 0, 2]];
        let matrix = Matrix::from_fn(3, 3, |i, j| constant(entries[i][j]));
        let (denominator, sign) = (constant(2), constant(1));
        let blocks = Blocks { matrices: vec![matrix], denominator, sign, length: 1 };
        let value = |eigenvalue, radius| {
            let form = blocks.polynomial(0, eigenvalue, radius, &mut Work::new()).unwrap();
            form.coefficient(0).coefficient(0)
        };
        for r in [1, 2, 3, 1 << 63, u64::MAX] {
            let s = Integer::from(r) * 2;
            let beside = |k: i64| &s + integer(k);
            let positive = beside(-3) * beside(5) * beside(-2);
            let negative = beside(3) * beside(-5) * beside(2);
            assert_eq!(value(Eigenvalue::Positive, r), positive);
            assert_eq!(value(Eigenvalue::Negative, r), negative);
            let square = |k: i64| &s * &s + integer(k);
            // The leading coefficient s³ squared, against s² for each of three pairs.
            assert_eq!(value(Eigenvalue::Pair, r), square(15) * square(-6) * square(10));
        }
        let work = &mut Work::new();
        assert!(blocks.polynomial(1, Eigenvalue::Positive, 1, work).is_err());
        assert!(blocks.polynomial(0, Eigenvalue::Positive, 0, work).is_err());
    }
}
