//! Proofs made by hand, of which the truth is known by another road, and files that are none.
//!
//! | module | certificates about |
//! |---|---|
//! | `families` | families that are none, curves, single members, other arities, divisibility |
//! | `norms` | norms of powers of the difference symbol |
//! | `polytopes`, `complex_polytopes`, `moving_polytopes` | invariant polytopes up to ends of all kinds |
//! | `words` | products with real and with complex eigenvalues |
//! | `stability`, `reduced`, `convergence` | roots of unity, masks that are reduced, C^0 in place of C^n |
//! | `regularity` | Hölder exponents |
//! | `mutations` | theorems of which one number is changed |
//! | `hostile` | files that are broken, or too large, or both |
//!
//! `support` makes them.

mod complex_polytopes;
mod convergence;
mod families;
mod hostile;
mod maps;
mod moving_polytopes;
mod mutations;
mod norms;
mod polytopes;
mod reduced;
mod regularity;
mod stability;
mod support;
mod words;
