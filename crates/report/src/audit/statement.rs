//! One claim, checked.

use refinable_algebra::{ParameterPolynomial, Ring};
use refinable_analysis::{Classification, Comparison, Norm, classify};
use refinable_papers::{Assertion, Bound, Statement, Trait};
use refinable_scheme::{Diagnostic, Expression, Mask, Scheme};

use super::workbench::Workbench;
use super::{Agreement, Finding, continuity, degrees, maximum};

/// Checks a claim about a scheme.
///
/// # Errors
/// A claim that cannot be understood.
pub fn check(workbench: &Workbench, assertion: &Assertion) -> Result<Finding, Diagnostic> {
    let scheme = workbench.scheme(&assertion.scheme, &assertion.set)?;
    match &assertion.statement {
        Statement::Mask { mask } => check_mask(&scheme, mask),
        Statement::Continuity(claim) => continuity::check(workbench, &scheme, claim),
        Statement::MaxContinuity { value, bound } => {
            maximum::check(workbench, &scheme, *value as usize, *bound)
        }
        Statement::Generation(claim) => {
            Ok(degrees::check(&workbench.degrees(&scheme), claim, |s| s.generation.0))
        }
        Statement::Reproduction(claim) => {
            Ok(degrees::check(&workbench.degrees(&scheme), claim, |s| s.reproduction.0))
        }
        Statement::SupportWidth { value } => {
            let width = scheme.mask().support_width();
            let equal = width == refinable_algebra::rational(i64::from(*value), 1);
            Ok(Finding::new(width.to_string(), agreement(equal)))
        }
        Statement::ParameterCount { value } => {
            let count = scheme.mask().parameters().len();
            Ok(Finding::new(count.to_string(), agreement(count == *value as usize)))
        }
        Statement::Type { traits } => Ok(check_traits(&scheme, traits)),
        Statement::Norm { continuity, level, rows } => {
            check_norm(workbench, &scheme, *continuity as usize, *level, rows)
        }
    }
}

/// For claims that are either exactly right or wrong.
pub fn agreement(equal: bool) -> Agreement {
    if equal { Agreement::Agrees } else { Agreement::Disagrees }
}

/// For a claimed number against the exact one.
pub fn compare(claimed: usize, found: usize, bound: Bound) -> Agreement {
    match bound {
        Bound::Equal => agreement(claimed == found),
        Bound::AtLeast if found > claimed => Agreement::Stronger,
        Bound::AtLeast => agreement(found == claimed),
    }
}

fn check_mask(scheme: &Scheme, claimed: &str) -> Result<Finding, Diagnostic> {
    let claimed = Mask::parse(claimed, scheme.mask().arity())?;
    let ours = scheme.mask();
    let (first, last) = ours.support();
    let (claimed_first, claimed_last) = claimed.support();
    let wrong = (first.min(claimed_first)..=last.max(claimed_last))
        .find(|&i| ours.coefficient(i) != claimed.coefficient(i));
    Ok(match wrong {
        None => {
            let count = ours.coefficients().count();
            Finding::new(format!("all {count} coefficients equal"), Agreement::Agrees)
        }
        Some(i) => {
            let (a, b) = (ours.coefficient(i), claimed.coefficient(i));
            Finding::new(format!("a_{i} = {a}, not {b}"), Agreement::Disagrees)
        }
    })
}

fn check_traits(scheme: &Scheme, traits: &[Trait]) -> Finding {
    let kind = classify(scheme.mask());
    let found = crate::show::words(&kind).join(", ");
    let verdicts = traits.iter().map(|t| match has(&kind, *t) {
        None => Agreement::Undecided,
        Some(holds) => agreement(holds),
    });
    Finding::new(found, verdicts.max().unwrap_or(Agreement::Agrees))
}

fn has(kind: &Classification, which: Trait) -> Option<bool> {
    match which {
        Trait::Primal => Some(kind.primal),
        Trait::Dual => Some(kind.dual),
        Trait::Interpolatory => Some(kind.interpolatory),
        Trait::Approximating => Some(kind.approximating),
        Trait::Combined => kind.combined,
        Trait::Relaxed => Some(kind.relaxed),
    }
}

/// A printed norm against `‖c_n^L‖`, as functions of the parameters.
fn check_norm(
    workbench: &Workbench,
    scheme: &Scheme,
    continuity: usize,
    level: u32,
    rows: &[Vec<String>],
) -> Result<Finding, Diagnostic> {
    if level == 0 {
        return Err(Diagnostic::new("claims", "a norm has a level of at least 1"));
    }
    let ours = Norm::of_difference(scheme.mask(), continuity, level, workbench.effort.budget)?;
    let rows: Result<Vec<Vec<ParameterPolynomial>>, Diagnostic> =
        rows.iter().map(|row| row.iter().map(|text| polynomial(text)).collect()).collect();
    let printed = Norm::new(&rows?, ParameterPolynomial::one());
    let text = ours.to_string();
    Ok(match ours.compare(&printed) {
        Comparison::Equal => Finding::new(text, Agreement::Agrees),
        Comparison::Unknown => Finding::new(text, Agreement::Undecided)
            .noted("the formulas differ, but no point was found at which their values do"),
        Comparison::Differ { at, left, right } => {
            let at: Vec<String> = at.iter().map(|(p, x)| format!("{p} = {x}")).collect();
            Finding::new(text, Agreement::Disagrees).noted(format!(
                "at {} the norm is {left}, the formula gives {right}",
                at.join(", ")
            ))
        }
    })
}

fn polynomial(text: &str) -> Result<ParameterPolynomial, Diagnostic> {
    let value = Expression::parse(text)?.evaluate()?;
    value.as_polynomial().cloned().ok_or_else(|| {
        Diagnostic::new("constant", format!("`{text}` is not a polynomial"))
            .with_hint("the terms of a norm are polynomials in the parameters")
    })
}
