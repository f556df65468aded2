//! Dividing polygons of the plane into pieces on which a set of matrices contracts or expands.
//!
//! The largest piece that is not decided is always next, until little is left. A piece through which
//! the boundary of contraction runs from edge to edge is cut along two lines on both sides of it: what
//! stays undecided between them is as thin as the boundary is straight.

use rayon::prelude::*;
use refinable_algebra::{Polynomial, Rational, Ring};
use refinable_certificate::{Inequality, Line, MapChecker, Node, Number, Polygon, Terms};

use crate::float::{approximate, dyadic};
use crate::front::{Front, Sampler};
use crate::geometry::{Place, area, diameter, extent};
use crate::moving::{Failure, moving_ellipsoids, moving_expansion};
use crate::plane::PlanePencil;
use crate::word::Word;

/// When to stop.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Effort {
    /// The part of the area of what contracts that may stay undecided.
    pub rest: Rational,
    /// The number of nodes beyond which nothing is cut.
    pub nodes: usize,
}

/// Divides polygons at the boundary of contraction; returns the first node of each polygon and all
/// nodes, each before those it is cut into. `factor` is `l` if areas are meant in the plane of `x` and
/// `y/l(x)`.
///
/// # Cost
/// A convex program of some dozen unknowns for each piece, whose length near the boundary is about the square
/// root of its distance.
pub fn partition(
    pencil: &PlanePencil,
    checker: &MapChecker,
    polygons: &[Polygon],
    factor: Option<&Polynomial<Rational>>,
    effort: &Effort,
) -> (Vec<usize>, Vec<Node>) {
    let scale = scale(polygons);
    let factor = factor.map(|l| [0, 1].map(|k| approximate(&l.coefficient(k))));
    let corners: Vec<Vec<Place>> = polygons.iter().map(|p| scaled(p, scale)).collect();
    let work = Work {
        pencil,
        checker,
        scale,
        factor,
        sampler: Sampler::new(pencil, scale, &corners),
        inequalities: inequalities(pencil, checker),
    };
    let mut arena = Arena { nodes: Vec::new(), open: Vec::new(), proved: 0.0 };
    let whole = polygons.iter().map(|polygon| work.open(polygon.clone()));
    let whole: Vec<Open> = whole.collect();
    let total: f64 = whole.iter().map(|open| open.area).sum();
    let roots = whole.into_iter().map(|open| arena.push(Piece::Open(open))).collect();
    let rest = approximate(&effort.rest);
    while arena.undecided() > rest * arena.proved.max(SMALLEST * total)
        && arena.nodes.len() < effort.nodes
    {
        let batch = arena.largest();
        if batch.is_empty() {
            break;
        }
        let steps: Vec<Piece> = batch.par_iter().map(|(_, open)| work.step(open)).collect();
        for ((at, _), piece) in batch.into_iter().zip(steps) {
            arena.replace(at, piece);
        }
    }
    (roots, arena.nodes)
}

/// Pieces that are treated at once; the order of the work does not depend on the number of threads.
const BATCH: usize = 32;
/// The part of the whole area that is looked at in any case.
const SMALLEST: f64 = 1e-4;
/// How long words are whose inequalities may refute.
const SHORT_WORD: usize = 4;
/// The moduli of eigenvalues that are looked for.
const RADII: [u64; 4] = [1, 2, 4, 16];
/// How much less parts of a piece count at the middle of which nothing proves contraction.
const LITTLE_HOPE: f64 = 0.25;
/// How far the boundary may stray from a line, against its length, for cuts along it.
const BULGE: f64 = 0.1;
/// How far from the boundary cuts are made, against its length and against the depth of the piece.
const MARGINS: [f64; 2] = [0.01, 0.125];

/// Inequalities that may refute, those first that reach up to the boundary.
fn inequalities(pencil: &PlanePencil, checker: &MapChecker) -> Vec<(Inequality, Floats)> {
    let words = Word::necklaces(pencil.letters(), SHORT_WORD, pencil.is_mirrored());
    let of = |word: &Word| checker.inequalities(&word.to_string(), &RADII);
    let mut all: Vec<(Inequality, Terms)> = words.par_iter().flat_map(of).collect();
    all.sort_by_key(|(inequality, _)| inequality.radius);
    let float = |(c, i, j): &(Number, u32, u32)| (approximate(&c.0), *i as i32, *j as i32);
    all.into_iter()
        .map(|(inequality, terms)| (inequality, terms.iter().map(float).collect()))
        .collect()
}

