//! The Hölder regularity of a scheme without free parameters.

use refinable_algebra::{Integer, Polynomial, Rational, Ring};
use refinable_certificate::{
    Certificate, Conclusion, End, FORMAT, Lemma, Number, Polytope, VERSION, verify,
};
use refinable_reals::{RealAlgebraic, logarithm};
use refinable_scheme::{Diagnostic, Normalised, geometric_factor};
use refinable_spectral::{Options, certificate_end, radius};

use crate::line::Line;
use crate::stability::{Instability, instability, is_stable, reduction};

/// Bits of the logarithms that are taken.
const BITS: u32 = 60;

/// The Hölder exponent of a scheme: limit functions are `r`-times differentiable in Hölder's sense for
/// every exponent below `r`.
#[derive(Clone, Debug)]
pub struct Regularity {
    /// `k`, with `σ^k` dividing the symbol exactly.
    pub divided_order: usize,
    /// A lower bound for `r`.
    pub lower: Rational,
    /// An upper bound; `None` if none is known because the shifts may not be stable.
    pub upper: Option<Rational>,
    /// `ρ = 1/scale` for the joint spectral radius of the matrices of `c_{k-1}`, if this is known exactly and
    /// tells the exponent: `r = k - 1 + log_m scale`.
    pub scale: Option<RealAlgebraic>,
    /// The word whose product has this growth.
    pub word: String,
    /// Whether the shifts are stable; always known for arity two.
    pub stable: Option<bool>,
    /// `q` if the exponent is that of the reduced mask `a(z) q(z) / q(z²)`, whose shifts are stable; all
    /// other fields are then about it.
    pub factor: Option<Polynomial<Integer>>,
    /// The largest `n` for which `r > n`: the scheme is C^n.
    pub continuity: Option<usize>,
    /// The proof, checked; only if there is an upper bound.
    pub certificate: Option<Certificate>,
}

/// The Hölder regularity `r = (k-1) - log_m ρ`.
///
/// # Errors
/// Code `parameters` if a parameter is free; `regularity` if the scheme does not converge or no bounds were found;
/// `budget` if the mask is so long that no proof would be read.
///
/// # Cost
/// One polytope, with a linear program in floats for every image of its vertices; a root isolation if the symbol is
/// non-negative.
///
/// # Source
/// Dyn 1992 and, for the converse, stability, see `docs/certificates.md`. Non-negative symbols need
/// one matrix only (Rioul 1992; Floater and Muntingh 2012).
pub fn regularity(
    name: &str,
    mask: &Normalised,
    options: &Options,
) -> Result<Regularity, Diagnostic> {
    let line = Line::new(name, mask).ok_or_else(|| parameters_free(mask))?;
    if line.parameter().is_some() {
        return Err(parameters_free(mask));
    }
    expect_proof(&line)?;
    let sharp = matches!(instability(&line), Instability::At(_));
    let own =
        Regularity { stable: is_stable(&line, sharp), ..regularity_of(&line, sharp, options)? };
    if sharp || own.continuity.is_none() {
        return Ok(own);
    }
    // A scheme that converges is as smooth as its limit function, and this as that of the reduced mask.
    let Some((factor, reduced)) = reduction(&line) else { return Ok(own) };
    let factor = factor.cleared().1;
    let reduced = reduced.named(format!("{name} reduced by {}", factor.display("z")));
    let found = expect_proof(&reduced).and_then(|()| regularity_of(&reduced, true, options));
    Ok(match found {
        Ok(found) => Regularity { stable: own.stable, factor: Some(factor), ..found },
        Err(_) => own,
    })
}

/// Asked before the search: whether the scheme may converge, and a certificate be read.
fn expect_proof(line: &Line) -> Result<(), Diagnostic> {
    if line.order() == 0 {
        let message = format!("{} does not divide the symbol", geometric_factor(line.arity()));
        return Err(
            Diagnostic::new("regularity", message).with_hint("such a scheme does not converge")
        );
    }
    line.expect_readable_proofs()
}

