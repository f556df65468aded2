//! The lemma `norm`: `‖c_n^L‖ < 1` on a closed interval.
//!
//! With `t = from·u + to·v`, `u + v = 1`, every coefficient of `c_n` is a form `α u + β v`, and every
//! coefficient of `c_n^L` a form of degree `L`. If `h_{ik}` is the coefficient of `u^(L-k) v^k` in the
//! `i`-th, then a row sum is at most `max_k Σ_i |h_{ik}| / binomial(L, k)`. Where that is not less than
//! one the interval is halved.

use refinable_algebra::{Integer, Ordered, Rational, Ring, binomial, integer};

use crate::family::Scheme;
use crate::order::equal;
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// A form `Σ_k h_k u^(L-k) v^k`.
type Form = Vec<Integer>;

/// How often an interval is halved.
const DEPTH: u32 = 40;
/// The most numbers that the forms of a level may have together: half a gigabyte.
const NUMBERS: usize = 16_000_000;

/// Checks that the norm is less than one for all parameters in `[from, to]`.
pub(crate) fn check(
    scheme: &Scheme,
    continuity: usize,
    level: u32,
    [from, to]: [&Rational; 2],
    work: &mut Work,
) -> Check<()> {
    ensure(level >= 1, "the level is less than one")?;
    let symbol = scheme.lower_difference(continuity, work)?;
    let [left, right] = [symbol.at(from, work)?, symbol.at(to, work)?];
    // Over the common denominator of both ends.
    let denominator = &left.denominator * &right.denominator;
    let constant = equal(from, to) || symbol.is_constant();
    let form = |(l, r): (&Integer, &Integer)| {
        let l = l * &right.denominator;
        if constant { vec![l] } else { vec![l, r * &left.denominator] }
    };
    let forms: Vec<Form> = left.p.iter().zip(&right.p).map(form).collect();
    let degree = if constant { 0 } else { level };
    let bounds: Vec<Integer> = {
        let one = denominator.power(level);
        (0..=degree).map(|k| binomial(degree, k) * &one).collect()
    };
    let mirrored = symbol.is_symmetric();
    let power = power(&forms, scheme.arity, level, denominator.bits(), work)?;
    // Beyond the number of coefficients it does not matter how far apart those of a row are.
    let stride = scheme.arity.checked_pow(level).unwrap_or(usize::MAX);
    check_rows(&power, stride, mirrored, &bounds, work)
}

/// `Π_{l<L} c(z^(m^l))`.
fn power(c: &[Form], m: usize, level: u32, bits: u64, work: &mut Work) -> Check<Vec<Form>> {
    let mut power = c.to_vec();
    for step in 1..level {
        // c^(l+1)(z) = c^l(z^m) c(z)
        let length = (power.len() - 1).saturating_mul(m).saturating_add(c.len());
        let width = power[0].len() + c[0].len() - 1;
        let small = length.saturating_mul(width) <= NUMBERS;
        ensure(small, "could not be checked within the limits")?;
        let products = (step as usize + 1) * 2 * (length / m + 1).saturating_mul(c.len());
        work.products(products, bits * u64::from(step), bits)?;
        let mut next = vec![vec![Integer::zero(); width]; length];
        for (i, a) in power.iter().enumerate() {
            for (j, b) in c.iter().enumerate() {
                add_product(&mut next[m * i + j], a, b);
            }
        }
        power = next;
    }
    Ok(power)
}

fn add_product(sum: &mut [Integer], a: &[Integer], b: &[Integer]) {
    for (i, x) in a.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        for (j, y) in b.iter().enumerate() {
            sum[i + j] += x * y;
        }
    }
}

fn check_rows(
    power: &[Form],
    stride: usize,
    mirrored: bool,
    bounds: &[Integer],
    work: &mut Work,
) -> Check<()> {
    for j in 0..stride.min(power.len()) {
        // Row j and the row of the mirror images have the same sum.
        let image = (power.len() - 1 - j) % stride;
        if mirrored && image < j {
            continue;
        }
        let row: Vec<Form> = power[j..].iter().step_by(stride).cloned().collect();
        if !holds(row, bounds, 0, work)? {
            return fail(format!("row {j} of the norm is not shown to be less than one"));
        }
    }
    Ok(())
}

