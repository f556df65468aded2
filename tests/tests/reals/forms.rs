//! Exact and decimal forms, read back from their text.

use proptest::prelude::*;
use refinable_algebra::{GcdDomain, Ordered, Rational, Ring, integer, parse_rational, rational};
use refinable_reals::{ExactForm, RealAlgebraic, real_roots};
use refinable_tests::{SturmChain, Surd};

use crate::generate::{
    factor, far_below, irrational, poly, polynomial, real, real_among, root_at, surd,
};

fn power_of_ten(exponent: i64) -> Rational {
    let power = Rational::from(integer(10).power(exponent.unsigned_abs() as u32));
    if exponent < 0 { rational(1, 1) / power } else { power }
}

/// The value of `-12.5` or `3.25e-9`.
fn decimal_value(text: &str) -> Rational {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let mantissa = parse_rational(mantissa).expect("a mantissa is a decimal number");
    mantissa * power_of_ten(exponent.parse().expect("an exponent is an integer"))
}

fn absolute(x: &Surd) -> Surd {
    let minus_one = x.constant(rational(-1, 1));
    if x.sign().is_lt() { x.times(&minus_one) } else { x.clone() }
}

/// The unit of the last of `digits` significant digits of a number other than zero.
fn unit(x: &Surd, digits: u32) -> Rational {
    let size = absolute(x);
    let mut e = 0;
    while size.compare_to_rational(&power_of_ten(e)).is_lt() {
        e -= 1;
    }
    while size.compare_to_rational(&power_of_ten(e + 1)).is_ge() {
        e += 1;
    }
    power_of_ten(e - i64::from(digits) + 1)
}

/// Whether `text` is `x` rounded to the nearest multiple of its unit.
fn is_nearest(text: &str, x: &Surd, digits: u32) -> bool {
    let rounded = decimal_value(text);
    let unit = unit(x, digits);
    let half = &unit / integer(2);
    (&rounded / unit).is_integer()
        && x.compare_to_rational(&(&rounded - &half)).is_ge()
        && x.compare_to_rational(&(&rounded + &half)).is_le()
}

/// `a ± √d` with small integers: sums and products of two of them are often near integers.
fn quadratic_integer() -> impl Strategy<Value = Surd> {
    let radicand = prop_oneof![Just(2i64), Just(3), Just(5), Just(6), Just(7), Just(10)];
    (-3i64..=3, any::<bool>(), radicand).prop_map(|(a, minus, d)| {
        let sign = if minus { -1 } else { 1 };
        Surd::new(rational(a, 1), rational(sign, 1), rational(d, 1))
    })
}

/// An irrational number so close to a tie of `digits` digits that only its exact side decides.
fn next_to_a_tie() -> impl Strategy<Value = (Surd, u32)> {
    (1u32..=8, any::<u32>(), 6u32..=24, any::<(bool, bool)>()).prop_map(
        |(digits, seed, distance, (negative, below))| {
            let lowest = 10i64.pow(digits - 1);
            let mantissa = lowest + i64::from(seed) % (9 * lowest);
            let tie = rational(2 * mantissa + 1, 2);
            let step = power_of_ten(-i64::from(digits + distance));
            let tie = if negative { -tie } else { tie };
            let step = if below { -step } else { step };
            (Surd::new(tie, step, rational(2, 1)), digits)
        },
    )
}

#[test]
fn a_quadratic_factor_without_the_number_is_no_form_of_it() {
    // (x² - 2)(x² - 3): -√3 - √2 and -√3 + √2 are not far from integers.
    let product = poly(&[-2, 0, 1]).times(&poly(&[-3, 0, 1]));
    let forms: Vec<String> =
        real_roots(&product).iter().map(|x| x.exact_form().display("x")).collect();
    assert_eq!(forms, ["-sqrt(3)", "-sqrt(2)", "sqrt(2)", "sqrt(3)"]);
    // (x³ - 9)(4x² - 5x - 7): 4 (∛9 + r) is near 5 and 4 ∛9 r near -7 for a root r of the second.
    let product = poly(&[-9, 0, 0, 1]).times(&poly(&[-7, -5, 4]));
    let form = real_roots(&product)[1].exact_form();
    assert!(matches!(form, ExactForm::Root { .. }), "{form:?}");
    // With a convergent p/q of √2 the cubic (x² - 2)(x - m) + q x - p has a root next to √2, within
    // 1/(8 q m), but none next to -√2.
    let (p, q) = (0..30).fold((1i64, 1i64), |(p, q), _| (p + 2 * q, p + q));
    let m = 1 << 24;
    let (two, cubic) = (poly(&[-2, 0, 1]), poly(&[2 * m - p, q - 2, -m, 1]));
    for root in real_roots(&two.times(&cubic)) {
        let is_radical = matches!(root.exact_form(), ExactForm::Radical(_));
        assert_eq!(is_radical, root.sign_of(&two).is_eq());
    }
}

