//! Families of two parameters as surfaces, or planes, of masks.

use std::collections::BTreeMap;

use refinable_algebra::{
    Laurent, Matrix, Monomial, Parameter, ParameterPolynomial, Polynomial, Rational, Ring, rational,
};
use refinable_certificate::{Chart, Number, PlaneFamily, Terms};
use refinable_reals::{Component, common_roots, common_zero_set};
use refinable_scheme::{Diagnostic, Normalised};
use refinable_spectral::{PlanePencil, Window};

use crate::budget::expect_readable_words;
use crate::line::letters;

/// Lines through a box for each coordinate, less one.
const PARTS: i64 = 16;
/// Special masks that are looked at one by one.
const FEW: usize = 4;
/// The highest degree of masks of which special ones are sought.
const SOUGHT: u32 = 12;
/// The highest degree of conditions that are solved for both coordinates at once.
const SOLVED: u32 = 6;

/// Where a higher power of `σ` divides the symbol.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Special {
    /// On the line through a point of the plane of `(x, y)` in a direction, along which the mask changes.
    Line(Box<[[Rational; 2]; 2]>),
    /// At a point.
    Point([Rational; 2]),
    /// Wherever the mask is that at a point.
    Mask([Rational; 2]),
}

/// The parts of a mask by exponents of two variables.
type Parts = BTreeMap<(u32, u32), Laurent<Rational>>;

/// A family of masks that are polynomials, or rational functions, of two coordinates `x` and `y`.
///
/// The coordinates are the parameters `u` and `v` themselves, or `x = u` and `y = v l(u)` with an affine
/// `l` that makes the masks affine: the families with the product `β(1-α)` are planes in the
/// coefficients, where a polytope proves a whole convex piece by its corners alone.
#[derive(Clone, Debug)]
pub struct Plane {
    name: String,
    arity: usize,
    parameters: [Parameter; 2],
    /// `l`, if it is not constant.
    factor: Option<Polynomial<Rational>>,
    lowest: i64,
    length: usize,
    /// For each `x^i y^j` its coefficients in the mask, or in the numerators.
    parts: Parts,
    /// The same for `u^i v^j`.
    in_parameters: Parts,
    /// The coefficients of each `x^i y^j` in the common denominator, if it is not one.
    denominator: Option<BTreeMap<(u32, u32), Rational>>,
}

impl Plane {
    /// The surface of masks of a family.
    ///
    /// # Errors
    /// Code `parameters` unless exactly two are free; `budget` for an arity above ten, as no proof with its words would
    /// be read.
    pub fn new(name: &str, mask: &Normalised) -> Result<Plane, Diagnostic> {
        expect_readable_words(mask.arity())?;
        let parameters: Vec<Parameter> = mask.parameters().into_iter().collect();
        let parameters: [Parameter; 2] =
            parameters.try_into().map_err(|free: Vec<Parameter>| {
                let names: Vec<&str> = free.iter().map(Parameter::name).collect();
                let message = match names.len() {
                    0 => "no parameter is free, and a map needs two".to_string(),
                    n => format!("a map needs two free parameters, not {n}: {}", names.join(", ")),
                };
                let hint = match names.len() {
                    0 => "`range` and `regularity` need no map",
                    1 => "`range` divides the line of one parameter",
                    _ => "set the others: --set NAME=VALUE",
                };
                Diagnostic::new("parameters", message).with_hint(hint)
            })?;
        let constant = mask.denominator().as_constant();
        let scale = constant.as_ref().map_or_else(Rational::one, Rational::recip);
        let numerator = mask.numerator().scaled(&ParameterPolynomial::constant(scale));
        let (lowest, length) = (numerator.lowest(), numerator.coefficients().len());
        let [u, v] = &parameters;
        let plain = parts(&numerator, u, v);
        let denominator = constant.is_none().then(|| {
            let terms = mask.denominator().terms();
            terms.map(|(m, c)| ((m.exponent(u), m.exponent(v)), c.clone())).collect()
        });
        // The roles may have to be exchanged.
        let charts = [(u, v), (v, u)].into_iter().find_map(|(u, v)| {
            let in_parameters = parts(&numerator, u, v);
            let (factor, parts) = chart(&in_parameters)?;
            Some(([u.clone(), v.clone()], Some(factor), parts, in_parameters))
        });
        let is_affine = plain.keys().all(|(i, j)| i + j <= 1);
        let (parameters, factor, parts, in_parameters) = charts
            .filter(|_| !is_affine && denominator.is_none())
            .unwrap_or_else(|| (parameters.clone(), None, plain.clone(), plain.clone()));
        let (name, arity) = (name.to_string(), mask.arity());
        Ok(Plane {
            name,
            arity,
            parameters,
            factor,
            lowest,
            length,
            parts,
            in_parameters,
            denominator,
        })
    }

