//! The gauge of a symmetric polytope, in floats: `‖y‖ = min {Σ|λ_k| : Σ λ_k u_k = y}`.
//!
//! Every set of `d` independent atoms, with signs, is a feasible basis of this linear program, so
//! the primal simplex method needs no first phase and starts where the last question ended.
//!
//! With complex weights each atom stands for a circle of columns `e^(iφ) u`; the dearest phase of each
//! is known in closed form, so that columns are made when they enter the basis.

use nalgebra::Complex;

/// The ball spanned by atoms and, if complex, their conjugates.
///
/// The first atoms are tiny multiples of the unit vectors: they make every vector representable, at
/// a price that shows when a vector is outside the span of the true atoms.
#[derive(Clone, Debug)]
pub(crate) struct Gauge {
    /// The number of real coordinates: real parts first, then imaginary parts if complex.
    size: usize,
    complex: bool,
    /// For each coordinate, that of all atoms: most time goes into products of all atoms with a vector,
    /// which processors do several atoms at a time.
    atoms: Vec<Vec<f64>>,
    basis: Vec<Column>,
    /// Row-major inverse of the matrix with the basic columns.
    inverse: Vec<f64>,
    /// How many products of floats all questions have taken, roughly.
    products: u64,
}

/// A column of the linear program: a phase times an atom.
#[derive(Clone, Debug)]
struct Column {
    atom: Atom,
    /// 1 or -1 if real.
    phase: Complex<f64>,
    vector: Vec<f64>,
    /// With which sign it is used; where its weight is zero the sign still counts.
    sign: f64,
}

/// Which atom: a true one, its conjugate, or a tiny one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Atom {
    /// As it was pushed.
    Plain(usize),
    /// The complex conjugate.
    Conjugate(usize),
    Tiny,
}

/// When a question may be answered before the optimum is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Any representation with a smaller total will do.
    pub inside: f64,
    /// No representation with a smaller total exists: that will do.
    pub outside: f64,
    /// By what part the total may be larger than the least.
    pub accuracy: f64,
}

/// A representation of a vector by atoms.
#[derive(Clone, Debug)]
pub(crate) struct Representation {
    /// Pairs of a true atom and its weight.
    pub weights: Vec<(Atom, Complex<f64>)>,
    /// The sum of absolute weights, tiny atoms included at their price.
    pub total: f64,
}

/// The length of the tiny atoms, against true ones of about 1.
const TINY: f64 = 1e-7;
/// The relative residual beyond which the inverse is computed afresh.
const ACCURACY: f64 = 1e-11;
/// The accuracy that floats can give.
pub(crate) const FINEST: f64 = 1e-10;

impl Gauge {
    /// The gauge without true atoms, for vectors of so many (complex) coordinates.
    pub fn new(dimension: usize, complex: bool) -> Self {
        let size = if complex { 2 * dimension } else { dimension };
        let unit = |i: usize| (0..size).map(|j| if i == j { TINY } else { 0.0 }).collect();
        let column = |i| Column {
            atom: Atom::Tiny,
            phase: Complex::new(1.0, 0.0),
            vector: unit(i),
            sign: 1.0,
        };
        let mut inverse = vec![0.0; size * size];
        inverse.iter_mut().step_by(size + 1).for_each(|x| *x = 1.0 / TINY);
        let atoms = vec![Vec::new(); size];
        let basis = (0..size).map(column).collect();
        Gauge { size, complex, atoms, basis, inverse, products: 0 }
    }

    /// How many products of floats all questions so far have taken, roughly.
    pub fn products(&self) -> u64 {
        self.products
    }

    /// Adds an atom.
    pub fn push(&mut self, atom: &[f64]) {
        self.atoms.iter_mut().zip(atom).for_each(|(all, x)| all.push(*x));
    }

    /// Represents `y` with the least total, or until the limits are met.
    ///
    /// # Cost
    /// Each pivot takes one product of all atoms with a vector.
    pub fn represent(&mut self, y: &[f64], limits: Limits) -> Representation {
        let mut x = self.solve(y);
        for _ in 0..100 * self.size {
            self.products += (self.size * (4 * self.size + self.atoms[0].len())) as u64;
            self.settle_signs(&x);
            let total: f64 = x.iter().map(|x| x.abs()).sum();
            let (atom, price) = self.dearest(&self.dual());
            let lower_bound = total / price.norm().max(1.0);
            if total <= limits.inside
                || lower_bound >= limits.outside
                || price.norm() <= 1.0 + limits.accuracy
                || !self.pivot(atom, price, &x)
            {
                break;
            }
            x = self.solve(y);
        }
        self.representation(&x)
    }

