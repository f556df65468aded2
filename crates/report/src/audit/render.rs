//! An audit as a document.

use serde_json::{Value, json};

use super::{Audit, AuditedCell, AuditedTable};
use crate::grid::{Cell, Document, Grid};
use crate::number::{intervals, points};

impl Audit {
    /// The whole audit: one table each, and the counts.
    pub fn document(&self) -> Document {
        let grids = self.tables.iter().map(AuditedTable::grid).collect();
        Document { grids, summary: Some(self.summary()), json: self.json() }
    }

    /// `477 cells: 300 agree, …`, in the order of the verdicts.
    pub fn summary(&self) -> String {
        let counts = self.counts();
        let total: usize = counts.iter().map(|(_, n)| n).sum();
        let parts: Vec<String> = counts.iter().map(|(a, n)| format!("{n} {}", a.word())).collect();
        format!("{total} cells: {} (norms up to level {})", parts.join(", "), self.level)
    }

    fn json(&self) -> Value {
        let mut counts = serde_json::Map::new();
        for (agreement, n) in self.counts() {
            counts.insert(agreement.word().into(), n.into());
        }
        json!({
            "level": self.level,
            "counts": counts,
            "tables": self.tables.iter().map(AuditedTable::json).collect::<Vec<_>>(),
        })
    }
}

impl AuditedTable {
    /// The table alone.
    pub fn document(&self) -> Document {
        Document { grids: vec![self.grid()], summary: None, json: self.json() }
    }

    /// The table with a column for each part of the verdict.
    pub fn grid(&self) -> Grid {
        let header = ["row", "column", "claim", "finding", "verdict", "note"];
        Grid {
            id: self.id.clone(),
            caption: format!("{} ({})", self.title, self.locator),
            header: header.map(String::from).to_vec(),
            rows: self.cells.iter().map(AuditedCell::row).collect(),
            remarks: Vec::new(),
        }
    }

    /// The table as data.
    pub fn json(&self) -> Value {
        json!({
            "id": self.id,
            "title": self.title,
            "locator": self.locator,
            "cells": self.cells.iter().map(AuditedCell::json).collect::<Vec<_>>(),
        })
    }
}

impl AuditedCell {
    /// Evidence and remarks in one text.
    fn note(&self) -> String {
        self.evidence.iter().chain(&self.remarks).cloned().collect::<Vec<_>>().join("; ")
    }

    fn row(&self) -> Vec<Cell> {
        let verdict = self.agreement.word();
        let texts = [&self.row, &self.column, &self.claim, &self.finding, verdict, &self.note()];
        texts.map(|text: &str| Cell::text(text)).to_vec()
    }

    fn json(&self) -> Value {
        let mut cell = json!({
            "row": self.row,
            "column": self.column,
            "claim": self.claim,
            "finding": self.finding,
            "agreement": self.agreement.word(),
            "note": self.note(),
        });
        if !self.certificates.is_empty() {
            cell["certificates"] = json!(self.certificates);
        }
        if let Some(ranges) = &self.ranges {
            let parameter = &ranges.parameter;
            cell["parameter"] = json!(parameter);
            cell["claimed"] = json!(intervals(&ranges.claimed, parameter));
            cell["proved"] = json!(intervals(&ranges.proved, parameter));
            cell["refuted"] = json!(intervals(&ranges.refuted, parameter));
            cell["proved_points"] = json!(points(&ranges.proved, parameter));
        }
        cell
    }
}
