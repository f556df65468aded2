//! What the page of an explorer is told about smoothness: verdicts, ranges or maps, all of them certified.
//!
//! An algebraic number is an integer polynomial, ascending, with an open interval in which it is the only root.
//! The cuts of a map are one list, in the order of a walk that goes below a line first: a text `a b c` for a
//! cut along `a x + b y = c`, a number for a piece with that reason.

use std::collections::BTreeMap;

use refinable_algebra::{
    Integer, Parameter, Polynomial, Rational, Ring, clear_denominators, rational,
};
use refinable_analysis::{
    ContinuityRange, Fineness, Map, MapVerdict, Options, PointVerdict, Sharpness, continuity_at,
    default_window, landscape, map, region_of, regularity, smoothest_in,
};
use refinable_certificate::{
    CellVerdict, Certificate, Conclusion, Node, Number, Section, parts_of_box,
};
use refinable_reals::{Bound, Interval, RealAlgebraic, Region};
use refinable_scheme::{Diagnostic, Normalised, Scheme};
use serde_json::{Value, json};

use super::ExplorerOptions;
use super::data::{terms, texts};
use crate::audit::short;
use crate::interproximate::floored;
use crate::map::{MOST_ORDERS, because, coordinates, parse_window, verdict};
use crate::map_picture::proved_on;
use crate::regularity::{exact_text, outward};
use crate::sharp::{proof_text, sharp_range, undecided_because, word, words};
use crate::svg::place;

/// What is said of a scheme without parameters.
pub(super) fn single(
    name: &str,
    mask: &Normalised,
    progress: &dyn Fn(&str),
) -> Result<Value, Diagnostic> {
    let mut data = alone(name, mask, progress)?;
    data["kind"] = "scheme".into();
    Ok(data)
}

/// The verdicts on one member up to the first order that is not proved, and its exponent.
fn alone(name: &str, mask: &Normalised, progress: &dyn Fn(&str)) -> Result<Value, Diagnostic> {
    let mut verdicts = Vec::new();
    for n in 0..MOST_ORDERS {
        progress(&format!("C^{n}"));
        let (found, certificate) = continuity_at(name, mask, n, &Sharpness::default())?;
        // The one lemma is about the only value: what it consists of tells more.
        let inside = certificate.lemmas.iter().flat_map(|l| l.inside().unwrap_or_default());
        let proof = Certificate { lemmas: inside.cloned().collect(), ..certificate.clone() };
        verdicts.push(json!({
            "continuity": n, "verdict": word(found), "because": proof_text(&proof),
        }));
        if found != PointVerdict::Proved {
            break;
        }
    }
    let holder = regularity(name, mask, &Options::default()).ok().map(|found| {
        let (lower, upper) = outward(&found);
        match (exact_text(&found, mask.arity()), upper) {
            (Some(text), _) => text,
            (None, Some(upper)) => format!("between {} and {}", place(&lower), place(&upper)),
            (None, None) => format!("at least {}", floored(&lower)),
        }
    });
    Ok(json!({"verdicts": verdicts, "holder": holder}))
}

/// Members of a family that stand out, in the order of the points, each with what is proved of it alone. The map may leave
/// a point undecided at which everything is known.
pub(super) fn members(
    scheme: &Scheme,
    parameters: &[Parameter],
    points: &[Vec<Rational>],
    progress: &dyn Fn(&str),
) -> Value {
    let member = |(k, point): (usize, &Vec<Rational>)| {
        // A mask takes values in the ascending order of its parameters.
        let values: BTreeMap<_, _> = parameters.iter().zip(point.iter().cloned()).collect();
        let mask = scheme.mask().at(&values.into_values().collect::<Vec<_>>()).ok()?;
        let quiet = |order: &str| progress(&format!("member {}, {order}", k + 1));
        let mut member = alone(scheme.name(), &mask, &quiet).ok()?;
        member["point"] = json!(texts(point));
        Some(member)
    };
    points.iter().enumerate().filter_map(member).collect()
}

