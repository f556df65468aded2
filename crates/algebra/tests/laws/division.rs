//! Division, greatest common divisors, square-free parts.

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Domain, GcdDomain, Integer, Laurent, Ordered, ParameterPolynomial, Polynomial, Rational, Ring,
    SquareFree, integer,
};

use crate::generate::{
    fraction, laurent, nonzero_fraction, nonzero_parameter_polynomial, nonzero_polynomial,
    pair_with_degree_gaps, parameter_polynomial, polynomial, short, whole, with_roots,
};
use crate::resultants::sylvester_determinant;

fn monic(low: Vec<Integer>) -> Polynomial<Integer> {
    let mut coefficients = low;
    coefficients.push(integer(1));
    Polynomial::new(coefficients)
}

/// `1 + z + … + z^(arity-1)`
fn geometric(arity: usize) -> Laurent<Integer> {
    Laurent::new(0, vec![integer(1); arity])
}

/// An irreducible polynomial of degree two, three or four.
fn irreducible() -> impl Strategy<Value = Polynomial<Integer>> {
    let fixed: [&[i64]; 5] =
        [&[1, 0, 1], &[-2, 0, 1], &[1, 1, 3], &[-2, 0, 0, 5], &[1, 0, -10, 0, 1]];
    (0..fixed.len())
        .prop_map(move |k| Polynomial::new(fixed[k].iter().map(|&c| integer(c)).collect()))
}

