//! Reading a claims file.
//!
//! Tables and cells are read first, claims second: only then can an error in a claim say in which
//! cell it stands.

use std::collections::HashSet;

use serde::Deserialize;
use toml::Spanned;

use crate::claim::Claim;
use crate::error::{ClaimsError, Place};
use crate::table::{Cell, Table};

/// The format of a claims file; see `docs/claims.md`.
#[derive(Clone, Copy, Debug)]
pub struct Claims;

impl Claims {
    /// Reads the tables of a claims file, in the file's order.
    ///
    /// # Errors
    /// If the text is not TOML or not of the format; see [`ClaimsError`]. Expressions are not
    /// read, so a claim with an unreadable mask is no error here.
    ///
    /// ```
    /// use refinable_papers::Claims;
    ///
    /// let error = Claims::parse("[[table]]\nid = 'mine'\ntitle = 'Mine'\nlocator = 'Table 1'\n");
    /// assert_eq!(error.unwrap_err().to_string(), "table `mine` has no `[[table.cell]]`");
    /// ```
    pub fn parse(text: &str) -> Result<Vec<Table>, ClaimsError> {
        let file: FileFields = toml::from_str(text)?;
        let tables = file
            .table
            .into_iter()
            .map(|fields| fields.into_table(text))
            .collect::<Result<Vec<_>, _>>()?;
        check_tables(&tables)?;
        Ok(tables)
    }
}

/// The file as TOML spells it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileFields {
    #[serde(default)]
    table: Vec<TableFields>,
}

/// A table as TOML spells it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TableFields {
    id: String,
    title: String,
    locator: String,
    #[serde(default)]
    cell: Vec<CellFields>,
}

/// A cell as TOML spells it, its claims unread.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CellFields {
    row: String,
    column: String,
    printed: String,
    #[serde(default)]
    claim: Vec<Spanned<toml::Table>>,
}

impl TableFields {
    fn into_table(self, text: &str) -> Result<Table, ClaimsError> {
        let Self { id, title, locator, cell } = self;
        let cells = cell
            .into_iter()
            .map(|fields| fields.into_cell(&id, text))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Table { id, title, locator, cells })
    }
}

impl CellFields {
    fn into_cell(self, table: &str, text: &str) -> Result<Cell, ClaimsError> {
        let Self { row, column, printed, claim } = self;
        let claims = claim
            .into_iter()
            .map(|fields| {
                let line = line_at(text, fields.span().start);
                Claim::from_fields(fields.into_inner()).map_err(|error| ClaimsError::Claim {
                    place: place(table, &row, &column),
                    line,
                    message: error.to_string().trim_end().to_owned(),
                })
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Cell { row, column, printed, claims })
    }
}

/// The line of a byte of the text, from 1.
fn line_at(text: &str, offset: usize) -> usize {
    text[..offset].matches('\n').count() + 1
}

fn place(table: &str, row: &str, column: &str) -> Place {
    Place { table: table.to_owned(), row: row.to_owned(), column: column.to_owned() }
}

fn check_tables(tables: &[Table]) -> Result<(), ClaimsError> {
    if tables.is_empty() {
        return Err(ClaimsError::NoTable);
    }
    let mut ids = HashSet::new();
    for table in tables {
        let id = &table.id;
        if !is_kebab_case(id) {
            return Err(ClaimsError::TableId { id: id.clone() });
        }
        if !ids.insert(id) {
            return Err(ClaimsError::DuplicateTable { id: id.clone() });
        }
        check_cells(table)?;
    }
    Ok(())
}

fn check_cells(table: &Table) -> Result<(), ClaimsError> {
    if table.cells.is_empty() {
        return Err(ClaimsError::EmptyTable { id: table.id.clone() });
    }
    let mut places = HashSet::new();
    for Cell { row, column, claims, .. } in &table.cells {
        if !places.insert((row, column)) {
            return Err(ClaimsError::DuplicateCell(place(&table.id, row, column)));
        }
        if claims.is_empty() {
            return Err(ClaimsError::EmptyCell(place(&table.id, row, column)));
        }
    }
    Ok(())
}

/// Lower-case words and numbers joined by single hyphens: ids become file names and anchors.
fn is_kebab_case(id: &str) -> bool {
    id.split('-').all(|word| {
        !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit())
    })
}
