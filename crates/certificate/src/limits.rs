//! What is too large to be looked at.

use refinable_algebra::{Ring, bit_length};

use crate::family::dimension;
use crate::model::{
    Certificate, Coefficients, Combination, Conclusion, End, Family, Interval, Lemma, Polytope,
};
use crate::number::Number;

/// The largest file that is read, in bytes: 64 MiB.
pub const FILE: usize = 64 << 20;
/// The largest number of JSON values in a file.
pub(crate) const VALUES: usize = 10_000_000;
/// The deepest nesting of arrays and objects.
pub(crate) const DEPTH: usize = 16;
/// The longest string or number in bytes, a closing quote included.
pub(crate) const TOKEN: usize = 4003;

const COEFFICIENTS: usize = 1000;
const DIMENSION: usize = 40;
/// The longest word.
pub(crate) const WORD: usize = 32;
const LEVEL: u32 = 12;
const DEGREE: usize = 1200;
const VERTICES: usize = 20_000;
const LEMMAS: usize = 5000;
const INTERVALS: usize = 5000;
/// For the denominators of one mask or polynomial together.
const DENOMINATOR_BITS: u64 = 14_000;

/// The result of a check of size: what is too large.
type Fits = Result<(), &'static str>;

/// Checks all counts, degrees and lengths.
pub(crate) fn check(certificate: &Certificate) -> Fits {
    check_family(&certificate.family)?;
    match &certificate.conclusion {
        Conclusion::Continuity { proved, refuted, .. } => {
            at_most(proved.len() + refuted.len(), INTERVALS, "more than 5000 intervals")?;
            proved.iter().chain(refuted).try_for_each(check_interval)?;
        }
        Conclusion::Regularity { from, to, .. } => {
            check_end(from)?;
            check_end(to)?;
        }
    }
    let inside = |lemma: &Lemma| 1 + lemma.inside().map_or(0, <[Lemma]>::len);
    let count = certificate.lemmas.iter().map(inside).sum();
    at_most(count, LEMMAS, "more than 5000 lemmas")?;
    let family = &certificate.family;
    certificate.lemmas.iter().try_for_each(|lemma| check_lemma(family, lemma))
}

impl Family {
    /// Whether a certificate about this family is of a size that is read at all. Where it is not, no proof need be
    /// sought.
    ///
    /// # Errors
    /// What is too large, as in `matrices of size above 40`.
    pub fn fits(&self) -> Result<(), &'static str> {
        check_family(self)
    }
}

fn at_most(size: usize, limit: usize, what: &'static str) -> Fits {
    if size <= limit { Ok(()) } else { Err(what) }
}

fn check_family(family: &Family) -> Fits {
    at_most(family.mask.len(), COEFFICIENTS, "more than 1000 mask coefficients")?;
    check_mask(&family.mask, &Vec::new())?;
    check_dimension(family, 0, family.order)?;
    if let Some(curve) = &family.curve {
        at_most(curve.mask.len(), COEFFICIENTS, "more than 1000 mask coefficients")?;
        check_mask(&curve.mask, &curve.denominator)?;
        check_polynomial(&curve.line.numerator)?;
        check_polynomial(&curve.line.denominator)?;
        denominators(curve.line.numerator.iter().chain(&curve.line.denominator))?;
    }
    Ok(())
}

fn check_mask(mask: &[Coefficients], denominator: &Coefficients) -> Fits {
    mask.iter().chain([denominator]).try_for_each(check_polynomial)?;
    denominators(mask.iter().flatten().chain(denominator))
}

fn check_polynomial(polynomial: &Coefficients) -> Fits {
    at_most(polynomial.len(), DEGREE + 1, "a polynomial of degree above 1200")?;
    denominators(polynomial.iter())
}

