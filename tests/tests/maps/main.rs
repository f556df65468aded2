//! Maps over two parameters: against single values, against ranges along curves, against the paper's
//! conditions; and that no map holds when it is changed.

mod poles;

use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, decimal, rational,
};
use refinable_analysis::{
    Fineness, Locus, Map, MapVerdict, Plane, PointVerdict, Sharpness, Window, continuity_at,
    continuity_range, default_window, landscape, map,
};
use refinable_certificate::{
    CellVerdict, Ellipsoids, Expansion, MapCertificate, Node, Number, verify_map,
};
use refinable_reals::RealAlgebraic;
use refinable_scheme::{Scheme, Substitution};

fn scheme(text: &str) -> Scheme {
    Scheme::resolve(text, 2).unwrap()
}

fn window(ends: [[(i64, i64); 2]; 2]) -> Window {
    ends.map(|span| span.map(|(p, q)| rational(p, q)))
}

fn map_of(text: &str, continuity: usize, ends: [[(i64, i64); 2]; 2]) -> Map {
    let scheme = scheme(text);
    let fineness = Fineness::default();
    map(scheme.name(), scheme.mask(), continuity, &window(ends), &fineness).unwrap()
}

fn at(family: &Scheme, map: &Map, point: &[Rational; 2]) -> Scheme {
    let substitution = |(parameter, value): (&Parameter, &Rational)| {
        let value = ParameterFraction::from(ParameterPolynomial::constant(value.clone()));
        Substitution::new(parameter.clone(), value)
    };
    let substitutions = map.plane.parameters().iter().zip(point).map(substitution);
    family.with(&substitutions.collect::<Vec<_>>()).unwrap()
}

/// Rational points of the box without a pattern.
fn points(window: &Window, count: u64) -> impl Iterator<Item = [Rational; 2]> + '_ {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as i64
    };
    (0..count).map(move |_| {
        [0, 1].map(|i| {
            let [low, high] = &window[i];
            low + (high - low) * rational(next(), 1 << 24)
        })
    })
}

/// How many points are proved and refuted, each of them in the same way on its own.
fn decided_alike(text: &str, map: &Map, count: u64) -> [u64; 2] {
    let family = scheme(text);
    let window = map.window();
    let mut decided = [0, 0];
    for point in points(&window, count) {
        let expected = match map.verdict_at(&point) {
            MapVerdict::Undecided => continue,
            MapVerdict::Proved => PointVerdict::Proved,
            MapVerdict::Refuted => PointVerdict::Refuted,
        };
        decided[usize::from(expected == PointVerdict::Refuted)] += 1;
        let single = at(&family, map, &point);
        let sharpness = Sharpness::default();
        let (found, _) = continuity_at(text, single.mask(), map.continuity(), &sharpness).unwrap();
        assert_eq!(found, expected, "{text} C^{} at {point:?}", map.continuity());
    }
    decided
}

/// Every decided point is decided in the same way on its own, and most are decided.
fn agrees_with_single_values(text: &str, map: &Map, count: u64) {
    let [proved, refuted] = decided_alike(text, map, count);
    assert!(proved + refuted > count * 9 / 10, "{text}: {proved} proved, {refuted} refuted");
    assert!(proved > count / 20 && refuted > count / 20, "{text}: {proved}, {refuted}");
}

/// What is undecided against what is proved.
fn undecided_part(map: &Map) -> Rational {
    let [proved, _, undecided] = map.areas();
    &undecided.upper / &proved.lower
}

fn three(continuity: usize) -> Map {
    map_of("a3", continuity, [[(-3, 8), (1, 1)], [(-7, 8), (9, 4)]])
}

#[test]
fn a3_converges_where_single_values_say_so() {
    let map = three(0);
    agrees_with_single_values("a3", &map, 200);
    assert!(undecided_part(&map) < rational(1, 100), "{}", undecided_part(&map));
    // The pieces make up the box: 11/8 times 25/8.
    let areas = map.areas();
    let sum = |f: fn(&refinable_analysis::Area) -> &Rational| -> Rational {
        areas.iter().map(f).cloned().sum()
    };
    let (lower, upper) = (sum(|a| &a.lower), sum(|a| &a.upper));
    assert!(lower <= rational(275, 64) && rational(275, 64) <= upper);
    assert!(upper - lower < rational(1, 1_000_000_000));
}

