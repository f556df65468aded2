//! Norms of difference schemes as formulas in any number of parameters.

use std::collections::BTreeMap;
use std::fmt;

use refinable_algebra::{
    Integer, Laurent, Ordered, Parameter, ParameterPolynomial, Rational, Ring, clear_denominators,
    integer, rational,
};
use refinable_scheme::{Diagnostic, Normalised};

use crate::budget::Budget;
use crate::difference::DifferenceSymbol;
use crate::power::{next_power, residue_rows};

/// `max_rows Σ_terms factor · |polynomial| / |denominator|`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Norm {
    rows: Vec<NormRow>,
    denominator: ParameterPolynomial,
}

/// `Σ factor · |polynomial|`: positive factors, primitive polynomials, distinct up to sign, ordered.
pub type NormRow = Vec<(Rational, ParameterPolynomial)>;

/// What a comparison of two norms as functions of the parameters has found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Comparison {
    /// The same function: the canonical rows are the same.
    Equal,
    /// Different functions: at this point the values are these.
    Differ {
        /// Where.
        at: BTreeMap<Parameter, Rational>,
        /// The value of the first norm.
        left: Rational,
        /// The value of the second norm.
        right: Rational,
    },
    /// The formulas differ, and so far no point has been found where the values do.
    Unknown,
}

impl Norm {
    /// The largest of sums of absolute values, over a common denominator.
    pub fn new(rows: &[Vec<ParameterPolynomial>], denominator: ParameterPolynomial) -> Self {
        let mut canonical: Vec<NormRow> = Vec::new();
        for row in rows.iter().map(|row| canonical_row(row)) {
            if !canonical.contains(&row) {
                canonical.push(row);
            }
        }
        keep_largest_constant(&mut canonical);
        Norm { rows: canonical, denominator }
    }

    /// `‖c_n^L‖` of a family.
    ///
    /// # Errors
    /// Code `divisibility` if `c_n` does not exist for all parameter values, `budget` if the level
    /// is too large.
    ///
    /// # Cost
    /// The size of `c_n^L` times the length of `c_n`, in sparse polynomials.
    pub fn of_difference(
        mask: &Normalised,
        continuity: usize,
        level: u32,
        budget: Budget,
    ) -> Result<Self, Diagnostic> {
        let symbol = identical_difference(mask, continuity)?;
        let degree =
            symbol.numerator.coefficients().iter().filter_map(ParameterPolynomial::degree).max();
        let (degree, parameters) = (degree.unwrap_or(0), mask.parameters().len() as u32);
        let terms = |l: u32| {
            let monomials = u64::from(degree).saturating_mul(l.into()).saturating_add(1);
            monomials.saturating_pow(parameters)
        };
        budget.admit(symbol.arity, symbol.numerator.coefficients().len(), level, terms)?;
        let c = Laurent::new(0, symbol.numerator.coefficients().to_vec());
        let mut power = c.clone();
        for _ in 1..level {
            power = next_power(&c, &power, symbol.arity);
        }
        let rows = residue_rows(power.coefficients(), symbol.arity.pow(level));
        Ok(Norm::new(&rows, symbol.denominator.power(level)))
    }

    /// The rows, each once.
    pub fn rows(&self) -> &[NormRow] {
        &self.rows
    }

    /// The polynomial below the bar; 1 for polynomial masks.
    pub fn denominator(&self) -> &ParameterPolynomial {
        &self.denominator
    }

    /// The value at a point that gives every parameter a number; `None` at a pole. For many points see [`PointwiseNorm`].
    pub fn value_at(&self, point: &BTreeMap<Parameter, Rational>) -> Option<Rational> {
        let value = |p: &ParameterPolynomial| {
            p.value_at(point).expect("every parameter has a value").absolute()
        };
        let denominator = value(&self.denominator);
        let sums = self.rows.iter().map(|row| {
            row.iter().fold(Rational::zero(), |sum, (factor, p)| sum + factor * value(p))
        });
        let largest = sums.max().unwrap_or_else(Rational::zero);
        (!denominator.is_zero()).then(|| largest / denominator)
    }

