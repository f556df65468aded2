//! `map`: where C^n is proved and refuted over two parameters.

use refinable_algebra::{
    GcdDomain, Monomial, Parameter, ParameterFraction, ParameterPolynomial, Polynomial, Rational,
    Ring, decimal, parse_rational,
};
use refinable_analysis::{Area, Fineness, Map, Plane, Window, default_window, map, region_of};
use refinable_certificate::{CellVerdict, Conclusion, Inequality, Node, Number, Polygon, Terms};
use refinable_scheme::{Diagnostic, Scheme, Substitution, geometric_factor};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::number::{intervals, rational_number};
use crate::sharp::statement;
use crate::show::may_vanish;
use crate::span::{named, parse_span};

/// Maps of one family in one box for several orders of continuity, ascending.
#[derive(Clone, Debug)]
pub struct Maps {
    scheme: String,
    /// One for each order.
    pub maps: Vec<Map>,
}

impl Maps {
    /// The maps for the orders that are asked for, `2` or `0..5`, in the box that is asked for,
    /// `alpha=-1/4..3/4,beta=-1/2..1/2`, or in one around the largest set.
    ///
    /// # Errors
    /// A text that is no such request; whatever [`map`] refuses.
    pub fn new(
        scheme: &Scheme,
        orders: &str,
        window: Option<&str>,
        fineness: &Fineness,
    ) -> Result<Maps, Diagnostic> {
        let orders = parse_orders(orders)?;
        let (name, mask) = (scheme.name(), scheme.mask());
        let window = match window {
            Some(text) => parse_window(scheme, text)?,
            None => default_window(name, mask, orders[0])?,
        };
        let maps = orders.iter().map(|&n| map(name, mask, n, &window, fineness));
        Ok(Maps { scheme: name.into(), maps: maps.collect::<Result<_, _>>()? })
    }

    /// Maps that are known, of one family in one box, in ascending order.
    pub(crate) fn of(scheme: &Scheme, maps: Vec<Map>) -> Maps {
        Maps { scheme: scheme.name().into(), maps }
    }

    /// One row for each order: areas, and how many pieces there are.
    pub fn document(&self) -> Document {
        let row = |map: &Map| {
            let areas = map.areas();
            let count = |f: fn(&CellVerdict) -> bool| {
                map.cells.iter().filter(|cell| f(&cell.verdict)).count().to_string()
            };
            let numbers = areas.iter().map(|area| decimal(&middle(area), 9));
            let pieces = [
                count(|v| matches!(v, CellVerdict::Proved)),
                count(|v| matches!(v, CellVerdict::Refuted { .. })),
                count(|v| matches!(v, CellVerdict::Undecided)),
            ];
            let order = format!("C^{}", map.continuity());
            [order].into_iter().chain(numbers).chain([pieces.join(" + ")]).map(Cell::text).collect()
        };
        let header = ["", "proved", "refuted", "undecided", "pieces"].map(String::from).to_vec();
        let rows = self.maps.iter().map(row).collect();
        let caption = format!("Areas of C^n of {} in {}", self.scheme, self.window_text());
        let remarks = self.remarks();
        let grid = Grid { id: "map".into(), caption, header, rows, remarks };
        let json = match &self.maps[..] {
            [map] => self.json_of(map),
            maps => {
                let maps: Vec<Value> = maps.iter().map(|map| self.json_of(map)).collect();
                json!({"scheme": self.scheme, "maps": maps})
            }
        };
        Document { grids: vec![grid], summary: None, json }
    }

    fn window_text(&self) -> String {
        let map = &self.maps[0];
        let spans = map.plane.parameters().iter().zip(map.window());
        let spans = spans.map(|(p, [low, high])| format!("{low} ≤ {p} ≤ {high}"));
        spans.collect::<Vec<_>>().join(", ")
    }

    fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        for map in &self.maps {
            let n = map.continuity();
            for (inequality, polynomial) in boundaries(map) {
                let text = polynomial.to_string();
                let boundary = if text.chars().count() <= LONGEST {
                    format!("{text} = 0")
                } else {
                    let degree = polynomial.degree().unwrap_or(0);
                    format!("a polynomial of degree {degree}, which the JSON has")
                };
                remarks.push(format!(
                    "C^{n} is refuted where the product along {} has an eigenvalue of modulus at least \
                     one: boundary {boundary}",
                    inequality.word
                ));
            }
            remarks.extend(map.certificate.sections.iter().map(|section| {
                let [x, y] = section.origin.each_ref().map(|c| &c.0);
                let [dx, dy] = section.direction.each_ref().map(|c| &c.0);
                let verdict = statement(&section.certificate);
                if !map.plane.is_affine() {
                    let factor = geometric_factor(map.plane.arity());
                    format!(
                        "({factor})^{} divides the symbol at (x, y) = ({x}, {y}), and wherever the mask is \
                         the same, maybe for others too: {verdict} there",
                        n + 1
                    )
                } else if dx.is_zero() && dy.is_zero() {
                    format!("C^{n} may hold for the mask at (x, y) = ({x}, {y}) only: {verdict}")
                } else {
                    format!(
                        "C^{n} may hold on the line (x, y) = ({x}, {y}) + t ({dx}, {dy}) only: {verdict}"
                    )
                }
            }));
            remarks.extend(left_open(map));
            if let Some(polygon) = map.plane.level_one(n) {
                let corners = corner_texts(&polygon);
                let corners: Vec<String> =
                    corners.iter().map(|[x, y]| format!("({x}, {y})")).collect();
                remarks.push(format!(
                    "level one proves C^{n} inside of the polygon of (x, y) with the corners {}",
                    corners.join(" ")
                ));
            }
            if needs_stability(map) {
                let also = match n < map.plane.order() {
                    true => String::new(),
                    false => {
                        let factor = geometric_factor(map.plane.arity());
                        format!("({factor})^{} does not divide the symbol and ", n + 1)
                    }
                };
                remarks.push(format!(
                    "what is refuted for C^{n} is refuted wherever {also}the shifts of the basic limit \
                     function are stable, which is everywhere but on a curve"
                ));
            }
        }
        let cut = self.maps.iter().filter(|map| reaches_the_edge(map));
        let cut: Vec<String> = cut.map(|map| format!("C^{}", map.continuity())).collect();
        if !cut.is_empty() {
            remarks.push(format!(
                "proved up to the edge of the box, so that a larger --box may show more: {}",
                cut.join(", ")
            ));
        }
        if let Some(poles) = poles(&self.maps[0]) {
            remarks.push(format!("the mask has poles where {poles} = 0: nothing is said there"));
        }
        remarks.push(format!(
            "coordinates of the pieces: {}",
            named_coordinates(&self.maps[0].plane).join(", ")
        ));
        remarks.push("proof checked".into());
        remarks
    }

    fn json_of(&self, map: &Map) -> Value {
        let [u, v] = map.plane.parameters();
        let [[u0, u1], [v0, v1]] = map.window();
        let span = |low: &Rational, high: &Rational| json!({"lo": rational_number(low), "hi": rational_number(high)});
        let cells: Vec<Value> = map
            .cells
            .iter()
            .map(|cell| {
                let corners = corner_texts(&cell.polygon);
                json!({
                    "verdict": verdict(cell.verdict),
                    "polygon": corners,
                    "because": because(&map.certificate.nodes[cell.node]),
                })
            })
            .collect();
        let boundaries: Vec<Value> = boundaries(map)
            .iter()
            .map(|(inequality, p)| json!({"word": inequality.word, "polynomial": p.to_string()}))
            .collect();
        let sections: Vec<Value> = map
            .certificate
            .sections
            .iter()
            .map(|section| {
                let Conclusion::Continuity { proved, refuted, .. } =
                    &section.certificate.conclusion
                else {
                    return Value::Null;
                };
                let region = |list| intervals(&region_of(list), "t");
                json!({
                    "origin": section.origin.each_ref().map(|c| c.0.to_string()),
                    "direction": section.direction.each_ref().map(|c| c.0.to_string()),
                    "proved": region(proved), "refuted": region(refuted),
                })
            })
            .collect();
        let [proved, refuted, undecided] = map.areas();
        let [x, y] = named_coordinates(&map.plane);
        json!({
            "scheme": self.scheme,
            "parameters": [u.name(), v.name()],
            "continuity": map.continuity(),
            "box": {u.name(): span(&u0, &u1), v.name(): span(&v0, &v1)},
            "coordinates": [x, y],
            "poles": poles(map).map(|p| p.to_string()),
            "area": {
                "proved": area_number(proved), "refuted": area_number(refuted),
                "undecided": area_number(undecided),
            },
            "level_one": map.plane.level_one(map.continuity()).map(|p| corner_texts(&p)),
            "refuted_if_stable": needs_stability(map),
            "cells": cells,
            "boundaries": boundaries,
            "sections": sections,
        })
    }
}

