//! The lemma `stable`: the integer shifts of the basic limit function are stable (Jia and Wang 1993).

use refinable_algebra::{Domain, GcdDomain, Integer, Polynomial, Rational, Ring, integer};

use crate::circle::{Pair, have_no_common_zero};
use crate::cyclotomic::{cyclotomic, odd_orders};
use crate::determinant::determinant;
use crate::family::{AffineSymbol, Scheme};
use crate::real::Real;
use crate::roots::real_roots;
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// Checks that the shifts are stable for every parameter value that is not among the exceptions.
pub(crate) fn check(scheme: &Scheme, exceptions: &[Real], work: &mut Work) -> Check<()> {
    ensure(scheme.arity == 2, "stability is checked for arity two only")?;
    let [p, q] = [&scheme.symbol.p, &scheme.symbol.q];
    let half =
        |first: usize| [p, q].map(|c| c.iter().skip(first).step_by(2).cloned().collect::<Vec<_>>());
    let halves = [half(0), half(1)].map(without_zeros);
    let reason = "two opposite points of the unit circle are zeros of the symbol";
    check_coprime(halves, scheme.symbol.is_constant(), exceptions, reason, work)?;
    check_cycles(scheme, exceptions, work)
}

/// The polynomial without the powers of the variable and the leading coefficients that vanish
/// identically.
fn without_zeros([p, q]: Pair) -> Pair {
    let zero = |i: &usize| p[*i].is_zero() && q[*i].is_zero();
    let first = (0..p.len()).find(|i| !zero(i)).unwrap_or(0);
    let last = (first..p.len()).rev().find(|i| !zero(i)).map_or(first, |i| i + 1);
    [p[first..last].to_vec(), q[first..last].to_vec()]
}

/// Checks that two polynomials have no common zero on the unit circle but for the exceptions.
fn check_coprime(
    parts: [Pair; 2],
    constant: bool,
    exceptions: &[Real],
    reason: &str,
    work: &mut Work,
) -> Check<()> {
    if constant {
        let origin = Real::Rational(Rational::from(integer(0)));
        return ensure(have_no_common_zero(&parts, &origin, work)?, reason);
    }
    let mut parts = parts;
    let mut resultant = resultant(&parts, work)?;
    if resultant.is_zero() {
        parts = without_common_factor(&parts, reason, work)?;
        resultant = self::resultant(&parts, work)?;
        ensure(!resultant.is_zero(), "could not be checked: a common factor of two polynomials")?;
    }
    for root in real_roots(&resultant, work)? {
        if !is_among(&root, exceptions, work)? && !have_no_common_zero(&parts, &root, work)? {
            return fail(reason);
        }
    }
    Ok(())
}

