//! The degree ladder of families, against the refinement of polynomial samples at single points.
//!
//! Points are random, and random on the strata themselves: on a curve one coordinate is solved for.

use std::collections::BTreeMap;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Ordered, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, integer, rational,
};
use refinable_analysis::{Degrees, Stratum, degrees};
use refinable_reals::{Component, RealAlgebraic};
use refinable_scheme::{Mask, Normalised, Scheme};
use refinable_tests::{difference_symbol, generation_degree, reproduction_degree};

type Values = BTreeMap<Parameter, Rational>;

/// The mask at a point; `None` at a pole.
fn at(mask: &Mask, point: &Values) -> Option<Vec<Rational>> {
    // Set one after the other, parameters may hide a pole: `u/(u + v)` at 0 is 0 for `u` first.
    if value(mask.denominator(), point).is_zero() {
        return None;
    }
    let coefficient = |c: ParameterFraction| {
        let value = point.iter().try_fold(c, |c, (name, x)| {
            c.substitute(name, &ParameterPolynomial::constant(x.clone()).into()).ok()
        });
        Some(value?.as_constant().expect("every parameter has a value"))
    };
    mask.coefficients().map(|(_, c)| coefficient(c)).collect()
}

fn value(p: &ParameterPolynomial, point: &Values) -> Rational {
    let value = point.iter().fold(p.clone(), |p, (name, x)| p.with(name, x));
    value.as_constant().expect("every parameter has a value")
}

fn contains(locus: &Component, point: &Values) -> bool {
    match locus {
        Component::Space => true,
        Component::Hypersurface(f) => value(f, point).is_zero(),
        Component::Point(p) => {
            p.coordinates().iter().all(|(name, x)| *x == RealAlgebraic::from(point[name].clone()))
        }
    }
}

/// The smallest strata that contain a point: all of the lowest dimension.
fn strata_at<'a>(degrees: &'a Degrees, point: &Values) -> Vec<&'a Stratum> {
    let codimension = |s: &Stratum| match s.locus {
        Component::Space => 0,
        Component::Hypersurface(_) => 1,
        Component::Point(_) => 2,
    };
    let mut found: Vec<_> = degrees.strata.iter().filter(|s| contains(&s.locus, point)).collect();
    let smallest = found.iter().map(|s| codimension(s)).max().expect("the generic stratum");
    found.retain(|s| codimension(s) == smallest);
    found
}

/// Compares the ladder at a point with the refinement of samples.
fn check_point(mask: &Normalised, degrees: &Degrees, point: &Values) -> Result<(), TestCaseError> {
    let Some(numbers) = at(mask, point) else { return Ok(()) };
    let generation = generation_degree(&numbers, mask.arity()).expect("stencils sum to 1");
    let reproduction = reproduction_degree(&numbers, mask.arity()).expect("stencils sum to 1");
    for stratum in strata_at(degrees, point) {
        let found = (stratum.generation.0, stratum.reproduction.0);
        prop_assert_eq!(found, (generation, reproduction.min(generation)), "at {:?}", point);
    }
    Ok(())
}

/// Rational points on the strata of a ladder, one for each linear equation and value from a list.
fn special_points(mask: &Mask, degrees: &Degrees, values: &[Rational]) -> Vec<Values> {
    let parameters: Vec<Parameter> = mask.parameters().into_iter().collect();
    let mut points = Vec::new();
    for stratum in &degrees.strata {
        match &stratum.locus {
            Component::Space => {}
            Component::Point(point) => {
                let coordinates = point.coordinates().iter();
                let rational: Option<Values> = coordinates
                    .map(|(name, x)| Some((name.clone(), x.as_rational()?.clone())))
                    .collect();
                points.extend(rational);
            }
            Component::Hypersurface(f) => {
                for (unknown, x) in parameters.iter().zip(values) {
                    points.extend(solved(f, unknown, &parameters, x));
                }
            }
        }
    }
    points
}

/// A point of `f = 0` with all coordinates but one equal to `x`, if `f` is linear in that one.
fn solved(
    f: &ParameterPolynomial,
    unknown: &Parameter,
    parameters: &[Parameter],
    x: &Rational,
) -> Option<Values> {
    let others = parameters.iter().filter(|p| *p != unknown);
    let mut point: Values = others.map(|p| (p.clone(), x.clone())).collect();
    let line = point.iter().fold(f.clone(), |f, (name, x)| f.with(name, x));
    let line = line.collected(unknown);
    let [constant, slope] = line.coefficients() else { return None };
    point.insert(unknown.clone(), -(constant.as_constant()? / slope.as_constant()?));
    Some(point)
}

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-24i64..=24, 1i64..=32).prop_map(|(p, q)| rational(p, q)),
        1 => Just(rational(0, 1)),
    ]
}

