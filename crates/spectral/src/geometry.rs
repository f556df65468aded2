//! Points and convex polygons in floats.

/// A point, or a direction.
pub(crate) type Place = [f64; 2];

/// The scalar product.
pub(crate) fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The least and the largest scalar product with a direction.
pub(crate) fn extent(places: &[Place], direction: Place) -> (f64, f64) {
    let products = || places.iter().map(|place| dot(direction, *place));
    (products().fold(f64::INFINITY, f64::min), products().fold(f64::NEG_INFINITY, f64::max))
}

/// The area of a polygon with corners in counterclockwise order.
pub(crate) fn area(corners: &[Place]) -> f64 {
    0.5 * edges(corners).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

/// The two corners that are farthest apart.
pub(crate) fn diameter(corners: &[Place]) -> [Place; 2] {
    let pairs =
        corners.iter().enumerate().flat_map(|(i, a)| corners[..i].iter().map(move |b| [*b, *a]));
    let longest = pairs.max_by(|a, b| distance(a[0], a[1]).total_cmp(&distance(b[0], b[1])));
    longest.expect("a polygon has three corners")
}

/// Whether a place is in the closed polygon.
pub(crate) fn contains(corners: &[Place], place: Place) -> bool {
    edges(corners)
        .all(|(a, b)| (b[0] - a[0]) * (place[1] - a[1]) >= (b[1] - a[1]) * (place[0] - a[0]))
}

/// The edges.
pub(crate) fn edges(corners: &[Place]) -> impl Iterator<Item = (Place, Place)> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// The distance of two places.
pub(crate) fn distance(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The place that is this part of the way from one to another.
pub(crate) fn between(a: Place, b: Place, part: f64) -> Place {
    [0, 1].map(|i| a[i] + part * (b[i] - a[i]))
}

/// The place that is so far in a direction.
pub(crate) fn moved(place: Place, direction: Place, by: f64) -> Place {
    [0, 1].map(|i| place[i] + by * direction[i])
}
