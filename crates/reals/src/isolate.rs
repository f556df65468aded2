//! Isolation of real roots.
//!
//! Method: Descartes' rule in Bernstein form with bisection (Vincent-Collins-Akritas). It stops for
//! every square-free polynomial: once an interval is short against the distance between roots, the
//! variations are 0 or 1 (the one- and two-circle theorems of Obreshkoff and Ostrowski; W.
//! Krandick, K. Mehlhorn, *New bounds for the Descartes method*, J. Symb. Comput. 41 (2006)).

use std::sync::Arc;

use refinable_algebra::{
    GcdDomain, Integer, Ordered, Polynomial, Rational, Ring, SquareFree, bit_length, integer,
};

use crate::algebraic::RealAlgebraic;
use crate::bernstein::Bernstein;

/// All distinct real roots, ascending.
///
/// # Panics
/// If the polynomial is zero.
pub fn real_roots(polynomial: &Polynomial<Integer>) -> Vec<RealAlgebraic> {
    assert!(!polynomial.is_zero(), "every number is a root of zero");
    let bound = root_bound(polynomial);
    real_roots_between(polynomial, &-bound.clone(), &bound)
}

/// All distinct real roots, ascending, each in its simplest stored form; none of the zero polynomial.
pub fn simple_roots(polynomial: &Polynomial<Integer>) -> Vec<RealAlgebraic> {
    if polynomial.is_zero() {
        return Vec::new();
    }
    real_roots(polynomial).iter().map(RealAlgebraic::simplified).collect()
}

/// The common real roots of several polynomials that are not all zero.
pub fn common_roots(polynomials: &[Polynomial<Integer>]) -> Vec<RealAlgebraic> {
    simple_roots(&polynomials.iter().fold(Polynomial::zero(), |g, p| g.gcd(p)))
}

/// The distinct roots in the open interval `(lower, upper)`, ascending.
///
/// # Panics
/// If the polynomial is zero.
pub fn real_roots_between(
    polynomial: &Polynomial<Integer>,
    lower: &Rational,
    upper: &Rational,
) -> Vec<RealAlgebraic> {
    assert!(!polynomial.is_zero(), "every number is a root of zero");
    let Some(degree) = polynomial.degree().filter(|d| *d > 0 && lower < upper) else {
        return Vec::new();
    };
    if degree == 1 {
        let root = Rational::new(-polynomial.coefficient(0), polynomial.coefficient(1));
        let inside = *lower < root && root < *upper;
        return if inside { vec![root.into()] } else { Vec::new() };
    }
    let form = Bernstein::new(polynomial, degree, lower, upper);
    match form.variations() {
        0 => Vec::new(),
        // A single simple root; bisection may go on with the polynomial as it is.
        1 => isolate(&Arc::new(polynomial.clone()), form, lower.clone(), upper.clone()),
        _ => {
            let square_free = SquareFree::part_of(polynomial).polynomial().clone();
            let degree = square_free.degree().expect("not zero");
            let form = Bernstein::new(&square_free, degree, lower, upper);
            isolate(&Arc::new(square_free), form, lower.clone(), upper.clone())
        }
    }
}

/// The bisection, left to right, with an explicit stack. Where a root sits on a bisection point it
/// is reported as the rational number it is.
fn isolate(
    polynomial: &Arc<Polynomial<Integer>>,
    form: Bernstein,
    lower: Rational,
    upper: Rational,
) -> Vec<RealAlgebraic> {
    let mut roots = Vec::new();
    let mut todo = vec![Task::Interval(form, lower, upper)];
    while let Some(task) = todo.pop() {
        match task {
            Task::Root(x) => roots.push(RealAlgebraic::from(x)),
            Task::Interval(form, lower, upper) => match form.variations() {
                0 => {}
                1 if ends_differ(&form) => {
                    roots.push(RealAlgebraic::isolated(polynomial.clone(), lower, upper));
                }
                _ => {
                    let middle = (&lower + &upper) / integer(2);
                    let (left, right) = form.split();
                    let on_middle = right.coefficients()[0].is_zero();
                    todo.push(Task::Interval(right, middle.clone(), upper));
                    if on_middle {
                        todo.push(Task::Root(middle.clone()));
                    }
                    todo.push(Task::Interval(left, lower, middle));
                }
            },
        }
    }
    roots
}

enum Task {
    Interval(Bernstein, Rational, Rational),
    Root(Rational),
}

/// Whether the values at both ends are nonzero: with one variation they then have opposite signs.
fn ends_differ(form: &Bernstein) -> bool {
    let b = form.coefficients();
    !b[0].is_zero() && !b[b.len() - 1].is_zero()
}

/// An exponent `e` with all roots inside `(-2^e, 2^e)`: Fujiwara's bound
/// `2 max |c_k / c_n|^(1/(n-k))`, rounded up.
///
/// # Panics
/// If the polynomial is zero.
///
/// # Cost
/// Bit lengths only.
pub fn root_bound_exponent(polynomial: &Polynomial<Integer>) -> i64 {
    let degree = polynomial.degree().expect("every number is a root of zero");
    let leading = polynomial.leading().map_or(1, bit_length) as i64;
    let exponents = polynomial.coefficients().iter().enumerate().take(degree);
    exponents
        .filter(|(_, c)| !c.is_zero())
        // |c_k / c_n| < 2^(bits(c_k) - bits(c_n) + 1)
        .map(|(k, c)| (bit_length(c) as i64 - leading + 1).div_euclid((degree - k) as i64) + 1)
        .max()
        .unwrap_or(0)
        + 1
}

