//! Dense polynomials in one variable over any ring.

use std::cmp::Ordering;
use std::fmt;

use crate::number::{Integer, Rational, clear_denominators};
use crate::ring::{Ordered, Ring};

/// `Σ_k coefficients[k] x^k`, index origin 0, the last coefficient nonzero (none for zero).
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Polynomial<R> {
    coefficients: Vec<R>,
}

impl<R: Ring> Polynomial<R> {
    /// `Σ_k coefficients[k] x^k`; zeros at the end are cut.
    pub fn new(mut coefficients: Vec<R>) -> Self {
        while coefficients.last().is_some_and(Ring::is_zero) {
            coefficients.pop();
        }
        Polynomial { coefficients }
    }

    /// The constant `c`.
    pub fn constant(c: R) -> Self {
        Polynomial::new(vec![c])
    }

    /// `c x^exponent`.
    pub fn monomial(c: R, exponent: usize) -> Self {
        let mut coefficients = vec![R::zero(); exponent];
        coefficients.push(c);
        Polynomial::new(coefficients)
    }

    /// The variable `x`.
    pub fn variable() -> Self {
        Polynomial::monomial(R::one(), 1)
    }

    /// The coefficients in ascending order, the leading one last.
    pub fn coefficients(&self) -> &[R] {
        &self.coefficients
    }

    /// The coefficient of `x^k`, zero beyond the degree.
    pub fn coefficient(&self, k: usize) -> R {
        self.coefficients.get(k).cloned().unwrap_or_else(R::zero)
    }

    /// The degree; `None` for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// The leading coefficient; `None` for the zero polynomial.
    pub fn leading(&self) -> Option<&R> {
        self.coefficients.last()
    }

    /// Whether the degree is at most zero.
    pub fn is_constant(&self) -> bool {
        self.coefficients.len() <= 1
    }

    /// The value at `x` (Horner).
    pub fn evaluate(&self, x: &R) -> R {
        self.coefficients.iter().rev().fold(R::zero(), |value, c| value.times(x).plus(c))
    }

    /// The formal derivative.
    pub fn derivative(&self) -> Self {
        let scaled = self.coefficients.iter().enumerate().skip(1);
        Polynomial::new(scaled.map(|(k, c)| c.times(&R::from_i64(k as i64))).collect())
    }

    /// `c · self`.
    pub fn scaled(&self, c: &R) -> Self {
        Polynomial::new(self.coefficients.iter().map(|a| a.times(c)).collect())
    }

    /// `x^k · self`.
    pub fn shifted(&self, k: usize) -> Self {
        let mut coefficients = vec![R::zero(); k];
        coefficients.extend_from_slice(&self.coefficients);
        Polynomial::new(coefficients)
    }

    /// The polynomial with `f` applied to every coefficient.
    pub fn map<S: Ring>(&self, f: impl FnMut(&R) -> S) -> Polynomial<S> {
        Polynomial::new(self.coefficients.iter().map(f).collect())
    }

    /// `self ± other` in place, without trimming; `sign` is the identity or the negation.
    fn add_scaled(&mut self, other: &Self, sign: fn(&R) -> R) {
        if self.coefficients.len() < other.coefficients.len() {
            self.coefficients.resize(other.coefficients.len(), R::zero());
        }
        for (sum, c) in self.coefficients.iter_mut().zip(&other.coefficients) {
            *sum = sum.plus(&sign(c));
        }
    }

    fn trimmed(self) -> Self {
        Polynomial::new(self.coefficients)
    }
}

