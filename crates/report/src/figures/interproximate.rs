//! The interproximate figures, with the paper's own control points and tensions.

use refinable_algebra::{Rational, parse_rational};
use refinable_refine::{Coordinate, Ends, Net, Polygon};
use refinable_scheme::{Diagnostic, Scheme};

use super::{Figure, settings};
use crate::canvas::{BLUE, Panel, RED, Shape, sheet};
use crate::curve::{Curve, places};
use crate::interproximate::{Assignment, Member};
use crate::surface::TensorSurface;
use crate::surface_picture::View;

const LEVELS: u32 = 6;

/// A panel: interpolated points, their pair, the pair of all others.
struct Setting {
    interpolated: &'static [usize],
    interpolating: [&'static str; 2],
    approximating: [&'static str; 2],
    text: &'static str,
}

/// `S_{a3}`, Section 6; the last printed point closes the polygon.
const FIRST: [[&str; 2]; 6] =
    [["1", "5"], ["1", "2"], ["13", "3.4"], ["14", "2.5"], ["14", "4.5"], ["13", "3.6"]];

/// `S_{a5}`, Section 6.
const SECOND: [[&str; 2]; 10] = [
    ["0", "0"],
    ["4", "0"],
    ["5", "5"],
    ["4", "10"],
    ["0", "10"],
    ["0", "8"],
    ["1", "8"],
    ["2", "5"],
    ["1", "2"],
    ["0", "2"],
];

/// All vertices of a polygon of at most ten.
const ALL: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9];

const OF_FIRST: [Setting; 5] = [
    Setting {
        interpolated: ALL,
        interpolating: ["0", "-0.05"],
        approximating: ["0", "-0.05"],
        text: "(b) all interpolated",
    },
    Setting {
        interpolated: &[],
        interpolating: ["0", "0"],
        approximating: ["1/12", "-1/44"],
        text: "(c) all approximated",
    },
    Setting {
        interpolated: &[3, 4],
        interpolating: ["0", "-3/50"],
        approximating: ["1/12", "-1/44"],
        text: "(d) 3 and 4 interpolated",
    },
    Setting {
        interpolated: &[0, 1, 3, 4],
        interpolating: ["0", "-3/50"],
        approximating: ["1/8", "0"],
        text: "(e) 0, 1, 3 and 4 interpolated",
    },
    Setting {
        interpolated: &[0, 1],
        interpolating: ["0", "-1/20"],
        approximating: ["1/8", "0"],
        text: "(f) 0 and 1 interpolated",
    },
];

const OF_SECOND: [Setting; 5] = [
    Setting {
        interpolated: ALL,
        interpolating: ["0", "-0.001"],
        approximating: ["0", "-0.001"],
        text: "(b) all interpolated",
    },
    Setting {
        interpolated: &[],
        interpolating: ["0", "0"],
        approximating: ["1/16", "-1/48"],
        text: "(c) all approximated",
    },
    Setting {
        interpolated: &[6, 7, 8],
        interpolating: ["0", "1/64"],
        approximating: ["1/10", "-49/1152"],
        text: "(d) 6, 7 and 8 interpolated",
    },
    Setting {
        interpolated: &[1, 2, 3],
        interpolating: ["0", "-2/125"],
        approximating: ["1/14", "-43/1664"],
        text: "(e) 1, 2 and 3 interpolated",
    },
    Setting {
        interpolated: &[0, 1, 3, 4],
        interpolating: ["0", "1/30"],
        approximating: ["1/11", "-1/30"],
        text: "(f) 0, 1, 3 and 4 interpolated",
    },
];

impl Setting {
    /// The command that draws the panel if some points are interpolated.
    fn interproximation(&self, scheme: &str, interpolated: &[usize], rest: &str) -> String {
        let numbers: Vec<String> = interpolated.iter().map(usize::to_string).collect();
        let pair = |[alpha, beta]: [&str; 2]| format!("alpha={alpha},beta={beta}");
        format!(
            "refinable interproximate {scheme} {rest} --interpolate {} --interpolating {} --approximating {} -o {}.svg",
            numbers.join(","),
            pair(self.interpolating),
            pair(self.approximating),
            self.letter()
        )
    }

