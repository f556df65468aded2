//! A page for each audited table, and its cells.

use maud::{Markup, html};

use super::page::{self, Page, scrolling, up};
use super::typeset::typeset;
use super::{Report, verdict};
use crate::audit::{AuditedCell, AuditedTable, CertificateStore};
use crate::picture;
use crate::sharp::proof_text;
use crate::site::{CERTIFICATES, TABLES};

/// The page of a table.
pub(super) fn path(table: &AuditedTable) -> String {
    format!("{TABLES}/{}.html", table.id)
}

/// The place of a cell on the page of its table, made of its row and its column.
pub(super) fn anchor(cell: &AuditedCell) -> String {
    format!("{}--{}", slug(&cell.row), slug(&cell.column))
}

/// Letters and digits of a text, what is between them as single hyphens.
fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

/// The cells of a table in groups of successive ones of the same row.
pub(super) fn groups<'a>(cells: &[&'a AuditedCell]) -> Vec<Vec<&'a AuditedCell>> {
    cells.chunk_by(|a, b| a.row == b.row).map(<[_]>::to_vec).collect()
}

/// The pages of all tables.
pub(super) fn pages(report: &Report<'_>) -> Vec<Page> {
    report.audit.tables.iter().enumerate().map(|(k, table)| page(report, k, table)).collect()
}

fn page(report: &Report<'_>, k: usize, table: &AuditedTable) -> Page {
    let tables = &report.audit.tables;
    let id = &table.id;
    let path = path(table);
    let cells: Vec<&AuditedCell> = table.cells.iter().collect();
    let body =
        Cells { cells, certificates: &report.audit.certificates, up: &up(&path), table: None };
    let before = k.checked_sub(1).map(|k| &tables[k]);
    let content = html! {
        p.locator { "In the paper: " (typeset(&table.locator)) "." }
        (counts(table))
        (glance(table))
        (body.markup(id, "Cell by cell"))
        @if picture::ranges(table).is_some() {
            figure {
                img src={ (id) ".svg" } alt={ "Claimed and proved ranges: " (table.title) };
                figcaption { "Claimed and proved ranges. Drawn, like this page, by " code { "refinable report build" } "." }
            }
        }
        h2 { "This table elsewhere" }
        (page::commands(&[format!("refinable tables --table {id}")]))
        (page::formats(id, &["md", "csv", "tex", "json"]))
        (page::latex(&table.document().latex()))
        nav.turn aria-label="Tables before and after" {
            @for (table, rel) in [(before, "prev"), (tables.get(k + 1), "next")] {
                @if let Some(table) = table {
                    a rel=(rel) href={ (table.id) ".html" } { (typeset(&table.title)) }
                }
            }
        }
    };
    Page { path, title: table.title.clone(), content }
}

/// The verdicts in the rows and columns of the printed table.
fn glance(table: &AuditedTable) -> Markup {
    let mut columns: Vec<&str> = Vec::new();
    for cell in &table.cells {
        if !columns.contains(&&*cell.column) {
            columns.push(&cell.column);
        }
    }
    if columns.len() < 2 {
        return html! {};
    }
    let cells: Vec<&AuditedCell> = table.cells.iter().collect();
    let linked = |cell: &AuditedCell| {
        let text = format!("{}, {}: {}", cell.row, cell.column, cell.agreement.word());
        html! {
            a.mark.(cell.agreement.word()) href={ "#" (anchor(cell)) } title=(text) aria-label=(text) {
                (cell.agreement.symbol())
            }
        }
    };
    let grid = html! {
        table.glance {
            caption #glance { "At a glance" }
            thead {
                tr { td {} @for column in &columns { th scope="col" { (typeset(column)) } } }
            }
            tbody {
                @for group in groups(&cells) {
                    tr {
                        th scope="row" { (typeset(&group[0].row)) }
                        @for column in &columns {
                            td { @for cell in group.iter().filter(|cell| cell.column == **column) { (linked(cell)) } }
                        }
                    }
                }
            }
        }
    };
    scrolling("glance", &grid)
}

/// How many cells have each verdict.
fn counts(table: &AuditedTable) -> Markup {
    html! {
        ul.counts aria-label="Verdicts" {
            @for (agreement, count) in table.counts() { li { (verdict(agreement)) " " (count) } }
        }
    }
}

/// Cells with their claims, findings, verdicts, and evidence.
pub(super) struct Cells<'a> {
    pub cells: Vec<&'a AuditedCell>,
    pub certificates: &'a CertificateStore,
    /// From the page to the folder of the report.
    pub up: &'a str,
    /// The page of the table if it is another one; cells can be linked to on their own page only.
    pub table: Option<&'a str>,
}

impl Cells<'_> {
    /// The table; `id` is unique on its page.
    pub fn markup(&self, id: &str, title: &str) -> Markup {
        let caption = format!("{id}-caption");
        let groups = groups(&self.cells);
        // Rows of one cell need no line of their own.
        let flat = groups.iter().all(|group| group.len() == 1);
        let table = html! {
            table.cells {
                caption #(caption) { (typeset(title)) }
                thead {
                    tr {
                        th scope="col" { "Cell" }
                        th scope="col" { "Claim, as printed" }
                        th scope="col" { "Finding" }
                        th scope="col" { "Verdict" }
                        th scope="col" { "Witness and notes" }
                    }
                }
                @for group in &groups {
                    tbody {
                        @if !flat {
                            tr.group { th scope="rowgroup" colspan="5" { (typeset(&group[0].row)) } }
                        }
                        @for cell in group {
                            @let name = if flat { format!("{}, {}", cell.row, cell.column) } else { cell.column.clone() };
                            (self.row(cell, &name))
                        }
                    }
                }
            }
        };
        scrolling(&caption, &table)
    }

    fn row(&self, cell: &AuditedCell, name: &str) -> Markup {
        let anchor = anchor(cell);
        let id = self.table.is_none().then_some(&anchor);
        html! {
            tr id=[id] {
                th scope="row" {
                    a.plain href={ (self.table.unwrap_or_default()) "#" (anchor) } { (typeset(name)) }
                }
                td { (typeset(&cell.claim)) }
                td { (typeset(&cell.finding)) }
                td { (verdict(cell.agreement)) }
                td.evidence {
                    @for text in &cell.evidence { p { (typeset(text)) } }
                    @for text in &cell.remarks { p.remark { (typeset(text)) } }
                    @if !cell.certificates.is_empty() { (self.proofs(cell)) }
                }
            }
        }
    }

    /// Links to the certificates of a cell, with what they are made of.
    fn proofs(&self, cell: &AuditedCell) -> Markup {
        html! {
            ul.certificates aria-label="Certificates" {
                @for name in &cell.certificates {
                    li {
                        a.plain href={ (self.up) (CERTIFICATES) "/" (name) ".json" } { (name) ".json" }
                        @if let Some(certificate) = self.certificates.get(name) {
                            ": " (proof_text(certificate))
                        }
                    }
                }
            }
        }
    }
}
