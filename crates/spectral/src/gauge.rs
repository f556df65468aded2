//! The gauge of a symmetric polytope, in floats: `‖y‖ = min {Σ|λ_k| : Σ λ_k u_k = y}`.
//!
//! Every set of `d` independent atoms, with signs, is a feasible basis of this linear program, so
//! the primal simplex method needs no first phase and starts where the last question ended.

/// The polytope spanned by `±` atoms.
///
/// The first `d` atoms are tiny multiples of the unit vectors: they make every vector
/// representable, at a price that shows when a vector is outside the span of the true atoms.
#[derive(Clone, Debug)]
pub(crate) struct Gauge {
    dimension: usize,
    atoms: Vec<f64>,
    basis: Vec<usize>,
    /// With which sign each basic atom is used; where its weight is zero the sign still counts.
    signs: Vec<f64>,
    /// Row-major inverse of the matrix with the basic atoms as columns.
    inverse: Vec<f64>,
}

/// When a question may be answered before the optimum is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Any representation with a smaller total will do.
    pub inside: f64,
    /// No representation with a smaller total exists: that will do.
    pub outside: f64,
}

/// A representation of a vector by atoms.
#[derive(Clone, Debug)]
pub(crate) struct Representation {
    /// Pairs of a true atom, counted from 0, and its weight.
    pub weights: Vec<(usize, f64)>,
    /// The sum of absolute weights, tiny atoms included at their price.
    pub total: f64,
}

/// The length of the tiny atoms, against true ones of about 1.
const TINY: f64 = 1e-7;
/// The relative residual beyond which the inverse is computed afresh.
const ACCURACY: f64 = 1e-13;
/// How far a price may exceed 1 at what is taken for the optimum.
const TOLERANCE: f64 = 1e-10;

impl Gauge {
    /// The gauge without true atoms.
    pub fn new(dimension: usize) -> Self {
        let mut gauge = Gauge {
            dimension,
            atoms: vec![0.0; dimension * dimension],
            basis: (0..dimension).collect(),
            signs: vec![1.0; dimension],
            inverse: vec![0.0; dimension * dimension],
        };
        for i in 0..dimension {
            gauge.atoms[i * dimension + i] = TINY;
            gauge.inverse[i * dimension + i] = 1.0 / TINY;
        }
        gauge
    }

    /// Adds an atom.
    pub fn push(&mut self, atom: &[f64]) {
        self.atoms.extend_from_slice(atom);
    }

    /// Represents `y` with the least total, or until the limits are met.
    ///
    /// # Cost
    /// Each pivot takes one product of all atoms with a vector.
    pub fn represent(&mut self, y: &[f64], limits: Limits) -> Representation {
        let d = self.dimension;
        let mut x = self.solve(y);
        for _ in 0..100 * d {
            self.settle_signs(&x);
            let total: f64 = x.iter().map(|x| x.abs()).sum();
            let (entering, price) = self.dearest(&self.dual());
            let lower_bound = total / price.abs().max(1.0);
            if total <= limits.inside
                || lower_bound >= limits.outside
                || price.abs() <= 1.0 + TOLERANCE
                || !self.pivot(entering, price.signum(), &x)
            {
                break;
            }
            x = self.solve(y);
        }
        let total = x.iter().map(|x| x.abs()).sum();
        let weights = self.basis.iter().zip(&x).filter(|(k, x)| **k >= d && **x != 0.0);
        Representation { weights: weights.map(|(k, x)| (k - d, *x)).collect(), total }
    }

    /// The weights of the basic atoms for `y`, from a fresh inverse if rounding errors have grown.
    fn solve(&mut self, y: &[f64]) -> Vec<f64> {
        let x = self.times_inverse(y);
        if self.residual(&x, y) <= ACCURACY * norm(y) {
            return x;
        }
        self.refactor();
        self.times_inverse(y)
    }

    /// The 1-norm of `y - Σ x_i u_i` over the basis.
    fn residual(&self, x: &[f64], y: &[f64]) -> f64 {
        let mut rest = y.to_vec();
        for (k, x) in self.basis.iter().zip(x) {
            rest.iter_mut().zip(self.atom(*k)).for_each(|(r, u)| *r -= x * u);
        }
        norm(&rest)
    }

    fn atom(&self, k: usize) -> &[f64] {
        &self.atoms[k * self.dimension..(k + 1) * self.dimension]
    }

    fn times_inverse(&self, y: &[f64]) -> Vec<f64> {
        self.inverse.chunks_exact(self.dimension).map(|row| dot(row, y)).collect()
    }

    /// Takes the signs of the weights, but keeps those of weights that are zero.
    fn settle_signs(&mut self, x: &[f64]) {
        let largest = x.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        for (sign, x) in self.signs.iter_mut().zip(x) {
            if x.abs() > 1e-13 * largest {
                *sign = x.signum();
            }
        }
    }

