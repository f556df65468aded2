//! What the page of an explorer is told: exact numbers as text, so that it can go on exactly.
//!
//! Polynomials in the parameters are lists of `[c, i, j]` for `c u^i v^j`; a family of one parameter has `j = 0`.

use refinable_algebra::{Monomial, Parameter, ParameterPolynomial, Rational};
use refinable_analysis::{
    Degrees, Stratum, TensionChoice, degrees, interpolating_value, interproximate_tensions,
};
use refinable_reals::Component;
use refinable_scheme::{Diagnostic, Mask, Scheme};
use serde_json::{Value, json};

use super::ExplorerOptions;
use super::smoothness::{line, members, plane, single, smoothest};
use crate::degrees::condition;

/// All that the page is told.
pub(super) fn of(
    scheme: &Scheme,
    options: &ExplorerOptions,
    progress: &dyn Fn(&str),
) -> Result<Value, Diagnostic> {
    let mask = scheme.mask();
    let free: Vec<Parameter> = mask.parameters().into_iter().collect();
    let mut smoothest: Option<Vec<Rational>> = None;
    let (parameters, smoothness, centre) = match free.len() {
        0 => (free, single(scheme.name(), mask, progress)?, Vec::new()),
        1 => {
            let (ranges, centre, value) = line(scheme, progress)?;
            smoothest = value.map(|value| vec![value]);
            (free, ranges, vec![centre])
        }
        _ => plane(scheme, options, progress)?,
    };
    progress("interpolating members");
    let tensions = tensions(scheme, &parameters);
    match &tensions {
        Tensions::Chosen(choice) => {
            smoothest = Some(in_order(mask, &parameters, &choice.approximating));
        }
        _ if parameters.len() == 2 => {
            progress("the smoothest member");
            smoothest = self::smoothest(scheme, options);
        }
        _ => {}
    }
    // It may be outside of a box that was asked for.
    let start = match &smoothest {
        Some(point) if options.window.is_none() && parameters.len() == 2 => point.clone(),
        _ => centre,
    };
    let found = degrees(mask);
    let special = found.strata.iter().filter_map(|stratum| match &stratum.locus {
        Component::Point(point) => point.rational_coordinates(&parameters),
        _ => None,
    });
    let mut notable = Vec::from_iter(smoothest.clone());
    for point in special {
        if !notable.contains(&point) {
            notable.push(point);
        }
    }
    Ok(json!({
        "scheme": scheme.name(),
        "words": options.words,
        "arity": mask.arity(),
        "parameters": parameters.iter().map(Parameter::name).collect::<Vec<_>>(),
        "mask": mask_data(mask, &parameters),
        "start": texts(&start),
        "degrees": degree_data(&found, &parameters),
        "smoothness": smoothness,
        "smoothest": smoothest.as_deref().map(texts),
        "members": members(scheme, &parameters, &notable, progress),
        "interpolating": tensions.data(mask, &parameters),
    }))
}

/// Numbers as text.
pub(super) fn texts(numbers: &[Rational]) -> Vec<String> {
    numbers.iter().map(ToString::to_string).collect()
}

/// The terms `[c, i, j]` of a polynomial in at most two parameters.
pub(super) fn terms(p: &ParameterPolynomial, parameters: &[Parameter]) -> Value {
    let term = |(monomial, c): (&Monomial, &Rational)| {
        let exponent = |k: usize| parameters.get(k).map_or(0, |p| monomial.exponent(p));
        json!([c.to_string(), exponent(0), exponent(1)])
    };
    p.terms().map(term).collect()
}

fn mask_data(mask: &Mask, parameters: &[Parameter]) -> Value {
    let (first, last) = mask.support();
    let coefficients: Value =
        (first..=last).map(|i| terms(&mask.numerator().coefficient(i), parameters)).collect();
    json!({
        "first": first,
        "coefficients": coefficients,
        "denominator": terms(mask.denominator(), parameters),
    })
}

/// The strata. A point with irrational coordinates is told in words only: no rational point is it.
fn degree_data(found: &Degrees, parameters: &[Parameter]) -> Value {
    let stratum = |stratum: &Stratum| {
        let mut data = json!({
            "condition": condition(&stratum.locus),
            "generation": stratum.generation.0,
            "reproduction": stratum.reproduction.0,
        });
        match &stratum.locus {
            Component::Space => {}
            Component::Hypersurface(f) => data["vanishes"] = terms(f, parameters),
            Component::Point(point) => {
                let point = point.rational_coordinates(parameters);
                data["point"] = point.map_or(Value::Null, |point| json!(texts(&point)));
            }
        }
        data
    };
    let strata: Vec<Value> = found.strata.iter().map(stratum).collect();
    json!({"complete": found.complete, "strata": strata})
}

/// The members by which vertices can be interpolated.
enum Tensions {
    /// One that was chosen, with the member that goes well with it.
    Chosen(Box<TensionChoice>),
    /// The only one.
    Value(Rational),
    /// None, and why.
    None(String),
}

fn tensions(scheme: &Scheme, parameters: &[Parameter]) -> Tensions {
    let mask = scheme.mask();
    if mask.is_interpolatory() {
        return Tensions::None("every vertex is interpolated already".into());
    }
    match (parameters.len(), interpolating_value(mask)) {
        (0, _) => Tensions::None("the scheme has no free parameter".into()),
        (1, Some((_, value))) => Tensions::Value(value),
        (2, Some(_)) => match interproximate_tensions(scheme.name(), mask) {
            Ok(choice) => Tensions::Chosen(choice.into()),
            Err(error) => Tensions::None(error.message().to_string()),
        },
        _ => {
            let text = "no value of a parameter was found at which the vertex rule of a binary family keeps old points";
            Tensions::None(text.into())
        }
    }
}

impl Tensions {
    fn data(&self, mask: &Mask, parameters: &[Parameter]) -> Value {
        match self {
            Tensions::Chosen(choice) => json!({
                "values": texts(&in_order(mask, parameters, &choice.interpolating)),
            }),
            Tensions::Value(value) => json!({"values": texts(std::slice::from_ref(value))}),
            Tensions::None(reason) => json!({"missing": reason}),
        }
    }
}

/// Values in the order of the parameters of a mask, in another order of them.
fn in_order(mask: &Mask, parameters: &[Parameter], values: &[Rational]) -> Vec<Rational> {
    let known: Vec<Parameter> = mask.parameters().into_iter().collect();
    let value = |p| known.iter().position(|q| q == p).and_then(|k| values.get(k)).cloned();
    parameters.iter().filter_map(value).collect()
}
