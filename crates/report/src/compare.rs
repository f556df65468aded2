//! `compare`: the table with which papers set schemes side by side.

use refinable_algebra::{Ordered, Rational, decimal};
use refinable_analysis::{
    Degrees, Options, Regularity, Sharpness, classify, degrees, landscape, regularity,
    smooth_window,
};
use refinable_scheme::{Diagnostic, Normalised, Scheme};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::regularity::exact_text;
use crate::sharp::sharp_range;
use crate::show::words;

/// The widest masks of families that are searched.
const WIDEST: i64 = 28;

/// What is found about the smoothness of a scheme or a family, and where.
#[derive(Clone, Debug, Default)]
pub(crate) struct Smoothness {
    /// The largest `n` for which C^n is proved somewhere.
    pub continuity: Option<usize>,
    /// The Hölder exponent there, if it is known.
    pub holder: Option<String>,
    /// The values of the parameters.
    pub place: Option<String>,
    /// Whether shifts are stable; of single schemes.
    pub stable: Option<bool>,
    /// Why nothing is found.
    pub problem: Option<String>,
}

impl Smoothness {
    /// The best that is proved: of a scheme itself, over one parameter by the ranges of all orders, over two by the
    /// smoothest member found.
    pub fn of(scheme: &Scheme) -> Self {
        let found = match scheme.mask().parameters().len() {
            1.. if scheme.mask().support_width() > Rational::from_integer(WIDEST.into()) => {
                Err(Diagnostic::new("budget", "the masks are too long for a search"))
            }
            0 => Smoothness::of_single(scheme),
            1 => Smoothness::over_one(scheme),
            2 => Smoothness::over_two(scheme),
            _ => Err(Diagnostic::new("parameters", "more than two parameters")),
        };
        let failed = |error: Diagnostic| Smoothness {
            problem: Some(error.message().to_string()),
            ..Smoothness::default()
        };
        found.unwrap_or_else(failed)
    }

    fn of_single(scheme: &Scheme) -> Result<Self, Diagnostic> {
        let found = regularity(scheme.name(), scheme.mask(), &Options::default())?;
        let holder = found.continuity.map(|_| exponent(&found, scheme.mask().arity()));
        let (continuity, stable) = (found.continuity, Some(found.stable));
        Ok(Smoothness { continuity, holder, stable, ..Smoothness::default() })
    }

    fn over_one(scheme: &Scheme) -> Result<Self, Diagnostic> {
        let mut best = Smoothness::default();
        // Beyond the highest degree of generation there is nothing.
        let highest = strata_maximum(&degrees(scheme.mask()), |s| s.generation.0);
        for n in 0..=highest {
            let found = sharp_range(scheme, n, &Sharpness::default())?;
            if found.proved.is_empty() {
                break;
            }
            let name = found.parameter.name();
            best.continuity = Some(n);
            best.place = Some(format!("{name} in {}", found.proved.display(name)));
        }
        Ok(best)
    }

    fn over_two(scheme: &Scheme) -> Result<Self, Diagnostic> {
        let (name, mask) = (scheme.name(), scheme.mask());
        let window = smooth_window(name, mask)?;
        let landscape = landscape(name, mask, &window, [2, 2])?;
        let Some(summit) = landscape.highest() else { return Ok(Smoothness::default()) };
        let values = landscape.plane.parameters().iter().zip(&summit.parameters);
        let place = values.map(|(p, x)| format!("{p} = {x}")).collect::<Vec<_>>().join(", ");
        Ok(Smoothness {
            continuity: summit.regularity.continuity,
            holder: Some(exponent(&summit.regularity, mask.arity())),
            place: Some(place),
            ..Smoothness::default()
        })
    }
}

/// The exact exponent if it is short, else a lower bound.
fn exponent(found: &Regularity, arity: usize) -> String {
    let exact = exact_text(found, arity).filter(|text| text.len() < 16);
    let scale = Rational::from_integer(10_000.into());
    exact.unwrap_or_else(|| format!("≥ {}", decimal(&((&found.lower * &scale).floor() / scale), 8)))
}

/// The largest value on any stratum.
fn strata_maximum(
    degrees: &Degrees,
    value: impl Fn(&refinable_analysis::Stratum) -> usize,
) -> usize {
    degrees.strata.iter().map(value).max().unwrap_or(0)
}

