//! Polytopes for parts of an interval on which no word is known to reach spectral radius one.

use nalgebra::DMatrix;
use refinable_algebra::{Integer, Polynomial, Rational};
use refinable_certificate::{self as certificate, End, Number, Polytope, Root};
use refinable_reals::{RealAlgebraic, real_roots_between};

use crate::body::{Body, Closing, Effort, Ends};
use crate::float::{approximate, approximate_root, dyadic, short_dyadic};
use crate::leading::{fastest, growth};
use crate::pencil::Pencil;
use crate::rounding::{Precision, Span, polytope};
use crate::seed::{Seed, Sowing};
use crate::word::Word;

/// The amounts, in floats, by which images must be inside.
const MARGINS: [f64; 2] = [1e-5, 1e-7];
/// The same where growth is less than one: a part of what is left, since with all of it nothing would
/// close, but no less than so much, since only the leading orbit need be so near the boundary.
const MARGINS_INSIDE: [(f64, f64); 2] = [(0.25, 1e-3), (0.025, 1e-5)];
/// The largest numbers of vertices of a polytope, mirror images not counted, tried in turn.
const MOST_VERTICES: [usize; 2] = [150, 750];
/// The same for a polytope on a closed interval, of which there may be many.
const CLOSED_VERTICES: [usize; 3] = [60, 240, 750];
/// Below which part of the way a step is not worth while.
const LEAST_REACH: f64 = 1e-5;
/// The lengths of unit vectors inside a polytope, the best first: the fatter it is, the less it minds
/// that matrices change.
const FATNESS: [f64; 2] = [0.3, 0.01];
/// The length of words that may show that two ends are too far apart for one polytope.
const PROBE: usize = 4;
/// Precisions for a polytope up to an exact end, and for one on a closed interval.
const EXACT: [Precision; 3] = [
    Precision { bits: 32, weight_bits: 20 },
    Precision { bits: 40, weight_bits: 32 },
    Precision { bits: 50, weight_bits: 44 },
];
const CLOSED: [Precision; 4] = [
    Precision { bits: 14, weight_bits: 12 },
    Precision { bits: 20, weight_bits: 18 },
    Precision { bits: 32, weight_bits: 28 },
    Precision { bits: 48, weight_bits: 44 },
];

/// A word, a sign and the polynomial `det(I - sign Π_w)` that vanishes where the word reaches one.
#[derive(Clone, Debug)]
pub(crate) struct Crossing {
    pub word: Word,
    pub sign: i32,
    pub determinant: Polynomial<Integer>,
}

/// What searches have in common.
pub(crate) struct Search<'a> {
    pub pencil: &'a Pencil,
    pub kind: certificate::Pencil,
    pub words: &'a [Word],
    /// The independent checker.
    pub accept: &'a (dyn Fn(&Polytope) -> bool + Sync),
}

/// The outcome of a search on a closed interval.
pub(crate) enum Closed {
    /// It is proved.
    Proved(Box<Polytope>),
    /// A word grows somewhere in it.
    Faster(Word),
    /// The effort did not suffice.
    Nothing,
}

