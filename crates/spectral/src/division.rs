//! The line of parameters, divided at `ρ(x) = 1`.

use rayon::prelude::*;
use refinable_algebra::{Integer, Matrix, Ordered, Polynomial, Rational, Ring, rational};
use refinable_certificate::{self as certificate, Lemma, Polytope};
use refinable_reals::{Bound, Interval, RealAlgebraic, Region};

use crate::cover::{Cover, prove};
use crate::float::{approximate, approximate_root};
use crate::leading::fastest;
use crate::pencil::Pencil;
use crate::rough::{Product, SignSet, rough_set, sign_set};
use crate::search::{Crossing, Outcome, Search, certificate_end, real_algebraic};
use crate::word::Word;
use crate::work::Work;

/// What is wanted of a division.
#[derive(Clone, Debug)]
pub struct Options {
    /// The longest word that is tried.
    pub longest_word: usize,
    /// How wide, against the interval, an undecided gap at an end may be that is not proved exactly.
    pub gap: Rational,
}

impl Default for Options {
    fn default() -> Self {
        Options { longest_word: 8, gap: rational(1, 1_000_000) }
    }
}

/// Where the joint spectral radius `ρ(x)` of a pencil is less than one, and where it is not.
#[derive(Clone, Debug)]
pub struct Division {
    /// `ρ(x) < 1` is proved here.
    pub contracting: Region,
    /// `ρ(x) ≥ 1` is proved here, by words.
    pub expanding: Region,
    /// The proofs.
    pub lemmas: Vec<Lemma>,
}

/// What is known about one word.
struct KnownWord {
    word: Word,
    crossings: Vec<Crossing>,
    region: Region,
    complete: bool,
}

/// Divides the line at `ρ(x) = 1`: words from below, polytopes from above.
///
/// `known` are closed intervals on which `ρ(x) < 1` has been shown otherwise; `accept` is the
/// independent check of a polytope.
///
/// # Cost
/// The words are as many as necklaces of up to `longest_word` letters; for each polytope that is tried a linear program
/// in floats for every image of every vertex.
///
/// # Source
/// Words and extremal polytopes: Guglielmi and Protasov 2013. One polytope for a half-open interval
/// up to an exact end, and for a whole cell: convexity, see `docs/certificates.md`.
pub fn divide(
    pencil: &Pencil,
    known: &[(Rational, Rational)],
    options: &Options,
    accept: &(dyn Fn(&Polytope) -> bool + Sync),
) -> Division {
    let words = Word::necklaces(pencil.letters(), options.longest_word, pencil.is_mirrored());
    let mut expansion = Expansion::new(pencil, &words);
    let (kind, work) = (certificate::Pencil::Parameter, &Work::unbounded());
    let search = Search { pencil, kind, words: &words, accept, work };
    loop {
        let components = expansion.region().complement().intervals();
        let proofs: Vec<Cover> = components
            .par_iter()
            .map(|component| prove(&search, component, &expansion.crossings(), known, options))
            .collect();
        let faster: Vec<Word> = proofs.iter().flat_map(|p| p.faster.clone()).collect();
        if faster.iter().any(|word| expansion.learn(word)) {
            continue;
        }
        return conclude(known, proofs, &expansion);
    }
}

/// Where words show that `ρ(x) ≥ 1`, and the lemmas that say so.
///
/// # Cost
/// A determinant with polynomial entries, and the isolation of its roots, for each word.
pub fn expanding(pencil: &Pencil, options: &Options) -> (Region, Vec<Lemma>) {
    let words = Word::necklaces(pencil.letters(), options.longest_word, pencil.is_mirrored());
    let expansion = Expansion::new(pencil, &words);
    (expansion.region(), expansion.lemmas())
}

/// Whether the joint spectral radius of constant matrices is less than one.
#[derive(Clone, Debug)]
pub enum Constant {
    /// It is, by a polytope on the point that was given.
    Contracting(Box<Polytope>),
    /// It is not: the product along this word has spectral radius at least one.
    Expanding(Word),
    /// The effort did not suffice.
    Undecided,
}

