//! A report directory: every file of it as text.

use std::collections::BTreeMap;

use refinable_papers::Paper;
use refinable_scheme::Diagnostic;

use crate::audit::{Audit, AuditedTable};
use crate::comparison::comparison;
use crate::families::{FamilyMaps, MAPS};
use crate::figures;
use crate::grid::Document;
use crate::html::{self, Report};
use crate::performance::Measurements;
use crate::picture;

/// The generated files of a report by their path, `/` between folders.
pub type Site = BTreeMap<String, String>;

/// The report of an audit: an index, each table as md, csv, tex, json and html, the comparison tables rebuilt, the figures, a page
/// for each family of two parameters, and one about speed if something has been measured. `NOTES.md` beside them is written by
/// hand and not part of it.
///
/// # Errors
/// Those of the pictures of families; a scheme that cannot be resolved.
pub fn report_site(
    paper: &Paper,
    audit: &Audit,
    families: &[FamilyMaps],
    measurements: Option<&Measurements>,
) -> Result<Site, Diagnostic> {
    let mut site = Site::new();
    let mut index = index(paper, audit, families);
    if let Some(measurements) = measurements {
        measurements.publish(&mut site);
        index.push_str(
            "\nHow time grows, and that of others: [performance](performance/README.md).\n",
        );
    }
    site.insert("README.md".into(), index);
    for family in families {
        family.publish(&mut site)?;
    }
    let figures = figures::all()?;
    figures::publish(&mut site, &figures);
    site.insert("tables.json".into(), audit.document().json_text());
    site.insert("tables.tex".into(), latex_document(audit));
    let comparison = comparison(&paper.tables, audit)?;
    publish(&mut site, "comparison", &comparison);
    for table in &audit.tables {
        publish(&mut site, &format!("{TABLES}/{}", table.id), &table.document());
        if let Some(svg) = picture::ranges(table) {
            site.insert(format!("{TABLES}/{}.svg", table.id), svg);
        }
    }
    for (name, certificate) in &audit.certificates {
        let json = format!("{}\n", certificate.to_json());
        site.insert(format!("{CERTIFICATES}/{name}.json"), json);
    }
    html::publish(
        &mut site,
        &Report {
            paper,
            audit,
            families,
            figures: &figures,
            comparison: &comparison,
            measurements,
        },
    );
    Ok(site)
}

/// A document as md, csv, tex and json.
fn publish(site: &mut Site, path: &str, document: &Document) {
    site.insert(format!("{path}.md"), document.markdown());
    site.insert(format!("{path}.csv"), document.csv());
    site.insert(format!("{path}.tex"), document.latex());
    site.insert(format!("{path}.json"), document.json_text());
}

/// The folder of a report that holds its tables.
pub(crate) const TABLES: &str = "tables";

/// The folder of a report that holds its certificates.
pub const CERTIFICATES: &str = "certificates";

fn index(paper: &Paper, audit: &Audit, families: &[FamilyMaps]) -> String {
    let mut text = format!(
        "# Audit of “{}”\n\n{}\n\n{}\n\nThe same as pages to read and to print: \
         [index.html](index.html).\n\nWhat the misprints are, and their evidence: \
         [NOTES.md](NOTES.md).\nAll tables as one document: [tables.tex](tables.tex); as data: \
         [tables.json](tables.json). Every verdict on continuity names its\n\
         certificates below [certificates](certificates/): `refinable verify FILE` checks one, and\n\
         docs/certificates.md says how to write another checker.\n\n",
        paper.title,
        paper.citation,
        audit.summary(),
    );
    text.push_str(
        "| table | cells | agrees | stronger | not-checked | undecided | disagrees | |\n",
    );
    text.push_str("|---|---|---|---|---|---|---|---|\n");
    for table in &audit.tables {
        text.push_str(&index_row(table));
    }
    text.push_str(
        "\nThe comparison tables rebuilt from masks, with the shape of limits and more schemes of others: \
         [comparison.md](comparison.md), [csv](comparison.csv), [tex](comparison.tex), [json](comparison.json).\n",
    );
    text.push_str("\nWhere the families of two parameters are C^n, over both of them:\n\n");
    for name in families.iter().map(FamilyMaps::name) {
        text.push_str(&format!("* [{name}]({MAPS}/{name}.md)\n"));
    }
    text.push_str("\nThe figures of the paper, drawn anew: [figures](figures/README.md).\n");
    text
}

fn index_row(table: &AuditedTable) -> String {
    let counts: Vec<String> = table.counts().iter().map(|(_, n)| n.to_string()).collect();
    let id = &table.id;
    let mut kinds = vec!["csv", "tex", "json"];
    kinds.extend(picture::ranges(table).map(|_| "svg"));
    let files: Vec<String> = kinds.iter().map(|e| format!("[{e}](tables/{id}.{e})")).collect();
    let files = files.join(" ");
    format!(
        "| [{}](tables/{id}.md) | {} | {} | {files} |\n",
        table.title,
        table.cells.len(),
        counts.join(" | "),
    )
}

/// A document that compiles on its own and inputs every table.
fn latex_document(audit: &Audit) -> String {
    let mut text = String::from(
        "\\documentclass[a4paper,landscape]{article}\n\\usepackage[margin=1.5cm]{geometry}\n\
         \\usepackage{amsmath,array,booktabs,longtable}\n\\setlength\\LTcapwidth{\\linewidth}\n\\begin{document}\n\\footnotesize\n",
    );
    for table in &audit.tables {
        text.push_str(&format!("\\input{{tables/{}.tex}}\n", table.id));
    }
    text.push_str("\\input{comparison.tex}\n\\end{document}\n");
    text
}
