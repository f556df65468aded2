//! Generation and reproduction degrees, stratified over the parameters.
//!
//! A family has no single degree: parameter space falls into strata, the generic one first, then
//! the curves on which a degree rises, then the points. See [`Degrees`].

use std::collections::BTreeMap;
use std::fmt;

use refinable_algebra::{
    GcdDomain, Integer, Monomial, Parameter, ParameterFraction, ParameterPolynomial, Rational,
    Ring, clear_denominators,
};
use refinable_reals::{Component, Unsolved, common_zero_set};
use refinable_scheme::Normalised;

/// The largest degree up to which polynomial data are refined to polynomials.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct GenerationDegree(pub usize);

/// The largest degree up to which samples of a polynomial are refined to samples of the same one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct ReproductionDegree(pub usize);

impl fmt::Display for GenerationDegree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for ReproductionDegree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A part of parameter space on which both degrees are constant, but for the smaller strata in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stratum {
    /// Where.
    pub locus: Component,
    /// The generation degree there.
    pub generation: GenerationDegree,
    /// The reproduction degree there.
    pub reproduction: ReproductionDegree,
}

/// The degrees of a family.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Degrees {
    /// The generic stratum first, then hypersurfaces, then points; within those by degree.
    pub strata: Vec<Stratum>,
    /// The parametrisation `τ = a'(1)/m` of the theorem.
    pub tau: ParameterFraction,
    /// Whether the strata reach down to the last point, and all have points. With three or more
    /// parameters the intersections of hypersurfaces are not computed, and conditions of very high
    /// degree are not solved.
    pub complete: bool,
}

impl Degrees {
    /// The stratum of almost all parameter values.
    pub fn generic(&self) -> &Stratum {
        &self.strata[0]
    }
}

/// The degrees of a family for all values of its parameters.
///
/// # Errors
/// None: the precondition is the type.
///
/// # Cost
/// `O(length)` moments of the mask for each degree; beyond that, gcds and resultants of the few
/// conditions at which a degree rises.
///
/// # Source
/// C. Conti, K. Hormann, *Polynomial reproduction for univariate subdivision schemes of any
/// arity*, J. Approx. Theory 163 (2011); for arity 2 it is Theorem 2.3 of Hameed and Mustafa:
/// generation up to `d` iff `a^(k)(-1) = 0` for `k ≤ d`; reproduction iff moreover
/// `a^(k)(1) = 2 τ(τ-1)…(τ-k+1)` for `k ≤ d`.
pub fn degrees(mask: &Normalised) -> Degrees {
    let conditions = Conditions::new(mask);
    let parameters: Vec<Parameter> = mask.parameters().into_iter().collect();
    let mut ladder = Ladder { conditions, parameters, strata: Vec::new(), complete: true };
    ladder.climb(Component::Space);
    ladder.strata.sort_by_key(|s| {
        let dimension = match s.locus {
            Component::Space => 0,
            Component::Hypersurface(_) => 1,
            Component::Point(_) => 2,
        };
        (dimension, s.generation, s.reproduction)
    });
    let tau = ladder.conditions.tau();
    Degrees { strata: ladder.strata, tau, complete: ladder.complete }
}

/// The polynomials whose vanishing raises the degrees, one step after the other.
struct Conditions {
    arity: usize,
    /// `d`, with the mask `A / d` and `A` over Z.
    denominator: ParameterPolynomial,
    /// For each monomial in the parameters its coefficients in `A`: pairs of the exponent `i` of
    /// `z` and `i(i-1)…(i-k+1)` times the coefficient, `k` the number of moments known.
    columns: Vec<(Monomial, Vec<(i64, Integer)>)>,
    /// `moments[k][r]`: see [`Conditions::moment`].
    moments: Vec<Vec<ParameterPolynomial>>,
}

impl Conditions {
    fn new(mask: &Normalised) -> Self {
        let mut by_monomial: BTreeMap<Monomial, Vec<(i64, Rational)>> = BTreeMap::new();
        for (i, p) in mask.numerator().terms() {
            for (monomial, c) in p.terms() {
                by_monomial.entry(monomial.clone()).or_default().push((i, c.clone()));
            }
        }
        let coefficients = by_monomial.values().flatten().map(|(_, c)| c);
        let (common, _) = clear_denominators(coefficients);
        let integral = |column: Vec<(i64, Rational)>| {
            column.into_iter().map(|(i, c)| (i, (c * &common).to_integer())).collect()
        };
        Conditions {
            arity: mask.arity(),
            denominator: mask.denominator().scaled(&Rational::from(common.clone())),
            columns: by_monomial.into_iter().map(|(m, column)| (m, integral(column))).collect(),
            moments: Vec::new(),
        }
    }