/// Whether the row sum is shown to be less than one on the interval, by bisection.
fn holds(row: Vec<Form>, bounds: &[Integer], depth: u32, work: &mut Work) -> Check<bool> {
    let bits = largest_bits(bounds);
    work.products(row.len() * bounds.len() * bounds.len(), bits, 1)?;
    let sum = |k: usize| row.iter().map(|form| form[k].absolute()).sum::<Integer>();
    if (0..bounds.len()).all(|k| sum(k) < bounds[k]) {
        return Ok(true);
    }
    // At the ends the sums are exact.
    let last = bounds.len() - 1;
    if depth == DEPTH || sum(0) >= bounds[0] || sum(last) >= bounds[last] {
        return Ok(false);
    }
    // The left half: u → 2u + v, v → v. The right half: u → u, v → u + 2v.
    let halves = [row.iter().map(|f| left_half(f)).collect(), {
        let reversed = row.iter().map(|f| f.iter().rev().cloned().collect::<Form>());
        reversed.map(|f| left_half(&f).into_iter().rev().collect()).collect()
    }];
    let scaled: Vec<Integer> = bounds.iter().map(|b| b << last).collect();
    for half in halves {
        if !holds(half, &scaled, depth + 1, work)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// `Σ h_k (2u + v)^(L-k) v^k`, by Horner's rule in `2u + v`.
fn left_half(form: &[Integer]) -> Form {
    let mut half: Form = Vec::with_capacity(form.len());
    let two = integer(2);
    for h in form {
        // half · (2u + v) + h v^k
        half.push(h.clone());
        for k in (0..half.len() - 1).rev() {
            let (low, high) = half.split_at_mut(k + 1);
            high[0] += &low[k];
            low[k] *= &two;
        }
    }
    half
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of one form against one.
    fn is_less_than_one(form: &[i64]) -> bool {
        let degree = form.len() as u32 - 1;
        let bounds: Vec<Integer> = (0..=degree).map(|k| binomial(degree, k) * 100).collect();
        let row = vec![form.iter().map(|&h| integer(h)).collect()];
        holds(row, &bounds, 0, &mut Work::new()).unwrap()
    }

    #[test]
    fn the_whole_interval_counts() {
        // b u v, at most b/4 in the middle.
        assert!(is_less_than_one(&[0, 390, 0]));
        assert!(is_less_than_one(&[0, -390, 0]));
        assert!(!is_less_than_one(&[0, 400, 0]));
        assert!(!is_less_than_one(&[0, -410, 0]));
        // b u³ v and b u v³, at most 27 b / 256, at one quarter.
        for (form, holds) in [([0, 940, 0, 0, 0], true), ([0, 950, 0, 0, 0], false)] {
            assert_eq!(is_less_than_one(&form), holds);
            let reversed: Vec<i64> = form.into_iter().rev().collect();
            assert_eq!(is_less_than_one(&reversed), holds);
        }
        // b u v², at most 4 b / 27 at two thirds, which halves never come to.
        assert!(is_less_than_one(&[0, 0, 670, 0]) && !is_less_than_one(&[0, 0, 675, 0]));
        for ends in [[100, 0], [0, 100], [-100, 0], [0, -100]] {
            assert!(!is_less_than_one(&ends));
        }
    }

    #[test]
    fn halves_agree_with_the_whole() {
        let form: Form = [3, -5, 7, 2].map(integer).to_vec();
        let value = |f: &[Integer], u: i64, v: i64| {
            let power = |x: i64, n: usize| integer(x).power(n as u32);
            (0..4).map(|k| &f[k] * power(u, 3 - k) * power(v, k)).sum::<Integer>()
        };
        for (u, v) in [(1, 0), (0, 1), (2, 5), (-1, 3)] {
            assert_eq!(value(&left_half(&form), u, v), value(&form, 2 * u + v, v));
        }
    }

    /// A row is left out only if the row of its mirror images is looked at.
    #[test]
    fn rows_are_left_out_for_their_mirror_images_only() {
        let bound = [integer(100)];
        for (length, stride) in (1..9).flat_map(|length| (1..10).map(move |s| (length, s))) {
            for place in 0..length {
                let large = |k: usize| k == place || k == length - 1 - place;
                let power: Vec<Form> =
                    (0..length).map(|k| vec![integer(if large(k) { 100 } else { 1 })]).collect();
                let work = &mut Work::new();
                assert!(check_rows(&power, stride, true, &bound, work).is_err());
                assert!(check_rows(&power, stride, false, &bound, work).is_err());
            }
            let ones = vec![vec![integer(1)]; length];
            assert_eq!(check_rows(&ones, stride, true, &bound, &mut Work::new()), Ok(()));
        }
    }
}
