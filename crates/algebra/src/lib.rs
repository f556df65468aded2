//! Exact algebra: the ground floor of Refinable.
//!
//! | module | noun |
//! |---|---|
//! | `ring` | the laws: [`Ring`], [`Domain`], [`GcdDomain`], [`Ordered`] |
//! | `number` | the scalars [`Integer`], [`Rational`] (and `i128` as a bounded ring) |
//! | `polynomial` | [`Polynomial`], dense in one variable over any ring |
//! | `division` | remainders, gcd, resultant, square-free part of polynomials |
//! | `modular` | images modulo primes, in which degrees of factors are seen quickly |
//! | `modular_gcd` | the gcd over Z from such images |
//! | `laurent` | [`Laurent`], dense in `z`, with negative exponents |
//! | `parameter` | [`Parameter`], [`Monomial`] |
//! | `parameter_polynomial` | [`ParameterPolynomial`], sparse over Q in named parameters |
//! | `fraction` | [`ParameterFraction`], quotients of those in lowest terms |
//! | `matrix` | [`Matrix`], determinant (Bareiss) and characteristic polynomial (Berkowitz) |
//!
//! Nothing here knows a float, a file or a subdivision scheme.
//!
//! ```
//! use refinable_algebra::{Laurent, Ring, rational};
//! // The cubic B-spline (1+z)^4 / 8, centred at z^0.
//! let a = Laurent::new(-2, [1, 4, 6, 4, 1].map(|c| rational(c, 8)).to_vec());
//! let (quotient, remainder) = a.divide_by_geometric(2, 4);
//! assert!(remainder.is_zero());
//! assert_eq!(quotient, Laurent::new(-2, vec![rational(1, 8)]));
//! ```

mod division;
mod fraction;
mod laurent;
mod matrix;
mod modular;
mod modular_gcd;
mod number;
mod parameter;
mod parameter_polynomial;
mod polynomial;
mod ring;

pub use division::SquareFree;
pub use fraction::{ParameterFraction, Pole};
pub use laurent::Laurent;
pub use matrix::Matrix;
pub use number::{
    Integer, Rational, binomial, bit_length, clear_denominators, decimal, dyadic_floor, integer,
    integer_square_root, least_common_multiple, parse_rational, rational,
};
pub use parameter::{Monomial, Parameter};
pub use parameter_polynomial::ParameterPolynomial;
pub use polynomial::{Polynomial, push_sign};
pub use ring::{Domain, GcdDomain, Ordered, Ring};
