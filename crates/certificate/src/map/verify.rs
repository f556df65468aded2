//! All nodes of a map, and what is proved where.

use std::collections::BTreeMap;

use rayon::prelude::*;
use refinable_algebra::{Integer, Ordered, Rational};

use crate::error::{Invalid, Part};
use crate::family::Scheme;
use crate::map::family::{PlaneScheme, Polar, check_section, parts};
use crate::map::form::{self, Form, is_nowhere_positive};
use crate::map::inequality::{Blocks, polynomial};
use crate::map::model::{
    Eigenvalue, Ellipsoids, Expansion, Inequality, MAP_FORMAT, MapCertificate, Node, PlaneFamily,
    Section, Terms,
};
use crate::map::polygon::{Line, Polygon};
use crate::map::quadratic::Letters;
use crate::map::stability::{is_generic, is_stable};
use crate::model::{Conclusion, VERSION};
use crate::number::Number;
use crate::verify::verify;
use crate::work::{Check, Reason, Work, ensure, fail, rational_bits};

/// What is proved on a piece of a map.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum CellVerdict {
    /// C^n holds everywhere on it.
    Proved,
    /// C^n fails on it, but for the points at which `σ^(n+1)` divides the symbol if `n` is not less than the order `k`, and
    /// for poles, where there is no scheme: everywhere else, or wherever the shifts are stable.
    Refuted {
        /// Whether stable shifts are needed.
        if_stable: bool,
    },
    /// Nothing is claimed.
    Undecided,
}

/// A convex piece of the plane of `(x, y)`, closed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cell {
    /// Where.
    pub polygon: Polygon,
    /// What is proved.
    pub verdict: CellVerdict,
    /// Its node.
    pub node: usize,
}

/// Checks pieces of a map, one at a time.
#[derive(Debug)]
pub struct MapChecker {
    scheme: PlaneScheme,
    continuity: usize,
    /// The difference symbol of the order `n + 1`, if there is one.
    lower: Option<Vec<Form>>,
    /// The matrices, if `n` is less than the order.
    letters: Option<Letters>,
}

impl MapChecker {
    /// For C^n of a family.
    ///
    /// # Errors
    /// [`Invalid`] if the family is not affine, normalised and divisible as it says, or too large.
    pub fn new(family: &PlaneFamily, continuity: usize) -> Result<MapChecker, Invalid> {
        let scheme = PlaneScheme::new(family).map_err(invalid(Part::Family))?;
        let lower = match scheme.bound(continuity) {
            Ok(_) => Some(scheme.lower_difference(continuity).map_err(invalid(Part::Family))?),
            Err(_) => None,
        };
        let letters = scheme.bound(continuity).ok().map(|bound| Letters::new(&scheme, &bound));
        Ok(MapChecker { scheme, continuity, lower, letters })
    }

    /// Whether `‖c_n‖ < 1` on the closed polygon: the absolute values of numerators of a row sum to less than that
    /// of the denominator, which has one sign at all control points, so that it has no zero on the polygon.
    pub fn has_small_norm(&self, polygon: &Polygon) -> bool {
        self.check_norm(polygon, &mut Work::new()).is_ok()
    }

    fn check_norm(&self, polygon: &Polygon, work: &mut Work) -> Check<()> {
        let Some(lower) = &self.lower else {
            return fail("the continuity is not less than the order");
        };
        let controls = self.scheme.controls(lower, polygon, work)?;
        let m = self.scheme.arity;
        let small = |Polar { values, denominator, .. }: &Polar| {
            (0..m).all(|j| {
                let row = values.iter().skip(j).step_by(m).map(Ordered::absolute);
                row.sum::<Integer>() < denominator.absolute()
            })
        };
        let is_positive = |polar: &Polar| polar.denominator.compare_to_zero().is_gt();
        let one_sign =
            controls.windows(2).all(|pair| is_positive(&pair[0]) == is_positive(&pair[1]));
        ensure(one_sign && controls.iter().all(small), "the norm is not below one")
    }

