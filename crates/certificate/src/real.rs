//! Real algebraic numbers: enclosures, signs, order.

use std::cmp::Ordering;
use std::sync::Arc;

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, dyadic_floor, integer};

use crate::determinant;
use crate::gcd::greatest_common_divisor;
use crate::model::{Coefficients, End};
use crate::order::{equal, less};
use crate::roots::{roots_between, sign_at};
use crate::work::{Check, Work, ensure, fail, rational_bits};

/// A real algebraic number.
#[derive(Clone, Debug)]
pub(crate) enum Real {
    /// A rational number.
    Rational(Rational),
    /// Any other, or one not known to be rational.
    Root(Root),
}

/// The only root of a square-free polynomial in an open interval, at whose ends it is not zero.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    polynomial: Arc<Polynomial<Integer>>,
    lower: Rational,
    upper: Rational,
}

/// A polynomial of a certificate times a positive integer that clears its denominators.
pub(crate) fn integer_polynomial(coefficients: &Coefficients) -> Polynomial<Integer> {
    Polynomial::new(coefficients.iter().map(|c| c.0.clone()).collect()).cleared().1
}

impl Real {
    /// The end of an interval, checked to be well-defined.
    pub fn new(end: &End, work: &mut Work) -> Check<Self> {
        let root = match end {
            End::Rational(x) => return Ok(Real::Rational(x.0.clone())),
            End::Algebraic(root) => root,
        };
        let polynomial = integer_polynomial(&root.root_of);
        let [lower, upper] = [&root.between[0].0, &root.between[1].0];
        ensure(less(lower, upper), "the interval around a root is empty")?;
        ensure(polynomial.degree().is_some(), "every number is a root of the zero polynomial")?;
        for x in [lower, upper] {
            let sign = sign_at(&polynomial, x, work)?;
            ensure(sign.is_ne(), "the polynomial of a root vanishes at an end of its interval")?;
        }
        let mut roots = roots_between(&polynomial, lower, upper, work)?;
        ensure(roots.len() == 1, "the interval around a root does not contain exactly one")?;
        Ok(roots.remove(0))
    }

    /// Rational numbers below and above, or twice the number itself.
    pub fn bracket(&self) -> (&Rational, &Rational) {
        match self {
            Real::Rational(x) => (x, x),
            Real::Root(root) => (&root.lower, &root.upper),
        }
    }

    /// The value, if it is known to be rational.
    pub fn as_rational(&self) -> Option<&Rational> {
        match self {
            Real::Rational(x) => Some(x),
            Real::Root(_) => None,
        }
    }

    /// Halves the enclosure.
    fn refine(&mut self, work: &mut Work) -> Check<()> {
        let Real::Root(root) = self else { return Ok(()) };
        let bits = rational_bits(&root.lower).max(rational_bits(&root.upper));
        // The gcd of numerator and denominator takes as many steps as there are bits.
        work.products(2, bits, 64 * bits)?;
        let middle = (&root.lower + &root.upper) / integer(2);
        self.cut(middle, work)
    }

    /// Keeps the side of `x`, inside the enclosure, on which the number is.
    fn cut(&mut self, x: Rational, work: &mut Work) -> Check<()> {
        let Real::Root(root) = self else { return Ok(()) };
        let sign = sign_at(&root.polynomial, &x, work)?;
        if sign.is_eq() {
            *self = Real::Rational(x);
        } else if sign == sign_at(&root.polynomial, &root.lower, work)? {
            root.lower = x;
        } else {
            root.upper = x;
        }
        Ok(())
    }

