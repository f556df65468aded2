//! Ellipsoids that move with the point of a polygon, in the integers of a certificate.

use nalgebra::DMatrix;
use refinable_certificate::Ellipsoids;

use crate::ellipsoid::{Centre, MOST_MEMORY};
use crate::geometry::{Place, extent};
use crate::plane::PlanePencil;

/// Bits of the largest entry, tried in turn.
const BITS: [i32; 2] = [20, 34];
/// The step for derivatives, against the extents of the polygon.
const STEP: f64 = 1e-4;

/// Ellipsoids that are accepted, if they are found: those at the middle of the polygon, and at its corners
/// what their derivatives say.
pub(crate) fn moving_ellipsoids(
    pencil: &PlanePencil,
    corners: &[Place],
    accept: &dyn Fn(&Ellipsoids) -> bool,
) -> Option<Ellipsoids> {
    (0..=MOST_MEMORY).find_map(|memory| {
        let at_corners = tangent(pencil, corners, memory)?;
        BITS.iter().map(|&bits| rounded(&at_corners, memory, bits)).find(|found| accept(found))
    })
}

/// For each corner the ellipsoids.
fn tangent(
    pencil: &PlanePencil,
    corners: &[Place],
    memory: u32,
) -> Option<Vec<Vec<DMatrix<f64>>>> {
    let middle = [0, 1].map(|k| corners.iter().map(|c| c[k]).sum::<f64>() / corners.len() as f64);
    let centre = Centre::find(&pencil.letters_at(middle), memory)?;
    let mut moving = Vec::new();
    for axis in [[1.0, 0.0], [0.0, 1.0]] {
        let (low, high) = extent(corners, axis);
        let step = STEP * (high - low);
        let at = |sign: f64| [0, 1].map(|k| middle[k] + sign * step * axis[k]);
        let [ahead, behind] = [1.0, -1.0].map(|sign| pencil.letters_at(at(sign)));
        moving.push((step, centre.slope(&ahead, &behind)?));
    }
    let at = |corner: &Place| {
        let of = |word: usize| {
            let start = centre.ellipsoids[word].clone();
            moving.iter().enumerate().fold(start, |sum, (k, (step, slope))| {
                sum + &slope[word] * ((corner[k] - middle[k]) / step)
            })
        };
        (0..centre.ellipsoids.len()).map(of).collect()
    };
    Some(corners.iter().map(at).collect())
}

fn rounded(at_corners: &[Vec<DMatrix<f64>>], memory: u32, bits: i32) -> Ellipsoids {
    let largest = at_corners.iter().flatten().map(DMatrix::amax).fold(0.0, f64::max);
    let scale = 2f64.powi(bits) / largest;
    let triangle = |matrix: &DMatrix<f64>| {
        let n = matrix.nrows();
        let places = (0..n).flat_map(|i| (i..n).map(move |j| (i, j)));
        places.map(|place| (matrix[place] * scale).round() as i64).collect()
    };
    let corner = |words: &Vec<DMatrix<f64>>| words.iter().map(triangle).collect();
    Ellipsoids { memory, corners: at_corners.iter().map(corner).collect() }
}
