//! `check` and `expect`: what a scheme file says, against what is found.

use refinable_analysis::{Options, Sharpness, classify, degrees, regularity};
use refinable_scheme::{Diagnostic, Expectation, Scheme, SchemeFile, Substitution};
use serde_json::{Value, json};

use crate::regularity::exact_text;
use crate::sharp::sharp_range;
use crate::show::words;

/// An expectation that was checked.
#[derive(Clone, Debug)]
pub struct Checked {
    /// What is expected, such as `support`, after what was set.
    pub what: String,
    /// What the file says.
    pub expected: String,
    /// What is found, or why nothing was.
    pub found: String,
    /// Who says what the file says.
    pub source: Option<String>,
}

impl Checked {
    /// Whether it was found as expected.
    pub fn holds(&self) -> bool {
        self.expected == self.found
    }
}

/// Checks everything that a file expects, in its order.
///
/// # Errors
/// What is wrong with the settings or the masks of the file itself.
pub fn check(file: &SchemeFile) -> Result<Vec<Checked>, Diagnostic> {
    let mut checked = Vec::new();
    for expectation in &file.expectations {
        let mut sets = Vec::new();
        for set in &expectation.set {
            sets.push(Substitution::parse(set)?);
        }
        let scheme = file.scheme.with(&sets)?;
        for (what, expected, found) in compared(&scheme, expectation)? {
            let at = expectation.set.join(", ");
            let what = if at.is_empty() { what } else { format!("{what} at {at}") };
            checked.push(Checked { what, expected, found, source: expectation.source.clone() });
        }
    }
    Ok(checked)
}

/// Triples: what, expected, found.
type Comparison = (String, String, String);

fn compared(scheme: &Scheme, expectation: &Expectation) -> Result<Vec<Comparison>, Diagnostic> {
    let mask = scheme.mask();
    let mut lines = Vec::new();
    let mut line = |what: &str, expected: String, found: String| {
        lines.push((what.to_string(), expected, found));
    };
    if let Some(text) = &expectation.mask {
        let expected = Scheme::resolve(text, mask.arity())?;
        line("mask", expected.mask().to_string(), mask.to_string());
    }
    if let Some([low, high]) = expectation.support {
        let (found_low, found_high) = mask.support();
        line("support", format!("[{low}, {high}]"), format!("[{found_low}, {found_high}]"));
    }
    if let Some(kind) = &expectation.kind {
        line("type", kind.join(", "), words(&classify(mask)).join(", "));
    }
    if expectation.generation.is_some() || expectation.reproduction.is_some() {
        let found = degrees(mask);
        if let Some(degree) = expectation.generation {
            line("generation", degree.to_string(), found.generic().generation.to_string());
        }
        if let Some(degree) = expectation.reproduction {
            line("reproduction", degree.to_string(), found.generic().reproduction.to_string());
        }
    }
    if expectation.continuity.is_some()
        || expectation.holder.is_some()
        || expectation.converges.is_some()
    {
        let found = regularity(scheme.name(), mask, &Options::default());
        // Without bounds the finding is the reason.
        let told = |f: &dyn Fn(&refinable_analysis::Regularity) -> String| match &found {
            Ok(found) => f(found),
            Err(error) => error.message().to_string(),
        };
        if let Some(converges) = expectation.converges {
            let text = |converges: bool| if converges { "yes" } else { "not proved" }.to_string();
            let found = found.as_ref().is_ok_and(|found| found.continuity.is_some());
            line("converges", text(converges), text(found));
        }
        if let Some(n) = expectation.continuity {
            let found = told(&|found| found.continuity.map_or("none".into(), |n| format!("C^{n}")));
            line("continuity", format!("C^{n}"), found);
        }
        if let Some(text) = &expectation.holder {
            let found = told(&|found| {
                exact_text(found, mask.arity()).unwrap_or_else(|| "not known exactly".into())
            });
            line("holder", text.clone(), found);
        }
    }
    if let Some(range) = &expectation.range {
        let found = sharp_range(scheme, range.continuity, &Sharpness::default());
        let found = match &found {
            Ok(found) => {
                let proved = found.proved.display(found.parameter.name());
                let sharp = found.undecided().is_empty();
                format!(
                    "{proved}{}",
                    if range.only && !sharp { ", and some undecided" } else { "" }
                )
            }
            Err(error) => error.message().to_string(),
        };
        line(&format!("range of C^{}", range.continuity), range.proved.clone(), found);
    }
    Ok(lines)
}

/// What was checked of schemes, by their names, as JSON with a final newline.
pub fn check_json(results: &[(String, Vec<Checked>)]) -> String {
    let line = |c: &Checked| {
        json!({
            "what": c.what,
            "expected": c.expected,
            "found": c.found,
            "holds": c.holds(),
            "source": c.source,
        })
    };
    let scheme = |(name, checked): &(String, Vec<Checked>)| {
        json!({
            "scheme": name,
            "checked": checked.len(),
            "differences": checked.iter().filter(|c| !c.holds()).count(),
            "expectations": checked.iter().map(line).collect::<Value>(),
        })
    };
    format!("{:#}\n", json!({"files": results.iter().map(scheme).collect::<Value>()}))
}

/// A scheme file that expects what is found now: what a maintainer of a mask wants to keep.
pub fn expected_file(scheme: &Scheme) -> String {
    let mask = scheme.mask();
    let (low, high) = mask.support();
    let kind: Vec<String> =
        words(&classify(mask)).iter().map(|word| format!("\"{word}\"")).collect();
    let found = degrees(mask);
    let mut text = format!(
        "name = {:?}\narity = {}\nmask = \"{}\"\n\n[[expect]]\nsource = \"computed\"\nsupport = [{low}, {high}]\n\
         type = [{}]\ngeneration = {}\nreproduction = {}\n",
        scheme.name(),
        mask.arity(),
        mask,
        kind.join(", "),
        found.generic().generation,
        found.generic().reproduction,
    );
    match mask.parameters().len() {
        0 => {
            if let Ok(found) = regularity(scheme.name(), mask, &Options::default()) {
                match found.continuity {
                    Some(n) => text.push_str(&format!("continuity = {n}\n")),
                    None => text.push_str("converges = false\n"),
                }
                if let Some(exact) = exact_text(&found, mask.arity()) {
                    text.push_str(&format!("holder = \"{exact}\"\n"));
                }
            }
        }
        1 => {
            for n in 0..=found.generic().generation.0 {
                let Ok(found) = sharp_range(scheme, n, &Sharpness::default()) else { break };
                if found.proved.is_empty() {
                    break;
                }
                let proved = found.proved.display(found.parameter.name());
                let only = found.undecided().is_empty();
                text.push_str(&format!(
                    "\n[[expect]]\nsource = \"computed\"\n\
                     range = {{ continuity = {n}, proved = \"{proved}\", only = {only} }}\n"
                ));
            }
        }
        _ => {}
    }
    text
}
