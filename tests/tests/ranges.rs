//! The exact sets that norms prove, against norms by refining data at rational points.
//!
//! Every continuity range of the transcribed paper is solved; at points close to each end, on both
//! sides, the oracle evaluates the norms themselves. Random families, poles included, follow.

use std::collections::BTreeSet;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{
    Parameter, ParameterFraction, ParameterPolynomial, Polynomial, Rational, Ring, integer,
    rational,
};
use refinable_analysis::{Budget, NormRange, norm_range};
use refinable_papers::{Claim, Paper, Statement};
use refinable_reals::{Bound, Interval, RealAlgebraic, Region};
use refinable_scheme::{Mask, Normalised, Scheme, Substitution};
use refinable_tests::{SturmChain, difference_symbol, iterated_norm};

/// A family with one free parameter and an order of continuity.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Question {
    scheme: String,
    set: Vec<String>,
    parameter: String,
    continuity: usize,
}

impl Question {
    fn family(&self) -> Family {
        let set: Vec<_> = self.set.iter().map(|s| Substitution::parse(s).unwrap()).collect();
        let scheme = Scheme::resolve_with(&self.scheme, 2, &set).unwrap();
        Family { mask: scheme.mask().clone(), parameter: Parameter::new(&self.parameter) }
    }
}

/// The questions behind all ranges that the paper prints, each once.
fn questions() -> BTreeSet<Question> {
    let paper = Paper::builtin().unwrap();
    let cells = paper.tables.iter().flat_map(|table| &table.cells);
    let claims = cells.flat_map(|cell| &cell.claims);
    claims
        .filter_map(|claim| {
            let Claim::Checkable(assertion) = claim else { return None };
            let Statement::Continuity(claimed) = &assertion.statement else { return None };
            Some(Question {
                scheme: assertion.scheme.clone(),
                set: assertion.set.clone(),
                parameter: claimed.interval.as_ref()?.parameter.clone(),
                continuity: claimed.order as usize,
            })
        })
        .collect()
}

/// A mask in at most one parameter.
#[derive(Clone, Debug)]
struct Family {
    mask: Normalised,
    parameter: Parameter,
}

impl Family {
    /// The mask at a rational point; `None` at a pole.
    fn at(&self, t: &Rational) -> Option<Vec<Rational>> {
        let value = ParameterFraction::from(ParameterPolynomial::constant(t.clone()));
        let coefficient = |c: ParameterFraction| {
            let number = c.substitute(&self.parameter, &value).ok()?;
            Some(number.as_constant().expect("no other parameter occurs"))
        };
        self.mask.coefficients().map(|(_, c)| coefficient(c)).collect()
    }

    /// `c_n` at a rational point; `None` where there is none.
    fn symbol(&self, continuity: usize, t: &Rational) -> Option<Vec<Rational>> {
        difference_symbol(&self.at(t)?, self.mask.arity(), continuity)
    }

    /// `‖c_n^level‖` by refining data; `None` where there is no `c_n`.
    fn norm(&self, continuity: usize, level: usize, t: &Rational) -> Option<Rational> {
        Some(iterated_norm(&self.symbol(continuity, t)?, self.mask.arity(), level))
    }

    fn is_below_one(&self, continuity: usize, level: usize, t: &Rational) -> bool {
        self.norm(continuity, level, t).is_some_and(|norm| norm < rational(1, 1))
    }

    /// The first level up to `last` whose norm is below 1.
    fn first_level(&self, continuity: usize, last: usize, t: &Rational) -> Option<usize> {
        let symbol = self.symbol(continuity, t)?;
        let below = |&l: &usize| iterated_norm(&symbol, self.mask.arity(), l) < rational(1, 1);
        (1..=last).find(below)
    }

    fn range(&self, continuity: usize, level: u32) -> NormRange {
        norm_range(&self.mask, &self.parameter, continuity, level, Budget::default()).unwrap()
    }
}

/// Points on both sides of a number, at most `2 / 10^digits` away.
fn sides(x: &RealAlgebraic, digits: u32) -> [Rational; 2] {
    let step = Rational::from(integer(1)) / Rational::from(integer(10).power(digits));
    let (lower, upper) = x.decimal_enclosure(digits);
    [lower - &step, upper + step]
}