/// Decides the pencil at a point, which only names the place if the pencil is constant.
///
/// # Cost
/// As for [`divide`], at one value.
pub fn decide(
    pencil: &Pencil,
    point: &Rational,
    options: &Options,
    accept: &(dyn Fn(&Polytope) -> bool + Sync),
) -> Constant {
    let words = Word::necklaces(pencil.letters(), options.longest_word, pencil.is_mirrored());
    let matrices = pencil.rounded_at(approximate(point));
    let (word, growth) = fastest(&matrices, &words);
    if growth > 1.0 - 1e-9 {
        let product = Product::new(&pencil.cleared(), word);
        if rough_set(&product).contains_rational(point) {
            return Constant::Expanding(word.clone());
        }
    }
    let (kind, work) = (certificate::Pencil::Parameter, &Work::unbounded());
    let search = Search { pencil, kind, words: &words, accept, work };
    match search.closed(point, point) {
        Outcome::Proved(polytope, _) => Constant::Contracting(polytope),
        Outcome::Faster(_) | Outcome::Nothing => Constant::Undecided,
    }
}

fn conclude(known: &[(Rational, Rational)], proofs: Vec<Cover>, expansion: &Expansion) -> Division {
    let closed = |a: &Rational, b: &Rational| {
        Region::interval(Bound::Closed(a.clone().into()), Bound::Closed(b.clone().into()))
    };
    let mut contracting = Region::union_of(known.iter().map(|(a, b)| closed(a, b)));
    let mut lemmas = expansion.lemmas();
    for polytope in proofs.into_iter().flat_map(|p| p.polytopes) {
        contracting = contracting.union(&proved_by(&polytope));
        lemmas.push(Lemma::Polytope(Box::new(polytope)));
    }
    Division { contracting, expanding: expansion.region(), lemmas }
}

/// The interval on which a polytope proves contraction.
fn proved_by(polytope: &Polytope) -> Region {
    let inner = RealAlgebraic::from(polytope.inner.0.clone());
    let end = real_algebraic(&polytope.end);
    let far = if polytope.open { Bound::Open } else { Bound::Closed };
    if inner <= end {
        Region::interval(Bound::Closed(inner), far(end))
    } else {
        Region::interval(far(end), Bound::Closed(inner))
    }
}

/// All words that matter so far.
struct Expansion<'a> {
    pencil: &'a Pencil,
    words: &'a [Word],
    cleared: (Integer, Vec<Matrix<Polynomial<Integer>>>),
    known: Vec<KnownWord>,
}

impl<'a> Expansion<'a> {
    /// Words of length one and two, and whatever floats find to grow at samples elsewhere.
    fn new(pencil: &'a Pencil, words: &'a [Word]) -> Self {
        let cleared = pencil.cleared();
        let mut expansion = Expansion { pencil, words, cleared, known: Vec::new() };
        for word in words.iter().filter(|word| word.letters().len() <= 2) {
            expansion.learn(word);
        }
        while expansion.learn_from_samples() {}
        expansion
    }

    fn region(&self) -> Region {
        Region::union_of(self.known.iter().map(|known| known.region.clone()))
    }

    fn crossings(&self) -> Vec<Crossing> {
        self.known.iter().flat_map(|known| known.crossings.clone()).collect()
    }

    /// Adds what can be found out about a word; `false` if all was known.
    fn learn(&mut self, word: &Word) -> bool {
        let product = Product::new(&self.cleared, word);
        if let Some(known) = self.known.iter_mut().find(|known| known.word == *word) {
            if known.complete {
                return false;
            }
            known.complete = true;
            let before = known.region.clone();
            known.region = before.union(&with_short_ends(&rough_set(&product), &before));
            return known.region != before;
        }
        let SignSet { determinants, region } = sign_set(&product);
        let crossings = Crossing::all(word, determinants);
        self.known.push(KnownWord { word: word.clone(), crossings, region, complete: false });
        true
    }

