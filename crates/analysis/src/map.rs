//! Where in a box of two parameters a family is C^n, and where it is not.

use std::sync::{Arc, OnceLock};

use refinable_algebra::{Parameter, Polynomial, Rational, Ring, rational};
use refinable_certificate::{
    Cell, CellVerdict, Conclusion, Inequality, Line, MAP_FORMAT, MapCertificate, MapChecker, Node,
    Number, Polygon, Section, Terms, VERSION, parts_of_box, verify_map,
};
use refinable_reals::RealAlgebraic;
use refinable_scheme::{Diagnostic, Normalised, geometric_factor};
use refinable_spectral::{Effort, Window, outline, partition};

use crate::area::Area;
use crate::continuity::{Sharpness, region_of};
use crate::line::{Line as LineOfMasks, radius_bound};
use crate::plane::{Plane, Special};
use crate::proof::Proof;

/// A map with its certificate, checked.
#[derive(Clone, Debug)]
pub struct Map {
    /// The family.
    pub plane: Plane,
    /// The proof.
    pub certificate: MapCertificate,
    /// The pieces of the plane of `(x, y)`, as the certificate proves them.
    pub cells: Vec<Cell>,
    checker: Arc<MapChecker>,
    /// The parts of the box, the line of each node that is cut, the verdict of each that is not.
    parts: Vec<Polygon>,
    lines: Vec<Option<Line>>,
    verdicts: Vec<Option<CellVerdict>>,
    areas: OnceLock<[Area; 3]>,
}

/// What a map says at a point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MapVerdict {
    /// C^n holds.
    Proved,
    /// C^n fails.
    Refuted,
    /// Nothing is said: the point is in no decided piece, the shifts may be unstable there, or it is a pole.
    Undecided,
}

/// When a map is fine enough.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fineness {
    /// The part of the proved area that may be left undecided, about.
    pub undecided: Rational,
    /// The number of nodes of the certificate beyond which nothing is cut any more.
    pub nodes: usize,
}

impl Default for Fineness {
    /// A hundred and sixtieth part, but for a minute of work at the most and a few megabytes.
    fn default() -> Self {
        Fineness { undecided: rational(1, 160), nodes: 8000 }
    }
}

/// The box that shows where C^n holds, with some margin.
///
/// # Errors
/// Code `parameters` if the family has no map, `budget` if its arity is above ten.
pub fn default_window(
    name: &str,
    mask: &Normalised,
    continuity: usize,
) -> Result<Window, Diagnostic> {
    let plane = Plane::new(name, mask)?;
    let order = plane.order().max(1);
    // Beyond the order C^n holds on curves only: show where the highest order below holds.
    let bound = radius_bound(plane.arity(), order, continuity.min(order - 1));
    Ok(outline(&plane.pencil_in_parameters(order, &bound)))
}

/// Divides a box into pieces on which C^n is proved, refuted or left undecided.
///
/// # Errors
/// Those of `divisible_plane`: code `parameters`, `budget`, `box` or `divisibility`; `certificate` if
/// the proof does not hold or the family is too large for it.
///
/// # Cost
/// That of [`partition`] and of the checker for all its pieces; a minute with the default [`Fineness`] for
/// masks of eleven coefficients.
///
/// # Source
/// Path-complete graphs of ellipsoids (Ahmadi, Jungers, Parrilo and Roozbehani 2014) that move with the
/// point; the proofs are in `docs/certificates.md`.
pub fn map(
    name: &str,
    mask: &Normalised,
    continuity: usize,
    window: &Window,
    fineness: &Fineness,
) -> Result<Map, Diagnostic> {
    let plane = divisible_plane(name, mask, window)?;
    expect_readable_degree(&plane)?;
    let order = plane.order();
    let family = plane.family(order);
    let checker = MapChecker::new(&family, continuity).map_err(invalid)?;
    let stable_at = generic_point(&plane, window, &checker).map(|p| p.map(Number));
    let numbers = window.clone().map(|span| span.map(Number));
    let parts = parts_of_box(&family, &numbers).map_err(invalid)?;
    let (roots, mut nodes, sections);
    if continuity < order {
        let pencil = plane.pencil(order, &radius_bound(plane.arity(), order, continuity));
        let effort = Effort { rest: fineness.undecided.clone(), nodes: fineness.nodes };
        (roots, nodes) = partition(&pencil, &checker, &parts, plane.factor(), &effort);
        if continuity > 0 && stable_at.is_none() {
            forget_refuted(&mut nodes);
        }
        sections = Vec::new();
    } else {
        let node = if stable_at.is_some() { Node::Indivisible } else { Node::Undecided };
        roots = (0..parts.len()).collect();
        nodes = vec![node; parts.len()];
        sections = on_special(&plane, window, continuity);
    }
    let certificate = MapCertificate {
        format: MAP_FORMAT.into(),
        version: VERSION,
        family,
        continuity,
        window: numbers,
        stable_at,
        roots,
        nodes,
        sections,
    };
    Map::checked(plane, certificate, checker)
}

