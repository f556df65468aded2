//! Which words grow fastest, in floats.

use nalgebra::{DMatrix, DVector};

use crate::word::Word;

/// The spectral radius of the product along a word, per letter.
pub(crate) fn growth(matrices: &[DMatrix<f64>], word: &Word) -> f64 {
    let product = product(matrices, word);
    spectral_radius(&product).powf(1.0 / word.letters().len() as f64)
}

/// The product along a word, letters applied from left to right.
pub(crate) fn product(matrices: &[DMatrix<f64>], word: &Word) -> DMatrix<f64> {
    let d = matrices[0].nrows();
    word.letters()
        .iter()
        .fold(DMatrix::identity(d, d), |product, &letter| &matrices[usize::from(letter)] * product)
}

fn spectral_radius(matrix: &DMatrix<f64>) -> f64 {
    // The iteration does not end on what is not finite.
    if matrix.iter().any(|x| !x.is_finite()) {
        return f64::INFINITY;
    }
    let Some(schur) = nalgebra::Schur::try_new(matrix.clone(), 1e-14, 10_000) else {
        return 0.0;
    };
    schur.complex_eigenvalues().iter().map(|z| z.norm()).fold(0.0, f64::max)
}

/// The word that grows fastest, shorter ones preferred, and its growth per letter.
pub(crate) fn fastest<'a>(matrices: &[DMatrix<f64>], words: &'a [Word]) -> (&'a Word, f64) {
    let mut best = (&words[0], growth(matrices, &words[0]));
    for word in &words[1..] {
        let growth = growth(matrices, word);
        if growth > best.1 * (1.0 + 1e-12) {
            best = (word, growth);
        }
    }
    best
}

/// The vector, of maximum norm 1, that the matrix changes least when it is multiplied by `sign`,
/// and whether no other does as well.
pub(crate) fn fixed_vector(matrix: &DMatrix<f64>, sign: i32) -> Option<DVector<f64>> {
    let d = matrix.nrows();
    let svd =
        (DMatrix::identity(d, d) * f64::from(sign) - matrix).try_svd(false, true, 1e-15, 10_000)?;
    let rows = svd.v_t?;
    let (least, _) = svd.singular_values.argmin();
    let doubtful = svd.singular_values.iter().filter(|s| **s < 1e-9).count() > 1;
    if doubtful {
        return None;
    }
    let v = rows.row(least).transpose();
    let largest = v.amax();
    Some(v / largest)
}

/// Real vectors of maximum norm 1 that span the eigenspaces of a matrix for eigenvalues at least as
/// large as a bound, the largest first: one for a real eigenvalue, two for a complex pair.
pub(crate) fn large_eigenvectors(matrix: &DMatrix<f64>, bound: f64) -> Vec<DVector<f64>> {
    let Some(schur) = nalgebra::Schur::try_new(matrix.clone(), 1e-14, 10_000) else {
        return Vec::new();
    };
    let mut values: Vec<_> = schur.complex_eigenvalues().iter().copied().collect();
    values.retain(|z| z.norm() >= bound && z.im >= 0.0);
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    values.iter().flat_map(|z| eigenspace(matrix, z.re, z.im)).collect()
}

/// Real vectors that span the eigenspaces for `re ± i im`.
fn eigenspace(matrix: &DMatrix<f64>, re: f64, im: f64) -> Vec<DVector<f64>> {
    let d = matrix.nrows();
    let identity = DMatrix::identity(d, d);
    // The kernel of (M - z)(M - z̄), or of M - z.
    let (shifted, rank) = if im > 1e-9 {
        (matrix * matrix - matrix * (2.0 * re) + identity * (re * re + im * im), 2)
    } else {
        (matrix - identity * re, 1)
    };
    let Some(svd) = shifted.try_svd(false, true, 1e-15, 10_000) else { return Vec::new() };
    let Some(rows) = svd.v_t else { return Vec::new() };
    let mut order: Vec<usize> = (0..d).collect();
    order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
    let least = order.iter().take(rank);
    least.map(|&i| rows.row(i).transpose()).map(|v| &v / v.amax()).collect()
}
