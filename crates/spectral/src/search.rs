//! Polytopes for parts of an interval on which no word is known to reach spectral radius one.

use nalgebra::DMatrix;
use refinable_algebra::{Integer, Polynomial, Rational};
use refinable_certificate::{self as certificate, End, Number, Polytope, Root};
use refinable_reals::{RealAlgebraic, real_roots_between};

use crate::body::{Body, Closing, Effort, Ends};
use crate::float::{approximate, approximate_root, dyadic, short_dyadic};
use crate::leading::{fastest, growth};
use crate::pencil::Pencil;
use crate::recipe::{Company, FATNESS, Recipe};
use crate::rounding::{Precision, Span, polytope};
use crate::seed::{Seed, Sowing};
use crate::word::Word;
use crate::work::Work;

/// The amounts, in floats, by which images must be inside.
const MARGINS: [f64; 2] = [1e-5, 1e-7];
/// The largest numbers of vertices of a polytope, mirror images not counted, tried in turn.
const MOST_VERTICES: [usize; 2] = [150, 750];
/// Below which part of the way a step is not worth while.
const LEAST_REACH: f64 = 1e-5;
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

impl Crossing {
    /// One for each sign and factor of the determinants of a word.
    pub fn all(word: &Word, determinants: Vec<(i32, Polynomial<Integer>)>) -> Vec<Crossing> {
        let crossing = |(sign, determinant)| Crossing { word: word.clone(), sign, determinant };
        determinants.into_iter().map(crossing).collect()
    }
}

/// What searches have in common.
pub(crate) struct Search<'a> {
    pub pencil: &'a Pencil,
    pub kind: certificate::Pencil,
    pub words: &'a [Word],
    /// The independent checker.
    pub accept: &'a (dyn Fn(&Polytope) -> bool + Sync),
    /// What growing polytopes may still take.
    pub work: &'a Work,
}

/// The outcome of a search where no word is known to grow.
pub(crate) enum Outcome {
    /// It is proved; and how the polytope was grown.
    Proved(Box<Polytope>, Recipe),
    /// A word grows there after all.
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
        tries(&seeds).find_map(|(seed, effort)| self.reaching(&place, &seed, effort, 1.0))
    }

    /// A polytope that proves contraction from `from`, inclusive, some way towards `goal`: at most the
    /// part `farthest` of it. The recipe that served last time is tried first.
    pub fn step(
        &self,
        from: &Rational,
        goal: &Rational,
        farthest: f64,
        last: Option<Recipe>,
    ) -> Outcome {
        let at_end = self.pencil.rounded_at(approximate(from));
        let place = Place::rational(from, &at_end, goal);
        self.inside(&at_end, last, |seed, effort| self.reaching(&place, seed, effort, farthest))
    }

    /// A polytope that proves contraction on the closed interval `[a, b]`, with `ρ(a) ≤ ρ(b)`.
    pub fn closed(&self, a: &Rational, b: &Rational) -> Outcome {
        let at_b = self.pencil.rounded_at(approximate(b));
        let place = Place::rational(b, &at_b, a);
        self.inside(&at_b, None, |seed, effort| self.holding(&place, 1.0, seed, effort))
    }

    /// The first recipe that does, with the word that grows fastest and less than one.
    fn inside(
        &self,
        matrices: &[DMatrix<f64>],
        last: Option<Recipe>,
        attempt: impl Fn(&Seed, Effort) -> Option<Polytope>,
    ) -> Outcome {
        let (word, growth) = fastest(matrices, self.words);
        if growth >= 1.0 {
            return Outcome::Faster(word.clone());
        }
        let seeds = self.sowing(matrices).inside(word, growth);
        // Where there is room for a polygon it comes first: it holds still.
        let last = last.filter(|_| seeds.seed(Company::Polygon).is_none());
        let found = last.into_iter().chain(Recipe::all()).find_map(|recipe| {
            let seed = seeds.seed(recipe.company)?.fattened(recipe.fatness);
            Some((attempt(&seed, recipe.effort(growth))?, recipe))
        });
        found.map_or(Outcome::Nothing, |(polytope, recipe)| {
            Outcome::Proved(Box::new(polytope), recipe)
        })
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
        let body = Body::grow(&alone, seed.shape, &seed.starts, effort, self.work)?;
        let vertices = (2 * body.vertices.len() + 50).max(240);
        let effort = Effort { vertices, ..effort };
        if self.kind == certificate::Pencil::Scale {
            // At scale zero all images are zero: one polytope does for all scales.
            return self.holding(place, 1.0, seed, effort);
        }
        let reaches = std::iter::successors(Some(farthest), |reach| Some(0.5 * reach));
        reaches.take_while(|reach| *reach > LEAST_REACH).find_map(|reach| {
            // A complex vector turns with the parameter: its polytope has to move.
            let still = (!seed.shape.complex).then(|| self.holding(place, reach, seed, effort));
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
        let body = Body::grow(&ends, seed.shape, &seed.starts, effort, self.work)?;
        self.write(&body, None, &inner, place.end.clone(), &ends)
    }

    fn moving(&self, place: &Place, reach: f64, body: &Body) -> Option<Polytope> {
        let inner = place.inner(reach);
        let at_inner = self.pencil.rounded_at(approximate(&inner));
        let ends = Ends { inner: &at_inner, end: place.at_end };
        let (body, moved) = body.moving(&ends, reach)?;
        self.write(&body, Some(&moved), &inner, place.end.clone(), &ends)
    }

    fn sowing<'a>(&'a self, matrices: &'a [DMatrix<f64>]) -> Sowing<'a> {
        Sowing { mirrored: self.pencil.is_mirrored(), words: self.words, matrices }
    }

    /// Whether some product of matrices from both ends grows: then no polytope serves both.
    fn too_far_apart(&self, ends: &Ends) -> bool {
        let both: Vec<DMatrix<f64>> = ends.inner.iter().chain(ends.end).cloned().collect();
        let words = Word::necklaces(both.len(), PROBE, false);
        words.iter().any(|word| growth(&both, word).is_some_and(|growth| growth > 1.0 + 1e-7))
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
}

/// All seeds in all ways up to an exact end, with a little effort first.
fn tries(seeds: &[Seed]) -> impl Iterator<Item = (Seed, Effort)> {
    MOST_VERTICES.into_iter().flat_map(move |vertices| {
        let efforts = MARGINS.map(|margin| Effort { margin, vertices });
        seeds.iter().flat_map(move |seed| {
            let fattened = move |effort| FATNESS.map(|fatness| (seed.fattened(fatness), effort));
            efforts.into_iter().flat_map(fattened)
        })
    })
}

/// An end, and which way the interval goes.
struct Place<'a> {
    end: End,
    x1: f64,
    at_end: &'a [DMatrix<f64>],
    goal: &'a Rational,
}

impl<'a> Place<'a> {
    /// An interval that ends at a rational number.
    fn rational(x1: &Rational, at_end: &'a [DMatrix<f64>], goal: &'a Rational) -> Self {
        let end = End::Rational(Number(x1.clone()));
        Place { end, x1: approximate(x1), at_end, goal }
    }

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
