//! Growing a polytope that all matrices map into itself, in floats.
//!
//! # Source
//! N. Guglielmi, V. Yu. Protasov, *Exact computation of joint spectral characteristics of linear
//! operators*, Found. Comput. Math. 13 (2013): begin with the leading eigenvectors, add every image
//! that is outside, until none is. Complex vertices where the leading eigenvalue is complex:
//! N. Guglielmi, F. Wirth, M. Zennaro, *Complex polytope extremality results for families of
//! matrices*, SIAM J. Matrix Anal. Appl. 27 (2005).

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use crate::gauge::{FINEST, Gauge, Limits};
use crate::leading::{followed, product};
use crate::word::Word;
use crate::work::Work;

/// The matrices at both ends of an interval; orbits are those of eigenvectors at `end`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ends<'a> {
    pub inner: &'a [DMatrix<f64>],
    pub end: &'a [DMatrix<f64>],
}

/// What a search asks for and may spend.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// By how much images must be inside.
    pub margin: f64,
    /// The largest number of vertices.
    pub vertices: usize,
}

/// A symmetric polytope with its mirror images, by vertices: the real parts of all coordinates and
/// then, if complex, the imaginary parts.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub dimension: usize,
    pub vertices: Vec<Vec<f64>>,
    /// Where each vertex comes from.
    origins: Vec<Origin>,
    pub orbits: Vec<Orbit>,
    pub shape: Shape,
}

/// Where a vertex comes from.
#[derive(Clone, Debug)]
enum Origin {
    /// An eigenvector of the product along a word.
    Eigenvector(Word),
    /// It was given.
    Given,
    /// The image of a vertex that came before, divided by the growth of its orbit.
    Next { parent: usize, letter: u8 },
    /// The image of a vertex that came before, times a factor.
    Image { parent: usize, letter: usize, factor: f64 },
}

/// What kind of polytope.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Shape {
    pub mirrored: bool,
    pub complex: bool,
    pub closing: Closing,
}

/// How orbits close at the end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Closing {
    /// By construction: they are those of eigenvectors for the eigenvalue 1 or -1.
    Orbits,
    /// Images may be vertices.
    Vertices,
    /// All images are inside, those that close an orbit by so much.
    Inside(f64),
}

/// The vertices `first, first + 1, …` are the orbit of an eigenvector along a word.
#[derive(Clone, Debug)]
pub(crate) struct Orbit {
    pub word: Word,
    pub first: usize,
}

/// By how much an image must be inside that is the next vertex of an orbit at the end.
const JUST_INSIDE: f64 = 1e-8;
/// How many binary places numbers have for which floats are exact.
const SHORT: f64 = (1 << 24) as f64;

/// By how much images are to be inside where a body unfolds, against the way to the goal.
const DEPTH: f64 = 0.01;
/// The largest number of vertices then.
const MOST_UNFOLDED: usize = 200;

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Inner,
    End,
}

struct Image {
    parent: usize,
    letter: usize,
    vector: Vec<f64>,
    margin: f64,
}

/// Where a search begins.
#[derive(Clone, Debug)]
pub(crate) enum Start {
    /// An eigenvector of the product along the word; each matrix is divided by the growth.
    Orbit { word: Word, growth: f64, vector: Vec<f64> },
    /// An eigenvector of the product along the word for a smaller eigenvalue.
    Companion { word: Word, vector: Vec<f64> },
    /// Any vector.
    Free(Vec<f64>),
}

impl Start {
    /// The vector.
    pub fn vector(&self) -> &[f64] {
        let (Start::Orbit { vector, .. } | Start::Companion { vector, .. } | Start::Free(vector)) =
            self;
        vector
    }

    /// The vector, to be changed.
    pub fn vector_mut(&mut self) -> &mut Vec<f64> {
        let (Start::Orbit { vector, .. } | Start::Companion { vector, .. } | Start::Free(vector)) =
            self;
        vector
    }

    /// The same start with its vector made longer or shorter.
    pub fn stretched(&self, factor: f64) -> Self {
        let mut start = self.clone();
        start.vector_mut().iter_mut().for_each(|x| *x *= factor);
        start
    }
}

impl Body {
    /// Adds images under the matrices at both ends until all images are inside, by `margin` at
    /// least, but for those that close an orbit. `None` if there are too many, or if too little work is left.
    pub fn grow(
        ends: &Ends,
        shape: Shape,
        starts: &[Start],
        effort: Effort,
        work: &Work,
    ) -> Option<Self> {
        let (body, finished) = Body::grown(ends, shape, starts, effort, work);
        finished.then_some(body)
    }

