//! Claims of C^n on a range or at a value. They are lower bounds.

use refinable_analysis::{ContinuityRange, PointVerdict};
use refinable_papers::{ClaimedContinuity, Interval};
use refinable_reals::{Bound, ExactForm, RealAlgebraic, Region};
use refinable_scheme::{Diagnostic, Scheme};

use super::constant::constant;
use super::workbench::Workbench;
use super::{Agreement, Finding, Ranges, maximum};
use crate::number::approximation;

/// Checks a claim of C^n.
///
/// # Errors
/// A claim on a range of a parameter that is not the only free one, or at a value that leaves a
/// parameter free.
pub fn check(
    workbench: &Workbench,
    scheme: &Scheme,
    claim: &ClaimedContinuity,
) -> Result<Finding, Diagnostic> {
    match &claim.interval {
        Some(interval) => check_range(workbench, scheme, claim.order as usize, interval),
        None => check_value(workbench, scheme, claim.order as usize),
    }
}

/// C^n of a scheme without free parameters.
fn check_value(
    workbench: &Workbench,
    scheme: &Scheme,
    claimed: usize,
) -> Result<Finding, Diagnostic> {
    let best = maximum::at_value(workbench, scheme)?;
    let (below, above) =
        (workbench.verdict(scheme, claimed)?, workbench.verdict(scheme, claimed + 1)?);
    let text = match &best {
        Some(best) => format!("C^{} proved: {}", best.continuity, best.witness),
        None => "not proved to converge".into(),
    };
    Ok(match (below.0, above.0) {
        (_, PointVerdict::Proved) => Finding::new(text, Agreement::Stronger),
        (PointVerdict::Proved, PointVerdict::Refuted) => {
            Finding::new(text, Agreement::Agrees).noted(format!("not C^{}", claimed + 1))
        }
        (PointVerdict::Proved, _) => Finding::new(text, Agreement::Agrees),
        (PointVerdict::Refuted, _) => {
            Finding::new(text, Agreement::Disagrees).noted(format!("C^{claimed} is refuted"))
        }
        _ => Finding::new(text, Agreement::Undecided),
    }
    .certified([below.1.clone(), above.1.clone()]))
}

fn check_range(
    workbench: &Workbench,
    scheme: &Scheme,
    continuity: usize,
    interval: &Interval,
) -> Result<Finding, Diagnostic> {
    let parameter = crate::range::only_parameter(scheme)?;
    if parameter.name() != interval.parameter {
        let message = format!("the free parameter is {parameter}, not {}", interval.parameter);
        return Err(Diagnostic::new("parameters", message));
    }
    let ends = (constant(&interval.left)?, constant(&interval.right)?);
    let certified = workbench.range(scheme, &parameter, continuity)?;
    let (range, certificate) = (&certified.0, &certified.1);
    let claimed = if ends.0 < ends.1 {
        Region::open(ends.0.clone(), ends.1.clone())
    } else {
        Region::empty()
    };
    let variable = parameter.name();
    let finding = |agreement| {
        let text = format!("proved on {}", short(&range.proved, variable));
        let ranges = Ranges {
            parameter: variable.into(),
            claimed: claimed.clone(),
            proved: range.proved.clone(),
            refuted: range.refuted.clone(),
        };
        Finding { ranges: Some(ranges), ..Finding::new(text, agreement) }
            .certified([certificate.clone()])
    };
    if claimed.is_empty() {
        let (left, right) = (ends.0.decimal(6), ends.1.decimal(6));
        let swapped = verdict(&Region::open(ends.1, ends.0), range);
        let finding = finding(Agreement::Disagrees).noted(format!(
            "as printed no value satisfies both inequalities: {left} is not less than {right}"
        ));
        return Ok(match left == right {
            true => finding,
            false => finding.noted(format!("with the ends interchanged: {}", swapped.word())),
        });
    }
    let pole = range.points.iter().find(|(t, v)| *v == PointVerdict::Pole && claimed.contains(t));
    if let Some((pole, _)) = pole {
        let pole = pole.exact_form().display(variable);
        return Ok(finding(Agreement::Disagrees)
            .noted(format!("the scheme is not defined at {variable} = {pole}")));
    }
    Ok(match verdict(&claimed, range) {
        Agreement::Disagrees => {
            let wrong = claimed.intersection(&range.refuted);
            finding(Agreement::Disagrees)
                .noted(format!("refuted on {}", short(&wrong, variable)))
                .noted(witness(range, &wrong, variable))
        }
        Agreement::Undecided => {
            let rest = claimed.difference(&range.proved);
            finding(Agreement::Undecided).noted(format!("not proved on {}", short(&rest, variable)))
        }
        agreement => finding(agreement),
    })
}

/// A claimed region against what is proved and refuted.
fn verdict(claimed: &Region, range: &ContinuityRange) -> Agreement {
    if !claimed.intersection(&range.refuted).is_empty() {
        return Agreement::Disagrees;
    }
    match (claimed.is_subset(&range.proved), range.proved.is_subset(claimed)) {
        (true, true) => Agreement::Agrees,
        (true, false) => Agreement::Stronger,
        (false, _) => Agreement::Undecided,
    }
}

/// `at alpha = 1/40 the word 0 has spectral radius at least 1`: a value inside a refuted region with
/// the reason.
fn witness(range: &ContinuityRange, wrong: &Region, variable: &str) -> String {
    let intervals = wrong.intervals();
    let Some(value) = intervals.iter().find_map(|interval| {
        match (interval.as_point(), interval.lower.number(), interval.upper.number()) {
            (Some(x), _, _) => x.as_rational().cloned(),
            (None, Some(a), Some(b)) => Some(a.rational_between(b)),
            _ => None,
        }
    }) else {
        return String::new();
    };
    match range.reason_at(&value) {
        Some(word) => format!(
            "at {variable} = {value} the product along the word {word} has spectral radius at least 1"
        ),
        None => format!("for example at {variable} = {value}"),
    }
}

/// A region in one line: exact ends where they are short, decimals for roots of higher degree.
pub fn short(region: &Region, variable: &str) -> String {
    let number = |x: &RealAlgebraic| match x.exact_form() {
        ExactForm::Root { .. } => format!("≈{}", x.decimal(6)),
        short => format!("{}{}", short.display(variable), approximation(x)),
    };
    let parts: Vec<String> = region
        .intervals()
        .iter()
        .map(|interval| match interval.as_point() {
            Some(x) => format!("{variable} = {}", number(x)),
            None => {
                format!("{}, {}", lower(&interval.lower, number), upper(&interval.upper, number))
            }
        })
        .collect();
    if parts.is_empty() { "∅".into() } else { parts.join(" ∪ ") }
}

fn lower(bound: &Bound, number: impl Fn(&RealAlgebraic) -> String) -> String {
    match bound {
        Bound::Infinite => "(-∞".into(),
        Bound::Open(x) => format!("({}", number(x)),
        Bound::Closed(x) => format!("[{}", number(x)),
    }
}

fn upper(bound: &Bound, number: impl Fn(&RealAlgebraic) -> String) -> String {
    match bound {
        Bound::Infinite => "∞)".into(),
        Bound::Open(x) => format!("{})", number(x)),
        Bound::Closed(x) => format!("{}]", number(x)),
    }
}
