//! Refinement against the double sum of its definition, against itself in other orders, and against closed
//! forms of its limits.

use proptest::prelude::*;
use refinable_algebra::{Rational, Ring, binomial, rational};
use refinable_refine::{
    BasicLimit, Coordinate, Ends, Interproximate, Net, Polygon, Surface, Tensions, Weights, refine,
    refine_net, refine_to,
};
use refinable_scheme::{Normalised, Scheme, Substitution};

fn mask(text: &str, arity: usize) -> Normalised {
    Scheme::resolve(text, arity).unwrap().mask().clone()
}

fn weights<T: Coordinate>(text: &str, arity: usize) -> Weights<T> {
    Weights::new(&mask(text, arity)).unwrap()
}

/// The interpolatory four-point scheme of arity 3: Hassan, Ivrissimtzis, Dodgson and Sabin 2002, at μ = 1/11.
const TERNARY: &str = "1/99*[-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4] @ -5";

/// Masks of arity 2, 3 and 4, symmetric or not, with gaps and with supports on one side.
const MASKS: [(&str, usize); 8] = [
    ("dd6", 2),
    ("bspline2", 2),
    ("[1/3, 1/4, 2/3, 3/4] @ 5", 2),
    ("[1/2, 0, 1/2, 1] @ -9", 2),
    (TERNARY, 3),
    ("1/27*[1, 4, 10, 16, 19, 16, 10, 4, 1] @ -4", 3),
    ("[1/4, 1/2, 1/4, 0, 3/4, 1/2, 3/4, 1] @ -2", 4),
    ("[1, 1]", 2),
];

/// `f'_i = Σ_j a_{i-mj} f_j`, of a sequence that is given by a function.
fn double_sum(mask: &Normalised, f: &dyn Fn(i64) -> Rational, i: i64) -> Rational {
    let m = mask.arity() as i64;
    let terms = mask.coefficients().filter(|(k, _)| (i - k).rem_euclid(m) == 0);
    terms.map(|(k, a)| a.as_constant().unwrap() * f((i - k).div_euclid(m))).sum()
}

fn numbers(count: usize) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec((-50_i64..50, 1_i64..9).prop_map(|(p, q)| rational(p, q)), count)
}