fn is_among(x: &Real, exceptions: &[Real], work: &mut Work) -> Check<bool> {
    for exception in exceptions {
        if x.compare(exception, work)?.is_eq() {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The resultant, as a polynomial in the parameter: the determinant of Sylvester's matrix.
fn resultant([a, b]: &[Pair; 2], work: &mut Work) -> Check<Polynomial<Integer>> {
    let (m, n) = (a[0].len().saturating_sub(1), b[0].len().saturating_sub(1));
    let varies = |part: &Pair| usize::from(part[1].iter().any(|q| !q.is_zero()));
    let coefficient = |part: &Pair, i: usize| match part[0].get(i) {
        Some(p) => Polynomial::new(vec![p.clone(), part[1][i].clone()]),
        None => Polynomial::zero(),
    };
    let entry = |k: usize| {
        let (i, j) = (k / (m + n), k % (m + n));
        let (part, shift) = if i < n { (a, i) } else { (b, i - n) };
        j.checked_sub(shift).map_or_else(Polynomial::zero, |l| coefficient(part, l))
    };
    let matrix: Vec<_> = (0..(m + n) * (m + n)).map(entry).collect();
    determinant(m + n, &matrix, varies(a) * n + varies(b) * m, work)
}

/// Both polynomials over their greatest common divisor, which must not depend on the parameter and
/// have no zero on the unit circle.
fn without_common_factor([a, b]: &[Pair; 2], reason: &str, work: &mut Work) -> Check<[Pair; 2]> {
    let two_variables = |[p, q]: &Pair| {
        let pairs = p.iter().zip(q);
        Polynomial::new(pairs.map(|(p, q)| Polynomial::new(vec![p.clone(), q.clone()])).collect())
    };
    let (a, b) = (two_variables(a), two_variables(b));
    let size = a.coefficients().len() + b.coefficients().len();
    let bits = largest_bits(a.coefficients().iter().flat_map(Polynomial::coefficients));
    work.products(size.pow(4), bits * size as u64, bits * size as u64)?;
    let common = a.gcd(&b);
    let fixed = common.coefficients().iter().all(Polynomial::is_constant);
    ensure(fixed, "could not be checked: a common factor of two polynomials has the parameter")?;
    let constants: Vec<Integer> = common.coefficients().iter().map(|c| c.coefficient(0)).collect();
    let zeros = vec![Integer::zero(); constants.len()];
    let origin = Real::Rational(Rational::from(integer(0)));
    ensure(have_no_common_zero(&[[constants, zeros]], &origin, work)?, reason)?;
    let pair = |p: Polynomial<Polynomial<Integer>>| -> Pair {
        let part = |k: usize| p.coefficients().iter().map(|c| c.coefficient(k)).collect();
        [part(0), part(1)]
    };
    Ok([pair(a.quotient(&common)), pair(b.quotient(&common))])
}

/// Checks that no orbit of a root of unity `ζ` of odd order `r ≥ 3` under squaring consists of zeros
/// of `a(-z)`, or, the same, of `c(-z)`.
fn check_cycles(scheme: &Scheme, exceptions: &[Real], work: &mut Work) -> Check<()> {
    let symbol = alternating(&scheme.difference);
    check_rational_cycles(&symbol, exceptions, work)?;
    if scheme.difference.is_constant() {
        return Ok(());
    }
    // An irrational parameter value: ζ and ζ² are both zeros.
    let symbol = without_zeros(without_zeros_at_one(symbol));
    let squared = symbol.clone().map(|c| with_squares(&c));
    let resultant = resultant(&[symbol.clone(), squared], work)?;
    ensure(!resultant.is_zero(), "could not be checked: c(-z) and c(-z²) have a common factor")?;
    for root in real_roots(&resultant, work)? {
        let settled = is_among(&root, exceptions, work)?
            || root.as_rational().is_some()
            || root.is_rational(work)?
            || orbit_is_left(&symbol, &root, work)?;
        ensure(settled, "an orbit of roots of unity may consist of zeros of the symbol")?;
    }
    Ok(())
}

/// How many of the first points of an orbit are looked at.
const STEPS: usize = 3;

/// Whether no point of the unit circle is a zero of the polynomial together with its square, the
/// square of that, and so on.
fn orbit_is_left(symbol: &Pair, t: &Real, work: &mut Work) -> Check<bool> {
    let mut parts = vec![symbol.clone()];
    while parts.len() < STEPS {
        parts.push(parts[parts.len() - 1].clone().map(|c| with_squares(&c)));
        if have_no_common_zero(&parts, t, work)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// For a rational parameter value all primitive `r`-th roots of unity are zeros of `c(-z)` if one is.
fn check_rational_cycles(symbol: &Pair, exceptions: &[Real], work: &mut Work) -> Check<()> {
    let [p, q] = symbol.clone().map(Polynomial::new);
    let degree = symbol[0].len() - 1;
    let bits = largest_bits(symbol.iter().flatten());
    for r in odd_orders(degree, work)? {
        let divisor = cyclotomic(r, work)?;
        work.products(2 * (degree + 1) * (degree + 1), bits + 64, 64)?;
        let [p, q] = [&p, &q].map(|c| c.divide_by_monic(&divisor).1);
        match common_zero(p.coefficients(), q.coefficients()) {
            CommonZero::None => {}
            CommonZero::One(t) => {
                let listed = is_among(&Real::Rational(t), exceptions, work)?;
                ensure(listed, "an orbit of roots of unity consists of zeros of the symbol")?;
            }
            CommonZero::Everywhere => {
                return fail("an orbit of roots of unity consists of zeros of the symbol");
            }
        }
    }
    Ok(())
}

/// Where all of several affine functions of the parameter vanish.
pub(crate) enum CommonZero {
    /// Nowhere.
    None,
    /// At one value.
    One(Rational),
    /// They are zero.
    Everywhere,
}

/// Where all `p_i + q_i t` vanish; missing coefficients are zero.
pub(crate) fn common_zero(p: &[Integer], q: &[Integer]) -> CommonZero {
    let zero = Integer::zero();
    let pair = |i: usize| (p.get(i).unwrap_or(&zero), q.get(i).unwrap_or(&zero));
    let count = p.len().max(q.len());
    let Some(first) = (0..count).find(|&i| !pair(i).0.is_zero() || !pair(i).1.is_zero()) else {
        return CommonZero::Everywhere;
    };
    let (p0, q0) = pair(first);
    if q0.is_zero() {
        return CommonZero::None;
    }
    // p_i q_0 = p_0 q_i says that p_i + q_i t vanishes at -p_0/q_0.
    let all = (first..count).all(|i| pair(i).0 * q0 == p0 * pair(i).1);
    if all { CommonZero::One(Rational::new(-p0, q0.clone())) } else { CommonZero::None }
}

/// `c(-z)`.
fn alternating(c: &AffineSymbol) -> Pair {
    [&c.p, &c.q].map(|part| {
        let signed = part.iter().enumerate();
        signed.map(|(i, c)| if i % 2 == 1 { -c } else { c.clone() }).collect()
    })
}

/// The polynomial without the factors `1 - z` that it has identically.
fn without_zeros_at_one([mut p, mut q]: Pair) -> Pair {
    let sum = |c: &[Integer]| c.iter().sum::<Integer>();
    while p.len() > 1 && sum(&p).is_zero() && sum(&q).is_zero() {
        for part in [&mut p, &mut q] {
            // The coefficients of p/(1 - z) are the partial sums.
            for i in 1..part.len() {
                let (low, high) = part.split_at_mut(i);
                high[0] += &low[i - 1];
            }
            part.pop();
        }
    }
    [p, q]
}

/// `p(z²)`.
fn with_squares(p: &[Integer]) -> Vec<Integer> {
    let mut spread = vec![Integer::zero(); (2 * p.len()).saturating_sub(1)];
    for (i, c) in p.iter().enumerate() {
        spread[2 * i] = c.clone();
    }
    spread
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Certificate, End, Root};
    use crate::number::Number;
    use crate::work::Reason;
    use refinable_algebra::parse_rational;

    /// `c(-z)` is, up to a factor, a factor of degree 8 of the 17th cyclotomic polynomial at
    /// `t = ±√17`: an orbit of eight roots of unity, though the degree of `c` is less than
    /// `φ(17) = 16`.
    #[test]
    fn an_orbit_at_an_irrational_parameter() {
        let half = [["1", "0"], ["1/2", "1/2"], ["2", "0"], ["-1", "0"], ["-3/2", "-1/2"]];
        let mask: Vec<_> = half.iter().chain(half.iter().rev()).collect();
        let text = serde_json::json!({
            "format": "refinable-certificate", "version": 1, "lemmas": [],
            "family": {
                "name": "", "arity": 2, "parameter": "t", "order": 1, "lowest": 0, "mask": mask,
            },
            "conclusion": {"kind": "continuity", "continuity": 0, "proved": [], "refuted": []},
        });
        let family = Certificate::read(text.to_string().as_bytes()).unwrap().family;
        let work = &mut Work::new();
        let scheme = Scheme::new(&family, work).unwrap();
        let number = |text: &str| Number(parse_rational(text).unwrap());
        let root = |from: &str, to: &str| Root {
            root_of: ["-17", "0", "1"].map(number).to_vec(),
            between: [number(from), number(to)],
        };
        let ends = [root("4", "5"), root("-5", "-4")].map(End::Algebraic);
        let [a, b] = ends.map(|end| Real::new(&end, work).unwrap());
        // At t = -4 the cube roots of unity are zeros.
        let four = Real::Rational(Rational::from(integer(-4)));
        for listed in [vec![], vec![a.clone()], vec![b.clone()]] {
            let listed = [listed, vec![four.clone()]].concat();
            let Err(Reason(reason)) = check_cycles(&scheme, &listed, &mut Work::new()) else {
                panic!("an exception is missing")
            };
            assert!(reason.contains("may consist of zeros"), "{reason}");
        }
        assert!(check_cycles(&scheme, &[a.clone(), b.clone()], work).is_err());
        assert_eq!(check_cycles(&scheme, &[a, four, b], work), Ok(()));
    }
}
