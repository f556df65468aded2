//! Exact analysis of families of subdivision schemes.
//!
//! A scheme is a mask, a family a mask with parameters. This library finds for which values of a parameter
//! the limits are C^n and for which they are not, with both sides proved and the proof as a certificate that
//! a checker of its own reads; degrees of polynomials that are generated and reproduced, for all values of the
//! parameters; and it refines curves and surfaces. Numbers are rational or algebraic throughout; floats search
//! for proofs, and draw.
//!
//! ```
//! use refinable::*;
//!
//! // The interpolatory four-point scheme, its tension w free (Dyn, Gregory and Levin 1987).
//! let family = Scheme::resolve("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 2)?;
//! assert!(family.mask().is_interpolatory());
//!
//! // Lines are reproduced whatever w is, cubics for w = 1/16 alone.
//! let strata = degrees(family.mask()).strata;
//! let reproduced: Vec<usize> = strata.iter().map(|stratum| stratum.reproduction.0).collect();
//! assert_eq!(reproduced, [1, 3]);
//!
//! // C^1 iff 0 < w < w*, with 32 w*^3 + 4 w* = 1 (Hechler, Mößner and Reif 2009).
//! let w = Parameter::new("w");
//! let range = continuity_range(family.name(), family.mask(), &w, 1, &Sharpness::default())?;
//! assert_eq!(range.proved.display("w"), "(0, root(32*w^3 + 4*w - 1, 1))");
//! assert_eq!(range.refuted, range.proved.complement());
//!
//! // The proof is a text of integers, and is read and checked by code that knows nothing of the search.
//! let text = range.certificate.to_json();
//! let certificate = Certificate::read(text.as_bytes()).expect("it has the form of one");
//! assert!(verify(&certificate).is_ok());
//!
//! // A member of the family applied to cubes, exactly: between those of 1 and 2 stands that of 3/2.
//! let member = family.with(&[Substitution::parse("w=1/16")?])?;
//! let cubes = Polygon::new(1, [0, 1, 8, 27].map(|y| rational(y, 1)).to_vec(), false)?;
//! let refined = refine(&cubes, &[&Weights::new(member.mask())?], Ends::Trim)?;
//! assert_eq!(refined.values(), [rational(1, 1), rational(27, 8), rational(8, 1)]);
//! # Ok::<(), Diagnostic>(())
//! ```
//!
//! The [`guide`] goes on from here, chapter by chapter. Each room of the house is a module below; what a newcomer
//! needs of them stands beside. The command line is the package `refinable-cli`.

pub mod guide;

#[doc(no_inline)]
pub use refinable_algebra as algebra;
#[doc(no_inline)]
pub use refinable_analysis as analysis;
#[doc(no_inline)]
pub use refinable_certificate as certificate;
#[doc(no_inline)]
pub use refinable_papers as papers;
#[doc(no_inline)]
pub use refinable_reals as reals;
#[doc(no_inline)]
pub use refinable_refine as refine;
#[doc(no_inline)]
pub use refinable_report as report;
#[doc(no_inline)]
pub use refinable_scheme as scheme;

#[doc(no_inline)]
pub use algebra::{Parameter, Rational, rational};
#[doc(no_inline)]
pub use analysis::{Sharpness, continuity_range, degrees, regularity};
#[doc(no_inline)]
pub use certificate::{Certificate, verify};
#[doc(no_inline)]
pub use reals::{RealAlgebraic, Region};
#[doc(no_inline)]
pub use refinable_refine::{Ends, Polygon, Weights, refine};
#[doc(no_inline)]
pub use scheme::{Diagnostic, Mask, Normalised, Scheme, Substitution};