fn floats(values: &[Rational]) -> Vec<f64> {
    values.iter().map(f64::from_rational).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn refinement_is_the_double_sum(which in 0..MASKS.len(), values in numbers(14), levels in 1_u32..4) {
        let (text, arity) = MASKS[which];
        let scheme = Scheme::resolve(text, arity).unwrap();
        let rule = Weights::<Rational>::new(scheme.mask()).unwrap();
        let n = values.len() as i64;
        let periodic = |i: i64| values[i.rem_euclid(n) as usize].clone();
        let closed = Polygon::new(1, values.clone(), true).unwrap();
        let once = refine(&closed, &[&rule], Ends::Trim).unwrap();
        for (i, found) in (0..).zip(once.values()) {
            prop_assert_eq!(found, &double_sum(scheme.mask(), &periodic, i));
        }
        // Many levels are one level many times, exactly in both kinds of numbers.
        let chain = vec![&rule; levels as usize];
        let float = Weights::<f64>::new(scheme.mask()).unwrap();
        for closed in [true, false] {
            let mut step = Polygon::new(2, values.clone(), closed).unwrap();
            let mut float_step = Polygon::new(2, floats(&values), closed).unwrap();
            let at_once = refine(&step, &chain, Ends::Trim);
            let float_at_once = refine(&float_step, &vec![&float; levels as usize], Ends::Trim);
            let Ok(at_once) = at_once else { prop_assert!(float_at_once.is_err()); continue };
            for _ in 0..levels {
                step = refine(&step, &[&rule], Ends::Trim).unwrap();
                float_step = refine(&float_step, &[&float], Ends::Trim).unwrap();
            }
            prop_assert_eq!(&at_once, &step);
            let float_at_once = float_at_once.unwrap();
            prop_assert_eq!(&float_at_once, &float_step);
            for (x, y) in at_once.values().iter().zip(float_at_once.values()) {
                prop_assert!((f64::from_rational(x) - y).abs() < 1e-9);
            }
        }
    }

    /// What is left by trimming is the longest run of points that the old ones determine.
    #[test]
    fn trimmed_are_the_points_that_are_determined(which in 0..MASKS.len(), values in numbers(12)) {
        let (text, arity) = MASKS[which];
        let scheme = Scheme::resolve(text, arity).unwrap();
        let rule = Weights::<Rational>::new(scheme.mask()).unwrap();
        let n = values.len() as i64;
        let (m, reach) = (arity as i64, 40);
        let determined = |i: &i64| {
            let mut used = scheme.mask().coefficients().filter(|(k, a)| {
                (i - k).rem_euclid(m) == 0 && a.as_constant().unwrap() != rational(0, 1)
            });
            used.all(|(k, _)| (0..n).contains(&(i - k).div_euclid(m)))
        };
        let indices: Vec<i64> = (-reach..m * n + reach).collect();
        let runs = indices.split(|i| !determined(i));
        let longest = runs.max_by_key(|run| run.len()).unwrap();
        let at = |j: i64| values[j as usize].clone();
        let expected: Vec<Rational> =
            longest.iter().map(|&i| double_sum(scheme.mask(), &at, i)).collect();
        let open = Polygon::new(1, values.clone(), false).unwrap();
        let found = refine(&open, &[&rule], Ends::Trim).unwrap();
        prop_assert_eq!(found.values(), &expected[..]);
    }

    #[test]
    fn tensor_products_in_any_order(values in numbers(60), first in 0..4_usize, second in 0..4_usize, closed in any::<[bool; 2]>()) {
        let names = ["bspline2", "bspline3", "[1/2, 1, 1/2]", "dd4"];
        let rules = [first, second].map(|k| weights::<Rational>(names[k], 2));
        let net = Net::new(1, 6, values.clone(), closed).unwrap();
        let ends = [Ends::Reflect; 2];
        let chains = rules.each_ref().map(|rule| [rule, rule]);
        let both = refine_net(&net, [&chains[0], &chains[1]], ends).unwrap();
        let along = refine_net(&net, [&[], &chains[1]], ends).unwrap();
        let across = refine_net(&net, [&chains[0], &[]], ends).unwrap();
        prop_assert_eq!(&both, &refine_net(&along, [&chains[0], &[]], ends).unwrap());
        prop_assert_eq!(&both, &refine_net(&across, [&[], &chains[1]], ends).unwrap());
        prop_assert_eq!(both.transposed(), refine_net(&net.transposed(), [&chains[1], &chains[0]], ends).unwrap());
        // Each row of `along` is a curve of its own.
        for i in 0..net.rows() {
            let row = Polygon::new(1, (0..6).map(|j| net.point(i, j)[0].clone()).collect(), closed[1]).unwrap();
            let row = refine(&row, &chains[1], Ends::Reflect).unwrap();
            prop_assert_eq!(row.values(), &along.values()[i * along.columns()..][..along.columns()]);
        }
    }

    /// With the same member everywhere an interproximate scheme is that member; points that a vertex rule
    /// keeps stay on every level.
    #[test]
    fn interproximate_curves(values in numbers(16), kept in prop::collection::vec(any::<bool>(), 8), closed in any::<bool>()) {
        let family = Scheme::resolve("a3", 2).unwrap();
        let member = |set: [&str; 2]| {
            let sets = set.map(|s| Substitution::parse(s).unwrap());
            Weights::<Rational>::new(family.with(&sets).unwrap().mask()).unwrap()
        };
        let members = vec![member(["alpha=1/8", "beta=0"]), member(["alpha=0", "beta=-1/20"])];
        let polygon = Polygon::new(2, values, closed).unwrap();
        let scheme = Interproximate::new(members.clone(), 0).unwrap();
        for (k, stationary) in members.iter().enumerate() {
            let scheme = Interproximate::new(members.clone(), k).unwrap();
            let same = Tensions::of_vertices(vec![k; 8]);
            let found = scheme.refine(&polygon, &same, 3, Ends::Reflect).unwrap();
            prop_assert_eq!(found, refine(&polygon, &[stationary; 3], Ends::Reflect).unwrap());
        }
        let tags: Vec<usize> = kept.iter().map(|&k| usize::from(k)).collect();
        for levels in 0..4 {
            let tensions = Tensions::of_vertices(tags.clone());
            let found = scheme.refine(&polygon, &tensions, levels, Ends::Reflect).unwrap();
            for (i, _) in kept.iter().enumerate().filter(|(_, kept)| **kept) {
                let at = i << levels;
                prop_assert_eq!(found.points().nth(at), polygon.points().nth(i));
            }
        }
        // The same scheme backwards: vertices change places, and so do edges.
        let mut backwards: Vec<Rational> = polygon.points().rev_points();
        backwards.truncate(16);
        let reversed = Polygon::new(2, backwards, closed).unwrap();
        let mut tensions = Tensions::of_vertices(tags.clone());
        tensions.vertices.reverse();
        tensions.edges.reverse();
        tensions.edges.rotate_left(1);
        let there = scheme.refine(&polygon, &Tensions::of_vertices(tags), 1, Ends::Reflect).unwrap();
        let back = scheme.refine(&reversed, &tensions, 1, Ends::Reflect).unwrap();
        let mut back = back.points().rev_points();
        if closed {
            // The vertex 0 and the edge after it are the last of the reversed polygon.
            back.rotate_left(2);
        }
        prop_assert_eq!(there.values(), &back[..]);
    }
}

