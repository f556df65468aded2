//! LaTeX for exact quantities.

use refinable_algebra::{
    Ordered, Parameter, ParameterFraction, ParameterPolynomial, Rational, Ring, integer,
};
use refinable_reals::{Bound, ExactForm, Radical, RealAlgebraic, Region};

use crate::dialect::Dialect;

/// The Greek letters that LaTeX has commands for, by their names.
const GREEK: [(&str, &str); 23] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
];

/// Whether the name is a Greek letter's, in small letters.
pub fn is_greek(name: &str) -> bool {
    greek_letter(name).is_some()
}

/// The Greek letter of a name.
pub fn greek_letter(name: &str) -> Option<&'static str> {
    GREEK.iter().find(|(known, _)| *known == name).map(|(_, letter)| *letter)
}

/// A parameter's name in math mode: `\alpha`, `w`, `\mathit{tension}`.
pub fn name(name: &str) -> String {
    if is_greek(name) {
        format!("\\{name}")
    } else if name.chars().count() == 1 {
        name.to_string()
    } else {
        format!("\\mathit{{{}}}", name.replace('_', "\\_"))
    }
}

/// `\frac{p}{q}`, or `p`.
pub fn rational(x: &Rational) -> String {
    if x.is_integer() {
        return x.to_string();
    }
    let sign = if x.compare_to_zero().is_lt() { "-" } else { "" };
    format!("{sign}\\frac{{{}}}{{{}}}", x.numer().absolute(), x.denom())
}

/// LaTeX in math mode.
struct Latex;

impl Dialect for Latex {
    const SIGNS: [&str; 2] = ["+", "-"];

    fn name(&self, parameter: &Parameter) -> String {
        name(parameter.name())
    }

    fn number(&self, size: &Rational, _alone: bool) -> String {
        rational(size)
    }

    fn power(&self, base: &str, exponent: u32) -> String {
        format!("{base}^{{{exponent}}}")
    }

    fn product(&self, number: Option<String>, powers: &[String]) -> String {
        format!("{}{}", number.unwrap_or_default(), powers.join(" "))
    }

    fn quotient(&self, top: &str, bottom: &str) -> String {
        format!("\\frac{{{top}}}{{{bottom}}}")
    }
}

/// A polynomial, constant term first, as masks are printed.
pub fn polynomial(p: &ParameterPolynomial) -> String {
    Latex.polynomial(p)
}

/// A fraction of polynomials.
pub fn fraction(f: &ParameterFraction) -> String {
    Latex.fraction(f)
}

/// A real algebraic number; `variable` names the unknown of `root(POLY, k)`.
pub fn number(x: &RealAlgebraic, variable: &str) -> String {
    match x.exact_form() {
        ExactForm::Rational(x) => rational(&x),
        ExactForm::Radical(radical) => self::radical(&radical),
        ExactForm::Root { polynomial, index } => {
            let text = polynomial.display(&name(variable)).replace('*', "");
            format!("\\operatorname{{root}}_{{{index}}}({text})")
        }
    }
}

fn radical(r: &Radical) -> String {
    let size = r.coefficient.absolute();
    let factor = if size == integer(1) { String::new() } else { size.to_string() };
    let negative = r.coefficient.compare_to_zero().is_lt();
    let sign = match (negative, r.rational_part.is_zero()) {
        (true, _) => "-",
        (false, true) => "",
        (false, false) => "+",
    };
    let first = if r.rational_part.is_zero() { String::new() } else { r.rational_part.to_string() };
    let top = format!("{first}{sign}{factor}\\sqrt{{{}}}", r.radicand);
    if r.denominator == integer(1) { top } else { format!("\\frac{{{top}}}{{{}}}", r.denominator) }
}

/// A union of intervals.
pub fn region(region: &Region, variable: &str) -> String {
    let parts: Vec<String> = region
        .intervals()
        .iter()
        .map(|interval| match interval.as_point() {
            Some(x) => format!("\\{{{}\\}}", number(x, variable)),
            None => {
                let lower = match &interval.lower {
                    Bound::Infinite => "(-\\infty".to_string(),
                    Bound::Open(x) => format!("({}", number(x, variable)),
                    Bound::Closed(x) => format!("[{}", number(x, variable)),
                };
                let upper = match &interval.upper {
                    Bound::Infinite => "\\infty)".to_string(),
                    Bound::Open(x) => format!("{})", number(x, variable)),
                    Bound::Closed(x) => format!("{}]", number(x, variable)),
                };
                format!("{lower},\\,{upper}")
            }
        })
        .collect();
    if parts.is_empty() { "\\emptyset".into() } else { parts.join(" \\cup ") }
}

