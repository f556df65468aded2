//! Where in the plane shifts may fail to be stable.

use refinable_algebra::{Integer, Polynomial, Rational, Ring};

use crate::map::family::PlaneScheme;
use crate::resultant::{of_squares, resultant};
use crate::stability::without_zeros_at_one;
use crate::work::{Check, Work};

/// Whether the shifts are stable at a point for a reason that holds almost everywhere: for arity two,
/// neither do the submasks of `c` have a common zero, nor is `z² ≠ 1` a zero of `c(-z)` together with
/// `z`; for others, two contrasts have no common zero.
///
/// All say that a resultant does not vanish, which is a polynomial in the coordinates.
pub(crate) fn is_generic(
    scheme: &PlaneScheme,
    point: &[Rational; 2],
    work: &mut Work,
) -> Check<bool> {
    let contrasts = (0..scheme.arity - 1).map(|j| scheme.contrast(j, point)).collect();
    exclude_instability(scheme, contrasts, point, work)
}

/// Whether the shifts are stable at one point: likewise, but `z = 1`, a zero where the order rises, does no harm.
pub(crate) fn is_stable(
    scheme: &PlaneScheme,
    point: &[Rational; 2],
    work: &mut Work,
) -> Check<bool> {
    let contrast = |j| {
        let values = scheme.contrast(j, point);
        let zeros = vec![Integer::zero(); values.len()];
        let [rest, _] = without_zeros_at_one([values, zeros]);
        rest
    };
    exclude_instability(scheme, (0..scheme.arity - 1).map(contrast).collect(), point, work)
}

/// Whether resultants of the submasks and of these contrasts show that the shifts are stable.
fn exclude_instability(
    scheme: &PlaneScheme,
    contrasts: Vec<Vec<Integer>>,
    point: &[Rational; 2],
    work: &mut Work,
) -> Check<bool> {
    let mut contrasts = contrasts.into_iter();
    if scheme.arity > 2 {
        let mut occurring = contrasts.filter(|contrast| !contrast.is_empty());
        let (Some(first), Some(second)) = (occurring.next(), occurring.next()) else {
            return Ok(false);
        };
        return are_coprime(&first, &second, work);
    }
    let contrast = contrasts.next().unwrap_or_default();
    let [even, odd] = scheme.halves(point);
    Ok(are_coprime(&even, &odd, work)? && are_coprime(&contrast, &squares(&contrast, work)?, work)?)
}

fn constants(coefficients: &[Integer]) -> Vec<Polynomial<Integer>> {
    coefficients.iter().cloned().map(Polynomial::constant).collect()
}

/// The polynomial with the squares of the zeros.
fn squares(coefficients: &[Integer], work: &mut Work) -> Check<Vec<Integer>> {
    let squares = of_squares(&constants(coefficients), work)?;
    Ok(squares.iter().map(|c| c.coefficient(0)).collect())
}

/// Whether the resultant of two polynomials of formal degrees does not vanish.
fn are_coprime(a: &[Integer], b: &[Integer], work: &mut Work) -> Check<bool> {
    let (long, short) = if a.len() >= b.len() { (a, b) } else { (b, a) };
    // Two monomials: the resultant of constants is 1, even where both vanish.
    if long.len() <= 1 {
        return Ok(long.iter().chain(short).any(|c| !c.is_zero()));
    }
    Ok(!resultant(&constants(long), &constants(short), work)?.is_zero())
}
