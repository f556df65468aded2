//! The Hölder exponent over two parameters: how it runs, and where it is largest; over one parameter, where it is
//! largest.

use refinable_algebra::{Integer, Rational, Ring};
use refinable_reals::{Interval, Region, common_roots};
use refinable_scheme::{Diagnostic, Normalised};
use refinable_spectral::{Options, PlanePencil, Window, decay, slowest};

use crate::budget::expect_readable_words;
use crate::line::{Line, letters};
use crate::map::divisible_plane;
use crate::plane::{Plane, Special, contains};
use crate::regularity::{Regularity, regularity};

/// The Hölder exponents of a family in a box.
#[derive(Clone, Debug)]
pub struct Landscape {
    /// The family.
    pub plane: Plane,
    /// The box.
    pub window: Window,
    /// Nodes of the grid in each direction.
    pub nodes: [usize; 2],
    /// The exponent where the symbol is divisible as often as everywhere, at each node, row by row from
    /// the lower end of the box. Approximate, for pictures: short words only.
    pub exponents: Vec<Rational>,
    /// The smoothest members that were found, those of the whole box first.
    pub summits: Vec<Summit>,
    /// Where a smooth member was found but its exponent was not enclosed.
    pub missed: Vec<Locus>,
}

/// A smooth member.
#[derive(Clone, Debug)]
pub struct Summit {
    /// Where in the plane it is the smoothest.
    pub locus: Locus,
    /// The parameters `u` and `v` of the plane.
    pub parameters: [Rational; 2],
    /// Its exponent, proved.
    pub regularity: Regularity,
}

/// Where a symbol is divisible more often than elsewhere.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Locus {
    /// Nowhere.
    Plane,
    /// On the line through a point of the plane of `(x, y)` in a direction.
    Line(Box<[[Rational; 2]; 2]>),
    /// At a point.
    Point,
    /// Wherever the mask is that at a point.
    Mask,
}

/// How near to the least growth summits are, as powers of two, tried in turn.
const TOLERANCES: [u32; 5] = [12, 9, 7, 6, 4];
/// The same where a summit has to be found at once: nearer to the least growth more words grow nearly as fast as the fastest,
/// and a proof takes a minute or fails.
const COARSE: [u32; 2] = [5, 4];
/// The same for simple numbers.
const NEAR: [u32; 1] = [12];
/// Beside an end that is left out: as far as this part of half of the interval.
const BESIDE: i64 = 128;
/// Steps on each line.
const STEPS: i64 = 512;

/// How the exponent runs in a box, and its largest values on the plane and on the lines and at the points
/// where a higher power of `σ` divides. Where they are is searched for; the exponents are proved.
///
/// # Errors
/// Code `parameters` if the family has no map, `budget` if its arity is above ten, `box` if the box is empty,
/// `divisibility` if `σ` does not divide.
///
/// # Cost
/// A search with floats over the box and along each line, and [`regularity`] for the best members found.
pub fn landscape(
    name: &str,
    mask: &Normalised,
    window: &Window,
    nodes: [usize; 2],
) -> Result<Landscape, Diagnostic> {
    let plane = divisible_plane(name, mask, window)?;
    let order = plane.order();
    let pencil = plane.pencil_in_parameters(order, &Rational::one());
    let whole = Rational::from_i64(order as i64 - 1);
    let exponents = decay(&pencil, window, nodes).into_iter().map(|d| &whole + d).collect();
    let mut places = vec![(Locus::Plane, slowest(&pencil, window, &TOLERANCES))];
    places.extend(special_places(&plane, window));
    let (mut summits, mut missed) = (Vec::new(), Vec::new());
    for (locus, choices) in places {
        // Where eigenvalues meet the radius may escape: a place not quite so smooth does as well.
        let summit = choices.into_iter().find_map(|parameters| {
            let member = mask.at(&plane.in_order(&parameters)).ok()?;
            let regularity = regularity(name, &member, &Options::default()).ok()?;
            Some(Summit { locus: locus.clone(), parameters, regularity })
        });
        match summit {
            Some(summit) => summits.push(summit),
            None => missed.push(locus),
        }
    }
    Ok(Landscape { plane, window: window.clone(), nodes, exponents, summits, missed })
}

