//! Areas of polygons that a change of parameters has bent.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use rayon::prelude::*;
use refinable_algebra::{Ordered, Polynomial, Rational, Ring, rational};
use refinable_certificate::Polygon;
use refinable_reals::logarithm;

/// Bounds for an area in the plane of the parameters.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Area {
    /// Not more than the area.
    pub lower: Rational,
    /// Not less.
    pub upper: Rational,
}

impl Area {
    /// The area that polygons of the plane of `(x, y)` have together in the plane of the parameters, where
    /// `y = v l(u)` with the factor `l`, or `y = v` without.
    pub(crate) fn of(polygons: &[&Polygon], factor: Option<&Polynomial<Rational>>) -> Area {
        let around = |polygon: &&Polygon| Integral::around(polygon, factor);
        let all: Vec<Integral> = polygons.par_iter().map(around).collect();
        all.into_iter().fold(Integral::default(), Integral::plus).area()
    }
}

/// Binary places of logarithms in areas.
const PLACES: u32 = 60;

/// `rational + Σ coefficient log argument`.
#[derive(Clone, Default)]
struct Integral {
    rational: Rational,
    /// The coefficients by the arguments. They vanish at corners inside of a region.
    logarithms: BTreeMap<Rational, Rational>,
}

impl Integral {
    /// The area of a polygon of the plane of `(x, y)` in the plane of the parameters: `-∮ y/|l(x)| dx`. On an
    /// edge `y = a + c l(x)` the integral of `y/l` is `c x + a/l' log |l(x)|`.
    fn around(polygon: &Polygon, factor: Option<&Polynomial<Rational>>) -> Self {
        let points = polygon.points();
        let next = points.iter().cycle().skip(1);
        let mut sum = Integral::default();
        for ([x0, y0], [x1, y1]) in points.iter().zip(next).filter(|(p, q)| p[0] != q[0]) {
            let Some(l) = factor else {
                sum.rational -= (y0 + y1) * (x1 - x0) / rational(2, 1);
                continue;
            };
            let (l0, l1, slope) = (l.evaluate(x0), l.evaluate(x1), l.coefficient(1));
            let c = (y1 - y0) / (&l1 - &l0);
            let a = (y0 - &c * &l0) / slope;
            sum.rational -= c * (x1 - x0);
            if !a.is_zero() {
                sum.add(l0.absolute(), a.clone());
                sum.add(l1.absolute(), -a);
            }
        }
        // Where l is negative, so is the integral.
        let negative = |l: &Polynomial<Rational>| {
            points.iter().map(|p| l.evaluate(&p[0])).sum::<Rational>() < Rational::zero()
        };
        if factor.is_some_and(negative) { sum.negated() } else { sum }
    }

    fn add(&mut self, argument: Rational, coefficient: Rational) {
        *self.logarithms.entry(argument).or_default() += coefficient;
    }

    fn negated(mut self) -> Self {
        self.rational = -self.rational;
        self.logarithms.values_mut().for_each(|c| *c = -&*c);
        self
    }

    fn plus(mut self, other: Self) -> Self {
        self.rational += other.rational;
        other.logarithms.into_iter().for_each(|(argument, c)| self.add(argument, c));
        self
    }

    /// Bounds, by binary logarithms times log 2.
    fn area(self) -> Area {
        let mut area = Area { lower: self.rational.clone(), upper: self.rational };
        for (argument, coefficient) in self.logarithms.iter().filter(|(_, c)| !c.is_zero()) {
            let (low, high) = logarithm(argument, 2, PLACES);
            let ends = [low, high].map(|log| coefficient * log);
            let products = || ends.iter().flat_map(|e| LOG_TWO.iter().map(move |two| e * two));
            area.lower += floor(&products().min().expect("four products"));
            area.upper += ceil(&products().max().expect("four products"));
        }
        // Of very small areas the bounds may be coarser than the area.
        area.lower = area.lower.max(Rational::zero());
        area
    }
}

/// Bounds for `log 2 = Σ 1/(k 2^k)`.
static LOG_TWO: LazyLock<[Rational; 2]> = LazyLock::new(|| {
    let term = |k: u32| (Rational::from_i64(i64::from(k)) * Rational::from_i64(2).power(k)).recip();
    let sum: Rational = (1..=PLACES + 10).map(term).sum();
    // What is left is less than the last term.
    let rest = term(PLACES + 10);
    [floor(&sum), ceil(&(sum + rest))]
});

/// Rounded down to `PLACES + 20` binary places, so that sums stay short.
fn floor(x: &Rational) -> Rational {
    let unit = Rational::from_i64(2).power(PLACES + 20);
    (x * &unit).floor() / unit
}

fn ceil(x: &Rational) -> Rational {
    -floor(&-x)
}
