//! Numbers made of square roots, compared by squaring.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Polynomial, Rational, integer, rational};

/// `rational + coefficient · √radicand`, the radicand not negative.
#[derive(Clone, Debug)]
pub struct Surd {
    /// The part beside the root.
    pub rational: Rational,
    /// The number in front of the root.
    pub coefficient: Rational,
    /// What stands under the root.
    pub radicand: Rational,
}

impl Surd {
    /// `rational + coefficient · √radicand`.
    ///
    /// # Panics
    /// If the radicand is negative.
    pub fn new(rational: Rational, coefficient: Rational, radicand: Rational) -> Self {
        assert!(!sign(&radicand).is_lt(), "the number is not real");
        Surd { rational, coefficient, radicand }
    }

    /// The sign: where the two terms disagree, the one with the larger square wins.
    pub fn sign(&self) -> Ordering {
        let (a, b) = (&self.rational, &self.coefficient);
        dominant(sign(a), self.root_sign(), || (a * a).cmp(&(b * b * &self.radicand)))
    }

    /// The order of two numbers, also with different radicands.
    pub fn compare(&self, other: &Self) -> Ordering {
        let apart = |x: &Surd, rational: Rational, coefficient: Rational| Surd {
            rational,
            coefficient,
            radicand: x.radicand.clone(),
        };
        let zero = rational(0, 1);
        NestedSurd {
            inner: apart(self, &self.rational - &other.rational, self.coefficient.clone()),
            coefficient: apart(self, -other.coefficient.clone(), zero),
            radicand: other.radicand.clone(),
        }
        .sign()
    }

    /// The order relative to a rational number.
    pub fn compare_to_rational(&self, x: &Rational) -> Ordering {
        let difference = Surd { rational: &self.rational - x, ..self.clone() };
        difference.sign()
    }

    /// `self + other` in `Q(√radicand)`.
    ///
    /// # Panics
    /// If the radicands differ.
    pub fn plus(&self, other: &Self) -> Self {
        assert_eq!(self.radicand, other.radicand, "two different fields");
        Surd {
            rational: &self.rational + &other.rational,
            coefficient: &self.coefficient + &other.coefficient,
            radicand: self.radicand.clone(),
        }
    }

    /// `self · other` in `Q(√radicand)`.
    ///
    /// # Panics
    /// If the radicands differ.
    pub fn times(&self, other: &Self) -> Self {
        assert_eq!(self.radicand, other.radicand, "two different fields");
        let (a, b) = (&self.rational, &self.coefficient);
        let (c, d) = (&other.rational, &other.coefficient);
        Surd {
            rational: a * c + b * d * &self.radicand,
            coefficient: a * d + b * c,
            radicand: self.radicand.clone(),
        }
    }

    /// The rational number `x` as an element of the same field.
    pub fn constant(&self, x: Rational) -> Self {
        Surd { rational: x, coefficient: rational(0, 1), radicand: self.radicand.clone() }
    }

    /// The value of a polynomial at this number (Horner).
    pub fn value_of(&self, polynomial: &Polynomial<Integer>) -> Self {
        let coefficients = polynomial.coefficients().iter().rev();
        coefficients.fold(self.constant(rational(0, 1)), |value, c| {
            let c = self.constant(Rational::from(c.clone()));
            value.times(self).plus(&c)
        })
    }

    /// An integer polynomial of degree two with this number and its conjugate as roots:
    /// `x² - 2ax + a² - b²d`, cleared of denominators.
    pub fn quadratic(&self) -> Polynomial<Integer> {
        let (a, b) = (&self.rational, &self.coefficient);
        let coefficients = [a * a - b * b * &self.radicand, -(a + a), rational(1, 1)];
        let scale = coefficients[0].denom() * coefficients[1].denom();
        let cleared = coefficients.map(|c| (c * &scale).to_integer());
        Polynomial::new(cleared.to_vec())
    }

    /// Reads `(3-sqrt(3))/64`, `-2*sqrt(5)`, `sqrt(2)/3`; `None` for anything else.
    pub fn parse(text: &str) -> Option<Self> {
        let (top, denominator) = match text.rsplit_once('/') {
            Some((top, bottom)) => (top, bottom.parse::<Integer>().ok()?),
            None => (text, integer(1)),
        };
        let top = match top.strip_prefix('(') {
            Some(inner) => inner.strip_suffix(')')?,
            None => top,
        };
        let (before, radicand) = top.strip_suffix(')')?.split_once("sqrt(")?;
        let (beside, coefficient) = split_coefficient(before)?;
        let over = |n: Integer| Rational::new(n, denominator.clone());
        let radicand = Rational::from(radicand.parse::<Integer>().ok()?);
        Some(Surd::new(over(beside), over(coefficient), radicand))
    }

    fn root_sign(&self) -> Ordering {
        let b = sign(&self.coefficient);
        if sign(&self.radicand).is_eq() { Ordering::Equal } else { b }
    }
}

/// From `-7+2*`, `7-`, `-`, `` to the number beside the root and the one in front of it.
fn split_coefficient(text: &str) -> Option<(Integer, Integer)> {
    // The sign in front of the root is the last one.
    let at = text.rfind(['+', '-']);
    let (beside, signed) = text.split_at(at.unwrap_or(0));
    let (negative, size) = match signed.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, signed.strip_prefix('+').unwrap_or(signed)),
    };
    let size = match size.strip_suffix('*') {
        Some(digits) => digits.parse().ok()?,
        None if size.is_empty() => integer(1),
        None => return None,
    };
    let beside = if beside.is_empty() { integer(0) } else { beside.parse().ok()? };
    Some((beside, if negative { -size } else { size }))
}

