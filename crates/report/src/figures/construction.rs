//! The construction of the four-point rule by displacement vectors, drawn from the recorded derivation.

use refinable_algebra::{Laurent, ParameterFraction, ParameterPolynomial, Rational, rational};
use refinable_refine::Coordinate;
use refinable_scheme::{Diagnostic, Points, Scheme, Step, Vectors};

use super::Figure;
use crate::canvas::{BLACK, BLUE, GREEN, Panel, Place, RED, Shape, sheet};

/// `f_{i-2}, …, f_{i+3}`, ours.
const CONTROL: [[i64; 2]; 6] = [[0, 0], [3, 6], [9, 8], [15, 7], [20, 2], [19, -4]];
/// The paper draws a negative `α`.
const ALPHA: [i64; 2] = [-1, 4];

/// The two steps of the derivation of `S_{a4}`, and the control points.
struct Construction {
    first: Points,
    first_vectors: Vectors,
    second: Points,
    second_vectors: Vectors,
}

pub(super) fn figures() -> Result<Vec<Figure>, Diagnostic> {
    let scheme = Scheme::resolve("a4", 2)?;
    let steps = scheme.derivation().map(|derivation| derivation.steps().to_vec());
    let Some(
        [
            Step::Initial { points: first, vectors: first_vectors },
            Step::Displacement { points: second, vectors: second_vectors, .. },
        ],
    ) = steps.as_deref()
    else {
        return Err(Diagnostic::new("derivation", "a4 is derived in two steps"));
    };
    let construction = Construction {
        first: first.clone(),
        first_vectors: first_vectors.clone(),
        second: second.clone(),
        second_vectors: second_vectors.clone(),
    };
    let note = "Drawn from the recorded derivation of a4, which the command prints; control points ours, α = -1/4.";
    let commands = vec!["refinable show a4 --derive".to_string()];
    let size = [640.0, 380.0];
    Ok(vec![
        Figure {
            name: "construction-1",
            label: "Geometrical",
            caption: format!(
                "(a) The points of the initial scheme, black. (b) The vectors C_{{2i,1}} and C_{{2i+1,1}} as points, \
                 blue. (c) Their differences, dashed, and the sums of these. {note}"
            ),
            commands: commands.clone(),
            svg: sheet("Construction by displacement vectors", &construction.beginning(), 1, size),
        },
        Figure {
            name: "construction-2",
            label: "Geometrical1",
            caption: format!(
                "(a) The vectors α C_{{2i,2}} and C_{{2i+1,2}} at the points that they move. (b) The points moved, green. \
                 (c) The points of the four-point scheme. {note}"
            ),
            commands,
            svg: sheet(
                "Construction by displacement vectors, continued",
                &construction.end(),
                1,
                size,
            ),
        },
    ])
}

impl Construction {
    fn beginning(&self) -> Vec<Panel> {
        let vectors = &self.first_vectors;
        let (vertices, edges) = (spots(&vectors.vertex, 1..5), spots(&vectors.edge, 0..5));
        let bullets =
            |points: &[Place]| Shape::Dots { points: points.to_vec(), color: BLUE, radius: 3.0 };
        // At each f_i: C_i - C_{i+1} and then C_i - C_{i-1}, head to tail, and their sum.
        let at_vertex = |k: usize| {
            (place(k + 1), minus(vertices[k], vertices[k + 1]), minus(vertices[k], vertices[k - 1]))
        };
        let at_edge = |k: usize| {
            let middle = spots(&self.first.edge, k..k + 1)[0];
            (middle, minus(edges[k], edges[k + 1]), minus(edges[k], edges[k - 1]))
        };
        let sums = [1, 2].map(at_vertex).into_iter().chain([1, 2, 3].map(at_edge));
        let arrows = sums.flat_map(|(from, first, second)| {
            let (middle, to) = (plus(from, first), plus(plus(from, first), second));
            [
                Shape::Arrow { from, to: middle, color: BLUE, dashed: true },
                Shape::Arrow { from: middle, to, color: BLUE, dashed: true },
                Shape::Arrow { from, to, color: BLUE, dashed: false },
            ]
        });
        vec![
            self.panel("(a) the initial scheme", [self.first_points()]),
            self.panel("(b) C_{2i,1} and C_{2i+1,1}", [vec![bullets(&vertices), bullets(&edges)]]),
            self.panel("(c) differences and their sums", [self.first_points(), arrows.collect()]),
        ]
    }

