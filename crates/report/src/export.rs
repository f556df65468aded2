//! `export`: a scheme as code of a computer algebra system, or as formulas in LaTeX.

use std::collections::BTreeMap;

use refinable_algebra::{Integer, Parameter, ParameterFraction, Rational, Ring};
use refinable_scheme::{Mask, Scheme};

use crate::dialect::Dialect;
use crate::latex;
use crate::show::pole;

/// The languages that a scheme can be written in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Language {
    /// Python with SymPy.
    SymPy,
    /// The Wolfram Language.
    Mathematica,
    /// Maple.
    Maple,
    /// MATLAB with its Symbolic Math Toolbox; without parameters and with numbers that doubles hold, plain MATLAB
    /// or Octave.
    Matlab,
    /// LaTeX with amsmath.
    Latex,
}

/// A scheme in a language: its parameters, arity, mask, symbol `a(z) = Σ a_i z^i`, stencils and support, and what the
/// conventions are in comments; `settings` are those that led to it, such as `alpha=1/8`, for the reader.
///
/// Numbers are exact. Parameters whose names mean something else in the language are renamed, and a comment says so.
///
/// ```
/// use refinable_report::{Language, export};
/// use refinable_scheme::Scheme;
/// let scheme = Scheme::resolve("fourpoint(w)", 2).unwrap();
/// let code = export(&scheme, &[], Language::SymPy);
/// assert!(code.contains("w = Symbol(\"w\")\n"));
/// assert!(code.contains("    Rational(1, 2) + w,\n"));
/// ```
///
/// # Cost
/// That of writing every coefficient twice.
pub fn export(scheme: &Scheme, settings: &[String], language: Language) -> String {
    let syntax = match language {
        Language::SymPy => &SYMPY,
        Language::Mathematica => &MATHEMATICA,
        Language::Maple => &MAPLE,
        Language::Matlab if fits_doubles(scheme.mask()) => &DOUBLES,
        Language::Matlab => &MATLAB,
        Language::Latex => return formulas(scheme, settings),
    };
    Code::new(syntax, scheme.mask()).program(scheme, settings)
}

/// Whether there is no parameter, and doubles hold all numerators and denominators: the quotients then are as exact
/// as doubles can be.
fn fits_doubles(mask: &Mask) -> bool {
    mask.coefficients().all(|(_, a)| a.as_constant().is_some_and(|a| holds(&a)))
}

/// The bits of the whole numbers that doubles hold.
const DOUBLE: u64 = 53;

/// Whether numerator and denominator are whole numbers that doubles hold.
fn holds(x: &Rational) -> bool {
    x.numer().bits().max(x.denom().bits()) <= DOUBLE
}

