//! From a polytope in floats to the integers of a certificate.

use nalgebra::DVector;
use refinable_algebra::Rational;
use refinable_certificate::{self as certificate, Combination, Leading, Number, Polytope};

use crate::body::{Body, Ends, Orbit};
use crate::gauge::{Gauge, Limits};

/// How many bits the integers have after the point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Precision {
    pub bits: u32,
    pub weight_bits: u32,
}

/// Everything about the interval that a polytope is to prove.
pub(crate) struct Span<'a> {
    pub pencil: certificate::Pencil,
    pub inner: &'a Rational,
    pub end: certificate::End,
    pub ends: Ends<'a>,
}

/// The vertices that a proof needs, with all combinations; `None` if the precision leaves no room.
///
/// Beginning with the orbits and with what represents the unit vectors, a vertex is kept if it is
/// met in the representation of an image of one that is kept.
pub(crate) fn polytope(body: &Body, span: &Span, precision: Precision) -> Option<Polytope> {
    let rounded = Rounded::new(body, precision);
    let mut writer = Writer {
        gauge: rounded.body.gauge(),
        rounded: &rounded,
        weight_bits: precision.weight_bits,
        slack: 1.0,
        orbit_error: 0.0,
    };
    let d = body.vertices[0].len();
    let mut units = Vec::new();
    let (mut largest, mut defect) = (0.0f64, 0.0f64);
    for i in 0..d {
        let unit = DVector::from_fn(d, |j, _| if i == j { 1.0 } else { 0.0 });
        let found = writer.write(&unit, Limits { inside: 0.0, outside: f64::INFINITY });
        largest = largest.max(found.total);
        defect = defect.max(found.residual);
        units.push(found.weights);
    }
    if defect > 0.5 {
        return None;
    }
    let kappa = largest / (1.0 - defect);
    writer.slack = kappa;
    if !body.orbits.is_empty() {
        // Rounding errors of an eigenvector, by a wide margin; the checker has the last word.
        writer.orbit_error = 32.0 * d as f64 * 0.5f64.powi(precision.bits as i32);
    }
    let mut images: Vec<Option<Images>> = vec![None; body.vertices.len()];
    let mut kept: Vec<usize> = rounded.orbit_vertices();
    kept.extend(units.iter().flatten().map(|(k, _)| rounded.vertex_of(*k)));
    while let Some(vertex) = kept.pop() {
        if images[vertex].is_some() {
            continue;
        }
        let v = DVector::from_column_slice(&rounded.body.vertices[vertex]);
        let mut inner = Vec::new();
        let mut end = Vec::new();
        for (letter, (at_inner, at_end)) in span.ends.inner.iter().zip(span.ends.end).enumerate() {
            inner.push(writer.image(&(at_inner * &v))?);
            end.push(if body.closes_orbit(vertex, letter) {
                None
            } else {
                Some(writer.image(&(at_end * &v))?)
            });
        }
        let written = inner.iter().chain(end.iter().flatten());
        kept.extend(written.flat_map(|w| &w.weights).map(|(k, _)| rounded.vertex_of(*k)));
        images[vertex] = Some((inner, end));
    }
    Some(rounded.assemble(span, precision, units, images))
}

/// The images of one vertex at both ends, for each letter; `None` closes an orbit.
type Images = (Vec<Written>, Vec<Option<Written>>);

/// The body with its vertices rounded.
struct Rounded {
    integers: Vec<Vec<i64>>,
    body: Body,
}

impl Rounded {
    fn new(body: &Body, precision: Precision) -> Self {
        let scale = 2f64.powi(precision.bits as i32);
        let round = |v: &Vec<f64>| v.iter().map(|x| (x * scale).round() as i64).collect();
        let integers: Vec<Vec<i64>> = body.vertices.iter().map(round).collect();
        let back = |v: &Vec<i64>| v.iter().map(|x| *x as f64 / scale).collect();
        let vertices = integers.iter().map(back).collect();
        Rounded { integers, body: Body { vertices, ..body.clone() } }
    }

    fn vertex_of(&self, atom: usize) -> usize {
        if self.body.mirrored { atom / 2 } else { atom }
    }

