//! `scan`: a quantity at every point of a grid over two parameters.

use std::collections::BTreeMap;

use rayon::prelude::*;
use refinable_algebra::{Parameter, Rational, rational};
use refinable_analysis::{
    Budget, Fineness, Map, MapVerdict, Options, Plane, PointVerdict, PointwiseNorm, Sharpness,
    Window, continuity_at, degrees, map, regularity,
};
use refinable_scheme::{Diagnostic, Normalised, Scheme};
use serde_json::json;

use crate::regularity::outward;
use crate::span::{named, parse_ascending_span};

/// What is found at every point.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Quantity {
    /// The largest `n` for which C^n is proved, -1 if convergence is not; and whether C^(n+1) is refuted.
    Continuity,
    /// Bounds for the Hölder exponent.
    Holder,
    /// The degree of polynomial generation.
    Generation,
    /// The degree of polynomial reproduction.
    Reproduction,
    /// `‖c_n^L‖`.
    Norm {
        /// The order `n`.
        continuity: usize,
        /// The level `L`.
        level: u32,
    },
}

/// A grid over the two free parameters of a scheme, and what is found on it.
#[derive(Clone, Debug)]
pub struct Scan {
    scheme: Scheme,
    axes: [Axis; 2],
    quantity: Quantity,
    /// For the continuity: one map for each order up to that of the symbol, which holds on a line only.
    maps: Vec<Map>,
    norm: Option<PointwiseNorm>,
}

/// Values of a parameter: the first, the last, and the number of steps between.
#[derive(Clone, Debug)]
struct Axis {
    parameter: Parameter,
    low: Rational,
    high: Rational,
    steps: u32,
}

/// The most points of a grid.
const MOST_POINTS: u64 = 100_000_000;
/// Nodes of the maps that decide most points of a scan, for each square root of a point: a node takes some
/// milliseconds, and saves about as many for points that would have to be decided on their own.
const NODES: u64 = 20;
const LEAST_NODES: usize = 1500;
const MOST_NODES: usize = 30_000;

impl Scan {
    /// The scan of a grid such as `alpha=0..1/8:200,beta=-1/10..0:200`, with the number of steps from one
    /// end to the other.
    ///
    /// # Errors
    /// A text that is no such grid, or one of more than a hundred million points; code `parameters`
    /// unless its parameters are the free ones.
    pub fn new(scheme: &Scheme, grid: &str, quantity: Quantity) -> Result<Scan, Diagnostic> {
        let axes = parse_grid(scheme, grid)?;
        let mut scan =
            Scan { scheme: scheme.clone(), axes, quantity, maps: Vec::new(), norm: None };
        match scan.quantity {
            Quantity::Continuity => scan.maps = scan.build_maps()?,
            Quantity::Norm { continuity, level } => {
                let budget = Budget::default();
                scan.norm = Some(PointwiseNorm::new(scheme.mask(), continuity, level, budget)?);
            }
            _ => {}
        }
        Ok(scan)
    }

    fn build_maps(&self) -> Result<Vec<Map>, Diagnostic> {
        let (name, mask) = (self.scheme.name(), self.scheme.mask());
        let plane = Plane::new(name, mask)?;
        let span = |p: &Parameter| {
            let axis = self.axes.iter().find(|axis| axis.parameter == *p);
            axis.map(|axis| [axis.low.clone(), axis.high.clone()])
        };
        let [Some(u), Some(v)] = plane.parameters().each_ref().map(span) else {
            return Ok(Vec::new());
        };
        let window: Window = [u, v];
        let nodes = (NODES * NODES * self.count()).isqrt() as usize;
        let nodes = nodes.clamp(LEAST_NODES, MOST_NODES);
        let fineness = Fineness { undecided: rational(1, 2000), nodes };
        (0..=plane.order()).map(|n| map(name, mask, n, &window, &fineness)).collect()
    }

    /// How many points there are.
    pub fn count(&self) -> u64 {
        self.axes.iter().map(|axis| u64::from(axis.steps) + 1).product()
    }

    /// The header of the CSV.
    pub fn header(&self) -> String {
        let [u, v] = self.axes.each_ref().map(|axis| axis.parameter.name());
        format!("{u},{v},{}\n", self.columns().join(","))
    }

