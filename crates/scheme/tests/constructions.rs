//! Constructions against each other and against masks as their papers print them.

use refinable_scheme::{Normalised, Scheme, Substitution, constructions};

fn mask(text: &str) -> Normalised {
    Scheme::resolve(text, 2).unwrap_or_else(|e| panic!("{text}: {e}")).mask().clone()
}

fn at(text: &str, sets: &[&str]) -> Normalised {
    let sets: Vec<_> = sets.iter().map(|s| Substitution::parse(s).unwrap()).collect();
    Scheme::resolve(text, 2).unwrap().with(&sets).unwrap().mask().clone()
}

#[test]
fn pseudo_splines_run_from_splines_to_interpolation() {
    for m in 1..=6 {
        assert_eq!(mask(&format!("pseudo({m}, 0)")), mask(&format!("bspline{}", 2 * m - 1)));
        assert_eq!(mask(&format!("pseudo({m}, {})", m - 1)), mask(&format!("dd{}", 2 * m)));
        assert_eq!(mask(&format!("dualpseudo({m}, 0)")), mask(&format!("bspline{}", 2 * m)));
    }
    // The dual four-point scheme, as Dyn, Floater and Hormann print it.
    assert_eq!(mask("dualpseudo(2, 1)"), mask("1/128*[-5, -7, 35, 105, 105, 35, -7, -5]"));
    // At α = 3/128, where the degree rises to five, S_{a4} is one of them.
    assert_eq!(mask("pseudo(3, 1)"), at("a4", &["alpha=3/128"]));
}

#[test]
fn families_meet() {
    assert_eq!(mask("jspline(0)"), mask("dd4"));
    assert_eq!(mask("jspline(1)"), mask("bspline3"));
    assert_eq!(mask("jspline(3/2)"), mask("bspline5"));
    assert_eq!(mask("jspline(8*alpha, 16*beta*(1-alpha)+1)"), mask("a3"));
    assert_eq!(mask("fourpoint(-beta)"), mask("i4"));
    assert_eq!(mask("fourpoint(1/16)"), mask("dd4"));
    assert_eq!(mask("sixpoint(beta)"), mask("i6"));
    assert_eq!(mask("sixpoint(3/256)"), mask("dd6"));
    assert_eq!(mask("dualfourpoint(0)"), mask("bspline2"));
    assert_eq!(mask("dualfourpoint(1/128)"), mask("dualpseudo(2, 1)"));
    for k in 4..9 {
        let (m, kind) = (k / 2, if k % 2 == 0 { "pseudo" } else { "dualpseudo" });
        assert_eq!(mask(&format!("hormannsabin({k})")), mask(&format!("{kind}({m}, 1)")));
    }
    // Li and Zheng: the cubic spline and the four-point scheme are ends of the line of J-splines.
    assert_eq!(mask("combine(dd4, bspline3, s)"), mask("jspline(s)"));
    assert_eq!(mask("combine(bspline1, bspline3, 1)"), mask("bspline3"));
}

#[test]
fn products_of_symbols() {
    for k in 1..8 {
        assert_eq!(mask(&format!("smooth(bspline1, {k})")), mask(&format!("bspline{}", k + 1)));
    }
    // Each half step is rounded to the left.
    assert_eq!(mask("shift(smooth(smooth(dd4, 1), 1), 1)"), mask("smooth(dd4, 2)"));
    assert_eq!(mask("convolve(bspline1, bspline1)"), mask("bspline3"));
    assert_eq!(mask("shift(convolve(bspline2, bspline2), 1)"), mask("bspline5"));
    assert_eq!(mask("convolve(a2, dd4)"), mask("convolve(dd4, a2)"));
    let ternary = Scheme::resolve("ternaryfourpoint(1/11)", 2).unwrap();
    let printed = "1/99*[-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4] @ -5";
    assert_eq!(ternary.mask(), Scheme::resolve(printed, 3).unwrap().mask());
}