/// The terms `c x^i y^j` of a polynomial.
type Floats = Vec<(f64, i32, i32)>;

/// A piece that is not decided.
#[derive(Clone)]
struct Open {
    polygon: Polygon,
    /// Scaled.
    corners: Vec<Place>,
    area: f64,
    /// What part of its area counts when the next piece is chosen.
    hope: f64,
}

/// What becomes of a piece.
enum Piece {
    Done(Node, f64),
    Open(Open),
    Cut([Number; 3], Box<[Piece; 2]>),
}

/// All pieces so far.
struct Arena {
    nodes: Vec<Node>,
    open: Vec<(usize, Open)>,
    /// The area where contraction is proved.
    proved: f64,
}

impl Arena {
    fn push(&mut self, piece: Piece) -> usize {
        let at = self.nodes.len();
        self.nodes.push(Node::Undecided);
        self.replace(at, piece);
        at
    }

    fn replace(&mut self, at: usize, piece: Piece) {
        match piece {
            Piece::Open(open) => self.open.push((at, open)),
            Piece::Done(node, area) => {
                let proves = matches!(node, Node::Norm | Node::Ellipsoids(_));
                self.proved += if proves { area } else { 0.0 };
                self.nodes[at] = node;
            }
            Piece::Cut(line, parts) => {
                let [below, above] = (*parts).map(|part| self.push(part));
                self.nodes[at] = Node::Cut { line, below, above };
            }
        }
    }

    fn undecided(&self) -> f64 {
        self.open.iter().map(|(_, open)| open.area).sum()
    }

    /// Takes the largest open pieces.
    fn largest(&mut self) -> Vec<(usize, Open)> {
        let urgency = |open: &Open| open.area * open.hope;
        self.open.sort_by(|(i, a), (j, b)| urgency(b).total_cmp(&urgency(a)).then(i.cmp(j)));
        self.open.drain(..BATCH.min(self.open.len())).collect()
    }
}

/// What all steps need.
struct Work<'a> {
    pencil: &'a PlanePencil,
    checker: &'a MapChecker,
    scale: Place,
    /// The coefficients of `l`.
    factor: Option<[f64; 2]>,
    sampler: Sampler<'a>,
    inequalities: Vec<(Inequality, Floats)>,
}

