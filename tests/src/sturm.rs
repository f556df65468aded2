//! Real roots by Sturm's theorem.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Polynomial, Rational, integer, rational};

/// Coefficients over Q in ascending order, the last one nonzero; empty for zero.
type Coefficients = Vec<Rational>;

/// The signed remainder sequence of two polynomials: `p_0`, `p_1`, `p_(k+1) = -(p_(k-1) mod p_k)`.
///
/// For `p_0 = p`, `p_1 = p'`, after division by the last member (the gcd), the number of sign
/// changes at `a` less that at `b` is the number of distinct roots of `p` in `(a, b]`, for all
/// `a < b`. For `p_1 = p' q` the difference is the number of distinct roots in `(a, b)` with `q > 0`
/// less the number of those with `q < 0`, provided that neither `a` nor `b` is a root of `p`.
///
/// # Cost
/// Rational arithmetic without any thought: `O(degree²)` operations on numbers that grow fast.
///
/// # Source
/// S. Basu, R. Pollack, M.-F. Roy, *Algorithms in Real Algebraic Geometry*, Theorems 2.50 and 2.61.
#[derive(Clone, Debug)]
pub struct SturmChain {
    members: Vec<Coefficients>,
}

impl SturmChain {
    /// The chain that counts the distinct roots of `polynomial`.
    ///
    /// # Panics
    /// If the polynomial is zero.
    pub fn of(polynomial: &Polynomial<Integer>) -> Self {
        let p = over_q(polynomial);
        assert!(!p.is_empty(), "every number is a root of zero");
        let derivative = derivative(&p);
        let members = signed_remainders(p, derivative);
        let gcd = members.last().expect("the first member is there").clone();
        let reduced = members.iter().map(|member| {
            let (quotient, remainder) = divide(member, &gcd);
            assert!(remainder.is_empty(), "the gcd divides every member");
            quotient
        });
        SturmChain { members: reduced.collect() }
    }

    /// The number of distinct real roots.
    pub fn count(&self) -> usize {
        let at_infinity = |negative: bool| {
            self.changes(|member| {
                let odd = member.len() % 2 == 0;
                let sign = sign(member.last().expect("no member is zero"));
                if negative && odd { sign.reverse() } else { sign }
            })
        };
        at_infinity(true) - at_infinity(false)
    }

    /// The number of distinct roots in `(lower, upper]`; zero if `lower ≥ upper`.
    pub fn count_half_open(&self, lower: &Rational, upper: &Rational) -> usize {
        if lower >= upper {
            return 0;
        }
        self.changes_at(lower) - self.changes_at(upper)
    }

    /// The number of distinct roots in the open interval `(lower, upper)`.
    pub fn count_open(&self, lower: &Rational, upper: &Rational) -> usize {
        let at_end = lower < upper && self.has_root(upper);
        self.count_half_open(lower, upper) - usize::from(at_end)
    }

    /// The number of distinct roots in the closed interval `[lower, upper]`.
    pub fn count_closed(&self, lower: &Rational, upper: &Rational) -> usize {
        let at_start = lower <= upper && self.has_root(lower);
        self.count_half_open(lower, upper) + usize::from(at_start)
    }

    /// Whether the rational number `x` is a root.
    pub fn has_root(&self, x: &Rational) -> bool {
        value(&self.members[0], x) == rational(0, 1)
    }

    /// Intervals `(lower, upper]` no wider than `width`, ascending and disjoint, with one root each
    /// and every real root in one of them.
    pub fn isolate(&self, width: &Rational) -> Vec<(Rational, Rational)> {
        let bound = root_bound(&self.members[0]);
        let mut found = Vec::new();
        let mut todo = vec![(-bound.clone(), bound)];
        while let Some((lower, upper)) = todo.pop() {
            let count = self.count_half_open(&lower, &upper);
            if count == 1 && &upper - &lower <= *width {
                found.push((lower, upper));
            } else if count > 0 {
                let middle = (&lower + &upper) / integer(2);
                todo.push((middle.clone(), upper));
                todo.push((lower, middle));
            }
        }
        found
    }

    /// The sign of `q` at the only root of `p` in the open interval `(lower, upper)`.
    ///
    /// # Panics
    /// If there is not exactly one root, or an end is a root.
    pub fn sign_at_only_root(
        p: &Polynomial<Integer>,
        q: &Polynomial<Integer>,
        lower: &Rational,
        upper: &Rational,
    ) -> Ordering {
        let counter = SturmChain::of(p);
        assert_eq!(counter.count_closed(lower, upper), 1, "not a single root");
        assert!(!counter.has_root(lower) && !counter.has_root(upper));
        let p = over_q(p);
        let weighted = product(&derivative(&p), &over_q(q));
        let chain = SturmChain { members: signed_remainders(p, weighted) };
        chain.changes_at(lower).cmp(&chain.changes_at(upper))
    }

    fn changes_at(&self, x: &Rational) -> usize {
        self.changes(|member| sign(&value(member, x)))
    }

