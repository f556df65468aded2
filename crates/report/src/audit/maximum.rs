//! Claims of maximum continuity: the largest n for which some parameter value gives C^n.
//!
//! Norms bound the maximum from below only. So a claim that is exceeded is refuted, a claim of "at
//! least" that is reached is proved, and all else is left to sharper means.

use std::fmt;

use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, decimal,
};
use refinable_papers::Bound;
use refinable_reals::{Component, Interval, Point};
use refinable_scheme::{Diagnostic, Scheme, Substitution};

use super::workbench::Workbench;
use super::{Agreement, Finding, continuity};

/// The best C^n that norms prove, where, and a norm below 1 as the witness.
struct Best {
    continuity: usize,
    place: String,
    witness: String,
}

/// Checks a claimed maximum.
///
/// # Errors
/// A budget that does not suffice.
pub fn check(
    workbench: &Workbench,
    scheme: &Scheme,
    claimed: usize,
    bound: Bound,
) -> Result<Finding, Diagnostic> {
    let Some(best) = best(workbench, scheme)? else {
        return Ok(Finding::new(
            "none of the values tried is proved to converge",
            Agreement::Undecided,
        ));
    };
    let text = format!("at least C^{}{}", best.continuity, best.place);
    let finding = |agreement| Finding::new(text.clone(), agreement).noted(best.witness.clone());
    Ok(match (best.continuity.cmp(&claimed), bound) {
        (std::cmp::Ordering::Greater, Bound::Equal) => finding(Agreement::Disagrees)
            .noted(format!("C^{} is attained, more than the claimed maximum", best.continuity)),
        (std::cmp::Ordering::Greater, Bound::AtLeast) => finding(Agreement::Stronger),
        (std::cmp::Ordering::Equal, Bound::AtLeast) => finding(Agreement::Agrees),
        (std::cmp::Ordering::Equal, Bound::Equal) => finding(Agreement::Undecided)
            .noted("attained; norms cannot show that it is the maximum"),
        (std::cmp::Ordering::Less, _) => finding(Agreement::Undecided),
    })
}

/// A norm below 1: the proof of C^n for a scheme without free parameters.
pub struct ProvedValue {
    /// The order n.
    pub continuity: usize,
    /// The lowest level whose norm is below 1.
    pub level: usize,
    /// That norm.
    pub norm: Rational,
}

impl fmt::Display for ProvedValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.norm.to_string();
        let short = text.len() <= 16;
        let value = if short { text } else { format!("≈ {}", decimal(&self.norm, 6)) };
        let equals = if short { " = " } else { " " };
        write!(f, "‖c_{}^{}‖{equals}{value}", self.continuity, self.level)
    }
}

/// The largest n with C^n proved for a scheme without free parameters.
///
/// # Errors
/// A budget that does not suffice; code `parameters` if a parameter is free.
pub fn proved_at_value(
    workbench: &Workbench,
    scheme: &Scheme,
) -> Result<Option<ProvedValue>, Diagnostic> {
    let generation = workbench.degrees(scheme).generic().generation.0;
    for continuity in (0..=generation).rev() {
        if let Some(norms) = workbench.norms(scheme, continuity)?.as_ref()
            && let Some(at) = norms.iter().position(|norm| *norm < Rational::one())
        {
            let (level, norm) = (at + 1, norms[at].clone());
            return Ok(Some(ProvedValue { continuity, level, norm }));
        }
    }
    Ok(None)
}

fn best(workbench: &Workbench, scheme: &Scheme) -> Result<Option<Best>, Diagnostic> {
    let parameters: Vec<Parameter> = scheme.mask().parameters().into_iter().collect();
    match parameters.as_slice() {
        [] => {
            let proved = proved_at_value(workbench, scheme)?;
            Ok(proved.map(|proved| {
                let witness = proved.to_string();
                Best { continuity: proved.continuity, place: String::new(), witness }
            }))
        }
        [parameter] => best_on_line(workbench, scheme, parameter),
        _ => best_on_strata(workbench, scheme),
    }
}

