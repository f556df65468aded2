//! Intervals of the real line with algebraic ends: containment in a union.

use std::cmp::Ordering;

use refinable_algebra::Rational;

use crate::model::{End, Interval};
use crate::real::Real;
use crate::work::{Check, Work, ensure, fail};

/// A place between two numbers: a number belongs to one side.
#[derive(Clone, Debug)]
pub(crate) enum Cut {
    /// Below all numbers.
    Lowest,
    /// Just below the number.
    Before(Real),
    /// Just above the number.
    After(Real),
    /// Above all numbers.
    Highest,
}

impl Cut {
    fn compare(&self, other: &Cut, work: &mut Work) -> Check<Ordering> {
        let rank = |cut: &Cut| match cut {
            Cut::Lowest => 0,
            Cut::Before(_) | Cut::After(_) => 1,
            Cut::Highest => 2,
        };
        let (Some(a), Some(b)) = (self.number(), other.number()) else {
            return Ok(rank(self).cmp(&rank(other)));
        };
        let side = |cut: &Cut| matches!(cut, Cut::After(_));
        Ok(a.compare(b, work)?.then(side(self).cmp(&side(other))))
    }

    /// The number, if the cut is at one.
    pub fn number(&self) -> Option<&Real> {
        match self {
            Cut::Before(x) | Cut::After(x) => Some(x),
            Cut::Lowest | Cut::Highest => None,
        }
    }
}

/// The numbers between two cuts, at least one.
#[derive(Clone, Debug)]
pub(crate) struct Span {
    /// The lower cut.
    pub low: Cut,
    /// The upper cut.
    pub high: Cut,
}

impl Span {
    /// The numbers between two cuts; fails if there are none.
    pub fn new(low: Cut, high: Cut, work: &mut Work) -> Check<Self> {
        ensure(low.compare(&high, work)?.is_lt(), "an interval is empty")?;
        Ok(Span { low, high })
    }

    /// The interval as it stands in a certificate.
    pub fn of_interval(interval: &Interval, work: &mut Work) -> Check<Self> {
        let (open, close) = match interval.ends.as_str() {
            "[]" => (true, true),
            "[)" => (true, false),
            "(]" => (false, true),
            "()" => (false, false),
            _ => return fail("an interval has unknown ends"),
        };
        let finite = |end: &Option<End>, closed: bool| {
            ensure(end.is_some() || !closed, "an infinite end belongs to an interval")
        };
        finite(&interval.from, open)?;
        finite(&interval.to, close)?;
        let low = match &interval.from {
            None => Cut::Lowest,
            Some(end) if open => Cut::Before(Real::new(end, work)?),
            Some(end) => Cut::After(Real::new(end, work)?),
        };
        let high = match &interval.to {
            None => Cut::Highest,
            Some(end) if close => Cut::After(Real::new(end, work)?),
            Some(end) => Cut::Before(Real::new(end, work)?),
        };
        Span::new(low, high, work)
    }

    /// The closed interval; `None` is infinite.
    pub fn closed(from: Option<Real>, to: Option<Real>, work: &mut Work) -> Check<Self> {
        let low = from.map_or(Cut::Lowest, Cut::Before);
        let high = to.map_or(Cut::Highest, Cut::After);
        Span::new(low, high, work)
    }

    /// One number.
    pub fn point(x: &Rational) -> Self {
        let x = Real::Rational(x.clone());
        Span { low: Cut::Before(x.clone()), high: Cut::After(x) }
    }

    /// All numbers.
    pub fn line() -> Self {
        Span { low: Cut::Lowest, high: Cut::Highest }
    }

    /// The parts of the line between finitely many numbers, which do not belong to them.
    pub fn complement(points: &[Real], work: &mut Work) -> Check<Vec<Self>> {
        let mut parts = Vec::new();
        let mut low = Cut::Lowest;
        for x in sorted(points, work)? {
            parts.push(Span { low, high: Cut::Before(x.clone()) });
            low = Cut::After(x);
        }
        parts.push(Span { low, high: Cut::Highest });
        Ok(parts)
    }

    /// Whether the number belongs to it.
    pub fn contains(&self, x: &Rational, work: &mut Work) -> Check<bool> {
        self.includes(&Span::point(x), work)
    }

    fn includes(&self, inner: &Span, work: &mut Work) -> Check<bool> {
        Ok(self.low.compare(&inner.low, work)?.is_le()
            && inner.high.compare(&self.high, work)?.is_le())
    }

    /// Whether every number of it belongs to one of the others.
    pub fn is_covered_by(&self, others: &[Span], work: &mut Work) -> Check<bool> {
        let mut reached = &self.low;
        while reached.compare(&self.high, work)?.is_lt() {
            let mut farthest = reached;
            for other in others {
                if other.low.compare(reached, work)?.is_le()
                    && farthest.compare(&other.high, work)?.is_lt()
                {
                    farthest = &other.high;
                }
            }
            if farthest.compare(reached, work)?.is_eq() {
                return Ok(false);
            }
            reached = farthest;
        }
        Ok(true)
    }
}

/// The distinct numbers in ascending order, by insertion.
pub(crate) fn sorted(points: &[Real], work: &mut Work) -> Check<Vec<Real>> {
    let mut sorted: Vec<Real> = Vec::with_capacity(points.len());
    'points: for x in points {
        let mut place = sorted.len();
        while place > 0 {
            match x.compare(&sorted[place - 1], work)? {
                Ordering::Equal => continue 'points,
                Ordering::Greater => break,
                Ordering::Less => place -= 1,
            }
        }
        sorted.insert(place, x.clone());
    }
    Ok(sorted)
}
