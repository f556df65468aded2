//! Families that run along a line of masks.

use refinable_algebra::{
    Integer, Laurent, Matrix, Parameter, Polynomial, Rational, Ring, clear_denominators,
};
use refinable_certificate::{Curve, Family, Number, Quotient};
use refinable_reals::{RealAlgebraic, Region, simple_roots};
use refinable_scheme::{Diagnostic, Normalised};
use refinable_spectral::Pencil;

use crate::budget::{expect_readable_words, unreadable};
use crate::difference::ClearedSymbol;
use crate::rational_map::RationalMap;

/// A line of masks `p + x q`, and how a family runs along it: its mask is that at `x = P(t)/Q(t)`.
///
/// A family that is affine in its parameter is the line itself, `x = t`. Many others run along a
/// line too: the curves in the plane of the tensions along which the degree of a family rises are
/// straight in the coefficients.
#[derive(Clone, Debug)]
pub struct Line {
    name: String,
    arity: usize,
    parameter: Option<Parameter>,
    base: Laurent<Rational>,
    direction: Laurent<Rational>,
    curve: Option<Along>,
}

/// The mask `numerators / denominator` in the family's own parameter, and `x` there.
#[derive(Clone, Debug)]
struct Along {
    numerators: Laurent<Polynomial<Rational>>,
    denominator: Polynomial<Rational>,
    line: (Polynomial<Rational>, Polynomial<Rational>),
}

impl Along {
    fn change(&self) -> RationalMap<'_> {
        RationalMap::new(&self.line.0, &self.line.1)
    }
}

impl Line {
    /// The line that the family runs along; `None` if there is none, or if more than one parameter
    /// is free.
    pub fn new(name: &str, mask: &Normalised) -> Option<Self> {
        let parameters = mask.parameters();
        let mut parameters = parameters.into_iter();
        let (parameter, None) = (parameters.next(), parameters.next()) else { return None };
        // Any name serves where none occurs.
        let t = parameter.clone().unwrap_or_else(|| Parameter::new("t"));
        let univariate = |p: &_| refinable_algebra::ParameterPolynomial::univariate(p, &t);
        let coefficients: Option<Vec<_>> =
            mask.numerator().coefficients().iter().map(univariate).collect();
        let numerators = Laurent::new(mask.numerator().lowest(), coefficients?);
        let denominator = univariate(mask.denominator())?;
        let name = name.to_string();
        let arity = mask.arity();
        let line = |base, direction, curve| Line { name, arity, parameter, base, direction, curve };
        if denominator.is_constant() && degree(&numerators) <= 1 {
            let inverse = denominator.coefficient(0).recip();
            let part = |k| numerators.map(|c| c.coefficient(k) * &inverse);
            return Some(line(part(0), part(1), None));
        }
        let along = numerators.coefficients().iter().find_map(|guide| {
            let parts: Option<Vec<_>> = numerators
                .coefficients()
                .iter()
                .map(|c| combination(c, &denominator, guide))
                .collect();
            parts.map(|parts| (guide.clone(), parts))
        });
        let (guide, parts) = along?;
        let lowest = numerators.lowest();
        let base = Laurent::new(lowest, parts.iter().map(|p| p.0.clone()).collect());
        let direction = Laurent::new(lowest, parts.iter().map(|p| p.1.clone()).collect());
        let curve = Along { numerators, line: (guide, denominator.clone()), denominator };
        Some(line(base, direction, Some(curve)))
    }

    /// The line of masks `base + x direction` with the parameter `x`, or a single mask without one.
    pub(crate) fn through(
        name: &str,
        arity: usize,
        parameter: Option<Parameter>,
        [base, direction]: [Laurent<Rational>; 2],
    ) -> Self {
        Line { name: name.into(), arity, parameter, base, direction, curve: None }
    }

    /// `c_n` on the line, in integers over a common denominator.
    ///
    /// # Panics
    /// If `σ^(n+1)` does not divide the symbol.
    pub(crate) fn difference_symbol(&self, continuity: usize) -> ClearedSymbol {
        let scale = Rational::from_i64(self.arity as i64).power(continuity as u32);
        let (quotient, remainder) = self.symbol().divide_by_geometric(self.arity, continuity + 1);
        assert!(remainder.is_zero(), "the order divides");
        let affine = quotient.map(|c| c.scaled(&scale));
        let entries = affine.coefficients().iter().flat_map(Polynomial::coefficients);
        let (denominator, _) = clear_denominators(entries);
        let scale = Rational::from(denominator.clone());
        ClearedSymbol {
            arity: self.arity,
            numerator: affine.map(|c| c.scaled(&scale).map(Rational::to_integer)),
            denominator: Polynomial::constant(denominator),
            remainder: Vec::new(),
        }
    }

