//! Values known from elsewhere: published theorems, classical schemes, other computer algebra.

use refinable_algebra::{
    Integer, Parameter, ParameterPolynomial, Polynomial, Rational, Ring, binomial, integer,
    parse_rational, rational,
};
use refinable_analysis::{Budget, Degrees, NormRange, degrees, norm_range, norm_values};
use refinable_papers::{Claim, Paper, Statement};
use refinable_reals::{Component, RealAlgebraic, Region, real_roots};
use refinable_scheme::{Expression, Mask, Scheme, Substitution};

fn scheme(text: &str, set: &[&str]) -> Scheme {
    let set: Vec<_> = set.iter().map(|s| Substitution::parse(s).unwrap()).collect();
    Scheme::resolve_with(text, 2, &set).unwrap()
}

fn range(scheme: &Scheme, continuity: usize, level: u32) -> NormRange {
    let parameters = scheme.mask().parameters();
    let parameter = parameters.first().expect("one parameter is free");
    norm_range(scheme.mask(), parameter, continuity, level, Budget::default()).unwrap()
}

/// The lowest level up to `last` at which a norm proves C^n.
fn proving_level(scheme: &Scheme, continuity: usize, last: u32) -> Option<usize> {
    let norms = norm_values(scheme.mask(), continuity, last, Budget::default()).unwrap()?;
    norms.iter().position(|norm| *norm < rational(1, 1)).map(|l| l + 1)
}

fn poly(coefficients: &[i64]) -> Polynomial<Integer> {
    Polynomial::new(coefficients.iter().map(|&c| integer(c)).collect())
}

fn polynomial(text: &str) -> ParameterPolynomial {
    let value = Expression::parse(text).unwrap().evaluate().unwrap();
    value.as_polynomial().unwrap().clone()
}

/// The paper's Table of continuity, N = 1: C^2 for 0 < α < 1/16.
#[test]
fn a4_is_c2_between_0_and_one_sixteenth_by_the_first_norm() {
    assert_eq!(
        range(&scheme("a4", &[]), 2, 1).proved,
        Region::open(rational(0, 1), rational(1, 16))
    );
}

/// N. Dyn, J. Gregory, D. Levin, *Analysis of uniform binary subdivision schemes for curve design*,
/// Constr. Approx. 7 (1991): C^1 for 0 < ω < (√5 - 1)/8, by the second norm. Here ω = -β.
#[test]
fn the_four_point_scheme_is_c1_on_the_classical_interval() {
    let range = range(&scheme("i4", &[]), 1, 2);
    let end = RealAlgebraic::quadratic(&rational(1, 8), &rational(-1, 8), &rational(5, 1));
    assert_eq!(range.levels[0], Region::empty());
    assert_eq!(range.levels[1], Region::open(end, rational(0, 1)));
}

/// N. Dyn, D. Levin, J. Gregory, *A 4-point interpolatory subdivision scheme for curve design*,
/// CAGD 4 (1987): continuous for |ω| < 1/4, by the first norm.
#[test]
fn the_four_point_scheme_converges_below_one_quarter() {
    let range = range(&scheme("i4", &[]), 0, 1);
    assert_eq!(range.proved, Region::open(rational(-1, 4), rational(1, 4)));
}

/// J. Hechler, B. Mößner, U. Reif, *C^1-continuity of the generalized four-point scheme*, Linear
/// Algebra Appl. 430 (2009): C^1 iff 0 < ω < ω*, the real root of 32ω³ + 4ω - 1. So no norm may
/// prove more, and higher ones should come closer.
#[test]
fn no_norm_proves_more_of_the_four_point_scheme_than_is_true() {
    // ω = -β: β* is the root of 32β³ + 4β + 1.
    let roots = real_roots(&poly(&[1, 4, 0, 32]));
    let [end] = roots.as_slice() else { panic!("one real root") };
    assert_eq!(end.decimal(5), "-0.19273");
    let range = range(&scheme("i4", &[]), 1, 7);
    assert!(range.proved.is_subset(&Region::open(end.clone(), rational(0, 1))));
    assert!(range.proved.contains_rational(&rational(-177, 1000)));
}

#[test]
fn b_splines_have_the_continuity_support_and_degrees_of_their_degree() {
    for d in 1..=12 {
        let spline = scheme(&format!("bspline{d}"), &[]);
        assert_eq!(proving_level(&spline, d - 1, 1), Some(1), "degree {d}");
        assert_eq!(proving_level(&spline, d, 3), None, "degree {d}");
        assert_eq!(spline.mask().support_width(), rational(d as i64 + 1, 1));
        assert_eq!(ladder(&degrees(spline.mask())), [(d, 1)], "degree {d}");
    }
}

