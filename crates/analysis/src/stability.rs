//! Stability of the integer shifts of the basic limit function.

use refinable_algebra::{
    GcdDomain, Integer, Laurent, Matrix, Ordered, Polynomial, Rational, Ring, integer,
};
use refinable_reals::{RealAlgebraic, real_roots_between, simple_roots};

use crate::line::Line;

/// Where on a line of masks the shifts may fail to be stable.
pub(crate) enum Instability {
    /// At these `x` at most.
    At(Vec<RealAlgebraic>),
    /// Perhaps everywhere.
    Everywhere,
}

/// The values of `x` at which smoothness may not follow contraction: a list that contains all
/// exceptional values.
///
/// For arity two, common zeros of both submasks on the unit circle do no harm unless they are roots of unity of
/// even order; all else is a cycle of zeros `-ζ^(2^k)`, `ζ` of odd order. For others, some `z` on the circle
/// must have `a(zω) = 0` for all `ω ≠ 1` with `ω^m = 1`. The proofs are in `docs/certificates.md`.
///
/// # Source
/// R. Q. Jia, J. Z. Wang, *Stability and linear independence associated with wavelet
/// decompositions*, Proc. AMS 117 (1993); the treatment of opposite zeros is ours.
pub(crate) fn instability(line: &Line) -> Instability {
    let exceptions = if line.arity() == 2 { binary_exceptions(line) } else { zeros_but_one(line) };
    exceptions.map_or(Instability::Everywhere, |mut exceptions| {
        exceptions.sort();
        exceptions.dedup();
        Instability::At(exceptions)
    })
}

/// Whether the shifts of a scheme without parameter are stable, if that is known: always for arity two. It is
/// known already whether the criterion of contraction is sharp.
pub(crate) fn is_stable(member: &Line, sharp: bool) -> Option<bool> {
    if member.arity() > 2 {
        return sharp.then_some(true);
    }
    // Common zeros of the submasks at which the criterion is sharp.
    let symbol = Symbol::new(member);
    let common = symbol.half(0).p.gcd(&symbol.half(1).p);
    let modulus = squared_modulus(&common.map(|c| Rational::from(c.clone()))).cleared().1;
    let ends = [1, -1].map(|end| modulus.sign_at(&Rational::from_i64(end)).is_gt());
    let [one, minus_one] = [1, -1].map(Rational::from_i64);
    let opposite =
        ends.contains(&false) || !real_roots_between(&modulus, &minus_one, &one).is_empty();
    Some(sharp && !opposite)
}

fn binary_exceptions(line: &Line) -> Option<Vec<RealAlgebraic>> {
    let symbol = Symbol::new(line);
    Some([opposite_zeros(&symbol)?, cycles(line, &symbol)?].concat())
}

/// For arity `m > 2` the `x` at which all contrasts of neighbouring submasks of `c` may vanish together on the
/// circle; `None` for all `x`.
///
/// With `c(z) = Σ z^j c_j(z^m)` they are `z^j c_j(z^m) - z^(j+1) c_(j+1)(z^m)`.
fn zeros_but_one(line: &Line) -> Option<Vec<RealAlgebraic>> {
    let m = line.arity();
    let c = line.difference_symbol(line.order().checked_sub(1)?).numerator;
    let signed = |j: usize| {
        move |(i, a): (usize, &Polynomial<Integer>)| match (i % m).checked_sub(j) {
            Some(0) => a.clone(),
            Some(1) => a.negated(),
            _ => Polynomial::zero(),
        }
    };
    let contrast =
        |j| Laurent::new(0, c.coefficients().iter().enumerate().map(signed(j)).collect());
    let contrasts: Vec<_> = (0..m - 1).map(contrast).filter(|part| !part.is_zero()).collect();
    let have_common_zero = |x: &Rational| {
        let moduli =
            contrasts.iter().map(|part| squared_modulus(part.map(|c| c.value_at(x)).polynomial()));
        !is_clearly_positive(&moduli.fold(Polynomial::zero(), |sum, modulus| sum.plus(&modulus)))
    };
    if line.parts().1.is_zero() {
        return (!have_common_zero(&Rational::zero())).then(Vec::new);
    }
    let [first, second] = contrasts.get(..2)? else { return None };
    let [first, second] = [first, second].map(Laurent::polynomial);
    // Two monomials have no common zero until they vanish: then the first does.
    let monomials = first.is_constant() && second.is_constant();
    let eliminant = if monomials { first.coefficient(0) } else { first.resultant(second) };
    if eliminant.is_zero() {
        return None;
    }
    let roots = simple_roots(&eliminant).into_iter();
    Some(roots.filter(|x| have_common_zero(&x.enclosure(&close()).0)).collect())
}