/// The looks of a language; what is written is the same in all of them.
struct Syntax {
    /// Around a comment of one line.
    comment: [&'static str; 2],
    /// Names that mean something else and cannot be had.
    taken: &'static [&'static str],
    /// Names of functions that a parameter hides, as far as papers use them for parameters.
    hidden: &'static [&'static str],
    /// Whether all other words can be had. If not, the language has too many of its own to be listed here: a letter
    /// or a Greek letter's name, perhaps with digits, is safe, and so is what ends in an underscore.
    words: bool,
    /// The part of a parameter's name that the language admits.
    admitted: fn(&str) -> String,
    /// What is put behind a name that cannot be had.
    mark: char,
    /// What comes before everything.
    opening: &'static str,
    /// Makes symbols of names, each with the parameter's own.
    declaration: fn(&[(&str, &str)]) -> String,
    /// Between a name and its value, and after it.
    definition: [&'static str; 2],
    /// Around a list of numbers.
    numbers: [&'static str; 2],
    /// Around a list of lists.
    lists: [&'static str; 2],
    /// At the end of a line inside a list.
    unfinished: &'static str,
    /// Between base and exponent.
    power: &'static str,
    /// A number that is not negative; `true` if it stands alone, where nothing beside it makes it exact.
    number: fn(&Rational, bool) -> String,
    /// The definition of the symbol from the mask.
    symbol: &'static str,
}

const SYMPY: Syntax = Syntax {
    comment: ["# ", ""],
    taken: &["E", "I", "N", "O", "Q", "S", "lambda", "pi"],
    hidden: &["beta", "gamma", "zeta"],
    words: false,
    admitted: str::to_string,
    mark: '_',
    opening: "from sympy import Rational, Symbol\n\n",
    declaration: |names| {
        names.iter().map(|(name, own)| format!("{name} = Symbol(\"{own}\")\n")).collect()
    },
    definition: [" = ", ""],
    numbers: ["[", "]"],
    lists: ["[", "]"],
    unfinished: "",
    power: "**",
    number: |size, alone| match (size.is_integer(), alone) {
        (true, false) => size.to_string(),
        (true, true) => format!("Rational({size})"),
        (false, _) => format!("Rational({}, {})", size.numer(), size.denom()),
    },
    symbol: "\n\ndef masksymbol(z):\n    return sum(a * z**i for i, a in enumerate(mask, start=first))\n\n\n",
};

const MATHEMATICA: Syntax = Syntax {
    comment: ["(* ", " *)"],
    // What the code defines, and z; the names of the system begin with capital letters.
    taken: &["arity", "first", "mask", "masksymbol", "stencils", "support", "z"],
    hidden: &[],
    words: true,
    admitted: |name| {
        let letters = name.chars().filter(|c| *c != '_').enumerate();
        letters.map(|(k, c)| if k == 0 { c.to_ascii_lowercase() } else { c }).collect()
    },
    mark: '1',
    opening: "",
    declaration: |names| format!("Clear[{}];\n", joined(names)),
    definition: [" = ", ";"],
    numbers: ["{", "}"],
    lists: ["{", "}"],
    unfinished: "",
    power: "^",
    number: |size, _| size.to_string(),
    symbol: "masksymbol[z_] := mask . z^Range[first, first + Length[mask] - 1];\n",
};

const MAPLE: Syntax = Syntax {
    comment: ["# ", ""],
    taken: &["D", "I", "O", "gamma", "pi"],
    hidden: &[],
    words: false,
    admitted: str::to_string,
    mark: '_',
    opening: "",
    declaration: |names| format!("unassign('{}'):\n", joined(names).replace(", ", "', '")),
    definition: [" := ", ":"],
    numbers: ["[", "]"],
    lists: ["[", "]"],
    unfinished: "",
    power: "^",
    number: |size, _| size.to_string(),
    symbol: "masksymbol := z -> add(mask[term]*z^(first + term - 1), term = 1..nops(mask)):\n",
};

const MATLAB: Syntax = Syntax {
    comment: ["% ", ""],
    // Octave has more names of the imaginary unit, and e.
    taken: &["I", "J", "e", "i", "j", "pi"],
    hidden: &["alpha", "beta", "gamma", "psi", "sigma", "zeta"],
    words: false,
    admitted: str::to_string,
    mark: '_',
    opening: "% Needs the Symbolic Math Toolbox; in Octave: pkg load symbolic\n",
    declaration: |names| format!("syms {}\n", joined(names).replace(", ", " ")),
    definition: [" = ", ";"],
    numbers: ["[", "]"],
    lists: ["{", "}"],
    unfinished: " ...",
    power: "^",
    number: |size, alone| {
        let whole = |n: &Integer| match n.bits() {
            0..=DOUBLE => format!("sym({n})"),
            _ => format!("sym('{n}')"),
        };
        match size.is_integer() {
            true if !alone && holds(size) => size.to_string(),
            true => whole(size.numer()),
            false if holds(size) => format!("{}/{}", whole(size.numer()), size.denom()),
            false => format!("{}/{}", whole(size.numer()), whole(size.denom())),
        }
    },
    symbol: "masksymbol = @(z) sum(mask .* z.^(first + (0:numel(mask) - 1)));\n",
};

/// Plain MATLAB, and Octave.
const DOUBLES: Syntax = Syntax { opening: "", number: |size, _| size.to_string(), ..MATLAB };

/// The longest list in one line of code, and the most letters of plain text in a line of formulas.
const LINE: usize = 72;
/// The longest name before marks: MATLAB tells names apart by 63 letters.
const LONGEST_NAME: usize = 50;

fn joined(names: &[(&str, &str)]) -> String {
    let names: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
    names.join(", ")
}

/// A letter or the name of a Greek one, perhaps with digits.
fn is_letter(name: &str) -> bool {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
    stem.len() == 1 || latex::is_greek(stem)
}

/// What is written in a language.
struct Code {
    syntax: &'static Syntax,
    /// What the parameters are called.
    names: BTreeMap<Parameter, String>,
}

impl Dialect for Code {
    const SIGNS: [&str; 2] = [" + ", " - "];

    fn name(&self, parameter: &Parameter) -> String {
        self.names[parameter].clone()
    }

    fn number(&self, size: &Rational, alone: bool) -> String {
        (self.syntax.number)(size, alone)
    }

    fn power(&self, base: &str, exponent: u32) -> String {
        format!("{base}{}{exponent}", self.syntax.power)
    }

    fn product(&self, number: Option<String>, powers: &[String]) -> String {
        let factors: Vec<String> = number.into_iter().chain(powers.iter().cloned()).collect();
        factors.join("*")
    }

    fn quotient(&self, top: &str, bottom: &str) -> String {
        format!("({top})/({bottom})")
    }
}

impl Code {
    fn new(syntax: &'static Syntax, mask: &Mask) -> Self {
        let mut names: BTreeMap<Parameter, String> = BTreeMap::new();
        for parameter in mask.parameters() {
            let mut name: String =
                (syntax.admitted)(parameter.name()).chars().take(LONGEST_NAME).collect();
            while syntax.taken.contains(&name.as_str())
                || !(syntax.words || is_letter(&name) || name.ends_with('_'))
                || names.values().any(|used| *used == name)
            {
                name.push(syntax.mark);
            }
            names.insert(parameter, name);
        }
        Code { syntax, names }
    }

    fn program(&self, scheme: &Scheme, settings: &[String]) -> String {
        let mask = scheme.mask();
        let mut remarks = heading(scheme, settings);
        remarks.extend(VARIABLES.into_iter().chain(CONVERSIONS).map(String::from));
        let on_names = self.remarks_on_names();
        if !on_names.is_empty() {
            remarks.push(String::new());
            remarks.extend(on_names);
        }
        let mut text =
            format!("{}\n{}", comments(&remarks, self.syntax.comment), self.syntax.opening);
        if !self.names.is_empty() {
            let names: Vec<(&str, &str)> =
                self.names.iter().map(|(own, name)| (name.as_str(), own.name())).collect();
            text.push_str(&(self.syntax.declaration)(&names));
            text.push('\n');
        }
        let (lowest, highest) = mask.support();
        let coefficients: Vec<ParameterFraction> = mask.coefficients().map(|(_, a)| a).collect();
        let stencils: Vec<String> = mask
            .rule()
            .stencils()
            .iter()
            .map(|stencil| {
                let [open, close] = self.syntax.lists;
                format!("{open}{}, {}{close}", stencil.first(), self.numbers(stencil.weights(), 2))
            })
            .collect();
        let [open, close] = self.syntax.numbers;
        text.push_str(&self.definition("arity", &mask.arity().to_string()));
        text.push_str(&self.definition("first", &lowest.to_string()));
        text.push_str(&self.definition("mask", &self.numbers(&coefficients, 1)));
        text.push_str(self.syntax.symbol);
        text.push_str(&self.definition("stencils", &self.lines(&stencils, self.syntax.lists, 1)));
        text.push_str(&self.definition("support", &format!("{open}{lowest}, {highest}{close}")));
        text
    }

    fn remarks_on_names(&self) -> Vec<String> {
        let remark = |(parameter, name): (&Parameter, &String)| {
            if parameter.name() != name {
                Some(format!("The parameter {parameter} is called {name} here."))
            } else if self.syntax.hidden.contains(&name.as_str()) {
                Some(format!("The parameter {name} hides the function of that name."))
            } else {
                None
            }
        };
        self.names.iter().filter_map(remark).collect()
    }

    fn definition(&self, name: &str, value: &str) -> String {
        let [is, end] = self.syntax.definition;
        format!("{name}{is}{value}{end}\n")
    }

    fn numbers(&self, numbers: &[ParameterFraction], depth: usize) -> String {
        let numbers: Vec<String> = numbers.iter().map(|a| self.fraction(a)).collect();
        let [open, close] = self.syntax.numbers;
        let short = format!("{open}{}{close}", numbers.join(", "));
        if short.len() <= LINE { short } else { self.lines(&numbers, [open, close], depth) }
    }

    /// A list with one item in a line.
    fn lines(&self, items: &[String], [open, close]: [&str; 2], depth: usize) -> String {
        let unfinished = self.syntax.unfinished;
        let [inner, outer] = [depth, depth - 1].map(|depth| "    ".repeat(depth));
        let items = items.join(&format!(",{unfinished}\n{inner}"));
        format!("{open}{unfinished}\n{inner}{items}{unfinished}\n{outer}{close}")
    }
}

/// What the scheme is, and how it refines.
fn heading(scheme: &Scheme, settings: &[String]) -> Vec<String> {
    let mut remarks = vec![
        "A subdivision scheme with exact coefficients, written by Refinable.".to_string(),
        String::new(),
        format!("scheme: \"{}\"", scheme.name()),
    ];
    if !settings.is_empty() {
        remarks.push(format!("set: \"{}\"", settings.join(", ")));
    }
    if let Some(source) = scheme.source() {
        remarks.push(format!("source: \"{source}\""));
    }
    remarks.extend(pole(scheme.mask()));
    remarks.extend(REFINEMENT.map(String::from));
    remarks
}

/// The conventions.
const REFINEMENT: [&str; 5] = [
    "",
    "One step of arity m: f'_i = Sum_j a_(i-m*j) f_j. So a_0 is the weight of f_0 in f'_0.",
    "The coefficients a_i sum to m, those with i = e modulo m, a stencil, sum to 1.",
    "The symbol is a(z) = Sum_i a_i z^i, in positive powers of z.",
    "",
];

/// What the code defines.
const VARIABLES: [&str; 6] = [
    "mask: a_i from i = first on",
    "masksymbol(z): a(z), of one z, a number or a symbol",
    "stencils: for e = 0, ..., m-1 a pair of an offset s and weights w_0, w_1, ..., which mean",
    "  f'_(m*i+e) = Sum_k w_k f_(i+s+k)",
    "support: the first and the last i with a_i not zero",
    "",
];

/// How others count, and how to get there.
const CONVERSIONS: [&str; 5] = [
    "To other conventions:",
    "- phi(x) = m Sum_i h_i phi(m*x-i), coefficients that sum to 1: h_i = a_i/m",
    "- filters, coefficients that sum to sqrt(m): a_i/sqrt(m)",
    "- symbols in powers of 1/z: a(1/z)",
    "- masks that begin at index 0: z^(-i) a(z) with their first index i, which moves the new points by i",
];

/// One comment for each remark.
fn comments(remarks: &[String], [open, close]: [&str; 2]) -> String {
    let line = |remark: &String| {
        // No name of a scheme goes on in the next line, or begins or ends a comment of Mathematica.
        let remark: String = remark.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let remark = remark.replace("(*", "( *").replace("*)", "* )");
        format!("{}\n", format!("{open}{remark}{close}").trim_end())
    };
    remarks.iter().map(line).collect()
}

/// LaTeX: the mask as a list, the symbol, and the rules as papers write them.
fn formulas(scheme: &Scheme, settings: &[String]) -> String {
    let mask = scheme.mask();
    let (lowest, highest) = mask.support();
    let mut remarks = heading(scheme, settings);
    remarks.extend(CONVERSIONS.map(String::from));
    remarks.extend(["".into(), "Needs the package amsmath.".into()]);
    let coefficients = mask.coefficients().map(|(i, a)| {
        let comma = if i == highest { "" } else { ",\\, " };
        (format!("{}{comma}", latex::fraction(&a)), a.to_string().len() + 2)
    });
    let mut rows = vec![
        format!("(a_i)_{{i={lowest}}}^{{{highest}}} ={{}}& [{}]", filled(coefficients)),
        format!("a(z) ={{}}& \\sum_{{i={lowest}}}^{{{highest}}} a_i z^i"),
    ];
    for (e, stencil) in mask.rule().stencils().iter().enumerate() {
        let weighted = stencil.terms().filter(|(_, w)| !w.numerator().is_zero());
        let terms = weighted
            .enumerate()
            .map(|(k, (j, w))| (summand(w, j, k == 0), w.to_string().len() + 6));
        let place = place(&mask.arity().to_string(), e as i64);
        rows.push(format!("f^{{k+1}}_{place} ={{}}& {}", filled(terms)));
    }
    let body = rows.join(",\\\\\n");
    format!("{}\\begin{{align*}}\n{body}.\n\\end{{align*}}\n", comments(&remarks, ["% ", ""]))
}

/// The index `{m i + j}`.
fn place(factor: &str, offset: i64) -> String {
    match offset {
        0 => format!("{{{factor}i}}"),
        _ => format!("{{{factor}i{offset:+}}}"),
    }
}

/// `± w f_{i+j}`; a weight of several terms in parentheses, none if it is one.
fn summand(weight: &ParameterFraction, offset: i64, is_first: bool) -> String {
    let single = weight.as_polynomial().filter(|p| p.terms().len() == 1);
    let text = latex::fraction(weight);
    let (sign, size) = match (single, text.strip_prefix('-')) {
        (Some(_), Some(size)) => ("-", size.to_string()),
        (None, _) if weight.as_polynomial().is_some() => ("+", format!("\\left({text}\\right)")),
        _ => ("+", text),
    };
    let size = if size == "1" { String::new() } else { format!("{size}\\,") };
    let sign = if is_first && sign == "+" { "" } else { sign };
    format!("{sign}{size}f^{{k}}_{}", place("", offset))
}

/// Parts of a formula, each with its width, in as many lines as it takes.
fn filled(parts: impl Iterator<Item = (String, usize)>) -> String {
    let (mut text, mut used) = (String::new(), 0);
    for (part, width) in parts {
        if used > 0 && used + width > LINE {
            text.push_str("\\\\\n& ");
            used = 0;
        }
        text.push_str(&part);
        used += width;
    }
    text
}
