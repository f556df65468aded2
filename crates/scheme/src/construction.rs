//! Constructions: schemes as functions of numbers, parameters and other schemes.
//!
//! With `σ = (1+z)²/(4z)` and `δ = -(1-z)²/(4z)`, `σ + δ = 1`.

use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;

use refinable_algebra::{Laurent, ParameterPolynomial, Rational, Ring};

use crate::budget::{Budget, FARTHEST_INDEX};
use crate::diagnostic::Diagnostic;
use crate::mask::Mask;
use crate::quotient::Quotient;
use crate::scheme::Scheme;

/// The largest whole number that a construction takes.
const LARGEST_NUMBER: u32 = 60;
/// The deepest nesting of constructions.
const DEEPEST: usize = 16;

/// A construction: what it is called, what it takes, what it is and where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct Construction {
    name: &'static str,
    signature: &'static str,
    description: &'static str,
    source: Option<&'static str>,
    build: fn(&[&str], usize) -> Result<Mask, Diagnostic>,
}

impl Construction {
    /// How it is written, such as `pseudo(m, l)`.
    pub fn signature(&self) -> &'static str {
        self.signature
    }

    /// What it makes.
    pub fn description(&self) -> &'static str {
        self.description
    }

    /// Where it comes from, if it is not obvious.
    pub fn source(&self) -> Option<&'static str> {
        self.source
    }
}

