//! Proofs made by hand, of which the truth is known by another road, and files that are none.
//!
//! | module | certificates about |
//! |---|---|
//! | `families` | families that are none, curves, single members, other arities, divisibility |
//! | `norms` | norms of powers of the difference symbol |
//! | `polytopes`, `complex_polytopes`, `moving_polytopes` | invariant polytopes up to ends of all kinds |
//! | `words` | products with real and with complex eigenvalues |
//! | `stability`, `reduced` | roots of unity, and masks that are reduced |
//! | `regularity` | Hölder exponents |
//! | `mutations` | theorems of which one number is changed |
//! | `hostile` | files that are broken, or too large, or both |
//!
//! `support` makes them.

mod complex_polytopes;
mod families;
mod hostile;
mod moving_polytopes;
mod mutations;
mod norms;
mod polytopes;
mod reduced;
mod regularity;
mod stability;
mod support;
mod words;