    /// Dyadic numbers below and above at a distance of at most `2^(1-bits)`, or twice the number
    /// itself if it is rational.
    pub fn enclosure(&self, bits: u32, work: &mut Work) -> Check<(Rational, Rational)> {
        let mut x = self.clone();
        let step = Rational::new(integer(1), integer(1) << bits);
        let mut speed = 1;
        while let Real::Root(root) = &x {
            if !less(&step, &(&root.upper - &root.lower)) {
                break;
            }
            speed = x.refine_by_secant(speed, work)?;
        }
        let (lower, upper) = x.bracket();
        if equal(lower, upper) {
            return Ok((lower.clone(), upper.clone()));
        }
        let lower = dyadic_floor(lower, bits);
        Ok((lower.clone(), lower + &step + &step))
    }

    /// One step of quadratic interval refinement (Abbott 2006): of `2^speed` equal parts the one
    /// where the secant is zero is tried. Returns the next speed.
    fn refine_by_secant(&mut self, speed: u32, work: &mut Work) -> Check<u32> {
        let Real::Root(root) = &*self else { return Ok(speed) };
        if speed == 1 {
            self.refine(work)?;
            return Ok(2);
        }
        let n = root.polynomial.coefficients().len();
        let bits = rational_bits(&root.lower).max(rational_bits(&root.upper));
        work.products(8 * n, bits.saturating_mul(n as u64), bits)?;
        work.products(6, bits, 64 * bits)?;
        let parts = integer(1) << speed;
        let left = homogeneous(&root.polynomial, &root.lower, root.upper.denom());
        let right = homogeneous(&root.polynomial, &root.upper, root.lower.denom());
        // The values have opposite signs: the quotient is positive, and rounded down.
        let index = &left * &parts / (&left - &right);
        let width = (&root.upper - &root.lower) / &parts;
        let before = (root.lower.clone(), root.upper.clone());
        let below = &before.0 + &width * &index;
        let above = &below + &width;
        let outer = [below, above].into_iter().filter(|x| less(&before.0, x) && less(x, &before.1));
        for x in outer {
            let (lower, upper) = self.bracket();
            if less(lower, &x) && less(&x, upper) {
                self.cut(x, work)?;
            }
        }
        let (lower, upper) = self.bracket();
        Ok(if !less(&width, &(upper - lower)) { speed * 2 } else { (speed / 2).max(1) })
    }

    /// The order of two numbers.
    pub fn compare(&self, other: &Self, work: &mut Work) -> Check<Ordering> {
        let bits = |x: &Self| rational_bits(x.bracket().0).max(rational_bits(x.bracket().1));
        work.products(4, bits(self), bits(other))?;
        if let Some(order) = self.separated(other) {
            return Ok(order);
        }
        let equal = match (self, other) {
            (Real::Rational(_), Real::Rational(_)) => true,
            (Real::Rational(x), Real::Root(root)) | (Real::Root(root), Real::Rational(x)) => {
                sign_at(&root.polynomial, x, work)?.is_eq()
            }
            (Real::Root(a), Real::Root(b)) => a.equals(b, work)?,
        };
        if equal {
            return Ok(Ordering::Equal);
        }
        let (mut a, mut b) = (self.clone(), other.clone());
        let (mut speed_a, mut speed_b) = (1, 1);
        loop {
            speed_a = a.refine_by_secant(speed_a, work)?;
            speed_b = b.refine_by_secant(speed_b, work)?;
            if let Some(order) = a.separated(&b) {
                return Ok(order);
            }
        }
    }

    /// The order, if the enclosures show that the two are different.
    fn separated(&self, other: &Self) -> Option<Ordering> {
        let ((a, b), (c, d)) = (self.bracket(), other.bracket());
        let rational = equal(a, b) && equal(c, d);
        if less(b, c) || (equal(b, c) && !rational) {
            Some(Ordering::Less)
        } else if less(d, a) || (equal(d, a) && !rational) {
            Some(Ordering::Greater)
        } else {
            None
        }
    }

    /// Whether a polynomial that is not zero vanishes here.
    pub fn is_root_of(&self, polynomial: &Polynomial<Integer>, work: &mut Work) -> Check<bool> {
        match self {
            Real::Rational(x) => Ok(sign_at(polynomial, x, work)?.is_eq()),
            Real::Root(root) => {
                let common = greatest_common_divisor(&root.polynomial, polynomial, work)?;
                root.is_met_by(&common, &root.lower, &root.upper, work)
            }
        }
    }
}

