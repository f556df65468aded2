//! The pages of the figures and of the maps.

use maud::html;

use super::Report;
use super::grid::grid;
use super::page::{self, Page, up};
use super::typeset::typeset;
use crate::families::{FamilyMaps, MAPS};
use crate::figures::{ABOUT_COMMANDS, FIGURES, INTRODUCTION};
use crate::site::CERTIFICATES;

/// All figures on one page, each with the commands that draw it.
pub(super) fn figures(report: &Report<'_>) -> Page {
    let content = html! {
        p { (typeset(INTRODUCTION)) }
        p { (typeset(ABOUT_COMMANDS)) }
        @for figure in report.figures {
            section #(figure.name) {
                h2 { a.plain href={ "#" (figure.name) } { (figure.label) } }
                figure {
                    img src={ (figure.name) ".svg" } alt=(figure.caption) loading="lazy";
                    figcaption { (typeset(&figure.caption)) }
                }
                @if figure.commands.len() == 1 {
                    (page::commands(&figure.commands))
                } @else {
                    details { summary { (figure.commands.len()) " commands" } (page::commands(&figure.commands)) }
                }
            }
        }
    };
    Page { path: format!("{FIGURES}/index.html"), title: "Figures".into(), content }
}

/// A page for each family of two parameters.
pub(super) fn maps(report: &Report<'_>) -> Vec<Page> {
    report.families.iter().map(map).collect()
}

fn map(family: &FamilyMaps) -> Page {
    let name = family.name();
    let path = format!("{MAPS}/{name}.html");
    let document = family.document();
    let content = html! {
        @for view in family.views() {
            figure {
                img src={ (view.file) ".svg" } alt=(view.title);
                figcaption { (typeset(&view.title)) }
                (page::commands(&[view.command]))
            }
        }
        @for line in family.drawn() { p { (typeset(&line)) } }
        @for table in &document.grids { (grid(table)) }
        h2 { "Certificates" }
        p { "For " code { "refinable verify" } ":" }
        ul.certificates {
            @for (n, file) in family.certificates() {
                li {
                    (typeset(&format!("C^{n}"))) ": "
                    a.plain href={ (up(&path)) (CERTIFICATES) "/" (file) ".json" } { (file) ".json" }
                }
            }
        }
        (page::formats(name, &["md", "csv"]))
        (page::latex(&document.latex()))
    };
    Page { path, title: family.title(), content }
}
