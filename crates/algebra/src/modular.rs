//! Polynomials modulo a prime: images of integer polynomials, in which degrees of factors and of
//! common divisors are seen quickly.
//!
//! A factor over Z of degree `k` has a leading coefficient that divides that of the polynomial. So
//! modulo a prime that does not divide the latter it is a factor of degree `k` again, and splits
//! into irreducible ones of degrees `j ≤ k`, which divide `x^(p^j) - x`.

use std::sync::LazyLock;

use crate::number::Integer;
use crate::polynomial::Polynomial;
use crate::ring::Ring;

/// The largest primes below `2^62`, so many as are mostly enough.
static LARGE_PRIMES: LazyLock<Vec<u64>> =
    LazyLock::new(|| primes_below(1 << 62).take(32).collect());

/// The primes below `2^62`, from above.
pub(crate) fn large_primes() -> impl Iterator<Item = u64> {
    let last = LARGE_PRIMES[LARGE_PRIMES.len() - 1];
    LARGE_PRIMES.iter().copied().chain(primes_below(last))
}

fn primes_below(bound: u64) -> impl Iterator<Item = u64> {
    (3..bound).rev().filter(|n| is_prime(*n))
}

/// Miller's test with the first twelve primes, which decides below `3·10^24` (Sorenson and Webster
/// 2017).
fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if BASES.iter().any(|&b| n.is_multiple_of(b)) {
        return BASES.contains(&n);
    }
    let twos = (n - 1).trailing_zeros();
    let odd = (n - 1) >> twos;
    BASES.iter().all(|&base| {
        let mut x = power(base, odd, n);
        x == 1
            || (0..twos).any(|_| {
                let found = x == n - 1;
                x = times(x, x, n);
                found
            })
    })
}

/// Primes near 1000: large enough that chance factors are rare, small enough for cheap products.
const PRIMES: [u64; 24] = [
    1009, 1013, 1019, 1021, 1031, 1033, 1039, 1049, 1051, 1061, 1063, 1069, 1087, 1091, 1093, 1097,
    1103, 1109, 1117, 1123, 1129, 1151, 1153, 1163,
];

impl Polynomial<Integer> {
    /// Whether it is certain, from its images modulo a few primes, that no polynomial of degree
    /// 1 to `degree` divides this one over Q. A `false` says nothing.
    ///
    /// # Cost
    /// `O(deg² · degree · log p)` machine operations for each of at most 24 primes.
    pub fn surely_has_no_factor_up_to(&self, degree: usize) -> bool {
        PRIMES.iter().any(|&p| {
            let image = Image::new(self, p);
            image.coefficients.len() == self.coefficients().len()
                && image.has_no_factor_up_to(degree)
        })
    }
}

/// `c` modulo `p`, in `0..p`.
pub(crate) fn residue(c: &Integer, p: u64) -> u64 {
    let modulus = Integer::from(p);
    let r = c % &modulus;
    let r = if r < Integer::zero() { r + &modulus } else { r };
    u64::try_from(r).expect("a residue is smaller than the prime")
}

/// A polynomial over the field of `p` elements, the last coefficient nonzero.
#[derive(Clone)]
pub(crate) struct Image {
    p: u64,
    coefficients: Vec<u64>,
}

impl Image {
    /// The polynomial modulo `p`.
    pub fn new(polynomial: &Polynomial<Integer>, p: u64) -> Self {
        Image::trimmed(p, polynomial.coefficients().iter().map(|c| residue(c, p)).collect())
    }

    /// The coefficients in ascending order.
    pub fn coefficients(&self) -> &[u64] {
        &self.coefficients
    }

    /// The prime.
    pub fn prime(&self) -> u64 {
        self.p
    }

    fn trimmed(p: u64, mut coefficients: Vec<u64>) -> Self {
        while coefficients.last() == Some(&0) {
            coefficients.pop();
        }
        Image { p, coefficients }
    }

    fn has_no_factor_up_to(&self, degree: usize) -> bool {
        if self.coefficients.len() <= 1 {
            return true;
        }
        let x = Image { p: self.p, coefficients: vec![0, 1] };
        let mut frobenius = x.remainder(self);
        (0..degree).all(|_| {
            frobenius = frobenius.power_modulo(self.p, self);
            self.gcd(&frobenius.minus(&x)).coefficients.len() == 1
        })
    }