    /// `Σ_i i(i-1)…(i-k+1) A_i` over the exponents `i ≡ r`, for each residue `r`: what the residue
    /// classes contribute to the k-th derivative at `z = 1`.
    ///
    /// # Cost
    /// One small product for every coefficient of the mask and every new `k`.
    fn moment(&mut self, k: usize) -> &[ParameterPolynomial] {
        while self.moments.len() <= k {
            let order = self.moments.len() as i64;
            let mut sums = vec![ParameterPolynomial::zero(); self.arity];
            for (monomial, column) in &mut self.columns {
                let mut parts = vec![Integer::zero(); self.arity];
                for (i, product) in column.iter_mut() {
                    parts[i.rem_euclid(self.arity as i64) as usize] += &*product;
                    *product *= *i - order;
                }
                for (sum, part) in sums.iter_mut().zip(parts) {
                    *sum = sum.plus(&ParameterPolynomial::term(part.into(), monomial.clone()));
                }
            }
            self.moments.push(sums);
        }
        &self.moments[k]
    }

    /// The conditions for generation degree `k` beside those for `k - 1`: the k-th derivative
    /// vanishes at every root of `1 + z + … + z^(m-1)`, iff the moments of all residue classes are
    /// equal (modulo that polynomial `z^m = 1`, and the powers below `m` have only the relation
    /// that their sum is zero). For `m = 2` this is `a^(k)(-1) = 0`.
    fn generation(&mut self, k: usize) -> Vec<ParameterPolynomial> {
        let (first, rest) = self.moment(k).split_first().expect("the arity is at least 2");
        rest.iter().map(|moment| moment.minus(first)).collect()
    }

    /// `m · d`, by which `A'(1)` is divided to give `τ = T / u`.
    fn u(&self) -> ParameterPolynomial {
        self.denominator.times(&ParameterPolynomial::from_i64(self.arity as i64))
    }

    fn derivative_at_one(&mut self, k: usize) -> ParameterPolynomial {
        self.moment(k).iter().fold(ParameterPolynomial::zero(), |sum, part| sum.plus(part))
    }

    fn tau(&mut self) -> ParameterFraction {
        ParameterFraction::new(self.derivative_at_one(1), &self.u())
            .expect("a denominator is not zero")
    }

    /// The condition for reproduction degree `k` beside those for `k - 1` and generation:
    /// `a^(k)(1) = m Π_{h<k} (τ - h)`, multiplied by powers of the denominators, which vanish
    /// nowhere in the domain of the family and are divided out again where they can be.
    fn reproduction(&mut self, k: usize) -> ParameterPolynomial {
        let (t, u) = (self.derivative_at_one(1), self.u());
        let derivative = self.derivative_at_one(k);
        if t.is_zero() {
            // τ = 0 and the product is zero.
            return derivative;
        }
        let product = (0..k).fold(ParameterPolynomial::one(), |product, h| {
            product.times(&t.minus(&u.times(&ParameterPolynomial::from_i64(h as i64))))
        });
        let left = derivative.times(&u.power(k as u32 - 1));
        without_factors_of(left.minus(&product), &self.denominator)
    }
}

/// `p` divided by every factor it shares with `d`, as often as it does.
fn without_factors_of(mut p: ParameterPolynomial, d: &ParameterPolynomial) -> ParameterPolynomial {
    use refinable_algebra::Domain;
    while !p.is_zero() {
        let common = p.gcd(d);
        if common.as_constant().is_some() {
            break;
        }
        p = p.quotient(&common);
    }
    p
}

/// The strata found so far, and what is needed to find more.
struct Ladder {
    conditions: Conditions,
    parameters: Vec<Parameter>,
    strata: Vec<Stratum>,
    complete: bool,
}

impl Ladder {
    /// Records the strata of a piece and goes on to the smaller pieces on which a degree rises.
    fn climb(&mut self, piece: Component) {
        // At a pole there is no mask, and all conditions may vanish.
        let parts = piece.split_by(&self.conditions.denominator, &self.parameters);
        if parts != [piece.clone()] {
            return parts.into_iter().for_each(|part| self.climb(part));
        }
        if self.is_pole(&piece) {
            return;
        }
        let (generation, reproduction) = match self.degrees_on(&piece) {
            Ok(degrees) => degrees,
            Err(parts) => return parts.into_iter().for_each(|part| self.climb(part)),
        };
        let stratum = Stratum {
            locus: piece,
            generation: GenerationDegree(generation),
            reproduction: ReproductionDegree(reproduction),
        };
        if self.strata.contains(&stratum) {
            return;
        }
        self.complete &= stratum.locus.is_surely_real(&self.parameters);
        self.strata.push(stratum.clone());
        if let Component::Point(_) = stratum.locus {
            return;
        }
        let conditions = self.conditions.generation(generation + 1);
        self.climb_where(&stratum.locus, &conditions);
        if reproduction < generation {
            let condition = self.conditions.reproduction(reproduction + 1);
            self.climb_where(&stratum.locus, &[condition]);
        }
    }

    fn climb_where(&mut self, piece: &Component, conditions: &[ParameterPolynomial]) {
        match self.zeros_on(piece, conditions) {
            Ok(parts) => parts.into_iter().for_each(|part| self.climb(part)),
            Err(Unsolved) => self.complete = false,
        }
    }

