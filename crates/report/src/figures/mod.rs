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

use crate::rule_picture::rule_picture;
use crate::site::Site;

/// The folder of a report that holds the figures.
const FIGURES: &str = "figures";

/// A figure of the paper.
pub(crate) struct Figure {
    /// The name of its file.
    pub name: &'static str,
    /// The label of the figure in the paper.
    pub label: &'static str,
    /// What is seen, and whose control points they are.
    pub caption: String,
    /// The picture.
    pub svg: String,
}

/// Adds all figures and a page that shows them to a site.
///
/// # Errors
/// Those of refinement.
pub fn publish(site: &mut Site) -> Result<(), Diagnostic> {
    let figures = all()?;
    let mut page = String::from(
        "# Figures\n\nThe figures of the paper, drawn anew. Initial polygons and nets are red, as in the paper; \
         limit curves are black, or black, blue and green, after five levels and more.\n",
    );
    for Figure { name, label, caption, .. } in &figures {
        page.push_str(&format!("\n## {label}\n\n![{label}]({name}.svg)\n\n{caption}\n"));
    }
    site.insert(format!("{FIGURES}/README.md"), page);
    for figure in figures {
        site.insert(format!("{FIGURES}/{}.svg", figure.name), figure.svg);
    }
    Ok(())
}

fn all() -> Result<Vec<Figure>, Diagnostic> {
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
    let caption = format!(
        "Sketches of the rules, drawn for N = 1: `refinable show {scheme} -o rule.svg` draws them for any scheme."
    );
    Ok(Figure { name, label, caption, svg })
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
