//! The lemma `polytope`: a symmetric polytope that the matrices map into its interior.

use refinable_algebra::{Integer, Ordered, Ring};

use crate::family::{Letters, Scheme};
use crate::fixed::{SCALE, divide_up, one, ratio_up, shift_up, times_up};
use crate::line::{Cut, Span};
use crate::model::{Combination, Polytope};
use crate::orbit::{Orbit, apply};
use crate::position::Position;
use crate::real::Real;
use crate::work::{Check, Work, ensure, fail};

/// Checks the polytope; the matrices are contractive on the span that is returned.
pub(crate) fn check(
    scheme: &Scheme,
    letters: &Letters,
    polytope: &Polytope,
    work: &mut Work,
) -> Check<Span> {
    let inner = Real::Rational(polytope.inner.0.clone());
    let end = Real::new(&polytope.end, work)?;
    let exact = polytope.leading.is_empty();
    ensure(
        !exact || end.as_rational().is_some(),
        "without leading words the end must be rational",
    )?;
    check_shape(scheme, letters, polytope)?;
    let span = span(inner.clone(), end.clone(), exact, work)?;
    let orbits = orbits(letters, polytope)?;
    let errors = vertex_errors(letters, polytope, &orbits, &end, work)?;
    let body = Body::new(letters, polytope, errors, work)?;
    let met = |_, _| false;
    body.check_images(&Position::best(letters, &inner, work)?, &polytope.inner_images, met, work)?;
    let met = |vertex: usize, letter: usize| {
        let on = |(first, orbit): &(usize, Orbit)| {
            let step = vertex.checked_sub(*first);
            step.and_then(|s| orbit.word.get(s)).is_some_and(|&l| l == letter)
        };
        orbits.iter().any(on)
    };
    body.check_images(&Position::best(letters, &end, work)?, &polytope.end_images, met, work)?;
    Ok(span)
}

/// The closed interval between the two numbers, without the end unless it is included.
fn span(inner: Real, end: Real, included: bool, work: &mut Work) -> Check<Span> {
    if inner.compare(&end, work)?.is_le() {
        let high = if included { Cut::After(end) } else { Cut::Before(end) };
        Span::new(Cut::Before(inner), high, work)
    } else {
        let low = if included { Cut::Before(end) } else { Cut::After(end) };
        Span::new(low, Cut::After(inner), work)
    }
}

fn check_shape(scheme: &Scheme, letters: &Letters, polytope: &Polytope) -> Check<()> {
    let d = letters.dimension;
    ensure(polytope.bits <= 62 && polytope.weight_bits <= 62, "more than 62 binary places")?;
    ensure(polytope.vertices.iter().all(|v| v.len() == d), "a vertex has the wrong length")?;
    ensure(polytope.units.len() == d, "the wrong number of units")?;
    for images in [&polytope.inner_images, &polytope.end_images] {
        ensure(images.len() == polytope.vertices.len(), "the wrong number of images")?;
        let complete = images.iter().all(|of| of.len() == letters.pairs.len());
        ensure(complete, "a vertex does not have an image for each letter")?;
    }
    if polytope.mirrored {
        let c = &scheme.difference;
        let fits = c.is_symmetric() && c.degree() == (scheme.arity - 1) * d;
        ensure(fits, "the difference symbol is not symmetric about the middle of the matrices")?;
    }
    Ok(())
}

