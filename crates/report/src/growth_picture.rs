//! Times against sizes, both as logarithms.

use std::f64::consts::LOG10_2;

use crate::canvas::{BLACK, BLUE, GREEN, GREY, Panel, Place, RED, Shape, sheet};
use crate::performance::{Point, Series};

const COLORS: [&str; 4] = [BLUE, GREEN, RED, BLACK];
const SIZE: Place = [720.0, 440.0];
/// Decades that are added below, for the numbers on the axes.
const ROOM: f64 = 0.12;
/// What part of an axis ends of lines are apart whose labels would cover each other, and the height of a label.
const CLOSE: f64 = 0.04;
const LINE: f64 = 16.0;

/// A line for each series, with its exponent, over a grid of round numbers.
pub(crate) fn growth_picture(title: &str, label: &str, series: &[&Series]) -> String {
    let lines: Vec<Vec<Place>> =
        series.iter().map(|s| s.points.iter().map(Point::place).collect()).collect();
    let all = || lines.iter().flatten();
    let least = |k: usize| all().map(|p| p[k]).fold(f64::INFINITY, f64::min);
    let most = |k: usize| all().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
    let low = [0, 1].map(|k| least(k) - ROOM * (most(k) - least(k)));
    let high = [most(0), most(1)];
    let mut shapes = Vec::new();
    for (at, text) in ticks(low[0], high[0]) {
        shapes.push(Shape::line(vec![[at, low[1]], [at, high[1]]], false, GREY));
        shapes.push(note([at, low[1]], [0.0, 12.0], "middle", text));
    }
    for (at, text) in ticks(low[1], high[1]) {
        shapes.push(Shape::line(vec![[low[0], at], [high[0], at]], false, GREY));
        shapes.push(note([low[0], at], [2.0, -3.0], "start", format!("{text} ms")));
    }
    let near =
        |a: &Place, b: &Place| (0..2).all(|k| (a[k] - b[k]).abs() < CLOSE * (high[k] - low[k]));
    let mut labelled: Vec<Place> = Vec::new();
    for ((series, points), color) in series.iter().zip(lines).zip(COLORS.into_iter().cycle()) {
        let text = format!("{}: exponent {:.1}", series.task, series.exponent());
        let last = *points.last().expect("at least three points");
        shapes.push(Shape::Dots { points: points.clone(), color, radius: 3.0 });
        shapes.push(Shape::line(points, false, color));
        // Where lines end together their labels stand below each other.
        let above = labelled.iter().filter(|other| near(other, &last)).count();
        shapes.push(note(last, [-10.0, -4.0 + LINE * above as f64], "end", text));
        labelled.push(last);
    }
    let caption = vec![format!("{label} across, milliseconds of processor time upwards")];
    sheet(title, &[Panel { caption, shapes, stretched: true }], 1, SIZE)
}

fn note(at: Place, offset: Place, anchor: &'static str, text: String) -> Shape {
    Shape::Label { at, offset, angle: 0.0, anchor, text }
}

/// Powers of ten between two logarithms, and twice and five times as much where there would be few.
fn ticks(low: f64, high: f64) -> Vec<(f64, String)> {
    /// `log10` of 1, 2 and 5.
    const STEPS: [(f64, i64); 3] = [(0.0, 1), (LOG10_2, 2), (1.0 - LOG10_2, 5)];
    let steps = if high - low > 2.5 { &STEPS[..1] } else { &STEPS[..] };
    let decades = low.floor() as i32..=high.ceil() as i32;
    let marks =
        decades.flat_map(|k| steps.iter().map(move |(step, n)| (f64::from(k) + step, *n, k)));
    let inside = marks.filter(|(at, ..)| (low..=high).contains(at));
    inside.map(|(at, n, k)| (at, round_number(n, k))).collect()
}

/// `n · 10^k` in full.
fn round_number(n: i64, k: i32) -> String {
    let zeros = "0".repeat(k.unsigned_abs() as usize);
    if k >= 0 { format!("{n}{zeros}") } else { format!("0.{}{n}", &zeros[1..]) }
}