/// The ranges of a family of one parameter, a value with the highest order that holds on an interval, and the smoothest
/// one that is found.
pub(super) fn line(
    scheme: &Scheme,
    progress: &dyn Fn(&str),
) -> Result<(Value, Rational, Option<Rational>), Diagnostic> {
    let mut ranges = Vec::new();
    for n in 0..MOST_ORDERS {
        progress(&format!("C^{n}"));
        let range = sharp_range(scheme, n, &Sharpness::default())?;
        let last = range.proved.is_empty();
        ranges.push(range);
        if last {
            break;
        }
    }
    let window = window_of(&ranges);
    let data: Vec<Value> = ranges.iter().map(range_data).collect();
    let centre = ranges.iter().rev().find_map(|range| {
        let intervals = range.proved.intervals();
        let proper = intervals.iter().find(|interval| interval.as_point().is_none())?;
        Some(proper.sample())
    });
    let data = json!({"kind": "line", "window": [texts(&window)], "ranges": data});
    let smoothest = ranges.iter().rev().find(|range| !range.proved.is_empty()).and_then(|range| {
        smoothest_in(scheme.name(), scheme.mask(), &range.proved).map(|(value, _)| value)
    });
    Ok((data, centre.unwrap_or_else(Rational::zero), smoothest))
}

/// An interval around the finite ends of all that is proved.
fn window_of(ranges: &[ContinuityRange]) -> [Rational; 2] {
    let ends: Vec<Rational> = ranges
        .iter()
        .flat_map(|range| range.proved.ends())
        .map(|end| end.enclosure(&rational(1, 1 << 20)).0)
        .collect();
    let (Some(low), Some(high)) = (ends.iter().min(), ends.iter().max()) else {
        return [rational(-1, 1), rational(1, 1)];
    };
    let margin = if low == high { rational(1, 1) } else { (high - low) / rational(5, 1) };
    // Short numbers, about a hundredth of the width apart.
    let unit = (rational(20, 1) / &margin).ceil();
    [((low - &margin) * &unit).floor() / &unit, ((high + &margin) * &unit).ceil() / unit]
}

fn range_data(range: &ContinuityRange) -> Value {
    let variable = range.parameter.name();
    let undecided = range.undecided();
    let parts = [(&range.proved, "proved"), (&range.refuted, "refuted"), (&undecided, "undecided")];
    let mut intervals: Vec<Value> = parts
        .into_iter()
        .flat_map(|(region, verdict)| intervals(region, verdict, variable))
        .collect();
    let poles = range.points.iter().filter(|(_, verdict)| *verdict == PointVerdict::Pole);
    let poles = Region::points(poles.map(|(t, _)| t.clone()));
    intervals.extend(self::intervals(&poles, "undefined", variable));
    let words = words(&range.certificate);
    let refuted = match words.len() {
        0 => String::new(),
        _ => format!("words whose products do not shrink: {}", words.join(", ")),
    };
    json!({
        "continuity": range.continuity,
        "intervals": intervals,
        "because": {
            "proved": proof_text(&range.certificate),
            "refuted": refuted,
            "undecided": undecided_because(range).join("; "),
        },
    })
}

fn intervals(region: &Region, verdict: &str, variable: &str) -> Vec<Value> {
    let data = |interval: &Interval| {
        let end = |bound: &Bound| bound.number().map_or(Value::Null, number);
        let alone = Region::from(interval);
        json!({
            "verdict": verdict,
            "lower": end(&interval.lower),
            "upper": end(&interval.upper),
            "closed": [interval.lower.is_closed(), interval.upper.is_closed()],
            "text": short(&alone, variable),
        })
    };
    region.intervals().iter().map(data).collect()
}

/// `"p/q"`, or a polynomial with an isolating interval.
fn number(x: &RealAlgebraic) -> Value {
    let x = x.simplified();
    if let Some(x) = x.as_rational() {
        return json!(x.to_string());
    }
    let (lower, upper) = x.bounds();
    let coefficients: Vec<String> =
        x.polynomial().coefficients().iter().map(Integer::to_string).collect();
    json!({"polynomial": coefficients, "lower": lower.to_string(), "upper": upper.to_string()})
}