    /// The weights of the true atoms, columns of one atom taken together.
    fn representation(&self, x: &[f64]) -> Representation {
        let mut weights: Vec<(Atom, Complex<f64>)> = Vec::new();
        let mut total = 0.0;
        let mut used: Vec<(Atom, Complex<f64>)> =
            self.basis.iter().zip(x).map(|(column, x)| (column.atom, column.phase * *x)).collect();
        used.sort_by_key(|(atom, _)| *atom);
        for (atom, weight) in used {
            match weights.last_mut() {
                _ if atom == Atom::Tiny => total += weight.norm(),
                Some((last, sum)) if *last == atom => *sum += weight,
                _ => weights.push((atom, weight)),
            }
        }
        weights.retain(|(_, weight)| weight.norm() != 0.0);
        total += weights.iter().map(|(_, weight)| weight.norm()).sum::<f64>();
        Representation { weights, total }
    }

    /// The weights of the basic columns for `y`, from a fresh inverse if rounding errors have grown.
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
        for (column, x) in self.basis.iter().zip(x) {
            rest.iter_mut().zip(&column.vector).for_each(|(r, u)| *r -= x * u);
        }
        norm(&rest)
    }

    fn times_inverse(&self, y: &[f64]) -> Vec<f64> {
        self.inverse.chunks_exact(self.size).map(|row| dot(row, y)).collect()
    }

    /// Takes the signs of the weights, but keeps those of weights that are zero.
    fn settle_signs(&mut self, x: &[f64]) {
        let largest = x.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        for (column, x) in self.basis.iter_mut().zip(x) {
            if x.abs() > 1e-13 * largest {
                column.sign = x.signum();
            }
        }
    }

    /// The functional that is the sign on each basic column.
    fn dual(&self) -> Vec<f64> {
        let mut dual = vec![0.0; self.size];
        for (row, column) in self.inverse.chunks_exact(self.size).zip(&self.basis) {
            dual.iter_mut().zip(row).for_each(|(y, r)| *y += column.sign * r);
        }
        dual
    }

    /// The atom `u` on which the functional `f` is largest in modulus, and `f(u) - i f(iu)`: its
    /// modulus is the largest `f(e^(iφ) u)`, and its conjugate has the direction of that phase.
    fn dearest(&self, dual: &[f64]) -> (Atom, Complex<f64>) {
        let mut best = (Atom::Tiny, Complex::new(0.0, 0.0));
        let mut largest = 0.0;
        let mut offer = |atom, price: Complex<f64>| {
            if price.norm_sqr() > largest {
                largest = price.norm_sqr();
                best = (atom, price);
            }
        };
        if !self.complex {
            for (k, price) in products(dual, &self.atoms).into_iter().enumerate() {
                offer(Atom::Plain(k), Complex::new(price, 0.0));
            }
            return best;
        }
        let (dual_re, dual_im) = dual.split_at(self.size / 2);
        let (re, im) = self.atoms.split_at(self.size / 2);
        let (a, b) = (products(dual_re, re), products(dual_im, im));
        let (c, e) = (products(dual_re, im), products(dual_im, re));
        for k in 0..a.len() {
            // f(iu) = dual_im · re - dual_re · im; the conjugate has the other sign of im.
            offer(Atom::Plain(k), Complex::new(a[k] + b[k], c[k] - e[k]));
            offer(Atom::Conjugate(k), Complex::new(a[k] - b[k], -c[k] - e[k]));
        }
        best
    }

    /// Exchanges a basic column, by the ratio test, for the dearest phase of the entering atom.
    fn pivot(&mut self, atom: Atom, price: Complex<f64>, x: &[f64]) -> bool {
        let phase = price.conj() / price.norm();
        let vector = self.column(atom, phase);
        let direction = self.times_inverse(&vector);
        let least_speed = 1e-9 * direction.iter().fold(0.0, |a: f64, w| a.max(w.abs()));
        let mut leaving: Option<(usize, f64, f64)> = None;
        for (i, (x, w)) in x.iter().zip(&direction).enumerate() {
            let speed = w * self.basis[i].sign;
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
        self.exchange(row, &direction);
        self.basis[row] = Column { atom, phase, vector, sign: 1.0 };
        true
    }

    /// A number, real unless the gauge is complex, times a true atom.
    pub fn column(&self, atom: Atom, factor: Complex<f64>) -> Vec<f64> {
        let (k, sign) = match atom {
            Atom::Plain(k) => (k, 1.0),
            Atom::Conjugate(k) => (k, -1.0),
            Atom::Tiny => unreachable!("tiny atoms only leave"),
        };
        if !self.complex {
            return self.atoms.iter().map(|u| u[k] * factor.re).collect();
        }
        let (re, im) = self.atoms.split_at(self.size / 2);
        let product = |re: &Vec<f64>, im: &Vec<f64>| Complex::new(re[k], sign * im[k]) * factor;
        let parts = || re.iter().zip(im).map(|(re, im)| product(re, im));
        parts().map(|z| z.re).chain(parts().map(|z| z.im)).collect()
    }

    /// Replaces the basic column of a row by one whose coordinates are `direction`.
    fn exchange(&mut self, row: usize, direction: &[f64]) {
        let d = self.size;
        let pivot = direction[row];
        let pivot_row: Vec<f64> =
            self.inverse[row * d..(row + 1) * d].iter().map(|r| r / pivot).collect();
        for (i, target) in self.inverse.chunks_exact_mut(d).enumerate() {
            if i == row {
                target.copy_from_slice(&pivot_row);
            } else {
                let factor = direction[i];
                target.iter_mut().zip(&pivot_row).for_each(|(t, p)| *t -= factor * p);
            }
        }
    }

    /// Computes the inverse afresh, to shed rounding errors.
    fn refactor(&mut self) {
        let d = self.size;
        let basis = nalgebra::DMatrix::from_fn(d, d, |i, j| self.basis[j].vector[i]);
        if let Some(inverse) = basis.try_inverse() {
            self.inverse = inverse.transpose().as_slice().to_vec();
        }
    }
}