/// The map that a certificate proves, if it is about this family and order; without any search.
///
/// # Errors
/// Those of [`map`]; code `certificate` if it does not hold or is about something else.
pub fn certified_map(
    name: &str,
    mask: &Normalised,
    continuity: usize,
    certificate: MapCertificate,
) -> Result<Map, Diagnostic> {
    let plane = Plane::new(name, mask)?;
    let family = plane.family(plane.order());
    if certificate.family != family || certificate.continuity != continuity {
        return Err(Diagnostic::new("certificate", format!("not about C^{continuity} of {name}")));
    }
    let checker = MapChecker::new(&family, continuity).map_err(invalid)?;
    Map::checked(plane, certificate, checker)
}

fn invalid(invalid: refinable_certificate::Invalid) -> Diagnostic {
    Diagnostic::new("certificate", format!("the certificate does not hold: {invalid}"))
}

/// The plane of a family that can be looked at in a box.
///
/// # Errors
/// Code `parameters` if the family has no map, `budget` if its arity is above ten, `box` if the box is empty,
/// `divisibility` if `σ` does not divide.
pub(crate) fn divisible_plane(
    name: &str,
    mask: &Normalised,
    window: &Window,
) -> Result<Plane, Diagnostic> {
    let plane = Plane::new(name, mask)?;
    check_window(&plane, window)?;
    if plane.order() == 0 {
        let factor = geometric_factor(plane.arity());
        let message =
            format!("{factor} does not divide the symbol for all values of the parameters");
        return Err(Diagnostic::new("divisibility", message));
    }
    Ok(plane)
}

fn check_window(plane: &Plane, window: &Window) -> Result<(), Diagnostic> {
    let [u, v] = plane.parameters();
    for [low, high] in window {
        if low >= high {
            let message = format!("the box is empty: {low} is not less than {high}");
            let hint = format!("give the lower end first: --box '{u}=-1/4..3/4,{v}=-1/2..1/2'");
            return Err(Diagnostic::new("box", message).with_hint(hint));
        }
    }
    Ok(())
}

/// Asked before a search: whether a checker reads masks of such a degree.
fn expect_readable_degree(plane: &Plane) -> Result<(), Diagnostic> {
    let degree = plane.degree();
    if degree <= MOST_DEGREE {
        return Ok(());
    }
    let message = format!(
        "the mask has degree {degree} in its parameters, and maps are read up to {MOST_DEGREE}"
    );
    let [_, v] = plane.parameters();
    let hint = format!("set one of them and ask for the `range` of the other: --set {v}=VALUE");
    Err(Diagnostic::new("budget", message).with_hint(hint))
}

