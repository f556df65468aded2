//! Where all rows of a norm are below the bound at once: branch and bound in Bernstein form.
//!
//! On a node `[lower, upper]` a row `Σ|p_i| < |d|` is *below* if its Bernstein coefficients show it
//! (`Σ_i |b_ik| < |d_k|` for all `k`), *above* if those of some `Σ ±p_i` show `≥ |d|`, and *settled*
//! if all `p_i` seem to have one sign, so that one polynomial inequality decides. A node ends when a
//! row is above, when all are below, or when the only one left is settled and solved exactly by
//! [`RowCondition::region`]; else it is halved.
//!
//! The coefficients are in fixed point, and their error counts against *below* and *above*. So they
//! only save exact solutions, and never replace one: the set returned is exact.

use std::cmp::Ordering;

use refinable_algebra::{Integer, Ordered, Polynomial, Rational, Ring, integer};
use refinable_reals::{
    Bernstein, Bound, Interval, Region, RoundedBernstein, power_of_two, real_roots,
    root_bound_exponent,
};

use crate::contractivity::Work;
use crate::piecewise::RowCondition;

/// Halvings after which rows that are settled are solved even if there are several.
const PATIENCE: u32 = 24;
/// Halvings after which all rows are solved.
const DEPTH: u32 = 64;
/// Nodes after which every further one is solved, so that the search ends in any case.
const NODES: usize = 4096;

/// The set where every row is below `|d|`, exactly.
///
/// # Cost
/// Nodes gather at the ends of the set, some ten for each; a node costs one de Casteljau step for
/// every polynomial of the rows that are still open on it.
pub fn sublevel_set(rows: &[RowCondition], d: &Polynomial<Integer>, work: &mut Work) -> Region {
    if rows.iter().all(RowCondition::is_empty) {
        // All rows vanish: 0 < |d| away from the poles.
        return Region::points(real_roots(d)).complement();
    }
    let start = Start::new(rows, d);
    let degrees = rows.iter().map(RowCondition::degree).chain(d.degree());
    let search = Search { d, degree: degrees.max().unwrap_or(0) };
    let mut found = start.beyond();
    search.run(start.nodes(rows, &search), &mut found, work);
    Region::union_of(found)
}

/// The part of an interval where all rows are below, row after row.
fn solve<'a>(
    rows: impl Iterator<Item = &'a RowCondition>,
    d: &Polynomial<Integer>,
    interval: &Interval,
) -> Region {
    let whole = Region::from(interval);
    rows.fold(whole, |left, row| {
        let parts = left.intervals();
        Region::union_of(parts.iter().map(|part| row.region(d, part)))
    })
}

fn closed(lower: &Rational, upper: &Rational) -> Interval {
    Interval {
        lower: Bound::Closed(lower.clone().into()),
        upper: Bound::Closed(upper.clone().into()),
    }
}

/// What lies outside the interval `[-2^exponent, 2^exponent]` in which the search starts.
struct Start {
    exponent: i64,
    /// Whether the half-lines below and above it belong to the set.
    half_lines: [bool; 2],
}

impl Start {
    fn new(rows: &[RowCondition], d: &Polynomial<Integer>) -> Self {
        let all = || rows.iter().flat_map(RowCondition::terms).map(|(p, _)| p);
        // Beyond the roots of p ± d a p that outgrows d alone exceeds it.
        let bound = |p: &Polynomial<Integer>| {
            root_bound_exponent(&p.minus(d)).max(root_bound_exponent(&p.plus(d)))
        };
        if let Some(exponent) = all().filter(|p| outgrows(p, d)).map(bound).min() {
            return Start { exponent, half_lines: [false; 2] };
        }
        let excesses = |end: Ordering| -> Vec<Polynomial<Integer>> {
            rows.iter().map(|row| row.excess(d, |p| sign_towards(p, end))).collect()
        };
        let (left, right) = (excesses(Ordering::Less), excesses(Ordering::Greater));
        let polynomials = all().chain([d]).chain(&left).chain(&right);
        let exponents = polynomials.filter(|p| !p.is_zero()).map(root_bound_exponent);
        Start {
            exponent: exponents.max().unwrap_or(0),
            half_lines: [
                left.iter().all(|e| sign_towards(e, Ordering::Less).is_lt()),
                right.iter().all(|e| sign_towards(e, Ordering::Greater).is_lt()),
            ],
        }
    }

    fn radius(&self) -> Rational {
        power_of_two(self.exponent)
    }

    fn beyond(&self) -> Vec<Region> {
        let radius = self.radius();
        let left = Region::interval(Bound::Infinite, Bound::Open((-radius.clone()).into()));
        let right = Region::interval(Bound::Open(radius.into()), Bound::Infinite);
        let lines = [left, right].into_iter().zip(self.half_lines);
        lines.filter_map(|(line, holds)| holds.then_some(line)).collect()
    }

