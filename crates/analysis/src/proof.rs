//! The search for a proof: where C^n holds and where it fails on a line of masks.

use refinable_algebra::{Integer, Rational, Ring};
use refinable_certificate::{
    Certificate, Conclusion, End, FORMAT, Interval, Lemma, Number, Pencil, Polytope, VERSION,
    verify,
};
use refinable_reals::{Bound, RealAlgebraic, Region, common_roots};
use refinable_spectral::{Constant, Division, certificate_end, decide, divide, expanding};

use crate::continuity::{PointVerdict, Sharpness, region_of};
use crate::contractivity::{Work, level_sets};
use crate::line::{Line, radius_bound};
use crate::stability::{Instability, instability, reduction};

/// A proof in the making, in the variable `x` of the line.
pub(crate) struct Proof<'a> {
    line: &'a Line,
    order: usize,
    continuity: usize,
    sharpness: &'a Sharpness,
    proved: Region,
    refuted: Region,
    lemmas: Vec<Lemma>,
}

impl<'a> Proof<'a> {
    pub fn new(line: &'a Line, order: usize, continuity: usize, sharpness: &'a Sharpness) -> Self {
        Proof {
            line,
            order,
            continuity,
            sharpness,
            proved: Region::empty(),
            refuted: Region::empty(),
            lemmas: Vec::new(),
        }
    }

    /// Whichever way applies.
    pub fn search(&mut self) {
        let constant = self.line.parts().1.is_zero();
        if self.order > self.continuity && !constant {
            self.divide();
        } else if self.order > self.continuity {
            self.only_member();
        } else if self.order > 0 {
            self.special_values();
        }
    }

    /// `n < k`: the line divided at the joint spectral radius `m^(k-1-n)`.
    fn divide(&mut self) {
        let bound = radius_bound(self.line.arity(), self.order, self.continuity);
        let pencil = self.line.pencil(self.order, &bound);
        let norms = self.norm_intervals();
        let known: Vec<(Rational, Rational)> =
            norms.iter().map(|(_, a, b)| (a.clone(), b.clone())).collect();
        let accept = |polytope: &Polytope| self.accepts(self.line, self.order, polytope);
        let Division { contracting, expanding, lemmas } =
            divide(&pencil, &known, &self.sharpness.spectral, &accept);
        self.lemmas.extend(norms.into_iter().map(|(level, from, to)| Lemma::Norm {
            level,
            from: Number(from),
            to: Number(to),
        }));
        self.lemmas.extend(lemmas);
        self.proved = contracting;
        self.refuted = expanding;
        self.restrict_to_stable();
    }

    /// A scheme without a parameter, placed at zero.
    fn only_member(&mut self) {
        let zero = Rational::zero();
        let (verdict, lemmas) = self.at(&zero);
        self.record(&zero.into(), verdict);
        self.lemmas.extend(lemmas);
    }

    fn record(&mut self, x: &RealAlgebraic, verdict: PointVerdict) {
        let point = Region::point(x.clone());
        match verdict {
            PointVerdict::Proved => self.proved = self.proved.union(&point),
            PointVerdict::Refuted => self.refuted = self.refuted.union(&point),
            _ => {}
        }
    }

    /// In each part of the set that norms prove, the longest interval that one level proves, a little
    /// shortened.
    fn norm_intervals(&self) -> Vec<(u32, Rational, Rational)> {
        let symbol = self.line.difference_symbol(self.continuity);
        let levels = level_sets(&symbol, None, self.sharpness.level, &mut Work::default());
        let parts = Region::union_of(levels.iter().cloned()).intervals();
        let longest = parts.into_iter().filter_map(|part| {
            let part = Region::from(&part);
            let candidates = (1..).zip(&levels).flat_map(|(level, region)| {
                let inside = region.intersection(&part).intervals().into_iter();
                inside.filter_map(move |interval| {
                    let (a, b) = (interval.lower.number()?, interval.upper.number()?);
                    let (a, b) = shrunk(a, b);
                    Some((level, a, b))
                })
            });
            candidates.max_by(|x, y| (&x.2 - &x.1).cmp(&(&y.2 - &y.1)))
        });
        longest.collect()
    }