proptest! {
    #[test]
    fn a_number_of_degree_two_is_written_as_a_radical_with_its_value(
        x in irrational(),
        others in factor(),
    ) {
        let form = real_among(&x, &others).exact_form();
        prop_assert!(matches!(form, ExactForm::Radical(_)), "{:?}", form);
        let read = Surd::parse(&form.display("t")).unwrap();
        prop_assert_eq!(read.compare(&x), std::cmp::Ordering::Equal);
        prop_assert!(read.value_of(&x.quadratic()).sign().is_eq());
    }

    #[test]
    fn the_roots_of_two_quadratics_keep_their_own_radicals(
        x in quadratic_integer(),
        y in quadratic_integer(),
    ) {
        let product = x.quadratic().times(&y.quadratic());
        for number in [x, y] {
            let form = root_at(&product, &number).exact_form();
            let read = Surd::parse(&form.display("t"));
            prop_assert!(
                read.is_some_and(|read| read.compare(&number).is_eq()),
                "{:?} for {:?}", form, number
            );
        }
    }

    #[test]
    fn a_radical_is_in_lowest_terms(x in irrational()) {
        let ExactForm::Radical(radical) = real(&x).exact_form() else {
            return Err(TestCaseError::fail("no radical"));
        };
        let (p, c) = (&radical.rational_part, &radical.coefficient);
        let common = GcdDomain::gcd(&GcdDomain::gcd(p, c), &radical.denominator);
        prop_assert_eq!(common, integer(1));
        prop_assert!(radical.denominator.compare_to_zero().is_gt() && !c.is_zero());
        prop_assert!(radical.radicand >= integer(2));
        for k in 2..=30 {
            prop_assert!(!(Rational::from(radical.radicand.clone()) / integer(k * k)).is_integer());
        }
    }

    #[test]
    fn the_form_of_a_number_of_degree_two_does_not_depend_on_its_polynomial(
        x in surd(),
        p in factor(),
        q in factor(),
    ) {
        prop_assert_eq!(real_among(&x, &p).exact_form(), real_among(&x, &q).exact_form());
    }

    #[test]
    fn every_exact_form_names_the_number(p in polynomial()) {
        let chain = SturmChain::of(&p);
        let width = rational(1, 1 << 20);
        for x in real_roots(&p) {
            let (lower, upper) = x.enclosure(&width);
            match x.exact_form() {
                ExactForm::Rational(value) => {
                    prop_assert!(chain.has_root(&value));
                    prop_assert!(lower <= value && value <= upper);
                    prop_assert_eq!(x.exact_form().display("t"), value.to_string());
                }
                ExactForm::Radical(radical) => {
                    let value = Surd::parse(&radical.to_string()).unwrap();
                    prop_assert!(value.value_of(&p).sign().is_eq());
                    prop_assert!(value.compare_to_rational(&lower).is_gt());
                    prop_assert!(value.compare_to_rational(&upper).is_lt());
                }
                ExactForm::Root { polynomial, index } => {
                    let own = SturmChain::of(&polynomial);
                    prop_assert_eq!(own.count_open(&lower, &upper), 1);
                    prop_assert_eq!(own.count_half_open(&far_below(), &lower), index - 1);
                    prop_assert!(polynomial.degree() >= Some(3));
                }
            }
        }
    }

    #[test]
    fn an_irreducible_cubic_is_written_as_a_root(n in 2i64..=200, others in factor()) {
        prop_assume!((2..=5).all(|k| k * k * k != n));
        let cube_root = poly(&[-n, 0, 0, 1]);
        let x = real_roots(&cube_root).remove(0);
        let same = real_roots(&cube_root.times(&others)).into_iter().find(|r| *r == x);
        for x in [Some(x), same] {
            let form = x.expect("a root of the product").exact_form();
            prop_assert!(matches!(form, ExactForm::Root { .. }), "{:?}", form);
        }
    }

    #[test]
    fn the_decimal_of_a_number_is_the_nearest(
        x in surd(),
        others in factor(),
        digits in 1u32..=20,
    ) {
        let text = real_among(&x, &others).decimal(digits);
        if x.sign().is_eq() {
            prop_assert_eq!(text, "0");
        } else {
            prop_assert!(is_nearest(&text, &x, digits), "{} for {:?}", text, x);
        }
    }

    #[test]
    fn the_decimal_of_a_number_next_to_a_tie_is_the_nearest((x, digits) in next_to_a_tie()) {
        let text = real(&x).decimal(digits);
        prop_assert!(is_nearest(&text, &x, digits), "{} for {:?}", text, x);
    }

    #[test]
    fn a_decimal_enclosure_holds_the_number_between_neighbours(
        x in surd(),
        others in factor(),
        digits in 0u32..=20,
    ) {
        let (lower, upper) = real_among(&x, &others).decimal_enclosure(digits);
        prop_assert!(x.compare_to_rational(&lower).is_ge());
        prop_assert!(x.compare_to_rational(&upper).is_le());
        let scale = power_of_ten(digits.into());
        let neighbours = (&lower * &scale).is_integer() && (&upper - &lower) * scale == rational(1, 1);
        prop_assert!(neighbours || x.compare_to_rational(&lower).is_eq() && lower == upper);
    }

    #[test]
    fn the_decimal_of_a_rational_root_is_that_of_the_number(x in surd(), others in factor()) {
        let rational_part = x.constant(x.rational.clone());
        let stored = RealAlgebraic::from(x.rational.clone());
        let hidden = real_among(&rational_part, &others);
        prop_assert_eq!(hidden.decimal(12), stored.decimal(12));
    }
}
