//! Tables as data, and their renderings.

use crate::latex;

/// A cell with its plain and its LaTeX text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cell {
    /// Plain text.
    pub plain: String,
    /// LaTeX, outside math mode.
    pub latex: String,
}

impl Cell {
    /// Text, or a formula in plain notation.
    pub fn text(plain: impl Into<String>) -> Self {
        let plain = plain.into();
        let latex = latex::formula_or_text(&plain);
        Cell { plain, latex }
    }

    /// A name, whatever it looks like.
    pub fn name(plain: impl Into<String>) -> Self {
        let plain = plain.into();
        let latex = latex::escape(&plain);
        Cell { plain, latex }
    }

    /// A formula with its own LaTeX, in math mode.
    pub fn math(plain: impl Into<String>, latex: &str) -> Self {
        Cell { plain: plain.into(), latex: format!("${latex}$") }
    }
}

/// A table: a caption, a header, rows of as many cells, and remarks below.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Grid {
    /// A short identifier, unique among the tables of a document.
    pub id: String,
    /// What the table shows.
    pub caption: String,
    /// Column titles.
    pub header: Vec<String>,
    /// The body.
    pub rows: Vec<Vec<Cell>>,
    /// Sentences below the table.
    pub remarks: Vec<String>,
}

/// A result of a command: tables for people, JSON for programs.
#[derive(Clone, PartialEq, Debug)]
pub struct Document {
    /// The tables; all with the same columns if there are several.
    pub grids: Vec<Grid>,
    /// One line that sums the document up, if it needs one.
    pub summary: Option<String>,
    /// The same as data.
    pub json: serde_json::Value,
}

impl Document {
    /// GitHub-flavoured Markdown.
    pub fn markdown(&self) -> String {
        let mut parts: Vec<String> = self.grids.iter().map(Grid::markdown).collect();
        parts.extend(self.summary.clone().map(|line| format!("{line}\n")));
        parts.join("\n")
    }

    /// Comma-separated values with one header; several tables get a first column `table`.
    pub fn csv(&self) -> String {
        let several = self.grids.len() > 1;
        let mut writer = csv::Writer::from_writer(Vec::new());
        if let Some(first) = self.grids.first() {
            let table = several.then_some("table");
            let header = table.into_iter().chain(first.header.iter().map(String::as_str));
            write_record(&mut writer, header);
        }
        for grid in &self.grids {
            for row in &grid.rows {
                let table = several.then_some(grid.id.as_str());
                let cells = table.into_iter().chain(row.iter().map(|cell| cell.plain.as_str()));
                write_record(&mut writer, cells);
            }
        }
        let bytes = writer.into_inner().expect("writing to memory cannot fail");
        String::from_utf8(bytes).expect("text in, text out")
    }

    /// A fragment of LaTeX with booktabs tables, for `\input` (packages booktabs, longtable, array,
    /// amsmath).
    pub fn latex(&self) -> String {
        let mut parts: Vec<String> = self.grids.iter().map(Grid::latex).collect();
        parts.extend(self.summary.as_ref().map(|line| format!("{}\n", latex::escape(line))));
        parts.join("\n")
    }

    /// Pretty-printed JSON with a final newline.
    pub fn json_text(&self) -> String {
        format!("{:#}\n", self.json)
    }
}

fn write_record<'a>(writer: &mut csv::Writer<Vec<u8>>, fields: impl Iterator<Item = &'a str>) {
    writer.write_record(fields).expect("writing to memory cannot fail");
}

impl Grid {
    fn markdown(&self) -> String {
        let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        let mut text = format!("### {}\n\n", self.caption);
        text.push_str(&line(self.header.clone()));
        text.push_str(&format!("|{}\n", "---|".repeat(self.header.len())));
        for row in &self.rows {
            text.push_str(&line(row.iter().map(|cell| escape_markdown(&cell.plain)).collect()));
        }
        if !self.remarks.is_empty() {
            text.push('\n');
        }
        for remark in &self.remarks {
            text.push_str(&format!("- {}\n", escape_markdown(remark)));
        }
        text
    }

    /// The columns by the characters of their longest cells, neither very narrow nor very wide.
    pub(crate) fn sizes(&self) -> Vec<usize> {
        let longest = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].plain.chars().count());
            // Titles break between words.
            let words = self.header[column].split(' ').map(|word| word.chars().count());
            cells.chain(words).max().unwrap_or(0).clamp(10, 48)
        };
        (0..self.header.len()).map(longest).collect()
    }

    /// Percentages of the line for the columns.
    fn widths(&self) -> Vec<usize> {
        let sizes = self.sizes();
        let total: usize = sizes.iter().sum();
        sizes.iter().map(|size| 88 * size / total).collect()
    }

    fn latex(&self) -> String {
        let column = |percent| {
            format!(">{{\\raggedright\\arraybackslash}}p{{{}\\linewidth}}", two_digits(percent))
        };
        let columns: String = self.widths().into_iter().map(column).collect();
        let header: Vec<String> =
            self.header.iter().map(|title| latex::formula_or_text(title)).collect();
        let mut text = format!(
            "\\begin{{longtable}}{{{}}}\n\\caption{{{}}}\\\\\n\\toprule\n{} \\\\\n\\midrule\n\\endhead\n",
            columns,
            latex::formula_or_text(&self.caption),
            header.join(" & ")
        );
        for row in &self.rows {
            let cells: Vec<&str> = row.iter().map(|cell| cell.latex.as_str()).collect();
            text.push_str(&format!("{} \\\\\n", cells.join(" & ")));
        }
        text.push_str("\\bottomrule\n\\end{longtable}\n");
        for remark in &self.remarks {
            text.push_str(&format!("\\noindent {}\\par\n", latex::escape(remark)));
        }
        text
    }
}

/// `17` as `0.17`.
fn two_digits(percent: usize) -> String {
    format!("0.{percent:02}")
}

fn escape_markdown(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").replace('*', "\\*").replace('_', "\\_")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document() -> Document {
        let grid = Grid {
            id: "g".into(),
            caption: "A grid".into(),
            header: vec!["index".into(), "coefficient".into()],
            rows: vec![vec![Cell::text("0"), Cell::math("1-2*alpha", "1-2\\alpha")]],
            remarks: vec!["a | b".into()],
        };
        Document { grids: vec![grid], summary: None, json: serde_json::json!({"a": 1}) }
    }

    #[test]
    fn markdown_escapes_what_would_break_the_table() {
        assert_eq!(
            document().markdown(),
            "### A grid\n\n| index | coefficient |\n|---|---|\n| 0 | 1-2\\*alpha |\n\n- a \\| b\n"
        );
    }

    #[test]
    fn csv_has_a_table_column_only_for_several_tables() {
        let mut document = document();
        assert_eq!(document.csv(), "index,coefficient\n0,1-2*alpha\n");
        document.grids.push(document.grids[0].clone());
        assert_eq!(document.csv().lines().next(), Some("table,index,coefficient"));
    }
}