    /// Refutes only where the shifts are stable: C^n with `n ≥ 1` does not follow the joint
    /// spectral radius elsewhere. There a reduced mask may decide, or that the scheme diverges.
    fn restrict_to_stable(&mut self) {
        if self.continuity == 0 || self.refuted.is_empty() {
            return;
        }
        let Instability::At(exceptions) = instability(self.line) else {
            let doubtful = std::mem::replace(&mut self.refuted, Region::empty());
            let zero = Rational::zero();
            // A single scheme is placed at zero.
            let only = self.line.parts().1.is_zero().then(|| self.reduced(&zero)).flatten();
            let Some((verdict, lemmas)) = only else { return self.refute_divergent(&doubtful) };
            self.lemmas.extend(lemmas);
            self.record(&zero.into(), verdict);
            return;
        };
        let exceptional = Region::points(exceptions.iter().cloned());
        let mut doubtful = self.refuted.intersection(&exceptional);
        self.refuted = self.refuted.difference(&exceptional);
        self.lemmas
            .push(Lemma::Stable { except: exceptions.iter().map(certificate_end).collect() });
        for x in doubtful.ends() {
            let Some((verdict, lemmas)) = x.as_rational().and_then(|x| self.exception(x)) else {
                continue;
            };
            self.lemmas.extend(lemmas);
            self.record(&x, verdict);
            doubtful = doubtful.difference(&Region::point(x));
        }
        self.refute_divergent(&doubtful);
    }

    /// Refutes where a scheme diverges, for which no stability is needed.
    fn refute_divergent(&mut self, doubtful: &Region) {
        if doubtful.is_empty() || self.order == 0 {
            return;
        }
        let pencil = self.line.pencil(self.order, &radius_bound(self.line.arity(), self.order, 0));
        let (divergent, mut lemmas) = expanding(&pencil, &self.sharpness.spectral);
        let refuted = doubtful.intersection(&divergent);
        if refuted.is_empty() {
            return;
        }
        lemmas.retain(|lemma| !expanded_by(lemma).intersection(&refuted).is_empty());
        self.lemmas.push(Lemma::Convergence { lemmas });
        self.refuted = self.refuted.union(&refuted);
    }

    /// `n ≥ k`: only where `σ^(n+1)` divides can the scheme be C^n.
    fn special_values(&mut self) {
        let conditions = self.line.divisibility(self.continuity + 1);
        let values = common_roots(&conditions);
        self.refuted = Region::line().difference(&Region::points(values.iter().cloned()));
        self.lemmas.push(Lemma::Indivisible {
            order: self.continuity + 1,
            except: values.iter().map(certificate_end).collect(),
        });
        self.restrict_to_stable();
        for x in &values {
            let (verdict, lemmas) = match x.as_rational() {
                Some(rational) => self.at(rational),
                None => (PointVerdict::Undecided, Vec::new()),
            };
            self.record(x, verdict);
            self.lemmas.extend(lemmas);
        }
    }

    /// C^n at one value, where `σ^(n+1)` divides, with a lemma that says so.
    fn at(&self, x: &Rational) -> (PointVerdict, Vec<Lemma>) {
        let member = self.line.at(x);
        let order = member.order();
        let is_sharp = || matches!(instability(&member), Instability::At(_));
        let sharp = Lemma::Stable { except: Vec::new() };
        let lemma = |lemmas| vec![Lemma::At { value: Number(x.clone()), order, lemmas }];
        if order <= self.continuity {
            let indivisible = Lemma::Indivisible { order: self.continuity + 1, except: Vec::new() };
            return match order > 0 && is_sharp() {
                true => (PointVerdict::Refuted, lemma(vec![indivisible, sharp])),
                false => (PointVerdict::Undecided, Vec::new()),
            };
        }
        let pencil = member.pencil(order, &radius_bound(member.arity(), order, self.continuity));
        // Inside an `at` lemma everything happens at the value itself.
        let accept = |polytope: &Polytope| {
            let inner = vec![Lemma::Polytope(Box::new(polytope.clone()))];
            self.holds(vec![Lemma::At { value: Number(x.clone()), order, lemmas: inner }])
        };
        match decide(&pencil, x, &self.sharpness.spectral, &accept) {
            Constant::Contracting(polytope) => {
                (PointVerdict::Proved, lemma(vec![Lemma::Polytope(polytope)]))
            }
            Constant::Expanding(word) => {
                let word = word_at(x, &word.to_string());
                match (self.continuity, is_sharp()) {
                    (0, _) => (PointVerdict::Refuted, lemma(vec![word])),
                    (_, true) => (PointVerdict::Refuted, lemma(vec![word, sharp])),
                    (_, false) => {
                        let unstable = || (PointVerdict::Unstable, lemma(vec![word]));
                        self.reduced(x).unwrap_or_else(unstable)
                    }
                }
            }
            Constant::Undecided => (PointVerdict::Undecided, Vec::new()),
        }
    }

    /// Decides C^n at a value at which the family is an exception: its member may be none, as where the order rises.
    fn exception(&self, x: &Rational) -> Option<(PointVerdict, Vec<Lemma>)> {
        if self.line.arity() == 2 {
            return self.reduced(x);
        }
        let found = self.at(x);
        matches!(found.0, PointVerdict::Proved | PointVerdict::Refuted).then_some(found)
    }

