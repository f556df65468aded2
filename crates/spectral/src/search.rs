//! Polytopes for parts of an interval on which no word is known to reach spectral radius one.

use nalgebra::DMatrix;
use refinable_algebra::{Integer, Polynomial, Rational};
use refinable_certificate::{self as certificate, End, Number, Polytope, Root};
use refinable_reals::{RealAlgebraic, real_roots_between};

use crate::body::{Body, Effort, Ends, Start};
use crate::float::{approximate, approximate_root, dyadic, short_dyadic};
use crate::leading::{fastest, fixed_vector, growth, large_eigenvectors, product};
use crate::pencil::Pencil;
use crate::rounding::{Precision, Span, polytope};
use crate::word::Word;

/// The amounts, in floats, by which images must be inside.
const MARGINS: [f64; 2] = [1e-5, 1e-7];
/// The largest number of vertices of a polytope, mirror images not counted.
const MOST_VERTICES: usize = 1500;
/// The same for a polytope on a closed interval, of which there may be many.
const CLOSED_VERTICES: usize = 600;
/// How far from an end towards the goal one polytope may reach: first this,
const FIRST_REACH: f64 = 0.25;
/// then if possible farther,
const FARTHER: [f64; 2] = [1.0, 0.6];
/// or else less far.
const NEARER: [f64; 3] = [0.06, 0.01, 1e-3];
/// Factors between the lengths of two leading eigenvectors.
const BALANCE: [f64; 9] = [1.0, 0.5, 2.0, 0.25, 4.0, 0.125, 8.0, 1.0 / 32.0, 32.0];
/// Eigenvectors for eigenvalues above this, against the largest, are among the first vertices.
const COMPANION: f64 = 0.9;
/// How many leading words are told apart.
const MOST_ORBITS: usize = 4;
/// Directions in which a polytope is thinner than this against its width get additional vertices.
const THIN: f64 = 1e-4;
/// The lengths of these.
const ADDITIONS: [f64; 3] = [0.01, 1e-3, 1e-4];
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
        let x1 = approximate_root(end);
        let at_end = self.pencil.rounded_at(x1);
        let orbits = leading_orbits(&at_end, end, crossings)?;
        let distance = approximate(goal) - x1;
        for starts in selections(&orbits) {
            for margin in MARGINS {
                // What the end alone needs tells what to spend on both ends.
                let alone = Ends { inner: &[], end: &at_end };
                let effort = Effort { margin, vertices: MOST_VERTICES };
                let Some(body) = self.full_body(&alone, starts.clone(), effort) else { break };
                let effort = Effort {
                    margin,
                    vertices: (12 * body.vertices.len() + 200).min(MOST_VERTICES),
                };
                let reached = |reach: f64| {
                    let inner = match reach {
                        1.0 => goal.clone(),
                        _ => short_dyadic(x1 + distance * reach, (distance * reach).abs() / 8.0),
                    };
                    let at_inner = self.pencil.rounded_at(approximate(&inner));
                    let ends = Ends { inner: &at_inner, end: &at_end };
                    if self.too_far_apart(&ends) {
                        return None;
                    }
                    let body = self.full_body(&ends, starts.clone(), effort)?;
                    self.write(&body, &inner, certificate_end(end), &ends, &EXACT)
                };
                if self.kind == certificate::Pencil::Scale {
                    // At scale zero all images are zero: one polytope does for all scales.
                    match reached(1.0) {
                        Some(found) => return Some(found),
                        None => continue,
                    }
                }
                if let Some(first) = reached(FIRST_REACH) {
                    return FARTHER.iter().find_map(|&reach| reached(reach)).or(Some(first));
                }
                if let Some(found) = NEARER.iter().find_map(|&reach| reached(reach)) {
                    return Some(found);
                }
            }
        }
        None
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
        let matrix = product(at_fast, word);
        let bound = COMPANION * growth.powi(word.letters().len() as i32);
        let starts = large_eigenvectors(&matrix, bound).into_iter().map(Start::Free);
        let margin = (0.1 * (1.0 - growth)).clamp(1e-11, 1e-2);
        let effort = Effort { margin, vertices: CLOSED_VERTICES };
        let Some(body) = self.full_body(&ends, starts.collect(), effort) else {
            return Closed::Nothing;
        };
        let end = End::Rational(Number(fast.clone()));
        let found = self.write(&body, slow, end, &ends, &CLOSED);
        found.map_or(Closed::Nothing, |found| Closed::Proved(Box::new(found)))
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
        inner: &Rational,
        end: End,
        ends: &Ends,
        precisions: &[Precision],
    ) -> Option<Polytope> {
        let span = Span { pencil: self.kind, inner, end, ends: *ends };
        precisions
            .iter()
            .filter_map(|&precision| polytope(body, &span, precision))
            .find(|found| (self.accept)(found))
    }

    /// A body that is not thin in any direction.
    fn full_body(&self, ends: &Ends, starts: Vec<Start>, effort: Effort) -> Option<Body> {
        let mirrored = self.pencil.is_mirrored();
        let body = Body::grow(ends, mirrored, &starts, effort)?;
        let thin = body.thin_directions(THIN);
        if thin.is_empty() {
            return Some(body);
        }
        ADDITIONS.iter().find_map(|&length| {
            let additions = thin.iter().map(|v| Start::Free(v * length));
            let starts: Vec<Start> = starts.iter().cloned().chain(additions).collect();
            Body::grow(ends, mirrored, &starts, effort)
        })
    }
}

/// The eigenvectors of the words that reach one at the end; `None` if there are none or they are
/// not unique.
fn leading_orbits(
    matrices: &[DMatrix<f64>],
    end: &RealAlgebraic,
    crossings: &[Crossing],
) -> Option<Vec<Start>> {
    let leading = crossings.iter().filter(|c| end.sign_of(&c.determinant).is_eq());
    let orbits: Option<Vec<Start>> = leading
        .map(|c| {
            let v = fixed_vector(&product(matrices, &c.word), c.sign)?;
            Some(Start::Orbit(c.word.clone(), c.sign, v))
        })
        .collect();
    let mut orbits = orbits.filter(|orbits| !orbits.is_empty())?;
    // Where very many words reach one together there is no telling them apart.
    orbits.truncate(MOST_ORBITS);
    Some(orbits)
}

/// Which orbits to begin with: one alone, if the others turn out to be inside; two, with different
/// lengths against each other; all of them.
fn selections(orbits: &[Start]) -> Vec<Vec<Start>> {
    let mut selections: Vec<Vec<Start>> = orbits.iter().map(|o| vec![o.clone()]).collect();
    for (i, first) in orbits.iter().enumerate() {
        for second in &orbits[i + 1..] {
            selections.extend(BALANCE.iter().map(|&f| vec![first.clone(), second.stretched(f)]));
        }
    }
    if orbits.len() > 2 {
        selections.push(orbits.to_vec());
    }
    selections
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