const CONSTRUCTIONS: [Construction; 13] = [
    Construction {
        name: "pseudo",
        signature: "pseudo(m, l)",
        description: "primal pseudo-spline: 2 σ^m Σ_{j≤l} C(m-1+j, j) δ^j",
        source: Some("Dong and Shen 2007"),
        build: |arguments, _| {
            let [m, l] = whole_numbers(arguments)?;
            pseudo_spline(m, l, false)
        },
    },
    Construction {
        name: "dualpseudo",
        signature: "dualpseudo(m, l)",
        description: "dual pseudo-spline: σ^m (1 + 1/z) Σ_{j≤l} C(m-1/2+j, j) δ^j",
        source: Some("Dyn, Hormann, Sabin and Shen 2008"),
        build: |arguments, _| {
            let [m, l] = whole_numbers(arguments)?;
            pseudo_spline(m, l, true)
        },
    },
    Construction {
        name: "hormannsabin",
        signature: "hormannsabin(k)",
        description: "cubic precision: (1+z)^k (1 + k/2 δ), normalised and centred",
        source: Some("Hormann and Sabin 2008"),
        build: |arguments, _| {
            let [k] = whole_numbers(arguments)?;
            pseudo_spline(k / 2, 1, k % 2 == 1)
        },
    },
    Construction {
        name: "jspline",
        signature: "jspline(s), jspline(a, b)",
        description: "J-spline: vertex [a, 8-2a, a]/8, edge [b-1, 9-b, 9-b, b-1]/16, a = b = s",
        source: Some("Rossignac and Schaefer 2009"),
        build: |arguments, _| match arguments {
            [s] => j_spline(s, s),
            [a, b] => j_spline(a, b),
            _ => Err(wrong_count("jspline(s), jspline(a, b)")),
        },
    },
    Construction {
        name: "fourpoint",
        signature: "fourpoint(w)",
        description: "interpolatory four-point scheme with tension",
        source: Some("Dyn, Gregory and Levin 1987"),
        build: |arguments, _| {
            let [w] = expressions(arguments, "fourpoint(w)")?;
            Mask::parse(&format!("even: [1]; odd: [-{w}, 1/2+{w}, 1/2+{w}, -{w}]"), 2)
        },
    },
    Construction {
        name: "sixpoint",
        signature: "sixpoint(w)",
        description: "interpolatory six-point scheme with tension, of cubic precision",
        source: Some("Weissman 1990"),
        build: |arguments, _| {
            let [w] = expressions(arguments, "sixpoint(w)")?;
            let half = format!("{w}, -1/16-3*{w}, 9/16+2*{w}");
            let other = format!("9/16+2*{w}, -1/16-3*{w}, {w}");
            Mask::parse(&format!("even: [1]; odd: [{half}, {other}]"), 2)
        },
    },
    Construction {
        name: "dualfourpoint",
        signature: "dualfourpoint(w)",
        description: "dual four-point scheme with tension; of fourth order accuracy at w = 1/128",
        source: Some("Dyn, Floater and Hormann 2005"),
        build: |arguments, _| {
            let [w] = expressions(arguments, "dualfourpoint(w)")?;
            let weights =
                [format!("-7*{w}"), format!("3/4+9*{w}"), format!("1/4+3*{w}"), format!("-5*{w}")];
            let [a, b, c, d] = weights;
            Mask::parse(&format!("even: [{a}, {b}, {c}, {d}]; odd: [{d}, {c}, {b}, {a}]"), 2)
        },
    },
    Construction {
        name: "ternaryfourpoint",
        signature: "ternaryfourpoint(mu)",
        description: "ternary interpolatory four-point scheme",
        source: Some("Hassan, Ivrissimtzis, Dodgson and Sabin 2002"),
        build: |arguments, _| {
            let [mu] = expressions(arguments, "ternaryfourpoint(mu)")?;
            let weights = [
                format!("-1/18-{mu}/6"),
                format!("13/18+{mu}/2"),
                format!("7/18-{mu}/2"),
                format!("-1/18+{mu}/6"),
            ];
            let [a, b, c, d] = weights;
            let rules = format!("0: [1]; 1: [{a}, {b}, {c}, {d}]; 2: [{d}, {c}, {b}, {a}]");
            Mask::parse(&rules, 3)
        },
    },
    Construction {
        name: "smooth",
        signature: "smooth(SCHEME, k)",
        description: "k averagings after the refinement: a(z) ((1+…+z^(m-1))/m)^k, centred",
        source: Some("Lane and Riesenfeld 1980; refine and smooth"),
        build: |arguments, depth| {
            let [scheme, k] = two(arguments, "smooth(SCHEME, k)")?;
            smoothed(&resolved(scheme, depth)?, whole_number(k, 0..=LARGEST_NUMBER)?)
        },
    },
    Construction {
        name: "convolve",
        signature: "convolve(SCHEME, SCHEME)",
        description: "a(z) b(z)/m: the basic limit functions are convolved",
        source: Some("Dyn and Levin 2002"),
        build: |arguments, depth| {
            let [a, b] = two(arguments, "convolve(SCHEME, SCHEME)")?;
            let (a, b) = (resolved(a, depth)?, resolved(b, depth)?);
            let m = same_arity(&a, &b)?;
            let mut budget = Budget::new();
            let product = quotient(&a)?.times(&quotient(&b)?, &mut budget)?;
            let product =
                product.times(&constant(Rational::from_i64(m as i64).recip()), &mut budget)?;
            Mask::of_quotient(m, product, &mut budget)
        },
    },
    Construction {
        name: "combine",
        signature: "combine(SCHEME, SCHEME, w)",
        description: "(1-w) a(z) + w b(z)",
        source: Some("for instance Li and Zheng 2013: the cubic spline and the four-point scheme"),
        build: |arguments, depth| {
            let [a, b, w] = arguments else {
                return Err(wrong_count("combine(SCHEME, SCHEME, w)"));
            };
            let (a, b) = (resolved(a, depth)?, resolved(b, depth)?);
            let m = same_arity(&a, &b)?;
            let mut budget = Budget::new();
            let w = scalar(w, &mut budget)?;
            let rest = constant(Rational::one()).plus(&w.negated(), &mut budget)?;
            let first = quotient(&a)?.times(&rest, &mut budget)?;
            let second = quotient(&b)?.times(&w, &mut budget)?;
            Mask::of_quotient(m, first.plus(&second, &mut budget)?, &mut budget)
        },
    },
    Construction {
        name: "shift",
        signature: "shift(SCHEME, k)",
        description: "z^k a(z): the same scheme with other indices",
        source: None,
        build: |arguments, depth| {
            let [scheme, k] = two(arguments, "shift(SCHEME, k)")?;
            let k = whole_number(k, -FARTHEST_INDEX..=FARTHEST_INDEX)?;
            let scheme = resolved(scheme, depth)?;
            let z = Quotient::polynomial(Laurent::monomial(ParameterPolynomial::one(), k));
            let mut budget = Budget::new();
            let shifted = quotient(&scheme)?.times(&z, &mut budget)?;
            Mask::of_quotient(scheme.mask().arity(), shifted, &mut budget)
        },
    },
    Construction {
        name: TENSOR,
        signature: "tensor(SCHEME, SCHEME)",
        description: "a(z) b(w) for nets: the first from row to row, the second along the rows",
        source: None,
        build: |_, _| {
            let hint = "`surface` refines nets with it; all else is said of its two factors";
            Err(Diagnostic::new("construction", "a tensor product has a symbol in two variables")
                .with_hint(hint))
        },
    },
];

