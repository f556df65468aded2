//! Maps as pictures: nested shades, with curves and marks over them.
//!
//! Proved orders are shades of one blue, the darker the higher, so that they are told apart in grey;
//! what is undecided is hatched, what is refuted is left white.

use std::fmt::Write;

use refinable_algebra::{ParameterFraction, ParameterPolynomial, Rational, Ring, rational};
use refinable_analysis::{Map, MapVerdict, Window, region_of};
use refinable_certificate::{CellVerdict, Conclusion, Section};
use refinable_reals::{Bound, Region};
use refinable_scheme::Diagnostic;

use crate::frame::{Frame, HEIGHT, LEFT, TOP, WIDTH};
use crate::map::{Maps, parse_curve, parse_point};
use crate::svg::{SHADES, escape, halo, place, raised};

/// The length of straight pieces of an edge that is drawn as a curve, and how many there are at most.
const EDGE: f64 = 16.0;
const MOST_PIECES: f64 = 16.0;
/// Straight pieces of a curve.
const CURVE: i64 = 400;
const LINE: i64 = 60;
/// How curves are told apart.
const DASHES: [&str; 4] = ["none", "7 3", "2 3", "9 3 2 3"];

impl Maps {
    /// The picture, with curves such as `beta=(8*alpha-1)/(16*(1-alpha))` and marked points such as
    /// `alpha=1/10,beta=-49/1152`.
    ///
    /// # Errors
    /// A curve or point that is none.
    pub fn picture(&self, curves: &[String], marks: &[String]) -> Result<String, Diagnostic> {
        self.picture_in(self.maps[0].window(), curves, marks)
    }

