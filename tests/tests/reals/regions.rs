//! Regions against sets of cells.
//!
//! Nine fixed numbers cut the line into nineteen cells, gaps and points alternating. A region with
//! these ends is a set of cells, a bit each, and its algebra is that of bits.

use std::sync::LazyLock;

use proptest::collection::vec;
use proptest::prelude::*;
use refinable_algebra::{Rational, Ring, rational};
use refinable_reals::{Bound, RealAlgebraic, Region, real_roots};

use crate::generate::{fraction, poly};

const NUMBERS: usize = 9;
const CELLS: usize = 2 * NUMBERS + 1;
const ALL: u32 = (1 << CELLS) - 1;

/// The numbers, ascending, each stored in two ways.
static ENDS: LazyLock<Vec<[RealAlgebraic; 2]>> = LazyLock::new(|| {
    let root = |coefficients: &[i64], factor: &[i64], k: usize| {
        let own = poly(coefficients);
        let x = real_roots(&own)[k].clone();
        let product = real_roots(&own.times(&poly(factor)));
        let same = product.into_iter().find(|r| *r == x).unwrap();
        [x, same]
    };
    vec![
        root(&[-5, 0, 1], &[-1, 1], 0),           // -√5
        root(&[1, 1], &[-2, 0, 1], 0),            // -1
        root(&[0, 1], &[-3, 0, 1], 0),            // 0
        root(&[-1, 3], &[-7, 0, 0, 1], 0),        // 1/3
        root(&[-2, 0, 0, 1], &[-3, 0, 1], 0),     // ∛2
        root(&[-2, 0, 1], &[-2, 0, 0, 1], 1),     // √2
        root(&[-1, -1, 1], &[-5, 0, 1], 1),       // (1+√5)/2
        root(&[-3, 0, 1], &[1, 0, -10, 0, 1], 1), // √3
        root(&[-2, 1], &[-5, 0, 1], 0),           // 2
    ]
});

/// A rational number of each gap. The squares, cubes and signs that show it: 9 > 5, 4 < 5,
/// 1 < 2 < 1.3³ = 2.197, 1.3² = 1.69 < 2 < 1.5², 1.5² < 1.5 + 1, 1.7² = 2.89 > 1.7 + 1, 2.89 < 3 < 1.9².
fn gaps() -> [Rational; NUMBERS + 1] {
    let tenths = [-30, -20, -5, 2, 10, 13, 15, 17, 19, 30];
    tenths.map(|n| rational(n, 10))
}

/// A region and its cells.
#[derive(Clone, Debug)]
struct Model {
    region: Region,
    cells: u32,
}

/// The interval from cell `first` to cell `last`; `other` chooses how its ends are stored.
fn interval(first: usize, last: usize, other: usize) -> Model {
    let lower = match first {
        0 => Bound::Infinite,
        k if k % 2 == 0 => Bound::Open(ENDS[k / 2 - 1][other].clone()),
        k => Bound::Closed(ENDS[k / 2][other].clone()),
    };
    let upper = match last {
        k if k == CELLS - 1 => Bound::Infinite,
        k if k % 2 == 0 => Bound::Open(ENDS[k / 2][1 - other].clone()),
        k => Bound::Closed(ENDS[k / 2][1 - other].clone()),
    };
    Model {
        region: Region::interval(lower, upper),
        cells: (first..=last).fold(0, |cells, k| cells | 1 << k),
    }
}

/// A union of up to four intervals, in any order.
fn model() -> impl Strategy<Value = Model> {
    vec((0..CELLS, 0..CELLS, 0..2usize), 0..=4).prop_map(|parts| {
        let parts = parts.into_iter().map(|(a, b, other)| interval(a.min(b), a.max(b), other));
        let parts: Vec<Model> = parts.collect();
        Model {
            cells: parts.iter().fold(0, |cells, part| cells | part.cells),
            region: Region::union_of(parts.into_iter().map(|part| part.region)),
        }
    })
}

/// The region with these cells, built from its points and gaps one by one.
fn from_cells(cells: u32) -> Region {
    let chosen = (0..CELLS).filter(|k| cells >> k & 1 == 1);
    Region::union_of(chosen.map(|k| interval(k, k, 0).region))
}

