//! Oracles: slow, simple algorithms that share nothing with the ones under test.
//!
//! | module | answers | where the project answers it |
//! |---|---|---|
//! | `sturm` | how many real roots, where, the sign of a polynomial at a root ([`SturmChain`]) | `refinable-reals`, by Descartes' rule |
//! | `surd` | the order of numbers with square roots ([`Surd`], [`NestedSurd`]) | `refinable-reals`, by isolating intervals |
//! | `difference` | difference schemes, norms, degrees, by refining data | `refinable-analysis`, by algebra on symbols |
//!
//! From `refinable-algebra` they take the scalars, and [`Polynomial`](refinable_algebra::Polynomial)
//! as a list of coefficients; every algorithm is their own.

mod difference;
mod sturm;
mod surd;

pub use difference::{
    difference_symbol, generation_degree, iterated_norm, refine, refine_unit_sequence,
    reproduction_degree,
};
pub use sturm::SturmChain;
pub use surd::{NestedSurd, Surd};
