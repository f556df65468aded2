//! The first page: the counts, the tables, and the ways to everything else.

use maud::{Markup, html};

use super::page::{Page, cited, commands, scrolling};
use super::typeset::typeset;
use super::{INDEX, Report, SPEED, table, verdict};
use crate::audit::{Agreement, AuditedTable, Counts};
use crate::families::MAPS;
use crate::figures::FIGURES;

/// The commands that build the report again, and check it.
const COMMANDS: [&str; 4] = [
    "cargo install --path crates/cli",
    "refinable tables",
    "refinable report build reports",
    "refinable report check reports",
];

/// The index.
pub(super) fn page(report: &Report<'_>) -> Page {
    let audit = report.audit;
    let certificate = audit.certificates.keys().next();
    let content = html! {
        p.source { (cited(&report.paper.citation)) }
        (verdicts(&audit.counts(), audit.level))
        (tables(report))
        section {
            h2 { "More" }
            ul {
                li { a href="errata.html" { "Errata" } ": the cells that disagree, and the misprints with their evidence" }
                li {
                    a href="comparison.html" { "Comparison" }
                    ": the comparison tables rebuilt from masks, with the shape of limits and more schemes of others"
                }
                @for family in report.families {
                    li {
                        a href={ (MAPS) "/" (family.name()) ".html" } { "Map of " (family.name()) }
                        ": " (typeset(&family.title()))
                    }
                }
                li { a href={ (FIGURES) "/index.html" } { "Figures" } " of the paper, drawn anew" }
                @if report.measurements.is_some() {
                    li { a href=(SPEED) { "Speed" } ": how long it takes, beside other programs" }
                }
                li {
                    "All tables as one document: " a.plain href="tables.tex" { "tables.tex" }
                    "; as data: " a.plain href="tables.json" { "tables.json" }
                }
            }
        }
        section {
            h2 { "To check a proof" }
            p {
                "Every verdict on continuity names its certificates, files in integers. A checker that knows nothing of the search \
                 accepts or rejects one, and docs/certificates.md of the sources says how to write another checker:"
            }
            @if let Some(name) = certificate { (commands(&[format!("refinable verify certificates/{name}.json")])) }
        }
        section {
            h2 { "To build this again" }
            p {
                "In the folder of the sources, with stable Rust. The report is the same to the last byte on every machine; the last \
                 command recomputes and compares it."
            }
            (commands(&COMMANDS.map(String::from)))
        }
    };
    Page { path: INDEX.into(), title: report.title(), content }
}

/// How many cells got each verdict, and what it means.
fn verdicts(counts: &Counts, level: u32) -> Markup {
    let total: usize = counts.iter().map(|(_, n)| n).sum();
    let share =
        |n: usize| format!("width: {}.{}%", 100 * n / total.max(1), 1000 * n / total.max(1) % 10);
    let table = html! {
        table.verdicts {
            caption #verdicts {
                (total) " cells of the paper’s tables, each claim against what is found "
                "(norms up to level " (level) ")"
            }
            thead {
                tr {
                    th scope="col" { "Verdict" }
                    th.number scope="col" { "Cells" }
                    th.share scope="col" { "Share" }
                    th scope="col" { "Meaning" }
                }
            }
            tbody {
                @for (agreement, n) in counts {
                    tr {
                        th scope="row" { (verdict(*agreement)) }
                        td.number { (n) }
                        td.share { span.bar.(agreement.word()) style=(share(*n)) {} }
                        td { (agreement.meaning()) }
                    }
                }
            }
        }
    };
    scrolling("verdicts", &table)
}

fn tables(report: &Report<'_>) -> Markup {
    let audit = report.audit;
    let counts = |counts: Counts| {
        html! { @for (_, n) in counts { td.number.none[n == 0] { (n) } } }
    };
    let row = |table: &AuditedTable| {
        html! {
            tr {
                th scope="row" { a.plain href=(table::path(table)) { (typeset(&table.title)) } }
                td.number { (table.cells.len()) }
                (counts(table.counts()))
            }
        }
    };
    let table = html! {
        table.tables {
            caption #tables { "Tables and theorems" }
            thead {
                tr {
                    th scope="col" { "Table" }
                    th.number scope="col" { "Cells" }
                    @for agreement in Agreement::ALL { th.number scope="col" { (verdict(agreement)) } }
                }
            }
            tbody { @for table in &audit.tables { (row(table)) } }
            tfoot {
                tr {
                    th scope="row" { "All" }
                    td.number { (audit.tables.iter().map(|table| table.cells.len()).sum::<usize>()) }
                    (counts(audit.counts()))
                }
            }
        }
    };
    scrolling("tables", &table)
}
