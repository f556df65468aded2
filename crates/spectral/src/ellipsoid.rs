//! Ellipsoids that matrices map into each other: the analytic centre of all that do, in floats.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use crate::quadratic::{self, add_square, add_vector, symmetric};

/// Letters of a word that an ellipsoid may know; what they are for is in `docs/certificates.md`.
const MOST_MEMORY: u32 = 3;

/// More ellipsoids the checker refuses.
const MOST_WORDS: usize = 64;

/// Newton's method stops at this decrement on the way,
const ROUGH: f64 = 0.3;
/// and at this one at its end.
const FINE: f64 = 0.02;
const MOST_STEPS: usize = 60;
/// If so much of what the radius is above one remains after a round, words are lengthened.
const SLOW: f64 = 0.8;
/// How many steps are tried in a round.
const TRIALS: usize = 20;

/// The positive definite `Q_s`, one for each word `s` of letters `B`, with `B Q_s B^T ≺ Q_t`, where `t` ends
/// with `B`, that make `Σ tr Q_s - Σ log det (Q_t - B Q_s B^T)` least. It is an analytic function of the
/// letters.
pub(crate) struct Centre {
    graph: Graph,
    /// The `Q_s`.
    pub ellipsoids: Vec<DMatrix<f64>>,
    hessian: Cholesky<f64, Dyn>,
}

/// How words follow each other.
#[derive(Clone, Copy)]
struct Graph {
    letters: usize,
    memory: u32,
    words: usize,
    size: usize,
}

impl Graph {
    fn new(letters: &[DMatrix<f64>], memory: u32) -> Self {
        Graph {
            letters: letters.len(),
            memory,
            words: letters.len().pow(memory),
            size: letters[0].nrows(),
        }
    }

    fn is_deepest(self) -> bool {
        self.memory == MOST_MEMORY || self.words * self.letters > MOST_WORDS
    }

    /// Words that are one letter longer, each with the ellipsoid of its end.
    fn deeper(
        self,
        letters: &[DMatrix<f64>],
        ellipsoids: &[DMatrix<f64>],
    ) -> (Graph, Vec<DMatrix<f64>>) {
        let deeper = Graph::new(letters, self.memory + 1);
        (deeper, (0..deeper.words).map(|word| ellipsoids[word % self.words].clone()).collect())
    }

    /// The words, the letter that comes next, and the words after it.
    fn edges(self) -> impl Iterator<Item = (usize, usize, usize)> {
        (0..self.words).flat_map(move |word| {
            (0..self.letters).map(move |l| (word, l, (word * self.letters + l) % self.words))
        })
    }
}

/// Gradient and Hessian of what is made least.
struct Jet {
    gradient: DVector<f64>,
    hessian: DMatrix<f64>,
}

impl Centre {
    /// The centre for the shortest words for which there are such ellipsoids.
    ///
    /// Starts where radius one is replaced by a larger one, and follows the centre while the radius is
    /// lowered; ellipsoids for short words are a start for longer ones.
    pub fn find(letters: &[DMatrix<f64>]) -> Option<Centre> {
        let mut graph = Graph::new(letters, 0);
        let mut ellipsoids = vec![DMatrix::identity(graph.size, graph.size)];
        let mut radius = (1.05 * graph.radius(letters, &ellipsoids)?).max(1.0);
        while radius > 1.0 {
            let hessian = graph.centre(letters, radius, &mut ellipsoids, ROUGH)?;
            let next = graph.lower(letters, radius, &mut ellipsoids, &hessian)?;
            if next - 1.0 > SLOW * (radius - 1.0) {
                if graph.is_deepest() {
                    return None;
                }
                (graph, ellipsoids) = graph.deeper(letters, &ellipsoids);
            }
            radius = next;
        }
        let hessian = graph.centre(letters, 1.0, &mut ellipsoids, FINE)?;
        Some(Centre { graph, ellipsoids, hessian })
    }

