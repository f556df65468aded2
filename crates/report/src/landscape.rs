//! The Hölder exponent over two parameters, as data and as a picture with contours.

use std::collections::BTreeMap;
use std::fmt::Write;

use refinable_algebra::{Rational, decimal};
use refinable_analysis::{Landscape, Locus, Summit, default_window, landscape};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::{Value, json};

use crate::frame::{Frame, HEIGHT, LEFT, TOP, WIDTH};
use crate::grid::{Cell, Document, Grid};
use crate::interproximate::floored;
use crate::map::{named_coordinates, parse_window};
use crate::number::rational_number;
use crate::regularity::{bounds_text, exact_text, outward};
use crate::svg::{SHADES, halo, place};

/// Nodes of the grid in each direction.
const NODES: [usize; 2] = [193, 145];
/// Longer exact exponents are left to the JSON.
const LONGEST: usize = 60;
/// The highest contour.
const HIGHEST: i64 = 40;
/// Contours between two integers.
const PARTS: i64 = 4;
/// The landscape of a family, ready to be shown.
#[derive(Clone, Debug)]
pub struct HolderMap {
    scheme: String,
    arity: usize,
    landscape: Landscape,
}

impl HolderMap {
    /// The landscape in the box that is asked for, or in one around where the family converges.
    ///
    /// # Errors
    /// A text that is no box; whatever [`landscape`] refuses.
    pub fn new(scheme: &Scheme, window: Option<&str>) -> Result<HolderMap, Diagnostic> {
        let (name, mask) = (scheme.name(), scheme.mask());
        let window = match window {
            Some(text) => parse_window(scheme, text)?,
            None => default_window(name, mask, 0)?,
        };
        let landscape = landscape(name, mask, &window, NODES)?;
        Ok(HolderMap { scheme: name.into(), arity: mask.arity(), landscape })
    }

    /// One row for each summit.
    pub fn document(&self) -> Document {
        let Landscape { plane, summits, missed, window, .. } = &self.landscape;
        let [u, v] = plane.parameters();
        let row = |summit: &Summit| {
            let (lower, upper) = outward(&summit.regularity);
            let [a, b] = &summit.parameters;
            let exact = exact_text(&summit.regularity, self.arity);
            let exponent = match exact.filter(|text| text.chars().count() <= LONGEST) {
                Some(whole) if Some(&lower) == upper.as_ref() => whole,
                Some(text) => format!("{text} ≈ {}", decimal(&lower, 8)),
                None => bounds_text(&lower, upper.as_ref(), 10),
            };
            let cells = [locus_text(&summit.locus), a.to_string(), b.to_string(), exponent];
            cells.into_iter().map(Cell::text).collect()
        };
        let header = ["where", u.name(), v.name(), "Hölder exponent"].map(String::from).to_vec();
        let [[u0, u1], [v0, v1]] = window;
        let caption =
            format!("Smoothest members of {} in {u0} ≤ {u} ≤ {u1}, {v0} ≤ {v} ≤ {v1}", self.scheme);
        let mut remarks = vec![
            "parameters are searched for and rounded, exponents are proved: there may be smoother members"
                .to_string(),
        ];
        remarks.extend(missed.iter().map(|locus| {
            format!("{}: no bounds for the exponent of the smoothest member", locus_text(locus))
        }));
        remarks.push(format!("coordinates of lines: {}", named_coordinates(plane).join(", ")));
        let rows = summits.iter().map(row).collect();
        let grid = Grid { id: "holder".into(), caption, header, rows, remarks };
        Document { grids: vec![grid], summary: None, json: self.json() }
    }

    fn json(&self) -> Value {
        let Landscape { plane, window, nodes, exponents, summits, .. } = &self.landscape;
        let [u, v] = plane.parameters();
        let span = |[low, high]: &[Rational; 2]| json!({"lo": rational_number(low), "hi": rational_number(high)});
        let summit = |summit: &Summit| {
            let (lower, upper) = outward(&summit.regularity);
            let [a, b] = summit.parameters.each_ref().map(rational_number);
            json!({
                "where": locus_text(&summit.locus),
                "parameters": {u.name(): a, v.name(): b},
                "holder": {
                    "exact": exact_text(&summit.regularity, self.arity),
                    "lower": lower.to_string(), "upper": upper.map(|upper| upper.to_string()),
                    "approx": place(&lower),
                },
                "continuity": summit.regularity.continuity,
                "divided_order": summit.regularity.divided_order,
                "word": summit.regularity.word,
            })
        };
        let rows: Vec<Vec<f64>> =
            exponents.chunks(nodes[0]).map(|row| row.iter().map(place).collect()).collect();
        json!({
            "scheme": self.scheme,
            "what": "holder",
            "parameters": [u.name(), v.name()],
            "box": {u.name(): span(&window[0]), v.name(): span(&window[1])},
            "maximum": self.landscape.highest().map(summit),
            "summits": summits.iter().map(summit).collect::<Vec<_>>(),
            "approximate_exponents": rows,
        })
    }

