//! Points as text: a line for each, or JSON.

use refinable_refine::{Coordinate, Net, Polygon};
use refinable_scheme::Diagnostic;
use serde_json::{Value, json};

/// Whether all coordinates are numbers.
///
/// # Errors
/// Code `overflow` if floats were not large enough.
pub(crate) fn expect_finite<T: Coordinate>(values: &[T]) -> Result<(), Diagnostic> {
    if values.iter().all(Coordinate::is_finite) {
        return Ok(());
    }
    let message = "coordinates grow beyond all floats";
    Err(Diagnostic::new("overflow", message).with_hint("scale the points, or refine with --exact"))
}

/// The names of the columns of points: `x,y,z` as far as they go, else `x1,x2,…`.
pub(crate) fn names(dimension: usize) -> String {
    match dimension {
        1..=3 => ["x", "y", "z"][..dimension].join(","),
        _ => (1..=dimension).map(|k| format!("x{k}")).collect::<Vec<_>>().join(","),
    }
}

/// A header and a point on each line.
pub fn polygon_csv<T: Coordinate>(polygon: &Polygon<T>) -> String {
    let mut text = format!("{}\n", names(polygon.dimension()));
    polygon.points().for_each(|point| push_line(&mut text, point));
    text
}

/// A header and a point on each line, blank lines between rows.
pub fn net_csv<T: Coordinate>(net: &Net<T>) -> String {
    let mut text = format!("{}\n", names(net.dimension()));
    for i in 0..net.rows() {
        if i > 0 {
            text.push('\n');
        }
        (0..net.columns()).for_each(|j| push_line(&mut text, net.point(i, j)));
    }
    text
}

fn push_line<T: Coordinate>(text: &mut String, point: &[T]) {
    for (k, x) in point.iter().enumerate() {
        if k > 0 {
            text.push(',');
        }
        text.push_str(&x.text());
    }
    text.push('\n');
}

/// A list of points; floats as numbers, exact coordinates as text.
pub fn polygon_json<T: Coordinate>(polygon: &Polygon<T>) -> Value {
    polygon.points().map(point_json).collect()
}

/// A list of rows.
pub fn net_json<T: Coordinate>(net: &Net<T>) -> Value {
    let row = |i| (0..net.columns()).map(|j| point_json(net.point(i, j))).collect::<Value>();
    (0..net.rows()).map(row).collect()
}

fn point_json<T: Coordinate>(point: &[T]) -> Value {
    point.iter().map(|x| if T::EXACT { json!(x.text()) } else { number(&x.text()) }).collect()
}

/// A float by its shortest text, which reads back as the same float.
fn number(text: &str) -> Value {
    text.parse::<f64>().map_or(Value::Null, Value::from)
}