impl Root {
    /// The only root of a square-free polynomial in the open interval, at whose ends it is not
    /// zero.
    pub fn new(polynomial: &Arc<Polynomial<Integer>>, lower: Rational, upper: Rational) -> Self {
        Root { polynomial: polynomial.clone(), lower, upper }
    }

    /// Whether `common`, a divisor of the polynomial without a root at `lower` and `upper`, has one
    /// between them.
    fn is_met_by(
        &self,
        common: &Polynomial<Integer>,
        lower: &Rational,
        upper: &Rational,
        work: &mut Work,
    ) -> Check<bool> {
        // It is simple, and the only one: the sign changes.
        Ok(sign_at(common, lower, work)? != sign_at(common, upper, work)?)
    }

    fn equals(&self, other: &Self, work: &mut Work) -> Check<bool> {
        // Each end belongs to one of the two intervals, so the divisor does not vanish there.
        let lower = if less(&self.lower, &other.lower) { &other.lower } else { &self.lower };
        let upper = if less(&self.upper, &other.upper) { &self.upper } else { &other.upper };
        if self.polynomial == other.polynomial {
            return self.is_met_by(&self.polynomial, lower, upper, work);
        }
        let common = greatest_common_divisor(&self.polynomial, &other.polynomial, work)?;
        self.is_met_by(&common, lower, upper, work)
    }
}

/// `(q s)^n p(x)` for `x` of denominator `q`.
fn homogeneous(polynomial: &Polynomial<Integer>, x: &Rational, s: &Integer) -> Integer {
    let degree = polynomial.degree().unwrap_or(0);
    determinant::homogeneous(polynomial, x, degree) * s.power(degree as u32)
}

/// A rational number strictly between two numbers; `None` is infinite.
pub(crate) fn between(low: Option<&Real>, high: Option<&Real>, work: &mut Work) -> Check<Rational> {
    let one = Rational::from(integer(1));
    let (mut a, mut b) = match (low, high) {
        (None, None) => return Ok(Rational::from(integer(0))),
        (Some(a), None) => return Ok(a.bracket().1 + one),
        (None, Some(b)) => return Ok(b.bracket().0 - one),
        (Some(a), Some(b)) => (a.clone(), b.clone()),
    };
    let (mut speed_a, mut speed_b) = (1, 1);
    loop {
        let (left, right) = (a.bracket().1, b.bracket().0);
        if less(left, right) {
            return Ok(simplest_dyadic(left, right));
        }
        if a.as_rational().is_some() && b.as_rational().is_some() {
            return fail("there is no number between two equal ones");
        }
        speed_a = a.refine_by_secant(speed_a, work)?;
        speed_b = b.refine_by_secant(speed_b, work)?;
    }
}

/// A number of few bits strictly between two others.
fn simplest_dyadic(left: &Rational, right: &Rational) -> Rational {
    let middle = (left + right) / integer(2);
    let width = right - left;
    let bits = width.denom().bits().saturating_sub(width.numer().bits()) + 2;
    let Ok(bits) = u32::try_from(bits) else { return middle };
    let rounded = dyadic_floor(&middle, bits);
    if less(left, &rounded) && less(&rounded, right) { rounded } else { middle }
}