/// For a binary mask `a` without parameter whose shifts are not stable: `q` and the mask `a q(z) / q(z²)`, one
/// of finitely many steps further stable, whose basic limit function is as smooth.
///
/// A cycle `-ζ^(2^k)` of zeros, `Φ_{2r}(z) = Φ_r(-z)` with odd `r`, goes by `q = Φ_r`, since
/// `Φ_r(z²) = Φ_r(z) Φ_r(-z)`; common zeros of the submasks go by `q` their common factor.
pub(crate) fn reduction(member: &Line) -> Option<(Polynomial<Rational>, Line)> {
    if member.arity() != 2 {
        return None;
    }
    let mut factor = Polynomial::<Rational>::one();
    let mut current = member.clone();
    for _ in 0..16 {
        if matches!(instability(&current), Instability::At(_)) {
            return (!factor.is_constant()).then_some((factor, current));
        }
        let q = step(&Symbol::new(&current).p)?.map(|c| Rational::from(c.clone()));
        let (p, _) = current.parts();
        let product = p.polynomial().times(&q);
        let squared = Laurent::new(0, q.coefficients().to_vec()).dilated(2);
        let symbol = refinable_algebra::Domain::divide_exactly(&product, squared.polynomial())?;
        current = current.with_symbol(Laurent::new(p.lowest(), symbol.coefficients().to_vec()));
        factor = factor.times(&q);
    }
    None
}

/// The factor for one step of a reduction.
fn step(a: &Polynomial<Integer>) -> Option<Polynomial<Integer>> {
    let degree = a.degree().unwrap_or(0);
    let mut orders = (3..=6 * degree + 6).step_by(2).filter(|&r| totient(r) <= degree);
    let divides =
        |r: &usize| refinable_algebra::Domain::divide_exactly(a, &cyclotomic(2 * r)).is_some();
    if let Some(r) = orders.find(divides) {
        return Some(cyclotomic(r));
    }
    let whole = Symbol { p: a.clone(), q: Polynomial::zero() };
    let common = whole.half(0).p.gcd(&whole.half(1).p);
    // Zero is no common zero: powers of w only shift.
    let tail: Vec<Integer> =
        common.coefficients().iter().skip_while(|c| c.is_zero()).cloned().collect();
    Some(Polynomial::new(tail)).filter(|q| !q.is_constant())
}

type Bivariate = Polynomial<Polynomial<Integer>>;

/// `a(z) = p(z) + x q(z)` in integers, up to a constant factor and a power of `z`.
struct Symbol {
    p: Polynomial<Integer>,
    q: Polynomial<Integer>,
}

impl Symbol {
    fn new(line: &Line) -> Self {
        let affine = line.symbol();
        let entries = affine.coefficients().iter().flat_map(Polynomial::coefficients);
        let scale = Rational::from(refinable_algebra::clear_denominators(entries).0);
        let part = |k: usize| affine.polynomial().map(|c| (c.coefficient(k) * &scale).to_integer());
        Symbol { p: part(0), q: part(1) }
    }

    fn bivariate(&self) -> Bivariate {
        let length = self.p.coefficients().len().max(self.q.coefficients().len());
        let coefficient = |k| Polynomial::new(vec![self.p.coefficient(k), self.q.coefficient(k)]);
        Polynomial::new((0..length).map(coefficient).collect())
    }