trait Backwards {
    fn rev_points(self) -> Vec<Rational>;
}

impl<'a, I: ExactSizeIterator<Item = &'a [Rational]>> Backwards for I {
    fn rev_points(self) -> Vec<Rational> {
        let points: Vec<&[Rational]> = self.collect();
        points.into_iter().rev().flatten().cloned().collect()
    }
}

/// Blocks begin and end anywhere, and so do the threads.
#[test]
fn blocks_and_threads_do_not_show() {
    let family = Scheme::resolve("a5", 2).unwrap();
    let sets = ["alpha=1/16", "beta=-1/48"].map(|s| Substitution::parse(s).unwrap());
    let rule = Weights::<f64>::new(family.with(&sets).unwrap().mask()).unwrap();
    let wave = |i: usize| ((i * i) % 101) as f64 / 7.0;
    for closed in [true, false] {
        let polygon = Polygon::new(3, (0..3 * 211).map(wave).collect(), closed).unwrap();
        let net = Net::new(3, 19, (0..3 * 19 * 11).map(wave).collect(), [closed, true]).unwrap();
        let with_threads = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let curve = refine(&polygon, &[&rule; 7], Ends::Reflect).unwrap();
                let chain = [&rule; 5];
                (curve, refine_net(&net, [&chain, &chain], [Ends::Reflect; 2]).unwrap())
            })
        };
        let (curve, surface) = with_threads(1);
        assert_eq!((&curve, &surface), (&with_threads(3).0, &with_threads(3).1));
        // Level by level every point is in one block and in one tile or another.
        let step = |p: Polygon<f64>| refine(&p, &[&rule], Ends::Trim).unwrap();
        if closed {
            assert_eq!((0..7).fold(polygon.clone(), |p, _| step(p)), curve);
        }
        // Rows that are handed out one by one are those of the whole.
        let chain = [&rule; 5];
        let made = Surface::new(&net, [&chain, &chain], [Ends::Reflect; 2]).unwrap();
        let mut rows = Vec::new();
        made.each_row(|row| -> Result<(), ()> {
            rows.extend_from_slice(row);
            Ok(())
        })
        .unwrap();
        assert_eq!(rows, surface.values());
        assert_eq!(rows.len(), 3 * made.rows() * made.columns());
    }
}

/// `B_d(x) = Σ_k (-1)^k C(d+1, k) (x - k)_+^d / d!`, and its derivatives.
fn b_spline(degree: u32, x: &Rational, order: u32) -> Rational {
    let power = degree - order;
    let terms = (0..=degree + 1).map(|k| {
        let at = x - rational(i64::from(k), 1);
        if at <= rational(0, 1) {
            return rational(0, 1);
        }
        let sign = rational(if k % 2 == 0 { 1 } else { -1 }, 1);
        sign * Rational::from(binomial(degree + 1, k)) * at.power(power)
    });
    let factorial: i64 = (1..=i64::from(power)).product();
    terms.sum::<Rational>() / rational(factorial, 1)
}

