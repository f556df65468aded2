//! Fractional linear changes of a parameter.

use refinable_algebra::{Integer, Polynomial, Rational, Ring};
use refinable_reals::{Bound, RealAlgebraic, Region, real_roots, sample_between};

/// `x = P(t) / Q(t)` with `P`, `Q` of degree at most one, not proportional: a bijection of the
/// projective line.
pub(crate) struct Moebius<'a> {
    numerator: &'a Polynomial<Rational>,
    denominator: &'a Polynomial<Rational>,
}

impl<'a> Moebius<'a> {
    pub fn new(numerator: &'a Polynomial<Rational>, denominator: &'a Polynomial<Rational>) -> Self {
        Moebius { numerator, denominator }
    }

    /// The `t` at which `x` is infinite.
    fn pole(&self) -> Option<RealAlgebraic> {
        let slope = self.denominator.coefficient(1);
        (!slope.is_zero()).then(|| (-self.denominator.coefficient(0) / slope).into())
    }

    /// All `t`, but the pole, whose `x` is in the region.
    pub fn preimage(&self, region: &Region) -> Region {
        let ends: Vec<(RealAlgebraic, bool)> = region
            .ends()
            .iter()
            .filter_map(|e| Some((self.inverse(e)?, region.contains(e))))
            .collect();
        let mut cuts: Vec<RealAlgebraic> = ends.iter().map(|(t, _)| t.clone()).collect();
        cuts.extend(self.pole());
        cuts.sort();
        cuts.dedup();
        let bound =
            |t: Option<&RealAlgebraic>| t.map_or(Bound::Infinite, |t| Bound::Open(t.clone()));
        let gaps = (0..=cuts.len()).filter_map(|i| {
            let (lower, upper) = (i.checked_sub(1).map(|i| &cuts[i]), cuts.get(i));
            let x = self.value(&sample_between(lower, upper));
            region.contains_rational(&x).then(|| Region::interval(bound(lower), bound(upper)))
        });
        let points = ends.iter().filter(|(_, inside)| *inside).map(|(t, _)| t.clone());
        Region::union_of(gaps.chain([Region::points(points)])).simplified()
    }

    fn value(&self, t: &Rational) -> Rational {
        self.numerator.evaluate(t) / self.denominator.evaluate(t)
    }

    /// The `t` with `P(t) = x Q(t)`; `None` if it is infinite.
    pub fn inverse(&self, x: &RealAlgebraic) -> Option<RealAlgebraic> {
        let [p0, p1] = [0, 1].map(|k| self.numerator.coefficient(k));
        let [q0, q1] = [0, 1].map(|k| self.denominator.coefficient(k));
        if let Some(x) = x.as_rational() {
            let slope = x * &q1 - &p1;
            return (!slope.is_zero()).then(|| ((&p0 - x * &q0) / slope).into());
        }
        // One of the roots of f(P/Q) Q^deg; the others belong to other roots of f.
        let candidates = real_roots(&self.composed(&x.polynomial()));
        let mut width = Rational::new(1.into(), Integer::from(1) << 40usize);
        loop {
            let (lower, upper) = x.enclosure(&width);
            let meets = |t: &&RealAlgebraic| {
                let (a, b) = t.enclosure(&width);
                let has_pole = self.pole().is_some_and(|p| {
                    p >= RealAlgebraic::from(a.clone()) && p <= RealAlgebraic::from(b.clone())
                });
                if has_pole {
                    return true;
                }
                let (u, v) = (self.value(&a), self.value(&b));
                let (least, most) = if u < v { (u, v) } else { (v, u) };
                least <= upper && lower <= most
            };
            let near: Vec<&RealAlgebraic> = candidates.iter().filter(meets).collect();
            if let [only] = near.as_slice() {
                return Some(only.simplified());
            }
            width = &width * &width;
        }
    }

    /// `f(P/Q) Q^deg(f)` in integers.
    fn composed(&self, f: &Polynomial<Integer>) -> Polynomial<Integer> {
        let degree = f.degree().unwrap_or(0) as u32;
        let mut sum = Polynomial::<Rational>::zero();
        for (k, c) in f.coefficients().iter().enumerate() {
            let power = self.numerator.power(k as u32);
            let rest = self.denominator.power(degree - k as u32);
            sum = sum.plus(&power.times(&rest).scaled(&Rational::from(c.clone())));
        }
        sum.cleared().1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn linear(a: i64, b: i64) -> Polynomial<Rational> {
        Polynomial::new(vec![rational(a, 1), rational(b, 1)])
    }

    /// x = 1/t maps (1/2, ∞) to (0, 2) and the rest of it comes from nowhere.
    #[test]
    fn the_inversion() {
        let (p, q) = (linear(1, 0), linear(0, 1));
        let inversion = Moebius::new(&p, &q);
        let region = Region::open(rational(0, 1), rational(2, 1));
        assert_eq!(inversion.preimage(&region).display("t"), "(1/2, ∞)");
        let region = Region::interval(
            Bound::Closed(rational(-1, 1).into()),
            Bound::Open(rational(1, 1).into()),
        );
        assert_eq!(inversion.preimage(&region).display("t"), "(-∞, -1] ∪ (1, ∞)");
    }

    /// x = (t+1)/(t-1) and x = √2: t = (√2+1)/(√2-1) = 3+2√2.
    #[test]
    fn algebraic_ends_go_to_their_own_image() {
        let (p, q) = (linear(1, 1), linear(-1, 1));
        let root = RealAlgebraic::quadratic(&rational(0, 1), &rational(1, 1), &rational(2, 1));
        let region = Region::interval(Bound::Open(root), Bound::Infinite);
        assert_eq!(Moebius::new(&p, &q).preimage(&region).display("t"), "(1, 3+2*sqrt(2))");
    }
}