    /// The parameters `u` and `v`.
    pub fn parameters(&self) -> &[Parameter; 2] {
        &self.parameters
    }

    /// Values of `u` and `v` in the ascending order of the parameters, in which masks take them.
    pub fn in_order(&self, [u, v]: &[Rational; 2]) -> [Rational; 2] {
        let exchanged = self.parameters[1] < self.parameters[0];
        if exchanged { [v.clone(), u.clone()] } else { [u.clone(), v.clone()] }
    }

    /// What the family is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// `l`, if `y = v l(u)` is not `v`.
    pub fn factor(&self) -> Option<&Polynomial<Rational>> {
        self.factor.as_ref()
    }

    /// Whether the masks are affine in `x` and `y`.
    pub fn is_affine(&self) -> bool {
        self.denominator.is_none() && self.parts.keys().all(|(i, j)| i + j <= 1)
    }

    /// The largest total degree of a numerator or the denominator, in the parameters or in `x` and `y`.
    pub(crate) fn degree(&self) -> u32 {
        let numerators = self.parts.keys().chain(self.in_parameters.keys());
        let all = numerators.chain(self.denominator.iter().flat_map(BTreeMap::keys));
        all.map(|(i, j)| i + j).max().unwrap_or(0)
    }

    /// Whether there is no mask at the point `(x, y)`, as the denominator vanishes.
    pub fn is_pole(&self, [x, y]: &[Rational; 2]) -> bool {
        self.denominator_at(x, y).is_zero()
    }

    /// The point `(x, y)` of the parameters.
    pub fn point(&self, [u, v]: &[Rational; 2]) -> [Rational; 2] {
        let y = self.factor.as_ref().map_or_else(|| v.clone(), |l| l.evaluate(u) * v);
        [u.clone(), y]
    }

    /// The parameters of a point `(x, y)`; `None` where `l` vanishes.
    pub fn parameters_at(&self, [x, y]: &[Rational; 2]) -> Option<[Rational; 2]> {
        let l = self.factor.as_ref().map_or_else(Rational::one, |l| l.evaluate(x));
        (!l.is_zero()).then(|| [x.clone(), y / l])
    }

    /// The largest `k` for which `σ^k` divides the symbol everywhere.
    pub fn order(&self) -> usize {
        let orders = self.parts.values().filter_map(|part| part.geometric_order(self.arity));
        orders.min().unwrap_or(0)
    }

    /// The family as a certificate has it.
    pub fn family(&self, order: usize) -> PlaneFamily {
        PlaneFamily {
            name: self.name.clone(),
            arity: self.arity,
            parameters: self.parameters.each_ref().map(|p| p.name().to_string()),
            order,
            lowest: self.lowest,
            mask: self.terms(&self.parts),
            denominator: self
                .denominator
                .as_ref()
                .map(|terms| terms.iter().map(|((i, j), c)| (Number(c.clone()), *i, *j)).collect()),
            chart: self.factor.as_ref().map(|factor| Chart {
                factor: factor.coefficients().iter().cloned().map(Number).collect(),
                mask: self.terms(&self.in_parameters),
            }),
        }
    }

    fn terms(&self, parts: &Parts) -> Vec<Terms> {
        let exponents = self.lowest..self.lowest + self.length as i64;
        let coefficient = |e: i64| {
            let all = parts.iter().map(|((i, j), part)| (Number(part.coefficient(e)), *i, *j));
            all.filter(|(c, ..)| !c.0.is_zero()).collect()
        };
        exponents.map(coefficient).collect()
    }

    /// The matrices `A_ε / bound` of `c = m^(k-1) a / σ^k` on the plane of `(x, y)`.
    ///
    /// # Panics
    /// If `σ^k` does not divide the symbol.
    pub fn pencil(&self, order: usize, bound: &Rational) -> PlanePencil {
        self.pencil_of(&self.parts, order, bound)
    }

    /// The same on the plane of the parameters.
    pub fn pencil_in_parameters(&self, order: usize, bound: &Rational) -> PlanePencil {
        self.pencil_of(&self.in_parameters, order, bound)
    }

