//! Difference schemes of a family.

use refinable_algebra::{Integer, Laurent, Parameter, ParameterPolynomial, Polynomial, Ring};
use refinable_scheme::Normalised;

/// The symbol `c_n(z) = m^n a(z) / σ(z)^(n+1)`, `σ(z) = 1 + z + … + z^(m-1)`, of the scheme that
/// refines the `(n+1)`-st differences, up to a power of `z`; for `m = 2` it is
/// `2^n a(z)/(1+z)^(n+1)`.
///
/// Where `σ^(n+1)` does not divide `a` identically the quotient is that of division with
/// remainder: it is `c_n` exactly at those parameter values at which the remainder vanishes.
///
/// `S_a` is C^n if `S_{c_n}` is contractive (Dyn 1992; Theorem 2.2 of Hameed and Mustafa).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DifferenceSymbol {
    /// The arity `m` of the scheme.
    pub arity: usize,
    /// The order `n` of continuity in question.
    pub continuity: usize,
    /// The numerator of `c_n`.
    pub numerator: Laurent<ParameterPolynomial>,
    /// The remainder's coefficients, all zero where `c_n` exists.
    pub remainder: Laurent<ParameterPolynomial>,
    /// The common denominator of `c_n`.
    pub denominator: ParameterPolynomial,
}

impl DifferenceSymbol {
    /// The `n`-th difference symbol of the family.
    ///
    /// # Cost
    /// `n + 1` passes over the mask.
    pub fn new(mask: &Normalised, continuity: usize) -> Self {
        let arity = mask.arity();
        let scale = ParameterPolynomial::from_i64(arity as i64).power(continuity as u32);
        let (quotient, remainder) = mask.numerator().divide_by_geometric(arity, continuity + 1);
        DifferenceSymbol {
            arity,
            continuity,
            numerator: quotient.scaled(&scale),
            remainder,
            denominator: mask.denominator().clone(),
        }
    }

    /// Whether `c_n` exists for all parameter values.
    pub fn exists_identically(&self) -> bool {
        self.remainder.is_zero()
    }
}

/// A difference symbol in at most one parameter with all denominators cleared: the integer trick.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ClearedSymbol {
    /// The arity.
    pub arity: usize,
    /// `C`, with `c_n = C / D`.
    pub numerator: Laurent<Polynomial<Integer>>,
    /// `D`; its real zeros are the poles of the family.
    pub denominator: Polynomial<Integer>,
    /// The polynomials that vanish where `c_n` exists.
    pub remainder: Vec<Polynomial<Integer>>,
}

impl ClearedSymbol {
    /// The symbol as one in `parameter`; `None` if another parameter occurs.
    pub fn new(symbol: &DifferenceSymbol, parameter: &Parameter) -> Option<Self> {
        let univariate = |p: &ParameterPolynomial| p.univariate(parameter);
        let coefficients: Option<Vec<_>> =
            symbol.numerator.coefficients().iter().map(univariate).collect();
        let (coefficients, denominator) = (coefficients?, univariate(&symbol.denominator)?);
        let all = coefficients.iter().chain([&denominator]);
        let rationals = all.flat_map(Polynomial::coefficients);
        let (common, cleared) = refinable_algebra::clear_denominators(rationals);
        let content =
            cleared.iter().fold(Integer::zero(), |g, c| refinable_algebra::GcdDomain::gcd(&g, c));
        // Multiply by `common`, divide by `content`: the smallest integers in this ratio.
        let scale = refinable_algebra::Rational::new(common, content);
        let clear =
            |p: &Polynomial<_>| p.scaled(&scale).map(refinable_algebra::Rational::to_integer);
        let remainder: Option<Vec<_>> = symbol
            .remainder
            .coefficients()
            .iter()
            .map(|p| univariate(p).map(|p| p.cleared().1))
            .collect();
        Some(ClearedSymbol {
            arity: symbol.arity,
            numerator: Laurent::new(0, coefficients.iter().map(clear).collect()),
            denominator: clear(&denominator),
            remainder: remainder?.into_iter().filter(|p| !p.is_zero()).collect(),
        })
    }

    /// The number of coefficients of `c_n`, zeros inside included.
    pub fn length(&self) -> usize {
        self.numerator.coefficients().len()
    }

    /// The largest degree in the parameter.
    pub fn parameter_degree(&self) -> usize {
        let all = self.numerator.coefficients().iter().chain([&self.denominator]);
        all.filter_map(Polynomial::degree).max().unwrap_or(0)
    }
}
