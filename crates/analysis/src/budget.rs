//! Limits on the size of a computation, checked before it starts.

use refinable_scheme::Diagnostic;

/// How large a difference symbol of a level may become.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Budget {
    /// The number of scalar coefficients that `c^L` may have.
    pub coefficients: u64,
    /// The degree in the parameter that its coefficients may have.
    pub degree: u64,
}

impl Default for Budget {
    /// Four million coefficients of degree 120: some hundred megabytes, and seconds to minutes.
    fn default() -> Self {
        Budget { coefficients: 4_000_000, degree: 120 }
    }
}

/// The most letters that the words of a proof may have: each is written as one digit.
const MOST_LETTERS: usize = 10;

/// Asked before a search for a proof with words: whether a checker reads words of so many letters.
///
/// # Errors
/// Code `budget`.
pub(crate) fn expect_readable_words(arity: usize) -> Result<(), Diagnostic> {
    if arity <= MOST_LETTERS {
        return Ok(());
    }
    let what = format!("words over {arity} letters, of which {MOST_LETTERS} have a digit");
    Err(unreadable(&what))
}

/// What is said of a proof that is not sought.
pub(crate) fn unreadable(what: &str) -> Diagnostic {
    Diagnostic::new("budget", format!("a proof would have {what}, and no checker reads it"))
        .with_hint("`refinable norm SCHEME -n N --level L` bounds the differences all the same")
}

impl Budget {
    /// Admits polynomials whose degree grows by `degree` with each level: root isolation takes more
    /// than the square of it.
    ///
    /// # Errors
    /// Code `budget`, naming the largest level that fits.
    pub(crate) fn admit_degree(self, degree: u64, level: u32) -> Result<(), Diagnostic> {
        if degree.saturating_mul(level.into()) <= self.degree {
            return Ok(());
        }
        let message = format!(
            "the coefficients have degree {degree} in the parameter, and level {level} would exceed {}",
            self.degree
        );
        let hint = match self.degree / degree {
            0 => "set the parameter to a value".to_string(),
            largest => format!("the largest level that fits is {largest}: --level {largest}"),
        };
        Err(Diagnostic::new("budget", message).with_hint(hint))
    }

    /// Admits level `level` of a symbol with `length` coefficients, each with `terms` terms, whose
    /// `L`-th power has at most `length · m^L` coefficients with `terms_at_level` terms each.
    ///
    /// # Errors
    /// Code `budget`, naming the largest level that fits.
    pub(crate) fn admit(
        self,
        arity: usize,
        length: usize,
        level: u32,
        terms_at_level: impl Fn(u32) -> u64,
    ) -> Result<(), Diagnostic> {
        let size = |level: u32| {
            let rows = (arity as u64).checked_pow(level)?;
            rows.checked_mul(length as u64)?.checked_mul(terms_at_level(level))
        };
        let fits = |level: u32| size(level).is_some_and(|size| size <= self.coefficients);
        if fits(level) {
            return Ok(());
        }
        let largest = (0..level).take_while(|&l| fits(l + 1)).last().map_or(0, |l| l + 1);
        let hint = match largest {
            0 => "the mask is too long for any level; set more parameters".to_string(),
            _ => format!("the largest level that fits is {largest}: --level {largest}"),
        };
        let allowed = self.coefficients;
        let message = format!("level {level} needs more than the {allowed} coefficients allowed");
        Err(Diagnostic::new("budget", message).with_hint(hint))
    }
}
