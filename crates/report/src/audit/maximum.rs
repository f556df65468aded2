//! Claims of maximum continuity: the largest n for which some parameter value gives C^n.
//!
//! The maximum is n if C^n is proved somewhere and C^(n+1) refuted everywhere. With two parameters C^n
//! is asked on the curves and at the points of the degree ladder, and refuted by the support alone.

use std::cmp::Ordering;

use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, decimal,
};
use refinable_analysis::{PointVerdict, highest_continuity};
use refinable_papers::Bound;
use refinable_reals::{Component, Interval, Point};
use refinable_scheme::{Diagnostic, Scheme, Substitution};

use super::workbench::Workbench;
use super::{Agreement, Finding, continuity};

/// The best C^n that is proved, where, and a witness.
pub struct Best {
    /// The order n.
    pub continuity: usize,
    place: String,
    /// Why C^n holds: a norm below 1 if one of low level is, else an invariant polytope.
    pub witness: String,
    certificates: Vec<String>,
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
    let excluded = excluded(workbench, scheme, best.continuity + 1)?;
    let at_least = if excluded.is_some() { "" } else { "at least " };
    let text = format!("{at_least}C^{}{}", best.continuity, best.place);
    let of_excluded = excluded.as_ref().map_or(&[][..], |excluded| &excluded.certificates);
    let certificates = best.certificates.iter().chain(of_excluded).cloned();
    let finding = |agreement| {
        Finding::new(text.clone(), agreement)
            .noted(best.witness.clone())
            .certified(certificates.clone())
    };
    let reason = excluded.as_ref().and_then(|excluded| excluded.reason.clone());
    let reason = reason.map_or(String::new(), |reason| format!(": {reason}"));
    let nothing_more = format!("C^{} is refuted for all values{reason}", best.continuity + 1);
    Ok(match (best.continuity.cmp(&claimed), bound, excluded.is_some()) {
        (Ordering::Greater, Bound::Equal, _) => finding(Agreement::Disagrees)
            .noted(format!("C^{} is attained, more than the claimed maximum", best.continuity)),
        (Ordering::Greater, Bound::AtLeast, _) => finding(Agreement::Stronger),
        (Ordering::Equal, Bound::AtLeast, _) => finding(Agreement::Agrees),
        (Ordering::Equal, Bound::Equal, true) => finding(Agreement::Agrees).noted(nothing_more),
        (Ordering::Equal, Bound::Equal, false) => {
            finding(Agreement::Undecided).noted("attained; not shown to be the maximum")
        }
        (Ordering::Less, _, true) => finding(Agreement::Disagrees).noted(nothing_more),
        (Ordering::Less, _, false) => finding(Agreement::Undecided),
    })
}

/// Why C^n fails for every value of the parameters.
struct Excluded {
    certificates: Vec<String>,
    /// What is too simple for a certificate.
    reason: Option<String>,
}

/// Why C^n fails for every value of the parameters; `None` if that is not known.
fn excluded(
    workbench: &Workbench,
    scheme: &Scheme,
    continuity: usize,
) -> Result<Option<Excluded>, Diagnostic> {
    let by =
        |certificate: &String| Excluded { certificates: vec![certificate.clone()], reason: None };
    let parameters: Vec<Parameter> = scheme.mask().parameters().into_iter().collect();
    Ok(match parameters.as_slice() {
        [] => {
            let verdict = workbench.verdict(scheme, continuity)?;
            (verdict.0 == PointVerdict::Refuted).then(|| by(&verdict.1))
        }
        [parameter] => {
            let range = workbench.range(scheme, parameter, continuity)?;
            let refuted = range.0.proved.is_empty() && range.0.undecided().is_empty();
            refuted.then(|| by(&range.1))
        }
        _ => excluded_by_support(scheme, continuity),
    })
}

/// The support alone refutes C^n, stable or not.
fn excluded_by_support(scheme: &Scheme, continuity: usize) -> Option<Excluded> {
    let most = highest_continuity(scheme.mask()).filter(|most| continuity > *most)?;
    let width = scheme.mask().support_width();
    let reason = format!("a limit function of support width {width} is at most C^{most}");
    Some(Excluded { certificates: Vec::new(), reason: Some(reason) })
}

/// The largest n with C^n proved for a scheme without free parameters.
///
/// # Errors
/// A budget that does not suffice; code `parameters` if a parameter is free.
pub fn at_value(workbench: &Workbench, scheme: &Scheme) -> Result<Option<Best>, Diagnostic> {
    let generation = workbench.degrees(scheme).generic().generation.0;
    for continuity in (0..=generation).rev() {
        let verdict = workbench.verdict(scheme, continuity)?;
        if verdict.0 == PointVerdict::Proved {
            let norms = workbench.norms(scheme, continuity)?;
            return Ok(Some(Best {
                continuity,
                place: String::new(),
                witness: norm_witness(norms.as_deref().unwrap_or_default(), continuity),
                certificates: vec![verdict.1.clone()],
            }));
        }
    }
    Ok(None)
}

/// `‖c_3^2‖ = 99/128`, or `an invariant polytope`.
fn norm_witness(norms: &[Rational], continuity: usize) -> String {
    let Some(level) = norms.iter().position(|norm| *norm < Rational::one()) else {
        return "by an invariant polytope".into();
    };
    let text = norms[level].to_string();
    let value = if text.len() <= 16 {
        format!("= {text}")
    } else {
        format!("≈ {}", decimal(&norms[level], 6))
    };
    format!("‖c_{continuity}^{}‖ {value}", level + 1)
}

fn best(workbench: &Workbench, scheme: &Scheme) -> Result<Option<Best>, Diagnostic> {
    let parameters: Vec<Parameter> = scheme.mask().parameters().into_iter().collect();
    match parameters.as_slice() {
        [] => at_value(workbench, scheme),
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
        let certified = workbench.range(scheme, parameter, continuity)?;
        let range = &certified.0;
        if let Some(interval) = range.proved.intervals().first() {
            let region = continuity::short(&range.proved, parameter.name());
            let word = if interval.as_point().is_some() { "at" } else { "on" };
            let place = format!(" {word} {region}");
            let witness = witness(workbench, scheme, parameter, interval, continuity)?;
            let certificates = vec![certified.1.clone()];
            return Ok(Some(Best { continuity, place, witness, certificates }));
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
    continuity: usize,
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
    let norms = workbench.norms(&fixed, continuity)?;
    let witness = norm_witness(norms.as_deref().unwrap_or_default(), continuity);
    Ok(format!("{witness} at {parameter} = {x}"))
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
