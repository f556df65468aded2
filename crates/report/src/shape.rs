//! What limits keep of the shape of their data, as text and as data.

use refinable_algebra::{Rational, Ring, decimal};
use refinable_refine::{ShapeVerdict, Witness, keeps_steps, preserves};
use refinable_scheme::Normalised;
use serde_json::{Value, json};

use crate::compare::Smoothness;

/// The verdicts about one scheme that converges.
pub(crate) struct Shape {
    step: ShapeVerdict,
    monotone: ShapeVerdict,
    convex: ShapeVerdict,
}

impl Shape {
    /// `None` unless the mask has no parameters and converges.
    pub fn of(mask: &Normalised, smoothness: &Smoothness) -> Option<Self> {
        smoothness.continuity?;
        let step = keeps_steps(mask).ok()?;
        let [monotone, convex] = [1, 2].map(|order| preserves(mask, order).ok());
        Some(Shape { step, monotone: monotone?, convex: convex? })
    }

    /// `none` or `≥ 1/16 at -1/2`.
    pub fn overshoot(&self) -> String {
        told(&self.step, "none", |w| format!("≥ {} at {}", amount(w), w.places[0]))
    }

    /// `yes` or `no`.
    pub fn monotone(&self) -> String {
        told(&self.monotone, "yes", |_| "no".into())
    }

    /// `yes` or `no`.
    pub fn convex(&self) -> String {
        told(&self.convex, "yes", |_| "no".into())
    }

    /// What is kept and what is not, each with its reason, in sentences.
    pub fn sentences(&self) -> [(&'static str, String); 3] {
        let step = |w: &Witness| format!("leaves [0, 1] by {} at {}", amount(w), w.places[0]);
        let falls = |w: &Witness| {
            let [from, to] = &w.places;
            format!("no: the limit of a step falls by {} from {from} to {to}", amount(w))
        };
        let bends = |w: &Witness| {
            let [from, to] = &w.places;
            format!(
                "no: the limit of max(0, k+1) has the second difference -{} from {from} to {to}",
                amount(w)
            )
        };
        [
            ("limit of a step", told(&self.step, "stays in [0, 1]", step)),
            ("keeps monotone data", told(&self.monotone, "yes", falls)),
            ("keeps convex data", told(&self.convex, "yes", bends)),
        ]
    }

    /// Verdicts and witnesses; exact.
    pub fn json(&self) -> Value {
        let verdict = |verdict: &ShapeVerdict| match verdict {
            ShapeVerdict::Proved => json!({"verdict": "proved"}),
            ShapeVerdict::Undecided => json!({"verdict": "undecided"}),
            ShapeVerdict::Refuted(w) => json!({
                "verdict": "refuted",
                "from": w.places[0].to_string(),
                "to": w.places[1].to_string(),
                "amount": w.amount.to_string(),
            }),
        };
        json!({
            "step": verdict(&self.step),
            "monotone": verdict(&self.monotone),
            "convex": verdict(&self.convex),
        })
    }
}

fn told(verdict: &ShapeVerdict, proved: &str, refuted: impl Fn(&Witness) -> String) -> String {
    match verdict {
        ShapeVerdict::Proved => proved.into(),
        ShapeVerdict::Refuted(witness) => refuted(witness),
        ShapeVerdict::Undecided => "undecided".into(),
    }
}

/// Exact if it is short, else cut to four decimals if any is other than 0.
fn amount(witness: &Witness) -> String {
    let exact = witness.amount.to_string();
    let scale = Rational::from_integer(10_000.into());
    let cut = (&witness.amount * &scale).floor() / scale;
    if exact.len() < 10 || cut.is_zero() { exact } else { format!("{}…", decimal(&cut, 8)) }
}
