//! What papers on subdivision schemes claim, transcribed as data.
//!
//! A [`Paper`] is a list of [`Table`]s, a table a list of [`Cell`]s, and a cell says what the
//! paper prints and which [`Claim`]s that makes. Masks, parameter values and ends of ranges stay
//! strings: this crate knows no arithmetic, so nothing here can be computed, and a misprint stays
//! a misprint. Whoever audits the claims gives the strings a meaning.
//!
//! What is checked on reading is the structure: unknown fields and kinds, empty tables and cells,
//! and two cells in one place are errors. The format is described field by field in
//! `docs/claims.md`.
//!
//! ```
//! use refinable_papers::{Claim, Paper, Statement};
//!
//! let paper = Paper::builtin()?;
//! let cell = paper.table("continuity-a-even").and_then(|table| table.cell("N=0", "C^0"));
//! let Some(Claim::Checkable(assertion)) = cell.map(|cell| &cell.claims[0]) else {
//!     panic!("the cell makes a checkable claim");
//! };
//! assert_eq!(assertion.scheme, "a2");
//! assert!(matches!(&assertion.statement, Statement::Continuity(claimed) if claimed.order == 0));
//! # Ok::<(), refinable_papers::ClaimsError>(())
//! ```

mod claim;
mod error;
mod file;
mod paper;
mod table;

pub use claim::{
    Assertion, Bound, Claim, ClaimedContinuity, ClaimedDegree, Interval, Over, Statement, Trait,
};
pub use error::{ClaimsError, Place};
pub use file::Claims;
pub use paper::Paper;
pub use table::{Cell, Table};
