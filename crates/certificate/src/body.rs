//! The body of a polytope: its vertices, their combinations, its gauge.

use refinable_algebra::{Integer, Ordered, Ring};

use crate::fixed::{SCALE, divide_up, one, ratio_up, shift_up, times_up};
use crate::model::{Polytope, Term};
use crate::orbit::apply;
use crate::position::Position;
use crate::work::{Check, Work, ensure, fail};

/// The polytope with its mirror images and conjugates, and what is known about its gauge.
pub(crate) struct Body<'a> {
    polytope: &'a Polytope,
    dimension: usize,
    /// At `x_1`.
    list: List,
    /// At `x_0`, if the vertices move.
    moved: Option<List>,
    /// `‖v‖ ≤ κ ‖v‖_1`, in fixed point.
    gauge: Integer,
}

/// The vertices at an end.
struct List {
    /// With the mirror images, but without the conjugates; of a complex one the real parts of all
    /// coordinates and then the imaginary parts, as in the certificate.
    vertices: Vec<Vec<i64>>,
    /// How far the vertices may be from the true ones, in the maximum norm, in fixed point.
    errors: Vec<Integer>,
}

impl List {
    fn new(mut vertices: Vec<Vec<i64>>, mut errors: Vec<Integer>, mirror: Option<usize>) -> Self {
        if let Some(dimension) = mirror {
            let mirrored = vertices.clone().into_iter().map(|mut v| {
                v.chunks_mut(dimension).for_each(<[i64]>::reverse);
                v
            });
            vertices.extend(mirrored.collect::<Vec<_>>());
            errors.extend_from_within(..);
        }
        List { vertices, errors }
    }
}

/// What a combination leaves of an image.
struct Rest {
    /// An upper bound for `Σ|λ|`, an integer over `2^weight_bits`.
    weight: Integer,
    vector: Vec<Integer>,
    denominator: Integer,
    /// An upper bound for the `1`-norm of its error, in fixed point.
    error: Integer,
}

impl Rest {
    /// A bound for its `1`-norm with all errors, in fixed point.
    fn norm(&self) -> Integer {
        ratio_up(&norm(self.vector.iter().cloned()), &self.denominator) + &self.error
    }
}

/// The value of a combination.
struct Sum {
    /// An upper bound for `Σ|λ|`, an integer over `2^weight_bits`.
    weight: Integer,
    /// `Σ λ u`, over `2^(bits + weight_bits)`.
    vector: Vec<Integer>,
    /// An upper bound for the `1`-norm of its error, in fixed point.
    error: Integer,
}

impl<'a> Body<'a> {
    /// The errors are those of the vertices of the certificate.
    pub fn new(
        polytope: &'a Polytope,
        dimension: usize,
        errors: Vec<Integer>,
        work: &mut Work,
    ) -> Check<Self> {
        let mirror = polytope.mirrored.then_some(dimension);
        // The vertices at the rational inner end are what they are.
        let exact = vec![Integer::zero(); errors.len()];
        let moved = polytope.motion.as_ref();
        let moved = moved.map(|moved| List::new(moved.vertices.clone(), exact, mirror));
        let list = List::new(polytope.vertices.clone(), errors, mirror);
        let gauge = Integer::zero();
        let mut body = Body { polytope, dimension, list, moved, gauge };
        for side in [Side::End, Side::Inner] {
            body.gauge = body.bound_gauge(side, work)?.max(body.gauge);
        }
        Ok(body)
    }

    /// The vertices at an end.
    fn at(&self, side: Side) -> &List {
        match (&self.moved, side) {
            (Some(moved), Side::Inner) => moved,
            _ => &self.list,
        }
    }

