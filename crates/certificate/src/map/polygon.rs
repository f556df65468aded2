//! Convex polygons with rational corners, exactly.

use std::cmp::Ordering;

use refinable_algebra::{GcdDomain, Integer, Ordered, Rational, Ring, clear_denominators, integer};

/// Integers `(X, Y, W)`, `W > 0`, that stand for the point `(X/W, Y/W)`.
pub(crate) type Corner = [Integer; 3];

/// A line `a x + b y = c`, in integers.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Line([Integer; 3]);

impl Line {
    /// The line; `None` if `a` and `b` are zero.
    pub fn new(a: &Rational, b: &Rational, c: &Rational) -> Option<Line> {
        let (_, cleared) = clear_denominators([a, b, c].into_iter());
        let line: [Integer; 3] = cleared.try_into().expect("three numbers are three");
        (!line[0].is_zero() || !line[1].is_zero()).then_some(Line(line))
    }

    /// How `a x + b y` compares with `c` at a point.
    pub fn compare(&self, point: &[Rational; 2]) -> Ordering {
        self.side(&corner(point)).compare_to_zero()
    }

    /// `a X + b Y - c W`: the sign tells the side.
    fn side(&self, corner: &Corner) -> Integer {
        let [a, b, c] = &self.0;
        let [x, y, w] = corner;
        a * x + b * y - c * w
    }

    /// The point that is on two lines that are not parallel.
    fn meet(&self, other: &Line) -> Corner {
        let ([a, b, c], [d, e, f]) = (&self.0, &other.0);
        let corner = [c * e - f * b, a * f - d * c, a * e - d * b];
        let divisor = corner.iter().fold(Integer::zero(), |g, x| GcdDomain::gcd(&g, x));
        let negative = corner[2].compare_to_zero().is_lt();
        corner.map(|x| if negative { -x / &divisor } else { x / &divisor })
    }
}

/// A convex polygon with its corners in counterclockwise order and the lines through its edges, the
/// `i`-th from corner `i` to the next. Corners on an edge are allowed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Polygon {
    corners: Vec<Corner>,
    edges: Vec<Line>,
}

impl Polygon {
    /// The hull of points in counterclockwise order; `None` if they are not the corners of a convex
    /// polygon with an interior.
    pub fn new(points: &[[Rational; 2]]) -> Option<Polygon> {
        let n = points.len();
        let after = |i: usize| &points[(i + 1) % n];
        let turns = (0..n).all(|i| {
            let ([ax, ay], [bx, by], [cx, cy]) = (&points[i], after(i), after(i + 1));
            (bx - ax) * (cy - by) > (by - ay) * (cx - bx)
        });
        let edge = |i: usize| {
            let ([ax, ay], [bx, by]) = (&points[i], after(i));
            let (a, b) = (by - ay, ax - bx);
            Line::new(&a, &b, &(&a * ax + &b * ay))
        };
        let edges: Vec<Line> = (0..n).map(edge).collect::<Option<_>>()?;
        // A closed chain of left turns may still go round more than once.
        let crossings =
            (0..n).filter(|&i| points[i][1] < after(i)[1] && after(i)[1] >= after(i + 1)[1]);
        (n >= 3 && turns && crossings.count() == 1)
            .then(|| Polygon { corners: points.iter().map(corner).collect(), edges })
    }

    /// The corners.
    pub fn points(&self) -> Vec<[Rational; 2]> {
        let point = |[x, y, w]: &Corner| [x, y].map(|t| Rational::new(t.clone(), w.clone()));
        self.corners.iter().map(point).collect()
    }

    /// The corners as integers.
    pub(crate) fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The parts where `a x + b y ≤ c` and where it is `≥ c`; `None` for a part without interior.
    pub fn cut(&self, line: &Line) -> [Option<Polygon>; 2] {
        let sides: Vec<Integer> = self.corners.iter().map(|corner| line.side(corner)).collect();
        [-1, 1].map(|sign| self.part(line, &sides, &integer(sign)))
    }

    /// The part whose side has the sign.
    fn part(&self, line: &Line, sides: &[Integer], sign: &Integer) -> Option<Polygon> {
        let n = self.corners.len();
        let side = |i: usize| (&sides[i % n] * sign).compare_to_zero();
        (0..n).find(|&i| side(i).is_gt())?;
        let mut part = Polygon { corners: Vec::new(), edges: Vec::new() };
        for i in 0..n {
            // A corner on the line counts as inside.
            let (here, next) = (side(i).is_ge(), side(i + 1).is_ge());
            if here {
                part.corners.push(self.corners[i].clone());
                let along = if side(i).is_eq() && !next { line } else { &self.edges[i] };
                part.edges.push(along.clone());
            }
            let crosses = here != next && !side(i).is_eq() && !side(i + 1).is_eq();
            if crosses {
                part.corners.push(self.edges[i].meet(line));
                part.edges.push(if here { line.clone() } else { self.edges[i].clone() });
            }
        }
        Some(part)
    }

    /// Whether a point is in the closed polygon.
    pub fn contains(&self, point: &[Rational; 2]) -> bool {
        let corner = corner(point);
        let inside = |edge: &Line, from: &Corner, to: &Corner| {
            // The polygon is to the left of its edges.
            let ([ax, ay, aw], [bx, by, bw]) = (from, to);
            let ([a, b, _], [dx, dy]) = (&edge.0, [bx * aw - ax * bw, by * aw - ay * bw]);
            let left = b * &dx - a * &dy;
            (left * edge.side(&corner)).compare_to_zero().is_ge()
        };
        let n = self.corners.len();
        let ends = (0..n).map(|i| (&self.corners[i], &self.corners[(i + 1) % n]));
        self.edges.iter().zip(ends).all(|(edge, (from, to))| inside(edge, from, to))
    }
}

