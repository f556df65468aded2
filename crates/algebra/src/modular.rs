//! Polynomials modulo a small prime, for one purpose: to see quickly that an integer polynomial has
//! no factor of low degree.
//!
//! A factor over Z of degree `k` has a leading coefficient that divides that of the polynomial. So
//! modulo a prime that does not divide the latter it is a factor of degree `k` again, and splits
//! into irreducible ones of degrees `j ≤ k`, which divide `x^(p^j) - x`.

use crate::number::Integer;
use crate::polynomial::Polynomial;
use crate::ring::Ring;

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

/// A polynomial over the field of `p` elements, the last coefficient nonzero.
#[derive(Clone)]
struct Image {
    p: u64,
    coefficients: Vec<u64>,
}

impl Image {
    fn new(polynomial: &Polynomial<Integer>, p: u64) -> Self {
        let modulus = Integer::from(p);
        let residue = |c: &Integer| {
            let r = c % &modulus;
            let r = if r < Integer::zero() { r + &modulus } else { r };
            u64::try_from(r).expect("a residue is smaller than the prime")
        };
        Image::trimmed(p, polynomial.coefficients().iter().map(residue).collect())
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
        let difference =
            |k| (at(&self.coefficients, k) + self.p - at(&other.coefficients, k)) % self.p;
        Image::trimmed(self.p, (0..length).map(difference).collect())
    }

    fn times(&self, other: &Self) -> Self {
        if self.coefficients.is_empty() || other.coefficients.is_empty() {
            return Image { p: self.p, coefficients: Vec::new() };
        }
        let mut product = vec![0; self.coefficients.len() + other.coefficients.len() - 1];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] = (product[i + j] + a * b) % self.p;
            }
        }
        Image::trimmed(self.p, product)
    }

    /// `self mod divisor`, the divisor not zero.
    fn remainder(&self, divisor: &Self) -> Self {
        let length = divisor.coefficients.len();
        let inverse = power(divisor.coefficients[length - 1], self.p - 2, self.p);
        let mut rest = self.coefficients.clone();
        while rest.len() >= length {
            let shift = rest.len() - length;
            let factor = rest[rest.len() - 1] * inverse % self.p;
            for (r, c) in rest[shift..].iter_mut().zip(&divisor.coefficients) {
                *r = (*r + (self.p - factor) * c) % self.p;
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

    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.coefficients.is_empty() {
            (a, b) = (b.clone(), a.remainder(&b));
        }
        a
    }
}

fn power(base: u64, exponent: u64, p: u64) -> u64 {
    let (mut result, mut square, mut rest) = (1, base, exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            result = result * square % p;
        }
        square = square * square % p;
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
