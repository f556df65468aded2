//! Tensor product surfaces.

use refinable_refine::{Ends, Net};
use refinable_scheme::Diagnostic;

use super::{Figure, member, models, settings, tensions};
use crate::canvas::{Panel, sheet};
use crate::surface::TensorSurface;
use crate::surface_picture::View;

const LEVELS: u32 = 3;

/// A scheme with its tensions.
type Column<'a> = (&'a str, &'a [&'a str]);

/// Three columns over the first model, and three over the second.
const FIGURES: [(&str, &str, [Column; 3], [Column; 3]); 3] = [
    (
        "surfaces-a3",
        "p5-3-point-b",
        [("a3", &["1/16", "-1/30"]), ("a3", &["1/8", "0"]), ("a3", &["1/4", "1/4"])],
        [("a3", &["0", "-1/12"]), ("a3", &["1/8", "0"]), ("a3", &["1/4", "1/4"])],
    ),
    (
        "surfaces-a5",
        "p5-5-point-b",
        [("a5", &["1/16", "-1/48"]), ("a5", &["1/10", "-49/1152"]), ("a5", &["1/8", "-13/224"])],
        [("a5", &["0", "-1/256"]), ("a5", &["1/16", "-1/48"]), ("a5", &["1/10", "-49/1152"])],
    ),
    (
        "surfaces-dd",
        "p5-DD-b",
        [("dd2", &[]), ("dd4", &[]), ("dd6", &[])],
        [("dd2", &[]), ("dd4", &[]), ("dd6", &[])],
    ),
];

pub(super) fn figures() -> Result<Vec<Figure>, Diagnostic> {
    FIGURES.iter().map(|(name, label, first, second)| figure(name, label, first, second)).collect()
}

/// Four rows: the first model, its mirror image from nearby, the second model, and this from above.
fn figure(
    name: &'static str,
    label: &'static str,
    first: &[Column<'_>; 3],
    second: &[Column<'_>; 3],
) -> Result<Figure, Diagnostic> {
    let (mut panels, mut commands) = (Vec::new(), Vec::new());
    let (hill, vase) = ("hill.csv", "vase.csv --closed rows");
    let rows = [
        (first, models::hill(), hill, View::OBLIQUE, true),
        (first, models::hill(), hill, View::MIRRORED, false),
        (second, models::vase(), vase, View::OBLIQUE, true),
        (second, models::vase(), vase, View::ABOVE, false),
    ];
    for (row, (columns, model, points, view, with_control)) in rows.into_iter().enumerate() {
        for (k, (scheme, values)) in columns.iter().enumerate() {
            let letter = char::from(b'a' + (3 * row + k) as u8);
            let values_text = match values {
                [] => format!("{}-point scheme", &scheme[2..]),
                _ => tensions(scheme, values),
            };
            if with_control {
                let settings = settings(scheme, values)?;
                commands.push(format!(
                    "refinable surface {scheme}{settings} {points} --ends reflect -l {LEVELS} -o {letter}.svg"
                ));
            }
            let caption = if with_control {
                format!("({letter}) {values_text}")
            } else {
                format!("({letter})")
            };
            let shapes = surface(scheme, values, &model)?.shapes(&view, with_control);
            panels.push(Panel { caption: vec![caption], shapes, stretched: false });
        }
    }
    let caption = "Surfaces over two initial nets (ours), refined three times, open ends reflected. (d)-(f): mirror \
                   images of (a)-(c) without the net; (j)-(l): projections of (g)-(i) to the xy-plane.";
    let svg = sheet("Tensor product surfaces", &panels, 3, [270.0, 230.0]);
    Ok(Figure { name, label, caption: caption.into(), commands, svg })
}

fn surface(
    scheme: &str,
    values: &[&str],
    model: &Net<f64>,
) -> Result<TensorSurface<f64>, Diagnostic> {
    let scheme = member(scheme, values)?;
    TensorSurface::new([&scheme, &scheme], model.clone(), LEVELS, [Ends::Reflect; 2], false)
}