    /// The parts of `Σ a_{2i+parity} w^i`.
    fn half(&self, parity: usize) -> Symbol {
        let half = |p: &Polynomial<Integer>| {
            Polynomial::new(p.coefficients().iter().skip(parity).step_by(2).cloned().collect())
        };
        Symbol { p: half(&self.p), q: half(&self.q) }
    }

    fn divided_by(&self, h: &Polynomial<Integer>) -> Symbol {
        let divide = |p: &Polynomial<Integer>| refinable_algebra::Domain::quotient(p, h);
        Symbol { p: divide(&self.p), q: divide(&self.q) }
    }
}

/// The `x` at which both submasks vanish at a root of unity of even order; `None` for all `x`.
fn opposite_zeros(symbol: &Symbol) -> Option<Vec<RealAlgebraic>> {
    let (even, odd) = (symbol.half(0), symbol.half(1));
    let fixed = [&even.p, &even.q, &odd.p, &odd.q];
    let fixed = fixed.into_iter().fold(Polynomial::zero(), |g, p| g.gcd(p));
    if even_orders(&fixed).next().is_some() {
        return None;
    }
    let (even, odd) = (even.divided_by(&fixed), odd.divided_by(&fixed));
    if even.q.is_zero() && odd.q.is_zero() {
        return Some(Vec::new());
    }
    // Where both vanish, x = -p/q is the same for both.
    let eliminant = even.p.times(&odd.q).minus(&even.q.times(&odd.p));
    if eliminant.is_zero() {
        return None;
    }
    let mut exceptions = Vec::new();
    for order in even_orders(&eliminant) {
        let phi = lift(&cyclotomic(order));
        let [r, s] = [&even, &odd].map(|part| part.bivariate().resultant(&phi));
        exceptions.extend(simple_roots(&r.gcd(&s)));
    }
    Some(exceptions)
}

/// The even `r` for which `Φ_r` divides the polynomial.
fn even_orders(p: &Polynomial<Integer>) -> impl Iterator<Item = usize> {
    let degree = p.degree().unwrap_or(0);
    let candidates = (2..=6 * degree + 6).step_by(2).filter(move |&r| totient(r) <= degree);
    candidates.filter(move |&r| {
        let phi = cyclotomic(r);
        refinable_algebra::Domain::divide_exactly(p, &phi).is_some()
    })
}

/// The `x` at which all `-ζ^(2^k)` may be zeros for some `ζ` of odd order; `None` for all `x`.
fn cycles(line: &Line, symbol: &Symbol) -> Option<Vec<RealAlgebraic>> {
    let bivariate = symbol.bivariate();
    let degree = bivariate.degree().unwrap_or(0);
    let mut exceptions = Vec::new();
    for order in (3..=6 * degree + 6).step_by(2).filter(|&r| totient(r) <= degree) {
        let (_, remainder) = bivariate.divide_by_monic(&lift(&cyclotomic(2 * order)));
        let common = remainder.coefficients().iter().fold(Polynomial::zero(), |g, c| g.gcd(c));
        if common.is_zero() {
            return None;
        }
        exceptions.extend(simple_roots(&common));
    }
    if !symbol.q.is_zero() {
        exceptions.extend(irrational_cycles(line)?);
    }
    Some(exceptions)
}

