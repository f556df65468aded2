//! Which known scheme a mask is.

use std::fmt;

use refinable_algebra::{Parameter, ParameterFraction, ParameterPolynomial, Ring};

use crate::mask::Mask;
use crate::normalised::Normalised;
use crate::scheme::Scheme;

/// A known scheme that a mask is, perhaps at values of that scheme's parameters, perhaps with other indices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Identity {
    /// The scheme as [`Scheme::resolve`] reads it, such as `pseudo(3, 1)` or `jspline(s)`.
    pub known: String,
    /// What its parameters are, in terms of those of the mask.
    pub values: Vec<(Parameter, ParameterFraction)>,
    /// The mask is `z^shift` times that of the known scheme.
    pub shift: i64,
}

/// `jspline(s) with s = 8*alpha`.
impl fmt::Display for Identity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A parameter that is called the same need not be told.
        let own = |p: &Parameter| ParameterFraction::from(ParameterPolynomial::parameter(p));
        let others = self.values.iter().filter(|(p, x)| *x != own(p));
        let values: Vec<String> = others.map(|(p, x)| format!("{p} = {x}")).collect();
        f.write_str(&self.known)?;
        if !values.is_empty() {
            write!(f, " with {}", values.join(", "))?;
        }
        match self.shift {
            0 => Ok(()),
            k => write!(f, ", indices moved by {k}"),
        }
    }
}

/// The widest mask that is looked up.
const WIDEST: i64 = 64;

/// Known schemes that are this mask for all values of its parameters: single ones first, then members of
/// families with few parameters. A family is left out where its parameters cannot be found one after the
/// other from linear equations.
///
/// ```
/// use refinable_scheme::{Scheme, identities};
/// let scheme = Scheme::resolve("[(8*a-1)/16, a, (9-8*a)/16, 1-2*a, (9-8*a)/16, a, (8*a-1)/16]", 2).unwrap();
/// let found = identities(scheme.mask());
/// assert_eq!(found[0].to_string(), "jspline(s) with s = 8*a");
/// ```
///
/// # Cost
/// Some dozens of systems of as many equations as the mask has coefficients.
pub fn identities(mask: &Normalised) -> Vec<Identity> {
    let (low, high) = mask.support();
    if high - low > WIDEST {
        return Vec::new();
    }
    let candidates = candidates(mask.arity(), high - low).into_iter();
    let mut found: Vec<Identity> = candidates.filter_map(|known| identity(mask, known)).collect();
    // One scheme may have several names: the shortest families first.
    found.sort_by_key(|identity| identity.values.len());
    found
}

/// Texts of schemes whose support may be as wide, or a little wider for families, whose ends may vanish.
fn candidates(arity: usize, width: i64) -> Vec<String> {
    match arity {
        2 => {}
        3 => return vec!["ternaryfourpoint(mu)".into()],
        _ => return Vec::new(),
    }
    let mut texts = vec![format!("bspline{}", width - 1)];
    if width % 2 == 0 {
        texts.push(format!("dd{}", width / 2 + 1));
        texts.extend((1..width / 4).map(|l| format!("pseudo({}, {l})", width / 2 - l)));
    } else {
        texts.extend((1..=width / 4).map(|l| format!("dualpseudo({}, {l})", width / 2 - l)));
    }
    for (text, own) in [
        ("fourpoint(w)", 6),
        ("sixpoint(w)", 10),
        ("dualfourpoint(w)", 7),
        ("jspline(s)", 6),
        ("jspline(a, b)", 6),
    ] {
        if (own - 2..=own).contains(&width) {
            texts.push(text.into());
        }
    }
    for points in 2..=width / 2 + 2 {
        if (2 * points - 2..=2 * points).contains(&width) {
            texts.push(format!("a{points}"));
        }
        if points % 2 == 0 && points >= 4 && (2 * points - 4..=2 * points - 2).contains(&width) {
            texts.push(format!("i{points}"));
        }
    }
    texts
}

fn identity(mask: &Normalised, known: String) -> Option<Identity> {
    let scheme = Scheme::resolve(&known, mask.arity()).ok()?;
    let family = scheme.mask();
    let middle = |mask: &Mask| {
        let (low, high) = mask.support();
        low + high
    };
    // The middle of a family stays where it is when its ends vanish: all of them are symmetric.
    let twice = middle(mask) - middle(family);
    let shift = (twice % 2 == 0).then_some(twice / 2)?;
    let parameters: Vec<Parameter> = family.parameters().into_iter().collect();
    let values = solved(family, mask, shift, &parameters)?;
    Some(Identity { known, values: parameters.into_iter().zip(values).collect(), shift })
}

/// The values of the family's parameters at which it is the mask, each found from an equation that is linear in
/// it and has no other unknown.
fn solved(
    family: &Normalised,
    mask: &Mask,
    shift: i64,
    parameters: &[Parameter],
) -> Option<Vec<ParameterFraction>> {
    // Names that nobody can type: those of the mask's parameters are others.
    let unknowns: Vec<Parameter> =
        (0..parameters.len()).map(|k| Parameter::new(&format!("unknown {k}"))).collect();
    let mut member = family.clone();
    for (parameter, unknown) in parameters.iter().zip(&unknowns) {
        let value = ParameterFraction::from(ParameterPolynomial::parameter(unknown));
        member = member.substitute(parameter, &value).ok()?;
    }
    let mut values: Vec<Option<ParameterFraction>> = vec![None; unknowns.len()];
    while let Some((k, value)) = next_value(&member, mask, shift, &unknowns)? {
        member = member.substitute(&unknowns[k], &value).ok()?;
        values[k] = Some(value);
    }
    values.into_iter().collect()
}

/// A parameter by its number, and its value.
type Found = (usize, ParameterFraction);

/// The next unknown with its value; `Some(None)` if all equations hold, `None` if one cannot.
fn next_value(
    member: &Normalised,
    mask: &Mask,
    shift: i64,
    unknowns: &[Parameter],
) -> Option<Option<Found>> {
    let ((a, b), (c, d)) = (member.support(), mask.support());
    let mut undecided = false;
    for i in (a + shift).min(c)..=(b + shift).max(d) {
        let difference = member.coefficient(i - shift).minus(&mask.coefficient(i));
        let equation = difference.numerator();
        let left = equation.parameters();
        let mut here = (0..unknowns.len()).filter(|k| left.contains(&unknowns[*k]));
        match (here.next(), here.next()) {
            (None, _) if equation.is_zero() => {}
            (None, _) => return None,
            (Some(k), None) => {
                let collected = equation.collected(&unknowns[k]);
                let [constant, slope] = collected.coefficients() else {
                    undecided = true;
                    continue;
                };
                let value = ParameterFraction::new(constant.negated(), slope).ok()?;
                return Some(Some((k, value)));
            }
            _ => undecided = true,
        }
    }
    if undecided { None } else { Some(None) }
}
