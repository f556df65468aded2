//! Real algebraic numbers.

use std::cmp::Ordering;
use std::fmt;
use std::sync::{Arc, OnceLock};

use refinable_algebra::{
    Integer, Ordered, Polynomial, Rational, Ring, bit_length, decimal, integer, rational,
};

use crate::bernstein::Bernstein;
use crate::exact_form::ExactForm;
use crate::isolate::{changes_sign, common_part, real_roots};

/// A real algebraic number: a rational number, or the only root of an integer polynomial in an open
/// interval with rational ends. Immutable; equality and order are those of the numbers.
#[derive(Clone)]
pub struct RealAlgebraic(Form);

#[derive(Clone)]
enum Form {
    Rational(Rational),
    /// The polynomial has exactly one root in the open interval, a simple one, and none at the ends.
    Root {
        polynomial: Arc<Polynomial<Integer>>,
        lower: Rational,
        upper: Rational,
        known: Arc<Known>,
    },
}

/// What has been found out about a number, shared by all its enclosures; it only saves time.
#[derive(Default)]
struct Known {
    rational: OnceLock<Option<Rational>>,
    exact: OnceLock<ExactForm>,
}

/// Halvings before an exact zero test by a gcd; most comparisons are decided long before.
const PATIENCE: u32 = 12;
/// Relative bits of the interval of an irrational number in its simplest form.
const SHARP: u32 = 60;

impl RealAlgebraic {
    /// The only root of `polynomial` in the open interval `(lower, upper)`.
    ///
    /// # Panics
    /// In debug builds, if the signs at the ends are not opposite.
    pub(crate) fn isolated(
        polynomial: Arc<Polynomial<Integer>>,
        lower: Rational,
        upper: Rational,
    ) -> Self {
        debug_assert!(changes_sign(&polynomial, &lower, &upper));
        RealAlgebraic(Form::Root { polynomial, lower, upper, known: Arc::default() })
    }

    /// `p + q √d` for rational `p`, `q` and `d ≥ 0`.
    ///
    /// # Panics
    /// If `d` is negative.
    pub fn quadratic(p: &Rational, q: &Rational, d: &Rational) -> Self {
        assert!(d.compare_to_zero().is_ge(), "the root of a negative number is not real");
        // x² - 2p x + p² - q² d, whose smaller root belongs to the minus sign.
        let constant = p * p - q * q * d;
        let quadratic =
            Polynomial::new(vec![constant, p * integer(-2), Rational::from(integer(1))]);
        let roots = real_roots(&quadratic.cleared().1);
        let root = if q.compare_to_zero().is_lt() { roots.first() } else { roots.last() };
        root.expect("the discriminant 4 q² d is not negative").simplified()
    }

