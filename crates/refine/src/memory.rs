//! How much memory a result may take.

use refinable_scheme::Diagnostic;

use crate::coordinate::Coordinate;
use crate::weights::Weights;

/// The most that a result may take, in bytes.
const LARGEST_RESULT: u64 = 2 << 30;

/// Whether so many values, after all steps of the rules, are not too much.
///
/// # Errors
/// Code `memory`, with what it would take.
pub(crate) fn check<T: Coordinate>(rules: &[&Weights<T>], values: u64) -> Result<(), Diagnostic> {
    let bits = rules.iter().map(|rule| rule.denominator_bits()).max().unwrap_or(0);
    let bytes = values.saturating_mul(T::bytes(rules.len() as u32, bits));
    if bytes <= LARGEST_RESULT {
        return Ok(());
    }
    let message = format!("the result would take about {}", in_words(bytes));
    let hint = format!("{} is the most; ask for fewer levels", in_words(LARGEST_RESULT));
    Err(Diagnostic::new("memory", message).with_hint(hint))
}

/// `1.5 GiB`, rounded up to a tenth.
fn in_words(bytes: u64) -> String {
    let units = ["bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"];
    let power = (bytes.max(1).ilog2() / 10) as usize;
    let tenths = (u128::from(bytes) * 10).div_ceil(1 << (10 * power));
    match tenths % 10 {
        0 => format!("{} {}", tenths / 10, units[power]),
        tenth => format!("{}.{tenth} {}", tenths / 10, units[power]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_in_words() {
        assert_eq!(in_words(0), "0 bytes");
        assert_eq!(in_words(2 << 30), "2 GiB");
        assert_eq!(in_words((3 << 29) + 1), "1.6 GiB");
        assert_eq!(in_words(u64::MAX), "16 EiB");
    }
}
