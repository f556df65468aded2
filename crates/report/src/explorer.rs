//! `explore`: a family as one page that opens from disk, with certified smoothness at every point and live
//! curves.
//!
//! All that the page says about smoothness and degrees is found here and embedded as data (`data`); the
//! page evaluates masks at a rational point, tests which piece of a certified map holds it, both in big
//! integers, and draws in floats. Its parts are plain files in `explorer/`, put together at compile time:
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
    /// That of the maps of all orders, or of the ranges: seconds to minutes.
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
