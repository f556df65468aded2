//! Derivations in the paper's notation, as plain text.

use std::fmt;

use refinable_algebra::{
    Integer, Laurent, ParameterPolynomial, Rational, Ring, clear_denominators, push_sign,
};

use crate::derivation::{Derivation, Step, Vectors, Weight};

/// `name = definition = value`, as the paper would print it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Equation {
    /// What is defined, such as `C_{2i,2}`.
    pub name: String,
    /// By what, such as `(C_{2i,1} - C_{2(i+1),1}) + (C_{2i,1} - C_{2(i-1),1})`.
    pub definition: String,
    /// What that is, such as `-f_{i-2} + 3*f_{i-1} - 4*f_i + 3*f_{i+1} - f_{i+2}`.
    pub value: String,
}

impl Equation {
    fn new(name: impl Into<String>, definition: impl Into<String>, value: String) -> Self {
        Equation { name: name.into(), definition: definition.into(), value }
    }
}

/// `name = definition`, and below it `= value` unless that is the same.
impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.name, self.definition)?;
        if self.value != self.definition {
            let indent = self.name.chars().count();
            write!(f, "\n{:indent$} = {}", "", self.value)?;
        }
        Ok(())
    }
}

impl Step {
    /// One line that says what the step does.
    pub fn heading(&self) -> String {
        let n = self.n();
        let action = match self {
            Step::Initial { .. } => "the initial rules and vectors".to_string(),
            Step::Displacement { .. } => "the points move along the vectors".to_string(),
            Step::Extension { weights, .. } => {
                format!("the edge rule gains {} weights", weights.len())
            }
            Step::Restriction { .. } => "alpha = 0".to_string(),
        };
        format!("N = {n}: {action}")
    }

    /// The equations of the step, in the order in which they are computed.
    pub fn equations(&self) -> Vec<Equation> {
        match self {
            Step::Initial { vectors, .. } => self.initial_equations(vectors),
            Step::Displacement { n, factor, vectors, .. } => {
                self.displacement_equations(*n, factor, vectors)
            }
            Step::Extension { n, weights, .. } => self.extension_equations(*n, weights),
            Step::Restriction { n, .. } => {
                let (vertex, edge) = names("f", n + 1);
                self.point_equations(
                    format!("({vertex} at alpha = 0)"),
                    format!("({edge} at alpha = 0)"),
                )
            }
        }
    }

    /// The equations of the two points, defined so.
    fn point_equations(&self, vertex: String, edge: String) -> Vec<Equation> {
        let names = names("f", self.n() + 1);
        let points = self.points();
        vec![
            Equation::new(names.0, vertex, written(&points.vertex)),
            Equation::new(names.1, edge, written(&points.edge)),
        ]
    }

    fn initial_equations(&self, vectors: &Vectors) -> Vec<Equation> {
        let vertex = "f_i + alpha*(f_{i-1} - 2*f_i + f_{i+1})".to_string();
        let edge = written(&self.points().edge);
        let mut equations = self.point_equations(vertex, edge);
        let names = names("C", 1);
        for (name, vector) in [(names.0, &vectors.vertex), (names.1, &vectors.edge)] {
            let value = written_vector(vector);
            equations.push(Equation::new(name, value.clone(), value));
        }
        equations
    }

    fn displacement_equations(
        &self,
        n: u32,
        factor: &Rational,
        vectors: &Vectors,
    ) -> Vec<Equation> {
        let turned = |odd: &str| {
            format!(
                "(C_{{2i{odd},{n}}} - C_{{2(i+1){odd},{n}}}) + (C_{{2i{odd},{n}}} - C_{{2(i-1){odd},{n}}})"
            )
        };
        let (vertex, edge) = names("C", n + 1);
        let (old_vertex, old_edge) = names("f", n);
        let points = self.point_equations(
            format!("{old_vertex} + alpha*{vertex}"),
            format!("{old_edge} + {edge}"),
        );
        let mut equations = vec![
            Equation::new(
                "(1/N)*(N/4 - 1/8)",
                format!("(1/{n})*({n}/4 - 1/8)"),
                factor.to_string(),
            ),
            Equation::new(vertex, turned(""), written_vector(&vectors.vertex)),
            Equation::new(
                edge,
                format!("{factor}*({})", turned("+1")),
                written_vector(&vectors.edge),
            ),
        ];
        equations.extend(points);
        equations
    }