/// The orbits with their first vertices, checked to be disjoint.
fn orbits<'a>(letters: &Letters, polytope: &'a Polytope) -> Check<Vec<(usize, Orbit<'a>)>> {
    let mut taken = vec![false; polytope.vertices.len()];
    let mut orbits = Vec::with_capacity(polytope.leading.len());
    for leading in &polytope.leading {
        let word = letters.word(&leading.word)?;
        let first = leading.vertex;
        let range = first.checked_add(word.len()).map(|last| first..last);
        let Some(range) = range.filter(|r| r.end <= taken.len()) else {
            return fail("a leading word has more letters than there are vertices");
        };
        let vertices = &polytope.vertices[range.clone()];
        for place in &mut taken[range] {
            ensure(!*place, "two leading words share a vertex")?;
            *place = true;
        }
        ensure(leading.sign == 1 || leading.sign == -1, "a sign is neither 1 nor -1")?;
        let pivot = leading.pivot;
        let exact = vertices[0].get(pivot).is_some_and(|&x| x != 0);
        ensure(exact, "the pivot of a leading word is not a coordinate that is not zero")?;
        let bits = polytope.bits;
        orbits.push((first, Orbit { word, sign: leading.sign, pivot, vertices, bits }));
    }
    Ok(orbits)
}

/// The errors of all vertices, mirrored ones included.
fn vertex_errors(
    letters: &Letters,
    polytope: &Polytope,
    orbits: &[(usize, Orbit)],
    end: &Real,
    work: &mut Work,
) -> Check<Vec<Integer>> {
    let mut errors = vec![Integer::zero(); polytope.vertices.len()];
    if !orbits.is_empty() {
        let position = Position::fixed(letters, end, work)?;
        for (first, orbit) in orbits {
            orbit.check_eigenvalue(letters, end, work)?;
            let bounds = orbit.errors(&position, letters.dimension, work)?;
            for (error, bound) in errors[*first..].iter_mut().zip(bounds) {
                *error = bound;
            }
        }
    }
    if polytope.mirrored {
        errors.extend_from_within(..);
    }
    Ok(errors)
}

/// The polytope with its mirror images and what is known about its gauge.
struct Body<'a> {
    dimension: usize,
    /// The number of vertices without mirror images.
    count: usize,
    vertices: Vec<Vec<i64>>,
    errors: Vec<Integer>,
    polytope: &'a Polytope,
    /// `‖v‖ ≤ κ ‖v‖_1`, in fixed point.
    gauge: Integer,
}

impl<'a> Body<'a> {
    fn new(
        letters: &Letters,
        polytope: &'a Polytope,
        errors: Vec<Integer>,
        work: &mut Work,
    ) -> Check<Self> {
        let mut vertices = polytope.vertices.clone();
        if polytope.mirrored {
            let mirror = |v: &Vec<i64>| v.iter().rev().copied().collect();
            vertices.extend(polytope.vertices.iter().map(mirror).collect::<Vec<_>>());
        }
        let count = polytope.vertices.len();
        let dimension = letters.dimension;
        let gauge = Integer::zero();
        let mut body = Body { dimension, count, vertices, errors, polytope, gauge };
        body.gauge = body.bound_gauge(work)?;
        Ok(body)
    }

    /// `κ = Γ / (1 - δ)` from the units.
    fn bound_gauge(&self, work: &mut Work) -> Check<Integer> {
        let scale = u64::from(self.polytope.bits + self.polytope.weight_bits);
        let (mut largest_sum, mut largest_rest) = (Integer::zero(), Integer::zero());
        for (i, unit) in self.polytope.units.iter().enumerate() {
            let Some(pairs) = unit else { return fail("a unit is null") };
            let sum = self.weight_sum(pairs)?;
            let combined = self.combine(pairs, work)?;
            let rest = combined.iter().enumerate().map(|(j, x)| {
                let unit = Integer::from(u8::from(i == j)) << scale;
                (unit - x).absolute()
            });
            let rest = (rest.sum::<Integer>() << (SCALE - scale)) + self.combination_error(pairs);
            largest_sum = largest_sum.max(sum);
            largest_rest = largest_rest.max(rest);
        }
        let gap = one() - largest_rest;
        ensure(gap > Integer::zero(), "the units do not show that the polytope has an interior")?;
        // Γ = sum / 2^weight_bits, in fixed point twice for the quotient.
        let numerator = largest_sum << (2 * SCALE - u64::from(self.polytope.weight_bits));
        Ok(divide_up(&numerator, &gap))
    }

