//! A polytope that the matrices at all control points map into its interior.
//!
//! Machine integers in fixed point, every rounding on the safe side; what would overflow is refused.

use refinable_algebra::Integer;

use crate::body::modulus_up;
use crate::fixed::divide_up;
use crate::map::model::{CellMotion, CellPolytope, Weights};
use crate::work::{Check, Work, ensure, fail};

/// Binary places of the matrices.
const PLACES: u32 = 48;
/// Binary places of the bound for the gauge.
const GAUGE_PLACES: u32 = 16;
/// The largest numbers of binary places of vertices and weights.
const MOST_PLACES: u32 = 40;
/// Vertices and weights are below `2^LARGEST` in absolute value, matrices below `2^12`.
const LARGEST: u32 = 44;
const LARGEST_ENTRY: u32 = 12;
const MOST_VERTICES: usize = 2000;

/// The matrices at one control point, rounded down to fixed point.
pub(crate) struct Control {
    /// For each letter, row by row.
    matrices: Vec<Vec<i128>>,
}

impl Control {
    /// The matrices whose entries are the numerators at the given places, over the denominator.
    pub fn new(matrices: &[Vec<Option<&Integer>>], denominator: &Integer) -> Check<Self> {
        let round = |entry: &Option<&Integer>| -> Check<i128> {
            let Some(entry) = entry else { return Ok(0) };
            // Division truncates: less than one place off, like rounding down.
            let fixed = i128::try_from(&((*entry << PLACES) / denominator)).unwrap_or(i128::MAX);
            ensure(fixed.abs() < 1 << (PLACES + LARGEST_ENTRY), "an entry above 4000")?;
            Ok(fixed)
        };
        let round_all = |matrix: &Vec<Option<&Integer>>| matrix.iter().map(round).collect();
        Ok(Control { matrices: matrices.iter().map(round_all).collect::<Check<_>>()? })
    }
}

/// Checks that all images are in the interior, at every point of the piece.
///
/// If the polytope moves, the piece is a triangle, and vertices and weights are affine functions of its
/// points. With barycentric coordinates `b_i` the residual `B u - Σ λ u` is `Σ b_i b_j r_ij`, and `Σ|λ|`
/// at most `Σ b_i b_j (W_i + W_j)/2`: it is enough that `(W_i + W_j)/2 + ‖r_ij‖ < 1` for all pairs.
pub(crate) fn check(
    polytope: &CellPolytope,
    dimension: usize,
    controls: &[Control],
    work: &mut Work,
) -> Check<()> {
    check_form(polytope, dimension)?;
    let motion = polytope.motion.as_ref();
    ensure(
        motion.is_none() || controls.len() == 3,
        "a polytope that moves, but not on a triangle",
    )?;
    let lists = [&polytope.vertices].into_iter().chain(motion.iter().flat_map(|m| &m.vertices));
    let lists = lists.map(|list| with_mirror_images(list, polytope.mirrored, dimension)).collect();
    let mut body = Body { polytope, dimension, lists, gauge: 0 };
    body.gauge = body.bound_of_gauge(work)?;
    let letters = controls.first().map_or(0, |control| control.matrices.len());
    for (vertex, images) in polytope.images.iter().enumerate() {
        let complete = images.len() == letters * controls.len();
        ensure(complete, "a vertex does not have an image for each letter")?;
        for letter in 0..letters {
            let corner = |i: usize| Corner {
                matrix: &controls[i].matrices[letter],
                weights: &images[i * letters + letter],
                list: if motion.is_some() { i } else { 0 },
            };
            for i in 0..controls.len() {
                let inside =
                    body.is_inside(vertex, [&corner(i), &corner(i)], &Weights::new(), work)?;
                ensure(inside, "an image of a vertex is not shown to be inside")?;
            }
            let Some(motion) = motion else { continue };
            for (k, [i, j]) in [[0, 1], [0, 2], [1, 2]].into_iter().enumerate() {
                let rest = &motion.rests[vertex];
                let Some(rest) = rest.get(3 * letter + k) else { return fail("a rest is missing") };
                let inside = body.is_inside(vertex, [&corner(i), &corner(j)], rest, work)?;
                ensure(inside, "an image of a vertex is not shown to stay inside")?;
            }
        }
    }
    Ok(())
}

