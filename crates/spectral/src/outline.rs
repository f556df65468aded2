//! Where to look: a box around the set on which a set of matrices contracts.

use rayon::prelude::*;
use refinable_algebra::Rational;

use crate::float::dyadic;
use crate::geometry::Place;
use crate::leading::fastest;
use crate::plane::PlanePencil;
use crate::word::Word;

/// The lower and upper ends of two intervals.
pub type Window = [[Rational; 2]; 2];

/// Samples in each direction.
const GRID: usize = 32;
/// The half sides of the boxes around the origin that are looked at first.
const FIRST: std::ops::RangeInclusive<i32> = -10..=2;
/// How often a box is fitted.
const ROUNDS: usize = 16;
/// Which part of the set, at each of the four sides, the box may leave out.
const TAIL: f64 = 0.02;
/// No box goes beyond this in either direction.
const FARTHEST: f64 = 16.0;
/// What is left around the set, against its extent.
const SPACE: f64 = 0.08;

/// A box with some margin around the set on which all short words shrink, or around where they grow
/// least if there is no such place.
///
/// # Cost
/// Some thousand samples for each box that is fitted, with all short words at each.
pub fn outline(pencil: &PlanePencil) -> Window {
    let look = Look { pencil, words: Word::necklaces(pencil.letters(), 3, pencil.is_mirrored()) };
    let mut best: Option<(f64, Frame)> = None;
    for power in FIRST.rev() {
        let half = 2f64.powi(power);
        let found = look.at([[-half, half]; 2]);
        // A set with a few samples is as good as one with many, but large boxes come first.
        let merit = found.inside.len().min(12) as f64 - found.least.1;
        if best.as_ref().is_none_or(|(most, _)| merit > *most) {
            best = Some((merit, found));
        }
    }
    let (_, mut frame) = best.expect("there is a first box");
    for _ in 0..ROUNDS {
        let next = frame.fitted();
        if next == frame.window {
            break;
        }
        frame = look.at(next);
    }
    frame.rounded()
}

struct Look<'a> {
    pencil: &'a PlanePencil,
    words: Vec<Word>,
}

/// A box, and where in it words shrink.
struct Frame {
    window: [Place; 2],
    inside: Vec<[usize; 2]>,
    /// Where growth is least, and how large it is.
    least: ([usize; 2], f64),
}

impl Look<'_> {
    fn at(&self, window: [Place; 2]) -> Frame {
        let growth: Vec<f64> = (0..GRID * GRID)
            .into_par_iter()
            .map(|k| {
                let index = [k % GRID, k / GRID];
                let place = [0, 1].map(|i| sample(window[i], index[i] as f64 + 0.5));
                fastest(&self.pencil.at(place), &self.words).1
            })
            .collect();
        let index = |k: usize| [k % GRID, k / GRID];
        let inside = (0..growth.len()).filter(|&k| growth[k] < 1.0).map(index).collect();
        let least = (0..growth.len()).min_by(|&a, &b| growth[a].total_cmp(&growth[b])).unwrap_or(0);
        Frame { window, inside, least: (index(least), growth[least]) }
    }
}

fn sample([low, high]: Place, step: f64) -> f64 {
    low + (high - low) * step / GRID as f64
}

impl Frame {
    /// The box around what is inside, with a sample to spare on each side; larger where it touches the
    /// box. A smaller one around the best sample if nothing is inside.
    fn fitted(&self) -> [Place; 2] {
        [0, 1].map(|i| {
            let span = self.window[i];
            let within = |x: f64| x.clamp(-FARTHEST, FARTHEST);
            if self.inside.is_empty() {
                let at = self.least.0[i] as f64 + 0.5;
                let room = GRID as f64 / 8.0;
                return [sample(span, at - room), sample(span, at + room)].map(within);
            }
            // Thin tails are left to those who ask for them.
            let mut places: Vec<usize> = self.inside.iter().map(|k| k[i]).collect();
            places.sort_unstable();
            let few = (TAIL * places.len() as f64) as usize;
            let (low, high) = (places[few], places[places.len() - 1 - few] + 1);
            let room = |touches: bool| if touches { GRID as f64 / 2.0 } else { 1.0 };
            let low = low as f64 - room(low == 0);
            let high = high as f64 + room(high == GRID);
            [sample(span, low), sample(span, high)].map(within)
        })
    }

    /// With a margin, and short numbers.
    fn rounded(&self) -> Window {
        [0, 1].map(|i| {
            let [low, high] = self.window[i];
            let extent = high - low;
            let unit = 2f64.powi((extent / 16.0).log2().floor() as i32);
            let round = |x: f64| dyadic(x * unit, 60);
            let low = ((low - SPACE * extent) / unit).floor();
            let high = ((high + SPACE * extent) / unit).ceil();
            [round(low), round(high)]
        })
    }
}
