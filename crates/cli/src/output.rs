//! Documents on standard output.

use std::io::{self, IsTerminal, Write};
use std::iter;

use comfy_table::presets::UTF8_HORIZONTAL_ONLY;
use comfy_table::{ContentArrangement, LineStyle, Table, TableStyle};
use indicatif::{ProgressBar, ProgressStyle};
use refinable_report::{Cell, Document, Grid};

use crate::arguments::Format;
use crate::failure::Failure;

/// The width of tables where there is no terminal that has one.
const WIDTH: u16 = 160;
/// A table with more columns is printed with its columns as lines.
const MOST_COLUMNS: usize = 14;
/// Lines above and below the table and under its header, none between the rows.
const STYLE: TableStyle = UTF8_HORIZONTAL_ONLY.row_separator(LineStyle::none());

/// Prints a document in the asked format.
///
/// # Errors
/// A standard output that cannot be written to; a closed pipe is none.
pub fn print(document: &Document, format: Format) -> Result<(), Failure> {
    let text = match format {
        Format::Text => text(document),
        Format::Json => document.json_text(),
        Format::Csv => document.csv(),
        Format::Md => document.markdown(),
        Format::Latex => document.latex(),
    };
    print_text(&text)
}

/// Prints text as it is.
///
/// # Errors
/// As for [`print()`].
pub fn print_text(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::new("output", error.to_string(), "standard output cannot be written to"))
        }
        _ => Ok(()),
    }
}

/// Says something on standard error, in colours where it is a terminal that has them and `NO_COLOR` is not set; where it cannot
/// be written to nothing else can be done.
pub fn say(text: &str) {
    let _ = anstream::stderr().write_all(text.as_bytes());
}

fn text(document: &Document) -> String {
    let mut parts: Vec<String> = document.grids.iter().map(grid).collect();
    parts.extend(document.summary.as_ref().map(|line| format!("{line}\n")));
    parts.join("\n")
}

fn grid(grid: &Grid) -> String {
    let mut table = Table::new();
    table.load_style(STYLE);
    table.set_content_arrangement(ContentArrangement::Dynamic);
    // A terminal that does not know its width says 0.
    if table.width().is_none_or(|width| width == 0) {
        table.set_width(WIDTH);
    }
    let plain = |row: &Vec<Cell>| row.iter().map(|cell| cell.plain.clone()).collect();
    let mut lines: Vec<Vec<String>> =
        iter::once(grid.header.clone()).chain(grid.rows.iter().map(plain)).collect();
    if grid.header.len() > MOST_COLUMNS {
        let column = |k: usize| lines.iter().map(|line| line[k].clone()).collect();
        lines = (0..grid.header.len()).map(column).collect();
    }
    let mut lines = lines.into_iter();
    table.set_header(lines.next().unwrap_or_default());
    table.add_rows(lines);
    let mut text = format!("{}\n{}\n", grid.caption, table.trim_fmt());
    for remark in &grid.remarks {
        text.push_str(&format!("{remark}\n"));
    }
    text
}

/// A progress bar on a terminal, nothing elsewhere.
pub fn progress_bar(count: u64, of: &str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = format!("{{bar:40}} {{pos}}/{{len}} {of}, {{per_sec}}, {{eta}} left");
    let style = ProgressStyle::with_template(&style).expect("the template is well formed");
    ProgressBar::new(count).with_style(style)
}