/// Whether another interval of the region has the same end.
fn is_shared(x: &RealAlgebraic, region: &[Interval]) -> bool {
    let bounds = region.iter().flat_map(|interval| [&interval.lower, &interval.upper]);
    bounds.filter(|bound| bound.number() == Some(x)).count() > 1
}

/// The only root of its polynomial between its bounds, by Sturm's theorem.
fn check_end(x: &RealAlgebraic) {
    let (lower, upper) = x.bounds();
    assert_eq!(SturmChain::of(&x.polynomial()).count_closed(&lower, &upper), 1, "{x:?}");
}

/// The region of one level has its ends where the norm passes 1.
fn check_level(family: &Family, continuity: usize, level: usize, region: &Region) {
    let intervals = region.intervals();
    for interval in &intervals {
        for (bound, inside) in [(&interval.lower, 1), (&interval.upper, 0)] {
            let Some(x) = bound.number() else { continue };
            check_end(x);
            if let Some(x) = x.simplified().as_rational() {
                let norm = family.norm(continuity, level, x);
                let expected = if bound.is_closed() {
                    norm < Some(rational(1, 1))
                } else {
                    norm.is_none_or(|norm| norm == rational(1, 1))
                };
                assert!(expected, "the norm at {x}");
            }
            let points = sides(x, 13);
            let below = points.each_ref().map(|t| family.is_below_one(continuity, level, t));
            let isolated = interval.as_point().is_some();
            let context = format!("level {level}, {}, end {x:?}", region.display("t"));
            assert_eq!(below[inside], !isolated, "just inside: {context}");
            assert_eq!(
                below[1 - inside],
                is_shared(x, &intervals) && !isolated,
                "outside: {context}"
            );
        }
    }
}

/// All of [`check_level`], the union of the levels, and a coarse grid over and around it.
fn check_range(question: &Question, level: u32) {
    let family = question.family();
    let n = question.continuity;
    let range = family.range(n, level);
    assert_eq!(range.levels.len(), level as usize);
    for (k, region) in range.levels.iter().enumerate() {
        check_level(&family, n, k + 1, region);
    }
    let some_norm = |t: &Rational| family.first_level(n, level as usize, t).is_some();
    let proved = range.proved.intervals();
    for interval in &proved {
        for (bound, inside) in [(&interval.lower, 1), (&interval.upper, 0)] {
            let Some(x) = bound.number() else { continue };
            check_end(x);
            let points = sides(x, 12);
            let isolated = interval.as_point().is_some();
            assert_eq!(some_norm(&points[inside]), !isolated, "{question:?} {x:?}");
            let outside = some_norm(&points[1 - inside]);
            assert_eq!(outside, is_shared(x, &proved) && !isolated, "{question:?} {x:?}");
        }
    }
    for t in grid(&range.proved) {
        assert_eq!(range.proved.contains_rational(&t), some_norm(&t), "{question:?} at {t}");
    }
}

/// Four points over the hull of a region and two on either side; of the empty region, around zero.
fn grid(region: &Region) -> Vec<Rational> {
    let ends = region.ends();
    let (lower, upper) = match (ends.first(), ends.last()) {
        (Some(first), Some(last)) if first < last => {
            (first.decimal_enclosure(6).0, last.decimal_enclosure(6).1)
        }
        _ => (rational(-1, 8), rational(1, 8)),
    };
    let width = &upper - &lower;
    (-2..6).map(|k| &lower + &width * rational(2 * k + 1, 8)).collect()
}

#[test]
fn the_paper_prints_ranges_of_all_its_families() {
    let questions = questions();
    assert!(questions.len() >= 50, "{} questions", questions.len());
    for family in ["a2", "a3", "a12", "i4", "i8"] {
        assert!(questions.iter().any(|q| q.scheme == family), "{family}");
    }
}

#[test]
fn every_range_of_the_paper_has_its_ends_where_a_norm_is_one() {
    for question in questions() {
        check_range(&question, 4);
    }
}

