//! Quadratic forms `Q`, moving with the point of a piece, which letters `B` shrink: `Q' - B Q B^T` is positive
//! definite everywhere on the piece.
//!
//! Machine integers in fixed point, every rounding on the safe side.

use std::collections::{BTreeMap, BTreeSet};

use refinable_algebra::{Integer, Ring};

use crate::family::{letters, places};
use crate::map::family::{PlaneScheme, Polar};
use crate::map::form::multisets;
use crate::map::model::{Ellipsoids, Expansion};
use crate::map::polygon::Polygon;
use crate::map::positive::is_positive_definite;
use crate::work::{Check, Work, ensure};

/// Binary places of the matrices, of `B Q`, and of `B Q B^T`.
const PLACES: u32 = 44;
const HALF_PLACES: u32 = 14;
const FULL_PLACES: u32 = 20;
/// Matrices are below `2^LARGEST_ENTRY` and the entries of `Q` below `2^LARGEST` in absolute value.
const LARGEST_ENTRY: u32 = 8;
const LARGEST: u32 = 36;
const MOST_WORDS: usize = 64;
const MOST_MATRICES: usize = 20_000;

/// The matrices `B` whose products are to shrink or to grow: the `A_ε`, over the bound for their radius; or,
/// if `A_{m-1-ε} = J A_ε J`, the `A_ε` and `A_ε J` for `2 ε < m`. A product of the `A_ε` is one of these, up
/// to a `J` on the left, and a product of these one of the `A_ε`.
#[derive(Debug)]
pub(crate) struct Letters {
    /// For each letter, which coefficient each entry is.
    places: Vec<Vec<Option<usize>>>,
    dimension: usize,
    bound: Integer,
}

/// A letter, with the forms before and after it.
#[derive(Clone, Copy)]
struct Step {
    letter: usize,
    from: usize,
    to: usize,
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

    /// Checks that every letter maps every ellipsoid into the interior of that of the word that ends
    /// with the letter, so that all products shrink.
    pub fn check_ellipsoids(
        &self,
        scheme: &PlaneScheme,
        polygon: &Polygon,
        ellipsoids: &Ellipsoids,
        work: &mut Work,
    ) -> Check<()> {
        let count = self.places.len();
        let words = count.checked_pow(ellipsoids.memory).unwrap_or(usize::MAX);
        ensure(words <= MOST_WORDS, "more than 64 ellipsoids")?;
        self.check_form(&ellipsoids.corners, polygon, words)?;
        for triangle in ellipsoids.corners.iter().flatten() {
            let form = |i: usize, j: usize| i128::from(entry(triangle, self.dimension, i, j));
            let matrix = square(self.dimension, form);
            ensure(is_positive_definite(matrix, 0), "an ellipsoid that is not positive definite")?;
        }
        let steps = (0..words).flat_map(|from| {
            (0..count).map(move |letter| Step { letter, from, to: (from * count + letter) % words })
        });
        self.check_steps(scheme, polygon, &ellipsoids.corners, &steps.collect::<Vec<_>>(), work)
    }

    /// Checks that a product has spectral radius at least one: with `P - Π P Π^T ≻ 0`, a smaller one
    /// would make `P = Σ Π^k (P - Π P Π^T) (Π^T)^k` positive definite, but there is a vector with
    /// `v^T P v < 0`.
    pub fn check_expansion(
        &self,
        scheme: &PlaneScheme,
        polygon: &Polygon,
        expansion: &Expansion,
        work: &mut Work,
    ) -> Check<()> {
        let d = self.dimension;
        let letters = letters(&expansion.word, self.places.len(), MOST_WORDS)?;
        self.check_form(&expansion.corners, polygon, letters.len())?;
        let v = &expansion.vector;
        ensure(v.len() == d, "a vector of the wrong length")?;
        let small = v.iter().all(|x| x.unsigned_abs() < 1 << LARGEST);
        ensure(small, "a vector with too large numbers")?;
        for forms in &expansion.corners {
            let product = |k: usize| {
                let (i, j) = (k / d, k % d);
                i128::from(entry(&forms[0], d, i, j)) * i128::from(v[i]) * i128::from(v[j])
            };
            let value: i128 = (0..d * d).map(product).sum();
            ensure(value < 0, "a form that is not negative at the vector")?;
        }
        let steps = letters.iter().enumerate();
        let steps =
            steps.map(|(from, &letter)| Step { letter, from, to: (from + 1) % letters.len() });
        self.check_steps(scheme, polygon, &expansion.corners, &steps.collect::<Vec<_>>(), work)
    }

