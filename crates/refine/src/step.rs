//! One step of refinement, in two loops: for points of few coordinates, and for long rows.

use std::array;
use std::ops::Range;

use crate::coordinate::Coordinate;
use crate::weights::Weights;

/// A part of every point of a sequence: of the point `i`, the coordinates from `offset` on, where the
/// points from `first` on follow each other every `stride` values.
pub(crate) struct View<'a, T> {
    pub values: &'a [T],
    pub first: i64,
    pub stride: usize,
    pub offset: usize,
}

// Derived, it would ask for coordinates that can be copied.
impl<T> Clone for View<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for View<'_, T> {}

/// Where new points go, one every `stride` values.
pub(crate) struct Target<'a, T> {
    pub values: &'a mut [T],
    pub stride: usize,
    pub offset: usize,
}

impl<T: Coordinate> Weights<T> {
    /// Writes `width` coordinates of the new points, which need none but the old points of the view.
    pub(crate) fn step(
        &self,
        old: View<'_, T>,
        new: &Range<i64>,
        width: usize,
        out: Target<'_, T>,
    ) {
        let whole = old.stride == width && out.stride == width;
        match width {
            1 if whole => self.step_points::<1>(old, new, out.values),
            2 if whole => self.step_points::<2>(old, new, out.values),
            3 if whole => self.step_points::<3>(old, new, out.values),
            4 if whole => self.step_points::<4>(old, new, out.values),
            _ => self.step_rows(old, new, width, out),
        }
    }

    fn step_points<const D: usize>(&self, old: View<'_, T>, new: &Range<i64>, out: &mut [T]) {
        let m = self.arity();
        // One class of remainders after the other: all its points have the same stencil.
        for (k, i) in (new.start..new.end).take(m).enumerate() {
            let stencil = &self.stencils[i.rem_euclid(m as i64) as usize];
            let start = (i.div_euclid(m as i64) + stencil.first - old.first) as usize;
            let (old, out) = (&old.values[start * D..], &mut out[k * D..]);
            let weights = &stencil.weights[..];
            match weights.len() {
                1 => unrolled::<T, 1, D>(weights, old, m, out),
                2 => unrolled::<T, 2, D>(weights, old, m, out),
                3 => unrolled::<T, 3, D>(weights, old, m, out),
                4 => unrolled::<T, 4, D>(weights, old, m, out),
                5 => unrolled::<T, 5, D>(weights, old, m, out),
                6 => unrolled::<T, 6, D>(weights, old, m, out),
                7 => unrolled::<T, 7, D>(weights, old, m, out),
                8 => unrolled::<T, 8, D>(weights, old, m, out),
                _ => by_rows::<T, D>(weights, old, m, out),
            }
        }
    }

    fn step_rows(&self, old: View<'_, T>, new: &Range<i64>, width: usize, out: Target<'_, T>) {
        let m = self.arity() as i64;
        let row =
            |i: i64| &old.values[(i - old.first) as usize * old.stride + old.offset..][..width];
        for (i, out_row) in new.clone().zip(out.values.chunks_mut(out.stride)) {
            let stencil = &self.stencils[i.rem_euclid(m) as usize];
            let first = i.div_euclid(m) + stencil.first;
            combine(&stencil.weights, |k| row(first + k), &mut out_row[out.offset..][..width]);
        }
    }
}

/// Every `m`-th point of `out` by a stencil of any length.
fn by_rows<T: Coordinate, const D: usize>(weights: &[T], old: &[T], m: usize, out: &mut [T]) {
    for (j, point) in out.chunks_mut(m * D).enumerate() {
        combine(weights, |k| &old[(j + k as usize) * D..][..D], &mut point[..D]);
    }
}

/// Every `m`-th point of `out` by a stencil of `N` weights, the first of them from the first points of
/// `old`; summed in the order of [`combine`].
fn unrolled<T: Coordinate, const N: usize, const D: usize>(
    weights: &[T],
    old: &[T],
    m: usize,
    out: &mut [T],
) {
    let weights: [T; N] = array::from_fn(|k| weights[k].clone());
    for (j, point) in out.chunks_mut(m * D).enumerate() {
        let window = &old[j * D..][..N * D];
        let mut sum: [T; D] = array::from_fn(|d| T::product(&weights[0], &window[d]));
        for k in 1..N {
            for d in 0..D {
                sum[d].add_product(&weights[k], &window[k * D + d]);
            }
        }
        point[..D].clone_from_slice(&sum);
    }
}

/// `out = Σ_k weights[k] · row(k)`, summed in this order whatever the loops.
pub(crate) fn combine<'a, T: Coordinate>(
    weights: &[T],
    row: impl Fn(i64) -> &'a [T],
    out: &mut [T],
) {
    match weights.len() {
        1 => fused::<T, 1>(weights, row, out),
        2 => fused::<T, 2>(weights, row, out),
        3 => fused::<T, 3>(weights, row, out),
        4 => fused::<T, 4>(weights, row, out),
        5 => fused::<T, 5>(weights, row, out),
        6 => fused::<T, 6>(weights, row, out),
        0 => out.fill(T::origin()),
        _ => {
            fused::<T, 6>(&weights[..6], &row, out);
            for (k, w) in (6..).zip(&weights[6..]) {
                for (sum, x) in out.iter_mut().zip(row(k)) {
                    sum.add_product(w, x);
                }
            }
        }
    }
}

/// The sum of `N` rows in one pass.
fn fused<'a, T: Coordinate, const N: usize>(
    weights: &[T],
    row: impl Fn(i64) -> &'a [T],
    out: &mut [T],
) {
    let weights: [T; N] = array::from_fn(|k| weights[k].clone());
    // As long as `out`: then no index has to be checked.
    let rows: [&[T]; N] = array::from_fn(|k| &row(k as i64)[..out.len()]);
    for (i, out) in out.iter_mut().enumerate() {
        let mut sum = T::product(&weights[0], &rows[0][i]);
        for k in 1..N {
            sum.add_product(&weights[k], &rows[k][i]);
        }
        *out = sum;
    }
}
