//! What the notation accepts, what it refuses, and what it says then.

use refinable_algebra::{Parameter, ParameterPolynomial, rational};
use refinable_scheme::{Diagnostic, Expression, Mask, Normalised, Scheme, Substitution, catalogue};

fn set(texts: &[&str]) -> Vec<Substitution> {
    let parse = |t: &&str| Substitution::parse(t).unwrap();
    texts.iter().map(parse).collect()
}

fn resolve(text: &str) -> Scheme {
    Scheme::resolve(text, 2).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn refused(text: &str) -> Diagnostic {
    match Scheme::resolve(text, 2) {
        Ok(scheme) => panic!("{text} was taken for {}", scheme.mask()),
        Err(error) => error,
    }
}

/// The value of an expression without parameters.
fn value(text: &str) -> Option<refinable_algebra::Rational> {
    Expression::parse(text).unwrap().evaluate().unwrap().as_constant()
}

#[test]
fn operators_bind_as_on_paper() {
    assert_eq!(value("1 - 2 - 3"), Some(rational(-4, 1)));
    assert_eq!(value("12/2/3*5"), Some(rational(10, 1)));
    assert_eq!(value("-2^2"), Some(rational(-4, 1)));
    assert_eq!(value("2^-2*3^(−1)"), Some(rational(1, 12)));
    assert_eq!(value("2*-3 + +1"), Some(rational(-5, 1)));
    assert_eq!(value("0.05 - 1/20"), Some(rational(0, 1)));
    assert_eq!(value("(2/3)^-2"), Some(rational(9, 4)));
    assert_eq!(value("0^0"), Some(rational(1, 1)));
}

#[test]
fn greek_letters_are_their_english_names() {
    let names = Expression::parse("α*β + ω_1 − γ").unwrap().names();
    let expected = ["alpha", "beta", "gamma", "omega_1"];
    assert!(names.iter().eq(expected.iter()));
    assert_eq!(resolve("[α, 1/2, 1 - 2*α, 1/2, α]").mask(), resolve("a2").mask());
}

#[test]
fn one_mask_in_four_notations() {
    let spline = resolve("bspline3");
    for text in [
        "[1/8, 1/2, 3/4, 1/2, 1/8]",
        "1/8*[1, 4, 6, 4, 1] @ -2",
        "1/8*z^-2*(1+z)^4",
        "((1 - z^2)/(1 - z))^4/(8*z^2)",
    ] {
        assert_eq!(resolve(text).mask(), spline.mask(), "{text}");
        assert_eq!(resolve(text).name(), text);
    }
    let shifted = Mask::parse("1/8*[1, 4, 6, 4, 1] @ 0", 2).unwrap();
    assert_eq!(shifted.support(), (0, 4));
    assert!(!shifted.is_primal() && !shifted.is_dual());
}

/// Rows as they stand in the sources of papers, rules, and products as they are written by hand.
#[test]
fn masks_as_papers_write_them() {
    for (text, name) in [
        ("\\frac{1}{2}[2\\alpha, 1, 2-4\\alpha, 1, 2\\alpha]", "a2"),
        (
            "$\\frac{1}{16}[-16 \\alpha, -1, 64 \\alpha, 9, 16-96 \\alpha,$\\\\ & $9, 64 \\alpha, -1, -16 \\alpha]$",
            "a4",
        ),
        ("1/16*[-16α, -1, 64α, 9, 16-96α, 9, 64α, -1, -16α] @ -4", "a4"),
        (
            "\\left[\\beta (1-\\alpha),\\alpha,\\frac{1}{2}-\\beta (1-\\alpha),1-2\\alpha,\\frac{1}{2}-\\beta (1-\\alpha),\\alpha,\\beta (1-\\alpha)\\right]",
            "a3",
        ),
        (
            "\\left[\\beta (1-\\alpha),-\\alpha,-\\frac{1}{16}-3 \\beta (1-\\alpha),4 \\alpha,\\frac{9}{16}+2 \\beta (1-\\alpha),1-6 \\alpha,\\frac{9}{16}+2 \\beta (1-\\alpha),4 \\alpha,-\\frac{1}{16}-3 \\beta (1-\\alpha),-\\alpha,\\beta (1-\\alpha)\\right]",
            "a5",
        ),
        ("\\frac{1}{8} z^{-2} \\cdot (1+z)^{4}", "bspline3"),
        ("even: [alpha, 1-2alpha, alpha]; odd: [1/2, 1/2]", "a2"),
        ("1: 1/2*[1, 1]; 0: [1/8, 3/4, 1/8];", "bspline3"),
        ("even: [3/4, 1/4]; odd: [1/4, 3/4]", "bspline2"),
        ("even: [1] @ 0; odd: 1/16*[-1, 9, 9, -1] @ -1", "dd4"),
    ] {
        assert_eq!(resolve(text).mask(), resolve(name).mask(), "{text}");
    }
    let ternary = Scheme::resolve("0: [1/3, 2/3] @ -1; 1: [1] @ 0; 2: [2/3, 1/3] @ 0", 3).unwrap();
    assert_eq!(ternary.mask(), Scheme::resolve("1/3*[1, 2, 3, 2, 1] @ -1", 3).unwrap().mask());
    // A rule says of its mask what the mask says of its rule.
    for name in ["a5", "bspline4", "dd6"] {
        let rule = resolve(name).mask().rule();
        let spelled = rule.stencils().iter().enumerate().map(|(class, stencil)| {
            let weights: Vec<String> = stencil.weights().iter().map(ToString::to_string).collect();
            format!("{class}: [{}] @ {}", weights.join(", "), stencil.first())
        });
        let spelled: Vec<String> = spelled.collect();
        assert_eq!(resolve(&spelled.join("; ")).mask(), resolve(name).mask());
    }
}

#[test]
fn even_lists_are_centred_to_be_dual() {
    let chaikin = resolve("1/4*[1, 3, 3, 1]");
    assert_eq!(chaikin.mask(), resolve("bspline2").mask());
    assert!(chaikin.mask().is_dual() && !chaikin.mask().is_primal());
    assert_eq!(chaikin.mask().support(), (-2, 1));
}

#[test]
fn a_ternary_mask_has_three_stencils() {
    let mask = Mask::parse("1/81*[-4, -5, 0, 30, 60, 81, 60, 30, 0, -5, -4]", 3).unwrap();
    let scheme = Normalised::new(mask).unwrap();
    assert_eq!(scheme.rule().stencils().len(), 3);
    assert_eq!(scheme.support_width(), rational(5, 1));
    assert!(scheme.is_primal());
    assert!(scheme.is_interpolatory());
    let two = Scheme::resolve("bspline1", 3).unwrap_err();
    assert_eq!((two.code(), two.message()), ("arity", "`bspline1` has arity 2, not 3"));
    let two = Scheme::resolve("fourpoint(w)", 3).unwrap_err();
    assert_eq!((two.code(), two.message()), ("arity", "`fourpoint(w)` has arity 2, not 3"));
    for arity in [2, 3] {
        let three = Scheme::resolve("ternaryfourpoint(w)", arity).unwrap();
        assert_eq!(three.mask().arity(), 3);
    }
}

#[test]
fn interpolation_is_a_condition_on_the_parameters() {
    let conditions = |text: &str| resolve(text).mask().interpolation_conditions();
    let alpha = ParameterPolynomial::parameter(&Parameter::new("alpha"));
    assert_eq!(conditions("a6"), [alpha]);
    assert_eq!(conditions("dd6"), []);
    // a_0 = 0: no value of any parameter helps.
    assert_eq!(conditions("[1, 1] @ 1"), [ParameterPolynomial::constant(rational(1, 1))]);
}

/// In parentheses there are no entries to be told apart.
#[test]
fn a_sign_in_parentheses_is_an_operator() {
    let mask = Mask::parse("[(1 -3), 1, -(2 -5)]", 2).unwrap();
    assert_eq!(mask, Mask::parse("[-2, 1, 3]", 2).unwrap());
}

/// A text, the code, what the caret is under, and a part of the hint if there is one.
const REFUSED: [(&str, &str, &str, Option<&str>); 49] = [
    ("[1/16a, 2]", "syntax", "a", Some("write `1/16*a` or `1/(16*a)`")),
    ("[64 a]", "syntax", "a", Some("write `64, a` or `64*a`")),
    ("[1/(a)b]", "syntax", "b", Some("write")),
    ("[2(a+1)]", "syntax", "(", Some("write `2*(a+1)`")),
    ("[(a+1)(b-1)]", "syntax", "(", Some("write `(a+1)*(b-1)`")),
    ("z(a+1)²", "syntax", "(", Some("write `z*(a+1)`")),
    ("[a b]", "syntax", "b", Some("write `a, b` or `a*b`")),
    ("[1 4 6 4 1]", "syntax", "4", Some("write `1, 4` or `1*4`")),
    ("[1 -2 1]", "syntax", "-", Some("commas")),
    ("[-1 -1]", "syntax", "-", Some("commas")),
    ("[(1) -1]", "syntax", "-", Some("commas")),
    ("[]", "syntax", "]", None),
    ("[1,,1]", "syntax", ",", None),
    ("0,5*(1+z)", "syntax", ",", Some("with a point: 0.5")),
    ("[1, 1,]", "syntax", "]", None),
    ("[1, 1", "syntax", "", None),
    ("1/2[1, 1]", "syntax", "[", Some("`1/16*[...]`")),
    ("1 + 1/2*[1, 1]", "syntax", "[", Some("single factor")),
    ("[1, 1]/2", "syntax", "/", Some("in front")),
    ("[1, 1] @ w", "syntax", "w", None),
    ("[1; 1]", "syntax", ";", Some("commas")),
    ("[1, 1] 1", "syntax", "1", None),
    ("[1e3, 1]", "syntax", "e3", Some("`1*e3`")),
    ("[1., 1]", "syntax", "1.", Some("write `1.0`")),
    ("[.5, 1]", "syntax", ".", Some("0.5")),
    ("z**2", "syntax", "*", Some("`^`")),
    ("z^a", "syntax", "a", Some("sqrt")),
    ("z^2^3", "syntax", "^", Some("`(a^b)^c`")),
    ("z^1.5", "syntax", "1.5", None),
    ("(1+z", "syntax", "", None),
    ("\\half*z", "syntax", "\\half", Some("Greek")),
    ("\\frac12*z", "syntax", "12", Some("\\frac{1}{2}")),
    ("\\frac{1}{2*z", "syntax", "", None),
    ("[1/2\\alpha, 1]", "syntax", "\\alpha", Some("`1/2*\\alpha`")),
    ("[\\alpha 2, 1]", "syntax", "2", Some("`\\alpha, 2` or `\\alpha*2`")),
    ("{1}*z", "syntax", "{", Some("group with")),
    ("even: [1]; odd: [1/2, 1/2", "syntax", "", None),
    ("even: [1], odd: [1/2, 1/2]", "syntax", ",", None),
    ("even [1]: odd", "syntax", "[", None),
    ("other: [1]", "syntax", "other", None),
    ("even: [1]; even: [1]", "arity", "even: [1]; even: [1]", Some("`even: [...]; odd: [...]`")),
    (
        "even: [1]; odd: [1/2, 1/2]; 2: [1]",
        "arity",
        "even: [1]; odd: [1/2, 1/2]; 2: [1]",
        Some("name the arity"),
    ),
    ("[sqrt(2), 1]", "irrational", "sqrt(2)", Some("exact and rational")),
    ("[1/(a - a), 1]", "pole", "(a - a)", None),
    ("[z, 1]", "symbol", "z", None),
    ("1/(1+z)", "symbol", "(1+z)", Some("powers of `z`")),
    ("1/2 + w", "symbol", "1/2 + w", Some("in brackets")),
    ("0*z", "zero-mask", "0*z", None),
    ("z^10001", "budget", "10001", None),
];

#[test]
fn a_refusal_shows_the_place_and_what_to_write() {
    for (text, code, marked, hint) in REFUSED {
        let error = refused(text);
        assert_eq!(error.code(), code, "{text}: {error}");
        let (shown, span) = error.excerpt().expect(text);
        assert_eq!(&shown[span], marked, "{text}: {error}");
        match (error.hint(), hint) {
            (Some(whole), Some(part)) => assert!(whole.contains(part), "{text}: {whole}"),
            (whole, part) => assert_eq!(whole, part, "{text}"),
        }
    }
}

#[test]
fn unknown_names_get_the_nearest_one() {
    for (typed, meant) in [
        ("bspine3", "bspline3"),
        ("BSpline3", "bspline3"),
        ("bspline0", "bspline1"),
        ("dd5", "dd4"),
        ("a1", "a2"),
        ("i5", "i4"),
        ("d4", "dd4"),
        ("a04", "a4"),
    ] {
        let error = refused(typed);
        assert_eq!(error.code(), "unknown-scheme");
        let hint = error.hint().unwrap();
        assert!(hint.starts_with(&format!("did you mean `{meant}`?")), "{typed}: {hint}");
    }
    let stranger = refused("butterfly");
    assert!(stranger.hint().unwrap().starts_with("the catalogue has a2 a4 a6 … a202"));
    assert_eq!(catalogue().len(), 5);
    for beyond in ["a204", "a205", "i206", "dd204", "bspline401", "a99999999999999999999"] {
        let error = refused(beyond);
        assert_eq!(error.code(), "budget", "{beyond}");
        assert!(error.message().starts_with("the catalogue ends at "));
    }
}

#[test]
fn a_mask_that_is_not_normalised_is_told_why() {
    let hint = |text: &str| refused(text).hint().unwrap().to_string();
    assert_eq!(
        refused("[1, 4, 6, 4, 1]").message(),
        "every stencil of a scheme sums to 1, but stencil 0 sums to 8, stencil 1 sums to 8"
    );
    assert_eq!(hint("[1, 4, 6, 4, 1]"), "multiply the mask by 1/8");
    assert_eq!(hint("1/4*[1, 2, 1]"), "multiply the mask by 2");
    assert_eq!(hint("[1, 2, 3]"), "check the entries, their number and the arity");
    assert_eq!(hint("[w, 1, 0, 1]"), "check the entries, their number and the arity");
    assert_eq!(
        hint("[w, 1, u*w]"),
        "the sums are 1 where u*w + w - 1 = 0, to be arranged with `--set`"
    );
    assert_eq!(hint("[v, 1, w]"), "the sums are 1 where v + w - 1 = 0, say with `--set 'v=1 - w'`");
    let arranged = Scheme::resolve_with("[v, 1, w]", 2, &set(&["v=1-w"])).unwrap();
    assert_eq!(arranged.mask().coefficient(-1).to_string(), "1 - w");
}

#[test]
fn substitutions_apply_in_order_and_may_bring_in_parameters() {
    let a5 = resolve("a5");
    let curve = a5.with(&set(&["beta=(8*alpha-1)/(16*(1-alpha))"])).unwrap();
    assert_eq!(curve.mask().coefficient(5).to_string(), "-1/16 + 1/2*alpha");
    assert!(curve.derivation().is_none() && a5.with(&[]).unwrap().derivation().is_some());
    let chained = a5.with(&set(&["alpha = 2*w", "w = 1/4", "beta = 1/2"])).unwrap();
    let direct = a5.with(&set(&["beta = 1/2", "alpha = 1/2"])).unwrap();
    assert_eq!(chained.mask(), direct.mask());
    // beta drops out at alpha = 1, and setting it then is still no mistake.
    assert!(a5.with(&set(&["alpha=1", "beta=3"])).is_ok());
}

#[test]
fn substitutions_that_make_no_sense_are_refused() {
    let a4 = resolve("a4");
    let refused = |texts: &[&str]| a4.with(&set(texts)).unwrap_err();
    let unknown = refused(&["beta=1"]);
    assert_eq!(unknown.message(), "the scheme has no parameter `beta`");
    assert_eq!(unknown.hint(), Some("it has `alpha`"));
    assert_eq!(refused(&["alpha=1", "w=2"]).hint(), Some("it has no free parameter"));
    assert_eq!(refused(&["alpha=1", "alpha=1"]).message(), "`alpha` is set twice");
    let pole = resolve("[1/(1-t), 1, t/(t-1)]").with(&set(&["t=1"])).unwrap_err();
    assert_eq!((pole.code(), pole.message()), ("pole", "the mask has a pole at t = 1"));
    // All at once there is no order in which 0/b is 0 first.
    let hidden = resolve("[a/b, 1/2, 1-2*a/b, 1/2, a/b]");
    let hidden = hidden.mask().at(&[0, 0].map(|x| rational(x, 1))).unwrap_err();
    assert_eq!((hidden.code(), hidden.message()), ("pole", "the mask has a pole at a = 0, b = 0"));
    assert_eq!(pole.hint(), Some("its denominator t - 1 vanishes there"));
    for (text, code) in [
        ("z=1", "substitution"),
        ("sqrt=1", "substitution"),
        ("alpha=z", "symbol"),
        ("alpha", "syntax"),
        ("=1", "syntax"),
        ("alpha==1", "syntax"),
        ("alpha=", "syntax"),
        ("2*alpha=1", "syntax"),
        ("alpha=1/0", "pole"),
        ("alpha=sqrt(3)/64", "irrational"),
    ] {
        assert_eq!(Substitution::parse(text).unwrap_err().code(), code, "{text}");
    }
}