fn root_bound(polynomial: &Polynomial<Integer>) -> Rational {
    power_of_two(root_bound_exponent(polynomial))
}

/// `2^exponent`.
pub fn power_of_two(exponent: i64) -> Rational {
    let power = integer(1) << exponent.unsigned_abs();
    if exponent < 0 { Rational::new(integer(1), power) } else { power.into() }
}

/// Whether `polynomial`, known to have at most one simple root in the open interval and none at
/// its ends, has one.
pub(crate) fn changes_sign(
    polynomial: &Polynomial<Integer>,
    lower: &Rational,
    upper: &Rational,
) -> bool {
    polynomial.sign_at(lower) != polynomial.sign_at(upper)
}

/// The primitive gcd of two integer polynomials.
pub(crate) fn common_part(a: &Polynomial<Integer>, b: &Polynomial<Integer>) -> Polynomial<Integer> {
    let gcd = a.gcd(b).primitive_part();
    debug_assert!(gcd.leading().is_none_or(|c| c.compare_to_zero().is_gt()));
    gcd
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn wilkinson_like_roots_are_found_exactly() {
        let p = (1..=12).fold(poly(&[1]), |p, k| p.times(&poly(&[-k, 3])));
        let expected: Vec<RealAlgebraic> = (1..=12).map(|k| rational(k, 3).into()).collect();
        assert_eq!(real_roots(&p), expected);
    }

    #[test]
    fn multiple_roots_count_once_and_complex_ones_not_at_all() {
        // (x²-2)² (x²+1) x
        let square = poly(&[-2, 0, 1]);
        let p = square.times(&square).times(&poly(&[1, 0, 1])).times(&poly(&[0, 1]));
        let roots = real_roots(&p);
        assert_eq!(roots.len(), 3);
        assert_eq!(roots[1], rational(0, 1).into());
        assert!(
            roots[2] > rational(14142, 10000).into() && roots[2] < rational(14143, 10000).into()
        );
    }

    #[test]
    fn an_open_interval_leaves_its_ends_out() {
        let p = poly(&[0, -1, 0, 1]); // x³ - x
        let roots = real_roots_between(&p, &rational(-1, 1), &rational(1, 1));
        assert_eq!(roots, [RealAlgebraic::from(rational(0, 1))]);
    }

    #[test]
    fn close_roots_are_told_apart() {
        // (2^20 x - 1)(2^20 x - 2)(x² - 2)
        let big = 1 << 20;
        let p = poly(&[-1, big]).times(&poly(&[-2, big])).times(&poly(&[-2, 0, 1]));
        assert_eq!(real_roots(&p).len(), 4);
    }

    #[test]
    fn intervals_leave_out_the_ends_of_lines_and_what_is_empty() {
        let [one, two, three] = [1, 2, 3].map(|n| rational(n, 1));
        let line = poly(&[-2, 1]);
        assert_eq!(real_roots_between(&line, &one, &three), [two.clone().into()]);
        let roots_of = |p: &[i64], lower, upper| real_roots_between(&poly(p), lower, upper).len();
        assert_eq!([roots_of(&[-2, 1], &one, &two), roots_of(&[-2, 1], &two, &three)], [0, 0]);
        assert_eq!([roots_of(&[-2, 1], &three, &one), roots_of(&[-4, 0, 1], &three, &one)], [0, 0]);
        assert_eq!([roots_of(&[-4, 0, 1], &two, &two), roots_of(&[5], &one, &three)], [0, 0]);
    }

    /// `x² - 2` and `(x - 1)(x² - 2)` vanish at `±√2`, and the roots of zero are not listed.
    #[test]
    fn common_roots_are_those_of_all() {
        let square = poly(&[-2, 0, 1]);
        let product = square.times(&poly(&[-1, 1]));
        assert_eq!(common_roots(&[product.clone(), square.clone()]), real_roots(&square));
        assert_eq!(common_roots(&[poly(&[]), square.clone()]), real_roots(&square));
        let simple = simple_roots(&product);
        assert_eq!(simple[1].as_rational(), Some(&rational(1, 1)));
        assert!(simple_roots(&poly(&[])).is_empty());
    }

    /// By hand from Fujiwara's bound with bit lengths: `1000 x² - 3 x + 70` has `⌊(2 - 10 + 1)/1⌋ = -7` and
    /// `⌊(7 - 10 + 1)/2⌋ = -1`, which counts, and two are added.
    #[test]
    fn bounds_of_roots_come_from_bit_lengths() {
        assert_eq!(root_bound_exponent(&poly(&[70, -3, 1000])), 1);
        assert_eq!(root_bound_exponent(&poly(&[-1000, 1])), 12);
        assert_eq!(root_bound_exponent(&poly(&[1, 0, 0, -1 << 20])), -5);
        assert_eq!(root_bound_exponent(&poly(&[5])), 1);
        assert_eq!([-3, 0, 3].map(power_of_two), [rational(1, 8), rational(1, 1), rational(8, 1)]);
    }
}
