//! What disagrees, and the notes on it that are written by hand.

use maud::html;

use super::Report;
use super::markdown::markdown;
use super::page::Page;
use super::table::{self, Cells};
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