fn corner_texts(polygon: &Polygon) -> Vec<[String; 2]> {
    polygon.points().iter().map(|p| p.each_ref().map(ToString::to_string)).collect()
}

/// Whether a piece on which C^n is proved has a side along the edge of the box, or a corner that is a whole side of it, as the
/// factor of the chart vanishes there. Lines and points beyond the order are not looked at.
fn reaches_the_edge(map: &Map) -> bool {
    let ([across, up], factor) = (map.window(), map.plane.factor());
    let l = |x: &Rational| factor.map_or_else(Rational::one, |l| l.evaluate(x));
    let is_along = |a: &[Rational; 2], b: &[Rational; 2]| {
        let is_end = across.contains(&a[0]);
        let is_constant = |v: &Rational| [a, b].iter().all(|p| p[1] == v * l(&p[0]));
        (is_end && (a[0] == b[0] || l(&a[0]).is_zero())) || up.iter().any(is_constant)
    };
    map.cells.iter().filter(|cell| cell.verdict == CellVerdict::Proved).any(|cell| {
        let points = cell.polygon.points();
        points.iter().zip(points.iter().cycle().skip(1)).any(|(a, b)| is_along(a, b))
    })
}

/// Whether a piece is refuted only where shifts are stable.
fn needs_stability(map: &Map) -> bool {
    map.cells.iter().any(|cell| cell.verdict == CellVerdict::Refuted { if_stable: true })
}

/// `x = alpha` and `y = beta*(1 - alpha)`.
pub(crate) fn named_coordinates(plane: &Plane) -> [String; 2] {
    let [x, y] = coordinates(plane);
    [format!("x = {x}"), format!("y = {y}")]
}

/// `alpha` and `beta*(1 - alpha)`.
pub(crate) fn coordinates(plane: &Plane) -> [String; 2] {
    let [u, v] = plane.parameters();
    let y = plane.factor().map_or_else(
        || v.to_string(),
        |l| {
            let affine = ParameterPolynomial::constant(l.coefficient(0))
                .plus(&ParameterPolynomial::parameter(u).scaled(&l.coefficient(1)));
            let affine = affine.to_string();
            if affine.contains(' ') { format!("{v}*({affine})") } else { format!("{v}*{affine}") }
        },
    );
    [u.to_string(), y]
}

/// Longer polynomials are not printed in full.
const LONGEST: usize = 160;

/// The word for a verdict.
pub(crate) fn verdict(verdict: CellVerdict) -> &'static str {
    match verdict {
        CellVerdict::Proved => "proved",
        CellVerdict::Refuted { .. } => "refuted",
        CellVerdict::Undecided => "undecided",
    }
}

/// What a piece is decided by.
pub(crate) fn because(node: &Node) -> String {
    match node {
        Node::Norm => "norm".into(),
        Node::Ellipsoids(ellipsoids) => format!("ellipsoids of memory {}", ellipsoids.memory),
        Node::Word(inequality) => format!("word {}", inequality.word),
        Node::Expansion(expansion) => format!("expansion along the letters {}", expansion.word),
        Node::Indivisible => "division".into(),
        Node::Undecided | Node::Cut { .. } => String::new(),
    }
}

