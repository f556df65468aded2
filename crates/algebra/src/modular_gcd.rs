//! Greatest common divisors of integer polynomials from images modulo primes.
//!
//! For a prime that does not divide both leading coefficients, the gcd of the images has at least the
//! degree of the true one. So a common divisor of the same degree, found by the Chinese remainder
//! theorem and confirmed by division, is the greatest. Polynomials without a common divisor, the usual
//! case, need one prime.
//!
//! Source: J. von zur Gathen, J. Gerhard, *Modern Computer Algebra*, Algorithm 6.38.

use crate::modular::{Image, inverse, large_primes, minus, residue, times};
use crate::number::{Integer, integer};
use crate::polynomial::Polynomial;
use crate::ring::{Domain, GcdDomain, Ordered, Ring};

/// The primitive gcd with a positive leading coefficient, of primitive polynomials that are not zero.
///
/// # Cost
/// `O(deg²)` machine operations for each prime; the primes have so many bits together as the result,
/// times the gcd of the leading coefficients, and two primes more.
pub(crate) fn gcd_by_images(
    a: &Polynomial<Integer>,
    b: &Polynomial<Integer>,
) -> Polynomial<Integer> {
    let leads = [a, b].map(|p| p.leading().expect("the polynomials are not zero"));
    let lead = leads[0].gcd(leads[1]);
    let mut lift: Option<Lift> = None;
    for p in large_primes().filter(|p| residue(&lead, *p) != 0) {
        let image = Image::new(a, p).gcd(&Image::new(b, p)).scaled(residue(&lead, p));
        let degree = image.coefficients().len() - 1;
        if degree == 0 {
            return Polynomial::one();
        }
        match &mut lift {
            // The prime is one of the few that lead to a wrong degree.
            Some(lift) if lift.degree() < degree => {}
            Some(lift) if lift.degree() == degree => {
                // Division is tried when one more prime tells nothing new.
                if lift.join(&image) {
                    continue;
                }
                let candidate = lift.symmetric().primitive_part();
                if [a, b].iter().all(|p| p.divide_exactly(&candidate).is_some()) {
                    return candidate;
                }
            }
            _ => lift = Some(Lift::new(&image)),
        }
    }
    unreachable!("only finitely many primes lead to a wrong degree")
}

/// A polynomial modulo a product of primes.
struct Lift {
    modulus: Integer,
    coefficients: Vec<Integer>,
}

impl Lift {
    fn new(image: &Image) -> Self {
        let coefficients = image.coefficients().iter().map(|c| Integer::from(*c)).collect();
        Lift { modulus: Integer::from(image.prime()), coefficients }
    }

    fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// Adds what is known modulo one more prime; whether the symmetric representatives change.
    fn join(&mut self, image: &Image) -> bool {
        let before = self.symmetric();
        let p = image.prime();
        let inverse = inverse(residue(&self.modulus, p), p);
        for (c, r) in self.coefficients.iter_mut().zip(image.coefficients()) {
            *c += &self.modulus * times(minus(*r, residue(c, p), p), inverse, p);
        }
        self.modulus *= p;
        self.symmetric() != before
    }

    /// The representatives of least absolute value.
    fn symmetric(&self) -> Polynomial<Integer> {
        let centred = self.coefficients.iter().map(|c| {
            let high = (c * integer(2) - &self.modulus).compare_to_zero().is_gt();
            if high { c - &self.modulus } else { c.clone() }
        });
        Polynomial::new(centred.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::division::gcd_by_subresultants;
    use crate::ring::Ring;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    /// Coefficients of more than 62 bits, of both signs, so that several primes are needed.
    #[test]
    fn many_primes_give_what_subresultants_give() {
        let common = poly(&[-98_765, 4_321, 7]).power(9);
        let a = common.times(&poly(&[5, 0, -3, 11]).power(4));
        let b = common.times(&poly(&[1, -1_000_003]).power(5));
        assert_eq!(gcd_by_images(&a, &b), common);
        assert_eq!(gcd_by_subresultants(&a, &b), common);
    }

    /// Modulo the first prime the two have a common root that is not one over Z.
    #[test]
    fn a_prime_that_leads_to_a_wrong_degree_does_no_harm() {
        let p = large_primes().next().map(Integer::from).expect("there are primes");
        let common = poly(&[3, 1, 2]);
        let [a, b] =
            [integer(0), p].map(|zero| common.times(&Polynomial::new(vec![zero, integer(1)])));
        assert_eq!(gcd_by_images(&a, &b), common);
        assert_eq!(gcd_by_images(&b, &a), common);
    }
}
