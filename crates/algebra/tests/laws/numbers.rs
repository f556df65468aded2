//! Scalars: reading, printing, rounding.

use proptest::prelude::*;
use refinable_algebra::{
    Integer, Ordered, Rational, Ring, binomial, bit_length, clear_denominators, decimal,
    dyadic_floor, integer, integer_square_root, least_common_multiple, parse_rational, rational,
};

use crate::generate::{fraction, whole};

fn power_of_ten(exponent: i64) -> Rational {
    let power = Rational::from(integer(10).power(exponent.unsigned_abs() as u32));
    if exponent < 0 { rational(1, 1) / power } else { power }
}

/// Positive and negative numbers of all sizes, many of them next to a power of ten or on a tie.
fn scattered() -> impl Strategy<Value = Rational> {
    let ratio = (any::<i32>(), 1i64..=i64::from(u32::MAX));
    let ratio = ratio.prop_map(|(p, q)| rational(p.into(), q));
    let near = (0u32..=9, -60i64..=60, any::<bool>()).prop_map(|(k, offset, negative)| {
        let x = Rational::from(integer(10).power(k) + integer(offset));
        if negative { -x } else { x }
    });
    (prop_oneof![ratio, near], -24i64..=24).prop_map(|(x, k)| x * power_of_ten(k))
}

/// A number and so many digits that its rounding may well carry up to the next power of ten.
fn below_a_power_of_ten() -> impl Strategy<Value = (Rational, u32)> {
    (1u32..=12, 0i64..=100, -12i64..=12).prop_map(|(digits, tenths, k)| {
        let power = Rational::from(integer(10).power(digits));
        ((power - rational(tenths, 10)) * power_of_ten(k), digits)
    })
}

/// The `e` with `10^e ≤ |x| < 10^(e+1)`, by trial.
fn decimal_exponent(x: &Rational) -> i64 {
    let size = x.absolute();
    let mut e = 0;
    while size < power_of_ten(e) {
        e -= 1;
    }
    while size >= power_of_ten(e + 1) {
        e += 1;
    }
    e
}

/// The value of `-12.5` or `3.25e-9`.
fn decimal_value(text: &str) -> Rational {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let mantissa = parse_rational(mantissa).expect("a mantissa is a decimal number");
    mantissa * power_of_ten(exponent.parse().expect("an exponent is an integer"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1024))]

    #[test]
    fn a_decimal_is_the_nearest_number_with_so_many_digits(
        (x, digits) in prop_oneof![(scattered(), 1u32..=20), below_a_power_of_ten()],
    ) {
        let text = decimal(&x, digits);
        let rounded = decimal_value(&text);
        if x.is_zero() {
            prop_assert_eq!(text, "0");
            return Ok(());
        }
        let unit = power_of_ten(decimal_exponent(&x) - i64::from(digits) + 1);
        let half = &unit / integer(2);
        let error = (&rounded - &x).absolute();
        prop_assert!((&rounded / unit).is_integer(), "{} has too many digits", text);
        prop_assert!(error <= half, "{} is not the nearest to {}", text, x);
        prop_assert!(error < half || rounded.absolute() > x.absolute(), "a tie goes outwards");
        prop_assert_eq!(text.contains('e'), !(-6..15).contains(&decimal_exponent(&rounded)));
        let mantissa = text.split('e').next().unwrap();
        prop_assert!(!mantissa.contains('.') || !mantissa.ends_with(['0', '.']), "{}", text);
    }
}

proptest! {
    #[test]
    fn a_printed_rational_is_read_back(x in scattered()) {
        prop_assert_eq!(parse_rational(&x.to_string()), Some(x));
    }

    #[test]
    fn a_decimal_number_is_read_exactly(
        negative in any::<bool>(),
        whole in 0i64..=9_999,
        places in 1usize..=8,
        tail in 0i64..=99_999_999,
    ) {
        let tail = tail % 10i64.pow(places as u32);
        let text = format!("{}{whole}.{tail:0places$}", if negative { "-" } else { "" });
        let size = rational(whole, 1) + rational(tail, 10i64.pow(places as u32));
        let expected = if negative { -size } else { size };
        prop_assert_eq!(parse_rational(&text), Some(expected));
    }

    #[test]
    fn the_floor_at_so_many_bits_is_the_largest_below(x in scattered(), bits in 0u32..=40) {
        let floor = dyadic_floor(&x, bits);
        let unit = Rational::new(integer(1), integer(2).power(bits));
        prop_assert!((&floor / &unit).is_integer());
        prop_assert!(floor <= x && x < floor + unit);
    }

    #[test]
    fn an_integer_square_root_is_the_largest_below(n in whole()) {
        let n = n.absolute();
        let root = integer_square_root(&n);
        let next = &root + integer(1);
        prop_assert!(&root * &root <= n && n < &next * &next);
    }

    #[test]
    fn the_bit_length_counts_the_halvings_to_zero(n in whole()) {
        let mut rest = n.absolute();
        let mut halvings = 0;
        while !rest.is_zero() {
            rest /= integer(2);
            halvings += 1;
        }
        prop_assert_eq!(bit_length(&n), halvings);
    }

    #[test]
    fn binomials_form_pascals_triangle(n in 1u32..=60, k in 1u32..=60) {
        let above = binomial(n - 1, k - 1) + binomial(n - 1, k);
        prop_assert_eq!(binomial(n, k), above);
        prop_assert_eq!(binomial(n, 0), integer(1));
    }

    #[test]
    fn the_least_common_multiple_is_the_least(a in 1i64..=60, b in 1i64..=60) {
        let least = (1..).map(|k| k * a).find(|multiple| multiple % b == 0);
        let signed = least_common_multiple(&integer(-a), &integer(b));
        prop_assert_eq!(Some(signed), least.map(integer));
    }

    #[test]
    fn clearing_denominators_takes_the_least_common_one(
        values in proptest::collection::vec(fraction(), 0..=5),
    ) {
        let (common, cleared) = clear_denominators(values.iter());
        let least = (1i64..).map(integer).find(|d| {
            values.iter().all(|v| (v * d).is_integer())
        });
        prop_assert_eq!(Some(&common), least.as_ref());
        let back: Vec<Rational> = cleared
            .into_iter()
            .map(|c: Integer| Rational::new(c, common.clone()))
            .collect();
        prop_assert_eq!(back, values);
    }
}
