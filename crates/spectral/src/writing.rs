//! Combinations in integers that represent images with room to spare.

use nalgebra::{Complex, DMatrix, DVector};

use crate::body::{Body, Closing, Ends, apply, padded};
use crate::gauge::{Atom, FINEST, Gauge, Limits};
use crate::rounding::Precision;

/// Integer weights of atoms of the gauge.
pub(crate) type Weights = Vec<(Atom, Complex<i64>)>;

/// A combination in integers.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    pub weights: Weights,
    total: f64,
    residual: f64,
}

/// The images of a vertex under a letter at both ends, and what is left between them.
#[derive(Clone, Debug)]
pub(crate) struct Images {
    pub inner: Written,
    pub end: Written,
    pub rest: Weights,
}

/// A total that leaves room for everything.
const ROOMY: f64 = 0.9;
/// How near to the least total a larger one must be, in turn: each begins where the last one ended.
const ACCURACIES: [f64; 4] = [1e-2, 1e-4, 1e-7, FINEST];
/// What must be left for the rounding of the checker.
const SPARE: f64 = 1e-11;

/// A polytope, with where it moves to.
pub(crate) struct Writer<'a> {
    end: Side<'a>,
    inner: Option<Side<'a>>,
    weight_bits: u32,
    /// `κ`: how much the gauge can exceed the 1-norm.
    slack: f64,
    orbit_error: f64,
}

/// The polytope at one end.
struct Side<'a> {
    body: &'a Body,
    gauge: Gauge,
}

impl<'a> Side<'a> {
    fn new(body: &'a Body) -> Self {
        Side { body, gauge: body.gauge() }
    }

    /// The sum of the weights' multiples of vertices.
    fn combine(&self, weights: &[(Atom, Complex<f64>)]) -> Vec<f64> {
        let mut sum = vec![0.0; self.body.vertices[0].len()];
        for (atom, weight) in weights {
            let column = self.gauge.column(*atom, *weight);
            sum.iter_mut().zip(&column).for_each(|(s, u)| *s += u);
        }
        sum
    }
}

impl<'a> Writer<'a> {
    pub fn new(body: &'a Body, moved: Option<&'a Body>, precision: Precision) -> Self {
        // Rounding errors of an eigenvector, by a wide margin; the checker has the last word.
        let rounding = 32.0 * body.dimension as f64 * 0.5f64.powi(precision.bits as i32);
        Writer {
            end: Side::new(body),
            inner: moved.map(Side::new),
            weight_bits: precision.weight_bits,
            slack: 1.0,
            orbit_error: if body.shape.closing == Closing::Orbits { rounding } else { 0.0 },
        }
    }

    /// The unit vectors, and with them the bound for the gauge.
    pub fn units(&mut self) -> Option<Vec<Weights>> {
        let (d, size) = (self.end.body.dimension, self.end.body.vertices[0].len());
        let limits = Limits { inside: 0.0, outside: f64::INFINITY, accuracy: 0.01 };
        let (mut largest, mut defect) = (0.0f64, 0.0f64);
        let mut units = Vec::new();
        for i in 0..d {
            let unit: Vec<f64> = (0..d).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
            let unit = padded(&unit, size);
            let found = self.end.gauge.represent(&unit, limits);
            let written = self.written(&self.end, &found.weights, &unit);
            largest = largest.max(written.total);
            defect = defect.max(written.residual);
            if let Some(inner) = &self.inner {
                defect = defect.max(self.written(inner, &found.weights, &unit).residual);
            }
            units.push(written.weights);
        }
        self.slack = largest / (1.0 - defect);
        (defect < 0.5).then_some(units)
    }

