//! `explore`: a family as one page that opens from disk, with certified smoothness at every point and live
//! curves.
//!
//! All that the page says about smoothness and degrees is found here and embedded as data (`data`, `smoothness`); the
//! page evaluates masks at a rational point, tests which piece of a certified map holds it and whether it is a member of which
//! more is known, all in big integers, and draws in floats. Its parts are plain files in `explorer/`, put together at compile time:
//!
//! | file | concern |
//! |---|---|
//! | `page.html`, `page.css` | the document, its looks |
//! | `dom.js` | elements, drags, keys |
//! | `rational.js` | rational and algebraic numbers, polynomials, resultants in `BigInt` |
//! | `scheme.js` | mask, rules, type and degrees at a point |
//! | `region.js` | which verdicts hold at a point, and why |
//! | `refine.js` | refinement in floats |
//! | `chart.js` | the picture of the map, or of the line |
//! | `curve.js` | the control polygon and its limit curve |
//! | `view.js` | the state, the panels, the address |

mod data;
mod smoothness;

use refinable_analysis::Fineness;
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::Value;

use crate::svg::escape;

/// What is explored, and how finely.
#[derive(Clone, Debug)]
pub struct ExplorerOptions {
    /// The words by which a command line names the scheme, its settings included: the page offers
    /// commands with them.
    pub words: Vec<String>,
    /// The box of a map, `alpha=-1/4..3/4,beta=-1/2..1/2`; one that shows where C^0 holds if left out.
    pub window: Option<String>,
    /// How fine maps are.
    pub fineness: Fineness,
}

/// The page about one scheme or family.
#[derive(Clone, Debug)]
pub struct Explorer {
    name: String,
    data: Value,
}

impl Explorer {
    /// Finds all that the page says. `progress` is told what is being looked for.
    ///
    /// # Errors
    /// Code `parameters` for more than two free parameters or masks that lie on no line; whatever else
    /// maps and ranges refuse.
    ///
    /// # Cost
    /// That of the maps of all orders and of a landscape, or of the ranges; and for each of a few members that of its
    /// regularity: seconds to minutes.
    pub fn new(
        scheme: &Scheme,
        options: &ExplorerOptions,
        progress: &dyn Fn(&str),
    ) -> Result<Explorer, Diagnostic> {
        let data = data::of(scheme, options, progress)?;
        Ok(Explorer { name: scheme.name().into(), data })
    }

    /// What is embedded.
    pub fn data(&self) -> &Value {
        &self.data
    }

    /// The page, which needs nothing else.
    pub fn page(&self) -> String {
        let title = format!("{}: smoothness and curves", self.name);
        // Inside of a script element only `<` could end it, and JSON has no other place for it than strings.
        let data = self.data.to_string().replace('<', "\\u003c");
        let parts = [&escape(&title), PAGE_STYLE, &data, &PAGE_SCRIPT.concat()];
        let mut page = String::new();
        let mut rest = PAGE;
        for (mark, part) in MARKS.into_iter().zip(parts) {
            let (before, after) =
                rest.split_once(mark).expect("the page has all marks, in this order");
            page.push_str(before);
            page.push_str(part);
            rest = after;
        }
        page.push_str(rest);
        page
    }
}

const PAGE: &str = include_str!("explorer/page.html");
const PAGE_STYLE: &str = include_str!("explorer/page.css");
/// The places of the title, the style, the data and the script in the page, in their order.
const MARKS: [&str; 4] = ["{{title}}", "/*{{style}}*/", "{{data}}", "/*{{script}}*/"];
/// One script: each file uses only what those before it define, and the last one starts.
const PAGE_SCRIPT: [&str; 8] = [
    include_str!("explorer/dom.js"),
    include_str!("explorer/rational.js"),
    include_str!("explorer/scheme.js"),
    include_str!("explorer/region.js"),
    include_str!("explorer/refine.js"),
    include_str!("explorer/chart.js"),
    include_str!("explorer/curve.js"),
    include_str!("explorer/view.js"),
];

#[cfg(test)]
mod tests {
    use refinable_algebra::{Rational, parse_rational, rational};
    use refinable_analysis::{MapVerdict, Window, map};

    use super::*;

    fn explored(scheme: &Scheme) -> Explorer {
        let options = ExplorerOptions {
            words: vec![scheme.name().into()],
            window: Some("alpha=-1/4..3/4,beta=-1/2..1/2".into()),
            fineness: Fineness { undecided: rational(1, 20), nodes: 600 },
        };
        Explorer::new(scheme, &options, &|_| ()).unwrap()
    }

    /// The data as a browser finds it.
    fn embedded(page: &str) -> Value {
        let (_, rest) = page.split_once("<script type=\"application/json\" id=\"data\">").unwrap();
        serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
    }