    /// The picture: shades for each unit of the exponent, contours, and the summits.
    pub fn picture(&self) -> String {
        let Landscape { plane, window, .. } = &self.landscape;
        let frame = Frame::new(window.clone());
        let mut svg = Frame::begin(&format!("Hölder exponent of {}", self.scheme), "");
        Field::new(&self.landscape).draw(&mut svg);
        self.draw_summits(&mut svg, &frame);
        frame.finish(&mut svg, plane.parameters());
        self.legend(&mut svg);
        svg.push_str("</svg>\n");
        svg
    }

    fn draw_summits(&self, svg: &mut String, frame: &Frame) {
        for (k, summit) in self.landscape.summits.iter().enumerate() {
            let [a, b] = &summit.parameters;
            let (x, y) = (frame.across(a), frame.down(b));
            let cross = format!("M{:.2} {y:.2}h10M{x:.2} {:.2}v10", x - 5.0, y - 5.0);
            let _ = writeln!(
                svg,
                "<path d=\"{cross}\" stroke=\"#ffffff\" stroke-width=\"4\"/>\
                 <path d=\"{cross}\" stroke=\"#000000\" stroke-width=\"1.6\"/>"
            );
            svg.push_str(&halo([x + 8.0, y - 6.0], "start", &letter(k)));
        }
    }

    fn legend(&self, svg: &mut String) {
        let summits = self.landscape.summits.iter().enumerate().map(|(k, summit)| {
            let (lower, upper) = outward(&summit.regularity);
            let dots = if Some(&lower) == upper.as_ref() { "" } else { "…" };
            let value = floored(&lower);
            format!("{}: {value}{dots}{}", letter(k), where_text(&summit.locus))
        });
        let lines = std::iter::once("contours: ¼ thin, 1 thick".to_string()).chain(summits);
        for (k, text) in lines.enumerate() {
            let (x, y) = (LEFT + WIDTH + 14.0, TOP + 10.0 + 18.0 * k as f64);
            let _ = writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\">{text}</text>");
        }
    }
}

fn letter(k: usize) -> String {
    char::from_u32('A' as u32 + k as u32 % 26).unwrap_or('A').to_string()
}

fn where_text(locus: &Locus) -> &'static str {
    match locus {
        Locus::Plane => "",
        Locus::Line(..) => " (on a line)",
        Locus::Point => " (at a point)",
        Locus::Mask => " (one mask)",
    }
}

fn locus_text(locus: &Locus) -> String {
    match locus {
        Locus::Plane => "plane".into(),
        Locus::Line(line) => {
            let [[x, y], [dx, dy]] = &**line;
            format!("line (x, y) = ({x}, {y}) + t ({dx}, {dy})")
        }
        Locus::Point => "point".into(),
        Locus::Mask => "mask".into(),
    }
}

/// Values at the nodes of a grid, in picture coordinates.
struct Field {
    nodes: [usize; 2],
    values: Vec<f64>,
}

impl Field {
    fn new(landscape: &Landscape) -> Self {
        Field { nodes: landscape.nodes, values: landscape.exponents.iter().map(place).collect() }
    }

