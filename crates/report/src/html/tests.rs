//! Pages of an audit made up for the purpose, with everything in its texts that HTML could trip over.

use refinable_papers::Paper;
use scraper::{Html, Selector};

use super::{Report, publish};
use crate::audit::{Agreement, Audit, AuditedCell, AuditedTable, CertificateStore};
use crate::grid::{Cell, Document, Grid};
use crate::site::Site;

const NASTY: &str = "<script>alert(1)</script> & \"quoted\" 'so' </td></table> 1 < 2 &lt; C^{<b>}";

fn cell(row: &str, column: &str, agreement: Agreement) -> AuditedCell {
    AuditedCell {
        row: row.into(),
        column: column.into(),
        claim: NASTY.into(),
        finding: NASTY.into(),
        agreement,
        evidence: vec![NASTY.into()],
        remarks: vec![NASTY.into()],
        ranges: None,
        certificates: Vec::new(),
    }
}

fn site() -> Site {
    let cells = vec![
        cell(NASTY, "C^0", Agreement::Disagrees),
        cell(NASTY, "C^1", Agreement::Agrees),
        cell("other", "C^1", Agreement::NotChecked),
    ];
    let table = AuditedTable { id: "t".into(), title: NASTY.into(), locator: NASTY.into(), cells };
    let audit = Audit { tables: vec![table], level: 1, certificates: CertificateStore::new() };
    let mut paper = Paper::builtin().expect("the paper is well formed");
    paper.title = NASTY.into();
    let grid = Grid {
        id: "g".into(),
        caption: NASTY.into(),
        header: vec![NASTY.into(), "second".into()],
        rows: vec![
            vec![Cell::text(NASTY), Cell::text(NASTY)],
            vec![Cell::text(""), Cell::text("")],
        ],
        remarks: vec![NASTY.into(); 9],
    };
    let comparison = Document { grids: vec![grid], summary: None, json: serde_json::Value::Null };
    let report = Report {
        paper: &paper,
        audit: &audit,
        families: &[],
        figures: &[],
        comparison: &comparison,
        measurements: None,
    };
    let mut site = Site::new();
    publish(&mut site, &report);
    site
}

fn texts(page: &str, selector: &str) -> Vec<String> {
    let html = Html::parse_document(page);
    let selector = Selector::parse(selector).expect("a selector");
    html.select(&selector).map(|element| element.text().collect()).collect()
}

/// The text is what a reader sees, but for the exponent.
fn seen() -> String {
    NASTY.replace("^{<b>}", "<b>")
}

#[test]
fn texts_are_escaped_everywhere() {
    let site = site();
    assert_eq!(site.len(), 5, "{:?}", site.keys());
    for (path, page) in &site {
        let html = Html::parse_document(page);
        assert!(html.errors.is_empty(), "{path}: {:?}", html.errors);
        assert!(texts(page, "script, b, table table").is_empty(), "{path}");
    }
    let page = &site["tables/t.html"];
    assert_eq!(texts(page, "table.cells td:nth-child(2)"), [seen(), seen(), seen()]);
    assert_eq!(texts(page, ".evidence p"), vec![seen(); 6]);
    assert_eq!(texts(page, "h1"), [seen()]);
    // In a title nothing is raised.
    assert!(texts(page, "title")[0].starts_with(NASTY));
    assert_eq!(texts(&site["comparison.html"], ".remarks li"), vec![seen(); 9]);
}

#[test]
fn the_latex_on_a_page_is_that_of_the_file() {
    let latex = &texts(&site()["tables/t.html"], ".latex pre code")[0];
    assert!(latex.starts_with("\\begin{longtable}") && latex.contains("alert(1)"), "{latex}");
}

#[test]
fn errata_link_to_the_cell() {
    let site = site();
    let html = Html::parse_document(&site["errata.html"]);
    let links = Selector::parse("table.cells tbody a").expect("a selector");
    let links: Vec<&str> = html.select(&links).filter_map(|link| link.attr("href")).collect();
    let [link] = links[..] else { panic!("{links:?}") };
    let place = link.strip_prefix("tables/t.html#").expect("a place");
    let page = &site["tables/t.html"];
    assert_eq!(texts(page, &format!("[id='{place}'] .verdict")), ["× disagrees"]);
}
