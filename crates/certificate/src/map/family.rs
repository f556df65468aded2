//! The symbol of a family of two parameters, its difference symbol, its matrices on a piece.

use refinable_algebra::{
    Integer, Polynomial, Rational, Ring, binomial, clear_denominators, integer,
};

use crate::family::{Scheme, dimension, divide_by_geometric, matrices};
use crate::limits;
use crate::map::form::{Form, Places, cleared, degree, multisets};
use crate::map::model::{Chart, PlaneFamily, Terms};
use crate::map::polygon::{Corner, Polygon};
use crate::number::Number;
use crate::stability::sign_in_contrast;
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// A family, checked to be normalised and divisible.
#[derive(Debug)]
pub(crate) struct PlaneScheme {
    /// The arity `m`.
    pub arity: usize,
    /// The order `k`.
    pub order: usize,
    /// The exponent of the first coefficient.
    pub lowest: i64,
    /// The numerators of the mask.
    pub symbol: Vec<Form>,
    /// The numerators of `m^(k-1) a / σ^k`.
    pub difference: Vec<Form>,
    /// The common denominator of the mask, a constant if there are no poles.
    pub denominator: Form,
    /// The largest total degree of a numerator or the denominator.
    pub degree: usize,
}

/// What polar forms are at some points, all over the same positive number.
#[derive(Debug)]
pub(crate) struct Polar {
    /// Those of the numerators,
    pub values: Vec<Integer>,
    /// and that of the denominator of the mask.
    pub denominator: Integer,
    /// The positive number.
    pub weight: Integer,
}

impl PlaneScheme {
    pub fn new(family: &PlaneFamily) -> Check<Self> {
        let m = family.arity;
        ensure((2..=MOST_LETTERS).contains(&m), "an arity below two or above ten")?;
        let [u, v] = &family.parameters;
        ensure(u != v, "the parameters have the same name")?;
        let length = family.mask.len();
        ensure(length >= m && length <= COEFFICIENTS, "a mask that is too short or too long")?;
        check_mask(&family.mask)?;
        let one = vec![(Number(Rational::one()), 0, 0)];
        let denominator = family.denominator.clone().unwrap_or(one);
        check_terms(&denominator)?;
        limits::denominators(denominator.iter().map(|(c, ..)| c)).or_else(fail)?;
        let mut symbol = cleared(&[&family.mask[..], &[denominator]].concat());
        let denominator = symbol.pop().unwrap_or_else(Form::zero);
        let constant = degree(&denominator) == 0;
        ensure(!constant || family.denominator.is_none(), "a denominator that is a constant")?;
        for j in 0..m {
            let stencil = symbol.iter().skip(j).step_by(m);
            let sum = stencil.fold(Form::zero(), |sum, c| sum.plus(c));
            ensure(sum == denominator, "a stencil does not sum to one")?;
        }
        if let Some(chart) = &family.chart {
            ensure(family.denominator.is_none(), "a chart of a family with a denominator")?;
            check_chart(&family.mask, chart)?;
        }
        let (order, steps) = (family.order, family.order.saturating_mul(m - 1));
        ensure(order >= 1 && steps < length, "an order that is too small or too large")?;
        let size = dimension(length - 1 - steps, m);
        ensure(size <= DIMENSION, "matrices of size above 24")?;
        let Some(quotient) = divided(&symbol, m, order) else {
            return fail("the symbol is not divisible as often as the order says");
        };
        let factor = Polynomial::constant(integer(m as i64).power(order as u32 - 1));
        let difference: Vec<Form> = quotient.iter().map(|c| c.scaled(&factor)).collect();
        let degree = symbol.iter().chain([&denominator]).map(degree).max().unwrap_or(0);
        Ok(PlaneScheme {
            arity: m,
            order,
            lowest: family.lowest,
            symbol,
            difference,
            denominator,
            degree,
        })
    }

    /// The size of the matrices.
    pub fn dimension(&self) -> usize {
        dimension(self.difference.len() - 1, self.arity)
    }

    /// `m^(k-1-n)`, if `n < k`.
    pub fn bound(&self, continuity: usize) -> Check<Integer> {
        match (self.order - 1).checked_sub(continuity) {
            Some(exponent) => Ok(integer(self.arity as i64).power(exponent as u32)),
            None => fail("the continuity is not less than the order"),
        }
    }

    /// Whether `B_{m-1-ε} = J B_ε J`.
    pub fn is_mirrored(&self) -> bool {
        let c = &self.difference;
        c.iter().eq(c.iter().rev()) && c.len() - 1 == (self.arity - 1) * self.dimension()
    }

    /// Whether masks have no poles.
    pub fn is_polynomial(&self) -> bool {
        degree(&self.denominator) == 0
    }

    /// The matrices `A_ε`, row by row, over the denominator.
    pub fn letters(&self) -> Vec<Vec<Form>> {
        matrices(&self.difference, self.arity)
    }

