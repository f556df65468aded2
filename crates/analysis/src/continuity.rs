//! For which values of a parameter a scheme is C^n, and for which it is not.

use refinable_algebra::{Domain, GcdDomain, Integer, Parameter, Polynomial, Rational, bit_length};
use refinable_certificate::{Certificate, Conclusion, End, Family, Interval, Lemma, verify};
use refinable_reals::{Bound, RealAlgebraic, Region, real_roots};
use refinable_scheme::{Diagnostic, Normalised};
use refinable_spectral::{Options, real_algebraic};

use crate::line::Line;
use crate::proof::Proof;
use crate::rational_map::RationalMap;

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
        Sharpness { level: 6, spectral: Options::default() }
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
    pub certificate: Certificate,
}

impl ContinuityRange {
    /// A word whose product refutes C^n at a value of the line's own parameter; `None` if the reason is
    /// another, or the family runs along a curve.
    pub fn reason_at(&self, value: &Rational) -> Option<&str> {
        let here = RealAlgebraic::from(value.clone());
        let family = &self.certificate.family;
        let contains = |from: &Option<End>, to: &Option<End>| {
            from.as_ref().is_none_or(|end| real_algebraic(end) <= here)
                && to.as_ref().is_none_or(|end| here <= real_algebraic(end))
        };
        self.certificate.lemmas.iter().find_map(|lemma| match lemma {
            Lemma::Word { word, from, to, .. } if contains(from, to) && family.curve.is_none() => {
                Some(word.as_str())
            }
            _ => None,
        })
    }

    /// What is neither proved nor refuted, poles aside.
    pub fn undecided(&self) -> Region {
        let poles = self.points.iter().filter(|(_, v)| *v == PointVerdict::Pole);
        let poles = Region::points(poles.map(|(t, _)| t.clone()));
        self.proved.union(&self.refuted).union(&poles).complement()
    }

    /// Whether every end is exact: nothing is left undecided but, perhaps, isolated values.
    pub fn is_exact(&self) -> bool {
        self.undecided().intervals().iter().all(|interval| interval.as_point().is_some())
    }
}

/// The exact range of C^n over the one free parameter of a family, proved from both sides.
///
/// With `σ^k` the power that divides the symbol identically and `n < k`, the scheme is C^n iff the
/// joint spectral radius of the matrices of `c_{k-1}` is below `m^(k-1-n)`, where the shifts are
/// stable; for `n ≥ k` only values come into question at which a higher power divides.
///
/// # Errors
/// Code `parameters` if the masks of the family lie on no line, or `parameter` is not the only free one; `budget`
/// if they are so long, or of so high an arity, that no proof would be read; `certificate` if the proof found does not
/// hold.
///
/// # Cost
/// A linear program in floats for every image of every vertex of the polytopes that are tried; the checker's work for
/// those that close. The better ρ is bounded by words, the fewer vertices: milliseconds to seconds for masks of up to
/// 25 coefficients, and more where the radius stays within a few per cent of the bound all along.
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
    let line = line_of(name, mask)?;
    expect_parameter(&line, parameter)?;
    let mut proof = Proof::new(&line, line.order(), continuity, sharpness);
    proof.search();
    ContinuityRange::of(&line, parameter, continuity, proof.certificate())
}

/// The range that an earlier certificate of the same theorem proves; `None` if it is about something
/// else or does not hold.
pub fn certified_range(
    mask: &Normalised,
    parameter: &Parameter,
    continuity: usize,
    certificate: &Certificate,
) -> Option<ContinuityRange> {
    let line = Line::new(&certificate.family.name, mask)?;
    expect_parameter(&line, parameter).ok()?;
    let same = certificate.family == line.family(line.order());
    let range = || ContinuityRange::of(&line, parameter, continuity, certificate.clone()).ok();
    if same { range() } else { None }
}