    /// The two nodes `[-radius, 0]` and `[0, radius]`.
    fn nodes<'a>(&self, rows: &'a [RowCondition], search: &Search<'_>) -> Vec<Node<'a>> {
        let (radius, zero) = (self.radius(), Rational::zero());
        let polynomials = polynomials(rows, search.d);
        let node = |lower: Rational, upper: Rational, mirrored: bool| {
            let (exponent, degree) = (self.exponent, search.degree);
            let forms = RoundedBernstein::around_zero(&polynomials, degree, exponent, mirrored)
                .unwrap_or_else(|| rounded(&polynomials, degree, &lower, &upper));
            Node::new(lower, upper, rows, forms)
        };
        vec![node(-radius.clone(), zero.clone(), true), node(zero, radius, false)]
    }
}

/// All polynomials of the rows, one row after the other, and then the bound.
fn polynomials<'p>(
    rows: impl IntoIterator<Item = &'p RowCondition>,
    d: &'p Polynomial<Integer>,
) -> Vec<&'p Polynomial<Integer>> {
    rows.into_iter().flat_map(RowCondition::terms).map(|(p, _)| p).chain([d]).collect()
}

/// Rounded forms on any interval, by way of the exact ones.
fn rounded(
    polynomials: &[&Polynomial<Integer>],
    degree: usize,
    lower: &Rational,
    upper: &Rational,
) -> (Vec<RoundedBernstein>, i128) {
    let exact = polynomials.iter().map(|p| Bernstein::new(p, degree, lower, upper));
    RoundedBernstein::of_exact(&exact.collect::<Vec<_>>())
}

/// Whether `|p| > |d|` far out.
fn outgrows(p: &Polynomial<Integer>, d: &Polynomial<Integer>) -> bool {
    let size = |p: &Polynomial<Integer>| p.leading().map(Ordered::absolute);
    (p.degree(), size(p)) > (d.degree(), size(d))
}

/// The sign towards `-∞` (`Less`) or `+∞` (`Greater`).
fn sign_towards(p: &Polynomial<Integer>, end: Ordering) -> Ordering {
    let sign = p.sign_at_infinity();
    let odd = p.degree().is_some_and(|d| d % 2 == 1);
    if end.is_lt() && odd { sign.reverse() } else { sign }
}

/// What all nodes share.
struct Search<'s> {
    d: &'s Polynomial<Integer>,
    /// The formal degree of all forms.
    degree: usize,
}

impl Search<'_> {
    fn run<'a>(&self, mut todo: Vec<Node<'a>>, found: &mut Vec<Region>, work: &mut Work) {
        let mut nodes = 0;
        while let Some(mut node) = todo.pop() {
            nodes += 1;
            work.nodes += 1;
            if node.is_coarse() {
                node = self.sharpened(node);
            }
            if examine(&mut node, work) == Progress::Excluded {
                continue;
            }
            if node.open.is_empty() {
                found.push(Region::from(&node.interval()));
            } else if node.depth >= DEPTH || nodes >= NODES || is_solvable(&node) {
                work.solved += node.open.len();
                let rows = node.open.iter().map(|open| open.row);
                found.push(solve(rows, self.d, &node.interval()));
            } else {
                todo.extend(node.halves(self.degree));
            }
        }
    }

    /// The node with its forms rounded afresh, in a unit that fits it.
    fn sharpened<'a>(&self, node: Node<'a>) -> Node<'a> {
        let rows: Vec<&'a RowCondition> = node.open.iter().map(|open| open.row).collect();
        let polynomials = polynomials(rows.iter().copied(), self.d);
        let forms = rounded(&polynomials, self.degree, &node.lower, &node.upper);
        let depth = node.depth;
        Node { depth, ..Node::new(node.lower, node.upper, rows, forms) }
    }
}

/// Drops the rows that are below on the node.
fn examine(node: &mut Node<'_>, work: &mut Work) -> Progress {
    let before = node.open.len();
    let mut excluded = false;
    let (bound, error) = (&node.bound, node.error);
    node.open.retain(|row| {
        let state = if excluded { State::Open } else { row.state(bound, error) };
        excluded |= state == State::Above;
        state != State::Below
    });
    work.enclosed += before - node.open.len();
    if excluded { Progress::Excluded } else { Progress::Left }
}

