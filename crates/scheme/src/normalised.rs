//! Masks whose stencils are affine combinations: the precondition of every analysis, as a type.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Deref;

use refinable_algebra::{
    GcdDomain, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring,
};

use crate::diagnostic::{Diagnostic, shortened};
use crate::mask::{Mask, primitive_conditions};

/// `σ(z)` as text: `1 + z`, `1 + z + z^2`, `1 + z + ... + z^3`.
pub fn geometric_factor(arity: usize) -> String {
    match arity {
        2 => "1 + z".into(),
        3 => "1 + z + z^2".into(),
        _ => format!("1 + z + ... + z^{}", arity - 1),
    }
}

/// How many stencils an error lists.
const LISTED: usize = 6;

/// A mask each of whose stencils sums to 1, whatever the parameters: `Σ_j a_{ε-mj} = 1` for every
/// `ε`, without which no scheme converges.
///
/// ```
/// use refinable_scheme::{Mask, Normalised};
/// let halved = Mask::parse("1/16*[1, 4, 6, 4, 1]", 2).unwrap();
/// let error = Normalised::new(halved).unwrap_err();
/// assert_eq!(error.hint(), Some("multiply the mask by 2"));
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Normalised(Mask);

impl Normalised {
    /// The mask, if it keeps the promise of the type.
    ///
    /// # Errors
    /// `not-normalised`, with the sums of the stencils; the hint says by what to multiply, or under
    /// which condition on the parameters the sums are 1.
    pub fn new(mask: Mask) -> Result<Self, Diagnostic> {
        if is_normalised(&mask) { Ok(Normalised(mask)) } else { Err(rejection(&mask)) }
    }

    /// The mask with `parameter` replaced by `value`; what held for all parameters still holds.
    ///
    /// # Errors
    /// Those of [`Mask::substitute`].
    pub fn substitute(
        &self,
        parameter: &Parameter,
        value: &ParameterFraction,
    ) -> Result<Self, Diagnostic> {
        let result = Normalised(self.0.substitute(parameter, value)?);
        debug_assert!(result.check_invariants());
        Ok(result)
    }

    /// The mask at values of all its parameters, in their order, taken together: `a/b` has a pole at `a = b = 0`, which
    /// one substitution after the other hides.
    ///
    /// # Errors
    /// Code `substitution` for another number of values, `pole` if the denominator vanishes there; those of
    /// [`Mask::substitute`].
    pub fn at(&self, values: &[Rational]) -> Result<Self, Diagnostic> {
        let parameters = self.parameters();
        if parameters.len() != values.len() {
            let message = format!("{} values for {} parameters", values.len(), parameters.len());
            return Err(Diagnostic::new("substitution", message));
        }
        let point: BTreeMap<_, _> =
            parameters.iter().cloned().zip(values.iter().cloned()).collect();
        if self.denominator().value_at(&point).is_some_and(|d| d.is_zero()) {
            let places: Vec<String> = point.iter().map(|(p, x)| format!("{p} = {x}")).collect();
            return Err(self.pole_at(&places.join(", ")));
        }
        parameters.iter().zip(values).try_fold(self.clone(), |mask, (parameter, value)| {
            let value = ParameterPolynomial::constant(value.clone()).into();
            mask.substitute(parameter, &value)
        })
    }

    /// Whether the promise of the type holds.
    pub fn check_invariants(&self) -> bool {
        is_normalised(&self.0) && self.0.check_invariants()
    }
}

impl Deref for Normalised {
    type Target = Mask;
    fn deref(&self) -> &Mask {
        &self.0
    }
}

impl fmt::Display for Normalised {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

fn is_normalised(mask: &Mask) -> bool {
    let sums = mask.stencil_numerators();
    sums.iter().all(|sum| sum == mask.denominator())
}

fn rejection(mask: &Mask) -> Diagnostic {
    let sums = mask.stencil_sums();
    let wrong: Vec<_> = sums
        .iter()
        .enumerate()
        .filter(|(_, sum)| sum.as_constant() != Some(Rational::one()))
        .collect();
    let listed: Vec<_> = wrong
        .iter()
        .take(LISTED)
        .map(|(e, sum)| format!("stencil {e} sums to {}", shortened(sum)))
        .collect();
    let more = if wrong.len() > LISTED { ", …" } else { "" };
    let message = format!("every stencil of a scheme sums to 1, but {}{more}", listed.join(", "));
    let error = Diagnostic::new("not-normalised", message);
    match advice(mask, &sums) {
        Some(advice) => error.with_hint(advice),
        None => error.with_hint("check the entries, their number and the arity"),
    }
}

fn advice(mask: &Mask, sums: &[ParameterFraction]) -> Option<String> {
    let constants: Option<Vec<Rational>> =
        sums.iter().map(ParameterFraction::as_constant).collect();
    if let Some(constants) = constants {
        let c = constants.first()?;
        let same = !c.is_zero() && constants.iter().all(|d| d == c);
        return same.then(|| format!("multiply the mask by {}", Rational::one() / c));
    }
    let conditions = conditions(mask);
    let never = |p: &ParameterPolynomial| p.as_constant().is_some_and(|c| !c.is_zero());
    // For one parameter, if it is easily told: whether all sums are 1 anywhere.
    let is_easy = mask.parameters().len() == 1
        && conditions.len() <= LISTED
        && conditions.iter().all(|c| c.degree() <= Some(24));
    let common = || conditions.iter().fold(ParameterPolynomial::zero(), |common, c| common.gcd(c));
    if conditions.iter().any(never) || is_easy && never(&common()) {
        return None;
    }
    let equation = |c: &ParameterPolynomial| format!("{} = 0", shortened(format!("{c:#}")));
    let equations: Vec<_> = conditions.iter().take(LISTED).map(equation).collect();
    let joint = match conditions.as_slice() {
        [single] => solved(single).map(|set| format!(", say with `--set '{set}'`")),
        _ => Some(", to be arranged with `--set`".into()),
    };
    let joint = joint.unwrap_or_else(|| ", to be arranged with `--set`".into());
    Some(format!("the sums are 1 where {}{joint}", equations.join(" and ")))
}

/// The polynomials whose common zeros are the parameters with normalised stencils, primitive.
fn conditions(mask: &Mask) -> Vec<ParameterPolynomial> {
    let sums = mask.stencil_numerators().into_iter();
    primitive_conditions(sums.map(|sum| sum.minus(mask.denominator())))
}

/// The condition solved for a parameter in which it is linear with a constant coefficient.
fn solved(condition: &ParameterPolynomial) -> Option<String> {
    condition.parameters().iter().find_map(|parameter| {
        let collected = condition.collected(parameter);
        let [constant, linear] = collected.coefficients() else {
            return None;
        };
        let value = constant.scaled(&(-Rational::one() / linear.as_constant()?));
        let set = format!("{parameter}={value}");
        // What is cut cannot be pasted.
        (shortened(&set) == set).then_some(set)
    })
}
