//! What each kind of lemma proves.

use refinable_algebra::{Integer, Rational, Ring, integer};

use crate::family::{Letters, Scheme};
use crate::line::Span;
use crate::model::{End, Lemma, Pencil, Polytope};
use crate::real::Real;
use crate::stability::{CommonZero, common_zero};
use crate::work::{Check, Work, ensure, fail, largest_bits};
use crate::{limits, nonnegative, norm, polytope, stability, word};

/// A statement that has been checked.
pub(crate) enum Fact {
    /// The joint spectral radius is less than one on the span.
    Contraction(Pencil, Span),
    /// The joint spectral radius is at least one on the span.
    Expansion(Pencil, Span),
    /// `σ^order` does not divide the symbol but for the exceptions.
    Indivisible {
        /// The power.
        order: usize,
        /// The exceptions.
        except: Vec<Real>,
    },
    /// The criterion of contraction is sharp but for the exceptions.
    Stable(Vec<Real>),
    /// The scheme is not C^n at the value.
    Refuted(Rational),
    /// The limit function is C^n at the value.
    Smooth(Rational),
    /// The scheme converges on the span.
    Convergent(Span),
    /// The scheme does not converge on the span.
    Divergent(Span),
}

/// What lemmas are about: a family, or one member of it.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a> {
    /// The family or its member.
    pub scheme: &'a Scheme,
    /// The order of continuity of the conclusion, if it is about continuity.
    pub continuity: Option<usize>,
    /// The parameter value of the member.
    pub value: Option<&'a Rational>,
}

/// The kind of a lemma as it is written.
pub(crate) fn kind(lemma: &Lemma) -> &'static str {
    match lemma {
        Lemma::Norm { .. } => "norm",
        Lemma::Polytope(_) => "polytope",
        Lemma::Word { .. } => "word",
        Lemma::Indivisible { .. } => "indivisible",
        Lemma::Stable { .. } => "stable",
        Lemma::Nonnegative { .. } => "nonnegative",
        Lemma::At { .. } => "at",
        Lemma::Convergence { .. } => "convergence",
        Lemma::Reduced { .. } => "reduced",
    }
}

