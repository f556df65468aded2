//! Schematic sketches of rules: which old points make a new one, with which weights.

use refinable_analysis::degrees;
use refinable_refine::Coordinate;
use refinable_scheme::{Scheme, Stencil};

use crate::canvas::{BLACK, GREY, Panel, Place, RED, Shape, sheet};

/// A panel for each stencil: the old points red, the new one black above the place where it stands.
pub fn rule_picture(scheme: &Scheme) -> String {
    let rule = scheme.mask().rule();
    let stencils = rule.stencils();
    let panels: Vec<Panel> =
        stencils.iter().enumerate().map(|(e, s)| panel(scheme, e, s)).collect();
    let title = format!("Rules of {}", scheme.name());
    sheet(&title, &panels, 1, [760.0, 260.0])
}

/// The stencil of `f'_{mi+ε}`.
fn panel(scheme: &Scheme, class: usize, stencil: &Stencil) -> Panel {
    let arity = scheme.mask().arity();
    let spread: Vec<(i64, String)> =
        stencil.terms().map(|(j, w)| (j, spelled(&w.to_string()))).collect();
    let (first, last) = (stencil.first().min(0), spread.last().map_or(0, |(j, _)| *j).max(1));
    let new = new_place(scheme, class);
    let base: Vec<Place> = (first..=last).map(|j| [j as f64, 0.0]).collect();
    let mut shapes = vec![Shape::line(base, false, RED)];
    // The room for weights and names.
    shapes.push(Shape::Dots {
        points: vec![[first as f64 - 0.6, -1.3], [last as f64 + 0.9, 1.2]],
        color: "none",
        radius: 0.0,
    });
    for (j, weight) in &spread {
        let at = [*j as f64, 0.0];
        shapes.push(Shape::Line {
            points: vec![at, new],
            closed: false,
            color: GREY,
            width: 1.0,
            dashed: true,
        });
        shapes.push(Shape::Dots { points: vec![at], color: RED, radius: 4.0 });
        shapes.push(Shape::Label {
            at,
            offset: [-2.0, 16.0],
            angle: 28.0,
            anchor: "start",
            text: weight.clone(),
        });
    }
    shapes.push(Shape::Dots { points: vec![new], color: BLACK, radius: 4.5 });
    shapes.push(Shape::Label {
        at: new,
        offset: [0.0, -9.0],
        angle: 0.0,
        anchor: "middle",
        text: new_name(arity, class),
    });
    let kind = match (arity, class, scheme.mask().is_primal()) {
        (2, 0, true) => "vertex rule: ",
        (2, 1, true) => "edge rule: ",
        _ => "",
    };
    let sum = format!("{kind}{} = Σ w_j f_{{i+j}}, j = {}", new_name(arity, class), range(&spread));
    Panel { caption: vec![sum], shapes, stretched: true }
}

/// Where the new point stands among the old ones: at `(ε - τ)/m`; where `τ` depends on parameters, as if it were 0.
fn new_place(scheme: &Scheme, class: usize) -> Place {
    let shift = degrees(scheme.mask()).tau.as_constant().unwrap_or_default();
    let arity = scheme.mask().arity() as f64;
    [(class as f64 - f64::from_rational(&shift)) / arity, 0.8]
}

fn new_name(arity: usize, class: usize) -> String {
    match class {
        0 => format!("f′_{arity}i"),
        _ => format!("f′_{arity}i+{class}"),
    }
}

fn range(spread: &[(i64, String)]) -> String {
    match (spread.first(), spread.last()) {
        (Some((first, _)), Some((last, _))) => format!("{first} … {last}"),
        _ => "none".into(),
    }
}

/// Greek letters for the names of parameters.
fn spelled(weight: &str) -> String {
    weight.replace("alpha", "α").replace("beta", "β").replace('*', "·")
}
