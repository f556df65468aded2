//! Maps of masks with a denominator: against ranges of one parameter, against single values.

use refinable_certificate::Terms;

use super::*;

/// A vertex rule with the weight `t`: C^1 on an interval, C^2 for `t = 1/8`.
fn rules(weight: &str) -> String {
    format!("even: [{weight}, 1-2*({weight}), {weight}]; odd: [1/2, 1/2]")
}

fn square(text: &str, continuity: usize) -> Map {
    map_of(text, continuity, [[(-1, 1), (1, 1)], [(-1, 1), (1, 1)]])
}

/// Where more powers divide than on a curve: the quintic B-spline `(1+z)^6/32`, C^4 with the exponent 5, at one point that is
/// on no line of a grid.
#[test]
fn a_single_point_is_solved_for() {
    let text = "[s*t, t/(1+t), 1/2-s*t, 1-2*t/(1+t), 1/2-s*t, t/(1+t), s*t]";
    let window = [[rational(0, 1), rational(1, 4)], [rational(0, 1), rational(1, 2)]];
    let point = [rational(13, 96), rational(3, 13)];
    let family = scheme(text);
    let landscape = landscape(text, family.mask(), &window, [2, 2]).unwrap();
    let highest = landscape.highest().unwrap();
    assert_eq!((&highest.parameters, &highest.regularity.lower), (&point, &rational(5, 1)));
    for (continuity, expected) in [(4, MapVerdict::Proved), (5, MapVerdict::Refuted)] {
        let map = map(text, family.mask(), continuity, &window, &Fineness::default()).unwrap();
        assert_eq!(map.verdict_at(&point), expected, "C^{continuity}");
        assert_eq!(map.verdict_at(&[rational(1, 8), rational(3, 13)]), MapVerdict::Refuted);
    }
}

/// `t = a/b`: the pairs of opposite wedges over an interval of `t` within `-1 .. 1` fill just as much of the square.
#[test]
fn wedges_on_both_sides_of_a_pole() {
    let one = scheme(&rules("t"));
    let t = Parameter::new("t");
    for n in 0..=1 {
        let range = continuity_range("t", one.mask(), &t, n, &Sharpness::default()).unwrap();
        let [interval] = &range.proved.intervals()[..] else { panic!("one interval") };
        let end = |bound: &refinable_reals::Bound| bound.number().unwrap().as_rational().cloned();
        let (low, high) = (end(&interval.lower).unwrap(), end(&interval.upper).unwrap());
        let map = square(&rules("a/b"), n);
        let mut decided = [0, 0];
        for point in points(&map.window(), 500) {
            let weight = &point[0] / &point[1];
            match map.verdict_at(&point) {
                MapVerdict::Proved => assert!(range.proved.contains_rational(&weight)),
                MapVerdict::Refuted => assert!(range.refuted.contains_rational(&weight)),
                MapVerdict::Undecided => continue,
            }
            decided[usize::from(!range.proved.contains_rational(&weight))] += 1;
        }
        assert!(
            decided[0] > 20 && decided[1] > 200 && decided[0] + decided[1] > 480,
            "{decided:?}"
        );
        let width = high - low;
        let [proved, ..] = map.areas();
        assert!(proved.upper <= width && proved.lower > &width * rational(98, 100), "{n}");
        for pole in [[rational(1, 3), rational(0, 1)], [rational(0, 1), rational(0, 1)]] {
            assert_eq!(map.verdict_at(&pole), MapVerdict::Undecided);
        }
    }
    let map = square(&rules("a/b"), 2);
    // The cubic B-spline wherever a/b = 1/8.
    for (point, expected) in [
        ([(1, 8), (1, 1)], MapVerdict::Proved),
        ([(-1, 16), (-1, 2)], MapVerdict::Proved),
        ([(0, 1), (0, 1)], MapVerdict::Undecided),
        ([(1, 7), (1, 1)], MapVerdict::Refuted),
        ([(1, 7), (0, 1)], MapVerdict::Undecided),
    ] {
        assert_eq!(map.verdict_at(&point.map(|(p, q)| rational(p, q))), expected, "{point:?}");
    }
}

