//! Claims of C^n on a range or at a value. They are lower bounds.

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
    let Some(proved) = maximum::proved_at_value(workbench, scheme)? else {
        return Ok(Finding::new("not proved to converge", Agreement::Undecided));
    };
    Ok(Finding::new(
        format!("C^{} proved: {proved}", proved.continuity),
        match proved.continuity.cmp(&claimed) {
            std::cmp::Ordering::Less => Agreement::Undecided,
            std::cmp::Ordering::Equal => Agreement::Agrees,
            std::cmp::Ordering::Greater => Agreement::Stronger,
        },
    ))
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
    let range = workbench.range(scheme, &parameter, continuity)?;
    let claimed = if ends.0 < ends.1 {
        Region::open(ends.0.clone(), ends.1.clone())
    } else {
        Region::empty()
    };
    let variable = parameter.name();
    let finding = |agreement| {
        let text = format!("proved on {}", short(&range.proved, variable));
        let (claimed, proved) = (claimed.clone(), range.proved.clone());
        let ranges = Ranges { parameter: variable.into(), claimed, proved };
        Finding { ranges: Some(ranges), ..Finding::new(text, agreement) }
    };
    if claimed.is_empty() {
        let (left, right) = (ends.0.decimal(6), ends.1.decimal(6));
        let swapped = verdict(&Region::open(ends.1, ends.0), &range.proved);
        let finding = finding(Agreement::Disagrees).noted(format!(
            "as printed no value satisfies both inequalities: {left} is not less than {right}"
        ));
        return Ok(match left == right {
            true => finding,
            false => finding.noted(format!("with the ends interchanged: {}", swapped.word())),
        });
    }
    if let Some(pole) = range.poles.iter().find(|pole| claimed.contains(pole)) {
        let pole = pole.exact_form().display(variable);
        return Ok(finding(Agreement::Disagrees)
            .noted(format!("the scheme is not defined at {variable} = {pole}")));
    }
    let agreement = verdict(&claimed, &range.proved);
    if agreement == Agreement::Undecided {
        let rest = claimed.difference(&range.proved);
        return Ok(finding(agreement).noted(format!("not proved on {}", short(&rest, variable))));
    }
    Ok(finding(agreement))
}

/// A claimed region against the proved one.
fn verdict(claimed: &Region, proved: &Region) -> Agreement {
    match (claimed.is_subset(proved), proved.is_subset(claimed)) {
        (true, true) => Agreement::Agrees,
        (true, false) => Agreement::Stronger,
        (false, _) => Agreement::Undecided,
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
