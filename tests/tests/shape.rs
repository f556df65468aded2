//! What limits keep of the shape of their data, against exact limits found another way, and against curves refined
//! step by step.

use refinable_algebra::{Ordered, Rational, Ring, decimal, rational};
use refinable_refine::{BasicLimit, ShapeVerdict, Witness, keeps_steps, preserves};
use refinable_scheme::{Normalised, Scheme};

fn mask(text: &str, arity: usize) -> Normalised {
    Scheme::resolve(text, arity).unwrap().mask().clone()
}

/// `F(x)` for `f_k = C(k+r-1, r-1)`, `k ≥ 0`, by the rows of transition matrices.
fn limit(mask: &Normalised, r: i64, x: &Rational) -> Rational {
    let stencil = BasicLimit::new(mask).unwrap().stencil(x, 0).unwrap();
    let data = |k: i64| match (r, k < 0) {
        (_, true) => Rational::zero(),
        (1, _) => Rational::one(),
        _ => Rational::from_i64(k + 1),
    };
    let indices = stencil.first()..;
    indices.zip(stencil.weights()).map(|(k, w)| data(k) * w).sum()
}

fn refuted(verdict: ShapeVerdict) -> Witness {
    match verdict {
        ShapeVerdict::Refuted(witness) => witness,
        other => panic!("{other:?}"),
    }
}

const SPLINES: [(&str, usize); 7] = [
    ("bspline1", 2),
    ("bspline2", 2),
    ("bspline3", 2),
    ("bspline6", 2),
    ("1/9*(1+z+z^2)^3*z^-3", 3),
    ("1/16*(1+z+z^2+z^3)^3*z^-5", 4),
    ("even: [3/4, 1/4]; odd: [1/4, 3/4]", 2),
];

const OSCILLATING: [(&str, usize); 8] = [
    ("dd4", 2),
    ("dd6", 2),
    ("fourpoint(1/32)", 2),
    ("dualfourpoint(1/128)", 2),
    ("pseudo(3, 1)", 2),
    ("jspline(7/4)", 2),
    ("ternaryfourpoint(1/11)", 3),
    ("0: [1]; 1: 1/128*[-7, 105, 35, -5]; 2: 1/16*[-1, 9, 9, -1]; 3: 1/128*[-5, 35, 105, -7]", 4),
];

#[test]
fn splines_keep_everything() {
    for (text, arity) in SPLINES {
        let mask = mask(text, arity);
        for order in 0..=2 {
            assert_eq!(preserves(&mask, order).unwrap(), ShapeVerdict::Proved, "{text}: {order}");
        }
        assert_eq!(keeps_steps(&mask).unwrap(), ShapeVerdict::Proved, "{text}");
    }
}

/// The witnesses hold for the limits that `refine` finds.
#[test]
fn witnesses_are_there() {
    let mut seen = [0; 3];
    for (text, arity) in OSCILLATING {
        let mask = &mask(text, arity);
        if let ShapeVerdict::Refuted(w) = preserves(mask, 1).unwrap() {
            let [from, to] = &w.places;
            assert_eq!(limit(mask, 1, from) - limit(mask, 1, to), w.amount, "{text}");
            assert!(w.amount.compare_to_zero().is_gt());
            seen[0] += 1;
        }
        if let ShapeVerdict::Refuted(w) = preserves(mask, 2).unwrap() {
            let [from, to] = &w.places;
            let middle = (from + to) / rational(2, 1);
            let second = limit(mask, 2, from) + limit(mask, 2, to)
                - rational(2, 1) * limit(mask, 2, &middle);
            assert_eq!(-second, w.amount, "{text}");
            seen[1] += 1;
        }
        if let ShapeVerdict::Refuted(w) = keeps_steps(mask).unwrap() {
            let value = limit(mask, 1, &w.places[0]);
            assert_eq!((&value - Rational::one()).max(-&value), w.amount, "{text}");
            seen[2] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count >= 5), "{seen:?}");
}

/// Interpolated steps are refined in floats, and leave [0, 1] about as far as is said.
#[test]
fn a_refined_step_overshoots() {
    let mut points: Vec<f64> = (-8..8).map(|k| if k < 0 { 0.0 } else { 1.0 }).collect();
    for _ in 0..8 {
        let between = |p: &[f64]| (-p[0] + 9.0 * p[1] + 9.0 * p[2] - p[3]) / 16.0;
        points = points.windows(4).flat_map(|p| [p[1], between(p)]).collect();
    }
    let most = points.iter().fold(0.0_f64, |most, p| most.max(p - 1.0).max(-p));
    assert!(points.windows(2).any(|p| p[1] < p[0]));
    let witness = refuted(keeps_steps(&mask("dd4", 2)).unwrap());
    let said = decimal(&witness.amount, 15).parse::<f64>().unwrap();
    assert!(said <= most + 1e-12 && most < said + 2e-3, "{said} {most}");
}

/// One number: -1/16 at 1/2 between (0, 0, 0, 1), whatever else.
#[test]
fn the_four_point_scheme_does_not_keep_monotone_data() {
    let witness = refuted(preserves(&mask("dd4", 2), 1).unwrap());
    assert_eq!(witness.amount, rational(1, 16));
    assert_eq!(witness.places, [rational(-2, 1), rational(-3, 2)]);
}

#[test]
fn what_is_not_asked() {
    assert_eq!(preserves(&mask("a2", 2), 1).unwrap_err().code(), "parameters");
    // σ² does not divide: convexity is not asked.
    let skew = mask("even: [1]; odd: [1/3, 2/3]", 2);
    assert_eq!(preserves(&skew, 2).unwrap(), ShapeVerdict::Undecided);
    assert_eq!(preserves(&skew, 1).unwrap(), ShapeVerdict::Proved);
}