    fn zeros_on(
        &self,
        piece: &Component,
        conditions: &[ParameterPolynomial],
    ) -> Result<Vec<Component>, Unsolved> {
        if let Component::Space = piece {
            return common_zero_set(conditions, &self.parameters);
        }
        let mut parts = vec![piece.clone()];
        for condition in conditions {
            let mut next = Vec::new();
            for part in &parts {
                next.extend(part.intersect(condition, &self.parameters)?);
            }
            parts = next;
        }
        Ok(parts)
    }

    /// Both degrees on a piece; or, if a condition holds on some of its components only, the parts
    /// into which that condition splits it.
    fn degrees_on(&mut self, piece: &Component) -> Result<(usize, usize), Vec<Component>> {
        let mut generation = 0;
        while all_hold(piece, &self.conditions.generation(generation + 1), &self.parameters)? {
            generation += 1;
        }
        let mut reproduction = 0;
        while reproduction < generation
            && all_hold(piece, &[self.conditions.reproduction(reproduction + 1)], &self.parameters)?
        {
            reproduction += 1;
        }
        Ok((generation, reproduction))
    }

    fn is_pole(&self, locus: &Component) -> bool {
        locus.annihilates(&self.conditions.denominator)
    }
}

/// Whether all conditions vanish on a piece; or the parts of it on one of which a condition does
/// and on the other of which it does not.
fn all_hold(
    piece: &Component,
    conditions: &[ParameterPolynomial],
    parameters: &[Parameter],
) -> Result<bool, Vec<Component>> {
    for condition in conditions.iter().filter(|c| !c.is_zero()) {
        if !piece.annihilates(condition) {
            let parts = piece.split_by(condition, parameters);
            return if parts == [piece.clone()] { Ok(false) } else { Err(parts) };
        }
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_scheme::Scheme;

    fn of(text: &str, arity: usize) -> Degrees {
        degrees(Scheme::resolve(text, arity).unwrap().mask())
    }

    fn generic(text: &str, arity: usize) -> (usize, usize) {
        let degrees = of(text, arity);
        (degrees.generic().generation.0, degrees.generic().reproduction.0)
    }

    #[test]
    fn b_splines_generate_their_degree_and_reproduce_lines() {
        for d in 1..8 {
            assert_eq!(generic(&format!("bspline{d}"), 2), (d, 1), "degree {d}");
        }
    }

    #[test]
    fn deslauriers_dubuc_reproduces_all_it_generates() {
        for n in 1..8 {
            assert_eq!(generic(&format!("dd{}", 2 * n), 2), (2 * n - 1, 2 * n - 1));
        }
    }

    /// Ternary four-point interpolation reproduces cubics: weights from Lagrange interpolation of
    /// -1, 0, 1, 2 at 1/3 are (-5, 60, 30, -4)/81.
    #[test]
    fn ternary_four_point_reproduces_cubics() {
        let text = "1/81*[-4, -5, 0, 30, 60, 81, 60, 30, 0, -5, -4]";
        assert_eq!(generic(text, 3), (3, 3));
    }

    #[test]
    fn the_four_point_scheme_with_tension_has_one_special_point() {
        let degrees = of("[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]", 2);
        let found: Vec<_> =
            degrees.strata.iter().map(|s| (s.generation.0, s.reproduction.0)).collect();
        assert_eq!(found, [(1, 1), (3, 3)]);
        let Component::Point(point) = &degrees.strata[1].locus else { panic!("a point") };
        let w = &point.coordinates()[&Parameter::new("w")];
        assert_eq!(w.exact_form().display("w"), "1/16");
    }

    /// `(x²+1) y = 0` raises a degree; of its two factors only `y` has real zeros, although `x²+1 = 0`
    /// would raise it further.
    #[test]
    fn strata_without_real_points_are_none() {
        let text = "1/32*(1+z)^6 + (x^2+1)*(y*(1+z)^2*(1-z) + (1+z)^3*(1-z))";
        let degrees = of(text, 2);
        let found: Vec<_> = degrees.strata.iter().map(|s| s.generation.0).collect();
        assert_eq!(found, [1, 2]);
        assert!(degrees.complete);
    }

    /// The paper's curve β = -(8α-1)/(16(α-1)) and the point α = 3/16 on it.
    #[test]
    fn the_two_tension_family_climbs_over_a_curve_to_points() {
        let degrees = of("a3", 2);
        let found: Vec<_> =
            degrees.strata.iter().map(|s| (s.generation.0, s.reproduction.0)).collect();
        assert_eq!(found, [(1, 1), (3, 1), (3, 3), (5, 1)]);
        assert!(degrees.complete);
    }

    /// The degree of `(1+z)²/2 + f (1-z²)(3+z)` rises where `f = 0`, and no further. Whether there are real zeros is
    /// not asked in three parameters, unless the degree in one of them is odd.
    #[test]
    fn surfaces_that_may_have_no_real_point_are_not_called_complete() {
        for (f, complete) in [("a^2+b^2+c^2+1", false), ("a^3+b^2+c^2+1", true)] {
            let degrees = of(&format!("1/2*(1+z)^2 + ({f})*(1-z^2)*(3+z)"), 2);
            let found: Vec<_> = degrees.strata.iter().map(|s| s.generation.0).collect();
            assert_eq!((found, degrees.complete), (vec![0, 1], complete), "{f}");
        }
    }
}
