//! Sheets of panels: lines, dots, faces and labels in coordinates of their own.

use std::fmt::Write;

use crate::svg::escape;

pub(crate) const RED: &str = "#cc3311";
pub(crate) const BLACK: &str = "#000000";
pub(crate) const GREEN: &str = "#228833";
pub(crate) const BLUE: &str = "#4477aa";
pub(crate) const GREY: &str = "#bbbbbb";

const MARGIN: f64 = 14.0;
const LINE: f64 = 16.0;
const HEAD: f64 = 30.0;

/// A place in a panel, `y` upwards.
pub(crate) type Place = [f64; 2];

/// Something to be drawn.
#[derive(Clone)]
pub(crate) enum Shape {
    /// A polygon without its inside.
    Line { points: Vec<Place>, closed: bool, color: &'static str, width: f64, dashed: bool },
    /// Bullets, with a radius in units of the picture.
    Dots { points: Vec<Place>, color: &'static str, radius: f64 },
    /// A filled polygon.
    Face { corners: Vec<Place>, fill: String },
    /// A line with a head at its end.
    Arrow { from: Place, to: Place, color: &'static str, dashed: bool },
    /// Text beside a place: moved by `offset` units of the picture, turned by `angle` degrees.
    Label { at: Place, offset: Place, angle: f64, anchor: &'static str, text: String },
}

impl Shape {
    /// A thin solid line.
    pub fn line(points: Vec<Place>, closed: bool, color: &'static str) -> Self {
        Shape::Line { points, closed, color, width: 1.3, dashed: false }
    }

    fn places(&self) -> Vec<Place> {
        match self {
            Shape::Line { points, .. } | Shape::Dots { points, .. } => points.clone(),
            Shape::Face { corners, .. } => corners.clone(),
            Shape::Arrow { from, to, .. } => vec![*from, *to],
            Shape::Label { at, .. } => vec![*at],
        }
    }

    fn draw(&self, svg: &mut String, frame: &Frame) {
        let list = |points: &[Place]| {
            let at = points.iter().map(|p| frame.at(*p));
            at.map(|[x, y]| format!("{x:.2},{y:.2}")).collect::<Vec<_>>().join(" ")
        };
        let dashes = |dashed: bool| if dashed { " stroke-dasharray=\"4 3\"" } else { "" };
        let _ = match self {
            Shape::Line { points, closed, color, width, dashed } => writeln!(
                svg,
                "<{} points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" \
                 stroke-linejoin=\"round\"{}/>",
                if *closed { "polygon" } else { "polyline" },
                list(points),
                dashes(*dashed)
            ),
            Shape::Dots { points, color, radius } => points.iter().try_for_each(|p| {
                let [x, y] = frame.at(*p);
                writeln!(
                    svg,
                    "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{color}\"/>"
                )
            }),
            Shape::Face { corners, fill } => {
                let at = corners.iter().map(|p| frame.at(*p));
                let at: Vec<String> = at.map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
                writeln!(svg, "<path fill=\"{fill}\" stroke=\"{fill}\" d=\"M{}z\"/>", at.join("L"))
            }
            Shape::Arrow { from, to, color, dashed } => {
                let ([a, b], [x, y]) = (frame.at(*from), frame.at(*to));
                let head = arrow_head([a, b], [x, y]);
                writeln!(
                    svg,
                    "<path d=\"M{a:.2} {b:.2}L{x:.2} {y:.2}\" stroke=\"{color}\"{}/>\
                     <polygon points=\"{head}\" fill=\"{color}\"/>",
                    dashes(*dashed)
                )
            }
            Shape::Label { at, offset, angle, anchor, text } => {
                let [x, y] = frame.at(*at);
                let (x, y) = (x + offset[0], y + offset[1]);
                let turn = match angle {
                    0.0 => String::new(),
                    _ => format!(" transform=\"rotate({angle} {x:.2} {y:.2})\""),
                };
                let text = escape(text);
                writeln!(
                    svg,
                    "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\"{turn}>{text}</text>"
                )
            }
        };
    }
}

/// The three corners of a head that ends at `to`.
fn arrow_head(from: Place, to: Place) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = (dx * dx + dy * dy).sqrt().max(1e-9);
    let [ux, uy] = [dx / length * 7.0, dy / length * 7.0];
    let corners = [
        to,
        [to[0] - ux - uy * 0.4, to[1] - uy + ux * 0.4],
        [to[0] - ux + uy * 0.4, to[1] - uy - ux * 0.4],
    ];
    corners.map(|[x, y]| format!("{x:.2},{y:.2}")).join(" ")
}

/// A picture with its own coordinates and a caption below.
pub(crate) struct Panel {
    /// Lines below the picture.
    pub caption: Vec<String>,
    /// What is drawn, the first at the bottom.
    pub shapes: Vec<Shape>,
    /// Whether both directions are stretched to the panel, as for graphs of functions.
    pub stretched: bool,
}

/// From the coordinates of a panel to those of the sheet.
struct Frame {
    low: Place,
    scale: Place,
    origin: Place,
}

impl Frame {
    /// Puts all places of the shapes into a box, in its middle.
    fn new(panel: &Panel, [left, top]: Place, size: Place) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for place in panel.shapes.iter().flat_map(Shape::places) {
            for k in [0, 1] {
                low[k] = low[k].min(place[k]);
                high[k] = high[k].max(place[k]);
            }
        }
        let room = [0, 1].map(|k| size[k] - 2.0 * MARGIN);
        // Whatever is flat, or nothing at all, is drawn in the middle.
        let span = [0, 1].map(|k| if high[k] > low[k] { high[k] - low[k] } else { 0.0 });
        let mut scale =
            [0, 1].map(|k| if span[k] > 0.0 { room[k] / span[k] } else { f64::INFINITY });
        if !panel.stretched {
            scale = [scale[0].min(scale[1]); 2];
        }
        scale = scale.map(|s| if s.is_finite() { s } else { 1.0 });
        if !low.iter().chain(&high).all(|x| x.is_finite()) {
            low = [0.0; 2];
        }
        let free = [0, 1].map(|k| (room[k] - span[k] * scale[k]) / 2.0);
        let origin = [left + MARGIN + free[0], top + size[1] - MARGIN - free[1]];
        Frame { low, scale, origin }
    }

    fn at(&self, [x, y]: Place) -> Place {
        [
            self.origin[0] + (x - self.low[0]) * self.scale[0],
            self.origin[1] - (y - self.low[1]) * self.scale[1],
        ]
    }
}

/// Panels of one size, row by row, below a title.
pub(crate) fn sheet(title: &str, panels: &[Panel], columns: usize, size: Place) -> String {
    let lines = panels.iter().map(|panel| panel.caption.len()).max().unwrap_or(0);
    let cell = [size[0], size[1] + LINE * lines as f64 + 6.0];
    let rows = panels.len().div_ceil(columns);
    let width = cell[0] * columns.min(panels.len()) as f64;
    let height = HEAD + cell[1] * rows as f64;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<title>{title}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <text x=\"{MARGIN}\" y=\"20\" font-size=\"14\">{title}</text>\n",
        title = escape(title)
    );
    for (k, panel) in panels.iter().enumerate() {
        let corner = [cell[0] * (k % columns) as f64, HEAD + cell[1] * (k / columns) as f64];
        let frame = Frame::new(panel, corner, size);
        // A hair's breadth of its own colour closes the seam from a face to the next.
        svg.push_str("<g stroke-width=\"0.4\">\n");
        let (faces, others): (Vec<_>, Vec<_>) =
            panel.shapes.iter().partition(|shape| matches!(shape, Shape::Face { .. }));
        faces.iter().for_each(|shape| shape.draw(&mut svg, &frame));
        svg.push_str("</g>\n");
        others.iter().for_each(|shape| shape.draw(&mut svg, &frame));
        for (line, text) in panel.caption.iter().enumerate() {
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                corner[0] + size[0] / 2.0,
                corner[1] + size[1] + LINE * (line as f64 + 0.7),
                escape(text)
            );
        }
    }
    svg.push_str("</svg>\n");
    svg
}