/// The largest `n` for which a mask of this support can be C^n, whatever its coefficients and whether its
/// shifts are stable or not: `N - 2` for `N + 1` coefficients of a binary scheme that converges.
///
/// For `j ≤ n` the values of `φ^(j)` at the `N - 1` integers inside the support are an eigenvector of
/// `(a_{2i-k})` for the eigenvalue `2^-j`: they are not all zero, or `φ^(j)` would vanish at every
/// dyadic number. `None` for another arity, or if no scheme of this support converges.
///
/// # Source
/// I. Daubechies and J. C. Lagarias, *Two-scale difference equations I*, SIAM J. Math. Anal. 22, 1991.
pub fn highest_continuity(mask: &Normalised) -> Option<usize> {
    let (lowest, highest) = mask.support();
    let width = usize::try_from(highest - lowest).ok()?;
    width.checked_sub(2).filter(|_| mask.arity() == 2)
}

fn line_of(name: &str, mask: &Normalised) -> Result<Line, Diagnostic> {
    let line = Line::new(name, mask).ok_or_else(|| {
        Diagnostic::new("parameters", "the masks of the family lie on no line")
            .with_hint("norms apply to every family: refinable range SCHEME -n N --level L")
    })?;
    line.expect_readable_proofs()?;
    Ok(line)
}

fn expect_parameter(line: &Line, parameter: &Parameter) -> Result<(), Diagnostic> {
    if line.parameter() == Some(parameter) {
        return Ok(());
    }
    let error =
        Diagnostic::new("parameters", format!("{parameter} is not the only free parameter"));
    Err(match line.parameter() {
        Some(free) => error.with_hint(format!("{free} is")),
        None => error.with_hint("none is free: a single scheme has no range"),
    })
}

impl ContinuityRange {
    /// What a certificate about the line proves, in the parameter of the family.
    fn of(
        line: &Line,
        parameter: &Parameter,
        continuity: usize,
        certificate: Certificate,
    ) -> Result<Self, Diagnostic> {
        check(&certificate)?;
        let Conclusion::Continuity { continuity: n, proved, refuted } = &certificate.conclusion
        else {
            return Err(Diagnostic::new("certificate", "it is not about continuity"));
        };
        if *n != continuity {
            return Err(Diagnostic::new("certificate", format!("it is about C^{n}")));
        }
        let region = |intervals: &[Interval]| line.pull_back(&region_of(intervals));
        let (proved, refuted) = (region(proved), region(refuted));
        let mut points: Vec<(RealAlgebraic, PointVerdict)> =
            line.poles().into_iter().map(|t| (t, PointVerdict::Pole)).collect();
        let isolated = |region: &Region| -> Vec<RealAlgebraic> {
            let intervals = region.intervals();
            intervals.iter().filter_map(|i| i.as_point().cloned()).collect()
        };
        points.extend(isolated(&proved).into_iter().map(|t| (t, PointVerdict::Proved)));
        points.extend(isolated(&refuted).into_iter().map(|t| (t, PointVerdict::Refuted)));
        let unstable = line.pull_back(&Region::points(exceptions(&certificate)));
        let open = proved.union(&refuted).complement();
        let poles = Region::points(line.poles());
        for t in isolated(&open.difference(&poles)) {
            let verdict = if unstable.contains(&t) {
                PointVerdict::Unstable
            } else {
                PointVerdict::Undecided
            };
            points.push((t, verdict));
        }
        points.sort_by(|a, b| a.0.cmp(&b.0));
        let parameter = parameter.clone();
        Ok(ContinuityRange { continuity, parameter, proved, refuted, points, certificate })
    }
}

fn check(certificate: &Certificate) -> Result<(), Diagnostic> {
    verify(certificate).map(drop).map_err(|invalid| {
        let message = format!("the certificate does not hold: {invalid}");
        Diagnostic::new("certificate", message)
    })
}

/// The values that the certificate excepts from stability.
fn exceptions(certificate: &Certificate) -> Vec<RealAlgebraic> {
    let lists = certificate.lemmas.iter().filter_map(|lemma| match lemma {
        Lemma::Stable { except } => Some(except),
        _ => None,
    });
    lists.flatten().map(real_algebraic).collect()
}