    fn check_form(&self, corners: &[Vec<Vec<i64>>], polygon: &Polygon, forms: usize) -> Check<()> {
        let count = polygon.corners().len();
        let fits = corners.len() == count && corners.iter().all(|corner| corner.len() == forms);
        ensure(fits, "the wrong number of quadratic forms")?;
        let size = self.dimension * (self.dimension + 1) / 2;
        let fits = corners.iter().flatten().all(|entries| entries.len() == size);
        ensure(fits, "a quadratic form of the wrong size")?;
        let small = |x: &i64| x.unsigned_abs() < 1 << LARGEST;
        let small = corners.iter().flatten().flatten().all(small);
        ensure(small, "a quadratic form with too large numbers")
    }

    /// Checks that `Q_to - B Q_from B^T` is positive definite on the polygon for each step.
    ///
    /// With the numerators `N` and the denominator `d` of `B`, times a number, this is so where `d² Q_to - N Q_from N^T` is.
    /// On each triangle with the first corner, `Q` is affine and `d` and `N` are of the degree `n` of the family, so
    /// this is a mean of the values of its polar form at the multisets of `2 n + 1` corners.
    fn check_steps(
        &self,
        scheme: &PlaneScheme,
        polygon: &Polygon,
        forms: &[Vec<Vec<i64>>],
        steps: &[Step],
        work: &mut Work,
    ) -> Check<()> {
        let corners = polygon.corners();
        let n = scheme.degree;
        let sets = controls(corners.len(), 2 * n + 1);
        let count = sets.len().saturating_mul(steps.len());
        ensure(count <= MOST_MATRICES, "more than 20000 matrices to check")?;
        // Only ratios matter: everything is measured by the denominator at the first corner.
        let unit = scheme.polar(&[], &vec![&corners[0]; n], work)?;
        ensure(!unit.denominator.is_zero(), "a piece with a pole at its first corner")?;
        let mut controls: BTreeMap<Vec<usize>, Control> = BTreeMap::new();
        for set in sets {
            work.spend((set.len() as u64 * 500) << set.len())?;
            let splits = splits(&set, n);
            for part in splits.keys().map(|(part, ..)| part) {
                if !controls.contains_key(part) {
                    let points: Vec<_> = part.iter().map(|&i| &corners[i]).collect();
                    let polar = scheme.polar(&scheme.difference, &points, work)?;
                    controls.insert(part.clone(), self.control(&polar, &unit)?);
                }
            }
            for step in steps {
                let mut sum = Sum::new(self.dimension);
                for ((left, corner, right), times) in &splits {
                    work.spend(500 + 2 * self.dimension.pow(3) as u64)?;
                    let [left, right] = [left, right].map(|part| &controls[part]);
                    let denominators = [left.denominator, right.denominator];
                    sum.add(denominators, &forms[*corner][step.to], *times);
                    let [left, right] = [left, right].map(|at| &at.letters[step.letter]);
                    sum.subtract(left, &forms[*corner][step.from], right, *times);
                }
                work.spend(20 * self.dimension.pow(3) as u64)?;
                let positive = is_positive_definite(sum.matrix, sum.error);
                ensure(positive, "a form is not shown to be mapped below the next one")?;
            }
        }
        Ok(())
    }

    /// The letters and the denominator from the values of polar forms, the unit being the denominator of another one.
    fn control(&self, polar: &Polar, unit: &Polar) -> Check<Control> {
        let weight = &polar.weight * &unit.denominator;
        let fixed = |value: &Integer, weight: &Integer| -> Check<i128> {
            let fixed = ((value * &unit.weight) << PLACES) / weight;
            let fixed = i128::try_from(&fixed).unwrap_or(i128::MAX);
            let small = fixed.unsigned_abs() < 1 << (PLACES + LARGEST_ENTRY);
            ensure(small, "an entry above 256")?;
            Ok(fixed)
        };
        let denominator = fixed(&polar.denominator, &weight)?;
        let weight = weight * &self.bound;
        let values = polar.values.iter().map(|value| fixed(value, &weight));
        let values: Vec<i128> = values.collect::<Check<_>>()?;
        let entry = |place: &Option<usize>| place.map_or(0, |i| values[i]);
        let letter = |matrix: &Vec<Option<usize>>| matrix.iter().map(entry).collect();
        Ok(Control { denominator, letters: self.places.iter().map(letter).collect() })
    }
}

