//! Texts that mean harm end in a result or an error, soon.

use std::time::{Duration, Instant};

use proptest::prelude::*;
use refinable_scheme::{Expression, Mask, Scheme, Substitution};

fn nested(times: usize, start: &str, around: impl Fn(&str) -> String) -> String {
    (0..times).fold(start.to_string(), |inner, _| around(&inner))
}

fn repeated(times: usize, separator: &str, part: impl Fn(usize) -> String) -> String {
    let parts: Vec<_> = (0..times).map(part).collect();
    parts.join(separator)
}

#[test]
fn expressions_that_explode_are_refused() {
    for text in [
        "((1+a)^999)^999".to_string(),
        "9^9999^9999".to_string(),
        "(9^9999)^9999".to_string(),
        "((9^9999)^-9999)^9999".to_string(),
        "(a+b+c+d)^500".to_string(),
        "(1/(1+a))^9000".to_string(),
        "(a^10000)^10000".to_string(),
        "9^99999999999999999999".to_string(),
        nested(60, "a+b+c", |inner| format!("({inner})^2")),
        nested(60, "a+b", |inner| format!("(c+1/({inner}))")),
        nested(30, "9", |inner| format!("({inner})^9999")),
        repeated(2_000, "+", |k| format!("1/(a+{k})")),
        repeated(50_000, "+", |k| format!("a{k}")),
        repeated(100, "*", |_| "7".repeat(9_990)),
        "7".repeat(10_001),
        "(".repeat(300_000),
        "-".repeat(500_000) + "1",
        "1+".repeat(600_000) + "1",
        "(a^9+b^9+c^9+1)/(a^9-b^8*c+3)+(a+b)/(a^7-b*c+7)".to_string(),
    ] {
        let result = Expression::parse(&text).and_then(|e| e.evaluate());
        let error = result.expect_err(&text[..text.len().min(60)]);
        let two_readings = error.message().contains("two readings");
        assert!(error.code() == "budget" || two_readings, "{text:.60}: {error}");
    }
}

#[test]
fn masks_that_explode_are_refused() {
    for text in [
        "((1+z)^999)^999".to_string(),
        "((z^10000)^10000)^10000".to_string(),
        "z^10000 + z^-10000".to_string(),
        "(z^9000-1)/(z-1)".to_string(),
        "(z^300-1)/(z-(a+b+c))".to_string(),
        "1/(1+a+b+c)^3*(1+z*a)^30".to_string(),
        "[1, 1] @ 99999999999999999999".to_string(),
        format!("[{}]", repeated(2_000, ",", |k| format!("1/(a+{k})"))),
        format!("[{}]", repeated(30_000, ",", |_| "1".to_string())),
    ] {
        let error = Mask::parse(&text, 2).expect_err(&text[..text.len().min(60)]);
        assert_eq!(error.code(), "budget", "{text:.60}: {error}");
    }
}

/// A weight is followed by as many gaps as the arity says: they are counted before they are laid out.
#[test]
fn rules_that_explode_are_refused() {
    let rules = |arity: usize, weights: usize| {
        let long = format!("0: [{}]", repeated(weights, ",", |_| "1".into()));
        let others = repeated(arity - 1, "; ", |k| format!("{}: [1]", k + 1));
        Mask::parse(&format!("{long}; {others}"), arity)
    };
    // The last weight of (n - 1) m + 1 terms is one more than 20 000.
    assert!(rules(10, 2_000).is_ok());
    assert_eq!(rules(10, 2_001).unwrap_err().code(), "budget");
    let error = rules(1_000, 20_000).unwrap_err();
    assert_eq!(error.code(), "budget");
    assert!(error.message().contains("up to 19999001 terms"), "{error}");
    assert_eq!(rules(1_001, 20_000).unwrap_err().code(), "arity");
}

#[test]
fn long_but_harmless_texts_are_read() {
    let chain = repeated(3_000, "-", |_| "1/3*a".to_string());
    let value = Expression::parse(&chain).unwrap().evaluate().unwrap();
    assert_eq!(value.to_string(), format!("-{}/3*a", 2_998));
    let deep = "(".repeat(199) + "1" + &")".repeat(199);
    assert!(Expression::parse(&deep).unwrap().evaluate().is_ok());
    let wide = repeated(1_000, "+", |_| "-(1)".to_string());
    assert_eq!(Expression::parse(&wide).unwrap().evaluate().unwrap().to_string(), "-1000");
    let list = format!("[{}]", repeated(5_000, ", ", |k| k.to_string()));
    assert_eq!(Mask::parse(&list, 2).unwrap().support(), (-2_499, 2_499));
}

/// Each limit from both sides: what is just admitted, and what is just refused.
#[test]
fn at_the_limits_of_expressions() {
    let number = |digits: usize| "7".repeat(digits);
    let padded = |bytes: usize| " ".repeat(bytes - 1) + "1";
    let deep = |levels: usize| "(".repeat(levels) + "1" + &")".repeat(levels);
    let long = vec![number(10_000); 4].join("+");
    for (admitted, refused) in [
        (padded(1 << 20), padded((1 << 20) + 1)),
        (number(10_000), number(10_001)),
        // The squares of the lengths sum to 400 million.
        (long.clone(), long + "+1"),
        (deep(200), deep(201)),
        ("a^10000".into(), "a^10001".into()),
        ("a^10000".into(), "a^10000*a".into()),
    ] {
        let result = Expression::parse(&admitted).and_then(|e| e.evaluate());
        assert!(result.is_ok(), "{admitted:.60}: {}", result.unwrap_err());
        let error = Expression::parse(&refused).and_then(|e| e.evaluate()).unwrap_err();
        assert_eq!(error.code(), "budget", "{refused:.60}: {error}");
    }
}

