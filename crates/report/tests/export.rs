//! Exported schemes, read back: by a reader of their syntax, and by SymPy where there is one.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use refinable_algebra::{ParameterFraction, Ring};
use refinable_report::{Language, export};
use refinable_scheme::{Expression, Mask, Scheme, SchemeFile, Stencil, Substitution};

const PROGRAMS: [Language; 4] =
    [Language::SymPy, Language::Mathematica, Language::Maple, Language::Matlab];

/// Families whose parameters have names that some language has taken, or that it cannot write.
const AWKWARD: [&str; 6] = [
    "[-lambda*E, 0, 1/2+lambda*E, 1, 1/2+lambda*E, 0, -lambda*E]",
    "even: [w_1, 1-w_1]; odd: [w1, 1-w1]",
    "even: [i*pi, 1-i*pi]; odd: [I, Gamma, 1-I-Gamma]",
    "even: [gamma, 1-gamma]; odd: [lambda, lambda_, 1-lambda-lambda_]",
    "even: [for/3, 1-for/3]; odd: [first, mask^2, 1-first-mask^2]",
    "even: [z1^12, 1-z1^12]; odd: [Z, 1-Z]",
];

/// Rational functions, also of two parameters, and numbers that no double holds.
const RATIONAL: [(&str, &str); 5] = [
    ("a3", "beta=(8*alpha-1)/(16*(1-alpha))"),
    ("a5", "beta=(128*alpha-3)/(256*(alpha-1))"),
    ("fourpoint(w)", "w=u/(3*v)"),
    ("fourpoint(w)", "w=(u^2-v)/(7-u*v^2)/123456789012345678901234567890"),
    ("fourpoint(w)", "w=12345678901234567890123456789/98765432109876543210987654321"),
];

fn schemes() -> Vec<Scheme> {
    let mut schemes = Vec::new();
    let catalogue = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scheme/catalogue");
    for entry in fs::read_dir(catalogue).unwrap() {
        let text = fs::read_to_string(entry.unwrap().path()).unwrap();
        schemes.push(SchemeFile::parse(&text).unwrap().scheme);
    }
    assert!(schemes.len() >= 37);
    let named = ["a2", "a3", "a8", "a9", "i10", "dd2", "dd40", "bspline1", "bspline64"];
    for text in named.iter().chain(&AWKWARD) {
        schemes.push(Scheme::resolve(text, 2).unwrap());
    }
    for (text, set) in RATIONAL {
        let set = Substitution::parse(set).unwrap();
        schemes.push(Scheme::resolve_with(text, 2, &[set]).unwrap());
    }
    schemes
}

/// What code says about a scheme.
struct Code {
    /// Everything but comments, in the notation of expressions.
    text: String,
    language: Language,
    /// The parameters by what they are called.
    names: BTreeMap<String, String>,
}

impl Code {
    fn of(scheme: &Scheme, language: Language) -> Self {
        let code = export(scheme, &[], language);
        let comment = match language {
            Language::SymPy | Language::Maple => "#",
            Language::Mathematica => "(*",
            Language::Matlab | Language::Latex => "%",
        };
        let (mut text, mut names) = (String::new(), BTreeMap::new());
        for line in code.lines() {
            if !line.starts_with(comment) {
                text.push_str(line.trim_end_matches(" ..."));
                text.push('\n');
            } else if let Some((_, renamed)) = line.split_once("The parameter ")
                && let Some((own, name)) = renamed.split_once(" is called ")
            {
                names.insert(name.split(' ').next().unwrap().into(), own.into());
            }
        }
        let text = text.replace("**", "^").replace('{', "[").replace('}', "]");
        Code { text: without_functions(&text), language, names }
    }

    /// What is assigned to a name, up to the end of the line or of the list.
    fn value(&self, name: &str) -> &str {
        let is = if self.language == Language::Maple { ":=" } else { "=" };
        let start = format!("\n{name} {is} ");
        let at = self.text.find(&start).unwrap_or_else(|| panic!("{name}:\n{}", self.text));
        let rest = &self.text[at + start.len()..];
        let mut depth = 0;
        let end = rest.find(|c| {
            depth += i32::from(c == '[') - i32::from(c == ']');
            depth == 0 && "\n;:".contains(c)
        });
        &rest[..end.unwrap()]
    }

    fn number(&self, text: &str) -> ParameterFraction {
        let own = |word: &str| self.names.get(word).cloned().unwrap_or_else(|| word.into());
        let text = map_words(text, &own);
        Expression::parse(&text).and_then(|e| e.evaluate()).unwrap_or_else(|e| panic!("{e}"))
    }

    fn numbers(&self, list: &str) -> Vec<ParameterFraction> {
        parts(list).into_iter().map(|text| self.number(text)).collect()
    }

