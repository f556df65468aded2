//! Polynomials in two variables: values at several points at once, and signs on polygons.

use refinable_algebra::{
    Integer, Ordered, Polynomial, Ring, clear_denominators, least_common_multiple,
};

use crate::map::model::Terms;
use crate::map::polygon::{Corner, Polygon};
use crate::work::{Check, Work, largest_bits};

/// A polynomial in `y` whose coefficients are polynomials in `x`.
pub(crate) type Form = Polynomial<Polynomial<Integer>>;

/// Polynomials times the least common denominator of all their coefficients.
pub(crate) fn cleared(all: &[Terms]) -> Vec<Form> {
    let (_, numbers) = clear_denominators(all.iter().flatten().map(|(c, ..)| &c.0));
    let mut numbers = numbers.into_iter();
    let form = |terms: &Terms| {
        let terms = terms.iter().zip(&mut numbers);
        let monomial = |(&(_, i, j), c): (&(_, u32, u32), Integer)| {
            Form::monomial(Polynomial::monomial(c, i as usize), j as usize)
        };
        terms.map(monomial).fold(Form::zero(), |sum, term| sum.plus(&term))
    };
    all.iter().map(form).collect()
}

/// The total degree; zero for the zero polynomial.
pub(crate) fn degree(form: &Form) -> usize {
    terms(form).map(|(i, j, _)| i + j).max().unwrap_or(0)
}

/// The terms `c x^i y^j`.
pub(crate) fn terms(form: &Form) -> impl Iterator<Item = (usize, usize, &Integer)> {
    form.coefficients().iter().enumerate().flat_map(|(j, row)| {
        let row = row.coefficients().iter().enumerate();
        row.filter(|(_, c)| !c.is_zero()).map(move |(i, c)| (i, j, c))
    })
}

/// All multisets of so many of the numbers below `count`, each in ascending order.
pub(crate) fn multisets(count: usize, size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    let shorter = multisets(count, size - 1);
    let longer = |set: &Vec<usize>| {
        let from = set.last().copied().unwrap_or(0);
        let set = set.clone();
        (from..count).map(move |i| [&set[..], &[i]].concat()).collect::<Vec<_>>()
    };
    shorter.iter().flat_map(longer).collect()
}

/// What the polar forms of polynomials of degree at most `n` at `n` points need to know of them.
pub(crate) struct Places {
    /// `i! j! (n-i-j)!` times the coefficient of `X^i Y^j` in `Π (X x_k + Y y_k + w_k)`.
    coefficients: Vec<Vec<Integer>>,
    /// `n! Π w_k`.
    pub denominator: Integer,
}

impl Places {
    /// The places, as many as the degree says.
    pub fn new(corners: &[&Corner]) -> Self {
        let n = corners.len();
        let mut product = vec![vec![Integer::from(1)]];
        for [x, y, w] in corners {
            let size = product.len();
            let mut next = vec![vec![Integer::zero(); size + 1]; size + 1];
            for (i, row) in product.iter().enumerate() {
                for (j, c) in row.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                    next[i + 1][j] += c * x;
                    next[i][j + 1] += c * y;
                    next[i][j] += c * w;
                }
            }
            product = next;
        }
        let factorials: Vec<Integer> = (0..=n)
            .scan(Integer::from(1), |f, k| {
                *f *= k.max(1);
                Some(f.clone())
            })
            .collect();
        for (i, row) in product.iter_mut().enumerate() {
            for (j, c) in row.iter_mut().enumerate().take(n + 1 - i) {
                *c *= &factorials[i] * &factorials[j] * &factorials[n - i - j];
            }
        }
        let weights = corners.iter().map(|[_, _, w]| w);
        let denominator = weights.fold(factorials[n].clone(), |product, w| product * w);
        Places { coefficients: product, denominator }
    }

    /// The numerator of the polar form.
    pub fn value(&self, form: &Form) -> Integer {
        terms(form).map(|(i, j, c)| c * &self.coefficients[i][j]).sum()
    }
}

/// How often a triangle is halved.
const HALVINGS: usize = 10;

/// Whether the polynomial is shown to be nowhere positive on a closed polygon.
///
/// On a triangle it is a mean of its Bernstein coefficients, which are the values of its polar form
/// at the corners. A triangle on which they do not tell is halved.
pub(crate) fn is_nowhere_positive(form: &Form, polygon: &Polygon, work: &mut Work) -> Check<bool> {
    let weight = polygon
        .corners()
        .iter()
        .fold(Integer::from(1), |w, [_, _, v]| least_common_multiple(&w, v));
    let corner = |[x, y, w]: &Corner| {
        let factor = &weight / w;
        [x * &factor, y * &factor, weight.clone()]
    };
    let corners: Vec<Corner> = polygon.corners().iter().map(corner).collect();
    let fan = corners.windows(2).skip(1);
    let mut triangles: Vec<([Corner; 3], usize)> =
        fan.map(|pair| ([corners[0].clone(), pair[0].clone(), pair[1].clone()], 0)).collect();
    let n = degree(form);
    while let Some((triangle, halvings)) = triangles.pop() {
        match sign_on(form, n, &triangle, work)? {
            Sign::NotPositive => {}
            Sign::Unknown if halvings < HALVINGS => {
                triangles.extend(halves(&triangle).map(|half| (half, halvings + 1)));
            }
            _ => return Ok(false),
        }
    }
    Ok(true)
}