/// The union of the intervals of a certificate that has been checked.
pub fn region_of(intervals: &[Interval]) -> Region {
    let bound = |end: &Option<End>, closed: bool| match end {
        None => Bound::Infinite,
        Some(end) if closed => Bound::Closed(real_algebraic(end)),
        Some(end) => Bound::Open(real_algebraic(end)),
    };
    Region::union_of(intervals.iter().map(|interval| {
        let lower = bound(&interval.from, interval.ends.starts_with('['));
        Region::interval(lower, bound(&interval.to, interval.ends.ends_with(']')))
    }))
}

/// The values of the parameter by which a family runs along a line of masks, for intervals of a certificate that has
/// been checked, poles left out. `None` if it does not run along one, if it stays at one place, or if the numbers are too
/// large: more than ten ends, a degree above 24 of their images, or coefficients of more than 400 bits.
///
/// # Cost
/// A root isolation for each end.
pub fn along_curve(family: &Family, intervals: &[Interval]) -> Option<Region> {
    let curve = family.curve.as_ref()?;
    let [(p_scale, p), (q_scale, q), (_, poles)] =
        [&curve.line.numerator, &curve.line.denominator, &curve.denominator]
            .map(|c| Polynomial::new(c.iter().map(|c| c.0.clone()).collect()).cleared());
    let region = region_of(intervals);
    let ends: Vec<Polynomial<Integer>> =
        region.ends().iter().map(RealAlgebraic::polynomial).collect();
    let degree_of = |p: &Polynomial<Integer>| p.degree().unwrap_or(0);
    let is_short = |p: &Polynomial<Integer>| p.coefficients().iter().all(|c| bit_length(c) <= 400);
    let highest = ends.iter().map(degree_of).max().unwrap_or(1).max(1);
    let readable = ends.len() <= 10
        && degree_of(&p).max(degree_of(&q)) * highest <= 24
        && degree_of(&poles) <= 24
        && [&p, &q, &poles].into_iter().chain(&ends).all(is_short);
    if !readable {
        return None;
    }
    let common = p.gcd(&q);
    let reduced = |p: &Polynomial<Integer>, scale: &Integer| {
        Domain::quotient(p, &common).scaled(scale).map(|c| Rational::from(c.clone()))
    };
    let (p, q) = (reduced(&p, &q_scale), reduced(&q, &p_scale));
    if p.is_constant() && q.is_constant() {
        return None;
    }
    let region = RationalMap::new(&p, &q).preimage(&region);
    Some(region.difference(&Region::points(real_roots(&poles))))
}

/// C^n of a scheme without free parameters, with its certificate.
///
/// # Errors
/// Code `parameters` if a parameter is free; `budget` if the mask is so long, or of so high an arity, that no proof
/// would be read; `certificate` if the proof found does not hold.
///
/// # Cost
/// As for [`continuity_range`], at one value.
pub fn continuity_at(
    name: &str,
    mask: &Normalised,
    continuity: usize,
    sharpness: &Sharpness,
) -> Result<(PointVerdict, Certificate), Diagnostic> {
    let line = line_of(name, mask)?;
    if let Some(parameter) = line.parameter() {
        let hint = format!("set it: --set {parameter}=VALUE");
        return Err(Diagnostic::new("parameters", format!("{parameter} is free")).with_hint(hint));
    }
    let mut proof = Proof::new(&line, line.order(), continuity, sharpness);
    proof.search();
    let certificate = proof.certificate();
    check(&certificate)?;
    Ok((verdict_of(&certificate), certificate))
}

/// The verdict that an earlier certificate of the same theorem proves.
pub fn certified_verdict(
    mask: &Normalised,
    continuity: usize,
    certificate: &Certificate,
) -> Option<PointVerdict> {
    let line = Line::new(&certificate.family.name, mask)?;
    let about = matches!(&certificate.conclusion,
        Conclusion::Continuity { continuity: n, .. } if *n == continuity);
    let same = about && certificate.family == line.family(line.order());
    (same && verify(certificate).is_ok()).then(|| verdict_of(certificate))
}

