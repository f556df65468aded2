//! `surface`: a refined net, as points, as a mesh and as a picture.

use refinable_refine::{ACROSS, ALONG, Coordinate, Ends, Net, Weights, refine_net};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::json;

use crate::canvas::{Panel, Shape, sheet};
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
}

impl<T: Coordinate> TensorSurface<T> {
    /// Refines a net with a scheme for each direction.
    ///
    /// # Errors
    /// Those of [`refine_net`].
    pub fn new(
        schemes: [&Scheme; 2],
        control: Net<T>,
        levels: u32,
        ends: [Ends; 2],
    ) -> Result<Self, Diagnostic> {
        let rules = [Weights::new(schemes[0].mask())?, Weights::new(schemes[1].mask())?];
        let chains = [rules[ACROSS].repeated(levels)?, rules[ALONG].repeated(levels)?];
        let points = refine_net(&control, [&chains[ACROSS], &chains[ALONG]], ends)?;
        expect_finite(points.values())?;
        Ok(TensorSurface {
            schemes: schemes.map(|s| s.name().to_string()),
            levels,
            control,
            points,
        })
    }

    /// A surface whose points are made in another way, by a scheme or schemes of this name.
    pub fn of_points(name: &str, control: Net<T>, points: Net<T>, levels: u32) -> Self {
        TensorSurface { schemes: [name.into(), name.into()], levels, control, points }
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
        let names = names(self.points.dimension());
        let grid = Grid {
            id: "surface".into(),
            caption: format!("{rows} × {columns} points of {}", self.title()),
            header: ["i", "j"].into_iter().chain(names.split(',')).map(String::from).collect(),
            rows: (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(row).collect(),
            remarks: Vec::new(),
        };
        let json = json!({
            "scheme": self.schemes[ALONG],
            "across": self.schemes[ACROSS],
            "levels": self.levels,
            "closed": self.points.closed(),
            "dimension": self.points.dimension(),
            "points": net_json(&self.points),
        });
        Document { grids: vec![grid], summary: None, json }
    }
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