fn check_form(polytope: &CellPolytope, dimension: usize) -> Check<()> {
    let places = [polytope.bits, polytope.weight_bits];
    ensure(places.iter().all(|&p| p <= MOST_PLACES), "more than 40 binary places")?;
    let count = polytope.vertices.len();
    ensure(count <= MOST_VERTICES, "more than 2000 vertices")?;
    ensure(polytope.images.len() == count, "the wrong number of images")?;
    ensure(polytope.units.len() == dimension, "the wrong number of units")?;
    let motion = polytope.motion.as_ref();
    let fits = |m: &CellMotion| {
        m.rests.len() == count && m.vertices.iter().all(|list| list.len() == count)
    };
    ensure(motion.is_none_or(fits), "the wrong number of vertices at another corner")?;
    let small = |x: &i64| x.unsigned_abs() < 1 << LARGEST;
    let length = if polytope.complex { 2 * dimension } else { dimension };
    let moved = motion.into_iter().flat_map(|m| m.vertices.iter().flatten());
    let mut vertices = polytope.vertices.iter().chain(moved);
    let fits = vertices.all(|v| v.len() == length && v.iter().all(small));
    ensure(fits, "a vertex of the wrong length, or too large")?;
    let rests = motion.into_iter().flat_map(|m| m.rests.iter().flatten());
    for weights in polytope.images.iter().flatten().chain(&polytope.units).chain(rests) {
        ensure(weights.len() <= MOST_VERTICES, "a combination of more than 2000 vertices")?;
        ensure(weights.iter().all(|t| small(&t.re) && small(&t.im)), "a weight that is too large")?;
        let real = polytope.complex || weights.iter().all(|t| t.im == 0);
        ensure(real, "a weight of a real polytope is not real")?;
    }
    Ok(())
}

fn with_mirror_images(vertices: &[Vec<i64>], mirrored: bool, d: usize) -> Vec<Vec<i64>> {
    let mirror = |v: &Vec<i64>| v.chunks(d).flat_map(|part| part.iter().rev().copied()).collect();
    let images = vertices.iter().filter(|_| mirrored).map(mirror);
    vertices.iter().cloned().chain(images).collect()
}

/// A polytope with its mirror images at every corner, and what is known of its gauge.
struct Body<'a> {
    polytope: &'a CellPolytope,
    dimension: usize,
    lists: Vec<Vec<Vec<i64>>>,
    /// `κ` with `‖v‖ ≤ κ ‖v‖_1` everywhere; rounded up, over `2^GAUGE_PLACES`.
    gauge: i128,
}

/// What belongs to an image at a control point.
struct Corner<'a> {
    matrix: &'a [i128],
    weights: &'a Weights,
    list: usize,
}