#[test]
fn a3_is_c1_where_single_values_say_so() {
    let map = map_of("a3", 1, [[(0, 1), (1, 2)], [(-1, 4), (1, 4)]]);
    agrees_with_single_values("a3", &map, 200);
    assert!(undecided_part(&map) < rational(1, 100), "{}", undecided_part(&map));
}

/// The ends of the ranges along the paper's curve are not inside of pieces that say otherwise.
#[test]
fn sections_agree_with_ranges_along_the_curve() {
    let curve = "beta=(8*alpha-1)/(16*(1-alpha))";
    let family = scheme("a3");
    let substitution = Substitution::parse(curve).unwrap();
    let along = family.with(std::slice::from_ref(&substitution)).unwrap();
    let alpha = Parameter::new("alpha");
    let map = three(0);
    let range = continuity_range("a3", along.mask(), &alpha, 0, &Sharpness::default()).unwrap();
    let mut decided = 0;
    for k in -23..64 {
        let a = rational(k, 64);
        let beta =
            (rational(8, 1) * &a - rational(1, 1)) / (rational(16, 1) * (rational(1, 1) - &a));
        let verdict = map.verdict_at(&[a.clone(), beta.clone()]);
        if beta < rational(-7, 8) || beta > rational(9, 4) || verdict == MapVerdict::Undecided {
            continue;
        }
        decided += 1;
        let x = RealAlgebraic::from(a.clone());
        assert_eq!(range.proved.contains(&x), verdict == MapVerdict::Proved, "{a}");
        assert_eq!(range.refuted.contains(&x), verdict == MapVerdict::Refuted, "{a}");
    }
    assert!(decided > 50, "{decided}");
}

/// Where `σ^(n+1)` divides on a line only, the map is refuted off it and has the range on it.
#[test]
fn beyond_the_order_only_a_line_is_left() {
    let map = map_of("a3", 3, [[(0, 1), (1, 2)], [(-1, 4), (1, 4)]]);
    assert!(map.cells.iter().all(|c| c.verdict == CellVerdict::Refuted { if_stable: true }));
    let [section] = &map.certificate.sections[..] else { panic!("one line") };
    // β(1 - α) = (8α - 1)/16, and C^3 for 1/8 < α < 3/8.
    assert_eq!(section.origin, [0, -1].map(|p| Number(rational(p, 16))));
    assert_eq!(section.direction, [(1, 1), (1, 2)].map(|(p, q)| Number(rational(p, q))));
    let refinable_certificate::Conclusion::Continuity { proved, .. } =
        &section.certificate.conclusion
    else {
        panic!("about continuity")
    };
    assert_eq!(refinable_analysis::region_of(proved).display("t"), "(1/8, 3/8)");
    let mut changed = map.certificate.clone();
    changed.sections[0].certificate.family.lowest = i64::MAX;
    assert!(verify_map(&changed).is_err());
    changed.sections[0].certificate.family.lowest = section.certificate.family.lowest;
    changed.sections[0].origin[0] = Number(rational(1, 7));
    assert!(verify_map(&changed).is_err());
    // β = (8α - 1)/(16 (1 - α)) is 1/26 at α = 3/16, and -3/62 at α = 1/32.
    for (point, expected) in [
        ([(3, 16), (1, 26)], MapVerdict::Proved),
        ([(1, 32), (-3, 62)], MapVerdict::Refuted),
        ([(3, 16), (1, 27)], MapVerdict::Refuted),
    ] {
        assert_eq!(map.verdict_at(&point.map(|(p, q)| rational(p, q))), expected, "{point:?}");
    }
}

