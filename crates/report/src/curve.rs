//! `curve`: a refined polygon, as points and as a picture.

use refinable_algebra::{Rational, Ring};
use refinable_analysis::{Options, degrees, regularity};
use refinable_refine::{BasicLimit, Coordinate, Ends, Polygon, Weights, refine, refine_to};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::json;

use crate::canvas::{BLACK, BLUE, Panel, Place, RED, Shape, sheet};
use crate::grid::{Cell, Document, Grid};
use crate::points::{expect_finite, names, polygon_csv, polygon_json};
use crate::surface_picture::View;

/// The points of a curve.
#[derive(Clone, Debug)]
pub struct Curve<T> {
    scheme: String,
    levels: u32,
    control: Polygon<T>,
    points: Polygon<T>,
    is_limit: bool,
    /// Where values that are not points stand: the numbers of the control values, refined like them.
    abscissae: Option<Polygon<T>>,
    /// Ends of the teeth of a curvature comb.
    comb: Option<Vec<Place>>,
    /// Numbers of control points that are drawn in another colour.
    marked: Vec<usize>,
}

/// How a curve is made.
#[derive(Clone, Copy, Debug)]
pub struct CurveOptions {
    /// How many times the polygon is refined.
    pub levels: u32,
    /// What happens at the ends of an open polygon.
    pub ends: Ends,
    /// Whether the points are moved onto the limit curve.
    pub limit: bool,
}

impl<T: Coordinate> Curve<T> {
    /// Refines a polygon.
    ///
    /// # Errors
    /// Those of [`refine`] and, for limits, `smoothness` if the scheme is not proved to converge, and
    /// those of [`BasicLimit`].
    pub fn new(
        scheme: &Scheme,
        control: Polygon<T>,
        options: CurveOptions,
    ) -> Result<Self, Diagnostic> {
        if options.limit {
            expect_smooth(scheme, 0, "limit points")?;
        }
        let abscissae = match (control.dimension(), control.is_closed()) {
            (1, false) => {
                let number = |i| T::from_rational(&Rational::from_i64(i));
                let numbers = (0..control.count() as i64).map(number).collect();
                Some(refined(scheme, &Polygon::new(1, numbers, false)?, options)?)
            }
            _ => None,
        };
        let points = refined(scheme, &control, options)?;
        expect_finite(points.values())?;
        Ok(Curve {
            scheme: scheme.name().to_string(),
            levels: options.levels,
            points,
            control,
            is_limit: options.limit,
            abscissae,
            comb: None,
            marked: Vec::new(),
        })
    }

    /// A curve whose points are made in another way, by a scheme of this name.
    /// The control points with the numbers of `marked` are drawn in another colour.
    pub fn of_points(
        name: &str,
        control: Polygon<T>,
        points: Polygon<T>,
        levels: u32,
        marked: Vec<usize>,
    ) -> Self {
        let scheme = name.to_string();
        Curve {
            scheme,
            levels,
            control,
            points,
            is_limit: false,
            abscissae: None,
            comb: None,
            marked,
        }
    }

    /// The points.
    pub fn points(&self) -> &Polygon<T> {
        &self.points
    }

    /// The points as comma-separated values.
    pub fn csv(&self) -> String {
        polygon_csv(&self.points)
    }

    /// The points as a table and as JSON.
    pub fn document(&self) -> Document {
        let row = |point: &[T]| point.iter().map(|x| Cell::text(x.text())).collect();
        let what = if self.is_limit { "points on the limit curve" } else { "points" };
        let grid = Grid {
            id: "curve".into(),
            caption: format!(
                "{} {what} at level {} of {}",
                self.points.count(),
                self.levels,
                self.scheme
            ),
            header: names(self.points.dimension()).split(',').map(String::from).collect(),
            rows: self.points.points().map(row).collect(),
            remarks: Vec::new(),
        };
        let json = json!({
            "scheme": self.scheme,
            "levels": self.levels,
            "limit": self.is_limit,
            "closed": self.points.is_closed(),
            "dimension": self.points.dimension(),
            "points": polygon_json(&self.points),
        });
        Document { grids: vec![grid], summary: None, json }
    }
}

