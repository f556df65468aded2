//! The frame of a picture over two parameters: the box, its axes, their ticks.

use std::fmt::Write;

use refinable_algebra::{Parameter, Rational, Ring, integer, rational};
use refinable_analysis::Window;

use crate::latex::greek_letter;
use crate::svg::{escape, place};

pub(crate) const LEFT: f64 = 84.0;
pub(crate) const TOP: f64 = 44.0;
pub(crate) const WIDTH: f64 = 640.0;
pub(crate) const HEIGHT: f64 = 460.0;
const LEGEND: f64 = 172.0;
const FOOTER: f64 = 64.0;
/// Ticks along an axis, about.
const TICKS: i64 = 6;

/// The box in picture coordinates.
pub(crate) struct Frame {
    /// The box.
    pub window: Window,
    low: [f64; 2],
    high: [f64; 2],
}

impl Frame {
    pub fn new(window: Window) -> Self {
        let low = window.each_ref().map(|[low, _]| place(low));
        let high = window.each_ref().map(|[_, high]| place(high));
        Frame { window, low, high }
    }

    pub fn across(&self, u: &Rational) -> f64 {
        self.x(place(u))
    }

    pub fn down(&self, v: &Rational) -> f64 {
        self.y(place(v))
    }

    pub fn x(&self, u: f64) -> f64 {
        LEFT + (u - self.low[0]) / (self.high[0] - self.low[0]) * WIDTH
    }

    pub fn y(&self, v: f64) -> f64 {
        TOP + (self.high[1] - v) / (self.high[1] - self.low[1]) * HEIGHT
    }

    /// Whether a place in the picture is inside of the box.
    pub fn contains(&self, x: f64, y: f64) -> bool {
        (LEFT..=LEFT + WIDTH).contains(&x) && (TOP..=TOP + HEIGHT).contains(&y)
    }

    /// Whether the places are not all on one and the same side beyond the box.
    pub fn meets(&self, places: &[(f64, f64)]) -> bool {
        let any = |f: &dyn Fn(&(f64, f64)) -> bool| places.iter().any(f);
        any(&|p| p.0 >= LEFT)
            && any(&|p| p.0 <= LEFT + WIDTH)
            && any(&|p| p.1 >= TOP)
            && any(&|p| p.1 <= TOP + HEIGHT)
    }

    /// The head of a picture with a title, and the box to which what follows is clipped.
    pub fn begin(title: &str, definitions: &str) -> String {
        let (width, height) = (LEFT + WIDTH + LEGEND, TOP + HEIGHT + FOOTER);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             font-family=\"sans-serif\" font-size=\"12\">\n<title>{title}</title>\n\
             <defs>{definitions}\
             <clipPath id=\"box\"><rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{WIDTH}\" height=\"{HEIGHT}\"/>\
             </clipPath></defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
             <text x=\"{LEFT}\" y=\"24\" font-size=\"14\">{title}</text>\n<g clip-path=\"url(#box)\">\n",
            title = escape(title),
        )
    }

    /// Ends what is clipped, and draws the axes with exact ticks.
    pub fn finish(&self, svg: &mut String, [u, v]: &[Parameter; 2]) {
        svg.push_str("</g>\n");
        let _ = writeln!(
            svg,
            "<rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"none\" \
             stroke=\"#000000\"/>"
        );
        let bottom = TOP + HEIGHT;
        for t in ticks(&self.window[0]) {
            let x = self.across(&t);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.2} {bottom}v5\" stroke=\"#000000\"/>\
                 <text x=\"{x:.2}\" y=\"{:.0}\" text-anchor=\"middle\">{t}</text>",
                bottom + 19.0
            );
        }
        for t in ticks(&self.window[1]) {
            let y = self.down(&t);
            let _ = writeln!(
                svg,
                "<path d=\"M{LEFT} {y:.2}h-5\" stroke=\"#000000\"/>\
                 <text x=\"{:.0}\" y=\"{:.2}\" text-anchor=\"end\">{t}</text>",
                LEFT - 9.0,
                y + 4.0
            );
        }
        let _ = writeln!(
            svg,
            "<text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"middle\">{}</text>\
             <text x=\"16\" y=\"{:.0}\">{}</text>",
            LEFT + WIDTH / 2.0,
            bottom + 44.0,
            escape(letter(u)),
            TOP + HEIGHT / 2.0,
            escape(letter(v)),
        );
    }
}

/// Multiples of a power of two within an interval.
fn ticks([low, high]: &[Rational; 2]) -> Vec<Rational> {
    let mut unit = Rational::one();
    let two = rational(2, 1);
    let span = high - low;
    while &span / &unit > rational(TICKS, 1) {
        unit *= &two;
    }
    while &span / &unit < rational(TICKS, 2) {
        unit /= &two;
    }
    let (first, last) = ((low / &unit).ceil().to_integer(), (high / &unit).floor().to_integer());
    let mut ticks = Vec::new();
    let mut k = first;
    while k <= last {
        ticks.push(Rational::from(k.clone()) * &unit);
        k += integer(1);
    }
    ticks
}

/// The Greek letter of a parameter that is called by its name.
fn letter(parameter: &Parameter) -> &str {
    greek_letter(parameter.name()).unwrap_or(parameter.name())
}