enum Sign {
    NotPositive,
    Positive,
    Unknown,
}

fn sign_on(form: &Form, n: usize, triangle: &[Corner; 3], work: &mut Work) -> Check<Sign> {
    let bits = largest_bits(triangle.iter().flatten());
    work.products(3 * (n + 1) * (n + 2) * (n + 2) * (n + 3) / 4, bits * n as u64 + 64, bits)?;
    let composed = composed(form, n, triangle);
    let is_positive = |c: &Integer| c.compare_to_zero().is_gt();
    if [(n, 0), (0, n), (0, 0)].iter().any(|&(i, j)| is_positive(&composed.terms[i][j])) {
        return Ok(Sign::Positive);
    }
    let all = !composed.terms.iter().flatten().any(is_positive);
    Ok(if all { Sign::NotPositive } else { Sign::Unknown })
}

/// A homogeneous polynomial in barycentric coordinates: `terms[i][j]` is the coefficient of
/// `a^i b^j c^(d-i-j)`.
#[derive(Clone)]
struct Barycentric {
    degree: usize,
    terms: Vec<Vec<Integer>>,
}

impl Barycentric {
    fn constant(c: Integer) -> Self {
        Barycentric { degree: 0, terms: vec![vec![c]] }
    }

    /// Times `x_0 a + x_1 b + x_2 c`.
    fn times_linear(&self, x: [&Integer; 3]) -> Self {
        let degree = self.degree + 1;
        let mut terms: Vec<Vec<Integer>> =
            (0..=degree).map(|i| vec![Integer::zero(); degree + 1 - i]).collect();
        for (i, row) in self.terms.iter().enumerate() {
            for (j, t) in row.iter().enumerate().filter(|(_, t)| !t.is_zero()) {
                terms[i + 1][j] += t * x[0];
                terms[i][j + 1] += t * x[1];
                terms[i][j] += t * x[2];
            }
        }
        Barycentric { degree, terms }
    }

    fn add(&mut self, other: &Self) {
        let all = self.terms.iter_mut().flatten().zip(other.terms.iter().flatten());
        all.for_each(|(x, y)| *x += y);
    }
}

/// `W^n f(X/W, Y/W)` for the corners' mean `(X, Y, W)` with the weights `a`, `b`, `c`: its coefficients are
/// the Bernstein coefficients times multinomials. By Horner's rule in `Y` and in `X`.
fn composed(form: &Form, n: usize, triangle: &[Corner; 3]) -> Barycentric {
    let of = |k: usize| [0, 1, 2].map(|corner| &triangle[corner][k]);
    let one = Barycentric::constant(Integer::from(1));
    let powers: Vec<Barycentric> =
        std::iter::successors(Some(one), |p| Some(p.times_linear(of(2)))).take(n + 1).collect();
    let horner = |degree: usize, of: [&Integer; 3], term: &dyn Fn(usize) -> Barycentric| {
        (0..degree).rev().fold(term(degree), |sum, k| {
            let mut next = sum.times_linear(of);
            next.add(&term(k));
            next
        })
    };
    horner(n, of(1), &|j| {
        let row = form.coefficient(j);
        horner(n - j, of(0), &|i| {
            let mut term = powers[n - j - i].clone();
            let c = row.coefficient(i);
            term.terms.iter_mut().flatten().for_each(|t| *t *= &c);
            term
        })
    })
}