/// Affine in both parameters, without a chart, and quadratic ones, of which control points decide.
#[test]
fn any_polynomial_mask_has_a_map() {
    for (text, affine) in [
        ("[b, a, 1/2-b, 1-2*a, 1/2-b, a, b]", true),
        ("[b, a^2, 1/2-b, 1-2*a^2, 1/2-b, a^2, b]", false),
    ] {
        let family = scheme(text);
        let plane = Plane::new(text, family.mask()).unwrap();
        assert_eq!((plane.is_affine(), plane.factor().is_none()), (affine, true), "{text}");
        let map = map_of(text, 0, [[(-1, 1), (1, 1)], [(-1, 1), (3, 2)]]);
        agrees_with_single_values(text, &map, 60);
    }
}

/// The conditions that the paper prints, Theorem on `S_{a3}`, `S_{a5}` and `S_{a7}`, in `(α, b)`.
#[test]
fn level_one_is_what_the_paper_prints() {
    let r = rational;
    let abs = |x: Rational| if x < Rational::zero() { -x } else { x };
    let max = |a: Rational, b: Rational| if a > b { a } else { b };
    let three = |a: &Rational, b: &Rational| {
        let first = abs(r(2, 1) * a - r(4, 1) * b) * r(2, 1);
        let second = abs(r(2, 1) * b) * r(2, 1) + abs(r(1, 1) + r(4, 1) * b - r(4, 1) * a);
        max(first, second)
    };
    let five = |a: &Rational, b: &Rational| {
        let first =
            abs(b.clone()) * r(16, 1) + abs(r(1, 2) - r(56, 1) * b - r(32, 1) * a) * r(2, 1);
        let second =
            abs(r(32, 1) * b + r(8, 1) * a) * r(2, 1) + abs(r(2, 1) - r(48, 1) * a - r(64, 1) * b);
        max(first, second)
    };
    type Condition<'a> = &'a dyn Fn(&Rational, &Rational) -> Rational;
    for (text, n, condition) in [("a3", 1, &three as Condition), ("a5", 3, &five as Condition)] {
        let family = scheme(text);
        let polygon = Plane::new(text, family.mask()).unwrap().level_one(n).unwrap();
        let corners = polygon.points();
        // At the corners the printed norm is one, and less in the middle of each edge or as much.
        for [a, b] in &corners {
            assert_eq!(condition(a, b), r(1, 1), "{text}");
        }
        for ([a, b], [c, d]) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            assert_eq!(condition(&((a + c) / r(2, 1)), &((b + d) / r(2, 1))), r(1, 1), "{text}");
        }
    }
    // The printed C^5 condition of S_{a7} is never satisfied, but the norm at level one is below one
    // nowhere either.
    let seven = scheme("a7");
    assert!(Plane::new("a7", seven.mask()).unwrap().level_one(5).is_none());
}

/// With `ω³ = 1` this mask has at `-ω` the value `4x + 2y - 4/3`: where it vanishes the shifts are not stable, as `-1` is
/// its own cube, and nothing is refuted that needs it; neither where the order rises, `y = 0`.
#[test]
fn unstable_members_of_a_ternary_family() {
    let text = "[x, 1/3+y, 2/3-y, 1-2x, 2/3-y, 1/3+y, x]";
    let family = Scheme::resolve(text, 3).unwrap();
    let window = window([[(0, 1), (1, 2)], [(1, 20), (1, 2)]]);
    let map = map(text, family.mask(), 1, &window, &Fineness::default()).unwrap();
    for (x, y, expected) in [
        ((1, 4), (1, 6), MapVerdict::Undecided),
        ((1, 6), (1, 3), MapVerdict::Undecided),
        ((1, 4), (1, 5), MapVerdict::Refuted),
        ((1, 6), (1, 4), MapVerdict::Refuted),
    ] {
        let point = [x, y].map(|(p, q)| rational(p, q));
        assert_eq!(map.verdict_at(&point), expected, "{point:?}");
    }
    // Where the order rises all contrasts vanish at one, which does no harm: C^2 needs one power more than there is.
    let higher = [[(0, 1), (1, 2)], [(-1, 4), (1, 4)]].map(|w| w.map(|(p, q)| rational(p, q)));
    let higher = refinable_analysis::map(text, family.mask(), 2, &higher, &Fineness::default());
    let higher = higher.unwrap();
    for (x, expected) in [((1, 4), MapVerdict::Refuted), ((1, 3), MapVerdict::Undecided)] {
        let point = [x, (0, 1)].map(|(p, q)| rational(p, q));
        assert_eq!(higher.verdict_at(&point), expected, "{point:?}");
    }
    for (x, y) in [((1, 4), (1, 6)), ((1, 4), (0, 1))] {
        let mut changed = map.certificate.clone();
        changed.stable_at = Some([x, y].map(|(p, q)| Number(rational(p, q))));
        let error = verify_map(&changed).unwrap_err().to_string();
        assert!(error.contains("not shown to be stable"), "{error}");
    }
}

