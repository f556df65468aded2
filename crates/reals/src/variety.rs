//! Real varieties in parameter space, piece by piece.

use refinable_algebra::{Domain, GcdDomain, Parameter, ParameterPolynomial, Ring};

use crate::isolate::real_roots;
use crate::point::Point;
use crate::system::{common_zeros, has_real_point};

/// A piece of the real zero set of finitely many polynomials in finitely many parameters.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Component {
    /// All of parameter space.
    Space,
    /// `{f = 0}` with `f` square-free, primitive and not constant: a curve in two parameters, a
    /// hypersurface in more. In one parameter the points themselves are listed instead.
    Hypersurface(ParameterPolynomial),
    /// A single point.
    Point(Point),
}

/// A zero set that is not worked out: hypersurfaces that meet in three or more parameters, or
/// polynomials of so high a degree that resultants are out of reach.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unsolved;

/// The largest total degree of a polynomial in one parameter that is solved.
const LARGEST_DEGREE: u32 = 200;
/// The largest total degree of a polynomial in two or more parameters that is solved.
const LARGEST_DEGREE_IN_SEVERAL: u32 = 24;

/// Whether gcds and resultants of the polynomial are within reach.
fn is_small(p: &ParameterPolynomial) -> bool {
    let limit = if p.parameters().len() > 1 { LARGEST_DEGREE_IN_SEVERAL } else { LARGEST_DEGREE };
    p.degree().is_none_or(|degree| degree <= limit)
}

impl Component {
    /// Whether `g` vanishes identically on the piece. For a hypersurface that is not irreducible:
    /// on all of it.
    pub fn annihilates(&self, g: &ParameterPolynomial) -> bool {
        match self {
            Component::Space => g.is_zero(),
            Component::Hypersurface(f) => g.divide_exactly(f).is_some(),
            Component::Point(point) => point.sign_of(g).is_eq(),
        }
    }

    /// The pieces of a hypersurface on which `g` vanishes identically, and those on no component of
    /// which it does, without those that have no real point; other pieces, and those too large to
    /// be split, come back whole.
    pub fn split_by(&self, g: &ParameterPolynomial, parameters: &[Parameter]) -> Vec<Component> {
        let Component::Hypersurface(f) = self else {
            return vec![self.clone()];
        };
        if !is_small(f) || !is_small(g) {
            return vec![self.clone()];
        }
        let common = f.gcd(g);
        if common.as_constant().is_some() || common == *f {
            return vec![self.clone()];
        }
        let parts = [common.clone(), f.quotient(&common)];
        parts.iter().flat_map(|part| zero_set(part, parameters).unwrap_or_default()).collect()
    }

    /// Whether the piece certainly has a real point: in three or more parameters that is known of a
    /// hypersurface only if its equation has odd degree in one of them.
    pub fn is_surely_real(&self, parameters: &[Parameter]) -> bool {
        match self {
            Component::Space | Component::Point(_) => true,
            Component::Hypersurface(f) => {
                let odd = |p: &Parameter| f.collected(p).degree().is_some_and(|d| d % 2 == 1);
                parameters.len() <= 2 || parameters.iter().any(odd)
            }
        }
    }

    /// The part of the piece where `g` vanishes, in the space of the given parameters.
    ///
    /// # Errors
    /// [`Unsolved`] for a proper intersection of hypersurfaces in three or more, and for polynomials of a total degree
    /// above 200, or above 24 in several parameters, that have to be solved.
    pub fn intersect(
        &self,
        g: &ParameterPolynomial,
        parameters: &[Parameter],
    ) -> Result<Vec<Component>, Unsolved> {
        if self.annihilates(g) {
            return Ok(vec![self.clone()]);
        }
        match self {
            Component::Space => zero_set(g, parameters),
            Component::Point(_) => Ok(Vec::new()),
            Component::Hypersurface(f) => {
                if !is_small(f) || !is_small(g) {
                    return Err(Unsolved);
                }
                let common = f.gcd(g);
                let mut pieces = zero_set(&common, parameters)?;
                let rest = f.quotient(&common);
                if rest.as_constant().is_none() && g.as_constant().is_none() {
                    let [x, y] = parameters else {
                        return Err(Unsolved);
                    };
                    pieces.extend(common_zeros(&rest, g, [x, y]).into_iter().map(Component::Point));
                }
                Ok(pieces)
            }
        }
    }
}