/// Extrapolation by polynomials of higher degrees swings.
const HIGHEST_EXTRAPOLATION: usize = 3;

/// Ends that are extrapolated by polynomials as high as the scheme reproduces for all values of its parameters,
/// at most cubic.
pub fn extrapolation(scheme: &Scheme) -> Ends {
    let degree = degrees(scheme.mask()).generic().reproduction.0;
    Ends::Extrapolate { degree: degree.min(HIGHEST_EXTRAPOLATION) }
}

fn refined<T: Coordinate>(
    scheme: &Scheme,
    polygon: &Polygon<T>,
    options: CurveOptions,
) -> Result<Polygon<T>, Diagnostic> {
    let rule = Weights::new(scheme.mask())?;
    let rules = rule.repeated(options.levels)?;
    if !options.limit {
        return refine(polygon, &rules, options.ends);
    }
    let last = BasicLimit::new(scheme.mask())?.rule(0)?;
    Ok(refine_to(polygon, &rules, &[&last], options.ends)?.remove(0))
}

impl Curve<f64> {
    /// Adds a curvature comb: at each point of a planar curve, on the limit, a tooth along the normal as
    /// long as the curvature, the longest a fifth of the size of the control polygon.
    ///
    /// # Errors
    /// Code `smoothness` if the scheme is not proved to be C^2, `dimension` if the curve is not planar.
    pub fn with_comb(mut self, scheme: &Scheme, ends: Ends) -> Result<Self, Diagnostic> {
        if self.control.dimension() != 2 {
            let message = format!("the points have {} coordinates", self.control.dimension());
            let hint = "a curvature comb is drawn for planar curves, with two";
            return Err(Diagnostic::new("dimension", message).with_hint(hint));
        }
        expect_smooth(scheme, 2, "curvature")?;
        let limit = BasicLimit::new(scheme.mask())?;
        let last = [limit.rule(0)?, limit.rule(1)?, limit.rule(2)?];
        let rule = Weights::new(scheme.mask())?;
        let rules = rule.repeated(self.levels)?;
        let jets = refine_to(&self.control, &rules, &last.each_ref(), ends)?;
        // Derivatives by the parameter of the last level: curvature does not depend on it.
        let teeth = jets[1].points().zip(jets[2].points()).map(|(d, dd)| {
            let speed = d[0] * d[0] + d[1] * d[1];
            let scale = (d[0] * dd[1] - d[1] * dd[0]) / (speed * speed);
            // The normal that points away from the centre of curvature.
            if scale.is_finite() { [d[1] * scale, -d[0] * scale] } else { [0.0, 0.0] }
        });
        let teeth: Vec<Place> = teeth.collect();
        let longest = teeth.iter().map(|[x, y]| x * x + y * y).fold(0.0, f64::max).sqrt();
        let factor = if longest > 0.0 { size(&self.control) / 5.0 / longest } else { 0.0 };
        let tips = jets[0].points().zip(&teeth);
        self.comb = Some(tips.map(|(p, [x, y])| [p[0] + factor * x, p[1] + factor * y]).collect());
        self.points = jets[0].clone();
        self.is_limit = true;
        Ok(self)
    }

    /// The curve, black, with its control polygon, red.
    ///
    /// # Errors
    /// Code `dimension` beyond three coordinates.
    pub fn picture(&self) -> Result<String, Diagnostic> {
        let caption = format!("{}, {} levels", self.scheme, self.levels);
        let panel = Panel {
            caption: Vec::new(),
            shapes: self.shapes()?,
            stretched: self.control.dimension() == 1,
        };
        Ok(sheet(&caption, &[panel], 1, [520.0, 420.0]))
    }