/// The irrational `x` at which `c(-z)`, `c(-z²)` and `c(-z⁴)` may vanish together on the circle.
fn irrational_cycles(line: &Line) -> Option<Vec<RealAlgebraic>> {
    let c = line.difference_symbol(line.order().checked_sub(1)?).numerator;
    let turned = |x: &Rational, power: usize| -> Polynomial<Rational> {
        let at = c.map(|coefficient| coefficient.value_at(x));
        let signed = at.polynomial().coefficients().iter().enumerate();
        let sign = |k: usize| Rational::from_i64(if k.is_multiple_of(2) { 1 } else { -1 });
        let turned: Vec<Rational> = signed.map(|(k, a)| a * sign(k)).collect();
        Laurent::new(0, turned).dilated(power).polynomial().clone()
    };
    let degree = c.coefficients().len().saturating_sub(1);
    let resultant = interpolated(3 * degree, |x| {
        let (first, second) = (turned(x, 1), turned(x, 2));
        // The resultant for the full degrees, whatever the leading coefficients at x.
        sylvester(&first, degree, &second, 2 * degree)
    });
    if resultant.is_zero() {
        return None;
    }
    let candidates =
        simple_roots(&resultant.cleared().1).into_iter().filter(|x| x.as_rational().is_none());
    let exceptions = candidates.filter(|x| {
        let x = x.enclosure(&close()).0;
        let sum = [1, 2, 4].map(|k| squared_modulus(&turned(&x, k)));
        !is_clearly_positive(&sum[0].plus(&sum[1]).plus(&sum[2]))
    });
    Some(exceptions.collect())
}

/// How close to a root of a resultant polynomials are looked at.
fn close() -> Rational {
    Rational::new(integer(1), integer(1) << 60usize)
}

/// Whether a polynomial in `cos θ` stays above a small part of its value at `θ = 0`.
fn is_clearly_positive(p: &Polynomial<Rational>) -> bool {
    let one = Rational::one();
    let small = p.evaluate(&one).absolute() / Rational::from(integer(1) << 20usize);
    let lowered = p.minus(&Polynomial::constant(small)).cleared().1;
    !lowered.is_zero()
        && lowered.sign_at(&one).is_gt()
        && lowered.sign_at(&-one.clone()).is_gt()
        && real_roots_between(&lowered, &-one.clone(), &one).is_empty()
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

/// The Sylvester determinant of two polynomials taken as of degrees `m` and `n`.
fn sylvester(p: &Polynomial<Rational>, m: usize, q: &Polynomial<Rational>, n: usize) -> Rational {
    let (dp, p) = p.cleared();
    let (dq, q) = q.cleared();
    let entry = |i: usize, j: usize| {
        let (polynomial, shift, degree) = if i < n { (&p, i, m) } else { (&q, i - n, n) };
        j.checked_sub(shift)
            .filter(|k| *k <= degree)
            .map_or_else(Integer::zero, |k| polynomial.coefficient(degree - k))
    };
    let determinant = Matrix::from_fn(m + n, m + n, entry).determinant();
    Rational::new(determinant, dp.power(n as u32).times(&dq.power(m as u32)))
}

/// The polynomial of at most a given degree with given values at integers, by Newton's formula.
fn interpolated(degree: usize, value: impl Fn(&Rational) -> Rational) -> Polynomial<Rational> {
    let nodes: Vec<Rational> = (0..=degree as i64)
        .map(|k| Rational::from_i64(if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 }))
        .collect();
    let mut differences: Vec<Rational> = nodes.iter().map(value).collect();
    for step in 1..=degree {
        for i in (step..=degree).rev() {
            let rise = &differences[i] - &differences[i - 1];
            differences[i] = rise / (&nodes[i] - &nodes[i - step]);
        }
    }
    (0..=degree).rev().fold(Polynomial::zero(), |sum: Polynomial<Rational>, i| {
        let factor = Polynomial::new(vec![-nodes[i].clone(), Rational::one()]);
        sum.times(&factor).plus(&Polynomial::constant(differences[i].clone()))
    })
}

