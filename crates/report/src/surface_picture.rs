//! Surfaces as shaded pictures.

use refinable_refine::{ACROSS, ALONG, Net};

use crate::canvas::{Place, RED, Shape};
use crate::mesh::{cross, difference, dot, in_space, quadrilaterals};

/// A direction of view: unit vectors to the right, upwards and towards the eye.
pub(crate) struct View {
    right: [f64; 3],
    up: [f64; 3],
    eye: [f64; 3],
}

/// `sin 60°`, half of `√3`.
const S: f64 = 0.866_025_403_784_438_6;

impl View {
    /// From the front, right and above: 60° round, 30° up.
    pub const OBLIQUE: View =
        View { right: [S, 0.5, 0.0], up: [-0.25, S / 2.0, S], eye: [S / 2.0, -0.75, 0.5] };
    /// The same, seen in a mirror.
    pub const MIRRORED: View = View { right: [-S, -0.5, 0.0], ..View::OBLIQUE };
    /// From above: the picture is the projection to the `xy`-plane.
    pub const ABOVE: View =
        View { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], eye: [0.0, 0.0, 1.0] };

    pub fn project(&self, point: [f64; 3]) -> Place {
        [dot(self.right, point), dot(self.up, point)]
    }
}

/// The faces of a surface from behind to the front, each with a shade by its slope.
pub(crate) fn faces(net: &Net<f64>, view: &View) -> Vec<Shape> {
    let mut faces: Vec<(f64, Shape)> = Vec::new();
    for corners in quadrilaterals(net) {
        let corners = corners.map(|k| in_space(net.point(k / net.columns(), k % net.columns())));
        let [a, b, c, d] = corners;
        let depth = corners.iter().map(|p| dot(view.eye, *p)).sum::<f64>();
        let normal = cross(difference(c, a), difference(d, b));
        let fill = shade(normal, view);
        faces.push((
            depth,
            Shape::Face { corners: corners.map(|p| view.project(p)).to_vec(), fill },
        ));
    }
    faces.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    faces.into_iter().map(|(_, shape)| shape).collect()
}

/// The lines of a control net.
pub(crate) fn wires(net: &Net<f64>, view: &View) -> Vec<Shape> {
    let closed = net.closed();
    let at = |i: usize, j: usize| view.project(in_space(net.point(i, j)));
    let rows = (0..net.rows()).map(|i| (0..net.columns()).map(|j| at(i, j)).collect());
    let columns = (0..net.columns()).map(|j| (0..net.rows()).map(|i| at(i, j)).collect());
    let rows = rows.map(|points: Vec<Place>| (points, closed[ALONG]));
    let columns = columns.map(|points: Vec<Place>| (points, closed[ACROSS]));
    let wire =
        |(points, closed)| Shape::Line { points, closed, color: RED, width: 0.8, dashed: false };
    let points = (0..net.rows()).flat_map(|i| (0..net.columns()).map(move |j| (i, j)));
    let dots =
        Shape::Dots { points: points.map(|(i, j)| at(i, j)).collect(), color: RED, radius: 2.0 };
    rows.chain(columns).map(wire).chain([dots]).collect()
}

/// Light comes from the upper left behind the eye; both sides are lit, the back in another hue.
fn shade(normal: [f64; 3], view: &View) -> String {
    let light: [f64; 3] =
        [0, 1, 2].map(|k| 0.7 * view.eye[k] - 0.45 * view.right[k] + 0.55 * view.up[k]);
    let lengths = (dot(normal, normal) * dot(light, light)).sqrt();
    let cosine = if lengths > 0.0 { dot(normal, light) / lengths } else { 0.0 };
    let bright = 0.35 + 0.65 * cosine.max(-cosine);
    let hue =
        if dot(normal, view.eye) >= 0.0 { [120.0, 170.0, 220.0] } else { [225.0, 185.0, 120.0] };
    let [r, g, b] = hue.map(|x: f64| (x * bright + 30.0 * bright * bright).min(255.0) as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
