//! `compare`: the table with which papers set schemes side by side.

use refinable_algebra::{Ordered, Rational};
use refinable_analysis::{
    ContinuityRange, Degrees, Options, Regularity, Sharpness, classify, default_window, degrees,
    landscape, regularity, smoothest_in,
};
use refinable_reals::Region;
use refinable_scheme::{Diagnostic, Normalised, Scheme};
use serde_json::{Value, json};

use crate::audit::short;
use crate::grid::{Cell, Document, Grid};
use crate::interproximate::floored;
use crate::regularity::{exact_text, yes_or_no};
use crate::shape::Shape;
use crate::sharp::sharp_range;
use crate::show::words;

/// The widest masks of families that are searched.
const WIDEST: i64 = 28;

/// What is found about the smoothness of a scheme or a family, and where.
#[derive(Clone, Debug, Default)]
pub(crate) struct Smoothness {
    /// The largest `n` for which C^n is proved somewhere.
    pub continuity: Option<usize>,
    /// The values of the parameters there, in short.
    pub place: Option<String>,
    /// The same exactly.
    pub exact_place: Option<String>,
    /// The Hölder exponent of the smoothest member that was found.
    pub holder: Option<String>,
    /// The values of its parameters.
    pub smoothest: Option<String>,
    /// Whether shifts are stable; of single schemes.
    pub stable: Option<bool>,
    /// Why nothing is found.
    pub problem: Option<String>,
}

impl Smoothness {
    /// The best that is proved: of a scheme itself, over one parameter by the ranges of all orders and the smoothest member
    /// found in the last of them, over two by the smoothest member found.
    pub fn of(scheme: &Scheme) -> Self {
        Smoothness::with(scheme, &|n| sharp_range(scheme, n, &Sharpness::default()))
    }

    /// The same, with the ranges over one parameter from elsewhere.
    pub fn with(scheme: &Scheme, range: &Ranging) -> Self {
        let found = match scheme.mask().parameters().len() {
            1.. if scheme.mask().support_width() > Rational::from_integer(WIDEST.into()) => {
                Err(Diagnostic::new("budget", "the masks are too long for a search"))
            }
            0 => Smoothness::of_single(scheme),
            1 => Smoothness::over_one(scheme, range),
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
        let (continuity, stable) = (found.continuity, found.stable);
        Ok(Smoothness { continuity, holder, stable, ..Smoothness::default() })
    }

    fn over_one(scheme: &Scheme, range: &Ranging) -> Result<Self, Diagnostic> {
        let mut best: Option<(usize, ContinuityRange)> = None;
        // Beyond the highest degree of generation there is nothing.
        let highest = strata_maximum(&degrees(scheme.mask()), |s| s.generation.0);
        for n in 0..=highest {
            let found = range(n)?;
            if found.proved.is_empty() {
                break;
            }
            best = Some((n, found));
        }
        let Some((n, found)) = best else { return Ok(Smoothness::default()) };
        let name = found.parameter.name();
        let (mask, arity) = (scheme.mask(), scheme.mask().arity());
        let summit = smoothest_in(scheme.name(), mask, &found.proved);
        Ok(Smoothness {
            continuity: Some(n),
            place: Some(within(&found.proved, name)),
            exact_place: Some(format!("{name} in {}", found.proved.display(name))),
            holder: summit.as_ref().map(|(_, found)| exponent(found, arity)),
            smoothest: summit.map(|(x, _)| format!("{name} = {x}")),
            ..Smoothness::default()
        })
    }

    fn over_two(scheme: &Scheme) -> Result<Self, Diagnostic> {
        let (name, mask) = (scheme.name(), scheme.mask());
        let window = default_window(name, mask, 0)?;
        let landscape = landscape(name, mask, &window, [2, 2])?;
        let Some(summit) = landscape.highest() else { return Ok(Smoothness::default()) };
        let values = landscape.plane.parameters().iter().zip(&summit.parameters);
        let place = values.map(|(p, x)| format!("{p} = {x}")).collect::<Vec<_>>().join(", ");
        Ok(Smoothness {
            continuity: summit.regularity.continuity,
            holder: Some(exponent(&summit.regularity, mask.arity())),
            place: Some(place.clone()),
            exact_place: Some(place.clone()),
            smoothest: Some(place),
            ..Smoothness::default()
        })
    }
}

/// `alpha ∈ (0, 1/8)`; where there are single values, these have the name already.
fn within(region: &Region, name: &str) -> String {
    let text = short(region, name);
    let has_points = region.intervals().iter().any(|interval| interval.as_point().is_some());
    if has_points { text } else { format!("{name} ∈ {text}") }
}

/// Where C^n is proved over the one parameter of a family.
pub(crate) type Ranging<'a> = dyn Fn(usize) -> Result<ContinuityRange, Diagnostic> + 'a;

/// The exact exponent if it is short, else a lower bound.
fn exponent(found: &Regularity, arity: usize) -> String {
    let exact = exact_text(found, arity).filter(|text| text.len() < 16);
    exact.unwrap_or_else(|| format!("≥ {}", floored(&found.lower)))
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
    let of = |scheme: &Scheme| Row::new(scheme, Smoothness::of(scheme));
    let rows: Vec<Row> = schemes.iter().map(of).collect();
    let grid = Grid {
        id: "compare".into(),
        caption: "Schemes side by side".into(),
        header: HEADER.map(String::from).to_vec(),
        rows: rows.iter().map(Row::cells).collect(),
        remarks: REMARKS.map(String::from).to_vec(),
    };
    let json = json!({"schemes": rows.iter().map(Row::json).collect::<Value>()});
    Document { grids: vec![grid], summary: None, json }
}

/// The columns of a comparison.
pub(crate) const HEADER: [&str; 19] = [
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
    "where",
    "Hölder exponent",
    "attained at",
    "stable shifts",
    "norm",
    "convex hull",
    "overshoot",
    "monotone",
    "convex",
];

/// What the columns mean.
pub(crate) const REMARKS: [&str; 3] = [
    "GD, RD: degrees of polynomial generation and reproduction, for all values of the parameters and at the best \
     ones",
    "C^n, exponent: proved, at the values named; the exponent is that of the smoothest member found",
    "overshoot: of the limit of a step of height 1, none or at least so much, beside the step at 0; monotone, convex: \
     whether limits of such data are such; single schemes only",
];

/// A scheme of a comparison.
pub(crate) struct Row {
    name: String,
    width: String,
    parameters: Vec<String>,
    kind: Vec<&'static str>,
    generation: [usize; 2],
    reproduction: [usize; 2],
    /// Whether the conditions for higher degrees were solved to the end.
    complete: bool,
    smoothness: Smoothness,
    norm: Option<Rational>,
    hull: Option<bool>,
    shape: Option<Shape>,
}

impl Row {
    /// What is found about a scheme, whose smoothness is known.
    pub fn new(scheme: &Scheme, smoothness: Smoothness) -> Self {
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
            complete: found.complete,
            shape: Shape::of(mask, &smoothness),
            smoothness,
            norm: scheme_norm(mask),
            hull: in_hulls(mask),
        }
    }

