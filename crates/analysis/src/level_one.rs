//! Level one over two parameters: a convex polygon.

use refinable_algebra::{Laurent, Rational, Ring};
use refinable_certificate::{Line, Polygon};

use crate::plane::Plane;

/// An affine function `c + a x + b y` of the plane.
type Affine = [Rational; 3];

/// The most different functions in a row: there are `2^n` half planes to cut with.
const MOST_TERMS: usize = 10;
/// Half the side, as a power of two, of the square that a polygon must not leave.
const FAR: u32 = 40;

impl Plane {
    /// The closed polygon of the plane of `(x, y)` on which `‖c_n‖ ≤ 1`; its interior is where the norm at
    /// level one proves C^n. `None` if the masks are not affine, `σ^(n+1)` does not divide, the rows are
    /// too long, the set is not bounded or has no interior.
    ///
    /// # Cost
    /// `2^n` half planes for a row with `n` different affine functions.
    ///
    /// # Source
    /// `Σ|l_i| < 1` is `Σ ±l_i < 1` for all signs: an intersection of half planes.
    pub fn level_one(&self, continuity: usize) -> Option<Polygon> {
        let far = Rational::from_i64(2).power(FAR);
        let near = -&far;
        let corners = [[&near, &near], [&far, &near], [&far, &far], [&near, &far]];
        let mut polygon = Polygon::new(&corners.map(|corner| corner.map(Clone::clone)))?;
        for row in self.rows(continuity)? {
            for half_plane in half_planes(&row)? {
                let [c, a, b] = half_plane;
                let rest = Rational::one() - c;
                match Line::new(&a, &b, &rest) {
                    Some(line) => polygon = polygon.cut(&line)[0].clone()?,
                    None if rest < Rational::zero() => return None,
                    None => {}
                }
            }
        }
        let inside = |p: &[Rational; 2]| p.iter().all(|t| near < *t && *t < far);
        polygon.points().iter().all(inside).then_some(polygon)
    }

    /// The rows of `‖c_n‖` as affine functions; equal ones are taken together.
    fn rows(&self, continuity: usize) -> Option<Vec<Vec<Affine>>> {
        if !self.is_affine() || continuity >= self.order() {
            return None;
        }
        let m = self.arity();
        let zero = [Rational::zero(), Rational::zero()];
        let unit = |i: usize| [0, 1].map(|j| Rational::from_i64(i64::from(i == j)));
        let [constant, by_x] = self.along(&zero, &unit(0))?;
        let [_, by_y] = self.along(&zero, &unit(1))?;
        let scale = Rational::from_i64(m as i64).power(continuity as u32);
        let quotient =
            |part: &Laurent<Rational>| part.divide_by_geometric(m, continuity + 1).0.scaled(&scale);
        let parts = [constant, by_x, by_y].map(|part| quotient(&part));
        let (lowest, length) = self.extent();
        let rows = (0..m as i64).map(|j| {
            let exponents =
                (lowest..lowest + length as i64).filter(|e| e.rem_euclid(m as i64) == j);
            let mut row: Vec<Affine> = Vec::new();
            for e in exponents {
                add(&mut row, parts.each_ref().map(|part| part.coefficient(e)));
            }
            row
        });
        Some(rows.collect())
    }
}

/// Adds `|l|`: to a multiple of it that is there already, if there is one.
fn add(row: &mut Vec<Affine>, l: Affine) {
    if l.iter().all(Ring::is_zero) {
        return;
    }
    let ratio = |known: &Affine| {
        let place = known.iter().position(|c| !c.is_zero())?;
        let ratio = &l[place] / &known[place];
        let multiple = known.iter().zip(&l).all(|(k, l)| k * &ratio == *l);
        multiple.then(|| if ratio < Rational::zero() { -ratio } else { ratio })
    };
    match row.iter_mut().find_map(|known| Some((ratio(known)?, known))) {
        Some((ratio, known)) => {
            let factor = ratio + Rational::one();
            known.iter_mut().for_each(|c| *c *= &factor);
        }
        None => row.push(l),
    }
}

/// `Σ ±l_i` for all signs.
fn half_planes(row: &[Affine]) -> Option<Vec<Affine>> {
    if row.len() > MOST_TERMS {
        return None;
    }
    let signed = |signs: usize| {
        let zero = [Rational::zero(), Rational::zero(), Rational::zero()];
        row.iter().enumerate().fold(zero, |sum, (k, l)| {
            let negative = signs >> k & 1 == 1;
            [0, 1, 2].map(|i| if negative { &sum[i] - &l[i] } else { &sum[i] + &l[i] })
        })
    };
    Some((0..1_usize << row.len()).map(signed).collect())
}
