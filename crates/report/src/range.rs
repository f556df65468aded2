//! `range`: where C^n is proved over one parameter.

use refinable_algebra::{Parameter, ParameterFraction, ParameterPolynomial, Ring, parse_rational};
use refinable_analysis::{Budget, NormRange, norm_range};
use refinable_reals::{Bound, ExactForm, Interval, RealAlgebraic, Region};
use refinable_scheme::{Diagnostic, Scheme, Substitution, geometric_factor};
use serde_json::{Value, json};

use crate::audit::short;
use crate::grid::{Cell, Document, Grid};
use crate::latex;
use crate::number::{approximation, intervals, number};

/// Where C^n is proved over the whole line of the one free parameter, by norms up to `level`.
///
/// # Errors
/// Code `parameters` unless exactly one parameter is free; `budget` for an absurd level.
pub fn range_table(
    scheme: &Scheme,
    continuity: usize,
    level: u32,
    budget: Budget,
) -> Result<Document, Diagnostic> {
    let parameter = only_parameter(scheme)?;
    let range = norm_range(scheme.mask(), &parameter, continuity, level, budget)?;
    let variable = parameter.name();
    let unproved = Unproved::new(&range);
    let mut rows = Vec::new();
    for (region, verdict) in [
        (&range.proved, "proved"),
        (&unproved.undecided, "undecided"),
        (&unproved.undefined, "undefined"),
    ] {
        for part in region.intervals() {
            let proof = if verdict == "proved" { proof(&range, &part) } else { String::new() };
            rows.push(vec![
                Cell::text(verdict),
                interval_cell(&part, variable),
                Cell::text(decimals(&part)),
                Cell::text(proof),
            ]);
        }
    }
    let header = ["verdict", variable, "decimals", "proof"].map(String::from).to_vec();
    let grid = Grid {
        id: "range".into(),
        caption: format!("C^{continuity} of {}, norms up to level {level}", scheme.name()),
        header,
        rows,
        remarks: remarks(&range, scheme.mask().arity()),
    };
    let points = points(&range, &unproved, variable);
    let json = json!({
        "scheme": scheme.name(),
        "parameter": variable,
        "continuity": continuity,
        "level": level,
        "proved": intervals(&range.proved, variable),
        "refuted": [],
        "undecided": intervals(&unproved.undecided, variable),
        "points": points,
        "exact": true,
    });
    Ok(Document { grids: vec![grid], summary: None, json })
}

/// The one free parameter of a scheme.
///
/// # Errors
/// Code `parameters` if there is none or more than one.
pub fn only_parameter(scheme: &Scheme) -> Result<Parameter, Diagnostic> {
    let mut free: Vec<Parameter> = scheme.mask().parameters().into_iter().collect();
    match (free.pop(), free.is_empty()) {
        (Some(parameter), true) => Ok(parameter),
        (None, _) => {
            let message = format!("{} has no free parameter, and a range needs one", scheme.name());
            let hint =
                "`refinable regularity SCHEME`, or `certify SCHEME -n N`, is about a single scheme";
            Err(Diagnostic::new("parameters", message).with_hint(hint))
        }
        (Some(last), false) => {
            let names: Vec<&str> = free.iter().map(Parameter::name).collect();
            let names = names.join(", ");
            let message = format!("{} has several free parameters: {names}, {last}", scheme.name());
            // A value that is no pole of all members.
            let regular = (0..8).find(|value| {
                let value = ParameterFraction::from(ParameterPolynomial::from_i64(*value));
                scheme.with(&[Substitution::new(last.clone(), value)]).is_ok()
            });
            let value = regular.map_or_else(|| "VALUE".into(), |value| value.to_string());
            let hint = format!("set all but one, for example --set '{last}={value}'");
            Err(Diagnostic::new("parameters", message).with_hint(hint))
        }
    }
}

/// The parts of the line that are not proved.
struct Unproved {
    undecided: Region,
    undefined: Region,
}

impl Unproved {
    fn new(range: &NormRange) -> Self {
        let undefined = Region::points(range.poles.iter().cloned());
        let undecided = range.proved.union(&undefined).complement();
        Unproved { undecided, undefined }
    }
}