/// Several settled rows may each have an end here; halving tells these apart more cheaply than
/// comparing algebraic numbers, unless they coincide.
fn is_solvable(node: &Node<'_>) -> bool {
    let settled = |row: &OpenRow<'_>| row.state(&node.bound, node.error) == State::Settled;
    (node.open.len() == 1 || node.depth >= PATIENCE) && node.open.iter().all(settled)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Progress {
    Excluded,
    Left,
}

/// How a row stands to the bound on a node.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    /// Below everywhere.
    Below,
    /// Not below anywhere.
    Above,
    /// All signs seem constant, so exact solution is cheap.
    Settled,
    /// None of these.
    Open,
}

/// A closed interval with the rows that are still open on it.
struct Node<'a> {
    lower: Rational,
    upper: Rational,
    depth: u32,
    open: Vec<OpenRow<'a>>,
    bound: RoundedBernstein,
    /// The error of every coefficient, in units.
    error: i128,
}

/// A row with the Bernstein forms of its polynomials.
struct OpenRow<'a> {
    row: &'a RowCondition,
    forms: Vec<RoundedBernstein>,
}

impl<'a> Node<'a> {
    /// A node with the forms of all polynomials of the rows, and then that of the bound.
    fn new(
        lower: Rational,
        upper: Rational,
        rows: impl IntoIterator<Item = &'a RowCondition>,
        (forms, error): (Vec<RoundedBernstein>, i128),
    ) -> Self {
        let mut forms = forms.into_iter();
        let mut take = |row: &'a RowCondition| {
            let forms = forms.by_ref().take(row.terms().len()).collect();
            OpenRow { row, forms }
        };
        let open = rows.into_iter().map(&mut take).collect();
        let bound = forms.next().expect("the bound comes last");
        Node { lower, upper, depth: 0, open, bound, error }
    }

    fn interval(&self) -> Interval {
        closed(&self.lower, &self.upper)
    }

    /// Whether less than some twenty bits of the bound are known, because the unit was chosen on an
    /// interval where the polynomials are much larger.
    fn is_coarse(&self) -> bool {
        let largest = self.bound.coefficients().iter().map(|d| d.abs()).max().unwrap_or(0);
        largest < self.error << 20
    }

    /// The right half, and the left one to be taken first.
    fn halves(self, degree: usize) -> [Node<'a>; 2] {
        let middle = (&self.lower + &self.upper) / integer(2);
        let bounds = self.bound.split();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for open in &self.open {
            let (l, r) = open.forms.iter().map(RoundedBernstein::split).unzip();
            left.push(OpenRow { row: open.row, forms: l });
            right.push(OpenRow { row: open.row, forms: r });
        }
        let (depth, error) = (self.depth + 1, self.error + degree as i128);
        let node = |lower, upper, open, bound| Node { lower, upper, depth, open, bound, error };
        [
            node(middle.clone(), self.upper, right, bounds.1),
            node(self.lower, middle, left, bounds.0),
        ]
    }
}

impl OpenRow<'_> {
    /// Compares the sums of the k-th coefficients with the k-th of the bound, for all `k`.
    fn state(&self, bound: &RoundedBernstein, error: i128) -> State {
        let bound_sign = bound.coefficients()[0].signum();
        let weights: i128 = self.row.terms().iter().map(|(_, weight)| i128::from(*weight)).sum();
        // The error of a sum and of the bound together.
        let slack = error * (weights + 1);
        let signs: Vec<i128> = self.forms.iter().map(typical_sign).collect();
        let (mut below, mut above, mut settled) = (true, true, true);
        for (k, d) in bound.coefficients().iter().enumerate() {
            let (sizes, signed) = self.sums(k, &signs);
            // |d| is at most the mean of the |d_k|; at least it is only if they have one sign.
            above &= signed - slack >= d.abs();
            let pole_free = d * bound_sign > error;
            below &= pole_free && sizes + slack < d.abs();
            settled &= pole_free && sizes - signed <= 2 * slack;
        }
        match (below, above, settled) {
            (true, _, _) => State::Below,
            (_, true, _) => State::Above,
            (_, _, true) => State::Settled,
            _ => State::Open,
        }
    }

    /// `Σ weight |b_ik|` and `Σ weight s_i b_ik`.
    fn sums(&self, k: usize, signs: &[i128]) -> (i128, i128) {
        let terms = self.forms.iter().zip(signs).zip(self.row.terms());
        terms.fold((0, 0), |(sizes, signed), ((form, sign), (_, weight))| {
            let b = form.coefficients()[k] * i128::from(*weight);
            (sizes + b.abs(), signed + sign * b)
        })
    }
}

/// The sign of the middle coefficient, or of the largest one if that is zero.
fn typical_sign(form: &RoundedBernstein) -> i128 {
    let b = form.coefficients();
    let middle = b[b.len() / 2].signum();
    let largest = || b.iter().max_by_key(|b| b.abs()).map_or(0, |b| b.signum());
    if middle == 0 { largest() } else { middle }
}