impl Real {
    /// Whether the number is rational. Then its product with the leading coefficient of an integer
    /// polynomial of which it is a root is an integer.
    pub fn is_rational(&self, work: &mut Work) -> Check<bool> {
        let Real::Root(root) = self else { return Ok(true) };
        let lead = root.polynomial.leading().map_or_else(|| integer(1), Ordered::absolute);
        let Ok(bits) = u32::try_from(lead.bits() + 3) else {
            return fail("could not be checked within the limits");
        };
        let (lower, upper) = self.enclosure(bits, work)?;
        let nearest = ((lower + upper) / integer(2) * &lead).round().to_integer();
        let candidate = Real::Rational(Rational::new(nearest, lead));
        Ok(self.compare(&candidate, work)?.is_eq())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Root;
    use crate::number::Number;
    use refinable_algebra::rational;

    /// The root between two numbers of a polynomial with integer coefficients.
    fn root(coefficients: &[i64], between: [Rational; 2]) -> Real {
        let root_of = coefficients.iter().map(|&c| Number(rational(c, 1))).collect();
        let root = Root { root_of, between: between.map(Number) };
        Real::new(&End::Algebraic(root), &mut Work::new()).unwrap()
    }

    fn sqrt(n: i64) -> Real {
        root(&[-n, 0, 1], [rational(0, 1), rational(n, 1)])
    }

    /// The roots of `(3x - 1)(x² - 2)` and `(5000x - 4999)(x² - x - 1)`.
    #[test]
    fn rational_roots_are_recognised() {
        let work = &mut Work::new();
        let product = [2, -6, -1, 3];
        let other = [4999, -1, -9999, 5000];
        for x in [
            root(&product, [rational(0, 1), rational(1, 1)]),
            root(&product, [rational(-1, 1), rational(1, 2)]),
            root(&other, [rational(0, 1), rational(3, 2)]),
            root(&[-7, 2], [rational(0, 1), rational(9, 1)]),
            Real::Rational(rational(5, 7)),
        ] {
            assert_eq!(x.is_rational(work), Ok(true), "{x:?}");
        }
        for x in [
            root(&product, [rational(1, 1), rational(2, 1)]),
            root(&product, [rational(-2, 1), rational(-1, 1)]),
            root(&other, [rational(3, 2), rational(2, 1)]),
            sqrt(2),
        ] {
            assert_eq!(x.is_rational(work), Ok(false), "{x:?}");
        }
    }

    /// Numbers given by their squares, and the same again as roots of products.
    #[test]
    fn the_order_is_that_of_the_squares() {
        let work = &mut Work::new();
        // (x² - 2)(x² - 3)(x - 7)
        let product = [-42, 6, 35, -5, -7, 1];
        let numbers = [
            (1, Real::Rational(rational(1, 1))),
            (2, sqrt(2)),
            (2, root(&product, [rational(1, 1), rational(3, 2)])),
            (3, root(&product, [rational(3, 2), rational(2, 1)])),
            (3, sqrt(3)),
            (4, root(&[-2, 1], [rational(0, 1), rational(5, 1)])),
            (49, root(&product, [rational(2, 1), rational(9, 1)])),
        ];
        for (square, x) in &numbers {
            for (other, y) in &numbers {
                assert_eq!(x.compare(y, work), Ok(square.cmp(other)), "{x:?} {y:?}");
                if square < other {
                    let x = between(Some(x), Some(y), work).unwrap();
                    let (square, other) = (rational(*square, 1), rational(*other, 1));
                    assert!(square < &x * &x && &x * &x < other, "{x}");
                }
            }
            let (above, below) = (between(Some(x), None, work), between(None, Some(x), work));
            let [above, below] = [above, below].map(|x| Real::Rational(x.unwrap()));
            assert_eq!(x.compare(&above, work), Ok(Ordering::Less));
            assert_eq!(x.compare(&below, work), Ok(Ordering::Greater));
        }
    }

    #[test]
    fn enclosures_are_narrow_and_hold_the_number() {
        let work = &mut Work::new();
        let two = rational(2, 1);
        for bits in [0, 1, 7, 100, 500] {
            let (lower, upper) = sqrt(2).enclosure(bits, work).unwrap();
            assert!(&lower * &lower < two && &upper * &upper > two, "{bits}");
            assert!((upper - lower) * (integer(1) << bits) <= two, "{bits}");
        }
    }
}
