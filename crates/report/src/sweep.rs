//! `regularity --sweep`: the Hölder exponent over one parameter.

use std::fmt::Write;

use rayon::prelude::*;
use refinable_algebra::{ParameterFraction, ParameterPolynomial, Rational, Ring, decimal};
use refinable_analysis::{Options, Regularity, regularity};
use refinable_scheme::{Diagnostic, Scheme, Substitution};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::range::only_parameter;
use crate::regularity::{outward, yes_or_no};
use crate::span::{named, parse_ascending_span};
use crate::svg::{escape, place};

/// Steps if none are given, and the most that are taken.
const STEPS: u32 = 64;
const MOST_STEPS: u32 = 4096;
/// How often the interval around the best value is divided.
const REFINEMENTS: usize = 3;

/// Certified exponents at rational values of a parameter.
#[derive(Clone, Debug)]
pub struct Sweep {
    scheme: String,
    parameter: String,
    /// Ascending values; `None` where no bounds were found.
    points: Vec<(Rational, Option<Regularity>)>,
    best: Option<(Rational, Regularity)>,
}

impl Sweep {
    /// The sweep that `alpha=0..1/16:64` asks for.
    ///
    /// # Errors
    /// A text that is no such request; code `parameters` unless one parameter is free.
    pub fn new(scheme: &Scheme, request: &str, options: &Options) -> Result<Self, Diagnostic> {
        let parameter = only_parameter(scheme)?;
        let (from, to, steps) = parse(request, parameter.name())?;
        let at = |x: &Rational| -> Option<Regularity> {
            let value = ParameterFraction::from(ParameterPolynomial::constant(x.clone()));
            let fixed = scheme.with(&[Substitution::new(parameter.clone(), value)]).ok()?;
            regularity(scheme.name(), fixed.mask(), options).ok()
        };
        let grid = |from: &Rational, to: &Rational, steps: u32| -> Vec<Rational> {
            let step = (to - from) / Rational::from_i64(i64::from(steps));
            (0..=steps).map(|k| from + &step * Rational::from_i64(i64::from(k))).collect()
        };
        let values = grid(&from, &to, steps);
        let found: Vec<Option<Regularity>> = values.par_iter().map(at).collect();
        let points: Vec<(Rational, Option<Regularity>)> = values.into_iter().zip(found).collect();
        let mut best = highest(&points);
        let mut step = (&to - &from) / Rational::from_i64(i64::from(steps));
        for _ in 0..REFINEMENTS {
            let Some((x, _)) = &best else { break };
            let (left, right) = ((x - &step).max(from.clone()), (x + &step).min(to.clone()));
            let values = grid(&left, &right, 8);
            let found: Vec<Option<Regularity>> = values.par_iter().map(at).collect();
            let closer: Vec<_> = values.into_iter().zip(found).collect();
            best = highest(&closer).or(best);
            step /= Rational::from_i64(4);
        }
        let parameter = parameter.name().to_string();
        Ok(Sweep { scheme: scheme.name().into(), parameter, points, best })
    }

    /// One row for each value, and the highest exponent found.
    pub fn document(&self) -> Document {
        let row = |x: &Rational, found: &Option<Regularity>| match found {
            Some(found) => {
                let (lower, upper) = outward(found);
                let continuity = found.continuity.map_or(String::new(), |n| n.to_string());
                let upper = upper.map_or(String::new(), |upper| upper.to_string());
                let stable = yes_or_no(found.stable).unwrap_or_default();
                [x.to_string(), lower.to_string(), upper, decimal(&lower, 10)]
                    .into_iter()
                    .chain([continuity, found.word.clone(), stable.into()])
                    .map(Cell::text)
                    .collect()
            }
            None => std::iter::once(Cell::text(x.to_string()))
                .chain((0..6).map(|_| Cell::text("")))
                .collect(),
        };
        let rows: Vec<Vec<Cell>> = self.points.iter().map(|(x, found)| row(x, found)).collect();
        let mut remarks = Vec::new();
        if let Some((x, found)) = &self.best {
            let (parameter, value) = (&self.parameter, decimal(&found.lower, 10));
            remarks.push(format!("highest exponent found: ≈ {value} at {parameter} = {x}"));
        }
        let header =
            [&self.parameter, "lower", "upper", "decimals", "continuity", "word", "stable"];
        let grid = Grid {
            id: "sweep".into(),
            caption: format!("Hölder exponents of {}", self.scheme),
            header: header.map(String::from).to_vec(),
            rows,
            remarks,
        };
        let point = |x: &Rational, found: &Regularity| {
            let (lower, upper) = outward(found);
            json!({
                "at": x.to_string(), "lower": lower.to_string(),
                "upper": upper.map(|upper| upper.to_string()),
                "continuity": found.continuity, "word": found.word, "stable": found.stable,
            })
        };
        let points: Vec<Value> = self
            .points
            .iter()
            .map(|(x, found)| match found {
                Some(found) => point(x, found),
                None => json!({"at": x.to_string()}),
            })
            .collect();
        let maximum = self.best.as_ref().map(|(x, found)| point(x, found));
        let json = json!({
            "scheme": self.scheme, "parameter": self.parameter, "points": points,
            "maximum": maximum,
        });
        Document { grids: vec![grid], summary: None, json }
    }

