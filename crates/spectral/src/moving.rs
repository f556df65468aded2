//! Quadratic forms that move with the point of a polygon, in the integers of a certificate.

use nalgebra::{DMatrix, DVector};
use refinable_certificate::{Ellipsoids, Expansion};

use crate::ellipsoid::Centre;
use crate::geometry::{Place, extent};
use crate::leading::{fastest, product};
use crate::plane::PlanePencil;
use crate::quadratic::{add_square, add_vector, coordinates, pairs, symmetric};
use crate::word::Word;

/// Bits of the largest entry, tried in turn.
const BITS: [i32; 2] = [20, 34];
/// How much faster than the fastest word ellipsoids may grow that measure expansion.
const FASTER: f64 = 1.2;
/// What part of the decay of the fastest word is enough for ellipsoids.
const WELL: f64 = 0.7;
/// How long the words are that may show expansion.
const LONGEST_WORD: usize = 5;
/// The step for derivatives, against the extents of the polygon.
const STEP: f64 = 1e-4;

/// Why there are no ellipsoids.
pub(crate) enum Failure {
    /// None are known even for the middle of the polygon.
    Nowhere,
    /// Those at the middle do not reach the corners.
    TooLarge,
}

/// Ellipsoids that are accepted, if they are found: those at the middle of the polygon, and at its corners
/// what their derivatives say. Words are lengthened as long as the ellipsoids shrink much less than the
/// fastest of the given words does.
pub(crate) fn moving_ellipsoids(
    pencil: &PlanePencil,
    corners: &[Place],
    words: &[Word],
    accept: impl Fn(&Ellipsoids) -> bool,
) -> Result<Ellipsoids, Failure> {
    let middle = middle(corners);
    let letters = pencil.letters_at(middle);
    let accepted = |centre: &Centre| {
        let at_corners = tangent(pencil, corners, middle, centre)?;
        BITS.iter().find_map(|&bits| {
            let corners = rounded(&at_corners, bits);
            Some(Ellipsoids { memory: centre.memory(), corners }).filter(&accept)
        })
    };
    let growth = fastest(&pencil.at(middle), words).1;
    let mut centre = Centre::find(&letters).ok_or(Failure::Nowhere)?;
    loop {
        if let Some(found) = accepted(&centre) {
            return Ok(found);
        }
        let near = 1.0 - centre.radius(&letters) > WELL * (1.0 - growth * growth);
        centre = centre.deeper(&letters).filter(|_| !near).ok_or(Failure::TooLarge)?;
    }
}

/// For each corner the ellipsoids.
fn tangent(
    pencil: &PlanePencil,
    corners: &[Place],
    middle: Place,
    centre: &Centre,
) -> Option<Vec<Vec<DMatrix<f64>>>> {
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

/// Forms for the fastest word in the middle of the polygon that are accepted, if they are found: at each
/// corner those with `P' - B P B^T = W'` for each letter, where the ellipsoids `W` grow in the middle
/// hardly faster than the word does.
pub(crate) fn moving_expansion(
    pencil: &PlanePencil,
    corners: &[Place],
    accept: impl Fn(&Expansion) -> bool,
) -> Option<Expansion> {
    let middle = pencil.letters_at(middle(corners));
    let words = Word::necklaces(middle.len(), LONGEST_WORD, false);
    let (word, growth) = fastest(&middle, &words);
    if growth <= 1.0 {
        return None;
    }
    let size = middle[0].nrows();
    let units = vec![DMatrix::identity(size, size); word.letters().len()];
    let slower: Vec<DMatrix<f64>> = middle.iter().map(|b| b / (FASTER * growth)).collect();
    let rests = stein(&slower, word, &units)?;
    let falling = stein(&middle, word, &rests)?[0].clone().symmetric_eigen();
    let (least, _) = falling.eigenvalues.argmin();
    let vector = falling.eigenvectors.column(least) * 2f64.powi(BITS[0]);
    let at = |corner: &Place| stein(&pencil.letters_at(*corner), word, &rests);
    let at_corners: Vec<Vec<DMatrix<f64>>> = corners.iter().map(at).collect::<Option<_>>()?;
    BITS.iter().find_map(|&bits| {
        let vector = vector.iter().map(|x| x.round() as i64).collect();
        let corners = rounded(&at_corners, bits);
        Some(Expansion { word: word.to_string(), vector, corners }).filter(&accept)
    })
}

/// The solutions of Stein's equations `P' = B P B^T + W'` around a word.
fn stein(
    letters: &[DMatrix<f64>],
    word: &Word,
    rests: &[DMatrix<f64>],
) -> Option<Vec<DMatrix<f64>>> {
    let size = letters[0].nrows();
    let after = |form: &DMatrix<f64>, place: usize| {
        let b = &letters[usize::from(word.letters()[place])];
        b * form * b.transpose() + &rests[(place + 1) % rests.len()]
    };
    let rest = (0..rests.len()).fold(DMatrix::zeros(size, size), |p, place| after(&p, place));
    let mut right = DVector::zeros(coordinates(size));
    add_vector(&mut right, 0, 1.0, &rest);
    let mut matrix = DMatrix::identity(right.len(), right.len());
    add_square(&mut matrix, [0, 0], -1.0, &product(letters, word));
    let first = symmetric(matrix.lu().solve(&right)?.as_slice(), size);
    let forms = (1..rests.len()).scan(first.clone(), |form, place| {
        *form = after(form, place - 1);
        Some(form.clone())
    });
    Some(std::iter::once(first).chain(forms).collect())
}

fn middle(corners: &[Place]) -> Place {
    [0, 1].map(|k| corners.iter().map(|c| c[k]).sum::<f64>() / corners.len() as f64)
}

/// Integers with the ratios of the entries, the upper triangles row by row.
fn rounded(at_corners: &[Vec<DMatrix<f64>>], bits: i32) -> Vec<Vec<Vec<i64>>> {
    let largest = at_corners.iter().flatten().map(DMatrix::amax).fold(0.0, f64::max);
    let scale = 2f64.powi(bits) / largest;
    let triangle = |matrix: &DMatrix<f64>| {
        pairs(matrix.nrows()).map(|place| (matrix[place] * scale).round() as i64).collect()
    };
    at_corners.iter().map(|forms| forms.iter().map(triangle).collect()).collect()
}