/// Every change of a number that a proof rests on is found.
#[test]
fn changed_maps_do_not_hold() {
    let map = map_of("a3", 1, [[(0, 1), (1, 4)], [(-1, 8), (1, 4)]]).certificate;
    assert!(verify_map(&map).is_ok());
    let read = MapCertificate::read(map.to_json().as_bytes()).unwrap();
    assert_eq!(read, map);
    let fails = |change: &dyn Fn(&mut MapCertificate)| {
        let mut changed = map.clone();
        change(&mut changed);
        assert!(changed != map && verify_map(&changed).is_err());
    };
    fails(&|m| m.continuity = 2);
    fails(&|m| m.family.order = 3);
    fails(&|m| m.family.mask[0][0].0 = Number(rational(1, 3)));
    fails(&|m| m.family.chart.as_mut().unwrap().factor[0] = Number(rational(2, 1)));
    fails(&|m| m.family.chart = None);
    fails(&|m| m.window[0][1] = Number(rational(-1, 1)));
    fails(&|m| m.window[0][1] = Number(rational(2, 1)));
    fails(&|m| m.stable_at = None);
    fails(&|m| m.stable_at = Some([(1, 4), (0, 1)].map(|(p, q)| Number(rational(p, q)))));
    fails(&|m| m.roots = vec![1]);
    fails(&|m| m.roots = vec![0, 0]);
    fails(&|m| {
        m.nodes.pop();
    });
    fails(&|m| m.nodes.push(Node::Undecided));
    let places = |f: fn(&Node) -> bool| -> Vec<usize> {
        (0..map.nodes.len()).filter(|&i| f(&map.nodes[i])).collect()
    };
    for i in places(|n| matches!(n, Node::Cut { .. })) {
        fails(&|m| {
            if let Node::Cut { below, above, .. } = &mut m.nodes[i] {
                *below = *above;
            }
        });
        fails(&|m| {
            if let Node::Cut { line, .. } = &mut m.nodes[i] {
                line[2] = Number(rational(1 << 30, 1));
            }
        });
    }
    let far = Rational::from_i64(2).power(600);
    fails(&|m| m.window[1][1] = Number(far.clone()));
    // The node that is one too many is seen before the node that nothing leads to.
    let with_nodes = |count| {
        let mut changed = map.clone();
        changed.nodes.resize(count, Node::Undecided);
        verify_map(&changed).unwrap_err().to_string()
    };
    assert!(with_nodes(200_000).contains("a node that is not reached"));
    assert!(with_nodes(200_001).contains("more than 200000 nodes"));
    // Bounded effort, and no panic, whatever is asked for.
    fails(&|m| m.continuity = usize::MAX);
    let mut absurd = map.clone();
    absurd.continuity = usize::MAX;
    absurd.nodes = vec![Node::Indivisible];
    assert!(verify_map(&absurd).is_ok(), "nothing with stable shifts is so smooth");
    fails(&|m| {
        let denominators = (1..1000).map(|k| Rational::from_i64(2).power(k) + rational(1, 1));
        let terms = denominators.map(|d| (Number(d.recip()), 0, 0)).collect::<Vec<_>>();
        m.family.mask[0].extend(terms.into_iter().take(90));
        m.family.mask[1] = m.family.mask[0].clone();
    });
    for word in ["", "2", "0000000000000", "001011010111"] {
        fails(&|m| {
            let Some(Node::Word(w)) = m.nodes.iter_mut().find(|n| matches!(n, Node::Word(_)))
            else {
                panic!("a word")
            };
            w.word = word.into();
        });
    }
    let words = places(|n| matches!(n, Node::Word(_)));
    let proofs = places(|n| matches!(n, Node::Ellipsoids(_)));
    assert!(words.len() > 5 && proofs.len() > 5);
    // What is proved is not refuted, and the other way round.
    fails(&|m| m.nodes[words[0]] = m.nodes[proofs[0]].clone());
    fails(&|m| m.nodes[proofs[0]] = m.nodes[words[0]].clone());
    fails(&|m| m.nodes[words[0]] = Node::Norm);
    fails(&|m| m.nodes[proofs[0]] = Node::Indivisible);
    for &i in &words {
        fails(&|m| {
            if let Node::Word(inequality) = &mut m.nodes[i] {
                inequality.radius = 1000;
            }
        });
        fails(&|m| {
            if let Node::Word(inequality) = &mut m.nodes[i] {
                inequality.block = 50;
            }
        });
    }
    for &i in proofs.iter().take(10) {
        let fails = |change: &dyn Fn(&mut Ellipsoids)| {
            fails(&|m| {
                if let Node::Ellipsoids(ellipsoids) = &mut m.nodes[i] {
                    change(ellipsoids);
                }
            });
        };
        fails(&|e| e.corners[0][0][0] *= -1);
        fails(&|e| e.corners[0][0][0] = 1 << 35);
        fails(&|e| e.corners[0][0][1] = 1 << 40);
        fails(&|e| e.corners[0][0][0] = i64::MIN);
        fails(&|e| e.corners[0][0].iter_mut().for_each(|x| *x = 0));
        fails(&|e| e.corners.iter_mut().flatten().flatten().for_each(|x| *x = -*x));
        fails(&|e| e.memory += 1);
        fails(&|e| e.memory = u32::MAX);
        fails(&|e| drop(e.corners.pop()));
        fails(&|e| drop(e.corners[0].pop()));
        fails(&|e| e.corners[0][0].truncate(1));
    }
}

