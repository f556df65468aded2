//! `range`: where C^n is proved and where it is refuted, from both sides.

use refinable_algebra::decimal;
use refinable_analysis::{
    Budget, ContinuityRange, Line, PointVerdict, Sharpness, along_curve, continuity_range,
    region_of,
};
use refinable_certificate::{Certificate, Conclusion, Lemma};
use refinable_reals::Region;
use refinable_scheme::{Diagnostic, Scheme, geometric_factor};
use serde_json::{Value, json};

use crate::audit::short;
use crate::grid::{Cell, Document, Grid};
use crate::latex;
use crate::number::{intervals, number};
use crate::range::{decimals, interval_cell, only_parameter, range_table};

/// The exact range of C^n over the one free parameter of a scheme, with the checked proof.
///
/// # Errors
/// Code `parameters` unless exactly one parameter is free and the masks lie on a line.
pub fn sharp_range(
    scheme: &Scheme,
    continuity: usize,
    sharpness: &Sharpness,
) -> Result<ContinuityRange, Diagnostic> {
    let parameter = only_parameter(scheme)?;
    continuity_range(scheme.name(), scheme.mask(), &parameter, continuity, sharpness)
}

/// The highest level of norms tried where the masks of a family lie on no line.
const CURVED_LEVEL: u32 = 4;

/// The range of C^n of a scheme with one free parameter, as sharp as the theory allows: from both sides if
/// the masks of the family lie on a line, otherwise what norms prove, with the rest undecided for that reason.
///
/// # Errors
/// Code `parameters` unless exactly one parameter is free; `budget` if even norms of level 1 cost too much.
pub fn any_range_table(
    scheme: &Scheme,
    continuity: usize,
    sharpness: &Sharpness,
) -> Result<Document, Diagnostic> {
    only_parameter(scheme)?;
    if Line::new(scheme.name(), scheme.mask()).is_some() {
        return Ok(sharp_range_table(scheme, &sharp_range(scheme, continuity, sharpness)?));
    }
    let by_norms = |level| range_table(scheme, continuity, level, Budget::default());
    let highest = (2..=CURVED_LEVEL).rev().find_map(|level| by_norms(level).ok());
    let mut document = highest.map_or_else(|| by_norms(1), Ok)?;
    let reason = "the masks of this family lie on no line, so that nothing but norms is known to \
                  decide: nothing is refuted";
    document.grids[0].remarks.push(reason.into());
    let is_exact = document.json["undecided"].as_array().is_some_and(Vec::is_empty);
    document.json["exact"] = is_exact.into();
    document.json["undecided_because"] = json!([reason]);
    Ok(document)
}

/// A range as a table: proved, refuted and undecided intervals of the whole line.
fn sharp_range_table(scheme: &Scheme, range: &ContinuityRange) -> Document {
    let variable = range.parameter.name();
    let undecided = range.undecided();
    let mut rows = Vec::new();
    for (region, verdict) in
        [(&range.proved, "proved"), (&range.refuted, "refuted"), (&undecided, "undecided")]
    {
        rows.extend(region.intervals().iter().map(|part| {
            vec![Cell::text(verdict), interval_cell(part, variable), Cell::text(decimals(part))]
        }));
    }
    let poles = range.points.iter().filter(|(_, verdict)| *verdict == PointVerdict::Pole);
    rows.extend(poles.map(|(t, _)| {
        let point = Region::point(t.clone());
        let exact = Cell::math(point.display(variable), &latex::region(&point, variable));
        vec![Cell::text("undefined"), exact, Cell::text(t.decimal(6))]
    }));
    let grid = Grid {
        id: "range".into(),
        caption: format!("C^{} of {}", range.continuity, scheme.name()),
        header: ["verdict", variable, "decimals"].map(String::from).to_vec(),
        rows,
        remarks: remarks(range),
    };
    Document { grids: vec![grid], summary: None, json: json_of(scheme, range) }
}

fn json_of(scheme: &Scheme, range: &ContinuityRange) -> Value {
    let variable = range.parameter.name();
    let points: Vec<Value> = range
        .points
        .iter()
        .map(|(t, verdict)| json!({"at": number(t, variable), "verdict": word(*verdict)}))
        .collect();
    json!({
        "scheme": scheme.name(),
        "parameter": variable,
        "continuity": range.continuity,
        "proved": intervals(&range.proved, variable),
        "refuted": intervals(&range.refuted, variable),
        "undecided": intervals(&range.undecided(), variable),
        "points": points,
        "exact": range.is_exact(),
        "words": words(&range.certificate),
        "undecided_because": undecided_because(range),
    })
}

