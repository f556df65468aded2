//! Tensions for interproximate schemes: which member approximates best, and which interpolates best among it.
//!
//! Far from interpolated vertices an interproximate scheme is its approximating member, and so is its
//! limit. At an interpolated vertex `v` the points that decide the limit over the edges beside it, `f_{-w}, …,
//! f_w` on any level, where `[-w, w]` is the support of the masks, depend on those of the level before by one and the same matrix `S`: the vertex rule of the interpolating member at
//! `v`, its edge rule on the edge after `v`, and the approximating member's rules elsewhere. If both members
//! reproduce polynomials of degree `d`, then `Δ^(d+1) S = T Δ^(d+1)` for a smaller matrix `T`, and on the rings
//! `2^-k ≤ |x - v| ≤ 2^(1-k)` the limit differs from a polynomial by what `T^k` makes of the differences: it
//! is of Hölder exponent at least `min(r, -log2 ρ(T))` at `v`, `r` that of the approximating member; more where an
//! eigenvector of `T` belongs to a smooth function, as for splines.

use refinable_algebra::{
    Matrix, Ordered, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, binomial,
    rational,
};
use refinable_reals::logarithm;
use refinable_scheme::{Diagnostic, Normalised, Rule};
use refinable_spectral::{PlanePencil, Window, slowest};

use crate::degrees::degrees;
use crate::landscape::landscape;
use crate::map::default_window;
use crate::regularity::Regularity;

/// Where the free parameter of interpolating members is sought.
const SPAN: [i64; 2] = [-1, 1];
/// How near to the least growth, as powers of two.
const TOLERANCES: [u32; 3] = [9, 6, 4];
/// The power of `T` whose norm is taken.
const POWER: u32 = 64;
/// The widest masks for which the search ends soon.
const WIDEST: i64 = 24;
/// Bits of the logarithm.
const BITS: u32 = 40;

/// A choice of tensions for an interproximate scheme, with what is proved of it.
#[derive(Clone, Debug)]
pub struct TensionChoice {
    /// The parameters of the approximating member, in their order: the smoothest one that was found.
    pub approximating: Vec<Rational>,
    /// Its Hölder exponent, proved.
    pub regularity: Regularity,
    /// The parameters of the interpolating member: its vertex rule keeps the old points.
    pub interpolating: Vec<Rational>,
    /// A lower bound for `-log2 ρ(T)`, proved: the exponent of the limit at interpolated vertices is at least the
    /// smaller of the two.
    pub at_vertices: Rational,
}