    fn extension_equations(&self, n: u32, weights: &[Weight]) -> Vec<Equation> {
        let mut equations: Vec<_> = weights.iter().map(|w| weight_equation(n, w)).collect();
        let values = weights.iter().map(Weight::value).collect();
        let first = weights.first().map_or(0, |w| w.j + 1);
        let sum = written_vector(&Laurent::new(first, values));
        let (vertex, edge) = names("f", n + 1);
        let old_vertex = format!("({vertex} of the {}-point scheme)", 2 * n + 2);
        let old_edge = format!("({edge} of the {}-point scheme)", 2 * n + 2);
        equations.extend(
            self.point_equations(old_vertex, format!("{old_edge} + beta*(1 - alpha)*({sum})")),
        );
        equations
    }
}

/// The weight of `f_{i+j+1}` over `beta (1 - alpha)`.
fn weight_equation(n: u32, weight: &Weight) -> Equation {
    let top = i64::from(n);
    let name = format!("weight at {}", point(weight.j + 1));
    let at_end = weight.j < -top - 1 || weight.j > top;
    let definition = if at_end {
        "1".to_string()
    } else {
        let (j, sign) = (weight.j, weight.j + top + 1);
        format!("(-1)^{sign}*({}/{})*C({}, {})", 2 * j + 1, top - j + 1, 2 * top + 2, top + j + 2)
    };
    Equation::new(name, definition, weight.value().to_string())
}

/// The heading, then the equations, each on its own lines.
impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.heading())?;
        self.equations().iter().try_for_each(|equation| write!(f, "\n{equation}"))
    }
}

/// The steps, with an empty line between them.
impl fmt::Display for Derivation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let steps: Vec<_> = self.steps().iter().map(Step::to_string).collect();
        f.pad(&steps.join("\n\n"))
    }
}

/// `C_{2i,m}` and `C_{2i+1,m}`, or the same with `f`.
fn names(letter: &str, m: u32) -> (String, String) {
    (format!("{letter}_{{2i,{m}}}"), format!("{letter}_{{2i+1,{m}}}"))
}

/// `f_{i+offset}`.
fn point(offset: i64) -> String {
    match offset {
        0 => "f_i".to_string(),
        _ => format!("f_{{i{offset:+}}}"),
    }
}

fn written_vector(vector: &Laurent<Rational>) -> String {
    written(&vector.map(|c| ParameterPolynomial::constant(c.clone())))
}

/// A combination of control points; numbers share their denominator: `1/16*(-f_{i-1} + 9*f_i)`.
fn written(combination: &Laurent<ParameterPolynomial>) -> String {
    let coefficients = combination.coefficients().iter();
    let constants: Option<Vec<Rational>> =
        coefficients.map(ParameterPolynomial::as_constant).collect();
    let common = constants.map_or_else(Integer::one, |values| clear_denominators(values.iter()).0);
    if common == Integer::one() {
        return written_sum(combination);
    }
    let scale = Rational::from(common.clone());
    let cleared = combination.map(|c| c.scaled(&scale));
    format!("1/{common}*({})", written_sum(&cleared))
}

fn written_sum(combination: &Laurent<ParameterPolynomial>) -> String {
    let mut text = String::new();
    for (offset, c) in combination.terms().filter(|(_, c)| !c.is_zero()) {
        let (negative, size) = signed(c);
        push_sign(&mut text, negative);
        if size != "1" {
            text.push_str(&size);
            text.push('*');
        }
        text.push_str(&point(offset));
    }
    if text.is_empty() { "0".into() } else { text }
}

/// The sign of a single term and what follows it; a sum keeps its signs inside brackets.
fn signed(c: &ParameterPolynomial) -> (bool, String) {
    let text = c.to_string();
    if c.terms().len() > 1 {
        return (false, format!("({text})"));
    }
    match text.strip_prefix('-') {
        Some(size) => (true, size.to_string()),
        None => (false, text),
    }
}