#[test]
fn some_ranges_at_a_higher_level() {
    for (scheme, parameter, continuity) in
        [("a2", "alpha", 1), ("a4", "alpha", 3), ("a6", "alpha", 4), ("i4", "beta", 1)]
    {
        let set = Vec::new();
        let (scheme, parameter) = (scheme.to_string(), parameter.to_string());
        check_range(&Question { scheme, set, parameter, continuity }, 6);
    }
}

/// Divisible at one value only: an isolated point, proved there and meaningless elsewhere.
#[test]
fn isolated_values_are_single_points() {
    for (scheme, continuity, value) in
        [("a2", 2, rational(1, 8)), ("a4", 4, rational(3, 128)), ("a6", 6, rational(5, 1024))]
    {
        let parameter = "alpha".to_string();
        let question = Question { scheme: scheme.into(), set: Vec::new(), parameter, continuity };
        let range = question.family().range(continuity, 5);
        assert_eq!(range.divisible_at, Some(vec![value.clone().into()]));
        check_range(&question, 5);
        let proved = question.family().first_level(continuity, 5, &value).is_some();
        assert_eq!(range.proved.contains_rational(&value), proved);
    }
}

#[test]
fn a_family_with_a_pole_is_undefined_there_and_nowhere_else() {
    let question = Question {
        scheme: "a3".into(),
        set: vec!["beta=(8*alpha-1)/(16*(1-alpha))".into(), "alpha=1/t".into()],
        parameter: "t".into(),
        continuity: 1,
    };
    let range = question.family().range(1, 3);
    assert_eq!(range.poles, [rational(0, 1).into()]);
    assert!(range.proved.contains_rational(&rational(4, 1)));
    check_range(&question, 3);
}

/// With `p = (t - 1/3)²` the first norm is `p + |1 - 2p|`: it touches 1 from below at a root of `p`,
/// and passes it where `p = 2/3`.
#[test]
fn a_point_where_the_norm_touches_one_is_left_out() {
    let text = "(1+z)*((t-1/3)^2 + (t-1/3)^2*z + (1-2*(t-1/3)^2)*z^2)";
    let question =
        Question { scheme: text.into(), set: Vec::new(), parameter: "t".into(), continuity: 0 };
    let range = question.family().range(0, 1);
    let expected = "((1-sqrt(6))/3, 1/3) ∪ (1/3, (1+sqrt(6))/3)";
    assert_eq!(range.proved.display("t"), expected);
    check_range(&question, 3);
}

/// `p + q t + r t²`, mostly of degree one.
fn entry() -> impl Strategy<Value = ParameterPolynomial> {
    let small = || (-6i64..=6, 8i64..=16).prop_map(|(p, q)| rational(p, q));
    let quadratic = prop_oneof![3 => Just(rational(0, 1)), 1 => small()];
    (small(), small(), quadratic).prop_map(|(p, q, r)| {
        let t = Parameter::new("t");
        let powers = [p, q, r].map(ParameterPolynomial::constant);
        ParameterPolynomial::from_collected(&Polynomial::new(powers.to_vec()), &t)
    })
}

/// `1`, `t - p/q` or `1 + t²`.
fn denominator() -> impl Strategy<Value = ParameterPolynomial> {
    let t = || ParameterPolynomial::parameter(&Parameter::new("t"));
    let linear = (-6i64..=6, 1i64..=3)
        .prop_map(move |(p, q)| t().minus(&ParameterPolynomial::constant(rational(p, q))));
    prop_oneof![
        3 => Just(ParameterPolynomial::one()),
        2 => linear,
        1 => Just(t().times(&t()).plus(&ParameterPolynomial::one())),
    ]
}

fn convolved(mask: &[ParameterFraction], arity: usize) -> Vec<ParameterFraction> {
    let zero = ParameterFraction::from(ParameterPolynomial::zero());
    let scale = ParameterPolynomial::constant(rational(1, arity as i64)).into();
    let mut product = vec![zero; mask.len() + arity - 1];
    for (i, c) in mask.iter().enumerate() {
        for k in 0..arity {
            product[i + k] = product[i + k].plus(&c.times(&scale));
        }
    }
    product
}