    fn columns(&self) -> &'static [&'static str] {
        match self.quantity {
            Quantity::Continuity => &["continuity", "next"],
            Quantity::Holder => &["lower", "upper"],
            Quantity::Generation => &["generation"],
            Quantity::Reproduction => &["reproduction"],
            Quantity::Norm { .. } => &["norm"],
        }
    }

    /// The rows of the points with these indices, the first parameter changing slowest: CSV, or one JSON
    /// object in each line.
    pub fn rows(&self, from: u64, to: u64, json: bool) -> String {
        let rows: Vec<String> =
            (from..to).into_par_iter().map(|index| self.row(index, json)).collect();
        rows.concat()
    }

    fn row(&self, index: u64, json: bool) -> String {
        let inner = u64::from(self.axes[1].steps) + 1;
        let point = [index / inner, index % inner];
        let point = [0, 1].map(|i| self.axes[i].value(point[i]));
        let values = self.values(&point);
        if !json {
            return format!("{},{},{}\n", point[0], point[1], values.join(","));
        }
        let mut object = serde_json::Map::new();
        for (axis, value) in self.axes.iter().zip(&point) {
            object.insert(axis.parameter.name().into(), json!(value.to_string()));
        }
        for (column, value) in self.columns().iter().zip(values) {
            let number = value.parse::<i64>().map_or_else(|_| json!(value), |n| json!(n));
            object.insert((*column).into(), number);
        }
        format!("{}\n", serde_json::Value::from(object))
    }

    /// What is found at a point, as text; empty where nothing was.
    fn values(&self, point: &[Rational; 2]) -> Vec<String> {
        if let Some(norm) = &self.norm {
            let names = self.axes.iter().map(|axis| axis.parameter.clone());
            let at: BTreeMap<Parameter, Rational> = names.zip(point.iter().cloned()).collect();
            return vec![norm.value_at(&at).map_or_else(String::new, |x| x.to_string())];
        }
        if self.quantity == Quantity::Continuity {
            let (continuity, next) = self.continuity(point);
            return vec![continuity.to_string(), next.into()];
        }
        let Some(mask) = self.mask_at(point) else {
            return self.columns().iter().map(|_| String::new()).collect();
        };
        match self.quantity {
            Quantity::Generation => vec![degrees(&mask).generic().generation.to_string()],
            Quantity::Reproduction => vec![degrees(&mask).generic().reproduction.to_string()],
            _ => match regularity(self.scheme.name(), &mask, &Options::default()) {
                Ok(found) => {
                    let (lower, upper) = outward(&found);
                    vec![lower.to_string(), upper.map_or(String::new(), |upper| upper.to_string())]
                }
                Err(_) => vec![String::new(), String::new()],
            },
        }
    }

    /// The scheme's mask at a point; `None` at a pole.
    fn mask_at(&self, point: &[Rational; 2]) -> Option<Normalised> {
        let mask = self.scheme.mask();
        let value = |p: &Parameter| {
            let axis = self.axes.iter().position(|axis| axis.parameter == *p)?;
            Some(point[axis].clone())
        };
        mask.at(&mask.parameters().iter().map(value).collect::<Option<Vec<_>>>()?).ok()
    }

    /// The largest proved order, and what is known of the next one.
    fn continuity(&self, point: &[Rational; 2]) -> (i64, &'static str) {
        let mut mask = None;
        let mut n = 0;
        // No mask of finite support is smooth of every order.
        loop {
            let proved = n as i64 - 1;
            let from_map = self.maps.get(n).map(|map| {
                let of = |p: &Parameter| self.axes.iter().position(|axis| axis.parameter == *p);
                let place = map.plane.parameters().each_ref().map(|p| of(p).unwrap_or(0));
                map.verdict_at(&place.map(|i| point[i].clone()))
            });
            let verdict = match from_map {
                Some(MapVerdict::Proved) => PointVerdict::Proved,
                Some(MapVerdict::Refuted) => PointVerdict::Refuted,
                _ => {
                    if mask.is_none() {
                        mask = self.mask_at(point);
                    }
                    let Some(mask) = &mask else { return (proved, "undefined") };
                    let found = continuity_at(self.scheme.name(), mask, n, &Sharpness::default());
                    found.map_or(PointVerdict::Undecided, |(verdict, _)| verdict)
                }
            };
            match verdict {
                PointVerdict::Proved => n += 1,
                PointVerdict::Refuted => return (proved, "refuted"),
                _ => return (proved, "undecided"),
            }
        }
    }
}

impl Axis {
    fn value(&self, step: u64) -> Rational {
        let part = rational(step as i64, i64::from(self.steps));
        &self.low + (&self.high - &self.low) * part
    }
}

fn parse_grid(scheme: &Scheme, text: &str) -> Result<[Axis; 2], Diagnostic> {
    let error = |message: String| {
        Diagnostic::new("grid", message)
            .with_hint("for example --grid 'alpha=0..1/8:200,beta=-1/10..0:200'")
    };
    let axis = |part: &str| {
        let (name, rest) = named(part).map_err(error)?;
        let (span, steps) = rest
            .split_once(':')
            .ok_or_else(|| error(format!("`{part}` does not say how many steps: `:200`")))?;
        let steps = steps.trim().parse::<u32>().ok().filter(|&n| n > 0);
        let steps = steps.ok_or_else(|| error("the steps are a positive whole number".into()))?;
        let [low, high] = parse_ascending_span(span).map_err(error)?;
        Ok(Axis { parameter: Parameter::new(name), low, high, steps })
    };
    let axes: Vec<Axis> = text.split(',').map(axis).collect::<Result<_, _>>()?;
    let mut named: Vec<&Parameter> = axes.iter().map(|axis| &axis.parameter).collect();
    named.sort();
    let free = scheme.mask().parameters();
    if named.len() != 2 || !named.iter().copied().eq(&free) {
        let free: Vec<&str> = free.iter().map(Parameter::name).collect();
        let message = match free.len() {
            0 => "no parameter is free".to_string(),
            _ => {
                format!("a grid is over two parameters, and the free ones are {}", free.join(", "))
            }
        };
        return Err(error(message));
    }
    let points: u64 = axes.iter().map(|axis| u64::from(axis.steps) + 1).product();
    if points > MOST_POINTS {
        return Err(error(format!("a grid of {points} points, more than {MOST_POINTS}")));
    }
    Ok(axes.try_into().expect("two parameters were named"))
}