impl Setting<'_> {
    /// Checks a lemma that has no lemmas inside.
    pub fn check(&self, lemma: &Lemma, work: &mut Work) -> Check<Fact> {
        match lemma {
            Lemma::Norm { level, from, to } => self.check_norm(*level, [&from.0, &to.0], work),
            Lemma::Polytope(polytope) => self.check_polytope(polytope, work),
            Lemma::Word { pencil, word, from, to } => {
                self.check_word(*pencil, word, [from, to], work)
            }
            Lemma::Indivisible { order, except } => self.check_indivisible(*order, except, work),
            Lemma::Stable { except } => {
                let except = reals(except, work)?;
                let listed = !self.scheme.constant || except.is_empty();
                ensure(listed, "an exception but no parameter")?;
                stability::check(self.scheme, &except, work)?;
                Ok(Fact::Stable(except))
            }
            Lemma::Nonnegative { end } => {
                let end = Real::new(end, work)?;
                let span = nonnegative::check(self.scheme, end, work)?;
                Ok(Fact::Contraction(Pencil::Scale, span))
            }
            Lemma::At { .. } | Lemma::Convergence { .. } | Lemma::Reduced { .. } => {
                fail(limits::NESTED)
            }
        }
    }

    fn letters(&self, pencil: Pencil) -> Check<Letters> {
        match (pencil, self.continuity) {
            (Pencil::Scale, _) => Letters::of_scale(self.scheme),
            (Pencil::Parameter, Some(n)) => Letters::of_parameter(self.scheme, n),
            (Pencil::Parameter, None) => fail("the conclusion gives no bound for the parameter"),
        }
    }

    /// Inside an `at` or a `reduced`, the parameter has one value.
    fn check_value(&self, pencil: Pencil, ends: [Option<&Real>; 2], work: &mut Work) -> Check<()> {
        let (Some(value), Pencil::Parameter) = (self.value, pencil) else { return Ok(()) };
        let value = Real::Rational(value.clone());
        for end in ends {
            let Some(end) = end else {
                return fail("an infinite end inside a lemma about one value");
            };
            ensure(
                end.compare(&value, work)?.is_eq(),
                "an end that is not the value of the lemma around it",
            )?;
        }
        Ok(())
    }

    fn check_norm(&self, level: u32, ends: [&Rational; 2], work: &mut Work) -> Check<Fact> {
        let Some(continuity) = self.continuity else {
            return fail("the conclusion is not about continuity");
        };
        let [from, to] = ends.map(|x| Real::Rational(x.clone()));
        self.check_value(Pencil::Parameter, [Some(&from), Some(&to)], work)?;
        let span = Span::closed(Some(from), Some(to), work)?;
        norm::check(self.scheme, continuity, level, ends, work)?;
        Ok(Fact::Contraction(Pencil::Parameter, span))
    }

    fn check_polytope(&self, polytope: &Polytope, work: &mut Work) -> Check<Fact> {
        let letters = self.letters(polytope.pencil)?;
        let inner = Real::Rational(polytope.inner.0.clone());
        let end = Real::new(&polytope.end, work)?;
        self.check_value(polytope.pencil, [Some(&inner), Some(&end)], work)?;
        let span = polytope::check(self.scheme, &letters, polytope, work)?;
        Ok(Fact::Contraction(polytope.pencil, span))
    }

    fn check_word(
        &self,
        pencil: Pencil,
        text: &str,
        ends: [&Option<End>; 2],
        work: &mut Work,
    ) -> Check<Fact> {
        let letters = self.letters(pencil)?;
        let letters_of_word = letters.word(text)?;
        let mut read = |end: &Option<End>| end.as_ref().map(|e| Real::new(e, work)).transpose();
        let (from, to) = (read(ends[0])?, read(ends[1])?);
        self.check_value(pencil, [from.as_ref(), to.as_ref()], work)?;
        let span = Span::closed(from, to, work)?;
        word::check(&letters, &letters_of_word, &span, work)?;
        Ok(Fact::Expansion(pencil, span))
    }

    fn check_indivisible(&self, order: usize, except: &[End], work: &mut Work) -> Check<Fact> {
        let except = reals(except, work)?;
        match self.divisibility(order, work)? {
            CommonZero::None => {}
            CommonZero::One(t) => {
                let t = Real::Rational(t);
                let mut listed = false;
                for x in &except {
                    listed |= x.compare(&t, work)?.is_eq();
                }
                ensure(listed, "a parameter value at which the power divides is missing")?;
            }
            CommonZero::Everywhere => return fail("the power of σ divides the symbol"),
        }
        Ok(Fact::Indivisible { order, except })
    }

    /// Where `σ^order` divides the symbol: where its remainder vanishes.
    fn divisibility(&self, order: usize, work: &mut Work) -> Check<CommonZero> {
        let scheme = self.scheme;
        let [p, q] = [&scheme.symbol.p, &scheme.symbol.q];
        // A power of higher degree leaves the symbol as it is, which is never zero.
        let Some(degree) = order.checked_mul(scheme.arity - 1).filter(|&n| n < p.len()) else {
            return Ok(CommonZero::None);
        };
        work.products(2 * p.len() * (degree + 1), largest_bits(p.iter().chain(q)) + 64, 64)?;
        let [p, q] = [p, q].map(|c| remainder(c.clone(), scheme.arity, order));
        Ok(common_zero(&p, &q))
    }
}

/// A vector that is zero if and only if `σ^order` divides, linear in the polynomial: the remainders
/// of the repeated division by `σ`, and what is left of the quotients.
fn remainder(mut p: Vec<Integer>, m: usize, order: usize) -> Vec<Integer> {
    let sigma = refinable_algebra::Polynomial::new(vec![integer(1); m]);
    let mut all = Vec::new();
    for _ in 0..order {
        let (quotient, rest) = refinable_algebra::Polynomial::new(p).divide_by_monic(&sigma);
        let mut rest = rest.coefficients().to_vec();
        rest.resize(m - 1, Integer::zero());
        all.extend(rest);
        p = quotient.coefficients().to_vec();
    }
    all
}

fn reals(ends: &[End], work: &mut Work) -> Check<Vec<Real>> {
    ends.iter().map(|end| Real::new(end, work)).collect()
}
