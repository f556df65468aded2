//! Three families of binary schemes by their recursion of displacement vectors.
//!
//! Source: R. Hameed, G. Mustafa, *Recursive process for constructing the refinement rules of new
//! combined subdivision schemes and its extended form*, Section 3. The equations go by the labels
//! of its LaTeX text: (1), (3), (vec-C), (scheme) make the `(2N+2)`-point family, (weights) and
//! (b2j+1) the `(2N+3)`-point one, `alpha = 0` in that the interpolatory `(2N+4)`-point one.
//!
//! The recursion is computed as it stands; the closed forms it collapses to are left to the tests.

use refinable_algebra::{
    Integer, Laurent, Parameter, ParameterPolynomial, Rational, Ring, binomial, clear_denominators,
    rational,
};

use crate::derivation::{Derivation, Points, Step, Vectors, Weight};

/// The scheme `S_{a_{2N+2}}` with the parameter `alpha`.
///
/// # Cost
/// `O(N²)` rational operations.
pub fn even_family(n: u32) -> Derivation {
    let mut steps = vec![initial()];
    for k in 1..=n {
        let previous = steps.last().expect("there is a first step");
        let next = displaced(previous, k).expect("displacements follow the first step");
        steps.push(next);
    }
    Derivation::from_steps(steps)
}

/// The scheme `S_{a_{2N+3}}` with the parameters `alpha` and `beta`.
///
/// # Cost
/// `O(N²)` rational operations.
pub fn odd_family(n: u32) -> Derivation {
    followed(&even_family(n), extended)
}

/// The interpolatory scheme `S_{a^I_{2N+4}}` with the parameter `beta`: `S_{a_{2N+3}}` at
/// `alpha = 0`.
///
/// # Cost
/// `O(N²)` rational operations.
pub fn interpolatory_family(n: u32) -> Derivation {
    followed(&odd_family(n), restricted)
}

/// The derivation with one step more.
fn followed(derivation: &Derivation, next: fn(&Step) -> Step) -> Derivation {
    let mut steps = derivation.steps().to_vec();
    let last = steps.last().expect("there is a first step");
    steps.push(next(last));
    Derivation::from_steps(steps)
}

/// Equations (1) and (3).
pub(crate) fn initial() -> Step {
    let second_difference = combination(-1, &[1, -2, 1]);
    let midpoint = combination(0, &[1, 1]).scaled(&rational(1, 2));
    Step::Initial {
        points: Points {
            vertex: Laurent::one().plus(&times_alpha(&second_difference)),
            edge: without_parameters(&midpoint),
        },
        vectors: Vectors { vertex: combination(-1, &[1, -1, 1]), edge: midpoint },
    }
}

/// Equations (vec-C) and (scheme); `None` if the step before has no vectors.
pub(crate) fn displaced(before: &Step, n: u32) -> Option<Step> {
    let vectors = before.vectors()?;
    let n_rational = rational(n.into(), 1);
    let factor = (&n_rational / rational(4, 1) - rational(1, 8)) / &n_rational;
    let vectors = Vectors {
        vertex: turned(&vectors.vertex, &Rational::one()),
        edge: turned(&vectors.edge, &factor),
    };
    let points = Points {
        vertex: before.points().vertex.plus(&times_alpha(&vectors.vertex)),
        edge: before.points().edge.plus(&without_parameters(&vectors.edge)),
    };
    Some(Step::Displacement { n, factor, vectors, points })
}

/// `factor · ((C_i - C_{i+1}) + (C_i - C_{i-1}))`, in integers over one denominator.
fn turned(vector: &Laurent<Rational>, factor: &Rational) -> Laurent<Rational> {
    let (common, cleared) = clear_denominators(vector.coefficients().iter());
    let vector = Laurent::new(vector.lowest(), cleared);
    let to_next = vector.minus(&vector.shifted(1));
    let to_previous = vector.minus(&vector.shifted(-1));
    let denominator = common * factor.denom();
    to_next.plus(&to_previous).map(|c| Rational::new(c * factor.numer(), denominator.clone()))
}

/// Equations (weights) and (b2j+1).
pub(crate) fn extended(before: &Step) -> Step {
    let n = before.n();
    let weights = extension_weights(n);
    let values = weights.iter().map(Weight::value).collect();
    let added = Laurent::new(-i64::from(n) - 1, values);
    let Points { vertex, edge } = before.points().clone();
    Step::Extension {
        n,
        weights,
        points: Points {
            vertex,
            edge: edge.plus(&without_parameters(&added).scaled(&edge_weight())),
        },
    }
}

/// The weights for `j = -N-2, …, N+1`.
fn extension_weights(n: u32) -> Vec<Weight> {
    let top = i64::from(n);
    let end = |j| Weight { j, sign: 1, quotient: Rational::one(), binomial: Integer::one() };
    let inner = (-top - 1..=top).map(|j| Weight {
        j,
        sign: if (j + top + 1) % 2 == 0 { 1 } else { -1 },
        quotient: rational(2 * j + 1, top - j + 1),
        binomial: binomial(2 * n + 2, (top + j + 2) as u32),
    });
    std::iter::once(end(-top - 2)).chain(inner).chain(std::iter::once(end(top + 1))).collect()
}

/// The rules at `alpha = 0`.
pub(crate) fn restricted(before: &Step) -> Step {
    let zero = Rational::zero();
    let at_zero = |rule: &Laurent<ParameterPolynomial>| rule.map(|c| c.with(&alpha(), &zero));
    Step::Restriction {
        n: before.n(),
        points: Points {
            vertex: at_zero(&before.points().vertex),
            edge: at_zero(&before.points().edge),
        },
    }
}

fn alpha() -> Parameter {
    Parameter::new("alpha")
}

/// `beta (1 - alpha)`.
fn edge_weight() -> ParameterPolynomial {
    let alpha = ParameterPolynomial::parameter(&alpha());
    let beta = ParameterPolynomial::parameter(&Parameter::new("beta"));
    beta.times(&ParameterPolynomial::one().minus(&alpha))
}

/// `Σ_k weights[k] f_{i+first+k}`.
fn combination(first: i64, weights: &[i64]) -> Laurent<Rational> {
    Laurent::new(first, weights.iter().map(|&w| rational(w, 1)).collect())
}

fn times_alpha(vector: &Laurent<Rational>) -> Laurent<ParameterPolynomial> {
    let alpha = ParameterPolynomial::parameter(&alpha());
    vector.map(|c| alpha.scaled(c))
}

fn without_parameters(vector: &Laurent<Rational>) -> Laurent<ParameterPolynomial> {
    vector.map(|c| ParameterPolynomial::constant(c.clone()))
}