    /// The picture of another box.
    pub(crate) fn picture_in(
        &self,
        window: Window,
        curves: &[String],
        marks: &[String],
    ) -> Result<String, Diagnostic> {
        let frame = Frame::new(window);
        let pattern = "<pattern id=\"undecided\" width=\"4\" height=\"4\" \
                       patternUnits=\"userSpaceOnUse\"><path d=\"M0 4L4 0M0 0L4 4\" \
                       stroke=\"#b2182b\" stroke-width=\"0.9\"/></pattern>";
        let mut svg = Frame::begin(&self.title(), pattern);
        for map in &self.maps {
            let shade = self.shade(map);
            draw(&mut svg, map, &frame, CellVerdict::Proved, shade);
        }
        for map in &self.maps {
            draw(&mut svg, map, &frame, CellVerdict::Undecided, "url(#undecided)");
        }
        for (k, curve) in curves.iter().enumerate() {
            let path = self.curve(&frame, curve)?;
            let dashes = DASHES[k % DASHES.len()];
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"1.4\" \
                 stroke-dasharray=\"{dashes}\"/>"
            );
        }
        for map in &self.maps {
            let path = sections(map, &frame);
            let shade = self.shade(map);
            // A point is a path of no length.
            let stays = |s: &Section| s.direction.iter().all(|d| d.0.is_zero());
            let is_point = map.certificate.sections.iter().any(stays);
            let caps = if is_point { " stroke-linecap=\"round\"" } else { "" };
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"5\"{caps}/>\
                 <path d=\"{path}\" fill=\"none\" stroke=\"{shade}\" stroke-width=\"3\"{caps}/>"
            );
        }
        for mark in marks {
            let [u, v] = parse_point(&self.maps[0], mark)?;
            let (x, y) = (frame.across(&u), frame.down(&v));
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" fill=\"#ffffff\" stroke=\"#000000\" \
                 stroke-width=\"1.6\"/>"
            );
        }
        frame.finish(&mut svg, self.maps[0].plane.parameters());
        self.labels(&mut svg, &frame);
        self.legend(&mut svg, curves, marks);
        svg.push_str("</svg>\n");
        Ok(svg)
    }

    fn title(&self) -> String {
        let map = &self.maps[0];
        let orders: Vec<String> = self.maps.iter().map(|m| order(m.continuity())).collect();
        format!("{} of {}", orders.join(", "), map.plane.name())
    }

    fn shade(&self, map: &Map) -> &'static str {
        let count = self.maps.len();
        let place = self.maps.iter().position(|m| m.continuity() == map.continuity()).unwrap_or(0);
        if count == 1 {
            SHADES[2]
        } else {
            SHADES[(place * SHADES.len() / count).min(SHADES.len() - 1)]
        }
    }

    /// The name of each order in the largest of its pieces of which the middle has no higher order.
    fn labels(&self, svg: &mut String, frame: &Frame) {
        for (k, map) in self.maps.iter().enumerate() {
            let mut best: Option<(f64, f64, f64)> = None;
            for cell in map.cells.iter().filter(|cell| cell.verdict == CellVerdict::Proved) {
                let points = cell.polygon.points();
                let middle = mean(&points);
                let covered = self.maps.get(k + 1).is_some_and(|next| is_proved(next, &middle));
                let place = corners(map, frame, &[middle]).first().copied();
                let shown = place.filter(|(x, y)| !covered && frame.contains(*x, *y));
                let Some((x, y)) = shown else { continue };
                let area = shoelace(&corners(map, frame, &points));
                if best.is_none_or(|(most, ..)| area > most) {
                    best = Some((area, x, y));
                }
            }
            if let Some((_, x, y)) = best {
                svg.push_str(&halo([x, y + 4.0], "middle", &order(map.continuity())));
            }
        }
    }

    fn legend(&self, svg: &mut String, curves: &[String], marks: &[String]) {
        let x = LEFT + WIDTH + 14.0;
        let mut y = TOP + 10.0;
        let mut row = |svg: &mut String, sample: &dyn Fn(f64) -> String, text: &str| {
            let _ = writeln!(
                svg,
                "{}<text x=\"{:.0}\" y=\"{:.0}\">{}</text>",
                sample(y),
                x + 26.0,
                y + 4.0,
                escape(text)
            );
            y += 20.0;
        };
        let block = |fill: String| {
            move |y: f64| {
                format!(
                    "<rect x=\"{x:.0}\" y=\"{:.0}\" width=\"20\" height=\"12\" fill=\"{fill}\" \
                     stroke=\"#888888\" stroke-width=\"0.5\"/>",
                    y - 6.0
                )
            }
        };
        for map in &self.maps {
            let sections = || map.certificate.sections.iter().filter(|s| !proved_on(s).is_empty());
            let on_line = sections().next().is_some();
            let moves = sections().any(|s| s.direction.iter().any(|d| !d.0.is_zero()));
            let on = match (on_line, moves) {
                (true, true) => ", on a line",
                (true, false) => ", one mask",
                (false, _) => "",
            };
            let proved = map.cells.iter().any(|cell| cell.verdict == CellVerdict::Proved);
            let verb = if proved || on_line { "proved" } else { "nowhere proved" };
            let text = format!("{} {verb}{on}", order(map.continuity()));
            row(svg, &block(self.shade(map).into()), &text);
        }
        row(svg, &block("url(#undecided)".into()), "undecided");
        row(svg, &block("#ffffff".into()), "refuted");
        for k in 0..curves.len() {
            let dashes = DASHES[k % DASHES.len()];
            let line = move |y: f64| {
                format!(
                    "<path d=\"M{x:.0} {y:.0}h20\" stroke=\"#000000\" stroke-width=\"1.4\" \
                     stroke-dasharray=\"{dashes}\"/>"
                )
            };
            row(svg, &line, &format!("curve {}", k + 1));
        }
        if !marks.is_empty() {
            let circle = move |y: f64| {
                format!(
                    "<circle cx=\"{:.0}\" cy=\"{y:.0}\" r=\"4\" fill=\"#ffffff\" stroke=\"#000000\" \
                     stroke-width=\"1.6\"/>",
                    x + 10.0
                )
            };
            row(svg, &circle, "marked");
        }
    }

    /// A curve as a path; it is left where it has a pole or leaves the box far behind.
    fn curve(&self, frame: &Frame, text: &str) -> Result<String, Diagnostic> {
        let map = &self.maps[0];
        let (place, curve) = parse_curve(map, text)?;
        let other = &map.plane.parameters()[1 - place];
        let [low, high] = &frame.window[1 - place];
        let mut path = String::new();
        let mut pen_down = false;
        for k in 0..=CURVE {
            let t = low + (high - low) * rational(k, CURVE);
            let value = ParameterFraction::from(ParameterPolynomial::constant(t.clone()));
            let at = curve.value().substitute(other, &value).ok();
            let Some(value) = at.and_then(|value| value.as_constant()) else {
                pen_down = false;
                continue;
            };
            let point = if place == 1 { [t, value] } else { [value, t] };
            let (x, y) = (frame.across(&point[0]), frame.down(&point[1]));
            let near = x > -WIDTH && x < 3.0 * WIDTH && y > -HEIGHT && y < 3.0 * HEIGHT;
            if near {
                let _ = write!(path, "{}{x:.2} {y:.2}", if pen_down { "L" } else { "M" });
            }
            pen_down = near;
        }
        Ok(path)
    }
}

