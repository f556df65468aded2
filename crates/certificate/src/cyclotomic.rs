//! Cyclotomic polynomials.

use refinable_algebra::{Integer, Polynomial, Ring, integer};

use crate::work::{Check, Work};

/// The odd `r ≥ 3` with `φ(r) ≤ bound`.
///
/// For odd `r`, `φ(r) ≥ √r`: so `r ≤ bound²`.
pub(crate) fn odd_orders(bound: usize, work: &mut Work) -> Check<Vec<usize>> {
    orders(3, bound * bound, bound, work)
}

/// The even `r` with `φ(r) ≤ bound`.
///
/// For even `r`, `φ(r) ≥ √(r/2)`: so `r ≤ 2 bound²`.
pub(crate) fn even_orders(bound: usize, work: &mut Work) -> Check<Vec<usize>> {
    orders(2, 2 * bound * bound, bound, work)
}

/// The numbers `r` from `first` to `last` in steps of two with `φ(r) ≤ bound`.
fn orders(first: usize, last: usize, bound: usize, work: &mut Work) -> Check<Vec<usize>> {
    work.spend(20 * last as u64)?;
    let mut totients: Vec<usize> = (0..=last).collect();
    for p in 2..=last {
        if totients[p] == p {
            for multiple in (p..=last).step_by(p) {
                totients[multiple] -= totients[multiple] / p;
            }
        }
    }
    Ok((first..=last).step_by(2).filter(|&r| totients[r] <= bound).collect())
}

/// `Φ_r = Π_{d | r} (1 - z^(r/d))^μ(d)` for `r > 1`, as a power series up to its degree.
pub(crate) fn cyclotomic(r: usize, work: &mut Work) -> Check<Polynomial<Integer>> {
    let primes = prime_divisors(r);
    let degree = primes.iter().fold(r, |n, p| n / p * (p - 1));
    work.products((degree + 1) << primes.len(), 256, 1)?;
    let mut series = vec![Integer::zero(); degree + 1];
    series[0] = integer(1);
    for subset in 0..1_usize << primes.len() {
        let chosen = primes.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1);
        let step = r / chosen.map(|(_, p)| p).product::<usize>();
        if subset.count_ones().is_multiple_of(2) {
            for k in (step..=degree).rev() {
                let (low, high) = series.split_at_mut(k);
                high[0] -= &low[k - step];
            }
        } else {
            for k in step..=degree {
                let (low, high) = series.split_at_mut(k);
                high[0] += &low[k - step];
            }
        }
    }
    Ok(Polynomial::new(series))
}

fn prime_divisors(mut n: usize) -> Vec<usize> {
    let mut primes = Vec::new();
    let mut p = 2;
    while p * p <= n {
        if n.is_multiple_of(p) {
            primes.push(p);
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        p += 1;
    }
    if n > 1 {
        primes.push(n);
    }
    primes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_cyclotomic_polynomials() {
        let work = &mut Work::new();
        let poly = |c: &[i64]| Polynomial::new(c.iter().map(|&c| integer(c)).collect());
        assert_eq!(cyclotomic(3, work).unwrap(), poly(&[1, 1, 1]));
        assert_eq!(cyclotomic(9, work).unwrap(), poly(&[1, 0, 0, 1, 0, 0, 1]));
        assert_eq!(cyclotomic(15, work).unwrap(), poly(&[1, -1, 0, 1, -1, 1, 0, -1, 1]));
        // The first with a coefficient other than 0 and ±1.
        assert_eq!(cyclotomic(105, work).unwrap().coefficient(7), integer(-2));
        assert_eq!(odd_orders(6, work).unwrap(), [3, 5, 7, 9]);
        assert_eq!(odd_orders(1, work).unwrap(), [0; 0]);
        assert_eq!(cyclotomic(2, work).unwrap(), poly(&[1, 1]));
        assert_eq!(cyclotomic(8, work).unwrap(), poly(&[1, 0, 0, 0, 1]));
        assert_eq!(cyclotomic(12, work).unwrap(), poly(&[1, 0, -1, 0, 1]));
        assert_eq!(even_orders(2, work).unwrap(), [2, 4, 6]);
        assert_eq!(even_orders(4, work).unwrap(), [2, 4, 6, 8, 10, 12]);
        assert_eq!(even_orders(0, work).unwrap(), [0; 0]);
    }

    /// Against `φ(r)` by counting: no order is too large to be looked at, 105 with `φ = 48` and 30 with `φ = 8` among
    /// them.
    #[test]
    fn all_orders_of_small_degree_are_found() {
        let totient = |r: usize| (1..=r).filter(|k| greatest_common(*k, r) == 1).count();
        let work = &mut Work::new();
        for bound in [1, 2, 8, 48] {
            let all = |first: usize| -> Vec<usize> {
                (first..2 * bound * bound + 9).step_by(2).filter(|&r| totient(r) <= bound).collect()
            };
            assert_eq!(odd_orders(bound, work).unwrap(), all(3), "{bound}");
            assert_eq!(even_orders(bound, work).unwrap(), all(2), "{bound}");
        }
    }

    fn greatest_common(a: usize, b: usize) -> usize {
        if b == 0 { a } else { greatest_common(b, a % b) }
    }
}