    /// The sum of the absolute weights, an integer over `2^weight_bits`.
    fn weight_sum(&self, pairs: &[(usize, i64)]) -> Check<Integer> {
        let inside = pairs.iter().all(|&(index, _)| index < self.vertices.len());
        ensure(inside, "a combination has an index that is no vertex")?;
        Ok(pairs.iter().map(|&(_, w)| u128::from(w.unsigned_abs())).sum::<u128>().into())
    }

    /// `Σ w u`, an integer vector over `2^(bits + weight_bits)`.
    fn combine(&self, pairs: &[(usize, i64)], work: &mut Work) -> Check<Vec<Integer>> {
        work.products(pairs.len() * self.dimension, 64, 64)?;
        let mut sum = vec![Integer::zero(); self.dimension];
        for &(index, weight) in pairs {
            for (s, &x) in sum.iter_mut().zip(&self.vertices[index]) {
                *s += i128::from(weight) * i128::from(x);
            }
        }
        Ok(sum)
    }

    /// `d Σ |λ| η` in fixed point.
    fn combination_error(&self, pairs: &[(usize, i64)]) -> Integer {
        let terms = pairs.iter().filter(|(index, _)| !self.errors[*index].is_zero());
        let sum: Integer = terms.map(|&(index, w)| &self.errors[index] * w.unsigned_abs()).sum();
        shift_up(&(sum * self.dimension), u64::from(self.polytope.weight_bits))
    }

    /// Checks that the images of the vertices are inside, but for those that are met by
    /// construction.
    fn check_images(
        &self,
        position: &Position,
        images: &[Vec<Combination>],
        met: impl Fn(usize, usize) -> bool,
        work: &mut Work,
    ) -> Check<()> {
        let norm = position.column_norm(self.dimension);
        for (vertex, of) in images.iter().enumerate().take(self.count) {
            for (letter, combination) in of.iter().enumerate() {
                match (combination, met(vertex, letter)) {
                    (None, true) => {}
                    (Some(pairs), false) => {
                        let inside =
                            self.is_inside(position, &norm, vertex, letter, pairs, work)?;
                        if !inside {
                            return fail(format!(
                                "the image of vertex {vertex} under letter {letter} is not shown to be inside"
                            ));
                        }
                    }
                    (None, false) => return fail("a combination is null where none is met"),
                    (Some(_), true) => {
                        return fail("a combination is not null where a vertex is met");
                    }
                }
            }
        }
        Ok(())
    }

    /// `Σ|λ| + κ ‖r‖_1 < 1`.
    fn is_inside(
        &self,
        position: &Position,
        norm: &Integer,
        vertex: usize,
        letter: usize,
        pairs: &[(usize, i64)],
        work: &mut Work,
    ) -> Check<bool> {
        let (d, weight_bits) = (self.dimension, u64::from(self.polytope.weight_bits));
        let sum = self.weight_sum(pairs)?;
        let combined = self.combine(pairs, work)?;
        work.products(d * d + d, position.denominator.bits() + 64, 64)?;
        let image = apply(d, &position.matrices[letter], &self.vertices[vertex]);
        let rest = image
            .iter()
            .zip(&combined)
            .map(|(a, b)| ((a << weight_bits) - b * &position.denominator).absolute());
        let scale = weight_bits + u64::from(self.polytope.bits);
        let rest = rest.sum::<Integer>();
        let mut rest = ratio_up(&rest, &(&position.denominator << scale));
        rest += self.combination_error(pairs);
        if !self.errors[vertex].is_zero() {
            rest += times_up(norm, &(&self.errors[vertex] * d));
        }
        if !position.error.is_zero() {
            let size: Integer =
                self.vertices[vertex].iter().map(|x| Integer::from(x.unsigned_abs())).sum();
            rest += times_up(&position.error, &(size << (SCALE - u64::from(self.polytope.bits))));
        }
        Ok((sum << (SCALE - weight_bits)) + times_up(&self.gauge, &rest) < one())
    }
}
