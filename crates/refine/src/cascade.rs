//! Several steps at once: which points they need, and a descent block by block.
//!
//! What is asked for is a range of points of the last level. The ranges that it needs on the levels
//! before are found backwards; from the control points they are filled forwards, a block of the last
//! level at a time. A block stays in the cache through all levels, blocks do not depend on each other,
//! and nothing is kept but the control points and the result.

use std::ops::Range;

use rayon::prelude::*;
use refinable_algebra::{Rational, Ring};
use refinable_scheme::Diagnostic;

use crate::coordinate::Coordinate;
use crate::ends::Ends;
use crate::step::{Target, View};
use crate::weights::Weights;

/// Points of the last level in a block of a curve: with their ancestors they fit into a cache.
const BLOCK: usize = 4096;
/// Values of a row in a tile.
const TILE: usize = 512;
/// Rows in a band of a surface.
pub(crate) const BAND: usize = 64;

/// Rules to be applied one after the other, to a control polygon of some length.
pub(crate) struct Cascade<'a, T> {
    rules: Vec<&'a Weights<T>>,
    /// The points of the last level that are asked for.
    last: Range<i64>,
}

impl<'a, T: Coordinate> Cascade<'a, T> {
    /// The cascade of `rules` on a polygon of `count` points, with all points of the last level that
    /// belong to it: for a closed polygon one period; with ghost points those that stand between the
    /// first and the last control point; else those that the control points determine.
    ///
    /// # Errors
    /// Code `levels` if there are more points than can be counted, `points` if there is none.
    pub fn new(
        rules: Vec<&'a Weights<T>>,
        count: usize,
        closed: bool,
        ends: Ends,
    ) -> Result<Self, Diagnostic> {
        // No index on any level is larger than this: it moves on by what stencils reach, level by level.
        let reach = rules.iter().map(|rule| rule.reach()).max().unwrap_or(0);
        let factor = |rule: &&Weights<T>| u128::from(rule.arity() as u64);
        let total = |count: u128| rules.iter().map(factor).try_fold(count, u128::checked_mul);
        let largest = total(count as u128 + 2 * u128::from(reach) + 2);
        if largest.is_none_or(|n| n > LARGEST_INDEX) {
            let message = format!("{} levels make more points than can be counted", rules.len());
            return Err(Diagnostic::new("levels", message).with_hint("ask for fewer levels"));
        }
        let total = total(count as u128).unwrap_or_default();
        let last = if closed {
            0..total as i64
        } else if ends == Ends::Trim {
            rules.iter().fold(0..count as i64, |old, rule| rule.produced(&old))
        } else {
            between_ends(&rules, count)
        };
        if last.is_empty() {
            return Err(too_few(&rules, count));
        }
        Ok(Cascade { rules, last })
    }

    /// The rules, the first first.
    pub fn rules(&self) -> &[&'a Weights<T>] {
        &self.rules
    }

    /// The points of the last level.
    pub fn last(&self) -> &Range<i64> {
        &self.last
    }

    /// How many points the last level has.
    pub fn count(&self) -> usize {
        (self.last.end - self.last.start) as usize
    }

    /// Only these points of the last level.
    pub fn restricted(self, last: Range<i64>) -> Self {
        Cascade { last, ..self }
    }

    /// The ranges of all levels for a range of the last one, control points first.
    pub fn ranges(&self, last: &Range<i64>) -> Vec<Range<i64>> {
        let mut ranges = vec![last.clone()];
        for rule in self.rules.iter().rev() {
            let needed = rule.needed(&ranges[ranges.len() - 1]);
            ranges.push(needed);
        }
        ranges.reverse();
        ranges
    }

    /// The control points that are needed.
    pub fn control(&self) -> Range<i64> {
        self.ranges(&self.last)[0].clone()
    }

    /// The points of the last level from the control points of [`control`](Self::control), `width`
    /// coordinates each.
    pub fn descend(&self, control: &[T], width: usize) -> Vec<T> {
        let mut out = vec![T::origin(); self.count() * width];
        if width <= TILE {
            self.fill(control, width, BLOCK.div_ceil(width), &mut out);
        } else {
            self.fill(control, width, BAND, &mut out);
        }
        out
    }