/// The products of a functional with all atoms, given by coordinates.
fn products(functional: &[f64], atoms: &[Vec<f64>]) -> Vec<f64> {
    let mut sums = vec![0.0; atoms[0].len()];
    for (f, coordinate) in functional.iter().zip(atoms) {
        sums.iter_mut().zip(coordinate).for_each(|(sum, x)| *sum += f * x);
    }
    sums
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

    const OPTIMUM: Limits = Limits { inside: 0.0, outside: f64::INFINITY, accuracy: FINEST };

    fn square() -> Gauge {
        let mut gauge = Gauge::new(2, false);
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
            assert!(found.weights.iter().all(|(_, weight)| weight.im == 0.0));
        }
    }

    #[test]
    fn outside_the_span_the_price_is_high() {
        let mut gauge = Gauge::new(2, false);
        gauge.push(&[1.0, 1.0]);
        assert!(gauge.represent(&[1.0, -1.0], OPTIMUM).total > 1e6);
        assert!((gauge.represent(&[2.0, 2.0], OPTIMUM).total - 2.0).abs() < 1e-9);
    }

    #[test]
    fn limits_stop_the_search_on_the_right_side() {
        let limits = Limits { inside: 0.99, outside: 1.01, accuracy: FINEST };
        assert!(square().represent(&[0.5, 0.2], limits).total <= 0.99);
        assert!(square().represent(&[1.5, 0.2], limits).total > 1.01);
    }

    /// The vectors `(1, i)` and `(1, -i)` are orthogonal, so that the gauge of their span is the sum
    /// of the moduli of the coordinates.
    #[test]
    fn a_complex_atom_and_its_conjugate() {
        let mut gauge = Gauge::new(2, true);
        gauge.push(&[1.0, 0.0, 0.0, 1.0]);
        for (y, expected) in [
            ([1.0, 0.0, 0.0, 1.0], 1.0),
            // i (1, i) = (i, -1), and half the sum is real.
            ([0.0, -1.0, 1.0, 0.0], 1.0),
            ([1.0, 0.0, 0.0, 0.0], 1.0),
            ([0.6, 0.8, 0.0, 0.0], 1.0),
            ([1.0, 0.0, 0.0, 0.5], 1.0),
            ([3.0, 0.0, 4.0, 0.0], 5.0),
        ] {
            let found = gauge.represent(&y, OPTIMUM);
            assert!((found.total - expected).abs() < 1e-6, "{y:?}: {found:?}");
        }
    }
}