    /// Decides C^n at a value at which stability fails, by the mask `a q(z) / q(z²)` that has a limit
    /// function of the same smoothness.
    fn reduced(&self, x: &Rational) -> Option<(PointVerdict, Vec<Lemma>)> {
        let member = self.line.at(x);
        let (factor, reduced) = reduction(&member)?;
        let order = reduced.order();
        let of_reduced = |lemmas| Lemma::Reduced {
            value: Number(x.clone()),
            factor: factor.coefficients().iter().cloned().map(Number).collect(),
            order,
            lemmas,
        };
        let refuted = |reason| {
            let lemmas = vec![of_reduced(vec![reason, Lemma::Stable { except: Vec::new() }])];
            self.holds(lemmas.clone()).then_some((PointVerdict::Refuted, lemmas))
        };
        if order <= self.continuity {
            return refuted(Lemma::Indivisible { order: self.continuity + 1, except: Vec::new() });
        }
        let pencil = reduced.pencil(order, &radius_bound(reduced.arity(), order, self.continuity));
        let accept = |polytope: &Polytope| {
            self.holds(vec![of_reduced(vec![Lemma::Polytope(Box::new(polytope.clone()))])])
        };
        match decide(&pencil, x, &self.sharpness.spectral, &accept) {
            Constant::Expanding(word) => refuted(word_at(x, &word.to_string())),
            Constant::Contracting(polytope) => {
                let lemmas = vec![of_reduced(vec![Lemma::Polytope(polytope)]), self.convergent(x)?];
                Some((PointVerdict::Proved, lemmas))
            }
            Constant::Undecided => None,
        }
    }

    /// The scheme converges at a value.
    fn convergent(&self, x: &Rational) -> Option<Lemma> {
        let pencil = self.line.pencil(self.order, &radius_bound(self.line.arity(), self.order, 0));
        let of_family = |polytope| Lemma::Convergence { lemmas: vec![Lemma::Polytope(polytope)] };
        let accept = |polytope: &Polytope| self.holds(vec![of_family(Box::new(polytope.clone()))]);
        match decide(&pencil, x, &self.sharpness.spectral, &accept) {
            Constant::Contracting(polytope) => Some(of_family(polytope)),
            _ => None,
        }
    }

    fn accepts(&self, line: &Line, order: usize, polytope: &Polytope) -> bool {
        let lemma = Lemma::Polytope(Box::new(polytope.clone()));
        verify(&self.certificate_of(line, order, vec![lemma], Vec::new(), Vec::new())).is_ok()
    }

    fn holds(&self, lemmas: Vec<Lemma>) -> bool {
        let certificate =
            self.certificate_of(self.line, self.order, lemmas, Vec::new(), Vec::new());
        verify(&certificate).is_ok()
    }

    pub fn certificate(&self) -> Certificate {
        let (proved, refuted) = (intervals(&self.proved), intervals(&self.refuted));
        self.certificate_of(self.line, self.order, self.lemmas.clone(), proved, refuted)
    }

    fn certificate_of(
        &self,
        line: &Line,
        order: usize,
        lemmas: Vec<Lemma>,
        proved: Vec<Interval>,
        refuted: Vec<Interval>,
    ) -> Certificate {
        Certificate {
            format: FORMAT.into(),
            version: VERSION,
            family: line.family(order),
            conclusion: Conclusion::Continuity { continuity: self.continuity, proved, refuted },
            lemmas,
        }
    }
}

/// The word's product has spectral radius at least one at a single value.
fn word_at(x: &Rational, word: &str) -> Lemma {
    let end = Some(End::Rational(Number(x.clone())));
    Lemma::Word { pencil: Pencil::Parameter, word: word.into(), from: end.clone(), to: end }
}

/// The closed interval on which a word lemma proves expansion.
fn expanded_by(lemma: &Lemma) -> Region {
    let Lemma::Word { from, to, .. } = lemma else { return Region::empty() };
    region_of(&[Interval { from: from.clone(), to: to.clone(), ends: "[]".into() }])
}

/// Short rational ends inside an open interval, at most a five-hundredth of its length from its own.
fn shrunk(a: &RealAlgebraic, b: &RealAlgebraic) -> (Rational, Rational) {
    let width = Rational::new(1.into(), Integer::from(1) << 60usize);
    let (a, b) = (a.enclosure(&width).1, b.enclosure(&width).0);
    let step = (&b - &a) / Rational::from_i64(1000);
    let near = |from: Rational, to: Rational| {
        RealAlgebraic::from(from).rational_between(&RealAlgebraic::from(to))
    };
    let two = Rational::from_i64(2);
    (near(&a + &step, &a + &step * &two), near(&b - &step * &two, &b - &step))
}

fn intervals(region: &Region) -> Vec<Interval> {
    let end = |bound: &Bound| bound.number().map(certificate_end);
    region
        .intervals()
        .iter()
        .map(|interval| Interval {
            from: end(&interval.lower),
            to: end(&interval.upper),
            ends: format!(
                "{}{}",
                if interval.lower.is_closed() { '[' } else { '(' },
                if interval.upper.is_closed() { ']' } else { ')' },
            ),
        })
        .collect()
}
