//! From floats to a certificate.

use nalgebra::Complex;
use refinable_algebra::Rational;
use refinable_certificate::{
    self as certificate, Combination, Leading, Motion, Number, Polytope, Term,
};

use crate::body::{Body, Closing, Ends, Orbit};
use crate::gauge::Atom;
use crate::writing::{Images, Weights, Writer};

/// How many bits the integers have after the point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Precision {
    pub bits: u32,
    pub weight_bits: u32,
}

/// Everything about the interval that a polytope is to prove.
pub(crate) struct Span<'a> {
    pub pencil: certificate::Pencil,
    pub inner: &'a Rational,
    pub end: certificate::End,
    pub ends: Ends<'a>,
}

/// The vertices that a proof needs, with all combinations; `None` if the precision leaves no room.
/// The vertices move if it is known where to.
///
/// Beginning with the orbits and with what represents the unit vectors, a vertex is kept if it is
/// met in the representation of an image of one that is kept.
pub(crate) fn polytope(
    body: &Body,
    moved: Option<&Body>,
    span: &Span,
    precision: Precision,
) -> Option<Polytope> {
    let rounded = Rounded::new(body, precision);
    let moved = moved.map(|moved| Rounded::new(moved, precision));
    let moved_body = moved.as_ref().map(|moved| &moved.body);
    let mut writer = Writer::new(&rounded.body, moved_body, precision);
    let units = writer.units()?;
    let mut images: Vec<Option<Vec<Images>>> = vec![None; body.vertices.len()];
    let mut kept: Vec<usize> = rounded.orbit_vertices();
    kept.extend(units.iter().flatten().map(|(atom, _)| rounded.vertex_of(*atom).0));
    while let Some(vertex) = kept.pop() {
        if images[vertex].is_some() {
            continue;
        }
        let letters = 0..span.ends.end.len();
        let of = letters.map(|letter| writer.images(&span.ends, vertex, letter));
        let of: Vec<Images> = of.collect::<Option<_>>()?;
        let written =
            of.iter().flat_map(|of| of.inner.weights.iter().chain(&of.end.weights).chain(&of.rest));
        kept.extend(written.map(|(atom, _)| rounded.vertex_of(*atom).0));
        images[vertex] = Some(of);
    }
    Some(rounded.assemble(moved.as_ref(), span, precision, &units, &images))
}

/// The body with its vertices rounded.
pub(crate) struct Rounded {
    pub integers: Vec<Vec<i64>>,
    pub body: Body,
}

impl Rounded {
    pub fn new(body: &Body, precision: Precision) -> Self {
        let scale = 2f64.powi(precision.bits as i32);
        let round = |v: &Vec<f64>| v.iter().map(|x| (x * scale).round() as i64).collect();
        let integers: Vec<Vec<i64>> = body.vertices.iter().map(round).collect();
        let back = |v: &Vec<i64>| v.iter().map(|x| *x as f64 / scale).collect();
        let vertices = integers.iter().map(back).collect();
        Rounded { integers, body: body.with_vertices(vertices) }
    }

    /// The vertex that an atom is, or of which it is the mirror image.
    pub fn vertex_of(&self, atom: Atom) -> (usize, bool) {
        let (Atom::Plain(k) | Atom::Conjugate(k)) = atom else {
            unreachable!("tiny atoms are no part of a representation")
        };
        self.body.vertex_of(k)
    }

    fn orbit_vertices(&self) -> Vec<usize> {
        let orbits = self.body.orbits.iter();
        orbits.flat_map(|orbit| orbit.first..orbit.first + orbit.word.letters().len()).collect()
    }

    fn assemble(
        &self,
        moved: Option<&Rounded>,
        span: &Span,
        precision: Precision,
        units: &[Weights],
        images: &[Option<Vec<Images>>],
    ) -> Polytope {
        // New indices: kept vertices in their order, mirror images after them, then all conjugates.
        let mut position = vec![0; images.len()];
        let kept: Vec<usize> = (0..images.len()).filter(|&v| images[v].is_some()).collect();
        kept.iter().enumerate().for_each(|(new, &old)| position[old] = new);
        let shape = self.body.shape;
        let listed = if shape.mirrored { 2 * kept.len() } else { kept.len() };
        let place = |atom: usize| {
            let (vertex, image) = self.body.vertex_of(atom);
            position[vertex] + if image { kept.len() } else { 0 }
        };
        let renumber = |weights: &Weights| -> Combination {
            let mut terms: Vec<Term> = weights
                .iter()
                .map(|&(atom, Complex { re, im })| match atom {
                    Atom::Conjugate(k) => Term { index: place(k) + listed, re, im },
                    Atom::Plain(k) => Term { index: place(k), re, im },
                    Atom::Tiny => unreachable!("tiny atoms are no part of a representation"),
                })
                .collect();
            terms.sort_unstable_by_key(|term| term.index);
            Some(terms)
        };
        let leading = |orbit: &Orbit| {
            let first = &self.integers[orbit.first];
            let pivot = (0..first.len()).max_by_key(|&i| first[i].abs()).unwrap_or(0);
            Leading {
                word: orbit.word.to_string(),
                sign: self.body.sign_of(orbit, &span.ends),
                vertex: position[orbit.first],
                pivot,
            }
        };
        let exact = shape.closing == Closing::Orbits;
        let listed_vertices = |of: &Rounded| kept.iter().map(|&v| of.integers[v].clone()).collect();
        let combinations = |choose: &dyn Fn(usize, usize, &Images) -> Combination| {
            let of = |&v: &usize| {
                let letters = images[v].iter().flatten().enumerate();
                letters.map(|(letter, image)| choose(v, letter, image)).collect()
            };
            kept.iter().map(of).collect()
        };
        let end_image = |v: usize, letter: usize, image: &Images| {
            let closes = exact && self.body.closes_orbit(v, letter);
            if closes { None } else { renumber(&image.end.weights) }
        };
        let motion = moved.map(|moved| Motion {
            vertices: listed_vertices(moved),
            rests: combinations(&|_, _, image| renumber(&image.rest)),
        });
        Polytope {
            pencil: span.pencil,
            inner: Number(span.inner.clone()),
            end: span.end.clone(),
            open: !matches!(shape.closing, Closing::Inside(_)),
            complex: shape.complex,
            mirrored: shape.mirrored,
            bits: precision.bits,
            vertices: listed_vertices(self),
            motion,
            leading: if exact {
                self.body.orbits.iter().map(leading).collect()
            } else {
                Vec::new()
            },
            weight_bits: precision.weight_bits,
            units: units.iter().map(renumber).collect(),
            inner_images: combinations(&|_, _, image| renumber(&image.inner.weights)),
            end_images: combinations(&end_image),
        }
    }
}
