//! Pages about the families of two parameters: their maps, with the paper's curves on them.

use std::collections::{BTreeMap, BTreeSet};

use refinable_algebra::{Parameter, Rational, rational};
use refinable_analysis::{Fineness, Map, Plane, Window, certified_map, default_window, map};
use refinable_certificate::{CellVerdict, MapCertificate};
use refinable_papers::{Claim, Table};
use refinable_scheme::{Diagnostic, Scheme, Substitution};

use crate::grid::Document;
use crate::map::Maps;
use crate::site::{CERTIFICATES, Site};

/// The folder of a report that holds the maps.
pub(crate) const MAPS: &str = "maps";

/// Certificates of maps by name, such as `map-a5-C3`.
pub type MapStore = BTreeMap<String, MapCertificate>;

/// The names of the families with two parameters in a paper's first tables.
const FAMILIES: [&str; 3] = ["a3", "a5", "a7"];

/// A picture of the maps of a family.
pub(crate) struct View {
    /// The name of its file.
    pub file: String,
    /// What is seen.
    pub title: String,
    /// The command that draws it.
    pub command: String,
    window: Window,
}

/// A family of two parameters with its maps, all in one box.
#[derive(Clone, Debug)]
pub struct FamilyMaps {
    scheme: Scheme,
    maps: Maps,
    /// The paper's curves and points.
    curves: Vec<String>,
    marks: Vec<String>,
}

impl FamilyMaps {
    /// The maps of the families, for all orders up to one more than the power of `σ` that divides everywhere. Those that are known
    /// and hold are used, others are searched for. `progress` is called once for each map.
    ///
    /// # Errors
    /// Whatever [`map`] refuses.
    pub fn all(
        tables: &[Table],
        known: &MapStore,
        progress: &dyn Fn(),
    ) -> Result<Vec<FamilyMaps>, Diagnostic> {
        FAMILIES.iter().map(|name| FamilyMaps::new(name, tables, known, progress)).collect()
    }

    /// How many maps [`all`](Self::all) makes.
    ///
    /// # Errors
    /// Those of [`Plane::new`].
    pub fn count() -> Result<usize, Diagnostic> {
        let of = |name: &&str| {
            let scheme = Scheme::resolve(name, 2)?;
            Ok(Plane::new(name, scheme.mask())?.order() + 2)
        };
        FAMILIES.iter().map(of).sum()
    }

    fn new(
        name: &str,
        tables: &[Table],
        known: &MapStore,
        progress: &dyn Fn(),
    ) -> Result<FamilyMaps, Diagnostic> {
        let scheme = Scheme::resolve(name, 2)?;
        let mask = scheme.mask();
        let order = Plane::new(name, mask)?.order();
        // Good enough for a picture, and a few megabytes.
        let fineness = Fineness { undecided: rational(1, 80), ..Fineness::default() };
        let mut window: Option<Window> = None;
        let mut maps = Vec::new();
        for continuity in 0..=order + 1 {
            let held = known.get(&certificate_name(name, continuity)).and_then(|certificate| {
                certified_map(name, mask, continuity, certificate.clone()).ok()
            });
            let fits = |map: &Map| {
                window.as_ref().is_none_or(|window| map.window() == *window)
                    && is_fine(map, &fineness)
            };
            let found = match held.filter(fits) {
                Some(map) => map,
                None => {
                    let window = match &window {
                        Some(window) => window.clone(),
                        None => default_window(name, mask, continuity)?,
                    };
                    map(name, mask, continuity, &window, &fineness)?
                }
            };
            window.get_or_insert_with(|| found.window());
            maps.push(found);
            progress();
        }
        let (curves, marks) = walks(name, maps[0].plane.parameters(), tables)?;
        Ok(FamilyMaps { maps: Maps::of(&scheme, maps), scheme, curves, marks })
    }

    /// The name of the family.
    pub(crate) fn name(&self) -> &str {
        self.scheme.name()
    }

    /// What the page about it is called.
    pub(crate) fn title(&self) -> String {
        format!("C^n of {} over both parameters", self.name())
    }

    /// What is drawn over the maps, a sentence for each curve of the paper, and one for its points.
    pub(crate) fn drawn(&self) -> Vec<String> {
        let curves = self.curves.iter().enumerate();
        let mut lines: Vec<String> =
            curves.map(|(k, curve)| format!("Curve {}: `{curve}`.", k + 1)).collect();
        if !self.marks.is_empty() {
            let marks = self.marks.iter().map(|mark| format!("`{mark}`")).collect::<Vec<_>>();
            lines.push(format!("Marked: {}.", marks.join(", ")));
        }
        lines
    }

    /// The table of areas, with what refutes and what proves.
    pub(crate) fn document(&self) -> Document {
        self.maps.document()
    }

    /// Both pictures: the box as a whole, and where the highest order on an open set holds.
    pub(crate) fn views(&self) -> [View; 2] {
        let (name, last) = (self.name(), self.maps.maps.len() - 1);
        let title = format!("C^0 to C^{last} of {name}");
        let near = format!("{title}, where the highest order on an open set holds");
        [
            self.view(name.into(), title, self.maps.maps[0].window()),
            self.view(format!("{name}-near"), near, self.smoothest()),
        ]
    }

