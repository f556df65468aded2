//! `degrees`: the strata of generation and reproduction.

use refinable_algebra::{Parameter, ParameterFraction, ParameterPolynomial, Ring};
use refinable_analysis::{Degrees, Stratum, degrees};
use refinable_reals::{Component, Point};
use refinable_scheme::Scheme;
use serde_json::{Map, Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::latex;
use crate::number::{approximation, number, rational_number};

/// The degree ladder of a scheme, generic stratum first.
pub fn degree_table(scheme: &Scheme) -> Document {
    let degrees = degrees(scheme.mask());
    let rows = degrees.strata.iter().map(|stratum| {
        vec![
            Cell::text(condition(&stratum.locus)),
            Cell::text(solved(&stratum.locus).join(", or ")),
            Cell::text(stratum.generation.to_string()),
            Cell::text(stratum.reproduction.to_string()),
            tau_cell(&tau(&degrees, stratum)),
        ]
    });
    let mut remarks = Vec::new();
    remarks.extend(crate::show::pole(scheme.mask()));
    if !degrees.complete {
        remarks.push(INCOMPLETE.into());
    }
    let header = ["condition", "solved", "generation", "reproduction", "tau"];
    let grid = Grid {
        id: "degrees".into(),
        caption: format!("Degrees of {}", scheme.name()),
        header: header.map(String::from).to_vec(),
        rows: rows.collect(),
        remarks,
    };
    let strata: Vec<Value> = degrees.strata.iter().map(|s| stratum_json(&degrees, s)).collect();
    let json = json!({
        "scheme": scheme.name(),
        "strata": strata,
        "complete": degrees.complete,
    });
    Document { grids: vec![grid], summary: None, json }
}

pub(crate) const INCOMPLETE: &str = "incomplete: the conditions have too many parameters, or too high a degree, to be solved to the end";

/// `generic`, an equation, or the coordinates of a point.
pub fn condition(locus: &Component) -> String {
    match locus {
        Component::Space => "generic".into(),
        Component::Hypersurface(f) => format!("{f:#} = 0"),
        Component::Point(point) => coordinates(point),
    }
}

/// `alpha = 3/16, beta = 1/26`.
pub fn coordinates(point: &Point) -> String {
    let texts = point.coordinates().iter().map(|(parameter, x)| {
        let exact = x.exact_form().display(parameter.name());
        format!("{parameter} = {exact}{}", approximation(x))
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// The equation of a curve solved for each parameter in which it is linear.
fn solved(locus: &Component) -> Vec<String> {
    solutions(locus).into_iter().map(|(p, value)| format!("{p} = {value}")).collect()
}

/// For each parameter in which the equation of a curve is linear, its value as a function of the
/// others. Where the denominator vanishes the curve has no point, as the polynomial is square-free
/// and the numerator has no common factor with it, but for finitely many points.
pub fn solutions(locus: &Component) -> Vec<(Parameter, ParameterFraction)> {
    let Component::Hypersurface(f) = locus else {
        return Vec::new();
    };
    let linear = |p: &Parameter| {
        let collected = f.collected(p);
        if collected.degree() != Some(1) || collected.content().as_constant().is_none() {
            return None;
        }
        let value =
            ParameterFraction::new(collected.coefficient(0).negated(), &collected.coefficient(1));
        Some((p.clone(), value.ok()?))
    };
    f.parameters().iter().rev().filter_map(linear).collect()
}

/// τ on a stratum: the coordinates of a point put in where they are rational.
fn tau(degrees: &Degrees, stratum: &Stratum) -> ParameterFraction {
    let Component::Point(point) = &stratum.locus else {
        return degrees.tau.clone();
    };
    point.coordinates().iter().fold(degrees.tau.clone(), |tau, (parameter, x)| {
        let value = x.as_rational().map(|x| ParameterPolynomial::constant(x.clone()).into());
        let substituted = value.and_then(|value| tau.substitute(parameter, &value).ok());
        substituted.unwrap_or(tau)
    })
}

fn tau_cell(tau: &ParameterFraction) -> Cell {
    Cell::math(tau.to_string(), &latex::fraction(tau))
}

fn stratum_json(degrees: &Degrees, stratum: &Stratum) -> Value {
    let mut parameters = Map::new();
    if let Component::Point(point) = &stratum.locus {
        for (parameter, x) in point.coordinates() {
            parameters.insert(parameter.to_string(), number(x, parameter.name()));
        }
    }
    let tau = tau(degrees, stratum);
    let tau = match tau.as_constant() {
        Some(tau) => rational_number(&tau),
        None => json!({"exact": tau.to_string()}),
    };
    json!({
        "condition": condition(&stratum.locus),
        "solved": solved(&stratum.locus),
        "parameters": parameters,
        "generation": stratum.generation.0,
        "reproduction": stratum.reproduction.0,
        "tau": tau,
    })
}