impl Body<'_> {
    /// An upper bound of `Σ|λ|`, and `Σ λ u` at a corner, over `2^weight_bits` and
    /// `2^(bits + weight_bits)`.
    fn combine(&self, weights: &Weights, list: usize, work: &mut Work) -> Check<(i128, Vec<i128>)> {
        let (d, list) = (self.dimension, &self.lists[list]);
        let complex = self.polytope.complex;
        let mut sum = vec![0; if complex { 2 * d } else { d }];
        work.spend((weights.len() * (2 * sum.len() + 4)) as u64)?;
        let mut total = 0;
        for term in weights {
            let conjugate = complex && term.index >= list.len();
            let place = if conjugate { term.index - list.len() } else { term.index };
            let Some(vertex) = list.get(place) else {
                return fail("a combination has an index that is no vertex");
            };
            total += modulus_up(term) as i128;
            // (a + ib)(x ± iy) = ax ∓ by + i(bx ± ay)
            let (a, b) = (i128::from(term.re), i128::from(term.im));
            let sign = if conjugate { -1 } else { 1 };
            for k in 0..d {
                let x = i128::from(vertex[k]);
                sum[k] += a * x;
                if complex {
                    let y = sign * i128::from(vertex[d + k]);
                    sum[k] -= b * y;
                    sum[d + k] += b * x + a * y;
                }
            }
        }
        Ok((total, sum))
    }

    /// If `e_i = Σ λ u + r_i`, then `κ ≤ max Σ|λ| + κ max ‖r_i‖_1`; `r_i` is largest at a corner.
    fn bound_of_gauge(&self, work: &mut Work) -> Check<i128> {
        let scale = self.polytope.bits + self.polytope.weight_bits;
        let (mut largest, mut rest) = (0, 0);
        for (i, weights) in self.polytope.units.iter().enumerate() {
            for list in 0..self.lists.len() {
                let (total, mut sum) = self.combine(weights, list, work)?;
                sum[i] -= 1_i128 << scale;
                largest = largest.max(total);
                rest = rest.max(sum.iter().map(|x| x.abs()).sum());
            }
        }
        let gap = (1_i128 << scale) - rest;
        ensure(gap > 0, "the units do not show that the polytope has an interior")?;
        let numerator = Integer::from(largest) << (GAUGE_PLACES + self.polytope.bits);
        let bound =
            i128::try_from(&divide_up(&numerator, &Integer::from(gap))).unwrap_or(i128::MAX);
        ensure(bound < 1 << LARGEST, "the units do not show that the polytope has an interior")?;
        Ok(bound)
    }

    /// Whether `W_i + W_j + Σ|μ| + κ ‖2 r_ij - Σ μ u‖_1 < 2` with the vertices at any corner, where
    /// `2 r_ij = B_i u_j + B_j u_i - Σ λ_i u_j - Σ λ_j u_i`.
    fn is_inside(
        &self,
        vertex: usize,
        [i, j]: [&Corner; 2],
        rest: &Weights,
        work: &mut Work,
    ) -> Check<bool> {
        let (bits, weight_bits) = (self.polytope.bits, self.polytope.weight_bits);
        let (d, shift) = (self.dimension, PLACES - weight_bits);
        let mut left = vec![0_i128; self.polytope.vertices[vertex].len()];
        let (mut total, mut size) = (0, 0);
        for (at, other) in [(i, j), (j, i)] {
            let u = &self.lists[other.list][vertex];
            let (weight, sum) = self.combine(at.weights, other.list, work)?;
            work.spend((d * d) as u64)?;
            // Otherwise it is not inside, and might be too large for what follows.
            if weight >= 1 << weight_bits {
                return Ok(false);
            }
            total += weight;
            size += u.iter().map(|&x| i128::from(x).abs()).sum::<i128>();
            let rows = |part| at.matrix.chunks_exact(d).map(move |row: &[i128]| (row, part));
            let images = u.chunks_exact(d).flat_map(rows);
            for ((l, (row, part)), s) in left.iter_mut().zip(images).zip(sum) {
                // Over 2^(PLACES + bits).
                let part: &[i64] = part;
                let image: i128 = row.iter().zip(part).map(|(a, &x)| a * i128::from(x)).sum();
                *l += image - (s << shift);
            }
        }
        let mut norm = 0;
        let lists = if rest.is_empty() { 1 } else { self.lists.len() };
        for list in 0..lists {
            let (weight, sum) = self.combine(rest, list, work)?;
            if weight >= 2 << weight_bits {
                return Ok(false);
            }
            total += if list == 0 { weight } else { 0 };
            norm = norm.max(left.iter().zip(sum).map(|(l, s)| (l - (s << shift)).abs()).sum());
        }
        // Every entry of a matrix is less than one place off.
        let norm: i128 = norm + size * d as i128;
        let two = 2_i128 << (PLACES + bits + GAUGE_PLACES);
        let total = total << (shift + bits + GAUGE_PLACES);
        // A product that overflows is far too large.
        Ok(norm.checked_mul(self.gauge).is_some_and(|norm| norm < two - total))
    }
}