/// The denominators of one mask or polynomial together are short.
pub(crate) fn denominators<'a>(numbers: impl Iterator<Item = &'a Number>) -> Fits {
    let total: u64 = numbers.map(|n| bit_length(n.0.denom()) - 1).sum();
    if total <= DENOMINATOR_BITS { Ok(()) } else { Err("denominators of more than 4000 digits") }
}

/// The size of the matrices for an order, as far as arity and order make sense; the mask is shorter
/// by some coefficients.
fn check_dimension(family: &Family, shorter: usize, order: usize) -> Fits {
    let Some(step) = family.arity.checked_sub(1).filter(|&s| s > 0) else { return Ok(()) };
    let length = order.checked_mul(step);
    let degree = length.and_then(|n| family.mask.len().checked_sub(1 + shorter)?.checked_sub(n));
    let Some(degree) = degree else { return Ok(()) };
    at_most(dimension(degree, family.arity), DIMENSION, "matrices of size above 40")
}

fn check_interval(interval: &Interval) -> Fits {
    [&interval.from, &interval.to].into_iter().flatten().try_for_each(check_end)
}

fn check_end(end: &End) -> Fits {
    match end {
        End::Rational(_) => Ok(()),
        End::Algebraic(root) => check_polynomial(&root.root_of),
    }
}

fn check_lemma(family: &Family, lemma: &Lemma) -> Fits {
    match lemma {
        Lemma::Norm { level, .. } if *level > LEVEL => Err("a level above 12"),
        Lemma::Norm { .. } => Ok(()),
        Lemma::Polytope(polytope) => check_polytope(polytope),
        Lemma::Word { word, from, to, .. } => {
            at_most(word.len(), WORD, "a word longer than 32")?;
            [from, to].into_iter().flatten().try_for_each(check_end)
        }
        Lemma::Indivisible { except, .. } | Lemma::Stable { except } => {
            at_most(except.len(), INTERVALS, "more than 5000 exceptions")?;
            except.iter().try_for_each(check_end)
        }
        Lemma::Nonnegative { end } => check_end(end),
        Lemma::At { order, lemmas, .. } => {
            check_dimension(family, 0, *order)?;
            check_inner(family, lemmas)
        }
        Lemma::Convergence { lemmas } => check_inner(family, lemmas),
        Lemma::Reduced { factor, order, lemmas, .. } => {
            check_polynomial(factor)?;
            let degree = factor.iter().rposition(|c| !c.0.is_zero()).unwrap_or(0);
            check_dimension(family, degree, *order)?;
            check_inner(family, lemmas)
        }
    }
}

/// What is wrong with lemmas that have lemmas inside, inside another.
pub(crate) const NESTED: &str = "an `at`, `convergence` or `reduced` lemma inside another";

/// The lemmas inside a lemma.
fn check_inner(family: &Family, lemmas: &[Lemma]) -> Fits {
    if lemmas.iter().any(|lemma| lemma.inside().is_some()) {
        return Err(NESTED);
    }
    lemmas.iter().try_for_each(|lemma| check_lemma(family, lemma))
}

fn check_polytope(polytope: &Polytope) -> Fits {
    check_end(&polytope.end)?;
    let moved = polytope.motion.as_ref();
    let count = polytope.vertices.len().max(moved.map_or(0, |m| m.vertices.len()));
    at_most(count, VERTICES, "more than 20000 vertices")?;
    at_most(polytope.leading.len(), VERTICES, "more than 20000 leading words")?;
    let longest = polytope.leading.iter().map(|l| l.word.len()).max().unwrap_or(0);
    at_most(longest, WORD, "a word longer than 32")?;
    let rests = moved.into_iter().flat_map(|m| &m.rests);
    let images = polytope.inner_images.iter().chain(&polytope.end_images).chain(rests).flatten();
    let pairs = |c: &Combination| c.as_ref().map_or(0, Vec::len);
    let longest = images.chain(&polytope.units).map(pairs).max().unwrap_or(0);
    at_most(longest, 2 * VERTICES, "a combination of more than 40000 vertices")
}
