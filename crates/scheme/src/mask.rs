//! Masks: the coefficients of a scheme, or of a family of schemes.

use std::collections::BTreeSet;
use std::fmt;

use refinable_algebra::{
    GcdDomain, Laurent, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, rational,
};

use crate::budget::{Budget, Size};
use crate::diagnostic::{Diagnostic, shortened};
use crate::quotient::Quotient;

/// The largest arity.
const LARGEST_ARITY: usize = 1_000;

/// The mask `(a_i)` of a scheme of arity `m`: `f'_i = Σ_j a_{i-mj} f_j`.
///
/// `a_i = numerator_i / denominator`, where the symbol `numerator(z)` has polynomials in the
/// parameters for coefficients and the denominator is the least common one: an integer polynomial,
/// primitive, with a positive leading coefficient, without a factor common to all numerators. So
/// equality of masks is equality of the parts. At least one coefficient is not zero.
///
/// ```
/// use refinable_scheme::Mask;
/// let four_point = Mask::parse("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 2).unwrap();
/// assert_eq!(four_point.support(), (-3, 3));
/// assert!(four_point.is_primal() && four_point.is_interpolatory());
/// assert_eq!(four_point.coefficient(1).to_string(), "1/2 + w");
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Mask {
    arity: usize,
    symbol: Quotient,
}

/// What every mask and every rule begins with.
pub(crate) fn check_arity(arity: usize) -> Result<(), Diagnostic> {
    if (2..=LARGEST_ARITY).contains(&arity) {
        return Ok(());
    }
    let message = format!("the arity is {arity}; it must be from 2 to {LARGEST_ARITY}");
    Err(Diagnostic::new("arity", message))
}

impl Mask {
    /// The mask with `a_{first + k} = coefficients[k]`; zeros at both ends are cut.
    ///
    /// # Errors
    /// `arity` below 2 or above 1000, `zero-mask`, `budget` if the least common denominator is out
    /// of reach.
    pub fn new(
        arity: usize,
        first: i64,
        coefficients: &[ParameterFraction],
    ) -> Result<Self, Diagnostic> {
        let mut budget = Budget::new();
        let parts = coefficients.iter().map(|c| (c.numerator(), c.denominator()));
        let symbol = Quotient::from_list(first, parts, &mut budget)?;
        Mask::of_quotient(arity, symbol, &mut budget)
    }

    /// The mask whose symbol is `symbol`.
    ///
    /// # Errors
    /// `arity` below 2 or above 1000, `zero-mask`.
    pub fn from_symbol(
        arity: usize,
        symbol: Laurent<ParameterPolynomial>,
    ) -> Result<Self, Diagnostic> {
        Mask::of_quotient(arity, Quotient::polynomial(symbol), &mut Budget::new())
    }

    /// Charges in advance the reduction of every single coefficient to lowest terms.
    pub(crate) fn of_quotient(
        arity: usize,
        symbol: Quotient,
        budget: &mut Budget,
    ) -> Result<Self, Diagnostic> {
        check_arity(arity)?;
        if symbol.is_zero() {
            let message = "every coefficient of the mask is zero";
            return Err(Diagnostic::new("zero-mask", message));
        }
        if symbol.has_denominator() {
            let denominator = Size::of(symbol.denominator());
            for c in symbol.numerator().coefficients() {
                budget.spend_on_gcd(&Size::of(c), &denominator)?;
            }
        }
        let mask = Mask { arity, symbol };
        debug_assert!(mask.check_invariants());
        Ok(mask)
    }

    /// The arity `m ≥ 2`: how many new points stand for an old one.
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// The symbol `Σ a_i z^i` times the denominator.
    pub fn numerator(&self) -> &Laurent<ParameterPolynomial> {
        self.symbol.numerator()
    }

    /// The least common denominator of the coefficients.
    pub fn denominator(&self) -> &ParameterPolynomial {
        self.symbol.denominator()
    }

    /// The first and the last index with a nonzero coefficient.
    pub fn support(&self) -> (i64, i64) {
        let support = self.numerator().support();
        support.expect("a mask has a nonzero coefficient")
    }

    /// `a_i`, in lowest terms; zero outside the support.
    pub fn coefficient(&self, index: i64) -> ParameterFraction {
        self.symbol.coefficient(index)
    }

    /// The pairs `(i, a_i)` over the support, zeros inside included.
    pub fn coefficients(&self) -> impl DoubleEndedIterator<Item = (i64, ParameterFraction)> {
        let (lowest, highest) = self.support();
        (lowest..=highest).map(|i| (i, self.coefficient(i)))
    }

    /// The parameters that occur; none for a single scheme.
    pub fn parameters(&self) -> BTreeSet<Parameter> {
        let mut parameters = self.denominator().parameters();
        for c in self.numerator().coefficients() {
            parameters.append(&mut c.parameters());
        }
        parameters
    }

    /// `(hi - lo)/(m - 1)`: the width of the support of the basic limit function.
    pub fn support_width(&self) -> Rational {
        let (lowest, highest) = self.support();
        rational(highest - lowest, self.arity as i64 - 1)
    }

