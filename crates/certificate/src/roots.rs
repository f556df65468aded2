//! Isolation of real roots by Descartes' rule and bisection (Vincent, Collins, Akritas), in
//! Bernstein's basis (Lane and Riesenfeld).

use std::cmp::Ordering;
use std::sync::Arc;

use refinable_algebra::{
    Integer, Ordered, Polynomial, Rational, Ring, integer, least_common_multiple,
};

use crate::gcd::square_free_part;
use crate::order::less;
use crate::real::{Real, Root};
use crate::work::{Check, Work, largest_bits, polynomial_bits, rational_bits};

/// The distinct roots in the open interval, ascending, of a polynomial that is not zero.
pub(crate) fn roots_between(
    polynomial: &Polynomial<Integer>,
    lower: &Rational,
    upper: &Rational,
    work: &mut Work,
) -> Check<Vec<Real>> {
    let square_free = Arc::new(square_free_part(polynomial, work)?);
    isolate(&square_free, lower, upper, work)
}

/// All distinct real roots, ascending, of a polynomial that is not zero.
pub(crate) fn real_roots(polynomial: &Polynomial<Integer>, work: &mut Work) -> Check<Vec<Real>> {
    let bound = root_bound(polynomial);
    roots_between(polynomial, &-bound.clone(), &bound, work)
}

/// A power of two larger than the modulus of every root: `2 max |c_k / c_n|^(1/(n-k))`, rounded up
/// (Fujiwara).
pub(crate) fn root_bound(polynomial: &Polynomial<Integer>) -> Rational {
    let degree = polynomial.degree().unwrap_or(0);
    let lead = polynomial.leading().map_or(1, Integer::bits);
    let lower = polynomial.coefficients().iter().enumerate().take(degree);
    // |c_k / c_n| < 2^excess
    let exponents = lower.map(|(k, c)| {
        let excess = (c.bits() + 1).saturating_sub(lead);
        excess.div_ceil((degree - k) as u64)
    });
    Rational::from(integer(1) << (exponents.max().unwrap_or(0) + 1))
}

/// Whether the polynomial is positive on the whole closed interval.
pub(crate) fn is_positive_on(
    polynomial: &Polynomial<Integer>,
    lower: &Rational,
    upper: &Rational,
    work: &mut Work,
) -> Check<bool> {
    if sign_at(polynomial, lower, work)? != Ordering::Greater
        || sign_at(polynomial, upper, work)? != Ordering::Greater
    {
        return Ok(false);
    }
    Ok(roots_between(polynomial, lower, upper, work)?.is_empty())
}

/// The sign of the polynomial at a rational number.
pub(crate) fn sign_at(
    polynomial: &Polynomial<Integer>,
    x: &Rational,
    work: &mut Work,
) -> Check<Ordering> {
    let (n, bits) = (polynomial.coefficients().len(), rational_bits(x));
    let size = polynomial_bits(polynomial).saturating_add(bits.saturating_mul(n as u64));
    work.products(3 * n, size, bits)?;
    Ok(polynomial.sign_at(x))
}

/// A polynomial on the interval `(lower, upper)` in Bernstein's basis, up to a positive factor.
struct Local {
    coefficients: Vec<Integer>,
    lower: Rational,
    upper: Rational,
}

/// `C(n, 0), …, C(n, n)`.
fn binomials(n: usize) -> Vec<Integer> {
    let mut row = vec![integer(1)];
    for k in 0..n {
        row.push(&row[k] * (n - k) / (k + 1));
    }
    row
}

enum Task {
    Interval(Local),
    Root(Rational),
}

fn isolate(
    polynomial: &Arc<Polynomial<Integer>>,
    lower: &Rational,
    upper: &Rational,
    work: &mut Work,
) -> Check<Vec<Real>> {
    let mut roots = Vec::new();
    let degree = polynomial.degree().unwrap_or(0);
    if degree == 0 || !less(lower, upper) {
        return Ok(roots);
    }
    if degree == 1 {
        let root = Rational::new(-polynomial.coefficient(0), polynomial.coefficient(1));
        let inside = less(lower, &root) && less(&root, upper);
        return Ok(if inside { vec![Real::Rational(root)] } else { roots });
    }
    let mut todo = vec![Task::Interval(Local::new(polynomial, lower, upper, work)?)];
    while let Some(task) = todo.pop() {
        match task {
            Task::Root(x) => roots.push(Real::Rational(x)),
            Task::Interval(local) => match local.variations() {
                0 => {}
                1 if local.ends_are_no_roots() => {
                    roots.push(Real::Root(Root::new(polynomial, local.lower, local.upper)));
                }
                _ => local.split_onto(&mut todo, work)?,
            },
        }
    }
    Ok(roots)
}