fn totient(n: usize) -> usize {
    (1..=n).filter(|k| gcd(*k, n) == 1).count()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// `Φ_n`.
fn cyclotomic(n: usize) -> Polynomial<Integer> {
    let one = Polynomial::constant(integer(1));
    let product = (1..n)
        .filter(|d| n.is_multiple_of(*d))
        .fold(one.clone(), |product, d| product.times(&cyclotomic(d)));
    refinable_algebra::Domain::quotient(&Polynomial::monomial(integer(1), n).minus(&one), &product)
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
        exceptions_for(2, text)
    }

    fn exceptions_for(arity: usize, text: &str) -> Option<Vec<RealAlgebraic>> {
        let scheme = Scheme::resolve(text, arity).unwrap();
        match instability(&Line::new(text, scheme.mask()).unwrap()) {
            Instability::At(list) => Some(list),
            Instability::Everywhere => None,
        }
    }

    #[test]
    fn interpolatory_schemes_and_splines_have_no_exceptions() {
        for text in ["dd4", "dd6", "bspline1", "bspline4", "bspline7"] {
            assert_eq!(exceptions(text), Some(vec![]), "{text}");
        }
        // At the end of convergence the symbol of the four-point scheme has the factor Φ_6.
        assert_eq!(exceptions("i4"), Some(vec![rational(1, 2).into()]));
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

    /// B-splines are stable for every arity.
    #[test]
    fn splines_of_higher_arity_have_no_exceptions() {
        for arity in 3..=6_usize {
            let sigma: Vec<String> = (0..arity).map(|k| format!("z^{k}")).collect();
            for power in 1..=4 {
                let symbol = format!("{arity}*(({})/{arity})^{power}", sigma.join("+"));
                assert_eq!(exceptions_for(arity, &symbol), Some(vec![]), "{symbol}");
            }
        }
    }

    /// If `φ` belongs to `a`, then `(φ + φ(· - 1))/2` belongs to `a(z) (1 + z^m)/(1 + z)` for odd `m`, and its shifts,
    /// taken with alternating signs, have the sum zero.
    #[test]
    fn means_of_splines_are_not_stable() {
        let mean = "1/3*(1+z+z^2)^2*(1-z+z^2)";
        assert_eq!(exceptions_for(3, mean), None);
        let mean = "1/5*(1+z+z^2+z^3+z^4)^2*(1-z+z^2-z^3+z^4)";
        assert_eq!(exceptions_for(5, mean), None);
    }

    /// `c = t + (1-2t) z + t z²` for arity 3: `c(zω) = c(z/ω) = 0` makes `z² = 1`. At `t = 1` it is the mean of splines, at
    /// `t = 1/3` the order rises.
    #[test]
    fn exceptions_of_a_ternary_family() {
        let family = "1/3*(1+z+z^2)^2*(t+(1-2*t)*z+t*z^2)";
        let expected = [rational(1, 3), rational(1, 1)].map(RealAlgebraic::from).to_vec();
        assert_eq!(exceptions_for(3, family), Some(expected));
    }

    /// Stability of single binary schemes, also where common zeros of the submasks do no harm: those of `w² + w + 1`.
    #[test]
    fn stable_is_what_is_stable() {
        let stable = |arity, text: &str| {
            let scheme = Scheme::resolve(text, arity).unwrap();
            let line = Line::new(text, scheme.mask()).unwrap();
            is_stable(&line, matches!(instability(&line), Instability::At(_)))
        };
        for text in ["dd4", "bspline3", "dd8"] {
            assert_eq!(stable(2, text), Some(true), "{text}");
        }
        for text in ["1/3*(1+z)*(1+z^2+z^4)", "[1/2, 1/2, 1/2, 1/2]", "z^-1*(1+z)*(1-z+z^2)"] {
            assert_eq!(stable(2, text), Some(false), "{text}");
        }
        // w² + 3w + 1 has no zero on the circle.
        assert_eq!(stable(2, "1/5*(1+z)*(1+3*z^2+z^4)"), Some(true));
        assert_eq!(stable(3, "1/3*(1+z+z^2)^2"), Some(true));
        assert_eq!(stable(3, "1/3*(1+z+z^2)^2*(1-z+z^2)"), None);
    }

    #[test]
    fn cyclotomic_polynomials() {
        let phi = |n| cyclotomic(n).display("z");
        assert_eq!(phi(6), "z^2 - z + 1");
        assert_eq!(phi(10), "z^4 - z^3 + z^2 - z + 1");
    }
}
