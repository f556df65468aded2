//! The lemma `stable`: the integer shifts of the basic limit function are stable (Jia and Wang
//! 1993), or, for arity two, those of another one with the same smoothness and the same joint spectral
//! radius.

use refinable_algebra::{Integer, Polynomial, Rational, Ring, integer};

use crate::circle::{Pair, have_no_common_zero};
use crate::cyclotomic::{cyclotomic, even_orders, odd_orders};
use crate::family::{AffineSymbol, Scheme, with_squares};
use crate::real::Real;
use crate::resultant::{Coefficients, of_squares, resultant};
use crate::roots::real_roots;
use crate::work::{Check, Work, ensure, fail, largest_bits};

/// Checks that the criterion of contraction is sharp for every parameter value that is not among the
/// exceptions.
pub(crate) fn check(scheme: &Scheme, exceptions: &[Real], work: &mut Work) -> Check<()> {
    if scheme.arity > 2 {
        return check_contrasts(scheme, exceptions, work);
    }
    check_opposite(&scheme.difference, exceptions, work)?;
    check_cycles(scheme, exceptions, work)
}

/// Checks for arity three or more that no point of the unit circle is a zero of all contrasts.
fn check_contrasts(scheme: &Scheme, exceptions: &[Real], work: &mut Work) -> Check<()> {
    let reason = "all but one of the points with the same power may be zeros of the symbol";
    let c = &scheme.difference;
    let contrasts: Vec<Pair> =
        (0..scheme.arity - 1).map(|j| contrast(c, scheme.arity, j)).collect();
    if c.is_constant() {
        let anywhere = Real::Rational(Rational::from(integer(0)));
        return ensure(have_no_common_zero(&contrasts, &anywhere, work)?, reason);
    }
    let mut affine =
        contrasts.iter().cloned().map(without_zeros).filter(|part| !part[0].is_empty());
    let (Some(first), Some(second)) = (affine.next(), affine.next()) else {
        return fail("could not be checked: all submasks but one vanish");
    };
    let (long, short) =
        if first[0].len() < second[0].len() { (second, first) } else { (first, second) };
    let (long, short) = (coefficients(&long), coefficients(&short));
    // Two monomials have no common zero until they vanish: then the first does.
    let eliminant = if long.len() == 1 { long[0].clone() } else { resultant(&long, &short, work)? };
    ensure(!eliminant.is_zero(), "could not be checked: two contrasts have a common factor")?;
    for root in real_roots(&eliminant, work)? {
        let settled =
            is_among(&root, exceptions, work)? || have_no_common_zero(&contrasts, &root, work)?;
        ensure(settled, reason)?;
    }
    Ok(())
}

/// Checks that the submasks of `c` have no common zero at a root of unity of even order.
///
/// Those of `a` have the same common zeros but for `w = 1`.
fn check_opposite(c: &AffineSymbol, exceptions: &[Real], work: &mut Work) -> Check<()> {
    let half =
        |i: usize| [&c.p, &c.q].map(|part| part.iter().skip(i).step_by(2).cloned().collect());
    let halves: [Pair; 2] = [half(0), half(1)];
    let degree = if c.is_constant() {
        Some(c.degree() / 2)
    } else {
        let size = halves[0][0].len();
        work.products(2 * size * size, largest_bits(&c.p), largest_bits(&c.q))?;
        dependence(&halves.clone().map(|half| half.map(Polynomial::new))).degree()
    };
    let Some(degree) = degree else {
        return fail("could not be checked: opposite zeros that move with the parameter");
    };
    for r in even_orders(degree, work)? {
        check_even_order(r, &halves, exceptions, work)?;
    }
    Ok(())
}

/// `e_0 o_1 - e_1 o_0`, which vanishes where `e_0 + t e_1` and `o_0 + t o_1` do for some `t`.
fn dependence([[e0, e1], [o0, o1]]: &[[Polynomial<Integer>; 2]; 2]) -> Polynomial<Integer> {
    e0.times(o1).minus(&e1.times(o0))
}

