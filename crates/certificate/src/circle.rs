//! Polynomials on the unit circle, as polynomials in `x = cos θ`.

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, integer};

use crate::fixed::divide_up;
use crate::real::Real;
use crate::roots::is_positive_on;
use crate::work::{Check, Work, largest_bits};

/// A polynomial `Σ (p_i + q_i t) w^i` up to a positive factor.
pub(crate) type Pair = [Vec<Integer>; 2];

/// `Σ_k g_k cos kθ` as a polynomial in `cos θ` (Clenshaw).
pub(crate) fn from_cosines(g: &[Integer], work: &mut Work) -> Check<Polynomial<Integer>> {
    work.products(2 * g.len() * g.len(), largest_bits(g) + 2 * g.len() as u64, 1)?;
    let double = Polynomial::new(vec![integer(0), integer(2)]);
    let (mut next, mut after) = (Polynomial::zero(), Polynomial::zero());
    for c in g.iter().skip(1).rev() {
        let sum = double.times(&next).minus(&after).plus(&Polynomial::constant(c.clone()));
        after = std::mem::replace(&mut next, sum);
    }
    let constant = Polynomial::constant(g.first().cloned().unwrap_or_default());
    Ok(next.shifted(1).minus(&after).plus(&constant))
}

/// `|f(e^{iθ})|²` as coefficients of `cos kθ`.
fn squared_modulus(f: &[Integer], work: &mut Work) -> Check<Vec<Integer>> {
    let bits = largest_bits(f);
    work.products(f.len() * f.len(), bits, bits)?;
    let correlation = |k: usize| f.iter().zip(&f[k..]).map(|(a, b)| a * b).sum::<Integer>();
    Ok((0..f.len()).map(|k| if k == 0 { correlation(0) } else { correlation(k) * 2 }).collect())
}

/// Whether the polynomials are shown to have no common zero on the unit circle for the parameter
/// value `t`, or for any value in some enclosure of it.
pub(crate) fn have_no_common_zero(parts: &[Pair], t: &Real, work: &mut Work) -> Check<bool> {
    if let Some(rational) = t.as_rational() {
        let zero = Rational::from(integer(0));
        return is_positive_sum(parts, rational, &zero, work);
    }
    for bits in [40, 100, 250] {
        let (lower, upper) = t.enclosure(bits, work)?;
        if is_positive_sum(parts, &lower, &(&upper - &lower), work)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether `Σ |f(w)|² > 0` for `|w| = 1` and all parameters in `[lower, lower + width]`.
///
/// With `f = e + δ q`, `0 ≤ δ ≤ width`, `e` the value at `lower`: `|f|²` differs from `|e|²` by at
/// most `width ‖q‖_1 (2 ‖e‖_1 + width ‖q‖_1)`.
fn is_positive_sum(
    parts: &[Pair],
    lower: &Rational,
    width: &Rational,
    work: &mut Work,
) -> Check<bool> {
    let mut cosines: Vec<Integer> = Vec::new();
    let mut deviation = Rational::from(integer(0));
    let v = lower.denom();
    for [p, q] in parts {
        let value: Vec<Integer> = p.iter().zip(q).map(|(p, q)| p * v + q * lower.numer()).collect();
        let modulus = squared_modulus(&value, work)?;
        if cosines.len() < modulus.len() {
            cosines.resize(modulus.len(), Integer::zero());
        }
        for (sum, c) in cosines.iter_mut().zip(&modulus) {
            *sum += c;
        }
        let norm = |f: &[Integer]| f.iter().map(Ordered::absolute).sum::<Integer>();
        // All times v².
        let slope = width * (norm(q) * v);
        deviation += &slope * (&slope + norm(&value) * integer(2));
    }
    let deviation = divide_up(deviation.numer(), deviation.denom());
    let sum = from_cosines(&cosines, work)?.minus(&Polynomial::constant(deviation));
    let one = Rational::from(integer(1));
    is_positive_on(&sum, &-one.clone(), &one, work)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    /// `t²`, which is `100²` at 100, and differs from it by `w (200 + w)` at `100 + w`.
    #[test]
    fn the_deviation_has_two_terms() {
        let parts = [[vec![integer(0)], vec![integer(1)]]];
        for (width, shown) in [(40, true), (41, true), (42, false), (70, false)] {
            let width = rational(width, 1);
            let got = is_positive_sum(&parts, &rational(100, 1), &width, &mut Work::new());
            assert_eq!(got, Ok(shown), "{width}");
        }
    }
}
