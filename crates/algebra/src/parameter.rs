//! Named parameters and the monomials they form.

use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// A named tension parameter, such as `alpha`; ordered by name.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Parameter(Arc<str>);

impl Parameter {
    /// The parameter of that name.
    pub fn new(name: &str) -> Self {
        Parameter(name.into())
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

/// A product of powers of parameters; exponents are positive, parameters ascending.
///
/// The order is graded: by total degree, then lexicographic with the first parameter strongest.
/// It is a monomial order (compatible with products), so leading terms multiply.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default)]
pub struct Monomial(Vec<(Parameter, u32)>);

impl Monomial {
    /// The empty product, 1.
    pub fn one() -> Self {
        Monomial(Vec::new())
    }

    /// `parameter^exponent`.
    pub fn power(parameter: Parameter, exponent: u32) -> Self {
        Monomial(if exponent == 0 { Vec::new() } else { vec![(parameter, exponent)] })
    }

    /// The factors `(parameter, exponent)`, parameters ascending.
    pub fn factors(&self) -> &[(Parameter, u32)] {
        &self.0
    }

    /// The total degree.
    pub fn degree(&self) -> u32 {
        self.0.iter().map(|(_, e)| e).sum()
    }

    /// The exponent of `parameter`.
    pub fn exponent(&self, parameter: &Parameter) -> u32 {
        self.0.iter().find(|(p, _)| p == parameter).map_or(0, |(_, e)| *e)
    }

    /// `self · other`.
    pub fn times(&self, other: &Self) -> Self {
        let mut factors = self.0.clone();
        for (parameter, exponent) in &other.0 {
            match factors.binary_search_by(|(p, _)| p.cmp(parameter)) {
                Ok(at) => factors[at].1 += exponent,
                Err(at) => factors.insert(at, (parameter.clone(), *exponent)),
            }
        }
        Monomial(factors)
    }

    /// The monomial with `parameter` set to one.
    pub fn without(&self, parameter: &Parameter) -> Self {
        Monomial(self.0.iter().filter(|(p, _)| p != parameter).cloned().collect())
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree().cmp(&other.degree()).then_with(|| {
            for ((p, e), (q, f)) in self.0.iter().zip(&other.0) {
                match q.cmp(p).then(e.cmp(f)) {
                    Ordering::Equal => {}
                    decided => return decided,
                }
            }
            // Equal degree and equal common part leave nothing over on either side.
            Ordering::Equal
        })
    }
}

impl fmt::Display for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (parameter, exponent)) in self.0.iter().enumerate() {
            let times = if i == 0 { "" } else { "*" };
            match exponent {
                1 => write!(f, "{times}{parameter}")?,
                _ => write!(f, "{times}{parameter}^{exponent}")?,
            }
        }
        Ok(())
    }
}
