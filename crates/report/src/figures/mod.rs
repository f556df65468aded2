//! The paper's figures, drawn anew.
//!
//! Where the paper prints the data of a figure they are used; for all others the control points are ours,
//! and the captions say so.

mod construction;
mod curves;
mod interproximate;
mod models;
mod surfaces;

use refinable_algebra::{Rational, parse_rational};
use refinable_scheme::{Diagnostic, Scheme};

use crate::points::{net_csv, polygon_csv};
use crate::rule_picture::rule_picture;
use crate::site::Site;

/// The folder of a report that holds the figures.
pub(crate) const FIGURES: &str = "figures";

/// What the page of figures says first.
pub(crate) const INTRODUCTION: &str = "The figures of the paper, drawn anew. Initial polygons and nets are red, as in the paper; limit curves are \
     black, or black, blue and green, after five levels and more.";

/// How the commands are to be taken.
pub(crate) const ABOUT_COMMANDS: &str = "Each command draws a part of a figure, a curve or a surface, from the control points beside the figures; it is \
     meant for the folder of the figures. The sheets that put the parts together are drawn by `refinable report build`.";

/// A figure of the paper.
pub(crate) struct Figure {
    /// The name of its file.
    pub name: &'static str,
    /// The label of the figure in the paper.
    pub label: &'static str,
    /// What is seen, and whose control points they are.
    pub caption: String,
    /// The commands that draw its parts.
    pub commands: Vec<String>,
    /// The picture.
    pub svg: String,
}

/// Adds all figures, the points they are drawn from, and a page that shows them to a site.
pub(crate) fn publish(site: &mut Site, figures: &[Figure]) {
    let mut page = format!("# Figures\n\n{INTRODUCTION}\n\n{ABOUT_COMMANDS}\n");
    for Figure { name, label, caption, commands, .. } in figures {
        let commands = commands.join("\n");
        page.push_str(&format!(
            "\n## {label}\n\n![{label}]({name}.svg)\n\n{caption}\n\n```sh\n{commands}\n```\n"
        ));
    }
    site.insert(format!("{FIGURES}/README.md"), page);
    for figure in figures {
        site.insert(format!("{FIGURES}/{}.svg", figure.name), figure.svg.clone());
    }
    let polygons = [
        ("letter", models::letter()),
        ("star", models::star()),
        ("interproximate-a3", interproximate::first()),
        ("interproximate-a5", interproximate::second()),
    ];
    for (name, polygon) in polygons {
        site.insert(format!("{FIGURES}/{name}.csv"), polygon_csv(&polygon));
    }
    let nets = [
        ("hill", models::hill()),
        ("vase", models::vase()),
        ("interproximate-surfaces", interproximate::net()),
    ];
    for (name, net) in nets {
        site.insert(format!("{FIGURES}/{name}.csv"), net_csv(&net));
    }
}

/// All figures, in the order of the paper.
///
/// # Errors
/// Those of refinement.
pub(crate) fn all() -> Result<Vec<Figure>, Diagnostic> {
    let mut figures = vec![sketch("schematic-even", "P5Schematic1", "a4")?];
    figures.extend(construction::figures()?);
    figures.push(sketch("schematic-odd", "P5Schematic2", "a5")?);
    figures.extend(curves::figures()?);
    figures.extend(surfaces::figures()?);
    figures.extend(interproximate::figures()?);
    Ok(figures)
}

fn sketch(name: &'static str, label: &'static str, scheme: &str) -> Result<Figure, Diagnostic> {
    let svg = rule_picture(&Scheme::resolve(scheme, 2)?);
    let caption = "Sketches of the rules, drawn for N = 1.".into();
    let commands = vec![format!("refinable show {scheme} -o {name}.svg")];
    Ok(Figure { name, label, caption, commands, svg })
}

/// A scheme of the catalogue at values of its parameters, in their order.
pub(crate) fn member(name: &str, values: &[&str]) -> Result<Scheme, Diagnostic> {
    let scheme = Scheme::resolve(name, 2)?;
    let values: Vec<Rational> =
        values.iter().map(|text| parse_rational(text).expect("the figures' own numbers")).collect();
    Ok(Scheme::new(name, scheme.mask().at(&values)?))
}

/// `α = 1/8, β = 0`, for the parameters of a family of the paper.
fn tensions(name: &str, values: &[&str]) -> String {
    let letters: &[&str] = if name.starts_with('i') { &["β"] } else { &["α", "β"] };
    let pairs = letters.iter().zip(values).map(|(letter, value)| format!("{letter} = {value}"));
    pairs.collect::<Vec<_>>().join(", ")
}

/// ` --set alpha=1/8 --set beta=0`, for the parameters of a scheme in their order.
fn settings(name: &str, values: &[&str]) -> Result<String, Diagnostic> {
    let scheme = Scheme::resolve(name, 2)?;
    let pairs = scheme.mask().parameters().into_iter().zip(values);
    Ok(pairs.map(|(parameter, value)| format!(" --set {parameter}={value}")).collect())
}