impl Search<'_> {
    /// A polytope that proves contraction from some rational number up to `end`, exclusive; the
    /// number is as far towards `goal` as one polytope will go.
    pub fn up_to(
        &self,
        end: &RealAlgebraic,
        crossings: &[Crossing],
        goal: &Rational,
    ) -> Option<Polytope> {
        let end = &end.simplified();
        let x1 = approximate_root(end);
        let at_end = self.pencil.rounded_at(x1);
        let place = Place { end: certificate_end(end), x1, at_end: &at_end, goal };
        let seeds = self.sowing(&at_end).up_to(end, crossings);
        // A little effort for all of them first.
        tries(&seeds, &MARGINS, &MOST_VERTICES)
            .find_map(|(seed, effort)| self.reaching(&place, seed, effort, 1.0))
    }

    /// A polytope that proves contraction from `from`, inclusive, some way towards `goal`: at most the
    /// part `farthest` of it.
    pub fn step(&self, from: &Rational, goal: &Rational, farthest: f64) -> Closed {
        let x1 = approximate(from);
        let at_end = self.pencil.rounded_at(x1);
        let (word, growth) = fastest(&at_end, self.words);
        if growth >= 1.0 {
            return Closed::Faster(word.clone());
        }
        let end = End::Rational(Number(from.clone()));
        let place = Place { end, x1, at_end: &at_end, goal };
        let margins = MARGINS_INSIDE.map(|(part, least)| spare(growth, part).max(least));
        let sowing = self.sowing(&at_end);
        let attempt = |seed: &Seed, most: &[usize]| {
            tries(std::slice::from_ref(seed), &margins, most)
                .find_map(|(seed, effort)| self.reaching(&place, seed, effort, farthest))
        };
        let (few, most) = CLOSED_VERTICES.split_at(2);
        let alone = sowing.inside(word, growth, room(growth));
        let company = || sowing.inside_with_company(word, growth, room(growth));
        let found = (alone.iter().find_map(|seed| attempt(seed, few)))
            .or_else(|| company().iter().find_map(|seed| attempt(seed, few)))
            .or_else(|| alone.iter().find_map(|seed| attempt(seed, most)));
        found.map_or(Closed::Nothing, |found| Closed::Proved(Box::new(found)))
    }

    /// A polytope from a place as far towards its goal as it will go, at most the part `farthest`.
    fn reaching(
        &self,
        place: &Place,
        seed: &Seed,
        effort: Effort,
        farthest: f64,
    ) -> Option<Polytope> {
        // What the end alone needs tells what to spend on both ends.
        let alone = Ends { inner: &[], end: place.at_end };
        let (seed, body) = self.fattest(&alone, seed, effort)?;
        let vertices = (2 * body.vertices.len() + 50).max(240);
        let effort = Effort { vertices, ..effort };
        if self.kind == certificate::Pencil::Scale {
            // At scale zero all images are zero: one polytope does for all scales.
            return self.holding(place, 1.0, &seed, effort);
        }
        let reaches = std::iter::successors(Some(farthest), |reach| Some(0.5 * reach));
        reaches.take_while(|reach| *reach > LEAST_REACH).find_map(|reach| {
            // A complex vector turns with the parameter: its polytope has to move.
            let still = (!seed.shape.complex).then(|| self.holding(place, reach, &seed, effort));
            still.flatten().or_else(|| self.moving(place, reach, &body))
        })
    }

    fn holding(&self, place: &Place, reach: f64, seed: &Seed, effort: Effort) -> Option<Polytope> {
        let inner = place.inner(reach);
        let at_inner = self.pencil.rounded_at(approximate(&inner));
        let ends = Ends { inner: &at_inner, end: place.at_end };
        if self.too_far_apart(&ends) {
            return None;
        }
        let body = Body::grow(&ends, seed.shape, &seed.starts, effort)?;
        self.write(&body, None, &inner, place.end.clone(), &ends)
    }

    fn moving(&self, place: &Place, reach: f64, body: &Body) -> Option<Polytope> {
        let inner = place.inner(reach);
        let at_inner = self.pencil.rounded_at(approximate(&inner));
        let ends = Ends { inner: &at_inner, end: place.at_end };
        let (body, moved) = body.moving(&ends, reach)?;
        self.write(&body, Some(&moved), &inner, place.end.clone(), &ends)
    }

    /// A polytope that proves contraction on the closed interval `[a, b]`.
    pub fn closed(&self, a: &Rational, b: &Rational) -> Closed {
        let at_a = self.pencil.rounded_at(approximate(a));
        let at_b = self.pencil.rounded_at(approximate(b));
        let (word_a, growth_a) = fastest(&at_a, self.words);
        let (word_b, growth_b) = fastest(&at_b, self.words);
        // Grown where growth is fastest; the images at the other end are then mostly inside.
        let ((slow, at_slow), (fast, at_fast), word, growth) = if growth_a > growth_b {
            ((b, &at_b), (a, &at_a), word_a, growth_a)
        } else {
            ((a, &at_a), (b, &at_b), word_b, growth_b)
        };
        if growth >= 1.0 {
            return Closed::Faster(word.clone());
        }
        let ends = Ends { inner: at_slow, end: at_fast };
        if self.too_far_apart(&ends) {
            return Closed::Nothing;
        }
        let end = End::Rational(Number(fast.clone()));
        let room = room(growth);
        let sowing = self.sowing(at_fast);
        let mut seeds = sowing.inside(word, growth, room);
        seeds.extend(sowing.inside_with_company(word, growth, room));
        let found = tries(&seeds, &[room], &CLOSED_VERTICES).find_map(|(seed, effort)| {
            let (_, body) = self.fattest(&ends, seed, effort)?;
            self.write(&body, None, slow, end.clone(), &ends)
        });
        found.map_or(Closed::Nothing, |found| Closed::Proved(Box::new(found)))
    }

    fn sowing<'a>(&'a self, matrices: &'a [DMatrix<f64>]) -> Sowing<'a> {
        Sowing { mirrored: self.pencil.is_mirrored(), words: self.words, matrices }
    }

    /// Whether some product of matrices from both ends grows: then no polytope serves both.
    fn too_far_apart(&self, ends: &Ends) -> bool {
        let both: Vec<DMatrix<f64>> = ends.inner.iter().chain(ends.end).cloned().collect();
        let words = Word::necklaces(both.len(), PROBE, false);
        words.iter().any(|word| growth(&both, word) > 1.0 + 1e-7)
    }

    fn write(
        &self,
        body: &Body,
        moved: Option<&Body>,
        inner: &Rational,
        end: End,
        ends: &Ends,
    ) -> Option<Polytope> {
        let precisions =
            if matches!(body.shape.closing, Closing::Inside(_)) { &CLOSED[..] } else { &EXACT };
        let span = Span { pencil: self.kind, inner, end, ends: *ends };
        precisions
            .iter()
            .filter_map(|&precision| polytope(body, moved, &span, precision))
            .find(|found| (self.accept)(found))
    }

    /// A body that is as fat as this effort allows, and the seed from which it has grown: with short
    /// unit vectors.
    fn fattest(&self, ends: &Ends, seed: &Seed, effort: Effort) -> Option<(Seed, Body)> {
        FATNESS.iter().find_map(|&length| {
            let seed = seed.fattened(length);
            let body = Body::grow(ends, seed.shape, &seed.starts, effort)?;
            Some((seed, body))
        })
    }
}