    fn pencil_of(&self, parts: &Parts, order: usize, bound: &Rational) -> PlanePencil {
        let scale = Rational::from_i64(self.arity as i64).power(order as u32 - 1) / bound;
        let extent = (self.lowest, self.length);
        let letters = |part| letters(part, self.arity, order, extent, &scale);
        let terms: Vec<(u32, u32, Vec<Matrix<Rational>>)> =
            parts.iter().map(|((i, j), part)| (*i, *j, letters(part))).collect();
        let pencil = PlanePencil::new(&terms);
        let Some(denominator) = &self.denominator else { return pencil };
        let terms: Vec<_> = denominator.iter().map(|((i, j), c)| (*i, *j, c.clone())).collect();
        pencil.over(&terms)
    }

    /// The polynomials in `x` and `y` that vanish where `σ^order` divides the symbol.
    pub fn divisibility(&self, order: usize) -> Vec<Polynomial<Polynomial<Rational>>> {
        let sigma = Polynomial::new(vec![Rational::one(); self.arity]);
        let divisor = sigma.power(order as u32);
        // All parts begin at the same exponent, so that remainders add up.
        let remainder = |part: &Laurent<Rational>| {
            let exponents = self.lowest..self.lowest + self.length as i64;
            let dense = Polynomial::new(exponents.map(|e| part.coefficient(e)).collect());
            dense.divide_by_monic(&divisor).1
        };
        let remainders: Vec<((u32, u32), Polynomial<Rational>)> =
            self.parts.iter().map(|(key, part)| (*key, remainder(part))).collect();
        let condition = |k: usize| {
            remainders.iter().fold(Polynomial::zero(), |sum, ((i, j), r)| {
                let row = Polynomial::monomial(r.coefficient(k), *i as usize);
                sum.plus(&Polynomial::monomial(row, *j as usize))
            })
        };
        let degree = divisor.degree().unwrap_or(0);
        (0..degree).map(condition).filter(|c| !c.is_zero()).collect()
    }

    /// The highest power of `σ` that masks of this length may have.
    pub(crate) fn highest_order(&self) -> usize {
        (self.length - 1) / (self.arity - 1)
    }

    /// Where `σ^order` divides the symbol: all of it if masks are affine, else the masks at points of the box that are
    /// found, if they are few.
    pub(crate) fn special(&self, order: usize, window: &Window) -> Vec<Special> {
        let conditions = self.divisibility(order);
        if self.degree() > SOUGHT {
            return Vec::new();
        }
        if !self.is_affine() {
            let mut masks = Vec::new();
            let mut few = |mut points: Vec<[Rational; 2]>| {
                points.sort_by_key(|[x, y]| x.to_string().len() + y.to_string().len());
                points.retain(|point| {
                    let mask = (!self.is_pole(point)).then(|| self.mask_at(point));
                    let is_new = mask.as_ref().is_some_and(|mask| !masks.contains(mask));
                    masks.extend(mask.filter(|_| is_new));
                    is_new
                });
                if points.len() > FEW { Vec::new() } else { points }
            };
            let single = few(single_points(&conditions, window));
            let others = few(points_on_lines(&conditions, window));
            return single.into_iter().chain(others).map(Special::Mask).collect();
        }
        let Some((origin, direction)) = common_line(&conditions) else { return Vec::new() };
        let moves = self.along(&origin, &direction).is_some_and(|[_, slope]| !slope.is_zero());
        if moves {
            return vec![Special::Line(Box::new([origin, direction]))];
        }
        if direction.iter().all(Rational::is_zero) {
            return vec![Special::Point(origin)];
        }
        vec![Special::Mask(self.short_point(&origin, &direction, window).unwrap_or(origin))]
    }

    /// A point on a line that is in the box, if there is one with a parameter that is a few parts of its range.
    fn short_point(
        &self,
        origin: &[Rational; 2],
        direction: &[Rational; 2],
        window: &Window,
    ) -> Option<[Rational; 2]> {
        let axis = usize::from(direction[0].is_zero());
        let [low, high] = &window[axis];
        let points = (1..PARTS).map(|k| {
            let t = (low + (high - low) * rational(k, PARTS) - &origin[axis]) / &direction[axis];
            [0, 1].map(|i| &origin[i] + &direction[i] * &t)
        });
        let is_inside = |point: &[Rational; 2]| {
            self.parameters_at(point).is_some_and(|parameters| contains(window, &parameters))
        };
        points.filter(is_inside).min_by_key(|[x, y]| x.to_string().len() + y.to_string().len())
    }