/// `‖c_1^2‖ < 1` for the lowest level that proves all of the interval, or the levels it takes.
fn proof(range: &NormRange, part: &Interval) -> String {
    let region = Region::from(part);
    let norm = |level: usize| format!("‖c_{}^{}‖ < 1", range.continuity, level + 1);
    let single = range.levels.iter().position(|proved| region.is_subset(proved));
    if let Some(level) = single {
        return norm(level);
    }
    let needed = range.levels.iter().enumerate();
    let needed = needed.filter(|(_, proved)| !proved.intersection(&region).is_empty());
    needed.map(|(level, _)| norm(level)).collect::<Vec<_>>().join(" or ")
}

/// Ends beyond this many characters are shown in decimals only.
const LONGEST: usize = 48;

/// An interval with its exact ends, unless they are too long to be read.
pub(crate) fn interval_cell(interval: &Interval, variable: &str) -> Cell {
    let region = Region::from(interval);
    if is_short(interval) {
        Cell::math(region.display(variable), &latex::region(&region, variable))
    } else {
        Cell::text(short(&region, variable))
    }
}

fn is_short(interval: &Interval) -> bool {
    let ends = [interval.lower.number(), interval.upper.number()];
    ends.into_iter().flatten().all(|x| match x.exact_form() {
        form @ ExactForm::Root { .. } => form.display("x").len() <= LONGEST,
        _ => true,
    })
}

/// The ends to six digits, marked unless they are exact.
pub fn decimals(interval: &Interval) -> String {
    let text = |x: &RealAlgebraic| {
        let decimal = x.decimal(6);
        let exact = x.as_rational().is_some_and(|q| parse_rational(&decimal).as_ref() == Some(q));
        if exact { decimal } else { format!("≈ {decimal}") }
    };
    let end = |bound: &Bound| bound.number().map_or("∞".into(), text);
    match interval.as_point() {
        Some(x) => text(x),
        None => format!("{} .. {}", end(&interval.lower).replace('∞', "-∞"), end(&interval.upper)),
    }
}

fn remarks(range: &NormRange, arity: usize) -> Vec<String> {
    let mut remarks = Vec::new();
    if let Some(points) = &range.divisible_at {
        let variable = range.parameter.name();
        let list = |x: &RealAlgebraic| {
            format!("{variable} = {}{}", x.exact_form().display(variable), approximation(x))
        };
        let listed: Vec<String> = points.iter().map(list).collect();
        let (order, factor) = (range.continuity + 1, geometric_factor(arity));
        remarks.push(if listed.is_empty() {
            format!("the symbol is divisible by ({factor})^{order} for no value")
        } else {
            format!(
                "the symbol is divisible by ({factor})^{order} only at isolated values: {}",
                listed.join(", ")
            )
        });
    }
    remarks.push(
        match range.divisible_at {
            None => {
                "undecided: no norm up to this level is below 1; a higher --level may prove more"
            }
            Some(_) => {
                "undecided: elsewhere there is no difference scheme whose norm could prove it"
            }
        }
        .into(),
    );
    remarks
}

/// The isolated points of the three regions, ascending.
fn points(range: &NormRange, unproved: &Unproved, variable: &str) -> Vec<Value> {
    let regions = [
        (&range.proved, "proved"),
        (&unproved.undecided, "undecided"),
        (&unproved.undefined, "undefined"),
    ];
    let mut all: Vec<(RealAlgebraic, &str)> = Vec::new();
    for (region, verdict) in regions {
        let intervals = region.intervals();
        let isolated = intervals.iter().filter_map(Interval::as_point);
        all.extend(isolated.map(|x| (x.clone(), verdict)));
    }
    all.sort_by(|a, b| a.0.cmp(&b.0));
    let point = |(x, verdict): &(RealAlgebraic, &str)| json!({"at": number(x, variable), "verdict": verdict});
    all.iter().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `‖c_0^1‖ = max(t², 1 - t²) < 1` but for `t = 0` and from `|t| = 1` on; the point 0 must not get
    /// lost between the intervals.
    #[test]
    fn isolated_undecided_points_are_listed() {
        let scheme = Scheme::resolve("[t^2, 1, 1-t^2]", 2).unwrap();
        let json = range_table(&scheme, 0, 1, Budget::default()).unwrap().json;
        assert_eq!(json["proved"].as_array().map(Vec::len), Some(2));
        assert_eq!(json["points"][0]["at"]["exact"], "0");
        assert_eq!(json["points"][0]["verdict"], "undecided");
    }
}