/// The exponent, from both sides if the criterion of contraction is sharp; whether the shifts are stable is left
/// open.
fn regularity_of(line: &Line, sharp: bool, options: &Options) -> Result<Regularity, Diagnostic> {
    let order = line.order();
    let pencil = line.scaled_pencil(order);
    let probe = |lemma: Lemma| {
        let conclusion =
            Conclusion::Continuity { continuity: 0, proved: Vec::new(), refuted: Vec::new() };
        verify(&certificate_of(line, order, conclusion, vec![lemma])).is_ok()
    };
    let accept = |p: &Polytope| probe(Lemma::Polytope(Box::new(p.clone())));
    let nonnegative = |end: &End| probe(Lemma::Nonnegative { end: end.clone() });
    let found = radius(&pencil, options, &nonnegative, &accept).ok_or_else(|| {
        let message = "no bounds for the joint spectral radius were found with the work allowed";
        Diagnostic::new("regularity", message)
            .with_hint("`refinable certify SCHEME -n N` decides a single C^N, which may be easier")
    })?;
    let (lower, upper) = bounds(line, order, &found.from, &found.to);
    let certificate = sharp.then(|| {
        let conclusion = Conclusion::Regularity {
            from: certificate_end(&found.from),
            to: certificate_end(&found.to),
            holder: [Number(lower.clone()), Number(upper.clone())],
        };
        let mut lemmas = found.lemmas.clone();
        lemmas.push(Lemma::Stable { except: Vec::new() });
        certificate_of(line, order, conclusion, lemmas)
    });
    if let Some(Err(invalid)) = certificate.as_ref().map(verify) {
        let message = format!("the certificate found does not hold: {invalid}");
        return Err(Diagnostic::new("certificate", message));
    }
    let scale = (sharp && found.from == found.to).then(|| found.from.clone());
    Ok(Regularity {
        divided_order: order,
        continuity: continuity(line, order, &found.from),
        lower,
        upper: sharp.then_some(upper),
        scale,
        word: found.word.to_string(),
        stable: None,
        factor: None,
        certificate,
    })
}

fn parameters_free(mask: &Normalised) -> Diagnostic {
    let names: Vec<String> = mask.parameters().iter().map(ToString::to_string).collect();
    let message = format!("free parameters: {}", names.join(", "));
    Diagnostic::new("parameters", message)
        .with_hint("set them with --set NAME=VALUE, or use --sweep")
}

fn certificate_of(
    line: &Line,
    order: usize,
    conclusion: Conclusion,
    lemmas: Vec<Lemma>,
) -> Certificate {
    let family = line.family(order);
    Certificate { format: FORMAT.into(), version: VERSION, family, conclusion, lemmas }
}

/// `k - 1 + log_m` of both ends, outward; exact for powers of `m`.
fn bounds(
    line: &Line,
    order: usize,
    from: &RealAlgebraic,
    to: &RealAlgebraic,
) -> (Rational, Rational) {
    let whole = Rational::from_i64(order as i64 - 1);
    let lower = logarithm(&from.relative_enclosure(80).0, line.arity(), BITS).0;
    let upper = logarithm(&to.relative_enclosure(80).1, line.arity(), BITS).1;
    (&whole + lower, whole + upper)
}

/// The largest `n < r`: `ρ < m^(k-1-n)`, that is `1/ρ > m^(n+1-k)`, decided exactly.
fn continuity(line: &Line, order: usize, from: &RealAlgebraic) -> Option<usize> {
    let arity = Rational::from_i64(line.arity() as i64);
    (0..order).rev().find(|&n| {
        let threshold = Rational::one() / arity.power((order - 1 - n) as u32);
        *from > RealAlgebraic::from(threshold)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{Ordered, rational};
    use refinable_scheme::Scheme;

    fn found(text: &str) -> Result<Regularity, Diagnostic> {
        regularity(text, Scheme::resolve(text, 2)?.mask(), &Options::default())
    }

    /// For large tensions the matrices are nearly a multiple of the tension: twice of it costs one derivative.
    #[test]
    fn large_tensions_have_small_exponents() {
        let near = rational(1, 1_000_000);
        for power in [12, 17, 30] {
            let [one, two] = [1, 2].map(|k| found(&format!("fourpoint({k}*10^{power})")));
            let (one, two) = (one.expect("bounds"), two.expect("bounds"));
            assert_eq!((one.continuity, two.continuity), (None, None));
            for each in [&one, &two] {
                let upper = each.upper.as_ref().expect("stable shifts");
                assert!(each.lower <= *upper && upper - &each.lower < near, "10^{power}");
            }
            let step = one.lower - two.lower;
            assert!((step - rational(1, 1)).absolute() < near, "10^{power}");
        }
    }

    /// Where floats overflow nothing is found, and said.
    #[test]
    fn tensions_beyond_floats() {
        for power in [40, 200, 400] {
            let error = found(&format!("fourpoint(10^{power})")).expect_err("beyond floats");
            assert_eq!(error.code(), "regularity", "10^{power}");
        }
    }
}