    /// The length of the words.
    pub fn memory(&self) -> u32 {
        self.graph.memory
    }

    /// The square of the norm of a letter with respect to the ellipsoids: the largest, up to rounding.
    pub fn radius(&self, letters: &[DMatrix<f64>]) -> f64 {
        self.graph.radius(letters, &self.ellipsoids).unwrap_or(1.0)
    }

    /// The centre for words that are one letter longer.
    pub fn deeper(&self, letters: &[DMatrix<f64>]) -> Option<Centre> {
        if self.graph.is_deepest() {
            return None;
        }
        let (graph, mut ellipsoids) = self.graph.deeper(letters, &self.ellipsoids);
        let hessian = graph.centre(letters, 1.0, &mut ellipsoids, FINE)?;
        Some(Centre { graph, ellipsoids, hessian })
    }

    /// The derivative of the centre in a direction, by that of the gradient: half its difference at two
    /// opposite places nearby.
    pub fn slope(
        &self,
        ahead: &[DMatrix<f64>],
        behind: &[DMatrix<f64>],
    ) -> Option<Vec<DMatrix<f64>>> {
        let gradient = |letters| Some(self.graph.jet(letters, 1.0, &self.ellipsoids)?.gradient);
        let change = (gradient(ahead)? - gradient(behind)?) * 0.5;
        Some(self.graph.matrices(&-self.hessian.solve(&change)))
    }
}

impl Graph {
    /// The least square of a radius in place of one.
    fn radius(self, letters: &[DMatrix<f64>], ellipsoids: &[DMatrix<f64>]) -> Option<f64> {
        let roots: Vec<DMatrix<f64>> = ellipsoids
            .iter()
            .map(|q| Some(q.clone().cholesky()?.unpack()))
            .collect::<Option<_>>()?;
        let of = |(from, letter, to): (usize, usize, usize)| {
            let image = roots[to].solve_lower_triangular(&(&letters[letter] * &roots[from]))?;
            Some((&image * image.transpose()).symmetric_eigenvalues().max())
        };
        self.edges().map(of).try_fold(0.0, |largest: f64, r| Some(largest.max(r?)))
    }

    /// Moves ellipsoids from the centre for a radius along the tangent of the curve of centres, as far as
    /// is allowed and at most to radius one; returns the radius there.
    fn lower(
        self,
        letters: &[DMatrix<f64>],
        radius: f64,
        ellipsoids: &mut [DMatrix<f64>],
        hessian: &Cholesky<f64, Dyn>,
    ) -> Option<f64> {
        let gradient = |radius: f64| Some(self.jet(letters, radius, ellipsoids)?.gradient);
        let step = 1e-5 * radius;
        let change = (gradient(radius + step)? - gradient(radius - step)?) / (2.0 * step);
        let slope = self.matrices(&-hessian.solve(&change));
        let moved = |to: f64| -> Vec<DMatrix<f64>> {
            ellipsoids.iter().zip(&slope).map(|(q, d)| q + d * (to - radius)).collect()
        };
        let allowed =
            |to: &f64| self.edges().all(|edge| slack(letters, *to, &moved(*to), edge).is_some());
        let parts = std::iter::successors(Some(1.0), |part| Some(0.7 * part)).take(TRIALS);
        let part = parts.map(|part| (part, radius.powf(1.0 - part))).find(|(_, to)| allowed(to));
        let (part, to) = part?;
        // Not quite as far as is possible.
        let to = if part < 1.0 { radius.powf(1.0 - 0.9 * part) } else { to };
        let next = moved(to);
        ellipsoids.clone_from_slice(&next);
        Some(to)
    }