    /// What is drawn.
    pub(crate) fn shapes(&self) -> Result<Vec<Shape>, Diagnostic> {
        let (control, curve) = match (self.control.dimension(), &self.abscissae) {
            (1, None) => {
                let message = "values of a closed polygon cannot be drawn";
                let hint = "give points of two or three coordinates";
                return Err(Diagnostic::new("dimension", message).with_hint(hint));
            }
            (_, Some(abscissae)) => {
                let numbers: Vec<f64> = (0..self.control.count()).map(|i| i as f64).collect();
                (graph(&numbers, &self.control), graph(abscissae.values(), &self.points))
            }
            (_, None) => (places(&self.control)?, places(&self.points)?),
        };
        let closed = self.control.is_closed();
        let marked: Vec<Place> = self.marked.iter().map(|&i| control[i]).collect();
        let mut shapes = vec![
            Shape::line(control.clone(), closed, RED),
            Shape::Dots { points: control, color: RED, radius: 3.0 },
        ];
        if let Some(tips) = &self.comb {
            let tooth = |(a, b): (&Place, &Place)| Shape::Line {
                points: vec![*a, *b],
                closed: false,
                color: BLUE,
                width: 0.6,
                dashed: false,
            };
            shapes.extend(curve.iter().zip(tips).map(tooth));
            shapes.push(Shape::line(tips.clone(), closed, BLUE));
        }
        shapes.push(Shape::line(curve, closed, BLACK));
        shapes.push(Shape::Dots { points: marked, color: BLUE, radius: 3.5 });
        Ok(shapes)
    }
}

/// The points above numbers.
fn graph(numbers: &[f64], values: &Polygon<f64>) -> Vec<Place> {
    numbers.iter().zip(values.values()).map(|(x, y)| [*x, *y]).collect()
}

/// The places at which points are drawn.
pub(crate) fn places(polygon: &Polygon<f64>) -> Result<Vec<Place>, Diagnostic> {
    let points = polygon.points();
    Ok(match polygon.dimension() {
        2 => points.map(|p| [p[0], p[1]]).collect(),
        3 => points.map(|p| View::OBLIQUE.project([p[0], p[1], p[2]])).collect(),
        n => {
            let message = format!("points of {n} coordinates cannot be drawn");
            return Err(Diagnostic::new("dimension", message).with_hint("two or three can"));
        }
    })
}

fn size(polygon: &Polygon<f64>) -> f64 {
    let extent = |k: usize| {
        let values = || polygon.points().map(move |p| p[k]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    extent(0).max(extent(1))
}

/// Whether a scheme is proved to be C^n.
///
/// # Errors
/// Code `smoothness`, and what is wanted of it; those of [`regularity`].
pub(crate) fn expect_smooth(scheme: &Scheme, order: usize, wanted: &str) -> Result<(), Diagnostic> {
    let found = regularity(scheme.name(), scheme.mask(), &Options::default())?.continuity;
    if found.is_some_and(|n| n >= order) {
        return Ok(());
    }
    let known = found.map_or("converge".into(), |_| format!("be C^{order}"));
    let message = format!("{} is not proved to {known}", scheme.name());
    Err(Diagnostic::new("smoothness", message)
        .with_hint(format!("for {wanted} a scheme must be C^{order}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cubic spline of a square: at its corner the derivatives are (1, -1) and (-2, -2), the curvature is √2,
    /// and all four teeth are as long, outward, a fifth of the side. On a line there are none.
    #[test]
    fn teeth_point_away_from_the_centre() {
        let scheme = Scheme::resolve("bspline3", 2).unwrap();
        let options = CurveOptions { levels: 0, ends: Ends::Reflect, limit: false };
        let comb = |values: &[f64], closed: bool| {
            let control = Polygon::new(2, values.to_vec(), closed).unwrap();
            let curve = Curve::new(&scheme, control, options).unwrap();
            let curve = curve.with_comb(&scheme, Ends::Reflect).unwrap();
            let tips = curve.comb.clone().unwrap();
            let points = curve.points.points().zip(tips);
            points.map(|(p, tip)| [tip[0] - p[0], tip[1] - p[1]]).collect::<Vec<Place>>()
        };
        let side = 0.4 / 2f64.sqrt();
        let teeth = comb(&[1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, 1.0], true);
        for (tooth, [x, y]) in
            teeth.iter().zip([[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]])
        {
            assert!((tooth[0] - x * side).abs() + (tooth[1] - y * side).abs() < 1e-12, "{tooth:?}");
        }
        assert!(
            comb(&[0.0, 0.0, 1.0, 2.0, 2.0, 4.0, 3.0, 6.0], false).iter().all(|t| *t == [0.0, 0.0])
        );
    }
}