    /// The values of the polar forms of forms, and of the denominator, at as many points as the degree says.
    pub fn polar(&self, forms: &[Form], points: &[&Corner], work: &mut Work) -> Check<Polar> {
        let n = self.degree;
        let bits = largest_bits(points.iter().copied().flatten()) * n as u64 + 64;
        work.products((n + 1) * (n + 2) * (forms.len() + n), bits, bits)?;
        let places = Places::new(points);
        let values = forms.iter().map(|form| places.value(form)).collect();
        let denominator = places.value(&self.denominator);
        Ok(Polar { values, denominator, weight: places.denominator })
    }

    /// The polar forms of forms and the denominator at all control points of a piece, the multisets of its
    /// corners. On the piece a form is a mean of them.
    pub fn controls(
        &self,
        forms: &[Form],
        polygon: &Polygon,
        work: &mut Work,
    ) -> Check<Vec<Polar>> {
        let corners = polygon.corners();
        let (r, n) = (corners.len() as u32, self.degree as u32);
        let count = i64::try_from(&binomial(r + n - n.min(1), n)).unwrap_or(i64::MAX);
        ensure(count <= CONTROLS, "more than 2000 control points")?;
        let sets = multisets(corners.len(), self.degree).into_iter();
        sets.map(|set| {
            let points: Vec<&Corner> = set.into_iter().map(|i| &corners[i]).collect();
            self.polar(forms, &points, work)
        })
        .collect()
    }

    /// The numerators of `m^n a / σ^(n+1)`.
    pub fn lower_difference(&self, continuity: usize) -> Check<Vec<Form>> {
        self.bound(continuity)?;
        let Some(quotient) = divided(&self.symbol, self.arity, continuity + 1) else {
            return fail("the symbol is not divisible as often as the order says");
        };
        let factor = integer(self.arity as i64).power(continuity as u32);
        Ok(quotient.iter().map(|c| c.scaled(&Polynomial::constant(factor.clone()))).collect())
    }

    /// Whether `σ^order` divides the symbol identically.
    pub fn is_divisible(&self, order: usize) -> bool {
        divided(&self.symbol, self.arity, order).is_some()
    }

    /// The mask at a point at which the denominator does not vanish.
    pub fn mask_at(&self, point: &[Rational; 2]) -> Vec<Rational> {
        let denominator = value_at(&self.denominator, point);
        self.symbol.iter().map(|form| value_at(form, point) / &denominator).collect()
    }

    /// The two submasks of the difference symbol at a point for arity two, without the coefficients that
    /// vanish identically at their ends; up to factors.
    pub fn halves(&self, point: &[Rational; 2]) -> [Vec<Integer>; 2] {
        [0, 1].map(|first| self.trimmed((first..self.difference.len()).step_by(2), |_| 1, point))
    }

    /// A contrast of two neighbouring submasks likewise.
    pub fn contrast(&self, j: usize, point: &[Rational; 2]) -> Vec<Integer> {
        let sign = |i| sign_in_contrast(i, self.arity, j);
        self.trimmed(0..self.difference.len(), sign, point)
    }

    /// The coefficients of the difference symbol at some places with signs, those at the ends left out that
    /// vanish identically.
    fn trimmed(
        &self,
        places: impl Iterator<Item = usize>,
        sign: impl Fn(usize) -> i64,
        point: &[Rational; 2],
    ) -> Vec<Integer> {
        let places: Vec<usize> = places.collect();
        let occurs = |&i: &usize| sign(i) != 0 && !self.difference[i].is_zero();
        let first = places.iter().position(occurs).unwrap_or(places.len());
        let last = places.iter().rposition(occurs).map_or(first, |i| i + 1);
        let value = |&i: &usize| value_at(&self.difference[i], point) * integer(sign(i));
        let values: Vec<Rational> = places[first..last].iter().map(value).collect();
        clear_denominators(values.iter()).1
    }
}

const MOST_LETTERS: usize = 10;
const COEFFICIENTS: usize = 200;
const DIMENSION: usize = 24;
const TERMS: usize = 100;
const CONTROLS: i64 = 2000;
const DEGREE: u32 = 6;

fn check_mask(mask: &[Terms]) -> Check<()> {
    mask.iter().try_for_each(check_terms)?;
    limits::denominators(mask.iter().flatten().map(|(c, ..)| c)).or_else(fail)
}

fn check_terms(terms: &Terms) -> Check<()> {
    ensure(terms.len() <= TERMS, "a polynomial of more than 100 terms")?;
    let small = terms.iter().all(|&(_, i, j)| i <= DEGREE && j <= DEGREE && i + j <= DEGREE);
    ensure(small, "a polynomial of degree above 6")
}

/// The value of a form at a point.
fn value_at(form: &Form, point: &[Rational; 2]) -> Rational {
    let rows = form.coefficients().iter().map(|row| row.value_at(&point[0]));
    Polynomial::new(rows.collect()).evaluate(&point[1])
}

/// The quotient by `σ^times`, if it is one identically.
fn divided(symbol: &[Form], m: usize, times: usize) -> Option<Vec<Form>> {
    let mut quotient = symbol.to_vec();
    for _ in 0..times {
        quotient = divide_by_geometric(&quotient, m)?;
    }
    Some(quotient)
}

