//! Dividing polygons of the plane into pieces on which a set of matrices contracts or expands.
//!
//! A piece through which the boundary of contraction runs from edge to edge is cut along two lines
//! on both sides of it: what is left undecided between them is as thin as the boundary is straight.

use rayon::prelude::*;
use refinable_algebra::Rational;
use refinable_certificate::{Inequality, Line, MapChecker, Node, Number, Polygon, Terms};

use crate::common::common_polytope;
use crate::float::{approximate, dyadic};
use crate::leading::{eigenvalues, fastest, is_complex, product};
use crate::plane::{Place, PlanePencil};
use crate::word::Word;

/// How pieces are divided.
pub struct Partition<'a> {
    pencil: &'a PlanePencil,
    checker: &'a MapChecker,
    words: Vec<Word>,
    inequalities: Vec<(Inequality, Terms)>,
    scale: Place,
    /// How wide the undecided strip along the boundary may be.
    width: f64,
    /// The area of a piece that is too small to be cut.
    smallest: f64,
}

/// What a polygon is divided into.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Tree {
    /// It is not cut.
    Leaf(Node),
    /// The parts where `a x + b y ≤ c` and where it is `≥ c`.
    Cut([Number; 3], Box<(Tree, Tree)>),
}

/// The part of what contracts that may be left undecided along the boundary, about.
const TOLERANCE: f64 = 0.007;
/// How long words are.
const LONGEST_WORD: usize = 4;
/// The moduli of eigenvalues that are looked for.
const RADII: [u64; 4] = [1, 2, 4, 16];
/// Samples along the edges of a piece, about.
const SAMPLES: f64 = 24.0;
/// Steps along a chord at which the boundary is sought.
const STEPS: usize = 5;
/// Which part of the width of a strip may be due to the curvature of the boundary.
const BULGE: f64 = 0.6;
/// Which part of it is left on either side of the boundary.
const MARGIN: f64 = 0.2;
/// Samples across a polygon for a first look.
const GRID: usize = 40;
/// How much wider a strip may be where a complex pair of eigenvalues leads: polytopes reach less far
/// there.
const TURNING: f64 = 8.0;
/// How short pieces beside the boundary may be, against the width of the strip.
const SHORTEST: f64 = 4.0;
const DEEPEST: usize = 40;

impl<'a> Partition<'a> {
    /// Divides polygons so that about the part [`TOLERANCE`] of what contracts is left undecided.
    pub fn new(pencil: &'a PlanePencil, checker: &'a MapChecker, polygons: &[Polygon]) -> Self {
        let words = Word::necklaces(pencil.letters(), LONGEST_WORD, pencil.is_mirrored());
        let inequalities = RADII
            .iter()
            .flat_map(|&r| words.iter().map(move |word| (word.to_string(), r)))
            .flat_map(|(word, r)| checker.inequalities(&word, r))
            .collect();
        let mut partition = Partition {
            pencil,
            checker,
            words,
            inequalities,
            scale: scale(polygons),
            width: 0.0,
            smallest: 0.0,
        };
        let (area, length, whole) = partition.look(polygons);
        partition.width = if length > 0.0 { TOLERANCE * area / length } else { 1.0 };
        partition.smallest = (TOLERANCE * TOLERANCE * area).min(whole) * 1e-3;
        partition
    }

    /// The pieces of a polygon.
    pub fn divide(&self, polygon: &Polygon) -> Tree {
        self.refine(polygon, 0)
    }

    /// The area where words shrink, the length of its boundary, in which parts count as much as strips
    /// may be wider there, and the whole area, roughly and scaled.
    fn look(&self, polygons: &[Polygon]) -> (f64, f64, f64) {
        let (mut area, mut length, mut whole) = (0.0, 0.0, 0.0);
        for polygon in polygons {
            let corners = self.scaled(polygon);
            let (low, high) = extent(&corners);
            let step = [0, 1].map(|i| (high[i] - low[i]) / GRID as f64);
            let place = |k: usize| {
                let index = [k % GRID, k / GRID];
                [0, 1].map(|i| low[i] + (index[i] as f64 + 0.5) * step[i])
            };
            let shrinks = |k: usize| is_in(&corners, place(k)) && self.shrinks(place(k));
            let inside: Vec<bool> = (0..GRID * GRID).into_par_iter().map(shrinks).collect();
            area += step[0] * step[1] * inside.iter().filter(|&&x| x).count() as f64;
            whole += area_of(&corners);
            let edges = (0..GRID * GRID).into_par_iter().map(|k| {
                let right = (k % GRID + 1 < GRID && inside[k] != inside[k + 1], step[1]);
                let up = (k / GRID + 1 < GRID && inside[k] != inside[k + GRID], step[0]);
                let edges = [right, up].into_iter().filter(|(crossed, _)| *crossed);
                let length: f64 = edges.map(|(_, length)| length).sum();
                if length > 0.0 { length * self.spread(place(k)) } else { 0.0 }
            });
            // In the order of the samples, so that the sum is always the same.
            length += edges.collect::<Vec<f64>>().iter().sum::<f64>();
        }
        (area, length * std::f64::consts::FRAC_PI_4, whole)
    }

