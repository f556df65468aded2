//! The conclusion from what the lemmas prove.

use refinable_algebra::{Rational, integer};

use crate::family::Scheme;
use crate::lemma::{Fact, Setting};
use crate::line::{Cut, Span};
use crate::model::{Conclusion, End, Interval, Pencil};
use crate::number::Number;
use crate::order::less;
use crate::real::Real;
use crate::regularity::logarithm;
use crate::verify::Proved;
use crate::work::{Check, Work, ensure, fail};

/// Checks that the conclusion follows.
pub(crate) fn check(
    scheme: &Scheme,
    conclusion: &Conclusion,
    proved: &[Proved],
    work: &mut Work,
) -> Check<()> {
    match conclusion {
        Conclusion::Continuity { continuity, proved: smooth, refuted } => {
            let known = Known::collect(scheme, *continuity, proved, work)?;
            known.check(*continuity, smooth, refuted, work)
        }
        Conclusion::Regularity { from, to, holder } => {
            check_regularity(scheme, [from, to], holder, proved, work)
        }
    }
}

/// What follows for the original mask from the facts inside a `reduced` lemma.
pub(crate) fn transfer(setting: &Setting, facts: &[Fact], work: &mut Work) -> Check<Fact> {
    let (Some(value), Some(continuity)) = (setting.value, setting.continuity) else {
        return fail("the conclusion is not about continuity");
    };
    let point = Span::point(value);
    let mut known = Known::default();
    for fact in facts {
        known.add(setting.scheme, continuity, fact, &point, work)?;
    }
    if point.is_covered_by(&known.contraction, work)? {
        return Ok(Fact::Smooth(value.clone()));
    }
    let expands = point.is_covered_by(&known.expansion, work)?;
    ensure(expands, "the lemmas inside show neither contraction, expansion nor indivisibility")?;
    let stable = point.is_covered_by(&known.stable, work)?;
    ensure(stable, "the lemmas inside do not show stability")?;
    Ok(Fact::Refuted(value.clone()))
}

/// What follows for the scheme from the facts inside a `convergence` lemma, which are about C^0.
pub(crate) fn convergence(facts: Vec<Fact>) -> Check<Vec<Fact>> {
    let follows = facts.into_iter().map(|fact| match fact {
        Fact::Contraction(Pencil::Parameter, span) => Ok(Fact::Convergent(span)),
        Fact::Expansion(Pencil::Parameter, span) => Ok(Fact::Divergent(span)),
        _ => fail("inside a `convergence` lemma is one that is about something else"),
    });
    follows.collect()
}

/// Sets of parameter values.
#[derive(Default)]
struct Known {
    contraction: Vec<Span>,
    /// Where continuity fails if the criterion of contraction is sharp.
    expansion: Vec<Span>,
    /// Where it is sharp, or continuity is known to fail.
    stable: Vec<Span>,
    /// Where the scheme converges.
    convergent: Vec<Span>,
    /// Where the limit function is smooth enough.
    smooth: Vec<Span>,
}

impl Known {
    fn collect(
        family: &Scheme,
        continuity: usize,
        proved: &[Proved],
        work: &mut Work,
    ) -> Check<Self> {
        let mut known = Known::default();
        for lemma in proved {
            let scheme = lemma.value.as_ref().map_or(family, |(_, member)| member);
            // What is proved about a member holds at its value, and about a constant family
            // everywhere.
            let place = lemma.value.as_ref().map_or_else(Span::line, |(t, _)| Span::point(t));
            for fact in &lemma.facts {
                known.add(scheme, continuity, fact, &place, work)?;
            }
        }
        // A scheme that converges to C^n functions is C^n.
        for point in std::mem::take(&mut known.smooth) {
            if point.is_covered_by(&known.convergent, work)? {
                known.contraction.push(point);
            }
        }
        Ok(known)
    }