    fn orbit_vertices(&self) -> Vec<usize> {
        let orbits = self.body.orbits.iter();
        orbits.flat_map(|orbit| orbit.first..orbit.first + orbit.word.letters().len()).collect()
    }

    fn assemble(
        &self,
        span: &Span,
        precision: Precision,
        units: Vec<Vec<(usize, i64)>>,
        images: Vec<Option<Images>>,
    ) -> Polytope {
        // New indices: kept vertices in their order, mirror images after them.
        let mut position = vec![0; images.len()];
        let kept: Vec<usize> = (0..images.len()).filter(|&v| images[v].is_some()).collect();
        kept.iter().enumerate().for_each(|(new, &old)| position[old] = new);
        let renumber = |weights: &[(usize, i64)]| -> Combination {
            let place = |atom: usize| {
                let image = self.body.mirrored && atom % 2 == 1;
                position[self.vertex_of(atom)] + if image { kept.len() } else { 0 }
            };
            let mut pairs: Vec<_> = weights.iter().map(|(k, w)| (place(*k), *w)).collect();
            pairs.sort_unstable();
            Some(pairs)
        };
        let leading = |orbit: &Orbit| {
            let first = &self.integers[orbit.first];
            let pivot = (0..first.len()).max_by_key(|&i| first[i].abs()).unwrap_or(0);
            Leading {
                word: orbit.word.to_string(),
                sign: orbit.sign,
                vertex: position[orbit.first],
                pivot,
            }
        };
        let all = images.iter().flatten();
        Polytope {
            pencil: span.pencil,
            inner: Number(span.inner.clone()),
            end: span.end.clone(),
            mirrored: self.body.mirrored,
            bits: precision.bits,
            vertices: kept.iter().map(|&v| self.integers[v].clone()).collect(),
            leading: self.body.orbits.iter().map(leading).collect(),
            weight_bits: precision.weight_bits,
            units: units.iter().map(|weights| renumber(weights)).collect(),
            inner_images: all
                .clone()
                .map(|(inner, _)| inner.iter().map(|w| renumber(&w.weights)).collect())
                .collect(),
            end_images: all
                .map(|(_, end)| {
                    end.iter().map(|w| w.as_ref().and_then(|w| renumber(&w.weights))).collect()
                })
                .collect(),
        }
    }
}

/// A combination in integers, by atoms of the gauge.
#[derive(Clone, Debug)]
struct Written {
    weights: Vec<(usize, i64)>,
    total: f64,
    residual: f64,
}

struct Writer<'a> {
    gauge: Gauge,
    rounded: &'a Rounded,
    weight_bits: u32,
    /// `κ`: how much the gauge can exceed the 1-norm.
    slack: f64,
    orbit_error: f64,
}

impl Writer<'_> {
    /// An image that is inside even with all that rounding costs.
    fn image(&mut self, y: &DVector<f64>) -> Option<Written> {
        for inside in [0.9, 0.99, 0.999, 0.9999, 0.0] {
            let limits = Limits { inside, outside: 1.0 };
            let found = self.write(y, limits);
            if found.total + self.slack * (found.residual + self.orbit_error) < 1.0 - 1e-11 {
                return Some(found);
            }
        }
        None
    }

    fn write(&mut self, y: &DVector<f64>, limits: Limits) -> Written {
        let found = self.gauge.represent(y.as_slice(), limits);
        let scale = 2f64.powi(self.weight_bits as i32);
        let rounded = found.weights.iter().map(|(k, w)| (*k, (w * scale).round() as i64));
        let weights: Vec<(usize, i64)> = rounded.filter(|(_, w)| *w != 0).collect();
        let mut residual = y.clone();
        let mut total = 0.0;
        for (atom, weight) in &weights {
            let weight = *weight as f64 / scale;
            let vertex = &self.rounded.body.vertices[self.rounded.vertex_of(*atom)];
            let d = vertex.len();
            let reversed = self.rounded.body.mirrored && atom % 2 == 1;
            for i in 0..d {
                residual[i] -= weight * vertex[if reversed { d - 1 - i } else { i }];
            }
            total += weight.abs();
        }
        Written { weights, total, residual: residual.iter().map(|r| r.abs()).sum() }
    }
}