const TENSOR: &str = "tensor";

/// All constructions.
///
/// ```
/// use refinable_scheme::{Scheme, constructions};
/// assert!(constructions().iter().any(|c| c.signature() == "pseudo(m, l)"));
/// let made = Scheme::resolve("smooth(dd2, 2)", 2).unwrap();
/// assert_eq!(made.mask(), Scheme::resolve("bspline3", 2).unwrap().mask());
/// ```
pub fn constructions() -> &'static [Construction] {
    &CONSTRUCTIONS
}

/// The texts of the schemes `S` and `T` in `tensor(S, T)`: from row to row, and along the rows; `None` if the
/// text is not of this form.
///
/// # Errors
/// Code `construction` for another number of schemes.
///
/// ```
/// use refinable_scheme::tensor_factors;
/// let factors = tensor_factors("tensor(jspline(1, 2), dd4)").unwrap().unwrap();
/// assert_eq!(factors, ["jspline(1, 2)", "dd4"]);
/// assert!(tensor_factors("dd4").is_none());
/// ```
pub fn tensor_factors(text: &str) -> Option<Result<[&str; 2], Diagnostic>> {
    let (name, arguments) = call(text.trim())?;
    (name == TENSOR).then(|| two(&arguments, "tensor(SCHEME, SCHEME)"))
}

/// The name and the arguments of `NAME(…)`.
fn call(text: &str) -> Option<(&str, Vec<&str>)> {
    let (name, rest) = text.split_once('(')?;
    Some((name.trim(), arguments(rest.strip_suffix(')')?)?))
}

/// What `NAME(…)` is made by, and the mask that it makes; `None` if the text is no such thing.
pub(crate) fn constructed(
    text: &str,
    depth: usize,
) -> Option<(&'static Construction, Result<Mask, Diagnostic>)> {
    let (name, arguments) = call(text)?;
    let construction = CONSTRUCTIONS.iter().find(|c| c.name == name)?;
    let mask = if depth < DEEPEST {
        (construction.build)(&arguments, depth + 1)
    } else {
        let message = format!("constructions are nested deeper than {DEEPEST} levels");
        Err(Diagnostic::new("budget", message))
    };
    Some((construction, mask))
}

/// The parts between the commas that are in no brackets; `None` if the brackets do not match.
fn arguments(text: &str) -> Option<Vec<&str>> {
    let (mut depth, mut start, mut parts) = (0_i64, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
        if depth < 0 {
            return None;
        }
    }
    parts.push(text[start..].trim());
    Some(parts)
}

fn wrong_count(signature: &str) -> Diagnostic {
    Diagnostic::new("construction", "the construction takes other arguments")
        .with_hint(format!("write {signature}"))
}

/// A whole number within bounds.
fn whole_number<T: FromStr + PartialOrd + Display>(
    text: &str,
    bounds: RangeInclusive<T>,
) -> Result<T, Diagnostic> {
    let number: Option<T> = text.trim().parse().ok();
    number.filter(|k| bounds.contains(k)).ok_or_else(|| {
        let shown: String = text.chars().take(24).collect();
        let message = format!("`{shown}` is no whole number that fits here");
        let hint = format!("{} to {} do", bounds.start(), bounds.end());
        Diagnostic::new("construction", message).with_hint(hint)
    })
}

fn whole_numbers<const N: usize>(arguments: &[&str]) -> Result<[u32; N], Diagnostic> {
    let mut numbers = Vec::new();
    for text in arguments {
        numbers.push(whole_number(text, 0..=LARGEST_NUMBER)?);
    }
    let hint = if N == 1 { "one whole number" } else { "two whole numbers" };
    numbers.try_into().map_err(|_| wrong_count(hint))
}

fn two<'a>(arguments: &[&'a str], signature: &str) -> Result<[&'a str; 2], Diagnostic> {
    <[&str; 2]>::try_from(arguments).map_err(|_| wrong_count(signature))
}