#[test]
fn limits_of_splines_are_splines() {
    let splines = [
        (2, "1/8*(1+z)^4", 3),
        (2, "1/16*(1+z)^5", 4),
        (3, "1/27*(1+z+z^2)^4", 3),
        (4, "1/16*(1+z+z^2+z^3)^3", 2),
    ];
    for (arity, text, degree) in splines {
        let limit = BasicLimit::new(&mask(text, arity)).unwrap();
        assert_eq!(limit.support(), [rational(0, 1), rational(i64::from(degree) + 1, 1)]);
        for (p, q) in [(0, 1), (1, 2), (-3, 4), (1, 3), (5, 3), (2, 7), (7, 12), (1, 5)] {
            let x = rational(p, q);
            for order in 0..degree {
                let stencil = limit.stencil(&x, order).unwrap();
                let mut sum = rational(0, 1);
                for (k, w) in (stencil.first()..).zip(stencil.weights()) {
                    assert_eq!(
                        *w,
                        b_spline(degree, &(&x - rational(k, 1)), order),
                        "{text} at {x}"
                    );
                    sum += w;
                }
                assert_eq!(sum, rational(i64::from(order == 0), 1));
            }
        }
    }
    // It has no third derivative.
    let cubic = BasicLimit::new(&mask("bspline3", 2)).unwrap();
    assert_eq!(cubic.stencil(&rational(0, 1), 3).unwrap_err().code(), "limit");
    let rule = cubic.rule::<Rational>(0).unwrap();
    assert_eq!(rule.stencils()[0].weights(), [(1, 6), (2, 3), (1, 6)].map(|(p, q)| rational(p, q)));
    // Chaikin's control points stand at the middles of the pieces.
    let chaikin = BasicLimit::new(&mask("bspline2", 2)).unwrap().rule::<Rational>(0).unwrap();
    let expected = [(1, 8), (3, 4), (1, 8)].map(|(p, q)| rational(p, q));
    assert_eq!(
        (chaikin.stencils()[0].first(), chaikin.stencils()[0].weights()),
        (-1, &expected[..])
    );
}

/// Thirty levels come as near as floats can.
#[test]
fn limits_are_approached() {
    for (text, arity) in [("dd4", 2), ("bspline2", 2), ("bspline5", 2), (TERNARY, 3)] {
        let scheme = mask(text, arity);
        let values = [0.0, 0.5, 1.0, 3.0, -2.0, 1.0, 5.0, 0.5, 0.25, -1.0, 2.0, 2.0].to_vec();
        let polygon = Polygon::new(1, values, false).unwrap();
        let limit = BasicLimit::new(&scheme).unwrap().rule::<f64>(0).unwrap();
        let limits = refine_to(&polygon, &[], &[&limit], Ends::Reflect).unwrap();
        let expected = limits[0].values()[5];
        // Only the points around the fifth are kept, the first of which has the index `first`.
        let rule = Weights::<f64>::new(&scheme).unwrap();
        let shift = f64::from_rational(rule.shift());
        let (mut part, mut first, mut place) = (polygon, 0_i64, 5.0);
        for _ in 0..30 {
            let start = rule.produced(&(0..part.count() as i64)).start + arity as i64 * first;
            let finer = refine(&part, &[&rule], Ends::Trim).unwrap();
            place = place * arity as f64 + shift;
            let middle = place.floor() as i64 - start;
            let [low, high] = [middle - 9, middle + 10].map(|i| i.clamp(0, finer.count() as i64));
            part = Polygon::new(1, finer.values()[low as usize..high as usize].to_vec(), false)
                .unwrap();
            first = start + low;
        }
        let nearest = part.values()[(place.round() as i64 - first) as usize];
        assert!((nearest - expected).abs() < 1e-6, "{text}: {nearest}, {expected}");
    }
}

