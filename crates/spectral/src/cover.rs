//! Polytopes that cover an interval between two ends as far as the effort goes.

use refinable_algebra::Rational;
use refinable_certificate::Polytope;
use refinable_reals::{Interval, RealAlgebraic};

use crate::division::Options;
use crate::float::{approximate, approximate_root, short_dyadic};
use crate::search::{Crossing, Outcome, Search};
use crate::word::Word;

/// How many polytopes are tried one after the other between two numbers.
const MOST_STEPS: usize = 100;

/// Polytopes on parts of an interval.
#[derive(Default)]
pub(crate) struct Cover {
    pub polytopes: Vec<Polytope>,
    /// Words that turned out to grow.
    pub faster: Vec<Word>,
}

impl Cover {
    /// From one number towards another, each polytope from where the one before ends, as far as the
    /// effort goes.
    fn advance(search: &Search, from: &Rational, goal: &Rational) -> Self {
        let mut cover = Cover::default();
        let distance = |from: &Rational| approximate(&(goal - from)).abs();
        let mut reached = from.clone();
        let mut stride = distance(from);
        let mut last = None;
        for _ in 0..MOST_STEPS {
            let left = distance(&reached);
            // Floats come no nearer.
            if left == 0.0 || approximate(&reached) == approximate(goal) {
                break;
            }
            match search.step(&reached, goal, (stride / left).min(1.0), last) {
                Outcome::Proved(polytope, recipe) => {
                    last = Some(recipe);
                    // The next step may be longer if this one went as far as it was to.
                    let taken = left - distance(&polytope.inner.0);
                    stride = if taken > 0.75 * stride { 2.0 * taken } else { taken };
                    reached = polytope.inner.0.clone();
                    cover.polytopes.push(*polytope);
                }
                Outcome::Faster(word) => {
                    cover.faster.push(word);
                    break;
                }
                Outcome::Nothing => break,
            }
        }
        cover
    }

    /// From an end towards a goal: from the end itself, if a polytope reaches it exactly, or else from
    /// a number that is a gap away.
    fn from_end(
        search: &Search,
        end: &RealAlgebraic,
        crossings: &[Crossing],
        goal: &Rational,
        gap: f64,
    ) -> Self {
        let mut cover = Cover::default();
        let start = match search.up_to(end, crossings, goal) {
            Some(polytope) => {
                let reached = polytope.inner.0.clone();
                cover.polytopes.push(polytope);
                reached
            }
            None => short_dyadic(approximate_root(end) + gap, gap.abs() / 4.0),
        };
        cover.extend(Cover::between(search, &start, goal));
        cover
    }

    /// Between two numbers, from both of them to the middle.
    fn between(search: &Search, from: &Rational, to: &Rational) -> Self {
        let (a, b) = (approximate(from), approximate(to));
        if a == b {
            return Cover::default();
        }
        let middle = short_dyadic((a + b) / 2.0, (b - a).abs() / 8.0);
        let halves = rayon::join(
            || Cover::advance(search, from, &middle),
            || Cover::advance(search, to, &middle),
        );
        let mut cover = halves.0;
        cover.extend(halves.1);
        cover
    }

    fn extend(&mut self, other: Cover) {
        self.polytopes.extend(other.polytopes);
        self.faster.extend(other.faster);
    }
}

/// Polytopes for one open interval without known growing words.
pub(crate) fn prove(
    search: &Search,
    component: &Interval,
    crossings: &[Crossing],
    known: &[(Rational, Rational)],
    options: &Options,
) -> Cover {
    let (Some(lower), Some(upper)) = (component.lower.number(), component.upper.number()) else {
        // A set that is unbounded has no leading word at infinity; it is left undecided.
        return Cover::default();
    };
    let (a, b) = (approximate_root(lower), approximate_root(upper));
    if b <= a {
        return Cover::default();
    }
    // Both ends reach towards what is known inside already, or else towards each other's middle.
    let inside = |x: &Rational| {
        let x = approximate(x);
        a < x && x < b
    };
    let mut solid: Vec<(Rational, Rational)> =
        known.iter().filter(|(l, r)| inside(l) && inside(r)).cloned().collect();
    solid.sort();
    if solid.is_empty() {
        let middle = short_dyadic((a + b) / 2.0, (b - a) / 8.0);
        // Nothing can be sought where floats tell no number apart from both ends.
        if !inside(&middle) {
            return Cover::default();
        }
        solid.push((middle.clone(), middle));
    }
    // Not narrower than floats are apart.
    let least = f64::EPSILON * a.abs().max(b.abs());
    let gap = (approximate(&options.gap) * (b - a) * 0.5).max(least);
    let goals = (&solid[0].0, &solid[solid.len() - 1].1);
    let (mut cover, from_upper) = rayon::join(
        || Cover::from_end(search, lower, crossings, goals.0, gap),
        || Cover::from_end(search, upper, crossings, goals.1, -gap),
    );
    cover.extend(from_upper);
    for pair in solid.windows(2) {
        cover.extend(Cover::between(search, &pair[0].1, &pair[1].0));
    }
    cover
}
