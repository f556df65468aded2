//! Where a sum of absolute values of polynomials stays below another polynomial in size.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, integer};
use refinable_reals::{Bound, Interval, RealAlgebraic, Region, real_roots, real_roots_between};

/// The condition `Σ_i weight_i |p_i(t)| < |d(t)|`: one row of a norm at one level.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct RowCondition {
    /// Distinct nonzero polynomials with positive leading coefficients, in a fixed order, each with
    /// the number of times it occurs up to sign.
    terms: Vec<(Polynomial<Integer>, u32)>,
}

impl RowCondition {
    /// The condition for a list of polynomials; sign, order and zeros make no difference.
    pub fn new(row: &[Polynomial<Integer>]) -> Self {
        let mut polynomials: Vec<_> = row.iter().filter(|p| !p.is_zero()).map(positive).collect();
        polynomials.sort_by(|p, q| p.coefficients().cmp(q.coefficients()));
        let mut terms: Vec<(Polynomial<Integer>, u32)> = Vec::new();
        for p in polynomials {
            match terms.last_mut() {
                Some((last, count)) if *last == p => *count += 1,
                _ => terms.push((p, 1)),
            }
        }
        RowCondition { terms }
    }

    /// The distinct polynomials and how often each occurs up to sign.
    pub fn terms(&self) -> &[(Polynomial<Integer>, u32)] {
        &self.terms
    }

    /// Whether all polynomials of the row are zero.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The largest degree; 0 for an empty row.
    pub fn degree(&self) -> usize {
        self.terms.iter().filter_map(|(p, _)| p.degree()).max().unwrap_or(0)
    }

    /// A size by which rows are tried: those that grow fastest cut the region soonest.
    pub fn growth(&self) -> Integer {
        let leading = |p: &Polynomial<Integer>| p.leading().expect("not zero").clone();
        self.terms.iter().fold(integer(0), |sum, (p, n)| sum + leading(p) * integer(i64::from(*n)))
    }

    /// The exact value of `Σ weight |p(t)|` at a rational point.
    pub fn value_at(&self, t: &Rational) -> Rational {
        let value = |p: &Polynomial<Integer>| p.value_at(t).absolute();
        let zero = Rational::zero();
        self.terms.iter().fold(zero, |sum, (p, n)| sum + value(p) * integer(i64::from(*n)))
    }

    /// Whether the condition holds at `t`, exactly.
    pub fn holds_at(&self, d: &Polynomial<Integer>, t: &RealAlgebraic) -> bool {
        let excess = self.excess(d, |p| t.sign_of(p));
        t.sign_of(&excess).is_lt()
    }

    /// `Σ weight sign(p) p - sign(d) d` for the signs at some place.
    pub fn excess(
        &self,
        d: &Polynomial<Integer>,
        sign: impl Fn(&Polynomial<Integer>) -> Ordering,
    ) -> Polynomial<Integer> {
        let signed = |p: &Polynomial<Integer>, n: i64| match sign(p) {
            Ordering::Less => p.scaled(&integer(-n)),
            _ => p.scaled(&integer(n)),
        };
        let terms = self.terms.iter().map(|(p, n)| signed(p, i64::from(*n)));
        terms.fold(signed(d, 1).negated(), |sum, term| sum.plus(&term))
    }

    /// The part of `within` where the condition holds, exactly.
    ///
    /// Between consecutive roots of the `p_i` and `d` all signs are constant and the condition is
    /// one polynomial inequality; at those roots the excess is continuous.
    ///
    /// # Cost
    /// One isolation for each polynomial of the row and one for each piece.
    pub fn region(&self, d: &Polynomial<Integer>, within: &Interval) -> Region {
        let breaks = self.breakpoints(d, within);
        let mut holds = Vec::new();
        for piece in within.gaps(&breaks) {
            let sample = piece.sample();
            let excess = self.excess(d, |p| p.sign_at(&sample));
            holds.push(negative_part(&excess, &piece));
            // The piece's upper end, unless it is that of the whole interval.
            if let Some(x) = piece.upper.number().filter(|x| breaks.contains(x))
                && x.sign_of(&excess).is_lt()
            {
                holds.push(Region::point(x.clone()));
            }
        }
        let closed_ends = [&within.lower, &within.upper].into_iter().filter(|b| b.is_closed());
        let at_ends = closed_ends.filter_map(Bound::number).filter(|x| self.holds_at(d, x));
        holds.extend(at_ends.cloned().map(Region::point));
        Region::union_of(holds).intersection(&within.into())
    }