/// The cells whose sample belongs to the region.
fn cells_of(region: &Region) -> u32 {
    let gaps = gaps();
    (0..CELLS).fold(0, |cells, k| {
        let inside = if k % 2 == 0 {
            region.contains_rational(&gaps[k / 2])
        } else {
            let [a, b] = &ENDS[k / 2];
            assert_eq!(region.contains(a), region.contains(b));
            region.contains(a)
        };
        cells | u32::from(inside) << k
    })
}

fn agrees(region: &Region, cells: u32) -> Result<(), TestCaseError> {
    prop_assert!(region.check_invariants());
    prop_assert_eq!(cells_of(region), cells);
    prop_assert_eq!(region, &from_cells(cells));
    Ok(())
}

#[test]
fn the_samples_lie_in_their_gaps() {
    let gaps = gaps().map(RealAlgebraic::from);
    for (k, [a, b]) in ENDS.iter().enumerate() {
        assert!(gaps[k] < *a && *a < gaps[k + 1] && a == b);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    #[test]
    fn the_operations_are_those_on_sets_of_cells(a in model(), b in model()) {
        agrees(&a.region, a.cells)?;
        agrees(&a.region.union(&b.region), a.cells | b.cells)?;
        agrees(&a.region.intersection(&b.region), a.cells & b.cells)?;
        agrees(&a.region.difference(&b.region), a.cells & !b.cells)?;
        agrees(&a.region.complement(), !a.cells & ALL)?;
    }

    #[test]
    fn equality_and_inclusion_are_those_of_sets(a in model(), b in model()) {
        prop_assert_eq!(a.region == b.region, a.cells == b.cells);
        prop_assert_eq!(a.region.is_subset(&b.region), a.cells & !b.cells == 0);
        prop_assert_eq!(a.region.is_empty(), a.cells == 0);
        let both = a.region.intersection(&b.region);
        prop_assert!(both.is_subset(&a.region) && both.is_subset(&b.region));
    }

    #[test]
    fn union_and_intersection_are_commutative_associative_and_idempotent(
        a in model(),
        b in model(),
        c in model(),
    ) {
        let [a, b, c] = [a, b, c].map(|model| model.region);
        prop_assert_eq!(a.union(&b), b.union(&a));
        prop_assert_eq!(a.intersection(&b), b.intersection(&a));
        prop_assert_eq!(a.union(&b).union(&c), a.union(&b.union(&c)));
        let right = a.intersection(&b.intersection(&c));
        prop_assert_eq!(a.intersection(&b).intersection(&c), right);
        prop_assert_eq!(&a.union(&a), &a);
        prop_assert_eq!(&a.intersection(&a), &a);
    }

    #[test]
    fn union_and_intersection_distribute_and_absorb(a in model(), b in model(), c in model()) {
        let [a, b, c] = [a, b, c].map(|model| model.region);
        let right = a.intersection(&b).union(&a.intersection(&c));
        prop_assert_eq!(a.intersection(&b.union(&c)), right);
        let right = a.union(&b).intersection(&a.union(&c));
        prop_assert_eq!(a.union(&b.intersection(&c)), right);
        prop_assert_eq!(&a.union(&a.intersection(&b)), &a);
        prop_assert_eq!(&a.intersection(&a.union(&b)), &a);
    }

    #[test]
    fn complements_obey_de_morgan(a in model(), b in model()) {
        let [a, b] = [a.region, b.region];
        let (not_a, not_b) = (a.complement(), b.complement());
        prop_assert_eq!(a.union(&b).complement(), not_a.intersection(&not_b));
        prop_assert_eq!(a.intersection(&b).complement(), not_a.union(&not_b));
        prop_assert_eq!(&not_a.complement(), &a);
        prop_assert_eq!(a.union(&not_a), Region::line());
        prop_assert_eq!(a.intersection(&not_a), Region::empty());
    }

    #[test]
    fn a_difference_is_the_intersection_with_the_complement(a in model(), b in model()) {
        let [a, b] = [a.region, b.region];
        prop_assert_eq!(a.difference(&b), a.intersection(&b.complement()));
        prop_assert_eq!(a.difference(&b).union(&a.intersection(&b)), a.clone());
        prop_assert_eq!(a.difference(&a), Region::empty());
    }

    #[test]
    fn membership_of_a_rational_number_commutes_with_every_operation(
        a in model(),
        b in model(),
        x in fraction(),
    ) {
        let [a, b] = [a.region, b.region];
        let (in_a, in_b) = (a.contains_rational(&x), b.contains_rational(&x));
        prop_assert_eq!(a.union(&b).contains_rational(&x), in_a || in_b);
        prop_assert_eq!(a.intersection(&b).contains_rational(&x), in_a && in_b);
        prop_assert_eq!(a.difference(&b).contains_rational(&x), in_a && !in_b);
        prop_assert_eq!(a.complement().contains_rational(&x), !in_a);
    }

    #[test]
    fn a_region_is_the_union_of_its_intervals(a in model()) {
        let intervals = a.region.intervals();
        let parts = intervals.iter().map(|i| Region::interval(i.lower.clone(), i.upper.clone()));
        let parts: Vec<Region> = parts.collect();
        prop_assert_eq!(&Region::union_of(parts.iter().cloned()), &a.region);
        prop_assert_eq!(&Region::union_of(parts.iter().rev().cloned()), &a.region);
        // One interval for each run of cells, in this order.
        let runs: Vec<u32> = parts.iter().map(cells_of).collect();
        prop_assert_eq!(runs.iter().fold(0, |all, run| all | run), a.cells);
        prop_assert_eq!(runs.len() as u32, (a.cells & !(a.cells << 1)).count_ones());
        prop_assert!(runs.windows(2).all(|pair| pair[0] < pair[1]));
        for (interval, run) in intervals.iter().zip(runs) {
            let point = run.count_ones() == 1 && run.trailing_zeros() % 2 == 1;
            prop_assert_eq!(interval.as_point().is_some(), point);
        }
    }

    #[test]
    fn the_ends_are_the_numbers_at_which_membership_changes(a in model()) {
        let bit = |k: usize| a.cells >> k & 1;
        let changing = (0..NUMBERS).filter(|k| {
            let around = [2 * k, 2 * k + 1, 2 * k + 2].map(bit);
            around != [around[0]; 3]
        });
        let expected: Vec<RealAlgebraic> = changing.map(|k| ENDS[k][0].clone()).collect();
        prop_assert_eq!(a.region.ends(), expected);
    }

    #[test]
    fn simplification_changes_no_set(a in model()) {
        prop_assert_eq!(a.region.simplified(), a.region.clone());
        let rational_ends = a.region.simplified().ends();
        let stored = rational_ends.iter().filter(|x| x.as_rational().is_some()).count();
        let values = [(-1, 1), (0, 1), (1, 3), (2, 1)].map(|(p, q)| rational(p, q));
        let values = values.map(RealAlgebraic::from);
        prop_assert_eq!(stored, a.region.ends().iter().filter(|x| values.contains(x)).count());
    }

    #[test]
    fn points_and_open_intervals_are_what_they_say(
        x in fraction(),
        y in fraction(),
        t in fraction(),
    ) {
        let point = Region::point(x.clone().into());
        prop_assert_eq!(point.contains_rational(&t), t == x);
        let both = Region::points([y.clone(), x.clone(), y.clone()].map(RealAlgebraic::from));
        prop_assert_eq!(both.contains_rational(&t), t == x || t == y);
        let open = Region::open(x.clone(), y.clone());
        prop_assert_eq!(open.contains_rational(&t), x < t && t < y);
        prop_assert_eq!(open.is_empty(), x >= y);
        prop_assert!(!open.contains_rational(&x) && !open.contains_rational(&y));
        let rest = open.union(&both);
        prop_assert_eq!(rest.contains_rational(&Rational::zero()),
            both.contains_rational(&Rational::zero()) || open.contains_rational(&Rational::zero()));
    }
}
