//! Common zeros in the plane, and curves with and without real points.

use std::collections::BTreeSet;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Integer, Ordered, ParameterPolynomial, Polynomial, Rational, Ring, integer, rational,
};
use refinable_reals::{
    Component, Point, common_zero_set, common_zeros, has_real_point, real_roots,
};
use refinable_tests::SturmChain;

use crate::generate::{in_parameter, plane, plane_polynomial, poly};

/// `a x + b y = c`
type Line = [i64; 3];

fn line() -> impl Strategy<Value = Line> {
    let zero_or_not = || prop_oneof![1 => Just(0i64), 3 => -4i64..=4];
    (zero_or_not(), zero_or_not(), -4i64..=4)
        .prop_map(|(a, b, c)| [a, b, c])
        .prop_filter("a line", |[a, b, _]| (*a, *b) != (0, 0))
}

fn coordinates() -> [ParameterPolynomial; 2] {
    plane().map(|p| ParameterPolynomial::parameter(&p))
}

/// `a x + b y - c`
fn linear([a, b, c]: Line) -> ParameterPolynomial {
    let [x, y] = coordinates();
    x.scaled(&rational(a, 1))
        .plus(&y.scaled(&rational(b, 1)))
        .minus(&ParameterPolynomial::from_i64(c))
}

fn product(lines: &[Line]) -> ParameterPolynomial {
    let factors = lines.iter().map(|line| linear(*line));
    factors.fold(ParameterPolynomial::one(), |product, f| product.times(&f))
}

fn determinant([a, b]: [i64; 2], [c, d]: [i64; 2]) -> i64 {
    a * d - b * c
}

/// The common point of two lines, by Cramer's rule; `None` if they are parallel.
fn meet([a, b, c]: Line, [d, e, f]: Line) -> Option<(Rational, Rational)> {
    let denominator = determinant([a, b], [d, e]);
    (denominator != 0).then(|| {
        (
            rational(determinant([c, b], [f, e]), denominator),
            rational(determinant([a, c], [d, f]), denominator),
        )
    })
}

fn same_line(g: Line, h: Line) -> bool {
    let minors = [[0, 1], [0, 2], [1, 2]];
    minors.iter().all(|[i, j]| g[*i] * h[*j] == g[*j] * h[*i])
}

fn zeros(f: &ParameterPolynomial, g: &ParameterPolynomial) -> Vec<Point> {
    let [x, y] = plane();
    common_zeros(f, g, [&x, &y])
}

fn real_point(f: &ParameterPolynomial) -> bool {
    let [x, y] = plane();
    has_real_point(f, [&x, &y])
}

fn rational_points(points: &[Point]) -> Option<Vec<(Rational, Rational)>> {
    let [x, y] = plane();
    let pairs = points.iter().map(|point| {
        let [a, b] = [&x, &y].map(|p| point.coordinates()[p].as_rational().cloned());
        a.zip(b)
    });
    pairs.collect()
}

/// Whether a rational point lies on the piece.
fn lies_on(piece: &Component, (a, b): &(Rational, Rational)) -> bool {
    let [x, y] = plane();
    match piece {
        Component::Space => true,
        Component::Hypersurface(f) => f.with(&x, a).with(&y, b).is_zero(),
        Component::Point(point) => {
            let coordinates = [(x, a.clone().into()), (y, b.clone().into())];
            *point == Point::new(coordinates)
        }
    }
}

/// `f(x, p(x))`, cleared of denominators.
fn on_graph(f: &ParameterPolynomial, p: &Polynomial<Integer>) -> Polynomial<Integer> {
    let [x, y] = plane();
    let value = f.collected(&y).evaluate(&in_parameter(p, &x));
    value.cleared_univariate(&x).expect("x alone is left").1
}