/// By how much an orbit that grows by less than one is to be inside.
fn room(growth: f64) -> f64 {
    spare(growth, 0.1)
}

/// This part of what is left between the growth and one.
fn spare(growth: f64, part: f64) -> f64 {
    (part * (1.0 - growth)).clamp(1e-11, 1e-2)
}

/// All seeds with all margins, with a little effort first.
fn tries<'a>(
    seeds: &'a [Seed],
    margins: &'a [f64],
    vertices: &'a [usize],
) -> impl Iterator<Item = (&'a Seed, Effort)> {
    vertices.iter().flat_map(move |&vertices| {
        let efforts = move || margins.iter().map(move |&margin| Effort { margin, vertices });
        seeds.iter().flat_map(move |seed| efforts().map(move |effort| (seed, effort)))
    })
}

/// An end, and which way the interval goes.
struct Place<'a> {
    end: End,
    x1: f64,
    at_end: &'a [DMatrix<f64>],
    goal: &'a Rational,
}

impl Place<'_> {
    /// A short number about this part of the way to the goal.
    fn inner(&self, reach: f64) -> Rational {
        if reach == 1.0 {
            return self.goal.clone();
        }
        let distance = (approximate(self.goal) - self.x1) * reach;
        short_dyadic(self.x1 + distance, distance.abs() / 8.0)
    }
}

/// The number as a certificate has it, with an enclosure narrow enough for most purposes.
pub fn certificate_end(x: &RealAlgebraic) -> End {
    let x = x.simplified();
    if let Some(rational) = x.as_rational() {
        return End::Rational(Number(rational.clone()));
    }
    let (lower, upper) = x.enclosure(&dyadic(1e-9, 40));
    let coefficients = x.polynomial().coefficients().to_vec();
    End::Algebraic(Root {
        root_of: coefficients.into_iter().map(|c| Number(Rational::from(c))).collect(),
        between: [Number(lower), Number(upper)],
    })
}

/// The number that a certificate writes.
///
/// # Panics
/// If the certificate has not been checked and names no number.
pub fn real_algebraic(end: &End) -> RealAlgebraic {
    match end {
        End::Rational(x) => x.0.clone().into(),
        End::Algebraic(Root { root_of, between: [lower, upper] }) => {
            let coefficients: Vec<Rational> = root_of.iter().map(|c| c.0.clone()).collect();
            let polynomial = Polynomial::new(coefficients).cleared().1;
            let roots = real_roots_between(&polynomial, &lower.0, &upper.0);
            roots.into_iter().next().expect("a checked end has its root between its bounds")
        }
    }
}
