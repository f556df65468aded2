//! How a body must move, to first order, whose vertices are mapped to vertices.
//!
//! At an end where a finite group permutes vertices, no image of these is inside the body. Away from
//! the end all images must be, and how they change is known: `B(x) u = B(x_1) u + D u` for a small
//! matrix `D`. If the vertices move to `u_k + h_k` and `B_ε(x_1) u_k = ±u_j`, the image is inside, up
//! to terms of second order, if `D_ε u_k + B_ε(x_1) h_k ∓ h_j` points from `±u_j` into the body. That is
//! a linear program for all the `h`.

use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};
use nalgebra::DMatrix;

use crate::body::{Body, Ends, apply, scaled};

/// How far a vertex may move, against the change of the matrices.
const FARTHEST: f64 = 100.0;

/// The displacements of all vertices for which the images are deepest inside; `None` if some will not
/// be inside. Vertices of which no image is a vertex stay where they are.
pub(crate) fn drift(body: &Body, ends: &Ends) -> Option<Vec<Vec<f64>>> {
    let change: Vec<DMatrix<f64>> = ends.inner.iter().zip(ends.end).map(|(a, b)| a - b).collect();
    let size = change.iter().map(|m| m.amax()).fold(0.0, f64::max);
    let mut program = Program::new(body);
    for vertex in 0..body.vertices.len() {
        for (letter, change) in change.iter().enumerate() {
            if let Some((atom, sign)) = body.met(ends, vertex, letter) {
                let pull = scaled(&apply(change, &body.vertices[vertex]), 1.0 / size);
                program.meet(vertex, &ends.end[letter], (atom, f64::from(sign)), &pull);
            }
        }
    }
    let solution = program.problem.solve().ok()?.into_solution().ok()?;
    let of = |h: &Vec<Variable>| h.iter().map(|x| solution[*x] * size).collect();
    (solution[program.depth] > 0.0).then(|| program.motion.iter().map(of).collect())
}

/// The linear program: the largest `s` such that every image that meets a vertex moves inside at the
/// rate `s` at least.
struct Program<'a> {
    body: &'a Body,
    /// All vertices with their mirror images.
    atoms: Vec<Vec<f64>>,
    problem: Problem,
    depth: Variable,
    /// The coordinates of `h_k`.
    motion: Vec<Vec<Variable>>,
}

impl<'a> Program<'a> {
    fn new(body: &'a Body) -> Self {
        let mut problem = Problem::new(OptimizationDirection::Maximize);
        let depth = problem.add_var(1.0, (0.0, 1.0));
        let mut coordinates = |v: &Vec<f64>| -> Vec<Variable> {
            v.iter().map(|_| problem.add_var(0.0, (-FARTHEST, FARTHEST))).collect()
        };
        let motion = body.vertices.iter().map(&mut coordinates).collect();
        Program { body, atoms: body.atoms(), problem, depth, motion }
    }

    /// Demands `pull + B h_k - sign h_j = -s sign u_j + Σ μ_i (±u_i - sign u_j)` with `μ ≥ 0`.
    fn meet(&mut self, vertex: usize, matrix: &DMatrix<f64>, met: (usize, f64), pull: &[f64]) {
        let (atom, sign) = met;
        let corner = scaled(&self.atoms[atom], sign);
        let others: Vec<Vec<f64>> = (0..self.atoms.len())
            .flat_map(|i| [(i, 1.0), (i, -1.0)])
            .filter(|&other| other != met)
            .map(|(i, sign)| {
                let to = self.atoms[i].iter().map(|x| x * sign);
                to.zip(&corner).map(|(x, c)| x - c).collect()
            })
            .collect();
        let weights: Vec<Variable> =
            others.iter().map(|_| self.problem.add_var(0.0, (0.0, f64::INFINITY))).collect();
        let (target, mirror) = self.body.vertex_of(atom);
        let d = pull.len();
        for row in 0..d {
            let along = |j: usize| if mirror { self.motion[target][d - 1 - j] } else { self.motion[target][j] };
            let mut terms: Vec<(Variable, f64)> =
                (0..d).map(|j| (self.motion[vertex][j], matrix[(row, j)])).collect();
            terms.push((along(row), -sign));
            terms.push((self.depth, corner[row]));
            terms.extend(weights.iter().zip(&others).map(|(w, v)| (*w, -v[row])));
            self.problem.add_constraint(sum(terms), ComparisonOp::Eq, -pull[row]);
        }
    }
}

/// Terms of the same variable taken together.
fn sum(mut terms: Vec<(Variable, f64)>) -> Vec<(Variable, f64)> {
    terms.sort_by_key(|(variable, _)| variable.idx());
    let mut sums: Vec<(Variable, f64)> = Vec::new();
    for (variable, factor) in terms {
        match sums.last_mut() {
            Some((last, total)) if *last == variable => *total += factor,
            _ => sums.push((variable, factor)),
        }
    }
    sums.retain(|(_, factor)| *factor != 0.0);
    sums
}
