//! Polynomials and determinants over a prime field of about `2^62` elements, and the way back.

use refinable_algebra::{Integer, Ordered, Polynomial, Ring, integer};

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

/// `a · b` modulo one of the [`Primes`], or another number between `2^62 - 2^31` and `2^62`.
fn times(a: u64, b: u64, p: u64) -> u64 {
    // 2^62 is this small number: after the first step less than 2^94, then less than 2^64.
    let fold = u128::from((1_u64 << 62) - p);
    let low = (1_u128 << 62) - 1;
    let x = u128::from(a) * u128::from(b);
    let x = (x >> 62) * fold + (x & low);
    let mut x = ((x >> 62) * fold + (x & low)) as u64;
    while x >= p {
        x -= p;
    }
    x
}

fn plus(a: u64, b: u64, p: u64) -> u64 {
    let sum = a + b;
    if sum >= p { sum - p } else { sum }
}

fn minus(a: u64, b: u64, p: u64) -> u64 {
    if a >= b { a - b } else { a + (p - b) }
}

/// `1/a`, by Fermat's theorem.
fn inverse(a: u64, p: u64) -> u64 {
    power(a, p - 2, p)
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
        minus(a, b, self.p)
    }

    /// `1/a` in the field.
    pub fn inverse(&self, a: u64) -> u64 {
        inverse(a, self.p)
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

/// The coefficients of the determinant of a matrix of polynomials modulo `p`, of which the degree is
/// known not to exceed `degree`.
pub(crate) fn determinant(size: usize, entries: &[Vec<u64>], degree: usize, p: u64) -> Vec<u64> {
    let at = |x: u64| {
        let horner = |e: &Vec<u64>| e.iter().rev().fold(0, |sum, &c| plus(times(sum, x, p), c, p));
        determinant_of_numbers(size, entries.iter().map(horner).collect(), p)
    };
    interpolate((0..=degree as u64).map(at).collect(), p)
}

/// By the method of Gauss.
fn determinant_of_numbers(size: usize, mut matrix: Vec<u64>, p: u64) -> u64 {
    let mut product = 1;
    for k in 0..size {
        let Some(pivot) = (k..size).find(|i| matrix[i * size + k] != 0) else { return 0 };
        if pivot != k {
            (k..size).for_each(|j| matrix.swap(pivot * size + j, k * size + j));
            product = minus(0, product, p);
        }
        let (above, below) = matrix.split_at_mut((k + 1) * size);
        let row = &above[k * size..];
        product = times(product, row[k], p);
        let inverse = inverse(row[k], p);
        for other in below.chunks_mut(size).filter(|other| other[k] != 0) {
            let factor = times(other[k], inverse, p);
            for j in k + 1..size {
                other[j] = minus(other[j], times(factor, row[j], p), p);
            }
        }
    }
    product
}

/// The coefficients of the polynomial of degree at most `n` with the values at `0, 1, …, n`, by
/// Newton's form `Σ_k Δ^k/k! x (x - 1) ⋯ (x - k + 1)`.
fn interpolate(mut values: Vec<u64>, p: u64) -> Vec<u64> {
    let n = values.len() - 1;
    for step in 1..=n {
        for k in (step..=n).rev() {
            values[k] = minus(values[k], values[k - 1], p);
        }
    }
    let factorial = (1..=n as u64).fold(1, |product, k| times(product, k, p));
    let mut quotient = inverse(factorial, p);
    let mut sum: Vec<u64> = Vec::with_capacity(n + 1);
    for k in (0..=n).rev() {
        // sum · (x - k) + Δ^k/k!
        sum.push(0);
        for j in (0..sum.len()).rev() {
            let below = if j > 0 { sum[j - 1] } else { times(values[k], quotient, p) };
            sum[j] = minus(below, times(sum[j], k as u64, p), p);
        }
        quotient = times(quotient, k as u64, p);
    }
    sum
}

/// Integers modulo a product of primes.
pub(crate) struct Lift {
    /// The product.
    pub modulus: Integer,
    numbers: Vec<Integer>,
}

impl Lift {
    /// From the residues modulo one prime.
    pub fn new(residues: &[u64], p: u64) -> Self {
        let numbers = residues.iter().map(|&c| Integer::from(c)).collect();
        Lift { modulus: Integer::from(p), numbers }
    }

    /// How many numbers there are.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Adds the residues modulo one more prime, by the Chinese remainder theorem.
    pub fn join(&mut self, residues: &[u64], p: u64) {
        let inverse = inverse(residue(&self.modulus, p), p);
        for (c, &r) in self.numbers.iter_mut().zip(residues) {
            let step = times(minus(r, residue(c, p), p), inverse, p);
            *c += &self.modulus * step;
        }
        self.modulus *= p;
    }

    /// The polynomial with the representatives of least absolute value as coefficients.
    pub fn symmetric(&self) -> Polynomial<Integer> {
        let two = integer(2);
        let centred = self.numbers.iter().map(|c| {
            let high = (c * &two - &self.modulus).compare_to_zero().is_gt();
            if high { c - &self.modulus } else { c.clone() }
        });
        Polynomial::new(centred.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_residues() {
        let mut x = 1_u64;
        for p in Primes::below_power_of_two().take(20).chain([(1 << 62) - (1 << 31) + 1]) {
            for _ in 0..200 {
                x = x
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                for (a, b) in [(x % p, x.rotate_left(29) % p), (p - 1, p - 1 - x % 9), (x % p, 0)] {
                    let exact = (u128::from(a) * u128::from(b) % u128::from(p)) as u64;
                    assert_eq!(times(a, b, p), exact);
                }
            }
        }
    }

    #[test]
    fn the_first_prime_is_the_known_one() {
        // 2^62 - 57 is the largest prime below 2^62, and 2^62 - 87 the next.
        let first: Vec<u64> = Primes::below_power_of_two().take(2).collect();
        assert_eq!(first, [(1 << 62) - 57, (1 << 62) - 87]);
    }
}
