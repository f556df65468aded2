//! Derivations: the recorded steps that lead to a mask, and their replay.

use refinable_algebra::{Integer, Laurent, ParameterPolynomial, Rational, Ring, integer};

use crate::diagnostic::Diagnostic;
use crate::displacement::{displaced, extended, initial, restricted};
use crate::mask::Mask;

/// The displacement vectors `C_{2i,N+1}` and `C_{2i+1,N+1}` as combinations of control points:
/// the coefficient of `x^j` is the weight of `f_{i+j}`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Vectors {
    /// `C_{2i,N+1}`.
    pub vertex: Laurent<Rational>,
    /// `C_{2i+1,N+1}`.
    pub edge: Laurent<Rational>,
}

/// The new points `f_{2i,N+1}` and `f_{2i+1,N+1}` as combinations of control points: the coefficient
/// of `x^j` is the weight of `f_{i+j}`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Points {
    /// `f_{2i,N+1}`.
    pub vertex: Laurent<ParameterPolynomial>,
    /// `f_{2i+1,N+1}`.
    pub edge: Laurent<ParameterPolynomial>,
}

/// One of the weights that extend an edge rule: `sign · quotient · binomial · beta (1 - alpha)` at
/// `f_{i+j+1}`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Weight {
    /// The index `j`, from `-N-2` to `N+1`.
    pub j: i64,
    /// `(-1)^(j+N+1)`; 1 at both ends.
    pub sign: i64,
    /// `(2j+1)/(N-j+1)`; 1 at both ends.
    pub quotient: Rational,
    /// `C(2N+2, N+j+2)`; 1 at both ends.
    pub binomial: Integer,
}

impl Weight {
    /// `sign · quotient · binomial`.
    pub fn value(&self) -> Rational {
        let scale = Rational::from(&self.binomial * integer(self.sign));
        &self.quotient * scale
    }
}

/// A step of a derivation, with all that it produced.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Step {
    /// `N = 0`: equations (1) and (3).
    Initial {
        /// `f_{2i,1}` and `f_{2i+1,1}`.
        points: Points,
        /// `C_{2i,1}` and `C_{2i+1,1}`.
        vectors: Vectors,
    },
    /// `N ≥ 1`: the points move along the vectors, equations (vec-C) and (scheme).
    Displacement {
        /// `N`.
        n: u32,
        /// `(1/N)(N/4 - 1/8)`.
        factor: Rational,
        /// `C_{2i,N+1}` and `C_{2i+1,N+1}`.
        vectors: Vectors,
        /// `f_{2i,N+1}` and `f_{2i+1,N+1}`.
        points: Points,
    },
    /// The edge rule gains `2N+4` weights, equations (weights) and (b2j+1).
    Extension {
        /// `N`.
        n: u32,
        /// The weights, `j` ascending.
        weights: Vec<Weight>,
        /// The points with the weights added.
        points: Points,
    },
    /// `alpha = 0`.
    Restriction {
        /// `N`.
        n: u32,
        /// The points at `alpha = 0`.
        points: Points,
    },
}

/// The recorded steps that lead to a mask.
///
/// ```
/// use refinable_scheme::even_family;
/// let derivation = even_family(1);
/// assert!(derivation.steps()[1].to_string().contains(
///     "C_{2i,2} = (C_{2i,1} - C_{2(i+1),1}) + (C_{2i,1} - C_{2(i-1),1})\n\
///     \u{20}        = -f_{i-2} + 3*f_{i-1} - 4*f_i + 3*f_{i+1} - f_{i+2}"
/// ));
/// assert_eq!(derivation.replay().unwrap().support(), (-4, 4));
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Derivation {
    steps: Vec<Step>,
}

impl Derivation {
    /// The derivation with these steps, not yet checked.
    pub fn from_steps(steps: Vec<Step>) -> Self {
        Derivation { steps }
    }

    /// The recorded steps.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The mask of the last step, unchecked.
    ///
    /// # Errors
    /// `derivation` if there is no step, `zero-mask`.
    pub fn mask(&self) -> Result<Mask, Diagnostic> {
        match self.steps.last() {
            Some(last) => last.points().mask(),
            None => Err(Diagnostic::new("derivation", "a derivation without steps")),
        }
    }

    /// Recomputes every step from the recorded one before it and returns the mask of the last.
    ///
    /// # Errors
    /// `derivation` if a step is not the one that follows, naming what differs.
    pub fn replay(&self) -> Result<Mask, Diagnostic> {
        let mut previous = None;
        for (index, step) in self.steps.iter().enumerate() {
            let wrong = |what: &str| {
                let message = format!("step {index} of the derivation: {what}");
                Err(Diagnostic::new("derivation", message))
            };
            let Some(expected) = step.recomputed(previous) else {
                return wrong("it cannot follow the step before it");
            };
            if let Some(part) = step.difference(&expected) {
                return wrong(&format!("the recorded {part} are not those that follow"));
            }
            previous = Some(step);
        }
        self.mask()
    }
}

impl Step {
    /// `N`.
    pub fn n(&self) -> u32 {
        match self {
            Step::Initial { .. } => 0,
            Step::Displacement { n, .. }
            | Step::Extension { n, .. }
            | Step::Restriction { n, .. } => *n,
        }
    }

    /// The new points after this step.
    pub fn points(&self) -> &Points {
        match self {
            Step::Initial { points, .. }
            | Step::Displacement { points, .. }
            | Step::Extension { points, .. }
            | Step::Restriction { points, .. } => points,
        }
    }

    /// The displacement vectors of this step; only the recursion itself has them.
    pub fn vectors(&self) -> Option<&Vectors> {
        match self {
            Step::Initial { vectors, .. } | Step::Displacement { vectors, .. } => Some(vectors),
            Step::Extension { .. } | Step::Restriction { .. } => None,
        }
    }

    /// What this step should be after `previous`; `None` if such a step cannot come there.
    fn recomputed(&self, previous: Option<&Step>) -> Option<Step> {
        match (self, previous) {
            (Step::Initial { .. }, None) => Some(initial()),
            (Step::Displacement { n, .. }, Some(before))
                if n.checked_sub(1) == Some(before.n()) =>
            {
                displaced(before, *n)
            }
            (Step::Extension { n, .. }, Some(before)) if before.n() == *n => {
                before.vectors().map(|_| extended(before))
            }
            (Step::Restriction { n, .. }, Some(before @ Step::Extension { .. })) => {
                (before.n() == *n).then(|| restricted(before))
            }
            _ => None,
        }
    }

    /// The first part in which two steps of one kind differ.
    fn difference(&self, expected: &Step) -> Option<&'static str> {
        if let (Step::Displacement { factor: a, .. }, Step::Displacement { factor: b, .. }) =
            (self, expected)
            && a != b
        {
            return Some("factors");
        }
        if let (Step::Extension { weights: a, .. }, Step::Extension { weights: b, .. }) =
            (self, expected)
            && a != b
        {
            return Some("weights");
        }
        if self.vectors() != expected.vectors() {
            return Some("displacement vectors");
        }
        (self != expected).then_some("points")
    }
}

impl Points {
    /// The binary mask of the two rules: `f_{i+j}` has the weight `a_{-2j}` in `f'_{2i}` and
    /// `a_{1-2j}` in `f'_{2i+1}`.
    fn mask(&self) -> Result<Mask, Diagnostic> {
        let vertex = self.vertex.dilated(2).reversed();
        let edge = self.edge.dilated(2).reversed().shifted(1);
        Mask::from_symbol(2, vertex.plus(&edge))
    }
}