/// Expressions in parentheses, to be put into masks; each is one by itself.
fn expressions<const N: usize>(
    arguments: &[&str],
    signature: &str,
) -> Result<[String; N], Diagnostic> {
    for text in arguments {
        crate::expression::Expression::parse(text)?;
    }
    let wrapped: Vec<String> = arguments.iter().map(|text| format!("({text})")).collect();
    wrapped.try_into().map_err(|_| wrong_count(signature))
}

fn resolved(text: &str, depth: usize) -> Result<Scheme, Diagnostic> {
    Scheme::resolve_nested(text, depth)
}

fn same_arity(a: &Scheme, b: &Scheme) -> Result<usize, Diagnostic> {
    let (m, n) = (a.mask().arity(), b.mask().arity());
    if m == n {
        return Ok(m);
    }
    Err(Diagnostic::new("arity", format!("the schemes have the arities {m} and {n}")))
}

fn quotient(scheme: &Scheme) -> Result<Quotient, Diagnostic> {
    let mask = scheme.mask();
    Quotient::new(mask.numerator().clone(), mask.denominator().clone(), &mut Budget::new())
}

fn constant(x: Rational) -> Quotient {
    Quotient::constant(ParameterPolynomial::constant(x))
}

/// An expression in parameters, as a factor of symbols.
fn scalar(text: &str, budget: &mut Budget) -> Result<Quotient, Diagnostic> {
    let value = crate::expression::Expression::parse(text)?.evaluate()?;
    let numerator = Laurent::new(0, vec![value.numerator().clone()]);
    Quotient::new(numerator, value.denominator().clone(), budget)
}

/// `2 σ^m Σ_{j≤l} C(h+j, j) δ^j` with `h = m - 1`; dual ones with `h = m - 1/2` and a factor `(1 + 1/z)/2`.
///
/// # Source
/// B. Dong, Z. Shen, *Pseudo-splines, wavelets and framelets*, 2007; N. Dyn, K. Hormann, M. Sabin, Z. Shen,
/// *Polynomial reproduction by symmetric subdivision schemes*, J. Approx. Theory 155 (2008).
fn pseudo_spline(m: u32, l: u32, is_dual: bool) -> Result<Mask, Diagnostic> {
    if l >= m {
        return Err(Diagnostic::new("construction", "there is no such pseudo-spline")
            .with_hint("l is less than m, half the number of factors 1 + z, rounded down"));
    }
    // C(h+j, j) = Π_{i=1..j} (h+i)/i, with 2h whole.
    let twice = 2 * i64::from(m) - if is_dual { 1 } else { 2 };
    let mut binomial = Rational::one();
    let mut sum = String::from("1");
    for j in 1..=i64::from(l) {
        binomial *= Rational::new((twice + 2 * j).into(), (2 * j).into());
        sum.push_str(&format!(" + {binomial}*(-(1-z)^2/(4*z))^{j}"));
    }
    let factor = if is_dual { "(1 + 1/z)" } else { "2" };
    Mask::parse(&format!("{factor}*((1+z)^2/(4*z))^{m}*({sum})"), 2)
}

/// # Source
/// J. Rossignac, S. Schaefer, *J-splines*, Computer-Aided Design 41 (2009).
fn j_spline(a: &str, b: &str) -> Result<Mask, Diagnostic> {
    let [a, b] = expressions(&[a, b], "jspline(a, b)")?;
    let edge = format!("1/16*[{b}-1, 9-{b}, 9-{b}, {b}-1]");
    Mask::parse(&format!("even: 1/8*[{a}, 8-2*{a}, {a}]; odd: {edge}"), 2)
}

/// `a(z) ((1+…+z^(m-1))/m)^k`, moved back by half of what it grew.
fn smoothed(scheme: &Scheme, k: u32) -> Result<Mask, Diagnostic> {
    let m = scheme.mask().arity();
    let mut budget = Budget::new();
    let weight = ParameterPolynomial::constant(Rational::from_i64(m as i64).recip());
    let box_function = Quotient::polynomial(Laurent::new(0, vec![weight; m]));
    let power = box_function.power(k as i32, &mut budget)?;
    let back = -((k as i64 * (m as i64 - 1) + 1) / 2);
    let back = Quotient::polynomial(Laurent::monomial(ParameterPolynomial::one(), back));
    let smoothed = quotient(scheme)?.times(&power, &mut budget)?.times(&back, &mut budget)?;
    Mask::of_quotient(m, smoothed, &mut budget)
}