    /// Shades, contours, and labels at contours of integers.
    fn draw(&self, svg: &mut String) {
        let high = self.highest().min(HIGHEST);
        for level in 0..=high {
            let shade = SHADES[(level as usize).min(SHADES.len() - 1)];
            let path = self.above(level as f64);
            let _ = writeln!(svg, "<path d=\"{path}\" fill=\"{shade}\"/>");
        }
        let mut labels = String::new();
        for k in 0..(high + 1) * PARTS {
            let whole = k % PARTS == 0;
            let lines = self.contour(k as f64 / PARTS as f64);
            let mut path = String::new();
            for line in &lines {
                for (i, [x, y]) in line.iter().enumerate() {
                    let _ = write!(path, "{}{x:.2} {y:.2}", if i == 0 { "M" } else { "L" });
                }
            }
            let width = if whole { 1.3 } else { 0.4 };
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"{width}\"/>"
            );
            let longest = lines.iter().max_by_key(|line| line.len()).filter(|line| line.len() > 8);
            if let Some(line) = longest.filter(|_| whole) {
                let [x, y] = line[line.len() / 2];
                labels.push_str(&halo([x, y + 4.0], "middle", &(k / PARTS).to_string()));
            }
        }
        svg.push_str(&labels);
    }

    /// The largest integer that is reached.
    fn highest(&self) -> i64 {
        self.values.iter().copied().fold(0.0, f64::max).floor() as i64
    }

    fn place(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        [
            LEFT + WIDTH * i as f64 / (self.nodes[0] - 1) as f64,
            TOP + HEIGHT * (1.0 - j as f64 / (self.nodes[1] - 1) as f64),
        ]
    }

    fn value(&self, [i, j]: [usize; 2]) -> f64 {
        self.values[j * self.nodes[0] + i]
    }

    /// Two triangles for each square of the grid.
    fn triangles(&self) -> impl Iterator<Item = [[usize; 2]; 3]> {
        let [columns, rows] = self.nodes;
        (0..rows - 1).flat_map(move |j| {
            (0..columns - 1).flat_map(move |i| {
                let [a, b, c, d] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                [[a, b, c], [a, c, d]]
            })
        })
    }

    /// Where a level is crossed between two nodes.
    fn crossing(&self, a: [usize; 2], b: [usize; 2], level: f64) -> [f64; 2] {
        let (u, v) = (self.value(a), self.value(b));
        let t = (level - u) / (v - u);
        let (p, q) = (self.place(a), self.place(b));
        [0, 1].map(|k| p[k] + t * (q[k] - p[k]))
    }

    /// Where values are at least the level, as a path: for each row of squares what is full at once.
    fn above(&self, level: f64) -> String {
        let mut path = String::new();
        let mut draw = |corners: &[[f64; 2]]| {
            for (k, [x, y]) in corners.iter().enumerate() {
                let _ = write!(path, "{}{x:.2} {y:.2}", if k == 0 { "M" } else { "L" });
            }
            path.push_str(if corners.is_empty() { "" } else { "Z" });
        };
        let is_above = |node: [usize; 2]| self.value(node) >= level;
        let full = |i: usize, j: usize| {
            [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]].into_iter().all(is_above)
        };
        let [columns, rows] = self.nodes;
        for j in 0..rows - 1 {
            let mut i = 0;
            while i < columns - 1 {
                let run = (i..columns - 1).take_while(|&i| full(i, j)).count();
                if run > 0 {
                    let ends = [[i, j], [i + run, j], [i + run, j + 1], [i, j + 1]];
                    draw(&ends.map(|node| self.place(node)));
                }
                i += run.max(1);
            }
        }
        for triangle in self.triangles() {
            let low = triangle.iter().map(|n| n[0]).min().unwrap_or(0);
            let bottom = triangle.iter().map(|n| n[1]).min().unwrap_or(0);
            if full(low, bottom) {
                continue;
            }
            let mut corners = Vec::new();
            for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (triangle[a], triangle[b])) {
                corners.extend(is_above(a).then(|| self.place(a)));
                corners.extend((is_above(a) != is_above(b)).then(|| self.crossing(a, b, level)));
            }
            draw(&corners);
        }
        path
    }

    /// Where values are equal to the level, as polygonal lines.
    fn contour(&self, level: f64) -> Vec<Vec<[f64; 2]>> {
        type Edge = ([usize; 2], [usize; 2]);
        let is_above = |node: [usize; 2]| self.value(node) >= level;
        // Each crossed edge with the crossed edges of its triangles.
        let mut beside: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
        for triangle in self.triangles() {
            let edges = [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (triangle[a], triangle[b]));
            let crossed: Vec<Edge> = edges
                .into_iter()
                .filter(|&(a, b)| is_above(a) != is_above(b))
                .map(|(a, b)| (a.min(b), a.max(b)))
                .collect();
            if let [e, f] = crossed[..] {
                beside.entry(e).or_default().push(f);
                beside.entry(f).or_default().push(e);
            }
        }
        let mut lines = Vec::new();
        // Open lines from their ends, then closed ones.
        let ends: Vec<Edge> =
            beside.iter().filter(|(_, others)| others.len() == 1).map(|(e, _)| *e).collect();
        let all: Vec<Edge> = beside.keys().copied().collect();
        for start in ends.into_iter().chain(all) {
            let mut line = Vec::new();
            let mut at = Some(start);
            while let Some(edge) = at {
                let Some(others) = beside.remove(&edge) else { break };
                line.push(self.crossing(edge.0, edge.1, level));
                at = others.iter().find(|other| beside.contains_key(other)).copied();
                if at.is_none() && others.contains(&start) && line.len() > 2 {
                    line.push(line[0]);
                }
            }
            lines.extend((line.len() > 1).then_some(line));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `x + y` on 4 by 4 nodes of a box: the level 2.5 runs straight across, and half is above.
    #[test]
    fn contours_of_a_plane_are_straight() {
        let values = (0..16).map(|k| f64::from(k % 4 + k / 4)).collect();
        let field = Field { nodes: [4, 4], values };
        assert_eq!(field.highest(), 6);
        let [line] = &field.contour(2.5)[..] else { panic!("one line") };
        for [x, y] in line {
            let i = 3.0 * (x - LEFT) / WIDTH;
            let j = 3.0 * (1.0 - (y - TOP) / HEIGHT);
            assert!((i + j - 2.5).abs() < 1e-9);
        }
        assert!(field.contour(6.5).is_empty() && field.above(6.5).is_empty());
    }

    /// A hill has closed contours that end where they begin.
    #[test]
    fn contours_of_a_hill_are_closed() {
        let height = |k: usize| {
            let [x, y] = [k % 9, k / 9].map(|i| i as f64 - 4.0);
            20.0 - x * x - y * y
        };
        let field = Field { nodes: [9, 9], values: (0..81).map(height).collect() };
        let lines = field.contour(14.5);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        assert!(lines[0].len() > 12);
    }
}