proptest! {
    #[test]
    fn division_by_a_monic_polynomial_leaves_a_shorter_remainder(
        a in polynomial(whole(), 8),
        low in vec(whole(), 0..=4),
    ) {
        let divisor = monic(low);
        let (quotient, remainder) = a.divide_by_monic(&divisor);
        prop_assert_eq!(quotient.times(&divisor).plus(&remainder), a);
        prop_assert!(remainder.is_zero() || remainder.degree() < divisor.degree());
    }

    #[test]
    fn a_pseudo_remainder_is_short_and_congruent(
        a in nonzero_polynomial(whole(), 8),
        b in nonzero_polynomial(whole(), 4),
    ) {
        let remainder = a.pseudo_remainder(&b);
        let (m, n) = (a.degree().unwrap(), b.degree().unwrap());
        prop_assert!(remainder.degree() < b.degree() || (n == 0 && remainder.is_zero()));
        let factor = b.leading().unwrap().power((m + 1).saturating_sub(n) as u32);
        let multiple = a.scaled(&factor).minus(&remainder);
        prop_assert!(multiple.divide_exactly(&b).is_some());
    }

    #[test]
    fn pseudo_remainders_over_q_are_scaled_remainders(
        quotient in nonzero_polynomial(fraction(), 3),
        b in nonzero_polynomial(fraction(), 3),
        c in polynomial(fraction(), 2),
    ) {
        let n = b.degree().unwrap();
        let remainder = Polynomial::new(c.coefficients().iter().take(n).cloned().collect());
        let a = quotient.times(&b).plus(&remainder);
        let factor = b.leading().unwrap().power(quotient.degree().unwrap() as u32 + 1);
        prop_assert_eq!(a.pseudo_remainder(&b), remainder.scaled(&factor));
    }

    #[test]
    fn exact_division_undoes_products_of_polynomials(
        a in polynomial(whole(), 5),
        b in nonzero_polynomial(whole(), 4),
        c in nonzero_polynomial(whole(), 3),
    ) {
        prop_assert_eq!(a.times(&b).divide_exactly(&b), Some(a.clone()));
        if c.degree() < b.degree() {
            prop_assert_eq!(a.times(&b).plus(&c).divide_exactly(&b), None);
        }
    }

    #[test]
    fn exact_division_undoes_products_of_parameter_polynomials(
        a in parameter_polynomial(3, 4),
        b in nonzero_parameter_polynomial(3, 3),
        c in nonzero_fraction(),
    ) {
        prop_assert_eq!(a.times(&b).divide_exactly(&b), Some(a.clone()));
        if b.as_constant().is_none() {
            let broken = a.times(&b).plus(&ParameterPolynomial::constant(c));
            prop_assert_eq!(broken.divide_exactly(&b), None);
        }
    }

    #[test]
    fn content_and_primitive_part_make_the_polynomial(a in nonzero_polynomial(whole(), 6)) {
        let primitive = a.primitive_part();
        let sign = integer(if a.sign_at_infinity().is_lt() { -1 } else { 1 });
        prop_assert_eq!(primitive.scaled(&(a.content() * sign)), a);
        prop_assert_eq!(primitive.content(), integer(1));
        prop_assert!(primitive.sign_at_infinity().is_gt());
    }

    #[test]
    fn the_gcd_of_multiples_is_the_common_factor_times_the_gcd(
        a in nonzero_polynomial(whole(), 4),
        b in nonzero_polynomial(whole(), 4),
        c in nonzero_polynomial(whole(), 4),
    ) {
        let (ac, bc) = (a.times(&c), b.times(&c));
        let gcd = ac.gcd(&bc);
        let [left, right] = [&ac, &bc].map(|p| p.divide_exactly(&gcd));
        prop_assert!(left.is_some() && right.is_some());
        prop_assert!(gcd.divide_exactly(&c).is_some());
        prop_assert!(left.unwrap().gcd(&right.unwrap()) == Polynomial::one());
        prop_assert!(gcd.sign_at_infinity().is_gt());
        prop_assert_eq!(&gcd, &bc.gcd(&ac));
        if !sylvester_determinant(&a, &b).is_zero() {
            let sign = integer(if c.sign_at_infinity().is_lt() { -1 } else { 1 });
            let content = GcdDomain::gcd(&a.content(), &b.content());
            prop_assert_eq!(gcd, c.scaled(&(content * sign)));
        }
    }

    #[test]
    fn the_gcd_after_degree_gaps_is_the_common_factor(
        (a, b) in pair_with_degree_gaps(),
        c in nonzero_polynomial(short(), 2),
    ) {
        // The sequence ends with the constant 3, so nothing else is common but a content.
        let gcd = a.times(&c).gcd(&b.times(&c));
        prop_assert_eq!(gcd.primitive_part(), c.primitive_part());
        prop_assert_eq!(a.gcd(&b).degree(), Some(0));
    }

    #[test]
    fn the_gcd_of_polynomials_with_known_roots_has_the_common_roots(
        mut a in vec(fraction(), 0..=5),
        mut b in vec(fraction(), 0..=5),
        common in vec(fraction(), 0..=3),
    ) {
        a.extend(common.iter().cloned());
        b.extend(common);
        let gcd = with_roots(&a).gcd(&with_roots(&b));
        // The intersection of multisets.
        let mut left = b;
        a.retain(|root| {
            let found = left.iter().position(|other| other == root);
            found.map(|at| left.swap_remove(at)).is_some()
        });
        prop_assert_eq!(gcd, with_roots(&a));
    }

    #[test]
    fn the_gcd_of_rational_polynomials_is_monic_and_the_common_factor(
        a in nonzero_polynomial(fraction(), 3),
        b in nonzero_polynomial(fraction(), 3),
        c in nonzero_polynomial(fraction(), 3),
    ) {
        let gcd = a.times(&c).gcd(&b.times(&c));
        prop_assert_eq!(gcd.leading(), Some(&Rational::one()));
        if sylvester_determinant(&a, &b).is_zero() {
            prop_assert!(gcd.divide_exactly(&c).is_some());
        } else {
            prop_assert_eq!(gcd.scaled(c.leading().unwrap()), c);
        }
    }

    #[test]
    fn the_gcd_of_parameter_polynomials_divides_both_and_leaves_coprime_parts(
        a in nonzero_parameter_polynomial(2, 3),
        b in nonzero_parameter_polynomial(2, 3),
        c in nonzero_parameter_polynomial(2, 3),
    ) {
        let (ac, bc) = (a.times(&c), b.times(&c));
        let gcd = ac.gcd(&bc);
        let [left, right] = [&ac, &bc].map(|p| p.divide_exactly(&gcd));
        prop_assert!(left.is_some() && right.is_some());
        prop_assert!(gcd.divide_exactly(&c).is_some());
        prop_assert!(left.unwrap().gcd(&right.unwrap()) == ParameterPolynomial::one());
        prop_assert_eq!(gcd.unit_part(), ParameterPolynomial::one());
        prop_assert_eq!(gcd, bc.gcd(&ac));
    }

    #[test]
    fn the_gcd_with_zero_is_the_other_one(a in nonzero_polynomial(whole(), 5)) {
        let zero = Polynomial::zero();
        prop_assert_eq!(a.gcd(&zero), zero.gcd(&a));
        let unit = a.unit_part();
        prop_assert_eq!(a.gcd(&zero).times(&unit), a);
    }

    #[test]
    fn a_factor_is_never_excluded(
        factor in nonzero_polynomial(whole(), 3),
        rest in nonzero_polynomial(whole(), 4),
        slack in 0usize..=1,
    ) {
        prop_assume!(!factor.is_constant());
        let degree = factor.degree().unwrap() + slack;
        prop_assert!(!factor.times(&rest).surely_has_no_factor_up_to(degree));
    }

    #[test]
    fn a_product_of_irreducible_factors_has_no_smaller_ones(
        degree in 3usize..=6,
        multiple in prop_oneof![Just(1i64), Just(-6), Just(35)],
        multiplicity in 1u32..=2,
    ) {
        // x^n - x - 1 is irreducible over Q (Selmer); modulo few primes it has small factors.
        let mut coefficients = vec![integer(0); degree + 1];
        coefficients[0] = integer(-1);
        coefficients[1] = integer(-1);
        coefficients[degree] = integer(1);
        let p = Polynomial::new(coefficients).power(multiplicity).scaled(&integer(multiple));
        prop_assert!(p.surely_has_no_factor_up_to(1));
    }

    #[test]
    fn the_square_free_part_has_each_root_once(
        roots in vec((fraction(), 1u32..=3), 0..=3),
        irreducible in irreducible(),
        multiplicity in 0u32..=2,
        factor in prop_oneof![Just(-6i64), Just(1), Just(35)],
    ) {
        let mut p = irreducible.power(multiplicity).scaled(&integer(factor));
        let mut distinct: Vec<Rational> = Vec::new();
        for (root, multiplicity) in roots {
            p = p.times(&with_roots(std::slice::from_ref(&root)).power(multiplicity));
            if !distinct.contains(&root) {
                distinct.push(root);
            }
        }
        let expected = with_roots(&distinct).times(&irreducible.power(multiplicity.min(1)));
        let part = SquareFree::part_of(&p);
        prop_assert_eq!(part.polynomial(), &expected);
        prop_assert!(part.check_invariants());
    }

    #[test]
    fn the_square_free_part_in_parameters_forgets_multiplicities(
        a in nonzero_parameter_polynomial(2, 2),
        b in nonzero_parameter_polynomial(2, 2),
        multiplicities in (1u32..=2, 1u32..=2),
    ) {
        let p = a.power(multiplicities.0).times(&b.power(multiplicities.1));
        let part = p.square_free_part();
        prop_assert_eq!(&part, &a.times(&b).square_free_part());
        prop_assert!(p.divide_exactly(&part).is_some());
        // Nothing of p is left once the factors of the part are taken out.
        let mut rest = p;
        while rest.as_constant().is_none() {
            let common = rest.gcd(&part);
            prop_assert!(common.as_constant().is_none());
            rest = rest.quotient(&common);
        }
        prop_assert_eq!(&part.square_free_part(), &part);
    }

    #[test]
    fn division_by_powers_of_the_geometric_sum_leaves_a_short_remainder(
        a in laurent(whole(), 14),
        arity in 2usize..=5,
        times in 0usize..=3,
    ) {
        let power = geometric(arity).power(times as u32);
        let (quotient, remainder) = a.divide_by_geometric(arity, times);
        prop_assert_eq!(quotient.times(&power).plus(&remainder), a.clone());
        if let Some((lowest, highest)) = remainder.support() {
            prop_assert!(lowest >= a.lowest());
            prop_assert!(highest - a.lowest() < (times * (arity - 1)) as i64);
        }
        prop_assert!(quotient.is_zero() || quotient.lowest() >= a.lowest());
    }

    #[test]
    fn multiples_of_the_geometric_sum_are_divided_without_remainder(
        quotient in laurent(whole(), 8),
        arity in 2usize..=5,
        times in 1usize..=3,
        error in short(),
        at in 0i64..=2,
    ) {
        let multiple = quotient.times(&geometric(arity).power(times as u32));
        let expected = (quotient, Laurent::zero());
        prop_assert_eq!(multiple.divide_by_geometric(arity, times), expected);
        // Off by one coefficient it is no multiple: z^k is a unit.
        let error = Laurent::monomial(error, at);
        let (_, remainder) = multiple.plus(&error).divide_by_geometric(arity, times);
        prop_assert_eq!(remainder.is_zero(), error.is_zero());
    }

    #[test]
    fn the_geometric_order_is_that_of_the_last_division_without_remainder(
        quotient in laurent(whole(), 8),
        arity in 2usize..=4,
        times in 0usize..=3,
    ) {
        let multiple = quotient.times(&geometric(arity).power(times as u32));
        let Some(order) = multiple.geometric_order(arity) else {
            prop_assert!(quotient.is_zero());
            return Ok(());
        };
        prop_assert!(order >= times);
        prop_assert!(multiple.divide_by_geometric(arity, order).1.is_zero());
        prop_assert!(!multiple.divide_by_geometric(arity, order + 1).1.is_zero());
    }

    #[test]
    fn the_primitive_form_of_a_parameter_polynomial_is_an_integer_polynomial(
        a in nonzero_parameter_polynomial(3, 4),
    ) {
        let (negative, size, primitive) = a.primitive();
        let factor = if negative { -size.clone() } else { size.clone() };
        prop_assert_eq!(primitive.scaled(&factor), a);
        prop_assert!(size.compare_to_zero().is_gt());
        let numerators: Vec<Integer> = primitive.terms().map(|(_, c)| c.numer().clone()).collect();
        prop_assert!(primitive.terms().all(|(_, c)| c.denom() == &integer(1)));
        let content = numerators.iter().fold(integer(0), |g, c| GcdDomain::gcd(&g, c));
        prop_assert_eq!(content, integer(1));
        prop_assert!(numerators.last().unwrap().compare_to_zero().is_gt());
    }
}
