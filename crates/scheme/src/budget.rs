//! The limits of exact arithmetic on input that nobody has vetted.
//!
//! Every product, sum and greatest common divisor is charged before it is done, by an estimate in
//! nanoseconds of what it costs at worst. The constants were measured once, on one machine; they
//! decide only how much is refused, never a result.

use refinable_algebra::{Domain, GcdDomain, Laurent, Parameter, ParameterPolynomial, Ring};

use crate::diagnostic::Diagnostic;

/// The work of one resolution or evaluation, in estimated nanoseconds.
const WORK: u64 = 500_000_000;
/// The largest number of terms of a polynomial, and the longest support of a symbol.
pub(crate) const MOST_TERMS: u64 = 20_000;
/// The largest total degree in the parameters.
const LARGEST_DEGREE: u64 = 10_000;
/// The largest numerator or denominator of a coefficient, in bits.
const MOST_BITS: u64 = 1 << 20;
/// The largest power of `z` in magnitude.
pub(crate) const FARTHEST_INDEX: i64 = 1_000_000;

/// What is left of the work.
pub(crate) struct Budget {
    left: u64,
}

/// The measures of a symbol that its products depend on.
#[derive(Clone, Default)]
pub(crate) struct Size {
    /// The number of powers of `z` from the first to the last.
    length: u64,
    /// The number of terms in `z` and the parameters.
    terms: u64,
    /// The total degree in the parameters.
    degree: u64,
    /// The largest bit length of a numerator or denominator.
    bits: u64,
    /// The parameters, ascending, each with its largest exponent.
    exponents: Vec<(Parameter, u64)>,
}

impl Size {
    pub fn of(polynomial: &ParameterPolynomial) -> Self {
        let mut size = Size::default();
        size.take_in(polynomial);
        size
    }

    pub fn of_symbol(symbol: &Laurent<ParameterPolynomial>) -> Self {
        let mut size = Size::default();
        for coefficient in symbol.coefficients() {
            size.take_in(coefficient);
        }
        size
    }

    fn take_in(&mut self, polynomial: &ParameterPolynomial) {
        self.length += 1;
        self.terms += polynomial.terms().len() as u64;
        self.degree = self.degree.max(polynomial.degree().unwrap_or(0).into());
        self.bits = self.bits.max(polynomial.height());
        for (monomial, _) in polynomial.terms() {
            for (parameter, exponent) in monomial.factors() {
                self.raise(parameter, u64::from(*exponent));
            }
        }
    }

    fn raise(&mut self, parameter: &Parameter, exponent: u64) {
        match self.exponents.binary_search_by(|(p, _)| p.cmp(parameter)) {
            Ok(at) => self.exponents[at].1 = self.exponents[at].1.max(exponent),
            Err(at) => self.exponents.insert(at, (parameter.clone(), exponent)),
        }
    }

    fn exponent(&self, parameter: &Parameter) -> u64 {
        self.exponents
            .binary_search_by(|(p, _)| p.cmp(parameter))
            .map_or(0, |at| self.exponents[at].1)
    }

    /// The parameters of both with their exponents in each.
    fn exponents_beside(&self, other: &Self) -> Vec<(u64, u64)> {
        let mut union = self.clone();
        for (parameter, _) in &other.exponents {
            union.raise(parameter, 0);
        }
        let names = union.exponents.iter().map(|(p, _)| p);
        names.map(|p| (self.exponent(p), other.exponent(p))).collect()
    }
}

impl Budget {
    pub fn new() -> Self {
        Budget { left: WORK }
    }