    fn minus(&self, other: &Self) -> Self {
        let length = self.coefficients.len().max(other.coefficients.len());
        let at = |c: &[u64], k: usize| c.get(k).copied().unwrap_or(0);
        let difference = |k| minus(at(&self.coefficients, k), at(&other.coefficients, k), self.p);
        Image::trimmed(self.p, (0..length).map(difference).collect())
    }

    fn times(&self, other: &Self) -> Self {
        if self.coefficients.is_empty() || other.coefficients.is_empty() {
            return Image { p: self.p, coefficients: Vec::new() };
        }
        let mut product = vec![0; self.coefficients.len() + other.coefficients.len() - 1];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] = (product[i + j] + times(*a, *b, self.p)) % self.p;
            }
        }
        Image::trimmed(self.p, product)
    }

    /// `c · self`.
    pub fn scaled(&self, c: u64) -> Self {
        let scaled = self.coefficients.iter().map(|a| times(*a, c, self.p));
        Image::trimmed(self.p, scaled.collect())
    }

    /// `self mod divisor`, the divisor not zero.
    fn remainder(&self, divisor: &Self) -> Self {
        let length = divisor.coefficients.len();
        let inverse = inverse(divisor.coefficients[length - 1], self.p);
        let mut rest = self.coefficients.clone();
        while rest.len() >= length {
            let shift = rest.len() - length;
            let factor = times(rest[rest.len() - 1], inverse, self.p);
            for (r, c) in rest[shift..].iter_mut().zip(&divisor.coefficients) {
                *r = minus(*r, times(factor, *c, self.p), self.p);
            }
            rest.pop();
        }
        Image::trimmed(self.p, rest)
    }

    fn power_modulo(&self, exponent: u64, modulus: &Self) -> Self {
        let mut result = Image { p: self.p, coefficients: vec![1] }.remainder(modulus);
        let (mut square, mut rest) = (self.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = result.times(&square).remainder(modulus);
            }
            square = square.times(&square).remainder(modulus);
            rest /= 2;
        }
        result
    }

    /// A greatest common divisor, monic if it is not zero.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.coefficients.is_empty() {
            let rest = a.remainder(&b);
            (a, b) = (b, rest);
        }
        a.coefficients.last().map_or_else(|| a.clone(), |lead| a.scaled(inverse(*lead, self.p)))
    }
}

/// `a b` in the field.
pub(crate) fn times(a: u64, b: u64, p: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(p)) as u64
}

/// `a - b` in the field.
pub(crate) fn minus(a: u64, b: u64, p: u64) -> u64 {
    if a >= b { a - b } else { a + (p - b) }
}

/// `1/a` in the field, by Fermat's theorem.
pub(crate) fn inverse(a: u64, p: u64) -> u64 {
    power(a, p - 2, p)
}

fn power(base: u64, exponent: u64, p: u64) -> u64 {
    let (mut result, mut square, mut rest) = (1, base % p, exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            result = times(result, square, p);
        }
        square = times(square, square, p);
        rest /= 2;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::integer;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn the_first_large_primes_are_the_known_ones() {
        // 2^62 - 57 is the largest prime below 2^62, and 2^62 - 87 the next.
        assert!(large_primes().take(2).eq([(1 << 62) - 57, (1 << 62) - 87]));
        assert_eq!(primes_below(1010).take(2).collect::<Vec<_>>(), [1009, 997]);
        // Where the list goes on, nothing is missing and nothing twice.
        assert!(large_primes().take(40).eq(primes_below(1 << 62).take(40)));
    }

    #[test]
    fn factors_that_exist_are_never_denied() {
        let quintic = poly(&[-1, -1, 0, 0, 0, 1]); // x⁵ - x - 1 is irreducible
        assert!(!poly(&[-7, 3]).times(&quintic).surely_has_no_factor_up_to(1));
        let quadratic = poly(&[5, 1, 11]);
        assert!(!quadratic.times(&quintic).surely_has_no_factor_up_to(2));
        assert!(quadratic.times(&quintic).surely_has_no_factor_up_to(1));
    }

    #[test]
    fn irreducible_polynomials_are_recognised() {
        assert!(poly(&[-1, -1, 0, 0, 0, 1]).surely_has_no_factor_up_to(2));
        assert!(poly(&[-2, 0, 0, 1]).surely_has_no_factor_up_to(1));
        // x⁴ + 1 is irreducible over Q, but splits into quadratics modulo every prime.
        assert!(!poly(&[1, 0, 0, 0, 1]).surely_has_no_factor_up_to(2));
        assert!(poly(&[1, 0, 0, 0, 1]).surely_has_no_factor_up_to(1));
    }
}