    /// Whether the ellipsoids prove C^n on the closed polygon.
    pub fn accepts(&self, polygon: &Polygon, ellipsoids: &Ellipsoids) -> bool {
        self.check_ellipsoids(polygon, ellipsoids, &mut Work::new()).is_ok()
    }

    /// Whether the forms refute C^n on the closed polygon, if the shifts are stable.
    pub fn accepts_expansion(&self, polygon: &Polygon, expansion: &Expansion) -> bool {
        self.check_expansion(polygon, expansion, &mut Work::new()).is_ok()
    }

    /// All inequalities for the blocks of a word with some radii, as polynomials in `x` and `y` that are
    /// not positive only where the radius is reached. Those of too high a degree are left out.
    pub fn inequalities(&self, word: &str, radii: &[u64]) -> Vec<(Inequality, Terms)> {
        let work = &mut Work::new();
        let Ok(blocks) = Blocks::new(&self.scheme, self.continuity, word, work) else {
            return Vec::new();
        };
        let kinds = [Eigenvalue::Positive, Eigenvalue::Negative, Eigenvalue::Pair];
        let all = radii.iter().flat_map(|&radius| {
            (0..blocks.count()).flat_map(move |block| kinds.map(|kind| (radius, block, kind)))
        });
        all.filter_map(|(radius, block, eigenvalue)| {
            let form = blocks.polynomial(block, eigenvalue, radius, &mut Work::new()).ok()?;
            let inequality = Inequality { word: word.into(), block, eigenvalue, radius };
            Some((inequality, terms(&form)))
        })
        .collect()
    }

    /// Whether the inequality holds on the closed polygon.
    pub fn refutes(&self, polygon: &Polygon, inequality: &Inequality) -> bool {
        let form = polynomial(&self.scheme, self.continuity, inequality);
        form.and_then(|(form, _)| is_nowhere_positive(&form, polygon, &mut Work::new()))
            .unwrap_or(false)
    }

    /// Whether the shifts are stable at a point of the plane for a reason that holds almost everywhere.
    pub fn is_generic(&self, point: &[Rational; 2]) -> bool {
        is_generic(&self.scheme, point, &mut Work::new()).unwrap_or(false)
    }

    /// Whether the shifts are shown to be stable at one point of the plane, which says nothing about others.
    pub fn is_stable(&self, point: &[Rational; 2]) -> bool {
        is_stable(&self.scheme, point, &mut Work::new()).unwrap_or(false)
    }

    fn letters(&self) -> Check<&Letters> {
        self.letters.as_ref().map_or_else(|| fail("the continuity is not less than the order"), Ok)
    }

    fn check_ellipsoids(
        &self,
        polygon: &Polygon,
        ellipsoids: &Ellipsoids,
        work: &mut Work,
    ) -> Check<()> {
        self.letters()?.check_ellipsoids(&self.scheme, polygon, ellipsoids, work)
    }

    fn check_expansion(
        &self,
        polygon: &Polygon,
        expansion: &Expansion,
        work: &mut Work,
    ) -> Check<()> {
        self.letters()?.check_expansion(&self.scheme, polygon, expansion, work)
    }
}

fn terms(form: &Form) -> Terms {
    let term = |(i, j, c): (usize, usize, &Integer)| {
        (Number(Rational::from(c.clone())), i as u32, j as u32)
    };
    form::terms(form).map(term).collect()
}

fn invalid(part: Part) -> impl Fn(Reason) -> Invalid {
    move |Reason(reason)| Invalid { part: part.clone(), reason }
}