impl Work<'_> {
    fn open(&self, polygon: Polygon) -> Open {
        let corners = scaled(&polygon, self.scale);
        let middle = corners.iter().map(|p| p[0]).sum::<f64>() / corners.len() as f64;
        let density = self.factor.map_or(1.0, |[c, d]| (c + d * middle * self.scale[0]).abs());
        let area = area(&corners) / density.max(f64::MIN_POSITIVE);
        Open { polygon, corners, area, hope: 1.0 }
    }

    /// Decides a piece, or cuts it.
    fn step(&self, open: &Open) -> Piece {
        let decided = match self.sampler.crossings(&open.corners) {
            Ok(true) => self.prove(open),
            Ok(false) => self.refute(open).ok_or(1.0),
            Err(ends) => {
                let front = ends.and_then(|ends| self.sampler.front(&open.corners, ends));
                return match front {
                    Some(front) => self.along(open, &front),
                    None => self.halve(open, open.hope),
                };
            }
        };
        match decided {
            Ok(node) => Piece::Done(node, open.area),
            Err(hope) => self.halve(open, hope * open.hope),
        }
    }

    /// Cuts along both sides of the boundary, or across it where it is not straight enough.
    fn along(&self, open: &Open, front: &Front) -> Piece {
        let Front { normal, low, high, length, middle } = *front;
        if high - low > BULGE * length {
            let across = [-normal[1], normal[0]];
            return self.cut(open, across, middle, open.hope);
        }
        let (bottom, top) = extent(&open.corners, normal);
        let margin = (MARGINS[0] * length).min(MARGINS[1] * (top - bottom)) + 0.1 * (high - low);
        let inner = self.parts(&open.polygon, normal, low - margin);
        let Some((line, [Some(inside), Some(beyond)])) = inner else {
            return self.halve(open, open.hope);
        };
        let part = |polygon: Polygon| Open { hope: open.hope, ..self.open(polygon) };
        let beyond = match self.parts(&beyond, normal, high + margin) {
            Some((line, [Some(strip), Some(outside)])) => {
                let outside = decided_or_open(part(outside), |open| self.refute(open));
                Piece::Cut(line, Box::new([Piece::Open(part(strip)), outside]))
            }
            _ => Piece::Open(part(beyond)),
        };
        let inside = decided_or_open(part(inside), |open| self.prove(open).ok());
        Piece::Cut(line, Box::new([inside, beyond]))
    }

    /// The corners as they are.
    fn places(&self, open: &Open) -> Vec<Place> {
        open.corners.iter().map(|p| [0, 1].map(|i| p[i] * self.scale[i])).collect()
    }

    /// What proves contraction, or the hope that is left for the parts.
    fn prove(&self, open: &Open) -> Result<Node, f64> {
        if self.checker.has_small_norm(&open.polygon) {
            return Ok(Node::Norm);
        }
        let accept = |ellipsoids: &_| self.checker.accepts(&open.polygon, ellipsoids);
        let found = moving_ellipsoids(self.pencil, &self.places(open), &self.sampler.words, accept);
        found.map(Node::Ellipsoids).map_err(|failure| match failure {
            Failure::TooLarge => 1.0,
            Failure::Nowhere => LITTLE_HOPE,
        })
    }

    fn refute(&self, open: &Open) -> Option<Node> {
        let places = self.places(open);
        let holds =
            |(_, terms): &&(Inequality, Floats)| places.iter().all(|p| value(terms, *p) <= 0.0);
        let mut likely = self.inequalities.iter().filter(holds);
        let found = likely.find(|(inequality, _)| self.checker.refutes(&open.polygon, inequality));
        if let Some((inequality, _)) = found {
            return Some(Node::Word(inequality.clone()));
        }
        let accept = |expansion: &_| self.checker.accepts_expansion(&open.polygon, expansion);
        moving_expansion(self.pencil, &places, accept).map(Node::Expansion)
    }

    /// Cuts across the longest diagonal.
    fn halve(&self, open: &Open, hope: f64) -> Piece {
        let [p, q] = diameter(&open.corners);
        let length = (q[0] - p[0]).hypot(q[1] - p[1]);
        // A rough direction, so that numbers stay short.
        let across = [0, 1].map(|i| ((q[i] - p[i]) / length * 8.0).round() / 8.0);
        let (low, high) = extent(&open.corners, across);
        self.cut(open, across, 0.5 * (low + high), hope)
    }

    fn cut(&self, open: &Open, normal: Place, at: f64, hope: f64) -> Piece {
        match self.parts(&open.polygon, normal, at) {
            Some((line, [Some(below), Some(above)])) => {
                let parts = [below, above];
                let parts = parts.map(|part| Piece::Open(Open { hope, ..self.open(part) }));
                Piece::Cut(line, Box::new(parts))
            }
            // Too small for the numbers in use.
            _ => Piece::Done(Node::Undecided, open.area),
        }
    }

    /// The parts of a polygon on both sides of a scaled line, and the line.
    fn parts(
        &self,
        polygon: &Polygon,
        normal: Place,
        at: f64,
    ) -> Option<([Number; 3], [Option<Polygon>; 2])> {
        // Powers of two, however small.
        let scale = self.scale.map(|s| {
            let power = Rational::from_i64(2).power(s.log2().abs() as u32);
            if s < 1.0 { power.recip() } else { power }
        });
        let [a, b] = [0, 1].map(|i| dyadic(normal[i], 12) / &scale[i]);
        let c = dyadic(at, 26);
        let line = Line::new(&a, &b, &c)?;
        Some(([a, b, c].map(Number), polygon.cut(&line)))
    }
}

fn scaled(polygon: &Polygon, scale: Place) -> Vec<Place> {
    let points = polygon.points();
    points.iter().map(|p| [0, 1].map(|i| approximate(&p[i]) / scale[i])).collect()
}

/// Powers of two near the extents of the polygons.
fn scale(polygons: &[Polygon]) -> Place {
    let points: Vec<[Rational; 2]> = polygons.iter().flat_map(Polygon::points).collect();
    let places: Vec<Place> = points.iter().map(|p| [0, 1].map(|i| approximate(&p[i]))).collect();
    [[1.0, 0.0], [0.0, 1.0]].map(|axis| {
        let (low, high) = extent(&places, axis);
        2f64.powi((high - low).log2().round() as i32)
    })
}

fn value(terms: &Floats, [x, y]: Place) -> f64 {
    terms.iter().map(|(c, i, j)| c * x.powi(*i) * y.powi(*j)).sum()
}

/// A piece that is decided at once if that is easy.
fn decided_or_open(open: Open, decide: impl Fn(&Open) -> Option<Node>) -> Piece {
    match decide(&open) {
        Some(node) => Piece::Done(node, open.area),
        None => Piece::Open(open),
    }
}
