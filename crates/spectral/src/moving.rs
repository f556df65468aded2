//! A polytope that moves over a triangle of sets of matrices.
//!
//! Where a complex pair leads, the ellipses in which different matrices turn do not fit into each other,
//! so that one polytope serves a small piece only; but they change smoothly. With vertices that are
//! affine functions of the point, what is left over is of second order. With complex vertices the
//! ellipses themselves belong to the polytope.

use nalgebra::{Complex, DMatrix};
use refinable_certificate::{CellMotion, CellPolytope};

use crate::body::{Body, Ends, apply};
use crate::common::{
    PRECISIONS, grown, kept_of, leaders, renumbered, renumbered_all, start, vertices_of,
};
use crate::gauge::{Atom, FINEST, Gauge, Limits, Representation};
use crate::rounding::{Precision, Rounded};
use crate::word::Word;
use crate::writing::{SPARE, Weights};

/// In which ways a polytope is grown, as in `common`; lengths are powers of two.
const WAYS: [(f64, f64, usize); 3] = [(0.3, 0.125, 60), (0.1, 0.125, 80), (0.1, 0.015625, 80)];
/// Pairs of corners.
const PAIRS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];

/// A polytope that moves from corner to corner, if one is found that is accepted.
pub(crate) fn moving_polytope(
    sets: &[Vec<DMatrix<f64>>; 3],
    mirrored: bool,
    words: &[Word],
    accept: &dyn Fn(&CellPolytope) -> bool,
) -> Option<CellPolytope> {
    let leader = leaders(sets, words)?.swap_remove(0);
    let starts = [start(sets, &leader, 0)?];
    let base = leader.set;
    WAYS.iter().find_map(|&way| {
        let body = grown(&sets[base], &starts, leader.growth, mirrored, way)?;
        let carried =
            |set: &Vec<DMatrix<f64>>| body.carried(&Ends { inner: set, end: &sets[base] });
        let bodies: Vec<Body> = sets.iter().map(carried).collect::<Option<_>>()?;
        PRECISIONS.iter().find_map(|&precision| {
            Moving::new(&bodies, base, sets, precision).written().filter(accept)
        })
    })
}

/// A polytope at the corners of a triangle.
struct Moving<'a> {
    corners: Vec<Rounded>,
    /// The corner at which it was grown.
    base: usize,
    sets: &'a [Vec<DMatrix<f64>>; 3],
    precision: Precision,
}

/// The combinations for a vertex and a letter.
struct Images {
    at_corners: Vec<Weights>,
    rests: Vec<Weights>,
}

impl<'a> Moving<'a> {
    fn new(
        bodies: &[Body],
        base: usize,
        sets: &'a [Vec<DMatrix<f64>>; 3],
        precision: Precision,
    ) -> Self {
        let corners = bodies.iter().map(|body| Rounded::new(body, precision)).collect();
        Moving { corners, base, sets, precision }
    }

    /// The polytope in integers, if rounding leaves room.
    fn written(&self) -> Option<CellPolytope> {
        let first = &self.corners[0];
        let d = first.body.dimension;
        let units: Vec<Weights> = (0..d).map(|i| self.unit(i)).collect::<Option<_>>()?;
        let slack = units.iter().flatten().map(|(_, w)| self.float(*w).re).fold(0.0, f64::max);
        let mut gauges: Vec<Gauge> =
            self.corners.iter().map(|corner| corner.body.gauge()).collect();
        let mut images: Vec<Option<Vec<Weights>>> = vec![None; first.integers.len()];
        let mut rests = images.clone();
        let mut kept = vertices_of(first, units.iter().flatten());
        while let Some(vertex) = kept.pop() {
            if images[vertex].is_some() {
                continue;
            }
            let letters = 0..self.sets[0].len();
            let of = letters.map(|letter| self.images(&mut gauges, slack, vertex, letter));
            let of: Vec<Images> = of.collect::<Option<_>>()?;
            let by_corner = |corner: usize| of.iter().map(move |of| of.at_corners[corner].clone());
            let at_corners: Vec<Weights> = (0..3).flat_map(by_corner).collect();
            let between: Vec<Weights> = of.iter().flat_map(|of| of.rests.clone()).collect();
            kept.extend(vertices_of(first, at_corners.iter().chain(&between).flatten()));
            images[vertex] = Some(at_corners);
            rests[vertex] = Some(between);
        }
        let kept = kept_of(&images);
        let list = |corner: usize| -> Vec<Vec<i64>> {
            kept.iter().map(|&v| self.corners[corner].integers[v].clone()).collect()
        };
        Some(CellPolytope {
            complex: first.body.shape.complex,
            mirrored: first.body.shape.mirrored,
            bits: self.precision.bits,
            vertices: list(0),
            weight_bits: self.precision.weight_bits,
            units: units.iter().map(|unit| renumbered(first, &kept, unit)).collect(),
            images: renumbered_all(first, &kept, &images),
            motion: Some(CellMotion {
                vertices: [list(1), list(2)],
                rests: renumbered_all(first, &kept, &rests),
            }),
        })
    }