fn verdict_of(certificate: &Certificate) -> PointVerdict {
    match &certificate.conclusion {
        Conclusion::Continuity { proved, .. } if !proved.is_empty() => PointVerdict::Proved,
        Conclusion::Continuity { refuted, .. } if !refuted.is_empty() => PointVerdict::Refuted,
        _ => PointVerdict::Undecided,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::Ring;
    use refinable_scheme::Scheme;

    fn scheme(text: &str, arity: usize) -> Scheme {
        Scheme::resolve(text, arity).expect("a scheme")
    }

    #[test]
    fn the_parameter_must_be_the_free_one() {
        let [w, other] = ["w", "alpha"].map(Parameter::new);
        let range = |text: &str, parameter: &Parameter| {
            let scheme = scheme(text, 2);
            continuity_range(text, scheme.mask(), parameter, 0, &Sharpness::default())
        };
        let found = range("fourpoint(w)", &w).expect("a range");
        assert_eq!(found.parameter, w);
        for (text, parameter) in
            [("fourpoint(w)", &other), ("dd4", &w), ("fourpoint(w*w)", &other), ("a3", &w)]
        {
            let error = range(text, parameter).expect_err(text);
            assert_eq!(error.code(), "parameters", "{text}");
        }
        let family = scheme("fourpoint(w)", 2);
        let earlier = |p: &Parameter| certified_range(family.mask(), p, 0, &found.certificate);
        assert!(earlier(&w).is_some() && earlier(&other).is_none());
    }

    /// Far from zero floats do not tell the ends of the range apart: nothing is proved between them, and the
    /// words prove what they prove elsewhere.
    #[test]
    fn ranges_far_from_zero_end() {
        let text = "fourpoint(w-10^20)";
        let (family, w) = (scheme(text, 2), Parameter::new("w"));
        let found = continuity_range(text, family.mask(), &w, 1, &Sharpness::default());
        let found = found.expect("a range");
        // C^1 at 1/16, and not at -1 and 1.
        let moved = |p: i64, q: i64| {
            let far = Rational::from_i64(10).power(20);
            far + Rational::new(p.into(), q.into())
        };
        assert!(!found.refuted.contains_rational(&moved(1, 16)));
        for n in [-1, 1] {
            assert!(found.refuted.contains_rational(&moved(n, 1)), "{n}");
            assert!(!found.proved.contains_rational(&moved(n, 1)), "{n}");
        }
    }

    /// The limit functions of `1/m (1 + z + ... + z^(m-1))^2` are splines of degree one, for each arity. The words of
    /// a proof have digits for ten letters; above, none is sought, and norms do without.
    #[test]
    fn proofs_for_large_arities() {
        let linear = |m: usize| scheme(&format!("1/{m}*((1-z^{m})/(1-z))^2"), m);
        let verdict = |m: usize, n: usize| {
            continuity_at("linear", linear(m).mask(), n, &Sharpness::default()).map(|v| v.0)
        };
        assert_eq!(verdict(10, 0).expect("readable"), PointVerdict::Proved);
        for m in [11, 64, 100] {
            let scheme = linear(m);
            let errors = [
                verdict(m, 0).expect_err("not readable"),
                crate::regularity("linear", scheme.mask(), &Options::default())
                    .expect_err("not readable"),
            ];
            for error in errors {
                assert_eq!(error.code(), "budget", "{m}");
                assert!(error.message().contains(&format!("words over {m} letters")), "{error}");
            }
            let norms = crate::norm_values(scheme.mask(), 0, 1, crate::Budget::default());
            let norms = norms.expect("small enough").expect("it is divisible");
            assert_eq!(norms, [Rational::new(1.into(), m.into())]);
        }
        // 1 at z = 1, so that the factor leaves a scheme a scheme.
        let plane = scheme("1/11*((1-z^11)/(1-z))^2*(1+(u+v*z)*(1-z))", 11);
        let error = crate::default_window("plane", plane.mask(), 0).expect_err("not readable");
        assert_eq!(error.code(), "budget");
    }
}
