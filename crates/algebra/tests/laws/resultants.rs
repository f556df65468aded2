//! The resultant is the determinant of Sylvester's matrix.

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Domain, Matrix, ParameterPolynomial, Polynomial, Rational, Ring, integer, rational,
};

use crate::generate::{
    fraction, nonzero_parameter_polynomial, nonzero_polynomial, pair_with_degree_gaps,
    parameter_polynomial, short, value, values, whole, with_roots,
};

/// The determinant of the matrix with `deg b` shifted rows of coefficients of `a` above `deg a` of
/// those of `b`; both are nonzero.
pub fn sylvester_determinant<R: Domain>(a: &Polynomial<R>, b: &Polynomial<R>) -> R {
    let (m, n) = (a.degree().unwrap(), b.degree().unwrap());
    let matrix = Matrix::from_fn(m + n, m + n, |i, j| {
        let (p, degree, row) = if i < n { (a, m, i) } else { (b, n, i - n) };
        // Row `row` holds the coefficients in descending order from column `row` on.
        match (degree + row).checked_sub(j) {
            Some(k) if k <= degree => p.coefficient(k),
            _ => R::zero(),
        }
    });
    matrix.determinant()
}

fn over_parameters() -> impl Strategy<Value = Polynomial<ParameterPolynomial>> {
    (vec(parameter_polynomial(2, 2), 0..=2), nonzero_parameter_polynomial(2, 2)).prop_map(
        |(mut coefficients, leading)| {
            coefficients.push(leading);
            Polynomial::new(coefficients)
        },
    )
}

proptest! {
    #[test]
    fn the_resultant_over_z_is_the_sylvester_determinant(
        a in nonzero_polynomial(whole(), 6),
        b in nonzero_polynomial(whole(), 6),
    ) {
        prop_assert_eq!(a.resultant(&b), sylvester_determinant(&a, &b));
    }

    #[test]
    fn the_resultant_after_degree_gaps_is_the_sylvester_determinant(
        (a, b) in pair_with_degree_gaps(),
    ) {
        prop_assert_eq!(a.resultant(&b), sylvester_determinant(&a, &b));
        prop_assert_eq!(b.resultant(&a), sylvester_determinant(&b, &a));
    }

    #[test]
    fn the_resultant_over_q_is_the_sylvester_determinant(
        a in nonzero_polynomial(fraction(), 4),
        b in nonzero_polynomial(fraction(), 4),
    ) {
        prop_assert_eq!(a.resultant(&b), sylvester_determinant(&a, &b));
    }

    #[test]
    fn the_resultant_over_parameters_is_the_sylvester_determinant(
        a in over_parameters(),
        b in over_parameters(),
    ) {
        prop_assert_eq!(a.resultant(&b), sylvester_determinant(&a, &b));
    }

    #[test]
    fn the_resultant_commutes_with_substitution_where_no_degree_drops(
        a in over_parameters(),
        b in over_parameters(),
        values in values(),
    ) {
        let at = |p: &Polynomial<ParameterPolynomial>| p.map(|c| value(c, &values));
        prop_assume!(at(&a).degree() == a.degree() && at(&b).degree() == b.degree());
        prop_assert_eq!(value(&a.resultant(&b), &values), at(&a).resultant(&at(&b)));
    }

    #[test]
    fn the_resultant_is_multiplicative_on_both_sides(
        a in nonzero_polynomial(short(), 3),
        b in nonzero_polynomial(short(), 3),
        c in nonzero_polynomial(short(), 4),
    ) {
        prop_assert_eq!(a.times(&b).resultant(&c), a.resultant(&c) * b.resultant(&c));
        prop_assert_eq!(c.resultant(&a.times(&b)), c.resultant(&a) * c.resultant(&b));
    }

    #[test]
    fn swapping_the_arguments_costs_a_sign_for_each_pair_of_roots(
        a in nonzero_polynomial(short(), 5),
        b in nonzero_polynomial(short(), 5),
    ) {
        let odd = a.degree().unwrap() * b.degree().unwrap() % 2 == 1;
        let sign = integer(if odd { -1 } else { 1 });
        prop_assert_eq!(a.resultant(&b), b.resultant(&a) * sign);
    }

    #[test]
    fn the_resultant_is_the_product_of_values_at_the_roots(
        roots in vec(fraction(), 0..=4),
        b in nonzero_polynomial(short(), 4),
    ) {
        // a = Π (q x - p): Res(a, b) = Π q^deg(b) b(p/q).
        let degree = b.degree().unwrap() as u32;
        let product = roots.iter().fold(rational(1, 1), |product, root| {
            product * Rational::from(root.denom().power(degree)) * b.value_at(root)
        });
        prop_assert_eq!(Rational::from(with_roots(&roots).resultant(&b)), product);
    }

    #[test]
    fn a_common_factor_makes_the_resultant_vanish(
        a in nonzero_polynomial(short(), 3),
        b in nonzero_polynomial(short(), 3),
        root in fraction(),
    ) {
        let common = with_roots(&[root]);
        prop_assert!(a.times(&common).resultant(&b.times(&common)).is_zero());
        prop_assert!(a.resultant(&Polynomial::zero()).is_zero());
    }
}
