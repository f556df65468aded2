//! Greatest common divisors of integer polynomials from images modulo primes.
//!
//! For a prime `p` that divides neither leading coefficient, the gcd modulo `p` has at least the
//! degree of the true one. So a common divisor of that degree, found by the Chinese remainder
//! theorem and confirmed by division, is the greatest.

use refinable_algebra::{Domain, GcdDomain, Integer, Ordered, Polynomial, Ring, integer};

use crate::modular::{Image, Primes, residue};
use crate::work::{Check, Work, polynomial_bits};

/// The primitive greatest common divisor with a positive leading coefficient, of two polynomials
/// that are not zero.
pub(crate) fn greatest_common_divisor(
    a: &Polynomial<Integer>,
    b: &Polynomial<Integer>,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let (a, b) = (primitive(a, work)?, primitive(b, work)?);
    let (Some(lead_a), Some(lead_b)) = (a.leading(), b.leading()) else {
        return Ok(Polynomial::one());
    };
    let lead = lead_a.gcd(lead_b);
    let mut lift: Option<Lift> = None;
    for p in Primes::below_power_of_two() {
        if residue(lead_a, p) == 0 || residue(lead_b, p) == 0 {
            continue;
        }
        let size = a.coefficients().len().max(b.coefficients().len());
        work.spend((size * size) as u64 * 8 + size as u64 * (polynomial_bits(&a) / 16 + 20))?;
        let image = Image::new(&a, p).gcd(Image::new(&b, p));
        if image.degree() == 0 {
            return Ok(Polynomial::one());
        }
        let image = image.scaled(residue(&lead, p));
        let stable = match &mut lift {
            Some(old) if old.degree() < image.degree() => continue,
            Some(old) if old.degree() == image.degree() => old.join(&image, work)?,
            _ => {
                lift = Some(Lift::new(&image));
                true
            }
        };
        let Some(candidate) = lift.as_ref().filter(|_| stable) else { continue };
        let candidate = primitive(&candidate.symmetric(), work)?;
        if divides(&candidate, &a, work)? && divides(&candidate, &b, work)? {
            return Ok(candidate);
        }
    }
    unreachable!("the iterator over primes does not end before the work does")
}

/// The product of the distinct irreducible factors, primitive, of a polynomial that is not zero.
pub(crate) fn square_free_part(
    polynomial: &Polynomial<Integer>,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let polynomial = primitive(polynomial, work)?;
    if polynomial.degree().is_none_or(|d| d < 2) {
        return Ok(polynomial);
    }
    let repeated = greatest_common_divisor(&polynomial, &polynomial.derivative(), work)?;
    if repeated.is_constant() {
        return Ok(polynomial);
    }
    spend_division(&polynomial, &repeated, work)?;
    primitive(&polynomial.quotient(&repeated), work)
}

/// The polynomial over the gcd of its coefficients, with a positive leading one.
pub(crate) fn primitive(
    polynomial: &Polynomial<Integer>,
    work: &mut Work,
) -> Check<Polynomial<Integer>> {
    let bits = polynomial_bits(polynomial);
    work.products(polynomial.coefficients().len(), bits, bits)?;
    Ok(polynomial.primitive_part())
}

fn divides(
    divisor: &Polynomial<Integer>,
    polynomial: &Polynomial<Integer>,
    work: &mut Work,
) -> Check<bool> {
    spend_division(polynomial, divisor, work)?;
    Ok(polynomial.divide_exactly(divisor).is_some())
}

fn spend_division(
    polynomial: &Polynomial<Integer>,
    divisor: &Polynomial<Integer>,
    work: &mut Work,
) -> Check<()> {
    let (n, m) = (polynomial.coefficients().len(), divisor.coefficients().len());
    let bits = polynomial_bits(polynomial) + polynomial_bits(divisor);
    work.products(n * (n + m), bits, 64)?;
    work.products(n * m, bits, polynomial_bits(divisor))
}

/// A polynomial modulo a product of primes.
struct Lift {
    modulus: Integer,
    coefficients: Vec<Integer>,
}