fn corner([x, y]: &[Rational; 2]) -> Corner {
    let w = refinable_algebra::least_common_multiple(x.denom(), y.denom());
    let scaled = |t: &Rational| t.numer() * (&w / t.denom());
    [scaled(x), scaled(y), w]
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    fn point(x: i64, y: i64) -> [Rational; 2] {
        [rational(x, 1), rational(y, 1)]
    }

    fn square() -> Polygon {
        Polygon::new(&[point(0, 0), point(2, 0), point(2, 2), point(0, 2)]).unwrap()
    }

    fn line(a: i64, b: i64, c: i64) -> Line {
        Line::new(&rational(a, 1), &rational(b, 1), &rational(c, 1)).unwrap()
    }

    /// Twice the area, by the shoelace formula.
    fn area(polygon: &Polygon) -> Rational {
        let points = polygon.points();
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|([ax, ay], [bx, by])| ax * by - bx * ay).sum()
    }

    #[test]
    fn parts_make_up_the_whole() {
        for (a, b, c) in [(1, 0, 1), (1, 1, 2), (1, 1, 1), (3, -2, 1), (-5, 7, 2), (2, 1, 4)] {
            let parts = square().cut(&line(a, b, c)).map(Option::unwrap);
            assert_eq!(area(&parts[0]) + area(&parts[1]), rational(8, 1), "{a} {b} {c}");
            for (part, sign) in parts.iter().zip([-1, 1]) {
                assert_eq!(Polygon::new(&part.points()).unwrap().points(), part.points());
                for [x, y] in part.points() {
                    let side = x * rational(a, 1) + y * rational(b, 1) - rational(c, 1);
                    assert!(side * rational(sign, 1) >= rational(0, 1));
                }
            }
        }
    }

    #[test]
    fn lines_beside_or_along_an_edge_cut_nothing_off() {
        for (a, b, c) in [(1, 0, 2), (1, 1, 4), (1, 0, 5)] {
            let [below, above] = square().cut(&line(a, b, c));
            assert_eq!(below.map(|p| p.points()), Some(square().points()));
            assert_eq!(above, None);
            let [below, above] = square().cut(&line(-a, -b, -c));
            assert_eq!((below, above.map(|p| p.points())), (None, Some(square().points())));
        }
    }

    /// Barycentric coordinates tell, at corners with different denominators.
    #[test]
    fn a_triangle_contains_the_means_of_its_corners() {
        let corners = [(0, 0), (3, 2), (2, 5)].map(|(p, q)| [rational(p, 7), rational(q, 4)]);
        let mut corners = corners.to_vec();
        corners[1][0] = rational(-3, 5);
        corners.reverse();
        let triangle = Polygon::new(&corners).unwrap();
        for i in -2..=6 {
            for j in -2..=6 {
                let weights = [i, j, 4 - i - j].map(|w| rational(w, 4));
                let mean = |k: usize| {
                    weights.iter().zip(&corners).map(|(w, corner)| w * &corner[k]).sum::<Rational>()
                };
                let inside = i >= 0 && j >= 0 && i + j <= 4;
                assert_eq!(triangle.contains(&[mean(0), mean(1)]), inside, "{i} {j}");
            }
        }
    }

    /// By the signs of the areas of the triangles with a point.
    #[test]
    fn triangles_of_all_shapes_contain_what_they_should() {
        let mut state = 7_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as i64
        };
        let mut point =
            || [rational(next() % 9 - 4, next() % 5 + 1), rational(next() % 9 - 4, next() % 7 + 1)];
        let turn =
            |[ax, ay]: &[Rational; 2], [bx, by]: &[Rational; 2], [cx, cy]: &[Rational; 2]| {
                ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).compare_to_zero()
            };
        let mut counts = [0, 0];
        for _ in 0..2000 {
            let [a, b, c, p] = [(); 4].map(|()| point());
            let Some(triangle) = Polygon::new(&[a.clone(), b.clone(), c.clone()]) else { continue };
            let turns = [turn(&a, &b, &p), turn(&b, &c, &p), turn(&c, &a, &p)];
            let inside = turns.iter().all(|turn| turn.is_ge());
            assert_eq!(triangle.contains(&p), inside, "{a:?} {b:?} {c:?} {p:?}");
            counts[usize::from(inside)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 50), "{counts:?}");
    }

    #[test]
    fn only_convex_polygons_in_order() {
        let points = [point(0, 0), point(2, 0), point(2, 2), point(0, 2)];
        let mut reversed = points.clone();
        reversed.reverse();
        assert_eq!(Polygon::new(&reversed), None);
        assert_eq!(Polygon::new(&points[..2]), None);
        assert_eq!(Polygon::new(&[point(0, 0), point(1, 1), point(2, 2)]), None);
        // A pentagram turns left all the way, twice round.
        let star = [(0, 10), (-6, -8), (10, 3), (-10, 3), (6, -8)].map(|(x, y)| point(x, y));
        assert_eq!(Polygon::new(&star), None);
    }

    #[test]
    fn points_on_the_boundary_belong_to_it() {
        let triangle = Polygon::new(&[point(0, 0), point(3, 1), point(1, 3)]).unwrap();
        for (x, y, inside) in
            [(1, 1, true), (3, 1, true), (2, 2, true), (0, 1, false), (3, 2, false), (2, 3, false)]
        {
            assert_eq!(triangle.contains(&point(x, y)), inside, "{x} {y}");
        }
    }
}
