//! Bounds in fixed point, rounded upwards: integers over `2^SCALE`.

use refinable_algebra::{Integer, Rational, integer};

/// The number of binary places.
pub(crate) const SCALE: u64 = 192;

/// One.
pub(crate) fn one() -> Integer {
    integer(1) << SCALE
}

/// `⌈numerator / denominator · 2^SCALE⌉` for a positive denominator.
pub(crate) fn ratio_up(numerator: &Integer, denominator: &Integer) -> Integer {
    divide_up(&(numerator << SCALE), denominator)
}

/// An upper bound for a rational number.
pub(crate) fn up(x: &Rational) -> Integer {
    ratio_up(x.numer(), x.denom())
}

/// `⌈a / b⌉` for positive `b`.
pub(crate) fn divide_up(a: &Integer, b: &Integer) -> Integer {
    // Division truncates: exact or upwards for negative numbers.
    if *a > integer(0) { (a - 1) / b + 1 } else { a / b }
}

/// An upper bound for the product.
pub(crate) fn times_up(a: &Integer, b: &Integer) -> Integer {
    shift_up(&(a * b), SCALE)
}

/// `⌈a / 2^bits⌉`.
pub(crate) fn shift_up(a: &Integer, bits: u64) -> Integer {
    // The shift of a negative number rounds downwards.
    -((-a) >> bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_rounded_upwards() {
        for a in -9..=9 {
            for b in 1..=4 {
                let exact = Rational::new(integer(a), integer(b));
                assert_eq!(divide_up(&integer(a), &integer(b)), exact.ceil().to_integer());
            }
            let quarter = Rational::new(integer(a), integer(4));
            assert_eq!(shift_up(&integer(a), 2), quarter.ceil().to_integer());
        }
    }
}
