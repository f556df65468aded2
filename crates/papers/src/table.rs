//! Tables of cells, the shape in which a paper prints what it claims.

use crate::claim::Claim;

/// A table of a paper, or a list of its theorems laid out as one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// A name in kebab-case, unique in its file.
    pub id: String,
    /// What the table is about.
    pub title: String,
    /// Where the paper prints it.
    pub locator: String,
    /// The cells in the paper's order, at most one for each row and column, at least one in all.
    pub cells: Vec<Cell>,
}

impl Table {
    /// The cell in this row and column, if the paper prints one there.
    pub fn cell(&self, row: &str, column: &str) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.row == row && cell.column == column)
    }
}

/// One printed entry of a table and the claims it makes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The name of the row.
    pub row: String,
    /// The name of the column.
    pub column: String,
    /// What the paper prints, in plain text, misprints included.
    pub printed: String,
    /// What that claims; at least one. The cell stands as far as its weakest claim does.
    pub claims: Vec<Claim>,
}
