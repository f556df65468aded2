//! The conclusion from the lemmas.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use refinable_algebra::Rational;

use crate::conclusion;
use crate::error::{Invalid, Part};
use crate::family::{Scheme, check_curve};
use crate::lemma::{Fact, Setting, kind};
use crate::limits;
use crate::model::{Certificate, Conclusion, FORMAT, Lemma, VERSION};
use crate::real::integer_polynomial;
use crate::work::{Check, Reason, Work, ensure, fail};

/// A summary of what has been checked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verified {
    /// The number of lemmas of each kind, those inside other lemmas included.
    pub lemmas: BTreeMap<&'static str, usize>,
}

/// What a lemma of the certificate proves: about the family, or about one member of it.
pub(crate) struct Proved {
    /// The parameter value of the member and its order.
    pub value: Option<(Rational, Scheme)>,
    /// The facts.
    pub facts: Vec<Fact>,
}

/// Checks every lemma, and that the conclusion follows. The answer does not depend on the number of
/// threads.
///
/// # Errors
/// [`Invalid`]: the first thing that fails, first the family, then the lemmas in their order, then
/// the conclusion.
///
/// # Cost
/// Bounded: a few seconds for each lemma, and no lemma's effort depends on another.
pub fn verify(certificate: &Certificate) -> Result<Verified, Invalid> {
    let at = |part: Part| move |Reason(reason)| Invalid { part, reason };
    check_form(certificate).map_err(at(Part::Family))?;
    let scheme = Scheme::new(&certificate.family, &mut Work::new()).map_err(at(Part::Family))?;
    if let Some(curve) = &certificate.family.curve {
        let checked = check_curve(&certificate.family, curve, &mut Work::new());
        checked.map_err(at(Part::Curve))?;
    }
    let proved = check_lemmas(certificate, &scheme)?;
    let conclusion = conclusion::check(&scheme, &certificate.conclusion, &proved, &mut Work::new());
    conclusion.map_err(at(Part::Conclusion))?;
    Ok(Verified { lemmas: count(&certificate.lemmas) })
}

fn check_form(certificate: &Certificate) -> Result<(), Reason> {
    let known = certificate.format == FORMAT && certificate.version == VERSION;
    if !known {
        return Err(Reason("an unknown format or version".into()));
    }
    limits::check(certificate).map_err(|what| Reason(what.into()))
}

/// All lemmas side by side. Of those after a failed one some may be left out.
fn check_lemmas(certificate: &Certificate, scheme: &Scheme) -> Result<Vec<Proved>, Invalid> {
    let continuity = match certificate.conclusion {
        Conclusion::Continuity { continuity, .. } => Some(continuity),
        Conclusion::Regularity { .. } => None,
    };
    let setting = Setting { scheme, continuity, value: None };
    let first_failed = AtomicUsize::new(usize::MAX);
    let results = certificate.lemmas.par_iter().enumerate().map(|(index, lemma)| {
        if first_failed.load(Ordering::Relaxed) < index {
            return None;
        }
        let result = check_lemma(&setting, index, lemma);
        if result.is_err() {
            first_failed.fetch_min(index, Ordering::Relaxed);
        }
        Some(result)
    });
    // A lemma is left out only after a failed one, which stops this.
    results.collect::<Vec<_>>().into_iter().flatten().collect()
}

fn check_lemma(setting: &Setting, index: usize, lemma: &Lemma) -> Result<Proved, Invalid> {
    let outer = kind(lemma);
    let invalid = |inside: Option<(usize, &'static str)>| {
        move |Reason(reason)| {
            let part = Part::Lemma { index, kind: outer, inside };
            Invalid { part, reason }
        }
    };
    let all = |setting: &Setting, lemmas: &[Lemma]| -> Result<Vec<Fact>, Invalid> {
        let checked = lemmas.iter().enumerate().map(|(place, lemma)| {
            let fact = setting.check(lemma, &mut Work::new());
            fact.map_err(invalid(Some((place, kind(lemma)))))
        });
        checked.collect()
    };
    let about_family = |facts| Ok(Proved { value: None, facts });
    match lemma {
        Lemma::At { value, lemmas, .. } => {
            let member = member(setting, lemma).map_err(invalid(None))?;
            let inner = Setting { scheme: &member, value: Some(&value.0), ..*setting };
            let facts = all(&inner, lemmas)?;
            Ok(Proved { value: Some((value.0.clone(), member)), facts })
        }
        Lemma::Reduced { value, lemmas, .. } => {
            let member = member(setting, lemma).map_err(invalid(None))?;
            let inner = Setting { scheme: &member, value: Some(&value.0), ..*setting };
            let facts = all(&inner, lemmas)?;
            let fact = conclusion::transfer(&inner, &facts, &mut Work::new());
            about_family(vec![fact.map_err(invalid(None))?])
        }
        Lemma::Convergence { lemmas } => {
            ensure(setting.continuity.is_some(), "the conclusion is not about continuity")
                .map_err(invalid(None))?;
            let facts = all(&Setting { continuity: Some(0), ..*setting }, lemmas)?;
            about_family(conclusion::convergence(facts).map_err(invalid(None))?)
        }
        _ => about_family(vec![setting.check(lemma, &mut Work::new()).map_err(invalid(None))?]),
    }
}

/// What the lemmas inside an `at` or a `reduced` are about.
fn member(setting: &Setting, lemma: &Lemma) -> Check<Scheme> {
    let Some(continuity) = setting.continuity else {
        return fail("the conclusion is not about continuity");
    };
    let work = &mut Work::new();
    match lemma {
        Lemma::At { value, order, .. } => setting.scheme.at(&value.0, *order, work),
        Lemma::Reduced { value, factor, order, .. } => {
            ensure(continuity >= 1, "a `reduced` lemma about C^0")?;
            setting.scheme.reduced(&value.0, &integer_polynomial(factor), *order, work)
        }
        _ => fail("a lemma that is not about one member"),
    }
}

fn count(lemmas: &[Lemma]) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for lemma in lemmas {
        *counts.entry(kind(lemma)).or_insert(0) += 1;
        for (kind, n) in count(lemma.inside().unwrap_or_default()) {
            *counts.entry(kind).or_insert(0) += n;
        }
    }
    counts
}
