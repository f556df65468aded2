//! The audit: what a paper claims, what we find, and how the two agree, cell by cell.

mod constant;
mod continuity;
mod degrees;
mod maximum;
mod render;
mod statement;
mod workbench;

use std::sync::atomic::{AtomicUsize, Ordering};

use refinable_papers::{Cell, Claim, Table};
use refinable_reals::Region;
use refinable_scheme::Diagnostic;

pub(crate) use continuity::short;
use workbench::Workbench;
pub(crate) use workbench::certified;
pub use workbench::{CertificateStore, Effort};

/// How a finding stands to a claim, from the best to the worst.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Agreement {
    /// The claim holds, and is exactly what we find.
    Agrees,
    /// The claim holds, and more is proved.
    Stronger,
    /// The claim is none a computation can decide; the note says why.
    NotChecked,
    /// Neither proved nor refuted with the means of this audit.
    Undecided,
    /// Some part of the claim is refuted.
    Disagrees,
}

impl Agreement {
    /// All of them, from the best to the worst.
    pub const ALL: [Agreement; 5] = [
        Agreement::Agrees,
        Agreement::Stronger,
        Agreement::NotChecked,
        Agreement::Undecided,
        Agreement::Disagrees,
    ];

    /// The word used in every output.
    pub fn word(self) -> &'static str {
        match self {
            Agreement::Agrees => "agrees",
            Agreement::Stronger => "stronger",
            Agreement::NotChecked => "not-checked",
            Agreement::Undecided => "undecided",
            Agreement::Disagrees => "disagrees",
        }
    }

    /// A sign for pictures and narrow columns, told apart without colour.
    pub fn symbol(self) -> &'static str {
        match self {
            Agreement::Agrees => "=",
            Agreement::Stronger => "+",
            Agreement::NotChecked => "–",
            Agreement::Undecided => "?",
            Agreement::Disagrees => "×",
        }
    }

    /// What it means, in a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Agreement::Agrees => "The claim holds, and is exactly what we find.",
            Agreement::Stronger => "The claim holds, and more is proved.",
            Agreement::NotChecked => "No computation can decide the claim; the note says why.",
            Agreement::Undecided => "Neither a proof nor a refutation was found.",
            Agreement::Disagrees => "A part of the claim is refuted, with a witness.",
        }
    }

    /// How many cells got each verdict.
    fn counted<'a>(cells: impl Iterator<Item = &'a AuditedCell> + Clone) -> Counts {
        Agreement::ALL.map(|a| (a, cells.clone().filter(|cell| cell.agreement == a).count()))
    }
}

/// How many cells got each verdict, from the best to the worst.
pub type Counts = [(Agreement, usize); 5];

/// What we found about one claim.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Finding {
    text: String,
    agreement: Agreement,
    notes: Vec<String>,
    ranges: Option<Ranges>,
    certificates: Vec<String>,
}

/// A claimed range of one parameter and the proved one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ranges {
    /// The parameter.
    pub parameter: String,
    /// Where the claim speaks; empty if its ends are interchanged.
    pub claimed: Region,
    /// Where it is proved.
    pub proved: Region,
    /// Where it is refuted.
    pub refuted: Region,
}

impl Finding {
    fn new(text: impl Into<String>, agreement: Agreement) -> Self {
        let text = text.into();
        Finding { text, agreement, notes: Vec::new(), ranges: None, certificates: Vec::new() }
    }

    /// With the certificates that prove it.
    fn certified(mut self, names: impl IntoIterator<Item = String>) -> Self {
        self.certificates.extend(names);
        self
    }

    /// With one more remark; an empty one is none.
    fn noted(mut self, note: impl Into<String>) -> Self {
        self.notes.extend(Some(note.into()).filter(|note| !note.is_empty()));
        self
    }
}

/// A cell of a table with its verdict.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AuditedCell {
    /// The row of the printed table.
    pub row: String,
    /// The column of the printed table.
    pub column: String,
    /// What the paper prints.
    pub claim: String,
    /// What we find.
    pub finding: String,
    /// How the two agree: the worst over the claims of the cell.
    pub agreement: Agreement,
    /// What proves or refutes the claim, or why nothing does.
    pub evidence: Vec<String>,
    /// Remarks on the printed text.
    pub remarks: Vec<String>,
    /// The ranges, if the cell speaks of one.
    pub ranges: Option<Ranges>,
    /// The names of the certificates that prove the finding.
    pub certificates: Vec<String>,
}

/// A table with its verdicts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AuditedTable {
    /// The table's identifier.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// Where it stands in the paper.
    pub locator: String,
    /// Its cells, in the paper's order.
    pub cells: Vec<AuditedCell>,
}

impl AuditedTable {
    /// How many cells got each verdict.
    pub fn counts(&self) -> Counts {
        Agreement::counted(self.cells.iter())
    }
}