impl Lift {
    fn new(image: &Image) -> Self {
        let coefficients = image.coefficients().iter().map(|&c| Integer::from(c)).collect();
        Lift { modulus: Integer::from(image.prime()), coefficients }
    }

    fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// Adds the information modulo one more prime; whether the symmetric lift stays the same.
    fn join(&mut self, image: &Image, work: &mut Work) -> Check<bool> {
        work.products(self.coefficients.len() * 3, self.modulus.bits(), 64)?;
        let before = self.symmetric();
        let p = image.prime();
        let inverse = image.inverse(residue(&self.modulus, p));
        for (c, &r) in self.coefficients.iter_mut().zip(image.coefficients()) {
            let step = image.times(image.minus(r, residue(c, p)), inverse);
            *c += &self.modulus * step;
        }
        self.modulus *= p;
        Ok(self.symmetric() == before)
    }

    /// The representatives of least absolute value.
    fn symmetric(&self) -> Polynomial<Integer> {
        let two = integer(2);
        let centred = self.coefficients.iter().map(|c| {
            let high = (c * &two - &self.modulus).compare_to_zero().is_gt();
            if high { c - &self.modulus } else { c.clone() }
        });
        Polynomial::new(centred.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    /// `x + c`.
    fn line(c: Integer) -> Polynomial<Integer> {
        Polynomial::new(vec![c, integer(1)])
    }

    fn gcd(a: &Polynomial<Integer>, b: &Polynomial<Integer>) -> Polynomial<Integer> {
        greatest_common_divisor(a, b, &mut Work::new()).unwrap()
    }

    /// Products with a common factor that no single prime holds, of either sign.
    #[test]
    fn coefficients_longer_than_several_primes() {
        let long = |bits: usize| integer(1) << bits;
        let common = Polynomial::new(vec![
            long(200) + integer(3),
            -long(150),
            integer(0),
            long(70) + integer(1),
        ]);
        let [a, b] = [[1, 0, 7], [5, -2, 3]].map(|c| common.times(&polynomial(&c)));
        assert_eq!(gcd(&a, &b), common);
        assert_eq!(gcd(&a.times(&polynomial(&[-6])), &b.times(&polynomial(&[10]))), common);
        assert_eq!(gcd(&a, &polynomial(&[5, -2, 3])), polynomial(&[1]));
    }

    /// `x + p` and `x` are the same modulo `p`: the first prime sees too much, or, if more are needed for long coefficients,
    /// a later one.
    #[test]
    fn primes_modulo_which_the_gcd_is_larger() {
        let primes: Vec<u64> = Primes::below_power_of_two().take(3).collect();
        let x = line(integer(0));
        for common in [polynomial(&[1, 1]), line((integer(1) << 150) - integer(1))] {
            for chosen in [vec![0], vec![1], vec![2], vec![0, 1], vec![0, 2]] {
                let product: Integer = chosen.iter().map(|&k| Integer::from(primes[k])).product();
                let [a, b] = [&x, &line(product)].map(|factor| common.times(factor));
                assert_eq!(gcd(&a, &b), common, "{chosen:?}");
            }
        }
        // Both leading coefficients vanish modulo the first prime.
        let lead = |c: i64| Polynomial::new(vec![integer(c), Integer::from(primes[0])]);
        assert_eq!(gcd(&lead(1).times(&x), &lead(1).times(&lead(2))), lead(1));
        assert_eq!(gcd(&lead(1), &lead(2)), polynomial(&[1]));
    }

    #[test]
    fn square_free_parts() {
        let work = &mut Work::new();
        let [a, b] = [polynomial(&[-1, 3]), polynomial(&[2, 0, 1])];
        let product = a.power(3).times(&b.power(2)).times(&polynomial(&[-4]));
        assert_eq!(square_free_part(&product, work), Ok(a.times(&b)));
        assert_eq!(square_free_part(&a.times(&polynomial(&[-2])), work), Ok(a));
    }
}
