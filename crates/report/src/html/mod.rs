//! The report as pages for people, made of what the Markdown is made of.
//!
//! A page is a function of the report. It needs nothing but itself and the pictures beside it: no script, no font, no network.

mod errata;
mod grid;
mod index;
mod markdown;
mod page;
mod pictures;
mod table;
#[cfg(test)]
mod tests;
mod typeset;

use maud::{Markup, html};
use refinable_papers::Paper;

use crate::audit::{Agreement, Audit};
use crate::families::FamilyMaps;
use crate::figures::Figure;
use crate::grid::Document;
use crate::performance::Measurements;
use crate::site::Site;
use page::Page;

/// What the pages are about.
pub(crate) struct Report<'a> {
    /// The paper that is audited.
    pub paper: &'a Paper,
    /// The verdicts.
    pub audit: &'a Audit,
    /// The families over two parameters.
    pub families: &'a [FamilyMaps],
    /// The figures.
    pub figures: &'a [Figure],
    /// The comparison tables.
    pub comparison: &'a Document,
    /// What is known about speed, if something has been measured.
    pub measurements: Option<&'a Measurements>,
}

impl Report<'_> {
    fn title(&self) -> String {
        format!("Audit of “{}”", self.paper.title)
    }
}

/// The first page.
const INDEX: &str = "index.html";

/// Adds all pages to a site.
pub(crate) fn publish(site: &mut Site, report: &Report<'_>) {
    let single: [fn(&Report<'_>) -> Page; 4] =
        [index::page, errata::page, comparison, pictures::figures];
    let mut pages: Vec<Page> = single.iter().map(|page| page(report)).collect();
    pages.extend(table::pages(report));
    pages.extend(pictures::maps(report));
    pages.extend(report.measurements.map(speed));
    for page in pages {
        site.insert(page.path.clone(), page.document(report));
    }
}

/// The comparison tables rebuilt.
fn comparison(report: &Report<'_>) -> Page {
    let content = html! {
        p { "The comparison tables of the paper rebuilt from masks, with the shape of limits and more schemes of others." }
        @for table in &report.comparison.grids { (grid::grid(table)) }
        (page::formats("comparison", &["md", "csv", "tex", "json"]))
        (page::latex(&report.comparison.latex()))
    };
    Page { path: "comparison.html".into(), title: "Comparison".into(), content }
}

/// The page about speed.
const SPEED: &str = "performance/index.html";

/// How time grows, and that of others.
fn speed(measurements: &Measurements) -> Page {
    let content = html! { section.notes { (markdown::markdown(&measurements.page())) } };
    Page { path: SPEED.into(), title: "Speed".into(), content }
}

/// A verdict as sign and word.
fn verdict(agreement: Agreement) -> Markup {
    html! {
        span.verdict {
            span.mark.(agreement.word()) aria-hidden="true" { (agreement.symbol()) } " " (agreement.word())
        }
    }
}
