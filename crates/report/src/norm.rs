//! `norm`: the norm of a difference scheme as a formula.

use refinable_algebra::{ParameterPolynomial, Rational, Ring, integer};
use refinable_analysis::{Budget, Norm, NormRow};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::latex;

/// `‖c_n^L‖` of a scheme, row by row.
///
/// # Errors
/// As for [`Norm::of_difference`].
pub fn norm_table(
    scheme: &Scheme,
    continuity: usize,
    level: u32,
    budget: Budget,
) -> Result<Document, Diagnostic> {
    let norm = Norm::of_difference(scheme.mask(), continuity, level, budget)?;
    let rows = norm.rows().iter().enumerate();
    let rows = rows.map(|(k, row)| {
        let text = Norm::new(&[weighted(row)], ParameterPolynomial::one()).to_string();
        vec![Cell::text((k + 1).to_string()), Cell::math(text, &row_latex(row))]
    });
    let grid = Grid {
        id: "norm".into(),
        caption: format!("Rows of the norm of c_{continuity}^{level} of {}", scheme.name()),
        header: vec!["row".into(), "sum of absolute values".into()],
        rows: rows.collect(),
        remarks: Vec::new(),
    };
    let json = json!({
        "scheme": scheme.name(),
        "continuity": continuity,
        "level": level,
        "norm": norm.to_string(),
        "rows": norm.rows().iter().map(row_json).collect::<Vec<_>>(),
        "denominator": norm.denominator().to_string(),
    });
    let summary = Some(format!("‖c_{continuity}^{level}‖ = {norm}"));
    Ok(Document { grids: vec![grid], summary, json })
}

fn weighted(row: &NormRow) -> Vec<ParameterPolynomial> {
    row.iter().map(|(factor, p)| p.scaled(factor)).collect()
}

fn row_latex(row: &NormRow) -> String {
    let one = ParameterPolynomial::one();
    let terms: Vec<String> = row
        .iter()
        .map(|(factor, p)| match (*p == one, *factor == Rational::from(integer(1))) {
            (true, _) => latex::rational(factor),
            (false, true) => format!("\\left|{}\\right|", latex::polynomial(p)),
            (false, false) => {
                format!("{}\\left|{}\\right|", latex::rational(factor), latex::polynomial(p))
            }
        })
        .collect();
    if terms.is_empty() { "0".into() } else { terms.join("+") }
}

fn row_json(row: &NormRow) -> Value {
    let term = |(factor, p): &(Rational, ParameterPolynomial)| json!({"factor": factor.to_string(), "polynomial": p.to_string()});
    row.iter().map(term).collect()
}