/// A family whose stencils sum to 1 by construction: in each residue class the last entry is what
/// is missing. Perhaps averaged with its mirror image; then multiplied by `σ/m` up to two times,
/// which is the order of continuity that makes sense to ask for.
fn family() -> impl Strategy<Value = (Family, usize)> {
    let entries = (2usize..=3, 1usize..=2)
        .prop_flat_map(|(arity, rows)| (Just(arity), vec(entry(), arity * rows)));
    (entries, denominator(), any::<bool>(), 0usize..=2).prop_map(
        |((arity, entries), denominator, symmetric, order)| {
            let one = ParameterFraction::from(ParameterPolynomial::one());
            let fraction =
                |p: ParameterPolynomial| ParameterFraction::new(p, &denominator).unwrap();
            let mut mask: Vec<_> = entries.into_iter().map(fraction).collect();
            for class in 0..arity {
                let rest = mask.iter().skip(class).step_by(arity);
                mask.push(rest.fold(one.clone(), |rest, c| rest.minus(c)));
                // The new entries follow one another, one for each class.
                debug_assert_eq!((mask.len() - 1) % arity, class);
            }
            if symmetric {
                let half = ParameterPolynomial::constant(rational(1, 2)).into();
                let mirrored = mask.iter().rev().zip(&mask);
                mask = mirrored.map(|(a, b)| a.plus(b).times(&half)).collect();
            }
            for _ in 0..order {
                mask = convolved(&mask, arity);
            }
            let mask = Normalised::new(Mask::new(arity, 0, &mask).unwrap()).unwrap();
            (Family { mask, parameter: Parameter::new("t") }, order)
        },
    )
}

/// The values of the region's ends and points near them, and points from a list.
fn samples(region: &Region, points: &[Rational]) -> Vec<Rational> {
    let mut samples = points.to_vec();
    for x in region.ends() {
        samples.extend(sides(&x, 8));
        samples.extend(x.simplified().as_rational().cloned());
    }
    samples
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn membership_is_a_norm_below_one(
        (family, order) in family(),
        points in vec((-40i64..=40, 1i64..=12).prop_map(|(p, q)| rational(p, q)), 6),
    ) {
        let range = family.range(order, 3);
        for pole in &range.poles {
            prop_assert!(!range.proved.contains(pole));
            prop_assert!(pole.simplified().as_rational().is_none_or(|t| family.at(t).is_none()));
        }
        for (k, region) in range.levels.iter().enumerate() {
            prop_assert!(region.check_invariants());
            prop_assert!(region.is_subset(&range.proved));
            for t in samples(region, &points) {
                let below = family.is_below_one(order, k + 1, &t);
                prop_assert_eq!(region.contains_rational(&t), below, "level {} at {}", k + 1, t);
            }
        }
        for t in samples(&range.proved, &points) {
            let level = family.first_level(order, 3, &t);
            let found = range.levels.iter().position(|region| region.contains_rational(&t));
            prop_assert_eq!(found.map(|below| below + 1), level);
        }
    }

    /// Far out the set is the half-lines of a rational function's limit, or nothing.
    #[test]
    fn half_lines_are_found((family, order) in family(), far in 1_000_000i64..2_000_000) {
        let range = family.range(order, 2);
        for t in [rational(far, 1), rational(-far, 1)] {
            for (k, region) in range.levels.iter().enumerate() {
                let below = family.is_below_one(order, k + 1, &t);
                prop_assert_eq!(region.contains_rational(&t), below, "level {} at {}", k + 1, t);
            }
        }
    }
}

/// An open end is open: the region has no closed bounds but those of isolated points.
#[test]
fn proved_intervals_are_open() {
    for question in questions() {
        let range = question.family().range(question.continuity, 2);
        for interval in range.proved.intervals() {
            let closed = [&interval.lower, &interval.upper].map(Bound::is_closed);
            assert_eq!(closed, [interval.as_point().is_some(); 2], "{question:?}");
        }
    }
}