    fn mask(&self) -> Mask {
        let [arity, first] = ["arity", "first"].map(|name| self.value(name).parse().unwrap());
        Mask::new(arity as usize, first, &self.numbers(self.value("mask"))).unwrap()
    }

    fn stencils(&self) -> Vec<Stencil> {
        let stencil = |text: &str| {
            let [first, weights] = parts(text).try_into().expect("a pair");
            Stencil::new(first.parse().unwrap(), self.numbers(weights))
        };
        parts(self.value("stencils")).into_iter().map(stencil).collect()
    }
}

/// `Rational(p, q)` as `(p/q)`, `sym(p)` and `sym('p')` as `(p)`.
fn without_functions(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some(at) = rest.find("Rational(").into_iter().chain(rest.find("sym(")).min() {
        let (before, call) = rest.split_at(at);
        let (_, call) = call.split_once('(').unwrap();
        let (inside, after) = call.split_once(')').unwrap();
        plain.push_str(&format!("{before}({})", inside.replace(", ", "/").replace('\'', "")));
        rest = after;
    }
    plain + rest
}

fn map_words(text: &str, f: &dyn Fn(&str) -> String) -> String {
    let is_inside = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut mapped = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = rest.find(|c| !is_inside(c)).unwrap_or(rest.len()).max(c.len_utf8());
        let (word, after) = rest.split_at(length);
        mapped.push_str(&f(word));
        rest = after;
    }
    mapped
}

/// The items of a list, which may be lists.
fn parts(list: &str) -> Vec<&str> {
    let inside = list.trim().strip_prefix('[').and_then(|list| list.strip_suffix(']'));
    let inside = inside.unwrap_or_else(|| panic!("no list: {list}"));
    let mut depth = 0;
    let at_comma = |c: char| {
        depth += i32::from("[(".contains(c)) - i32::from("])".contains(c));
        depth == 0 && c == ','
    };
    inside.split(at_comma).map(str::trim).collect()
}

#[test]
fn programs_say_what_the_scheme_is() {
    for scheme in schemes() {
        for language in PROGRAMS {
            let code = Code::of(&scheme, language);
            let what = format!("{} in {language:?}", scheme.name());
            assert_eq!(&code.mask(), &**scheme.mask(), "{what}");
            assert_eq!(code.stencils(), scheme.mask().rule().stencils(), "{what}");
            let (lowest, highest) = scheme.mask().support();
            assert_eq!(parts(code.value("support")), [lowest, highest].map(|i| i.to_string()));
        }
    }
}

/// The mask is read by the reader of masks; the rules one by one.
#[test]
fn formulas_say_what_the_scheme_is() {
    let schemes = schemes();
    // What LaTeX writes as words in italics is not read back.
    for scheme in schemes.iter().filter(|s| !AWKWARD.contains(&s.name())) {
        let text = export(scheme, &[], Language::Latex);
        let (_, body) = text.split_once("\\begin{align*}\n").expect("formulas");
        let (body, _) = body.split_once(".\n\\end{align*}").expect("formulas");
        let rows: Vec<&str> = body.split(" ={}& ").collect();
        let (list, _) = rows[1].rsplit_once(']').expect("a list");
        let (lowest, _) = scheme.mask().support();
        let mask = Mask::parse(&format!("{list}] @ {lowest}"), scheme.mask().arity());
        assert_eq!(&mask.unwrap(), &**scheme.mask(), "{text}");
        for (row, stencil) in rows[3..].iter().zip(scheme.mask().rule().stencils()) {
            let (row, _) = row.split_once(",\\\\\nf^{k+1}").unwrap_or((row, ""));
            let terms: Vec<_> = stencil.terms().filter(|(_, w)| !w.numerator().is_zero()).collect();
            let pieces: Vec<&str> = row.split("f^{k}_{i").collect();
            assert_eq!(pieces.len(), terms.len() + 1, "{row}");
            let mut before = pieces[0];
            for ((j, weight), after) in terms.into_iter().zip(&pieces[1..]) {
                let (offset, next) = after.split_once('}').expect("an index");
                let offset = if offset.is_empty() { 0 } else { offset.parse().unwrap() };
                let number = before.trim_start_matches("\\\\\n& ");
                let number = number.trim_start_matches('+').trim_end_matches("\\,");
                let number =
                    if ["", "-"].contains(&number) { &format!("{number}1") } else { number };
                let read = Expression::parse(&format!("\\,{number}")).unwrap().evaluate().unwrap();
                assert_eq!((offset, &read), (j, weight), "{row}");
                before = next;
            }
            assert_eq!(before, "", "{row}");
        }
    }
}

