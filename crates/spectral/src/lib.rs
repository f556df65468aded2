//! The joint spectral radius of sets of matrices that are affine in one variable.
//!
//! | module | noun |
//! |---|---|
//! | `pencil` | [`Pencil`]: the matrices `P_ε + x Q_ε` |
//! | `word` | [`Word`]: products of matrices, necklaces of letters |
//! | `rough`, `schur` | from below: where a product has spectral radius at least one, exactly |
//! | `leading` | which words grow fastest, in floats |
//! | `gauge` | the norm whose ball is a polytope: a linear program, in floats |
//! | `body` | growing a polytope that all matrices map into itself, in floats |
//! | `rounding`, `writing` | from floats to the integers of a certificate |
//! | `seed` | what a polytope begins with |
//! | `recipe` | in which ways it is grown where every word shrinks |
//! | `search` | polytopes on closed intervals and up to exact ends |
//! | `division` | [`divide`]: the line, divided at radius one; [`expanding`]: one side of it; [`decide`] at a single value |
//! | `cover` | polytopes one after the other, from the ends of an interval inwards |
//! | `radius` | [`radius()`](radius()): the radius of one set of matrices |
//! | `plane` | [`PlanePencil`]: matrices that are polynomials in two variables |
//! | `ellipsoid` | ellipsoids that matrices map into each other, in floats |
//! | `quadratic` | symmetric matrices in coordinates, in floats |
//! | `moving` | quadratic forms that move with the point of a polygon, in the integers of a certificate |
//! | `landscape` | [`decay`], [`slowest`]: how words grow over a box, and where they do least |
//! | `outline` | [`outline()`](outline()): a box around the set on which matrices contract |
//! | `partition` | [`partition()`](partition()): polygons of the plane, divided at radius one |
//! | `front`, `geometry` | where the boundary runs through a polygon, in floats |
//! | `work` | what a search may cost |
//! | `float` | from exact numbers to floats and back |
//!
//! This is the one room with floats. They find proofs; a proof counts once the independent checker
//! has accepted it.

mod body;
mod cover;
mod division;
mod ellipsoid;
mod float;
mod front;
mod gauge;
mod geometry;
mod landscape;
mod leading;
mod moving;
mod outline;
mod partition;
mod pencil;
mod plane;
mod quadratic;
mod radius;
mod recipe;
mod rough;
mod rounding;
mod schur;
mod search;
mod seed;
mod word;
mod work;
mod writing;

pub use division::{Constant, Division, Options, decide, divide, expanding};
pub use landscape::{decay, slowest};
pub use outline::{Window, outline};
pub use partition::{Effort, partition};
pub use pencil::Pencil;
pub use plane::PlanePencil;
pub use radius::{Radius, radius};
pub use search::{certificate_end, real_algebraic};
pub use word::Word;
