//! What a polytope begins with: leading eigenvectors, and what may keep them company.

use std::cell::OnceCell;

use nalgebra::DMatrix;
use refinable_reals::RealAlgebraic;

use crate::body::{Body, Closing, Effort, Ends, Shape, Start, padded};
use crate::gauge::Limits;
use crate::leading::{eigenvalues, eigenvector, fixed_vector, is_complex, product};
use crate::recipe::{Company, LENGTHS, room};
use crate::search::Crossing;
use crate::word::Word;
use crate::work::Work;

/// Other eigenvectors of the leading word keep it company whose eigenvalues are not below this part of
/// the largest: they make the polytope stout, which helps images inside.
const KIN: f64 = 0.3;
/// Eigenvectors of other words do that grow nearly as fast,
const RIVAL: f64 = 0.97;
/// if they are no longer and not more than this.
const RIVAL_LENGTH: usize = 4;
const MOST_RIVALS: usize = 2;
/// How many leading words are told apart.
const MOST_ORBITS: usize = 4;
/// Lengths of the company where all images are vertices, which stay short.
const VERTEX_LENGTHS: [f64; 4] = [0.875, 0.9375, 0.8125, 1.0];
/// How far outside a rival is, without which it would be of no use, and with which the leading
/// vector is not inside.
const OUTSIDE: f64 = 1.15;
/// Growth below which a complex leading pair needs no complex polytope.
const REAL: f64 = 0.95;
/// The effort after which it is seen where the boundary would be without rivals.
const GLANCE: Effort = Effort { margin: 1e-5, vertices: 60 };

/// The first vertices of a polytope.
#[derive(Clone, Debug)]
pub(crate) struct Seed {
    pub shape: Shape,
    pub starts: Vec<Start>,
}

impl Seed {
    /// With unit vectors of this length besides.
    pub fn fattened(&self, length: f64) -> Self {
        let size = self.starts[0].vector().len();
        let dimension = if self.shape.complex { size / 2 } else { size };
        // Mirror images do for the other half.
        let units = if self.shape.mirrored { dimension.div_ceil(2) } else { dimension };
        let unit = |i: usize| (0..size).map(|j| if i == j { length } else { 0.0 }).collect();
        let units = (0..units).map(|i| Start::Free(unit(i)));
        Seed { shape: self.shape, starts: self.starts.iter().cloned().chain(units).collect() }
    }
}

/// Seeds for a place where every word shrinks.
pub(crate) struct Inside<'a> {
    sowing: Sowing<'a>,
    /// The leading vector with its orbit.
    orbit: Option<Start>,
    growth: f64,
    /// Much work, and mostly not needed.
    accompanied: OnceCell<Vec<Seed>>,
}

impl Inside<'_> {
    /// The seed with this company, if there is one.
    pub fn seed(&self, company: Company) -> Option<Seed> {
        let orbit = self.orbit.as_ref()?;
        let d = self.sowing.matrices[0].nrows();
        let complex = orbit.vector().len() > d;
        let closing = Closing::Inside(room(self.growth));
        let shape = Shape { mirrored: self.sowing.mirrored, complex, closing };
        match company {
            Company::Polygon if complex && self.growth < REAL => {
                let parts = orbit.vector().chunks_exact(d);
                let starts = parts.map(|part| Start::Free(part.to_vec())).collect();
                Some(Seed { shape: Shape { complex: false, ..shape }, starts })
            }
            Company::Polygon => None,
            Company::Alone => Some(Seed { shape, starts: vec![orbit.clone()] }),
            Company::Length(length) => {
                let k = LENGTHS.iter().position(|l| *l == length)?;
                let rivals = || self.sowing.rivals(self.growth, true);
                let all = || self.sowing.seeds(closing, std::slice::from_ref(orbit), &rivals());
                // The first is alone.
                self.accompanied.get_or_init(all).get(k + 1).cloned()
            }
        }
    }
}

/// Where seeds are sought.
#[derive(Clone, Copy)]
pub(crate) struct Sowing<'a> {
    pub mirrored: bool,
    pub words: &'a [Word],
    pub matrices: &'a [DMatrix<f64>],
}

impl<'a> Sowing<'a> {
    /// For an end at which words reach one: orbits of their eigenvectors, and if it is rational
    /// eigenvectors whose images may be vertices. In the order of what is likely to do.
    pub fn up_to(&self, end: &RealAlgebraic, crossings: &[Crossing]) -> Vec<Seed> {
        let leading: Vec<&Crossing> =
            crossings.iter().filter(|c| end.sign_of(&c.determinant).is_eq()).collect();
        let vector = |c: &&Crossing| fixed_vector(&product(self.matrices, &c.word), c.sign);
        let vectors: Vec<Option<Vec<f64>>> = leading.iter().map(vector).collect();
        let mut seeds = Vec::new();
        // Eigenvectors that are not unique lead no orbits.
        if vectors.iter().all(Option::is_some) {
            let orbits = leading.iter().zip(vectors.iter().flatten()).map(|(crossing, v)| {
                Start::Orbit { word: crossing.word.clone(), growth: 1.0, vector: v.clone() }
            });
            // Where very many words reach one together there is no telling them apart.
            let orbits: Vec<Start> = orbits.take(MOST_ORBITS).collect();
            seeds.extend(self.seeds(Closing::Orbits, &orbits, &self.rivals(1.0, false)));
        }
        if end.as_rational().is_some() {
            let starts = vectors.iter().flatten().filter_map(|v| integral(v)).map(Start::Free);
            let vertices = self.seeds(Closing::Vertices, &starts.collect::<Vec<_>>(), &[]);
            // Several eigenvectors at a rational end are more likely to span a plane in which a
            // finite group acts than to lead orbits of their own.
            let at = if leading.len() > 1 { 0 } else { seeds.len() };
            seeds.splice(at..at, vertices);
        }
        seeds
    }