#[test]
fn interpolatory_schemes_keep_every_point() {
    for (text, arity) in [("dd4", 2), ("dd8", 2), ("[-1/10, 0, 3/5, 1, 3/5, 0, -1/10]", 2)] {
        let values: Vec<Rational> = (0..30).map(|i| rational((i * i) % 11, 3)).collect();
        for closed in [true, false] {
            let polygon = Polygon::new(2, values.clone(), closed).unwrap();
            let rule = weights::<Rational>(text, arity);
            let finer = refine(&polygon, &[&rule; 4], Ends::Reflect).unwrap();
            assert!(polygon.points().eq(finer.points().step_by(16)), "{text}");
            let limit = BasicLimit::new(&mask(text, arity)).unwrap().rule(0).unwrap();
            assert_eq!(refine_to(&polygon, &[], &[&limit], Ends::Reflect).unwrap()[0], polygon);
        }
    }
}

#[test]
fn what_cannot_be_refined_says_so() {
    let code = |result: Result<Polygon<f64>, refinable_scheme::Diagnostic>| {
        let error = result.unwrap_err();
        (error.code(), error.message().to_string(), error.hint().unwrap_or_default().to_string())
    };
    let rule = weights::<f64>("dd6", 2);
    let line = |n: usize, closed| Polygon::new(1, vec![1.0; n], closed).unwrap();
    // Neither a long way nor a wide support is a danger.
    let far = weights::<f64>("1/2*(1+z)*z^1000 + 1/2*(1+z)*z^-1000", 2);
    assert_eq!(refine(&line(2, false), &[&far], Ends::Reflect).unwrap().values(), [1.0; 2]);
    assert_eq!(rule.repeated(u32::MAX).unwrap_err().code(), "levels");
    let wide = BasicLimit::new(&mask("bspline200", 2)).unwrap();
    assert_eq!(wide.stencil(&rational(0, 1), 0).unwrap_err().code(), "budget");
    let (kind, message, hint) = code(refine(&line(3, false), &[&rule], Ends::Trim));
    assert_eq!(
        (kind, &message[..]),
        ("points", "too few points for the stencils of the scheme: 3")
    );
    assert!(hint.starts_with("give 5 or more"), "{hint}");
    assert_eq!(refine(&line(5, false), &[&rule], Ends::Trim).unwrap().count(), 1);
    // A closed polygon may be shorter than a stencil, down to a single point.
    assert_eq!(refine(&line(1, true), &[&rule; 3], Ends::Trim).unwrap().count(), 8);
    assert_eq!(refine(&line(1, false), &[&rule; 3], Ends::Reflect).unwrap().count(), 1);
    let (kind, message, _) = code(refine(&line(1000, true), &[&rule; 20], Ends::Trim));
    assert_eq!((kind, &message[..]), ("memory", "the result would take about 7.9 GiB"));
    assert_eq!(code(refine(&line(1000, true), &[&rule; 80], Ends::Trim)).0, "levels");
    assert_eq!(Polygon::new(0, vec![1.0], false).unwrap_err().code(), "dimension");
    assert_eq!(Polygon::new(65, vec![1.0], false).unwrap_err().code(), "dimension");
    assert_eq!(Polygon::new(2, vec![1.0; 3], false).unwrap_err().code(), "points");
    assert_eq!(Polygon::<f64>::new(2, vec![], false).unwrap_err().code(), "points");
    assert_eq!(Net::<f64>::new(1, 0, vec![1.0], [false; 2]).unwrap_err().code(), "points");
    assert_eq!(Net::new(1, 2, vec![1.0; 3], [false; 2]).unwrap_err().code(), "points");
    let family = Weights::<f64>::new(&mask("a4", 2)).unwrap_err();
    assert_eq!(family.hint(), Some("set them: --set alpha=VALUE"));
}

/// An interproximate scheme by its definition: every point of every level on its own.
struct Definition {
    /// Members; 0 is the approximating one.
    members: Vec<Weights<Rational>>,
    vertices: Vec<usize>,
    edges: Vec<usize>,
    points: Vec<Rational>,
}

impl Definition {
    fn keeps(&self, member: usize) -> bool {
        let vertex = &self.members[member].stencils()[0];
        (vertex.first(), vertex.weights()) == (0, &[rational(1, 1)][..])
    }

