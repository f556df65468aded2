//! What can be wrong with a claims file.

use std::fmt;

/// Where in a claims file a cell stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The id of the table.
    pub table: String,
    /// The name of the row.
    pub row: String,
    /// The name of the column.
    pub column: String,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "table `{}`, row `{}`, column `{}`", self.table, self.row, self.column)
    }
}

/// Why a claims file could not be read.
#[derive(Clone, Debug, PartialEq)]
pub enum ClaimsError {
    /// The text is not TOML, or a field of a table or a cell is missing, unknown or of the wrong
    /// type; the message has line and column.
    Toml(toml::de::Error),
    /// The file has no table.
    NoTable,
    /// A table's id is not in kebab-case.
    TableId {
        /// The id as written.
        id: String,
    },
    /// Two tables have the same id.
    DuplicateTable {
        /// The id both have.
        id: String,
    },
    /// A table has no cell.
    EmptyTable {
        /// The table's id.
        id: String,
    },
    /// A cell makes no claim.
    EmptyCell(Place),
    /// Two cells of a table stand in the same row and column.
    DuplicateCell(Place),
    /// A field of a claim is missing, unknown or of the wrong type.
    Claim {
        /// The cell that makes the claim.
        place: Place,
        /// The line where the claim begins, from 1.
        line: usize,
        /// What is wrong with it.
        message: String,
    },
}

impl fmt::Display for ClaimsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Toml(error) => write!(f, "{}", error.to_string().trim_end()),
            Self::NoTable => write!(f, "no `[[table]]` in the file"),
            Self::TableId { id } => write!(f, "table id `{id}` is not in kebab-case"),
            Self::DuplicateTable { id } => write!(f, "two tables have the id `{id}`"),
            Self::EmptyTable { id } => write!(f, "table `{id}` has no `[[table.cell]]`"),
            Self::EmptyCell(place) => write!(f, "{place}: no `[[table.cell.claim]]`"),
            Self::DuplicateCell(place) => write!(f, "{place}: the cell occurs twice"),
            Self::Claim { place, line, message } => {
                write!(f, "{place}, claim at line {line}: {message}")
            }
        }
    }
}

impl std::error::Error for ClaimsError {}

impl From<toml::de::Error> for ClaimsError {
    fn from(error: toml::de::Error) -> Self {
        Self::Toml(error)
    }
}
