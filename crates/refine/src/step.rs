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
        let m = self.arity() as i64;
        let (mut i, mut class) = (new.start.div_euclid(m), new.start.rem_euclid(m) as usize);
        for point in out.chunks_exact_mut(D) {
            let stencil = &self.stencils[class];
            let start = (i + stencil.first - old.first) as usize * D;
            let window = &old.values[start..start + stencil.weights.len() * D];
            let mut terms = stencil.weights.iter().zip(window.chunks_exact(D));
            let mut sum: [T; D] = array::from_fn(|_| T::origin());
            if let Some((w, x)) = terms.next() {
                sum = array::from_fn(|k| T::product(w, &x[k]));
            }
            for (w, x) in terms {
                for k in 0..D {
                    sum[k].add_product(w, &x[k]);
                }
            }
            point.clone_from_slice(&sum);
            class += 1;
            if class == self.stencils.len() {
                (class, i) = (0, i + 1);
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

/// `out = Σ_k weights[k] · row(k)`, summed in this order whatever the loops.
pub(crate) fn combine<'a, T: Coordinate>(
    weights: &[T],
    row: impl Fn(i64) -> &'a [T],
    out: &mut [T],
) {
    let Some((w, rest)) = weights.split_first() else { return };
    for (sum, x) in out.iter_mut().zip(row(0)) {
        *sum = T::product(w, x);
    }
    // Two rows at once: fewer passes over `out`.
    for (k, pair) in (1..).step_by(2).zip(rest.chunks(2)) {
        match pair {
            [v, w] => {
                for ((sum, x), y) in out.iter_mut().zip(row(k)).zip(row(k + 1)) {
                    sum.add_product(v, x);
                    sum.add_product(w, y);
                }
            }
            _ => {
                for (sum, x) in out.iter_mut().zip(row(k)) {
                    sum.add_product(&pair[0], x);
                }
            }
        }
    }
}
