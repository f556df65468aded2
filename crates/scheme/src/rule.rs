//! Rules: what a program applies to refine a polygon.

use refinable_algebra::{ParameterFraction, ParameterPolynomial};

use crate::diagnostic::Diagnostic;
use crate::mask::Mask;

/// The weights of one new point: `f'_{mi+ε} = Σ_j w_j f_{i+j}` with `w_{first+k} = weights[k]`.
///
/// In terms of the mask `w_j = a_{ε-mj}`: the stencil reads its residue class backwards. Neither the
/// first nor the last weight is zero; the zero stencil has no weights and `first = 0`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stencil {
    first: i64,
    weights: Vec<ParameterFraction>,
}

/// All stencils of a scheme, `ε = 0, …, m-1`: the rule of one refinement step.
///
/// ```
/// use refinable_scheme::Scheme;
/// let chaikin = Scheme::resolve("bspline2", 2).unwrap();
/// let rule = chaikin.mask().rule();
/// let [vertex, edge] = rule.stencils() else { panic!("binary") };
/// assert_eq!((vertex.first(), vertex.weights()[0].to_string()), (0, "3/4".to_string()));
/// assert_eq!((edge.first(), edge.weights()[0].to_string()), (0, "1/4".to_string()));
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Rule {
    stencils: Vec<Stencil>,
}

impl Stencil {
    /// The stencil with `w_{first+k} = weights[k]`; zeros at both ends are cut.
    pub fn new(first: i64, mut weights: Vec<ParameterFraction>) -> Self {
        let is_zero = |w: &ParameterFraction| w.numerator().terms().len() == 0;
        while weights.last().is_some_and(is_zero) {
            weights.pop();
        }
        let zeros = weights.iter().take_while(|w| is_zero(w)).count();
        weights.drain(..zeros);
        Stencil { first: if weights.is_empty() { 0 } else { first + zeros as i64 }, weights }
    }

    /// The offset `j` of the first weight; 0 for the zero stencil.
    pub fn first(&self) -> i64 {
        self.first
    }

    /// The weights from `first()` on.
    pub fn weights(&self) -> &[ParameterFraction] {
        &self.weights
    }

    /// The sum of the weights; 1 in every stencil of a scheme that converges.
    pub fn sum(&self) -> ParameterFraction {
        let zero = ParameterFraction::from(ParameterPolynomial::default());
        self.weights.iter().fold(zero, |sum, w| sum.plus(w))
    }

    /// The pairs `(j, w_j)`, ascending.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (i64, &ParameterFraction)> {
        self.weights.iter().enumerate().map(|(k, w)| (self.first + k as i64, w))
    }
}

impl Rule {
    /// The rule with the stencils of `f'_{mi}, f'_{mi+1}, …, f'_{mi+m-1}`.
    pub fn new(stencils: Vec<Stencil>) -> Self {
        Rule { stencils }
    }

    /// The number of stencils.
    pub fn arity(&self) -> usize {
        self.stencils.len()
    }

    /// The stencils, `ε` ascending from 0.
    pub fn stencils(&self) -> &[Stencil] {
        &self.stencils
    }

    /// The mask of the rule: `a_{ε-mj} = w_j`.
    ///
    /// # Errors
    /// `arity` for fewer than two stencils, `zero-mask` if all of them are zero, `budget`.
    pub fn mask(&self) -> Result<Mask, Diagnostic> {
        let arity = self.arity() as i64;
        let entries: Vec<_> = (0..arity)
            .zip(&self.stencils)
            .flat_map(|(e, stencil)| stencil.terms().map(move |(j, w)| (e - arity * j, w)))
            .collect();
        let lowest = entries.iter().map(|(i, _)| *i).min().unwrap_or(0);
        let highest = entries.iter().map(|(i, _)| *i).max().unwrap_or(-1);
        let zero = ParameterFraction::from(ParameterPolynomial::default());
        let mut coefficients = vec![zero; (highest - lowest + 1) as usize];
        for (i, w) in entries {
            coefficients[(i - lowest) as usize] = w.clone();
        }
        Mask::new(self.arity(), lowest, &coefficients)
    }
}

impl Mask {
    /// The rule of the mask: the stencils `w_j = a_{ε-mj}`.
    pub fn rule(&self) -> Rule {
        let arity = self.arity() as i64;
        let (lowest, highest) = self.support();
        let stencil = |e: i64| {
            // a_{ε-mj} lies in the support for these j.
            let first = (e - highest).div_euclid(arity);
            let last = (e - lowest).div_euclid(arity);
            let weights = (first..=last).map(|j| self.coefficient(e - arity * j));
            Stencil::new(first, weights.collect())
        };
        Rule::new((0..arity).map(stencil).collect())
    }
}