/// Hölder exponents 2, 2.8301, 3.5511 (G. Deslauriers, S. Dubuc, *Symmetric iterative interpolation
/// processes*, Constr. Approx. 5 (1989); T. Eirola, SIAM J. Math. Anal. 23 (1992)): C^1, C^2, C^3 and
/// not more.
#[test]
fn deslauriers_dubuc_schemes_are_as_smooth_as_their_exponent() {
    for (points, continuity) in [(4, 1), (6, 2), (8, 3)] {
        let scheme = scheme(&format!("dd{points}"), &[]);
        for n in 0..=continuity {
            let level = proving_level(&scheme, n, 8);
            assert!(level.is_some(), "C^{n} of the {points}-point scheme");
        }
        for n in continuity + 1..points {
            assert_eq!(proving_level(&scheme, n, 8), None, "C^{n} of the {points}-point scheme");
        }
    }
}

/// Every mask the paper prints is the one its recursion yields.
#[test]
fn the_printed_masks_are_those_of_the_recursion() {
    let paper = Paper::builtin().unwrap();
    let mut count = 0;
    for cell in paper.tables.iter().flat_map(|table| &table.cells) {
        for claim in &cell.claims {
            let Claim::Checkable(assertion) = claim else { continue };
            let Statement::Mask { mask } = &assertion.statement else { continue };
            let set: Vec<&str> = assertion.set.iter().map(String::as_str).collect();
            let ours = scheme(&assertion.scheme, &set);
            assert_eq!(**ours.mask(), Mask::parse(mask, 2).unwrap(), "{}", cell.row);
            count += 1;
        }
    }
    assert!(count >= 9, "{count} masks");
}

/// The mask of the first scheme, by hand: three control points, two rules.
#[test]
fn the_first_mask_by_hand() {
    let printed = Mask::parse("[alpha, 1/2, 1-2*alpha, 1/2, alpha]", 2).unwrap();
    assert_eq!(**scheme("a2", &[]).mask(), printed);
}

/// `(generation, reproduction)`, generic first.
fn ladder(degrees: &Degrees) -> Vec<(usize, usize)> {
    degrees.strata.iter().map(|s| (s.generation.0, s.reproduction.0)).collect()
}

/// α = C(2N+2, N+1)/16^(N+1): 1/8, 3/128, 5/1024, …, where two more degrees are generated.
#[test]
fn the_even_families_have_one_special_value() {
    for n in 0..=5_u32 {
        let scheme = scheme(&format!("a{}", 2 * n + 2), &[]);
        let degrees = degrees(scheme.mask());
        let d = 2 * n as usize + 1;
        assert_eq!(ladder(&degrees), [(d, d), (d + 2, d)], "N = {n}");
        let special = Rational::new(binomial(2 * n + 2, n + 1), integer(16).power(n + 1));
        assert_eq!(degrees.strata[1].locus, at(&[("alpha", special)]), "N = {n}");
    }
    assert_eq!(Rational::new(binomial(4, 2), integer(256)), rational(3, 128));
}

fn at(coordinates: &[(&str, Rational)]) -> Component {
    let coordinates = coordinates.iter().map(|(name, x)| (Parameter::new(name), x.clone().into()));
    Component::Point(refinable_reals::Point::new(coordinates))
}

fn check_odd_family(n: usize, curve: &str, generating: [Rational; 2], reproducing: Rational) {
    let scheme = scheme(&format!("a{}", 2 * n + 3), &[]);
    let degrees = degrees(scheme.mask());
    let d = 2 * n + 1;
    assert!(degrees.complete);
    assert_eq!(ladder(&degrees), [(d, d), (d + 2, d), (d + 2, d + 2), (d + 4, d)], "N = {n}");
    let [_, line, reproduction, generation] = degrees.strata.as_slice() else { unreachable!() };
    assert_eq!(line.locus, Component::Hypersurface(polynomial(curve).primitive().2), "N = {n}");
    let [alpha, beta] = generating;
    assert_eq!(generation.locus, at(&[("alpha", alpha), ("beta", beta)]), "N = {n}");
    let interpolatory = at(&[("alpha", rational(0, 1)), ("beta", reproducing)]);
    assert_eq!(reproduction.locus, interpolatory, "N = {n}");
}

#[test]
fn the_ladder_of_a3() {
    let curve = "8*alpha - 1 - 16*beta*(1-alpha)";
    check_odd_family(0, curve, [rational(3, 16), rational(1, 26)], rational(-1, 16));
}