#[test]
fn what_is_no_construction() {
    for (text, code) in [
        ("pseudo(2, 2)", "construction"),
        ("pseudo(0, 0)", "construction"),
        ("pseudo(2)", "construction"),
        ("pseudo(2, x)", "construction"),
        ("pseudo(99999999999, 1)", "construction"),
        ("hormannsabin(3)", "construction"),
        ("fourpoint(1/0)", "pole"),
        ("fourpoint(w, 1)", "construction"),
        ("fourpoint()", "syntax"),
        ("fourpoint(w]", "syntax"),
        ("jspline(1, 2, 3)", "construction"),
        ("smooth(dd4)", "construction"),
        ("smooth(nosuch, 1)", "unknown-scheme"),
        ("combine(dd4, ternaryfourpoint(1/11), w)", "arity"),
        ("combine(dd4, dd6, z)", "symbol"),
        ("shift(dd4, 1.5)", "construction"),
    ] {
        assert_eq!(Scheme::resolve(text, 2).unwrap_err().code(), code, "{text}");
    }
    let nested = format!("{}dd4{}", "smooth(".repeat(20), ", 1)".repeat(20));
    assert_eq!(Scheme::resolve(&nested, 2).unwrap_err().code(), "budget");
}

/// What a hint says is true: the ends that it names are admitted, and the numbers beyond them are not.
#[test]
fn hints_name_the_numbers_that_do() {
    for (start, typed, low, high) in
        [("shift([1, 1] @ 0,", "x", -1_000_000, 1_000_000), ("smooth(dd4,", "-1", 0, 60)]
    {
        let resolve = |k: String| Scheme::resolve(&format!("{start} {k})"), 2);
        let error = resolve(typed.into()).unwrap_err();
        assert_eq!(error.hint(), Some(format!("{low} to {high} do").as_str()));
        for k in [low, high] {
            assert!(resolve(k.to_string()).is_ok(), "{start} {k})");
        }
        for k in [low - 1, high + 1] {
            assert_eq!(resolve(k.to_string()).unwrap_err().code(), "construction", "{start} {k})");
        }
    }
}

/// Each signature is that of a call, by as many arguments as it names.
#[test]
fn signatures_are_what_is_written() {
    for signature in constructions().iter().flat_map(|c| c.signature().split("), ")) {
        let call = signature.trim_end_matches(')');
        let (name, names) = call.split_once('(').unwrap();
        let arguments = names.split(", ").map(|n| match n {
            "SCHEME" => "dd4",
            "m" | "k" => "4",
            _ => "1",
        });
        let text = format!("{name}({})", arguments.collect::<Vec<_>>().join(", "));
        match Scheme::resolve(&text, 2) {
            Ok(_) => {}
            // Nothing but `surface` takes tensor products.
            Err(error) => assert!(error.message().contains("two variables"), "{text}: {error}"),
        }
    }
}

#[test]
fn masks_are_recognised() {
    let names = |text: &str| -> Vec<String> {
        let scheme = Scheme::resolve(text, 2).unwrap();
        refinable_scheme::identities(scheme.mask()).iter().map(ToString::to_string).collect()
    };
    let has = |text: &str, known: &str| {
        let found = names(text);
        assert!(found.iter().any(|name| name == known), "{text}: {found:?}");
    };
    has("1/8*[1, 4, 6, 4, 1]", "bspline3");
    has("1/8*[1, 4, 6, 4, 1]", "jspline(s) with s = 1");
    has("1/8*[1, 4, 6, 4, 1] @ 3", "bspline3, indices moved by 5");
    has("1/16*[-1, 0, 9, 16, 9, 0, -1]", "dd4");
    has("1/16*[-1, 0, 9, 16, 9, 0, -1]", "fourpoint(w) with w = 1/16");
    has("1/16*[-1, 0, 9, 16, 9, 0, -1]", "a4 with alpha = 0");
    has("[-u/2, 0, (1+u)/2, 1, (1+u)/2, 0, -u/2]", "fourpoint(w) with w = 1/2*u");
    has("1/128*[-5, -7, 35, 105, 105, 35, -7, -5]", "dualpseudo(2, 1)");
    has("ternaryfourpoint(t/2)", "ternaryfourpoint(mu) with mu = 1/2*t");
    // A name that looks like that of an unknown is a name like any other.
    has("fourpoint(2*unknown_0)", "fourpoint(w) with w = 2*unknown_0");
    let special = "1/128*[-3, -8, 12, 72, 110, 72, 12, -8, -3]";
    has(special, "pseudo(3, 1)");
    has(special, "a4 with alpha = 3/128");
    has("jspline(8*t, 16*u+1)", "a3 with alpha = t, beta = -u/(t - 1)");
    has("1/8*(1+z+z^2+z^3)^2", "jspline(a, b) with a = 2, b = 3, indices moved by 3");
    for stranger in ["[1/3, 1/4, 2/3, 3/4]", "[1, 1] @ 5", "[1/2, 1/2, 1/2, 1/2]"] {
        assert_eq!(names(stranger), Vec::<String>::new(), "{stranger}");
    }
}