/// A rational point in every gap between the real roots of `p`, by Sturm.
fn samples(p: &Polynomial<Integer>) -> Vec<Rational> {
    let found = SturmChain::of(p).isolate(&rational(1, 1 << 12));
    let mut samples: Vec<Rational> = found.iter().map(|(lower, _)| lower.clone()).collect();
    samples.push(found.last().map_or_else(Rational::zero, |(_, upper)| upper + integer(1)));
    samples
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn products_of_lines_meet_where_cramer_says(
        f in vec(line(), 1..=3),
        g in vec(line(), 1..=3),
    ) {
        let mut pairs = f.iter().flat_map(|a| g.iter().map(move |b| (*a, *b)));
        prop_assume!(pairs.clone().all(|(a, b)| !same_line(a, b)));
        let expected: BTreeSet<_> = pairs.by_ref().filter_map(|(a, b)| meet(a, b)).collect();
        let found = zeros(&product(&f), &product(&g));
        prop_assert_eq!(rational_points(&found), Some(expected.into_iter().collect()));
    }

    #[test]
    fn a_graph_meets_a_curve_as_often_as_sturm_counts(
        p in vec(-4i64..=4, 1..=3).prop_map(|c| poly(&c)),
        f in plane_polynomial(),
    ) {
        let [x, y] = plane();
        let eliminated = on_graph(&f, &p);
        prop_assume!(!eliminated.is_zero());
        let graph = coordinates()[1].minus(&in_parameter(&p, &x));
        let found = zeros(&graph, &f);
        prop_assert_eq!(found.len(), SturmChain::of(&eliminated).count());
        let width = rational(1, 1 << 30);
        for (point, root) in found.iter().zip(real_roots(&eliminated)) {
            prop_assert_eq!(&point.coordinates()[&x], &root);
            let (below, _) = point.coordinates()[&x].enclosure(&width);
            let (height, _) = point.coordinates()[&y].enclosure(&width);
            prop_assert!((p.value_at(&below) - height).absolute() < rational(1, 1 << 10));
        }
    }

    #[test]
    fn zeros_do_not_depend_on_the_order_of_the_polynomials(
        p in vec(-4i64..=4, 1..=3).prop_map(|c| poly(&c)),
        f in plane_polynomial(),
    ) {
        let [x, y] = plane();
        prop_assume!(!on_graph(&f, &p).is_zero());
        let graph = coordinates()[1].minus(&in_parameter(&p, &x));
        let found = zeros(&graph, &f);
        prop_assert_eq!(&zeros(&f, &graph), &found);
        let swapped = common_zeros(&graph, &f, [&y, &x]);
        prop_assert_eq!(swapped.len(), found.len());
        prop_assert!(found.iter().all(|point| swapped.contains(point)));
    }

    #[test]
    fn a_grid_is_the_product_of_its_sides(
        p in vec(-6i64..=6, 1..=4).prop_map(|c| poly(&c)),
        q in vec(-6i64..=6, 1..=3).prop_map(|c| poly(&c)),
    ) {
        prop_assume!(!p.is_zero() && !q.is_zero());
        let [x, y] = plane();
        let found = zeros(&in_parameter(&p, &x), &in_parameter(&q, &y));
        let columns = SturmChain::of(&p).count();
        prop_assert_eq!(found.len(), columns * SturmChain::of(&q).count());
    }

    #[test]
    fn the_pieces_of_a_common_zero_set_of_lines_hold_its_points_and_no_others(
        pool in vec(line(), 4),
        choices in vec(vec(0usize..4, 0..=3), 1..=3),
    ) {
        // Every polynomial is a product of lines of the pool, so that they share curves.
        let chosen = choices.iter().map(|c| c.iter().map(|k| pool[*k]).collect::<Vec<_>>());
        let products: Vec<Vec<Line>> = chosen.collect();
        let polynomials: Vec<_> = products.iter().map(|lines| product(lines)).collect();
        let pieces = common_zero_set(&polynomials, &plane()).unwrap();
        let grid = (-4i64..=4).flat_map(|a| (-4i64..=4).map(move |b| (a, b)));
        let grid = grid.map(|(a, b)| (rational(a, 1), rational(b, 1)));
        let meets = pool.iter().flat_map(|g| pool.iter().filter_map(|h| meet(*g, *h)));
        for point in meets.chain(grid) {
            let on_line = |[a, b, c]: &Line| {
                &point.0 * integer(*a) + &point.1 * integer(*b) == rational(*c, 1)
            };
            let expected = products.iter().all(|lines| lines.iter().any(on_line));
            prop_assert_eq!(pieces.iter().any(|piece| lies_on(piece, &point)), expected);
        }
        for (k, piece) in pieces.iter().enumerate() {
            prop_assert!(!pieces[..k].contains(piece));
        }
    }

    #[test]
    fn a_sum_of_two_squares_has_a_real_point_iff_nothing_positive_is_added(
        g in line(),
        h in line(),
        constant in prop_oneof![Just(0i64), -3i64..=3],
    ) {
        prop_assume!(determinant([g[0], g[1]], [h[0], h[1]]) != 0);
        let squares = linear(g).power(2).plus(&linear(h).power(2));
        let curve = squares.plus(&ParameterPolynomial::from_i64(constant));
        prop_assert_eq!(real_point(&curve), constant <= 0);
        let with_line = curve.times(&linear(g)).square_free_part();
        prop_assert!(real_point(&with_line));
    }

    #[test]
    fn a_curve_of_degree_two_in_y_has_a_real_point_iff_a_quotient_is_not_negative(
        s in vec(-4i64..=4, 1..=4).prop_map(|c| poly(&c)),
        q in vec(-4i64..=4, 1..=4).prop_map(|c| poly(&c)),
    ) {
        prop_assume!(!s.is_zero() && !q.is_zero());
        let [x, _] = plane();
        let [_, y] = coordinates();
        // s(x) y² + q(x) = 0: where q vanishes take y = 0; else s and q must differ in sign.
        let curve = in_parameter(&s, &x).times(&y.power(2)).plus(&in_parameter(&q, &x));
        let opposite = |t: &Rational| {
            let product = s.value_at(t) * q.value_at(t);
            product.compare_to_zero().is_lt()
        };
        let expected = SturmChain::of(&q).count() > 0
            || samples(&s.times(&q)).iter().any(opposite);
        prop_assert_eq!(real_point(&curve.square_free_part()), expected);
    }

    #[test]
    fn a_definite_form_times_anything_has_the_real_points_of_the_other(
        p in vec(-4i64..=4, 1..=3).prop_map(|c| poly(&c)),
        n in 1i64..=5,
    ) {
        // (x² + y² + n) (y² - p(x)), the second with a real point iff p ≥ 0 somewhere.
        let [x, _] = plane();
        let [px, py] = coordinates();
        let definite = px.power(2).plus(&py.power(2)).plus(&ParameterPolynomial::from_i64(n));
        let other = py.power(2).minus(&in_parameter(&p, &x));
        let somewhere = p.is_zero()
            || SturmChain::of(&p).count() > 0
            || p.value_at(&Rational::zero()).compare_to_zero().is_gt();
        let curve = definite.times(&other).square_free_part();
        prop_assert_eq!(real_point(&curve), somewhere);
    }
}

/// The limits from both sides: `x^200 = 1` is solved and `x^201 = 1` is not, nor are curves beyond degree 24.
#[test]
fn degrees_that_are_not_solved() {
    let ([x, y], names) = (coordinates(), plane());
    let one = ParameterPolynomial::one();
    let unity = |n| common_zero_set(&[x.power(n).minus(&one)], &names[..1]);
    assert_eq!(unity(200).map(|roots| roots.len()).ok(), Some(2));
    assert!(unity(201).is_err());
    let graph = |n| common_zero_set(&[x.power(n).plus(&y)], &names);
    assert!(matches!(&graph(24).unwrap()[..], [Component::Hypersurface(_)]));
    assert!(graph(25).is_err());
}
