//! `show`: a scheme's mask, support and kind; and its derivation.

use refinable_algebra::{ParameterPolynomial, Ring};
use refinable_analysis::{Classification, classify};
use refinable_reals::real_roots;
use refinable_scheme::{Mask, Scheme};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::latex;

/// Mask, support and classification of a scheme.
pub fn show(scheme: &Scheme) -> Document {
    let mask = scheme.mask();
    let kind = classify(mask);
    let (lowest, highest) = mask.support();
    let rows = mask.coefficients().map(|(index, coefficient)| {
        let exact = Cell::math(coefficient.to_string(), &latex::fraction(&coefficient));
        vec![Cell::text(index.to_string()), exact]
    });
    let parameters: Vec<String> = mask.parameters().iter().map(ToString::to_string).collect();
    let mut remarks = vec![
        format!("support [{lowest}, {highest}], support width {}", mask.support_width()),
        format!("type: {}", words(&kind).join(", ")),
    ];
    if !parameters.is_empty() {
        remarks.push(format!("parameters: {}", parameters.join(", ")));
    }
    if let Some(pole) = pole(mask) {
        remarks.push(pole);
    }
    let grid = Grid {
        id: "mask".into(),
        caption: format!("Mask of {} (arity {})", scheme.name(), mask.arity()),
        header: vec!["index".into(), "coefficient".into()],
        rows: rows.collect(),
        remarks,
    };
    Document { json: json(scheme, &kind, &parameters), grids: vec![grid], summary: None }
}

/// The adjectives that hold for all parameter values, in the order papers use.
pub fn words(kind: &Classification) -> Vec<&'static str> {
    let all = [
        (kind.primal, "primal"),
        (kind.dual, "dual"),
        (kind.interpolatory, "interpolatory"),
        (kind.approximating, "approximating"),
        (kind.combined == Some(true), "combined"),
        (kind.relaxed, "relaxed"),
    ];
    all.into_iter().filter_map(|(holds, word)| holds.then_some(word)).collect()
}

/// The sentence on the values at which the family is not defined, if there may be some.
pub fn pole(mask: &Mask) -> Option<String> {
    let denominator = mask.denominator();
    may_vanish(denominator).then(|| format!("not defined where {denominator:#} = 0"))
}

/// Whether a polynomial may vanish for real values of its parameters; decided if it has only one and a degree of
/// at most 60.
pub(crate) fn may_vanish(p: &ParameterPolynomial) -> bool {
    let parameters = p.parameters();
    match parameters.iter().collect::<Vec<_>>()[..] {
        [] => p.is_zero(),
        [only] if p.degree() <= Some(60) => {
            p.cleared_univariate(only).is_none_or(|(_, cleared)| !real_roots(&cleared).is_empty())
        }
        _ => true,
    }
}

fn json(scheme: &Scheme, kind: &Classification, parameters: &[String]) -> Value {
    let mask = scheme.mask();
    let (lowest, highest) = mask.support();
    let entries: Vec<Value> = mask
        .coefficients()
        .map(|(index, c)| json!({"index": index, "coefficient": c.to_string()}))
        .collect();
    let width = mask.support_width();
    // A whole number where it is one (always for arity 2), an exact fraction as text otherwise.
    let width = match i64::try_from(width.numer()) {
        Ok(whole) if width.is_integer() => json!(whole),
        _ => json!(width.to_string()),
    };
    json!({
        "name": scheme.name(),
        "arity": mask.arity(),
        "parameters": parameters,
        "support": [lowest, highest],
        "mask": entries,
        "type": {
            "primal": kind.primal,
            "dual": kind.dual,
            "interpolatory": kind.interpolatory,
            "approximating": kind.approximating,
            "combined": kind.combined,
            "relaxed": kind.relaxed,
        },
        "support_width": width,
        "denominator": mask.denominator().to_string(),
    })
}
