//! Monomials are vectors of exponents; their order is the graded lexicographic one.

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::Parameter;

use crate::generate::{NAMES, product_of_powers};

fn exponents() -> impl Strategy<Value = Vec<u32>> {
    vec(0u32..=2, NAMES.len())
}

fn added(a: &[u32], b: &[u32]) -> Vec<u32> {
    a.iter().zip(b).map(|(x, y)| x + y).collect()
}

proptest! {
    #[test]
    fn monomials_are_ordered_by_degree_then_by_the_vector_of_exponents(
        a in exponents(),
        b in exponents(),
    ) {
        let graded = |e: &Vec<u32>| (e.iter().sum::<u32>(), e.clone());
        let order = product_of_powers(&a).cmp(&product_of_powers(&b));
        prop_assert_eq!(order, graded(&a).cmp(&graded(&b)));
    }

    #[test]
    fn a_product_of_monomials_adds_exponents(a in exponents(), b in exponents()) {
        let product = product_of_powers(&a).times(&product_of_powers(&b));
        prop_assert_eq!(&product, &product_of_powers(&added(&a, &b)));
        prop_assert_eq!(product.degree(), added(&a, &b).iter().sum::<u32>());
        for (k, name) in NAMES.iter().enumerate() {
            prop_assert_eq!(product.exponent(&Parameter::new(name)), a[k] + b[k]);
        }
    }

    #[test]
    fn multiplying_both_sides_keeps_the_order(
        a in exponents(),
        b in exponents(),
        c in exponents(),
    ) {
        let before = product_of_powers(&a).cmp(&product_of_powers(&b));
        let [a, b] = [a, b].map(|e| product_of_powers(&added(&e, &c)));
        prop_assert_eq!(a.cmp(&b), before);
    }

    #[test]
    fn without_a_parameter_its_exponent_is_zero_and_the_others_stay(
        exponents in exponents(),
        k in 0..NAMES.len(),
    ) {
        let mut expected = exponents.clone();
        expected[k] = 0;
        let reduced = product_of_powers(&exponents).without(&Parameter::new(NAMES[k]));
        prop_assert_eq!(reduced, product_of_powers(&expected));
    }
}