    /// Takes `work` off the budget.
    pub fn spend(&mut self, work: u64) -> Result<(), Diagnostic> {
        match self.left.checked_sub(work) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(excess("the exact result takes too much work to compute")),
        }
    }

    /// `a · b`.
    pub fn product(
        &mut self,
        a: &Laurent<ParameterPolynomial>,
        b: &Laurent<ParameterPolynomial>,
    ) -> Result<Laurent<ParameterPolynomial>, Diagnostic> {
        if a.is_zero() || b.is_zero() {
            return Ok(Laurent::zero());
        }
        within_reach(a.lowest() + b.lowest())?;
        self.spend_on_product(&Size::of_symbol(a), &Size::of_symbol(b))?;
        Ok(a.times(b))
    }

    /// `a + b`.
    pub fn sum(
        &mut self,
        a: &Laurent<ParameterPolynomial>,
        b: &Laurent<ParameterPolynomial>,
    ) -> Result<Laurent<ParameterPolynomial>, Diagnostic> {
        if let (Some(a), Some(b)) = (a.support(), b.support()) {
            at_most_terms((a.1.max(b.1) - a.0.min(b.0)).unsigned_abs() + 1)?;
        }
        let (x, y) = (Size::of_symbol(a), Size::of_symbol(b));
        let copies = (x.length + y.length) * 100;
        let additions = (x.terms + y.terms).saturating_mul(operation(x.bits.max(y.bits)));
        self.spend(copies.saturating_add(additions))?;
        Ok(a.plus(b))
    }

    /// The greatest common divisor of two polynomials.
    pub fn gcd(
        &mut self,
        p: &ParameterPolynomial,
        q: &ParameterPolynomial,
    ) -> Result<ParameterPolynomial, Diagnostic> {
        self.spend_on_gcd(&Size::of(p), &Size::of(q))?;
        Ok(p.gcd(q))
    }

    /// `p / divisor`, if the division is exact.
    pub fn exact_quotient(
        &mut self,
        p: &ParameterPolynomial,
        divisor: &ParameterPolynomial,
    ) -> Result<Option<ParameterPolynomial>, Diagnostic> {
        let (x, y) = (Size::of(p), Size::of(divisor));
        // The long division copies what is left of the dividend at every step.
        let copies = x.terms.saturating_mul(x.terms).saturating_mul(100);
        let steps = pairs(&x, &y).saturating_mul(operation(x.bits + y.bits));
        self.spend(copies.saturating_add(steps))?;
        Ok(p.divide_exactly(divisor))
    }

    /// Charges a greatest common divisor.
    pub fn spend_on_gcd(&mut self, p: &Size, q: &Size) -> Result<(), Diagnostic> {
        let exponents = p.exponents_beside(q);
        let sequence = gcd_work(&exponents, (p.degree, q.degree), (p.bits, q.bits));
        // The primitive parts at the beginning, whatever comes then.
        let cleared =
            |size: &Size| size.terms.saturating_mul(4).saturating_mul(operation(size.bits));
        let preparation = cleared(p).saturating_add(cleared(q));
        self.spend(sequence.saturating_add(preparation))
    }

    fn spend_on_product(&mut self, x: &Size, y: &Size) -> Result<(), Diagnostic> {
        let (length, degree) = (x.length + y.length - 1, x.degree + y.degree);
        let bits = x.bits + y.bits;
        let parameters = x.exponents_beside(y).len() as u64;
        let dense = length.saturating_mul(monomials(parameters, degree));
        at_most_terms(length)?;
        at_most_terms(pairs(x, y).min(dense))?;
        if degree > LARGEST_DEGREE {
            return Err(excess(format!(
                "a degree of {degree}; at most {LARGEST_DEGREE} is computed"
            )));
        }
        if bits > MOST_BITS {
            return Err(excess(format!(
                "a number of {bits} bits; at most {MOST_BITS} are computed"
            )));
        }
        self.spend(pairs(x, y).saturating_mul(operation(bits)))
    }
}

/// A greatest common divisor by the subresultant sequence in the first parameter, where the degrees
/// `(d, e)` of the two in each parameter, their total degrees and the bits of their coefficients are
/// given; before it come the contents, which have one parameter less.
///
/// The remainders have coefficients of degree `d_1 e_i + e_1 d_i` in the `i`-th parameter, of total
/// degree at most the product of the total degrees (Bézout), and of `d_1`, `e_1` times the bits.
/// Half of the bits and an eighth of the pairs of terms are those of an average remainder; another
/// third, because input in several parameters is sparse.
fn gcd_work(degrees: &[(u64, u64)], total: (u64, u64), bits: (u64, u64)) -> u64 {
    let Some((&(d, e), rest)) = degrees.split_first() else {
        return 400;
    };
    let bezout = total.0.saturating_mul(total.1);
    let grown = rest.iter().map(|(f, g)| (d * g + e * f).min(bezout));
    let (sum, dense) = grown.fold((0u64, 1u64), |(sum, dense), degree| {
        (sum.saturating_add(degree), dense.saturating_mul(degree + 1))
    });
    let terms = dense.min(monomials(rest.len() as u64, sum.min(bezout)));
    let average = (d.saturating_mul(bits.1)).saturating_add(e.saturating_mul(bits.0)) / 2;
    let remainders = (2 * d.min(e) * (d + e))
        .saturating_mul((terms.saturating_mul(terms) / 24).max(1))
        .saturating_mul(operation(average));
    let inner: Vec<_> = rest.iter().map(|(f, g)| (*f.max(g), *f.max(g))).collect();
    let (degree, height) = (total.0.max(total.1), bits.0.max(bits.1));
    let contents = gcd_work(&inner, (degree, degree), (height, height));
    remainders.saturating_add(contents.saturating_mul(2))
}

/// The number of products of single terms.
fn pairs(x: &Size, y: &Size) -> u64 {
    x.terms.max(x.length).saturating_mul(y.terms.max(y.length))
}

/// One product or sum of rational numbers, and its place in a polynomial. Both take greatest common
/// divisors by shifts and subtractions, quadratic in the bits.
fn operation(bits: u64) -> u64 {
    bits.saturating_mul(90 + bits / 100).saturating_add(1_000)
}

/// The number of monomials of total degree at most `degree`: `C(parameters + degree, degree)`.
fn monomials(parameters: u64, degree: u64) -> u64 {
    let mut count = 1u64;
    for k in 1..=parameters {
        // Exact at every step: C(degree + k, k) = C(degree + k - 1, k - 1) (degree + k) / k.
        match count.checked_mul(degree + k) {
            Some(product) => count = product / k,
            None => return u64::MAX,
        }
    }
    count
}

pub(crate) fn at_most_terms(terms: u64) -> Result<(), Diagnostic> {
    if terms <= MOST_TERMS {
        return Ok(());
    }
    Err(excess(format!("up to {terms} terms; at most {MOST_TERMS} are computed")))
}

fn within_reach(index: i64) -> Result<(), Diagnostic> {
    if index.abs() <= FARTHEST_INDEX {
        return Ok(());
    }
    Err(excess(format!("a power z^{index}; at most z^{FARTHEST_INDEX} is computed")))
}

fn excess(message: impl Into<String>) -> Diagnostic {
    Diagnostic::new("budget", message)
        .with_hint("use smaller exponents, shorter numbers or fewer parameters")
}
