//! The paper's comparison tables, rebuilt by [`compare`](crate::compare()) for all rows whose masks are known.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use refinable_algebra::Rational;
use refinable_analysis::Sharpness;
use refinable_papers::{Claim, Table};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::{Map, Value, json};

use crate::audit::{Agreement, Audit, AuditedCell, CertificateStore, certified};
use crate::compare::{HEADER, REMARKS, Row, Smoothness};
use crate::grid::{Cell, Document, Grid};
use crate::range::only_parameter;
use crate::sharp::sharp_range;

/// The tables of a paper that set schemes side by side.
const TABLES: [&str; 2] = ["comparison-dd", "comparison-all"];

/// Schemes of others that the paper's introduction speaks of, by the key of the citation, as far as their masks are known;
/// their files in the catalogue say from where.
const OTHERS: [[&str; 2]; 5] = [
    ["[Dyn5], 3 and 4 points", "even: [1/3, 1/3, 1/3]; odd: [1/4, 1/4, 1/4, 1/4]"],
    [
        "[Dyn5], 5 and 6 points",
        "even: [1/5, 1/5, 1/5, 1/5, 1/5]; odd: [1/6, 1/6, 1/6, 1/6, 1/6, 1/6]",
    ],
    ["[Dyn7]", "dualfourpoint(w)"],
    ["[Li]", "combine(bspline3, dd4, w)"],
    ["[Dyn1]", "fourpoint(w)"],
];

/// The columns of a comparison that leave room for what is printed; the data have all.
const SHOWN: [&str; 13] = [
    "scheme",
    "support width",
    "GD, all",
    "GD, best",
    "RD, all",
    "RD, best",
    "C^n",
    "where",
    "Hölder exponent",
    "attained at",
    "overshoot",
    "monotone",
    "convex",
];

/// What the rows of others stand for.
const DETERMINED: &str = "where the paper gives no mask, the B-spline is the member that the printed SW and GD1 determine; the \
                          family itself is not known, and its row is not verified";
const INFERRED: &str = "what the keys stand for is inferred from the paper's text, which has no bibliography; NOTES.md says how";

/// The widest masks of two parameters whose smoothest member is looked for: a search takes seconds.
const WIDEST_OF_TWO: i64 = 14;

/// A row of a printed table with the schemes it is about.
struct Entry<'a> {
    name: &'a str,
    printed: Vec<(&'a str, &'a str)>,
    verdicts: Vec<(&'a str, Agreement)>,
    masks: Vec<String>,
}

/// What is found about each mask.
type Findings = BTreeMap<String, Row>;

/// The comparison tables with what is printed, how it stands in the audit, and what is found; and other schemes that the paper
/// speaks of.
///
/// Rows of schemes without masks are rebuilt where their own figures determine one: `n + 1` coefficients that
/// `(1+z)^n` divides are those of the B-spline of degree `n - 1`.
///
/// # Errors
/// A scheme that cannot be resolved.
///
/// # Cost
/// Ranges over one parameter are taken from the certificates of the audit. For each family of two parameters the smoothest
/// member is searched for, which takes seconds.
pub(crate) fn comparison(tables: &[Table], audit: &Audit) -> Result<Document, Diagnostic> {
    let printed = TABLES.iter().filter_map(|id| tables.iter().find(|table| table.id == *id));
    let mut sections: Vec<(&str, &str, &str, Vec<Entry>)> = Vec::new();
    for table in printed {
        let audited = audit.tables.iter().filter(|audited| audited.id == table.id);
        let cells: Vec<&AuditedCell> = audited.flat_map(|audited| &audited.cells).collect();
        sections.push((&table.id, &table.title, DETERMINED, entries(table, &cells)));
    }
    let other = |[name, mask]: [&'static str; 2]| Entry {
        name,
        printed: Vec::new(),
        verdicts: Vec::new(),
        masks: vec![mask.to_string()],
    };
    let others = OTHERS.into_iter().map(other).collect();
    sections.push(("others", "Other schemes of the paper's introduction", INFERRED, others));

    // Most schemes stand in two tables.
    let entries = sections.iter().flat_map(|(.., entries)| entries);
    let masks: BTreeSet<&String> = entries.flat_map(|entry| &entry.masks).collect();
    let row = |mask: &String| {
        let scheme = Scheme::resolve(mask, 2)?;
        Ok((mask.clone(), Row::new(&scheme, smoothness(&scheme, &audit.certificates))))
    };
    let findings: Findings = masks.into_par_iter().map(row).collect::<Result<_, Diagnostic>>()?;

    let (mut grids, mut data) = (Vec::new(), Vec::new());
    for (id, title, remark, entries) in sections {
        grids.push(grid(id, title, remark, &entries, &findings));
        let rows: Value = entries.iter().map(|entry| entry.json(&findings)).collect();
        data.push(json!({"id": id, "rows": rows}));
    }
    if let Some(last) = grids.last_mut() {
        last.remarks.extend(REMARKS.map(String::from));
    }
    Ok(Document { grids, summary: None, json: json!({"tables": data}) })
}