/// The boundary curves that occur, as primitive polynomials in the parameters.
fn boundaries(map: &Map) -> Vec<(Inequality, ParameterPolynomial)> {
    let mut found: Vec<(Inequality, ParameterPolynomial)> = Vec::new();
    let poles = poles(map);
    for (inequality, terms) in map.boundaries() {
        let polynomial = in_parameters(map, &terms);
        // For the sake of its sign an inequality may have the denominator as a factor.
        let quotient =
            poles.as_ref().and_then(|d| ParameterFraction::new(polynomial.clone(), d).ok());
        let polynomial = match quotient.as_ref().and_then(ParameterFraction::as_polynomial) {
            Some(quotient) => quotient.primitive().2,
            None => polynomial,
        };
        if !found.iter().any(|(_, known)| *known == polynomial) {
            found.push((inequality, polynomial));
        }
    }
    found
}

/// Where a higher power divides the symbol and nothing is said, if that is not known to be nowhere.
fn left_open(map: &Map) -> Option<String> {
    let order = map.continuity() + 1;
    if order <= map.plane.order() || !map.certificate.sections.is_empty() {
        return None;
    }
    let terms = |form: &Polynomial<Polynomial<Rational>>| -> Terms {
        let rows = form.coefficients().iter().enumerate();
        let entries = rows.flat_map(|(j, row)| {
            let row = row.coefficients().iter().enumerate();
            row.map(move |(i, c)| (Number(c.clone()), i as u32, j as u32))
        });
        entries.collect()
    };
    let conditions = map.plane.divisibility(order);
    let conditions: Vec<ParameterPolynomial> =
        conditions.iter().map(|form| in_parameters(map, &terms(form))).collect();
    let common = conditions.iter().fold(ParameterPolynomial::zero(), |g, p| g.gcd(p));
    let never = |p: &ParameterPolynomial| !may_vanish(p);
    if conditions.iter().any(never) {
        return None;
    }
    let factor = geometric_factor(map.plane.arity());
    let text = common.to_string();
    let place = match common.as_constant() {
        Some(_) => "at single points at most".into(),
        None if never(&common) => return None,
        None if text.chars().count() <= LONGEST => format!("where {text} = 0"),
        None => "on a curve".into(),
    };
    Some(format!("({factor})^{order} may divide the symbol {place}: C^{} is open there", order - 1))
}

/// The polynomial that vanishes at the poles, primitive, if there are some.
fn poles(map: &Map) -> Option<ParameterPolynomial> {
    let denominator = in_parameters(map, map.certificate.family.denominator.as_ref()?);
    may_vanish(&denominator).then_some(denominator)
}

/// A polynomial in `x` and `y` as one in the parameters, primitive.
fn in_parameters(map: &Map, terms: &Terms) -> ParameterPolynomial {
    let [u, v] = map.plane.parameters();
    let one = Polynomial::constant(Rational::one());
    let factor = map.plane.factor().unwrap_or(&one);
    let power = |p: &Parameter, e: u32| {
        ParameterPolynomial::term(Rational::one(), Monomial::power(p.clone(), e))
    };
    let factor = factor
        .coefficients()
        .iter()
        .enumerate()
        .fold(ParameterPolynomial::zero(), |sum, (k, c)| sum.plus(&power(u, k as u32).scaled(c)));
    let sum = terms.iter().fold(ParameterPolynomial::zero(), |sum, (c, i, j)| {
        let y = power(v, *j).times(&factor.power(*j));
        sum.plus(&power(u, *i).times(&y).scaled(&c.0))
    });
    sum.primitive().2
}

fn middle(area: &Area) -> Rational {
    (&area.lower + &area.upper) / Rational::from_i64(2)
}

/// `{"exact", "lower", "upper", "approx"}`; `exact` is null for an area that is not known exactly.
fn area_number(area: &Area) -> Value {
    if area.lower == area.upper {
        return rational_number(&area.lower);
    }
    let approx: Option<f64> = decimal(&middle(area), 15).parse().ok();
    // Outwards, to short decimals.
    let unit = Rational::from_i64(10).power(15);
    let lower = (&area.lower * &unit).floor() / &unit;
    let upper = (&area.upper * &unit).ceil() / &unit;
    json!({
        "exact": Value::Null, "lower": lower.to_string(), "upper": upper.to_string(), "approx": approx,
    })
}

