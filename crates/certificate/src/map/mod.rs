//! Maps: certificates about families of two parameters.
//!
//! | module | noun |
//! |---|---|
//! | `model` | [`MapCertificate`] and its parts, field by field |
//! | `read` | from bytes to a map |
//! | `polygon` | [`Polygon`], [`Line`]: convex polygons and how they are cut |
//! | `form` | polynomials in two variables: polar forms, signs on polygons |
//! | `family` | the symbol, the difference symbol, the matrices on a piece |
//! | `quadratic` | pieces on which quadratic forms prove contraction or expansion |
//! | `positive` | positive definite matrices |
//! | `inequality` | pieces on which the product along a word has a large eigenvalue |
//! | `stability` | where shifts may fail to be stable |
//! | `verify` | [`verify_map`]: all nodes, and what is proved where |

mod family;
mod form;
mod inequality;
mod model;
mod polygon;
mod positive;
mod quadratic;
mod read;
mod stability;
mod verify;

pub use model::*;
pub use polygon::{Line, Polygon};
pub use verify::{Cell, CellVerdict, MapChecker, parts_of_box, verify_map};