/// The parameters in the order of the plane, its maps up to the first order that holds nowhere, and a point
/// with the highest order that holds on a piece.
pub(super) fn plane(
    scheme: &Scheme,
    options: &ExplorerOptions,
    progress: &dyn Fn(&str),
) -> Result<(Vec<Parameter>, Value, Vec<Rational>), Diagnostic> {
    let (name, mask) = (scheme.name(), scheme.mask());
    let window = window(scheme, options)?;
    let mut maps = Vec::new();
    for n in 0..MOST_ORDERS {
        progress(&format!("map of C^{n}"));
        let found = map(name, mask, n, &window, &options.fineness)?;
        let last = !holds_somewhere(&found);
        maps.push(found);
        if last {
            break;
        }
    }
    let plane = &maps[0].plane;
    let parameters = plane.parameters().to_vec();
    let order = plane.order();
    let (difference, _) = mask.numerator().divide_by_geometric(mask.arity(), order);
    let difference: Value =
        difference.coefficients().iter().map(|c| terms(c, &parameters)).collect();
    let data: Vec<Value> = maps.iter().map(map_data).collect();
    let data = json!({
        "kind": "plane",
        "words": map_words(&maps[0], &options.fineness),
        "window": window.each_ref().map(|span| texts(span)),
        "coordinates": format!("({})", coordinates(plane).join(", ")),
        "factor": plane.factor().map(|l| texts(&[l.coefficient(0), l.coefficient(1)])),
        "order": order,
        "difference": difference,
        "maps": data,
    });
    let centre = maps.iter().rev().find_map(centre);
    let centre = centre.unwrap_or_else(|| window.map(|[low, high]| (low + high) / rational(2, 1)));
    Ok((parameters, data, centre.to_vec()))
}

fn window(scheme: &Scheme, options: &ExplorerOptions) -> Result<[[Rational; 2]; 2], Diagnostic> {
    match &options.window {
        Some(text) => parse_window(scheme, text),
        None => default_window(scheme.name(), scheme.mask(), 0),
    }
}

/// The smoothest member that is found in the box of a plane; none if it cannot be searched for.
pub(super) fn smoothest(scheme: &Scheme, options: &ExplorerOptions) -> Option<Vec<Rational>> {
    let window = window(scheme, options).ok()?;
    let found = landscape(scheme.name(), scheme.mask(), &window, [2, 2]).ok()?;
    found.highest().map(|summit| summit.parameters.to_vec())
}

/// The words by which a command line asks for maps of this box and fineness.
fn map_words(map: &Map, fineness: &Fineness) -> Vec<String> {
    let spans = map.plane.parameters().iter().zip(map.window());
    let spans: Vec<String> = spans.map(|(p, [low, high])| format!("{p}={low}..{high}")).collect();
    let mut words = vec!["--box".into(), spans.join(",")];
    if *fineness != Fineness::default() {
        words.extend(["--undecided".into(), fineness.undecided.to_string()]);
        words.extend(["--nodes".into(), fineness.nodes.to_string()]);
    }
    words
}

fn holds_somewhere(map: &Map) -> bool {
    map.cells.iter().any(|cell| cell.verdict == CellVerdict::Proved)
        || map.certificate.sections.iter().any(|section| !proved_on(section).is_empty())
}

/// Parameters with short numbers near the middle of a proved piece with the largest box around it.
fn centre(map: &Map) -> Option<[Rational; 2]> {
    let proved = map.cells.iter().filter(|cell| cell.verdict == CellVerdict::Proved);
    let boxes = proved.map(|cell| {
        let points = cell.polygon.points();
        [0, 1].map(|i| {
            let along = || points.iter().map(|p| p[i].clone());
            let low = along().min().expect("a polygon has corners");
            [low, along().max().expect("a polygon has corners")]
        })
    });
    let extent = |[[a, b], [c, d]]: &[[Rational; 2]; 2]| (b - a) * (d - c);
    let largest = boxes.max_by_key(extent)?;
    let middle =
        map.plane.parameters_at(&largest.map(|[low, high]| (low + high) / rational(2, 1)))?;
    let short = (3..20).map(|bits| {
        let parts = rational(1 << bits, 1);
        middle.each_ref().map(|x| (x * &parts).round() / &parts)
    });
    let is_proved = |point: &[Rational; 2]| map.verdict_at(point) == MapVerdict::Proved;
    short.into_iter().find(is_proved).or(Some(middle))
}