    /// The mask at a point `(x, y)` that is no pole.
    pub(crate) fn mask_at(&self, [x, y]: &[Rational; 2]) -> Laurent<Rational> {
        let power = |i: u32, j: u32| x.power(i) * y.power(j);
        let parts = self.parts.iter().map(|((i, j), part)| part.scaled(&power(*i, *j)));
        let numerator = parts.fold(Laurent::new(0, Vec::new()), |sum, part| sum.plus(&part));
        numerator.scaled(&self.denominator_at(x, y).recip())
    }

    fn denominator_at(&self, x: &Rational, y: &Rational) -> Rational {
        self.denominator.as_ref().map_or_else(Rational::one, |terms| {
            terms.iter().map(|((i, j), c)| c * x.power(*i) * y.power(*j)).sum()
        })
    }

    /// The mask at a point of the plane of `(x, y)`, moving along a direction: `p + t q`.
    ///
    /// `None` if the masks are not affine and the direction is not zero.
    pub fn along(
        &self,
        origin: &[Rational; 2],
        direction: &[Rational; 2],
    ) -> Option<[Laurent<Rational>; 2]> {
        if direction.iter().all(Rational::is_zero) {
            return Some([self.mask_at(origin), Laurent::new(0, Vec::new())]);
        }
        let part = |i: u32, j: u32| {
            self.parts.get(&(i, j)).cloned().unwrap_or_else(|| Laurent::new(0, Vec::new()))
        };
        let [constant, by_x, by_y] = [part(0, 0), part(1, 0), part(0, 1)];
        let linear = |[x, y]: &[Rational; 2]| by_x.scaled(x).plus(&by_y.scaled(y));
        self.is_affine().then(|| [constant.plus(&linear(origin)), linear(direction)])
    }

    /// The exponent of the first coefficient, and how many there are.
    pub fn extent(&self) -> (i64, usize) {
        (self.lowest, self.length)
    }

    /// The arity `m`.
    pub fn arity(&self) -> usize {
        self.arity
    }
}

/// The coefficients of each `u^i v^j`.
fn parts(numerator: &Laurent<ParameterPolynomial>, u: &Parameter, v: &Parameter) -> Parts {
    let mut parts: BTreeMap<(u32, u32), Vec<(i64, Rational)>> = BTreeMap::new();
    for (exponent, coefficient) in numerator.terms() {
        for (monomial, c) in coefficient.terms() {
            let key = |monomial: &Monomial| (monomial.exponent(u), monomial.exponent(v));
            parts.entry(key(monomial)).or_default().push((exponent, c.clone()));
        }
    }
    let laurent = |terms: Vec<(i64, Rational)>| {
        let monomials = terms.into_iter().map(|(e, c)| Laurent::monomial(c, e));
        monomials.fold(Laurent::new(0, Vec::new()), |sum, m| sum.plus(&m))
    };
    parts.into_iter().map(|(key, terms)| (key, laurent(terms))).collect()
}

/// `l` and the parts in `x = u`, `y = v l(u)`, if the mask is affine in these: it is affine in `u` and in
/// `v`, and the coefficients of `v` and of `u v` are in one ratio.
fn chart(parts: &Parts) -> Option<(Polynomial<Rational>, Parts)> {
    let part = |i: u32, j: u32| parts.get(&(i, j));
    let known = [(0, 0), (1, 0), (0, 1), (1, 1)];
    if parts.keys().any(|key| !known.contains(key)) {
        return None;
    }
    let product = part(1, 1)?;
    let (exponent, slope) = product.terms().find(|(_, c)| !c.is_zero())?;
    let nothing = Laurent::new(0, Vec::new());
    let alone = part(0, 1).unwrap_or(&nothing);
    let ratio = alone.coefficient(exponent) / slope;
    if product.scaled(&ratio) != *alone {
        return None;
    }
    // l is ratio + u in the smallest integers, its first coefficient positive.
    let (_, primitive) = Polynomial::new(vec![ratio.clone(), Rational::one()]).cleared();
    let negative = ratio < Rational::zero();
    let factor = primitive.map(|c| {
        let c = Rational::from(c.clone());
        if negative { -c } else { c }
    });
    let scale = factor.coefficient(1).recip();
    let mut plane = Parts::new();
    for key in [(0, 0), (1, 0)] {
        plane.extend(part(key.0, key.1).map(|p| (key, p.clone())));
    }
    plane.insert((0, 1), product.scaled(&scale));
    Some((factor, plane))
}