/// Arity 3: C^0 for `-1/3 < a/b < 2/3` and C^1 for `0 < a/b < 1/3`, on the square the triangles above these slopes.
#[test]
fn wedges_of_a_ternary_family() {
    let text = "[a/b, 1/3, 2/3, 1-2*a/b, 2/3, 1/3, a/b]";
    let family = Scheme::resolve(text, 3).unwrap();
    let window = [[(-1, 1), (1, 1)], [(0, 1), (1, 1)]].map(|w| w.map(|(p, q)| rational(p, q)));
    for (n, exact) in [(0, rational(1, 2)), (1, rational(1, 6))] {
        let map = map(text, family.mask(), n, &window, &Fineness::default()).unwrap();
        let [proved, refuted, _] = map.areas();
        let rest = rational(2, 1) - &exact;
        for (area, exact) in [(proved, exact), (refuted, rest)] {
            assert!(area.lower <= exact && area.lower > exact * rational(97, 100), "C^{n}");
        }
    }
}

/// Degree 6 is read, degree 7 refused before the search.
#[test]
fn degrees_that_are_read() {
    let window = [[rational(0, 1), rational(1, 4)], [rational(1, 1), rational(2, 1)]];
    let ask = |power: usize| {
        let text = rules(&format!("a/b^{power}"));
        let coarse = Fineness { undecided: rational(1, 2), ..Fineness::default() };
        map(&text, scheme(&text).mask(), 1, &window, &coarse)
    };
    assert!(ask(6).is_ok());
    assert_eq!(ask(7).unwrap_err().code(), "budget");
}

/// Denominators of higher degree, with and without zeros in the box, and asymmetric masks.
#[test]
fn masks_with_denominators_agree_with_single_values() {
    for text in [
        "[b, a/(1+b^2), 1/2-b, 1-2*a/(1+b^2), 1/2-b, a/(1+b^2), b]",
        "[a/(1+2*b), b, 1-a/(1+2*b), 1-b]",
        "[a/(1/4-b^2), 1/2, 1-2*a/(1/4-b^2), 1/2, a/(1/4-b^2)]",
    ] {
        let map = square(text, 0);
        let [proved, refuted] = decided_alike(text, &map, 60);
        assert!(proved > 2 && refuted > 2 && proved + refuted > 50, "{text}: {proved}, {refuted}");
    }
}

/// A certificate does not hold with another denominator, a constant one, a chart or a section.
#[test]
fn changed_denominators_are_found() {
    let map = square(&rules("a/b"), 1).certificate;
    assert!(verify_map(&map).is_ok());
    assert_eq!(MapCertificate::read(map.to_json().as_bytes()).unwrap(), map);
    let fails = |change: &dyn Fn(&mut MapCertificate), because: &str| {
        let mut changed = map.clone();
        change(&mut changed);
        let error = verify_map(&changed).unwrap_err().to_string();
        assert!(error.contains(because), "{error}");
    };
    let term = |c, i, j| (Number(rational(c, 1)), i, j);
    let with =
        |terms: Terms| move |m: &mut MapCertificate| m.family.denominator = Some(terms.clone());
    fails(&with(vec![term(1, 1, 0)]), "a stencil does not sum to one");
    fails(&with(vec![term(-1, 0, 1)]), "a stencil does not sum to one");
    fails(&with(vec![]), "a denominator that is a constant");
    fails(&with(vec![term(1, 0, 0)]), "a denominator that is a constant");
    fails(&with(vec![term(1, 4, 3)]), "a polynomial of degree above 6");
    fails(&|m| m.family.denominator = None, "a stencil does not sum to one");
    let chart = map_of("a3", 1, [[(0, 1), (1, 4)], [(-1, 8), (1, 4)]]).certificate;
    fails(
        &|m| m.family.chart = chart.family.chart.clone(),
        "a chart of a family with a denominator",
    );
    let line = map_of("a3", 3, [[(0, 1), (1, 4)], [(-1, 8), (1, 4)]]).certificate;
    let mut beyond = square(&rules("a/b"), 3).certificate;
    beyond.sections = line.sections;
    let error = verify_map(&beyond).unwrap_err().to_string();
    assert!(error.contains("a line of masks with a denominator"), "{error}");
    let special = square(&rules("a/b"), 2).certificate;
    for (origin, because) in [
        ([(1, 4), (1, 1)], "a section is about other masks"),
        ([(1, 4), (0, 1)], "a section at a pole"),
        ([(0, 1), (0, 1)], "a section at a pole"),
    ] {
        let mut changed = special.clone();
        changed.sections[0].origin = origin.map(|(p, q)| Number(rational(p, q)));
        let error = verify_map(&changed).unwrap_err().to_string();
        assert!(error.contains(because), "{error}");
    }
    let mut same = special;
    same.sections[0].origin = [(-1, 16), (-1, 2)].map(|(p, q)| Number(rational(p, q)));
    assert!(verify_map(&same).is_ok());
}