    fn add(
        &mut self,
        scheme: &Scheme,
        continuity: usize,
        fact: &Fact,
        place: &Span,
        work: &mut Work,
    ) -> Check<()> {
        match fact {
            Fact::Contraction(Pencil::Parameter, span) => self.contraction.push(span.clone()),
            Fact::Expansion(Pencil::Parameter, span) => self.expansion.push(span.clone()),
            Fact::Contraction(Pencil::Scale, span) => {
                if span.contains(&unit_scale(scheme, continuity)?, work)? {
                    self.contraction.push(place.clone());
                }
            }
            Fact::Expansion(Pencil::Scale, span) => {
                if span.contains(&unit_scale(scheme, continuity)?, work)? {
                    self.expansion.push(place.clone());
                }
            }
            Fact::Indivisible { order, except } => {
                if order.saturating_sub(1) <= continuity {
                    self.expansion.extend(within(place, except, work)?);
                }
            }
            Fact::Stable(except) => self.stable.extend(within(place, except, work)?),
            Fact::Refuted(value) => self.refute(Span::point(value)),
            Fact::Divergent(span) => self.refute(span.clone()),
            Fact::Convergent(span) => self.convergent.push(span.clone()),
            Fact::Smooth(value) => self.smooth.push(Span::point(value)),
        }
        Ok(())
    }

    /// Adds a set on which continuity fails, whether the criterion is sharp or not.
    fn refute(&mut self, span: Span) {
        self.expansion.push(span.clone());
        self.stable.push(span);
    }

    fn check(
        &self,
        continuity: usize,
        proved: &[Interval],
        refuted: &[Interval],
        work: &mut Work,
    ) -> Check<()> {
        for (index, interval) in proved.iter().enumerate() {
            let span = Span::of_interval(interval, work)?;
            if !span.is_covered_by(&self.contraction, work)? {
                return fail(format!("proved interval {index} is not covered by the lemmas"));
            }
        }
        for (index, interval) in refuted.iter().enumerate() {
            let span = Span::of_interval(interval, work)?;
            if !span.is_covered_by(&self.expansion, work)? {
                return fail(format!("refuted interval {index} is not covered by the lemmas"));
            }
            if continuity >= 1 && !span.is_covered_by(&self.stable, work)? {
                return fail(format!("refuted interval {index} is not shown to be stable"));
            }
        }
        Ok(())
    }
}

/// The scale at which the pencil "scale" has the matrices over the bound.
fn unit_scale(scheme: &Scheme, continuity: usize) -> Check<Rational> {
    Ok(Rational::new(integer(1), scheme.bound(continuity)?))
}

/// A place, the line or a point, without the exceptions.
fn within(place: &Span, except: &[Real], work: &mut Work) -> Check<Vec<Span>> {
    let Some(point) = place.low.number() else { return Span::complement(except, work) };
    for x in except {
        if x.compare(point, work)?.is_eq() {
            return Ok(Vec::new());
        }
    }
    Ok(vec![place.clone()])
}

fn check_regularity(
    scheme: &Scheme,
    [from, to]: [&End; 2],
    [lower, upper]: &[Number; 2],
    proved: &[Proved],
    work: &mut Work,
) -> Check<()> {
    ensure(scheme.constant, "the regularity of a family with a parameter")?;
    let [from, to] = [Real::new(from, work)?, Real::new(to, work)?];
    let zero = Real::Rational(Rational::from(integer(0)));
    let (mut contraction, mut expansion, mut stable) = (Vec::new(), Vec::new(), false);
    for fact in proved.iter().flat_map(|lemma| &lemma.facts) {
        match fact {
            Fact::Contraction(Pencil::Scale, span) => contraction.push(span.clone()),
            Fact::Expansion(Pencil::Scale, span) => expansion.push(span.clone()),
            Fact::Stable(except) => stable |= except.is_empty(),
            _ => {}
        }
    }
    let inside = Span::new(Cut::Before(zero.clone()), Cut::Before(from.clone()), work)?;
    ensure(to.compare(&zero, work)?.is_gt(), "the upper end is not positive")?;
    // The radius is proportional to the scale: expansion at one scale is expansion from there on.
    let outside = Span { low: Cut::Before(to.clone()), high: Cut::After(to.clone()) };
    let contracts = inside.is_covered_by(&contraction, work)?;
    ensure(contracts, "contraction up to the lower end is not covered by the lemmas")?;
    let expands = outside.is_covered_by(&expansion, work)?;
    ensure(expands, "expansion at the upper end is not covered by the lemmas")?;
    ensure(stable, "the shifts are not shown to be stable")?;
    ensure(!scheme.is_divisible(scheme.order + 1), "the symbol is divisible more often")?;
    let order = Rational::from(integer(scheme.order as i64 - 1));
    let below = logarithm(&from, scheme.arity, work)?.0 + &order;
    let above = logarithm(&to, scheme.arity, work)?.1 + &order;
    ensure(!less(&below, &lower.0), "the lower bound of the regularity does not follow")?;
    ensure(!less(&upper.0, &above), "the upper bound of the regularity does not follow")
}