impl Landscape {
    /// The summit with the largest exponent that is proved.
    pub fn highest(&self) -> Option<&Summit> {
        self.summits.iter().max_by(|a, b| a.regularity.lower.cmp(&b.regularity.lower))
    }
}

/// The smoothest places in the box on each line and at each point where a higher power divides.
fn special_places(plane: &Plane, window: &Window) -> Vec<(Locus, Vec<[Rational; 2]>)> {
    let mut found = Vec::new();
    let mut seen = Vec::new();
    for order in plane.order() + 1..=plane.highest_order() {
        let special = plane.special(order, window);
        for place in special.into_iter().filter(|place| !seen.contains(place)).collect::<Vec<_>>() {
            let at = |point: &[Rational; 2]| {
                plane.parameters_at(point).filter(|p| contains(window, p)).map(|p| vec![p])
            };
            match &place {
                Special::Line(line) => {
                    let [origin, direction] = &**line;
                    let places = slowest_on(plane, window, origin, direction).into_iter();
                    found.extend(places.map(|choices| (Locus::Line(line.clone()), choices)));
                }
                Special::Point(point) => found.extend(at(point).map(|p| (Locus::Point, p))),
                Special::Mask(point) => found.extend(at(point).map(|p| (Locus::Mask, p))),
            }
            seen.push(place);
        }
    }
    found
}

/// Places at which words grow least, for each part of a line that is in the box.
fn slowest_on(
    plane: &Plane,
    window: &Window,
    origin: &[Rational; 2],
    direction: &[Rational; 2],
) -> Vec<Vec<[Rational; 2]>> {
    let Some(masks) = plane.along(origin, direction) else { return Vec::new() };
    let line = Line::through(plane.name(), plane.arity(), None, masks);
    let point = |t: &Rational| {
        let point = [0, 1].map(|i| &origin[i] + &direction[i] * t);
        plane.parameters_at(&point).filter(|parameters| contains(window, parameters))
    };
    // Where the line enters and leaves the strip of the first parameter, or, if this is constant, the box.
    let mut ends = if direction[0].is_zero() {
        let l = plane.factor().map_or_else(Rational::one, |l| l.evaluate(&origin[0]));
        window[1].each_ref().map(|v| (v * &l - &origin[1]) / &direction[1])
    } else {
        window[0].each_ref().map(|x| (x - &origin[0]) / &direction[0])
    };
    ends.sort();
    let [low, high] = ends;
    let step = (&high - &low) / Rational::from_i64(STEPS);
    let nodes: Vec<Rational> = (0..=STEPS).map(|k| &low + &step * Rational::from_i64(k)).collect();
    let runs = nodes.split(|t| point(t).is_none()).filter(|run| run.len() > 1);
    let slowest = runs.map(|run| {
        let span = [run[0].clone(), run[run.len() - 1].clone()];
        slowest_between(&line, span, &TOLERANCES).iter().filter_map(&point).collect()
    });
    slowest.collect()
}

/// Places at which words grow least between two `x` of a line, for each tolerance.
fn slowest_between(line: &Line, span: [Rational; 2], tolerances: &[u32]) -> Vec<Rational> {
    let order = line.order();
    let scale = Rational::from_i64(line.arity() as i64).power(order as u32 - 1);
    let (base, direction) = line.parts();
    let of = |part| letters(part, line.arity(), order, line.extent(), &scale);
    let pencil = PlanePencil::new(&[(0, 0, of(base)), (1, 0, of(direction))]);
    let zero = [Rational::zero(), Rational::zero()];
    let places = slowest(&pencil, &[span, zero], tolerances);
    places.into_iter().map(|[x, _]| x).collect()
}

