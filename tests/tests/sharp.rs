//! Sharp ranges and regularity against values of other authors, against each other, and against
//! norms by refining data.

use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Polynomial, Rational, Ring, decimal,
    integer, rational,
};
use refinable_analysis::{
    Budget, ContinuityRange, Options, PointVerdict, Regularity, Sharpness, continuity_at,
    continuity_range, highest_continuity, norm_range, regularity, smoothest_in,
};
use refinable_certificate::verify;
use refinable_reals::{Region, real_roots};
use refinable_scheme::{Scheme, Substitution};
use refinable_tests::{difference_symbol, iterated_norm};

fn scheme(text: &str) -> Scheme {
    Scheme::resolve(text, 2).unwrap()
}

fn at(family: &Scheme, parameter: &str, value: &Rational) -> Scheme {
    let value = ParameterFraction::from(ParameterPolynomial::constant(value.clone()));
    family.with(&[Substitution::new(Parameter::new(parameter), value)]).unwrap()
}

fn range(family: &Scheme, parameter: &str, continuity: usize) -> ContinuityRange {
    let parameter = Parameter::new(parameter);
    let sharpness = Sharpness::default();
    continuity_range(family.name(), family.mask(), &parameter, continuity, &sharpness).unwrap()
}

fn exponent(scheme: &Scheme) -> Regularity {
    regularity(scheme.name(), scheme.mask(), &Options::default()).unwrap()
}

/// The four-point scheme is smoothest at 1/16 (Dubuc), the J-splines at the quintic B-spline, s = 3/2 (Rossignac
/// and Schaefer); the ends of a region are obeyed, and of single values the better one is taken.
#[test]
fn the_smoothest_members_of_known_families() {
    let smoothest = |text: &str, region: Region| {
        let family = scheme(text);
        let (at, found) = smoothest_in(family.name(), family.mask(), &region).unwrap();
        (at, found.lower, found.upper.unwrap())
    };
    let [zero, half] = [rational(0, 1), rational(1, 2)];
    let two = rational(2, 1);
    let four_point = smoothest("fourpoint(w)", Region::open(zero.clone(), rational(19, 100)));
    assert_eq!(four_point, (rational(1, 16), two.clone(), two));
    // Chaikin's scheme among others with the factor (1+z)², by the rise of its order.
    let corners =
        smoothest("1/2*(1+z)^2*(3*a+(1-3*a)*z)", Region::open(zero.clone(), half.clone()));
    assert_eq!(corners, (rational(1, 6), rational(2, 1), rational(2, 1)));
    // A simple number near where words grow least: the ternary four-point scheme at 1/11.
    let ternary = Scheme::resolve("ternaryfourpoint(mu)", 3).unwrap();
    let region = Region::open(rational(1, 15), rational(1, 9));
    let (place, found) = smoothest_in("ternary", ternary.mask(), &region).unwrap();
    assert_eq!((place, found.scale), (rational(1, 11), Some(rational(11, 9).into())));
    let five = rational(5, 1);
    let spline = smoothest("jspline(s)", Region::open(half, rational(3, 1)));
    assert_eq!(spline, (rational(3, 2), five.clone(), five));
    let (at, lower, _) = smoothest("jspline(s)", Region::open(zero, rational(1, 1)));
    assert!(at < rational(1, 1) && lower < rational(4, 1), "{at}: {lower}");
    let single = [rational(1, 1), rational(3, 2), rational(2, 1)].map(Into::into);
    assert_eq!(smoothest("jspline(s)", Region::points(single)).0, rational(3, 2));
}

/// Hechler, Mößner and Reif 2009: C^1 iff 0 < ω < ω*, 32ω³ + 4ω - 1 = 0, ω = -β.
#[test]
fn the_four_point_scheme_is_c1_exactly_up_to_the_known_tension() {
    let found = range(&scheme("i4"), "beta", 1);
    let end = real_roots(&Polynomial::new([1, 4, 0, 32].map(integer).to_vec())).remove(0);
    assert_eq!(found.proved, Region::open(end.clone(), rational(0, 1)));
    assert_eq!(found.refuted, found.proved.complement());
    assert!(found.is_exact() && found.undecided().is_empty());
    assert_eq!(found.proved.display("beta"), "(root(32*beta^3 + 4*beta + 1, 1), 0)");
}

