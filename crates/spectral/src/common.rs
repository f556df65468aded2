//! One polytope for several sets of matrices: they all map it into its interior, and with them every
//! mean of the sets.

use nalgebra::DMatrix;
use refinable_certificate::{self as certificate, CellPolytope};

use crate::body::{Body, Closing, Effort, Ends, Shape, Start, apply};
use crate::gauge::Atom;
use crate::leading::{eigenvalues, eigenvector, fastest, is_complex, product};
use crate::recipe::room;
use crate::rounding::{Precision, Rounded};
use crate::seed::Seed;
use crate::word::Word;
use crate::writing::{Weights, Writer};

/// In which ways a polytope is grown: by what part of the room images are to be inside, the length of
/// unit vectors inside, and the largest number of vertices.
const WAYS: [(f64, f64, usize); 4] =
    [(0.1, 1.0, 60), (0.1, 0.1, 60), (0.1, 0.1, 250), (0.02, 1.0, 120)];
/// Binary places of vertices and weights, tried in turn.
const PRECISIONS: [Precision; 3] = [
    Precision { bits: 12, weight_bits: 12 },
    Precision { bits: 18, weight_bits: 18 },
    Precision { bits: 30, weight_bits: 30 },
];
/// How near to the fastest growth that of another set must be for its eigenvector to be a start.
const NEAR: f64 = 0.97;
const MOST_STARTS: usize = 3;

/// The growth of the fastest word of a set.
struct Leader<'a> {
    set: usize,
    word: &'a Word,
    growth: f64,
}

/// A polytope that all sets map into its interior and that is accepted, if one is found.
pub(crate) fn common_polytope(
    sets: &[Vec<DMatrix<f64>>],
    mirrored: bool,
    words: &[Word],
    accept: &dyn Fn(&CellPolytope) -> bool,
) -> Option<CellPolytope> {
    let leaders = leaders(sets, words)?;
    let growth = leaders[0].growth;
    let all: Vec<DMatrix<f64>> = sets.iter().flatten().cloned().collect();
    let near = leaders.iter().filter(|leader| leader.growth > NEAR * growth).take(MOST_STARTS);
    let mut starts: Vec<Vec<Start>> = near.map(|leader| starts(sets, leader)).collect();
    if starts[0].len() > 1 {
        // Planes that nearly agree do not help each other.
        starts.truncate(1);
    }
    let starts = starts.concat();
    grown(&all, &starts, growth, mirrored).find_map(|body| {
        PRECISIONS.iter().find_map(|&precision| written(&body, &all, precision).filter(accept))
    })
}

/// The fastest word of each set, the fastest set first; `None` if one grows.
fn leaders<'a>(sets: &[Vec<DMatrix<f64>>], words: &'a [Word]) -> Option<Vec<Leader<'a>>> {
    let leader = |(set, matrices): (usize, &Vec<DMatrix<f64>>)| {
        let (word, growth) = fastest(matrices, words);
        Leader { set, word, growth }
    };
    let mut leaders: Vec<Leader> = sets.iter().enumerate().map(leader).collect();
    leaders.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    (leaders[0].growth < 1.0).then_some(leaders)
}

/// Polytopes that the matrices map into their interior, grown in several ways.
fn grown(
    matrices: &[DMatrix<f64>],
    starts: &[Start],
    growth: f64,
    mirrored: bool,
) -> impl Iterator<Item = Body> {
    let shape = Shape { mirrored, complex: false, closing: Closing::Inside(room(growth)) };
    WAYS.iter().filter_map(move |&(part, fatness, vertices)| {
        let seed = Seed { shape, starts: starts.to_vec() }.fattened(fatness);
        let effort = Effort { margin: (part * (1.0 - growth)).min(0.02), vertices };
        Body::grow(&Ends { inner: &[], end: matrices }, shape, &seed.starts, effort)
    })
}

/// The leading eigenvector of a word, with its orbit, or the plane in which a complex one turns.
fn starts(sets: &[Vec<DMatrix<f64>>], leader: &Leader) -> Vec<Start> {
    let matrices = &sets[leader.set];
    let matrix = product(matrices, leader.word);
    let Some(leading) = eigenvalues(&matrix).first().copied() else { return Vec::new() };
    let Some(vector) = eigenvector(&matrix, leading) else { return Vec::new() };
    if is_complex(&leading) {
        return vector.chunks_exact(matrix.nrows()).map(|v| Start::Free(v.to_vec())).collect();
    }
    let word = leader.word.shifted(leader.set * matrices.len());
    vec![Start::Orbit { word, growth: leader.growth, vector }]
}

/// The polytope in integers, with the vertices that are met from those that represent the unit vectors.
fn written(body: &Body, matrices: &[DMatrix<f64>], precision: Precision) -> Option<CellPolytope> {
    let rounded = Rounded::new(body, precision);
    let mut writer = Writer::new(&rounded.body, None, precision);
    let units = writer.units()?;
    let mut images: Vec<Option<Vec<Weights>>> = vec![None; body.vertices.len()];
    let mut kept: Vec<usize> = vertices_of(&rounded, units.iter().flatten());
    while let Some(vertex) = kept.pop() {
        if images[vertex].is_some() {
            continue;
        }
        let of = matrices.iter().map(|matrix| {
            let image = apply(matrix, &rounded.body.vertices[vertex]);
            writer.inside(&image).map(|written| written.weights)
        });
        let of: Vec<Weights> = of.collect::<Option<_>>()?;
        kept.extend(vertices_of(&rounded, of.iter().flatten()));
        images[vertex] = Some(of);
    }
    let kept: Vec<usize> = (0..images.len()).filter(|&v| images[v].is_some()).collect();
    let weights = |weights: &Weights| -> certificate::Weights {
        let mut terms: Vec<(usize, i64)> = weights
            .iter()
            .map(|(atom, weight)| {
                let (vertex, mirror) = rounded.vertex_of(*atom);
                let place = kept.binary_search(&vertex).expect("what is met is kept");
                (place + if mirror { kept.len() } else { 0 }, weight.re)
            })
            .collect();
        terms.sort_unstable();
        terms
    };
    let of_vertex = |&v: &usize| images[v].iter().flatten().map(weights).collect();
    Some(CellPolytope {
        mirrored: body.shape.mirrored,
        bits: precision.bits,
        vertices: kept.iter().map(|&v| rounded.integers[v].clone()).collect(),
        weight_bits: precision.weight_bits,
        units: units.iter().map(weights).collect(),
        images: kept.iter().map(of_vertex).collect(),
    })
}

fn vertices_of<'a>(
    rounded: &Rounded,
    weights: impl Iterator<Item = &'a (Atom, nalgebra::Complex<i64>)>,
) -> Vec<usize> {
    weights.map(|(atom, _)| rounded.vertex_of(*atom).0).collect()
}
