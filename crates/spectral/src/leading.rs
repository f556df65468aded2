//! Which words grow fastest, in floats.

use nalgebra::{Complex, DMatrix, DVector};

use crate::body::apply;
use crate::word::Word;

/// The spectral radius of the product along a word, per letter; `None` if floats do not find it.
pub(crate) fn growth(matrices: &[DMatrix<f64>], word: &Word) -> Option<f64> {
    let radius = spectral_radius(&product(matrices, word))?;
    Some(radius.powf(1.0 / word.letters().len() as f64))
}

/// The product along a word, letters applied from left to right.
pub(crate) fn product(matrices: &[DMatrix<f64>], word: &Word) -> DMatrix<f64> {
    let d = matrices[0].nrows();
    word.letters()
        .iter()
        .fold(DMatrix::identity(d, d), |product, &letter| &matrices[usize::from(letter)] * product)
}

fn spectral_radius(matrix: &DMatrix<f64>) -> Option<f64> {
    // The iteration does not end on what is not finite.
    if matrix.iter().any(|x| !x.is_finite()) {
        return Some(f64::INFINITY);
    }
    eigenvalues(matrix).first().map(|z| z.norm()).filter(|radius| !radius.is_nan())
}

/// The word that grows fastest, shorter ones preferred, and its growth per letter. Words of unknown growth are
/// passed over; where no other is left, the first is taken to grow without bound.
pub(crate) fn fastest<'a>(matrices: &[DMatrix<f64>], words: &'a [Word]) -> (&'a Word, f64) {
    let known = words.iter().filter_map(|word| Some((word, growth(matrices, word)?)));
    let faster = |best: (&'a Word, f64), next: (&'a Word, f64)| {
        if next.1 > best.1 * (1.0 + 1e-12) { next } else { best }
    };
    known.reduce(faster).unwrap_or((&words[0], f64::INFINITY))
}

/// The vector, of maximum norm 1, that the matrix changes least when it is multiplied by `sign`,
/// and whether no other does as well.
pub(crate) fn fixed_vector(matrix: &DMatrix<f64>, sign: i32) -> Option<Vec<f64>> {
    let d = matrix.nrows();
    let svd =
        (DMatrix::identity(d, d) * f64::from(sign) - matrix).try_svd(false, true, 1e-15, 10_000)?;
    let rows = svd.v_t?;
    let (least, _) = svd.singular_values.argmin();
    let doubtful = svd.singular_values.iter().filter(|s| **s < 1e-9).count() > 1;
    (!doubtful).then(|| of_norm_one(rows.row(least).iter().copied().collect()))
}

/// The eigenvalues, the largest first; of a complex pair the one in the upper half plane. None if Schur's iteration
/// does not converge.
pub(crate) fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let schur = |accuracy: f64| nalgebra::Schur::try_new(matrix.clone(), accuracy, 1_000);
    // For a few matrices the iteration stalls just above the rounding of the machine.
    let Some(schur) = [1e-14, 1e-12, 1e-10].into_iter().find_map(schur) else {
        return Vec::new();
    };
    let mut values: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
    values.retain(|z| z.im >= 0.0);
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    values
}

/// Whether an eigenvalue is one of a complex pair, as far as floats can tell.
pub(crate) fn is_complex(eigenvalue: &Complex<f64>) -> bool {
    eigenvalue.im > 1e-9
}

/// An eigenvector of maximum norm 1: `d` real coordinates, or for a complex eigenvalue the real and
/// then the imaginary parts.
pub(crate) fn eigenvector(matrix: &DMatrix<f64>, eigenvalue: Complex<f64>) -> Option<Vec<f64>> {
    let d = matrix.nrows();
    let identity = DMatrix::identity(d, d);
    let (re, im) = (eigenvalue.re, eigenvalue.im);
    let kernel = |matrix: DMatrix<f64>| -> Option<DVector<f64>> {
        let svd = matrix.try_svd(false, true, 1e-15, 10_000)?;
        let (least, _) = svd.singular_values.argmin();
        Some(svd.v_t?.row(least).transpose())
    };
    if !is_complex(&eigenvalue) {
        let v = kernel(matrix - identity * re)?;
        return Some(of_norm_one(v.as_slice().to_vec()));
    }
    // If (M - z)(M - z̄) r = 0, then (M - z̄) r is an eigenvector for z.
    let pair = matrix * matrix - matrix * (2.0 * re) + identity * (re * re + im * im);
    let r = kernel(pair)?;
    let real = matrix * &r - &r * re;
    Some(of_norm_one(real.iter().copied().chain(r.iter().map(|x| x * im)).collect()))
}

fn of_norm_one(v: Vec<f64>) -> Vec<f64> {
    let largest = v.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    v.iter().map(|x| x / largest).collect()
}

/// The eigenvalue and the eigenvector of another matrix nearest to those of the given eigenvector,
/// which keeps its largest coordinate.
pub(crate) fn followed(
    matrix: &DMatrix<f64>,
    vector: &[f64],
    other: &DMatrix<f64>,
) -> Option<(Complex<f64>, Vec<f64>)> {
    let d = matrix.nrows();
    let coordinate = |v: &[f64], i: usize| Complex::new(v[i], v.get(d + i).copied().unwrap_or(0.0));
    let pivot = (0..d)
        .max_by(|&i, &j| coordinate(vector, i).norm().total_cmp(&coordinate(vector, j).norm()))?;
    let image = apply(matrix, vector);
    let here = coordinate(vector, pivot);
    let eigenvalue = coordinate(&image, pivot) / here;
    // Eigenvectors are those of eigenvalues in the upper half plane.
    let eigenvalue = Complex::new(eigenvalue.re, eigenvalue.im.abs());
    let distance = |z: &Complex<f64>| (z - eigenvalue).norm();
    let near = eigenvalues(other).into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    if is_complex(&near) && vector.len() == d {
        return None;
    }
    let found = eigenvector(other, near)?;
    let factor = here / coordinate(&found, pivot);
    let turned: Vec<Complex<f64>> = (0..d).map(|i| coordinate(&found, i) * factor).collect();
    let parts = turned.iter().map(|z| z.re).chain(turned.iter().map(|z| z.im));
    Some((near, parts.take(vector.len()).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Squares of such entries overflow, and the iteration comes to nothing.
    #[test]
    fn words_of_unknown_growth_are_passed_over() {
        let unknown = DMatrix::from_row_slice(2, 2, &[1e200, 1e200, 1e200, -1e200]);
        let known = DMatrix::from_row_slice(2, 2, &[0.5, 1.0, 0.0, 0.25]);
        let words = Word::necklaces(2, 1, false);
        let matrices = [unknown.clone(), known];
        assert_eq!(growth(&matrices, &words[0]), None);
        assert_eq!(fastest(&matrices, &words), (&words[1], 0.5));
        assert_eq!(fastest(&[unknown], &words[..1]), (&words[0], f64::INFINITY));
    }
}
