//! Random polynomials, and numbers of which the truth is known.

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Integer, Monomial, Parameter, ParameterPolynomial, Polynomial, Rational, Ring, integer,
    rational,
};
use refinable_reals::{RealAlgebraic, real_roots};
use refinable_tests::Surd;

/// The highest degree that occurs; Sturm's chain over Q is slow beyond it.
const DEGREE: usize = 12;

pub fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
    Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
}

/// A number below every root that occurs.
pub fn far_below() -> Rational {
    rational(i64::MIN, 1)
}

/// A rational number with a short numerator and denominator.
pub fn fraction() -> impl Strategy<Value = Rational> {
    (-12i64..=12, 1i64..=8).prop_map(|(p, q)| rational(p, q))
}

/// A polynomial of degree one to eight without any structure.
fn unstructured() -> impl Strategy<Value = Polynomial<Integer>> {
    (vec(-50i64..=50, 1..=8), 1i64..=50).prop_map(|(mut low, leading)| {
        low.push(leading);
        poly(&low)
    })
}

/// Linear factors, square roots, two roots side by side, one root that is nearly double, and
/// anything else of degree up to four.
pub fn factor() -> impl Strategy<Value = Polynomial<Integer>> {
    let anything = (vec(-9i64..=9, 1..=4), 1i64..=5).prop_map(|(mut low, leading)| {
        low.push(leading);
        poly(&low)
    });
    prop_oneof![
        3 => (-12i64..=12, 1i64..=8).prop_map(|(p, q)| poly(&[-p, q])),
        2 => (1i64..=12, 1i64..=4).prop_map(|(n, q)| poly(&[-n, 0, q])),
        2 => (-9i64..=9, 4u32..=24).prop_map(|(p, bits)| {
            let scale = 1i64 << bits;
            poly(&[-p, scale]).times(&poly(&[-p - 1, scale]))
        }),
        1 => (3usize..=5, 2i64..=40).prop_map(|(n, a)| {
            // Mignotte: two roots close to 1/a.
            Polynomial::variable().power(n as u32)
                .minus(&poly(&[-1, a]).power(2).scaled(&integer(2)))
        }),
        3 => anything,
    ]
}

/// A product of factors with multiplicities, with a content and a sign.
fn product() -> impl Strategy<Value = Polynomial<Integer>> {
    let factors = vec((factor(), 1u32..=3), 1..=4);
    (factors, prop_oneof![Just(1i64), Just(-1), Just(-6)]).prop_map(|(factors, unit)| {
        let mut product = poly(&[unit]);
        for (factor, multiplicity) in factors {
            let next = product.times(&factor.power(multiplicity));
            if next.degree() <= Some(DEGREE) {
                product = next;
            }
        }
        product
    })
}

/// A nonzero polynomial of degree at most twelve.
pub fn polynomial() -> impl Strategy<Value = Polynomial<Integer>> {
    prop_oneof![1 => unstructured(), 2 => product()]
}

/// `a + b √d`; rational if `b` is zero or `d` is a square.
pub fn surd() -> impl Strategy<Value = Surd> {
    let radicand = prop_oneof![Just(2i64), Just(3), Just(5), Just(8), Just(9), Just(18), Just(20)];
    (fraction(), -6i64..=6, 1i64..=5, radicand)
        .prop_map(|(a, p, q, d)| Surd::new(a, rational(p, q), rational(d, 1)))
}

/// `a + b √d` that is no rational number.
pub fn irrational() -> impl Strategy<Value = Surd> {
    let radicand = prop_oneof![Just(2i64), Just(3), Just(5), Just(6), Just(8), Just(12)];
    (fraction(), 1i64..=6, 1i64..=5, any::<bool>(), radicand).prop_map(|(a, p, q, minus, d)| {
        let b = rational(if minus { -p } else { p }, q);
        Surd::new(a, b, rational(d, 1))
    })
}

/// The root of `polynomial` that is the given number.
///
/// # Panics
/// If there is none.
pub fn root_at(polynomial: &Polynomial<Integer>, number: &Surd) -> RealAlgebraic {
    let roots = real_roots(polynomial);
    let found = roots.into_iter().find(|root| {
        let (lower, upper) = root.bounds();
        let (after, before) =
            (number.compare_to_rational(&lower), number.compare_to_rational(&upper));
        (after.is_gt() && before.is_lt()) || (after.is_eq() && before.is_eq())
    });
    found.expect("the number is a root of the polynomial")
}

/// The number as a root of its quadratic polynomial.
pub fn real(number: &Surd) -> RealAlgebraic {
    root_at(&number.quadratic(), number)
}

/// The same number as a root of a multiple of that polynomial.
pub fn real_among(number: &Surd, others: &Polynomial<Integer>) -> RealAlgebraic {
    root_at(&number.quadratic().times(others), number)
}

/// The two parameters of the plane.
pub fn plane() -> [Parameter; 2] {
    ["x", "y"].map(Parameter::new)
}

/// A polynomial in one parameter.
pub fn in_parameter(p: &Polynomial<Integer>, parameter: &Parameter) -> ParameterPolynomial {
    let constants = p.map(|c| ParameterPolynomial::constant(Rational::from(c.clone())));
    ParameterPolynomial::from_collected(&constants, parameter)
}

/// A polynomial of at most four terms in the plane, every exponent at most two; zero included.
pub fn plane_polynomial() -> impl Strategy<Value = ParameterPolynomial> {
    let term = (-5i64..=5, 1i64..=3, 0u32..=2, 0u32..=2);
    vec(term, 0..=4).prop_map(|terms| {
        let [x, y] = plane();
        let terms = terms.into_iter();
        terms.fold(ParameterPolynomial::zero(), |sum, (p, q, i, j)| {
            let monomial = Monomial::power(x.clone(), i).times(&Monomial::power(y.clone(), j));
            sum.plus(&ParameterPolynomial::term(rational(p, q), monomial))
        })
    })
}
