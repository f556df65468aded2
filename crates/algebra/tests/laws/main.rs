//! Laws of the algebra under random input; the truth comes by another road wherever there is one.
//!
//! | module | states laws of |
//! |---|---|
//! | `rings` | polynomials, Laurent polynomials, parameter polynomials as rings; evaluation |
//! | `monomials` | monomials and the order of terms |
//! | `division` | quotients, remainders, gcd, square-free part, division by `1 + z + …` |
//! | `resultants` | the resultant, against the Sylvester determinant and products over roots |
//! | `matrices` | determinant and characteristic polynomial, against Leibniz' sum |
//! | `fractions` | quotients of parameter polynomials |
//! | `numbers` | scalars, reading and printing |
//!
//! `generate` makes the input, `expression` computes the value of printed text.

mod division;
mod expression;
mod fractions;
mod generate;
mod matrices;
mod monomials;
mod numbers;
mod resultants;
mod rings;