/// `inner + coefficient · √radicand` over a field `Q(√d)`.
#[derive(Clone, Debug)]
pub struct NestedSurd {
    /// The part beside the outer root.
    pub inner: Surd,
    /// The number in front of the outer root.
    pub coefficient: Surd,
    /// What stands under the outer root; not negative.
    pub radicand: Rational,
}

impl NestedSurd {
    /// The sign, by squaring as for [`Surd`].
    pub fn sign(&self) -> Ordering {
        let (u, v) = (&self.inner, &self.coefficient);
        let root_sign = if sign(&self.radicand).is_eq() { Ordering::Equal } else { v.sign() };
        dominant(u.sign(), root_sign, || {
            let negated = u.constant(-self.radicand.clone());
            u.times(u).plus(&v.times(v).times(&negated)).sign()
        })
    }

    /// `self + other`.
    pub fn plus(&self, other: &Self) -> Self {
        NestedSurd {
            inner: self.inner.plus(&other.inner),
            coefficient: self.coefficient.plus(&other.coefficient),
            radicand: self.radicand.clone(),
        }
    }

    /// `self · other`.
    pub fn times(&self, other: &Self) -> Self {
        let (a, b) = (&self.inner, &self.coefficient);
        let (c, d) = (&other.inner, &other.coefficient);
        let radicand = a.constant(self.radicand.clone());
        NestedSurd {
            inner: a.times(c).plus(&b.times(d).times(&radicand)),
            coefficient: a.times(d).plus(&b.times(c)),
            radicand: self.radicand.clone(),
        }
    }
}

/// The sign of a sum of two terms; `sizes` compares their absolute values.
fn dominant(first: Ordering, second: Ordering, sizes: impl Fn() -> Ordering) -> Ordering {
    if first.is_eq() || first == second {
        return second;
    }
    if second.is_eq() {
        return first;
    }
    match sizes() {
        Ordering::Greater => first,
        Ordering::Less => second,
        Ordering::Equal => Ordering::Equal,
    }
}

fn sign(x: &Rational) -> Ordering {
    x.cmp(&rational(0, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surd(a: i64, b: i64, d: i64) -> Surd {
        Surd::new(rational(a, 1), rational(b, 1), rational(d, 1))
    }

    #[test]
    fn signs_by_squaring() {
        assert_eq!(surd(-7, 5, 2).sign(), Ordering::Greater); // √50 > √49
        assert_eq!(surd(7, -5, 2).sign(), Ordering::Less);
        assert_eq!(surd(-3, 1, 9).sign(), Ordering::Equal);
        assert_eq!(surd(0, -1, 2).sign(), Ordering::Less);
        assert_eq!(surd(1, -1, 0).sign(), Ordering::Greater);
    }

    #[test]
    fn comparison_across_fields() {
        // 1 + √2 < √6 < 5/2, 2√2 = √8
        assert_eq!(surd(1, 1, 2).compare(&surd(0, 1, 6)), Ordering::Less);
        assert_eq!(surd(0, 1, 6).compare(&surd(1, 1, 2)), Ordering::Greater);
        assert_eq!(surd(0, 2, 2).compare(&surd(0, 1, 8)), Ordering::Equal);
        assert_eq!(surd(0, 1, 6).compare_to_rational(&rational(5, 2)), Ordering::Less);
    }

    #[test]
    fn a_surd_is_a_root_of_its_quadratic() {
        let golden = Surd::new(rational(1, 2), rational(-1, 2), rational(5, 1));
        let quadratic = golden.quadratic();
        assert_eq!(quadratic.degree(), Some(2));
        assert_eq!(golden.value_of(&quadratic).sign(), Ordering::Equal);
        assert_eq!(golden.value_of(&Polynomial::new(vec![integer(1)])).sign(), Ordering::Greater);
    }

    #[test]
    fn printed_radicals_are_read() {
        let cases = [
            ("(3-sqrt(3))/64", (3, 64), (-1, 64), 3),
            ("-7+2*sqrt(5)", (-7, 1), (2, 1), 5),
            ("-sqrt(2)", (0, 1), (-1, 1), 2),
            ("11*sqrt(7)/3", (0, 1), (11, 3), 7),
        ];
        for (text, a, b, d) in cases {
            let read = Surd::parse(text).unwrap();
            assert_eq!(read.rational, rational(a.0, a.1), "{text}");
            assert_eq!(read.coefficient, rational(b.0, b.1), "{text}");
            assert_eq!(read.radicand, rational(d, 1), "{text}");
        }
        assert!(Surd::parse("1/2").is_none() && Surd::parse("root(x, 1)").is_none());
    }

    #[test]
    fn nested_arithmetic_multiplies_out() {
        // (√2 + √3)² - 5 = 2√6, whose square is 24.
        let inner = surd(0, 1, 2);
        let sum = NestedSurd {
            coefficient: inner.constant(rational(1, 1)),
            radicand: rational(3, 1),
            inner,
        };
        let constant = |n: i64| NestedSurd {
            inner: sum.inner.constant(rational(n, 1)),
            coefficient: sum.inner.constant(rational(0, 1)),
            radicand: rational(3, 1),
        };
        let double_root = sum.times(&sum).plus(&constant(-5));
        let zero = double_root.times(&double_root).plus(&constant(-24));
        assert_eq!(double_root.sign(), Ordering::Greater);
        assert_eq!(zero.sign(), Ordering::Equal);
    }
}
