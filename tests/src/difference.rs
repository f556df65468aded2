//! Difference schemes, their norms, and degrees, by refining data.
//!
//! Here a mask is the list `a_0, a_1, …` of coefficients, index origin 0 (zeros at either end are
//! allowed and shift the origin), and refinement of arity `m` is `f'_i = Σ_j a_(i-mj) f_j`, summed
//! over all integers `j`.
//!
//! # Polynomial data
//! For `f_j = j^k` the sum over `j` runs over the `a_l` with `l ≡ i (mod m)`, and `j = (i - l)/m`: on
//! each residue class of `i` the refined data are a polynomial in `i` of degree at most `k`. Such a
//! sequence is determined by few of its values, so that finitely many of them prove an identity:
//! - Differences of order `k + 1` of the refined data are again of this kind; they vanish for all `i`
//!   if they do so for `m (k + 1)` consecutive ones. Then the refined data are one polynomial.
//! - Two sequences of this kind agree for all `i` if they agree for `m (k + 1)` consecutive ones.
//!
//! # Parametrisation
//! Let the mask preserve polynomials of degree one: `f_j = 1` becomes `1`, so that every residue class
//! sums to 1, and `f_j = j` becomes `(i - s)/m` with `s = Σ_(l ≡ i) l a_l`, the same number for every
//! class; adding the classes, `m s = a'(1)`, so that `s` is `τ = a'(1)/m`. Hence data read off at the
//! points `j` are reproduced where the new points are put at `(i - τ)/m`, and nowhere else. This is
//! used below, for every arity.
//!
//! In the binary case it is the parametrisation `t_i^(k) = (i + τ)/2^k` of Conti and Hormann moved by
//! `τ`: data at `j + τ` go to `(i - τ)/2 + τ = (i + τ)/2`, and moving all points changes no space of
//! polynomials. For arity `m` the fixed shift would have to be `a'(1)/(m (m-1))`: a point `j + σ` goes
//! to `(i - τ)/m + σ`, which is `(i + σ)/m` iff `σ (m - 1) = τ`.

use refinable_algebra::{Rational, integer, rational};

/// The coefficients of `m^order · a(z) / (1 + z + … + z^(m-1))^(order + 1)`, the symbol `c_order` of the
/// scheme for the divided differences of that order; `None` if the division leaves a remainder.
///
/// For a mask that starts at `z^0` so does the result.
pub fn difference_symbol(mask: &[Rational], arity: usize, order: usize) -> Option<Vec<Rational>> {
    let mut symbol = mask.to_vec();
    for _ in 0..=order {
        symbol = divide_by_geometric(&symbol, arity)?;
    }
    let factor = power(arity, order);
    Some(symbol.into_iter().map(|c| c * &factor).collect())
}

/// Division of power series from the low end: `q_i = p_i - q_(i-1) - … - q_(i-m+1)`. The quotient is a
/// polynomial iff the series ends `m - 1` places before `p` does.
fn divide_by_geometric(p: &[Rational], arity: usize) -> Option<Vec<Rational>> {
    let mut quotient: Vec<Rational> = Vec::new();
    for (i, c) in p.iter().enumerate() {
        let recent = &quotient[i.saturating_sub(arity - 1)..];
        let sum = recent.iter().fold(rational(0, 1), |sum, q| sum + q);
        quotient.push(c - sum);
    }
    let kept = p.len().saturating_sub(arity - 1);
    let tail = quotient.split_off(kept);
    tail.iter().all(|q| *q == rational(0, 1)).then_some(quotient)
}

/// `f'_i = Σ_j a_(i-mj) f_j` for data `f_0, f_1, …` that are zero elsewhere; the result begins at `f'_0`
/// and ends with the last index to which the mask reaches.
pub fn refine(mask: &[Rational], arity: usize, data: &[Rational]) -> Vec<Rational> {
    let mut refined = Vec::new();
    for (j, f) in data.iter().enumerate() {
        for (l, a) in mask.iter().enumerate() {
            let i = arity * j + l;
            if refined.len() <= i {
                refined.resize(i + 1, rational(0, 1));
            }
            refined[i] += a * f;
        }
    }
    refined
}