/// A B-spline of degree d has Hölder exponent d, and is C^(d-1) but not C^d.
#[test]
fn splines_are_as_regular_as_their_degree() {
    for degree in 1..=20 {
        let spline = scheme(&format!("bspline{degree}"));
        let found = exponent(&spline);
        let exactly = Rational::from_i64(degree);
        assert_eq!(
            (&found.lower, &found.upper),
            (&exactly, &Some(exactly.clone())),
            "degree {degree}"
        );
        assert_eq!(found.continuity, Some(degree as usize - 1));
        assert!(found.stable == Some(true) && found.scale.is_some());
    }
}

/// Deslauriers and Dubuc; Eirola 1992; Daubechies 1992, for 4 to 20 points.
#[test]
fn deslauriers_dubuc_exponents() {
    let known = [(4, "2"), (6, "2.8301"), (8, "3.5511"), (10, "4.1936")];
    for points in (4..=20).step_by(2) {
        let found = exponent(&scheme(&format!("dd{points}")));
        let gap = found.upper.unwrap() - &found.lower;
        assert!(gap <= rational(1, 1_000_000_000), "{points} points");
        if let Some((_, text)) = known.iter().find(|(p, _)| *p == points) {
            assert_eq!(decimal(&found.lower, text.len().max(2) as u32 - 1), *text);
        }
    }
}

/// A B-spline of degree d has support width d+1 and is C^(d-1): no support allows more.
#[test]
fn splines_are_as_smooth_as_their_support_allows() {
    for degree in 1..=20 {
        let spline = scheme(&format!("bspline{degree}"));
        assert_eq!(highest_continuity(spline.mask()), exponent(&spline).continuity);
    }
    assert_eq!(highest_continuity(scheme("[1, 1]").mask()), None);
    assert_eq!(highest_continuity(scheme("a3").mask()), Some(4));
}

/// With r = 3 - log2(9/8): 2 to the power of 5 - r is 9/2.
#[test]
fn the_six_point_scheme_has_an_exact_exponent() {
    assert_eq!(exponent(&scheme("dd6")).scale, Some(rational(2, 9).into()));
}

/// r > n exactly where C^n is proved, at values inside, outside and near the ends; where C^n is
/// refuted all norms are at least 1 by the oracle.
#[test]
fn ranges_and_regularity_agree() {
    let mut decided = 0;
    for (name, arity, parameter, highest) in [
        ("a2", 2, "alpha", 1),
        ("a4", 2, "alpha", 3),
        ("a6", 2, "alpha", 4),
        ("i4", 2, "beta", 1),
        ("i6", 2, "beta", 2),
        ("ternaryfourpoint(mu)", 3, "mu", 3),
        ("1/3*(1+z+z^2)^2*(t+(1-2*t)*z+t*z^2)", 3, "t", 2),
        ("1/16*(1+z+z^2+z^3)^3*(t+(1-t)*z)", 4, "t", 3),
    ] {
        let family = Scheme::resolve(name, arity).unwrap();
        let ranges: Vec<ContinuityRange> =
            (0..=highest).map(|n| range(&family, parameter, n)).collect();
        let values = (-7..=7).map(|k| rational(k * k * k, 343 * 5)).chain([rational(1, 61)]);
        for value in values {
            let member = at(&family, parameter, &value);
            let found = exponent(&member);
            for (n, range) in ranges.iter().enumerate() {
                let whole = Rational::from_i64(n as i64);
                if range.proved.contains_rational(&value) {
                    assert!(found.lower > whole, "{name} {value}: r > {n}");
                    decided += 1;
                }
                if range.refuted.contains_rational(&value) && found.stable == Some(true) {
                    assert!(found.lower <= whole, "{name} {value}: r <= {n}");
                    assert_norms_at_least_one(&member, n);
                    decided += 1;
                }
            }
        }
    }
    assert!(decided > 300, "only {decided} cases were decided");
}

fn assert_norms_at_least_one(member: &Scheme, continuity: usize) {
    let mask: Vec<Rational> =
        member.mask().numerator().coefficients().iter().map(|c| c.as_constant().unwrap()).collect();
    let scale = member.mask().denominator().as_constant().unwrap();
    let mask: Vec<Rational> = mask.iter().map(|c| c / &scale).collect();
    let arity = member.mask().arity();
    if let Some(c) = difference_symbol(&mask, arity, continuity) {
        for level in 1..=[5, 3, 2][arity - 2] {
            assert!(
                iterated_norm(&c, arity, level) >= rational(1, 1),
                "{} level {level}",
                member.name()
            );
        }
    }
}

