//! The lemma `nonnegative`: a symbol that is non-negative on the unit circle.

use refinable_algebra::{Integer, Polynomial, Rational, Ring, integer};

use crate::circle::from_cosines;
use crate::determinant::Product;
use crate::family::{Letters, Scheme};
use crate::line::{Cut, Span};
use crate::real::{Real, between};
use crate::roots::{roots_between, sign_at};
use crate::work::{Check, Work, ensure};

/// Checks that the pencil "scale" is contractive on `[0, end)`, and returns this span.
pub(crate) fn check(scheme: &Scheme, end: Real, work: &mut Work) -> Check<Span> {
    ensure(scheme.arity == 2, "non-negative symbols are for arity two only")?;
    let letters = Letters::of_scale(scheme)?;
    let c = &scheme.difference;
    ensure(c.is_symmetric(), "the difference symbol is not symmetric")?;
    ensure(c.degree().is_multiple_of(2), "the degree of the difference symbol is odd")?;
    let one = Rational::from(integer(1));
    let zero = Real::Rational(Rational::from(integer(0)));
    let span = Span::new(Cut::Before(zero), Cut::Before(end.clone()), work)?;
    let modulus = centred(&c.p, work)?;
    ensure(is_nonnegative(&modulus, &one, work)?, "the difference symbol is negative somewhere")?;
    // 1/ρ is a root of this polynomial; its value at zero is not zero.
    let candidates = Product::new(&letters, &[0], work)?.determinant(1, work)?;
    let (_, upper) = end.bracket();
    for root in roots_between(&candidates, &Rational::from(integer(0)), upper, work)? {
        let later = root.compare(&end, work)?.is_ge();
        ensure(later, "the determinant has a root between zero and the end")?;
    }
    Ok(span)
}

/// `c(e^{iθ}) e^{-iMθ/2}` as a polynomial in `cos θ`.
fn centred(c: &[Integer], work: &mut Work) -> Check<Polynomial<Integer>> {
    let half = c.len() / 2;
    let cosines: Vec<Integer> = c[half..]
        .iter()
        .enumerate()
        .map(|(k, c)| if k == 0 { c.clone() } else { c * integer(2) })
        .collect();
    from_cosines(&cosines, work)
}

/// Whether the polynomial is non-negative on `[-1, 1]`, and not zero.
fn is_nonnegative(p: &Polynomial<Integer>, one: &Rational, work: &mut Work) -> Check<bool> {
    if p.is_zero() {
        return Ok(false);
    }
    let minus = Real::Rational(-one.clone());
    let plus = Real::Rational(one.clone());
    let roots = roots_between(p, &-one.clone(), one, work)?;
    let cuts: Vec<&Real> = [&minus].into_iter().chain(&roots).chain([&plus]).collect();
    for pair in cuts.windows(2) {
        let sample = between(Some(pair[0]), Some(pair[1]), work)?;
        if sign_at(p, &sample, work)?.is_le() {
            return Ok(false);
        }
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn holds(coefficients: &[i64]) -> bool {
        let p = Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect());
        is_nonnegative(&p, &Rational::from(integer(1)), &mut Work::new()).unwrap()
    }

    /// Negative near an end, in the middle, everywhere, and nowhere but outside of `[-1, 1]`; zero does not count.
    #[test]
    fn all_of_the_interval_counts() {
        assert!([&[1, 2][..], &[1, -2], &[-1, 0, 4], &[-1], &[]].iter().all(|p| !holds(p)));
        assert!(
            [&[1, 1][..], &[1, -1], &[3, -2], &[1], &[0, 0, 1], &[1, 0, -1]]
                .iter()
                .all(|p| holds(p))
        );
        // (2x - 1)², twice the same root, and (2x - 1)³.
        assert!(holds(&[1, -4, 4]) && !holds(&[-1, 6, -12, 8]));
    }
}