/// `‖S‖ = max_ε Σ_j |a_{ε-mj}|`, the norm of one step on bounded sequences; of a single scheme.
pub(crate) fn scheme_norm(mask: &Normalised) -> Option<Rational> {
    let rule = mask.rule();
    let sum = |stencil: &refinable_scheme::Stencil| -> Option<Rational> {
        stencil.weights().iter().map(|w| Some(w.as_constant()?.absolute())).sum()
    };
    let sums: Option<Vec<Rational>> = rule.stencils().iter().map(sum).collect();
    sums?.into_iter().max()
}

/// Whether no weight is negative: then every curve lies in the convex hulls of its control points; of a single
/// scheme.
pub(crate) fn in_hulls(mask: &Normalised) -> Option<bool> {
    let signs = mask.coefficients().map(|(_, a)| Some(!a.as_constant()?.compare_to_zero().is_lt()));
    signs.collect::<Option<Vec<bool>>>().map(|signs| signs.iter().all(|sign| *sign))
}

/// A row for each scheme.
pub fn compare(schemes: &[Scheme]) -> Document {
    let header = [
        "scheme",
        "support width",
        "parameters",
        "type",
        "GD, all",
        "GD, best",
        "RD, all",
        "RD, best",
        "approximation order",
        "C^n",
        "Hölder exponent",
        "where",
        "stable shifts",
        "norm",
        "convex hull",
    ];
    let rows: Vec<Row> = schemes.iter().map(Row::new).collect();
    let grid = Grid {
        id: "compare".into(),
        caption: "Schemes side by side".into(),
        header: header.map(String::from).to_vec(),
        rows: rows.iter().map(Row::cells).collect(),
        remarks: vec![
            "GD, RD: degrees of polynomial generation and reproduction, for all values of the parameters and at the best \
             ones"
                .into(),
            "C^n, exponent: proved, at the values named; over two parameters at the smoothest member found".into(),
        ],
    };
    let json = json!({"schemes": rows.iter().map(Row::json).collect::<Value>()});
    Document { grids: vec![grid], summary: None, json }
}

struct Row {
    name: String,
    width: String,
    parameters: Vec<String>,
    kind: Vec<&'static str>,
    generation: [usize; 2],
    reproduction: [usize; 2],
    smoothness: Smoothness,
    norm: Option<Rational>,
    hull: Option<bool>,
}

impl Row {
    fn new(scheme: &Scheme) -> Self {
        let mask = scheme.mask();
        let found = degrees(mask);
        let best = |f: fn(&refinable_analysis::Stratum) -> usize| {
            [f(found.generic()), strata_maximum(&found, f)]
        };
        Row {
            name: scheme.name().to_string(),
            width: mask.support_width().to_string(),
            parameters: mask.parameters().iter().map(ToString::to_string).collect(),
            kind: words(&classify(mask)),
            generation: best(|s| s.generation.0),
            reproduction: best(|s| s.reproduction.0),
            smoothness: Smoothness::of(scheme),
            norm: scheme_norm(mask),
            hull: in_hulls(mask),
        }
    }

    fn cells(&self) -> Vec<Cell> {
        let yes = |value: Option<bool>| match value {
            Some(true) => "yes".to_string(),
            Some(false) => "no".to_string(),
            None => String::new(),
        };
        let s = &self.smoothness;
        let texts = [
            self.name.clone(),
            self.width.clone(),
            self.parameters.join(", "),
            self.kind.join(", "),
            self.generation[0].to_string(),
            self.generation[1].to_string(),
            self.reproduction[0].to_string(),
            self.reproduction[1].to_string(),
            (self.reproduction[0] + 1).to_string(),
            s.continuity
                .map_or_else(|| s.problem.clone().unwrap_or("none".into()), |n| format!("C^{n}")),
            s.holder.clone().unwrap_or_default(),
            s.place.clone().unwrap_or_default(),
            yes(s.stable),
            self.norm.as_ref().map(ToString::to_string).unwrap_or_default(),
            yes(self.hull),
        ];
        texts.map(Cell::text).to_vec()
    }

    fn json(&self) -> Value {
        let s = &self.smoothness;
        json!({
            "scheme": self.name,
            "support_width": self.width,
            "parameters": self.parameters,
            "type": self.kind,
            "generation": {"all": self.generation[0], "best": self.generation[1]},
            "reproduction": {"all": self.reproduction[0], "best": self.reproduction[1]},
            "approximation_order": self.reproduction[0] + 1,
            "continuity": s.continuity,
            "holder": s.holder,
            "where": s.place,
            "stable": s.stable,
            "norm": self.norm.as_ref().map(ToString::to_string),
            "convex_hull": self.hull,
            "problem": s.problem,
        })
    }
}