    /// Compares two norms as functions of the parameters.
    pub fn compare(&self, other: &Self) -> Comparison {
        let mut sorted = [self.rows.clone(), other.rows.clone()];
        for rows in &mut sorted {
            rows.sort_by_key(row_text);
        }
        if sorted[0] == sorted[1] && self.denominator == other.denominator {
            return Comparison::Equal;
        }
        let mut parameters = self.parameters();
        parameters.extend(other.parameters());
        parameters.sort();
        parameters.dedup();
        for k in 0..TRIALS {
            let at = trial_point(&parameters, k);
            let values = (self.value_at(&at), other.value_at(&at));
            if let (Some(left), Some(right)) = values
                && left != right
            {
                return Comparison::Differ { at, left, right };
            }
        }
        Comparison::Unknown
    }

    fn parameters(&self) -> Vec<Parameter> {
        let rows = self.rows.iter().flatten().map(|(_, p)| p).chain([&self.denominator]);
        rows.flat_map(ParameterPolynomial::parameters).collect()
    }
}

/// Points tried before two different formulas are left undecided.
const TRIALS: i64 = 400;

/// A scattered rational point near the origin, on finer and finer scales: additive recurrences with
/// steps prime to the moduli.
fn trial_point(parameters: &[Parameter], k: i64) -> BTreeMap<Parameter, Rational> {
    let scale = 1_i64 << (k % 8);
    let coordinate = |i: usize| {
        let step = [37, 59, 83, 101][i % 4];
        rational((step * (k + 1)) % 129 - 64, 64 * scale)
    };
    parameters.iter().enumerate().map(|(i, p)| (p.clone(), coordinate(i))).collect()
}

/// Of the rows without parameters only the largest matters.
fn keep_largest_constant(rows: &mut Vec<NormRow>) {
    let constant = |row: &NormRow| -> Option<Rational> {
        row.iter().try_fold(Rational::zero(), |sum, (factor, p)| {
            Some(sum + factor * p.as_constant()?.absolute())
        })
    };
    let largest = rows.iter().filter_map(constant).max();
    let parametric = rows.iter().any(|row| constant(row).is_none());
    rows.retain(|row| match constant(row) {
        None => true,
        value => value == largest && !(row.is_empty() && parametric),
    });
}

/// Merges terms that agree up to a factor, and orders them.
fn canonical_row(row: &[ParameterPolynomial]) -> NormRow {
    let mut terms: NormRow = Vec::new();
    for p in row.iter().filter(|p| !p.is_zero()) {
        let (_, size, primitive) = p.primitive();
        match terms.iter_mut().find(|(_, q)| *q == primitive) {
            Some((factor, _)) => *factor += size,
            None => terms.push((size, primitive)),
        }
    }
    terms.sort_by_cached_key(|(_, p)| p.to_string());
    terms
}

fn row_text(row: &NormRow) -> String {
    let mut text = String::new();
    for (factor, p) in row {
        let plus = if text.is_empty() { "" } else { " + " };
        let one = ParameterPolynomial::one();
        let term = match (*p == one, *factor == Rational::from(integer(1))) {
            (true, _) => factor.to_string(),
            (false, true) => format!("|{p}|"),
            (false, false) => format!("{factor}*|{p}|"),
        };
        text.push_str(plus);
        text.push_str(&term);
    }
    if text.is_empty() { "0".into() } else { text }
}

/// `max{ 4*|alpha|, |1 - 2*alpha| + 2*|beta| }`, over `|denominator|` where there is one.
impl fmt::Display for Norm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: Vec<String> = self.rows.iter().map(row_text).collect();
        let top = match rows.as_slice() {
            [] => "0".to_string(),
            [row] if self.denominator == ParameterPolynomial::one() => row.clone(),
            _ => format!("max{{ {} }}", rows.join(", ")),
        };
        if self.denominator == ParameterPolynomial::one() {
            f.write_str(&top)
        } else {
            write!(f, "{top} / |{:#}|", self.denominator)
        }
    }
}

/// `‖c_n^L‖` of a family at points: numbers first and powers after, without the formula.
#[derive(Clone, Debug)]
pub struct PointwiseNorm {
    symbol: DifferenceSymbol,
    level: u32,
}