/// In a corner of the map of C^5 of `a7` a complex pair of a product of eight rows is large: no inequality
/// of a low degree tells, but quadratic forms do. And memory is needed beside it.
#[test]
fn complex_pairs_refute_and_are_met() {
    let window = [[(79, 5000), (83, 5000)], [(3, 500), (7, 1000)]];
    let family = scheme("a7");
    let fineness = Fineness { undecided: rational(1, 50), nodes: 1500 };
    let map = map("a7", family.mask(), 5, &self::window(window), &fineness).unwrap();
    assert!(undecided_part(&map) < rational(1, 5), "{}", undecided_part(&map));
    agrees_with_single_values("a7", &map, 20);
    let certificate = &map.certificate;
    let expands = |node: &Node| matches!(node, Node::Expansion(_));
    let remembers = |node: &Node| matches!(node, Node::Ellipsoids(e) if e.memory > 0);
    assert!(certificate.nodes.iter().any(remembers));
    let at = certificate.nodes.iter().position(expands).unwrap();
    let fails = |change: &dyn Fn(&mut Expansion)| {
        let mut changed = certificate.clone();
        let Node::Expansion(expansion) = &mut changed.nodes[at] else { panic!("an expansion") };
        change(expansion);
        assert!(changed != *certificate && verify_map(&changed).is_err());
    };
    fails(&|e| e.vector.iter_mut().for_each(|x| *x = 0));
    fails(&|e| e.vector[0] = i64::MIN);
    fails(&|e| e.vector.truncate(1));
    fails(&|e| e.corners[0][0][0] += 1 << 35);
    fails(&|e| e.corners.iter_mut().flatten().flatten().for_each(|x| *x = -*x));
    fails(&|e| drop(e.corners.pop()));
    // What is positive at the vector is no proof, nor is what the letters do not shrink.
    fails(&|e| e.corners.iter_mut().for_each(|forms| forms[0][0] += 1 << 30));
    // A form that is negative everywhere passes the test of the vector only.
    let proved = certificate.nodes.iter().position(|node| matches!(node, Node::Ellipsoids(_)));
    let proved = proved.unwrap();
    let size = certificate_corners(&map, proved);
    let dimension = 8;
    let negative = |i: usize, j: usize| if i == j { -1_000_000 } else { 0 };
    let triangle: Vec<i64> =
        (0..dimension).flat_map(|i| (i..dimension).map(move |j| negative(i, j))).collect();
    let vector = (0..dimension as i64).map(|i| i64::from(i == 0)).collect();
    let corners = vec![vec![triangle]; size];
    for word in ["0", "1"] {
        let mut changed = certificate.clone();
        let (vector, corners) = (Clone::clone(&vector), corners.clone());
        changed.nodes[proved] = Node::Expansion(Expansion { word: word.into(), vector, corners });
        let reason = verify_map(&changed).unwrap_err().to_string();
        assert!(reason.contains("mapped below"), "{reason}");
    }
    fails(&|e| e.word.clear());
    fails(&|e| e.word = "4".into());
    fails(&|e| e.word.push('0'));
}