/// Tensions for a binary family of two parameters.
///
/// The approximating member is the smoothest summit of the [`landscape`]. The interpolating one has a vertex rule
/// that keeps the old points, and of those it has the largest `-log2 ρ(T)` found. What is found by floats is
/// proved: the first by a certificate, the second by the norm of a power of `T` in rational numbers.
///
/// # Errors
/// Code `tensions` if the family is not binary and primal, if there is no such member, or if more than one
/// parameter would be left free; those of [`landscape`].
///
/// # Cost
/// That of [`landscape`], some seconds to a minute.
///
/// # Source
/// Ours; for spectra of local matrices at a special vertex see Warren and Weimer, *Subdivision methods for
/// geometric design*, 2002.
pub fn interproximate_tensions(name: &str, mask: &Normalised) -> Result<TensionChoice, Diagnostic> {
    let parameters: Vec<Parameter> = mask.parameters().into_iter().collect();
    let (fixed, value) = interpolating_value(mask).ok_or_else(|| not_interpolating(mask))?;
    let free: Vec<&Parameter> = parameters.iter().filter(|p| **p != fixed).collect();
    let [free] = free[..] else { return Err(not_interpolating(mask)) };
    if mask.support_width() > Rational::from_i64(WIDEST) {
        let hint = "give the tensions yourself";
        return Err(
            Diagnostic::new("tensions", "the masks are too long for a search").with_hint(hint)
        );
    }
    let window = default_window(name, mask, 0)?;
    let landscape = landscape(name, mask, &window, [2, 2])?;
    let Some(summit) = landscape.highest() else {
        let hint = "give the tensions yourself";
        let message = "no smooth member of the family was found";
        return Err(Diagnostic::new("tensions", message).with_hint(hint));
    };
    let smoothest = landscape.plane.in_order(&summit.parameters);
    let approximating = mask.at(&smoothest)?.rule();
    let interpolating = mask.substitute(&fixed, &constant(&value))?;
    let degree = degrees(mask).generic().reproduction.0;
    let (lowest, highest) = mask.support();
    let w = highest.max(-lowest);
    let local = |x: &Rational| -> Result<Matrix<Rational>, Diagnostic> {
        let member = interpolating.substitute(free, &constant(x))?;
        Ok(local_matrix(&approximating, &member.rule(), w, degree))
    };
    let [zero, one] = [local(&Rational::zero())?, local(&Rational::one())?];
    let (rows, _) = zero.shape();
    let slope = Matrix::from_fn(rows, rows, |i, j| one.entry(i, j).minus(zero.entry(i, j)));
    let pencil = PlanePencil::new(&[(0, 0, vec![zero]), (1, 0, vec![slope])]);
    let span: Window = [SPAN.map(|x| rational(x, 1)), [Rational::zero(), Rational::zero()]];
    let mut best: Option<(Rational, Rational)> = None;
    for [x, _] in slowest(&pencil, &span, &TOLERANCES) {
        // Short numbers near the best place; what they are worth is exact.
        let exponent = decay(&local(&x)?);
        if best.as_ref().is_none_or(|(_, known)| exponent > *known) {
            best = Some((x, exponent));
        }
    }
    let (x, at_vertices) = best.ok_or_else(|| not_interpolating(mask))?;
    let interpolating =
        parameters.iter().map(|p| if *p == fixed { &value } else { &x }).cloned().collect();
    Ok(TensionChoice {
        approximating: smoothest.to_vec(),
        regularity: summit.regularity.clone(),
        interpolating,
        at_vertices,
    })
}

fn not_interpolating(mask: &Normalised) -> Diagnostic {
    let message = "tensions are chosen for primal binary families of two parameters, one of which decides whether \
                   points are kept";
    let names: Vec<String> = mask.parameters().iter().map(|p| format!("{p}=…")).collect();
    let names = names.join(",");
    Diagnostic::new("tensions", message)
        .with_hint(format!("give them: --interpolating '{names}' --approximating '{names}'"))
}

/// The parameter that decides whether the vertex rule keeps the old points, and the value at which it does.
pub fn interpolating_value(mask: &Normalised) -> Option<(Parameter, Rational)> {
    let conditions = mask.interpolation_conditions();
    let first = conditions.first().filter(|_| mask.arity() == 2 && mask.is_primal())?;
    let parameter = first.parameters().into_iter().next()?;
    let collected = first.collected(&parameter);
    let [a, b] = collected.coefficients() else { return None };
    let value = -a.as_constant()? / b.as_constant()?;
    let member = mask.substitute(&parameter, &constant(&value)).ok()?;
    member.is_interpolatory().then_some((parameter, value))
}

fn constant(x: &Rational) -> ParameterFraction {
    ParameterFraction::from(ParameterPolynomial::constant(x.clone()))
}

