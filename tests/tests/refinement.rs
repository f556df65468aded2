//! Refinement of polynomial data against the degrees that analysis finds: two roads that share no code.

use refinable_algebra::{
    ParameterFraction, ParameterPolynomial, Polynomial, Rational, Ring, rational,
};
use refinable_analysis::degrees;
use refinable_refine::{BasicLimit, Ends, Polygon, Weights, refine, refine_to};
use refinable_scheme::{Scheme, Substitution};

/// A member of every kind of scheme of the catalogue, the families at tensions without a meaning.
fn catalogue() -> Vec<(String, Scheme)> {
    let names = (2..=9).map(|k| format!("a{k}")).chain((2..=5).map(|k| format!("i{}", 2 * k)));
    let splines = (1..=7).map(|d| format!("bspline{d}"));
    let names = names.chain((1..=5).map(|k| format!("dd{}", 2 * k))).chain(splines);
    let inline = [
        ("1/99*[-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4] @ -5", 3),
        ("1/27*[1, 4, 10, 16, 19, 16, 10, 4, 1] @ -4", 3),
        ("1/16*(1+z+z^2+z^3)^3", 4),
        ("[1/3, 1/4, 2/3, 3/4] @ 5", 2),
    ];
    let schemes = names.map(|name| (name, 2)).chain(inline.map(|(text, m)| (text.to_string(), m)));
    schemes
        .map(|(name, arity)| {
            let family = Scheme::resolve(&name, arity).unwrap();
            let values = [rational(1, 37), rational(-3, 41)].into_iter();
            let parameters = family.mask().parameters();
            let set = parameters.iter().zip(values).map(|(parameter, value)| {
                let value = ParameterFraction::from(ParameterPolynomial::constant(value));
                Substitution::new(parameter.clone(), value)
            });
            let member = family.with(&set.collect::<Vec<_>>()).unwrap();
            (name, member)
        })
        .collect()
}

/// The polynomial `x^d - 2 x^(d-1) + … `, whose coefficients are all different from zero.
fn polynomial(degree: usize) -> Polynomial<Rational> {
    let coefficient = |k: usize| rational(if k.is_multiple_of(2) { 1 } else { -2 }, 1 + k as i64);
    Polynomial::new((0..=degree).map(coefficient).collect())
}

/// Whether all points of the level lie on the polynomial, the first control point at 0 and the distance of
/// control points 1.
fn reproduces(scheme: &Scheme, degree: usize, levels: usize, count: usize, ends: Ends) -> bool {
    let p = polynomial(degree);
    let data = (0..count as i64).map(|i| p.evaluate(&rational(i, 1))).collect();
    let rule = Weights::<Rational>::new(scheme.mask()).unwrap();
    let polygon = Polygon::new(1, data, false).unwrap();
    let rules = vec![&rule; levels];
    let found = refine(&polygon, &rules, ends).unwrap();
    // A new point `i` stands at `(i - τ)/m` among the old ones.
    let m = Rational::from_i64(rule.arity() as i64);
    let step = m.power(levels as u32).recip();
    let offset = (0..levels).fold(Rational::zero(), |x, _| (x - rule.shift()) / &m);
    let first = if ends == Ends::Trim {
        let range = rules.iter().fold(0..count as i64, |old, rule| rule.produced(&old));
        rational(range.start, 1)
    } else {
        (-&offset / &step).ceil()
    };
    let place = |i: usize| (&first + rational(i as i64, 1)) * &step + &offset;
    let places: Vec<Rational> = (0..found.count()).map(place).collect();
    if ends != Ends::Trim {
        let (start, end) = (&places[0], &places[places.len() - 1]);
        let last = rational(count as i64 - 1, 1);
        assert!(*start >= Rational::zero() && start - &step < Rational::zero());
        assert!(*end <= last && end + &step > last);
    }
    places.iter().zip(found.values()).all(|(x, y)| p.evaluate(x) == *y)
}

#[test]
fn every_scheme_reproduces_what_its_degree_says_and_no_more() {
    let mut tested = 0;
    for (name, scheme) in catalogue() {
        let degree = degrees(scheme.mask()).generic().reproduction.0;
        let reach = scheme.mask().support_width().to_integer();
        let count = 3 * usize::try_from(reach).unwrap() + 8;
        for d in 0..=degree {
            assert!(reproduces(&scheme, d, 2, count, Ends::Trim), "{name}, {d}");
            let ends = Ends::Extrapolate { degree };
            assert!(reproduces(&scheme, d, 2, degree + 2, ends), "{name}, {d}, to the ends");
        }
        assert!(!reproduces(&scheme, degree + 1, 1, count, Ends::Trim), "{name}, {}", degree + 1);
        if degree > 0 {
            assert!(reproduces(&scheme, 1, 3, 5, Ends::Reflect), "{name}");
        }
        tested += 1;
    }
    assert_eq!(tested, 28);
}

/// The limit of what is reproduced is the polynomial, and so are its derivatives.
#[test]
fn limits_of_polynomials_are_polynomials() {
    for name in ["dd4", "dd6", "dd8", "bspline2", "bspline4"] {
        let scheme = Scheme::resolve(name, 2).unwrap();
        let degree = degrees(scheme.mask()).generic().reproduction.0;
        let p = polynomial(degree);
        let data = (0..30).map(|i| p.evaluate(&rational(i, 1))).collect();
        let polygon = Polygon::new(1, data, false).unwrap();
        let limit = BasicLimit::new(scheme.mask()).unwrap();
        let rules = [limit.rule::<Rational>(0).unwrap(), limit.rule(1).unwrap()];
        let [values, slopes] =
            &refine_to(&polygon, &[], &rules.each_ref(), Ends::Trim).unwrap()[..]
        else {
            panic!("two rules")
        };
        let first = (0..30).find(|&i| p.evaluate(&rational(i, 1)) == values.values()[0]).unwrap();
        for (k, (value, slope)) in values.values().iter().zip(slopes.values()).enumerate() {
            let x = rational(first + k as i64, 1);
            assert_eq!((value, slope), (&p.evaluate(&x), &p.derivative().evaluate(&x)), "{name}");
        }
    }
}
