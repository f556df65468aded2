//! Ellipsoids, moving with the point, which the matrices map into the interior of each other.
//!
//! Machine integers in fixed point, every rounding on the safe side.

use std::collections::{BTreeMap, BTreeSet};

use refinable_algebra::Integer;

use crate::family::places;
use crate::map::family::PlaneScheme;
use crate::map::form::multisets;
use crate::map::model::Ellipsoids;
use crate::map::polygon::Polygon;
use crate::map::positive::is_positive_definite;
use crate::work::{Check, Work, ensure};

/// Binary places of the matrices.
const PLACES: u32 = 60;
/// Matrices are below `2^LARGEST_ENTRY` and the entries of `Q` below `2^LARGEST` in absolute value.
const LARGEST_ENTRY: u32 = 12;
const LARGEST: u32 = 40;
const MOST_WORDS: usize = 64;
const MOST_MATRICES: usize = 20_000;

/// The matrices `B` whose products are to shrink: the `A_ε`, over the bound for their radius; or, if
/// `A_{m-1-ε} = J A_ε J`, the `A_ε` and `A_ε J` for `2 ε < m`. A product of the `A_ε` is one of these, up
/// to a `J` on the left.
#[derive(Debug)]
pub(crate) struct Letters {
    /// For each letter, which coefficient each entry is.
    places: Vec<Vec<Option<usize>>>,
    dimension: usize,
    bound: Integer,
}

impl Letters {
    /// The letters of a family, over the bound.
    pub fn new(scheme: &PlaneScheme, bound: &Integer) -> Self {
        let dimension = scheme.dimension();
        let mut places = places(scheme.difference.len(), scheme.arity);
        if scheme.is_mirrored() {
            places.truncate(scheme.arity.div_ceil(2));
            let mirrored = |matrix: Vec<Option<usize>>| {
                let rows = matrix.chunks_exact(dimension);
                let reversed = rows.flat_map(|row| row.iter().rev().copied()).collect();
                [matrix, reversed]
            };
            places = places.into_iter().flat_map(mirrored).collect();
        }
        Letters { places, dimension, bound: bound.clone() }
    }

    /// Checks that every letter maps every ellipsoid into the interior of the next one at every point
    /// of the closed polygon.
    ///
    /// On each triangle with the first corner, `Q` is affine and `B` of the degree `n` of the family, so
    /// the matrix `[[Q', B Q], [Q B^T, Q]]` is a mean of the values of its polar form at the multisets
    /// of `n + 1` corners; they are to be positive definite.
    pub fn check(
        &self,
        scheme: &PlaneScheme,
        polygon: &Polygon,
        ellipsoids: &Ellipsoids,
        work: &mut Work,
    ) -> Check<()> {
        let corners = polygon.corners();
        let words = self.words(ellipsoids.memory)?;
        self.check_form(ellipsoids, corners.len(), words)?;
        let sets = controls(corners.len(), scheme.degree + 1);
        let count = sets.len() * words * self.places.len();
        ensure(count <= MOST_MATRICES, "more than 20000 matrices to check")?;
        let mut known: BTreeMap<Vec<usize>, Vec<Vec<i128>>> = BTreeMap::new();
        for set in sets {
            let mut terms = Vec::new();
            for at in 0..set.len() {
                let mut others = set.clone();
                let corner = others.remove(at);
                if !known.contains_key(&others) {
                    let points: Vec<_> = others.iter().map(|&i| &corners[i]).collect();
                    let values = scheme.polar(&scheme.difference, &points, work)?;
                    known.insert(others.clone(), self.matrices(&values)?);
                }
                terms.push((corner, others));
            }
            let sums: Vec<Vec<i128>> =
                (0..words).map(|word| sum(set.iter().map(|&c| &ellipsoids.corners[c][word]))).collect();
            for word in 0..words {
                for letter in 0..self.places.len() {
                    let next = (word * self.places.len() + letter) % words;
                    let terms = terms.iter();
                    let terms = terms.map(|(c, s)| (&known[s][letter], &ellipsoids.corners[*c][word]));
                    let inside = self.is_inside(&sums[word], &sums[next], terms, work)?;
                    ensure(inside, "an ellipsoid is not shown to be mapped into the next one")?;
                }
            }
        }
        Ok(())
    }