/// The most orders that are mapped at once.
pub(crate) const MOST_ORDERS: usize = 24;

fn parse_orders(text: &str) -> Result<Vec<usize>, Diagnostic> {
    let number = |text: &str| text.trim().parse::<usize>().ok().filter(|&n| n < 1000);
    let orders = match text.split_once("..") {
        Some((from, to)) => number(from).zip(number(to)).map(|(a, b)| (a..=b).collect()),
        None => number(text).map(|n| vec![n]),
    };
    orders.filter(|all: &Vec<usize>| !all.is_empty() && all.len() <= MOST_ORDERS).ok_or_else(|| {
        Diagnostic::new("continuity", format!("`{text}` is no order of continuity and no range"))
            .with_hint("for example --continuity 2 or --continuity 0..5, at most 24 orders at once")
    })
}

/// The box of a request such as `alpha=-1/4..3/4,beta=-1/2..1/2`, in the order of the parameters.
pub(crate) fn parse_window(scheme: &Scheme, text: &str) -> Result<Window, Diagnostic> {
    let error = |message: String| {
        Diagnostic::new("box", message)
            .with_hint("for example --box 'alpha=-1/4..3/4,beta=-1/2..1/2'")
    };
    let plane = Plane::new(scheme.name(), scheme.mask())?;
    let mut spans: [Option<[Rational; 2]>; 2] = [None, None];
    for part in text.split(',') {
        let (name, span) = named(part).map_err(error)?;
        let place = plane.parameters().iter().position(|p| p.name() == name);
        let place = place.ok_or_else(|| {
            let [u, v] = plane.parameters();
            error(format!("the free parameters are {u} and {v}, not {name}"))
        })?;
        if spans[place].replace(parse_span(span).map_err(error)?).is_some() {
            return Err(error(format!("{name} is given twice")));
        }
    }
    match spans {
        [Some(u), Some(v)] => Ok([u, v]),
        _ => Err(error("the box needs both parameters".into())),
    }
}

/// A point such as `alpha=1/10,beta=-49/1152`, in the order of the parameters of a map.
///
/// # Errors
/// Code `mark` if it is no such point.
pub(crate) fn parse_point(map: &Map, text: &str) -> Result<[Rational; 2], Diagnostic> {
    let error = |message: String| {
        Diagnostic::new("mark", message).with_hint("for example --mark 'alpha=1/10,beta=-49/1152'")
    };
    let value = |parameter: &Parameter| {
        let part = text.split(',').filter_map(|part| part.split_once('='));
        let mut values = part.filter(|(name, _)| name.trim() == parameter.name());
        let (_, value) = values
            .next()
            .ok_or_else(|| error(format!("`{text}` does not say what {parameter} is")))?;
        parse_rational(value.trim())
            .ok_or_else(|| error(format!("`{value}` is no rational number")))
    };
    let [u, v] = map.plane.parameters();
    Ok([value(u)?, value(v)?])
}

/// A curve such as `beta=(8*alpha-1)/(16*(1-alpha))`: which of the parameters it gives, and how.
///
/// # Errors
/// Whatever a substitution refuses; code `curve` if it is not one parameter in terms of the other.
pub(crate) fn parse_curve(map: &Map, text: &str) -> Result<(usize, Substitution), Diagnostic> {
    let curve = Substitution::parse(text)?;
    let parameters = map.plane.parameters();
    let place = parameters.iter().position(|p| p == curve.parameter());
    let other = place.map(|place| &parameters[1 - place]);
    let fits = other.is_some_and(|other| curve.value().parameters().iter().all(|p| p == other));
    match place {
        Some(place) if fits => Ok((place, curve)),
        _ => {
            let [u, v] = parameters;
            Err(Diagnostic::new("curve", format!("a curve gives {u} or {v} in terms of the other"))
                .with_hint("for example --curve 'beta=(8*alpha-1)/(16*(1-alpha))'"))
        }
    }
}
