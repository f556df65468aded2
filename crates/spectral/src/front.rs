//! Where the boundary of contraction runs through a polygon, in floats.

use std::collections::BTreeSet;

use rayon::prelude::*;

use crate::geometry::{Place, between, contains, distance, dot, edges, extent, moved};
use crate::leading::fastest;
use crate::plane::PlanePencil;
use crate::word::Word;

/// How long words are that may lead somewhere,
const LONGEST_WORD: usize = 8;
/// those that are tried everywhere,
const SHORT_WORD: usize = 4;
/// and by how much short words must grow where long ones are tried.
const SLOW: f64 = 0.7;
/// Samples across a polygon at which words are compared.
const GRID: usize = 24;
/// Samples along the edges of a piece, about.
const SAMPLES: f64 = 24.0;
/// Places along a chord at which the boundary is sought.
const STEPS: usize = 4;
/// How accurately it is found, against the length of the chord.
const ACCURACY: f64 = 1e-4;

/// Tells where words shrink.
pub(crate) struct Sampler<'a> {
    pencil: &'a PlanePencil,
    scale: Place,
    /// The words that lead somewhere.
    pub words: Vec<Word>,
}

/// A nearly straight piece of the boundary: where it is across the direction from the inside to the
/// outside.
pub(crate) struct Front {
    pub normal: Place,
    pub low: f64,
    pub high: f64,
    pub length: f64,
    /// Where its middle is along the direction `(-n_y, n_x)`.
    pub middle: f64,
}

impl<'a> Sampler<'a> {
    /// With the words that lead somewhere in the polygons, all scaled.
    pub fn new(pencil: &'a PlanePencil, scale: Place, polygons: &[Vec<Place>]) -> Self {
        let necklaces = |longest| Word::necklaces(pencil.letters(), longest, pencil.is_mirrored());
        let (short, long) = (necklaces(SHORT_WORD), necklaces(LONGEST_WORD));
        let samples = polygons.iter().flat_map(|corners| {
            let axes = [extent(corners, [1.0, 0.0]), extent(corners, [0.0, 1.0])];
            let place = move |k: usize| {
                let step = [k % GRID, k / GRID].map(|i| (i as f64 + 0.5) / GRID as f64);
                [0, 1].map(|i| axes[i].0 + step[i] * (axes[i].1 - axes[i].0))
            };
            (0..GRID * GRID).map(place).filter(|place| contains(corners, *place))
        });
        let leader = |place: Place| {
            let matrices = pencil.at([0, 1].map(|i| place[i] * scale[i]));
            let (word, growth) = fastest(&matrices, &short);
            // Far from the boundary on either side it does not matter which word leads.
            let near = (SLOW..1.0 / SLOW).contains(&growth);
            (if near { fastest(&matrices, &long).0 } else { word }).clone()
        };
        let samples: Vec<Place> = samples.collect();
        let leaders: BTreeSet<Word> = samples.into_par_iter().map(leader).collect();
        let mut words: Vec<Word> = leaders.into_iter().collect();
        words.sort_by_key(|word| word.letters().len());
        Sampler { pencil, scale, words }
    }

    /// Whether all words shrink at a place.
    fn shrinks(&self, place: Place) -> bool {
        let matrices = self.pencil.at([0, 1].map(|i| place[i] * self.scale[i]));
        fastest(&matrices, &self.words).1 < 1.0
    }

    /// Whether words shrink everywhere on the edges of a polygon, or nowhere; otherwise two places where
    /// the boundary crosses them, if there are just two.
    pub fn crossings(&self, corners: &[Place]) -> Result<bool, Option<[Place; 2]>> {
        let around: f64 = edges(corners).map(|(a, b)| distance(a, b)).sum();
        let samples = edges(corners).flat_map(|(a, b)| {
            let count = (SAMPLES * distance(a, b) / around).ceil().max(1.0);
            (0..count as usize).map(move |k| between(a, b, k as f64 / count))
        });
        let ring: Vec<(Place, bool)> = samples.map(|place| (place, self.shrinks(place))).collect();
        let next = |i: usize| ring[(i + 1) % ring.len()];
        let changes: Vec<usize> = (0..ring.len()).filter(|&i| ring[i].1 != next(i).1).collect();
        match changes[..] {
            [] => Ok(ring[0].1),
            [i, j] => {
                let tolerance = ACCURACY * distance(ring[i].0, ring[j].0);
                Err(Some([i, j].map(|i| self.crossing(ring[i].0, next(i).0, tolerance))))
            }
            _ => Err(None),
        }
    }

    /// A place on the boundary between two of which one is inside.
    fn crossing(&self, mut a: Place, mut b: Place, tolerance: f64) -> Place {
        let inside = self.shrinks(a);
        while distance(a, b) > tolerance {
            let middle = between(a, b, 0.5);
            if middle == a || middle == b {
                break;
            }
            if self.shrinks(middle) == inside {
                a = middle;
            } else {
                b = middle;
            }
        }
        between(a, b, 0.5)
    }

    /// How the boundary runs between two places on the edges, if it can be followed.
    pub fn front(&self, corners: &[Place], [p, q]: [Place; 2]) -> Option<Front> {
        let length = distance(p, q);
        let middle = between(p, q, 0.5);
        let across = [(q[1] - p[1]) / length, (p[0] - q[0]) / length];
        let out = self.outwards(corners, middle, across, length)?;
        // Rounded so that numbers stay short.
        let normal = across.map(|x| (x * out * 4096.0).round() / 4096.0);
        let mut offsets = vec![dot(normal, p), dot(normal, q)];
        for k in 1..=STEPS {
            let place = between(p, q, k as f64 / (STEPS + 1) as f64);
            offsets.push(dot(normal, self.beside(corners, place, normal, length)?));
        }
        let low = offsets.iter().copied().fold(f64::INFINITY, f64::min);
        let high = offsets.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let middle = dot([-normal[1], normal[0]], middle);
        Some(Front { normal, low, high, length, middle })
    }

    /// 1 if words grow on the side to which the direction points, -1 if on the other.
    fn outwards(&self, corners: &[Place], at: Place, direction: Place, length: f64) -> Option<f64> {
        let steps = std::iter::successors(Some(0.25 * length), |step| Some(0.5 * step));
        steps.take_while(|step| *step > ACCURACY * length).find_map(|step| {
            let sides = [step, -step].map(|by| moved(at, direction, by));
            let inside = sides.map(|place| contains(corners, place).then(|| self.shrinks(place)));
            match inside {
                [Some(false), Some(true)] => Some(1.0),
                [Some(true), Some(false)] => Some(-1.0),
                // In a thin piece one side tells.
                [Some(false), None] | [None, Some(true)] => Some(1.0),
                [Some(true), None] | [None, Some(false)] => Some(-1.0),
                _ => None,
            }
        })
    }

    /// The place on the boundary ahead of or behind another one, within the polygon.
    fn beside(&self, corners: &[Place], from: Place, normal: Place, length: f64) -> Option<Place> {
        let inside = self.shrinks(from);
        let sign = if inside { 1.0 } else { -1.0 };
        let mut step = 1e-3 * length;
        let mut last = from;
        while step < length {
            let there = moved(from, normal, sign * step);
            if !contains(corners, there) {
                return None;
            }
            if self.shrinks(there) != inside {
                return Some(self.crossing(last, there, ACCURACY * length));
            }
            last = there;
            step *= 2.0;
        }
        None
    }
}