    /// The images of a vertex at the inner end and at the end.
    pub fn images(&mut self, ends: &Ends, vertex: usize, letter: usize) -> Option<Images> {
        let u = &self.end.body.vertices[vertex];
        let [at_inner, at_end] = [ends.inner, ends.end].map(|m| &m[letter]);
        let image = apply(at_end, u);
        let met = self.end.body.met(ends, vertex, letter);
        let met = met.map(|(atom, sign)| {
            let weight = Complex::new(f64::from(sign), 0.0);
            self.written(&self.end, &[(Atom::Plain(atom), weight)], &image)
        });
        let Some(inner) = &self.inner else {
            let inner_image = apply(at_inner, u);
            let inner = self.inside(&inner_image)?;
            let end = met.map_or_else(|| self.inside(&image), Some)?;
            return Some(Images { inner, end, rest: Weights::new() });
        };
        let u_inner = inner.body.vertices[vertex].clone();
        let inner_image = apply(at_inner, &u_inner);
        // What is left of B(x_1) u' + B(x_0) u gives the middle of the way.
        let crossed: Vec<f64> =
            apply(at_end, &u_inner).iter().zip(apply(at_inner, u)).map(|(a, b)| a + b).collect();
        let pair = |writer: &mut Self, end: Written| {
            let inner = writer.followed(&end, &inner_image)?;
            let rest = writer.rest(&inner, &end, &crossed)?;
            Some(Images { inner, end, rest })
        };
        match met {
            // The vertex that is met may be several at the inner end.
            Some(_) if self.end.body.shape.closing == Closing::Vertices => {
                let inner = self.inside_moved(&inner_image)?;
                let end = self.folded(&inner, &image)?;
                let rest = self.rest(&inner, &end, &crossed)?;
                Some(Images { inner, end, rest })
            }
            Some(met) => pair(self, met),
            None => ACCURACIES.iter().find_map(|&accuracy| {
                let end = self.inside_by(&image, accuracy)?;
                pair(self, end)
            }),
        }
    }

    /// A representation at the end with room for all that rounding costs.
    pub fn inside(&mut self, y: &[f64]) -> Option<Written> {
        ACCURACIES.iter().find_map(|&accuracy| self.inside_by(y, accuracy))
    }

    fn inside_by(&mut self, y: &[f64], accuracy: f64) -> Option<Written> {
        let limits = Limits { inside: ROOMY, outside: 1.0, accuracy };
        let found = self.end.gauge.represent(y, limits);
        let written = self.written(&self.end, &found.weights, y);
        self.fits(&written).then_some(written)
    }

    /// An image at the inner end, by whatever vertices.
    fn inside_moved(&mut self, y: &[f64]) -> Option<Written> {
        let limits = Limits { inside: 0.0, outside: 1.0, accuracy: FINEST };
        let side = self.inner.as_mut()?;
        let weights = side.gauge.represent(y, limits).weights;
        Some(self.written(self.inner.as_ref()?, &weights, y)).filter(|written| self.fits(written))
    }

    /// An image at the end that is a vertex, by all vertices that are the same there, in the proportions
    /// that their weights have at the inner end.
    fn folded(&self, inner: &Written, image: &[f64]) -> Option<Written> {
        let is_image =
            |atom: Atom, sign| self.end.gauge.column(atom, Complex::new(sign, 0.0)) == image;
        let twins = inner
            .weights
            .iter()
            .filter(|(atom, weight)| is_image(*atom, weight.re.signum() as f64));
        let twins: Vec<(Atom, i64)> = twins.map(|(atom, weight)| (*atom, weight.re)).collect();
        let sum: i64 = twins.iter().map(|(_, weight)| weight.abs()).sum();
        let one = 2f64.powi(self.weight_bits as i32);
        let share = |weight: i64| (weight as f64 / sum as f64 * one) as i64;
        let mut weights: Weights =
            twins.iter().map(|(atom, weight)| (*atom, Complex::new(share(*weight), 0))).collect();
        // In all exactly one.
        let missing = one as i64 - weights.iter().map(|(_, weight)| weight.re.abs()).sum::<i64>();
        let (_, first) = weights.first_mut()?;
        first.re += first.re.signum() * missing;
        Some(Written { weights, total: 1.0, residual: 0.0 })
    }

    fn fits(&self, written: &Written) -> bool {
        written.total + self.slack * (written.residual + self.orbit_error) < 1.0 - SPARE
    }