    /// The conditions on `x` for `σ^order` to divide the symbol: polynomials that must vanish.
    pub(crate) fn divisibility(&self, order: usize) -> Vec<Polynomial<Integer>> {
        let (_, remainder) = self.symbol().divide_by_geometric(self.arity, order);
        let conditions = remainder.coefficients().iter().filter(|c| !c.is_zero());
        conditions.map(|c| c.cleared().1).collect()
    }

    /// The symbol as a polynomial in `z` with coefficients in `x`.
    pub(crate) fn symbol(&self) -> Laurent<Polynomial<Rational>> {
        let base = self.base.map(|c| Polynomial::constant(c.clone()));
        base.plus(&self.direction.map(|c| Polynomial::monomial(c.clone(), 1)))
    }

    /// The set of the family's parameter whose `x` is in a set of the line.
    pub fn pull_back(&self, region: &Region) -> Region {
        match &self.curve {
            None => region.clone(),
            Some(curve) => curve.change().preimage(region),
        }
    }

    /// Bounds of the `x` of an interval of the family's parameter that holds no pole, up to `2^-60` in the
    /// parameter where the curve turns round; `None` if an end is a pole.
    pub(crate) fn span(&self, ends: &[Rational; 2]) -> Option<[Rational; 2]> {
        let Some(curve) = &self.curve else { return Some(ends.clone()) };
        let change = curve.change();
        let inside = Region::open(ends[0].clone(), ends[1].clone());
        let turns = change.turns().into_iter().filter(|t| inside.contains(t)).map(nearby);
        let values: Option<Vec<Rational>> =
            ends.iter().cloned().chain(turns).map(|t| change.value(&t)).collect();
        let values = values?;
        Some([values.iter().min()?.clone(), values.iter().max()?.clone()])
    }

    /// The values of the family's parameter at `x`, up to `2^-60` where they are irrational.
    pub(crate) fn lift(&self, x: &Rational) -> Vec<Rational> {
        match &self.curve {
            None => vec![x.clone()],
            Some(curve) => {
                curve.change().inverse(&x.clone().into()).into_iter().map(nearby).collect()
            }
        }
    }

    /// The only member of the family at `x`, as a line without direction.
    pub fn at(&self, x: &Rational) -> Self {
        Line {
            name: self.name.clone(),
            arity: self.arity,
            parameter: None,
            base: self.mask_at(x),
            direction: Laurent::new(0, Vec::new()),
            curve: None,
        }
    }

    /// The same line with another symbol, for a line without direction.
    pub(crate) fn with_symbol(&self, symbol: Laurent<Rational>) -> Self {
        Line { base: symbol, ..self.clone() }
    }

    /// The same line by another name.
    pub(crate) fn named(self, name: String) -> Self {
        Line { name, ..self }
    }

    /// The values of the family's parameter at which there is no scheme.
    pub fn poles(&self) -> Vec<RealAlgebraic> {
        match &self.curve {
            Some(curve) if !curve.denominator.is_constant() => {
                simple_roots(&curve.denominator.cleared().1)
            }
            _ => Vec::new(),
        }
    }

    /// The mask at `x`.
    pub fn mask_at(&self, x: &Rational) -> Laurent<Rational> {
        self.base.plus(&self.direction.scaled(x))
    }

    /// The arity `m`.
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// The parameter of the family.
    pub fn parameter(&self) -> Option<&Parameter> {
        self.parameter.as_ref()
    }

    /// `p` and `q` of the masks `p + x q`.
    pub fn parts(&self) -> (&Laurent<Rational>, &Laurent<Rational>) {
        (&self.base, &self.direction)
    }

    /// The largest `k` for which `σ^k` divides the symbol everywhere on the line.
    pub fn order(&self) -> usize {
        let parts = [&self.base, &self.direction];
        parts.iter().filter_map(|part| part.geometric_order(self.arity)).min().unwrap_or(0)
    }

    /// The pencil of the matrices `A_ε[i][j] = c_{o+ε+i-mj} / bound` of `c = m^(k-1) a / σ^k`.
    ///
    /// # Panics
    /// If `σ^k` does not divide the symbol.
    pub fn pencil(&self, order: usize, bound: &Rational) -> Pencil {
        let scale = Rational::from_i64(self.arity as i64).power(order as u32 - 1) / bound;
        let of = |part| letters(part, self.arity, order, self.extent(), &scale);
        Pencil::new(of(&self.base), of(&self.direction))
    }

    /// The pencil `x A_ε` of a line without direction.
    pub(crate) fn scaled_pencil(&self, order: usize) -> Pencil {
        let nothing = self.with_symbol(Laurent::new(0, Vec::new()));
        let turned = Line { direction: self.base.clone(), ..nothing };
        turned.pencil(order, &Rational::one())
    }

