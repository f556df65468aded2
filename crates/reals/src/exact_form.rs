//! How an exact real number is written down.

use refinable_algebra::{
    Domain, Integer, Ordered, Polynomial, Rational, Ring, SquareFree, integer, rational,
};

use crate::algebraic::RealAlgebraic;
use crate::isolate::real_roots;
use crate::point::enclosed_product;

/// A way to write a real algebraic number; for degree one and two the only one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ExactForm {
    /// A rational number.
    Rational(Rational),
    /// A number of degree two.
    Radical(Radical),
    /// The `index`-th real root (ascending, from 1) of a square-free primitive integer polynomial.
    Root {
        /// The polynomial.
        polynomial: Polynomial<Integer>,
        /// Which of its real roots, from 1.
        index: usize,
    },
}

/// `(rational_part + coefficient · √radicand) / denominator`, the denominator positive, no common
/// factor of the three; the radicand is free of the squares of small primes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Radical {
    /// The integer beside the root.
    pub rational_part: Integer,
    /// The integer in front of the root.
    pub coefficient: Integer,
    /// What stands under the root, at least 2.
    pub radicand: Integer,
    /// The positive integer below the bar.
    pub denominator: Integer,
}

impl ExactForm {
    /// The form of `x`: rational if it is, radical if a quadratic factor is found, root otherwise.
    pub(crate) fn of(x: &RealAlgebraic) -> Self {
        let square_free = SquareFree::part_of(&x.polynomial()).polynomial().clone();
        if square_free.surely_has_no_factor_up_to(2) {
            let roots = real_roots(&square_free);
            return ExactForm::root(square_free, &roots, x);
        }
        let x = x.simplified();
        if let Some(x) = x.as_rational() {
            return ExactForm::Rational(x.clone());
        }
        let (polynomial, roots) = without_rational_roots(square_free);
        if polynomial.surely_has_no_factor_up_to(2) {
            return ExactForm::root(polynomial, &roots, &x);
        }
        let mut others = roots.iter().filter(|other| **other != x);
        match others.find_map(|other| quadratic_factor(&polynomial, &x, other)) {
            Some(factor) => ExactForm::Radical(radical(&factor, &x)),
            None => ExactForm::root(polynomial, &roots, &x),
        }
    }

    fn root(polynomial: Polynomial<Integer>, roots: &[RealAlgebraic], x: &RealAlgebraic) -> Self {
        let at = roots.iter().position(|root| root == x);
        ExactForm::Root { polynomial, index: at.expect("x is one of the roots") + 1 }
    }

    /// `p/q`, `(3 - sqrt(3))/64` without blanks, or `root(32*w^3 + 4*w - 1, 1)`.
    pub fn display(&self, variable: &str) -> String {
        match self {
            ExactForm::Rational(x) => x.to_string(),
            ExactForm::Radical(radical) => radical.to_string(),
            ExactForm::Root { polynomial, index } => {
                format!("root({}, {index})", polynomial.display(variable))
            }
        }
    }
}

impl std::fmt::Display for Radical {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let one = integer(1);
        let size = self.coefficient.absolute();
        let root = match size == one {
            true => format!("sqrt({})", self.radicand),
            false => format!("{size}*sqrt({})", self.radicand),
        };
        let negative = self.coefficient.compare_to_zero().is_lt();
        let top = match (self.rational_part.is_zero(), negative) {
            (true, false) => root,
            (true, true) => format!("-{root}"),
            (false, false) => format!("{}+{root}", self.rational_part),
            (false, true) => format!("{}-{root}", self.rational_part),
        };
        match (self.denominator == one, self.rational_part.is_zero()) {
            (true, _) => f.write_str(&top),
            (false, true) => write!(f, "{top}/{}", self.denominator),
            (false, false) => write!(f, "({top})/{}", self.denominator),
        }
    }
}

/// A square-free polynomial divided by the linear factors of all rational roots, and the real roots
/// that are left.
fn without_rational_roots(
    mut rest: Polynomial<Integer>,
) -> (Polynomial<Integer>, Vec<RealAlgebraic>) {
    let mut irrational = Vec::new();
    for root in real_roots(&rest).iter().map(RealAlgebraic::simplified) {
        match root.as_rational() {
            Some(_) => rest = rest.quotient(&root.polynomial()),
            None => irrational.push(root),
        }
    }
    (rest, irrational)
}