    /// `κ = Γ / (1 - δ)` from the units.
    fn bound_gauge(&self, side: Side, work: &mut Work) -> Check<Integer> {
        let scale = u64::from(self.polytope.bits + self.polytope.weight_bits);
        let (mut largest_weight, mut largest_rest) = (Integer::zero(), Integer::zero());
        for (i, unit) in self.polytope.units.iter().enumerate() {
            let Some(terms) = unit else { return fail("a unit is null") };
            let sum = self.sum(side, terms, work)?;
            let mut rest = sum.vector;
            rest[i] -= Integer::from(1) << scale;
            let rest = (norm(rest) << (SCALE - scale)) + sum.error;
            largest_weight = largest_weight.max(sum.weight);
            largest_rest = largest_rest.max(rest);
        }
        let gap = one() - largest_rest;
        ensure(gap > Integer::zero(), "the units do not show that the polytope has an interior")?;
        // Γ = weight / 2^weight_bits, in fixed point twice for the quotient.
        let numerator = largest_weight << (2 * SCALE - u64::from(self.polytope.weight_bits));
        Ok(divide_up(&numerator, &gap))
    }

    /// A vertex as a place in the list, and whether the conjugate is meant.
    fn vertex(&self, index: usize) -> Check<(usize, bool)> {
        let count = self.list.vertices.len();
        if index < count {
            Ok((index, false))
        } else if self.polytope.complex && index - count < count {
            Ok((index - count, true))
        } else {
            fail("a combination has an index that is no vertex")
        }
    }

    fn sum(&self, side: Side, terms: &[Term], work: &mut Work) -> Check<Sum> {
        let List { vertices, errors } = self.at(side);
        // A complex product takes four real ones.
        let products = self.dimension * if self.polytope.complex { 4 } else { 1 };
        work.products(terms.len() * (products + 1), 64, 64)?;
        let length = self.dimension * if self.polytope.complex { 2 } else { 1 };
        let mut vector = vec![Integer::zero(); length];
        let (mut weight, mut error) = (0, Integer::zero());
        for term in terms {
            ensure(
                term.im == 0 || self.polytope.complex,
                "a weight of a real polytope is not real",
            )?;
            let (place, conjugate) = self.vertex(term.index)?;
            add_multiple(&mut vector, self.dimension, term, &vertices[place], conjugate);
            let modulus = modulus_up(term);
            weight += modulus;
            if !errors[place].is_zero() {
                error += &errors[place] * modulus;
            }
        }
        // ‖Σ λ (u - ũ)‖_1 ≤ d Σ|λ| η
        let error = shift_up(&(error * self.dimension), u64::from(self.polytope.weight_bits));
        Ok(Sum { weight: weight.into(), vector, error })
    }

    /// Whether the image of a vertex of the certificate is shown to be in the interior, by
    /// `Σ|λ| + κ ‖r‖_1 < 1` with the residual `r`; or in the body at all if its boundary is
    /// allowed, for which it must be met exactly.
    pub fn has_image(
        &self,
        place: &Place,
        image: Image,
        terms: &[Term],
        work: &mut Work,
    ) -> Check<bool> {
        let rest = self.rest(place, place.side, image, terms, work)?;
        let norm = rest.norm();
        let gauge = self.in_fixed_point(&rest.weight) + times_up(&self.gauge, &norm);
        let boundary = self.polytope.open && place.side == Side::End;
        Ok(gauge < one() || boundary && norm.is_zero() && gauge == one())
    }

    /// Whether the image stays inside between the ends while the vertices move: the middle one of the
    /// Bernstein coefficients. It is the mean of the others if they do not move.
    pub fn has_path(
        &self,
        (inner, end): (&Place, &Place),
        image: Image,
        (at_inner, at_end, rest): (&[Term], &[Term], &[Term]),
        work: &mut Work,
    ) -> Check<bool> {
        // B(x_1) u' - Σ λ u' + B(x_0) u - Σ λ' u, twice the coefficient.
        let a = self.rest(end, Side::Inner, image, at_end, work)?;
        let b = self.rest(inner, Side::End, image, at_inner, work)?;
        work.products(2 * a.vector.len(), a.denominator.bits() + 64, b.denominator.bits())?;
        let both = a.vector.iter().zip(&b.vector);
        let sum: Vec<Integer> =
            both.map(|(x, y)| x * &b.denominator + y * &a.denominator).collect();
        // The rest stands for the same combination at both ends.
        let denominator = &a.denominator * &b.denominator;
        let scale = u64::from(self.polytope.bits + self.polytope.weight_bits);
        let unit = &denominator >> scale;
        let mut weight = a.weight + b.weight;
        let mut largest = Integer::zero();
        for side in [Side::Inner, Side::End] {
            let rest = self.sum(side, rest, work)?;
            let left = sum.iter().zip(&rest.vector).map(|(s, r)| s - r * &unit);
            largest = largest.max(ratio_up(&norm(left), &denominator) + rest.error);
            if side == Side::End {
                weight += rest.weight;
            }
        }
        let norm = largest + a.error + b.error;
        Ok(self.in_fixed_point(&weight) + times_up(&self.gauge, &norm) < one() * 2)
    }