/// All pieces with a verdict as one path.
fn draw(svg: &mut String, map: &Map, frame: &Frame, verdict: CellVerdict, fill: &str) {
    let mut path = String::new();
    for cell in map.cells.iter().filter(|cell| cell.verdict == verdict) {
        let corners = corners(map, frame, &cell.polygon.points());
        if !frame.meets(&corners) {
            continue;
        }
        for (k, (x, y)) in corners.into_iter().enumerate() {
            let _ = write!(path, "{}{x:.2} {y:.2}", if k == 0 { "M" } else { "L" });
        }
        path.push('Z');
    }
    if path.is_empty() {
        return;
    }
    // A hair of stroke closes the seams between pieces.
    let stroke = if verdict == CellVerdict::Undecided { "#b2182b" } else { fill };
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"0.4\" \
         stroke-linejoin=\"round\"/>"
    );
}

/// Where on its line a section proves the order.
pub(crate) fn proved_on(section: &Section) -> Region {
    match &section.certificate.conclusion {
        Conclusion::Continuity { proved, .. } => region_of(proved),
        _ => Region::empty(),
    }
}

/// The lines, or points, on which a map proves an order that holds nowhere else, as a path.
fn sections(map: &Map, frame: &Frame) -> String {
    let mut path = String::new();
    for section in &map.certificate.sections {
        let at = |t: &Rational| [0, 1].map(|i| &section.origin[i].0 + &section.direction[i].0 * t);
        for interval in proved_on(section).intervals() {
            let end = |bound: &Bound| bound.number().map(|x| x.enclosure(&rational(1, 1 << 30)).0);
            let (Some(low), Some(high)) = (end(&interval.lower), end(&interval.upper)) else {
                continue;
            };
            for k in 0..=LINE {
                let t = &low + (&high - &low) * rational(k, LINE);
                // An edge from the point to itself would have no place in the picture.
                for (x, y) in corners(map, frame, &[at(&t)]).into_iter().take(1) {
                    let _ = write!(path, "{}{x:.2} {y:.2}", if k == 0 { "M" } else { "L" });
                }
            }
        }
    }
    path
}

