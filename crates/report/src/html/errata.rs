//! What disagrees, and the notes on it that are written by hand.

use maud::{Markup, PreEscaped, html};
use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeStream};

use super::Report;
use super::page::Page;
use super::table::{self, Cells};
use super::typeset::typeset;
use crate::audit::{Agreement, AuditedCell};

/// The notes are committed beside the report, and no part of what is generated.
const NOTES: &str = include_str!("../../../../reports/NOTES.md");

/// The page.
pub(super) fn page(report: &Report<'_>) -> Page {
    let audit = report.audit;
    let disagree = |cell: &&AuditedCell| cell.agreement == Agreement::Disagrees;
    let count = audit.tables.iter().flat_map(|table| &table.cells).filter(disagree).count();
    let content = html! {
        section {
            h2 { "Cells that disagree" }
            p {
                (count) " cells of the tables disagree with what is found. The cell links to its place on the "
                "page of its table; below, "
                a href="#notes" { "what the misprints are" } "."
            }
            @for table in &audit.tables {
                @let cells: Vec<&AuditedCell> = table.cells.iter().filter(disagree).collect();
                @if !cells.is_empty() {
                    @let page = table::path(table);
                    @let cells = Cells { cells, certificates: &audit.certificates, up: "", table: Some(&page) };
                    (cells.markup(&table.id, &table.title))
                }
            }
        }
        section.notes #notes {
            h2 { "Notes" }
            (markdown(NOTES))
        }
    };
    Page { path: "errata.html".into(), title: "Errata".into(), content }
}

/// The notes below a heading of the page: without their title, the other headings one level deeper, formulas typeset,
/// and links to the pages instead of the Markdown they are made beside.
fn markdown(text: &str) -> Markup {
    let mut within_title = false;
    let events = TextMergeStream::new(Parser::new_ext(text, Options::ENABLE_TABLES));
    let events = events.filter(move |event| {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) => within_title = true,
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                within_title = false;
                return false;
            }
            _ => {}
        }
        !within_title
    });
    let mut html = String::new();
    pulldown_cmark::html::push_html(&mut html, events.map(adapted));
    PreEscaped(html)
}

fn adapted(event: Event<'_>) -> Event<'_> {
    match event {
        Event::Start(Tag::Heading { level, id, classes, attrs }) => {
            Event::Start(Tag::Heading { level: deeper(level), id, classes, attrs })
        }
        Event::End(TagEnd::Heading(level)) => Event::End(TagEnd::Heading(deeper(level))),
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let dest_url = match dest_url.strip_suffix(".md") {
                Some(stem) => CowStr::from(format!("{stem}.html")),
                None => dest_url,
            };
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        Event::Text(text) => Event::InlineHtml(typeset(&text).into_string().into()),
        other => other,
    }
}

fn deeper(level: HeadingLevel) -> HeadingLevel {
    match level {
        HeadingLevel::H1 => HeadingLevel::H2,
        HeadingLevel::H2 => HeadingLevel::H3,
        HeadingLevel::H3 => HeadingLevel::H4,
        HeadingLevel::H4 => HeadingLevel::H5,
        _ => HeadingLevel::H6,
    }
}

#[cfg(test)]
mod tests {
    use super::markdown;

    #[test]
    fn notes_become_a_part_of_a_page() {
        let html =
            markdown("# Title\n\n## A & B\n\nC^2, [all](tables/x.md), `a_b < c`\n").into_string();
        let expected = "<h3>A &amp; B</h3>\n<p>C<sup>2</sup>, <a href=\"tables/x.html\">all</a>, \
                        <code>a_b &lt; c</code></p>\n";
        assert_eq!(html.trim_start(), expected);
    }
}