/// Doubles where they are exact enough, symbols where not.
#[test]
fn matlab_needs_its_toolbox_only_for_parameters_and_long_numbers() {
    for (text, symbolic) in
        [("dd4", false), ("bspline52", false), ("bspline53", true), ("a2", true)]
    {
        let code = export(&Scheme::resolve(text, 2).unwrap(), &[], Language::Matlab);
        assert_eq!(code.contains("sym("), symbolic, "{code}");
        assert_eq!(code.contains("Toolbox"), symbolic, "{code}");
        assert!(!code.contains("sym('") || text == "bspline53", "{code}");
    }
}

#[test]
fn names_that_mean_something_else_are_changed_and_told() {
    let code = |text: &str, language| export(&Scheme::resolve(text, 2).unwrap(), &[], language);
    let sympy = code(AWKWARD[0], Language::SymPy);
    assert!(sympy.contains("lambda_ = Symbol(\"lambda\")\n"), "{sympy}");
    assert!(sympy.contains("# The parameter lambda is called lambda_ here.\n"), "{sympy}");
    let wolfram = code(AWKWARD[1], Language::Mathematica);
    assert!(wolfram.contains("Clear[w1, w11];\n"), "{wolfram}");
    let both = code(AWKWARD[3], Language::SymPy);
    assert!(both.contains("lambda__ = Symbol(\"lambda_\")\n"), "{both}");
    assert!(both.contains("# The parameter gamma hides the function of that name.\n"), "{both}");
    let matlab = code(AWKWARD[4], Language::Matlab);
    assert!(matlab.contains("syms first_ for_ mask_\n"), "{matlab}");
    let maple = code(AWKWARD[4], Language::Maple);
    assert!(maple.contains("unassign('first_', 'for_', 'mask_'):\n"), "{maple}");
}

/// Whatever a scheme is called, its name stays in its comment.
#[test]
fn names_of_schemes_cannot_leave_their_comments() {
    let name = "a\\nb *) (* \\u2028 \\\\";
    let text = format!("name = \"{name}\"\nmask = \"dd4\"\nsource = \"x\\ny\"\n");
    let scheme = SchemeFile::parse(&text).unwrap().scheme;
    assert!(scheme.name().contains('\n') && scheme.source() == Some("x\ny"));
    let plain = Scheme::resolve("dd4", 2).unwrap();
    for language in PROGRAMS.into_iter().chain([Language::Latex]) {
        let [named, plain] =
            [&scheme, &plain].map(|scheme| export(scheme, &["w=1\n".into()], language));
        assert_eq!(named.lines().count(), plain.lines().count(), "{named}");
        assert_eq!(named.matches("*)").count(), named.matches("(* ").count(), "{named}");
        // A backslash at the end of a line would join the next one to a comment of Maple.
        assert!(language == Language::Latex || !named.contains("\\\n"), "{named}");
    }
}

/// SymPy runs the code, and its own arithmetic agrees; skipped where there is no SymPy.
#[test]
fn sympy_finds_the_same() {
    let known = Command::new("python3").args(["-c", "import sympy"]).output();
    if !known.is_ok_and(|output| output.status.success()) {
        eprintln!("skipped: python3 has no sympy");
        return;
    }
    let schemes = schemes();
    let mut program = String::from("import sympy\nz = sympy.Symbol('z')\n");
    for scheme in &schemes {
        let code = export(scheme, &[], Language::SymPy);
        assert!(!code.contains("'''"));
        program.push_str(&format!("space = {{}}\nexec(r'''{code}''', space)\n{CHECKS}"));
    }
    let mut python = Command::new("python3");
    let mut child = python
        .args(["-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(program.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let printed = String::from_utf8(output.stdout).unwrap();
    let mut lines = printed.lines();
    for scheme in &schemes {
        for (_, coefficient) in scheme.mask().coefficients() {
            let line = lines.next().expect("a line for each coefficient").replace("**", "^");
            let read = Expression::parse(&line).unwrap().evaluate().unwrap();
            assert_eq!(read, coefficient, "{}: {line}", scheme.name());
        }
    }
    assert_eq!(lines.next(), None);
}

/// The coefficients of the symbol, after what the code says about itself.
const CHECKS: &str = "
mask, first, m = space['mask'], space['first'], space['arity']
assert sympy.cancel(sum(mask)) == m and space['support'] == [first, first + len(mask) - 1]
assert sum(len(w) for _, w in space['stencils']) <= len(mask) and len(space['stencils']) == m
for e, (s, weights) in enumerate(space['stencils']):
    assert sympy.cancel(sum(weights)) == 1
    for k, w in enumerate(weights):
        assert w == mask[e - m*(s + k) - first]
series, denominator = sympy.fraction(sympy.cancel(space['masksymbol'](z) * z**(-first)))
series = sympy.Poly(series, z)
for k in range(len(mask)):
    print(sympy.cancel(series.coeff_monomial(z**k) / denominator))
";