/// Whether parameters are in a box, its ends included.
pub(crate) fn contains(window: &Window, parameters: &[Rational; 2]) -> bool {
    window.iter().zip(parameters).all(|([low, high], x)| low <= x && x <= high)
}

/// Points of a box at which polynomials in `x` and `y` vanish together: those on lines through it of one coordinate.
fn points_on_lines(
    conditions: &[Polynomial<Polynomial<Rational>>],
    window: &Window,
) -> Vec<[Rational; 2]> {
    let within = |axis: usize, x: &Rational| window[axis][0] <= *x && *x <= window[axis][1];
    let across = |axis: usize| {
        let [low, high] = &window[axis];
        (0..=PARTS).flat_map(move |k| {
            let fixed = low + (high - low) * rational(k, PARTS);
            let restricted = |c: &Polynomial<Polynomial<Rational>>| {
                let on_line = match axis {
                    0 => c.map(|row| row.evaluate(&fixed)),
                    _ => c.evaluate(&Polynomial::constant(fixed.clone())),
                };
                on_line.cleared().1
            };
            let restricted: Vec<_> =
                conditions.iter().map(restricted).filter(|c| !c.is_zero()).collect();
            let roots = if restricted.is_empty() { Vec::new() } else { common_roots(&restricted) };
            let roots = roots.into_iter().filter_map(|root| root.as_rational().cloned());
            let points = roots.filter(move |root| within(1 - axis, root)).map(move |root| {
                if axis == 0 { [fixed.clone(), root] } else { [root, fixed.clone()] }
            });
            points.collect::<Vec<_>>()
        })
    };
    let mut points: Vec<[Rational; 2]> = (0..2).flat_map(across).collect();
    points.sort();
    points.dedup();
    points
}

/// Points of a box with rational coordinates at which polynomials of low degree in `x` and `y` vanish together as parts of
/// them without a common factor do.
fn single_points(
    conditions: &[Polynomial<Polynomial<Rational>>],
    window: &Window,
) -> Vec<[Rational; 2]> {
    let [x, y] = ["x", "y"].map(Parameter::new);
    let row = |p: &Polynomial<Rational>| {
        let constants = p.map(|c| ParameterPolynomial::constant(c.clone()));
        ParameterPolynomial::from_collected(&constants, &x)
    };
    let conditions: Vec<ParameterPolynomial> =
        conditions.iter().map(|c| ParameterPolynomial::from_collected(&c.map(row), &y)).collect();
    if conditions.iter().any(|c| c.degree() > Some(SOLVED)) {
        return Vec::new();
    }
    let plane = [x, y];
    let pieces = common_zero_set(&conditions, &plane).unwrap_or_default();
    let rational = |piece: Component| match piece {
        Component::Point(point) => point.rational_coordinates(&plane)?.try_into().ok(),
        _ => None,
    };
    pieces.into_iter().filter_map(rational).filter(|point| contains(window, point)).collect()
}

/// The line or point where affine polynomials in `x` and `y` vanish together: a point of it, and how it
/// goes on.
fn common_line(
    conditions: &[Polynomial<Polynomial<Rational>>],
) -> Option<([Rational; 2], [Rational; 2])> {
    let rows: Vec<[Rational; 3]> = conditions
        .iter()
        .map(|c| {
            let at = |i: usize, j: usize| c.coefficient(j).coefficient(i);
            [at(1, 0), at(0, 1), at(0, 0)]
        })
        .collect();
    let minor =
        |a: &[Rational; 3], b: &[Rational; 3], i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let first = rows.first()?;
    let [a, b, c] = first;
    let independent = rows.iter().find(|row| !minor(first, row, 0, 1).is_zero());
    if let Some(second) = independent {
        let determinant = minor(first, second, 0, 1);
        let point =
            [minor(first, second, 1, 2), minor(first, second, 2, 0)].map(|x| x / &determinant);
        let on =
            |row: &[Rational; 3]| (&row[0] * &point[0] + &row[1] * &point[1] + &row[2]).is_zero();
        return rows.iter().all(on).then(|| (point, [Rational::zero(), Rational::zero()]));
    }
    let same = rows
        .iter()
        .all(|row| minor(first, row, 0, 2).is_zero() && minor(first, row, 1, 2).is_zero());
    match (a.is_zero(), b.is_zero()) {
        _ if !same => None,
        (_, false) => Some(([Rational::zero(), -c / b], [Rational::one(), -a / b])),
        (false, true) => Some(([-c / a, Rational::zero()], [Rational::zero(), Rational::one()])),
        (true, true) => None,
    }
}
