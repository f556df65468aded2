//! How fast words grow over a box, for pictures and for where to look.

use rayon::prelude::*;
use refinable_algebra::Rational;

use crate::float::{approximate, dyadic};
use crate::geometry::Place;
use crate::leading::fastest;
use crate::outline::Window;
use crate::plane::PlanePencil;
use crate::word::Word;

/// How long words are at the points of a picture, and where the least growth is sought, for two letters; for more letters
/// they are shorter, so that there are not many times as many.
const DRAWN: usize = 5;
const SOUGHT: usize = 8;
/// Binary places of logarithms.
const PLACES: u32 = 24;
/// Samples in each direction at first, and in each smaller box.
const GRID: usize = 40;
const FINE: usize = 9;
/// How many samples are followed, how much smaller a box is than the last, and how often.
const STARTS: usize = 6;
const SHRINK: f64 = 0.6;
const ROUNDS: usize = 40;

/// The short words, of which there are at most four times as many as for two letters.
fn words(pencil: &PlanePencil, longest: usize) -> Vec<Word> {
    let most = 4 << longest;
    let count = |length: &usize| pencil.letters().checked_pow(*length as u32);
    let length = (1..=longest).rev().find(|length| count(length).is_some_and(|n| n <= most));
    Word::necklaces(pencil.letters(), length.unwrap_or(1), pencil.is_mirrored())
}

/// `-log_m` of the growth per letter of the fastest of the short words at the nodes of a grid, the ends of the
/// box included, row by row from its lower end; a multiple of `2^-24`. Longer words may grow faster: the decay
/// of all products is this at the most, as far as floats can tell.
///
/// # Cost
/// All words of up to five letters, or as many shorter ones, at each node.
pub fn decay(pencil: &PlanePencil, window: &Window, [columns, rows]: [usize; 2]) -> Vec<Rational> {
    let words = words(pencil, DRAWN);
    let spans = floats(window);
    let at = |index: usize| {
        let steps = [(index % columns, columns), (index / columns, rows)];
        let place = [0, 1].map(|i| {
            let (k, count) = steps[i];
            spans[i][0] + (spans[i][1] - spans[i][0]) * k as f64 / (count.max(2) - 1) as f64
        });
        let growth = fastest(&pencil.at(place), &words).1;
        // Nilpotent matrices decay without bound.
        let decay = -growth.max(f64::MIN_POSITIVE).ln() / (pencil.letters() as f64).ln();
        dyadic(decay.clamp(-1000.0, 1000.0), PLACES)
    };
    (0..columns * rows).into_par_iter().map(at).collect()
}

/// Places of short numbers near where the fastest word grows least in a box, for each of the tolerances `t`:
/// there it grows by at most about `2^-t` of that faster. Places to look, not proofs. An empty side of the
/// box is kept.
///
/// # Cost
/// Some thousand samples, with all words of up to eight letters, or as many shorter ones, at each.
pub fn slowest(pencil: &PlanePencil, window: &Window, tolerances: &[u32]) -> Vec<[Rational; 2]> {
    let words = words(pencil, SOUGHT);
    let growth = |place: Place| fastest(&pencil.at(place), &words).1;
    let spans = floats(window);
    let extents = spans.map(|[low, high]| high - low);
    let middle = spans.map(|[low, high]| 0.5 * (low + high));
    // Never beyond the box.
    let samples = |middle: Place, extents: Place, count: usize| {
        let inside = |place: Place| [0, 1].map(|i| place[i].clamp(spans[i][0], spans[i][1]));
        samples(middle, extents, count, &inside, &growth)
    };
    let mut first = samples(middle, extents, GRID);
    first.sort_by(|a, b| a.1.total_cmp(&b.1));
    let lowest = first.into_iter().take(STARTS).map(|start| {
        let mut best = start;
        let mut extents = extents.map(|e| e * 4.0 / GRID as f64);
        for _ in 0..ROUNDS {
            let around = samples(best.0, extents, FINE);
            best = around.into_iter().fold(best, |a, b| if b.1 < a.1 { b } else { a });
            extents = extents.map(|e| e * SHRINK);
        }
        best
    });
    let (place, least) = lowest.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are starts");
    let around = |bits: u32| {
        // The nodes of the lattice around the place.
        let ends = [0, 1].map(|i| {
            if extents[i] == 0.0 {
                return vec![window[i][0].clone()];
            }
            let unit = 2f64.powi(bits as i32);
            [(place[i] * unit).floor(), (place[i] * unit).ceil()]
                .map(|x| dyadic(x / unit, bits))
                .into()
        });
        let [across, up] = ends;
        across.into_iter().flat_map(move |u| up.clone().into_iter().map(move |v| [u.clone(), v]))
    };
    let near = tolerances.iter().filter_map(|t| {
        let limit = least * (1.0 + 2f64.powi(-(*t as i32)));
        let in_box =
            |p: &[Rational; 2]| p.iter().zip(window).all(|(x, [low, high])| low <= x && x <= high);
        let is_near =
            |p: &[Rational; 2]| in_box(p) && growth(p.each_ref().map(approximate)) <= limit;
        (1..=LONGEST).flat_map(around).find(is_near)
    });
    near.collect()
}

/// The longest binary fractions.
const LONGEST: u32 = 40;

fn samples(
    middle: Place,
    extents: Place,
    count: usize,
    inside: &(impl Fn(Place) -> Place + Sync),
    growth: &(impl Fn(Place) -> f64 + Sync),
) -> Vec<(Place, f64)> {
    let counts = extents.map(|e| if e == 0.0 { 1 } else { count });
    let at = |index: usize| {
        let steps = [index % counts[0], index / counts[0]];
        let place = [0, 1]
            .map(|i| middle[i] + extents[i] * ((steps[i] as f64 + 0.5) / counts[i] as f64 - 0.5));
        let place = inside(place);
        (place, growth(place))
    };
    (0..counts[0] * counts[1]).into_par_iter().map(at).collect()
}

fn floats(window: &Window) -> [Place; 2] {
    window.each_ref().map(|span| span.each_ref().map(approximate))
}