    /// Moves ellipsoids to the centre; returns the Hessian there.
    fn centre(
        self,
        letters: &[DMatrix<f64>],
        radius: f64,
        ellipsoids: &mut [DMatrix<f64>],
        accuracy: f64,
    ) -> Option<Cholesky<f64, Dyn>> {
        // At the centre the sum of the traces is the sum of the ranks.
        let traces: f64 = ellipsoids.iter().map(DMatrix::trace).sum();
        let scale = (self.words * self.letters * self.size) as f64 / traces;
        ellipsoids.iter_mut().for_each(|q| *q *= scale);
        for _ in 0..MOST_STEPS {
            let Jet { gradient, hessian } = self.jet(letters, radius, ellipsoids)?;
            let hessian = hessian.cholesky()?;
            let step = -hessian.solve(&gradient);
            let decrement = (-gradient.dot(&step)).max(0.0).sqrt();
            let step = self.matrices(&step);
            let moved = |part: f64| -> Vec<DMatrix<f64>> {
                ellipsoids.iter().zip(&step).map(|(q, d)| q + d * part).collect()
            };
            // The whole Newton step, or less of it, but not less than what is known to be safe.
            let safe = 1.0 / (1.0 + decrement);
            let bold = std::iter::successors(Some(1.0), |part| Some(0.6 * part));
            let bold = bold.take_while(|part| *part > safe).find(|&part| {
                self.edges().all(|edge| slack(letters, radius, &moved(part), edge).is_some())
            });
            let part = match bold {
                Some(1.0) => 1.0,
                Some(part) => (0.9 * part).max(safe),
                None if decrement < ROUGH => 1.0,
                None => safe,
            };
            let next = moved(part);
            ellipsoids.clone_from_slice(&next);
            if decrement < accuracy {
                return Some(hessian);
            }
        }
        None
    }

    /// The derivatives of `Σ tr Q_s - Σ log det M`, `M = radius Q_t - B Q_s B^T`, in orthonormal coordinates
    /// of the `Q_s`; `None` where an `M` is not positive definite.
    ///
    /// With `P = M^-1`: in the directions `F`, `G` of `Q_t` the second derivative is `radius² tr(P F P G)`;
    /// in those of `Q_s` the same with `B^T P B` in place of `P`; in one of each with `P B`.
    fn jet(
        self,
        letters: &[DMatrix<f64>],
        radius: f64,
        ellipsoids: &[DMatrix<f64>],
    ) -> Option<Jet> {
        let n = quadratic::coordinates(self.size);
        let identity = DMatrix::identity(self.size, self.size);
        let mut gradient = DVector::zeros(n * self.words);
        let mut hessian = DMatrix::zeros(n * self.words, n * self.words);
        for word in 0..self.words {
            add_vector(&mut gradient, word * n, 1.0, &identity);
        }
        for (from, letter, to) in self.edges() {
            let b = &letters[letter];
            let p = slack(letters, radius, ellipsoids, (from, letter, to))?.inverse();
            let pb = &p * b;
            let bpb = b.transpose() * &pb;
            let (from, to) = (from * n, to * n);
            add_vector(&mut gradient, to, -radius, &p);
            add_vector(&mut gradient, from, 1.0, &bpb);
            add_square(&mut hessian, [to, to], radius * radius, &p);
            add_square(&mut hessian, [from, from], 1.0, &bpb);
            add_square(&mut hessian, [to, from], -radius, &pb);
            add_square(&mut hessian, [from, to], -radius, &pb.transpose());
        }
        Some(Jet { gradient, hessian })
    }

    /// The symmetric matrices with the given coordinates.
    fn matrices(self, coordinates: &DVector<f64>) -> Vec<DMatrix<f64>> {
        let all = coordinates.as_slice().chunks_exact(quadratic::coordinates(self.size));
        all.map(|form| symmetric(form, self.size)).collect()
    }
}

/// The factor of `radius Q_t - B Q_s B^T`, if it is positive definite.
fn slack(
    letters: &[DMatrix<f64>],
    radius: f64,
    ellipsoids: &[DMatrix<f64>],
    (from, letter, to): (usize, usize, usize),
) -> Option<Cholesky<f64, Dyn>> {
    let b = &letters[letter];
    (&ellipsoids[to] * radius - b * &ellipsoids[from] * b.transpose()).cholesky()
}