    /// What has grown with this effort, and whether it was enough.
    pub fn grown(
        ends: &Ends,
        shape: Shape,
        starts: &[Start],
        effort: Effort,
        work: &Work,
    ) -> (Self, bool) {
        let Effort { margin, vertices } = effort;
        let dimension = ends.end[0].nrows();
        let mut body = Body {
            dimension,
            vertices: Vec::new(),
            origins: Vec::new(),
            orbits: Vec::new(),
            shape,
        };
        for start in starts {
            body.begin(ends.end, start);
        }
        let mut gauge = body.gauge();
        let mut taken = 0;
        let (mut at_end, mut at_inner) = (0, 0);
        loop {
            // All images at the end first; most images at the other end are then inside too.
            let (side, from) = match (at_end < body.vertices.len(), at_inner < body.vertices.len())
            {
                (true, _) => (Side::End, &mut at_end),
                (false, true) => (Side::Inner, &mut at_inner),
                (false, false) => return (body, true),
            };
            let generation = *from..body.vertices.len();
            *from = body.vertices.len();
            let mut images = body.images(ends, side, generation, margin);
            // Long images first: they may swallow the others.
            images.sort_by(|a, b| squared_length(&b.vector).total_cmp(&squared_length(&a.vector)));
            for Image { parent, letter, vector, margin } in images {
                // Anything that is not far enough inside is added: no need to know where it is.
                let limits =
                    Limits { inside: 1.0 - margin, outside: 1.0 - margin, accuracy: FINEST };
                let total = gauge.represent(&vector, limits).total;
                work.spend(gauge.products() - taken);
                taken = gauge.products();
                if work.left() == 0 {
                    return (body, false);
                }
                if total > limits.inside {
                    // Where vertices are to meet they must stay as they are.
                    let stays = side == Side::End
                        && shape.closing == Closing::Vertices
                        && is_short(&vector);
                    let factor = if stays { 1.0 } else { 1.0 + 2.0 * effort.margin };
                    body.push_with_mirror(&mut gauge, &scaled(&vector, factor));
                    body.push(scaled(&vector, factor), Origin::Image { parent, letter, factor });
                    if body.vertices.len() > vertices {
                        return (body, false);
                    }
                }
            }
        }
    }

    fn begin(&mut self, matrices: &[DMatrix<f64>], start: &Start) {
        match start {
            Start::Free(v) => self.push(v.clone(), Origin::Given),
            Start::Companion { word, vector } => {
                self.push(vector.clone(), Origin::Eigenvector(word.clone()));
            }
            Start::Orbit { word, growth, vector } => {
                let first = self.vertices.len();
                self.orbits.push(Orbit { word: word.clone(), first });
                self.push(vector.clone(), Origin::Eigenvector(word.clone()));
                let (_, letters) = word.letters().split_last().expect("words are not empty");
                for (parent, &letter) in (first..).zip(letters) {
                    let next = apply(&matrices[usize::from(letter)], &self.vertices[parent]);
                    self.push(scaled(&next, 1.0 / growth), Origin::Next { parent, letter });
                }
            }
        }
    }

    fn push(&mut self, vertex: Vec<f64>, origin: Origin) {
        self.vertices.push(vertex);
        self.origins.push(origin);
    }

    /// The polytope at both ends, the end first, if it may move; `reach` is the part of the way to the
    /// goal between them.
    pub fn moving(&self, ends: &Ends, reach: f64) -> Option<(Body, Body)> {
        match self.shape.closing {
            Closing::Vertices => self.unfolded(ends, DEPTH * reach),
            _ => Some((self.clone(), self.carried(ends)?)),
        }
    }

    /// The polytope with the same vertices for the matrices at the inner end, eigenvectors for
    /// eigenvectors and images for images.
    fn carried(&self, ends: &Ends) -> Option<Body> {
        let mut moved = self.with_vertices(Vec::new());
        let mut growth = 1.0;
        for (vertex, origin) in self.vertices.iter().zip(&self.origins) {
            let next = match origin {
                Origin::Given => vertex.clone(),
                Origin::Next { parent, letter } => scaled(
                    &apply(&ends.inner[usize::from(*letter)], &moved.vertices[*parent]),
                    1.0 / growth,
                ),
                Origin::Image { parent, letter, factor } => {
                    scaled(&apply(&ends.inner[*letter], &moved.vertices[*parent]), *factor)
                }
                Origin::Eigenvector(word) => {
                    let [at_inner, at_end] = [ends.inner, ends.end].map(|m| product(m, word));
                    let (eigenvalue, vector) = followed(&at_end, vertex, &at_inner)?;
                    growth = eigenvalue.norm().powf(1.0 / word.letters().len() as f64);
                    vector
                }
            };
            moved.vertices.push(next);
        }
        Some(moved)
    }