    /// The distinct roots of all polynomials strictly inside the interval, ascending.
    fn breakpoints(&self, d: &Polynomial<Integer>, within: &Interval) -> Vec<RealAlgebraic> {
        let all = self.terms.iter().map(|(p, _)| p).chain([d]);
        let mut breaks: Vec<RealAlgebraic> = all.flat_map(|p| roots_inside(p, within)).collect();
        breaks.sort();
        breaks.dedup();
        breaks
    }
}

fn positive(p: &Polynomial<Integer>) -> Polynomial<Integer> {
    if p.sign_at_infinity().is_lt() { p.negated() } else { p.clone() }
}

/// The roots of a nonzero polynomial strictly inside an interval, ascending.
fn roots_inside(p: &Polynomial<Integer>, within: &Interval) -> Vec<RealAlgebraic> {
    let (lower, upper) = (within.lower.number(), within.upper.number());
    let roots = match (lower, upper) {
        (Some(lower), Some(upper)) => real_roots_between(p, &lower.bounds().0, &upper.bounds().1),
        _ => real_roots(p),
    };
    let is_inside = |x: &RealAlgebraic| {
        lower.is_none_or(|lower| lower < x) && upper.is_none_or(|upper| x < upper)
    };
    roots.into_iter().filter(is_inside).collect()
}

/// The part of the inside of an interval on which `p` is negative.
fn negative_part(p: &Polynomial<Integer>, within: &Interval) -> Region {
    if p.is_zero() {
        return Region::empty();
    }
    within.gaps_where(&roots_inside(p, within), |sample| p.sign_at(sample).is_lt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn a_sum_of_two_absolute_values() {
        // |t| + |t - 1| < 3: -1 < t < 2
        let row = RowCondition::new(&[poly(&[0, 1]), poly(&[1, -1])]);
        assert_eq!(
            row.region(&poly(&[3]), &Interval::LINE),
            Region::open(rational(-1, 1), rational(2, 1))
        );
        // |t| + |t - 1| < 1 never holds, and ≤ only on [0, 1].
        assert_eq!(row.region(&poly(&[1]), &Interval::LINE), Region::empty());
    }

    #[test]
    fn a_touching_point_is_left_out() {
        // |t² - 2| < 2: (-2, 0) ∪ (0, 2)
        let row = RowCondition::new(&[poly(&[-2, 0, 1])]);
        let expected = Region::open(rational(-2, 1), rational(0, 1))
            .union(&Region::open(rational(0, 1), rational(2, 1)));
        assert_eq!(row.region(&poly(&[2]), &Interval::LINE), expected);
    }

    #[test]
    fn a_denominator_cuts_out_its_pole() {
        // 1 < |t|: outside [-1, 1]; and |t - 1| < |t - 1| nowhere.
        let row = RowCondition::new(&[poly(&[1])]);
        assert_eq!(row.region(&poly(&[0, 1]), &Interval::LINE).display("t"), "(-∞, -1) ∪ (1, ∞)");
        let same = RowCondition::new(&[poly(&[-1, 1])]);
        assert_eq!(same.region(&poly(&[-1, 1]), &Interval::LINE), Region::empty());
    }

    #[test]
    fn irrational_breakpoints_inside_the_region_belong_to_it() {
        // |t² - 2| < 1: 1 < |t| < √3, across the breakpoints ±√2.
        let row = RowCondition::new(&[poly(&[-2, 0, 1])]);
        let region = row.region(&poly(&[1]), &Interval::LINE);
        assert_eq!(region.display("t"), "(-sqrt(3), -1) ∪ (1, sqrt(3))");
    }

    #[test]
    fn signs_and_repetitions_are_merged() {
        let row = RowCondition::new(&[poly(&[1, 1]), poly(&[]), poly(&[-1, -1])]);
        assert_eq!(row.value_at(&rational(1, 2)), rational(3, 1));
        assert_eq!(row.region(&poly(&[4]), &Interval::LINE).display("t"), "(-3, 1)");
    }
}
