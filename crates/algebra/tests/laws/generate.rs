//! Random algebraic objects, small but not smooth: zeros are frequent, large numbers occur.

use std::collections::BTreeMap;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Integer, Laurent, Matrix, Monomial, Parameter, ParameterPolynomial, Polynomial, Rational, Ring,
    integer, rational,
};

/// The names of the parameters that occur, in their order.
pub const NAMES: [&str; 3] = ["alpha", "beta", "gamma"];

/// A value for every parameter.
pub type Values = BTreeMap<String, Rational>;

/// An integer: often zero, mostly small, sometimes longer than a machine word.
pub fn whole() -> impl Strategy<Value = Integer> {
    prop_oneof![
        2 => Just(integer(0)),
        9 => (-9i64..=9).prop_map(integer),
        1 => any::<(i64, i64)>().prop_map(|(a, b)| integer(a) * integer(b)),
    ]
}

/// A short integer, zero included.
pub fn short() -> impl Strategy<Value = Integer> {
    (-9i64..=9).prop_map(integer)
}

/// A rational number with a short numerator and denominator.
pub fn fraction() -> impl Strategy<Value = Rational> {
    (-9i64..=9, 1i64..=6).prop_map(|(p, q)| rational(p, q))
}

/// A rational number other than zero.
pub fn nonzero_fraction() -> impl Strategy<Value = Rational> {
    fraction().prop_filter("not zero", |x| !x.is_zero())
}

/// A polynomial of degree at most `degree`, zero included.
pub fn polynomial<R: Ring>(
    coefficient: impl Strategy<Value = R>,
    degree: usize,
) -> impl Strategy<Value = Polynomial<R>> {
    vec(coefficient, 0..=degree + 1).prop_map(Polynomial::new)
}

/// A polynomial of degree at most `degree`, not zero.
pub fn nonzero_polynomial<R: Ring>(
    coefficient: impl Strategy<Value = R>,
    degree: usize,
) -> impl Strategy<Value = Polynomial<R>> {
    polynomial(coefficient, degree).prop_filter("not zero", |p| !p.is_zero())
}

/// Two polynomials whose sequence of remainders falls by several degrees at a time: built from its
/// end by `a = quotient · b + remainder`.
pub fn pair_with_degree_gaps() -> impl Strategy<Value = (Polynomial<Integer>, Polynomial<Integer>)>
{
    let quotient = || (vec(-3i64..=3, 1..=3), prop_oneof![Just(1i64), Just(-1), Just(2)]);
    (quotient(), vec(quotient(), 1..=3)).prop_map(|(last, quotients)| {
        let with_leading = |(low, leading): (Vec<i64>, i64)| {
            let coefficients = low.into_iter().chain([leading]);
            Polynomial::new(coefficients.map(integer).collect())
        };
        let start = (with_leading(last), Polynomial::constant(integer(3)));
        let steps = quotients.into_iter().map(with_leading);
        steps.fold(start, |(a, b), quotient| (quotient.times(&a).plus(&b), a))
    })
}

/// A Laurent polynomial with at most `length` coefficients, zero included.
pub fn laurent<R: Ring>(
    coefficient: impl Strategy<Value = R>,
    length: usize,
) -> impl Strategy<Value = Laurent<R>> {
    (-6i64..=6, vec(coefficient, 0..=length)).prop_map(|(lowest, c)| Laurent::new(lowest, c))
}

/// A monomial in the first `parameters` parameters, every exponent at most two.
pub fn monomial(parameters: usize) -> impl Strategy<Value = Monomial> {
    vec(0u32..=2, parameters).prop_map(|exponents| product_of_powers(&exponents))
}

/// `alpha^exponents[0] · beta^exponents[1] · …`
pub fn product_of_powers(exponents: &[u32]) -> Monomial {
    let powers = NAMES.iter().zip(exponents);
    powers.fold(Monomial::one(), |m, (name, &e)| m.times(&Monomial::power(Parameter::new(name), e)))
}

/// A polynomial of at most `terms` terms in the first `parameters` parameters, zero included.
pub fn parameter_polynomial(
    parameters: usize,
    terms: usize,
) -> impl Strategy<Value = ParameterPolynomial> {
    vec((fraction(), monomial(parameters)), 0..=terms).prop_map(|terms| {
        let terms = terms.into_iter();
        terms
            .fold(ParameterPolynomial::zero(), |p, (c, m)| p.plus(&ParameterPolynomial::term(c, m)))
    })
}

/// The same without zero.
pub fn nonzero_parameter_polynomial(
    parameters: usize,
    terms: usize,
) -> impl Strategy<Value = ParameterPolynomial> {
    parameter_polynomial(parameters, terms).prop_filter("not zero", |p| !p.is_zero())
}

/// A value for each of the parameters.
pub fn values() -> impl Strategy<Value = Values> {
    vec(fraction(), NAMES.len()).prop_map(|values| {
        let names = NAMES.iter().map(ToString::to_string);
        names.zip(values).collect()
    })
}

/// A square matrix of size `1..=largest`.
pub fn matrix<R: Ring>(
    entry: impl Strategy<Value = R>,
    largest: usize,
) -> impl Strategy<Value = Matrix<R>> {
    let entries = vec(entry, largest * largest);
    (1..=largest, entries).prop_map(|(n, entries)| square(n, &entries))
}

/// The `n × n` matrix of the first `n²` entries.
pub fn square<R: Ring>(n: usize, entries: &[R]) -> Matrix<R> {
    Matrix::from_fn(n, n, |i, j| entries[i * n + j].clone())
}

/// The value of a polynomial in parameters, term by term.
pub fn value(polynomial: &ParameterPolynomial, values: &Values) -> Rational {
    polynomial
        .terms()
        .map(|(monomial, c)| {
            let powers = monomial.factors().iter();
            powers.fold(c.clone(), |product, (parameter, exponent)| {
                (0..*exponent).fold(product, |product, _| product * &values[parameter.name()])
            })
        })
        .fold(rational(0, 1), |sum, term| sum + term)
}

/// `Π (denominator · x - numerator)` over the given roots.
pub fn with_roots(roots: &[Rational]) -> Polynomial<Integer> {
    roots.iter().fold(Polynomial::one(), |p, root| {
        p.times(&Polynomial::new(vec![-root.numer(), root.denom().clone()]))
    })
}
