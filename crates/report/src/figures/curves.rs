//! Limit curves of the families, and of the Deslauriers-Dubuc schemes.

use refinable_refine::{Ends, Polygon};
use refinable_scheme::Diagnostic;

use super::{Figure, member, models, settings, tensions};
use crate::canvas::{BLACK, BLUE, GREEN, Panel, Shape, sheet};
use crate::curve::{Curve, CurveOptions, places};

const OPTIONS: CurveOptions = CurveOptions { levels: 5, ends: Ends::Trim, limit: false };

/// Tensions: a value for each parameter.
type Values<'a> = &'a [&'a str];

/// Three schemes and, for each of them, three members: from C^1 on, by the audited ranges.
type Trio<'a> = [(&'a str, [Values<'a>; 3]); 3];

const TRIOS: [(&str, &str, Trio); 3] = [
    (
        "limit-2-3-4",
        "p5-3-point",
        [
            ("a2", [&["1/32"], &["1/8"], &["3/16"]]),
            ("a3", [&["1/16", "-1/30"], &["1/8", "0"], &["1/4", "1/4"]]),
            ("i4", [&["-1/32"], &["-1/16"], &["-1/8"]]),
        ],
    ),
    (
        "limit-4-5-6",
        "p5-5-point",
        [
            ("a4", [&["1/128"], &["1/32"], &["1/16"]]),
            ("a5", [&["1/32", "-3/62"], &["1/16", "-1/48"], &["1/10", "-49/1152"]]),
            ("i6", [&["1/256"], &["3/256"], &["1/40"]]),
        ],
    ),
    (
        "limit-6-7-8",
        "p5-7-point",
        [
            ("a6", [&["1/200"], &["1/80"], &["1/50"]]),
            ("a7", [&["1/100", "-1/128"], &["1/128", "1/512"], &["1/80", "1/80"]]),
            ("i8", [&["-1/400"], &["-5/2048"], &["-3/400"]]),
        ],
    ),
];

/// The four members of a figure with two models each.
const QUARTETS: [(&str, &str, &str, [Values; 4]); 3] = [
    (
        "limit-a3",
        "p5-3-point-1",
        "a3",
        [&["1/2048", "-255/4096"], &["1/16", "-1/30"], &["1/8", "0"], &["1/4", "1/4"]],
    ),
    (
        "limit-a5",
        "p5-5-point-1",
        "a5",
        [&["1/32", "-3/62"], &["1/16", "-1/48"], &["1/10", "-49/1152"], &["1/8", "-11/128"]],
    ),
    (
        "limit-a7",
        "p5-7-point-1",
        "a7",
        [&["-1/2048", "1/512"], &["1/100", "-1/128"], &["1/128", "1/512"], &["1/80", "1/80"]],
    ),
];

pub(super) fn figures() -> Result<Vec<Figure>, Diagnostic> {
    let mut figures = Vec::new();
    for (name, label, trio) in TRIOS {
        figures.push(three_schemes(name, label, &trio)?);
    }
    for (name, label, scheme, members) in QUARTETS {
        let columns = members.map(|values| (scheme, values, tensions(scheme, values)));
        let caption = format!(
            "Limit curves of {scheme} at the tensions of the paper, for two initial polygons (ours)."
        );
        figures.push(two_models(name, label, &columns, caption)?);
    }
    let points = ["dd2", "dd4", "dd6", "dd8"];
    let columns = points.map(|name| (name, &[][..], format!("{}-point scheme", &name[2..])));
    let caption =
        "Limit curves of the primal schemes of Deslauriers and Dubuc, for the same polygons.";
    figures.push(two_models("limit-dd", "p5-DD-u", &columns, caption.into())?);
    Ok(figures)
}

/// A panel for each scheme, with three members over one polygon.
fn three_schemes(
    name: &'static str,
    label: &'static str,
    trio: &Trio<'_>,
) -> Result<Figure, Diagnostic> {
    let (mut panels, mut commands) = (Vec::new(), Vec::new());
    for (k, (scheme, members)) in trio.iter().enumerate() {
        let mut shapes = Vec::new();
        let mut caption = vec![format!("({}) {scheme}", ["a", "b", "c"][k])];
        let colors = [(BLACK, "black"), (BLUE, "blue"), (GREEN, "green")];
        for (values, (color, word)) in members.iter().zip(colors) {
            let curve = Curve::new(&member(scheme, values)?, models::letter(), OPTIONS)?;
            if shapes.is_empty() {
                // The control polygon with its points, without the curve.
                shapes = curve.shapes()?;
                shapes.truncate(2);
            }
            shapes.push(Shape::line(places(curve.points())?, true, color));
            caption.push(format!("{word}: {}", tensions(scheme, values)));
            commands.push(command(scheme, values, "letter", &format!("{scheme}-{word}"))?);
        }
        panels.push(Panel { caption, shapes, stretched: false });
    }
    let title =
        format!("Limit curves of {}", trio.each_ref().map(|(scheme, _)| *scheme).join(", "));
    let caption =
        "One initial polygon (ours), and for each scheme three members that are C^1 at least.";
    let svg = sheet(&title, &panels, 3, [260.0, 280.0]);
    Ok(Figure { name, label, caption: caption.into(), commands, svg })
}

/// Schemes in columns, two polygons in rows.
fn two_models(
    name: &'static str,
    label: &'static str,
    columns: &[(&str, Values, String)],
    caption: String,
) -> Result<Figure, Diagnostic> {
    let (mut panels, mut commands) = (Vec::new(), Vec::new());
    let models = [("letter", models::letter()), ("star", models::star())];
    for (row, (points, model)) in models.iter().enumerate() {
        for (k, (scheme, values, text)) in columns.iter().enumerate() {
            let letter = ["a", "b", "c", "d"][k];
            let caption = match row {
                0 => Vec::new(),
                _ => vec![format!("({letter}) {text}")],
            };
            commands.push(command(scheme, values, points, &format!("{letter}-{points}"))?);
            panels.push(Panel { caption, shapes: curve(scheme, values, model)?, stretched: false });
        }
    }
    let svg =
        sheet("Limit curves for two initial polygons", &panels, columns.len(), [230.0, 240.0]);
    Ok(Figure { name, label, caption, commands, svg })
}

/// The command that draws one of the curves.
fn command(
    scheme: &str,
    values: Values<'_>,
    points: &str,
    output: &str,
) -> Result<String, Diagnostic> {
    let (settings, levels) = (settings(scheme, values)?, OPTIONS.levels);
    Ok(format!(
        "refinable curve {scheme}{settings} {points}.csv --closed -l {levels} -o {output}.svg"
    ))
}

fn curve(scheme: &str, values: Values<'_>, model: &Polygon<f64>) -> Result<Vec<Shape>, Diagnostic> {
    Curve::new(&member(scheme, values)?, model.clone(), OPTIONS)?.shapes()
}