    /// The same if none is, which is the scheme itself.
    fn approximation(&self, verb: &str, scheme: &str, rest: &str) -> Result<String, Diagnostic> {
        let settings = settings(scheme, &self.approximating)?;
        Ok(format!("refinable {verb} {scheme}{settings} {rest} -o {}.svg", self.letter()))
    }

    /// The letter of the panel, `(b) …`.
    fn letter(&self) -> &str {
        &self.text[1..2]
    }
}

pub(super) fn figures() -> Result<Vec<Figure>, Diagnostic> {
    Ok(vec![
        curves(
            "interproximate-a3",
            "interproximate-1-fig",
            "a3",
            first(),
            &OF_FIRST,
            [340.0, 130.0],
        )?,
        curves(
            "interproximate-a5",
            "interproximate-2-fig",
            "a5",
            second(),
            &OF_SECOND,
            [280.0, 250.0],
        )?,
        surfaces()?,
    ])
}

fn numbers(texts: &[&str]) -> Vec<Rational> {
    texts.iter().map(|text| parse_rational(text).unwrap_or_default()).collect()
}

fn assignment(
    setting: &Setting,
    count: usize,
    interpolated: &[usize],
) -> Result<Assignment, Diagnostic> {
    let [interpolating, approximating]: [Member; 2] =
        [numbers(&setting.interpolating), numbers(&setting.approximating)];
    Assignment::of_vertices(count, interpolated, interpolating, approximating)
}

/// The control polygon of the figure of `S_{a3}`.
pub(super) fn first() -> Polygon<f64> {
    polygon(&FIRST)
}

/// The control polygon of the figure of `S_{a5}`.
pub(super) fn second() -> Polygon<f64> {
    polygon(&SECOND)
}

fn polygon(points: &[[&str; 2]]) -> Polygon<f64> {
    let values = points.iter().flat_map(|point| numbers(point));
    let values = values.map(|x| Coordinate::from_rational(&x)).collect();
    Polygon::new(2, values, true).expect("a few points")
}

/// The control net of the figure of surfaces: four closed rows of four points; the fifth printed point closes each of them.
pub(super) fn net() -> Net<f64> {
    let rows = [[0.0, 2.0], [5.0, 0.0], [10.0, 2.0], [5.0, 15.0]];
    let values = [0.0, 2.0, 4.0, 6.0].iter().flat_map(|z| rows.map(|[x, y]| [x, y, *z])).flatten();
    Net::new(3, 4, values.collect(), [false, true]).expect("a few points")
}

fn curves(
    name: &'static str,
    label: &'static str,
    scheme: &str,
    control: Polygon<f64>,
    settings: &[Setting],
    size: [f64; 2],
) -> Result<Figure, Diagnostic> {
    let family = Scheme::resolve(scheme, 2)?;
    let count = control.count();
    let (mut panels, mut commands) = (vec![indexed(&control)?], Vec::new());
    for setting in settings {
        let tagged: Vec<usize> =
            setting.interpolated.iter().copied().filter(|i| *i < count).collect();
        commands.push(match tagged[..] {
            [] => setting.approximation(
                "curve",
                scheme,
                &format!("{name}.csv --closed -l {LEVELS}"),
            )?,
            _ => setting.interproximation(
                scheme,
                &tagged,
                &format!("{name}.csv --closed -l {LEVELS}"),
            ),
        });
        let assignment = assignment(setting, count, &tagged)?;
        let refined = assignment.refine(&family, &control, LEVELS, Ends::Trim)?;
        let curve = Curve::of_points("", control.clone(), refined, LEVELS, tagged);
        let shapes = curve.shapes()?;
        panels.push(Panel { caption: captions(setting), shapes, stretched: false });
    }
    let title = format!("Interproximate curves of {}", family.name());
    let caption =
        "Control points and tensions are the paper's; points that are interpolated are blue.";
    let svg = sheet(&title, &panels, 3, size);
    Ok(Figure { name, label, caption: caption.into(), commands, svg })
}

fn captions(setting: &Setting) -> Vec<String> {
    let spelled = |[alpha, beta]: [&str; 2]| format!("(α, β) = ({alpha}, {beta})");
    let mut lines = vec![setting.text.to_string()];
    if !setting.interpolated.is_empty() {
        lines.push(format!("interpolated: {}", spelled(setting.interpolating)));
    }
    if setting.interpolated.len() < ALL.len() {
        lines.push(format!("others: {}", spelled(setting.approximating)));
    }
    lines
}

/// The control polygon with its numbers.
fn indexed(control: &Polygon<f64>) -> Result<Panel, Diagnostic> {
    let at = places(control)?;
    let mut shapes = vec![
        Shape::line(at.clone(), true, RED),
        Shape::Dots { points: at.clone(), color: RED, radius: 3.0 },
    ];
    let middle = at.iter().map(|[_, y]| y).sum::<f64>() / at.len() as f64;
    shapes.extend(at.iter().enumerate().map(|(i, p)| Shape::Label {
        at: *p,
        offset: [5.0, if p[1] < middle { 14.0 } else { -5.0 }],
        angle: 0.0,
        anchor: "start",
        text: i.to_string(),
    }));
    Ok(Panel { caption: vec!["(a) control points".into()], shapes, stretched: false })
}

fn surfaces() -> Result<Figure, Diagnostic> {
    let control = net();
    let family = Scheme::resolve("a3", 2)?;
    let setting = |interpolated, interpolating, approximating, text| Setting {
        interpolated,
        interpolating,
        approximating,
        text,
    };
    let settings = [
        setting(ALL, ["0", "-1/40"], ["0", "-1/40"], "(a) all interpolated"),
        setting(&[], ["0", "0"], ["1/8", "0"], "(b) all approximated"),
        setting(&[3], ["0", "-1/40"], ["1/8", "0"], "(c) (5, 15, z) interpolated"),
    ];
    let (mut panels, mut commands) = (Vec::new(), Vec::new());
    for setting in settings {
        let tagged: Vec<usize> =
            (0..16).filter(|k| setting.interpolated.contains(&(k % 4))).collect();
        let points = "interproximate-surfaces.csv --ends reflect -l 3";
        commands.push(match tagged[..] {
            [] => setting.approximation("surface", "a3", &format!("{points} --closed rows"))?,
            _ => setting.interproximation(
                "a3",
                &tagged,
                &format!("{points} --surface --closed=rows"),
            ),
        });
        let assignment = assignment(&setting, 16, &tagged)?;
        let refined = assignment.refine_net(&family, &control, 3, [Ends::Reflect; 2])?;
        let surface = TensorSurface::of_points("", control.clone(), refined, 3);
        let mut shapes = surface.shapes(&View::OBLIQUE, true);
        let at = |k: &usize| {
            let p = control.point(k / 4, k % 4);
            View::OBLIQUE.project([p[0], p[1], p[2]])
        };
        shapes.push(Shape::Dots {
            points: tagged.iter().map(at).collect(),
            color: BLUE,
            radius: 3.0,
        });
        panels.push(Panel { caption: captions(&setting), shapes, stretched: false });
    }
    let caption = "Control points and tensions are the paper's; rows are closed, and the ends of columns, about which \
                   the paper says nothing, are reflected.";
    Ok(Figure {
        name: "interproximate-surfaces",
        label: "interproximate-b-fig",
        caption: caption.into(),
        commands,
        svg: sheet("Interproximate surfaces of a3", &panels, 3, [290.0, 270.0]),
    })
}