/// A point near the middle of the box at which the shifts are stable, as they are almost everywhere.
fn generic_point(plane: &Plane, window: &Window, checker: &MapChecker) -> Option<[Rational; 2]> {
    let candidates = [(5, 7), (3, 4), (6, 5), (2, 9), (8, 3), (7, 8)];
    candidates.into_iter().find_map(|(i, j)| {
        let at = |[low, high]: &[Rational; 2], k| low + (high - low) * rational(k, 11);
        let point = plane.point(&[at(&window[0], i), at(&window[1], j)]);
        checker.is_generic(&point).then_some(point)
    })
}

/// Without stable shifts a large eigenvalue refutes nothing, unless it is so large that the scheme diverges;
/// those pieces are given up as well.
fn forget_refuted(nodes: &mut [Node]) {
    for node in nodes {
        if matches!(node, Node::Word(_) | Node::Expansion(_)) {
            *node = Node::Undecided;
        }
    }
}

/// C^n where `σ^(n+1)` divides, as far as this is known.
fn on_special(plane: &Plane, window: &Window, continuity: usize) -> Vec<Section> {
    let section = |special: Special| {
        let [origin, direction] = match special {
            Special::Line(line) => *line,
            Special::Point(at) | Special::Mask(at) => [at, [Rational::zero(), Rational::zero()]],
        };
        let masks = plane.along(&origin, &direction)?;
        let moves = direction.iter().any(|d| !d.is_zero());
        let parameter = moves.then(|| Parameter::new("t"));
        let line = LineOfMasks::through(plane.name(), plane.arity(), parameter, masks);
        let sharpness = Sharpness::default();
        let mut proof = Proof::new(&line, line.order(), continuity, &sharpness);
        proof.search();
        let certificate = proof.certificate();
        Some(Section { origin: origin.map(Number), direction: direction.map(Number), certificate })
    };
    plane.special(continuity + 1, window).into_iter().filter_map(section).collect()
}

/// The largest total degree of the numerators and the denominator of a map.
const MOST_DEGREE: u32 = 6;

type Form = Polynomial<Polynomial<Rational>>;

impl Map {
    fn checked(
        plane: Plane,
        certificate: MapCertificate,
        checker: MapChecker,
    ) -> Result<Map, Diagnostic> {
        let cells = verify_map(&certificate).map_err(invalid)?;
        let mut verdicts = vec![None; certificate.nodes.len()];
        cells.iter().for_each(|cell| verdicts[cell.node] = Some(cell.verdict));
        let line = |node: &Node| match node {
            Node::Cut { line: [a, b, c], .. } => Line::new(&a.0, &b.0, &c.0),
            _ => None,
        };
        let lines = certificate.nodes.iter().map(line).collect();
        let parts = parts_of_box(&certificate.family, &certificate.window).map_err(invalid)?;
        let checker = checker.into();
        let areas = OnceLock::new();
        Ok(Map { plane, certificate, cells, checker, parts, lines, verdicts, areas })
    }

    /// The order `n`.
    pub fn continuity(&self) -> usize {
        self.certificate.continuity
    }

    /// The box.
    pub fn window(&self) -> Window {
        self.certificate.window.clone().map(|span| span.map(|end| end.0))
    }

    /// What the map says at a point; nothing outside of the box.
    ///
    /// # Cost
    /// One comparison for each cut on the way down to the piece.
    pub fn verdict_at(&self, parameters: &[Rational; 2]) -> MapVerdict {
        let point = self.plane.point(parameters);
        if self.plane.is_pole(&point) {
            return MapVerdict::Undecided;
        }
        let roots = self.parts.iter().zip(&self.certificate.roots);
        let mut open: Vec<usize> =
            roots.filter(|(part, _)| part.contains(&point)).map(|(_, &root)| root).collect();
        let mut verdicts = Vec::new();
        while let Some(at) = open.pop() {
            match (&self.certificate.nodes[at], &self.lines[at]) {
                (Node::Cut { below, above, .. }, Some(line)) => {
                    // A point on the line belongs to both parts.
                    let side = line.compare(&point);
                    open.extend(side.is_le().then_some(*below));
                    open.extend(side.is_ge().then_some(*above));
                }
                _ => verdicts.extend(self.verdicts[at]),
            }
        }
        self.combined(&verdicts, &point)
    }

