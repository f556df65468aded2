//! Whether symmetric matrices are positive definite, in machine integers.

/// Entries are brought below `2^PLACES`.
const PLACES: u32 = 60;

/// Whether every symmetric matrix of which no entry differs by more than `error` from that of the given
/// one is shown to be positive definite; the upper triangle is used. Entries are below `2^126` and the error
/// is not negative.
///
/// Elimination of `M - μ I` with rounded entries is the exact one of a matrix `M - μ I + E`: an entry is off by
/// less than one for each step and for the scaling, and by the scaled error. If all pivots are positive, this
/// matrix is positive definite, and so is `M`, since `‖E‖ < μ`.
pub(crate) fn is_positive_definite(mut matrix: Vec<Vec<i128>>, error: i128) -> bool {
    let n = matrix.len();
    let largest = matrix.iter().flatten().map(|x| x.unsigned_abs()).max().unwrap_or(0);
    let bits = 128 - largest.leading_zeros();
    let (down, up) = (bits.saturating_sub(PLACES), PLACES.saturating_sub(bits));
    // Rounding down, here and at each step, is less than one off.
    let scaled = (error >> down).checked_mul(1 << up);
    let off = scaled.and_then(|error| error.checked_add(2 + n as i128));
    let margin = off.and_then(|off| off.checked_mul(n as i128)).unwrap_or(i128::MAX);
    if margin >= 1 << PLACES {
        return false;
    }
    for (i, row) in matrix.iter_mut().enumerate() {
        row.iter_mut().for_each(|x| *x = (*x >> down) << up);
        row[i] -= margin;
    }
    for k in 0..n {
        let pivot = matrix[k][k];
        if pivot <= 0 {
            return false;
        }
        let (above, below) = matrix.split_at_mut(k + 1);
        let row = &above[k];
        for (i, other) in (k + 1..).zip(below) {
            // The symmetric entry of the row below may be rounded otherwise and is not used.
            for j in i..n {
                other[j] -= (row[i] * row[j]).div_euclid(pivot);
            }
            // An entry beyond the diagonal ones shows that the matrix is not positive definite.
            if other[i] <= 0 || other[i..].iter().any(|x| x.unsigned_abs() >> (PLACES + 1) > 0) {
                return false;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `H_ij = 1/(i+j+1)`, scaled, less a multiple of 1e-10 on the diagonal; its least eigenvalue for n = 6 is
    /// 1.083e-7.
    fn hilbert(n: usize, less: i128) -> Vec<Vec<i128>> {
        let one = 1_i128 << 100;
        let entry = |i: usize, j: usize| one / (i + j + 1) as i128;
        let mut rows: Vec<Vec<i128>> =
            (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        rows.iter_mut().enumerate().for_each(|(i, row)| row[i] -= less * one / 10_000_000_000);
        rows
    }

    #[test]
    fn hilbert_matrices_are_positive_definite() {
        assert!(is_positive_definite(hilbert(6, 1080), 1));
        assert!(!is_positive_definite(hilbert(6, 1090), 1));
        // An error larger than the least eigenvalue may make it singular.
        assert!(is_positive_definite(hilbert(6, 0), 1 << 72));
        assert!(!is_positive_definite(hilbert(6, 0), 1 << 77));
    }

    #[test]
    fn small_matrices_by_hand() {
        let matrix =
            |a: i128, b: i128, c: i128| vec![vec![a << 70, b << 70], vec![b << 70, c << 70]];
        assert!(is_positive_definite(matrix(4, 3, 3), 0));
        assert!(!is_positive_definite(matrix(4, 4, 4), 0));
        assert!(!is_positive_definite(matrix(4, 5, 4), 0));
        assert!(!is_positive_definite(matrix(-4, 0, 4), 0));
        assert!(!is_positive_definite(matrix(0, 0, 0), 0));
        // Small integers are scaled up, and the error with them.
        assert!(is_positive_definite(vec![vec![5, 3], vec![3, 2]], 0));
        assert!(!is_positive_definite(vec![vec![5, 3], vec![3, 2]], 1));
        let extreme = i128::MAX >> 1;
        assert!(!is_positive_definite(vec![vec![1, extreme], vec![extreme, 1]], extreme));
    }
}