impl Local {
    fn new(
        polynomial: &Polynomial<Integer>,
        lower: &Rational,
        upper: &Rational,
        work: &mut Work,
    ) -> Check<Self> {
        let mut moved = moved_to_unit(polynomial, lower, upper, work)?;
        // If p(y) = Σ_k b_k C(n,k) y^k (1-y)^(n-k), then (1+z)^n p(1/(1+z)) = Σ_k b_(n-k) C(n,k) z^k.
        moved.reverse();
        shift_by_one(&mut moved, work)?;
        moved.reverse();
        let binomials = binomials(moved.len() - 1);
        let common = binomials.iter().fold(integer(1), |c, b| least_common_multiple(&c, b));
        work.products(4 * moved.len(), largest_bits(&moved), common.bits() * 64)?;
        let scaled = moved.iter().zip(&binomials).map(|(c, b)| c * (&common / b)).collect();
        let mut local = Local { coefficients: scaled, lower: lower.clone(), upper: upper.clone() };
        strip_twos(&mut local.coefficients);
        Ok(local)
    }

    /// Descartes' bound for the number of roots in the open interval; exact if it is 0 or 1.
    fn variations(&self) -> usize {
        let signs = self.coefficients.iter().map(Ordered::compare_to_zero).filter(|s| s.is_ne());
        let mut count = 0;
        let mut last = None;
        for sign in signs {
            count += usize::from(last.is_some_and(|l| l != sign));
            last = Some(sign);
        }
        count
    }

    fn ends_are_no_roots(&self) -> bool {
        let ends = [self.coefficients.first(), self.coefficients.last()];
        ends.into_iter().flatten().all(|c| !c.is_zero())
    }

    /// Puts the right half, the middle if it is a root, and the left half on the stack, by the
    /// algorithm of de Casteljau.
    fn split_onto(self, todo: &mut Vec<Task>, work: &mut Work) -> Check<()> {
        let mut right = self.coefficients;
        let n = right.len() - 1;
        work.products(n * n / 2, largest_bits(&right) + n as u64, 1)?;
        // Sums in place of means: after k steps times 2^k.
        let mut left = Vec::with_capacity(n + 1);
        for k in 0..=n {
            left.push(&right[0] << (n - k));
            for i in 0..n - k {
                let (low, high) = right.split_at_mut(i + 1);
                low[i] += &high[0];
            }
        }
        for (k, c) in right.iter_mut().enumerate() {
            *c <<= k;
        }
        let on_middle = right[0].is_zero();
        let middle = (&self.lower + &self.upper) / integer(2);
        for half in [&mut left, &mut right] {
            strip_twos(half);
        }
        let upper = Local { coefficients: right, lower: middle.clone(), upper: self.upper };
        let lower = Local { coefficients: left, lower: self.lower, upper: middle.clone() };
        todo.push(Task::Interval(upper));
        if on_middle {
            todo.push(Task::Root(middle));
        }
        todo.push(Task::Interval(lower));
        Ok(())
    }
}

/// `e^n p((a + w y)/e)` for the interval from `a/e` to `(a+w)/e`, by Horner's rule.
fn moved_to_unit(
    polynomial: &Polynomial<Integer>,
    lower: &Rational,
    upper: &Rational,
    work: &mut Work,
) -> Check<Vec<Integer>> {
    let common = lower.denom() * upper.denom();
    let start = lower.numer() * upper.denom();
    let width = upper.numer() * lower.denom() - &start;
    let n = polynomial.coefficients().len();
    let bits = largest_bits([&common, &start, &width]);
    let size = polynomial_bits(polynomial).saturating_add(bits.saturating_mul(n as u64));
    work.products(n * n, size, bits)?;
    let mut moved: Vec<Integer> = Vec::with_capacity(n);
    let mut power = integer(1);
    for c in polynomial.coefficients().iter().rev() {
        moved.push(Integer::zero());
        for k in (0..moved.len()).rev() {
            let below = if k > 0 { &moved[k - 1] * &width } else { c * &power };
            moved[k] = &moved[k] * &start + below;
        }
        power *= &common;
    }
    Ok(moved)
}

/// Divides by the largest power of two that divides all.
fn strip_twos(coefficients: &mut [Integer]) {
    let twos = coefficients.iter().filter_map(Integer::trailing_zeros).min().unwrap_or(0);
    coefficients.iter_mut().for_each(|c| *c >>= twos);
}

/// `p(y) → p(y + 1)`.
fn shift_by_one(coefficients: &mut [Integer], work: &mut Work) -> Check<()> {
    let n = coefficients.len();
    work.products(n * n / 2, largest_bits(coefficients.iter()) + n as u64, 1)?;
    for i in 0..n {
        for j in (i..n - 1).rev() {
            let (low, high) = coefficients.split_at_mut(j + 1);
            low[j] += &high[0];
        }
    }
    Ok(())
}
