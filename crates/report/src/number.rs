//! Exact numbers as JSON.

use refinable_algebra::Rational;
use refinable_reals::{Bound, Interval, RealAlgebraic, Region};
use serde_json::{Value, json};

/// `{"exact", "lower", "upper", "approx"}`: exact as text, an enclosure of width 1e-13 (0 for a
/// rational number) with rational ends, and the nearest 15-digit decimal as a JSON number.
pub fn number(x: &RealAlgebraic, variable: &str) -> Value {
    let (lower, upper) = x.decimal_enclosure(13);
    json!({
        "exact": x.exact_form().display(variable),
        "lower": lower.to_string(),
        "upper": upper.to_string(),
        "approx": approx(x),
    })
}

/// The same for a rational number.
pub fn rational_number(x: &Rational) -> Value {
    number(&x.clone().into(), "")
}

fn approx(x: &RealAlgebraic) -> Value {
    // The decimal text is exact arithmetic; JSON has no other numbers than these.
    x.decimal(15).parse::<f64>().map_or(Value::Null, Value::from)
}

/// `{"lo", "hi", "lo_closed", "hi_closed"}`; an infinite end is `null`.
pub fn interval(interval: &Interval, variable: &str) -> Value {
    let end = |bound: &Bound| bound.number().map_or(Value::Null, |x| number(x, variable));
    json!({
        "lo": end(&interval.lower),
        "hi": end(&interval.upper),
        "lo_closed": interval.lower.is_closed(),
        "hi_closed": interval.upper.is_closed(),
    })
}

/// The intervals of a region that are not single points.
pub fn intervals(region: &Region, variable: &str) -> Vec<Value> {
    let proper = region.intervals().into_iter().filter(|i| i.as_point().is_none());
    proper.map(|i| interval(&i, variable)).collect()
}

/// The isolated points of a region.
pub fn points(region: &Region, variable: &str) -> Vec<Value> {
    let isolated = region.intervals();
    isolated.iter().filter_map(Interval::as_point).map(|x| number(x, variable)).collect()
}

/// `≈ 0.19273` behind an irrational number, nothing behind a rational one.
pub fn approximation(x: &RealAlgebraic) -> String {
    match x.simplified().as_rational() {
        Some(_) => String::new(),
        None => format!(" ≈ {}", x.decimal(6)),
    }
}
