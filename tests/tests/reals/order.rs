//! Order, equality and signs of real algebraic numbers.

use std::cmp::Ordering;

use proptest::prelude::*;
use refinable_algebra::{Integer, Polynomial, Rational, Ring, integer, rational};
use refinable_reals::{RealAlgebraic, real_roots};
use refinable_tests::{SturmChain, Surd};

use crate::generate::{factor, fraction, irrational, poly, polynomial, real, real_among, surd};

/// The sign of `q` at a root of `p`, by Sturm and Tarski.
fn sign_by_counting(
    p: &Polynomial<Integer>,
    root: &RealAlgebraic,
    q: &Polynomial<Integer>,
) -> Ordering {
    let (lower, upper) = root.bounds();
    if lower == upper {
        return q.value_at(&lower).cmp(&rational(0, 1));
    }
    SturmChain::sign_at_only_root(p, q, &lower, &upper)
}

/// `a + b √2` and a rational number, or another such number, closer to it than the patience of any
/// comparison that refines step by step.
fn close_pair() -> impl Strategy<Value = (Surd, Surd)> {
    (irrational(), 12u32..=80, -3i64..=3).prop_map(|(x, bits, k)| {
        let step = rational(k, 1) / rational(2, 1).power(bits);
        let y = Surd::new(&x.rational + step, x.coefficient.clone(), x.radicand.clone());
        (x, y)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    #[test]
    fn the_order_is_that_of_the_numbers_constructed(
        x in surd(),
        y in surd(),
        others in factor(),
    ) {
        let order = x.compare(&y);
        prop_assert_eq!(real(&x).cmp(&real(&y)), order);
        prop_assert_eq!(real_among(&x, &others).cmp(&real(&y)), order);
        prop_assert_eq!(real(&y) == real(&x), order.is_eq());
    }

    #[test]
    fn a_number_made_from_its_parts_is_that_number(x in surd(), others in factor()) {
        let made = RealAlgebraic::quadratic(&x.rational, &x.coefficient, &x.radicand);
        prop_assert_eq!(made, real_among(&x, &others));
    }

    #[test]
    fn close_numbers_are_told_apart((x, y) in close_pair(), others in factor()) {
        prop_assert_eq!(real(&x).cmp(&real(&y)), x.compare(&y));
        prop_assert_eq!(real_among(&y, &others).cmp(&real(&x)), y.compare(&x));
        // A polynomial with both of them as roots.
        let both = [real_among(&x, &y.quadratic()), real_among(&y, &x.quadratic())];
        prop_assert_eq!(both[0].cmp(&real(&y)), x.compare(&y));
        prop_assert_eq!(both[1].cmp(&real(&x)), y.compare(&x));
        prop_assert_eq!(both[0].cmp(&both[1]), x.compare(&y));
    }

    #[test]
    fn the_order_relative_to_rational_numbers_is_right(
        x in surd(),
        y in fraction(),
        others in factor(),
    ) {
        let expected = x.compare_to_rational(&y);
        prop_assert_eq!(real_among(&x, &others).cmp(&y.clone().into()), expected);
        prop_assert_eq!(RealAlgebraic::from(y).cmp(&real(&x)), expected.reverse());
    }

    #[test]
    fn equal_numbers_from_different_polynomials_are_equal(
        x in surd(),
        p in factor(),
        q in factor(),
    ) {
        prop_assert_eq!(real_among(&x, &p), real_among(&x, &q));
        prop_assert_eq!(real_among(&x, &p).simplified(), real(&x));
    }

    #[test]
    fn the_roots_of_a_product_are_those_of_its_factors(p in polynomial(), q in factor()) {
        let mut united = real_roots(&p);
        united.extend(real_roots(&q));
        united.sort();
        united.dedup();
        prop_assert_eq!(united.len(), SturmChain::of(&p.times(&q)).count());
        prop_assert_eq!(united, real_roots(&p.times(&q)));
    }

    #[test]
    fn the_order_is_total(p in polynomial(), q in factor(), r in factor()) {
        let mut numbers = real_roots(&p);
        numbers.extend(real_roots(&q.times(&r)));
        numbers.extend(real_roots(&r));
        for a in &numbers {
            prop_assert_eq!(a.cmp(a), Ordering::Equal);
            for b in &numbers {
                prop_assert_eq!(a.cmp(b), b.cmp(a).reverse());
                for c in numbers.iter().filter(|_| a <= b) {
                    prop_assert!(b > c || a <= c, "{:?} ≤ {:?} ≤ {:?}", a, b, c);
                }
            }
        }
    }

    #[test]
    fn signs_are_those_that_sturm_and_tarski_count(p in polynomial(), q in polynomial()) {
        for root in real_roots(&p) {
            prop_assert_eq!(root.sign_of(&q), sign_by_counting(&p, &root, &q));
        }
    }

    #[test]
    fn signs_at_roots_of_a_common_factor_are_zero_only_there(
        p in factor(),
        common in factor(),
        q in factor(),
    ) {
        let (p, q) = (p.times(&common), q.times(&common));
        for root in real_roots(&p) {
            let expected = sign_by_counting(&p, &root, &q);
            prop_assert_eq!(root.sign_of(&q), expected);
            if root.sign_of(&common).is_eq() {
                prop_assert_eq!(expected, Ordering::Equal);
            }
        }
    }

    #[test]
    fn signs_at_surds_are_those_of_the_value(
        x in surd(),
        others in factor(),
        q in polynomial(),
    ) {
        let number = real_among(&x, &others);
        prop_assert_eq!(number.sign_of(&q), x.value_of(&q).sign());
        let multiple = q.times(&x.quadratic());
        prop_assert_eq!(number.sign_of(&multiple), Ordering::Equal);
        prop_assert_eq!(number.sign_of(&Polynomial::zero()), Ordering::Equal);
    }

    #[test]
    fn signs_of_values_next_to_zero_are_exact((x, y) in close_pair()) {
        prop_assert_eq!(real(&x).sign_of(&y.quadratic()), x.value_of(&y.quadratic()).sign());
    }

    #[test]
    fn rational_numbers_are_recognised_and_irrational_ones_are_not(
        x in surd(),
        others in factor(),
    ) {
        let simple = real_among(&x, &others).simplified();
        // Nine is the only square among the radicands.
        let nine = x.radicand == rational(9, 1);
        let is_rational = nine || x.coefficient.is_zero();
        let value = &x.rational + &x.coefficient * integer(3);
        prop_assert_eq!(simple.as_rational(), is_rational.then_some(&value));
    }

    #[test]
    fn a_rational_number_between_two_numbers_is_between_them(x in surd(), y in surd()) {
        prop_assume!(x.compare(&y).is_ne());
        let (x, y) = if x.compare(&y).is_lt() { (x, y) } else { (y, x) };
        let between = real(&x).rational_between(&real(&y));
        prop_assert!(x.compare_to_rational(&between).is_lt());
        prop_assert!(y.compare_to_rational(&between).is_gt());
    }

    #[test]
    fn between_close_numbers_there_is_a_rational_one((x, y) in close_pair()) {
        prop_assume!(x.compare(&y).is_lt());
        let between = real(&x).rational_between(&real(&y));
        prop_assert!(x.compare_to_rational(&between).is_lt());
        prop_assert!(y.compare_to_rational(&between).is_gt());
    }

    #[test]
    fn bounds_hold_the_number(x in surd(), others in factor(), bits in 0u32..=60) {
        let width = Rational::new(integer(1), integer(1) << bits);
        let number = real_among(&x, &others);
        for (lower, upper) in [number.bounds(), number.enclosure(&width)] {
            prop_assert!(x.compare_to_rational(&lower).is_ge());
            prop_assert!(x.compare_to_rational(&upper).is_le());
        }
    }
}

#[test]
fn cube_roots_are_ordered_like_their_cubes() {
    let cube_root = |n: i64| real_roots(&poly(&[-n, 0, 0, 1])).remove(0);
    for a in -9..=9 {
        for b in -9..=9 {
            assert_eq!(cube_root(a).cmp(&cube_root(b)), a.cmp(&b));
        }
    }
}
