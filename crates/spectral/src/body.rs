//! Growing a polytope that all matrices map into itself, in floats.
//!
//! # Source
//! N. Guglielmi, V. Yu. Protasov, *Exact computation of joint spectral characteristics of linear
//! operators*, Found. Comput. Math. 13 (2013): begin with the leading eigenvectors, add every image
//! that is outside, until none is.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use crate::gauge::{Gauge, Limits};
use crate::word::Word;

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

/// A symmetric polytope with its mirror images, by vertices.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub vertices: Vec<Vec<f64>>,
    pub orbits: Vec<Orbit>,
    pub mirrored: bool,
}

/// The vertices `first, first + 1, …` are the orbit of an eigenvector along a word.
#[derive(Clone, Debug)]
pub(crate) struct Orbit {
    pub word: Word,
    pub sign: i32,
    pub first: usize,
}

/// By how much an image must be inside that is the next vertex of an orbit at the end.
const JUST_INSIDE: f64 = 1e-8;

#[derive(Clone, Copy)]
enum Side {
    Inner,
    End,
}

struct Image {
    vector: DVector<f64>,
    margin: f64,
}

/// Where a search begins.
#[derive(Clone, Debug)]
pub(crate) enum Start {
    /// An eigenvector for the eigenvalue `sign` of the product along the word.
    Orbit(Word, i32, DVector<f64>),
    /// Any vector.
    Free(DVector<f64>),
}

impl Start {
    /// The same start with its vector made longer or shorter.
    pub fn stretched(&self, factor: f64) -> Self {
        match self {
            Start::Orbit(word, sign, v) => Start::Orbit(word.clone(), *sign, v * factor),
            Start::Free(v) => Start::Free(v * factor),
        }
    }
}

impl Body {
    /// Adds images under the matrices at both ends until all images are inside, by `margin` at
    /// least, but for those that close an orbit. `None` if there are too many.
    pub fn grow(ends: &Ends, mirrored: bool, starts: &[Start], effort: Effort) -> Option<Self> {
        let Effort { margin, vertices } = effort;
        let mut body = Body { vertices: Vec::new(), orbits: Vec::new(), mirrored };
        for start in starts {
            body.begin(ends.end, start);
        }
        let mut gauge = body.gauge();
        let (mut at_end, mut at_inner) = (0, 0);
        loop {
            // All images at the end first; most images at the other end are then inside too.
            let (side, from) = match (at_end < body.vertices.len(), at_inner < body.vertices.len())
            {
                (true, _) => (Side::End, &mut at_end),
                (false, true) => (Side::Inner, &mut at_inner),
                (false, false) => return Some(body),
            };
            let generation = *from..body.vertices.len();
            *from = body.vertices.len();
            let mut images = body.images(ends, side, generation, margin);
            // Long images first: they may swallow the others.
            images.sort_by(|a, b| b.vector.norm().total_cmp(&a.vector.norm()));
            for Image { vector, margin } in images {
                let limits = Limits { inside: 1.0 - margin, outside: 1.0 + 1e-9 };
                if gauge.represent(vector.as_slice(), limits).total > limits.inside {
                    body.add(&mut gauge, vector * (1.0 + 2.0 * effort.margin));
                    if body.vertices.len() > vertices {
                        return None;
                    }
                }
            }
        }
    }

    fn begin(&mut self, matrices: &[DMatrix<f64>], start: &Start) {
        match start {
            Start::Free(v) => self.vertices.push(v.as_slice().to_vec()),
            Start::Orbit(word, sign, v) => {
                let first = self.vertices.len();
                self.orbits.push(Orbit { word: word.clone(), sign: *sign, first });
                let mut v = v.clone();
                for &letter in word.letters() {
                    self.vertices.push(v.as_slice().to_vec());
                    v = &matrices[usize::from(letter)] * v;
                }
            }
        }
    }

    fn add(&mut self, gauge: &mut Gauge, vertex: DVector<f64>) {
        let vertex = vertex.as_slice().to_vec();
        push_with_mirror(gauge, &vertex, self.mirrored);
        self.vertices.push(vertex);
    }

    /// The images that have to be inside, and by how much.
    fn images(&self, ends: &Ends, side: Side, generation: Range<usize>, margin: f64) -> Vec<Image> {
        let matrices = match side {
            Side::End => ends.end,
            Side::Inner => ends.inner,
        };
        let mut images = Vec::new();
        for vertex in generation {
            let v = DVector::from_column_slice(&self.vertices[vertex]);
            for (letter, m) in matrices.iter().enumerate() {
                let margin = match (side, self.closes_orbit(vertex, letter)) {
                    (Side::End, true) => continue,
                    // Near the end this image is near the next vertex of the orbit: only just inside.
                    (Side::Inner, true) => JUST_INSIDE,
                    // Less than the excess that vertices get, so that small changes add none.
                    (Side::Inner, false) => margin / 4.0,
                    (Side::End, false) => margin,
                };
                images.push(Image { vector: m * &v, margin });
            }
        }
        images
    }

    /// Whether the image of the vertex under the letter is the next vertex of its orbit.
    pub fn closes_orbit(&self, vertex: usize, letter: usize) -> bool {
        self.orbits.iter().any(|orbit| {
            let step = vertex.checked_sub(orbit.first);
            step.and_then(|k| orbit.word.letters().get(k)) == Some(&(letter as u8))
        })
    }

    /// The gauge of the polytope; atom `k` is vertex `k`, or with mirror images vertex `k / 2`.
    pub fn gauge(&self) -> Gauge {
        let dimension = self.vertices.first().map_or(0, Vec::len);
        let mut gauge = Gauge::new(dimension);
        for vertex in &self.vertices {
            push_with_mirror(&mut gauge, vertex, self.mirrored);
        }
        gauge
    }

    /// Unit vectors in whose direction the polytope is thinner than `ratio` of its width.
    pub fn thin_directions(&self, ratio: f64) -> Vec<DVector<f64>> {
        let mut columns: Vec<DVector<f64>> =
            self.vertices.iter().map(|v| DVector::from_column_slice(v)).collect();
        if self.mirrored {
            let mirror = |v: &Vec<f64>| DVector::from_iterator(v.len(), v.iter().rev().copied());
            columns.extend(self.vertices.iter().map(mirror));
        }
        let d = columns[0].len();
        let gram = columns.iter().fold(DMatrix::zeros(d, d), |sum, v| sum + v * v.transpose());
        let eigen = gram.symmetric_eigen();
        let widest = eigen.eigenvalues.max();
        (0..d)
            .filter(|&i| eigen.eigenvalues[i] < widest * ratio * ratio)
            .map(|i| eigen.eigenvectors.column(i).into_owned())
            .collect()
    }
}

fn push_with_mirror(gauge: &mut Gauge, vertex: &[f64], mirrored: bool) {
    gauge.push(vertex);
    if mirrored {
        let mirror: Vec<f64> = vertex.iter().rev().copied().collect();
        gauge.push(&mirror);
    }
}
