//! A polytope that the matrices at all control points map into its interior.
//!
//! Machine integers in fixed point, every rounding on the safe side; what would overflow is refused.

use refinable_algebra::Integer;

use crate::fixed::divide_up;
use crate::map::model::{CellPolytope, Weights};
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
            let small = fixed.unsigned_abs() < 1 << (PLACES + LARGEST_ENTRY);
            ensure(small, "an entry above 4000")?;
            Ok(fixed)
        };
        let round_all = |matrix: &Vec<Option<&Integer>>| matrix.iter().map(round).collect();
        Ok(Control { matrices: matrices.iter().map(round_all).collect::<Check<_>>()? })
    }
}

/// Checks that all images are in the interior.
pub(crate) fn check(
    polytope: &CellPolytope,
    dimension: usize,
    controls: &[Control],
    work: &mut Work,
) -> Check<()> {
    check_form(polytope, dimension)?;
    let vertices = with_mirror_images(polytope);
    let gauge = bound_of_gauge(polytope, dimension, &vertices, work)?;
    let letters = controls.iter().flat_map(|control| &control.matrices);
    let count = letters.clone().count();
    for (vertex, images) in polytope.vertices.iter().zip(&polytope.images) {
        ensure(images.len() == count, "a vertex does not have an image for each letter")?;
        for (matrix, weights) in letters.clone().zip(images) {
            let inside = is_inside(polytope, &vertices, vertex, matrix, weights, gauge, work)?;
            ensure(inside, "an image of a vertex is not shown to be inside")?;
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
    ensure(polytope.vertices.iter().all(|v| v.len() == dimension), "a vertex of the wrong length")?;
    let images = polytope.images.iter().flatten();
    let small = |x: &i64| x.unsigned_abs() < 1 << LARGEST;
    ensure(polytope.vertices.iter().flatten().all(small), "a vertex that is too large")?;
    for weights in images.chain(&polytope.units) {
        ensure(weights.len() <= MOST_VERTICES, "a combination of more than 2000 vertices")?;
        ensure(weights.iter().all(|(_, w)| small(w)), "a weight that is too large")?;
    }
    Ok(())
}

fn with_mirror_images(polytope: &CellPolytope) -> Vec<Vec<i64>> {
    let mirrored = polytope.vertices.iter().filter(|_| polytope.mirrored);
    let images = mirrored.map(|v| v.iter().rev().copied().collect());
    polytope.vertices.iter().cloned().chain(images).collect()
}

/// `Σ|λ|` and `Σ λ u`, over `2^weight_bits` and `2^(bits + weight_bits)`.
fn combine(
    weights: &Weights,
    vertices: &[Vec<i64>],
    dimension: usize,
    work: &mut Work,
) -> Check<(i128, Vec<i128>)> {
    work.spend((weights.len() * (dimension + 4)) as u64)?;
    let mut sum = vec![0; dimension];
    let mut total = 0;
    for &(index, weight) in weights {
        let Some(vertex) = vertices.get(index) else {
            return fail("a combination has an index that is no vertex");
        };
        let weight = i128::from(weight);
        total += weight.abs();
        sum.iter_mut().zip(vertex).for_each(|(s, &x)| *s += weight * i128::from(x));
    }
    Ok((total, sum))
}

/// `κ` with `‖v‖ ≤ κ ‖v‖_1`: if `e_i = Σ λ u + r_i`, then `κ ≤ max Σ|λ| + κ max ‖r_i‖_1`. Rounded up,
/// over `2^GAUGE_PLACES`.
fn bound_of_gauge(
    polytope: &CellPolytope,
    dimension: usize,
    vertices: &[Vec<i64>],
    work: &mut Work,
) -> Check<i128> {
    let scale = polytope.bits + polytope.weight_bits;
    let (mut largest, mut rest) = (0, 0);
    for (i, weights) in polytope.units.iter().enumerate() {
        let (total, mut sum) = combine(weights, vertices, dimension, work)?;
        sum[i] -= 1_i128 << scale;
        largest = largest.max(total);
        rest = rest.max(sum.iter().map(|x| x.abs()).sum());
    }
    let gap = (1_i128 << scale) - rest;
    ensure(gap > 0, "the units do not show that the polytope has an interior")?;
    let numerator = Integer::from(largest) << (GAUGE_PLACES + polytope.bits);
    let bound = i128::try_from(&divide_up(&numerator, &Integer::from(gap))).unwrap_or(i128::MAX);
    ensure(bound < 1 << LARGEST, "the units do not show that the polytope has an interior")?;
    Ok(bound)
}

/// Whether `Σ|λ| + κ ‖B u - Σ λ u‖_1 < 1`.
fn is_inside(
    polytope: &CellPolytope,
    vertices: &[Vec<i64>],
    vertex: &[i64],
    matrix: &[i128],
    weights: &Weights,
    gauge: i128,
    work: &mut Work,
) -> Check<bool> {
    let d = vertex.len();
    let (total, sum) = combine(weights, vertices, d, work)?;
    work.spend((d * d) as u64)?;
    if total >= 1 << polytope.weight_bits {
        return Ok(false);
    }
    // Over 2^(PLACES + bits).
    let product = |row: &[i128]| row.iter().zip(vertex).map(|(a, &x)| a * i128::from(x)).sum();
    let image = matrix.chunks_exact(d).map(product);
    let shift = PLACES - polytope.weight_bits;
    let rest: i128 = image.zip(&sum).map(|(a, s): (i128, _)| (a - (s << shift)).abs()).sum();
    // Every entry of the matrix is less than one place off.
    let size: i128 = vertex.iter().map(|&x| i128::from(x).abs()).sum();
    let rest = rest + size * d as i128;
    let one = 1_i128 << (PLACES + polytope.bits + GAUGE_PLACES);
    let total = total << (shift + polytope.bits + GAUGE_PLACES);
    // A product that overflows is far too large.
    Ok(rest.checked_mul(gauge).is_some_and(|rest| rest < one - total))
}