    /// The number if it is stored as a rational one; see [`simplified`](Self::simplified).
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.0 {
            Form::Rational(x) => Some(x),
            Form::Root { .. } => None,
        }
    }

    /// An integer polynomial of which the number is a root.
    pub fn polynomial(&self) -> Polynomial<Integer> {
        match &self.0 {
            Form::Rational(x) => Polynomial::new(vec![-x.numer(), x.denom().clone()]),
            Form::Root { polynomial, .. } => polynomial.primitive_part(),
        }
    }

    /// Rational bounds `lower ≤ self ≤ upper`; equal iff the number is stored as rational.
    pub fn bounds(&self) -> (Rational, Rational) {
        match &self.0 {
            Form::Rational(x) => (x.clone(), x.clone()),
            Form::Root { lower, upper, .. } => (lower.clone(), upper.clone()),
        }
    }

    /// Bounds at most `width` apart.
    ///
    /// # Panics
    /// If `width` is not positive.
    ///
    /// # Cost
    /// One evaluation of the polynomial per halving.
    pub fn enclosure(&self, width: &Rational) -> (Rational, Rational) {
        assert!(width.compare_to_zero().is_gt(), "an enclosure needs a positive width");
        self.refined_until(|lower, upper| upper - lower <= *width).bounds()
    }

    /// Bounds whose distance is at most `2^-bits` of either.
    ///
    /// # Panics
    /// If the number is zero.
    ///
    /// # Cost
    /// One evaluation of the polynomial per halving.
    pub fn relative_enclosure(&self, bits: u32) -> (Rational, Rational) {
        assert!(*self != Rational::zero().into(), "zero has no leading bits");
        let scale = Rational::from(integer(1) << bits);
        let enough = |lower: &Rational, upper: &Rational| {
            let least = lower.absolute().min(upper.absolute());
            lower.compare_to_zero() == upper.compare_to_zero() && (upper - lower) * &scale <= least
        };
        self.refined_until(enough).bounds()
    }

    /// The same number with a tighter interval, halved until `enough(lower, upper)`.
    pub(crate) fn refined_until(&self, enough: impl Fn(&Rational, &Rational) -> bool) -> Self {
        let mut current = self.clone();
        loop {
            match &current.0 {
                Form::Root { lower, upper, .. } if !enough(lower, upper) => {
                    current = current.halved();
                }
                _ => return current,
            }
        }
    }

    /// One bisection step.
    pub(crate) fn halved(&self) -> Self {
        let Form::Root { polynomial, lower, upper, known } = &self.0 else {
            return self.clone();
        };
        let middle = (lower + upper) / integer(2);
        let sign = polynomial.sign_at(&middle);
        if sign.is_eq() {
            return middle.into();
        }
        let (lower, upper) = if sign == polynomial.sign_at(lower) {
            (middle, upper.clone())
        } else {
            (lower.clone(), middle)
        };
        let (polynomial, known) = (polynomial.clone(), known.clone());
        RealAlgebraic(Form::Root { polynomial, lower, upper, known })
    }

    /// The number in rational form if it is rational; else with an interval short enough for most
    /// further questions.
    pub fn simplified(&self) -> Self {
        let Form::Root { polynomial, known, .. } = &self.0 else {
            return self.clone();
        };
        match known.rational.get_or_init(|| self.rational_value(polynomial)) {
            Some(x) => x.clone().into(),
            None => self.refined_until(|lower, upper| {
                (upper - lower) * integer(1 << SHARP) <= lower.absolute().min(upper.absolute())
            }),
        }
    }

    /// A root `p/q` of a polynomial with leading coefficient `c` has `q | c`, so `c · self` is the
    /// only integer in a short enough interval.
    fn rational_value(&self, polynomial: &Polynomial<Integer>) -> Option<Rational> {
        if polynomial.surely_has_no_factor_up_to(1) {
            return None;
        }
        let leading = Rational::from(polynomial.leading().expect("not zero").absolute());
        let one = rational(1, 1);
        let narrow = self.refined_until(|lower, upper| (upper - lower) * &leading < one);
        let (lower, upper) = narrow.bounds();
        let candidate = (&upper * &leading).floor() / leading;
        let inside = lower <= candidate && candidate <= upper;
        (inside && polynomial.sign_at(&candidate).is_eq()).then_some(candidate)
    }

    /// The exact sign of `polynomial` at this number.
    ///
    /// # Cost
    /// Usually a few Bernstein forms on shrinking intervals; a gcd only when the value is, or is
    /// extremely close to, zero.
    pub fn sign_of(&self, polynomial: &Polynomial<Integer>) -> Ordering {
        let Some(degree) = polynomial.degree() else {
            return Ordering::Equal;
        };
        let mut x = self.clone();
        for step in 0.. {
            let (lower, upper) = match &x.0 {
                Form::Rational(x) => return polynomial.sign_at(x),
                Form::Root { lower, upper, .. } => (lower, upper),
            };
            let form = Bernstein::new(polynomial, degree, lower, upper);
            if let Some(sign) = form.constant_sign() {
                return sign;
            }
            if step == PATIENCE && x.is_root_of(polynomial) {
                return Ordering::Equal;
            }
            x = x.halved();
        }
        unreachable!("a nonzero value keeps its sign on a short enough interval")
    }

    /// Whether `polynomial` vanishes here: iff its gcd with the defining polynomial has a root in
    /// the interval, which can only be this one, and simple.
    fn is_root_of(&self, polynomial: &Polynomial<Integer>) -> bool {
        match &self.0 {
            Form::Rational(x) => polynomial.sign_at(x).is_eq(),
            Form::Root { polynomial: own, lower, upper, .. } => {
                changes_sign(&common_part(own, polynomial), lower, upper)
            }
        }
    }

    /// A rational number strictly between `self` and a larger number, short where it can be.
    ///
    /// # Panics
    /// If `self ≥ other`.
    pub fn rational_between(&self, other: &Self) -> Rational {
        assert!(self < other, "nothing lies between");
        let (mut a, mut b) = (self.clone(), other.clone());
        loop {
            let (upper, lower) = (a.bounds().1, b.bounds().0);
            if upper < lower {
                return short_between(&upper, &lower);
            }
            (a, b) = (a.halved(), b.halved());
        }
    }

    /// `p/q`, radicals or `root(POLY, k)`.
    pub fn exact_form(&self) -> ExactForm {
        match &self.0 {
            Form::Rational(x) => ExactForm::Rational(x.clone()),
            Form::Root { known, .. } => known.exact.get_or_init(|| ExactForm::of(self)).clone(),
        }
    }

    /// `self` rounded to `digits ≥ 1` significant digits, as text.
    ///
    /// # Panics
    /// If `digits` is zero.
    pub fn decimal(&self, digits: u32) -> String {
        let x = self.simplified();
        let text = |x: &Rational| decimal(x, digits);
        // An irrational number is no tie, so both ends round alike in the end.
        let narrow = x.refined_until(|lower, upper| text(lower) == text(upper));
        text(&narrow.bounds().0)
    }

    /// The interval `[k, k + 1] / 10^digits` around an irrational number, and `[x, x]` for a rational
    /// one: bounds that depend on nothing but the number.
    pub fn decimal_enclosure(&self, digits: u32) -> (Rational, Rational) {
        let x = self.simplified();
        if let Some(x) = x.as_rational() {
            return (x.clone(), x.clone());
        }
        let scale = Rational::from(integer(10).power(digits));
        let floor = |x: &Rational| (x * &scale).floor();
        let narrow = x.refined_until(|lower, upper| floor(lower) == floor(upper));
        let lower = floor(&narrow.bounds().0);
        (&lower / &scale, (lower + rational(1, 1)) / scale)
    }
}

