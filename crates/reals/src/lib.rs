//! The real line, exactly.
//!
//! | module | noun |
//! |---|---|
//! | `bernstein` | [`Bernstein`]: a polynomial on an interval, with Descartes' bound on its roots |
//! | `rounded` | [`RoundedBernstein`]: the same in fixed point with a known error |
//! | `isolate` | isolation of all real roots, or of those in an interval |
//! | `algebraic` | [`RealAlgebraic`]: exact comparison, signs of polynomials, enclosures |
//! | `exact_form` | [`ExactForm`]: `p/q`, radicals, `root(POLY, k)` |
//! | `logarithm` | enclosures of logarithms |
//! | `region` | [`Region`]: finite unions of intervals with exact ends, canonical |
//! | `point` | [`Point`]: a point of parameter space with real algebraic coordinates |
//! | `system` | common zeros of two polynomials in two parameters |
//! | `variety` | [`Component`]: pieces of the zero set of several polynomials |
//!
//! No float decides anything; every answer is exact.
//!
//! ```
//! use refinable_algebra::{Polynomial, integer};
//! use refinable_reals::{RealAlgebraic, real_roots};
//! // The critical tension of the four-point scheme: 32ω³ + 4ω - 1 = 0.
//! let p = Polynomial::new([-1, 4, 0, 32].map(integer).to_vec());
//! let roots = real_roots(&p);
//! assert_eq!(roots.len(), 1);
//! assert_eq!(roots[0].decimal(5), "0.19273");
//! assert_eq!(roots[0].exact_form().display("omega"), "root(32*omega^3 + 4*omega - 1, 1)");
//! ```

mod algebraic;
mod bernstein;
mod exact_form;
mod isolate;
mod logarithm;
mod point;
mod region;
mod rounded;
mod system;
mod variety;

pub use algebraic::RealAlgebraic;
pub use bernstein::Bernstein;
pub use exact_form::{ExactForm, Radical};
pub use isolate::{
    common_roots, power_of_two, real_roots, real_roots_between, root_bound_exponent, simple_roots,
};
pub use logarithm::logarithm;
pub use point::Point;
pub use region::{Bound, Interval, Region};
pub use rounded::RoundedBernstein;
pub use system::{common_zeros, has_real_point};
pub use variety::{Component, Unsolved, common_zero_set};
