//! Proofs about subdivision schemes as data, and an independent checker.
//!
//! | module | noun |
//! |---|---|
//! | `model` | [`Certificate`] and its parts, field by field |
//! | `number` | [`Number`]: rational numbers as they stand in a file |
//! | `error` | [`Unreadable`], [`Invalid`] |
//! | `read`, `limits` | from bytes to a certificate; what is too large |
//! | `verify`, `lemma`, `conclusion` | [`verify`]: all lemmas, what each proves, what follows |
//! | `family` | symbols that are affine in the parameter, difference symbols, matrices |
//! | `norm` | the lemma `norm`, by forms and bisection |
//! | `polytope`, `body`, `orbit`, `position` | the lemma `polytope`: the form, the gauge, the true leading vertices |
//! | `word`, `jury` | the lemma `word`: signs of determinants, eigenvalues and the unit circle |
//! | `stability`, `circle`, `cyclotomic`, `resultant` | the lemma `stable` |
//! | `nonnegative` | the lemma `nonnegative` |
//! | `regularity` | enclosures of binary logarithms |
//! | `real`, `line` | real algebraic numbers; intervals and what they cover |
//! | `roots`, `gcd`, `modular`, `determinant` | isolation, divisors, determinants of polynomials |
//! | `map` | [`MapCertificate`], [`verify_map`]: families of two parameters |
//! | `order`, `fixed` | the order of rational numbers; bounds in fixed point |
//! | `work` | bounded effort |
//!
//! The format is described in `docs/certificates.md`. Of the other crates only the arithmetic of
//! `refinable-algebra` is used, and no float anywhere.

mod body;
mod circle;
mod conclusion;
mod cyclotomic;
mod determinant;
mod error;
mod family;
mod fixed;
mod gcd;
mod jury;
mod lemma;
mod limits;
mod line;
mod map;
mod model;
mod modular;
mod nonnegative;
mod norm;
mod number;
mod orbit;
mod order;
mod polytope;
mod position;
mod read;
mod real;
mod regularity;
mod resultant;
mod roots;
mod stability;
mod verify;
mod word;
mod work;

pub use error::{Invalid, Part, Unreadable};
pub use limits::FILE as LARGEST_FILE;
pub use map::*;
pub use model::*;
pub use number::Number;
pub use verify::{Verified, verify};