    /// The polytope at both ends, the end first, where vertices are mapped to vertices at the end: those
    /// images that are not inside at the inner end become vertices of their own there. At the end they
    /// are vertices already, so that several vertices come from one.
    ///
    /// `None` if there are too many. Close to the end there are not if every cycle of vertices shrinks.
    fn unfolded(&self, ends: &Ends, margin: f64) -> Option<(Body, Body)> {
        let limits = Limits { inside: 1.0 - margin, outside: 1.0, accuracy: FINEST };
        let (mut folded, mut moved) = (self.clone(), self.clone());
        let mut gauge = moved.gauge();
        let mut vertex = 0;
        while vertex < moved.vertices.len() {
            for letter in 0..ends.end.len() {
                let image = apply(&ends.end[letter], &folded.vertices[vertex]);
                if folded.twin(&image).is_none() {
                    continue;
                }
                let apart = apply(&ends.inner[letter], &moved.vertices[vertex]);
                if gauge.represent(&apart, limits).total > limits.inside {
                    let factor = 1.0 + 2.0 * margin;
                    let apart = scaled(&apart, factor);
                    moved.push_with_mirror(&mut gauge, &apart);
                    moved.push(apart, Origin::Image { parent: vertex, letter, factor });
                    folded.push(image, Origin::Image { parent: vertex, letter, factor: 1.0 });
                    if moved.vertices.len() > MOST_UNFOLDED {
                        return None;
                    }
                }
            }
            vertex += 1;
        }
        Some((folded, moved))
    }

    /// The images that have to be inside, and by how much.
    fn images(&self, ends: &Ends, side: Side, generation: Range<usize>, margin: f64) -> Vec<Image> {
        let mut images = Vec::new();
        for vertex in generation {
            for letter in 0..ends.end.len() {
                let closes = self.closes(ends, vertex, letter);
                let margin = match (side, closes, self.shape.closing) {
                    (Side::End, true, Closing::Inside(margin)) => margin,
                    (Side::End, true, _) => continue,
                    (Side::End, false, _) => margin,
                    // Near the end this image is near the next vertex of the orbit: only just inside.
                    (Side::Inner, true, Closing::Inside(margin)) => JUST_INSIDE.min(margin / 4.0),
                    (Side::Inner, true, _) => JUST_INSIDE,
                    // Less than the excess that vertices get, so that small changes add none.
                    (Side::Inner, false, _) => margin / 4.0,
                };
                let matrices = if side == Side::End { ends.end } else { ends.inner };
                let Some(matrix) = matrices.get(letter) else { continue };
                let vector = apply(matrix, &self.vertices[vertex]);
                images.push(Image { parent: vertex, letter, vector, margin });
            }
        }
        images
    }

    /// Whether the image of the vertex at the end is a vertex.
    fn closes(&self, ends: &Ends, vertex: usize, letter: usize) -> bool {
        match self.shape.closing {
            Closing::Vertices => {
                self.twin(&apply(&ends.end[letter], &self.vertices[vertex])).is_some()
            }
            _ => self.closes_orbit(vertex, letter),
        }
    }

    /// Whether the image of the vertex under the letter is the next vertex of its orbit.
    pub fn closes_orbit(&self, vertex: usize, letter: usize) -> bool {
        self.orbits.iter().any(|orbit| {
            let step = vertex.checked_sub(orbit.first);
            step.and_then(|k| orbit.word.letters().get(k)) == Some(&(letter as u8))
        })
    }

    /// The same polytope with other vertices.
    pub fn with_vertices(&self, vertices: Vec<Vec<f64>>) -> Self {
        Body { vertices, ..self.clone() }
    }

    /// The atom that the image of a vertex at the end is, and its sign.
    pub fn met(&self, ends: &Ends, vertex: usize, letter: usize) -> Option<(usize, i32)> {
        match self.shape.closing {
            Closing::Inside(_) => None,
            Closing::Vertices => self.twin(&apply(&ends.end[letter], &self.vertices[vertex])),
            Closing::Orbits => self.orbits.iter().find_map(|orbit| {
                let letters = orbit.word.letters();
                let step = vertex.checked_sub(orbit.first)?;
                if letters.get(step) != Some(&(letter as u8)) {
                    return None;
                }
                let last = step + 1 == letters.len();
                let next = if last { orbit.first } else { vertex + 1 };
                let sign = if last { self.sign_of(orbit, ends) } else { 1 };
                Some((self.atoms_of(next).0, sign))
            }),
        }
    }

