//! Roots by Descartes' rule against roots by Sturm's theorem.

use std::cmp::Ordering;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Integer, Ordered, Polynomial, Rational, Ring, binomial, integer, rational,
};
use refinable_reals::{
    Bernstein, RoundedBernstein, power_of_two, real_roots, real_roots_between, root_bound_exponent,
};
use refinable_tests::SturmChain;

use crate::generate::{factor, far_below, fraction, poly, polynomial};

/// The value of a Bernstein form at `u`, by its definition.
fn bernstein_value(form: &Bernstein, u: &Rational) -> Rational {
    let coefficients = form.coefficients();
    let n = coefficients.len() as u32 - 1;
    let rest = rational(1, 1) - u;
    (0..=n)
        .map(|k| {
            let c = Rational::from(&coefficients[k as usize] * binomial(n, k));
            c * u.power(k) * rest.power(n - k)
        })
        .fold(rational(0, 1), |sum, term| sum + term)
}

/// The true coefficients of the form, without any scale.
fn bernstein_coefficients(
    p: &Polynomial<Integer>,
    degree: usize,
    lower: &Rational,
    upper: &Rational,
) -> Vec<Rational> {
    let form = Bernstein::new(p, degree, lower, upper);
    let scale = scale(degree, lower, upper);
    let coefficients = form.coefficients().iter();
    coefficients.map(|c| Rational::from(c.clone()) / &scale).collect()
}

/// `degree! q^degree` with `q` the common denominator of the ends.
fn scale(degree: usize, lower: &Rational, upper: &Rational) -> Rational {
    let q = (1i64..).find(|q| [lower, upper].iter().all(|end| (*end * integer(*q)).is_integer()));
    factorial(degree) * rational(q.expect("a common denominator"), 1).power(degree as u32)
}