    /// The number of words of a length.
    fn words(&self, memory: u32) -> Check<usize> {
        let words = self.places.len().checked_pow(memory).unwrap_or(usize::MAX);
        ensure(words <= MOST_WORDS, "more than 64 ellipsoids")?;
        Ok(words)
    }

    fn check_form(&self, ellipsoids: &Ellipsoids, corners: usize, words: usize) -> Check<()> {
        let all = &ellipsoids.corners;
        let fits = all.len() == corners && all.iter().all(|corner| corner.len() == words);
        ensure(fits, "not one ellipsoid for each word at each corner")?;
        let size = self.dimension * (self.dimension + 1) / 2;
        let fits = all.iter().flatten().all(|entries| entries.len() == size);
        ensure(fits, "an ellipsoid of the wrong size")?;
        let small = |x: &i64| x.unsigned_abs() < 1 << LARGEST;
        ensure(all.iter().flatten().flatten().all(small), "an ellipsoid with too large numbers")
    }

    /// The letters from the values of the coefficients, row by row, each entry less than one place off.
    fn matrices(&self, (values, denominator): &(Vec<Integer>, Integer)) -> Check<Vec<Vec<i128>>> {
        let denominator = denominator * &self.bound;
        let fixed = |value: &Integer| -> Check<i128> {
            let fixed = i128::try_from(&((value << PLACES) / &denominator)).unwrap_or(i128::MAX);
            let small = fixed.unsigned_abs() < 1 << (PLACES + LARGEST_ENTRY);
            ensure(small, "an entry above 4000")?;
            Ok(fixed)
        };
        let fixed: Vec<i128> = values.iter().map(fixed).collect::<Check<_>>()?;
        let entry = |place: &Option<usize>| place.map_or(0, |i| fixed[i]);
        Ok(self.places.iter().map(|matrix| matrix.iter().map(entry).collect()).collect())
    }

    /// Whether `[[Q', X], [X^T, Q]]` is positive definite with the sum `X` of the products `B Q_i`.
    fn is_inside<'a>(
        &self,
        from: &[i128],
        to: &[i128],
        terms: impl Iterator<Item = (&'a Vec<i128>, &'a Vec<i64>)>,
        work: &mut Work,
    ) -> Check<bool> {
        let d = self.dimension;
        let mut matrix = vec![vec![0_i128; 2 * d]; 2 * d];
        for i in 0..d {
            for j in 0..d {
                matrix[i][j] = entry(to, d, i, j) << PLACES;
                matrix[d + i][d + j] = entry(from, d, i, j) << PLACES;
            }
        }
        let mut error = 0;
        for (letter, ellipsoid) in terms {
            work.spend((2 * d * d * d) as u64)?;
            let ellipsoid: Vec<i128> = ellipsoid.iter().map(|&x| x.into()).collect();
            for (i, row) in letter.chunks_exact(d).enumerate() {
                for j in 0..d {
                    let products = row.iter().enumerate().map(|(k, b)| b * entry(&ellipsoid, d, k, j));
                    matrix[i][d + j] += products.sum::<i128>();
                }
            }
            let columns = (0..d).map(|j| (0..d).map(|k| entry(&ellipsoid, d, k, j).abs()).sum());
            error += columns.max().unwrap_or(0_i128);
        }
        work.spend((20 * d * d * d) as u64)?;
        Ok(is_positive_definite(matrix, error))
    }
}

/// The multisets of so many corners of one of the triangles with the first corner.
fn controls(corners: usize, size: usize) -> BTreeSet<Vec<usize>> {
    let of = |k: usize| {
        let triangle = [0, k, k + 1];
        multisets(3, size).into_iter().map(move |set| set.into_iter().map(|i| triangle[i]).collect())
    };
    (1..corners - 1).flat_map(of).collect()
}

/// The entry of a symmetric matrix of which the upper triangle is given row by row.
fn entry<T: Copy>(triangle: &[T], dimension: usize, i: usize, j: usize) -> T {
    let (i, j) = (i.min(j), i.max(j));
    triangle[i * (2 * dimension + 1 - i) / 2 + j - i]
}

fn sum<'a>(mut all: impl Iterator<Item = &'a Vec<i64>>) -> Vec<i128> {
    let first = all.next().map_or_else(Vec::new, |v| v.iter().map(|&x| x.into()).collect());
    all.fold(first, |sum: Vec<i128>, v| sum.iter().zip(v).map(|(s, &x)| s + i128::from(x)).collect())
}
