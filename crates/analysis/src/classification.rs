//! The kinds of schemes that papers tell apart.

use refinable_algebra::Parameter;
use refinable_reals::{Component, common_zero_set};
use refinable_scheme::Mask;

/// The kind of a family of schemes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Classification {
    /// `a(z) = a(1/z)`.
    pub primal: bool,
    /// `z a(z) = a(1/z)`.
    pub dual: bool,
    /// The old points stay where they are, for all parameter values.
    pub interpolatory: bool,
    /// The old points move, for all parameter values.
    pub approximating: bool,
    /// Interpolatory at some parameter values and approximating at others; `None` if that takes
    /// the solution of a system in more than two parameters.
    pub combined: Option<bool>,
    /// Primal and not interpolatory: a vertex rule that relaxes the old points.
    pub relaxed: bool,
}

/// Classifies a family by its symbol and its vertex rule.
///
/// # Source
/// Definition 2.1 of Hameed and Mustafa (after Conti and Hormann 2011) for primal and dual; the
/// text of their Section 2 for combined and relaxed.
pub fn classify(mask: &Mask) -> Classification {
    let interpolatory = mask.is_interpolatory();
    let somewhere = interpolatory_somewhere(mask);
    Classification {
        primal: mask.is_primal(),
        dual: mask.is_dual(),
        interpolatory,
        approximating: somewhere == Some(false),
        combined: somewhere.map(|s| s && !interpolatory),
        relaxed: mask.is_primal() && !interpolatory,
    }
}

/// Whether some parameter value that is no pole makes the vertex rule reproduce the old points.
fn interpolatory_somewhere(mask: &Mask) -> Option<bool> {
    let parameters: Vec<Parameter> = mask.parameters().into_iter().collect();
    let conditions = mask.interpolation_conditions();
    let zeros = common_zero_set(&conditions, &parameters).ok()?;
    let d = mask.denominator();
    let parts: Vec<Component> = zeros
        .iter()
        .flat_map(|zero| zero.split_by(d, &parameters))
        .filter(|part| !part.annihilates(d))
        .collect();
    let real = parts.iter().any(|part| part.is_surely_real(&parameters));
    (real || parts.is_empty()).then_some(real)
}

#[cfg(test)]
mod tests {
    use super::*;
    use refinable_scheme::Scheme;

    fn kind(text: &str) -> Classification {
        classify(Scheme::resolve(text, 2).unwrap().mask())
    }

    #[test]
    fn the_families_of_the_paper() {
        let even = kind("a4");
        assert!(even.primal && even.relaxed && !even.interpolatory && !even.approximating);
        assert_eq!(even.combined, Some(true));
        assert_eq!(kind("a5").combined, Some(true));
        let interpolatory = kind("i6");
        assert!(interpolatory.interpolatory && !interpolatory.relaxed);
        assert_eq!(interpolatory.combined, Some(false));
    }

    #[test]
    fn splines_are_approximating_and_alternate_between_primal_and_dual() {
        for d in 2..7 {
            let spline = kind(&format!("bspline{d}"));
            assert!(spline.approximating);
            assert_eq!((spline.primal, spline.dual), (d % 2 == 1, d % 2 == 0));
        }
    }

    /// The vertex rule is the old point where `x² + y² + w² + 1` or `y (x² + 1)` vanish: nowhere, and
    /// at the pole `y = 0`. In three parameters the first is left open.
    #[test]
    fn conditions_without_real_solutions_make_no_combined_scheme() {
        let open = kind("z^-1*(1/2+z+1/2*z^2)+(x^2+y^2+w^2+1)*(z^2-1)");
        assert_eq!(open.combined, None);
        let pole = kind("1/y*z^-1+x^2+2+(1-1/y)*z-(x^2+1)*z^2");
        assert_eq!(pole.combined, Some(false));
    }

    /// A vertex rule that would need both w = 0 and w = 1 is never interpolatory.
    #[test]
    fn contradicting_conditions_leave_a_family_approximating() {
        let family = kind("[w, 1/2, 0, 1/2, 1-w]");
        assert!(family.approximating);
        assert_eq!(family.combined, Some(false));
    }
}