    /// For a place where the fastest word grows by less than one.
    pub fn inside(self, word: &Word, growth: f64) -> Inside<'a> {
        Inside {
            sowing: self,
            orbit: self.orbit(word, growth),
            growth,
            accompanied: OnceCell::new(),
        }
    }

    /// The leading eigenvector of a word.
    fn orbit(&self, word: &Word, growth: f64) -> Option<Start> {
        let matrix = product(self.matrices, word);
        let leading = eigenvalues(&matrix).first().copied()?;
        let vector = eigenvector(&matrix, leading)?;
        Some(Start::Orbit { word: word.clone(), growth, vector })
    }

    /// Leading eigenvectors of short words that grow nearly as fast; complex ones too if that is
    /// allowed.
    fn rivals(&self, growth: f64, complex: bool) -> Vec<Start> {
        let mut found: Vec<(f64, Start)> = Vec::new();
        for word in self.words.iter().filter(|word| word.letters().len() <= RIVAL_LENGTH) {
            let matrix = product(self.matrices, word);
            let leading = eigenvalues(&matrix).first().copied();
            let Some(z) = leading.filter(|z| complex || !is_complex(z)) else { continue };
            let rate = z.norm().powf(1.0 / word.letters().len() as f64) / growth;
            if (RIVAL..1.0 - 1e-9).contains(&rate) {
                let start = |vector| Start::Companion { word: word.clone(), vector };
                found.extend(eigenvector(&matrix, z).map(start).map(|start| (rate, start)));
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().take(MOST_RIVALS).map(|(_, start)| start).collect()
    }

    /// Eigenvectors of the word for its smaller eigenvalues; complex ones too if that is allowed.
    fn kin(&self, word: &Word, complex: bool) -> Vec<Start> {
        let matrix = product(self.matrices, word);
        let values = eigenvalues(&matrix);
        let largest = values.first().map_or(0.0, |z| z.norm());
        let kin = values.iter().filter(|z| {
            (KIN..1.0 - 1e-9).contains(&(z.norm() / largest)) && (complex || !is_complex(z))
        });
        let vectors = kin.filter_map(|z| eigenvector(&matrix, *z));
        vectors.map(|vector| Start::Companion { word: word.clone(), vector }).collect()
    }

    /// Each of the leading starts with company of several lengths, and alone.
    fn seeds(&self, closing: Closing, leading: &[Start], rivals: &[Start]) -> Vec<Seed> {
        let d = self.matrices[0].nrows();
        let mut all: Vec<Start> = leading.iter().chain(rivals).cloned().collect();
        let complex = all.iter().any(|start| start.vector().len() > d);
        if complex {
            all.iter_mut().for_each(|start| *start.vector_mut() = padded(start.vector(), 2 * d));
        }
        let shape = Shape { mirrored: self.mirrored, complex, closing };
        let starts = (0..leading.len()).flat_map(|first| {
            let mut others = all.clone();
            let first = others.remove(first);
            self.accompanied(shape, &first, &others)
        });
        starts.map(|starts| Seed { shape, starts }).collect()
    }

    /// A start with its rivals just outside of what it would lead to alone, and with its kin, all in
    /// several lengths; and alone.
    fn accompanied(&self, shape: Shape, first: &Start, rivals: &[Start]) -> Vec<Vec<Start>> {
        let alone = vec![first.clone()];
        let mut company = match first {
            Start::Orbit { word, .. } => self.kin(word, shape.complex),
            _ => Vec::new(),
        };
        let size = first.vector().len();
        company.iter_mut().for_each(|start| *start.vector_mut() = padded(start.vector(), size));
        if shape.closing == Closing::Vertices {
            company.extend(rivals.iter().cloned());
        } else if !rivals.is_empty() {
            let ends = Ends { inner: &[], end: self.matrices };
            let glance = Body::grown(&ends, shape, &alone, GLANCE, &Work::unbounded()).0;
            let mut gauge = glance.gauge();
            let limits = Limits { inside: 0.0, outside: f64::INFINITY, accuracy: 0.01 };
            company.extend(rivals.iter().map(|start| {
                let total = gauge.represent(start.vector(), limits).total;
                start.stretched(short(OUTSIDE / total))
            }));
        }
        if company.is_empty() {
            return vec![alone];
        }
        let lengths = match shape.closing {
            Closing::Vertices => &VERTEX_LENGTHS[..],
            _ => &LENGTHS[..],
        };
        let with = lengths.iter().map(|&length| {
            let company = company.iter().map(|start| start.stretched(short(length)));
            [first.clone()].into_iter().chain(company).collect()
        });
        [alone.clone()].into_iter().chain(with).collect()
    }
}

/// The factor with few binary places, so that short vectors stay short.
fn short(factor: f64) -> f64 {
    let unit = 2f64.powi(factor.log2().floor() as i32 - 5);
    (factor / unit).round() * unit
}

/// The multiple of a vector by the least integer, against its largest coordinate, that makes
/// it integral, divided by a power of two.
fn integral(v: &[f64]) -> Option<Vec<f64>> {
    let largest = v.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let multiple = |q: u32| v.iter().map(move |x| x / largest * f64::from(q));
    let near = |x: f64| (x - x.round()).abs() < 1e-9;
    let q = (1..1000).find(|&q| multiple(q).all(near))?;
    let scale = f64::from(q.next_power_of_two());
    Some(multiple(q).map(|x| x.round() / scale).collect())
}