    /// The lowest exponent and the number of coefficients on the whole line.
    pub(crate) fn extent(&self) -> (i64, usize) {
        let supports = [self.base.support(), self.direction.support()];
        let supports: Vec<(i64, i64)> = supports.into_iter().flatten().collect();
        let lowest = supports.iter().map(|s| s.0).min().unwrap_or(0);
        let highest = supports.iter().map(|s| s.1).max().unwrap_or(0);
        (lowest, (highest - lowest) as usize + 1)
    }

    /// Asked before a search that may be long: whether a certificate about the line is of a size that is read, and its
    /// words have letters that are.
    ///
    /// # Errors
    /// Code `budget`, with what is too large.
    pub(crate) fn expect_readable_proofs(&self) -> Result<(), Diagnostic> {
        expect_readable_words(self.arity)?;
        self.family(self.order()).fits().map_err(unreadable)
    }

    /// The family as a certificate has it.
    pub fn family(&self, order: usize) -> Family {
        let (lowest, length) = self.extent();
        let exponents = lowest..lowest + length as i64;
        let coefficient = |i: i64| {
            let pair = [self.base.coefficient(i), self.direction.coefficient(i)];
            numbers(Polynomial::new(pair.to_vec()).coefficients())
        };
        let name = self.curve.as_ref().map(|_| "x".to_string());
        Family {
            name: self.name.clone(),
            arity: self.arity,
            parameter: name.or_else(|| self.parameter.as_ref().map(|p| p.name().to_string())),
            order,
            lowest,
            mask: exponents.clone().map(coefficient).collect(),
            curve: self.curve.as_ref().map(|curve| Curve {
                parameter: self.parameter.as_ref().map_or("t", Parameter::name).to_string(),
                mask: exponents
                    .map(|i| numbers(curve.numerators.coefficient(i).coefficients()))
                    .collect(),
                denominator: numbers(curve.denominator.coefficients()),
                line: Quotient {
                    numerator: numbers(curve.line.0.coefficients()),
                    denominator: numbers(curve.line.1.coefficients()),
                },
            }),
        }
    }
}

/// `m^(k-1-n)`: C^n holds where the joint spectral radius of the matrices of order `k` is less; with stable
/// shifts, only there.
pub(crate) fn radius_bound(m: usize, order: usize, continuity: usize) -> Rational {
    Rational::from_i64(m as i64).power((order - 1 - continuity) as u32)
}

/// The matrices `scale · A_ε[i][j] = c_{o+ε+i-mj}` of `c = a / σ^k`, for a part `a` of a mask whose first
/// exponent and length are given.
///
/// # Panics
/// If `σ^k` does not divide.
pub(crate) fn letters(
    part: &Laurent<Rational>,
    m: usize,
    order: usize,
    (lowest, length): (i64, usize),
    scale: &Rational,
) -> Vec<Matrix<Rational>> {
    let top = length - 1 - order * (m - 1);
    let d = top.div_ceil(m - 1).max(1);
    let origin = (m - 1) * (d - 1);
    let (c, remainder) = part.divide_by_geometric(m, order);
    assert!(remainder.is_zero(), "the order divides");
    let entry = |letter: usize, i: usize, j: usize| {
        c.coefficient(lowest + (origin + letter + i) as i64 - (m * j) as i64) * scale
    };
    (0..m).map(|e| Matrix::from_fn(d, d, |i, j| entry(e, i, j))).collect()
}

/// A number itself if it is rational, or one at most `2^-60` away.
fn nearby(t: RealAlgebraic) -> Rational {
    t.enclosure(&Rational::new(1.into(), Integer::from(1) << 60usize)).0
}

fn numbers(coefficients: &[Rational]) -> Vec<Number> {
    coefficients.iter().cloned().map(Number).collect()
}

fn degree(numerators: &Laurent<Polynomial<Rational>>) -> usize {
    numerators.coefficients().iter().filter_map(Polynomial::degree).max().unwrap_or(0)
}

/// `(u, v)` with `p = u a + v b`, if `a` and `b` are independent and it exists.
fn combination(
    p: &Polynomial<Rational>,
    a: &Polynomial<Rational>,
    b: &Polynomial<Rational>,
) -> Option<(Rational, Rational)> {
    let width = a.coefficients().len().max(b.coefficients().len());
    let minor = |f: &Polynomial<Rational>, g: &Polynomial<Rational>, i: usize, j: usize| {
        f.coefficient(i) * g.coefficient(j) - f.coefficient(j) * g.coefficient(i)
    };
    let pairs = (0..width).flat_map(|i| (0..i).map(move |j| (i, j)));
    let (i, j) = pairs.into_iter().find(|&(i, j)| !minor(a, b, i, j).is_zero())?;
    let determinant = minor(a, b, i, j);
    // Cramer's rule on two coefficients, then the identity on all.
    let u = minor(p, b, i, j) / &determinant;
    let v = minor(a, p, i, j) / &determinant;
    (a.scaled(&u).plus(&b.scaled(&v)) == *p).then_some((u, v))
}