/// The sequence with a one at index `position` and zeros elsewhere, refined `levels` times.
pub fn refine_unit_sequence(
    mask: &[Rational],
    arity: usize,
    position: usize,
    levels: usize,
) -> Vec<Rational> {
    let mut data = vec![rational(0, 1); position];
    data.push(rational(1, 1));
    for _ in 0..levels {
        data = refine(mask, arity, &data);
    }
    data
}

/// `‖c^L‖ = max_j Σ_i |c^L_(j - m^L i)|` over the residues `j` modulo `m^L`, with `c^L` the unit sequence
/// refined `L = levels` times: the norm of that many steps as an operator on bounded sequences.
pub fn iterated_norm(mask: &[Rational], arity: usize, levels: usize) -> Rational {
    let values = refine_unit_sequence(mask, arity, 0, levels);
    let modulus = arity.pow(u32::try_from(levels).expect("few levels"));
    let sums = (0..modulus).map(|residue| {
        let class = values.iter().skip(residue).step_by(modulus);
        class.fold(rational(0, 1), |sum, c| sum + size(c))
    });
    sums.max().expect("there is a residue")
}

/// The largest `d` such that refinement maps polynomial data of degree `≤ d` to polynomial data;
/// `None` if it does not even preserve the constant 1.
pub fn generation_degree(mask: &[Rational], arity: usize) -> Option<usize> {
    if !preserves_one(mask, arity) {
        return None;
    }
    largest_degree(mask, |degree| {
        let length = arity * (degree + 1);
        let mut values = refined_power(mask, arity, degree, length + degree + 1);
        for _ in 0..=degree {
            values = values.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
        }
        assert_eq!(values.len(), length);
        values.iter().all(|v| *v == rational(0, 1))
    })
}

/// The largest `d` such that polynomial data of degree `≤ d` at the points `j` become data of the same
/// polynomial at the points `(i - τ)/m`, `τ = a'(1)/m`; `None` if that fails for the constant 1.
pub fn reproduction_degree(mask: &[Rational], arity: usize) -> Option<usize> {
    let m = integer(arity as i64);
    let moment = mask.iter().enumerate();
    let tau = moment.fold(rational(0, 1), |sum, (l, a)| sum + a * integer(l as i64)) / &m;
    largest_degree(mask, |degree| {
        let values = refined_power(mask, arity, degree, arity * (degree + 1));
        values.iter().enumerate().all(|(i, value)| {
            let point = (rational(i as i64, 1) - &tau) / &m;
            *value == product(&point, degree)
        })
    })
}

/// The last degree up to which `holds` is true; `None` if it fails for degree 0.
fn largest_degree(mask: &[Rational], holds: impl Fn(usize) -> bool) -> Option<usize> {
    let failure = (0..=mask.len()).find(|&degree| !holds(degree));
    failure.expect("a symbol of degree n has no zero of order n + 1").checked_sub(1)
}

fn preserves_one(mask: &[Rational], arity: usize) -> bool {
    let refined = refined_power(mask, arity, 0, arity);
    refined.iter().all(|v| *v == rational(1, 1))
}

/// The values `f'_0, …, f'_(length-1)` of the refined data `f_j = j^degree`, `j` over all integers: for
/// each `i` the sum over the `l ≡ i (mod m)` of `a_l ((i - l)/m)^degree`.
fn refined_power(mask: &[Rational], arity: usize, degree: usize, length: usize) -> Vec<Rational> {
    let m = arity as i64;
    (0..length as i64)
        .map(|i| {
            let terms = (0i64..).zip(mask).filter(|(l, _)| (i - l) % m == 0);
            terms.fold(rational(0, 1), |sum, (l, a)| {
                sum + a * product(&rational((i - l) / m, 1), degree)
            })
        })
        .collect()
}

/// `x^exponent`
fn product(x: &Rational, exponent: usize) -> Rational {
    (0..exponent).fold(rational(1, 1), |power, _| power * x)
}

