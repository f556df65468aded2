//! `analyze`: everything about one scheme on one page.

use refinable_analysis::{classify, degrees};
use refinable_refine::BasicLimit;
use refinable_scheme::{Scheme, identities};
use serde_json::{Map, Value, json};

use crate::compare::{Smoothness, in_hulls, scheme_norm};
use crate::degrees::{INCOMPLETE, condition, solutions};
use crate::grid::{Cell, Document, Grid};
use crate::regularity::yes_or_no;
use crate::shape::Shape;
use crate::show::{pole, words};

/// The quantities of a scheme, each with its value.
pub fn analyze(scheme: &Scheme) -> Document {
    let mask = scheme.mask();
    let (low, high) = mask.support();
    let parameters: Vec<String> = mask.parameters().iter().map(ToString::to_string).collect();
    let mut page = Page::default();
    page.line("arity", mask.arity().to_string());
    page.line("mask", mask.to_string());
    page.line("parameters", parameters.join(", "));
    page.line("support", format!("[{low}, {high}], width {}", mask.support_width()));
    page.line("type", words(&classify(mask)).join(", "));
    let known = identities(mask).into_iter().map(|identity| identity.to_string());
    page.list("is", known.filter(|known| known != scheme.name()).collect());
    let found = degrees(mask);
    page.list(
        "degrees: generation, reproduction",
        found
            .strata
            .iter()
            .map(|stratum| {
                let solved = solutions(&stratum.locus).into_iter().next();
                let place =
                    solved.map_or_else(|| condition(&stratum.locus), |(p, x)| format!("{p} = {x}"));
                format!("{}, {} ({place})", stratum.generation, stratum.reproduction)
            })
            .collect(),
    );
    if !found.complete {
        page.line("more degrees", INCOMPLETE.into());
    }
    page.line("tau", found.tau.to_string());
    page.line("approximation order", (found.generic().reproduction.0 + 1).to_string());
    let smoothness = Smoothness::of(scheme);
    let place = smoothness.place.as_ref().map_or_else(String::new, |place| format!(", {place}"));
    page.line(
        "smoothness, proved",
        match (smoothness.continuity, &smoothness.problem) {
            (Some(n), _) => format!("C^{n}{place}"),
            (None, Some(problem)) => problem.clone(),
            (None, None) => "none".into(),
        },
    );
    let shape = Shape::of(mask, &smoothness);
    // Over one parameter the range says where it is smooth, and not where it is smoothest.
    let smoothest = smoothness.smoothest.filter(|at| smoothness.place.as_ref() != Some(at));
    let at = smoothest.map_or_else(String::new, |at| format!(", {at}"));
    page.line(
        "Hölder exponent",
        match smoothness.holder {
            Some(exponent) => format!("{exponent}{at}"),
            None if smoothness.continuity.is_some() => "no bound was found".into(),
            None => String::new(),
        },
    );
    page.line(
        "stable shifts",
        match yes_or_no(smoothness.stable) {
            Some(word) => word.into(),
            None if smoothness.continuity.is_some() && mask.parameters().is_empty() => {
                "not known".into()
            }
            None => String::new(),
        },
    );
    if let (Ok(limit), Some(n)) = (BasicLimit::new(mask), smoothness.continuity) {
        for order in 0..=n.min(2) {
            let name = ["limit stencil", "first derivative", "second derivative"][order];
            if let Ok(stencil) = limit.stencil(&limit.place(), order as u32) {
                let weights: Vec<String> =
                    stencil.weights().iter().map(ToString::to_string).collect();
                page.line(name, format!("[{}] from {}", weights.join(", "), stencil.first()));
            }
        }
    }
    page.line("norm of a step", scheme_norm(mask).map(|norm| norm.to_string()).unwrap_or_default());
    page.line(
        "in the convex hull",
        match in_hulls(mask) {
            Some(true) => "yes: no weight is negative".into(),
            Some(false) => "not always: some weights are negative".into(),
            None => String::new(),
        },
    );
    for (name, sentence) in shape.iter().flat_map(Shape::sentences) {
        page.line(name, sentence);
    }
    page.document(scheme)
}

/// Lines of quantities; what is empty is left out.
#[derive(Default)]
struct Page {
    lines: Vec<(String, String)>,
    json: Map<String, Value>,
}

impl Page {
    fn line(&mut self, name: &str, value: String) {
        if !value.is_empty() {
            self.json.insert(key(name), json!(value));
            self.lines.push((name.into(), value));
        }
    }

    /// A line for each value, the name at the first.
    fn list(&mut self, name: &str, values: Vec<String>) {
        for (k, value) in values.iter().enumerate() {
            let name = if k == 0 { name } else { "" };
            self.lines.push((name.into(), value.clone()));
        }
        self.json.insert(key(name), json!(values));
    }

    fn document(self, scheme: &Scheme) -> Document {
        let row = |(name, value): &(String, String)| {
            vec![Cell::text(name.clone()), Cell::text(value.clone())]
        };
        let grid = Grid {
            id: "analyze".into(),
            caption: scheme.name().to_string(),
            header: ["quantity", "value"].map(String::from).to_vec(),
            rows: self.lines.iter().map(row).collect(),
            remarks: pole(scheme.mask()).into_iter().collect(),
        };
        let mut json = Map::new();
        json.insert("scheme".into(), json!(scheme.name()));
        json.extend(self.json);
        Document { grids: vec![grid], summary: None, json: json.into() }
    }
}

/// The name of a quantity as a field of JSON.
fn key(name: &str) -> String {
    let head = name.split([':', ',']).next().unwrap_or(name);
    head.to_lowercase().replace('ö', "oe").replace(' ', "_")
}