/// The real zeros of one nonzero polynomial.
fn zero_set(g: &ParameterPolynomial, parameters: &[Parameter]) -> Result<Vec<Component>, Unsolved> {
    if g.as_constant().is_some() {
        return Ok(Vec::new());
    }
    if !is_small(g) {
        return Err(Unsolved);
    }
    let f = g.square_free_part();
    Ok(match parameters {
        [x] => {
            let (_, p) = f.cleared_univariate(x).expect("only this parameter occurs");
            let points = real_roots(&p).into_iter().map(|root| Point::new([(x.clone(), root)]));
            points.map(Component::Point).collect()
        }
        [x, y] if !has_real_point(&f, [x, y]) => Vec::new(),
        _ => vec![Component::Hypersurface(f)],
    })
}

/// The common real zeros of several polynomials, as a list of pieces without repetition.
///
/// # Errors
/// [`Unsolved`] as for [`Component::intersect`].
pub fn common_zero_set(
    polynomials: &[ParameterPolynomial],
    parameters: &[Parameter],
) -> Result<Vec<Component>, Unsolved> {
    let mut pieces = vec![Component::Space];
    for g in polynomials {
        let mut next: Vec<Component> = Vec::new();
        for piece in &pieces {
            for part in piece.intersect(g, parameters)? {
                if !next.contains(&part) {
                    next.push(part);
                }
            }
        }
        pieces = next;
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_algebra::rational;

    #[test]
    fn a_line_and_a_point_off_it() {
        let (x, y) = (Parameter::new("x"), Parameter::new("y"));
        let [px, py] = [&x, &y].map(ParameterPolynomial::parameter);
        let int = ParameterPolynomial::from_i64;
        // x (x - 1) = 0 and x (y - 2) = 0: the line x = 0 and the point (1, 2).
        let f = px.times(&px.minus(&int(1)));
        let g = px.times(&py.minus(&int(2)));
        let pieces = common_zero_set(&[f, g], &[x.clone(), y.clone()]).unwrap();
        let point = Point::new([(x, rational(1, 1).into()), (y, rational(2, 1).into())]);
        assert_eq!(pieces, [Component::Hypersurface(px), Component::Point(point)]);
    }

    #[test]
    fn one_parameter_gives_points() {
        let x = Parameter::new("x");
        let px = ParameterPolynomial::parameter(&x);
        let p = px.power(2).minus(&ParameterPolynomial::from_i64(4)).power(2);
        let pieces = common_zero_set(std::slice::from_ref(&p), std::slice::from_ref(&x)).unwrap();
        let at = |v| Component::Point(Point::new([(x.clone(), rational(v, 1).into())]));
        assert_eq!(pieces, [at(-2), at(2)]);
    }

    fn xyz() -> ([Parameter; 3], [ParameterPolynomial; 3]) {
        let parameters = ["x", "y", "z"].map(Parameter::new);
        let polynomials = parameters.each_ref().map(ParameterPolynomial::parameter);
        (parameters, polynomials)
    }

    #[test]
    fn hypersurfaces_are_split_where_another_polynomial_vanishes() {
        let (plane, [x, y, _]) = xyz();
        let plane = &plane[..2];
        let piece = |f: &ParameterPolynomial| Component::Hypersurface(f.square_free_part());
        let one = ParameterPolynomial::from_i64(1);
        let both = piece(&x.times(&y));
        assert_eq!(both.split_by(&x.times(&y.minus(&one)), plane), [piece(&x), piece(&y)]);
        // x² + y² + 1 has no real zero.
        let circle = x.power(2).plus(&y.power(2)).plus(&one);
        assert_eq!(piece(&x.times(&circle)).split_by(&x, plane), [piece(&x)]);
        assert_eq!(common_zero_set(&[circle], plane), Ok(vec![]));
        // Nothing in common, all in common, and too large to be looked at.
        let large = x.power(25).minus(&y).times(&x);
        for (f, g) in [(&x, &y), (&x, &x.times(&y)), (&x, &large), (&large, &x)] {
            assert_eq!(piece(f).split_by(g, plane), [piece(f)]);
        }
        assert_eq!(Component::Space.split_by(&x, plane), [Component::Space]);
        for (f, g) in [(&x, &y.power(25).minus(&x)), (&large, &y)] {
            assert_eq!(piece(f).intersect(g, plane), Err(Unsolved));
        }
    }

    #[test]
    fn surfaces_of_odd_degree_have_real_points() {
        let (space, [x, y, z]) = xyz();
        let piece = |f: &ParameterPolynomial| Component::Hypersurface(f.clone());
        let sphere = x.power(2).plus(&y.power(2)).plus(&z.power(2));
        assert!(!piece(&sphere.plus(&ParameterPolynomial::one())).is_surely_real(&space));
        assert!(piece(&sphere.plus(&y.power(3))).is_surely_real(&space));
        assert!(piece(&x.times(&y).plus(&z.power(2))).is_surely_real(&space));
        assert!(piece(&x.power(2).minus(&y.power(2))).is_surely_real(&space[..2]));
        assert!(Component::Space.is_surely_real(&space));
    }
}