    fn fill(&self, control: &[T], width: usize, block: usize, out: &mut [T]) {
        out.par_chunks_mut(block * width).enumerate().for_each(|(k, out)| {
            let start = self.last.start + (k * block) as i64;
            let points = out.len() / width;
            self.block(control, width, &(start..start + points as i64), out);
        });
    }

    /// A block of the last level, tile by tile.
    pub fn block(&self, control: &[T], width: usize, last: &Range<i64>, out: &mut [T]) {
        let ranges = self.ranges(last);
        let first = self.control().start;
        let mut buffers = [Vec::new(), Vec::new()];
        for offset in (0..width).step_by(TILE) {
            let tile = TILE.min(width - offset);
            let control = View { values: control, first, stride: width, offset };
            let out = Target { values: &mut *out, stride: width, offset };
            self.tile(control, &ranges, tile, &mut buffers, out);
        }
    }

    fn tile(
        &self,
        control: View<'_, T>,
        ranges: &[Range<i64>],
        width: usize,
        buffers: &mut [Vec<T>; 2],
        out: Target<'_, T>,
    ) {
        let Some((final_rule, rules)) = self.rules.split_last() else {
            copy(control, &ranges[0], width, out);
            return;
        };
        let [old, new] = buffers;
        let mut source = None;
        for (rule, range) in rules.iter().zip(&ranges[1..]) {
            new.resize((range.end - range.start) as usize * width, T::origin());
            let target = Target { values: &mut *new, stride: width, offset: 0 };
            rule.step(view(control, source, old, width), range, width, target);
            std::mem::swap(old, new);
            source = Some(range.start);
        }
        let last = &ranges[ranges.len() - 1];
        final_rule.step(view(control, source, old, width), last, width, out);
    }
}

/// The points of the level before: in the buffer, once there is a first one.
fn view<'a, T>(
    control: View<'a, T>,
    first: Option<i64>,
    buffer: &'a [T],
    width: usize,
) -> View<'a, T> {
    match first {
        Some(first) => View { values: buffer, first, stride: width, offset: 0 },
        None => control,
    }
}

fn copy<T: Coordinate>(old: View<'_, T>, range: &Range<i64>, width: usize, out: Target<'_, T>) {
    for (i, row) in range.clone().zip(out.values.chunks_mut(out.stride)) {
        let from = (i - old.first) as usize * old.stride + old.offset;
        row[out.offset..][..width].clone_from_slice(&old.values[from..][..width]);
    }
}

/// Indices are not larger, with room for sums and products of a few of them.
const LARGEST_INDEX: u128 = 1 << 56;

/// The points of the last level that stand from the first to the last control point.
fn between_ends<T: Coordinate>(rules: &[&Weights<T>], count: usize) -> Range<i64> {
    // A new point `i` stands at `(i - τ)/m`: both ends are carried from level to level.
    let mut ends = [Rational::zero(), Rational::from_i64(count as i64 - 1)];
    for rule in rules {
        let m = Rational::from_i64(rule.arity() as i64);
        ends = ends.map(|t| t * &m + rule.shift());
    }
    let [first, last] = [ends[0].ceil(), ends[1].floor()].map(|t| i64::try_from(t.to_integer()));
    // Coefficients may be large, and then points stand anywhere: none of them between the ends.
    match (first, last) {
        (Ok(first), Ok(last)) if first.abs().max(last.abs()) < 1 << 60 => first..last + 1,
        _ => 0..0,
    }
}

fn too_few<T: Coordinate>(rules: &[&Weights<T>], count: usize) -> Diagnostic {
    let enough = (count + 1..=count + LARGEST_STENCIL)
        .find(|&n| !rules.iter().fold(0..n as i64, |old, rule| rule.produced(&old)).is_empty());
    let message = format!("too few points for the stencils of the scheme: {count}");
    let hint = match enough {
        Some(n) => format!("give {n} or more, close the polygon, or continue it beyond its ends"),
        None => {
            "close the polygon, or take a scheme whose points stand among the old ones".to_string()
        }
    };
    Diagnostic::new("points", message).with_hint(hint)
}

/// How many more points are tried for the hint.
const LARGEST_STENCIL: usize = 4096;
