//! Regions of the real line: finite unions of intervals with exact ends.

use std::{fmt, iter};

use refinable_algebra::{Rational, Ring};

use crate::algebraic::RealAlgebraic;

/// A place where the line can be cut: at infinity, or just before or just after a number.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Cut {
    Start,
    At(RealAlgebraic, Side),
    End,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Side {
    Before,
    After,
}

/// One end of an interval.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Bound {
    /// The interval goes on for ever.
    Infinite,
    /// The number does not belong to the interval.
    Open(RealAlgebraic),
    /// The number belongs to the interval.
    Closed(RealAlgebraic),
}

impl Bound {
    /// The number at this end, if it is finite.
    pub fn number(&self) -> Option<&RealAlgebraic> {
        match self {
            Bound::Infinite => None,
            Bound::Open(x) | Bound::Closed(x) => Some(x),
        }
    }

    /// Whether the number belongs to the interval.
    pub fn is_closed(&self) -> bool {
        matches!(self, Bound::Closed(_))
    }
}

/// A nonempty interval.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Interval {
    /// The lower end.
    pub lower: Bound,
    /// The upper end.
    pub upper: Bound,
}

impl Interval {
    /// The whole line.
    pub const LINE: Interval = Interval { lower: Bound::Infinite, upper: Bound::Infinite };

    /// The only number of the interval, if there is only one.
    pub fn as_point(&self) -> Option<&RealAlgebraic> {
        match (&self.lower, &self.upper) {
            (Bound::Closed(a), Bound::Closed(b)) if a == b => Some(a),
            _ => None,
        }
    }

    /// A rational number between the ends.
    ///
    /// # Panics
    /// If the interval is a single point.
    pub fn sample(&self) -> Rational {
        let one = Rational::one();
        match (self.lower.number(), self.upper.number()) {
            (None, None) => Rational::zero(),
            (Some(x), None) => x.bounds().1.ceil() + one,
            (None, Some(x)) => x.bounds().0.floor() - one,
            (Some(a), Some(b)) => a.rational_between(b),
        }
    }

    /// The open intervals that are left when the ends and strictly ascending numbers between them are taken out,
    /// ascending.
    pub fn gaps(&self, cuts: &[RealAlgebraic]) -> Vec<Interval> {
        let open =
            |x: Option<&RealAlgebraic>| x.map_or(Bound::Infinite, |x| Bound::Open(x.clone()));
        let lowers = iter::once(self.lower.number()).chain(cuts.iter().map(Some));
        let uppers = cuts.iter().map(Some).chain([self.upper.number()]);
        let ends = lowers.zip(uppers);
        ends.map(|(a, b)| Interval { lower: open(a), upper: open(b) }).collect()
    }

    /// The union of those [`gaps`](Self::gaps) whose samples satisfy a condition: with the roots of polynomials
    /// as the cuts, of those on which a condition on their signs holds.
    pub fn gaps_where(&self, cuts: &[RealAlgebraic], holds: impl Fn(&Rational) -> bool) -> Region {
        let gaps = self.gaps(cuts);
        Region::union_of(gaps.iter().filter(|gap| holds(&gap.sample())).map(Region::from))
    }
}

/// A finite union of intervals: the strictly ascending list of the cuts at which membership
/// changes, beginning outside. The list is unique, so equality of regions is equality of sets.
#[derive(Clone, PartialEq, Eq)]
pub struct Region {
    cuts: Vec<Cut>,
}

impl Region {
    /// The empty set.
    pub fn empty() -> Self {
        Region { cuts: Vec::new() }
    }

    /// The whole line.
    pub fn line() -> Self {
        Region { cuts: vec![Cut::Start, Cut::End] }
    }

    /// `{x}`.
    pub fn point(x: RealAlgebraic) -> Self {
        Region { cuts: vec![Cut::At(x.clone(), Side::Before), Cut::At(x, Side::After)] }
    }

    /// The interval between two ends; empty if they leave nothing between them.
    pub fn interval(lower: Bound, upper: Bound) -> Self {
        let lower = match lower {
            Bound::Infinite => Cut::Start,
            Bound::Open(x) => Cut::At(x, Side::After),
            Bound::Closed(x) => Cut::At(x, Side::Before),
        };
        let upper = match upper {
            Bound::Infinite => Cut::End,
            Bound::Open(x) => Cut::At(x, Side::Before),
            Bound::Closed(x) => Cut::At(x, Side::After),
        };
        if lower < upper { Region { cuts: vec![lower, upper] } } else { Region::empty() }
    }