/// A number strictly between `a < b`, dyadic with few bits.
fn short_between(a: &Rational, b: &Rational) -> Rational {
    let gap = b - a;
    let extra = bit_length(gap.denom()).saturating_sub(bit_length(gap.numer())) + 2;
    let middle = (a + b) / integer(2);
    let candidate = refinable_algebra::dyadic_floor(&middle, extra as u32);
    if *a < candidate && candidate < *b { candidate } else { middle }
}

impl From<Rational> for RealAlgebraic {
    fn from(x: Rational) -> Self {
        RealAlgebraic(Form::Rational(x))
    }
}

impl From<Integer> for RealAlgebraic {
    fn from(x: Integer) -> Self {
        Rational::from(x).into()
    }
}

impl Ord for RealAlgebraic {
    /// # Cost
    /// Against a rational number at most one evaluation. Otherwise a few, and a gcd only for
    /// numbers that are equal, or extremely close, and given by different polynomials.
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Rational(x), Form::Rational(y)) => x.cmp(y),
            (Form::Rational(x), Form::Root { .. }) => other.cmp_rational(x).reverse(),
            (Form::Root { .. }, Form::Rational(y)) => self.cmp_rational(y),
            (Form::Root { .. }, Form::Root { .. }) => self.cmp_root(other),
        }
    }
}

impl RealAlgebraic {
    /// Against a rational number: the polynomial changes sign only at the root.
    fn cmp_rational(&self, y: &Rational) -> Ordering {
        match &self.0 {
            Form::Rational(x) => x.cmp(y),
            Form::Root { lower, .. } if y <= lower => Ordering::Greater,
            Form::Root { upper, .. } if y >= upper => Ordering::Less,
            Form::Root { polynomial, lower, .. } => match polynomial.sign_at(y) {
                Ordering::Equal => Ordering::Equal,
                sign if sign == polynomial.sign_at(lower) => Ordering::Greater,
                _ => Ordering::Less,
            },
        }
    }

