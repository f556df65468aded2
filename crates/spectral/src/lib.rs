//! The joint spectral radius of a pencil of matrices.

mod body;
mod division;
mod float;
mod gauge;
mod leading;
mod pencil;
mod radius;
mod rough;
mod rounding;
mod schur;
mod search;
mod word;

pub use division::{Constant, Division, Options, decide, divide};
pub use pencil::Pencil;
pub use radius::{Radius, radius};
pub use search::{certificate_end, real_algebraic};
pub use word::Word;