/// Checks that two polynomials have no common zero at a primitive `r`-th root of unity `ζ`.
///
/// If a polynomial that does not vanish identically at `ζ` vanishes for `t = τ`, and the two are
/// dependent, then `τ` is an element of `Q(ζ)`, and the resultant vanishes exactly at its conjugates.
fn check_even_order(
    r: usize,
    halves: &[Pair; 2],
    exceptions: &[Real],
    work: &mut Work,
) -> Check<()> {
    let reason = "the submasks have a common zero at a root of unity of even order";
    let divisor = cyclotomic(r, work)?;
    let size = halves[0][0].len();
    work.products(6 * size * size, largest_bits(halves.iter().flatten().flatten()) + 64, 64)?;
    let rest = |c: Vec<Integer>| Polynomial::new(c).divide_by_monic(&divisor).1;
    let rests = halves.clone().map(|half| half.map(rest));
    let vanishes = |part: &&[Polynomial<Integer>; 2]| part.iter().all(Ring::is_zero);
    let Some([p, q]) = rests.iter().find(|part| !vanishes(part)) else { return fail(reason) };
    if !dependence(&rests).divide_by_monic(&divisor).1.is_zero() {
        return Ok(());
    }
    let length = p.coefficients().len().max(q.coefficients().len());
    let part = [p, q].map(|c| (0..length).map(|i| c.coefficient(i)).collect());
    let divisor = divisor.coefficients().iter().cloned().map(Polynomial::constant).collect();
    for root in real_roots(&resultant(&divisor, &coefficients(&part), work)?, work)? {
        ensure(is_among(&root, exceptions, work)?, reason)?;
    }
    Ok(())
}

/// The polynomial without the powers of the variable and the leading coefficients that vanish
/// identically.
fn without_zeros([p, q]: Pair) -> Pair {
    let zero = |i: &usize| p[*i].is_zero() && q[*i].is_zero();
    let first = (0..p.len()).find(|i| !zero(i)).unwrap_or(p.len());
    let last = (first..p.len()).rev().find(|i| !zero(i)).map_or(first, |i| i + 1);
    [p[first..last].to_vec(), q[first..last].to_vec()]
}

