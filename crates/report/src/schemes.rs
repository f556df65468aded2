//! `schemes`: what can be named.

use refinable_scheme::{catalogue, constructions};
use serde_json::{Value, json};

use crate::grid::{Cell, Document, Grid};

/// The names of the catalogue and the constructions, what they are and where they come from.
pub fn schemes() -> Document {
    let named = catalogue().iter().map(|row| (row.names(), row.description(), Some(row.source())));
    let made = constructions().iter().map(|c| (c.signature().into(), c.description(), c.source()));
    let lines: Vec<(String, &str, Option<&str>)> = named.chain(made).collect();
    let grid = Grid {
        id: "schemes".into(),
        caption: "Schemes that have names, and constructions, which may be nested".into(),
        header: ["name", "scheme", "source"].map(String::from).to_vec(),
        rows: lines
            .iter()
            .map(|(name, description, source)| {
                [name.as_str(), *description, source.unwrap_or("")].map(Cell::text).to_vec()
            })
            .collect(),
        remarks: Vec::new(),
    };
    let object = |(name, description, source): &(String, &str, Option<&str>)| json!({ "name": name, "description": description, "source": source });
    let json = lines.iter().map(object).collect::<Value>();
    Document { grids: vec![grid], summary: None, json: json!({ "schemes": json }) }
}
