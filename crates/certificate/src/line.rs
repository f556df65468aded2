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

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{integer, rational};

    /// The cuts below, at and above 0, 1 and 2, in ascending order.
    fn cuts() -> Vec<Cut> {
        let at = |n: i64| Real::Rational(Rational::from(integer(n)));
        let finite = (0..3).flat_map(|n| [Cut::Before(at(n)), Cut::After(at(n))]);
        [Cut::Lowest].into_iter().chain(finite).chain([Cut::Highest]).collect()
    }

    /// Between the cuts `i < j` of the list lie the cells `i` to `j - 1`: with the numbers of [`samples`] in them.
    fn spans() -> Vec<(Span, std::ops::Range<usize>)> {
        let pairs = (0..8).flat_map(|i| (i + 1..8).map(move |j| (i, j)));
        let span =
            |(i, j): (usize, usize)| Span { low: cuts()[i].clone(), high: cuts()[j].clone() };
        pairs.map(|(i, j)| (span((i, j)), i..j)).collect()
    }

    /// A number of each cell.
    fn samples() -> Vec<Rational> {
        (-1..6).map(|k| rational(k, 2)).collect()
    }

    #[test]
    fn spans_are_sets_of_cells() {
        let (spans, work) = (spans(), &mut Work::new());
        for (span, cells) in &spans {
            for (cell, x) in samples().iter().enumerate() {
                assert_eq!(span.contains(x, work), Ok(cells.contains(&cell)), "{span:?} {x}");
            }
            for (a, in_a) in &spans {
                for (b, in_b) in &spans {
                    let covered = cells.clone().all(|k| in_a.contains(&k) || in_b.contains(&k));
                    let both = [a.clone(), b.clone()];
                    assert_eq!(span.is_covered_by(&both, work), Ok(covered), "{span:?} {both:?}");
                }
            }
        }
    }

    #[test]
    fn an_interval_without_numbers_is_none() {
        let (cuts, work) = (cuts(), &mut Work::new());
        for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
            assert_eq!(Span::new(cuts[i].clone(), cuts[j].clone(), work).is_ok(), i < j);
        }
    }

    #[test]
    fn numbers_are_sorted_and_counted_once() {
        let work = &mut Work::new();
        let at = |n: i64| Real::Rational(Rational::from(integer(n)));
        let sorted = sorted(&[3, 1, 2, 3, -4, 1].map(at), work).unwrap();
        let numbers: Vec<_> = sorted.iter().map(|x| x.as_rational().cloned()).collect();
        assert_eq!(numbers, [-4, 1, 2, 3].map(|n| Some(Rational::from(integer(n)))));
        let parts = Span::complement(&[1, 0, 1].map(at), work).unwrap();
        let inside = |x: &Rational| {
            parts.iter().filter(|part| part.contains(x, &mut Work::new()) == Ok(true)).count()
        };
        let counts: Vec<usize> = samples().iter().map(inside).collect();
        assert_eq!(counts, [1, 0, 1, 0, 1, 1, 1]);
    }
}
