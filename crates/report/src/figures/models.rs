//! Control polygons and nets of our own.

use refinable_refine::{Net, Polygon};

/// A capital I, closed.
const LETTER: [[i32; 2]; 12] = [
    [0, 0],
    [6, 0],
    [6, 2],
    [4, 2],
    [4, 6],
    [6, 6],
    [6, 8],
    [0, 8],
    [0, 6],
    [2, 6],
    [2, 2],
    [0, 2],
];

/// A star of five points, closed.
const STAR: [[i32; 2]; 10] =
    [[0, 10], [-3, 3], [-10, 3], [-4, -1], [-6, -8], [0, -4], [6, -8], [4, -1], [10, 3], [3, 3]];

/// Heights of a hill with a notch, over a square of five by five points.
const HEIGHTS: [[i32; 5]; 5] =
    [[0, 1, 0, 1, 0], [1, 4, 6, 4, 1], [0, 6, 0, 6, 0], [1, 4, 6, 4, 1], [0, 1, 0, 1, 0]];

/// Half the widths of a vase at the heights `0, 3, 6, …`.
const WIDTHS: [i32; 5] = [3, 6, 2, 3, 5];

/// The first model of curves.
pub(crate) fn letter() -> Polygon<f64> {
    closed(&LETTER)
}

/// The second one.
pub(crate) fn star() -> Polygon<f64> {
    closed(&STAR)
}

fn closed(points: &[[i32; 2]]) -> Polygon<f64> {
    let values = points.iter().flatten().map(|x| f64::from(*x)).collect();
    Polygon::new(2, values, true).expect("a few points")
}

/// The first model of surfaces: open in both directions.
pub(crate) fn hill() -> Net<f64> {
    let point = |i: usize, j: usize| [3.0 * j as f64, 3.0 * i as f64, f64::from(HEIGHTS[i][j])];
    let values = (0..5).flat_map(|i| (0..5).flat_map(move |j| point(i, j))).collect();
    Net::new(3, 5, values, [false, false]).expect("a few points")
}

/// The second one: rows are closed, hexagons.
pub(crate) fn vase() -> Net<f64> {
    let around = [[2, 0], [1, 2], [-1, 2], [-2, 0], [-1, -2], [1, -2]];
    let values = WIDTHS.iter().enumerate().flat_map(|(i, width)| {
        around
            .iter()
            .flat_map(move |[x, y]| [f64::from(x * width), f64::from(y * width), 5.0 * i as f64])
    });
    Net::new(3, 6, values.collect(), [false, true]).expect("a few points")
}