    /// What closed pieces that contain a point say together.
    fn combined(&self, verdicts: &[CellVerdict], point: &[Rational; 2]) -> MapVerdict {
        let says = |verdict: CellVerdict| verdicts.contains(&verdict);
        if says(CellVerdict::Proved) {
            return MapVerdict::Proved;
        }
        let beyond = self.continuity() >= self.certificate.family.order;
        if beyond && self.divides_at(point) {
            return self.on_section(point);
        }
        let refuted = says(CellVerdict::Refuted { if_stable: false })
            || says(CellVerdict::Refuted { if_stable: true }) && self.checker.is_stable(point);
        if refuted { MapVerdict::Refuted } else { MapVerdict::Undecided }
    }

    /// Whether `σ^(n+1)` divides the symbol at a point of the plane of `(x, y)`.
    fn divides_at(&self, [x, y]: &[Rational; 2]) -> bool {
        let conditions = self.plane.divisibility(self.continuity() + 1);
        let value = |c: &Form| c.map(|row| row.evaluate(x)).evaluate(y);
        conditions.iter().all(|c| value(c).is_zero())
    }

    /// What is proved at a point on the line of a section, or with the mask of one.
    fn on_section(&self, point: &[Rational; 2]) -> MapVerdict {
        let at = |section: &Section| {
            let [origin, direction] =
                [&section.origin, &section.direction].map(|p| p.each_ref().map(|c| c.0.clone()));
            let Some(moving) = (0..2).find(|&i| !direction[i].is_zero()) else {
                let same = self.plane.mask_at(&origin) == self.plane.mask_at(point);
                return same.then(|| RealAlgebraic::from(Rational::zero()));
            };
            let t = (&point[moving] - &origin[moving]) / &direction[moving];
            let there = (0..2).all(|i| &origin[i] + &direction[i] * &t == point[i]);
            there.then(|| RealAlgebraic::from(t))
        };
        let found = self.certificate.sections.iter().find_map(|s| Some((at(s)?, &s.certificate)));
        let Some((t, certificate)) = found else { return MapVerdict::Undecided };
        match &certificate.conclusion {
            Conclusion::Continuity { proved, .. } if region_of(proved).contains(&t) => {
                MapVerdict::Proved
            }
            Conclusion::Continuity { refuted, .. } if region_of(refuted).contains(&t) => {
                MapVerdict::Refuted
            }
            _ => MapVerdict::Undecided,
        }
    }

    /// The inequalities up to the boundary by which pieces are refuted, each once, with the polynomial in
    /// `x` and `y` that vanishes on the boundary.
    pub fn boundaries(&self) -> Vec<(Inequality, Terms)> {
        let mut used: Vec<&Inequality> = Vec::new();
        for node in &self.certificate.nodes {
            if let Node::Word(inequality) = node
                && inequality.radius == 1
                && !used.contains(&inequality)
            {
                used.push(inequality);
            }
        }
        used.sort();
        let of = |inequality: &Inequality| {
            let all = self.checker.inequalities(&inequality.word, &[1]);
            all.into_iter().find(|(known, _)| known == inequality)
        };
        used.into_iter().filter_map(of).collect()
    }

    /// The areas, in the plane of the parameters, of what is proved, refuted and undecided.
    pub fn areas(&self) -> &[Area; 3] {
        self.areas.get_or_init(|| {
            let verdict = |cell: &Cell| match cell.verdict {
                CellVerdict::Proved => 0,
                CellVerdict::Refuted { .. } => 1,
                CellVerdict::Undecided => 2,
            };
            [0, 1, 2].map(|k| {
                let cells = self.cells.iter().filter(|cell| verdict(cell) == k);
                let polygons: Vec<&Polygon> = cells.map(|cell| &cell.polygon).collect();
                Area::of(&polygons, self.plane.factor())
            })
        })
    }
}
