//! Stability of the integer shifts of the basic limit function.

use refinable_algebra::{
    GcdDomain, Integer, Ordered, Polynomial, Rational, Ring, integer,
};
use refinable_reals::{RealAlgebraic, real_roots, real_roots_between};

use crate::line::Line;

/// Where on a line of binary masks the shifts may fail to be stable.
pub(crate) enum Instability {
    /// At these `x` at most.
    At(Vec<RealAlgebraic>),
    /// Perhaps everywhere.
    Everywhere,
}

/// The values of `x` at which the shifts may not be stable: a list that contains all exceptional
/// values, and others only where a common zero of both submasks is too near to the unit circle, or a
/// cyclotomic polynomial may split over the field of an irrational value.
///
/// # Source
/// R. Q. Jia, J. Z. Wang, *Stability and linear independence associated with wavelet
/// decompositions*, Proc. AMS 117 (1993).
pub(crate) fn instability(line: &Line) -> Instability {
    if line.arity() != 2 {
        return Instability::Everywhere;
    }
    let symbol = Symbol::new(line);
    let (even, odd) = (symbol.part(0), symbol.part(1));
    let resultant = even.resultant(&odd);
    if resultant.is_zero() {
        return Instability::Everywhere;
    }
    let mut exceptions: Vec<RealAlgebraic> = real_roots(&resultant)
        .iter()
        .map(RealAlgebraic::simplified)
        .filter(|x| vanish_together(&even, &odd, x))
        .collect();
    for order in (3..).step_by(2).take_while(|&r| r <= 3 * symbol.degree() * symbol.degree()) {
        if totient(order) > symbol.degree() {
            continue;
        }
        let phi = cyclotomic(2 * order);
        exceptions.extend(symbol.common_zeros_with(&phi));
        if !generated_by_two(order) {
            let norm = symbol.norm(&phi);
            if norm.is_zero() {
                return Instability::Everywhere;
            }
            let split = real_roots(&norm);
            exceptions.extend(split.iter().map(RealAlgebraic::simplified).filter(|x| x.as_rational().is_none()));
        }
    }
    exceptions.sort();
    exceptions.dedup();
    Instability::At(exceptions)
}

type Bivariate = Polynomial<Polynomial<Integer>>;

/// `a(z)` as a polynomial in `z` over Z\[x\], up to a constant factor and a power of `z`.
struct Symbol(Bivariate);

impl Symbol {
    fn new(line: &Line) -> Self {
        let affine = line.symbol();
        let entries = affine.coefficients().iter().flat_map(Polynomial::coefficients);
        let scale = Rational::from(refinable_algebra::clear_denominators(entries).0);
        Symbol(affine.polynomial().map(|c| c.scaled(&scale).map(Rational::to_integer)))
    }

    fn degree(&self) -> usize {
        self.0.degree().unwrap_or(0)
    }

    /// `Σ a_{2i+parity} w^i` without its powers of `w`.
    fn part(&self, parity: usize) -> Bivariate {
        let coefficients = self.0.coefficients().iter().skip(parity).step_by(2);
        let tail: Vec<_> = coefficients.skip_while(|c| c.is_zero()).cloned().collect();
        Polynomial::new(tail)
    }

    /// The `x` at which the monic polynomial divides the symbol.
    fn common_zeros_with(&self, monic: &Bivariate) -> Vec<RealAlgebraic> {
        let (_, remainder) = self.0.divide_by_monic(monic);
        let common = remainder.coefficients().iter().fold(Polynomial::zero(), |g, c| g.gcd(c));
        if common.is_zero() { Vec::new() } else { roots(&common) }
    }

    fn norm(&self, phi: &Bivariate) -> Polynomial<Integer> {
        self.0.resultant(phi)
    }
}

fn roots(p: &Polynomial<Integer>) -> Vec<RealAlgebraic> {
    real_roots(p).iter().map(RealAlgebraic::simplified).collect()
}

/// Whether `|e(w)|² + |o(w)|²` comes near zero on the unit circle at, or very near to, `x`.
fn vanish_together(even: &Bivariate, odd: &Bivariate, x: &RealAlgebraic) -> bool {
    let near = x.enclosure(&Rational::new(integer(1), integer(1) << 60usize)).0;
    let at = |p: &Bivariate| p.map(|c| c.value_at(&near));
    let sum = squared_modulus(&at(even)).plus(&squared_modulus(&at(odd)));
    // In units of the value at w = 1, which is at least about the square of half the sum of a.
    let small = sum.evaluate(&Rational::one()).absolute() / Rational::from(integer(1) << 30usize);
    let lowered = sum.minus(&Polynomial::constant(small)).cleared().1;
    let one = Rational::one();
    let low_at = |c: &Rational| lowered.sign_at(c).is_le();
    lowered.is_zero()
        || low_at(&one)
        || low_at(&-one.clone())
        || !real_roots_between(&lowered, &-one.clone(), &one).is_empty()
}

