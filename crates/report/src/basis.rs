//! `basis`: the basic limit function and its derivatives, exactly.

use refinable_algebra::{Rational, Ring, decimal};
use refinable_analysis::{Options, regularity};
use refinable_refine::{BasicLimit, Coordinate, Ends, Polygon, Weights, refine};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::{Value, json};

use crate::canvas::{BLACK, BLUE, GREEN, GREY, Panel, Place, RED, Shape, sheet};
use crate::grid::{Cell, Document, Grid};
use crate::number;

/// Derivatives that are shown if nothing else is asked for.
const USUAL_ORDER: usize = 2;
/// The farthest index of a mask.
const FARTHEST: i64 = 1_000;
/// The finest grid.
const MOST_LEVELS: u32 = 12;

/// The values of the basic limit function of a scheme on a grid.
#[derive(Clone, Debug)]
pub struct Basis {
    scheme: Scheme,
    support: [Rational; 2],
    continuity: usize,
    levels: u32,
    /// The grid `j/m^L` over the support.
    places: Vec<Rational>,
    /// `values[n][i]`: the derivative of order `n` at `places[i]`.
    values: Vec<Vec<Rational>>,
}

impl Basis {
    /// The function and its derivatives up to an order, at all multiples of `m^-levels` in its support;
    /// up to the second, as far as they are proved to be continuous, if no order is given.
    ///
    /// # Errors
    /// Code `smoothness` if so many derivatives are not proved to be continuous, `levels` for too fine a
    /// grid, those of [`regularity`] and of [`BasicLimit`].
    pub fn new(scheme: &Scheme, levels: u32, order: Option<usize>) -> Result<Self, Diagnostic> {
        if levels > MOST_LEVELS {
            let hint = format!("{MOST_LEVELS} levels are the most");
            return Err(Diagnostic::new("levels", "the grid is too fine").with_hint(hint));
        }
        // Parameters that are free are told before any search.
        let limit = BasicLimit::new(scheme.mask())?;
        let found = regularity(scheme.name(), scheme.mask(), &Options::default())?.continuity;
        let Some(continuity) = found else {
            let message = format!("{} is not proved to converge", scheme.name());
            let hint = "without a limit there is no basic limit function";
            return Err(Diagnostic::new("smoothness", message).with_hint(hint));
        };
        let order = order.unwrap_or(continuity.min(USUAL_ORDER));
        if order > continuity {
            let message = format!("{} is not proved to be C^{order}", scheme.name());
            let hint = format!("it is C^{continuity}: ask for derivatives up to that order");
            return Err(Diagnostic::new("smoothness", message).with_hint(hint));
        }
        let (low, high) = scheme.mask().support();
        if low.abs().max(high.abs()) > FARTHEST {
            let message = "the mask is too far from the index 0, or too long";
            let hint = format!("indices up to {FARTHEST} do: `shift(SCHEME, k)` moves a mask");
            return Err(Diagnostic::new("budget", message).with_hint(hint));
        }
        let (places, values) = table(scheme, &limit, levels, order)?;
        let support = limit.support();
        Ok(Basis { scheme: scheme.clone(), support, continuity, levels, places, values })
    }

    /// A table, and JSON.
    pub fn document(&self) -> Document {
        let header = (0..self.values.len()).map(|n| format!("phi{}", "'".repeat(n)));
        let row = |(i, x): (usize, &Rational)| {
            let values = self.values.iter().map(|values| &values[i]);
            [x].into_iter().chain(values).map(|x| Cell::text(x.to_string())).collect()
        };
        let [low, high] = &self.support;
        let grid = Grid {
            id: "basis".into(),
            caption: format!("Basic limit function of {}", self.scheme.name()),
            header: ["x".to_string()].into_iter().chain(header).collect(),
            rows: self.places.iter().enumerate().map(row).collect(),
            remarks: vec![
                format!("support [{low}, {high}], C^{}", self.continuity),
                "exact values; derivatives by x, control points at the integers".into(),
            ],
        };
        let values = self.places.iter().enumerate().map(|(i, x)| {
            let values: Vec<Value> =
                self.values.iter().map(|v| number::rational_number(&v[i])).collect();
            json!({"x": number::rational_number(x), "values": values})
        });
        let json = json!({
            "scheme": self.scheme.name(),
            "arity": self.scheme.mask().arity(),
            "support": [number::rational_number(low), number::rational_number(high)],
            "continuity": self.continuity,
            "levels": self.levels,
            "derivatives": self.values.len() - 1,
            "values": values.collect::<Value>(),
        });
        Document { grids: vec![grid], summary: None, json }
    }

    /// A panel for the function with the first steps of the cascade towards it, and one for each
    /// derivative.
    ///
    /// # Errors
    /// Those of [`refine`].
    pub fn picture(&self) -> Result<String, Diagnostic> {
        let panels = (0..self.values.len()).map(|order| {
            let mut shapes = self.axis();
            if order == 0 {
                shapes.extend(self.cascade()?);
            }
            let points = self.places.iter().zip(&self.values[order]);
            let points = points.map(|(x, y)| [float(x), float(y)]).collect();
            shapes.push(Shape::Line {
                points,
                closed: false,
                color: BLACK,
                width: 1.8,
                dashed: false,
            });
            let values = || self.values[order].iter();
            let ends = [values().max(), values().min()].into_iter().flatten();
            shapes.extend(ends.filter(|y| !y.is_zero()).map(|y| Shape::Label {
                at: [float(&self.support[0]), float(y)],
                offset: [0.0, 4.0],
                angle: 0.0,
                anchor: "start",
                text: decimal(y, 4),
            }));
            let caption = match order {
                0 => "φ, and the polygons of levels 0 to 3".to_string(),
                _ => format!("φ{}", "′".repeat(order)),
            };
            Ok(Panel { caption: vec![caption], shapes, stretched: true })
        });
        let panels: Vec<Panel> = panels.collect::<Result<_, Diagnostic>>()?;
        let [low, high] = &self.support;
        let title =
            format!("Basic limit function of {}, support [{low}, {high}]", self.scheme.name());
        Ok(sheet(&title, &panels, 2, [420.0, 280.0]))
    }