/// The denominator and the numerators of the letters, row by row, at a control point: with `PLACES` binary places,
/// less than one place off.
struct Control {
    denominator: i128,
    letters: Vec<Vec<i128>>,
}

/// A sum of forms and products, with `FULL_PLACES` binary places.
struct Sum {
    dimension: usize,
    matrix: Vec<Vec<i128>>,
    /// By how much no entry is off.
    error: i128,
}

impl Sum {
    fn new(dimension: usize) -> Self {
        Sum { dimension, matrix: vec![vec![0; dimension]; dimension], error: 0 }
    }

    /// Adds `times l r Q`. `l r` is rounded first.
    fn add(&mut self, [left, right]: [i128; 2], form: &[i64], times: i128) {
        let (scale, shift) = ((left * right) >> PLACES, PLACES - FULL_PLACES);
        for (i, row) in self.matrix.iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                let q = i128::from(entry(form, self.dimension, i, j));
                *x += times * ((scale * q) >> shift);
            }
        }
        // Both factors are less than one place off, and rounding down adds one, here and above.
        let off = ((left.abs() + right.abs()) >> PLACES) + 3;
        let largest = form.iter().map(|q| i128::from(q.abs())).max().unwrap_or(0);
        self.error += times * (((off * largest) >> shift) + 2);
    }

    /// Subtracts `times L Q R^T`. `L Q` is rounded first.
    fn subtract(&mut self, left: &[i128], form: &[i64], right: &[i128], times: i128) {
        let d = self.dimension;
        let q = square(d, |i, j| i128::from(entry(form, d, i, j)));
        let half = square(d, |i, j| {
            let products = (0..d).map(|k| left[i * d + k] * q[k][j]);
            products.sum::<i128>() >> (PLACES - HALF_PLACES)
        });
        // The entries of L are less than one place off, and rounding down adds one.
        let weight = |row: &[i128]| row.iter().map(|x| x.abs()).sum::<i128>();
        let largest = |rows: &mut dyn Iterator<Item = i128>| rows.max().unwrap_or(0);
        let size = largest(&mut q.iter().map(|row| weight(row)));
        let half_error = 2 + (size >> (PLACES - HALF_PLACES));
        let shift = PLACES + HALF_PLACES - FULL_PLACES;
        for (i, row) in self.matrix.iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                let products = half[i].iter().zip(&right[j * d..][..d]).map(|(a, b)| a * b);
                *x -= times * (products.sum::<i128>() >> shift);
            }
        }
        // Of the product: what R is off, what L Q is off, and rounding.
        let of_right = largest(&mut half.iter().map(|row| weight(row))) + d as i128 * half_error;
        let of_half = half_error * largest(&mut right.chunks_exact(d).map(weight));
        self.error += times * (((of_right + of_half) >> shift) + 2);
    }
}

/// The multisets of so many corners of one of the triangles with the first corner.
fn controls(corners: usize, size: usize) -> BTreeSet<Vec<usize>> {
    let of = |k: usize| {
        let triangle = [0, k, k + 1];
        multisets(3, size)
            .into_iter()
            .map(move |set| set.into_iter().map(|i| triangle[i]).collect())
    };
    (1..corners - 1).flat_map(of).collect()
}

/// A part of a multiset, one element, and the other part.
type Split = (Vec<usize>, usize, Vec<usize>);

/// In which ways a multiset of `2 n + 1` elements is divided into `n`, one and `n`, and how often.
fn splits(set: &[usize], n: usize) -> BTreeMap<Split, i128> {
    let mut all = BTreeMap::new();
    for middle in 0..set.len() {
        for chosen in 0_u32..1 << set.len() {
            if chosen.count_ones() as usize != n || chosen >> middle & 1 == 1 {
                continue;
            }
            let part = |side: u32| {
                let places = (0..set.len()).filter(|&i| i != middle && chosen >> i & 1 == side);
                places.map(|i| set[i]).collect()
            };
            *all.entry((part(1), set[middle], part(0))).or_insert(0) += 1;
        }
    }
    all
}

/// The entry of a symmetric matrix of which the upper triangle is given row by row.
fn entry(triangle: &[i64], dimension: usize, i: usize, j: usize) -> i64 {
    let (i, j) = (i.min(j), i.max(j));
    triangle[i * (2 * dimension + 1 - i) / 2 + j - i]
}