/// `base^exponent`
fn power(base: usize, exponent: usize) -> Rational {
    product(&rational(base as i64, 1), exponent)
}

fn size(x: &Rational) -> Rational {
    if *x < rational(0, 1) { -x } else { x.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn over(denominator: i64, numerators: &[i64]) -> Vec<Rational> {
        let numerators = numerators.iter();
        numerators.map(|&n| rational(n, denominator)).collect()
    }

    /// `(1 + z + … + z^(m-1))^(degree + 1) / m^degree`
    fn b_spline(arity: usize, degree: usize) -> Vec<Rational> {
        let sigma = vec![rational(1, 1); arity];
        let mut mask = sigma.clone();
        for _ in 0..degree {
            mask = convolution(&mask, &sigma);
        }
        let factor = power(arity, degree);
        mask.into_iter().map(|c| c / &factor).collect()
    }

    fn convolution(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        let mut c = vec![rational(0, 1); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                c[i + j] += x * y;
            }
        }
        c
    }

    fn four_point() -> Vec<Rational> {
        over(16, &[-1, 0, 9, 16, 9, 0, -1])
    }

    fn degrees(mask: &[Rational], arity: usize) -> (Option<usize>, Option<usize>) {
        (generation_degree(mask, arity), reproduction_degree(mask, arity))
    }

    #[test]
    fn b_splines_generate_their_degree_and_reproduce_lines() {
        for arity in 2..=4 {
            for degree in 0..=5 {
                let expected = (Some(degree), Some(degree.min(1)));
                assert_eq!(degrees(&b_spline(arity, degree), arity), expected);
            }
        }
    }

    #[test]
    fn chaikin_generates_parabolas_and_reproduces_lines() {
        assert_eq!(degrees(&over(4, &[1, 3, 3, 1]), 2), (Some(2), Some(1)));
    }

    #[test]
    fn the_four_point_scheme_reproduces_cubics() {
        assert_eq!(degrees(&four_point(), 2), (Some(3), Some(3)));
    }

    #[test]
    fn ternary_interpolation_at_four_points_reproduces_cubics() {
        // Cubic Lagrange interpolation at -1, 0, 1, 2, evaluated at 1/3 and 2/3.
        let mask = over(81, &[-4, -5, 0, 30, 60, 81, 60, 30, 0, -5, -4]);
        assert_eq!(degrees(&mask, 3), (Some(3), Some(3)));
    }

    #[test]
    fn degrees_do_not_depend_on_the_origin() {
        for zeros in 0..4 {
            let mut mask = vec![rational(0, 1); zeros];
            mask.extend(four_point());
            mask.push(rational(0, 1));
            assert_eq!(degrees(&mask, 2), (Some(3), Some(3)));
        }
    }

    #[test]
    fn masks_that_move_a_constant_have_no_degree() {
        assert_eq!(degrees(&over(1, &[1, 2, 1]), 2), (None, None));
        assert_eq!(degrees(&[], 2), (None, None));
        assert_eq!(degrees(&over(1, &[2, 1]), 2), (None, None));
    }

    #[test]
    fn a_skewed_mask_of_generation_one_reproduces_lines() {
        // (1+z)² (1+2z)/6: its two classes agree on lines, whatever the third factor.
        assert_eq!(degrees(&over(6, &[1, 4, 5, 2]), 2), (Some(1), Some(1)));
    }

    /// The binary parametrisation as it is published: data at `i + τ` go to `(i + τ)/2`.
    #[test]
    fn the_published_binary_parametrisation_is_the_same_condition() {
        for mask in [b_spline(2, 1), b_spline(2, 2), b_spline(2, 3), four_point()] {
            let moment = mask.iter().enumerate();
            let first = moment.fold(rational(0, 1), |sum, (l, a)| sum + a * integer(l as i64));
            let tau = first / integer(2);
            let reproduced = reproduction_degree(&mask, 2).unwrap();
            for degree in 0..=reproduced + 1 {
                let exact = (0..2 * (degree as i64 + 1)).all(|i| {
                    let classes = (0i64..).zip(&mask).filter(|(l, _)| (i - l) % 2 == 0);
                    let refined = classes.fold(rational(0, 1), |sum, (l, a)| {
                        sum + a * product(&(rational((i - l) / 2, 1) + &tau), degree)
                    });
                    refined == product(&((rational(i, 1) + &tau) / integer(2)), degree)
                });
                assert_eq!(exact, degree <= reproduced);
            }
        }
    }

    #[test]
    fn difference_symbols_of_b_splines_are_b_splines() {
        // c_n of degree d is the symbol of degree d - 1 - n, times m^n / m^(n+1) = 1/m.
        for arity in 2..=4 {
            for degree in 1..=4 {
                for order in 0..degree {
                    let expected = b_spline(arity, degree - 1 - order);
                    let expected = expected.into_iter().map(|c| c / integer(arity as i64));
                    let symbol = difference_symbol(&b_spline(arity, degree), arity, order);
                    assert_eq!(symbol, Some(expected.collect()));
                }
                let constant = difference_symbol(&b_spline(arity, degree), arity, degree);
                assert_eq!(constant, Some(vec![rational(1, 1)]));
                assert_eq!(difference_symbol(&b_spline(arity, degree), arity, degree + 1), None);
            }
        }
    }

    #[test]
    fn the_difference_scheme_refines_the_differences() {
        // Δ(S_a f) = S_(c_0) (Δ f) with (Δ f)_i = f_i - f_(i-1), and the same again for the next order.
        let mask = four_point();
        let data: Vec<Rational> = [3, -1, 4, 1, -5, 9].map(|n| rational(n, 1)).to_vec();
        let differences = |f: &[Rational]| convolution(f, &over(1, &[1, -1]));
        let first = difference_symbol(&mask, 2, 0).unwrap();
        let left = differences(&refine(&mask, 2, &data));
        assert_eq!(left, refine(&first, 2, &differences(&data)));
        // Divided differences of the refined data: the steps are halved, hence the factor 2.
        let second = difference_symbol(&mask, 2, 1).unwrap();
        let left: Vec<Rational> = differences(&left).iter().map(|d| d * integer(2)).collect();
        assert_eq!(left, refine(&second, 2, &differences(&differences(&data))));
    }

    #[test]
    fn a_unit_sequence_elsewhere_gives_the_same_values_further_on() {
        let mask = four_point();
        for (position, levels) in [(1, 1), (2, 2), (3, 3)] {
            let moved = refine_unit_sequence(&mask, 2, position, levels);
            let (zeros, values) = moved.split_at(position << levels);
            assert!(zeros.iter().all(|v| *v == rational(0, 1)));
            assert_eq!(values, refine_unit_sequence(&mask, 2, 0, levels));
        }
    }

    #[test]
    fn norms_of_the_four_point_scheme() {
        // c_0 = (-1 + z + 8 z² + 8 z³ + z⁴ - z⁵)/16, rows of 1 + 8 + 1.
        let c0 = difference_symbol(&four_point(), 2, 0).unwrap();
        assert_eq!(iterated_norm(&c0, 2, 1), rational(5, 8));
        // c_1 = (-1 + 2z + 6z² + 2z³ - z⁴)/8: 1 at level one, 3/4 at level two.
        let c1 = difference_symbol(&four_point(), 2, 1).unwrap();
        assert_eq!(c1, over(8, &[-1, 2, 6, 2, -1]));
        assert_eq!(iterated_norm(&c1, 2, 1), rational(1, 1));
        assert_eq!(iterated_norm(&c1, 2, 2), rational(3, 4));
    }

    #[test]
    fn the_norm_of_no_steps_is_one_and_that_of_a_b_spline_is_small() {
        let c = difference_symbol(&b_spline(3, 2), 3, 1).unwrap();
        assert_eq!(iterated_norm(&c, 3, 0), rational(1, 1));
        assert_eq!(iterated_norm(&c, 3, 2), rational(1, 9));
    }
}