    /// A unit vector as a multiple of the vertex that the seed has in its direction, which does not move.
    fn unit(&self, i: usize) -> Option<Weights> {
        let rounded = &self.corners[0];
        let d = rounded.body.dimension;
        let alone = |v: &[i64], i: usize| v[i] > 0 && v.iter().filter(|&&x| x != 0).count() == 1;
        let one = 1_i64 << (self.precision.bits + self.precision.weight_bits);
        rounded.integers.iter().enumerate().find_map(|(vertex, v)| {
            let (plain, mirror) = rounded.body.atoms_of(vertex);
            let (atom, at) = match mirror {
                _ if alone(v, i) => (plain, i),
                Some(mirror) if alone(v, d - 1 - i) => (mirror, d - 1 - i),
                _ => return None,
            };
            Some(vec![(Atom::Plain(atom), Complex::new(one / v[at], 0))])
        })
    }

    /// The images of a vertex under a letter at all corners, and what is left of them in between.
    fn images(
        &self,
        gauges: &mut [Gauge],
        slack: f64,
        vertex: usize,
        letter: usize,
    ) -> Option<Images> {
        let at = |corner: usize, list: usize| {
            apply(&self.sets[corner][letter], &self.corners[list].body.vertices[vertex])
        };
        // The least weights change continuously from corner to corner.
        let least = Limits { inside: 0.0, outside: 1.0, accuracy: FINEST };
        let corner = |(corner, gauge): (usize, &mut Gauge)| {
            let image = at(corner, corner);
            let weights = self.rounded(&gauge.represent(&image, least));
            let total = self.total(&weights);
            let residual = self.residual(&weights, corner, &image);
            (total + slack * residual < 1.0 - SPARE).then_some((weights, total))
        };
        let corners = gauges.iter_mut().enumerate().map(corner);
        let corners: Vec<(Weights, f64)> = corners.collect::<Option<_>>()?;
        let mut rest = |[i, j]: [usize; 2]| -> Option<Weights> {
            let sums = [self.combine(&corners[i].0, j), self.combine(&corners[j].0, i)];
            let images = at(i, j).into_iter().zip(at(j, i)).map(|(a, b)| a + b);
            let left: Vec<f64> =
                images.enumerate().map(|(k, x)| x - sums[0][k] - sums[1][k]).collect();
            let room = 2.0 - SPARE - corners[i].1 - corners[j].1;
            if slack * self.residual(&Weights::new(), 0, &left) < room {
                return Some(Weights::new());
            }
            let limits = Limits { inside: 0.1 * room, outside: room, accuracy: 0.01 };
            let weights = self.rounded(&gauges[self.base].represent(&left, limits));
            let residuals = (0..3).map(|corner| self.residual(&weights, corner, &left));
            let residual = residuals.fold(0.0, f64::max);
            (self.total(&weights) + slack * residual < room).then_some(weights)
        };
        let rests = PAIRS.into_iter().map(&mut rest).collect::<Option<_>>()?;
        Some(Images {
            at_corners: corners.into_iter().map(|(weights, _)| weights).collect(),
            rests,
        })
    }

    fn rounded(&self, found: &Representation) -> Weights {
        let one = 2f64.powi(self.precision.weight_bits as i32);
        let round = |x: f64| (x * one).round() as i64;
        let weights = found.weights.iter();
        let weights = weights.map(|(atom, w)| (*atom, Complex::new(round(w.re), round(w.im))));
        weights.filter(|(_, w)| w.re != 0 || w.im != 0).collect()
    }

    fn total(&self, weights: &Weights) -> f64 {
        weights.iter().map(|(_, w)| self.float(*w).norm()).sum()
    }

    /// The 1-norm of what a combination at a corner leaves of a vector.
    fn residual(&self, weights: &Weights, corner: usize, vector: &[f64]) -> f64 {
        let sum = self.combine(weights, corner);
        vector.iter().zip(sum).map(|(x, s)| (x - s).abs()).sum()
    }

    fn float(&self, weight: Complex<i64>) -> Complex<f64> {
        let one = 2f64.powi(self.precision.weight_bits as i32);
        Complex::new(weight.re as f64 / one, weight.im as f64 / one)
    }

    /// The sum of the weights' multiples of vertices at a corner.
    fn combine(&self, weights: &Weights, corner: usize) -> Vec<f64> {
        let rounded = &self.corners[corner];
        let (d, complex) = (rounded.body.dimension, rounded.body.shape.complex);
        let mut sum = vec![0.0; if complex { 2 * d } else { d }];
        for (atom, weight) in weights {
            let (vertex, mirror) = rounded.vertex_of(*atom);
            let u = &rounded.body.vertices[vertex];
            let sign = if matches!(atom, Atom::Conjugate(_)) { -1.0 } else { 1.0 };
            let factor = self.float(*weight);
            for i in 0..d {
                let k = if mirror { d - 1 - i } else { i };
                let imaginary = if complex { sign * u[d + k] } else { 0.0 };
                let term = factor * Complex::new(u[k], imaginary);
                sum[i] += term.re;
                if complex {
                    sum[d + i] += term.im;
                }
            }
        }
        sum
    }
}
