//! The three families against their closed forms, the masks printed in the paper, and tampering.

use refinable_algebra::{
    Laurent, Parameter, ParameterPolynomial, Rational, Ring, binomial, integer, rational,
};
use refinable_scheme::{
    Derivation, Mask, Scheme, Step, Substitution, even_family, interpolatory_family, odd_family,
};

type Symbol = Laurent<ParameterPolynomial>;

fn number(c: Rational) -> ParameterPolynomial {
    ParameterPolynomial::constant(c)
}

fn parameter(name: &str) -> ParameterPolynomial {
    ParameterPolynomial::parameter(&Parameter::new(name))
}

fn symbol(lowest: i64, coefficients: &[Rational]) -> Symbol {
    Laurent::new(lowest, coefficients.iter().cloned().map(number).collect())
}

/// `(z^-2 - 2 + z^2)^k` up to the sign `(-1)^k`, with integer coefficients: `(-1)^j C(2k, k+j)`.
fn minus_d_to_the(k: u32) -> Symbol {
    let coefficients: Vec<_> = (0..=2 * k)
        .map(|j| {
            let sign = if (j + k).is_multiple_of(2) { 1 } else { -1 };
            Rational::from(binomial(2 * k, j) * integer(sign))
        })
        .collect();
    symbol(-i64::from(k), &coefficients).dilated(2)
}

/// `1 - α (-D)^(N+1)`.
fn closed_vertex(n: u32) -> Symbol {
    Symbol::one().minus(&minus_d_to_the(n + 1).scaled(&parameter("alpha")))
}

/// `Σ_{k≤N} C(2k,k)/16^k (-D)^k (z^-1 + z)/2`.
fn closed_edge(n: u32) -> Symbol {
    let ends = symbol(-1, &[rational(1, 2), rational(0, 1), rational(1, 2)]);
    let mut sum = Symbol::zero();
    for k in 0..=n {
        let weight = Rational::new(binomial(2 * k, k), integer(1) << (4 * k));
        sum = sum.plus(&minus_d_to_the(k).scaled(&number(weight)));
    }
    sum.times(&ends)
}

/// `b D^(N+1) (z^-1 + z)`.
fn closed_extension(n: u32, b: &ParameterPolynomial) -> Symbol {
    let ends = symbol(-1, &[rational(1, 1), rational(0, 1), rational(1, 1)]);
    let sign = number(rational(if n.is_multiple_of(2) { -1 } else { 1 }, 1));
    minus_d_to_the(n + 1).times(&ends).scaled(&sign).scaled(b)
}

fn assert_symbol(derivation: &Derivation, expected: &Symbol, what: &str) {
    let mask = derivation.replay().expect("an honest derivation");
    assert_eq!(mask.denominator(), &ParameterPolynomial::one());
    assert_eq!(mask.numerator(), expected, "{what}");
}

#[test]
fn the_recursion_collapses_to_the_closed_forms() {
    let b = parameter("beta").times(&ParameterPolynomial::one().minus(&parameter("alpha")));
    for n in 0..=40 {
        let (vertex, edge) = (closed_vertex(n), closed_edge(n));
        let even = vertex.plus(&edge);
        assert_symbol(&even_family(n), &even, &format!("a{}", 2 * n + 2));
        let odd = even.plus(&closed_extension(n, &b));
        assert_symbol(&odd_family(n), &odd, &format!("a{}", 2 * n + 3));
        let beta = closed_extension(n, &parameter("beta"));
        let interpolatory = Symbol::one().plus(&edge).plus(&beta);
        let name = format!("i{}", 2 * n + 4);
        assert_symbol(&interpolatory_family(n), &interpolatory, &name);
    }
}

