//! Two polynomials in two parameters: their common real zeros, exactly.

use refinable_algebra::{Parameter, ParameterPolynomial, Polynomial, Ring};

use crate::algebraic::RealAlgebraic;
use crate::isolate::real_roots;
use crate::point::Point;
use crate::region::Interval;

/// The real points at which `f` and `g` both vanish, ordered by the first coordinate.
///
/// Every common zero projects to a root of `Res_y(f, g)` and to one of `Res_x(f, g)`; of these
/// finitely many pairs the true ones are picked by exact signs.
///
/// # Panics
/// If `f` and `g` have a common factor, or further parameters occur.
///
/// # Cost
/// Two resultants, and one exact sign per pair of roots.
pub fn common_zeros(
    f: &ParameterPolynomial,
    g: &ParameterPolynomial,
    [x, y]: [&Parameter; 2],
) -> Vec<Point> {
    let candidates = |eliminated: &Parameter, kept: &Parameter| -> Vec<RealAlgebraic> {
        let resultant = f.collected(eliminated).resultant(&g.collected(eliminated));
        let (_, p) = resultant.cleared_univariate(kept).expect("only two parameters occur");
        assert!(!p.is_zero(), "coprime polynomials have a nonzero resultant");
        real_roots(&p)
    };
    let ys = candidates(x, y);
    let mut zeros = Vec::new();
    for a in candidates(y, x) {
        for b in &ys {
            let point = Point::new([(x.clone(), a.clone()), (y.clone(), b.clone())]);
            if point.sign_of(f).is_eq() && point.sign_of(g).is_eq() {
                zeros.push(point);
            }
        }
    }
    zeros
}

/// Whether the curve `f = 0` in the plane of two parameters has a real point.
///
/// Between the zeros of the discriminant the number of real roots over `x` is constant, so one
/// sample for each gap decides all but finitely many vertical lines; a real point above those that
/// no sample sees is a multiple root (a simple one would persist nearby).
///
/// # Panics
/// If `f` is zero or not square-free, or further parameters occur.
pub fn has_real_point(f: &ParameterPolynomial, [x, y]: [&Parameter; 2]) -> bool {
    let collected = f.collected(y);
    if collected.is_constant() {
        return has_real_root(f, x);
    }
    let content = collected.content();
    if content.as_constant().is_none() && has_real_root(&content, x) {
        return true;
    }
    let primitive = collected.primitive_part();
    let derivative = primitive.derivative();
    let leading = primitive.leading().expect("not zero");
    let critical = primitive.resultant(&derivative).times(leading);
    let (_, critical) = critical.cleared_univariate(x).expect("only two parameters occur");
    let seen = Interval::LINE.gaps(&real_roots(&critical)).iter().any(|gap| {
        let sample = gap.sample();
        let fibre = primitive.map(|c| c.with(x, &sample));
        has_real_root(&ParameterPolynomial::from_collected(&fibre, y), y)
    });
    let back = |p: &Polynomial<ParameterPolynomial>| ParameterPolynomial::from_collected(p, y);
    seen || !common_zeros(&back(&primitive), &back(&derivative), [x, y]).is_empty()
}

fn has_real_root(p: &ParameterPolynomial, x: &Parameter) -> bool {
    let (_, p) = p.cleared_univariate(x).expect("only one parameter occurs");
    p.is_zero() || !real_roots(&p).is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn xy() -> (Parameter, Parameter, ParameterPolynomial, ParameterPolynomial) {
        let (x, y) = (Parameter::new("x"), Parameter::new("y"));
        let (px, py) = (ParameterPolynomial::parameter(&x), ParameterPolynomial::parameter(&y));
        (x, y, px, py)
    }

    #[test]
    fn a_circle_meets_a_hyperbola_in_four_irrational_points() {
        let (x, y, px, py) = xy();
        // x² + y² = 4, x y = 1: x = ±(√6 ± √2)/2
        let circle = px.power(2).plus(&py.power(2)).minus(&ParameterPolynomial::from_i64(4));
        let hyperbola = px.times(&py).minus(&ParameterPolynomial::one());
        let zeros = common_zeros(&circle, &hyperbola, [&x, &y]);
        assert_eq!(zeros.len(), 4);
        assert_eq!(zeros[3].coordinates()[&x].decimal(8), "1.9318517");
        assert_eq!(zeros[3].coordinates()[&y].decimal(8), "0.51763809");
    }

    #[test]
    fn a_line_meets_a_parabola_where_it_should() {
        let (x, y, px, py) = xy();
        let parabola = py.minus(&px.power(2));
        let line = py.minus(&px).minus(&ParameterPolynomial::from_i64(2));
        let zeros = common_zeros(&parabola, &line, [&x, &y]);
        let expected = [(-1, 1), (2, 4)].map(|(a, b)| {
            Point::new([(x.clone(), rational(a, 1).into()), (y.clone(), rational(b, 1).into())])
        });
        assert_eq!(zeros, expected);
    }

    #[test]
    fn curves_without_real_points_are_recognised() {
        let (x, y, px, py) = xy();
        let int = ParameterPolynomial::from_i64;
        let squares = px.power(2).plus(&py.power(2));
        assert!(!has_real_point(&squares.plus(&int(1)), [&x, &y]));
        assert!(has_real_point(&squares, [&x, &y])); // the origin alone
        assert!(has_real_point(&squares.minus(&int(1)), [&x, &y]));
        assert!(has_real_point(&px.minus(&int(3)), [&x, &y]));
        assert!(!has_real_point(&px.power(2).plus(&int(3)), [&x, &y]));
        // (x² + 1)(y² ± 1), of which the first factor has no real point.
        let factor = px.power(2).plus(&int(1));
        let [plus, minus] = [1, -1].map(|c| factor.times(&py.power(2).plus(&int(c))));
        assert!(!has_real_point(&plus, [&x, &y]) && has_real_point(&minus, [&x, &y]));
    }
}
