//! Rules in numbers.

use std::ops::Range;

use refinable_algebra::{ParameterFraction, Rational, Ring, bit_length, clear_denominators};
use refinable_scheme::{Diagnostic, Normalised};

use crate::coordinate::Coordinate;

/// The most levels: even a single point makes more than `2^48` by then.
const MOST_LEVELS: u32 = 48;

/// The weights of one new point: `f'_{mi+ε} = Σ_k weights[k] f_{i+first+k}`.
#[derive(Clone, PartialEq, Debug)]
pub struct Stencil<T> {
    pub(crate) first: i64,
    pub(crate) weights: Vec<T>,
}

impl<T> Stencil<T> {
    /// The offset of the first weight.
    pub fn first(&self) -> i64 {
        self.first
    }

    /// The weights from `first()` on.
    pub fn weights(&self) -> &[T] {
        &self.weights
    }

    /// One more than the offset of the last weight.
    pub(crate) fn end(&self) -> i64 {
        self.first + self.weights.len() as i64
    }
}

/// The rule of one step without parameters: as many stencils as new points stand for an old one.
///
/// A rule of one stencil replaces every point by a combination of its neighbours, as limit stencils
/// do.
#[derive(Clone, PartialEq, Debug)]
pub struct Weights<T> {
    pub(crate) stencils: Vec<Stencil<T>>,
    shift: Rational,
    denominator_bits: u64,
}

impl<T: Coordinate> Weights<T> {
    /// The rule of a mask.
    ///
    /// # Errors
    /// Code `parameters` if the mask has some.
    pub fn new(mask: &Normalised) -> Result<Self, Diagnostic> {
        let exact = constant_coefficients(mask)?;
        let rule = mask.rule();
        let stencil = |s: &refinable_scheme::Stencil| Stencil {
            first: s.first(),
            weights: s.weights().iter().filter_map(ParameterFraction::as_constant).collect(),
        };
        let stencils = rule.stencils().iter().map(stencil).collect();
        // τ = a'(1)/m; Conti and Hormann 2011.
        let moment: Rational =
            exact.iter().map(|(i, a)| Rational::from_i64(*i) * a).sum::<Rational>();
        Ok(Weights::of(stencils, moment / Rational::from_i64(mask.arity() as i64)))
    }

    /// The rule of these stencils, in which the new point `i` stands at `(i - shift)/m` between the
    /// old points `0, 1, …`.
    pub(crate) fn of(stencils: Vec<Stencil<Rational>>, shift: Rational) -> Self {
        let all = stencils.iter().flat_map(|s| &s.weights);
        let denominator_bits = bit_length(&clear_denominators(all).0);
        let convert = |s: &Stencil<Rational>| Stencil {
            first: s.first,
            weights: s.weights.iter().map(T::from_rational).collect(),
        };
        Weights { stencils: stencils.iter().map(convert).collect(), shift, denominator_bits }
    }

    /// How many new points stand for an old one.
    pub fn arity(&self) -> usize {
        self.stencils.len()
    }

    /// The stencils of `f'_{mi}, f'_{mi+1}, …`.
    pub fn stencils(&self) -> &[Stencil<T>] {
        &self.stencils
    }

    /// `τ`: the new point `i` stands at `(i - τ)/m` between the old points `0, 1, …`, if the rule
    /// reproduces lines.
    pub fn shift(&self) -> &Rational {
        &self.shift
    }

    /// The bits of the common denominator of the weights.
    pub fn denominator_bits(&self) -> u64 {
        self.denominator_bits
    }

    /// The rule as often as there are levels.
    ///
    /// # Errors
    /// Code `levels` for more than anybody can count.
    pub fn repeated(&self, levels: u32) -> Result<Vec<&Self>, Diagnostic> {
        if levels > MOST_LEVELS {
            let message = format!("{levels} levels make more points than can be counted");
            return Err(Diagnostic::new("levels", message).with_hint("ask for fewer levels"));
        }
        Ok(vec![self; levels as usize])
    }

    /// How far the stencils reach, from the point `i` whose descendants they make.
    pub(crate) fn reach(&self) -> u64 {
        let ends =
            self.stencils.iter().flat_map(|s| [s.first.unsigned_abs(), s.end().unsigned_abs()]);
        ends.max().unwrap_or(0)
    }

    /// The old points that some new ones are made of.
    pub fn needed(&self, new: &Range<i64>) -> Range<i64> {
        let m = self.arity() as i64;
        let at = |i: i64| (i.div_euclid(m), &self.stencils[i.rem_euclid(m) as usize]);
        // Along one class of remainders the first point needed moves on, so the first few tell.
        let first = (new.start..new.end.min(new.start + m)).map(|i| at(i).0 + at(i).1.first);
        let end = (new.start.max(new.end - m)..new.end).map(|i| at(i).0 + at(i).1.end());
        first.min().unwrap_or(new.start)..end.max().unwrap_or(new.start)
    }

    /// The new points that can be made of some old ones; perhaps an empty or a reversed range.
    pub fn produced(&self, old: &Range<i64>) -> Range<i64> {
        let m = self.arity() as i64;
        let classes = || (0..m).zip(&self.stencils);
        // In the class of ε the stencil at `i` fits if `old.start ≤ i + first` and `i + end ≤ old.end`.
        let start = classes().map(|(e, s)| m * (old.start - s.first - 1) + e + 1).max();
        let end = classes().map(|(e, s)| m * (old.end - s.end() + 1) + e).min();
        start.unwrap_or(0)..end.unwrap_or(0)
    }
}

/// The pairs `(i, a_i)` of a mask without parameters.
pub(crate) fn constant_coefficients(mask: &Normalised) -> Result<Vec<(i64, Rational)>, Diagnostic> {
    let constant = |(i, a): (i64, ParameterFraction)| Some((i, a.as_constant()?));
    mask.coefficients().map(constant).collect::<Option<_>>().ok_or_else(|| {
        let names: Vec<String> = mask.parameters().iter().map(ToString::to_string).collect();
        let message = format!("the scheme still has the parameters {}", names.join(", "));
        let sets: Vec<String> = names.iter().map(|name| format!("--set {name}=VALUE")).collect();
        Diagnostic::new("parameters", message).with_hint(format!("set them: {}", sets.join(" ")))
    })
}
