//! The joint spectral radius of one set of matrices.

use refinable_algebra::Rational;
use refinable_certificate::{self as certificate, Lemma, Polytope};
use refinable_reals::{RealAlgebraic, real_roots_between};

use crate::division::Options;
use crate::float::{approximate_root, leading_bits};
use crate::leading::{fastest, growth};
use crate::pencil::Pencil;
use crate::rough::{Product, rough_set, sign_set};
use crate::search::{Crossing, Outcome, Search, certificate_end};
use crate::word::Word;
use crate::work::Work;

/// Bounds `from ≤ 1/ρ ≤ to` for the joint spectral radius `ρ` of a set of matrices.
#[derive(Clone, Debug)]
pub struct Radius {
    /// The word that grows fastest among those tried.
    pub word: Word,
    /// Any scale below keeps the matrices contractive.
    pub from: RealAlgebraic,
    /// From this scale on they are not.
    pub to: RealAlgebraic,
    /// The proofs, about the pencil "scale".
    pub lemmas: Vec<Lemma>,
}

/// What growing polytopes may take up to an exact end, and then for each width: a second or two. For the masks of papers
/// it is a fiftieth of that or less; without a limit matrices of size 24 and more take many minutes in vain.
const WORK: u64 = 3_000_000_000;
/// How far apart, relatively, the bounds may be, tried in turn where they cannot be made equal.
const WIDTHS: [f64; 6] = [4e-10, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2];

/// Bounds for `1/ρ`, equal if a polytope closes at the eigenvector of the fastest word. The pencil
/// must be `x A_ε`; `nonnegative` checks that the end of the interval follows from a non-negative
/// symbol. `None` if nothing was found with the work that is allowed.
///
/// # Cost
/// For each polytope that is tried a linear program in floats for every image of every vertex.
///
/// # Source
/// Guglielmi and Protasov 2013: the scale is a parameter, and `1/ρ` the end of its range.
pub fn radius(
    pencil: &Pencil,
    options: &Options,
    nonnegative: &dyn Fn(&certificate::End) -> bool,
    accept: &(dyn Fn(&Polytope) -> bool + Sync),
) -> Option<Radius> {
    let words = Word::necklaces(pencil.letters(), options.longest_word, pencil.is_mirrored());
    let matrices = pencil.rounded_at(1.0);
    let (word, fastest_growth) = fastest(&matrices, &words);
    if fastest_growth == 0.0 {
        return None;
    }
    let (kind, work) = (certificate::Pencil::Scale, &Work::of(WORK));
    let search = Search { pencil, kind, words: &words, accept, work };
    let cleared = pencil.cleared();
    let crossings: Vec<Crossing> = words
        .iter()
        .filter(|word| growth(&matrices, word).is_some_and(|g| g > fastest_growth * (1.0 - 1e-9)))
        .flat_map(|word| Crossing::all(word, sign_set(&Product::new(&cleared, word)).determinants))
        .collect();
    match real_end(&crossings, 1.0 / fastest_growth) {
        Some(end) => {
            let upper = word_lemma(word, &end);
            if nonnegative(&certificate_end(&end)) {
                let lemma = Lemma::Nonnegative { end: certificate_end(&end) };
                return Some(exact(word, end, vec![lemma, upper]));
            }
            let zero = Rational::from_integer(0.into());
            match search.up_to(&end, &crossings, &zero) {
                Some(polytope) => {
                    let lemmas = vec![Lemma::Polytope(Box::new(polytope)), upper];
                    Some(exact(word, end, lemmas))
                }
                None => bracket(&search, word, &end, upper),
            }
        }
        None => {
            let product = Product::new(&cleared, word);
            let above = leading_bits((1.0 + 1e-12) / fastest_growth, 53)?;
            let end = RealAlgebraic::from(above);
            let expanding = rough_set(&product).contains(&end);
            expanding.then(|| bracket(&search, word, &end, word_lemma(word, &end))).flatten()
        }
    }
}

fn exact(word: &Word, end: RealAlgebraic, lemmas: Vec<Lemma>) -> Radius {
    Radius { word: word.clone(), from: end.clone(), to: end, lemmas }
}

/// A lower bound as near to the upper one as a polytope will prove.
fn bracket(search: &Search, word: &Word, to: &RealAlgebraic, upper: Lemma) -> Option<Radius> {
    let zero = Rational::from_integer(0.into());
    WIDTHS.iter().find_map(|width| {
        let from = leading_bits(approximate_root(to) * (1.0 - width), 50)?;
        // However much the finer ones took, the coarser ones are easier.
        let search = Search { work: &Work::of(WORK), ..*search };
        let Outcome::Proved(polytope, _) = search.closed(&zero, &from) else { return None };
        Some(Radius {
            word: word.clone(),
            from: from.into(),
            to: to.clone(),
            lemmas: vec![Lemma::Polytope(polytope), upper.clone()],
        })
    })
}

/// Expansion at one scale, which is expansion from there on.
fn word_lemma(word: &Word, from: &RealAlgebraic) -> Lemma {
    Lemma::Word {
        pencil: certificate::Pencil::Scale,
        word: word.to_string(),
        from: Some(certificate_end(from)),
        to: Some(certificate_end(from)),
    }
}

/// The scale near `approximation` at which a word has the eigenvalue 1 or -1.
fn real_end(crossings: &[Crossing], approximation: f64) -> Option<RealAlgebraic> {
    let lower = leading_bits(approximation * (1.0 - 1e-9), 53)?;
    let upper = leading_bits(approximation * (1.0 + 1e-9), 53)?;
    let roots = crossings
        .iter()
        .filter(|c| !refinable_algebra::Ring::is_zero(&c.determinant))
        .flat_map(|c| real_roots_between(&c.determinant, &lower, &upper));
    roots.map(|root| root.simplified()).min()
}