    /// The eigenvalue, 1 or -1, of the product along an orbit at the end.
    pub fn sign_of(&self, orbit: &Orbit, ends: &Ends) -> i32 {
        let start = &self.vertices[orbit.first];
        let letters = orbit.word.letters().iter();
        let image = letters.fold(start.clone(), |v, &e| apply(&ends.end[usize::from(e)], &v));
        let product: f64 = image.iter().zip(start).map(|(x, y)| x * y).sum();
        if product < 0.0 { -1 } else { 1 }
    }

    /// The atom that is the vector, and its sign.
    fn twin(&self, v: &[f64]) -> Option<(usize, i32)> {
        if !is_short(v) {
            return None;
        }
        let same =
            |u: &mut dyn Iterator<Item = &f64>, sign: f64| u.zip(v).all(|(a, b)| a * sign == *b);
        (0..self.vertices.len()).find_map(|k| {
            let u = &self.vertices[k];
            let (plain, mirror) = self.atoms_of(k);
            [1, -1].into_iter().find_map(|sign| {
                if same(&mut u.iter(), f64::from(sign)) {
                    return Some((plain, sign));
                }
                mirror
                    .filter(|_| same(&mut u.iter().rev(), f64::from(sign)))
                    .map(|mirror| (mirror, sign))
            })
        })
    }

    /// The atoms of the gauge that are a vertex and its mirror image.
    fn atoms_of(&self, vertex: usize) -> (usize, Option<usize>) {
        if self.shape.mirrored { (2 * vertex, Some(2 * vertex + 1)) } else { (vertex, None) }
    }

    /// The vertex that is an atom of the gauge, or of which it is the mirror image.
    pub fn vertex_of(&self, atom: usize) -> (usize, bool) {
        if self.shape.mirrored { (atom / 2, atom % 2 == 1) } else { (atom, false) }
    }

    /// The gauge of the polytope.
    pub fn gauge(&self) -> Gauge {
        let mut gauge = Gauge::new(self.dimension, self.shape.complex);
        for vertex in &self.vertices {
            self.push_with_mirror(&mut gauge, vertex);
        }
        gauge
    }

    fn push_with_mirror(&self, gauge: &mut Gauge, vertex: &[f64]) {
        gauge.push(vertex);
        if self.shape.mirrored {
            gauge.push(&mirrored(self.dimension, vertex));
        }
    }
}

fn is_short(v: &[f64]) -> bool {
    v.iter().all(|x| (x * SHORT).fract() == 0.0)
}

/// The image of a vector, real or complex.
pub(crate) fn apply(matrix: &DMatrix<f64>, v: &[f64]) -> Vec<f64> {
    let d = matrix.nrows();
    let part = |part: &[f64]| (matrix * DVector::from_column_slice(part)).as_slice().to_vec();
    v.chunks_exact(d).flat_map(part).collect()
}

/// The vector with its coordinates in reverse order.
pub(crate) fn mirrored(dimension: usize, v: &[f64]) -> Vec<f64> {
    v.chunks_exact(dimension).flat_map(|part| part.iter().rev().copied()).collect()
}

/// A real vector, followed by zero imaginary parts up to the size.
pub(crate) fn padded(v: &[f64], size: usize) -> Vec<f64> {
    v.iter().copied().chain(std::iter::repeat(0.0)).take(size).collect()
}

fn scaled(v: &[f64], factor: f64) -> Vec<f64> {
    v.iter().map(|x| x * factor).collect()
}

fn squared_length(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum()
}

#[cfg(test)]
mod tests {
    use nalgebra::dmatrix;

    use super::*;

    /// A turn by one radian, a little shorter: a polygon of many corners. The same amount of work always gives the
    /// same polygon, and with all of it spent there is none.
    #[test]
    fn growing_ends_with_the_work() {
        let (sin, cos) = 1f64.sin_cos();
        let turn = [dmatrix![cos, -sin; sin, cos] * 0.98];
        let ends = Ends { inner: &[], end: &turn };
        let shape = Shape { mirrored: false, complex: false, closing: Closing::Inside(1e-3) };
        let effort = Effort { margin: 1e-3, vertices: 200 };
        let grown = |products: u64| {
            let work = Work::of(products);
            let body = Body::grow(&ends, shape, &[Start::Free(vec![1.0, 0.0])], effort, &work);
            (body.map(|body| body.vertices), work.left())
        };
        let (polygon, left) = grown(1 << 40);
        assert!(polygon.as_ref().is_some_and(|corners| corners.len() > 3), "{polygon:?}");
        let taken = (1 << 40) - left;
        assert_eq!(grown(taken + 1), (polygon, 1));
        assert_eq!(grown(taken), (None, 0));
    }
}