/// Checks a map: the family, that the pieces make up the box, and the proof on every piece. Returns
/// the pieces. The answer does not depend on the number of threads.
///
/// # Errors
/// [`Invalid`]: the first thing that fails.
///
/// # Cost
/// Bounded for each piece by the limits in `docs/certificates.md`; pieces are checked side by side.
pub fn verify_map(map: &MapCertificate) -> Result<Vec<Cell>, Invalid> {
    let known = map.format == MAP_FORMAT && map.version == VERSION;
    ensure(known, "an unknown format or version").map_err(invalid(Part::Family))?;
    let checker = MapChecker::new(&map.family, map.continuity)?;
    let short = map.stable_at.iter().flatten().all(is_short);
    ensure(short, "a point with numbers of more than 512 bits")
        .map_err(invalid(Part::Stability))?;
    ensure(map.sections.len() <= MOST_SECTIONS, "more than 50 sections")
        .map_err(invalid(Part::Section(MOST_SECTIONS)))?;
    let pieces = pieces(map).map_err(invalid(Part::Box))?;
    let reasons = Reasons::new(map, &checker)?;
    let check = |(node, polygon): (usize, Polygon)| {
        let verdict = reasons.check(&polygon, &map.nodes[node], &mut Work::new());
        let verdict = verdict.map_err(invalid(Part::Node(node)))?;
        Ok(Cell { polygon, verdict, node })
    };
    let cells: Vec<Result<Cell, Invalid>> = pieces.into_par_iter().map(check).collect();
    let cells = cells.into_iter().collect::<Result<_, _>>()?;
    for (index, section) in map.sections.iter().enumerate() {
        let checked = check_certificate(section, map.continuity);
        let scheme = checked.map_err(invalid(Part::Section(index)))?;
        let lowest = section.certificate.family.lowest;
        let [origin, direction] =
            [&section.origin, &section.direction].map(|p| [p[0].0.clone(), p[1].0.clone()]);
        check_section(&checker.scheme, (&scheme, lowest), &origin, &direction, &mut Work::new())
            .map_err(invalid(Part::Section(index)))?;
    }
    Ok(cells)
}

/// The box of a family as convex polygons of the plane of `(x, y)`: one, or two where the factor of the
/// chart vanishes inside of it.
///
/// # Errors
/// [`Invalid`] if the box is empty or the chart has no such factor.
pub fn parts_of_box(
    family: &PlaneFamily,
    window: &[[Number; 2]; 2],
) -> Result<Vec<Polygon>, Invalid> {
    parts(family, window).map_err(invalid(Part::Box))
}

/// The certificate of a section proves something about C^n.
fn check_certificate(section: &Section, continuity: usize) -> Check<Scheme> {
    let certificate = &section.certificate;
    let about = matches!(&certificate.conclusion,
        Conclusion::Continuity { continuity: n, .. } if *n == continuity);
    ensure(about, "a section is about something else")?;
    let short = section.origin.iter().chain(&section.direction).all(is_short);
    ensure(short, "a section with numbers of more than 512 bits")?;
    ensure(certificate.family.curve.is_none(), "a section that is a curve")?;
    verify(certificate).map_err(|invalid| Reason(invalid.to_string()))?;
    Scheme::new(&certificate.family, &mut Work::new())
}

const MOST_NODES: usize = 200_000;
const MOST_INEQUALITIES: usize = 500;
const MOST_CORNERS: usize = 50;
const MOST_SECTIONS: usize = 50;
const MOST_BITS: u64 = 512;

fn is_short(x: &Number) -> bool {
    rational_bits(&x.0) <= MOST_BITS
}

