//! Exact values of limit curves and of their derivatives.
//!
//! The basic limit function `φ = Σ_i a_i φ(m· - i)` is known at a rational place once its values at all
//! places that differ by whole numbers are: with `Φ(x) = (φ(x + j))_j` and `m x = d + x'`,
//! `Φ(x) = T_d Φ(x')`, `T_d[j][l] = a_{mj + d - l}`; a derivative of order `n` takes a factor `m^n`.
//! The fractional parts of `x, m x, m² x, …` repeat from some point on; where they do, `Φ` is a vector
//! that a product of these matrices keeps, and what it gives for the data `k^n` fixes its length.

use refinable_algebra::{Matrix, Rational, Ring};
use refinable_scheme::{Diagnostic, Normalised};

use crate::coordinate::Coordinate;
use crate::weights::{Stencil, Weights, constant_coefficients};

/// The widest support of `φ`: matrices have as many rows.
const WIDEST: usize = 128;
/// The most steps until the fractional parts repeat.
const LONGEST_ORBIT: usize = 64;

/// The basic limit function `φ`, the limit of the scheme for `f_0 = 1` and all other points 0, so that
/// the limit for any points is `F(x) = Σ_k f_k φ(x - k)`.
///
/// Whether there is one, and how often it can be differentiated, is not asked here.
///
/// ```
/// use refinable_algebra::rational;
/// use refinable_refine::BasicLimit;
/// use refinable_scheme::Scheme;
/// let cubic = BasicLimit::new(Scheme::resolve("bspline3", 2).unwrap().mask()).unwrap();
/// let stencil = cubic.stencil(&rational(0, 1), 0).unwrap();
/// assert_eq!((stencil.first(), stencil.weights()), (-1, &[(1, 6), (2, 3), (1, 6)].map(|(p, q)| rational(p, q))[..]));
/// ```
#[derive(Clone, Debug)]
pub struct BasicLimit {
    arity: i64,
    lowest: i64,
    coefficients: Vec<Rational>,
    shift: Rational,
}

impl BasicLimit {
    /// The basic limit function of a mask.
    ///
    /// # Errors
    /// Code `parameters` if the mask has some.
    pub fn new(mask: &Normalised) -> Result<Self, Diagnostic> {
        let coefficients: Vec<Rational> =
            constant_coefficients(mask)?.into_iter().map(|(_, a)| a).collect();
        let shift = Weights::<Rational>::new(mask)?.shift().clone();
        let (lowest, _) = mask.support();
        Ok(BasicLimit { arity: mask.arity() as i64, lowest, coefficients, shift })
    }

    /// The interval outside of which `φ` vanishes: `[lo/(m-1), hi/(m-1)]` for the support `[lo, hi]` of
    /// the mask.
    pub fn support(&self) -> [Rational; 2] {
        let highest = self.lowest + self.coefficients.len() as i64 - 1;
        [self.lowest, highest].map(|i| Rational::from_i64(i) / Rational::from_i64(self.arity - 1))
    }

    /// Where the control point `f_0` stands: `τ/(m-1)`, so that lines that are reproduced are
    /// reproduced at their places.
    pub fn place(&self) -> Rational {
        &self.shift / Rational::from_i64(self.arity - 1)
    }

    /// The weights of `F^(n)(x) = Σ_k w_k f_k`, `w_k = φ^(n)(x - k)`; at `x =` [`place`](Self::place)
    /// those of the limit of the control point `f_0`, and of its derivatives.
    ///
    /// # Errors
    /// Code `limit` if the values are not determined: no scheme that is C^n with stable shifts has this;
    /// `place` if the orbit of `x` is too long; `budget` if the support is too wide.
    pub fn stencil(&self, x: &Rational, order: u32) -> Result<Stencil<Rational>, Diagnostic> {
        let values = self.values(x, order)?;
        // φ(x + l) is the weight of f_{-l}.
        let terms = values.into_iter().rev().map(|(l, value)| (-l, value));
        let mut terms = terms.skip_while(|(_, w)| w.is_zero()).peekable();
        let first = terms.peek().map_or(0, |(k, _)| *k);
        let mut weights: Vec<Rational> = terms.map(|(_, w)| w).collect();
        while weights.last().is_some_and(Ring::is_zero) {
            weights.pop();
        }
        Ok(Stencil { first, weights })
    }

    /// The rule that replaces every point by the limit, or a derivative of it, where the point stands.
    /// After `L` levels a derivative of order `n` by the parameter of the control points is `m^(nL)` as
    /// large.
    ///
    /// # Errors
    /// Those of [`stencil`](Self::stencil).
    pub fn rule<T: Coordinate>(&self, order: u32) -> Result<Weights<T>, Diagnostic> {
        Ok(Weights::of(vec![self.stencil(&self.place(), order)?], Rational::zero()))
    }

