//! What all pages have in common.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::typeset::typeset;
use super::{INDEX, Report, SPEED};
use crate::families::MAPS;
use crate::figures::FIGURES;

/// The looks of all pages, inside of each of them: a page can be sent alone.
const STYLE: &str = include_str!("style.css");

/// A page of the report: where it is, what it is called, what it says.
pub(super) struct Page {
    /// The file, from the folder of the report, `/` between folders.
    pub path: String,
    /// The title in plain notation.
    pub title: String,
    /// What follows the title.
    pub content: Markup,
}

/// From the page at a path to the folder of the report: `../` for each folder it is in.
pub(super) fn up(path: &str) -> String {
    "../".repeat(path.matches('/').count())
}

impl Page {
    /// The whole document, with the ways to the other pages.
    pub fn document(&self, report: &Report<'_>) -> String {
        let up = up(&self.path);
        let link = |path: &str, text: &str| {
            let here = (path == self.path).then_some("page");
            html! { li { a href={ (up) (path) } aria-current=[here] { (text) } } }
        };
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    title { (self.title) @if self.path != INDEX { " · " (report.title()) } }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    a.skip href="#content" { "Skip to the content" }
                    nav aria-label="Pages of the report" {
                        ul {
                            (link(INDEX, "Audit"))
                            (link("errata.html", "Errata"))
                            (link("comparison.html", "Comparison"))
                            @for family in report.families {
                                (link(&format!("{MAPS}/{}.html", family.name()), &format!("Map of {}", family.name())))
                            }
                            (link(&format!("{FIGURES}/index.html"), "Figures"))
                            @if report.measurements.is_some() { (link(SPEED, "Speed")) }
                        }
                    }
                    main #content {
                        h1 { (typeset(&self.title)) }
                        (self.content)
                    }
                    footer {
                        p {
                            "Part of the " a href={ (up) (INDEX) } { "audit" } " of " (cited(&report.paper.citation))
                        }
                        p { "Written by " code { "refinable report build" } " from exact arithmetic; no float decides anything here." }
                    }
                }
            }
        };
        format!("{}\n", page.into_string())
    }
}

/// A citation, with a link where it names a preprint.
pub(super) fn cited(citation: &str) -> Markup {
    const PREPRINT: &str = "arXiv:";
    let Some((before, rest)) = citation.split_once(PREPRINT) else {
        return html! { (citation) };
    };
    let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
    let number = rest[..end].trim_end_matches('.');
    html! {
        (before)
        a href={ "https://arxiv.org/abs/" (number) } { (PREPRINT) (number) }
        (&rest[number.len()..])
    }
}

/// A wide table in a box of its own that scrolls, by touch and by keys; `id` is that of its caption.
pub(super) fn scrolling(id: &str, table: &Markup) -> Markup {
    html! { div.scroll role="region" tabindex="0" aria-labelledby=(id) { (table) } }
}

/// Commands, each on a line of its own, to be selected by a click.
pub(super) fn commands(commands: &[String]) -> Markup {
    html! { div.commands { @for command in commands { pre { code { (command) } } } } }
}

/// LaTeX to be selected by a click, folded away.
pub(super) fn latex(text: &str) -> Markup {
    html! {
        details.latex {
            summary { "LaTeX" }
            p {
                "A fragment for " code { "\\input" } ", with the packages booktabs, longtable, array and amsmath; a click selects \
                 all of it."
            }
            pre tabindex="0" { code { (text) } }
        }
    }
}

/// The same document in other formats: links to files next to the page.
pub(super) fn formats(stem: &str, ends: &[&str]) -> Markup {
    html! {
        p.formats {
            "The same as "
            @for (k, end) in ends.iter().enumerate() {
                @if k > 0 { ", " }
                a href={ (stem) "." (end) } { (end) }
            }
            "."
        }
    }
}