/// Checks that the masks in the parameters are those at `x = u`, `y = v l(u)`.
fn check_chart(mask: &[Terms], chart: &Chart) -> Check<()> {
    ensure(chart.mask.len() == mask.len(), "the masks have different lengths")?;
    check_mask(&chart.mask)?;
    limits::denominators(chart.factor.iter()).or_else(fail)?;
    let factor = Polynomial::new(chart.factor.iter().map(|c| c.0.clone()).collect());
    ensure(factor.degree() == Some(1), "the factor of the chart is not affine")?;
    for (in_plane, in_parameters) in mask.iter().zip(&chart.mask) {
        let in_plane = rational_form(in_plane);
        let substituted = in_plane.coefficients().iter().enumerate();
        let substituted = substituted.map(|(j, row)| row.times(&factor.power(j as u32))).collect();
        let same = Polynomial::new(substituted) == rational_form(in_parameters);
        ensure(same, "the masks in the parameters are not those in the plane")?;
    }
    Ok(())
}

fn rational_form(terms: &Terms) -> Polynomial<Polynomial<Rational>> {
    let monomial = |(c, i, j): &(Number, u32, u32)| {
        Polynomial::monomial(Polynomial::monomial(c.0.clone(), *i as usize), *j as usize)
    };
    terms.iter().map(monomial).fold(Polynomial::zero(), |sum, term| sum.plus(&term))
}

/// The parts of the box in the plane of `(x, y)`: one, or two where the factor of the chart vanishes
/// inside of the box.
pub(crate) fn parts(family: &PlaneFamily, window: &[[Number; 2]; 2]) -> Check<Vec<Polygon>> {
    let [[u0, u1], [v0, v1]] = [&window[0], &window[1]].map(|[a, b]| [&a.0, &b.0]);
    ensure(u0 < u1 && v0 < v1, "the lower end of the box is not below the upper one")?;
    let factor = family.chart.as_ref().map(|chart| chart.factor.iter().map(|c| c.0.clone()));
    let Some(factor) = factor.map(|c| Polynomial::new(c.collect())) else {
        let corners = [[u0, v0], [u1, v0], [u1, v1], [u0, v1]].map(|p| p.map(Clone::clone));
        return Ok(Polygon::new(&corners).into_iter().collect());
    };
    ensure(factor.degree() == Some(1), "the factor of the chart is not affine")?;
    let zero = -factor.coefficient(0) / factor.coefficient(1);
    let inside = *u0 < zero && zero < *u1;
    let spans = if inside { vec![(u0, &zero), (&zero, u1)] } else { vec![(u0, u1)] };
    let part = |(a, b): (&Rational, &Rational)| {
        let at = |u: &Rational, v: &Rational| [u.clone(), factor.evaluate(u) * v];
        let mut corners = vec![at(a, v0), at(b, v0), at(b, v1), at(a, v1)];
        corners.dedup();
        if corners.first() == corners.last() {
            corners.pop();
        }
        // The factor may be negative.
        Polygon::new(&corners).or_else(|| {
            corners.reverse();
            Polygon::new(&corners)
        })
    };
    match spans.into_iter().map(part).collect() {
        Some(parts) => Ok(parts),
        None => fail("a part of the box has no interior"),
    }
}

/// Checks that the family of another certificate runs along a line of the plane, or is the mask at a point.
pub(crate) fn check_section(
    scheme: &PlaneScheme,
    other: (&Scheme, i64),
    origin: &[Rational; 2],
    direction: &[Rational; 2],
    work: &mut Work,
) -> Check<()> {
    let (other, lowest) = other;
    let point = direction.iter().all(Ring::is_zero);
    ensure(point || scheme.is_polynomial(), "a line of masks with a denominator")?;
    ensure(point == other.constant, "a section does not move with its parameter")?;
    ensure(!value_at(&scheme.denominator, origin).is_zero(), "a section at a pole")?;
    // Polynomials of degree at most n are the same if they are at n + 1 values of the parameter.
    for t in 0..=scheme.degree.max(1) {
        let t = Rational::from(integer(t as i64));
        let at = [0, 1].map(|i| &origin[i] + &direction[i] * &t);
        work.products(8 * scheme.symbol.len(), 256, 256)?;
        let member = other.symbol.at(&t, work)?;
        let [ours, theirs] = [(scheme.mask_at(&at), scheme.lowest), (member.values(), lowest)]
            .map(|(mask, lowest)| without_zeros(mask, lowest));
        let same = ours == theirs;
        ensure(same, "a section is about other masks than those of the line")?;
    }
    Ok(())
}

/// The coefficients of a mask with their exponents, zeros left out.
fn without_zeros(mask: Vec<Rational>, lowest: i64) -> Vec<(i128, Rational)> {
    (i128::from(lowest)..).zip(mask).filter(|(_, c)| !c.is_zero()).collect()
}