    /// Two roots: each is first placed against the ends of the other's interval; if both lie in the
    /// common part they are equal iff a gcd says so.
    fn cmp_root(&self, other: &Self) -> Ordering {
        let (mut a, mut b) = (self.clone(), other.clone());
        for step in 0.. {
            if let Some(decided) =
                a.separated(&b).or_else(|| b.separated(&a).map(Ordering::reverse))
            {
                return decided;
            }
            if (step == 0 && a.shares_polynomial(&b)) || (step == PATIENCE && a.equals(&b)) {
                return Ordering::Equal;
            }
            (a, b) = (a.halved(), b.halved());
        }
        unreachable!("distinct numbers have disjoint enclosures in the end")
    }

    /// The order of the two, if `self` lies outside the open interval of `other`.
    fn separated(&self, other: &Self) -> Option<Ordering> {
        let (lower, upper) = other.bounds();
        if lower == upper {
            return Some(self.cmp_rational(&lower));
        }
        if self.cmp_rational(&lower).is_le() {
            return Some(Ordering::Less);
        }
        self.cmp_rational(&upper).is_ge().then_some(Ordering::Greater)
    }

    /// Whether both are given by the same polynomial; each is its only root in either interval then,
    /// once both lie in both.
    fn shares_polynomial(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Form::Root { polynomial: p, .. }, Form::Root { polynomial: q, .. }) => p == q,
            _ => false,
        }
    }

    /// Equality of two roots that both lie in both intervals: a root of `gcd(p, q)` in the common
    /// interval is the only root of `p` there, and of `q`.
    fn equals(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (
                Form::Root { polynomial: p, lower: p_lower, upper: p_upper, .. },
                Form::Root { polynomial: q, lower: q_lower, upper: q_upper, .. },
            ) => {
                let (lower, upper) = (p_lower.max(q_lower), p_upper.min(q_upper));
                changes_sign(&common_part(p, q), lower, upper)
            }
            _ => self.cmp(other).is_eq(),
        }
    }
}

impl PartialOrd for RealAlgebraic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for RealAlgebraic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for RealAlgebraic {}

