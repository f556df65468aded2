//! One polytope for several sets of matrices: they all map it into its interior, and with them every
//! mean of the sets.

use nalgebra::{Complex, DMatrix};
use refinable_certificate::{self as certificate, CellPolytope, Term};

use crate::body::{Body, Closing, Effort, Ends, Shape, Start, apply};
use crate::gauge::Atom;
use crate::leading::{eigenvalues, eigenvector, fastest, product};
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
pub(crate) const PRECISIONS: [Precision; 3] = [
    Precision { bits: 12, weight_bits: 12 },
    Precision { bits: 18, weight_bits: 18 },
    Precision { bits: 30, weight_bits: 30 },
];
/// How near to the fastest growth that of another set must be for its eigenvector to be a start.
const NEAR: f64 = 0.97;
const MOST_STARTS: usize = 3;

/// The growth of the fastest word of a set.
pub(crate) struct Leader<'a> {
    pub set: usize,
    pub word: &'a Word,
    pub growth: f64,
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
    let first = |leader: &Leader| leader.set * sets[0].len();
    let mut starts: Vec<Start> =
        near.filter_map(|leader| start(sets, leader, first(leader))).collect();
    let d = all[0].nrows();
    if starts[0].vector().len() > d {
        // The plane in which a complex vector turns; others that nearly agree are no help.
        let parts = starts[0].vector().chunks_exact(d);
        starts = parts.map(|part| Start::Free(part.to_vec())).collect();
    }
    starts.retain(|start| start.vector().len() == d);
    WAYS.iter().find_map(|&way| {
        let body = grown(&all, &starts, growth, mirrored, way)?;
        PRECISIONS.iter().find_map(|&precision| written(&body, &all, precision).filter(accept))
    })
}

/// The fastest word of each set, the fastest set first; `None` if one grows.
pub(crate) fn leaders<'a>(
    sets: &[Vec<DMatrix<f64>>],
    words: &'a [Word],
) -> Option<Vec<Leader<'a>>> {
    let leader = |(set, matrices): (usize, &Vec<DMatrix<f64>>)| {
        let (word, growth) = fastest(matrices, words);
        Leader { set, word, growth }
    };
    let mut leaders: Vec<Leader> = sets.iter().enumerate().map(leader).collect();
    leaders.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    (leaders[0].growth < 1.0).then_some(leaders)
}

/// A polytope that the matrices map into its interior: images are to be inside by a part of the room
/// that growth leaves, with unit vectors of some length inside, and no more vertices than the last number.
pub(crate) fn grown(
    matrices: &[DMatrix<f64>],
    starts: &[Start],
    growth: f64,
    mirrored: bool,
    (part, fatness, vertices): (f64, f64, usize),
) -> Option<Body> {
    let complex = starts[0].vector().len() > matrices[0].nrows();
    let shape = Shape { mirrored, complex, closing: Closing::Inside(room(growth)) };
    let seed = Seed { shape, starts: starts.to_vec() }.fattened(fatness);
    let effort = Effort { margin: (part * (1.0 - growth)).min(0.02), vertices };
    Body::grow(&Ends { inner: &[], end: matrices }, shape, &seed.starts, effort)
}

/// The leading eigenvector of a word, with its orbit; the letters of the set begin with `first`.
pub(crate) fn start(sets: &[Vec<DMatrix<f64>>], leader: &Leader, first: usize) -> Option<Start> {
    let matrix = product(&sets[leader.set], leader.word);
    let leading = eigenvalues(&matrix).first().copied()?;
    let vector = eigenvector(&matrix, leading)?;
    let word = leader.word.shifted(first);
    Some(Start::Orbit { word, growth: leader.growth, vector })
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
    let kept = kept_of(&images);
    Some(CellPolytope {
        complex: false,
        mirrored: body.shape.mirrored,
        bits: precision.bits,
        vertices: kept.iter().map(|&v| rounded.integers[v].clone()).collect(),
        weight_bits: precision.weight_bits,
        units: units.iter().map(|unit| renumbered(&rounded, &kept, unit)).collect(),
        images: renumbered_all(&rounded, &kept, &images),
        motion: None,
    })
}

/// The vertices of which something is known.
pub(crate) fn kept_of<T>(known: &[Option<T>]) -> Vec<usize> {
    (0..known.len()).filter(|&v| known[v].is_some()).collect()
}

/// Weights of kept vertices, mirror images after them, conjugates after those.
pub(crate) fn renumbered(
    rounded: &Rounded,
    kept: &[usize],
    weights: &Weights,
) -> certificate::Weights {
    let listed = if rounded.body.shape.mirrored { 2 * kept.len() } else { kept.len() };
    let term = |(atom, weight): &(Atom, Complex<i64>)| {
        let (vertex, mirror) = rounded.vertex_of(*atom);
        let place = kept.binary_search(&vertex).expect("what is met is kept");
        let place = place + if mirror { kept.len() } else { 0 };
        let conjugate = matches!(atom, Atom::Conjugate(_));
        let index = place + if conjugate { listed } else { 0 };
        Term { index, re: weight.re, im: weight.im }
    };
    let mut terms: Vec<Term> = weights.iter().map(term).collect();
    terms.sort_unstable_by_key(|term| term.index);
    terms
}

/// The same for all kept vertices.
pub(crate) fn renumbered_all(
    rounded: &Rounded,
    kept: &[usize],
    known: &[Option<Vec<Weights>>],
) -> Vec<Vec<certificate::Weights>> {
    let of = |&v: &usize| known[v].iter().flatten().map(|w| renumbered(rounded, kept, w)).collect();
    kept.iter().map(of).collect()
}

/// The vertices that are met.
pub(crate) fn vertices_of<'a>(
    rounded: &Rounded,
    weights: impl Iterator<Item = &'a (Atom, Complex<i64>)>,
) -> Vec<usize> {
    weights.map(|(atom, _)| rounded.vertex_of(*atom).0).collect()
}