    /// Looks for growing words where none is known yet.
    fn learn_from_samples(&mut self) -> bool {
        let components = self.region().complement().intervals();
        let samples: Vec<f64> = components.iter().flat_map(samples).collect();
        let growing: Vec<Option<&Word>> = samples
            .par_iter()
            .map(|&x| {
                let (word, growth) = fastest(&self.pencil.rounded_at(x), self.words);
                (growth > 1.0 + 1e-9).then_some(word)
            })
            .collect();
        let mut learned = false;
        // One word at a time: it may grow at the other samples too.
        for word in growing.into_iter().flatten() {
            learned = self.learn(word);
            if learned {
                break;
            }
        }
        learned
    }

    /// One lemma for each maximal interval of each word that the words before it do not cover.
    fn lemmas(&self) -> Vec<Lemma> {
        let mut covered = Region::empty();
        let mut lemmas = Vec::new();
        for known in &self.known {
            for interval in known.region.intervals() {
                let region = Region::from(&interval);
                if region.is_subset(&covered) {
                    continue;
                }
                covered = covered.union(&region);
                lemmas.push(Lemma::Word {
                    pencil: certificate::Pencil::Parameter,
                    word: known.word.to_string(),
                    from: interval.lower.number().map(certificate_end),
                    to: interval.upper.number().map(certificate_end),
                });
            }
        }
        lemmas
    }
}

/// The intervals of a closed set that another does not contain, each cut back to rational ends very
/// near its own: where a complex pair crosses the unit circle the exact end is a root of a polynomial
/// of a degree in the hundreds, which nobody wants to see.
fn with_short_ends(region: &Region, known: &Region) -> Region {
    let relative = rational(1, 1 << 34);
    let width = |x: &RealAlgebraic| {
        let (lower, upper) = x.enclosure(&relative);
        let size = lower.absolute().max(upper.absolute());
        if size.is_zero() { relative.clone() } else { size * &relative }
    };
    let inward = |bound: &Bound, lower: bool| match bound.number() {
        None => Bound::Infinite,
        Some(x) => {
            let (below, above) = x.enclosure(&width(x));
            let end = if lower { above } else { below };
            Bound::Closed(short_dyadic_of(&end, lower).into())
        }
    };
    let intervals =
        region.intervals().into_iter().filter(|interval| !Region::from(interval).is_subset(known));
    Region::union_of(intervals.map(|interval| {
        Region::interval(inward(&interval.lower, true), inward(&interval.upper, false))
    }))
}

/// A dyadic number with some forty leading bits, not below `x` or not above it.
fn short_dyadic_of(x: &Rational, up: bool) -> Rational {
    let size = approximate(x).abs().max(f64::MIN_POSITIVE).log2().ceil() as i32;
    let scale = rational(2, 1).power((44 - size).max(0) as u32);
    let scaled = x * &scale;
    (if up { scaled.ceil() } else { scaled.floor() }) / scale
}

/// Where to look for growing words: across the interval, and close to its ends.
fn samples(interval: &Interval) -> Vec<f64> {
    let number = |bound: &Bound| bound.number().map(approximate_root);
    let (a, b) = (number(&interval.lower), number(&interval.upper));
    match (a, b) {
        (Some(a), Some(b)) => {
            let across = (1..16).map(|k| a + (b - a) * f64::from(k) / 16.0);
            let close = (1..7).flat_map(|k| {
                let step = (b - a) * 0.1f64.powi(k) / 2.0;
                [a + step, b - step]
            });
            across.chain(close).collect()
        }
        (Some(a), None) => (-10..40).step_by(3).map(|k| a + 2f64.powi(k)).collect(),
        (None, Some(b)) => (-10..40).step_by(3).map(|k| b - 2f64.powi(k)).collect(),
        (None, None) => (-20..40)
            .step_by(4)
            .flat_map(|k| [2f64.powi(k), -(2f64.powi(k))])
            .chain([0.0])
            .collect(),
    }
}
