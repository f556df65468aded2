//! The lemma `polytope`: a symmetric polytope that the matrices map into its interior.

use refinable_algebra::{Integer, Ring};

use crate::body::{Body, Image, Met, Place, Side};
use crate::family::{Letters, Scheme};
use crate::line::{Cut, Span};
use crate::model::{Combination, Polytope, Term};
use crate::orbit::Orbit;
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
    check_form(scheme, letters, polytope, &end)?;
    let span = span(inner.clone(), end.clone(), !polytope.open, work)?;
    let orbits = orbits(letters, polytope)?;
    let errors = vertex_errors(letters, polytope, &orbits, &end, work)?;
    let body = Body::new(polytope, letters.dimension, errors, work)?;
    let mut place = |x: &Real, side: Side| {
        Ok(Place::new(Position::best(letters, x, work)?, letters.dimension, side))
    };
    let (inner, end) = (place(&inner, Side::Inner)?, place(&end, Side::End)?);
    let letters = 0..letters.pairs.len();
    let images = (0..polytope.vertices.len())
        .flat_map(|vertex| letters.clone().map(move |letter| Image { vertex, letter }));
    for image in images.clone() {
        let given = Given::new(polytope, image);
        let Some(terms) = given.inner else { return fail(NULL) };
        ensure_inside(body.has_image(&inner, image, terms, work)?, image)?;
    }
    for image in images {
        let given = Given::new(polytope, image);
        let met = met(&orbits, image);
        ensure_inside(check_image(&body, (&inner, &end), image, given, met, work)?, image)?;
    }
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

fn check_form(scheme: &Scheme, letters: &Letters, polytope: &Polytope, end: &Real) -> Check<()> {
    let rational = end.as_rational().is_some();
    ensure(polytope.open || rational, "an end that belongs to the interval must be rational")?;
    let leads = !polytope.leading.is_empty();
    ensure(polytope.open || !leads, "a leading word at an end that belongs to the interval")?;
    ensure(!polytope.complex || !leads, "a leading word of a complex polytope")?;
    ensure(polytope.bits <= 62 && polytope.weight_bits <= 62, "more than 62 binary places")?;
    let d = letters.dimension;
    let length = if polytope.complex { 2 * d } else { d };
    let moved = polytope.motion.iter().flat_map(|motion| &motion.vertices);
    let fits = polytope.vertices.iter().chain(moved).all(|v| v.len() == length);
    ensure(fits, "a vertex has the wrong length")?;
    let moved = polytope.motion.as_ref().map(|motion| motion.vertices.len());
    let fits = moved.is_none_or(|count| count == polytope.vertices.len());
    ensure(fits, "the wrong number of vertices at the inner end")?;
    ensure(polytope.units.len() == d, "the wrong number of units")?;
    let rests = polytope.motion.as_ref().map(|motion| &motion.rests);
    for images in [&polytope.inner_images, &polytope.end_images].into_iter().chain(rests) {
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

/// The errors of the vertices, zero off the orbits.
fn vertex_errors(
    letters: &Letters,
    polytope: &Polytope,
    orbits: &[(usize, Orbit)],
    end: &Real,
    work: &mut Work,
) -> Check<Vec<Integer>> {
    let mut errors = vec![Integer::zero(); polytope.vertices.len()];
    if orbits.is_empty() {
        return Ok(errors);
    }
    let position = Position::fixed(letters, end, work)?;
    for (first, orbit) in orbits {
        orbit.check_eigenvalue(letters, end, work)?;
        let bounds = orbit.errors(&position, letters.dimension, work)?;
        for (error, bound) in errors[*first..].iter_mut().zip(bounds) {
            *error = bound;
        }
    }
    Ok(errors)
}

const NULL: &str = "a combination is null where none is met";

fn ensure_inside(inside: bool, Image { vertex, letter }: Image) -> Check<()> {
    if inside {
        return Ok(());
    }
    fail(format!("the image of vertex {vertex} under letter {letter} is not shown to be inside"))
}

/// Checks the image of a vertex under a letter at the end, and on the way from there if the polytope
/// moves. Images of mirrored vertices are mirror images, `B_{m-1-ε} = J B_ε J`, and those of
/// conjugates are conjugate, since the matrices are real.
fn check_image(
    body: &Body,
    ends: (&Place, &Place),
    image: Image,
    given: Given,
    met: Option<Met>,
    work: &mut Work,
) -> Check<bool> {
    let unit = met.map(|met| [body.unit_term(met)]);
    let at_end = match (given.end, &unit) {
        (Some(terms), None) => terms,
        (None, Some(unit)) => &unit[..],
        (None, None) => return fail(NULL),
        (Some(_), Some(_)) => return fail("a combination is not null where a vertex is met"),
    };
    let inside = met.is_some() || body.has_image(ends.1, image, at_end, work)?;
    match (given.inner, given.rest) {
        (_, None) => Ok(inside),
        (Some(at_inner), Some(Some(rest))) => {
            Ok(inside && body.has_path(ends, image, (at_inner, at_end, rest), work)?)
        }
        _ => fail("a rest is null"),
    }
}

/// What the certificate has for an image.
struct Given<'a> {
    inner: Option<&'a [Term]>,
    end: Option<&'a [Term]>,
    /// If the polytope moves.
    rest: Option<Option<&'a [Term]>>,
}

impl<'a> Given<'a> {
    fn new(polytope: &'a Polytope, Image { vertex, letter }: Image) -> Self {
        let of = |images: &'a [Vec<Combination>]| images[vertex][letter].as_deref();
        Given {
            inner: of(&polytope.inner_images),
            end: of(&polytope.end_images),
            rest: polytope.motion.as_ref().map(|motion| of(&motion.rests)),
        }
    }
}

/// The vertex that the image of the given one is by construction, as the next one of an orbit.
fn met(orbits: &[(usize, Orbit)], Image { vertex, letter }: Image) -> Option<Met> {
    orbits.iter().find_map(|(first, orbit)| {
        let step = vertex.checked_sub(*first)?;
        let next = step + 1;
        (orbit.word.get(step) == Some(&letter)).then(|| {
            if next < orbit.word.len() {
                Met { vertex: first + next, sign: 1 }
            } else {
                Met { vertex: *first, sign: orbit.sign }
            }
        })
    })
}