    /// The members of a vertex and of the edge after it.
    fn tensions(&self, level: u32, i: i64) -> (usize, usize) {
        if level == 0 {
            let i = i.rem_euclid(self.points.len() as i64) as usize;
            return (self.vertices[i], self.edges[i]);
        }
        let parent = self.tensions(level - 1, i.div_euclid(2));
        if i.rem_euclid(2) == 0 && self.keeps(parent.0) { parent } else { (0, 0) }
    }

    fn point(&self, level: u32, i: i64) -> Rational {
        if level == 0 {
            return self.points[i.rem_euclid(self.points.len() as i64) as usize].clone();
        }
        let (parent, class) = (i.div_euclid(2), i.rem_euclid(2) as usize);
        let (vertex, edge) = self.tensions(level - 1, parent);
        let stencil = &self.members[if class == 0 { vertex } else { edge }].stencils()[class];
        let terms = (parent + stencil.first()..).zip(stencil.weights());
        terms.map(|(j, w)| w * self.point(level - 1, j)).sum()
    }
}

fn members_of_a3() -> Vec<Weights<Rational>> {
    let family = Scheme::resolve("a3", 2).unwrap();
    let member = |set: [&str; 2]| {
        let sets = set.map(|s| Substitution::parse(s).unwrap());
        Weights::new(family.with(&sets).unwrap().mask()).unwrap()
    };
    [
        ["alpha=1/8", "beta=1/50"],
        ["alpha=0", "beta=-1/20"],
        ["alpha=0", "beta=1/30"],
        ["alpha=1/5", "beta=0"],
    ]
    .map(member)
    .to_vec()
}

/// New points far away from those that they stem from: with one member everywhere it is the pure scheme.
#[test]
fn interproximate_refinement_of_shifted_masks() {
    for text in [
        "1/16*[-1, 0, 9, 16, 9, 0, -1] @ 17",
        "1/16*[-1, 0, 9, 16, 9, 0, -1] @ -23",
        "1/4*[1, 3, 3, 1] @ 7",
    ] {
        let rule = weights::<Rational>(text, 2);
        let scheme = Interproximate::new(vec![rule.clone()], 0).unwrap();
        let values: Vec<Rational> = (0..9).map(|i| rational((i * i) % 7, 2)).collect();
        for closed in [true, false] {
            let polygon = Polygon::new(1, values.clone(), closed).unwrap();
            let tensions = Tensions::of_vertices(vec![0; 9]);
            let found = scheme.refine(&polygon, &tensions, 3, Ends::Reflect).unwrap();
            assert_eq!(found, refine(&polygon, &[&rule; 3], Ends::Reflect).unwrap(), "{text}");
        }
    }
}

/// Vertices and edges that take different members, kept and not, over several levels.
#[test]
fn interproximate_refinement_is_its_definition() {
    let definition = Definition {
        members: members_of_a3(),
        vertices: vec![1, 0, 2, 3, 1, 0, 0],
        edges: vec![2, 3, 1, 1, 0, 2, 0],
        points: [3, -1, 4, 1, -5, 9, 2].map(|x| rational(x, 1)).to_vec(),
    };
    let scheme = Interproximate::new(definition.members.clone(), 0).unwrap();
    let tensions =
        Tensions { vertices: definition.vertices.clone(), edges: definition.edges.clone() };
    let polygon = Polygon::new(1, definition.points.clone(), true).unwrap();
    for level in 0..4 {
        let expected: Vec<Rational> = (0..7 << level).map(|i| definition.point(level, i)).collect();
        let found = scheme.refine(&polygon, &tensions, level, Ends::Trim).unwrap();
        assert_eq!(found.values(), expected, "level {level}");
    }
}

