//! What continues an open polygon beyond its ends.

use std::collections::BTreeMap;
use std::ops::Range;

use refinable_algebra::{Rational, Ring, rational};

use crate::coordinate::Coordinate;

/// How an open polygon `f_0, …, f_{n-1}` is treated at its ends.
///
/// Ghost points are added to the control polygon once; from there on the pure scheme acts. So a limit
/// is as smooth near the ends as elsewhere.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Ends {
    /// No ghost points: every new point that the old ones determine, and no other. The curve gets
    /// shorter.
    #[default]
    Trim,
    /// Reflection at the end point: `f_{-j} = 2 f_0 - f_j`. A symmetric primal scheme keeps the end
    /// points, and the curve is not bent there.
    Reflect,
    /// The polynomial of this degree through the first points, or of a lower one if there are too few:
    /// what a scheme reproduces up to that degree is reproduced up to the ends.
    Extrapolate {
        /// The degree.
        degree: usize,
    },
}

impl Ends {
    /// The points of `range` of the continued polygon, each of which has `width` coordinates.
    pub(crate) fn extend<T: Coordinate>(
        self,
        values: &[T],
        width: usize,
        closed: bool,
        range: &Range<i64>,
    ) -> Vec<T> {
        let count = values.len() / width;
        let mut extended = Vec::with_capacity((range.end - range.start) as usize * width);
        for index in range.clone() {
            let terms = self.point(index, count as i64, closed);
            if let [(only, _)] = terms[..] {
                extended.extend_from_slice(&values[only * width..][..width]);
                continue;
            }
            let weights: Vec<T> = terms.iter().map(|(_, w)| T::from_rational(w)).collect();
            extended.extend((0..width).map(|k| {
                let mut sum = T::origin();
                for ((i, _), w) in terms.iter().zip(&weights) {
                    sum.add_product(w, &values[i * width + k]);
                }
                sum
            }));
        }
        extended
    }

    /// The point `index` as a combination of the `n` given ones, pairs `(index, weight)`; a single pair
    /// has the weight 1.
    fn point(self, index: i64, n: i64, closed: bool) -> Vec<(usize, Rational)> {
        let given = |i: i64| vec![(i as usize, Rational::one())];
        if closed {
            return given(index.rem_euclid(n));
        }
        if (0..n).contains(&index) || n == 1 {
            return given(index.clamp(0, n - 1));
        }
        // Counted from the end beyond which the point lies.
        let (beyond, end) = if index < 0 { (-index, 0) } else { (index - (n - 1), n - 1) };
        let from_end = |j: i64| if end == 0 { j } else { end - j };
        match self {
            Ends::Trim => unreachable!("a trimmed polygon is asked for none of these"),
            Ends::Reflect => reflected(index, n),
            Ends::Extrapolate { degree } => {
                let degree = degree.min(n as usize - 1) as i64;
                let weight = |j| lagrange(j, degree, -beyond);
                (0..=degree).map(|j| (from_end(j) as usize, weight(j))).collect()
            }
        }
    }
}

/// Reflections at both ends move on: `f_{i+2(n-1)} = f_i + 2 (f_{n-1} - f_0)`.
fn reflected(index: i64, n: i64) -> Vec<(usize, Rational)> {
    let (turns, rest) = (index.div_euclid(2 * (n - 1)), index.rem_euclid(2 * (n - 1)));
    let mut weights = BTreeMap::from([(0, -2 * turns), (n - 1, 2 * turns)]);
    if rest < n {
        *weights.entry(rest).or_default() += 1;
    } else {
        *weights.entry(2 * (n - 1) - rest).or_default() -= 1;
        *weights.entry(n - 1).or_default() += 2;
    }
    let used = weights.into_iter().filter(|(_, w)| *w != 0);
    used.map(|(i, w)| (i as usize, Rational::from_i64(w))).collect()
}

/// At `x`, the polynomial that is 1 at `j` and 0 at the other nodes of `0, …, degree`.
fn lagrange(j: i64, degree: i64, x: i64) -> Rational {
    let factors = (0..=degree).filter(|k| *k != j).map(|k| rational(x - k, j - k));
    factors.fold(Rational::one(), |product, factor| product * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghosts_continue_lines_and_parabolas() {
        let values: Vec<Rational> = [0, 1, 4, 9].map(|x| rational(x, 1)).to_vec();
        let extended = |ends: Ends, closed| ends.extend(&values, 1, closed, &(-2..6));
        let expected = |x: [i64; 8]| x.map(|x| rational(x, 1)).to_vec();
        let degree = |degree| Ends::Extrapolate { degree };
        assert_eq!(extended(degree(2), false), expected([4, 1, 0, 1, 4, 9, 16, 25]));
        assert_eq!(extended(degree(7), false), expected([4, 1, 0, 1, 4, 9, 16, 25]));
        assert_eq!(extended(degree(1), false), expected([-2, -1, 0, 1, 4, 9, 14, 19]));
        assert_eq!(extended(Ends::Reflect, false), expected([-4, -1, 0, 1, 4, 9, 14, 17]));
        assert_eq!(extended(Ends::Trim, true), expected([4, 9, 0, 1, 4, 9, 0, 1]));
        // Two points, reflected over and over, make a line; a single point stays.
        let two = [rational(0, 1), rational(1, 1)];
        let line = Ends::Reflect.extend(&two, 1, false, &(-3..5));
        assert_eq!(line, expected([-3, -2, -1, 0, 1, 2, 3, 4]));
        assert_eq!(Ends::Reflect.extend(&two[1..], 1, false, &(-2..0)), vec![rational(1, 1); 2]);
    }
}