/// Hassan, Ivrissimtzis, Dodgson and Sabin 2002: the ternary four-point scheme is C² for `1/15 < μ < 1/9`, with the exponent
/// `log_3 11 = 2.18265…` at 1/11. Hassan and Dodgson 2003: the three-point one is C¹ for `2/9 < b < 1/3`. Both only there.
#[test]
fn ternary_schemes_from_both_sides() {
    let ternary = |text: &str| Scheme::resolve(text, 3).unwrap();
    let four = ternary("ternaryfourpoint(mu)");
    let found = range(&four, "mu", 2);
    assert_eq!(found.proved, Region::open(rational(1, 15), rational(1, 9)));
    assert_eq!(found.refuted, found.proved.complement());
    // At 1/27 the order is four, and still nothing is C³.
    for n in 3..=6 {
        assert_eq!(range(&four, "mu", n).refuted, Region::line(), "C^{n}");
    }
    let smooth = exponent(&at(&four, "mu", &rational(1, 11)));
    assert_eq!((smooth.continuity, smooth.stable), (Some(2), Some(true)));
    assert_eq!(smooth.scale, Some(rational(11, 9).into()));
    assert_eq!(decimal(&smooth.lower, 10), "2.182658339");
    let three = ternary("[b-1/3, 0, b, 4/3-2b, 1, 4/3-2b, b, 0, b-1/3]");
    let found = range(&three, "b", 1);
    assert_eq!(found.proved, Region::open(rational(2, 9), rational(1, 3)));
    assert_eq!(found.refuted, found.proved.complement());
}

/// A B-spline of degree `d` has the Hölder exponent `d` for every arity.
#[test]
fn splines_of_higher_arity() {
    for arity in 3..=5_usize {
        let sigma: Vec<String> = (0..arity).map(|k| format!("z^{k}")).collect();
        for degree in 1..=4 {
            let symbol = format!("{arity}*(({})/{arity})^{}", sigma.join("+"), degree + 1);
            let found = exponent(&Scheme::resolve(&symbol, arity).unwrap());
            let exactly = Rational::from_i64(degree);
            assert_eq!(
                (&found.lower, &found.upper),
                (&exactly, &Some(exactly.clone())),
                "{symbol}"
            );
            assert_eq!(found.stable, Some(true));
        }
    }
}

#[test]
fn what_norms_prove_is_inside_and_nothing_is_both_proved_and_refuted() {
    for (name, parameter, continuity) in [
        ("a2", "alpha", 0),
        ("a4", "alpha", 2),
        ("a6", "alpha", 3),
        ("i4", "beta", 1),
        ("a8", "alpha", 4),
    ] {
        let family = scheme(name);
        let sharp = range(&family, parameter, continuity);
        let parameter = Parameter::new(parameter);
        let norms =
            norm_range(family.mask(), &parameter, continuity, 4, Budget::default()).unwrap();
        assert!(norms.proved.is_subset(&sharp.proved), "{name} C^{continuity}");
        assert!(sharp.proved.intersection(&sharp.refuted).is_empty());
    }
}

/// (1+z)((1+z²)/2)³ is C² although (1+z)² does not divide it: its limit function is a cubic spline,
/// summed over translates.
#[test]
fn a_dilated_spline_is_as_smooth_as_the_spline() {
    let dilated = scheme("1/8*(1+z)*(1+z^2)^3");
    let verdict = |n| {
        let (verdict, _) =
            continuity_at("dilated", dilated.mask(), n, &Sharpness::default()).unwrap();
        verdict
    };
    for n in 0..=2 {
        assert_eq!(verdict(n), PointVerdict::Proved, "C^{n}");
    }
    for n in 3..=4 {
        assert_eq!(verdict(n), PointVerdict::Refuted, "C^{n}");
    }
    let found = exponent(&dilated);
    assert_eq!((found.lower, found.upper), (rational(3, 1), Some(rational(3, 1))));
    assert_eq!(found.stable, Some(false));
}

