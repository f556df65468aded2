//! For which values of a parameter a scheme is C^n, and for which it is not.

use refinable_algebra::{GcdDomain, Integer, Parameter, Polynomial, Rational, Ring};
use refinable_certificate::{
    Certificate, Conclusion, FORMAT, Interval, Lemma, Number, Pencil, Polytope, VERSION, verify,
};
use refinable_reals::{Bound, RealAlgebraic, Region, real_roots};
use refinable_scheme::{Diagnostic, Normalised};
use refinable_spectral::{Constant, Division, Options, certificate_end, decide, divide};

use crate::contractivity::{Work, level_sets};
use crate::line::Line;
use crate::stability::{Instability, instability};

/// How sharp a range is to be.
#[derive(Clone, Debug)]
pub struct Sharpness {
    /// The highest level of norms that fill the middle of a range.
    pub level: u32,
    /// How words and polytopes are searched for.
    pub spectral: Options,
}

impl Default for Sharpness {
    fn default() -> Self {
        Sharpness { level: 3, spectral: Options::default() }
    }
}

/// The verdict at a value that needs a treatment of its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PointVerdict {
    /// The scheme is C^n there.
    Proved,
    /// It is not.
    Refuted,
    /// The difference scheme is not contractive, but the shifts are not stable either.
    Unstable,
    /// Nothing was shown.
    Undecided,
    /// There is no scheme.
    Pole,
}

/// The line of a parameter, divided into where C^n is proved, refuted and undecided.
#[derive(Clone, Debug)]
pub struct ContinuityRange {
    /// The order `n`.
    pub continuity: usize,
    /// The free parameter.
    pub parameter: Parameter,
    /// Where the scheme is C^n.
    pub proved: Region,
    /// Where it is not.
    pub refuted: Region,
    /// Values apart from the intervals around them, ascending.
    pub points: Vec<(RealAlgebraic, PointVerdict)>,
    /// The proof, checked.
    pub certificate: Option<Certificate>,
}

impl ContinuityRange {
    /// What is neither proved nor refuted, poles aside.
    pub fn undecided(&self) -> Region {
        let poles = self.points.iter().filter(|(_, v)| *v == PointVerdict::Pole);
        let poles = Region::points(poles.map(|(t, _)| t.clone()));
        self.proved.union(&self.refuted).union(&poles).complement()
    }

    /// Whether nothing is left undecided.
    pub fn is_exact(&self) -> bool {
        self.undecided().is_empty()
    }
}

/// The exact range of C^n over the one free parameter of a family, proved from both sides.
///
/// With `σ^k` the power that divides the symbol identically and `n < k`, the scheme is C^n iff the
/// joint spectral radius of the matrices of `c_{k-1}` is below `m^(k-1-n)`, where the shifts are
/// stable; for `n ≥ k` only values come into question at which a higher power divides.
///
/// # Errors
/// Code `parameters` if the family does not run along a line of masks in one parameter.
///
/// # Source
/// Dyn 1992; Jia and Wang 1993; see `docs/certificates.md` for the steps of the proof.
pub fn continuity_range(
    name: &str,
    mask: &Normalised,
    parameter: &Parameter,
    continuity: usize,
    sharpness: &Sharpness,
) -> Result<ContinuityRange, Diagnostic> {
    let line = Line::new(name, mask).ok_or_else(|| {
        Diagnostic::new("parameters", "the family does not run along a line of masks")
            .with_hint("norms up to a level apply to every family: --level L")
    })?;
    let order = line.order();
    let mut proof = Proof::new(&line, order, continuity, sharpness);
    if order > continuity {
        proof.divide();
    } else if order > 0 {
        proof.special_values();
    }
    let certificate = proof.certificate();
    if let Err(invalid) = verify(&certificate) {
        let message = format!("the certificate found does not hold: {invalid}");
        return Err(Diagnostic::new("certificate", message));
    }
    let poles = match line.substitution() {
        Some((_, denominator)) if !denominator.is_constant() => roots(&denominator.cleared().1),
        _ => Vec::new(),
    };
    let pull_back = |x: &RealAlgebraic| line.pull_back(&Region::point(x.clone())).ends();
    let mut points: Vec<(RealAlgebraic, PointVerdict)> =
        poles.into_iter().map(|t| (t, PointVerdict::Pole)).collect();
    for (x, verdict) in &proof.points {
        points.extend(pull_back(x).into_iter().map(|t| (t, *verdict)));
    }
    points.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(ContinuityRange {
        continuity,
        parameter: parameter.clone(),
        proved: line.pull_back(&proof.proved),
        refuted: line.pull_back(&proof.refuted),
        points,
        certificate: Some(certificate),
    })
}

/// A proof in the making, in the variable `x` of the line.
struct Proof<'a> {
    line: &'a Line,
    order: usize,
    continuity: usize,
    sharpness: &'a Sharpness,
    proved: Region,
    refuted: Region,
    points: Vec<(RealAlgebraic, PointVerdict)>,
    lemmas: Vec<Lemma>,
}

