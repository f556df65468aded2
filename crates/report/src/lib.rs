//! Claims joined with findings, and every result as a document.
//!
//! | module | noun |
//! |---|---|
//! | `grid` | [`Document`], [`Grid`], [`Cell`]: tables as data, rendered as md, csv, tex and json |
//! | `latex`, `number` | exact quantities as LaTeX and as JSON |
//! | `show`, `degrees`, `range`, `sharp`, `regularity`, `norm` | one document for each analysis |
//! | `shape` | what limits keep of the shape of their data |
//! | `map`, `map_picture` | [`Maps`]: orders of continuity over two parameters, as data and as SVG |
//! | `landscape` | [`HolderMap`]: the Hölder exponent over two parameters, as data and as SVG |
//! | `span` | requests such as `NAME=A..B` |
//! | `scan` | [`Scan`]: a quantity at every point of a grid |
//! | `svg`, `frame`, `raster` | what pictures have in common; from SVG to pixels |
//! | `curve`, `surface`, `basis` | [`Curve`], [`TensorSurface`], [`Basis`]: refined points, limits, as data and as SVG |
//! | `compare`, `analyze` | schemes side by side; one scheme on a page |
//! | `explorer` | [`Explorer`]: a family as one page to explore, with certified verdicts at every point |
//! | `comparison` | the paper's comparison tables rebuilt |
//! | `expect` | [`check`]: what scheme files expect, against what is found |
//! | `export` | [`export()`]: a scheme in another [`Language`]; `dialect`: how languages write polynomials |
//! | `interproximate` | [`Assignment`]: tensions at every control point |
//! | `mesh` | [`Mesh`]: surfaces as OBJ, PLY and STL |
//! | `rule_picture` | sketches of stencils |
//! | `points` | points as text |
//! | `canvas`, `surface_picture` | sheets of panels; shaded faces |
//! | `picture` | claimed against proved ranges as SVG |
//! | `audit` | [`Audit`]: the verdict on every cell of a paper's tables |
//! | `figures` | the paper's figures, drawn anew |
//! | `families` | [`FamilyMaps`]: pages about the families of two parameters |
//! | `html` | the report as pages for people |
//! | `performance`, `growth_picture` | [`Measurements`]: how time grows, and that of others, from committed files |
//! | `site` | the files of a report directory |
//!
//! Nothing here knows the clock, the terminal or the file system: the same input gives the same
//! bytes on every machine.

mod analyze;
mod audit;
mod basis;
mod canvas;
mod compare;
mod comparison;
mod curve;
mod degrees;
mod dialect;
mod expect;
mod explorer;
mod export;
mod families;
mod figures;
mod frame;
mod grid;
mod growth_picture;
mod html;
mod interproximate;
mod landscape;
mod latex;
mod map;
mod map_picture;
mod mesh;
mod norm;
mod number;
mod performance;
mod picture;
mod points;
mod range;
mod raster;
mod regularity;
mod rule_picture;
mod scan;
mod schemes;
mod shape;
mod sharp;
mod show;
mod site;
mod span;
mod surface;
mod surface_picture;
mod svg;
mod sweep;

pub use analyze::analyze;
pub use audit::{
    Agreement, Audit, AuditedCell, AuditedTable, CertificateStore, Counts, Effort, Ranges,
};
pub use basis::Basis;
pub use compare::compare;
pub use curve::{Curve, CurveOptions, extrapolation};
pub use degrees::degree_table;
pub use expect::{Checked, check, check_json, expected_file};
pub use explorer::{Explorer, ExplorerOptions};
pub use export::{Language, export};
pub use families::{FamilyMaps, MapStore};
pub use grid::{Cell, Document, Grid};
pub use interproximate::{
    Assignment, Member, TensionTable, assignment_document, choice_text, tensions_of,
};
pub use landscape::HolderMap;
pub use map::Maps;
pub use mesh::{Mesh, MeshFormat};
pub use norm::norm_table;
pub use performance::Measurements;
pub use points::{net_csv, net_json, polygon_csv, polygon_json};
pub use range::range_table;
pub use raster::png;
pub use regularity::{outward, regularity_table};
pub use rule_picture::rule_picture;
pub use scan::{Quantity, Scan};
pub use schemes::schemes;
pub use sharp::{any_range_table, proof_text, sharp_range, statement};
pub use show::show;
pub use site::{CERTIFICATES, Site, report_site};
pub use surface::TensorSurface;
pub use sweep::Sweep;
