//! Changes of a parameter by a rational function.

use refinable_algebra::{Integer, Polynomial, Rational, Ring};
use refinable_reals::{Interval, RealAlgebraic, Region, real_roots};

/// `x = P(t) / Q(t)`, not constant, with `P` and `Q` coprime.
pub(crate) struct RationalMap<'a> {
    numerator: &'a Polynomial<Rational>,
    denominator: &'a Polynomial<Rational>,
}

impl<'a> RationalMap<'a> {
    pub fn new(numerator: &'a Polynomial<Rational>, denominator: &'a Polynomial<Rational>) -> Self {
        RationalMap { numerator, denominator }
    }

    /// All `t`, but the poles, whose `x` is in the region.
    ///
    /// Between poles and places where `x` is an end of the region it is inside or outside as a whole.
    pub fn preimage(&self, region: &Region) -> Region {
        let mut cuts = real_roots(&self.denominator.cleared().1);
        let mut points = Vec::new();
        for end in region.ends() {
            let places = self.inverse(&end);
            if region.contains(&end) {
                points.extend(places.iter().cloned());
            }
            cuts.extend(places);
        }
        cuts.sort();
        cuts.dedup();
        let is_inside = |t: &Rational| self.value(t).is_some_and(|x| region.contains_rational(&x));
        Interval::LINE.gaps_where(&cuts, is_inside).union(&Region::points(points)).simplified()
    }

    /// `x`; `None` at a pole.
    pub fn value(&self, t: &Rational) -> Option<Rational> {
        let bottom = self.denominator.evaluate(t);
        (!bottom.is_zero()).then(|| self.numerator.evaluate(t) / bottom)
    }

    /// All `t` with `P(t) = x Q(t)`, ascending.
    pub fn inverse(&self, x: &RealAlgebraic) -> Vec<RealAlgebraic> {
        if let Some(x) = x.as_rational() {
            return real_roots(&self.below(x).cleared().1);
        }
        // At a root of f(P/Q) Q^deg the map is a root of f: this one, if it is between the bounds of it.
        let (lower, upper) = x.bounds();
        let side = |bound| self.below(&bound).times(self.denominator).cleared().1;
        let (above, below) = (side(lower), side(upper));
        let candidates = real_roots(&self.composed(&x.polynomial())).into_iter();
        let here = candidates.filter(|t| t.sign_of(&above).is_gt() && t.sign_of(&below).is_lt());
        here.map(|t| t.simplified()).collect()
    }

    /// All `t` at which the map turns round, or may do so.
    pub fn turns(&self) -> Vec<RealAlgebraic> {
        let [p, q] = [self.numerator, self.denominator];
        real_roots(&p.derivative().times(q).minus(&q.derivative().times(p)).cleared().1)
    }

    /// `P - x Q`.
    fn below(&self, x: &Rational) -> Polynomial<Rational> {
        self.numerator.minus(&self.denominator.scaled(x))
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
    use refinable_reals::Bound;

    fn polynomial(coefficients: &[i64]) -> Polynomial<Rational> {
        Polynomial::new(coefficients.iter().map(|&c| rational(c, 1)).collect())
    }

    fn preimage(p: &[i64], q: &[i64], region: &Region) -> String {
        RationalMap::new(&polynomial(p), &polynomial(q)).preimage(region).display("t")
    }

    /// x = 1/t maps (1/2, ∞) to (0, 2) and the rest of it comes from nowhere.
    #[test]
    fn the_inversion() {
        let region = Region::open(rational(0, 1), rational(2, 1));
        assert_eq!(preimage(&[1], &[0, 1], &region), "(1/2, ∞)");
        let region = Region::interval(
            Bound::Closed(rational(-1, 1).into()),
            Bound::Open(rational(1, 1).into()),
        );
        assert_eq!(preimage(&[1], &[0, 1], &region), "(-∞, -1] ∪ (1, ∞)");
    }

    /// x = (t+1)/(t-1) and x = √2: t = (√2+1)/(√2-1) = 3+2√2.
    #[test]
    fn algebraic_ends_go_to_their_own_image() {
        let root = RealAlgebraic::quadratic(&rational(0, 1), &rational(1, 1), &rational(2, 1));
        let region = Region::interval(Bound::Open(root), Bound::Infinite);
        assert_eq!(preimage(&[1, 1], &[-1, 1], &region), "(1, 3+2*sqrt(2))");
    }

    /// x = t² covers the positive numbers twice, zero once and the negative ones never.
    #[test]
    fn the_square() {
        let region = Region::open(rational(-3, 1), rational(4, 1));
        assert_eq!(preimage(&[0, 0, 1], &[1], &region), "(-2, 2)");
        let region = Region::open(rational(0, 1), rational(4, 1));
        assert_eq!(preimage(&[0, 0, 1], &[1], &region), "(-2, 0) ∪ (0, 2)");
        let region = Region::point(rational(0, 1).into());
        assert_eq!(preimage(&[0, 0, 1], &[1], &region), "{0}");
        let region = Region::open(rational(-4, 1), rational(-1, 1));
        assert_eq!(preimage(&[0, 0, 1], &[1], &region), "∅");
        // The conjugate -√2 of the end √2 is no square: no end, though a root of the same polynomial.
        let root = RealAlgebraic::quadratic(&rational(0, 1), &rational(1, 1), &rational(2, 1));
        let region = Region::interval(Bound::Infinite, Bound::Open(root));
        assert_eq!(preimage(&[0, 0, 1], &[1], &region), "(root(t^4 - 2, 1), root(t^4 - 2, 2))");
    }

    /// x = t/(1+t²) rises between -1 and 1 and never exceeds 1/2 in magnitude; x = 2/5 at 1/2 and 2.
    #[test]
    fn a_map_that_turns_round() {
        let region = Region::interval(Bound::Closed(rational(2, 5).into()), Bound::Infinite);
        assert_eq!(preimage(&[0, 1], &[1, 0, 1], &region), "[1/2, 2]");
        let (p, q) = (polynomial(&[0, 1]), polynomial(&[1, 0, 1]));
        let turns = RationalMap::new(&p, &q).turns();
        assert_eq!(turns, [rational(-1, 1).into(), rational(1, 1).into()]);
    }
}