impl fmt::Debug for RealAlgebraic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.exact_form().display("x"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    fn sqrt(n: i64) -> RealAlgebraic {
        real_roots(&poly(&[-n, 0, 1])).pop().unwrap()
    }

    /// `1/√(2·10^80)` and its negative are enclosed as closely as `√2`, against their size.
    #[test]
    fn small_numbers_have_leading_bits() {
        let square = integer(2) * integer(10).power(80);
        let roots = real_roots(&Polynomial::new(vec![integer(-1), integer(0), square.clone()]));
        for root in roots {
            let (lower, upper) = root.relative_enclosure(20);
            assert!(lower < upper && lower.compare_to_zero() == upper.compare_to_zero());
            let squares = [&lower * &lower, &upper * &upper].map(|x| x * &square);
            let near = rational(1, 1 << 18);
            assert!(squares.iter().all(|x| (x - rational(1, 1)).absolute() < near));
        }
    }

    #[test]
    #[should_panic(expected = "no leading bits")]
    fn zero_has_no_leading_bits() {
        RealAlgebraic::from(integer(0)).relative_enclosure(1);
    }

    #[test]
    fn equal_numbers_from_different_polynomials() {
        // √2 is a root of x²-2 and of (x²-2)(x-7)(x²-3).
        let other = poly(&[-2, 0, 1]).times(&poly(&[-7, 1])).times(&poly(&[-3, 0, 1]));
        let roots = real_roots(&other);
        assert_eq!(roots[2], sqrt(2));
        assert!(roots[3] > sqrt(2));
    }

    #[test]
    fn rational_roots_are_recognised() {
        // (3x-1)(x²-2): the root 1/3 is no bisection point.
        let roots = real_roots(&poly(&[-1, 3]).times(&poly(&[-2, 0, 1])));
        assert_eq!(roots[1].simplified().as_rational(), Some(&rational(1, 3)));
        assert_eq!(roots[0].simplified().as_rational(), None);
        assert_eq!(roots[1], rational(1, 3).into());
    }

    #[test]
    fn signs_at_a_root_are_exact() {
        let x = sqrt(2);
        assert_eq!(x.sign_of(&poly(&[-2, 0, 1])), Ordering::Equal);
        assert_eq!(x.sign_of(&poly(&[4, 0, -4, 0, 1])), Ordering::Equal); // (x²-2)²
        // 2^60 (x - 1.41421356237309505) separates only deep down.
        let tight = Polynomial::new(vec![
            "-141421356237309504880".parse().unwrap(),
            "100000000000000000000".parse().unwrap(),
        ]);
        assert_eq!(x.sign_of(&tight), Ordering::Greater);
    }

    #[test]
    fn between_two_numbers_there_is_a_short_rational() {
        let x = sqrt(2).rational_between(&sqrt(3));
        assert!(sqrt(2) < x.clone().into() && RealAlgebraic::from(x) < sqrt(3));
    }

    #[test]
    fn decimals_of_irrationals() {
        assert_eq!(sqrt(2).decimal(12), "1.41421356237");
        let negative = real_roots(&poly(&[-2, 0, 1])).remove(0);
        assert_eq!(negative.decimal(6), "-1.41421");
    }

    /// `x = p + q √d`: `(x - p)² = q² d`, and `x - p` has the sign of `q`.
    #[test]
    fn quadratic_numbers_satisfy_their_equation() {
        let numbers = [rational(-3, 2), rational(0, 1), rational(1, 3), rational(2, 1)];
        for (p, q) in numbers.iter().flat_map(|p| numbers.iter().map(move |q| (p, q))) {
            for d in [0, 1, 2, 5, 9].map(|d| rational(d, 1)) {
                let x = RealAlgebraic::quadratic(p, q, &d);
                let constant = p * p - q * q * &d;
                let equation = Polynomial::new(vec![constant, p * integer(-2), rational(1, 1)]);
                assert_eq!(x.sign_of(&equation.cleared().1), Ordering::Equal, "{p} {q} {d}");
                let expected = (q * &d).compare_to_zero();
                assert_eq!(x.cmp(&p.clone().into()), expected, "{p} {q} {d}");
            }
        }
    }

    /// Bounds are as near as they are asked to be, and around the number: their squares around 2.
    #[test]
    fn enclosures_are_narrow_and_hold_the_number() {
        let holds = |(lower, upper): &(Rational, Rational)| {
            let two = rational(2, 1);
            lower * lower < two && two < upper * upper && lower < upper
        };
        for width in [rational(1, 3), rational(1, 1000), rational(1, 1 << 40)] {
            let bounds = sqrt(2).enclosure(&width);
            assert!(holds(&bounds) && &bounds.1 - &bounds.0 <= width, "{width}");
        }
        let bounds = sqrt(2).simplified().bounds();
        assert!(holds(&bounds));
        assert!((&bounds.1 - &bounds.0) * integer(1 << 60) <= bounds.0);
        assert_eq!(sqrt(2).decimal_enclosure(3), (rational(1414, 1000), rational(1415, 1000)));
        let negative = real_roots(&poly(&[-2, 0, 1])).remove(0);
        assert_eq!(negative.decimal_enclosure(3), (rational(-1415, 1000), rational(-1414, 1000)));
    }

    /// `(x-1)(x²-2)` between 6/5 and 8/5: 1 is a root, and the only integer that the bounds leave, but outside of them.
    #[test]
    fn a_rational_root_beside_an_interval_is_another_number() {
        let polynomial = poly(&[-1, 1]).times(&poly(&[-2, 0, 1])).into();
        let x = RealAlgebraic::isolated(polynomial, rational(6, 5), rational(8, 5));
        assert_eq!(x.simplified().as_rational(), None);
        assert_eq!(x, sqrt(2));
    }

    /// Between `1/3 + 10^-30` and `1/2 - 2·10^-30` a few bits are enough; between neighbours nothing is short.
    #[test]
    fn numbers_between_are_short_where_they_can_be() {
        let tiny = Rational::new(integer(1), integer(10).power(30));
        let (a, b) = (rational(1, 3) + &tiny, rational(1, 2) - &tiny * integer(2));
        let x = short_between(&a, &b);
        assert!(a < x && x < b && bit_length(x.denom()) <= 8, "{x}");
        for (a, b) in [(rational(0, 1), tiny.clone()), (a.clone(), &a + &tiny), (-&tiny, tiny)] {
            let x = short_between(&a, &b);
            assert!(a < x && x < b, "{a} {x} {b}");
        }
        assert_eq!(format!("{:?}", sqrt(2)), "sqrt(2)");
    }
}
