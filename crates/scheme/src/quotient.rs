//! Symbols over a common denominator: what expressions evaluate to and masks are made of.

use std::collections::BTreeMap;

use refinable_algebra::{
    Domain, GcdDomain, Laurent, Monomial, Parameter, ParameterFraction, ParameterPolynomial, Ring,
};

use crate::budget::Budget;
use crate::diagnostic::Diagnostic;

/// `numerator(z) / denominator` in lowest terms: the denominator is an integer polynomial in the
/// parameters, primitive, with a positive leading coefficient, and no factor of it divides every
/// coefficient of the numerator. So equality is equality of the parts.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Quotient {
    numerator: Laurent<ParameterPolynomial>,
    denominator: ParameterPolynomial,
}

impl Quotient {
    pub fn polynomial(numerator: Laurent<ParameterPolynomial>) -> Self {
        Quotient { numerator, denominator: ParameterPolynomial::one() }
    }

    pub fn constant(c: ParameterPolynomial) -> Self {
        Quotient::polynomial(Laurent::monomial(c, 0))
    }

    /// `numerator / denominator`, reduced.
    ///
    /// # Errors
    /// `pole` for a zero denominator, `budget`.
    pub fn new(
        numerator: Laurent<ParameterPolynomial>,
        denominator: ParameterPolynomial,
        budget: &mut Budget,
    ) -> Result<Self, Diagnostic> {
        if denominator.is_zero() {
            return Err(pole());
        }
        if numerator.is_zero() || denominator == ParameterPolynomial::one() {
            return Ok(Quotient::polynomial(numerator));
        }
        let common = common_factor(&numerator, &denominator, budget)?;
        let reduced = quotient(&denominator, &common, budget)?;
        let unit = reduced.unit_part();
        let divisor = common.times(&unit);
        let coefficients = numerator.coefficients().iter();
        let divided = coefficients.map(|c| quotient(c, &divisor, budget));
        Ok(Quotient {
            numerator: Laurent::new(numerator.lowest(), divided.collect::<Result<_, _>>()?),
            denominator: reduced.quotient(&unit),
        })
    }