    /// `{x : lower < x < upper}`.
    pub fn open(lower: impl Into<RealAlgebraic>, upper: impl Into<RealAlgebraic>) -> Self {
        Region::interval(Bound::Open(lower.into()), Bound::Open(upper.into()))
    }

    /// The union of finitely many regions.
    pub fn union_of(regions: impl IntoIterator<Item = Region>) -> Self {
        regions.into_iter().fold(Region::empty(), |all, region| all.union(&region))
    }

    /// The set of finitely many points.
    pub fn points(points: impl IntoIterator<Item = RealAlgebraic>) -> Self {
        Region::union_of(points.into_iter().map(Region::point))
    }

    /// Everything outside.
    pub fn complement(&self) -> Self {
        Region::line().difference(self)
    }

    /// The points of either.
    pub fn union(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a || b)
    }

    /// The points of both.
    pub fn intersection(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a && b)
    }

    /// The points of `self` outside `other`.
    pub fn difference(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a && !b)
    }

    /// Whether every point of `self` is in `other`.
    pub fn is_subset(&self, other: &Self) -> bool {
        self.difference(other).is_empty()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.cuts.is_empty()
    }

    /// Whether `x` belongs to the region.
    pub fn contains(&self, x: &RealAlgebraic) -> bool {
        let here = Cut::At(x.clone(), Side::Before);
        self.cuts.iter().take_while(|cut| **cut <= here).count() % 2 == 1
    }

    /// Whether the rational number `x` belongs to the region.
    pub fn contains_rational(&self, x: &Rational) -> bool {
        self.contains(&x.clone().into())
    }

    /// The maximal intervals, ascending; isolated points are intervals with equal closed ends.
    pub fn intervals(&self) -> Vec<Interval> {
        let bound = |cut: &Cut, closed: Side| match cut {
            Cut::Start | Cut::End => Bound::Infinite,
            Cut::At(x, side) if *side == closed => Bound::Closed(x.clone()),
            Cut::At(x, _) => Bound::Open(x.clone()),
        };
        let pairs = self.cuts.chunks_exact(2);
        pairs
            .map(|pair| Interval {
                lower: bound(&pair[0], Side::Before),
                upper: bound(&pair[1], Side::After),
            })
            .collect()
    }

    /// The finite numbers at which membership changes, ascending, each once.
    pub fn ends(&self) -> Vec<RealAlgebraic> {
        let mut ends: Vec<RealAlgebraic> = Vec::new();
        for cut in &self.cuts {
            if let Cut::At(x, _) = cut
                && ends.last() != Some(x)
            {
                ends.push(x.clone());
            }
        }
        ends
    }

    /// The region with every end in its simplest stored form.
    pub fn simplified(&self) -> Self {
        let cuts = self.cuts.iter().map(|cut| match cut {
            Cut::At(x, side) => Cut::At(x.simplified(), *side),
            infinite => infinite.clone(),
        });
        Region { cuts: cuts.collect() }
    }

    /// Whether the list of cuts is what the type promises.
    pub fn check_invariants(&self) -> bool {
        self.cuts.len().is_multiple_of(2) && self.cuts.windows(2).all(|pair| pair[0] < pair[1])
    }

    /// Sweeps both lists of cuts and records where `keep(in self, in other)` changes.
    fn combine(&self, other: &Self, keep: impl Fn(bool, bool) -> bool) -> Self {
        let (mut i, mut j) = (0, 0);
        let mut cuts = Vec::new();
        let mut inside = false;
        while i < self.cuts.len() || j < other.cuts.len() {
            let cut = match (self.cuts.get(i), other.cuts.get(j)) {
                (Some(a), Some(b)) => a.min(b).clone(),
                (a, b) => a.or(b).expect("the loop goes on while one is left").clone(),
            };
            i += usize::from(self.cuts.get(i) == Some(&cut));
            j += usize::from(other.cuts.get(j) == Some(&cut));
            if keep(i % 2 == 1, j % 2 == 1) != inside {
                inside = !inside;
                cuts.push(cut);
            }
        }
        let result = Region { cuts };
        debug_assert!(result.check_invariants());
        result
    }
}

impl Region {
    /// The region as text, roots written in the named variable: `(-1/4, 3/4) ∪ {1}`, or `∅`.
    pub fn display(&self, variable: &str) -> String {
        let number = |x: &RealAlgebraic| x.exact_form().display(variable);
        let parts: Vec<String> = self
            .intervals()
            .iter()
            .map(|interval| match interval.as_point() {
                Some(x) => format!("{{{}}}", number(x)),
                None => {
                    let lower = match &interval.lower {
                        Bound::Infinite => "(-∞".to_string(),
                        Bound::Open(x) => format!("({}", number(x)),
                        Bound::Closed(x) => format!("[{}", number(x)),
                    };
                    let upper = match &interval.upper {
                        Bound::Infinite => "∞)".to_string(),
                        Bound::Open(x) => format!("{})", number(x)),
                        Bound::Closed(x) => format!("{}]", number(x)),
                    };
                    format!("{lower}, {upper}")
                }
            })
            .collect();
        if parts.is_empty() { "∅".into() } else { parts.join(" ∪ ") }
    }
}