    /// The number of sign changes along the chain, zeros left out.
    fn changes(&self, sign: impl Fn(&Coefficients) -> Ordering) -> usize {
        let signs = self.members.iter().map(sign).filter(|s| s.is_ne());
        let signs: Vec<Ordering> = signs.collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// Every member is divided by the size of its leading coefficient, which changes no sign.
fn signed_remainders(p: Coefficients, q: Coefficients) -> Vec<Coefficients> {
    let mut members = vec![p];
    let mut next = q;
    while !next.is_empty() {
        let last = next.last().expect("not empty");
        let size = if sign(last).is_lt() { -last } else { last.clone() };
        let scaled: Coefficients = next.iter().map(|c| c / &size).collect();
        let (_, remainder) = divide(members.last().expect("not empty"), &scaled);
        next = remainder.into_iter().map(|c| -c).collect();
        members.push(scaled);
    }
    members
}

/// `(quotient, remainder)`, by long division.
fn divide(a: &Coefficients, b: &Coefficients) -> (Coefficients, Coefficients) {
    let mut rest = a.clone();
    let mut quotient = vec![rational(0, 1); (a.len() + 1).saturating_sub(b.len())];
    for shift in (0..quotient.len()).rev() {
        let factor = &rest[shift + b.len() - 1] / &b[b.len() - 1];
        for (k, c) in b.iter().enumerate() {
            rest[shift + k] -= &factor * c;
        }
        quotient[shift] = factor;
    }
    (trimmed(quotient), trimmed(rest))
}

fn product(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let mut product = vec![rational(0, 1); a.len() + b.len()];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    trimmed(product)
}

fn derivative(p: &Coefficients) -> Coefficients {
    let terms = p.iter().enumerate().skip(1);
    terms.map(|(k, c)| c * integer(k as i64)).collect()
}

fn value(p: &Coefficients, x: &Rational) -> Rational {
    let zero = rational(0, 1);
    p.iter().rev().fold(zero, |value, c| value * x + c)
}

/// `1 + max |c_k / c_n|` (Cauchy).
fn root_bound(p: &Coefficients) -> Rational {
    let leading = p.last().expect("not zero");
    let ratios = p.iter().map(|c| {
        let ratio = c / leading;
        if sign(&ratio).is_lt() { -ratio } else { ratio }
    });
    ratios.max().expect("not zero") + integer(1)
}

fn over_q(p: &Polynomial<Integer>) -> Coefficients {
    let coefficients = p.coefficients().iter();
    coefficients.map(|c| Rational::from(c.clone())).collect()
}

fn trimmed(mut p: Coefficients) -> Coefficients {
    while p.last().is_some_and(|c| sign(c).is_eq()) {
        p.pop();
    }
    p
}

fn sign(x: &Rational) -> Ordering {
    x.cmp(&rational(0, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    #[test]
    fn the_chain_of_sturms_example() {
        // x³ - 2x - 5, one real root, between 2 and 3.
        let chain = SturmChain::of(&poly(&[-5, -2, 0, 1]));
        assert_eq!(chain.count(), 1);
        assert_eq!(chain.count_open(&rational(2, 1), &rational(3, 1)), 1);
    }

    #[test]
    fn multiple_roots_count_once_and_ends_are_respected() {
        // x² (x-1)³ (x+2) = x^6 - x^5 - 3x^4 + 5x^3 - 2x^2
        let chain = SturmChain::of(&poly(&[0, 0, -2, 5, -3, -1, 1]));
        let count = |f: fn(&SturmChain, &Rational, &Rational) -> usize, a, b| {
            f(&chain, &rational(a, 1), &rational(b, 1))
        };
        assert_eq!(chain.count(), 3);
        assert_eq!(count(SturmChain::count_half_open, 0, 1), 1);
        assert_eq!(count(SturmChain::count_open, 0, 1), 0);
        assert_eq!(count(SturmChain::count_closed, 0, 1), 2);
        assert_eq!(count(SturmChain::count_closed, 1, 1), 1);
        assert_eq!(count(SturmChain::count_open, 1, 0), 0);
        assert_eq!(count(SturmChain::count_open, -3, 2), 3);
    }

    #[test]
    fn isolation_encloses_the_square_roots_of_two() {
        let width = rational(1, 1000);
        let found = SturmChain::of(&poly(&[-2, 0, 1])).isolate(&width);
        assert_eq!(found.len(), 2);
        let (lower, upper) = &found[1];
        assert!(lower * lower < rational(2, 1) && upper * upper > rational(2, 1));
        assert!(upper - lower <= width);
    }

    #[test]
    fn signs_at_a_root() {
        let (p, one, two) = (poly(&[-2, 0, 1]), rational(1, 1), rational(2, 1));
        let sign = |q: &[i64]| SturmChain::sign_at_only_root(&p, &poly(q), &one, &two);
        assert_eq!(sign(&[-7, 5]), Ordering::Greater); // 5√2 > 7
        assert_eq!(sign(&[-3, 2]), Ordering::Less); // 2√2 < 3
        assert_eq!(sign(&[0, -2, 0, 1]), Ordering::Equal);
        assert_eq!(sign(&[]), Ordering::Equal);
        assert_eq!(sign(&[-1]), Ordering::Less);
    }
}