    /// A cell for each column of [`HEADER`].
    pub fn cells(&self) -> Vec<Cell> {
        let yes = |value| yes_or_no(value).unwrap_or_default().to_string();
        let s = &self.smoothness;
        let at_least = if self.complete { "" } else { "≥ " };
        let shape = |text: fn(&Shape) -> String| self.shape.as_ref().map(text).unwrap_or_default();
        let texts = [
            self.width.clone(),
            self.parameters.join(", "),
            self.kind.join(", "),
            self.generation[0].to_string(),
            format!("{at_least}{}", self.generation[1]),
            self.reproduction[0].to_string(),
            format!("{at_least}{}", self.reproduction[1]),
            (self.reproduction[0] + 1).to_string(),
            s.continuity
                .map_or_else(|| s.problem.clone().unwrap_or("none".into()), |n| format!("C^{n}")),
            s.place.clone().unwrap_or_default(),
            s.holder.clone().unwrap_or_default(),
            s.smoothest.clone().unwrap_or_default(),
            yes(s.stable),
            self.norm.as_ref().map(ToString::to_string).unwrap_or_default(),
            yes(self.hull),
            shape(Shape::overshoot),
            shape(Shape::monotone),
            shape(Shape::convex),
        ];
        std::iter::once(Cell::name(&self.name)).chain(texts.map(Cell::text)).collect()
    }

    /// The same as data.
    pub fn json(&self) -> Value {
        let s = &self.smoothness;
        json!({
            "scheme": self.name,
            "support_width": self.width,
            "parameters": self.parameters,
            "type": self.kind,
            "generation": {"all": self.generation[0], "best": self.generation[1]},
            "reproduction": {"all": self.reproduction[0], "best": self.reproduction[1]},
            "degrees_complete": self.complete,
            "approximation_order": self.reproduction[0] + 1,
            "continuity": s.continuity,
            "where": s.exact_place,
            "holder": s.holder,
            "attained_at": s.smoothest,
            "stable": s.stable,
            "norm": self.norm.as_ref().map(ToString::to_string),
            "convex_hull": self.hull,
            "shape": self.shape.as_ref().map(Shape::json),
            "problem": s.problem,
        })
    }
}