/// The smoothest member of a family of one parameter that is found in a set of its values, where the family
/// converges, and its exponent. Where it is is searched for; the exponent is proved.
///
/// `None` if no exponent was enclosed: the family runs along no line of masks, its arity is above ten, or the set is
/// empty or holds single irrational values only. Unbounded intervals are not searched.
///
/// # Cost
/// One search with floats for each interval, and [`regularity`] at one value or a few.
pub fn smoothest_in(
    name: &str,
    mask: &Normalised,
    region: &Region,
) -> Option<(Rational, Regularity)> {
    let line = Line::new(name, mask)?;
    expect_readable_words(mask.arity()).ok()?;
    let certified = |t: Rational| {
        let member = mask.at(std::slice::from_ref(&t)).ok()?;
        Some((t, regularity(name, &member, &Options::default()).ok()?))
    };
    // Where the order rises there is often a summit; and so there is at simple numbers.
    let special = common_roots(&line.divisibility(line.order() + 1)).into_iter();
    let special = special.filter_map(|x| x.as_rational().cloned()).flat_map(|x| line.lift(&x));
    let mut found: Vec<_> =
        special.filter(|t| region.contains_rational(t)).filter_map(certified).collect();
    for interval in region.intervals() {
        let Some(point) = interval.as_point() else {
            let (simple, rounded) = places_in(&line, &interval);
            found.extend(simple.and_then(certified));
            found.extend(rounded.into_iter().find_map(certified));
            continue;
        };
        found.extend(point.as_rational().cloned().and_then(certified));
    }
    // The first of equal ones.
    found.into_iter().reduce(|best, next| if next.1.lower > best.1.lower { next } else { best })
}

/// The largest denominator of a simple number.
const SIMPLE: i64 = 64;

/// Values of the family's parameter near where words grow least in an interval: a simple number very near, if there is
/// one, and others that are less near.
fn places_in(line: &Line, interval: &Interval) -> (Option<Rational>, Vec<Rational>) {
    let width = Rational::new(1.into(), Integer::from(1) << 60usize);
    let (Some(lower), Some(upper)) = (interval.lower.number(), interval.upper.number()) else {
        return (None, Vec::new());
    };
    let ends = [lower.enclosure(&width).1, upper.enclosure(&width).0];
    let Some(span) = line.span(&ends) else { return (None, Vec::new()) };
    let near = slowest_between(line, span.clone(), &NEAR);
    let radius = (&ends[1] - &ends[0]) / Rational::from_i64(512);
    let simple =
        near.iter().flat_map(|x| line.lift(x)).map(|t| simplest(&(&t - &radius), &(t + &radius)));
    let region = Region::from(interval);
    let simple = simple
        .into_iter()
        .find(|t| *t.denom() <= Integer::from(SIMPLE) && region.contains_rational(t));
    let places = slowest_between(line, span, &COARSE);
    // The search may come to an end that does not belong to the interval: beside it then.
    let middle = (&ends[0] + &ends[1]) / Rational::from_i64(2);
    let inward = |t: Rational| match region.contains_rational(&t) {
        true => t,
        false => &t + (&middle - &t) / Rational::from_i64(BESIDE),
    };
    let found = places.iter().flat_map(|x| line.lift(x)).map(inward);
    (simple, found.filter(|t| region.contains_rational(t)).collect())
}

/// The number with the smallest denominator between two, `a < b`, by continued fractions.
fn simplest(a: &Rational, b: &Rational) -> Rational {
    let whole = a.ceil();
    if whole <= *b {
        // The whole number nearest to zero.
        let last = b.floor();
        return Rational::zero().clamp(whole, last);
    }
    let floor = a.floor();
    &floor + simplest(&(b - &floor).recip(), &(a - &floor).recip()).recip()
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    /// By looking at all numbers with smaller denominators.
    #[test]
    fn the_simplest_number_between_two() {
        let samples = (-40..40).map(|k| (rational(k, 13), rational(k, 13) + rational(1, 9)));
        for (a, b) in
            samples.chain((-40..40).map(|k| (rational(k, 7), rational(k, 7) + rational(1, 200))))
        {
            let found = simplest(&a, &b);
            let denominator = (1..).find(|d| {
                let d = Rational::from_i64(*d);
                (&a * &d).ceil() <= (&b * &d).floor()
            });
            assert!(a <= found && found <= b);
            assert_eq!(*found.denom(), Integer::from(denominator.unwrap()), "{a} {b}");
        }
        assert_eq!(simplest(&rational(-5, 2), &rational(7, 2)), rational(0, 1));
        assert_eq!(simplest(&rational(-7, 2), &rational(-5, 2)), rational(-3, 1));
    }
}