/// A polygon of the plane of `(x, y)` in picture coordinates, edges that are curves there in pieces.
fn corners(map: &Map, frame: &Frame, points: &[[Rational; 2]]) -> Vec<(f64, f64)> {
    let factor = map.plane.factor().map(|l| [0, 1].map(|k| place(&l.coefficient(k))));
    let floats: Vec<[f64; 2]> = points.iter().map(|p| p.each_ref().map(place)).collect();
    let Some([c, d]) = factor else {
        return floats.iter().map(|[x, y]| (frame.x(*x), frame.y(*y))).collect();
    };
    let factor = |[x, _]: &[f64; 2]| c + d * x;
    let at = |[x, y]: [f64; 2]| (frame.x(x), frame.y(y / factor(&[x, y])));
    let is_singular = |point: &[f64; 2]| factor(point).abs() < 1e-12;
    let next = floats.iter().cycle().skip(1);
    let mut all = Vec::new();
    for (a, b) in floats.iter().zip(next) {
        // A corner at which the factor vanishes is a whole edge there; on edges towards it v is constant.
        match (is_singular(a), is_singular(b)) {
            (true, true) => {}
            (true, false) => all.push((frame.x(a[0]), at(*b).1)),
            (false, true) => all.extend([at(*a), (frame.x(b[0]), at(*a).1)]),
            (false, false) => {
                // Short edges are as good as straight.
                let ((px, py), (qx, qy)) = (at(*a), at(*b));
                let pieces = ((qx - px).hypot(qy - py) / EDGE).clamp(1.0, MOST_PIECES) as usize;
                let step = |k: usize| k as f64 / pieces as f64;
                all.extend((0..pieces).map(|k| at([0, 1].map(|i| a[i] + step(k) * (b[i] - a[i])))));
            }
        }
    }
    all
}

fn mean(points: &[[Rational; 2]]) -> [Rational; 2] {
    let count = Rational::from_i64(points.len() as i64);
    [0, 1].map(|i| points.iter().map(|p| p[i].clone()).sum::<Rational>() / &count)
}

/// Whether the order is proved at a point of the plane of `(x, y)`.
fn is_proved(map: &Map, point: &[Rational; 2]) -> bool {
    let at = map.plane.parameters_at(point);
    at.is_some_and(|parameters| map.verdict_at(&parameters) == MapVerdict::Proved)
}

fn shoelace(points: &[(f64, f64)]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let sum: f64 = points.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum();
    (0.5 * sum).abs()
}

/// `C⁰`, `C¹`, …
fn order(n: usize) -> String {
    let raised = raised(&n.to_string()).unwrap_or_default();
    format!("C{raised}")
}

#[cfg(test)]
mod tests {
    use refinable_analysis::Fineness;
    use refinable_scheme::Scheme;

    use super::*;

    /// What is drawn covers the area that is proved, also where the factor of the chart vanishes in the box.
    #[test]
    fn drawn_areas_are_the_areas() {
        for (text, window) in [
            ("even: [a*b, 1-2*a*b, a*b]; odd: [1/2, 1/2]", "a=-1..1,b=-1..1"),
            ("fourpoint(a*b)", "a=-1..1,b=-1/2..1"),
            ("combine(combine(bspline3, dd4, s), bspline1, t)", "t=0..2,s=-4..4"),
            ("a3", "alpha=0..1/2,beta=-1/4..1/4"),
            ("[a, 1/2+b, 1-2*a, 1/2-b, a]", "a=-1/2..1/2,b=-1/2..1/2"),
        ] {
            let scheme = Scheme::resolve(text, 2).unwrap();
            let maps = Maps::new(&scheme, "0", Some(window), &Fineness::default()).unwrap();
            let map = &maps.maps[0];
            let frame = Frame::new(map.window());
            let proved = map.cells.iter().filter(|cell| cell.verdict == CellVerdict::Proved);
            let drawn: f64 =
                proved.map(|cell| shoelace(&corners(map, &frame, &cell.polygon.points()))).sum();
            let [width, height] = map.window().map(|[low, high]| place(&(high - low)));
            let drawn = drawn / (WIDTH * HEIGHT) * width * height;
            let exact = place(&map.areas()[0].lower);
            assert!((drawn / exact - 1.0).abs() < 0.005, "{text}: {drawn} for {exact}");
        }
    }
}