    /// The functional that is the sign on each basic atom.
    fn dual(&self) -> Vec<f64> {
        let mut dual = vec![0.0; self.dimension];
        for (row, sign) in self.inverse.chunks_exact(self.dimension).zip(&self.signs) {
            dual.iter_mut().zip(row).for_each(|(y, r)| *y += sign * r);
        }
        dual
    }

    /// The atom on which the functional is largest in modulus, and its value there.
    fn dearest(&self, dual: &[f64]) -> (usize, f64) {
        let mut best = (0, 0.0f64);
        for (k, atom) in self.atoms.chunks_exact(self.dimension).enumerate() {
            let price = dot(dual, atom);
            if price.abs() > best.1.abs() {
                best = (k, price);
            }
        }
        best
    }

    /// Exchanges a basic atom, by the ratio test, for `sign` times the entering one.
    fn pivot(&mut self, entering: usize, sign: f64, x: &[f64]) -> bool {
        let direction: Vec<f64> =
            self.times_inverse(self.atom(entering)).iter().map(|w| w * sign).collect();
        let least_speed = 1e-9 * direction.iter().fold(0.0, |a: f64, w| a.max(w.abs()));
        let mut leaving: Option<(usize, f64, f64)> = None;
        for (i, (x, w)) in x.iter().zip(&direction).enumerate() {
            let speed = w * self.signs[i];
            if speed <= least_speed {
                continue;
            }
            let ratio = x.abs() / speed;
            let better = leaving.is_none_or(|(_, least, fastest)| {
                ratio < least - 1e-14 || (ratio <= least + 1e-14 && speed > fastest)
            });
            if better {
                leaving = Some((i, ratio, speed));
            }
        }
        let Some((row, ..)) = leaving else { return false };
        self.exchange(row, entering, &direction, sign);
        true
    }

    /// Replaces the basic atom of a row by `entering`, whose coordinates are `sign · direction`.
    fn exchange(&mut self, row: usize, entering: usize, direction: &[f64], sign: f64) {
        let d = self.dimension;
        let pivot = direction[row] * sign;
        let pivot_row: Vec<f64> =
            self.inverse[row * d..(row + 1) * d].iter().map(|r| r / pivot).collect();
        for (i, target) in self.inverse.chunks_exact_mut(d).enumerate() {
            if i == row {
                target.copy_from_slice(&pivot_row);
            } else {
                let factor = direction[i] * sign;
                target.iter_mut().zip(&pivot_row).for_each(|(t, p)| *t -= factor * p);
            }
        }
        self.basis[row] = entering;
        self.signs[row] = sign;
    }

    /// Computes the inverse afresh, to shed rounding errors.
    fn refactor(&mut self) {
        let d = self.dimension;
        let basis = nalgebra::DMatrix::from_fn(d, d, |i, j| self.atom(self.basis[j])[i]);
        if let Some(inverse) = basis.try_inverse() {
            self.inverse = inverse.transpose().as_slice().to_vec();
        }
    }
}

fn norm(y: &[f64]) -> f64 {
    y.iter().map(|y| y.abs()).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPTIMUM: Limits = Limits { inside: 0.0, outside: f64::INFINITY };

    fn square() -> Gauge {
        let mut gauge = Gauge::new(2);
        gauge.push(&[1.0, 1.0]);
        gauge.push(&[1.0, -1.0]);
        gauge
    }

    #[test]
    fn the_square_has_the_maximum_norm() {
        let mut gauge = square();
        for y in [[0.3, 0.7], [-2.0, 1.0], [0.0, 0.5], [1.0, 1.0]] {
            let found = gauge.represent(&y, OPTIMUM);
            let norm = f64::max(y[0].abs(), y[1].abs());
            assert!((found.total - norm).abs() < 1e-9, "{y:?}: {found:?}");
            assert!(found.weights.iter().all(|(k, _)| *k < 2));
        }
    }

    #[test]
    fn outside_the_span_the_price_is_high() {
        let mut gauge = Gauge::new(2);
        gauge.push(&[1.0, 1.0]);
        assert!(gauge.represent(&[1.0, -1.0], OPTIMUM).total > 1e6);
        assert!((gauge.represent(&[2.0, 2.0], OPTIMUM).total - 2.0).abs() < 1e-9);
    }

    #[test]
    fn limits_stop_the_search_on_the_right_side() {
        let limits = Limits { inside: 0.99, outside: 1.01 };
        assert!(square().represent(&[0.5, 0.2], limits).total <= 0.99);
        assert!(square().represent(&[1.5, 0.2], limits).total > 1.01);
    }
}