impl PointwiseNorm {
    /// The norm of the `level`-th power.
    ///
    /// # Errors
    /// As for [`Norm::of_difference`].
    pub fn new(
        mask: &Normalised,
        continuity: usize,
        level: u32,
        budget: Budget,
    ) -> Result<Self, Diagnostic> {
        let symbol = identical_difference(mask, continuity)?;
        budget.admit(symbol.arity, symbol.numerator.coefficients().len(), level, |_| 1)?;
        Ok(PointwiseNorm { symbol, level })
    }

    /// The value at a point; `None` at a pole, or if the point does not give every parameter a number.
    ///
    /// # Cost
    /// The size of `c_n^L` times the length of `c_n`, in integers over one denominator.
    pub fn value_at(&self, point: &BTreeMap<Parameter, Rational>) -> Option<Rational> {
        let DifferenceSymbol { arity, numerator, denominator, .. } = &self.symbol;
        let value = |p: &ParameterPolynomial| p.value_at(point);
        let coefficients: Vec<Rational> =
            numerator.coefficients().iter().map(value).collect::<Option<_>>()?;
        let (scale, cleared) = clear_denominators(coefficients.iter());
        let c = Laurent::new(0, cleared);
        let power = (1..self.level).fold(c.clone(), |power, _| next_power(&c, &power, *arity));
        let rows = residue_rows(power.coefficients(), arity.pow(self.level));
        let sum = |row: &Vec<Integer>| row.iter().map(Ordered::absolute).sum::<Integer>();
        let largest = Rational::from(rows.iter().map(sum).max().unwrap_or_default());
        let below = Rational::from(scale) * value(denominator)?.absolute();
        (!below.is_zero()).then(|| largest / below.power(self.level))
    }
}

/// The difference symbol, if it exists for all parameter values.
fn identical_difference(
    mask: &Normalised,
    continuity: usize,
) -> Result<DifferenceSymbol, Diagnostic> {
    let symbol = DifferenceSymbol::new(mask, continuity);
    if symbol.exists_identically() {
        return Ok(symbol);
    }
    let order = continuity + 1;
    let message = format!("difference scheme {order} does not exist for all parameter values");
    Err(Diagnostic::new("divisibility", message).with_hint(
        "`refinable degrees` lists the parameter values at which it does; fix them with --set",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_scheme::Scheme;

    fn norm(text: &str, continuity: usize, level: u32) -> Norm {
        let scheme = Scheme::resolve(text, 2).unwrap();
        Norm::of_difference(scheme.mask(), continuity, level, Budget::default()).unwrap()
    }

    /// By hand: c_0 of [w', …] with the four-point mask is -w z³ + w z² + z/2 + … ; at level one
    /// both rows are 2|w| + 1/2.
    #[test]
    fn the_norm_of_the_four_point_scheme_by_hand() {
        let norm = norm("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 0, 1);
        assert_eq!(norm.to_string(), "1/2 + 2*|w|");
    }

    #[test]
    fn equal_functions_compare_equal_whatever_their_form() {
        let w = ParameterPolynomial::parameter(&Parameter::new("w"));
        let half = ParameterPolynomial::constant(rational(1, 2));
        let printed = Norm::new(
            &[vec![w.scaled(&rational(-2, 1)), half.clone()], vec![half, w.clone(), w.negated()]],
            ParameterPolynomial::one(),
        );
        let ours = norm("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 0, 1);
        assert_eq!(ours.compare(&printed), Comparison::Equal);
    }

    #[test]
    fn a_wrong_coefficient_is_found_with_a_witness() {
        let w = ParameterPolynomial::parameter(&Parameter::new("w"));
        let half = ParameterPolynomial::constant(rational(1, 2));
        let wrong = Norm::new(&[vec![w.scaled(&rational(3, 1)), half]], ParameterPolynomial::one());
        let Comparison::Differ { at, left, right } =
            norm("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 0, 1).compare(&wrong)
        else {
            panic!("the functions differ")
        };
        let w = at[&Parameter::new("w")].absolute();
        assert_eq!(left, &w * integer(2) + rational(1, 2));
        assert_eq!(right, w * integer(3) + rational(1, 2));
    }
}