impl<R: Ring> Ring for Polynomial<R> {
    fn zero() -> Self {
        Polynomial { coefficients: Vec::new() }
    }
    fn one() -> Self {
        Polynomial::constant(R::one())
    }
    fn from_i64(n: i64) -> Self {
        Polynomial::constant(R::from_i64(n))
    }
    fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_scaled(other, R::clone);
        sum.trimmed()
    }
    fn minus(&self, other: &Self) -> Self {
        let mut difference = self.clone();
        difference.add_scaled(other, R::negated);
        difference.trimmed()
    }
    fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero();
        product.add_product(self, other);
        product
    }
    fn negated(&self) -> Self {
        Polynomial { coefficients: self.coefficients.iter().map(R::negated).collect() }
    }
    fn add_product(&mut self, a: &Self, b: &Self) {
        if a.is_zero() || b.is_zero() {
            return;
        }
        let length = a.coefficients.len() + b.coefficients.len() - 1;
        if self.coefficients.len() < length {
            self.coefficients.resize(length, R::zero());
        }
        for (i, x) in a.coefficients.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            for (sum, y) in self.coefficients[i..].iter_mut().zip(&b.coefficients) {
                sum.add_product(x, y);
            }
        }
        while self.coefficients.last().is_some_and(Ring::is_zero) {
            self.coefficients.pop();
        }
    }
}

impl Polynomial<Rational> {
    /// `(d, p)` with `self = p / d`, `p` over Z and `d > 0` the least common denominator.
    pub fn cleared(&self) -> (Integer, Polynomial<Integer>) {
        let (common, cleared) = clear_denominators(self.coefficients.iter());
        (common, Polynomial::new(cleared))
    }
}

impl Polynomial<Integer> {
    /// The sign of the value at the rational number `x`.
    ///
    /// # Cost
    /// `degree` products in Z: `Σ c_k p^k q^(n-k)` has the sign of the value at `p/q`, no gcd is
    /// ever taken.
    pub fn sign_at(&self, x: &Rational) -> Ordering {
        let (p, q) = (x.numer(), x.denom());
        let mut power = Integer::from(1);
        let mut value = Integer::from(0);
        for c in self.coefficients.iter().rev() {
            value = value * p + c * &power;
            power *= q;
        }
        value.compare_to_zero()
    }

    /// The sign as `x → +∞`.
    pub fn sign_at_infinity(&self) -> Ordering {
        self.leading().map_or(Ordering::Equal, Ordered::compare_to_zero)
    }

    /// `p(x)` for a rational `x`.
    pub fn value_at(&self, x: &Rational) -> Rational {
        self.map(|c| Rational::from(c.clone())).evaluate(x)
    }

    /// Writes the polynomial in the named variable, highest power first: `32*w^3 + 4*w - 1`.
    pub fn display(&self, variable: &str) -> String {
        let terms = self.coefficients.iter().enumerate().rev().filter(|(_, c)| !c.is_zero());
        let mut text = String::new();
        for (k, c) in terms {
            let power = match k {
                0 => String::new(),
                1 => variable.to_string(),
                _ => format!("{variable}^{k}"),
            };
            push_term(&mut text, &Rational::from(c.clone()), &power);
        }
        if text.is_empty() { "0".into() } else { text }
    }
}

/// Appends `± c*power` to a sum; a coefficient of one is left out, an empty power is a constant.
pub(crate) fn push_term(text: &mut String, coefficient: &Rational, power: &str) {
    push_sign(text, coefficient.compare_to_zero() == Ordering::Less);
    let size = coefficient.absolute();
    if power.is_empty() {
        text.push_str(&size.to_string());
    } else if size == Rational::one() {
        text.push_str(power);
    } else {
        text.push_str(&format!("{size}*{power}"));
    }
}

/// Appends what stands before the next term of a sum: `+` or `-` between blanks, at the start `-` or nothing.
///
/// ```
/// let mut sum = String::new();
/// for (negative, term) in [(true, "x"), (false, "y"), (true, "z")] {
///     refinable_algebra::push_sign(&mut sum, negative);
///     sum.push_str(term);
/// }
/// assert_eq!(sum, "-x + y - z");
/// ```
pub fn push_sign(text: &mut String, negative: bool) {
    text.push_str(match (text.is_empty(), negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    });
}

impl fmt::Display for Polynomial<Integer> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.display("x"))
    }
}