impl From<&Interval> for Region {
    fn from(interval: &Interval) -> Self {
        Region::interval(interval.lower.clone(), interval.upper.clone())
    }
}

impl fmt::Debug for Region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.display("x"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn open(a: i64, b: i64) -> Region {
        Region::open(rational(a, 1), rational(b, 1))
    }
    fn point(a: i64) -> Region {
        Region::point(rational(a, 1).into())
    }

    #[test]
    fn touching_open_intervals_leave_the_point_out() {
        let region = open(0, 1).union(&open(1, 2));
        assert_eq!(region.display("x"), "(0, 1) ∪ (1, 2)");
        assert_eq!(region.union(&point(1)), open(0, 2));
        assert_eq!(open(0, 2).difference(&point(1)), region);
    }

    #[test]
    fn complement_is_an_involution_and_swaps_ends() {
        let region = open(0, 1).union(&point(3));
        assert_eq!(region.complement().display("x"), "(-∞, 0] ∪ [1, 3) ∪ (3, ∞)");
        assert_eq!(region.complement().complement(), region);
        assert_eq!(Region::empty().complement(), Region::line());
        assert_eq!(Region::line().complement(), Region::empty());
    }

    #[test]
    fn membership_respects_open_ends() {
        let region = open(0, 1).union(&point(3));
        let has = |p, q| region.contains_rational(&rational(p, q));
        assert!(has(1, 2) && has(3, 1));
        assert!(!has(0, 1) && !has(1, 1) && !has(5, 2));
    }

    #[test]
    fn gaps_and_the_numbers_taken_out_make_the_interval() {
        let cuts = [0, 2].map(|n| RealAlgebraic::from(rational(n, 1)));
        let display =
            |gaps: &[Interval]| Region::union_of(gaps.iter().map(Region::from)).display("x");
        assert_eq!(display(&Interval::LINE.gaps(&cuts)), "(-∞, 0) ∪ (0, 2) ∪ (2, ∞)");
        let closed = &point(-1).union(&open(-1, 3)).union(&point(3)).intervals()[0];
        assert_eq!(display(&closed.gaps(&cuts)), "(-1, 0) ∪ (0, 2) ∪ (2, 3)");
        assert_eq!(Interval::LINE.gaps(&[]), [Interval::LINE]);
        let positive = Interval::LINE.gaps_where(&cuts, |x| *x > Rational::zero());
        assert_eq!(positive.display("x"), "(0, 2) ∪ (2, ∞)");
        for gap in Interval::LINE.gaps(&cuts).iter().chain(&closed.gaps(&cuts)) {
            assert!(Region::from(gap).contains_rational(&gap.sample()));
        }
    }

    #[test]
    fn an_interval_without_points_is_empty() {
        assert_eq!(open(2, 1), Region::empty());
        assert_eq!(open(1, 1), Region::empty());
        assert_eq!(open(0, 1).intersection(&open(1, 2)), Region::empty());
    }

    #[test]
    fn lists_of_cuts_that_are_none() {
        let at = |n: i64, side| Cut::At(rational(n, 1).into(), side);
        let holds = |cuts: &[Cut]| Region { cuts: cuts.to_vec() }.check_invariants();
        let [before, after, next] = [at(0, Side::Before), at(0, Side::After), at(1, Side::Before)];
        assert!(holds(&[]) && holds(&[before.clone(), after.clone()]));
        assert!(holds(&[Cut::Start, before.clone(), after.clone(), next.clone()]));
        assert!(!holds(std::slice::from_ref(&before)) && !holds(&[next.clone(), after.clone()]));
        assert!(!holds(&[after.clone(), after.clone()]));
        assert!(!holds(&[Cut::Start, before, next, after]));
        let zero = || RealAlgebraic::from(rational(0, 1));
        for (lower, upper) in [
            (Bound::Open(zero()), Bound::Closed(zero())),
            (Bound::Closed(zero()), Bound::Open(zero())),
        ] {
            assert_eq!(Region::interval(lower, upper), Region::empty());
        }
        assert_eq!(format!("{:?}", open(0, 1).union(&point(3))), "(0, 1) ∪ {3}");
    }
}