    /// `Σ_k z^(first+k) p_k/q_k`, over the least common denominator of the `parts` `(p_k, q_k)`.
    ///
    /// # Errors
    /// `budget`.
    pub fn from_list<'a>(
        first: i64,
        parts: impl Iterator<Item = (&'a ParameterPolynomial, &'a ParameterPolynomial)> + Clone,
        budget: &mut Budget,
    ) -> Result<Self, Diagnostic> {
        let mut common = ParameterPolynomial::one();
        for (_, denominator) in parts.clone() {
            if denominator != &ParameterPolynomial::one() {
                let shared = budget.gcd(&common, denominator)?;
                common = product(&common, &quotient(denominator, &shared, budget)?, budget)?;
            }
        }
        let raised = parts.map(|(p, q)| product(p, &quotient(&common, q, budget)?, budget));
        let numerator = Laurent::new(first, raised.collect::<Result<_, _>>()?);
        Quotient::new(numerator, common, budget)
    }

    /// The numerator, a Laurent polynomial in `z`.
    pub fn numerator(&self) -> &Laurent<ParameterPolynomial> {
        &self.numerator
    }

    /// The denominator, free of `z`.
    pub fn denominator(&self) -> &ParameterPolynomial {
        &self.denominator
    }

    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    pub fn has_denominator(&self) -> bool {
        self.denominator != ParameterPolynomial::one()
    }

    pub fn negated(&self) -> Self {
        Quotient { numerator: self.numerator.negated(), ..self.clone() }
    }

    pub fn plus(&self, other: &Self, budget: &mut Budget) -> Result<Self, Diagnostic> {
        if self.denominator == other.denominator {
            let sum = budget.sum(&self.numerator, &other.numerator)?;
            return Quotient::new(sum, self.denominator.clone(), budget);
        }
        let left = budget.product(&self.numerator, &constant(&other.denominator))?;
        let right = budget.product(&other.numerator, &constant(&self.denominator))?;
        let sum = budget.sum(&left, &right)?;
        let denominator = product(&self.denominator, &other.denominator, budget)?;
        Quotient::new(sum, denominator, budget)
    }

    pub fn times(&self, other: &Self, budget: &mut Budget) -> Result<Self, Diagnostic> {
        let numerator = budget.product(&self.numerator, &other.numerator)?;
        let denominator = product(&self.denominator, &other.denominator, budget)?;
        Quotient::new(numerator, denominator, budget)
    }

    /// `self / divisor`, for a divisor that is a monomial in `z` or divides exactly.
    ///
    /// # Errors
    /// `pole` for a zero divisor; `symbol` if the result is not a Laurent polynomial in `z`; `budget`.
    pub fn divided_by(&self, divisor: &Self, budget: &mut Budget) -> Result<Self, Diagnostic> {
        let Some((lowest, highest)) = divisor.numerator.support() else {
            return Err(pole());
        };
        let by_denominator = budget.product(&self.numerator, &constant(&divisor.denominator))?;
        if lowest == highest {
            let shifted = budget.product(&by_denominator, &power_of_z(-lowest))?;
            let leading = divisor.numerator.coefficient(lowest);
            let denominator = product(&self.denominator, &leading, budget)?;
            return Quotient::new(shifted, denominator, budget);
        }
        let quotient = divide_exactly(&by_denominator, &divisor.numerator, budget)?;
        Quotient::new(quotient, self.denominator.clone(), budget)
    }

    /// `self^exponent`; a negative power only of a monomial in `z`.
    ///
    /// # Errors
    /// As [`divided_by`](Self::divided_by).
    pub fn power(&self, exponent: i32, budget: &mut Budget) -> Result<Self, Diagnostic> {
        let one = Quotient::constant(ParameterPolynomial::one());
        let base = if exponent < 0 { one.divided_by(self, budget)? } else { self.clone() };
        let mut rest = exponent.unsigned_abs();
        let (mut power, mut square) = (one, base);
        while rest > 0 {
            if rest % 2 == 1 {
                power = power.coprime_product(&square, budget)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.coprime_product(&square, budget)?;
            }
        }
        Ok(power)
    }

    /// The product of two powers of one quotient: by Gauss's lemma nothing cancels.
    fn coprime_product(&self, other: &Self, budget: &mut Budget) -> Result<Self, Diagnostic> {
        Ok(Quotient {
            numerator: budget.product(&self.numerator, &other.numerator)?,
            denominator: product(&self.denominator, &other.denominator, budget)?,
        })
    }

    /// `self` with `parameter` replaced by `value`, which must be free of `z`.
    ///
    /// With `value = p/q` and `D` the degree of `self` in the parameter, numerator and denominator
    /// `Σ c_k t^k` both become `Σ c_k p^k q^(D-k)`.
    ///
    /// # Errors
    /// `pole` if the denominator vanishes identically after the substitution; `budget`.
    pub fn substitute(
        &self,
        parameter: &Parameter,
        value: &ParameterFraction,
        budget: &mut Budget,
    ) -> Result<Self, Diagnostic> {
        let numerator = by_powers(&self.numerator, parameter);
        let denominator = by_powers(&constant(&self.denominator), parameter);
        let degree = numerator.len().max(denominator.len()) - 1;
        let powers = homogeneous_powers(value, degree, budget)?;
        let numerator = combine(&numerator, &powers, budget)?;
        let denominator = combine(&denominator, &powers, budget)?;
        Quotient::new(numerator, denominator.coefficient(0), budget)
    }

    /// The coefficient of `z^index`, in lowest terms.
    pub fn coefficient(&self, index: i64) -> ParameterFraction {
        let numerator = self.numerator.coefficient(index);
        if self.has_denominator() {
            ParameterFraction::new(numerator, &self.denominator)
                .expect("the denominator is not zero")
        } else {
            numerator.into()
        }
    }
}

fn pole() -> Diagnostic {
    Diagnostic::new("pole", "division by an expression that is identically zero")
}

fn constant(c: &ParameterPolynomial) -> Laurent<ParameterPolynomial> {
    Laurent::monomial(c.clone(), 0)
}

fn power_of_z(exponent: i64) -> Laurent<ParameterPolynomial> {
    Laurent::monomial(ParameterPolynomial::one(), exponent)
}

/// `p · q` within the budget.
pub(crate) fn product(
    p: &ParameterPolynomial,
    q: &ParameterPolynomial,
    budget: &mut Budget,
) -> Result<ParameterPolynomial, Diagnostic> {
    Ok(budget.product(&constant(p), &constant(q))?.coefficient(0))
}

/// The greatest common divisor of the denominator and all coefficients of the numerator.
///
/// Only the parameters of the denominator matter: a common divisor is free of the others, so it
/// divides a coefficient iff it divides that coefficient's parts by powers of the others.
fn common_factor(
    numerator: &Laurent<ParameterPolynomial>,
    denominator: &ParameterPolynomial,
    budget: &mut Budget,
) -> Result<ParameterPolynomial, Diagnostic> {
    let mut common = denominator.primitive().2;
    for coefficient in numerator.coefficients() {
        for part in parts_over(coefficient, denominator) {
            if common.as_constant().is_some() {
                return Ok(ParameterPolynomial::one());
            }
            common = budget.gcd(&common, &part)?;
        }
    }
    Ok(common)
}