/// The word for a verdict.
pub(crate) fn word(verdict: PointVerdict) -> &'static str {
    match verdict {
        PointVerdict::Proved => "proved",
        PointVerdict::Refuted => "refuted",
        PointVerdict::Unstable => "unstable",
        PointVerdict::Undecided => "undecided",
        PointVerdict::Pole => "undefined",
    }
}

fn remarks(range: &ContinuityRange) -> Vec<String> {
    let mut remarks = Vec::new();
    let order = range.continuity + 1;
    let indivisible =
        range.certificate.lemmas.iter().any(|lemma| matches!(lemma, Lemma::Indivisible { .. }));
    if indivisible {
        let factor = geometric_factor(range.certificate.family.arity);
        remarks.push(format!("refuted where ({factor})^{order} does not divide the symbol"));
    }
    let words = words(&range.certificate);
    if !words.is_empty() {
        remarks.push(format!(
            "refuted where the product along a word has spectral radius at least 1: {}",
            words.join(", ")
        ));
    }
    remarks.extend(undecided_because(range));
    remarks.push(format!("proof checked: {}", proof_text(&range.certificate)));
    remarks
}

/// Why something is left undecided, if it is.
pub(crate) fn undecided_because(range: &ContinuityRange) -> Vec<String> {
    let mut reasons = Vec::new();
    if range.points.iter().any(|(_, verdict)| *verdict == PointVerdict::Unstable) {
        reasons.push(
            "undecided values: the difference scheme is not contractive, but the shifts of the basic \
             limit function may not be stable there",
        );
    }
    let has = |kind: fn(&Lemma) -> bool| range.certificate.lemmas.iter().any(kind);
    let refuting = has(|l| matches!(l, Lemma::Word { .. } | Lemma::Indivisible { .. }));
    if !range.is_exact()
        && range.continuity > 0
        && refuting
        && !has(|l| matches!(l, Lemma::Stable { .. }))
    {
        reasons.push(
            "undecided intervals: where contraction fails nothing is refuted, because it is not known \
             that the shifts of the basic limit function are stable",
        );
    } else if !range.is_exact() {
        reasons.push(
            "undecided intervals: no proof was found there; a gap is left at an end at which a complex pair of \
             eigenvalues, or several words at once, lead",
        );
    }
    reasons.into_iter().map(String::from).collect()
}