    /// Whether `a(z) = a(1/z)`: the mask is symmetric about index 0.
    ///
    /// # Source
    /// C. Conti, K. Hormann, *Polynomial reproduction for univariate subdivision schemes of any
    /// arity*, J. Approx. Theory 163 (2011), and Definition 1 of the paper on recursive schemes.
    pub fn is_primal(&self) -> bool {
        self.numerator() == &self.numerator().reversed()
    }

    /// Whether `z a(z) = a(1/z)`: the mask is symmetric about index -1/2.
    ///
    /// # Source
    /// As [`is_primal`](Self::is_primal).
    pub fn is_dual(&self) -> bool {
        self.numerator().shifted(1) == self.numerator().reversed()
    }

    /// Whether `a_{mk} = δ_{k0}` identically: every refinement keeps the old points.
    pub fn is_interpolatory(&self) -> bool {
        self.interpolation_conditions().is_empty()
    }

    /// The numerators of the `a_{mk} - δ_{k0}` that are not identically zero, primitive, each once,
    /// in the order of `k`. The scheme is interpolatory exactly where all of them vanish.
    ///
    /// ```
    /// use refinable_scheme::Scheme;
    /// let a4 = Scheme::resolve("a4", 2).unwrap();
    /// assert_eq!(a4.mask().interpolation_conditions()[0].to_string(), "alpha");
    /// ```
    pub fn interpolation_conditions(&self) -> Vec<ParameterPolynomial> {
        let (lowest, highest) = self.support();
        let differences = (lowest.min(0)..=highest.max(0))
            .filter(|i| i.rem_euclid(self.arity as i64) == 0)
            .map(|i| match (i, self.numerator().coefficient(i)) {
                (0, c) => c.minus(self.denominator()),
                (_, c) => c,
            });
        primitive_conditions(differences)
    }

    /// The numerators of the sums `Σ_j a_{ε-mj}` of the stencils, `ε = 0, …, m-1`; over the
    /// denominator they are the sums themselves.
    pub(crate) fn stencil_numerators(&self) -> Vec<ParameterPolynomial> {
        let mut sums = vec![ParameterPolynomial::zero(); self.arity];
        for (i, c) in self.numerator().terms() {
            let sum = &mut sums[i.rem_euclid(self.arity as i64) as usize];
            sum.add_product(c, &ParameterPolynomial::one());
        }
        sums
    }

    /// The sums `Σ_j a_{ε-mj}` of the stencils `ε = 0, …, m-1`; all of them are 1 in a scheme that
    /// converges.
    pub fn stencil_sums(&self) -> Vec<ParameterFraction> {
        let sums = self.stencil_numerators().into_iter();
        sums.map(|sum| {
            ParameterFraction::new(sum, self.denominator()).expect("the denominator is not zero")
        })
        .collect()
    }

    /// The mask with `parameter` replaced by `value`.
    ///
    /// # Errors
    /// `pole` if a denominator vanishes identically after the substitution, `zero-mask`, `budget`.
    pub fn substitute(
        &self,
        parameter: &Parameter,
        value: &ParameterFraction,
    ) -> Result<Self, Diagnostic> {
        self.substitute_within(parameter, value, &mut Budget::new())
    }

    pub(crate) fn substitute_within(
        &self,
        parameter: &Parameter,
        value: &ParameterFraction,
        budget: &mut Budget,
    ) -> Result<Self, Diagnostic> {
        let symbol = self.symbol.substitute(parameter, value, budget);
        let symbol = symbol.map_err(|error| match error.code() {
            "pole" => self.pole_at(&format!("{parameter} = {}", shortened(value))),
            _ => error,
        })?;
        Mask::of_quotient(self.arity, symbol, budget)
    }

    pub(crate) fn pole_at(&self, place: &str) -> Diagnostic {
        let message = format!("the mask has a pole at {place}");
        Diagnostic::new("pole", message).with_hint(format!(
            "its denominator {} vanishes there",
            shortened(format!("{:#}", self.denominator()))
        ))
    }

    /// Whether the promises of the type hold.
    pub fn check_invariants(&self) -> bool {
        let unit = self.denominator().unit_part();
        self.arity >= 2 && !self.numerator().is_zero() && unit == ParameterPolynomial::one()
    }
}

/// The polynomials that are not identically zero, primitive, each once: conditions for all of them to vanish.
pub(crate) fn primitive_conditions(
    polynomials: impl Iterator<Item = ParameterPolynomial>,
) -> Vec<ParameterPolynomial> {
    let mut conditions = Vec::new();
    for p in polynomials.filter(|p| !p.is_zero()) {
        let primitive = p.primitive().2;
        if !conditions.contains(&primitive) {
            conditions.push(primitive);
        }
    }
    conditions
}

/// `[a_lo, …, a_hi] @ lo`: the notation that [`Mask::parse`] reads back.
impl fmt::Display for Mask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let entries: Vec<_> = self.coefficients().map(|(_, c)| c.to_string()).collect();
        f.pad(&format!("[{}] @ {}", entries.join(", "), self.support().0))
    }
}