/// Plain text with LaTeX's special characters escaped and the few signs our texts use translated.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            // The order of C^2, the power of a bracket.
            '^' if rest.peek().is_some_and(char::is_ascii_digit) => {
                let digits = std::iter::from_fn(|| rest.next_if(char::is_ascii_digit));
                escaped.push_str(&format!("$^{{{}}}$", digits.collect::<String>()));
            }
            '\\' => escaped.push_str("\\textbackslash{}"),
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                escaped.push('\\');
                escaped.push(c);
            }
            '~' => escaped.push_str("\\textasciitilde{}"),
            '^' => escaped.push_str("\\textasciicircum{}"),
            '<' | '>' | '|' => escaped.push_str(&format!("${c}$")),
            _ => match symbol(c) {
                Some(command) => escaped.push_str(&format!("${command}$")),
                None => escaped.push(c),
            },
        }
    }
    escaped
}

fn symbol(c: char) -> Option<&'static str> {
    Some(match c {
        '∪' => "\\cup",
        '∅' => "\\emptyset",
        '∞' => "\\infty",
        '≈' => "\\approx",
        '≤' => "\\le",
        '≥' => "\\ge",
        '∈' => "\\in",
        '‖' => "\\|",
        '∀' => "\\forall",
        _ => return None,
    })
}

/// A formula written in plain text (`-1/4 < alpha < (3-sqrt(3))/64`) in math mode; text that is not
/// made of numbers, known names and operators alone is escaped instead.
pub fn formula_or_text(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    formula(text).map_or_else(|| escape(text), |math| format!("${}$", math.trim_end()))
}

fn formula(text: &str) -> Option<String> {
    let mut math = String::new();
    let mut rest = text.trim();
    let mut open_roots: Vec<i32> = Vec::new();
    let mut depth = 0_i32;
    while let Some(c) = rest.chars().next() {
        let word: String = rest.chars().take_while(char::is_ascii_alphabetic).collect();
        if word == "sqrt" && rest[4..].starts_with('(') {
            math.push_str("\\sqrt{");
            depth += 1;
            open_roots.push(depth);
            rest = &rest[5..];
            continue;
        }
        if !word.is_empty() {
            let known = is_greek(&word) || word.len() == 1;
            math.push_str(&known.then(|| name(&word))?);
            math.push(' ');
            rest = &rest[word.len()..];
            continue;
        }
        if rest.starts_with("..") {
            math.push_str("\\dots ");
            rest = rest[2..].trim_start();
            continue;
        }
        match c {
            '(' => {
                depth += 1;
                math.push('(');
            }
            ')' if open_roots.last() == Some(&depth) => {
                open_roots.pop();
                depth -= 1;
                math.push('}');
            }
            ')' => {
                depth -= 1;
                math.push(')');
            }
            '*' => math.push_str("\\,"),
            '^' => {
                let digits = rest[1..].chars().take_while(char::is_ascii_digit);
                let exponent: String = digits.collect();
                rest = &rest[exponent.len()..];
                let power =
                    if exponent.is_empty() { "^".into() } else { format!("^{{{exponent}}}") };
                math.push_str(&power);
            }
            '{' | '}' => {
                math.push('\\');
                math.push(c);
            }
            // Long masks must break somewhere.
            ',' => math.push_str(",\\allowbreak "),
            _ if "0123456789+-/<>=[].|@ ".contains(c) => math.push(c),
            _ => math.push_str(symbol(c)?),
        }
        rest = &rest[c.len_utf8()..];
    }
    Some(math)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational as q;

    #[test]
    fn polynomials_and_fractions() {
        let [a, b] = ["alpha", "beta"].map(|n| ParameterPolynomial::parameter(&Parameter::new(n)));
        let p = ParameterPolynomial::constant(q(-1, 16)).plus(&a.times(&b).scaled(&q(3, 1)));
        assert_eq!(polynomial(&p), "-\\frac{1}{16}+3\\alpha \\beta");
    }

    #[test]
    fn formulas_in_plain_text() {
        assert_eq!(
            formula_or_text("-1/4 < alpha < (3-sqrt(3))/64"),
            "$-1/4 < \\alpha  < (3-\\sqrt{3})/64$"
        );
        assert_eq!(formula_or_text("not 100% checked"), "not 100\\% checked");
        assert_eq!(formula_or_text("-∞ .. ≈ 0.19"), "$-\\infty \\dots \\approx 0.19$");
        assert_eq!(formula_or_text("0..w"), "$0\\dots w$");
        assert_eq!(formula_or_text("w"), "$w$");
        assert_eq!(formula_or_text("C^10"), "$C ^{10}$");
        assert_eq!(formula_or_text("C^12 of ^"), "C$^{12}$ of \\textasciicircum{}");
    }
}