    fn end(&self) -> Vec<Panel> {
        let alpha = f64::from_rational(&rational(ALPHA[0], ALPHA[1]));
        let (vertices, edges) =
            (spots(&self.second_vectors.vertex, 2..4), spots(&self.second_vectors.edge, 1..4));
        let scaled = |v: Place, s: f64| [v[0] * s, v[1] * s];
        let moved = |from: Place, by: Place| Shape::Arrow {
            from,
            to: plus(from, by),
            color: BLUE,
            dashed: false,
        };
        let first = [spots(&self.first.vertex, 2..4), spots(&self.first.edge, 1..4)];
        let arrows: Vec<Shape> = first[0]
            .iter()
            .zip(&vertices)
            .map(|(p, v)| moved(*p, scaled(*v, alpha)))
            .chain(first[1].iter().zip(&edges).map(|(p, v)| moved(*p, *v)))
            .collect();
        vec![
            self.panel("(a) α C_{2i,2} and C_{2i+1,2}", [self.first_points(), arrows.clone()]),
            self.panel(
                "(b) points moved along them",
                [self.first_points(), arrows, self.second_points()],
            ),
            self.panel("(c) the four-point scheme", [self.second_points()]),
        ]
    }

    /// The control polygon and what is drawn over it.
    fn panel<const N: usize>(&self, caption: &str, layers: [Vec<Shape>; N]) -> Panel {
        let control: Vec<Place> = (0..CONTROL.len()).map(place).collect();
        let mut shapes = vec![
            Shape::line(control.clone(), false, RED),
            Shape::Dots { points: control, color: RED, radius: 3.0 },
        ];
        let names = ["f_{i-2}", "f_{i-1}", "f_i", "f_{i+1}", "f_{i+2}", "f_{i+3}"];
        let name = |(k, name): (usize, &str)| Shape::Label {
            at: place(k),
            offset: [if k < 3 { 8.0 } else { -8.0 }, 14.0],
            angle: 0.0,
            anchor: if k < 3 { "start" } else { "end" },
            text: name.to_string(),
        };
        shapes.extend(names.into_iter().enumerate().map(name));
        shapes.extend(layers.into_iter().flatten());
        Panel { caption: vec![caption.into()], shapes, stretched: false }
    }

    fn first_points(&self) -> Vec<Shape> {
        polygon(&self.first, 1..5, BLACK)
    }

    fn second_points(&self) -> Vec<Shape> {
        polygon(&self.second, 2..4, GREEN)
    }
}

/// New points with their polygon: the vertices of `range`, and the edges around them.
fn polygon(points: &Points, range: std::ops::Range<usize>, color: &'static str) -> Vec<Shape> {
    let (vertices, edges) =
        (spots(&points.vertex, range.clone()), spots(&points.edge, range.start - 1..range.end));
    let mut all = vec![edges[0]];
    for (vertex, edge) in vertices.iter().zip(&edges[1..]) {
        all.extend([*vertex, *edge]);
    }
    vec![Shape::line(all.clone(), false, color), Shape::Dots { points: all, color, radius: 3.0 }]
}

/// A coefficient at the drawn `α`.
trait AtAlpha {
    fn at_alpha(&self) -> Rational;
}

impl AtAlpha for Rational {
    fn at_alpha(&self) -> Rational {
        self.clone()
    }
}

impl AtAlpha for ParameterPolynomial {
    fn at_alpha(&self) -> Rational {
        let alpha =
            ParameterFraction::from(ParameterPolynomial::constant(rational(ALPHA[0], ALPHA[1])));
        let whole = ParameterFraction::from(self.clone());
        let parameters = self.parameters();
        let set = parameters.iter().try_fold(whole, |x, p| x.substitute(p, &alpha)).ok();
        set.and_then(|x| x.as_constant()).unwrap_or_default()
    }
}

/// `Σ_j w_j f_{i+j}` for each `i`, a number of a control point from 0.
fn spots<C: AtAlpha + refinable_algebra::Ring>(
    combination: &Laurent<C>,
    range: std::ops::Range<usize>,
) -> Vec<Place> {
    let spot = |i: usize| {
        let mut at = [0.0, 0.0];
        for (j, w) in combination.terms() {
            let w = f64::from_rational(&w.at_alpha());
            let [x, y] = place((i as i64 + j) as usize);
            at = [at[0] + w * x, at[1] + w * y];
        }
        at
    };
    range.map(spot).collect()
}

fn place(i: usize) -> Place {
    CONTROL[i].map(|x| x as f64)
}

fn plus(a: Place, b: Place) -> Place {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}