fn square(size: usize, entry: impl Fn(usize, usize) -> i128) -> Vec<Vec<i128>> {
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 6 = 3!/(1! 1! 1!) and 30 = 5!/(2! 1! 2!).
    #[test]
    fn splits_are_counted_by_multinomials() {
        for (set, n) in [(vec![0, 1, 2], 1), (vec![4, 4, 7], 1), (vec![0, 0, 1, 1, 1], 2)] {
            let all = splits(&set, n);
            assert_eq!(all.values().sum::<i128>(), if n == 1 { 6 } else { 30 });
            for (left, middle, right) in all.keys() {
                let mut joined = [&left[..], &[*middle], &right[..]].concat();
                joined.sort_unstable();
                assert_eq!(joined, set);
            }
        }
        assert_eq!(splits(&[4, 4, 7], 1)[&(vec![4], 4, vec![7])], 2);
    }

    /// Two triangles share the diagonal from the first corner to the third, and the second corner is in none with the
    /// fourth.
    #[test]
    fn control_points_are_those_of_the_triangles() {
        let all = controls(4, 2);
        let without = [vec![1, 3]];
        let expected = multisets(4, 2).into_iter().filter(|set| !without.contains(set));
        assert_eq!(all, expected.collect::<BTreeSet<_>>());
        assert_eq!(controls(5, 1).len(), 5);
        assert!(!controls(5, 3).iter().any(|set| set.contains(&1) && set.contains(&4)));
        assert!(controls(5, 3).contains(&vec![0, 3, 4]));
    }

    /// `L Q R^T` for integers is exact up to the rounding that is announced.
    #[test]
    fn products_of_integers() {
        let fixed = |m: [i128; 4]| m.map(|x| x << PLACES);
        let mut sum = Sum::new(2);
        // [[2, 1], [1, 3]] - 2 [[1, 2], [0, 1]] [[5, -1], [-1, 4]] [[3, 0], [1, 1]]^T.
        sum.add([1 << PLACES; 2], &[2, 1, 3], 1);
        sum.subtract(&fixed([1, 2, 0, 1]), &[5, -1, 4], &fixed([3, 0, 1, 1]), 2);
        let expected = [[2 - 18, 1 - 20], [1 + 6, 3 - 6]];
        for (row, expected) in sum.matrix.iter().zip(expected) {
            for (x, expected) in row.iter().zip(expected) {
                assert_eq!(*x, i128::from(expected) << FULL_PLACES);
            }
        }
        assert!(sum.error < 1 << 10);
    }

    /// What is announced bounds what is off: entries of 44 binary places that stand for numbers almost one
    /// place away from zero, of both signs.
    #[test]
    fn rounding_is_announced() {
        let mut state = 1_u64;
        let mut next = move |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 8) as i64 as i128 % (1_i128 << bits) - (1 << (bits - 1))
        };
        for _ in 0..200 {
            // Twenty places more than the checker keeps.
            let mut long = || (next(54) << 12) + next(12);
            let exact: Vec<[i128; 4]> = (0..2).map(|_| [(); 4].map(|()| long())).collect();
            let form = [(); 3].map(|()| next(36) as i64);
            let kept = exact.iter().map(|m| m.map(|x| x / (1 << 20))).collect::<Vec<_>>();
            let mut sum = Sum::new(2);
            sum.subtract(&kept[0], &form, &kept[1], 3);
            let [l, r] = [exact[0], exact[1]];
            for i in 0..2 {
                for j in 0..2 {
                    let products = (0..4).map(|k| {
                        let (a, b) = (k / 2, k % 2);
                        Integer::from(l[2 * i + a])
                            * Integer::from(entry(&form, 2, a, b))
                            * Integer::from(r[2 * j + b])
                    });
                    let exact = products.sum::<Integer>() * Integer::from(-3);
                    let shift = 2 * (PLACES + 20) - FULL_PLACES;
                    let found = Integer::from(sum.matrix[i][j]) << shift;
                    let error = Integer::from(sum.error) << shift;
                    let off = found - exact;
                    assert!(off < error && -off < error);
                }
            }
            // Of l r Q with numbers in place of matrices.
            let [l, r] = [l[0], r[0]];
            let mut sum = Sum::new(2);
            sum.add([kept[0][0], kept[1][0]], &form, 3);
            for (i, j) in [(0, 0), (0, 1), (1, 1)] {
                let q = Integer::from(entry(&form, 2, i, j));
                let exact: Integer = Integer::from(l) * Integer::from(r) * q * Integer::from(3);
                let shift = 2 * (PLACES + 20) - FULL_PLACES;
                let off: Integer = (Integer::from(sum.matrix[i][j]) << shift) - exact;
                let error = Integer::from(sum.error) << shift;
                assert!(off < error && -off < error);
            }
        }
    }
}