    fn view(&self, file: String, title: String, window: Window) -> View {
        let (name, last) = (self.name(), self.maps.maps.len() - 1);
        let [u, v] = self.maps.maps[0].plane.parameters();
        let [[a, b], [c, d]] = &window;
        let mut command =
            format!("refinable map {name} -n 0..{last} --box '{u}={a}..{b},{v}={c}..{d}'");
        for (option, texts) in [("curve", &self.curves), ("mark", &self.marks)] {
            command.extend(texts.iter().map(|text| format!(" --{option} '{text}'")));
        }
        command.push_str(&format!(" -o {file}.svg"));
        View { file, title, command, window }
    }

    /// The orders of continuity with the names of their certificates.
    pub(crate) fn certificates(&self) -> impl Iterator<Item = (usize, String)> {
        let orders = self.maps.maps.iter().map(Map::continuity);
        orders.map(|n| (n, certificate_name(self.name(), n)))
    }

    /// Adds the page, its pictures and certificates to a site.
    ///
    /// # Errors
    /// Those of the pictures.
    pub(crate) fn publish(&self, site: &mut Site) -> Result<(), Diagnostic> {
        let name = self.name();
        for view in self.views() {
            let picture = self.maps.picture_in(view.window, &self.curves, &self.marks)?;
            site.insert(format!("{MAPS}/{}.svg", view.file), picture);
        }
        let document = self.document();
        site.insert(format!("{MAPS}/{name}.md"), self.page(&document.markdown()));
        site.insert(format!("{MAPS}/{name}.csv"), document.csv());
        for (map, (_, file)) in self.maps.maps.iter().zip(self.certificates()) {
            let json = format!("{}\n", map.certificate.to_json());
            site.insert(format!("{CERTIFICATES}/{file}.json"), json);
        }
        Ok(())
    }

    fn page(&self, table: &str) -> String {
        let mut text = format!("# {}\n\n", self.title());
        for View { file, title, command, .. } in self.views() {
            text.push_str(&format!("![{title}]({file}.svg)\n\n```sh\n{command}\n```\n\n"));
        }
        for line in self.drawn() {
            text.push_str(&format!("{line}\n"));
        }
        text.push('\n');
        text.push_str(table);
        text.push_str("\nCertificates, for `refinable verify`:");
        for (n, file) in self.certificates() {
            text.push_str(&format!(" [C^{n}](../{CERTIFICATES}/{file}.json)"));
        }
        text.push('\n');
        text
    }

    /// A box around what is proved of the highest order that holds on an open set.
    fn smoothest(&self) -> Window {
        let whole = self.maps.maps[0].window();
        let proves = |map: &&Map| map.cells.iter().any(|c| c.verdict == CellVerdict::Proved);
        let Some(map) = self.maps.maps.iter().rev().find(proves) else { return whole };
        let proved = map.cells.iter().filter(|cell| cell.verdict == CellVerdict::Proved);
        let corners = proved.flat_map(|cell| cell.polygon.points());
        let corners: Vec<[Rational; 2]> =
            corners.filter_map(|point| map.plane.parameters_at(&point)).collect();
        [0, 1].map(|i| {
            let values = || corners.iter().map(|corner| &corner[i]);
            let (low, high) = (values().min(), values().max());
            let (Some(low), Some(high)) = (low, high) else { return whole[i].clone() };
            let [low, high] = widened(low, high);
            let [least, most] = &whole[i];
            [low.max(least.clone()), high.min(most.clone())]
        })
    }
}

/// An interval with some space on both sides, up to multiples of a power of two that can be written down.
fn widened(low: &Rational, high: &Rational) -> [Rational; 2] {
    let space = (high - low) * rational(1, 12);
    let mut unit = rational(1, 1);
    while unit > space && low < high {
        unit *= rational(1, 2);
    }
    let (low, high) = ((low - &space) / &unit, (high + &space) / &unit);
    [low.floor() * &unit, high.ceil() * &unit]
}

/// Whether a map leaves as little undecided as is asked for, or has taken as many nodes.
fn is_fine(map: &Map, fineness: &Fineness) -> bool {
    let [proved, _, undecided] = map.areas();
    let allowed = &proved.lower * &fineness.undecided * rational(2, 1);
    undecided.upper <= allowed || map.certificate.nodes.len() >= fineness.nodes
}

fn certificate_name(family: &str, continuity: usize) -> String {
    format!("map-{family}-C{continuity}")
}

/// The curves along which the tables walk through the plane of a family, the second parameter in terms of the
/// first, and the points at which they stop.
fn walks(
    family: &str,
    [u, v]: &[Parameter; 2],
    tables: &[Table],
) -> Result<(Vec<String>, Vec<String>), Diagnostic> {
    let claims = tables.iter().flat_map(|table| &table.cells).flat_map(|cell| &cell.claims);
    let (mut curves, mut marks) = (BTreeSet::new(), BTreeSet::new());
    for claim in claims {
        let Claim::Checkable(assertion) = claim else { continue };
        if assertion.scheme != family {
            continue;
        }
        let mut substitutions = Vec::new();
        for text in &assertion.set {
            substitutions.push(Substitution::parse(text)?);
        }
        let Some((curve, points)) = substitutions.split_first() else { continue };
        if curve.parameter() != v || curve.value().as_constant().is_some() {
            continue;
        }
        curves.insert(format!("{v}={}", curve.value()));
        if let [point] = points
            && let Some(a) = point.value().as_constant()
            && let Ok(b) = curve.value().substitute(point.parameter(), point.value())
            && let Some(b) = b.as_constant()
        {
            marks.insert(format!("{u}={a},{v}={b}"));
        }
    }
    Ok((curves.into_iter().collect(), marks.into_iter().collect()))
}