/// Matrices of one row: those of the ternary `[a, b, 1, 1-a, 1-b]` are `a`, `b - a` and `1 - b`. `Q = 1` shows that
/// they shrink where all are small; where all are large `Q = -1` is mapped below itself by each of them, which
/// proves that they grow, and not that they shrink.
#[test]
fn forms_of_one_row_by_hand() {
    let family = Scheme::resolve("[a, b, 1, 1-a, 1-b]", 3).unwrap();
    let fineness = Fineness { nodes: 1, ..Fineness::default() };
    let claim = |window: [[(i64, i64); 2]; 2], node: Node| {
        let made = map("by hand", family.mask(), 0, &self::window(window), &fineness).unwrap();
        let mut certificate = made.certificate;
        (certificate.roots, certificate.nodes) = (vec![0], vec![node]);
        verify_map(&certificate).map(|cells| cells[0].verdict).map_err(|e| e.to_string())
    };
    let small = [[(2, 5), (3, 5)], [(2, 5), (3, 5)]];
    let large = [[(5, 1), (6, 1)], [(-6, 1), (-5, 1)]];
    let ellipsoids =
        |q| Node::Ellipsoids(Ellipsoids { memory: 0, corners: vec![vec![vec![q]]; 4] });
    let expansion = |q| {
        let corners = vec![vec![vec![q]]; 4];
        Node::Expansion(Expansion { word: "1".into(), vector: vec![1], corners })
    };
    assert_eq!(claim(small, ellipsoids(1)), Ok(CellVerdict::Proved));
    assert_eq!(claim(large, expansion(-1)), Ok(CellVerdict::Refuted { if_stable: false }));
    assert!(claim(large, ellipsoids(-1)).unwrap_err().contains("not positive definite"));
    assert!(claim(large, ellipsoids(1)).unwrap_err().contains("mapped below"));
    assert!(claim(small, expansion(-1)).unwrap_err().contains("mapped below"));
    assert!(claim(small, expansion(1)).unwrap_err().contains("not negative"));
}

fn certificate_corners(map: &Map, node: usize) -> usize {
    map.cells.iter().find(|cell| cell.node == node).unwrap().polygon.points().len()
}