/// At α = 17/256 the symbol of a6 is `(1-z+z²) â(z)` with `â = (1+z)⁶ (17 - 82z + 138z² - 82z³ + 17z⁴)/256`.
/// As `(1+z²+z⁴) = (1+z+z²)(1-z+z²)`, its limit function is a third of the sum of three translates of
/// that of `â`, which is C¹: so is the scheme at this value, and at no other near it.
#[test]
fn a_single_value_may_be_smooth_among_rough_ones() {
    let value = rational(17, 256);
    let family = scheme("a6");
    let member = at(&family, "alpha", &value);
    let reduced = scheme("1/256*z^-5*(1+z)^6*(17-82*z+138*z^2-82*z^3+17*z^4)");
    let other = scheme("1/256*z^-5*(1+z)^6*(17-82*z+138*z^2-82*z^3+17*z^4)*z^-1*(1-z+z^2)");
    assert_eq!(member.mask(), other.mask());
    let found = range(&family, "alpha", 1);
    assert!(found.proved.contains_rational(&value) && found.is_exact());
    assert!(found.undecided().is_empty());
    for near in [rational(17 * 4096 - 1, 1 << 20), rational(17 * 4096 + 1, 1 << 20)] {
        assert!(found.refuted.contains_rational(&near));
    }
    let (exponent, of_reduced) = (exponent(&member), exponent(&reduced));
    assert_eq!((&exponent.lower, exponent.continuity), (&of_reduced.lower, Some(1)));
    assert_eq!([exponent.stable, of_reduced.stable], [Some(false), Some(true)]);
    assert!(of_reduced.factor.is_none());
    assert!(range(&family, "alpha", 2).refuted.contains_rational(&value));
}

/// i8 has an unstable value that is irrational. There it diverges, so it is not C^5 anywhere.
#[test]
fn where_a_scheme_diverges_it_is_not_smooth() {
    let found = range(&scheme("i8"), "beta", 5);
    assert_eq!(found.refuted, Region::line());
}

/// At α = 1/2 the symbol of a2 is a hat function's, spread: continuous and no more. The reduced mask
/// shows it.
#[test]
fn reduction_settles_an_unstable_value() {
    let family = scheme("a2");
    assert!(range(&family, "alpha", 1).refuted.contains_rational(&rational(1, 2)));
}

/// A family along a curve: the paper's β(α) of S_{a3}, a line in the coefficients.
#[test]
fn a_curve_is_a_line_of_masks() {
    let set = [Substitution::parse("beta=(8*alpha-1)/(16*(1-alpha))").unwrap()];
    let family = Scheme::resolve_with("a3", 2, &set).unwrap();
    let found = range(&family, "alpha", 3);
    for value in [rational(3, 16), rational(1, 4), rational(1, 10)] {
        let member = at(&family, "alpha", &value);
        assert_eq!(
            found.proved.contains_rational(&value),
            exponent(&member).lower > rational(3, 1)
        );
    }
}

/// Families that cover their line several times, in part or with poles: every value has the verdict of its
/// member alone.
#[test]
fn a_line_may_be_covered_more_than_once() {
    let mut seen = [0; 2];
    for text in
        ["fourpoint(t^2)", "fourpoint(t^3-t/4)", "jspline(4*t/(1+t^2))", "jspline(1/(t^2-2))"]
    {
        let family = scheme(text);
        let range = range(&family, "t", 1);
        for k in -12..=12 {
            let t = rational(k, 8);
            let member = at(&family, "t", &t);
            let (verdict, _) =
                continuity_at("member", member.mask(), 1, &Sharpness::default()).unwrap();
            let expected = (verdict == PointVerdict::Proved, verdict == PointVerdict::Refuted);
            let found = (range.proved.contains_rational(&t), range.refuted.contains_rational(&t));
            assert_eq!(found, expected, "{text} at {t}");
            seen[0] += usize::from(found.0);
            seen[1] += usize::from(found.1);
        }
    }
    assert!(seen.iter().all(|&n| n > 20), "{seen:?}");
}

/// Every lemma of a certified exponent is needed: without any one of them the theorem is not proved.
#[test]
fn a_certified_exponent_needs_all_its_lemmas() {
    let whole = exponent(&scheme("dd6")).certificate.unwrap();
    assert!(verify(&whole).is_ok());
    assert_eq!(whole.lemmas.len(), 3);
    for dropped in 0..whole.lemmas.len() {
        let mut part = whole.clone();
        part.lemmas.remove(dropped);
        assert!(verify(&part).is_err(), "lemma {dropped} is not needed");
    }
}