/// The coefficients of `polynomial` by monomials in the parameters that `denominator` lacks.
fn parts_over(
    polynomial: &ParameterPolynomial,
    denominator: &ParameterPolynomial,
) -> Vec<ParameterPolynomial> {
    let kept = denominator.parameters();
    let mut parts: BTreeMap<Monomial, ParameterPolynomial> = BTreeMap::new();
    for (monomial, c) in polynomial.terms() {
        let (mut inner, mut outer) = (monomial.clone(), monomial.clone());
        for (parameter, _) in monomial.factors() {
            if kept.contains(parameter) {
                outer = outer.without(parameter);
            } else {
                inner = inner.without(parameter);
            }
        }
        let term = ParameterPolynomial::term(c.clone(), inner);
        let part = parts.entry(outer).or_default();
        part.add_product(&term, &ParameterPolynomial::one());
    }
    parts.into_values().collect()
}

/// `p / divisor`, known to be exact.
fn quotient(
    p: &ParameterPolynomial,
    divisor: &ParameterPolynomial,
    budget: &mut Budget,
) -> Result<ParameterPolynomial, Diagnostic> {
    let quotient = budget.exact_quotient(p, divisor)?;
    Ok(quotient.expect("the theorem behind this step makes the division exact"))
}

/// `dividend / divisor` in `z` by long division from the top, if it is exact.
fn divide_exactly(
    dividend: &Laurent<ParameterPolynomial>,
    divisor: &Laurent<ParameterPolynomial>,
    budget: &mut Budget,
) -> Result<Laurent<ParameterPolynomial>, Diagnostic> {
    let (lowest, highest) = divisor.support().ok_or_else(pole)?;
    let leading = divisor.coefficient(highest);
    let mut rest = dividend.clone();
    let mut descending = Vec::new();
    let mut shift = dividend.support().map_or(0, |(_, top)| top - highest);
    while rest.support().is_some() && shift + lowest >= rest.lowest() {
        let top = rest.coefficient(shift + highest);
        let Some(c) = budget.exact_quotient(&top, &leading)? else {
            return Err(remainder());
        };
        let taken = budget.product(divisor, &Laurent::monomial(c.negated(), shift))?;
        rest = budget.sum(&rest, &taken)?;
        descending.push(c);
        shift -= 1;
    }
    if !rest.is_zero() {
        return Err(remainder());
    }
    descending.reverse();
    Ok(Laurent::new(shift + 1, descending))
}

fn remainder() -> Diagnostic {
    let message =
        "a symbol is a Laurent polynomial: this division by an expression in `z` leaves a rest";
    Diagnostic::new("symbol", message)
        .with_hint("divide by powers of `z` only, or where the division is exact")
}

/// The parts of `symbol` by powers of `parameter`, from the 0-th on; at least one.
fn by_powers(
    symbol: &Laurent<ParameterPolynomial>,
    parameter: &Parameter,
) -> Vec<Laurent<ParameterPolynomial>> {
    let collected: Vec<_> = symbol.coefficients().iter().map(|c| c.collected(parameter)).collect();
    let length = collected.iter().map(|c| c.coefficients().len()).max();
    (0..length.unwrap_or(0).max(1))
        .map(|k| {
            let part = collected.iter().map(|c| c.coefficient(k)).collect();
            Laurent::new(symbol.lowest(), part)
        })
        .collect()
}

/// `p^k q^(degree-k)` for `k = 0..=degree`, where `value = p/q`.
fn homogeneous_powers(
    value: &ParameterFraction,
    degree: usize,
    budget: &mut Budget,
) -> Result<Vec<ParameterPolynomial>, Diagnostic> {
    let mut up_to = |base: &ParameterPolynomial| {
        let mut powers = vec![ParameterPolynomial::one()];
        for k in 0..degree {
            powers.push(product(&powers[k], base, budget)?);
        }
        Ok::<_, Diagnostic>(powers)
    };
    let (above, below) = (up_to(value.numerator())?, up_to(value.denominator())?);
    let both = above.iter().zip(below.iter().rev());
    both.map(|(p, q)| product(p, q, budget)).collect()
}

/// `Σ_k parts[k] · powers[k]`.
fn combine(
    parts: &[Laurent<ParameterPolynomial>],
    powers: &[ParameterPolynomial],
    budget: &mut Budget,
) -> Result<Laurent<ParameterPolynomial>, Diagnostic> {
    let mut sum = Laurent::zero();
    for (part, power) in parts.iter().zip(powers) {
        let product = budget.product(part, &constant(power))?;
        sum = budget.sum(&sum, &product)?;
    }
    Ok(sum)
}