/// The table of masks of the `(2N+2)`-point schemes, typed off the page.
const PRINTED_EVEN: [&str; 6] = [
    "1/2*[2*α, 1, 2 - 4*α, 1, 2*α]",
    "1/16*[-16*α, -1, 64*α, 9, 16 - 96*α, 9, 64*α, -1, -16*α]",
    "1/256*[256*α, 3, -1536*α, -25, 3840*α, 150, 256 - 5120*α, 150, 3840*α, -25, -1536*α, 3, 256*α]",
    "1/2048*[-2048*α, -5, 16384*α, 49, -57344*α, -245, 114688*α, 1225, 2048 - 143360*α, 1225,
      114688*α, -245, -57344*α, 49, 16384*α, -5, -2048*α]",
    "1/65536*[65536*α, 35, -655360*α, -405, 2949120*α, 2268, -7864320*α, -8820, 13762560*α, 39690,
      65536 - 16515072*α, 39690, 13762560*α, -8820, -7864320*α, 2268, 2949120*α, -405, -655360*α,
      35, 65536*α]",
    "1/524288*[-524288*α, -63, 6291456*α, 847, -34603008*α, -5445, 115343360*α, 22869, -259522560*α,
      -76230, 415236096*α, 320166, 524288 - 484442112*α, 320166, 415236096*α, -76230, -259522560*α,
      22869, 115343360*α, -5445, -34603008*α, 847, 6291456*α, -63, -524288*α]",
];

const PRINTED_ODD: [&str; 3] = [
    "[β*(1-α), α, 1/2 - β*(1-α), 1 - 2*α, 1/2 - β*(1-α), α, β*(1-α)]",
    "[β*(1-α), -α, -1/16 - 3*β*(1-α), 4*α, 9/16 + 2*β*(1-α), 1 - 6*α, 9/16 + 2*β*(1-α), 4*α,
      -1/16 - 3*β*(1-α), -α, β*(1-α)]",
    "[β*(1-α), α, 3/256 - 5*β*(1-α), -6*α, -25/256 + 9*β*(1-α), 15*α, 150/256 - 5*β*(1-α), 1 - 20*α,
      150/256 - 5*β*(1-α), 15*α, -25/256 + 9*β*(1-α), -6*α, 3/256 - 5*β*(1-α), α, β*(1-α)]",
];

#[test]
fn the_printed_masks_are_those_of_the_recursion() {
    for (n, printed) in (0..).zip(PRINTED_EVEN) {
        let mask = even_family(n).replay().unwrap();
        assert_eq!(mask, Mask::parse(printed, 2).unwrap(), "N = {n}");
    }
    for (n, printed) in (0..).zip(PRINTED_ODD) {
        let mask = odd_family(n).replay().unwrap();
        assert_eq!(mask, Mask::parse(printed, 2).unwrap(), "N = {n}");
    }
}

#[test]
fn the_derivation_reads_like_the_interpretation_of_the_framework() {
    let printed = "\
N = 1: the points move along the vectors
(1/N)*(N/4 - 1/8) = (1/1)*(1/4 - 1/8)
                  = 1/8
C_{2i,2} = (C_{2i,1} - C_{2(i+1),1}) + (C_{2i,1} - C_{2(i-1),1})
         = -f_{i-2} + 3*f_{i-1} - 4*f_i + 3*f_{i+1} - f_{i+2}
C_{2i+1,2} = 1/8*((C_{2i+1,1} - C_{2(i+1)+1,1}) + (C_{2i+1,1} - C_{2(i-1)+1,1}))
           = 1/16*(-f_{i-1} + f_i + f_{i+1} - f_{i+2})
f_{2i,2} = f_{2i,1} + alpha*C_{2i,2}
         = -alpha*f_{i-2} + 4*alpha*f_{i-1} + (1 - 6*alpha)*f_i + 4*alpha*f_{i+1} - alpha*f_{i+2}
f_{2i+1,2} = f_{2i+1,1} + C_{2i+1,2}
           = 1/16*(-f_{i-1} + 9*f_i + 9*f_{i+1} - f_{i+2})";
    assert_eq!(even_family(1).steps()[1].to_string(), printed);
    let extension = odd_family(1).steps()[2].to_string();
    assert!(extension.contains("weight at f_{i-1} = (-1)^0*(-3/4)*C(4, 1)\n"));
    assert!(extension.contains(
        "+ beta*(1 - alpha)*(f_{i-2} - 3*f_{i-1} + 2*f_i + 2*f_{i+1} - 3*f_{i+2} + f_{i+3})"
    ));
    let restriction = interpolatory_family(0).steps()[2].to_string();
    assert!(restriction.contains("= beta*f_{i-1} + (1/2 - beta)*f_i + (1/2 - beta)*f_{i+1}"));
}

