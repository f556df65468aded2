//! Pictures of audited ranges: what is claimed against what is proved.
//!
//! SVG with fixed decimals. Floats only place ink, by additions, products and quotients that IEEE
//! 754 fixes to the last bit, so the bytes are the same on every machine.

use std::fmt::Write;

use refinable_reals::{Bound, Interval, RealAlgebraic, Region};

use crate::audit::{Agreement, AuditedCell, AuditedTable, Ranges};
use crate::svg::{escape, raised};

const PANEL_WIDTH: f64 = 440.0;
const LABEL_WIDTH: f64 = 44.0;
const MARGIN: f64 = 16.0;
const HEADER: f64 = 30.0;
const BAR: f64 = 22.0;
const FOOTER: f64 = 26.0;
const COLUMNS: usize = 2;
const LEGEND: f64 = 34.0;

/// One panel for each row of the table that has ranges: a bar where C^n is proved, and above it a
/// bracket over the range the paper claims. `None` if no cell of the table has a range.
pub fn ranges(table: &AuditedTable) -> Option<String> {
    let panels = panels(table);
    if panels.is_empty() {
        return None;
    }
    let lines = panels.chunks(COLUMNS);
    let heights: Vec<f64> =
        lines.map(|line| line.iter().map(Panel::height).fold(0.0, f64::max)).collect();
    let width = PANEL_WIDTH * COLUMNS as f64;
    let height = heights.iter().sum::<f64>() + LEGEND;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n\
         <title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        escape(&table.title)
    );
    for (k, panel) in panels.iter().enumerate() {
        let x = PANEL_WIDTH * (k % COLUMNS) as f64;
        let y = heights[..k / COLUMNS].iter().sum();
        panel.draw(&mut svg, x, y);
    }
    legend(&mut svg, height - LEGEND);
    svg.push_str("</svg>\n");
    Some(svg)
}

/// The cells of one row that speak of ranges of one parameter.
struct Panel<'a> {
    title: &'a str,
    bars: Vec<(&'a AuditedCell, &'a Ranges)>,
    lower: f64,
    upper: f64,
}

fn panels(table: &AuditedTable) -> Vec<Panel<'_>> {
    let mut rows: Vec<&str> = Vec::new();
    for cell in &table.cells {
        if !rows.contains(&cell.row.as_str()) {
            rows.push(&cell.row);
        }
    }
    let bars = |row: &str| -> Vec<(&AuditedCell, &Ranges)> {
        let cells = table.cells.iter().filter(|cell| cell.row == row);
        cells.filter_map(|cell| cell.ranges.as_ref().map(|ranges| (cell, ranges))).collect()
    };
    let panels = rows.into_iter().map(|row| (row, bars(row))).filter(|(_, bars)| !bars.is_empty());
    panels.map(|(title, bars)| Panel::new(title, bars)).collect()
}

impl<'a> Panel<'a> {
    fn new(title: &'a str, bars: Vec<(&'a AuditedCell, &'a Ranges)>) -> Self {
        let regions = bars.iter().flat_map(|(_, ranges)| [&ranges.claimed, &ranges.proved]);
        let ends: Vec<f64> = regions.flat_map(Region::ends).map(|x| place(&x)).collect();
        let lower = ends.iter().copied().fold(0.0, f64::min);
        let upper = ends.iter().copied().fold(0.0, f64::max);
        let margin = (upper - lower) / 20.0;
        Panel { title, bars, lower: lower - margin, upper: upper + margin }
    }

    fn height(&self) -> f64 {
        HEADER + BAR * self.bars.len() as f64 + FOOTER
    }

    fn draw(&self, svg: &mut String, x: f64, y: f64) {
        let parameter = self.bars.first().map_or("", |(_, ranges)| &ranges.parameter);
        let title = escape(&format!("{}, {parameter}", self.title));
        text(svg, x + LABEL_WIDTH, y + 18.0, "start", &format!("font-weight=\"bold\">{title}"));
        for (k, (cell, ranges)) in self.bars.iter().enumerate() {
            self.draw_bar(svg, x, y + HEADER + BAR * k as f64, cell, ranges);
        }
        self.draw_axis(svg, x, y + HEADER + BAR * self.bars.len() as f64 + 4.0);
    }

