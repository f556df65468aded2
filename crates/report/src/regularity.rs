//! `regularity`: the Hölder exponent of a scheme without free parameters.

use refinable_algebra::{Rational, Ring, decimal};
use refinable_analysis::Regularity;
use refinable_scheme::{Scheme, geometric_factor};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::sharp::proof_text;

/// The regularity of a scheme as a table.
pub fn regularity_table(scheme: &Scheme, found: &Regularity) -> Document {
    let arity = scheme.mask().arity();
    let exact = exact_text(found, arity);
    let (lower, upper) = outward(found);
    let value = match &exact {
        Some(text) => text.clone(),
        None => bounds_text(&lower, upper.as_ref(), 12),
    };
    let continuity = match (found.continuity, &found.upper) {
        (Some(n), _) => format!("C^{n}"),
        // The joint spectral radius of the difference scheme is at least one. Masks are reduced only if they converge.
        (None, Some(upper)) if *upper <= Rational::zero() => "no continuous limit".into(),
        (None, _) => "not proved to converge".into(),
    };
    let divided = format!("factors {} divided out", geometric_factor(arity));
    let decimals = exact.as_ref().map(|_| ("decimals", format!("≈ {}", decimal(&lower, 10))));
    let rows = [
        Some(("Hölder exponent", value)),
        decimals,
        Some(("implies", continuity)),
        Some(("leading word", found.word.clone())),
        Some((&divided, found.divided_order.to_string())),
        Some(("stable shifts", yes_or_no(found.stable).unwrap_or("not known").into())),
    ];
    let mut remarks = Vec::new();
    if let Some(factor) = &found.factor {
        remarks.push(format!(
            "the exponent of the mask a(z) q(z)/q(z^2), q = {}, whose shifts are stable and whose limit \
             function is as smooth",
            factor.display("z")
        ));
    } else if found.upper.is_none() {
        remarks.push(
            match found.stable {
                Some(_) => "without stable shifts the exponent is a lower bound only",
                None => "the exponent is a lower bound only, unless the shifts are stable",
            }
            .into(),
        );
    }
    if let Some(certificate) = &found.certificate {
        remarks.push(format!("proof checked: {}", proof_text(certificate)));
    }
    let row = |(name, value): (&str, String)| vec![Cell::text(name), Cell::text(value)];
    let grid = Grid {
        id: "regularity".into(),
        caption: format!("Regularity of {}", scheme.name()),
        header: ["quantity", "value"].map(String::from).to_vec(),
        rows: rows.into_iter().flatten().map(row).collect(),
        remarks,
    };
    let mut holder = json!({
        "lower": lower.to_string(),
        "upper": upper.map(|upper| upper.to_string()),
        "approx": decimal(&lower, 15).parse::<f64>().map_or(Value::Null, Value::from),
    });
    if let Some(text) = &exact {
        holder["exact"] = Value::from(text.clone());
    }
    let json = json!({
        "scheme": scheme.name(),
        "holder": holder,
        "continuity": found.continuity,
        "stable": found.stable,
        "word": found.word,
        "divided_order": found.divided_order,
        "reduced_by": found.factor.as_ref().map(|factor| factor.display("z")),
    });
    Document { grids: vec![grid], summary: None, json }
}

/// Both bounds rounded outward to 15 decimals, but equal integers as they are.
pub fn outward(found: &Regularity) -> (Rational, Option<Rational>) {
    let scale = Rational::from_i64(1_000_000_000_000_000);
    let upper = found.upper.as_ref().map(|upper| (upper * &scale).ceil() / &scale);
    ((&found.lower * &scale).floor() / &scale, upper)
}

/// `[2.83, 2.84]`, or `≥ 2.83` if there is no upper bound.
pub(crate) fn bounds_text(lower: &Rational, upper: Option<&Rational>, digits: u32) -> String {
    match upper {
        Some(upper) => format!("[{}, {}]", decimal(lower, digits), decimal(upper, digits)),
        None => format!("≥ {}", decimal(lower, digits)),
    }
}

/// The word for what is known, if it is.
pub(crate) fn yes_or_no(known: Option<bool>) -> Option<&'static str> {
    known.map(|yes| if yes { "yes" } else { "no" })
}

/// `3 - log2(9/8)`: the largest power of the arity taken out of the radius.
pub(crate) fn exact_text(found: &Regularity, arity: usize) -> Option<String> {
    let scale = found.scale.as_ref()?;
    let base = Rational::from_i64(arity as i64);
    let mut whole = found.divided_order as i64 - 1;
    if let Some(rational) = scale.as_rational() {
        let mut radius = Rational::one() / rational;
        while radius >= base {
            radius /= &base;
            whole -= 1;
        }
        while radius < Rational::one() {
            radius *= &base;
            whole += 1;
        }
        if radius == Rational::one() {
            return Some(whole.to_string());
        }
        return Some(format!("{whole} - log{arity}({radius})"));
    }
    Some(format!("{whole} + log{arity}({})", scale.exact_form().display("x")))
}