fn check_family(mask: &Normalised, values: &[Rational]) -> Result<(), TestCaseError> {
    let degrees = degrees(mask);
    prop_assert!(degrees.complete);
    prop_assert_eq!(&degrees.generic().locus, &Component::Space);
    let parameters = mask.parameters();
    check_point(mask, &degrees, &parameters.into_iter().zip(values.iter().cloned()).collect())?;
    for point in special_points(mask, &degrees, values) {
        check_point(mask, &degrees, &point)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_families_of_the_catalogue(
        family in 0..3usize,
        n in 0u32..=4,
        values in vec(number(), 2),
    ) {
        let name = [format!("a{}", 2 * n + 2), format!("a{}", 2 * n + 3), format!("i{}", 2 * n + 4)];
        check_family(Scheme::resolve(&name[family], 2).unwrap().mask(), &values)?;
    }
}

#[test]
fn fixed_schemes_of_the_catalogue() {
    let names = (1..=5).flat_map(|n| [format!("dd{}", 2 * n), format!("bspline{n}")]);
    for name in names {
        check_family(Scheme::resolve(&name, 2).unwrap().mask(), &[]).unwrap();
    }
}

/// An entry `(p + q u + r v) / d`, often zero or without parameters.
fn entry() -> impl Strategy<Value = ParameterPolynomial> {
    let small = || prop_oneof![2 => Just(0i64), 3 => -4i64..=4];
    (small(), small(), small(), 1i64..=4).prop_map(|(p, q, r, d)| {
        let term = |c: i64, name| {
            ParameterPolynomial::parameter(&Parameter::new(name)).scaled(&rational(c, d))
        };
        ParameterPolynomial::constant(rational(p, d)).plus(&term(q, "u")).plus(&term(r, "v"))
    })
}

/// Multiplied by `σ/m`, which adds one to the generation degree.
fn smoothed(mask: &[ParameterFraction], arity: usize) -> Vec<ParameterFraction> {
    let scale = ParameterPolynomial::constant(rational(1, arity as i64)).into();
    let mut product =
        vec![ParameterFraction::from(ParameterPolynomial::zero()); mask.len() + arity - 1];
    for (i, c) in mask.iter().enumerate() {
        for k in 0..arity {
            product[i + k] = product[i + k].plus(&c.times(&scale));
        }
    }
    product
}

/// Masks of arity 2 to 4 whose stencils sum to 1 by construction, the denominator `1`, `u` or
/// `u - v + 2`, perhaps symmetric, with up to three factors `σ/m`, anywhere on the line.
fn mask() -> impl Strategy<Value = Normalised> {
    let shape = (2usize..=4, 1usize..=2, 0usize..3, 0usize..=3, -9i64..=9, any::<bool>());
    shape.prop_flat_map(|shape| (Just(shape), vec(entry(), shape.0 * shape.1))).prop_filter_map(
        "a mask is not zero",
        |((arity, _, below, order, first, even), entries)| {
            let [u, v] =
                ["u", "v"].map(|name| ParameterPolynomial::parameter(&Parameter::new(name)));
            let two = ParameterPolynomial::from_i64(2);
            let below =
                [ParameterPolynomial::one(), u.clone(), u.minus(&v).plus(&two)][below].clone();
            let one = ParameterFraction::from(ParameterPolynomial::one());
            let fraction = |p| ParameterFraction::new(p, &below).expect("not zero");
            let mut mask: Vec<_> = entries.into_iter().map(fraction).collect();
            for class in 0..arity {
                let rest = mask.iter().skip(class).step_by(arity);
                mask.push(rest.fold(one.clone(), |rest, c| rest.minus(c)));
            }
            if even {
                let half = ParameterPolynomial::constant(rational(1, 2)).into();
                let mirrored = mask.iter().rev().zip(&mask);
                mask = mirrored.map(|(a, b)| a.plus(b).times(&half)).collect();
            }
            for _ in 0..order {
                mask = smoothed(&mask, arity);
            }
            Normalised::new(Mask::new(arity, first, &mask).ok()?).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn random_families(mask in mask(), values in vec(number(), 2)) {
        check_family(&mask, &values)?;
    }

    /// Generation: `σ^(d+1)` divides the symbol, and no higher power does. Reproduction: moreover
    /// `a(z) - m z^τ` has a zero of order `d + 1` at 1, `τ = a'(1)/m`; with `τ = p/q` that is the order
    /// of `a(z^q) - m z^p`.
    #[test]
    fn the_derivative_form_is_the_order_of_zero_form(
        mask in mask(),
        values in vec(number(), 2),
    ) {
        let point: Values =
            mask.parameters().into_iter().zip(values.iter().cloned()).collect();
        let Some(numbers) = at(&mask, &point) else { return Ok(()) };
        let arity = mask.arity();
        let generation = (0..=numbers.len())
            .take_while(|&n| difference_symbol(&numbers, arity, n).is_some())
            .count() - 1;
        let reproduction = order_at_one(&numbers, arity).map_or(generation, |n| n - 1);
        for stratum in strata_at(&degrees(&mask), &point) {
            prop_assert_eq!(stratum.generation.0, generation);
            prop_assert_eq!(stratum.reproduction.0, reproduction.min(generation));
        }
    }
}

/// `0/0` at `u = 0`, `v = 2`: setting `u` first would make it a scheme.
#[test]
fn a_pole_that_one_order_of_setting_hides_is_a_pole() {
    let text = "[-u/(u-v+2), 1, (2*u-v+2)/(u-v+2)]";
    let scheme = Scheme::resolve(text, 2).unwrap();
    let parameters = scheme.mask().parameters();
    let point: Values = parameters.into_iter().zip([0, 2].map(|x| rational(x, 1))).collect();
    assert_eq!(at(scheme.mask(), &point), None);
    check_family(scheme.mask(), &[rational(0, 1), rational(0, 1)]).unwrap();
}

/// `α = v/4u` in the three-point family: at `u = v = 0` the numerators of all conditions vanish, and
/// there is no scheme.
#[test]
fn a_common_zero_of_all_conditions_at_a_pole_is_no_stratum() {
    let scheme = Scheme::resolve("[v/(4*u), 1/2, 1-v/(2*u), 1/2, v/(4*u)]", 2).unwrap();
    let degrees = degrees(scheme.mask());
    let found: Vec<_> = degrees.strata.iter().map(|s| (s.generation.0, s.reproduction.0)).collect();
    assert_eq!(found, [(1, 1), (3, 1)]);
    check_family(scheme.mask(), &[rational(2, 1), rational(4, 1)]).unwrap();
}

/// The order of the zero of `a(z) - m z^τ` at 1; `None` if it is zero.
fn order_at_one(mask: &[Rational], arity: usize) -> Option<usize> {
    let m = integer(arity as i64);
    let moment = (0..).zip(mask).fold(rational(0, 1), |sum, (i, a)| sum + a * integer(i));
    let tau = moment / &m;
    // Reproduction does not depend on the denominator's size, but a polynomial's length does.
    let q = i64::try_from(tau.denom()).expect("short");
    let p = i64::try_from(tau.numer()).expect("short");
    let shift = (-p).max(0);
    let mut terms: BTreeMap<i64, Rational> = BTreeMap::new();
    for (i, a) in (0..).zip(mask) {
        *terms.entry(q * i + shift).or_insert_with(Rational::zero) += a;
    }
    *terms.entry(p + shift).or_insert_with(Rational::zero) -= &m;
    // The k-th factorial moments vanish up to the order.
    let moment = |k: i64| {
        terms.iter().fold(Rational::zero(), |sum, (i, c)| {
            sum + (0..k).fold(c.clone(), |c, h| c * integer(i - h))
        })
    };
    if terms.values().all(|c| c.compare_to_zero().is_eq()) {
        return None;
    }
    (0..).find(|&k| !moment(k).is_zero()).map(|k| k as usize)
}

/// A Lagrange interpolation of every arity: 2r points reproduce degree 2r - 1.
#[test]
fn interpolation_at_equidistant_points_reproduces_all_it_generates() {
    for arity in 2..=4_i64 {
        for r in 1..=3_i64 {
            let mut coefficients = BTreeMap::new();
            for class in 0..arity {
                // New points at class/m between the points 0 and 1, from the data at 1-r, …, r.
                for j in 1 - r..=r {
                    let x = rational(class, arity);
                    let others = (1 - r..=r).filter(|k| *k != j);
                    let weight =
                        others.fold(rational(1, 1), |w, k| w * (&x - integer(k)) / integer(j - k));
                    coefficients.insert(class - arity * j, weight);
                }
            }
            let (first, last) = (-arity * r, arity - 1 + arity * (r - 1));
            let list: Vec<ParameterFraction> = (first..=last)
                .map(|i| coefficients.get(&i).cloned().unwrap_or_else(Rational::zero))
                .map(|c| ParameterPolynomial::constant(c).into())
                .collect();
            let mask = Normalised::new(Mask::new(arity as usize, first, &list).unwrap()).unwrap();
            let d = 2 * r as usize - 1;
            let generic = degrees(&mask).generic().clone();
            assert_eq!((generic.generation.0, generic.reproduction.0), (d, d), "{arity} {r}");
            check_family(&mask, &[]).unwrap();
        }
    }
}