    /// The combination of the same vertices that is nearest, where they have moved to.
    fn followed(&self, end: &Written, y: &[f64]) -> Option<Written> {
        let inner = self.inner.as_ref()?;
        let weights: Vec<(Atom, Complex<f64>)> =
            end.weights.iter().map(|(atom, weight)| (*atom, self.float(*weight))).collect();
        let sum = inner.combine(&weights);
        let rest = DVector::from_iterator(y.len(), y.iter().zip(&sum).map(|(y, s)| y - s));
        let directions: &[Complex<f64>] = if inner.body.shape.complex {
            &[Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)]
        } else {
            &[Complex::new(1.0, 0.0)]
        };
        let columns: Vec<DVector<f64>> = weights
            .iter()
            .flat_map(|(atom, _)| directions.iter().map(|z| inner.gauge.column(*atom, *z)))
            .map(DVector::from_vec)
            .collect();
        if columns.is_empty() {
            return Some(self.written(inner, &[], y)).filter(|written| self.fits(written));
        }
        let svd = DMatrix::from_columns(&columns).try_svd(true, true, 1e-15, 10_000)?;
        let correction = svd.solve(&rest, 1e-12).ok()?;
        let corrected: Vec<(Atom, Complex<f64>)> = weights
            .iter()
            .zip(correction.as_slice().chunks_exact(directions.len()))
            .map(|((atom, weight), steps)| {
                let step: Complex<f64> = steps.iter().zip(directions).map(|(x, z)| z * *x).sum();
                (*atom, weight + step)
            })
            .collect();
        Some(self.written(inner, &corrected, y)).filter(|written| self.fits(written))
    }

    /// A combination that is nearly what is left of the image between the ends, if this is so little
    /// that the image is inside all the way; mostly nothing.
    fn rest(&mut self, at_inner: &Written, at_end: &Written, crossed: &[f64]) -> Option<Weights> {
        let inner = self.inner.as_ref()?;
        let floats = |written: &Written| -> Vec<(Atom, Complex<f64>)> {
            written.weights.iter().map(|(atom, weight)| (*atom, self.float(*weight))).collect()
        };
        let moved = inner.combine(&floats(at_end));
        let fixed = self.end.combine(&floats(at_inner));
        let rest: Vec<f64> =
            crossed.iter().zip(moved.iter().zip(&fixed)).map(|(c, (a, b))| c - a - b).collect();
        let room =
            2.0 * (1.0 - SPARE - self.slack * self.orbit_error) - at_inner.total - at_end.total;
        let norm: f64 = rest.iter().map(|x| x.abs()).sum();
        if self.slack * norm < room {
            return Some(Weights::new());
        }
        let limits = Limits { inside: 0.1 * room, outside: room, accuracy: 1e-2 };
        let found = self.end.gauge.represent(&rest, limits);
        let inner = self.inner.as_ref()?;
        let written = [&self.end, inner].map(|side| self.written(side, &found.weights, &rest));
        let residual = written[0].residual.max(written[1].residual);
        let [written, _] = written;
        (written.total + self.slack * residual < room).then_some(written.weights)
    }

    fn float(&self, weight: Complex<i64>) -> Complex<f64> {
        Complex::new(weight.re as f64, weight.im as f64) / 2f64.powi(self.weight_bits as i32)
    }

    /// The weights, rounded, and what they leave of the vector.
    fn written(&self, side: &Side, weights: &[(Atom, Complex<f64>)], y: &[f64]) -> Written {
        let scale = 2f64.powi(self.weight_bits as i32);
        let round = |x: f64| (x * scale).round() as i64;
        let rounded = weights.iter().map(|(k, w)| (*k, Complex::new(round(w.re), round(w.im))));
        let weights: Weights = rounded.filter(|(_, w)| w.re != 0 || w.im != 0).collect();
        let floats: Vec<(Atom, Complex<f64>)> =
            weights.iter().map(|(atom, weight)| (*atom, self.float(*weight))).collect();
        let sum = side.combine(&floats);
        Written {
            total: floats.iter().map(|(_, weight)| weight.norm()).sum(),
            residual: y.iter().zip(&sum).map(|(y, s)| (y - s).abs()).sum(),
            weights,
        }
    }
}
