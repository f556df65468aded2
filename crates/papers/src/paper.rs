//! The paper transcribed in this crate.

use serde::Deserialize;

use crate::error::ClaimsError;
use crate::file::Claims;
use crate::table::Table;

/// A paper: what it is, and the tables of what it claims.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Paper {
    /// The title.
    pub title: String,
    /// The authors in the paper's order.
    pub authors: Vec<String>,
    /// How to cite it.
    pub citation: String,
    /// How the tables' locators are to be read.
    pub locators: String,
    /// The tables in the paper's order.
    #[serde(skip)]
    pub tables: Vec<Table>,
}

/// The bibliography of Hameed and Mustafa's paper.
const BIBLIOGRAPHY: &str = include_str!("../data/hameed-mustafa/paper.toml");

/// A transcribed table of the same paper.
macro_rules! table {
    ($name:literal) => {
        include_str!(concat!("../data/hameed-mustafa/tables/", $name, ".toml"))
    };
}

/// The transcribed tables, in the paper's order.
const TABLES: [&str; 14] = [
    table!("01-masks-a-even"),
    table!("02-remark-dd"),
    table!("03-masks-a-odd"),
    table!("04-continuity-a-even"),
    table!("05-properties-a-even"),
    table!("06-special-a-even"),
    table!("07-continuity-a-odd"),
    table!("08-properties-a-odd"),
    table!("09-properties-interpolatory"),
    table!("10-theorems"),
    table!("11-norms"),
    table!("12-comparison-dd"),
    table!("13-comparison-all"),
    table!("14-conclusion"),
];

impl Paper {
    /// The paper of Hameed and Mustafa, as transcribed.
    ///
    /// # Errors
    /// If the transcription breaks the format it is written in, which the tests of this crate
    /// rule out for a released version.
    pub fn builtin() -> Result<Self, ClaimsError> {
        let mut paper: Self = toml::from_str(BIBLIOGRAPHY)?;
        for text in TABLES {
            paper.tables.extend(Claims::parse(text)?);
        }
        Ok(paper)
    }

    /// The table with this id, if there is one.
    pub fn table(&self, id: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.id == id)
    }
}