/// Replaces one step and returns the complaint.
fn complaint(derivation: &Derivation, at: usize, change: impl Fn(&mut Step)) -> String {
    let mut steps = derivation.steps().to_vec();
    change(&mut steps[at]);
    let error = Derivation::from_steps(steps).replay().unwrap_err();
    assert_eq!(error.code(), "derivation");
    error.message().to_string()
}

#[test]
fn a_tampered_derivation_fails_where_it_was_tampered_with() {
    let honest = interpolatory_family(3);
    let said = complaint(&honest, 0, |step| {
        let Step::Initial { vectors, .. } = step else { unreachable!() };
        vectors.vertex = vectors.vertex.negated();
    });
    assert!(said.starts_with("step 0 of the derivation: the recorded displacement vectors"));
    let said = complaint(&honest, 2, |step| {
        let Step::Displacement { factor, .. } = step else { unreachable!() };
        *factor = rational(1, 4);
    });
    assert!(said.starts_with("step 2 of the derivation: the recorded factors"));
    let said = complaint(&honest, 3, |step| {
        let Step::Displacement { points, .. } = step else { unreachable!() };
        points.edge = points.edge.shifted(1);
    });
    assert!(said.starts_with("step 3 of the derivation: the recorded points"));
    let said = complaint(&honest, 4, |step| {
        let Step::Extension { weights, .. } = step else { unreachable!() };
        weights[2].sign = -weights[2].sign;
    });
    assert!(said.starts_with("step 4 of the derivation: the recorded weights"));
    let said = complaint(&honest, 5, |step| {
        let Step::Restriction { points, .. } = step else { unreachable!() };
        points.vertex = points.edge.clone();
    });
    assert!(said.starts_with("step 5 of the derivation: the recorded points"));
}

#[test]
fn steps_out_of_order_are_no_derivation() {
    let steps = interpolatory_family(2).steps().to_vec();
    for dropped in 0..steps.len() - 1 {
        let mut fewer = steps.clone();
        fewer.remove(dropped);
        assert!(Derivation::from_steps(fewer).replay().is_err(), "without {dropped}");
    }
    let twice = [&steps[..], &steps[4..]].concat();
    assert!(Derivation::from_steps(twice).replay().is_err());
    assert!(Derivation::from_steps(Vec::new()).replay().is_err());
}

fn resolved(name: &str) -> Scheme {
    Scheme::resolve(name, 2).unwrap()
}

fn with(scheme: &Scheme, set: &str) -> Scheme {
    scheme.with(&[Substitution::parse(set).unwrap()]).unwrap()
}

/// Lagrange interpolation and the recursion are two roads to the same schemes.
#[test]
fn all_families_meet_in_deslauriers_and_dubuc() {
    for n in 0..=20 {
        let dubuc = resolved(&format!("dd{}", 2 * n + 2));
        let even = with(&resolved(&format!("a{}", 2 * n + 2)), "alpha=0");
        let interpolatory = resolved(&format!("i{}", 2 * n + 4));
        assert_eq!(even.mask(), dubuc.mask());
        assert_eq!(with(&interpolatory, "beta=0").mask(), dubuc.mask());
        let odd = with(&resolved(&format!("a{}", 2 * n + 3)), "alpha=0");
        assert_eq!(odd.mask(), interpolatory.mask());
    }
}

#[test]
fn the_ends_of_the_catalogue_are_within_reach() {
    for name in ["a202", "a203", "i204", "dd202", "bspline400"] {
        let scheme = resolved(name);
        assert!(scheme.mask().check_invariants());
        let is_dual = name == "bspline400";
        assert_eq!((scheme.mask().is_primal(), scheme.mask().is_dual()), (!is_dual, is_dual));
    }
}