#[test]
fn at_the_limits_of_masks() {
    let list = |count: usize| format!("[{}]", repeated(count, ",", |_| "1".into()));
    for (admitted, refused) in [
        (list(20_000), list(20_001)),
        ("[1, 1] @ 1000000".into(), "[1, 1] @ 1000001".into()),
        ("1+z^10000*z^9999".into(), "1+z^10000*z^10000".into()),
    ] {
        let result = Mask::parse(&admitted, 2);
        assert!(result.is_ok(), "{admitted:.60}: {}", result.unwrap_err());
        assert_eq!(Mask::parse(&refused, 2).unwrap_err().code(), "budget", "{refused:.60}");
    }
    assert!(Mask::parse("1+z", 1000).is_ok());
    assert_eq!(Mask::parse("1+z", 1001).unwrap_err().code(), "arity");
    let smooth = |times: usize| "smooth(".repeat(times) + "dd4" + &", 1)".repeat(times);
    for (admitted, refused, code) in [
        ("bspline400".into(), "bspline401".into(), "budget"),
        (smooth(16), smooth(17), "budget"),
        ("smooth(dd4, 60)".into(), "smooth(dd4, 61)".into(), "construction"),
    ] {
        let result = Scheme::resolve(&admitted, 2);
        assert!(result.is_ok(), "{admitted}: {}", result.unwrap_err());
        assert_eq!(Scheme::resolve(&refused, 2).unwrap_err().code(), code, "{refused}");
    }
}

#[test]
fn substitutions_that_explode_are_refused() {
    let family = Scheme::resolve("a83", 2).unwrap();
    let set = |text: &str| Substitution::parse(text).unwrap();
    let steps: Vec<_> =
        (0..12).map(|k| set(&format!("{}=(x{k}+y{k})^6/(x{k}-2*y{k})^5", name(k)))).collect();
    let error = family.with(&steps).unwrap_err();
    assert_eq!(error.code(), "budget");
}

/// The parameter that the `k`-th substitution of a chain replaces.
fn name(k: usize) -> String {
    match k {
        0 => "alpha".to_string(),
        _ => format!("x{}", k - 1),
    }
}

/// Found by fuzzing: every coefficient brings the common denominator, so that what is printed may be more than
/// what can be read; it is refused then, not read as something else.
#[test]
fn what_is_printed_is_read_again_or_refused() {
    for (text, is_read) in
        [("j1/Σq^63*(1+j+z^2)^2/(1+a)", false), ("(1+j+z^2)^2/(1+a)", true), ("z/(1+a)^2", true)]
    {
        let mask = Mask::parse(text, 2).unwrap();
        match Mask::parse(&mask.to_string(), 2) {
            Ok(again) => assert!(is_read && again == mask, "{text}"),
            Err(error) => assert!(!is_read && error.code() == "budget", "{text}: {error}"),
        }
    }
}

/// Found by fuzzing: the sums of the stencils were reduced against a constant denominator, for which the contents of
/// polynomials in many parameters were taken. It took minutes.
#[test]
fn many_parameters_over_a_constant() {
    let start = Instant::now();
    let error = Scheme::resolve("((a+b+c+d+e+f+g+h+i+j+k+l)^2*z+m)^2", 2).unwrap_err();
    assert_eq!(error.code(), "not-normalised");
    assert!(start.elapsed() < Duration::from_secs(30), "{:?}", start.elapsed());
}

fn tokens() -> impl Strategy<Value = String> {
    let token = prop_oneof![
        Just("1"),
        Just("0"),
        Just("0.5"),
        Just("16"),
        Just("a"),
        Just("b"),
        Just("z"),
        Just("α"),
        Just("sqrt"),
        Just("+"),
        Just("-"),
        Just("−"),
        Just("*"),
        Just("/"),
        Just("^"),
        Just("^2"),
        Just("^-3"),
        Just("("),
        Just(")"),
        Just("["),
        Just("]"),
        Just(","),
        Just("@"),
        Just("="),
        Just(" "),
        Just("."),
        Just("(1+z)"),
        Just("(a-b)"),
        Just("^999"),
    ];
    proptest::collection::vec(token, 0..14).prop_map(|tokens| tokens.concat())
}

/// Whatever the text, its errors can be printed and point into it.
fn exercise(text: &str) -> Result<(), TestCaseError> {
    let errors = [
        Expression::parse(text).and_then(|e| e.evaluate().map(|_| ())).err(),
        Mask::parse(text, 2).map(|_| ()).err(),
        Scheme::resolve(text, 3).map(|_| ()).err(),
        Substitution::parse(text).map(|_| ()).err(),
    ];
    for error in errors.into_iter().flatten() {
        let title = format!("error[{}]: ", error.code());
        prop_assert!(error.to_string().starts_with(&title), "{}", error);
        if let Some((shown, span)) = error.excerpt() {
            prop_assert!(shown.get(span).is_some());
        }
    }
    Ok(())
}

/// Nothing is written beside the sources when a test fails; the failing case is printed.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn any_string_is_a_result_or_an_error(text in any::<String>()) {
        exercise(&text)?;
    }

    #[test]
    fn any_bytes_are_a_result_or_an_error(bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
        exercise(&String::from_utf8_lossy(&bytes))?;
    }

    #[test]
    fn any_row_of_tokens_is_a_result_or_an_error(text in tokens()) {
        exercise(&text)?;
        exercise(&format!("[{text}]"))?;
    }
}