/// `|p(w)|²` for `|w| = 1` as a polynomial in `cos θ`, by Chebyshev polynomials.
fn squared_modulus(p: &Polynomial<Rational>) -> Polynomial<Rational> {
    let c = p.coefficients();
    let lag = |k: usize| -> Rational {
        c.iter().zip(c.iter().skip(k)).map(|(a, b)| a * b).fold(Rational::zero(), |s, t| s + t)
    };
    let (mut previous, mut current) = (Polynomial::one(), Polynomial::variable());
    let two = Polynomial::monomial(Rational::from_i64(2), 1);
    let mut sum = Polynomial::constant(lag(0));
    for k in 1..c.len() {
        sum = sum.plus(&current.scaled(&(lag(k) * Rational::from_i64(2))));
        let next = two.times(&current).minus(&previous);
        previous = std::mem::replace(&mut current, next);
    }
    sum
}

fn totient(n: usize) -> usize {
    (1..=n).filter(|k| gcd(*k, n) == 1).count()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Whether 2 and -1 generate all units modulo the odd number `n`.
fn generated_by_two(n: usize) -> bool {
    let mut seen = std::collections::BTreeSet::new();
    let mut power = 1;
    while seen.insert(power) {
        power = power * 2 % n;
    }
    let both: std::collections::BTreeSet<usize> =
        seen.iter().flat_map(|&u| [u, n - u]).collect();
    both.len() == totient(n)
}

/// `Φ_n` as a polynomial over Z\[x\].
fn cyclotomic(n: usize) -> Bivariate {
    let minus_one = |n: usize| {
        Polynomial::monomial(integer(1), n).minus(&Polynomial::constant(integer(1)))
    };
    let product = (1..n)
        .filter(|d| n.is_multiple_of(*d))
        .fold(Polynomial::constant(integer(1)), |product, d| product.times(&integer_cyclotomic(d)));
    lift(&refinable_algebra::Domain::quotient(&minus_one(n), &product))
}

fn integer_cyclotomic(n: usize) -> Polynomial<Integer> {
    cyclotomic(n).map(|c| c.coefficient(0))
}

fn lift(p: &Polynomial<Integer>) -> Bivariate {
    p.map(|c| Polynomial::constant(c.clone()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;
    use refinable_scheme::Scheme;

    fn exceptions(text: &str) -> Option<Vec<RealAlgebraic>> {
        let scheme = Scheme::resolve(text, 2).unwrap();
        match instability(&Line::new(text, scheme.mask()).unwrap()) {
            Instability::At(list) => Some(list),
            Instability::Everywhere => None,
        }
    }

    #[test]
    fn interpolatory_schemes_and_splines_are_stable() {
        for text in ["i4", "i6", "dd4", "dd6", "bspline1", "bspline4", "bspline7"] {
            assert_eq!(exceptions(text), Some(vec![]), "{text}");
        }
    }

    /// (1+z)((1+z²)/2)³: both submasks are ((1+w)/2)³, which vanish at w = -1.
    #[test]
    fn a_dilated_spline_is_not_stable() {
        assert_eq!(exceptions("1/8*(1+z)*(1+z^2)^3"), None);
    }

    /// z⁻¹(1+z)(1-z+z²) = z⁻¹ + z²: φ is a third of the indicator of an interval of length 3.
    #[test]
    fn cyclotomic_factors_make_shifts_dependent() {
        // (1-t) (1+z) + t (1+z³): at t = 1 the factor Φ_6 appears.
        assert_eq!(exceptions("(1-t)*(1+z)+t*(1+z^3)"), Some(vec![rational(1, 1).into()]));
    }

    #[test]
    fn cyclotomic_polynomials() {
        let phi = |n| integer_cyclotomic(n).display("z");
        assert_eq!(phi(6), "z^2 - z + 1");
        assert_eq!(phi(10), "z^4 - z^3 + z^2 - z + 1");
        assert!(generated_by_two(7) && !generated_by_two(17));
    }
}