/// Reflected ends: the same by ghost points written down, vertices mirrored at the ends and edges onto edges.
#[test]
fn reflected_tensions_are_mirrored() {
    let vertices = [1, 0, 2, 3, 1, 0, 3];
    let edges = [2, 3, 1, 1, 0, 2];
    let points = [3, -1, 4, 1, -5, 9, 2].map(|x| rational(x, 1));
    let mirrored = |i: i64| if i < 0 { -i } else if i > 6 { 12 - i } else { i } as usize;
    let ghost = |i: i64| {
        let end = if i < 0 { &points[0] } else { &points[6] };
        let given = &points[mirrored(i)];
        if (0..7).contains(&i) { given.clone() } else { rational(2, 1) * end - given }
    };
    let edge = |i: i64| {
        edges[if i < 0 {
            -i - 1
        } else if i > 5 {
            11 - i
        } else {
            i
        } as usize]
    };
    let definition = Definition {
        members: members_of_a3(),
        vertices: (-6..13).map(|i| vertices[mirrored(i)]).collect(),
        edges: (-6..12).map(edge).chain([0]).collect(),
        points: (-6..13).map(ghost).collect(),
    };
    let scheme = Interproximate::new(definition.members.clone(), 0).unwrap();
    let tensions = Tensions { vertices: vertices.to_vec(), edges: [&edges[..], &[0]].concat() };
    let polygon = Polygon::new(1, points.to_vec(), false).unwrap();
    for level in 0..4 {
        let expected: Vec<Rational> =
            (6 << level..=12 << level).map(|i| definition.point(level, i)).collect();
        let found = scheme.refine(&polygon, &tensions, level, Ends::Reflect).unwrap();
        assert_eq!(found.values(), expected, "level {level}");
    }
}

/// Nets by their definition: each row with the members of its points, then each column with those of the points of
/// the refined rows, of which new ones are approximating; after both, so is all that is not kept.
#[test]
fn interproximate_nets_are_their_definition() {
    let members = members_of_a3();
    let scheme = Interproximate::new(members.clone(), 0).unwrap();
    let (rows, columns) = (5, 7);
    let mut values: Vec<Vec<Rational>> = (0..rows as i64)
        .map(|i| (0..columns as i64).map(|j| rational((i * i * 5 + j * 3) % 11, 2)).collect())
        .collect();
    let mut tags: Vec<Vec<usize>> =
        (0..rows).map(|i| (0..columns).map(|j| (i * 3 + j * j) % 4).collect()).collect();
    let net = Net::new(1, columns, values.concat(), [true, true]).unwrap();
    let given = tags.concat();
    // A line of points and members, once refined.
    let refined = |values: &[Rational], tags: &[usize]| -> Vec<Rational> {
        let n = values.len() as i64;
        let point = |i: i64| {
            let (parent, class) = (i / 2, (i % 2) as usize);
            let stencil = &members[tags[parent as usize]].stencils()[class];
            let terms = (parent + stencil.first()..).zip(stencil.weights());
            terms.map(|(j, w)| w * &values[j.rem_euclid(n) as usize]).sum()
        };
        (0..2 * n).map(point).collect()
    };
    let spread = |tags: &[usize]| -> Vec<usize> { tags.iter().flat_map(|&tag| [tag, 0]).collect() };
    fn turned<T: Clone>(lines: &[Vec<T>]) -> Vec<Vec<T>> {
        (0..lines[0].len()).map(|j| lines.iter().map(|line| line[j].clone()).collect()).collect()
    }
    for level in 0..4 {
        let found = scheme.refine_net(&net, &given, level, [Ends::Trim; 2]).unwrap();
        assert_eq!((found.rows(), found.columns()), (rows << level, columns << level));
        assert_eq!(found.values(), values.concat(), "level {level}");
        let along: Vec<_> = values.iter().zip(&tags).map(|(v, t)| refined(v, t)).collect();
        let along_tags: Vec<_> = tags.iter().map(|t| spread(t)).collect();
        let (lines, line_tags) = (turned(&along), turned(&along_tags));
        let across: Vec<_> = lines.iter().zip(&line_tags).map(|(v, t)| refined(v, t)).collect();
        values = turned(&across);
        tags = turned(&line_tags.iter().map(|t| spread(t)).collect::<Vec<_>>());
        // 1 and 2 keep their points.
        tags.iter_mut()
            .flatten()
            .for_each(|tag| *tag = if matches!(tag, 1 | 2) { *tag } else { 0 });
    }
}
