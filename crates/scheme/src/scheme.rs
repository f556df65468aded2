//! What a user means by a line of text.

use std::collections::BTreeSet;

use refinable_algebra::Parameter;

use crate::budget::Budget;
use crate::catalogue::look_up;
use crate::construction::constructed;
use crate::derivation::Derivation;
use crate::diagnostic::Diagnostic;
use crate::expression::SYMBOL_VARIABLE;
use crate::mask::Mask;
use crate::normalised::Normalised;
use crate::substitution::Substitution;

/// A scheme, or a family of schemes, with a name and, where they are known, its source and its derivation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Scheme {
    name: String,
    mask: Normalised,
    source: Option<String>,
    derivation: Option<Derivation>,
}

impl Scheme {
    /// A scheme without a source and a derivation.
    pub fn new(name: impl Into<String>, mask: Normalised) -> Self {
        Scheme { name: name.into(), mask, source: None, derivation: None }
    }

    /// The scheme under another name; without its derivation, which is that of the old name.
    pub(crate) fn renamed(self, name: String) -> Self {
        Scheme { name, derivation: None, ..self }
    }

    /// The scheme with a source, or with the one it has if there is no other.
    pub(crate) fn with_source(self, source: Option<String>) -> Self {
        Scheme { source: source.or(self.source), ..self }
    }

    /// The scheme that `text` means: a name of the [`catalogue`](crate::catalogue()), a construction such as
    /// `pseudo(4, 1)` of [`constructions`](crate::constructions), which knows its arity, or a mask in the notation
    /// of [`Mask::parse`]; the text then is the name.
    ///
    /// ```
    /// use refinable_scheme::Scheme;
    /// let cubic = Scheme::resolve("1/8*z^-2*(1+z)^4", 2).unwrap();
    /// assert_eq!(cubic.mask(), Scheme::resolve("bspline3", 2).unwrap().mask());
    /// let error = Scheme::resolve("bspine3", 2).unwrap_err();
    /// assert!(error.hint().unwrap().starts_with("did you mean `bspline3`?"));
    /// ```
    ///
    /// # Errors
    /// `unknown-scheme`, `not-normalised`, `arity` for a catalogue name with another arity than 2, and for a construction if the
    /// one asked for is neither its own nor 2; `construction` for arguments that a construction does not take, and those of [`Mask::parse`].
    pub fn resolve(text: &str, arity: usize) -> Result<Self, Diagnostic> {
        Scheme::resolve_with(text, arity, &[])
    }

    /// The scheme that `text` means after the substitutions. Unlike [`with`](Self::with) after
    /// [`resolve`](Self::resolve), this admits masks that are normalised only at those values.
    ///
    /// # Errors
    /// Those of [`resolve`](Self::resolve) and of [`with`](Self::with).
    pub fn resolve_with(
        text: &str,
        arity: usize,
        substitutions: &[Substitution],
    ) -> Result<Self, Diagnostic> {
        let text = text.trim();
        if text.is_empty() {
            return Err(Diagnostic::new("syntax", "the scheme is empty"));
        }
        if is_name(text) {
            return named(text, arity)?.with(substitutions);
        }
        let (mask, source) = match constructed(text, 0) {
            Some((construction, made)) => {
                let made = made?;
                // Two is what is not asked for.
                if arity != 2 {
                    expect_arity(text, &made, arity)?;
                }
                (made, construction.source())
            }
            None => (Mask::parse(text, arity)?, None),
        };
        let mask = substituted(&mask, substitutions)?;
        Ok(Scheme::new(text, Normalised::new(mask)?).with_source(source.map(String::from)))
    }

    /// An argument of a construction: a name, a construction, or a binary mask.
    pub(crate) fn resolve_nested(text: &str, depth: usize) -> Result<Self, Diagnostic> {
        match constructed(text, depth) {
            Some((_, mask)) => Ok(Scheme::new(text, Normalised::new(mask?)?)),
            None => Scheme::resolve(text, 2),
        }
    }

    /// The name; of a mask that was typed in, the text.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The mask.
    pub fn mask(&self) -> &Normalised {
        &self.mask
    }

    /// Where the scheme comes from; of a construction or a scheme file, what is said there.
    pub fn source(&self) -> Option<&str> {
        self.source.as_deref()
    }

    /// How the mask was derived, if it was.
    pub fn derivation(&self) -> Option<&Derivation> {
        self.derivation.as_ref()
    }

    /// The scheme with parameters replaced, in the given order. A value may bring in new parameters,
    /// and those may be set after it. The name and the source stay; the derivation stays only if nothing is set.
    ///
    /// # Errors
    /// `substitution` for a parameter that is set twice, or that neither the scheme nor a value set
    /// before has (one that dropped out on the way, as `beta` does at `alpha = 1`, may still be set);
    /// `pole`, `budget`.
    pub fn with(&self, substitutions: &[Substitution]) -> Result<Self, Diagnostic> {
        if substitutions.is_empty() {
            return Ok(self.clone());
        }
        let mask = substituted(&self.mask, substitutions)?;
        Ok(Scheme { mask: Normalised::new(mask)?, derivation: None, ..self.clone() })
    }
}

/// A letter, then letters, digits and underscores, but not the variable of symbols.
fn is_name(text: &str) -> bool {
    text != SYMBOL_VARIABLE
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

fn expect_arity(name: &str, mask: &Mask, arity: usize) -> Result<(), Diagnostic> {
    if mask.arity() == arity {
        return Ok(());
    }
    let message = format!("`{name}` has arity {}, not {arity}", mask.arity());
    Err(Diagnostic::new("arity", message))
}

fn named(name: &str, arity: usize) -> Result<Scheme, Diagnostic> {
    let (row, mask, derivation) = look_up(name)?;
    expect_arity(name, &mask, arity)?;
    let source = Some(row.source().to_string());
    Ok(Scheme { source, derivation, ..Scheme::new(name, Normalised::new(mask)?) })
}

fn substituted(mask: &Mask, substitutions: &[Substitution]) -> Result<Mask, Diagnostic> {
    check_parameters(mask, substitutions)?;
    let mut budget = Budget::new();
    substitutions.iter().try_fold(mask.clone(), |mask, s| {
        mask.substitute_within(s.parameter(), s.value(), &mut budget)
    })
}

/// Whether every parameter is there to be set, and set once.
fn check_parameters(mask: &Mask, substitutions: &[Substitution]) -> Result<(), Diagnostic> {
    let mut known = mask.parameters();
    let mut set = BTreeSet::new();
    for substitution in substitutions {
        let parameter = substitution.parameter();
        if !set.insert(parameter.clone()) {
            let message = format!("`{parameter}` is set twice");
            return Err(Diagnostic::new("substitution", message));
        }
        if !known.contains(parameter) {
            return Err(not_there(parameter, &(&known - &set)));
        }
        known.append(&mut substitution.value().parameters());
    }
    Ok(())
}

fn not_there(parameter: &Parameter, free: &BTreeSet<Parameter>) -> Diagnostic {
    let message = format!("the scheme has no parameter `{parameter}`");
    let error = Diagnostic::new("substitution", message);
    let names: Vec<_> = free.iter().map(|p| format!("`{p}`")).collect();
    error.with_hint(match names.as_slice() {
        [] => "it has no free parameter".to_string(),
        names => format!("it has {}", names.join(", ")),
    })
}
