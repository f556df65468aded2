//! Subdivision schemes before any analysis: masks, symbols and rules, how they are written down,
//! where they come from, and a catalogue.
//!
//! | module | noun |
//! |---|---|
//! | `diagnostic` | [`Diagnostic`], what is wrong with an input, where, and what to write instead |
//! | `expression` | [`Expression`], numbers and names as people type them; `lexer`, `reading`, `parser`, `evaluation` |
//! | `mask` | [`Mask`], the coefficients; `inline` reads them from lists and symbols |
//! | `rule` | [`Rule`], [`Stencil`], what a program applies |
//! | `normalised` | [`Normalised`], a mask whose stencils sum to 1 |
//! | `derivation` | [`Derivation`], the recorded [`Step`]s to a mask, and their replay |
//! | `displacement` | three families by their recursion of displacement vectors |
//! | `narration` | derivations as text: [`Equation`] |
//! | `catalogue` | the schemes that have names |
//! | `construction` | schemes made of numbers, parameters and other schemes |
//! | `scheme` | [`Scheme`], [`Substitution`], what a user means by a line of text |
//! | `file` | [`SchemeFile`]: a scheme with its source and what is expected of it |
//! | `identity` | [`identities`]: which known scheme a mask is |
//! | `quotient`, `budget` | arithmetic on input that nobody has vetted |
//!
//! **Conventions.** `f'_i = Σ_j a_{i-mj} f_j` with arity `m`; the weights of every stencil sum to 1,
//! so a binary mask sums to 2. The symbol is `a(z) = Σ a_i z^i`.
//!
//! ```
//! use refinable_scheme::{Scheme, Substitution};
//! let family = Scheme::resolve("a4", 2).unwrap();
//! let dd4 = family.with(&[Substitution::parse("alpha=0").unwrap()]).unwrap();
//! assert_eq!(dd4.mask(), Scheme::resolve("dd4", 2).unwrap().mask());
//! assert_eq!(dd4.mask(), Scheme::resolve("1/16*[-1, 0, 9, 16, 9, 0, -1]", 2).unwrap().mask());
//! ```

mod budget;
mod catalogue;
mod construction;
mod derivation;
mod diagnostic;
mod displacement;
mod evaluation;
mod expression;
mod file;
mod identity;
mod inline;
mod lexer;
mod mask;
mod narration;
mod normalised;
mod parser;
mod quotient;
mod reading;
mod rule;
mod scheme;
mod substitution;

pub use catalogue::{Entry, catalogue};
pub use construction::{Construction, constructions, tensor_factors};
pub use derivation::{Derivation, Points, Step, Vectors, Weight};
pub use diagnostic::Diagnostic;
pub use displacement::{even_family, interpolatory_family, odd_family};
pub use expression::{Expression, Node, NodeKind};
pub use file::{Expectation, ExpectedRange, SchemeFile};
pub use identity::{Identity, identities};
pub use mask::Mask;
pub use narration::Equation;
pub use normalised::{Normalised, geometric_factor};
pub use rule::{Rule, Stencil};
pub use scheme::Scheme;
pub use substitution::Substitution;