    /// The residual `B u - Σ λ u` with the matrices of one end and the vertices of an end.
    fn rest(
        &self,
        place: &Place,
        vertices: Side,
        image: Image,
        terms: &[Term],
        work: &mut Work,
    ) -> Check<Rest> {
        let (d, position) = (self.dimension, &place.position);
        let weight_bits = u64::from(self.polytope.weight_bits);
        let bits = u64::from(self.polytope.bits);
        let sum = self.sum(vertices, terms, work)?;
        let vector = &self.at(vertices).vertices[image.vertex];
        work.products((d + 1) * vector.len(), position.denominator.bits() + 64, 64)?;
        let matrix = &position.matrices[image.letter];
        let image_vector = vector.chunks(d).flat_map(|part| apply(d, matrix, part));
        let rest = image_vector
            .zip(&sum.vector)
            .map(|(a, b)| (a << weight_bits) - b * &position.denominator);
        let rest = rest.collect();
        let mut error = sum.error;
        let of_vertex = &self.at(vertices).errors[image.vertex];
        if !of_vertex.is_zero() {
            error += times_up(&place.norm, &(of_vertex * d));
        }
        if !position.error.is_zero() {
            let size = norm(vector.iter().map(|&x| x.into()));
            error += times_up(&position.error, &(size << (SCALE - bits)));
        }
        let denominator = &position.denominator << (weight_bits + bits);
        Ok(Rest { weight: sum.weight, vector: rest, denominator, error })
    }

    /// A weight, an integer over `2^weight_bits`.
    fn in_fixed_point(&self, weight: &Integer) -> Integer {
        weight << (SCALE - u64::from(self.polytope.weight_bits))
    }

    /// The combination that is a vertex or its opposite.
    pub fn unit_term(&self, Met { vertex, sign }: Met) -> Term {
        Term { index: vertex, re: i64::from(sign) << self.polytope.weight_bits, im: 0 }
    }
}

/// A vertex and a letter.
#[derive(Clone, Copy)]
pub(crate) struct Image {
    pub vertex: usize,
    pub letter: usize,
}

/// What an image is by construction: a vertex, or its opposite.
#[derive(Clone, Copy)]
pub(crate) struct Met {
    pub vertex: usize,
    pub sign: i32,
}

/// Which end of the interval.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Side {
    /// `x_0`.
    Inner,
    /// `x_1`.
    End,
}

/// An end of the interval.
pub(crate) struct Place {
    /// The matrices.
    position: Position,
    /// A bound for their norm by columns.
    norm: Integer,
    side: Side,
}

impl Place {
    /// The end with the matrices of this size.
    pub fn new(position: Position, dimension: usize, side: Side) -> Self {
        let norm = position.column_norm(dimension);
        Place { position, norm, side }
    }
}

/// Adds `(re + i im) u`, or with the conjugate of `u`.
fn add_multiple(sum: &mut [Integer], d: usize, term: &Term, vertex: &[i64], conjugate: bool) {
    // (a + ib)(x ± iy) = ax ∓ by + i(bx ± ay); both imaginary parts are empty if real.
    let (a, b) = (i128::from(term.re), i128::from(term.im));
    let sign = if conjugate { -1 } else { 1 };
    let (real, imaginary) = sum.split_at_mut(d);
    let (x, y) = vertex.split_at(d);
    add_real_multiple(real, a, x);
    add_real_multiple(imaginary, sign * a, y);
    if b != 0 {
        add_real_multiple(real, -sign * b, y);
        add_real_multiple(imaginary, b, x);
    }
}

