//! Ways to grow a polytope where every word shrinks.

use crate::body::Effort;

/// The lengths of unit vectors inside a polytope, the best first: the fatter it is, the less it minds
/// that matrices change.
pub(crate) const FATNESS: [f64; 3] = [1.0, 0.1, 0.01];
/// By how much images must be inside: a part of what is left between growth and one, since with all
/// of it nothing would close, but no less than so much, since only the leading orbit need be so near
/// the boundary.
const MARGINS: [(f64, f64); 2] = [(0.25, 1e-3), (0.025, 1e-5)];
/// The largest numbers of vertices, mirror images not counted: few are tried first,
const FEW: [usize; 2] = [60, 240];
/// and many if nothing else helps.
const MANY: [usize; 1] = [750];
/// Into how many lengths of its company a leading vector is put.
pub(crate) const LENGTHS: [f64; 6] = [1.0, 0.5, 2.0, 0.25, 4.0, 0.1];

/// What a leading vector begins with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Company {
    /// Nothing, and in place of the disc in which a complex vector turns a polygon.
    Polygon,
    /// Nothing.
    Alone,
    /// Other eigenvectors, so many times as long as they would be.
    Length(f64),
}

/// A way to grow a polytope.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Recipe {
    pub company: Company,
    pub fatness: f64,
    margin: (f64, f64),
    vertices: usize,
}

impl Recipe {
    /// All recipes, those first that are cheap or likely to succeed.
    pub fn all() -> impl Iterator<Item = Recipe> {
        let alone = [Company::Polygon, Company::Alone];
        let company = LENGTHS.map(Company::Length);
        let first = alone.into_iter().chain(company).flat_map(|c| Recipe::of(c, &FEW));
        first.chain(alone.into_iter().flat_map(|c| Recipe::of(c, &MANY)))
    }

    fn of(company: Company, most: &[usize]) -> impl Iterator<Item = Recipe> {
        most.iter().flat_map(move |&vertices| {
            let margins = MARGINS.into_iter();
            margins.flat_map(move |margin| {
                FATNESS.map(|fatness| Recipe { company, fatness, margin, vertices })
            })
        })
    }

    /// What this recipe asks for where words grow by less than one.
    pub fn effort(&self, growth: f64) -> Effort {
        let (part, least) = self.margin;
        Effort { margin: spare(growth, part).max(least), vertices: self.vertices }
    }
}

/// By how much the leading orbit is to be inside.
pub(crate) fn room(growth: f64) -> f64 {
    spare(growth, 0.1)
}

/// This part of what is left between growth and one.
fn spare(growth: f64, part: f64) -> f64 {
    (part * (1.0 - growth)).clamp(1e-11, 1e-2)
}