fn factorial(n: usize) -> Rational {
    (1..=n as i64).fold(rational(1, 1), |product, k| product * integer(k))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    #[test]
    fn there_are_as_many_real_roots_as_sturm_counts(p in polynomial()) {
        prop_assert_eq!(real_roots(&p).len(), SturmChain::of(&p).count());
    }

    #[test]
    fn an_open_interval_holds_as_many_roots_as_sturm_counts(
        p in polynomial(),
        ends in vec((fraction(), fraction()), 4),
    ) {
        let chain = SturmChain::of(&p);
        for (lower, upper) in ends {
            let found = real_roots_between(&p, &lower, &upper);
            prop_assert_eq!(found.len(), chain.count_open(&lower, &upper));
            for root in found {
                let (start, end) = root.bounds();
                prop_assert!(lower <= start && end <= upper);
            }
        }
    }

    #[test]
    fn a_linear_polynomial_has_its_root_strictly_inside(root in fraction(), end in fraction()) {
        let linear = Polynomial::new(vec![-root.numer(), root.denom().clone()]);
        prop_assert!(real_roots_between(&linear, &root, &end).is_empty());
        prop_assert!(real_roots_between(&linear, &end, &root).is_empty());
        let beyond = &root + (&root - &end);
        let found = real_roots_between(&linear, &end, &beyond);
        prop_assert_eq!(found.len(), usize::from(end < root));
    }

    #[test]
    fn an_interval_from_root_to_root_leaves_its_ends_out(
        p in polynomial(),
        (a, b) in (fraction(), fraction()),
        multiplicities in (1u32..=3, 1u32..=3),
    ) {
        prop_assume!(a != b);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let at = |x: &Rational| Polynomial::new(vec![-x.numer(), x.denom().clone()]);
        let ends = at(&lower).power(multiplicities.0).times(&at(&upper).power(multiplicities.1));
        let found = real_roots_between(&p.times(&ends), &lower, &upper);
        prop_assert_eq!(found.len(), SturmChain::of(&p).count_open(&lower, &upper));
    }

    #[test]
    fn the_roots_ascend_and_each_enclosure_holds_exactly_one(
        p in polynomial(),
        bits in 0u32..=40,
    ) {
        let chain = SturmChain::of(&p);
        let width = Rational::new(integer(1), integer(1) << bits);
        for (k, root) in real_roots(&p).iter().enumerate() {
            let (lower, upper) = root.enclosure(&width);
            prop_assert!(lower <= upper && &upper - &lower <= width);
            if lower == upper {
                prop_assert!(chain.has_root(&lower));
                prop_assert_eq!(chain.count_half_open(&far_below(), &lower), k + 1);
            } else {
                prop_assert_eq!(chain.count_open(&lower, &upper), 1);
                prop_assert!(!chain.has_root(&lower) && !chain.has_root(&upper));
                prop_assert_eq!(chain.count_half_open(&far_below(), &lower), k);
            }
        }
    }

    #[test]
    fn every_root_is_smaller_than_the_bound(p in polynomial()) {
        let chain = SturmChain::of(&p);
        let bound = power_of_two(root_bound_exponent(&p));
        prop_assert_eq!(chain.count_open(&-&bound, &bound), chain.count());
    }

    #[test]
    fn rounded_forms_stay_within_their_error(
        polynomials in vec(factor(), 1..=3),
        radius in -4i64..=4,
        mirrored in any::<bool>(),
        path in vec(any::<bool>(), 0..=6),
    ) {
        // The form of 1 shows the unit.
        let one = poly(&[1]);
        let all: Vec<&Polynomial<Integer>> = polynomials.iter().chain([&one]).collect();
        let degree = all.iter().filter_map(|p| p.degree()).max().expect("one has degree 0");
        let (forms, first_error) =
            RoundedBernstein::around_zero(&all, degree, radius, mirrored).unwrap();
        let unit = forms[all.len() - 1].coefficients()[0];
        prop_assert!(unit > 1);
        let side = power_of_two(radius);
        let zero = rational(0, 1);
        let (start, end) = if mirrored { (-side, zero) } else { (zero, side) };
        for (p, mut form) in all.into_iter().zip(forms) {
            let (mut lower, mut upper) = (start.clone(), end.clone());
            for right in &path {
                let middle = (&lower + &upper) / integer(2);
                let (left_half, right_half) = form.split();
                form = if *right { right_half } else { left_half };
                *(if *right { &mut lower } else { &mut upper }) = middle;
            }
            let exact = bernstein_coefficients(p, degree, &lower, &upper);
            let error = first_error + (degree * path.len()) as i128;
            let error = rational(1, 1) * Integer::from(error);
            prop_assert_eq!(form.coefficients().len(), exact.len());
            for (rounded, exact) in form.coefficients().iter().zip(exact) {
                let off = exact * Integer::from(unit) - Rational::from(Integer::from(*rounded));
                prop_assert!(off.absolute() <= error);
            }
        }
    }

    #[test]
    fn sturms_intervals_hold_the_same_roots(p in polynomial()) {
        let intervals = SturmChain::of(&p).isolate(&rational(1, 64));
        let roots = real_roots(&p);
        prop_assert_eq!(roots.len(), intervals.len());
        for (root, (lower, upper)) in roots.iter().zip(intervals) {
            prop_assert!(*root > lower.into() && *root <= upper.into());
        }
    }

    #[test]
    fn the_polynomial_of_a_root_has_this_one_root_between_its_bounds(p in polynomial()) {
        for root in real_roots(&p) {
            let chain = SturmChain::of(&root.polynomial());
            let (lower, upper) = root.bounds();
            prop_assert_eq!(chain.count_closed(&lower, &upper), 1);
            prop_assert_eq!(chain.has_root(&lower), lower == upper);
        }
    }

    #[test]
    fn a_bernstein_form_has_the_values_of_its_polynomial(
        p in polynomial(),
        elevation in 0usize..=2,
        (lower, width) in (fraction(), (1i64..=9, 1i64..=9)),
        u in fraction(),
    ) {
        let degree = p.degree().unwrap() + elevation;
        let width = rational(width.0, width.1);
        let upper = &lower + &width;
        let form = Bernstein::new(&p, degree, &lower, &upper);
        prop_assert_eq!(form.coefficients().len(), degree + 1);
        let value = p.value_at(&(&lower + &width * &u)) * scale(degree, &lower, &upper);
        prop_assert_eq!(bernstein_value(&form, &u), value);
    }

    #[test]
    fn the_halves_of_a_bernstein_form_have_its_values(p in polynomial(), u in fraction()) {
        let degree = p.degree().unwrap();
        let form = Bernstein::new(&p, degree, &rational(-1, 3), &rational(5, 2));
        let (left, right) = form.split();
        let scale = rational(2, 1).power(degree as u32);
        let half = &u / integer(2);
        let expected = bernstein_value(&form, &half) * &scale;
        prop_assert_eq!(bernstein_value(&left, &u), expected);
        let expected = bernstein_value(&form, &(half + rational(1, 2))) * scale;
        prop_assert_eq!(bernstein_value(&right, &u), expected);
    }

    #[test]
    fn the_variations_exceed_the_roots_with_multiplicity_by_an_even_number(
        roots in vec((fraction(), 1u32..=2), 0..=4),
        complex in vec((-4i64..=4, 1i64..=6), 0..=2),
        (a, b) in (fraction(), fraction()),
    ) {
        prop_assume!(a != b);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let mut p = poly(&[1]);
        let mut inside = 0;
        for (root, multiplicity) in &roots {
            let linear = Polynomial::new(vec![-root.numer(), root.denom().clone()]);
            p = p.times(&linear.power(*multiplicity));
            inside += if lower < *root && *root < upper { *multiplicity as usize } else { 0 };
        }
        for (re, im) in complex {
            p = p.times(&poly(&[re * re + im * im, -2 * re, 1]));
        }
        let form = Bernstein::new(&p, p.degree().unwrap(), &lower, &upper);
        prop_assert!(form.variations() >= inside);
        prop_assert_eq!((form.variations() - inside) % 2, 0);
    }

    #[test]
    fn a_constant_sign_is_the_sign_on_the_closed_interval(
        p in polynomial(),
        (a, b) in (fraction(), fraction()),
        u in (0i64..=8).prop_map(|k| rational(k, 8)),
    ) {
        prop_assume!(a != b);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let form = Bernstein::new(&p, p.degree().unwrap(), &lower, &upper);
        if let Some(sign) = form.constant_sign() {
            let x = &lower + (&upper - &lower) * u;
            prop_assert_eq!(p.value_at(&x).cmp(&rational(0, 1)), sign);
            prop_assert_eq!(SturmChain::of(&p).count_closed(&lower, &upper), 0);
        }
        let nothing = Bernstein::new(&Polynomial::zero(), 3, &lower, &upper);
        prop_assert_eq!(nothing.constant_sign(), None);
        // On a short interval away from every root the sign must show.
        if p.value_at(&lower).cmp(&rational(0, 1)) == Ordering::Greater {
            let short = (0u32..).map(|bits| &lower + rational(1, 1) / rational(2, 1).power(bits));
            let mut forms = short.map(|end| Bernstein::new(&p, p.degree().unwrap(), &lower, &end));
            prop_assert!(forms.any(|form| form.constant_sign() == Some(Ordering::Greater)));
        }
    }
}