/// The halves on both sides of the middle of the longest edge.
fn halves(triangle: &[Corner; 3]) -> [[Corner; 3]; 2] {
    let length = |i: usize| -> Integer {
        let ([ax, ay, _], [bx, by, _]) = (&triangle[i], &triangle[(i + 1) % 3]);
        (ax - bx) * (ax - bx) + (ay - by) * (ay - by)
    };
    let i = (0..3).max_by_key(|&i| length(i)).unwrap_or(0);
    let [a, b, c] = [0, 1, 2].map(|k| triangle[(i + k) % 3].clone());
    let middle = [0, 1, 2].map(|k| &a[k] + &b[k]);
    // All have the same weight, now doubled.
    let [a, b, c] = [a, b, c].map(|corner| corner.map(|x| x * 2));
    let [x, y, w] = middle;
    let middle = [x, y, w];
    [[a, middle.clone(), c.clone()], [middle, b, c]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::{Rational, integer, rational};

    fn form(terms: &[(i64, usize, usize)]) -> Form {
        let monomial = |&(c, i, j): &(i64, usize, usize)| {
            Form::monomial(Polynomial::monomial(integer(c), i), j)
        };
        terms.iter().map(monomial).fold(Form::zero(), |sum, term| sum.plus(&term))
    }

    fn corner(x: i64, y: i64, w: i64) -> Corner {
        [x, y, w].map(integer)
    }

    /// The polar form of `x² y` at three points is the mean of `x_a x_b y_c`.
    #[test]
    fn polar_forms_by_hand() {
        let points = [corner(1, 2, 1), corner(3, 5, 2), corner(-1, 7, 3)];
        let places = Places::new(&points.iter().collect::<Vec<_>>());
        let value = Rational::new(places.value(&form(&[(1, 2, 1)])), places.denominator.clone());
        let [(ax, ay), (bx, by), (cx, cy)] = [(1, 1, 2, 1), (3, 2, 5, 2), (-1, 3, 7, 3)]
            .map(|(a, b, c, d)| (rational(a, b), rational(c, d)));
        let sum = &ax * &bx * cy + &ax * &cx * by + &bx * &cx * ay;
        assert_eq!(value, sum / rational(3, 1));
        // At three times the same point it is the value.
        let places = Places::new(&[&points[1]; 3]);
        let value = Rational::new(places.value(&form(&[(1, 2, 1)])), places.denominator.clone());
        assert_eq!(value, rational(9 * 5, 8));
        // Also of a polynomial of lower degree.
        let value = Rational::new(places.value(&form(&[(7, 0, 0)])), places.denominator.clone());
        assert_eq!(value, rational(7, 1));
    }

    #[test]
    fn there_are_as_many_multisets_as_binomials_say() {
        assert_eq!(multisets(3, 4).len(), 15);
        assert_eq!(multisets(5, 2).len(), 15);
        assert_eq!(multisets(2, 0), [vec![0_usize; 0]]);
    }

    /// The coefficients are the values of the polar form at the corners times multinomials.
    #[test]
    fn composition_and_polar_forms_agree() {
        let f = form(&[(2, 3, 0), (-5, 1, 2), (7, 1, 1), (-1, 0, 1), (4, 0, 0)]);
        let triangle = [corner(1, 2, 3), corner(-4, 5, 3), corner(2, -7, 3)];
        let composed = composed(&f, 3, &triangle);
        let factorial = |k: usize| (1..=k as i64).product::<i64>();
        for i in 0..=3 {
            for j in 0..=3 - i {
                let set = [vec![0; i], vec![1; j], vec![2; 3 - i - j]].concat();
                let places = Places::new(&set.iter().map(|&k| &triangle[k]).collect::<Vec<_>>());
                // Over 3! 3³.
                let value = Rational::new(places.value(&f), integer(6));
                let multinomial = 6 / (factorial(i) * factorial(j) * factorial(3 - i - j));
                let expected = value * rational(multinomial, 1);
                assert_eq!(Rational::from(composed.terms[i][j].clone()), expected, "{i} {j}");
            }
        }
    }

    #[test]
    fn signs_on_a_square() {
        let point = |x, y| [rational(x, 2), rational(y, 2)];
        let square = Polygon::new(&[point(0, 0), point(2, 0), point(2, 2), point(0, 2)]).unwrap();
        let shown = |terms: &[(i64, usize, usize)]| {
            is_nowhere_positive(&form(terms), &square, &mut Work::new()).unwrap()
        };
        // (2x + y - 3)(…) in several shapes; x y - 1 touches at a corner.
        assert!(shown(&[(1, 1, 1), (-1, 0, 0)]));
        assert!(!shown(&[(3, 1, 1), (-2, 0, 0)]));
        // x² + y² - x - y vanishes at all corners; a hundredth more is positive there.
        assert!(shown(&[(1, 2, 0), (1, 0, 2), (-1, 1, 0), (-1, 0, 1)]));
        assert!(!shown(&[(100, 2, 0), (100, 0, 2), (-100, 1, 0), (-100, 0, 1), (1, 0, 0)]));
        // 1 - 8 (x - 1/2)² - … has its largest value, 1/100 or -1/100, in the middle.
        let hill =
            |top: i64| [(-800, 2, 0), (800, 1, 0), (-800, 0, 2), (800, 0, 1), (top - 400, 0, 0)];
        assert!(!shown(&hill(1)) && shown(&hill(-1)));
        assert!(shown(&[]));
    }
}