/// `2 polytopes, 1 norm, 3 word intervals, …`.
pub fn proof_text(certificate: &Certificate) -> String {
    let lemmas = &certificate.lemmas;
    let count = |kind: fn(&Lemma) -> bool| lemmas.iter().filter(|lemma| kind(lemma)).count();
    let plural = |n: usize, noun: &str| match n {
        0 => None,
        1 => Some(format!("1 {noun}")),
        _ => Some(format!("{n} {noun}s")),
    };
    let parts = [
        plural(count(|l| matches!(l, Lemma::Polytope(_))), "polytope"),
        plural(count(|l| matches!(l, Lemma::Norm { .. })), "norm"),
        plural(count(|l| matches!(l, Lemma::Word { .. })), "word interval"),
        plural(count(|l| matches!(l, Lemma::Indivisible { .. })), "division"),
        plural(count(|l| matches!(l, Lemma::At { .. })), "single value"),
        plural(count(|l| matches!(l, Lemma::Convergence { .. })), "convergence statement"),
        plural(count(|l| matches!(l, Lemma::Reduced { .. })), "reduced mask"),
        plural(count(|l| matches!(l, Lemma::Nonnegative { .. })), "non-negative symbol"),
        plural(count(|l| matches!(l, Lemma::Stable { .. })), "stability"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The words of a certificate, each once, in order.
pub(crate) fn words(certificate: &Certificate) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for lemma in &certificate.lemmas {
        for lemma in lemma.inside().unwrap_or(std::slice::from_ref(lemma)) {
            if let Lemma::Word { word, .. } = lemma
                && !words.contains(word)
            {
                words.push(word.clone());
            }
        }
    }
    words
}

/// The theorem of a certificate in one line.
pub fn statement(certificate: &Certificate) -> String {
    let family = &certificate.family;
    match &certificate.conclusion {
        Conclusion::Continuity { continuity, proved, refuted } => {
            let curve = family.curve.as_ref();
            let pulled = [proved, refuted].map(|intervals| along_curve(family, intervals));
            let (regions, variable, along) = match (pulled, curve) {
                ([Some(proved), Some(refuted)], Some(curve)) => {
                    ([proved, refuted], Some(&curve.parameter), None)
                }
                (_, curve) => {
                    let regions = [proved, refuted].map(|intervals| region_of(intervals));
                    (regions, family.parameter.as_ref(), curve.map(|curve| &curve.parameter))
                }
            };
            let part = |(word, region): (&str, &Region)| match variable {
                _ if region.is_empty() => None,
                None => Some(word.to_string()),
                Some(variable) => Some(format!("{word} on {}", short(region, variable))),
            };
            let parts = ["proved", "refuted"].into_iter().zip(&regions).filter_map(part);
            let text = parts.collect::<Vec<_>>().join(", ");
            let text = if text.is_empty() { "nothing decided".into() } else { text };
            let along = along.map_or(String::new(), |parameter| {
                format!(", in the coordinate of a line of masks along which {parameter} runs")
            });
            format!("{} is C^{continuity}: {text}{along}", family.name)
        }
        Conclusion::Regularity { holder: [lower, upper], .. } => {
            let (lower, upper) = (decimal(&lower.0, 12), decimal(&upper.0, 12));
            format!("{} has Hölder exponent in [{lower}, {upper}]", family.name)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(text: &str) -> Value {
        let scheme = Scheme::resolve(text, 2).unwrap();
        any_range_table(&scheme, 0, &Sharpness::default()).unwrap().json
    }

    /// A vertex rule with the weight `1/b` is C^1 for weights in (0, 1/2), that is for `b > 2`; said of `b`, not of the weight.
    #[test]
    fn statements_are_about_the_parameter() {
        let scheme = Scheme::resolve("even: [1/b, 1-2/b, 1/b]; odd: [1/2, 1/2]", 2).unwrap();
        let found = sharp_range(&scheme, 1, &Sharpness::default()).unwrap();
        let stated = statement(&found.certificate);
        let expected = "is C^1: proved on (2, ∞), refuted on (-∞, 0) ∪ (0, 2]";
        assert!(stated.ends_with(expected), "{stated}");
    }

    /// The four-point scheme converges for `|w| < 1/2`: with `w = t²` for `t² < 1/2`, and with
    /// `w = t/(1+t²)`, which is `±1/2` at `t = ±1` and smaller elsewhere, everywhere but there.
    #[test]
    fn families_that_cover_their_line_twice() {
        let proved = |json: &Value| -> Vec<[Value; 2]> {
            let parts = json["proved"].as_array().unwrap().iter();
            parts.map(|p| ["lo", "hi"].map(|end| p[end]["exact"].clone())).collect()
        };
        assert_eq!(proved(&range("fourpoint(w)")), [["-1/2", "1/2"]]);
        assert_eq!(proved(&range("fourpoint(t^2)")), [["-sqrt(2)/2", "sqrt(2)/2"]]);
        let turned = range("fourpoint(t/(1+t^2))");
        let infinite = Value::Null;
        let (one, minus_one) = (json!("1"), json!("-1"));
        assert_eq!(
            proved(&turned),
            [[&infinite, &minus_one], [&minus_one, &one], [&one, &infinite]]
                .map(|p| p.map(Value::clone))
        );
        let points: Vec<_> = turned["points"]
            .as_array()
            .unwrap()
            .iter()
            .map(|p| (&p["at"]["exact"], &p["verdict"]))
            .collect();
        let refuted = json!("refuted");
        assert_eq!(points, [(&minus_one, &refuted), (&one, &refuted)]);
        assert_eq!(turned["exact"], true);
    }

    /// Masks on a conic: norms prove, nothing is refuted, and the reason is said.
    #[test]
    fn families_on_no_line_are_undecided_beyond_norms() {
        let json = range("even: [w^2, 1-w-w^2, w]; odd: [1/2, 1/2]");
        assert_eq!(json["proved"].as_array().map(Vec::len), Some(1));
        assert_eq!(json["refuted"], json!([]));
        assert_eq!(json["exact"], false);
        assert!(json["undecided_because"][0].as_str().unwrap().contains("on no line"));
    }
}