fn entries<'a>(table: &'a Table, audited: &[&AuditedCell]) -> Vec<Entry<'a>> {
    let mut names: Vec<&str> = table.cells.iter().map(|cell| cell.row.as_str()).collect();
    names.dedup();
    let entry = |name: &'a str| {
        let cells: Vec<_> = table.cells.iter().filter(|cell| cell.row == name).collect();
        let mut masks: Vec<String> = Vec::new();
        for claim in cells.iter().flat_map(|cell| &cell.claims) {
            if let Claim::Checkable(assertion) = claim
                && !masks.contains(&assertion.scheme)
            {
                masks.push(assertion.scheme.clone());
            }
        }
        masks.extend(determined(table, name).filter(|_| masks.is_empty()));
        let verdict = |column: &'a str| {
            let cell = audited.iter().find(|cell| cell.row == name && cell.column == column)?;
            Some((column, cell.agreement))
        };
        let columns = cells.iter().map(|cell| cell.column.as_str());
        Entry {
            name,
            printed: cells.iter().map(|cell| (&*cell.column, &*cell.printed)).collect(),
            verdicts: columns.filter_map(verdict).collect(),
            masks,
        }
    };
    names.into_iter().map(entry).collect()
}

/// The scheme that the printed figures of a row determine.
fn determined(table: &Table, row: &str) -> Option<String> {
    let number = |column: &str| table.cell(row, column)?.printed.parse::<u32>().ok();
    let (width, degree) = (number("SW")?, number("GD1")?);
    (width == degree + 1).then(|| format!("bspline{degree}"))
}

fn smoothness(scheme: &Scheme, certificates: &CertificateStore) -> Smoothness {
    let mask = scheme.mask();
    let widest = Rational::from_integer(WIDEST_OF_TWO.into());
    if mask.parameters().len() == 2 && mask.support_width() > widest {
        let problem = Some("not searched; see the audit".to_string());
        return Smoothness { problem, ..Smoothness::default() };
    }
    Smoothness::with(scheme, &|n| {
        let known = certified(certificates, scheme, &only_parameter(scheme)?, n);
        known.map_or_else(|| sharp_range(scheme, n, &Sharpness::default()), Ok)
    })
}

/// The cells of the columns that are shown.
fn shown(row: &Row) -> Vec<Cell> {
    let cells = HEADER.iter().zip(row.cells());
    cells.filter(|(title, _)| SHOWN.contains(title)).map(|(_, cell)| cell).collect()
}

fn grid(id: &str, title: &str, remark: &str, entries: &[Entry], findings: &Findings) -> Grid {
    let header = ["row", "printed", "audit"].into_iter().chain(SHOWN);
    Grid {
        id: id.into(),
        caption: title.into(),
        header: header.map(String::from).collect(),
        rows: entries.iter().flat_map(|entry| entry.lines(findings)).collect(),
        remarks: vec![remark.into()],
    }
}

impl Entry<'_> {
    /// A line for each scheme, what is printed at the first; one without findings if there is none.
    fn lines(&self, findings: &Findings) -> Vec<Vec<Cell>> {
        let printed: Vec<String> =
            self.printed.iter().map(|(c, text)| format!("{c} {text}")).collect();
        let first =
            [Cell::name(self.name), Cell::name(printed.join(", ")), Cell::text(self.verdict())];
        let blank = |n: usize| vec![Cell::text(""); n];
        let mut found: Vec<Vec<Cell>> = self.rows(findings).map(shown).collect();
        if found.is_empty() {
            found.push([vec![Cell::text("mask not known")], blank(SHOWN.len() - 1)].concat());
        }
        let head = |k: usize| if k == 0 { first.to_vec() } else { blank(first.len()) };
        found.into_iter().enumerate().map(|(k, cells)| [head(k), cells].concat()).collect()
    }

    /// The worst verdict, with the columns that have it unless all have.
    fn verdict(&self) -> String {
        let Some(worst) = self.verdicts.iter().map(|(_, agreement)| *agreement).max() else {
            return String::new();
        };
        let with: Vec<&str> =
            self.verdicts.iter().filter(|(_, a)| *a == worst).map(|(column, _)| *column).collect();
        if with.len() == self.verdicts.len() {
            worst.word().into()
        } else {
            format!("{}: {}", worst.word(), with.join(", "))
        }
    }

    fn rows<'f>(&'f self, findings: &'f Findings) -> impl Iterator<Item = &'f Row> {
        self.masks.iter().filter_map(|mask| findings.get(mask))
    }

    fn json(&self, findings: &Findings) -> Value {
        let printed: Map<String, Value> =
            self.printed.iter().map(|(c, text)| (c.to_string(), json!(text))).collect();
        let verdicts: Map<String, Value> =
            self.verdicts.iter().map(|(c, a)| (c.to_string(), json!(a.word()))).collect();
        let found: Vec<Value> = self.rows(findings).map(Row::json).collect();
        json!({"row": self.name, "printed": printed, "audit": verdicts, "found": found})
    }
}