/// From the highest order that divisibility admits anywhere downwards: the first with a nonempty
/// proved set.
fn best_on_line(
    workbench: &Workbench,
    scheme: &Scheme,
    parameter: &Parameter,
) -> Result<Option<Best>, Diagnostic> {
    let degrees = workbench.degrees(scheme);
    let highest = degrees.strata.iter().map(|s| s.generation.0).max().unwrap_or(0);
    for continuity in (0..=highest).rev() {
        let range = workbench.range(scheme, parameter, continuity)?;
        if let Some(interval) = range.proved.intervals().first() {
            let region = continuity::short(&range.proved, parameter.name());
            let word = if interval.as_point().is_some() { "at" } else { "on" };
            let witness = witness(workbench, scheme, parameter, interval)?;
            return Ok(Some(Best { continuity, place: format!(" {word} {region}"), witness }));
        }
    }
    Ok(None)
}

/// A short rational value inside a proved interval, with the norm there.
fn witness(
    workbench: &Workbench,
    scheme: &Scheme,
    parameter: &Parameter,
    interval: &Interval,
) -> Result<String, Diagnostic> {
    let inside = match (interval.as_point(), interval.lower.number(), interval.upper.number()) {
        (Some(x), _, _) => x.as_rational().cloned(),
        (None, Some(lower), Some(upper)) => Some(lower.rational_between(upper)),
        (None, Some(lower), None) => Some(lower.bounds().1 + Rational::one()),
        (None, None, Some(upper)) => Some(upper.bounds().0 - Rational::one()),
        (None, None, None) => Some(Rational::zero()),
    };
    let Some(x) = inside else {
        return Ok(String::new());
    };
    let value = ParameterFraction::from(ParameterPolynomial::constant(x.clone()));
    let fixed = scheme.with(&[Substitution::new(parameter.clone(), value)])?;
    let proved = proved_at_value(workbench, &fixed)?;
    Ok(proved.map_or_else(String::new, |proved| format!("{proved} at {parameter} = {x}")))
}

/// With two or more parameters the smoothest members are sought where divisibility is highest: on
/// the curves that can be solved for a parameter, and at the rational points.
fn best_on_strata(workbench: &Workbench, scheme: &Scheme) -> Result<Option<Best>, Diagnostic> {
    let mut found: Option<Best> = None;
    for stratum in &workbench.degrees(scheme).strata {
        let Some((condition, substitutions)) = substitutions(&stratum.locus) else {
            continue;
        };
        let Ok(restricted) = scheme.with(&substitutions) else {
            continue;
        };
        if let Some(candidate) = best(workbench, &restricted)?
            && found.as_ref().is_none_or(|best| candidate.continuity > best.continuity)
        {
            let place = match candidate.place.as_str() {
                "" => format!(" at {condition}"),
                place => format!("{place} with {condition}"),
            };
            found = Some(Best { place, ..candidate });
        }
    }
    Ok(found)
}

fn substitutions(locus: &Component) -> Option<(String, Vec<Substitution>)> {
    match locus {
        Component::Space => None,
        Component::Hypersurface(_) => {
            let (parameter, value) = crate::degrees::solutions(locus).into_iter().next()?;
            let condition = format!("{parameter} = {value}");
            Some((condition, vec![Substitution::new(parameter, value)]))
        }
        Component::Point(point) => Some((crate::degrees::coordinates(point), rational(point)?)),
    }
}

fn rational(point: &Point) -> Option<Vec<Substitution>> {
    let coordinates = point.coordinates().iter();
    let substitutions = coordinates.map(|(parameter, x)| {
        let value = ParameterPolynomial::constant(x.as_rational()?.clone());
        Some(Substitution::new(parameter.clone(), ParameterFraction::from(value)))
    });
    substitutions.collect()
}