    fn draw_bar(&self, svg: &mut String, x: f64, y: f64, cell: &AuditedCell, ranges: &Ranges) {
        let label = escape(&superscript(&cell.column));
        text(svg, x + LABEL_WIDTH - 8.0, y + 15.0, "end", &format!(">{label}"));
        for (from, to) in self.spans(&ranges.proved, x) {
            let width = (to - from).max(1.5);
            let _ = writeln!(
                svg,
                "<rect x=\"{from:.2}\" y=\"{:.2}\" width=\"{width:.2}\" height=\"9\" fill=\"#4477aa\"/>",
                y + 8.0
            );
        }
        for (from, to) in self.spans(&ranges.claimed, x) {
            let top = y + 4.0;
            let _ = writeln!(
                svg,
                "<path d=\"M{from:.2} {:.2}V{top:.2}H{to:.2}V{:.2}\" fill=\"none\" stroke=\"#000000\"/>",
                top + 4.0,
                top + 4.0
            );
        }
        let verdict = format!("fill=\"#333333\">{}", cell.agreement.symbol());
        text(svg, x + PANEL_WIDTH - MARGIN + 4.0, y + 16.0, "middle", &verdict);
    }

    fn draw_axis(&self, svg: &mut String, x: f64, y: f64) {
        let (from, to) = (x + LABEL_WIDTH, x + PANEL_WIDTH - 2.0 * MARGIN);
        let _ = writeln!(
            svg,
            "<path d=\"M{from:.2} {y:.2}H{to:.2}M{:.2} {:.2}V{:.2}\" stroke=\"#999999\"/>",
            self.across(0.0, x),
            y - 3.0,
            y + 3.0
        );
        text(svg, self.across(0.0, x), y + 15.0, "middle", ">0");
        let regions = self.bars.iter().map(|(_, ranges)| &ranges.proved);
        let ends: Vec<RealAlgebraic> = regions.flat_map(Region::ends).collect();
        for end in [ends.iter().min(), ends.iter().max()].into_iter().flatten() {
            let at = self.across(place(end), x);
            if (at - self.across(0.0, x)).abs() > 50.0 {
                text(svg, at, y + 15.0, "middle", &format!(">{}", end.decimal(3)));
            }
        }
    }

    /// The finite intervals of a region in picture coordinates.
    fn spans(&self, region: &Region, x: f64) -> Vec<(f64, f64)> {
        let end = |bound: &Bound, infinite: f64| bound.number().map_or(infinite, place);
        let span = |interval: &Interval| {
            let lower = end(&interval.lower, self.lower).max(self.lower);
            let upper = end(&interval.upper, self.upper).min(self.upper);
            (self.across(lower, x), self.across(upper, x))
        };
        region.intervals().iter().map(span).collect()
    }

    fn across(&self, value: f64, x: f64) -> f64 {
        let width = PANEL_WIDTH - LABEL_WIDTH - 2.0 * MARGIN;
        let span = self.upper - self.lower;
        let share = if span > 0.0 { (value - self.lower) / span } else { 0.5 };
        x + LABEL_WIDTH + width * share
    }
}

fn legend(svg: &mut String, y: f64) {
    let _ = writeln!(
        svg,
        "<rect x=\"44\" y=\"{:.2}\" width=\"30\" height=\"9\" fill=\"#4477aa\"/>\
         <path d=\"M250 {:.2}V{:.2}H280V{:.2}\" fill=\"none\" stroke=\"#000000\"/>",
        y + 10.0,
        y + 18.0,
        y + 13.0,
        y + 18.0
    );
    text(svg, 80.0, y + 19.0, "start", ">proved");
    text(svg, 286.0, y + 19.0, "start", ">claimed by the paper");
    let marks = Agreement::ALL.into_iter().filter(|a| *a != Agreement::NotChecked);
    let marks: Vec<String> = marks.map(|a| format!("{} {}", a.symbol(), a.word())).collect();
    text(svg, 450.0, y + 19.0, "start", &format!(">{}", marks.join(", ")));
}

/// Text at a place; `rest` is the remaining attributes, `>`, and the escaped content.
fn text(svg: &mut String, x: f64, y: f64, anchor: &str, rest: &str) {
    let gap = if rest.starts_with('>') { "" } else { " " };
    let _ =
        writeln!(svg, "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\"{gap}{rest}</text>");
}

/// `C^2` as `C²`.
fn superscript(text: &str) -> String {
    let Some((base, exponent)) = text.split_once('^') else {
        return text.to_string();
    };
    raised(exponent).map_or_else(|| text.to_string(), |raised| format!("{base}{raised}"))
}

fn place(x: &RealAlgebraic) -> f64 {
    x.decimal(12).parse().expect("a decimal is a float")
}