    /// Nothing is fetched from anywhere: there is no address, and the policy of the page would forbid it.
    #[test]
    fn the_page_needs_nothing_else() {
        let page = explored(&Scheme::resolve("bspline3", 2).unwrap()).page();
        for word in [
            "http:",
            "https:",
            "fetch(",
            "import ",
            "import(",
            "XMLHttpRequest",
            "WebSocket",
            "src=",
            "href=",
        ] {
            assert!(!page.contains(word), "{word}");
        }
        assert!(page.contains("default-src 'none'"));
        assert!(MARKS.iter().all(|mark| !page.contains(mark)));
    }

    #[test]
    fn names_end_no_element_and_start_none() {
        let mask = Scheme::resolve("bspline3", 2).unwrap().mask().clone();
        let name = "</script><script>throw 1</script></title>\"'&amp;{{data}}<!--";
        let explorer = explored(&Scheme::new(name, mask));
        let page = explorer.page();
        assert_eq!(embedded(&page), *explorer.data());
        assert_eq!(explorer.data()["scheme"], name);
        let plain = explored(&Scheme::resolve("bspline3", 2).unwrap()).page();
        for mark in ["<script", "</script", "</title", "<!--"] {
            assert_eq!(page.matches(mark).count(), plain.matches(mark).count(), "{mark}");
        }
    }

    /// The reasons of the pieces that hold a point, found in the embedded data by another walk: down from every
    /// root through the list of cuts itself.
    fn reasons(data: &Value, n: usize, point: &[Rational; 2]) -> Vec<Value> {
        let found = &data["smoothness"]["maps"][n];
        let mut all = Vec::new();
        for tree in found["trees"].as_array().unwrap() {
            let walk = tree.as_array().unwrap();
            descend(walk, 0, Some(point), &mut all);
        }
        all.into_iter().map(|k| found["reasons"][k].clone()).collect()
    }

    /// Where the part of the walk that begins at `at` ends; without a point it is only passed over.
    fn descend(
        walk: &[Value],
        at: usize,
        point: Option<&[Rational; 2]>,
        all: &mut Vec<usize>,
    ) -> usize {
        let Some(line) = walk[at].as_str() else {
            all.extend(point.map(|_| walk[at].as_u64().unwrap() as usize));
            return at + 1;
        };
        let line: Vec<Rational> = line.split(' ').map(|c| parse_rational(c).unwrap()).collect();
        let side = |[x, y]: &[Rational; 2]| (&line[0] * x + &line[1] * y).cmp(&line[2]);
        let above = descend(walk, at + 1, point.filter(|p| side(p).is_le()), all);
        descend(walk, above, point.filter(|p| side(p).is_ge()), all)
    }

    /// At 200 points of the box the data say what the map says.
    #[test]
    fn the_data_say_what_the_maps_say() {
        let scheme = Scheme::resolve("a3", 2).unwrap();
        let explorer = explored(&scheme);
        let data = embedded(&explorer.page());
        let window: Window = [[rational(-1, 4), rational(3, 4)], [rational(-1, 2), rational(1, 2)]];
        let fineness = Fineness { undecided: rational(1, 20), nodes: 600 };
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            rational((state >> 44) as i64 % 997, 997)
        };
        let points: Vec<[Rational; 2]> =
            (0..200).map(|_| [next() - rational(1, 4), next() - rational(1, 2)]).collect();
        let mut decided = 0;
        for n in 0..2 {
            let map = map("a3", scheme.mask(), n, &window, &fineness).unwrap();
            for point in &points {
                let reasons = reasons(&data, n, &map.plane.point(point));
                let says = |verdict: &str| reasons.iter().any(|r| r["verdict"] == verdict);
                let surely =
                    reasons.iter().any(|r| r["verdict"] == "refuted" && r["if_stable"].is_null());
                match map.verdict_at(point) {
                    MapVerdict::Proved => assert!(says("proved"), "{point:?}"),
                    MapVerdict::Refuted => assert!(says("refuted") && !says("proved"), "{point:?}"),
                    MapVerdict::Undecided => assert!(!says("proved") && !surely, "{point:?}"),
                }
                decided += usize::from(map.verdict_at(point) != MapVerdict::Undecided);
            }
        }
        assert!(decided > 300, "{decided} of 400");
    }

    #[test]
    fn one_parameter_has_ends_and_none_has_verdicts() {
        let data = explored(&Scheme::resolve("i4", 2).unwrap()).data().clone();
        let proved = &data["smoothness"]["ranges"][1]["intervals"][0];
        assert_eq!(proved["verdict"], "proved");
        assert_eq!(proved["lower"]["polynomial"], serde_json::json!(["1", "4", "0", "32"]));
        assert_eq!(proved["upper"], "0");
        let data = explored(&Scheme::resolve("dd4", 2).unwrap()).data().clone();
        let verdicts = data["smoothness"]["verdicts"].as_array().unwrap().iter();
        let words: Vec<&str> = verdicts.map(|v| v["verdict"].as_str().unwrap()).collect();
        assert_eq!(words, ["proved", "proved", "refuted"]);
    }
}