impl<'a> Proof<'a> {
    fn new(line: &'a Line, order: usize, continuity: usize, sharpness: &'a Sharpness) -> Self {
        Proof {
            line,
            order,
            continuity,
            sharpness,
            proved: Region::empty(),
            refuted: Region::empty(),
            points: Vec::new(),
            lemmas: Vec::new(),
        }
    }

    /// `n < k`: the line divided at the joint spectral radius `m^(k-1-n)`.
    fn divide(&mut self) {
        let bound = bound(self.line, self.order, self.continuity);
        let pencil = self.line.pencil(self.order, &bound);
        if pencil.is_constant() {
            return self.whole_line();
        }
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

    /// A family whose mask does not depend on the parameter is C^n everywhere or nowhere.
    fn whole_line(&mut self) {
        let zero = Rational::zero();
        let (verdict, _) = self.at(&zero);
        match verdict {
            PointVerdict::Proved => self.proved = Region::point(zero.into()),
            PointVerdict::Refuted => self.refuted = Region::point(zero.into()),
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
            let part = Region::interval(part.lower, part.upper);
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
    /// spectral radius elsewhere.
    fn restrict_to_stable(&mut self) {
        if self.continuity == 0 || self.refuted.is_empty() {
            return;
        }
        let Instability::At(exceptions) = instability(self.line) else {
            self.refuted = Region::empty();
            return;
        };
        for x in &exceptions {
            if self.refuted.contains(x) {
                self.points.push((x.clone(), PointVerdict::Unstable));
            }
        }
        self.refuted = self.refuted.difference(&Region::points(exceptions.iter().cloned()));
        self.lemmas.push(Lemma::Stable { except: exceptions.iter().map(certificate_end).collect() });
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
            match verdict {
                PointVerdict::Proved => self.proved = self.proved.union(&Region::point(x.clone())),
                PointVerdict::Refuted => self.refuted = self.refuted.union(&Region::point(x.clone())),
                _ => {}
            }
            self.points.retain(|(point, _)| point != x);
            self.points.push((x.clone(), verdict));
            self.lemmas.extend(lemmas);
        }
    }

    /// C^n at one value, where `σ^(n+1)` divides, with a lemma that says so.
    fn at(&self, x: &Rational) -> (PointVerdict, Vec<Lemma>) {
        let member = self.line.at(x);
        let order = member.order();
        if order <= self.continuity {
            return (PointVerdict::Undecided, Vec::new());
        }
        let pencil = member.pencil(order, &bound(&member, order, self.continuity));
        // Inside an `at` lemma everything happens at the value itself.
        let accept = |polytope: &Polytope| {
            let inner = vec![Lemma::Polytope(Box::new(polytope.clone()))];
            self.holds(vec![Lemma::At { value: Number(x.clone()), order, lemmas: inner }])
        };
        let lemma = |lemmas| vec![Lemma::At { value: Number(x.clone()), order, lemmas }];
        match decide(&pencil, x, &self.sharpness.spectral, &accept) {
            Constant::Contracting(polytope) => {
                (PointVerdict::Proved, lemma(vec![Lemma::Polytope(polytope)]))
            }
            Constant::Expanding(word) => {
                let end = Some(certificate_end(&x.clone().into()));
                let word = Lemma::Word {
                    pencil: Pencil::Parameter,
                    word: word.to_string(),
                    from: end.clone(),
                    to: end,
                };
                let stable = matches!(instability(&member), Instability::At(_));
                match (self.continuity, stable) {
                    (0, _) => (PointVerdict::Refuted, lemma(vec![word])),
                    (_, true) => {
                        let stable = Lemma::Stable { except: Vec::new() };
                        (PointVerdict::Refuted, lemma(vec![word, stable]))
                    }
                    (_, false) => (PointVerdict::Unstable, lemma(vec![word])),
                }
            }
            Constant::Undecided => (PointVerdict::Undecided, Vec::new()),
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

    fn certificate(&self) -> Certificate {
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

/// `m^(k-1-n)`.
fn bound(line: &Line, order: usize, continuity: usize) -> Rational {
    Rational::from_i64(line.arity() as i64).power((order - 1 - continuity) as u32)
}

/// Short rational ends inside an open interval, a twentieth of its length from its own.
fn shrunk(a: &RealAlgebraic, b: &RealAlgebraic) -> (Rational, Rational) {
    let width = Rational::new(1.into(), Integer::from(1) << 60usize);
    let (a, b) = (a.enclosure(&width).1, b.enclosure(&width).0);
    let length = &b - &a;
    let tenth = &length / Rational::from_i64(10);
    let near = |from: Rational, to: Rational| {
        RealAlgebraic::from(from).rational_between(&RealAlgebraic::from(to))
    };
    let lower = near(&a + &tenth / Rational::from_i64(2), &a + &tenth);
    let upper = near(&b - &tenth, &b - &tenth / Rational::from_i64(2));
    (lower, upper)
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

fn common_roots(polynomials: &[Polynomial<Integer>]) -> Vec<RealAlgebraic> {
    let common = polynomials.iter().fold(Polynomial::zero(), |g, p| g.gcd(p));
    if common.is_zero() { Vec::new() } else { roots(&common) }
}

fn roots(p: &Polynomial<Integer>) -> Vec<RealAlgebraic> {
    real_roots(p).iter().map(RealAlgebraic::simplified).collect()
}
