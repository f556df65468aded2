//! Subdivision rules applied: curves, surfaces, interproximate refinement, limit points.
//!
//! | module | noun |
//! |---|---|
//! | `coordinate` | [`Coordinate`]: floats or exact rationals, one code for both |
//! | `polygon` | [`Polygon`], [`Net`]: control points |
//! | `reading` | [`PointTable`]: control points from text |
//! | `weights`, `step` | [`Weights`]: a rule in numbers, and one step of it |
//! | `ends` | [`Ends`]: what continues an open polygon |
//! | `cascade` | several steps at once, block by block |
//! | `curve`, `surface` | [`refine`], [`Surface`] |
//! | `limit` | [`BasicLimit`]: exact values of limits and their derivatives |
//! | `shape` | [`ShapeVerdict`]: whether limits keep signs, monotonicity, convexity, and the bounds of a step |
//! | `interproximate` | [`Interproximate`]: tensions of their own at every vertex and edge |
//! | `memory` | how much a result may take |
//!
//! Nothing here knows how smooth a scheme is.

mod cascade;
mod coordinate;
mod curve;
mod ends;
mod interproximate;
mod limit;
mod memory;
mod polygon;
mod reading;
mod shape;
mod step;
mod surface;
mod weights;

pub use coordinate::Coordinate;
pub use curve::{refine, refine_to};
pub use ends::Ends;
pub use interproximate::{Interproximate, Tensions};
pub use limit::BasicLimit;
pub use polygon::{ACROSS, ALONG, LARGEST_DIMENSION, Net, Polygon};
pub use reading::PointTable;
pub use shape::{ShapeVerdict, Witness, keeps_steps, preserves};
pub use surface::{Surface, refine_net};
pub use weights::{Stencil, Weights};