/// The result of an audit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Audit {
    /// The audited tables.
    pub tables: Vec<AuditedTable>,
    /// The highest level of norms that was computed.
    pub level: u32,
    /// The certificates behind the findings, by name.
    pub certificates: CertificateStore,
}

impl Audit {
    /// Checks every claim of the tables. Certificates among the `known` ones that hold are used, others
    /// are searched for. `progress` is called once for each finished cell, from any
    /// thread. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// A claim that cannot be understood: an unknown scheme, a syntax error, a substitution that
    /// makes no sense. The message names table, row and column.
    pub fn new(
        tables: &[Table],
        effort: Effort,
        known: CertificateStore,
        progress: &(dyn Fn() + Sync),
    ) -> Result<Self, Diagnostic> {
        let workbench = Workbench::new(effort, known);
        let cells: Vec<(&Table, &Cell)> =
            tables.iter().flat_map(|t| t.cells.iter().map(move |c| (t, c))).collect();
        let audited: Result<Vec<AuditedCell>, Diagnostic> = in_parallel(&cells, |(table, cell)| {
            let result = audit_cell(&workbench, cell);
            progress();
            result.map_err(|error| located(error, table, cell))
        })
        .into_iter()
        .collect();
        let mut audited = audited?.into_iter();
        let tables = tables.iter().map(|table| AuditedTable {
            id: table.id.clone(),
            title: table.title.clone(),
            locator: table.locator.clone(),
            cells: audited.by_ref().take(table.cells.len()).collect(),
        });
        let tables: Vec<AuditedTable> = tables.collect();
        Ok(Audit { certificates: workbench.used(), tables, level: effort.level })
    }

    /// How many cells got each verdict.
    pub fn counts(&self) -> Counts {
        Agreement::counted(self.tables.iter().flat_map(|table| &table.cells))
    }
}

/// Results in the order of the items, by as many threads as there are processors.
///
/// Plain threads: a cell may wait for a result that another one computes, and a thread of rayon's pool
/// that waits takes up other cells, which may then wait for the first.
fn in_parallel<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let work = || -> Vec<(usize, R)> {
        let indices = std::iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)));
        indices.take_while(|&i| i < items.len()).map(|i| (i, f(&items[i]))).collect()
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut results: Vec<(usize, R)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|w| w.join().expect("no cell panics")).collect()
    });
    results.sort_by_key(|(i, _)| *i);
    results.into_iter().map(|(_, result)| result).collect()
}

fn located(error: Diagnostic, table: &Table, cell: &Cell) -> Diagnostic {
    let place = format!("table {}, row {}, column {}", table.id, cell.row, cell.column);
    error.within(&place)
}

fn audit_cell(workbench: &Workbench, cell: &Cell) -> Result<AuditedCell, Diagnostic> {
    let findings: Result<Vec<Finding>, Diagnostic> = cell
        .claims
        .iter()
        .map(|claim| match claim {
            Claim::NotChecked { reason } => {
                Ok(Finding::new("", Agreement::NotChecked).noted(reason.clone()))
            }
            Claim::Checkable(assertion) => statement::check(workbench, assertion),
        })
        .collect();
    let findings = findings?;
    let remarks = cell.claims.iter().filter_map(|claim| match claim {
        Claim::Checkable(assertion) => assertion.note.as_ref(),
        Claim::NotChecked { .. } => None,
    });
    Ok(AuditedCell {
        row: cell.row.clone(),
        column: cell.column.clone(),
        claim: cell.printed.clone(),
        finding: summarise(&findings),
        agreement: findings.iter().map(|f| f.agreement).max().unwrap_or(Agreement::NotChecked),
        evidence: distinct(findings.iter().flat_map(|finding| &finding.notes)),
        remarks: distinct(remarks),
        certificates: certificates(&findings),
        ranges: findings.into_iter().find_map(|f| f.ranges),
    })
}

/// Texts in their order, each once.
fn distinct<'a>(texts: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut distinct: Vec<String> = Vec::new();
    for text in texts {
        if !distinct.contains(text) {
            distinct.push(text.clone());
        }
    }
    distinct
}

/// The certificates of a cell, each once.
fn certificates(findings: &[Finding]) -> Vec<String> {
    let all: std::collections::BTreeSet<&String> =
        findings.iter().flat_map(|f| &f.certificates).collect();
    all.into_iter().cloned().collect()
}

/// The findings of a cell in one text; several of them in the order of the claims.
fn summarise(findings: &[Finding]) -> String {
    let texts: Vec<&str> = findings.iter().map(|f| f.text.as_str()).collect();
    match texts.split_first() {
        Some((first, rest)) if rest.iter().all(|text| text == first) => (*first).to_string(),
        _ => texts.join("; "),
    }
}
