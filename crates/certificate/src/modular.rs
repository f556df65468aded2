//! Polynomials over a prime field of about `2^62` elements.

use refinable_algebra::{Integer, Polynomial, Ring};

/// `c` modulo `p`, in `0..p`.
pub(crate) fn residue(c: &Integer, p: u64) -> u64 {
    let modulus = Integer::from(p);
    let r = c % &modulus;
    let r = if r < Integer::zero() { r + &modulus } else { r };
    u64::try_from(r).expect("a residue is smaller than the prime")
}

/// The primes below `2^62`, from above.
pub(crate) struct Primes(u64);

impl Primes {
    /// From the largest one on.
    pub fn below_power_of_two() -> Self {
        Primes((1 << 62) + 1)
    }
}

impl Iterator for Primes {
    type Item = u64;

    fn next(&mut self) -> Option<u64> {
        loop {
            self.0 -= 2;
            if is_prime(self.0) {
                return Some(self.0);
            }
        }
    }
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
        let mut power = power(base, odd, n);
        if power == 1 || power == n - 1 {
            return true;
        }
        (1..twos).any(|_| {
            power = times(power, power, n);
            power == n - 1
        })
    })
}

fn times(a: u64, b: u64, p: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(p)) as u64
}

fn power(base: u64, mut exponent: u64, p: u64) -> u64 {
    let (mut result, mut square) = (1, base % p);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = times(result, square, p);
        }
        square = times(square, square, p);
        exponent /= 2;
    }
    result
}

/// A polynomial over the field of `p` elements, the last coefficient not zero.
pub(crate) struct Image {
    p: u64,
    coefficients: Vec<u64>,
}

impl Image {
    /// The polynomial modulo `p`.
    pub fn new(polynomial: &Polynomial<Integer>, p: u64) -> Self {
        let coefficients = polynomial.coefficients().iter().map(|c| residue(c, p)).collect();
        Image { p, coefficients }.trimmed()
    }

    /// The coefficients in ascending order.
    pub fn coefficients(&self) -> &[u64] {
        &self.coefficients
    }

    /// The prime.
    pub fn prime(&self) -> u64 {
        self.p
    }

    /// The degree; 0 for zero.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// `a · b` in the field.
    pub fn times(&self, a: u64, b: u64) -> u64 {
        times(a, b, self.p)
    }

    /// `a - b` in the field.
    pub fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + (self.p - b) }
    }

    /// `1/a` in the field, by Fermat's theorem.
    pub fn inverse(&self, a: u64) -> u64 {
        power(a, self.p - 2, self.p)
    }

    /// `c · self`.
    pub fn scaled(&self, c: u64) -> Self {
        let coefficients = self.coefficients.iter().map(|&a| self.times(a, c)).collect();
        Image { p: self.p, coefficients }.trimmed()
    }

    /// The monic greatest common divisor, of two polynomials not both zero.
    pub fn gcd(self, other: Image) -> Image {
        let (mut a, mut b) = (self, other);
        while !b.coefficients.is_empty() {
            let b_monic = b.monic();
            let rest = a.remainder(&b_monic);
            (a, b) = (b_monic, rest);
        }
        a.monic()
    }

    fn monic(&self) -> Image {
        match self.coefficients.last() {
            Some(&lead) => self.scaled(self.inverse(lead)),
            None => Image { p: self.p, coefficients: Vec::new() },
        }
    }

    /// The remainder by a monic divisor.
    fn remainder(mut self, divisor: &Image) -> Image {
        let low = divisor.coefficients.len() - 1;
        while self.coefficients.len() > low {
            let top = self.coefficients.pop().expect("longer than the divisor");
            let start = self.coefficients.len() - low;
            for (k, &c) in divisor.coefficients[..low].iter().enumerate() {
                let old = self.coefficients[start + k];
                self.coefficients[start + k] = self.minus(old, self.times(top, c));
            }
        }
        self.trimmed()
    }

    fn trimmed(mut self) -> Self {
        while self.coefficients.last() == Some(&0) {
            self.coefficients.pop();
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_prime_is_the_known_one() {
        // 2^62 - 57 is the largest prime below 2^62, and 2^62 - 87 the next.
        let first: Vec<u64> = Primes::below_power_of_two().take(2).collect();
        assert_eq!(first, [(1 << 62) - 57, (1 << 62) - 87]);
    }

    #[test]
    fn primes_are_told_from_what_looks_like_them() {
        let primes = (2..200).filter(|&n| is_prime(n)).count();
        assert_eq!(primes, 46); // π(200)
        // Chernick's Carmichael number 211 · 421 · 631, and 2^61 - 1, a Mersenne prime.
        assert!(!is_prime(211 * 421 * 631) && is_prime((1 << 61) - 1));
    }

    #[test]
    fn arithmetic_in_the_field() {
        let p = (1 << 62) - 57;
        let field = Image { p, coefficients: Vec::new() };
        for a in [1, 2, 3, 1 << 40, p - 1] {
            assert_eq!(field.times(a, field.inverse(a)), 1);
            assert_eq!(field.minus(field.minus(5, a), 5), p - a);
        }
        assert_eq!([residue(&Integer::from(-1), p), residue(&Integer::from(p), p)], [p - 1, 0]);
    }
}