/// The smoothest `S_{a3}` is the quintic B-spline, at one point; on the line where σ³ divides, the next.
#[test]
fn the_smoothest_a3_is_a_b_spline() {
    let family = scheme("a3");
    let window = window([[(-3, 8), (1, 1)], [(-7, 8), (9, 4)]]);
    let found = landscape("a3", family.mask(), &window, [12, 9]).unwrap();
    let at = |locus: fn(&Locus) -> bool| found.summits.iter().find(|s| locus(&s.locus)).unwrap();
    let point = at(|l| *l == Locus::Point);
    assert_eq!(point.parameters, [rational(3, 16), rational(1, 26)]);
    let values = found.plane.parameters().iter().zip(&point.parameters);
    let substitutions = values.map(|(p, x)| {
        let value = ParameterFraction::from(ParameterPolynomial::constant(x.clone()));
        Substitution::new(p.clone(), value)
    });
    let member = family.with(&substitutions.collect::<Vec<_>>()).unwrap();
    let spline = scheme("bspline5");
    assert_eq!(member.mask().numerator().coefficients(), spline.mask().numerator().coefficients());
    assert_eq!(point.regularity.lower, rational(5, 1));
    assert_eq!(point.regularity.upper, Some(rational(5, 1)));
    assert_eq!(found.highest().unwrap().parameters, point.parameters);
    let line = at(|l| matches!(l, Locus::Line(..)));
    assert!(line.regularity.lower >= rational(4, 1) && line.regularity.divided_order > 3);
    let plane = at(|l| *l == Locus::Plane);
    assert!(plane.regularity.lower >= rational(2, 1));
    // No word of the picture decays faster than what is proved at the summit allows.
    let highest = found.exponents.iter().max().unwrap();
    assert_eq!(found.exponents.len(), 108);
    let upper = plane.regularity.upper.as_ref().unwrap();
    assert!(*highest <= upper + rational(1, 100), "{highest}");
}

/// The same with names in the other order: the plane takes `a` for `y`, masks take it first.
#[test]
fn names_do_not_change_the_smoothest() {
    let parameter =
        |name: &str| ParameterFraction::from(ParameterPolynomial::parameter(&Parameter::new(name)));
    let renamed = [("alpha", "b"), ("beta", "a")]
        .map(|(old, new)| Substitution::new(Parameter::new(old), parameter(new)));
    let family = scheme("a3").with(&renamed).unwrap();
    let window = window([[(0, 1), (1, 4)], [(0, 1), (1, 8)]]);
    let found = landscape("a3", family.mask(), &window, [2, 2]).unwrap();
    assert_eq!(found.plane.parameters().each_ref().map(Parameter::name), ["b", "a"]);
    let highest = found.highest().unwrap();
    assert_eq!(highest.parameters, [rational(3, 16), rational(1, 26)]);
    assert_eq!(highest.regularity.lower, rational(5, 1));
}

/// Pieces have straight edges in `(x, y)`, but their areas are meant in the parameters.
#[test]
fn areas_make_up_the_box_of_the_parameters() {
    let map = map_of("a3", 1, [[(0, 1), (1, 2)], [(0, 1), (1, 4)]]);
    let [proved, refuted, undecided] = map.areas();
    let total = &proved.lower + &refuted.lower + &undecided.lower;
    assert_eq!(decimal(&total, 12), "0.125");
}

/// Every map of the paper's families in its default box, at 200 points each.
#[test]
fn all_maps_agree_with_single_values() {
    for (text, orders) in [("a3", 0..=3), ("a5", 0..=5), ("a7", 0..=6)] {
        let family = scheme(text);
        let order = *orders.end();
        let fineness = Fineness::default();
        let window = default_window(text, family.mask(), order).unwrap();
        std::thread::scope(|scope| {
            for parity in [0, 1] {
                let (family, window, fineness) = (&family, &window, &fineness);
                let orders = orders.clone().filter(move |n| n % 2 == parity);
                scope.spawn(move || {
                    for n in orders {
                        let map = map(text, family.mask(), n, window, fineness).unwrap();
                        let [proved, refuted] = decided_alike(text, &map, 200);
                        println!("{text} C^{n}: {proved} proved, {refuted} refuted");
                        assert!(proved + refuted > 180, "{text} C^{n}: {proved}, {refuted}");
                    }
                });
            }
        });
    }
}