    /// The pairs `(l, φ^(n)(x + l))`, ascending, over the support.
    pub(crate) fn values(
        &self,
        x: &Rational,
        order: u32,
    ) -> Result<Vec<(i64, Rational)>, Diagnostic> {
        if self.window().count() > WIDEST {
            let message = "the support is too wide for exact limits";
            let hint = format!("{WIDEST} control points are the most");
            return Err(Diagnostic::new("budget", message).with_hint(hint));
        }
        let whole = x.floor();
        let (digits, start) = self.orbit(&(x - &whole))?;
        let (before, period) = digits.split_at(start.0);
        let mut values = self.periodic(period, &start.1, order)?;
        for &d in before.iter().rev() {
            let step = self.transition(d, order);
            values =
                column(&step.times(&Matrix::from_fn(values.len(), 1, |i, _| values[i].clone())));
        }
        // φ(x + l) with x = ⌊x⌋ + x' is φ(x' + (l + ⌊x⌋)).
        let whole = i64::try_from(whole.to_integer()).map_err(|_| far(x))?;
        let indices = self.window().map(|l| l - whole);
        Ok(indices.zip(values).collect())
    }

    /// The digits `d` of `m x = d + x'` until the fractional parts repeat, and after how many of them
    /// the period begins, and where.
    fn orbit(&self, x: &Rational) -> Result<(Vec<i64>, (usize, Rational)), Diagnostic> {
        let m = Rational::from_i64(self.arity);
        let (mut seen, mut digits) = (vec![x.clone()], Vec::new());
        while seen.len() <= LONGEST_ORBIT {
            let next = seen[seen.len() - 1].times(&m);
            let digit = next.floor();
            digits.push(i64::try_from(digit.to_integer()).map_err(|_| far(x))?);
            let next = next - digit;
            if let Some(start) = seen.iter().position(|y| *y == next) {
                return Ok((digits, (start, next)));
            }
            seen.push(next);
        }
        Err(far(x))
    }

    /// The indices `l` for which `φ(x + l)` may be other than zero for some `0 ≤ x < 1`.
    fn window(&self) -> std::ops::RangeInclusive<i64> {
        let highest = self.lowest + self.coefficients.len() as i64 - 1;
        self.lowest.div_euclid(self.arity - 1)..=highest.div_euclid(self.arity - 1)
    }

    fn coefficient(&self, i: i64) -> Rational {
        let index = usize::try_from(i - self.lowest).ok();
        index.and_then(|i| self.coefficients.get(i)).cloned().unwrap_or_else(Rational::zero)
    }

    /// `m^n T_d`.
    fn transition(&self, digit: i64, order: u32) -> Matrix<Rational> {
        let window = self.window();
        let (first, size) = (*window.start(), window.count());
        let scale = Rational::from_i64(self.arity).power(order);
        let index = |i: usize| first + i as i64;
        Matrix::from_fn(size, size, |j, l| {
            &scale * self.coefficient(self.arity * index(j) + digit - index(l))
        })
    }

    /// The values at `x`, to which the digits of a period lead back.
    fn periodic(
        &self,
        period: &[i64],
        x: &Rational,
        order: u32,
    ) -> Result<Vec<Rational>, Diagnostic> {
        let window: Vec<i64> = self.window().collect();
        let size = window.len();
        let identity = Matrix::identity(size);
        let product =
            period.iter().fold(identity.clone(), |m, &d| m.times(&self.transition(d, order)));
        // At the ends of its support a continuous function is zero.
        let [low, high] = self.support();
        let at = |l: i64| x + Rational::from_i64(l);
        let zeros: Vec<usize> =
            (0..size).filter(|&j| at(window[j]) <= low || at(window[j]) >= high).collect();
        let equations =
            Matrix::from_fn(size + zeros.len(), size, |i, j| match i.checked_sub(size) {
                None => product.entry(i, j).minus(identity.entry(i, j)),
                Some(k) => identity.entry(zeros[k], j).clone(),
            });
        // For f_k = k^n the derivative is n!: Σ_l (-l)^n φ^(n)(x + l) = n!.
        let moment = |v: &[Rational]| -> Rational {
            window.iter().zip(v).map(|(l, v)| Rational::from_i64(-l).power(order) * v).sum()
        };
        let factorial: Rational = (1..=i64::from(order)).map(Rational::from_i64).product();
        match &equations.null_space()[..] {
            [vector] if !moment(vector).is_zero() => {
                let scale = factorial / moment(vector);
                Ok(vector.iter().map(|v| v * &scale).collect())
            }
            _ => {
                let what = if order == 0 { "limit".into() } else { format!("derivative {order}") };
                let message = format!("the {what} is not determined by the scheme at {x}");
                let hint = "is the scheme so smooth? `refinable regularity` tells";
                Err(Diagnostic::new("limit", message).with_hint(hint))
            }
        }
    }
}

fn column(matrix: &Matrix<Rational>) -> Vec<Rational> {
    (0..matrix.shape().0).map(|i| matrix.entry(i, 0).clone()).collect()
}

fn far(x: &Rational) -> Diagnostic {
    let message = format!("{x} is no place at which limits are evaluated");
    Diagnostic::new("place", message).with_hint("take a fraction with a small denominator")
}