    fn scaled(&self, polygon: &Polygon) -> Vec<Place> {
        let points = polygon.points();
        points.iter().map(|p| [0, 1].map(|i| approximate(&p[i]) / self.scale[i])).collect()
    }

    /// Whether all words shrink at a scaled place.
    fn shrinks(&self, place: Place) -> bool {
        let matrices = self.pencil.at([0, 1].map(|i| place[i] * self.scale[i]));
        fastest(&matrices, &self.words).1 < 1.0
    }

    fn refine(&self, polygon: &Polygon, depth: usize) -> Tree {
        let corners = self.scaled(polygon);
        if area_of(&corners) < self.smallest || depth > DEEPEST {
            return Tree::Leaf(Node::Undecided);
        }
        let ring = self.ring(&corners);
        let changes: Vec<usize> =
            (0..ring.len()).filter(|&i| ring[i].1 != ring[(i + 1) % ring.len()].1).collect();
        match changes[..] {
            [] => {
                let found =
                    if ring[0].1 { self.prove(polygon) } else { self.refute(polygon, &corners) };
                found.map_or_else(|| self.halve(polygon, &corners, depth), Tree::Leaf)
            }
            [i, j] => {
                let ends = [i, j].map(|i| self.crossing(ring[i].0, ring[(i + 1) % ring.len()].0));
                self.follow(polygon, &corners, ends, depth)
            }
            _ => self.halve(polygon, &corners, depth),
        }
    }

    /// Samples along the edges, and whether words shrink there.
    fn ring(&self, corners: &[Place]) -> Vec<(Place, bool)> {
        let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
        let around: f64 = edges().map(|(a, b)| distance(*a, *b)).sum();
        let samples = edges().flat_map(|(a, b)| {
            let count = (SAMPLES * distance(*a, *b) / around).ceil().max(1.0);
            (0..count as usize).map(move |k| between(*a, *b, k as f64 / count))
        });
        samples.map(|place| (place, self.shrinks(place))).collect()
    }