    /// The line `y = 0` with the integers of the support, and its ends.
    fn axis(&self) -> Vec<Shape> {
        let [low, high] = self.support.each_ref().map(float);
        let mut shapes = vec![Shape::line(vec![[low, 0.0], [high, 0.0]], false, GREY)];
        let mut tick = self.support[0].ceil();
        while tick <= self.support[1] {
            shapes.push(Shape::Label {
                at: [float(&tick), 0.0],
                offset: [0.0, 12.0],
                angle: 0.0,
                anchor: "middle",
                text: decimal(&tick, 6),
            });
            tick += Rational::one();
        }
        shapes.push(Shape::Dots {
            points: vec![[low, 0.0], [high, 0.0]],
            color: BLACK,
            radius: 2.0,
        });
        shapes
    }

    /// The polygons of the first levels of the data `1` at 0, above the places at which they stand.
    fn cascade(&self) -> Result<Vec<Shape>, Diagnostic> {
        let rule = Weights::<f64>::new(self.scheme.mask())?;
        let (data, reach) = unit(self.scheme.mask().support(), f64::from_rational);
        // The control point of number i stands at i + place.
        let place = float(&BasicLimit::new(self.scheme.mask())?.place());
        let numbers = (-reach..=reach).map(|i| i as f64 + place).collect();
        let numbers = Polygon::new(1, numbers, false)?;
        let mut shapes = Vec::new();
        for (level, color) in [RED, GREEN, BLUE, GREY].into_iter().enumerate() {
            let rules = vec![&rule; level];
            let values = refine(&data, &rules, Ends::Trim)?;
            // Abscissae refined by the scheme are those at which values stand, if it reproduces lines.
            let abscissae = refine(&numbers, &rules, Ends::Trim)?;
            let points = abscissae.values().iter().zip(values.values());
            let points: Vec<Place> = points.map(|(x, y)| [*x, *y]).collect();
            let inside = points.into_iter().filter(|[x, _]| self.is_inside(*x)).collect();
            shapes.push(Shape::line(inside, false, color));
        }
        Ok(shapes)
    }

    fn is_inside(&self, x: f64) -> bool {
        let [low, high] = self.support.each_ref().map(float);
        low - 1.0 <= x && x <= high + 1.0
    }
}

/// The places `j/m^L` of the support and the derivatives there: the data 1 at 0, refined, and the limit
/// stencils at the integers.
type Table = (Vec<Rational>, Vec<Vec<Rational>>);

fn table(
    scheme: &Scheme,
    limit: &BasicLimit,
    levels: u32,
    order: usize,
) -> Result<Table, Diagnostic> {
    let rule = Weights::<Rational>::new(scheme.mask())?;
    let (data, reach) = unit(scheme.mask().support(), Rational::clone);
    let rules = vec![&rule; levels as usize];
    let finer = refine(&data, &rules, Ends::Trim)?;
    // Where the refined points begin: as many steps of the arithmetic of ranges.
    let first = rules.iter().fold(-reach..reach + 1, |old, rule| rule.produced(&old)).start;
    let scale = Rational::from_i64(scheme.mask().arity() as i64).power(levels);
    let [low, high] = limit.support().map(|x| x * &scale);
    let indices = || low.ceil().to_integer()..=high.floor().to_integer();
    let (start, end) = indices().into_inner();
    let [start, end] = [start, end].map(|i| i64::try_from(i).unwrap_or(0));
    let mut values = Vec::new();
    for n in 0..=order {
        let stencil = limit.stencil(&Rational::zero(), n as u32)?;
        let factor = scale.power(n as u32);
        let value = |j: i64| {
            let terms = (j + stencil.first()..).zip(stencil.weights());
            let point =
                |i: i64| usize::try_from(i - first).ok().and_then(|i| finer.values().get(i));
            let terms = terms.filter_map(|(i, w)| Some(point(i)? * w));
            terms.sum::<Rational>() * &factor
        };
        values.push((start..=end).map(value).collect());
    }
    let places = (start..=end).map(|j| Rational::from_i64(j) / &scale).collect();
    Ok((places, values))
}

/// The data `1` at 0 among zeros, from `-reach` to `reach`, so many that trimming does not matter.
fn unit<T: Coordinate>(
    (lowest, highest): (i64, i64),
    convert: impl Fn(&Rational) -> T,
) -> (Polygon<T>, i64) {
    let reach = 3 * (lowest.abs().max(highest.abs()) + 2);
    let values =
        (-reach..=reach).map(|i| convert(&Rational::from_i64(i64::from(i == 0)))).collect();
    (Polygon::new(1, values, false).expect("some numbers"), reach)
}

fn float(x: &Rational) -> f64 {
    f64::from_rational(x)
}
