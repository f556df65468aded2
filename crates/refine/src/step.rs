//! One step of refinement, in two loops: for points of few coordinates, and for long rows.

use std::array;
use std::ops::Range;

use pulp::Arch;

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
    ///
    /// With the longest vectors that the machine has; products and sums are rounded one by one on all of
    /// them, so that the result is the same.
    pub(crate) fn step(
        &self,
        old: View<'_, T>,
        new: &Range<i64>,
        width: usize,
        out: Target<'_, T>,
    ) {
        Arch::new().dispatch(
            // What is not inlined would be compiled without these vectors: hence the attributes here.
            #[inline(always)]
            || self.step_all(old, new, width, out),
        );
    }

    #[inline(always)]
    fn step_all(&self, old: View<'_, T>, new: &Range<i64>, width: usize, out: Target<'_, T>) {
        let whole = old.stride == width && out.stride == width;
        match width {
            1 if whole => self.step_points::<1, 2>(old, new, out.values),
            2 if whole => self.step_points::<2, 4>(old, new, out.values),
            3 if whole => self.step_points::<3, 6>(old, new, out.values),
            4 if whole => self.step_points::<4, 8>(old, new, out.values),
            _ => self.step_rows(old, new, width, out),
        }
    }

    /// For points of `D` coordinates; `PAIR = 2 D`.
    #[inline(always)]
    fn step_points<const D: usize, const PAIR: usize>(
        &self,
        old: View<'_, T>,
        new: &Range<i64>,
        out: &mut [T],
    ) {
        let m = self.arity();
        let done = if T::EXACT { 0 } else { self.step_pairs::<D, PAIR>(old, new, out) };
        let (new, out) = (new.start + done as i64..new.end, &mut out[done * D..]);
        // One class of remainders after the other: all its points have the same stencil.
        for (k, i) in new.take(m).enumerate() {
            let (start, weights) = self.stencil_at(i, &old);
            let (old, out) = (&old.values[start as usize * D..], &mut out[k * D..]);
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

    /// New points of a binary scheme two at a time, from all old points that either of them needs; a
    /// point that only the other one needs has the weight zero. How many points are made: all but the
    /// last of an odd number, or none where the stencils are empty or together too long.
    #[inline(always)]
    fn step_pairs<const D: usize, const PAIR: usize>(
        &self,
        old: View<'_, T>,
        new: &Range<i64>,
        out: &mut [T],
    ) -> usize {
        let stencils = [new.start, new.start + 1].map(|i| self.stencil_at(i, &old));
        let pairs = out.len() / PAIR;
        if self.arity() != 2 || pairs == 0 || stencils.iter().any(|(_, w)| w.is_empty()) {
            return 0;
        }
        let [(even, even_weights), (odd, odd_weights)] = stencils;
        let first = even.min(odd);
        let end = (even + even_weights.len() as i64).max(odd + odd_weights.len() as i64);
        let weight = |k: i64, (start, weights): (i64, &[T])| {
            let weight = usize::try_from(k - start).ok().and_then(|k| weights.get(k));
            weight.cloned().unwrap_or(T::origin())
        };
        let weights: Vec<_> = (first..end).map(|k| stencils.map(|s| weight(k, s))).collect();
        let (old, out) = (&old.values[first as usize * D..], &mut out[..pairs * PAIR]);
        match weights.len() {
            2 => in_pairs::<T, 2, D, PAIR>(&weights, old, out),
            3 => in_pairs::<T, 3, D, PAIR>(&weights, old, out),
            4 => in_pairs::<T, 4, D, PAIR>(&weights, old, out),
            5 => in_pairs::<T, 5, D, PAIR>(&weights, old, out),
            6 => in_pairs::<T, 6, D, PAIR>(&weights, old, out),
            7 => in_pairs::<T, 7, D, PAIR>(&weights, old, out),
            8 => in_pairs::<T, 8, D, PAIR>(&weights, old, out),
            _ => return 0,
        }
        2 * pairs
    }

    /// Where in the view the stencil of the new point `i` begins, and its weights.
    #[inline(always)]
    fn stencil_at(&self, i: i64, old: &View<'_, T>) -> (i64, &[T]) {
        let m = self.arity() as i64;
        let stencil = &self.stencils[i.rem_euclid(m) as usize];
        (i.div_euclid(m) + stencil.first - old.first, &stencil.weights)
    }

    #[inline(always)]
    fn step_rows(&self, old: View<'_, T>, new: &Range<i64>, width: usize, out: Target<'_, T>) {
        let row = |i: i64| &old.values[i as usize * old.stride + old.offset..][..width];
        for (i, out_row) in new.clone().zip(out.values.chunks_mut(out.stride)) {
            let (start, weights) = self.stencil_at(i, &old);
            combine(weights, |k| row(start + k), &mut out_row[out.offset..][..width]);
        }
    }
}

/// Pairs of new points from all `N` old points that they need, the first of them from the first points of
/// `old`; summed in the order of [`combine`]. `weights[k]` are those of both new points.
#[inline(always)]
fn in_pairs<T: Coordinate, const N: usize, const D: usize, const PAIR: usize>(
    weights: &[[T; 2]],
    old: &[T],
    out: &mut [T],
) {
    // As many weights as values: then the sums are those of vectors.
    let weights: [[T; PAIR]; N] = array::from_fn(|k| array::from_fn(|v| weights[k][v / D].clone()));
    for (j, pair) in out.as_chunks_mut::<PAIR>().0.iter_mut().enumerate() {
        let window = &old[j * D..][..N * D];
        let mut sums: [T; PAIR] = array::from_fn(|v| T::product(&weights[0][v], &window[v % D]));
        for k in 1..N {
            for v in 0..PAIR {
                sums[v].add_product(&weights[k][v], &window[k * D + v % D]);
            }
        }
        *pair = sums;
    }
}

/// Every `m`-th point of `out` by a stencil of any length.
#[inline(always)]
fn by_rows<T: Coordinate, const D: usize>(weights: &[T], old: &[T], m: usize, out: &mut [T]) {
    for (j, point) in out.chunks_mut(m * D).enumerate() {
        combine(weights, |k| &old[(j + k as usize) * D..][..D], &mut point[..D]);
    }
}

/// Every `m`-th point of `out` by a stencil of `N` weights, the first of them from the first points of
/// `old`; summed in the order of [`combine`].
#[inline(always)]
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
#[inline(always)]
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
#[inline(always)]
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