fn add_real_multiple(sum: &mut [Integer], factor: i128, vector: &[i64]) {
    for (s, &x) in sum.iter_mut().zip(vector) {
        *s += factor * i128::from(x);
    }
}

/// The modulus of a weight, rounded upwards.
fn modulus_up(term: &Term) -> u128 {
    let [a, b] = [term.re, term.im].map(|x| u128::from(x.unsigned_abs()));
    if b == 0 {
        return a;
    }
    let square = a * a + b * b;
    let root = square.isqrt();
    if root * root == square { root } else { root + 1 }
}

/// The sum of the absolute values. Of the real and imaginary parts of a complex vector it is an
/// upper bound for the `1`-norm.
fn norm(vector: impl IntoIterator<Item = Integer>) -> Integer {
    vector.into_iter().map(|x| x.absolute()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polytope in the plane or in `C²`, without images; weights are quarters.
    fn polytope(complex: bool, mirrored: bool, vertices: &str, units: &str) -> Polytope {
        let text = format!(
            r#"{{"pencil": "scale", "inner": "0", "end": "1", "open": true, "complex": {complex},
                "mirrored": {mirrored}, "bits": 0, "vertices": {vertices}, "leading": [],
                "weight_bits": 2, "units": {units}, "inner_images": [], "end_images": []}}"#
        );
        serde_json::from_str(&text).unwrap()
    }

    fn term(index: usize, re: i64, im: i64) -> Term {
        Term { index, re, im }
    }

    /// `p/q` in fixed point, rounded upwards.
    fn fixed(p: i64, q: i64) -> Integer {
        ratio_up(&Integer::from(p), &Integer::from(q))
    }

    /// One matrix over four, with an error.
    fn place(matrix: [i64; 4], error: Integer) -> Place {
        let matrices = vec![matrix.map(Integer::from).to_vec()];
        Place::new(Position { matrices, denominator: Integer::from(4), error }, 2, Side::End)
    }

    const UNITS: &str = "[[[0, 4]], [[1, 4]]]";

    fn body(polytope: &Polytope, errors: [Integer; 2]) -> Check<Body<'_>> {
        let count = polytope.vertices.len();
        Body::new(polytope, 2, errors[..count].to_vec(), &mut Work::new())
    }

    #[test]
    fn the_gauge_is_bounded_by_weights_residuals_and_errors() {
        let gauge = |units: &str, errors: [Integer; 2]| {
            let polytope = polytope(false, false, "[[1, 0], [0, 1]]", units);
            body(&polytope, errors).map(|b| b.gauge)
        };
        let none = || [fixed(0, 1), fixed(0, 1)];
        assert_eq!(gauge(UNITS, none()), Ok(one()));
        // A residual of 1/4 + 1/4, in the first or in the second: κ = (3/4 + 1/4) / (1 - 1/2).
        assert_eq!(gauge("[[[0, 3], [1, 1]], [[1, 4]]]", none()), Ok(fixed(2, 1)));
        assert_eq!(gauge("[[[0, 4]], [[1, 3], [0, -1]]]", none()), Ok(fixed(2, 1)));
        // The largest weight is that of either: (4 + 1 + 1)/4.
        assert_eq!(gauge("[[[0, 4], [1, 1], [1, -1]], [[1, 4]]]", none()), Ok(fixed(3, 2)));
        assert_eq!(gauge("[[[0, 4]], [[1, 4], [0, 1], [0, -1]]]", none()), Ok(fixed(3, 2)));
        // Errors of 1/16 in each of two coordinates: κ = 1 / (1 - 2/16).
        assert_eq!(gauge(UNITS, [fixed(1, 16), fixed(0, 1)]), Ok(fixed(8, 7)));
        assert_eq!(gauge(UNITS, [fixed(0, 1), fixed(1, 16)]), Ok(fixed(8, 7)));
        assert_eq!(
            gauge("[[[0, 4], [1, 1], [1, -1]], [[1, 4]]]", [fixed(1, 16), fixed(1, 32)]),
            // 2/16 + 2 · 2/4 · 1/32 = 5/32
            Ok(divide_up(&(fixed(3, 2) << SCALE), &fixed(27, 32)))
        );
        assert!(gauge(UNITS, [fixed(1, 2), fixed(0, 1)]).is_err());
        assert!(gauge("[[[0, 4]], [[0, 4]]]", none()).is_err());
    }

    #[test]
    fn errors_of_mirror_images_are_those_of_the_originals() {
        let polytope = polytope(false, true, "[[1, 0]]", UNITS);
        let body = body(&polytope, [fixed(1, 16), fixed(0, 1)]).unwrap();
        assert_eq!(body.gauge, fixed(8, 7));
        assert_eq!(body.list.vertices, [[1, 0], [0, 1]]);
        let sum = body.sum(Side::End, &[term(1, 2, 0)], &mut Work::new()).unwrap();
        assert_eq!((sum.weight, sum.error), (Integer::from(2), fixed(1, 16)));
        assert_eq!(sum.vector, [0, 2].map(Integer::from));
    }

    #[test]
    fn residuals_are_bounded_with_all_errors() {
        let polytope = polytope(false, false, "[[1, 0], [0, -3]]", "[[[0, 4]], [[1, -1]]]");
        let bound = |matrix, error, errors: [Integer; 2], vertex, terms: &[Term]| {
            let work = &mut Work::new();
            let body = body(&polytope, errors).unwrap();
            let image = Image { vertex, letter: 0 };
            let rest = body.rest(&place(matrix, error), Side::End, image, terms, work);
            rest.unwrap().norm()
        };
        let zero = || fixed(0, 1);
        let exact = || [zero(), zero()];
        // The columns are 2/4, 1/4 and -1/4, 3/4; -3 times the second is 3/4, -9/4.
        let matrix = [2, -1, 1, 3];
        let (a, b) = (term(0, 2, 0), term(1, 1, 0));
        assert_eq!(bound(matrix, zero(), exact(), 0, &[]), fixed(3, 4));
        assert_eq!(bound(matrix, zero(), exact(), 1, &[]), fixed(3, 1));
        assert_eq!(bound(matrix, zero(), exact(), 0, &[a]), fixed(1, 4));
        assert_eq!(bound(matrix, zero(), exact(), 0, &[a, b]), fixed(1, 1));
        assert_eq!(bound(matrix, zero(), exact(), 1, &[term(0, 3, 0), term(1, 3, 0)]), zero());
        // The error of the matrix counts with the size of the vertex.
        assert_eq!(bound(matrix, fixed(1, 8), exact(), 0, &[a]), fixed(3, 8));
        assert_eq!(bound(matrix, fixed(1, 8), exact(), 1, &[]), fixed(27, 8));
        // That of the vertex with the norm by columns, which is one, in both coordinates.
        assert_eq!(bound(matrix, zero(), [fixed(1, 8), zero()], 0, &[]), fixed(4, 4));
        assert_eq!(bound(matrix, fixed(1, 8), [fixed(1, 8), zero()], 0, &[]), fixed(37, 32));
        assert_eq!(bound([8, 8, 0, 0], zero(), [fixed(1, 8), zero()], 0, &[]), fixed(10, 4));
        // That of a combination with its weights.
        assert_eq!(bound(matrix, zero(), [zero(), fixed(1, 8)], 0, &[a, b]), fixed(17, 16));
        assert_eq!(bound(matrix, zero(), [fixed(1, 8), zero()], 1, &[a]), fixed(21, 8));
    }

    #[test]
    fn residuals_of_complex_vertices_have_two_parts() {
        let polytope =
            polytope(true, false, "[[1, 0, 0, 0], [0, 1, 0, 2]]", "[[[0, 4]], [[1, 1, -2]]]");
        let body = Body::new(&polytope, 2, vec![Integer::zero(); 2], &mut Work::new());
        // e_1 - (1 - 2i)/4 (1 + 2i) e_1 = -e_1/4, and |1 - 2i| < 3.
        let body = body.unwrap();
        assert_eq!(body.gauge, ratio_up(&Integer::from(4), &Integer::from(3)));
        let bound = |vertex, terms: &[Term]| {
            let work = &mut Work::new();
            let place = place([2, -1, 1, 3], Integer::zero());
            let image = Image { vertex, letter: 0 };
            body.rest(&place, Side::End, image, terms, work).unwrap().norm()
        };
        // (2, 1)/4 - (2 + i)/4 (1, 0) = (-i, 1)/4, and (1 + 2i)(-1, 3)/4.
        assert_eq!(bound(0, &[term(0, 2, 1)]), fixed(2, 4));
        assert_eq!(bound(0, &[term(0, 2, 0)]), fixed(1, 4));
        assert_eq!(bound(1, &[]), fixed(12, 4));
        assert_eq!(bound(1, &[term(0, -1, -2), term(1, 3, 0)]), fixed(0, 4));
        // With the conjugate (1 - 2i)(0, 1), of which 3 (-3 + 4i)/5 times is (1 + 2i) 3.
        assert_eq!(bound(1, &[term(0, -1, -2), term(3, 3, 0)]), fixed(12, 4));
        assert_eq!(bound(1, &[term(0, -1, -2), term(3, 0, 3)]), fixed(6, 4));
        assert_eq!(bound(1, &[term(2, -1, -2), term(1, 3, 0)]), fixed(0, 4));
    }

    #[test]
    fn the_way_between_the_ends_is_bounded_with_all_errors() {
        let mut polytope = polytope(false, false, "[[1, 0], [0, 1]]", UNITS);
        let motion = r#"{"vertices": [[1, 0], [0, 1]], "rests": []}"#;
        polytope.motion = serde_json::from_str(motion).unwrap();
        let zero = || fixed(0, 1);
        // The images of the first vertex are columns, in quarters.
        let inside =
            |columns: [i64; 2], errors: [Integer; 2], vertex_errors, terms: [&[Term]; 3]| {
                let work = &mut Work::new();
                let body = body(&polytope, vertex_errors).unwrap();
                let [a, b] = columns.map(|c| [c, 0, 0, 0]);
                let [inner_error, end_error] = errors;
                let mut inner = place(a, inner_error);
                inner.side = Side::Inner;
                let image = Image { vertex: 0, letter: 0 };
                let [at_inner, at_end, rest] = terms;
                let terms = (at_inner, at_end, rest);
                body.has_path((&inner, &place(b, end_error)), image, terms, work).unwrap()
            };
        let exact = || [zero(), zero()];
        let none: [&[Term]; 3] = [&[], &[], &[]];
        assert!(inside([3, 4], exact(), exact(), none));
        assert!(!inside([4, 4], exact(), exact(), none));
        // The sum of 7/4 and the errors of the matrices.
        for (error, is_inside) in [(fixed(1, 5), true), (fixed(1, 4), false)] {
            assert_eq!(inside([3, 4], [error.clone(), zero()], exact(), none), is_inside);
            assert_eq!(inside([3, 4], [zero(), error], exact(), none), is_inside);
        }
        // That of the vertex itself: (7/4 + 2 η 3/4) / (1 - 2 η), the norm of the inner end alone.
        let vertex = |error: Integer| inside([3, 4], exact(), [error, zero()], none);
        assert!(vertex(fixed(1, 23)) && !vertex(fixed(1, 21)));
        // That of another one: 7/4 / (1 - 2 η).
        let other = |error: Integer| inside([3, 4], exact(), [zero(), error], none);
        assert!(other(fixed(1, 17)) && !other(fixed(1, 16)));
        // With one half of the other: 1/2 + (1/2 + 1/2 + η) / (1 - 2 η). The moved one is exact.
        let half = [term(1, 2, 0)];
        let with_half = |error: Integer, terms| inside([1, 1], exact(), [zero(), error], terms);
        for terms in [[&half, &[][..], &[]], [&[], &[], &half]] {
            assert!(with_half(fixed(1, 9), terms) && !with_half(fixed(1, 7), terms));
        }
        let at_end: [&[Term]; 3] = [&[], &half, &[]];
        assert!(with_half(fixed(1, 7), at_end) && !with_half(fixed(1, 5), at_end));
    }
}