/// The pieces that are not cut further, with their nodes, in the order of the nodes. Every node is
/// reached once, from one before it or from the box.
fn pieces(map: &MapCertificate) -> Check<Vec<(usize, Polygon)>> {
    let short = map.window.iter().flatten().all(is_short);
    ensure(short, "a box with numbers of more than 512 bits")?;
    let parts = parts(&map.family, &map.window)?;
    ensure(parts.len() == map.roots.len(), "not one root for each part of the box")?;
    ensure(map.nodes.len() <= MOST_NODES, "more than 200000 nodes")?;
    let mut polygons: Vec<Option<Polygon>> = vec![None; map.nodes.len()];
    let place =
        |at: usize, after: Option<usize>, polygon: Polygon, all: &mut Vec<Option<Polygon>>| {
            let free = all.get(at).is_some_and(Option::is_none) && after.is_none_or(|n| n < at);
            ensure(free, "a node that does not exist, or is reached twice")?;
            all[at] = Some(polygon);
            Ok(())
        };
    for (&root, part) in map.roots.iter().zip(parts) {
        place(root, None, part, &mut polygons)?;
    }
    let mut leaves = Vec::new();
    for (index, node) in map.nodes.iter().enumerate() {
        let Some(polygon) = polygons[index].take() else {
            return fail("a node that is not reached");
        };
        let Node::Cut { line: [a, b, c], below, above } = node else {
            leaves.push((index, polygon));
            continue;
        };
        ensure([a, b, c].into_iter().all(is_short), "a cut by numbers of more than 512 bits")?;
        let Some(line) = Line::new(&a.0, &b.0, &c.0) else { return fail("a cut that is no line") };
        for (child, part) in [below, above].into_iter().zip(polygon.cut(&line)) {
            let Some(part) = part else { return fail("a cut that misses its piece") };
            ensure(part.corners().len() <= MOST_CORNERS, "a piece with more than 50 corners")?;
            place(*child, Some(index), part, &mut polygons)?;
        }
    }
    Ok(leaves)
}

/// What the proofs on the pieces have in common.
struct Reasons<'a> {
    checker: &'a MapChecker,
    /// Whether the shifts are stable almost everywhere.
    stable: bool,
    /// The polynomial of each inequality that occurs, and whether it shows divergence.
    inequalities: BTreeMap<&'a Inequality, (Form, bool)>,
}

impl<'a> Reasons<'a> {
    fn new(map: &'a MapCertificate, checker: &'a MapChecker) -> Result<Self, Invalid> {
        let stable = map.stable_at.as_ref().map(|[x, y]| [x.0.clone(), y.0.clone()]);
        let stable = match stable {
            None => false,
            Some(point) => {
                let generic = is_generic(&checker.scheme, &point, &mut Work::new());
                generic
                    .and_then(|generic| ensure(generic, "the shifts are not shown to be stable"))
                    .map_err(invalid(Part::Stability))?;
                true
            }
        };
        let mut inequalities = BTreeMap::new();
        for (index, node) in map.nodes.iter().enumerate() {
            if let Node::Word(inequality) = node
                && !inequalities.contains_key(inequality)
            {
                ensure(inequalities.len() < MOST_INEQUALITIES, "more than 500 inequalities")
                    .map_err(invalid(Part::Node(index)))?;
                let form = polynomial(&checker.scheme, checker.continuity, inequality);
                inequalities.insert(inequality, form.map_err(invalid(Part::Node(index)))?);
            }
        }
        Ok(Reasons { checker, stable, inequalities })
    }

    fn check(&self, polygon: &Polygon, node: &Node, work: &mut Work) -> Check<CellVerdict> {
        match node {
            Node::Cut { .. } | Node::Undecided => Ok(CellVerdict::Undecided),
            Node::Norm => {
                self.checker.check_norm(polygon, work)?;
                Ok(CellVerdict::Proved)
            }
            Node::Ellipsoids(ellipsoids) => {
                self.checker.check_ellipsoids(polygon, ellipsoids, work)?;
                Ok(CellVerdict::Proved)
            }
            Node::Expansion(expansion) => {
                self.checker.check_expansion(polygon, expansion, work)?;
                self.refuted(self.checker.continuity > 0)
            }
            Node::Word(inequality) => {
                let (form, diverges) = &self.inequalities[inequality];
                let holds = is_nowhere_positive(form, polygon, work)?;
                ensure(holds, "the inequality is not shown to hold")?;
                self.refuted(!diverges)
            }
            Node::Indivisible => {
                let order = self.checker.continuity.saturating_add(1);
                let divisible = self.checker.scheme.is_divisible(order);
                ensure(!divisible, "the power of σ divides the symbol")?;
                self.refuted(true)
            }
        }
    }

    fn refuted(&self, if_stable: bool) -> Check<CellVerdict> {
        ensure(!if_stable || self.stable, "stable shifts are needed and not shown")?;
        Ok(CellVerdict::Refuted { if_stable })
    }
}