/// `T`, with `Δ^(d+1) S = T Δ^(d+1)` for the points from `-w` to `w` around an interpolated vertex.
fn local_matrix(
    approximating: &Rule,
    interpolating: &Rule,
    w: i64,
    degree: usize,
) -> Matrix<Rational> {
    let stencil = |i: i64| match i {
        0 | 1 => &interpolating.stencils()[i as usize],
        _ => &approximating.stencils()[i.rem_euclid(2) as usize],
    };
    let size = 2 * w as usize + 1;
    let weight = |i: usize, j: usize| {
        let (i, j) = (i as i64 - w, j as i64 - w);
        let s = stencil(i);
        let index = j - i.div_euclid(2) - s.first();
        let weight = usize::try_from(index).ok().and_then(|k| s.weights().get(k));
        weight.and_then(ParameterFraction::as_constant).unwrap_or_else(Rational::zero)
    };
    let refinement = Matrix::from_fn(size, size, weight);
    let order = degree + 1;
    // Differences of order d+1, and points with given ones: zeros first, then repeated sums.
    let difference = Matrix::from_fn(size - order, size, |i, j| {
        let k = j.checked_sub(i).filter(|k| *k <= order);
        let sign = |k: usize| rational(if (order - k).is_multiple_of(2) { 1 } else { -1 }, 1);
        k.map_or_else(Rational::zero, |k| {
            sign(k) * Rational::from(binomial(order as u32, k as u32))
        })
    });
    let sums = Matrix::from_fn(size, size - order, |i, j| {
        let steps = i.checked_sub(j + 1).filter(|steps| *steps + 1 >= order);
        steps.map_or_else(Rational::zero, |n| Rational::from(binomial(n as u32, order as u32 - 1)))
    });
    difference.times(&refinement).times(&sums)
}

/// A lower bound for `-log2 ρ(T)`: `-log2 ‖T^k‖ / k` with the norm of largest row sums.
fn decay(matrix: &Matrix<Rational>) -> Rational {
    let mut power = matrix.clone();
    let mut exponent = 1;
    while exponent < POWER {
        power = power.times(&power);
        exponent *= 2;
    }
    let (rows, columns) = power.shape();
    let sum = |i: usize| (0..columns).map(|j| power.entry(i, j).absolute()).sum::<Rational>();
    let norm = (0..rows).map(sum).max().unwrap_or_else(Rational::zero);
    if norm.is_zero() {
        return rational(i64::from(POWER), 1);
    }
    -logarithm(&norm, 2, BITS).1 / Rational::from_i64(i64::from(POWER))
}

#[cfg(test)]
mod tests {
    use refinable_scheme::Scheme;

    use super::*;

    /// With the same member everywhere `T` is that of the stationary scheme, whose eigenvalues are those of
    /// cubic splines at a knot: 1/4 and 1/8 twice, once for each side.
    #[test]
    fn the_local_matrix_of_a_spline() {
        let rule = Scheme::resolve("bspline3", 2).unwrap().mask().rule();
        let matrix = local_matrix(&rule, &rule, 2, 1);
        let roots = [rational(1, 4), rational(1, 8), rational(1, 8)];
        let expected =
            roots.iter().fold(refinable_algebra::Polynomial::new(vec![Rational::one()]), |p, r| {
                p.times(&refinable_algebra::Polynomial::new(vec![-r, Rational::one()]))
            });
        assert_eq!(matrix.characteristic_polynomial(), expected);
        let found = decay(&matrix);
        assert!(rational(19, 10) < found && found <= rational(2, 1), "{found}");
    }

    /// Of the members that keep old points, that of Deslauriers and Dubuc goes best with the quintic spline.
    #[test]
    fn tensions_of_a3() {
        let family = Scheme::resolve("a3", 2).unwrap();
        let choice = interproximate_tensions("a3", family.mask()).unwrap();
        assert_eq!(choice.approximating, [rational(3, 16), rational(1, 26)]);
        assert_eq!(choice.interpolating, [rational(0, 1), rational(-1, 16)]);
        let exponent = &choice.at_vertices;
        assert!(rational(13, 10) < *exponent && *exponent < rational(14, 10), "{exponent}");
        let scheme = Scheme::resolve("bspline3", 2).unwrap();
        assert_eq!(interproximate_tensions("", scheme.mask()).unwrap_err().code(), "tensions");
    }
}