    /// The exponent as a curve, the orders of continuity as levels, the highest value marked.
    pub fn picture(&self) -> String {
        let known: Vec<(f64, f64)> = self
            .points
            .iter()
            .filter_map(|(x, found)| Some((place(x), place(&found.as_ref()?.lower))))
            .collect();
        let first = self.points.first().map_or(0.0, |(x, _)| place(x));
        let last = self.points.last().map_or(1.0, |(x, _)| place(x));
        let top = known.iter().map(|p| p.1).fold(1.0, f64::max).ceil();
        let bottom = known.iter().map(|p| p.1).fold(0.0, f64::min).floor().max(-2.0);
        let x = |v: f64| LEFT + (v - first) / (last - first) * WIDTH;
        let y = |r: f64| TOP + (top - r.max(bottom)) / (top - bottom) * HEIGHT;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0} {:.0}\" \
             font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" \
             fill=\"#ffffff\"/>\n<text x=\"{LEFT:.0}\" y=\"18\">Hölder exponent of {} over {}</text>\n",
            LEFT + WIDTH + 30.0,
            TOP + HEIGHT + 50.0,
            escape(&self.scheme),
            escape(&self.parameter),
        );
        for level in bottom as i32..=top as i32 {
            let at = y(f64::from(level));
            let _ = write!(
                svg,
                "<line x1=\"{LEFT:.1}\" y1=\"{at:.1}\" x2=\"{:.1}\" y2=\"{at:.1}\" \
                 stroke=\"#cccccc\"/>\n<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{level}</text>\n",
                LEFT + WIDTH,
                LEFT - 6.0,
                at + 4.0,
            );
        }
        let curve: Vec<String> =
            known.iter().map(|p| format!("{:.2},{:.2}", x(p.0), y(p.1))).collect();
        let _ = writeln!(
            svg,
            "<polyline fill=\"none\" stroke=\"#1f4e8c\" stroke-width=\"2\" points=\"{}\"/>",
            curve.join(" ")
        );
        if let Some((at, found)) = &self.best {
            let (cx, cy) = (x(place(at)), y(place(&found.lower)));
            let _ = writeln!(
                svg,
                "<circle cx=\"{cx:.2}\" cy=\"{cy:.2}\" r=\"4\" fill=\"#b3261e\"/>\n\
                 <text x=\"{cx:.2}\" y=\"{:.2}\" text-anchor=\"middle\">≈ {} at {at}</text>",
                cy - 9.0,
                decimal(&found.lower, 6),
            );
        }
        for (value, anchor) in [(self.points.first(), "start"), (self.points.last(), "end")] {
            if let Some((value, _)) = value {
                let _ = writeln!(
                    svg,
                    "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\">{value}</text>",
                    x(place(value)),
                    TOP + HEIGHT + 20.0,
                );
            }
        }
        svg.push_str("</svg>\n");
        svg
    }
}

const LEFT: f64 = 50.0;
const TOP: f64 = 40.0;
const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 340.0;

fn highest(points: &[(Rational, Option<Regularity>)]) -> Option<(Rational, Regularity)> {
    let known = points.iter().filter_map(|(x, found)| Some((x, found.as_ref()?)));
    // The first of equal ones, so that the order of the work does not matter.
    known
        .reduce(|best, next| if next.1.lower > best.1.lower { next } else { best })
        .map(|(x, found)| (x.clone(), found.clone()))
}

fn parse(request: &str, parameter: &str) -> Result<(Rational, Rational, u32), Diagnostic> {
    let error = |message: String| {
        let hint = format!("for example --sweep '{parameter}=0..1/16:64'");
        Diagnostic::new("sweep", message).with_hint(hint)
    };
    let (name, rest) = named(request).map_err(error)?;
    if name != parameter {
        return Err(error(format!("the free parameter is {parameter}, not {name}")));
    }
    let (interval, steps) = match rest.split_once(':') {
        Some((interval, steps)) => (interval, steps.trim().parse::<u32>().ok()),
        None => (rest, Some(STEPS)),
    };
    let steps = steps.filter(|steps| (1..=MOST_STEPS).contains(steps));
    let steps =
        steps.ok_or_else(|| error(format!("the steps are a number from 1 to {MOST_STEPS}")))?;
    let [from, to] = parse_ascending_span(interval).map_err(error)?;
    Ok((from, to, steps))
}