#[test]
fn the_ladder_of_a5() {
    let curve = "256*beta*(1-alpha) + 128*alpha - 3";
    check_odd_family(1, curve, [rational(5, 128), rational(-1, 123)], rational(3, 256));
}

#[test]
fn the_ladder_of_a7() {
    let curve = "2048*beta*(1-alpha) - 1024*alpha + 5";
    check_odd_family(2, curve, [rational(35, 4096), rational(15, 8122)], rational(-5, 2048));
}

/// N = 20, far beyond the paper's tables.
#[test]
fn the_ladder_of_a43() {
    let scale = parse_rational("4835703278458516698824704").unwrap();
    let curve = "4835703278458516698824704*beta*(1-alpha) \
                 - (2417851639229258349412352*alpha - 67282234305)";
    let alpha = parse_rational("263012370465").unwrap() / &scale;
    let product = &alpha * rational(1, 2) - parse_rational("67282234305").unwrap() / &scale;
    let beta = product / (rational(1, 1) - &alpha);
    let reproducing = parse_rational("-67282234305").unwrap() / &scale;
    check_odd_family(20, curve, [alpha, beta], reproducing);
}

/// The curves on which the odd families generate two more degrees.
const CURVES: [(&str, &str); 3] = [
    ("a3", "beta=(8*alpha-1)/(16*(1-alpha))"),
    ("a5", "beta=(3-128*alpha)/(256*(1-alpha))"),
    ("a7", "beta=(1024*alpha-5)/(2048*(1-alpha))"),
];

/// Scheme (on its curve), order, level and the two ends, to 12 significant digits: computed with
/// PARI/GP 2.15 by `benches/peers/pari/contractivity.gp`.
const ENDS: [(&str, usize, usize, &str, &str); 30] = [
    ("a2", 1, 4, "0", "0.441954097146"),
    ("a2", 1, 6, "0", "0.458488427166"),
    ("a4", 0, 4, "-0.117236167231", "0.23898222204"),
    ("a4", 1, 4, "-0.0247757691386", "0.13209515374"),
    ("a4", 2, 6, "0", "0.0753191491227"),
    ("a4", 3, 4, "0.0215418154725", "0.0389880053586"),
    ("a4", 3, 6, "0.0208576726343", "0.0404528788407"),
    ("a6", 0, 3, "-0.0365481451726", "0.0694332542749"),
    ("a6", 2, 4, "-0.00518980781615", "0.0213327294362"),
    ("a6", 3, 6, "0.00239184461983", "0.0139876363589"),
    ("a6", 4, 4, "0.00470074246417", "0.0084457998757"),
    ("a8", 1, 5, "-0.00594042727696", "0.0122958114241"),
    ("a8", 4, 4, "0.000759806104494", "0.00248165159349"),
    ("a8", 5, 4, "0.00130690037232", "0.00132220406163"),
    ("a10", 2, 3, "-0.000796143734293", "0.00163197510808"),
    ("a10", 4, 5, "0.0000412417405672", "0.00073042558938"),
    ("a12", 2, 1, "0.00000166236807447", "0.000042234148298"),
    ("a12", 3, 3, "-0.0000132417055617", "0.000297804054201"),
    ("a12", 5, 4, "0.0000624880781752", "0.00014668718558"),
    ("i4", 0, 6, "-0.435136809871", "0.438903608086"),
    ("i4", 1, 6, "-0.177197811685", "0"),
    ("i6", 1, 5, "-0.0360795914676", "0.0942064774341"),
    ("i6", 2, 4, "0", "0.0406633735274"),
    ("i8", 2, 3, "-0.0130604671233", "0.00513493416802"),
    ("i8", 3, 4, "-0.00677462693598", "-0.00286214547173"),
    ("i8", 3, 5, "-0.00712376255562", "-0.00239174598174"),
    ("a3", 1, 4, "-0.116474975016", "0.696133926958"),
    ("a3", 3, 6, "0.125", "0.354244213583"),
    ("a5", 4, 5, "0.0292177959704", "0.0639128920567"),
    ("a7", 3, 3, "0.00299516036988", "0.0239959401552"),
];

#[test]
fn ends_agree_with_other_computer_algebra() {
    for (name, continuity, level, lower, upper) in ENDS {
        let curve = CURVES.iter().find(|(scheme, _)| *scheme == name).map(|(_, set)| *set);
        let scheme = scheme(name, curve.as_slice());
        let range = range(&scheme, continuity, level as u32);
        let found: Vec<String> =
            range.levels[level - 1].ends().iter().map(|x| x.decimal(12)).collect();
        assert_eq!(found, [lower, upper], "{name}, C^{continuity}, level {level}");
    }
}
