//! Masks that nobody would publish, with what is known of them by hand.

use refinable_algebra::{parse_rational, rational};
use refinable_analysis::{Options, Regularity, degrees, regularity};
use refinable_scheme::Scheme;

fn resolve(text: &str) -> Scheme {
    Scheme::resolve(text, 2).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn regularity_of(text: &str) -> Regularity {
    let scheme = resolve(text);
    regularity(scheme.name(), scheme.mask(), &Options::default())
        .unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn holder(text: &str, lower: &str, upper: &str) -> Regularity {
    let found = regularity_of(text);
    let [lower, upper] = [lower, upper].map(|x| parse_rational(x).expect("a decimal"));
    let between = lower <= found.lower && found.upper.as_ref().is_some_and(|found| *found <= upper);
    assert!(between, "{text}: {} {:?}", found.lower, found.upper);
    found
}

/// `(1+z)(1+z²)/2`: the limit function is `χ[0,1] * χ[0,2] / 2`, a trapezoid of slope 1/2. Its shifts are not
/// stable, `Σ (-1)^j φ(x-j) = 0`, and yet the scheme converges: the differences are refined by `(1+z²)/2`, and
/// `∏ (1+z^(2^k))/2` over `L` levels has `2^L` coefficients `2^-L`, each class modulo `2^L` two of them at most.
#[test]
fn four_equal_coefficients_converge_to_a_trapezoid() {
    let found = holder("[1/2, 1/2, 1/2, 1/2]", "1", "1");
    assert_eq!((found.continuity, found.stable), (Some(0), Some(false)));
}

/// `(1+z)(1+3z²)/4`: over `L` levels the differences are refined by `∏ (1+3z^(2·2^k))/4`, with coefficients
/// `3^i/4^L`. The first level does not contract, `1/4 + 3/4 = 1`; the leading matrix has the eigenvalue 3/4, and the
/// exponent is `-log2(3/4)`.
#[test]
fn a_mask_without_symmetry() {
    let found = holder("1/4*[1, 1, 3, 3]", "0.415037499", "0.415037500");
    assert_eq!(found.continuity, Some(0));
    let generic = degrees(resolve("1/4*[1, 1, 3, 3]").mask()).generic().clone();
    assert_eq!((generic.generation.0, generic.reproduction.0), (0, 0));
}

/// Its stencils sum to 4/3 and 2/3.
#[test]
fn stencils_must_sum_to_one() {
    let error = Scheme::resolve("1/6*[1, 1, 2, 1, 2, 1, 2, 1, 1]", 2).unwrap_err();
    assert_eq!(error.code(), "not-normalised");
    assert!(error.message().contains("4/3") && error.message().contains("2/3"), "{error}");
    // A class without a coefficient sums to 0.
    for text in ["[2, 0]", "[1]", "[1, 0, 1]"] {
        assert_eq!(Scheme::resolve(text, 2).unwrap_err().code(), "not-normalised", "{text}");
    }
    assert_eq!(Scheme::resolve("[0, 0, 0]", 2).unwrap_err().code(), "zero-mask");
}

/// Zeros at the ends are no part of the mask, but they count for where a list is centred.
#[test]
fn zero_ends() {
    let hat = resolve("[1/2, 1, 1/2]");
    assert_eq!(resolve("[0, 0, 1/2, 1, 1/2, 0, 0]").mask(), hat.mask());
    assert_eq!(resolve("[0, 1/2, 1, 1/2, 0, 0, 0] @ -2").mask(), hat.mask());
    assert_eq!(resolve("[1/2, 1, 1/2, 0, 0]").mask().support(), (-2, 0));
    assert_eq!(hat.mask().support(), (-1, 1));
}

/// Where a mask stands changes neither smoothness nor generation; `τ` moves, and with it nothing is lost, as points
/// may stand anywhere.
#[test]
fn one_sided_supports() {
    for first in [-40, -4, 0, 7, 1000] {
        let text = format!("1/8*[1, 4, 6, 4, 1] @ {first}");
        let found = holder(&text, "3", "3");
        assert_eq!(found.continuity, Some(2), "{text}");
        let generic = degrees(resolve(&text).mask()).generic().clone();
        assert_eq!((generic.generation.0, generic.reproduction.0), (3, 1), "{text}");
    }
}

/// `1 + z³`: the limit of a pulse is `χ[0,3]/3`, weakly; pointwise the scheme diverges. The box itself, `1 + z`,
/// converges to a function with a jump.
#[test]
fn jumps_are_not_proved_continuous() {
    for text in ["[1, 0, 0, 1]", "[1, 1]", "[1, 1] @ 5", "[1, 0, 0, 0, 0, 1]"] {
        let found = regularity_of(text);
        assert_eq!(found.continuity, None, "{text}");
        assert!(found.lower <= rational(0, 1), "{text}");
    }
}

/// `(1+z)(2-z²)`: the differences are refined by `2 - z²`, whose leading eigenvalue is 2: they double.
#[test]
fn a_scheme_that_explodes() {
    let found = holder("[2, 2, -1, -1]", "-1", "-1");
    assert_eq!(found.continuity, None);
}