fn map_data(map: &Map) -> Value {
    let certificate = &map.certificate;
    let mut data = json!({
        "continuity": map.continuity(),
        "parts": parts_of_box(&certificate.family, &certificate.window)
            .map(|parts| parts.iter().map(|part| {
                part.points().iter().map(|p| texts(p)).collect::<Vec<_>>()
            }).collect::<Vec<_>>())
            .unwrap_or_default(),
    });
    let mut reasons = Reasons::of(map);
    let trees: Vec<Value> = certificate.roots.iter().map(|&root| reasons.tree(root)).collect();
    data["reasons"] = reasons.known.into();
    data["trees"] = trees.into();
    if map.continuity() >= certificate.family.order {
        let conditions = map.plane.divisibility(map.continuity() + 1);
        data["divisible"] = conditions.iter().map(form).collect();
        data["sections"] = certificate.sections.iter().map(section).collect();
    }
    data
}

/// The terms of a polynomial in `x` and `y`.
fn form(p: &Polynomial<Polynomial<Rational>>) -> Value {
    let rows = p.coefficients().iter().enumerate();
    let terms = rows.flat_map(|(j, row)| {
        let row = row.coefficients().iter().enumerate().filter(|(_, c)| !c.is_zero());
        row.map(move |(i, c)| json!([c.to_string(), i, j]))
    });
    terms.collect()
}

fn section(section: &Section) -> Value {
    let numbers = |p: &[Number; 2]| p.each_ref().map(|c| c.0.to_string());
    let mut parts = intervals(&proved_on(section), "proved", "t");
    if let Conclusion::Continuity { refuted, .. } = &section.certificate.conclusion {
        parts.extend(intervals(&region_of(refuted), "refuted", "t"));
    }
    json!({
        "origin": numbers(&section.origin),
        "direction": numbers(&section.direction),
        "intervals": parts,
    })
}

/// The reasons of the pieces of a map, each once.
struct Reasons<'a> {
    map: &'a Map,
    known: Vec<Value>,
    /// For each node the reason that all its pieces have, if it is one: such a node need not be cut.
    uniform: Vec<Option<usize>>,
}

impl<'a> Reasons<'a> {
    fn of(map: &'a Map) -> Self {
        let nodes = &map.certificate.nodes;
        let mut known: Vec<Value> = Vec::new();
        let mut uniform = vec![None; nodes.len()];
        for cell in &map.cells {
            let mut reason =
                json!({"verdict": verdict(cell.verdict), "because": because(&nodes[cell.node])});
            if cell.verdict == (CellVerdict::Refuted { if_stable: true }) {
                reason["if_stable"] = true.into();
            }
            let place = known.iter().position(|old| *old == reason).unwrap_or_else(|| {
                known.push(reason);
                known.len() - 1
            });
            uniform[cell.node] = Some(place);
        }
        // Parts have larger numbers than what was cut.
        for (index, node) in nodes.iter().enumerate().rev() {
            if let Node::Cut { below, above, .. } = node
                && uniform[*below] == uniform[*above]
            {
                uniform[index] = uniform[*below];
            }
        }
        Reasons { map, known, uniform }
    }

    /// The cuts from a node on.
    fn tree(&mut self, root: usize) -> Value {
        let mut walk = Vec::new();
        let mut open = vec![root];
        while let Some(at) = open.pop() {
            match (&self.map.certificate.nodes[at], self.uniform[at]) {
                (_, Some(reason)) => walk.push(json!(reason)),
                (Node::Cut { line, below, above }, None) => {
                    let (_, line) = clear_denominators(line.iter().map(|c| &c.0));
                    let line: Vec<String> = line.iter().map(Integer::to_string).collect();
                    walk.push(json!(line.join(" ")));
                    open.extend([*above, *below]);
                }
                (_, None) => unreachable!("every piece has a reason"),
            }
        }
        walk.into()
    }
}
