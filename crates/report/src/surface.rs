//! `surface`: a refined net, as points, as a mesh and as a picture.

use refinable_refine::{ACROSS, ALONG, BasicLimit, Coordinate, Ends, Net, Weights, refine_net};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::json;

use crate::canvas::{Panel, Shape, sheet};
use crate::curve::expect_smooth;
use crate::grid::{Cell, Document, Grid};
use crate::points::{expect_finite, names, net_csv, net_json};
use crate::surface_picture::{View, faces, wires};

/// The most faces that are drawn.
const MOST_FACES: usize = 100_000;

/// A tensor product surface.
#[derive(Clone, Debug)]
pub struct TensorSurface<T> {
    schemes: [String; 2],
    levels: u32,
    control: Net<T>,
    points: Net<T>,
    is_limit: bool,
}

impl<T: Coordinate> TensorSurface<T> {
    /// Refines a net with a scheme for each direction; with `limit` the points are then moved onto the
    /// limit surface, by the product of the limit stencils.
    ///
    /// # Errors
    /// Those of [`refine_net`] and, for limits, `smoothness` if a scheme is not proved to converge, and
    /// those of [`BasicLimit`].
    pub fn new(
        schemes: [&Scheme; 2],
        control: Net<T>,
        levels: u32,
        ends: [Ends; 2],
        limit: bool,
    ) -> Result<Self, Diagnostic> {
        let rules = [Weights::new(schemes[0].mask())?, Weights::new(schemes[1].mask())?];
        let mut chains = [rules[ACROSS].repeated(levels)?, rules[ALONG].repeated(levels)?];
        let last = if limit { Some(limit_rules(schemes)?) } else { None };
        for (chain, rule) in chains.iter_mut().zip(last.iter().flatten()) {
            chain.push(rule);
        }
        let points = refine_net(&control, [&chains[ACROSS], &chains[ALONG]], ends)?;
        expect_finite(points.values())?;
        Ok(TensorSurface {
            schemes: schemes.map(|s| s.name().to_string()),
            levels,
            control,
            points,
            is_limit: limit,
        })
    }

    /// A surface whose points are made in another way, by a scheme or schemes of this name.
    pub fn of_points(name: &str, control: Net<T>, points: Net<T>, levels: u32) -> Self {
        TensorSurface {
            schemes: [name.into(), name.into()],
            levels,
            control,
            points,
            is_limit: false,
        }
    }

    /// The points.
    pub fn points(&self) -> &Net<T> {
        &self.points
    }

    /// The points as comma-separated values, a blank line between rows.
    pub fn csv(&self) -> String {
        net_csv(&self.points)
    }

    fn title(&self) -> String {
        let [across, along] = &self.schemes;
        let product =
            if across == along { across.clone() } else { format!("{across} ⊗ {along}") };
        format!("{product}, {} levels", self.levels)
    }

    /// The points as a table, rows numbered from 0, and as JSON.
    pub fn document(&self) -> Document {
        let row = |(i, j): (usize, usize)| {
            let numbers = [i, j].map(|k| Cell::text(k.to_string()));
            let point = self.points.point(i, j).iter().map(|x| Cell::text(x.text()));
            numbers.into_iter().chain(point).collect()
        };
        let (rows, columns) = (self.points.rows(), self.points.columns());
        let what = if self.is_limit { "points on the limit surface" } else { "points" };
        let names = names(self.points.dimension());
        let grid = Grid {
            id: "surface".into(),
            caption: format!("{rows} × {columns} {what} of {}", self.title()),
            header: ["i", "j"].into_iter().chain(names.split(',')).map(String::from).collect(),
            rows: (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(row).collect(),
            remarks: Vec::new(),
        };
        let json = json!({
            "scheme": self.schemes[ALONG],
            "across": self.schemes[ACROSS],
            "levels": self.levels,
            "limit": self.is_limit,
            "closed": self.points.closed(),
            "dimension": self.points.dimension(),
            "points": net_json(&self.points),
        });
        Document { grids: vec![grid], summary: None, json }
    }
}

/// The rules that move points onto the limit, one for each direction.
fn limit_rules<T: Coordinate>(schemes: [&Scheme; 2]) -> Result<[Weights<T>; 2], Diagnostic> {
    let rule = |scheme: &Scheme| {
        expect_smooth(scheme, 0, "limit points")?;
        BasicLimit::new(scheme.mask())?.rule(0)
    };
    let across = rule(schemes[ACROSS])?;
    // Convergence takes longer to prove than anything else here.
    let is_same = schemes[ALONG].mask() == schemes[ACROSS].mask();
    let along = if is_same { across.clone() } else { rule(schemes[ALONG])? };
    Ok([across, along])
}

impl TensorSurface<f64> {
    /// The surface, shaded, with its control net, red.
    ///
    /// # Errors
    /// Code `dimension` unless the points have three coordinates, `levels` for too many faces.
    pub fn picture(&self) -> Result<String, Diagnostic> {
        if self.points.dimension() != 3 {
            let message = format!("the points have {} coordinates", self.points.dimension());
            let hint = "a surface is drawn in space, with three";
            return Err(Diagnostic::new("dimension", message).with_hint(hint));
        }
        let count = self.points.rows() * self.points.columns();
        if count > MOST_FACES {
            let message = format!("{count} faces are too many for a picture");
            let hint = format!("{MOST_FACES} are the most: ask for fewer levels, or for a mesh");
            return Err(Diagnostic::new("levels", message).with_hint(hint));
        }
        let shapes = self.shapes(&View::OBLIQUE, true);
        let panel = Panel { caption: Vec::new(), shapes, stretched: false };
        Ok(sheet(&self.title(), &[panel], 1, [560.0, 460.0]))
    }

    /// The faces, and the control net if it is wanted.
    pub(crate) fn shapes(&self, view: &View, with_control: bool) -> Vec<Shape> {
        let mut shapes = faces(&self.points, view);
        if with_control {
            shapes.extend(wires(&self.control, view));
        }
        shapes
    }
}

#[cfg(test)]
mod tests {
    use refinable_algebra::{Rational, Ring, rational};

    use super::*;

    /// The control net of `N_3(x) N_3(y)`: its limit values at integers are the products of 1/6, 2/3, 1/6.
    #[test]
    fn limits_of_a_bicubic_spline() {
        let values = (0..25).map(|k| Rational::from_i64(i64::from(k == 12))).collect();
        let net = Net::new(1, 5, values, [true; 2]).unwrap();
        let cubic = Scheme::resolve("bspline3", 2).unwrap();
        let ends = [Ends::Trim; 2];
        let surface = TensorSurface::new([&cubic, &cubic], net, 0, ends, true).unwrap();
        let expected = [[1, 4, 1], [4, 16, 4], [1, 4, 1]];
        for (i, row) in expected.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                assert_eq!(surface.points().point(i + 1, j + 1), [rational(*value, 36)]);
            }
        }
    }
}
