//! Claims joined with findings, and every result as a document.
//!
//! | module | noun |
//! |---|---|
//! | `grid` | [`Document`], [`Grid`], [`Cell`]: tables as data, rendered as md, csv, tex and json |
//! | `latex`, `number` | exact quantities as LaTeX and as JSON |
//! | `show`, `degrees`, `range`, `sharp`, `regularity`, `norm` | one document for each analysis |
//! | `map`, `map_picture` | [`Maps`]: orders of continuity over two parameters, as data and as SVG |
//! | `landscape` | [`HolderMap`]: the Hölder exponent over two parameters, as data and as SVG |
//! | `scan` | [`Scan`]: a quantity at every point of a grid |
//! | `svg`, `frame`, `raster` | what pictures have in common; from SVG to pixels |
//! | `picture` | claimed against proved ranges as SVG |
//! | `audit` | [`Audit`]: the verdict on every cell of a paper's tables |
//! | `families` | [`FamilyMaps`]: pages about the families of two parameters |
//! | `site` | the files of a report directory |
//!
//! Nothing here knows the clock, the terminal or the file system: the same input gives the same
//! bytes on every machine.

mod audit;
mod degrees;
mod families;
mod frame;
mod grid;
mod landscape;
mod latex;
mod map;
mod map_picture;
mod norm;
mod number;
mod picture;
mod range;
mod raster;
mod regularity;
mod scan;
mod sharp;
mod show;
mod site;
mod svg;
mod sweep;

pub use audit::{Agreement, Audit, AuditedCell, AuditedTable, CertificateStore, Effort, Ranges};
pub use degrees::degree_table;
pub use families::{FamilyMaps, MapStore};
pub use grid::{Cell, Document, Grid};
pub use landscape::HolderMap;
pub use map::Maps;
pub use norm::norm_table;
pub use range::range_table;
pub use raster::png;
pub use regularity::{outward, regularity_table};
pub use scan::{Quantity, Scan};
pub use sharp::{proof_text, sharp_range, sharp_range_table, statement};
pub use show::show;
pub use site::{CERTIFICATES, Site, report_site};
pub use sweep::Sweep;