    /// A place on the boundary between two of which one is inside.
    fn crossing(&self, mut a: Place, mut b: Place) -> Place {
        let inside = self.shrinks(a);
        while distance(a, b) > 0.02 * self.width {
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

    /// Cuts along the boundary that runs between two places on the edges.
    fn follow(&self, polygon: &Polygon, corners: &[Place], ends: [Place; 2], depth: usize) -> Tree {
        let Some(front) = self.front(corners, ends) else {
            return self.halve(polygon, corners, depth);
        };
        let Front { normal, low, high, width, .. } = front;
        if high - low > BULGE * width {
            let along = tangent(normal);
            let middle = dot(along, between(ends[0], ends[1], 0.5));
            let parts = self.cut(polygon, along, middle, |part| self.refine(part, depth + 1));
            return parts.unwrap_or_else(|| self.halve(polygon, corners, depth));
        }
        let margin = MARGIN * width;
        let strip_and_outside = |rest: &Polygon| {
            let strip = |part: &Polygon, outside: bool| match outside {
                false => Tree::Leaf(Node::Undecided),
                true => self.refute_or_halve(part, depth + 1),
            };
            self.cut_in_two(rest, normal, high + margin, strip)
        };
        self.cut_in_two(polygon, normal, low - margin, |part, beyond| match beyond {
            false => self.prove_beside(part, &front, depth + 1),
            true => strip_and_outside(part),
        })
    }

    /// How the boundary runs between two places on the edges.
    fn front(&self, corners: &[Place], [p, q]: [Place; 2]) -> Option<Front> {
        let length = distance(p, q);
        let middle = between(p, q, 0.5);
        let across = [(q[1] - p[1]) / length, (p[0] - q[0]) / length];
        let out = self.outwards(corners, middle, across, 0.25 * length)?;
        // Rounded so that numbers stay short.
        let normal = across.map(|x| (x * out * 4096.0).round() / 4096.0);
        let offsets = (0..=STEPS + 1).map(|k| {
            let place = between(p, q, k as f64 / (STEPS + 1) as f64);
            let on_edge = k == 0 || k == STEPS + 1;
            let boundary =
                if on_edge { Some(place) } else { self.beside(corners, place, normal, length) };
            boundary.map(|place| dot(normal, place))
        });
        let offsets = offsets.collect::<Option<Vec<f64>>>()?;
        let low = offsets.iter().copied().fold(f64::INFINITY, f64::min);
        let high = offsets.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let width = self.spread(middle) * self.width;
        Some(Front { normal, low, high, width })
    }

    /// How much wider a strip may be at a place.
    fn spread(&self, place: Place) -> f64 {
        let matrices = self.pencil.at([0, 1].map(|i| place[i] * self.scale[i]));
        let (word, _) = fastest(&matrices, &self.words);
        let leading = eigenvalues(&product(&matrices, word)).first().copied();
        if leading.is_some_and(|z| is_complex(&z)) { TURNING } else { 1.0 }
    }

    /// Proves a piece inside of the boundary that it comes near to, or cuts it: along the boundary where
    /// it is deep, across where it is not.
    fn prove_beside(&self, polygon: &Polygon, front: &Front, depth: usize) -> Tree {
        if depth > DEEPEST {
            return Tree::Leaf(Node::Undecided);
        }
        if let Some(node) = self.prove(polygon) {
            return Tree::Leaf(node);
        }
        let corners = self.scaled(polygon);
        let normal = front.normal;
        let along = tangent(normal);
        let extent = |direction: Place| {
            let at = || corners.iter().map(|corner| dot(direction, *corner));
            (at().fold(f64::INFINITY, f64::min), at().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((bottom, top), (left, right)) = (extent(normal), extent(along));
        let near = |part: &Polygon| self.prove_beside(part, front, depth + 1);
        if right - left < SHORTEST * front.width {
            // The strip is made wider.
            return self.cut_in_two(
                polygon,
                normal,
                top - front.width,
                |part, beyond| match beyond {
                    false => self.refine(part, depth + 1),
                    true => Tree::Leaf(Node::Undecided),
                },
            );
        }
        if top - bottom > right - left {
            return self.cut_in_two(polygon, normal, 0.5 * (top + bottom), |part, beyond| {
                match beyond {
                    false => self.refine(part, depth + 1),
                    true => near(part),
                }
            });
        }
        self.cut(polygon, along, 0.5 * (left + right), near).unwrap_or(Tree::Leaf(Node::Undecided))
    }

    fn refute_or_halve(&self, polygon: &Polygon, depth: usize) -> Tree {
        let corners = self.scaled(polygon);
        let found = self.refute(polygon, &corners);
        found.map_or_else(|| self.halve(polygon, &corners, depth), Tree::Leaf)
    }

    /// 1 if words grow on the side to which the direction points, -1 if on the other.
    fn outwards(
        &self,
        corners: &[Place],
        place: Place,
        direction: Place,
        reach: f64,
    ) -> Option<f64> {
        let mut step = reach;
        while step > 1e-3 * self.width {
            let [ahead, behind] = [step, -step].map(|s| moved(place, direction, s));
            if is_in(corners, ahead) && is_in(corners, behind) {
                match (self.shrinks(ahead), self.shrinks(behind)) {
                    (false, true) => return Some(1.0),
                    (true, false) => return Some(-1.0),
                    _ => {}
                }
            }
            step *= 0.5;
        }
        None
    }

    /// The place on the boundary ahead of or behind another one.
    fn beside(&self, corners: &[Place], place: Place, normal: Place, length: f64) -> Option<Place> {
        let inside = self.shrinks(place);
        let sign = if inside { 1.0 } else { -1.0 };
        let mut step = 0.25 * self.width;
        while step < 2.0 * length {
            let there = moved(place, normal, sign * step);
            if !is_in(corners, there) {
                return None;
            }
            if self.shrinks(there) != inside {
                return Some(self.crossing(place, there));
            }
            step *= 2.0;
        }
        None
    }

    fn prove(&self, polygon: &Polygon) -> Option<Node> {
        if self.checker.has_small_norm(polygon) {
            return Some(Node::Norm);
        }
        let points = polygon.points();
        let corners: Vec<Place> =
            points.iter().map(|p| [0, 1].map(|i| approximate(&p[i]))).collect();
        let sets = self.pencil.controls(&corners);
        let accept = |polytope: &_| self.checker.accepts(polygon, polytope);
        let mirrored = self.pencil.is_mirrored();
        let found = common_polytope(&sets, mirrored, &self.words, &accept);
        found.map(|polytope| Node::Polytope(Box::new(polytope)))
    }

    fn refute(&self, polygon: &Polygon, corners: &[Place]) -> Option<Node> {
        let places: Vec<Place> =
            corners.iter().map(|p| [0, 1].map(|i| p[i] * self.scale[i])).collect();
        let holds =
            |(_, terms): &&(Inequality, Terms)| places.iter().all(|p| value(terms, *p) <= 0.0);
        let mut likely = self.inequalities.iter().filter(holds);
        let found = likely.find(|(inequality, _)| self.checker.refutes(polygon, inequality));
        found.map(|(inequality, _)| Node::Word(inequality.clone()))
    }

    /// Cuts across the longer side of the box around it.
    fn halve(&self, polygon: &Polygon, corners: &[Place], depth: usize) -> Tree {
        let (low, high) = extent(corners);
        let across = if high[0] - low[0] >= high[1] - low[1] { [1.0, 0.0] } else { [0.0, 1.0] };
        let at = 0.5 * (dot(across, low) + dot(across, high));
        let halves = self.cut(polygon, across, at, |part| self.refine(part, depth + 1));
        halves.unwrap_or(Tree::Leaf(Node::Undecided))
    }

    /// Cuts a polygon and treats both parts in the same way; `None` if there is one part only.
    fn cut(
        &self,
        polygon: &Polygon,
        normal: Place,
        at: f64,
        treat: impl Fn(&Polygon) -> Tree + Sync,
    ) -> Option<Tree> {
        let (line, [Some(below), Some(above)]) = self.parts(polygon, normal, at)? else {
            return None;
        };
        let parts = rayon::join(|| treat(&below), || treat(&above));
        Some(Tree::Cut(line, Box::new(parts)))
    }

    /// Cuts a polygon, if the line meets it; the treatment is told whether a part is beyond the line.
    fn cut_in_two(
        &self,
        polygon: &Polygon,
        normal: Place,
        at: f64,
        treat: impl Fn(&Polygon, bool) -> Tree + Sync,
    ) -> Tree {
        let Some((line, parts)) = self.parts(polygon, normal, at) else {
            return Tree::Leaf(Node::Undecided);
        };
        match parts {
            [Some(below), Some(above)] => {
                let parts = rayon::join(|| treat(&below, false), || treat(&above, true));
                Tree::Cut(line, Box::new(parts))
            }
            [Some(below), None] => treat(&below, false),
            [None, Some(above)] => treat(&above, true),
            [None, None] => Tree::Leaf(Node::Undecided),
        }
    }

    /// The parts of a polygon on both sides of a scaled line, and the line.
    fn parts(
        &self,
        polygon: &Polygon,
        normal: Place,
        at: f64,
    ) -> Option<([Number; 3], [Option<Polygon>; 2])> {
        let scale = self.scale.map(|s| dyadic(s, 60));
        let [a, b] = [0, 1].map(|i| dyadic(normal[i], 12) / &scale[i]);
        let c = dyadic(at, 26);
        let line = Line::new(&a, &b, &c)?;
        Some(([a, b, c].map(Number), polygon.cut(&line)))
    }
}

/// A nearly straight piece of the boundary: where it is across the direction from the inside to the
/// outside, and how wide a strip around it may be.
struct Front {
    normal: Place,
    low: f64,
    high: f64,
    width: f64,
}

fn tangent([x, y]: Place) -> Place {
    [-y, x]
}

/// Powers of two near the extents of the polygons.
fn scale(polygons: &[Polygon]) -> Place {
    let points: Vec<Place> = polygons
        .iter()
        .flat_map(Polygon::points)
        .map(|[x, y]: [Rational; 2]| [approximate(&x), approximate(&y)])
        .collect();
    let (low, high) = extent(&points);
    [0, 1].map(|i| 2f64.powi((high[i] - low[i]).log2().round() as i32))
}

fn value(terms: &Terms, [x, y]: Place) -> f64 {
    terms.iter().map(|(c, i, j)| approximate(&c.0) * x.powi(*i as i32) * y.powi(*j as i32)).sum()
}

fn extent(points: &[Place]) -> (Place, Place) {
    let fold =
        |i: usize, start: f64, f: fn(f64, f64) -> f64| points.iter().map(|p| p[i]).fold(start, f);
    let low = [0, 1].map(|i| fold(i, f64::INFINITY, f64::min));
    (low, [0, 1].map(|i| fold(i, f64::NEG_INFINITY, f64::max)))
}

fn area_of(corners: &[Place]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

fn is_in(corners: &[Place], place: Place) -> bool {
    let mut edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.all(|(a, b)| (b[0] - a[0]) * (place[1] - a[1]) >= (b[1] - a[1]) * (place[0] - a[0]))
}

fn distance(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn between(a: Place, b: Place, part: f64) -> Place {
    [0, 1].map(|i| a[i] + part * (b[i] - a[i]))
}

fn moved(place: Place, direction: Place, by: f64) -> Place {
    [0, 1].map(|i| place[i] + by * direction[i])
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
