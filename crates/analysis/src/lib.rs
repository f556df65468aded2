//! What can be proved about a family of subdivision schemes.
//!
//! | module | noun |
//! |---|---|
//! | `degrees` | [`Degrees`]: generation and reproduction, stratified over the parameters |
//! | `difference` | [`DifferenceSymbol`] `c_n` and its integer form |
//! | `power` | the symbols `c^L` of repeated refinement |
//! | `norm` | [`Norm`] `‖c_n^L‖` as a formula in the parameters, [`PointwiseNorm`] at points |
//! | `piecewise` | [`RowCondition`]: sums of absolute values below a bound, solved exactly |
//! | `sublevel` | where all rows of a norm are below a bound, by branch and bound |
//! | `contractivity` | [`NormRange`]: the exact parameter set that norms prove |
//! | `line`, `rational_map` | [`Line`]: families along a line of masks |
//! | `plane` | [`Plane`]: families of two parameters, as planes of masks |
//! | `level_one` | the polygon that norms at level one prove, of a [`Plane`] |
//! | `map` | [`Map`]: where in a box of two parameters C^n holds and fails, with the certificate |
//! | `area` | [`Area`]: of parts of a map, in the plane of the parameters |
//! | `landscape` | [`Landscape`]: the Hölder exponent over two parameters, and the smoothest members; of one parameter too |
//! | `stability` | where smoothness follows contraction; reduced masks |
//! | `continuity`, `proof` | [`ContinuityRange`]: where C^n holds and fails, with the certificate |
//! | `regularity` | [`Regularity`]: the Hölder exponent of one scheme |
//! | `interproximation` | the exponent at the kept vertices, and the tensions that make it largest |
//! | `classification` | [`Classification`]: interpolatory, approximating, combined, relaxed |
//! | `budget` | [`Budget`]: limits, checked before work starts |

mod area;
mod budget;
mod classification;
mod continuity;
mod contractivity;
mod degrees;
mod difference;
mod interproximation;
mod landscape;
mod level_one;
mod line;
mod map;
mod plane;
mod stability;

mod norm;
mod piecewise;
mod power;
mod proof;
mod rational_map;
mod regularity;
mod sublevel;

pub use area::Area;
pub use budget::Budget;
pub use classification::{Classification, classify};
pub use continuity::{
    ContinuityRange, PointVerdict, Sharpness, along_curve, certified_range, certified_verdict,
    continuity_at, continuity_range, highest_continuity, region_of,
};
pub use contractivity::{NormRange, Work, norm_range, norm_values};
pub use degrees::{Degrees, GenerationDegree, ReproductionDegree, Stratum, degrees};
pub use difference::{ClearedSymbol, DifferenceSymbol};
pub use interproximation::{TensionChoice, interpolating_value, interproximate_tensions};
pub use landscape::{Landscape, Locus, Summit, landscape, smoothest_in};
pub use line::Line;
pub use map::{Fineness, Map, MapVerdict, certified_map, default_window, map};
pub use norm::{Comparison, Norm, NormRow, PointwiseNorm};
pub use piecewise::RowCondition;
pub use plane::Plane;
pub use refinable_spectral::{Options, Window};
pub use regularity::{Regularity, regularity};