fn is_among(x: &Real, exceptions: &[Real], work: &mut Work) -> Check<bool> {
    for exception in exceptions {
        if x.compare(exception, work)?.is_eq() {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Coefficients that are affine in the parameter.
fn coefficients([p, q]: &Pair) -> Coefficients {
    p.iter().zip(q).map(|(p, q)| Polynomial::new(vec![p.clone(), q.clone()])).collect()
}

/// Checks that no orbit of a root of unity `ζ` of odd order `r ≥ 3` under squaring consists of zeros
/// of `a(-z)`, or, the same, of `c(-z)`.
fn check_cycles(scheme: &Scheme, exceptions: &[Real], work: &mut Work) -> Check<()> {
    // c(-z)
    let symbol = contrast(&scheme.difference, 2, 0);
    check_rational_cycles(&symbol, exceptions, work)?;
    if scheme.difference.is_constant() {
        return Ok(());
    }
    // An irrational parameter value: ζ and ζ² are both zeros.
    let symbol = without_zeros(without_zeros_at_one(symbol));
    // The resultant of f(z) and f(z²) is that of f and a polynomial with the zeros ζ².
    let affine = coefficients(&symbol);
    let resultant = resultant(&of_squares(&affine, work)?, &affine, work)?;
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

/// The sign of the coefficient `c_i` in the contrast `c_j(z^m) z^j - c_{j+1}(z^m) z^(j+1)` of two
/// submasks, `c(z) = Σ c_j(z^m) z^j`. For arity two it is `c(-z)`.
///
/// All contrasts vanish at `z` if and only if `c(zω) = 0` for all `ω ≠ 1` with `ω^m = 1`.
pub(crate) fn sign_in_contrast(i: usize, arity: usize, j: usize) -> i64 {
    i64::from(i % arity == j) - i64::from(i % arity == j + 1)
}

fn contrast(c: &AffineSymbol, arity: usize, j: usize) -> Pair {
    [&c.p, &c.q].map(|part| {
        let signed = part.iter().enumerate();
        signed.map(|(i, c)| c * integer(sign_in_contrast(i, arity, j))).collect()
    })
}

/// The polynomial without the factors `1 - z` that it has identically.
pub(crate) fn without_zeros_at_one([mut p, mut q]: Pair) -> Pair {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Certificate, End, Root};
    use crate::number::Number;
    use crate::work::Reason;
    use refinable_algebra::parse_rational;

    fn scheme(mask: &serde_json::Value) -> Scheme {
        let text = serde_json::json!({
            "format": "refinable-certificate", "version": 1, "lemmas": [],
            "family": {
                "name": "", "arity": 2, "parameter": "t", "order": 1, "lowest": 0, "mask": mask,
            },
            "conclusion": {"kind": "continuity", "continuity": 0, "proved": [], "refuted": []},
        });
        let family = Certificate::read(text.to_string().as_bytes()).unwrap().family;
        Scheme::new(&family, &mut Work::new()).unwrap()
    }

    /// `(1-z)² (2+z)` and `5 (1-z)` have one factor `1-z` in common; of zero only a constant is left.
    #[test]
    fn common_zeros_at_one_are_taken_out() {
        let without = |p: &[i64], q: &[i64]| {
            without_zeros_at_one([p, q].map(|part| part.iter().map(|&c| integer(c)).collect()))
        };
        let pair = |p: &[i64], q: &[i64]| {
            [p, q].map(|part| part.iter().map(|&c| integer(c)).collect::<Vec<_>>())
        };
        assert_eq!(without(&[2, -3, 0, 1], &[5, -5, 0, 0]), pair(&[2, -1, -1], &[5, 0, 0]));
        assert_eq!(without(&[1, -2, 1], &[0, 0, 0]), pair(&[1], &[0]));
        assert_eq!(without(&[1, -1], &[1, 1]), pair(&[1, -1], &[1, 1]));
        assert_eq!(without(&[1, 1], &[1, -1]), pair(&[1, 1], &[1, -1]));
        assert_eq!(without(&[0, 0, 0], &[0, 0, 0]), pair(&[0], &[0]));
    }

    /// The root of a polynomial between two numbers.
    fn root(polynomial: [&str; 3], from: &str, to: &str) -> Real {
        let number = |text: &str| Number(parse_rational(text).unwrap());
        let root_of = polynomial.map(number).to_vec();
        let root = Root { root_of, between: [number(from), number(to)] };
        Real::new(&End::Algebraic(root), &mut Work::new()).unwrap()
    }

    /// `c(z) = (z² - 1)(z⁴ - t z² + 1) + z (z⁸ + 1)/2`: the submasks have the common zeros `w`, eighth
    /// roots of unity, with `w + 1/w = t = ±√2`.
    #[test]
    fn opposite_zeros_at_an_irrational_parameter() {
        let pairs = [
            ["-1", "0"],
            ["-1/2", "0"],
            ["3/2", "1"],
            ["1", "1"],
            ["-1", "-1"],
            ["-1", "-1"],
            ["1", "0"],
            ["1", "0"],
            ["0", "0"],
            ["1/2", "0"],
            ["1/2", "0"],
        ];
        let scheme = scheme(&serde_json::json!(pairs));
        let square = ["-2", "0", "1"];
        let [a, b] = [root(square, "1", "2"), root(square, "-2", "-1")];
        let work = &mut Work::new();
        for listed in [vec![], vec![a.clone()], vec![b.clone()]] {
            let Err(Reason(reason)) = check_opposite(&scheme.difference, &listed, work) else {
                panic!("an exception is missing")
            };
            assert!(reason.contains("of even order"), "{reason}");
        }
        assert_eq!(check_opposite(&scheme.difference, &[a, b], work), Ok(()));
    }

    /// `c(-z)` is, up to a factor, a factor of degree 8 of the 17th cyclotomic polynomial at
    /// `t = ±√17`: an orbit of eight roots of unity, though the degree of `c` is less than
    /// `φ(17) = 16`.
    #[test]
    fn an_orbit_at_an_irrational_parameter() {
        let half = [["1", "0"], ["1/2", "1/2"], ["2", "0"], ["-1", "0"], ["-3/2", "-1/2"]];
        let mask: Vec<_> = half.iter().chain(half.iter().rev()).collect();
        let scheme = scheme(&serde_json::json!(mask));
        let square = ["-17", "0", "1"];
        let [a, b] = [root(square, "4", "5"), root(square, "-5", "-4")];
        let work = &mut Work::new();
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