/// The primitive quadratic factor of `p` with the roots `x` and `y`, if there is one.
///
/// Its leading coefficient divides the leading coefficient `c` of `p`, so `c (x + y)` and `c x y`
/// are integers: enclosures narrower than one leave a single candidate, tested by division.
fn quadratic_factor(
    p: &Polynomial<Integer>,
    x: &RealAlgebraic,
    y: &RealAlgebraic,
) -> Option<Polynomial<Integer>> {
    let c = Rational::from(p.leading()?.clone());
    let (mut x, mut y) = (x.clone(), y.clone());
    let (sum, product) = loop {
        let (xs, ys) = (x.bounds(), y.bounds());
        let sums = ((&xs.0 + &ys.0) * &c, (&xs.1 + &ys.1) * &c);
        let (lower, upper) = enclosed_product(&xs, &ys);
        let products = (lower * &c, upper * &c);
        let narrow = |(lower, upper): &(Rational, Rational)| upper - lower < rational(1, 1);
        if narrow(&sums) && narrow(&products) {
            break (only_integer(&sums)?, only_integer(&products)?);
        }
        (x, y) = (x.halved(), y.halved());
    };
    let factor = Polynomial::new(vec![product, -sum, c.to_integer()]).primitive_part();
    // Another quadratic factor may fit the enclosures: this one must have the root x.
    (x.sign_of(&factor).is_eq() && p.divide_exactly(&factor).is_some()).then_some(factor)
}

/// The only integer in a closed interval shorter than one.
fn only_integer((lower, upper): &(Rational, Rational)) -> Option<Integer> {
    let candidate = upper.floor();
    (candidate >= *lower).then(|| candidate.to_integer())
}

/// The root `x` of `A x² + B x + C` as `(-B ± k√d) / 2A` with `k² d = B² - 4AC`.
fn radical(factor: &Polynomial<Integer>, x: &RealAlgebraic) -> Radical {
    let [c, b, a] = [0, 1, 2].map(|k| factor.coefficient(k));
    let (outside, radicand) = split_square(&b * &b - integer(4) * &a * &c);
    // A > 0: the larger root takes the plus sign, and the smaller one lies below -B/2A.
    let vertex = RealAlgebraic::from(Rational::new(-b.clone(), integer(2) * &a));
    let coefficient = if *x > vertex { outside } else { -outside };
    let denominator = integer(2) * a;
    let common = [&coefficient, &denominator]
        .into_iter()
        .fold(b.absolute(), |g, n| refinable_algebra::GcdDomain::gcd(&g, n));
    Radical {
        rational_part: -b / &common,
        coefficient: coefficient / &common,
        radicand,
        denominator: denominator / &common,
    }
}

/// `n = k² d` with the squares of primes below 1000 taken out; `n` is no square.
fn split_square(n: Integer) -> (Integer, Integer) {
    let (mut outside, mut inside) = (integer(1), n);
    for k in 2..1000 {
        let square = integer(k * k);
        while let Some(quotient) = inside.divide_exactly(&square) {
            outside *= integer(k);
            inside = quotient;
        }
    }
    (outside, inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
        Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
    }

    fn forms(coefficients: &[i64]) -> Vec<String> {
        real_roots(&poly(coefficients)).iter().map(|x| x.exact_form().display("t")).collect()
    }

    #[test]
    fn radicals_in_the_normal_form_of_the_contract() {
        // 4096 t² - 384 t + 6 = 0: t = (3 ± √3)/64
        assert_eq!(forms(&[6, -384, 4096]), ["(3-sqrt(3))/64", "(3+sqrt(3))/64"]);
        // 16 t² + 4 t - 1 = 0: t = (-1 ± √5)/8
        assert_eq!(forms(&[-1, 4, 16]), ["(-1-sqrt(5))/8", "(-1+sqrt(5))/8"]);
        assert_eq!(forms(&[-2, 0, 1]), ["-sqrt(2)", "sqrt(2)"]);
        assert_eq!(forms(&[-1, 0, 12]), ["-sqrt(3)/6", "sqrt(3)/6"]);
    }

    #[test]
    fn a_quadratic_factor_hides_in_a_larger_polynomial() {
        // (t² - t - 1)(t³ - 2)
        let p = poly(&[-1, -1, 1]).times(&poly(&[-2, 0, 0, 1]));
        let forms: Vec<String> =
            real_roots(&p).iter().map(|x| x.exact_form().display("t")).collect();
        assert_eq!(
            forms,
            ["(1-sqrt(5))/2", "root(t^5 - t^4 - t^3 - 2*t^2 + 2*t + 2, 2)", "(1+sqrt(5))/2"]
        );
    }

    #[test]
    fn irreducible_quartics_stay_roots() {
        // (x²-5)² - 24 = x⁴ - 10x² + 1, roots ±√2±√3
        assert_eq!(forms(&[1, 0, -10, 0, 1])[3], "root(t^4 - 10*t^2 + 1, 4)");
    }

    /// `(t³ - 2)((t - 10^30)² - 2)`: the product of the roots is enclosed less closely than their sum.
    #[test]
    fn a_quadratic_factor_with_large_roots() {
        let large = integer(10).power(30);
        let square = vec![&large * &large - integer(2), -&large * integer(2), integer(1)];
        let p = Polynomial::new(square).times(&poly(&[-2, 0, 0, 1]));
        let forms = real_roots(&p).into_iter().map(|x| x.exact_form().display("t"));
        let expected = ["-", "+"].map(|sign| format!("{large}{sign}sqrt(2)"));
        assert_eq!(forms.skip(1).collect::<Vec<_>>(), expected);
    }
}
