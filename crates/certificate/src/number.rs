//! Rational numbers as they stand in a file.

use refinable_algebra::{Rational, parse_rational};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::order::equal;

/// The largest number of digits of a numerator or denominator.
const DIGITS: usize = 2000;

/// A rational number, written `"p/q"` or `"p"`.
#[derive(Clone, Debug)]
pub struct Number(pub Rational);

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        equal(&self.0, &other.0)
    }
}

impl Eq for Number {}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let mut parts = text.strip_prefix('-').unwrap_or(&text).split('/');
        if parts.any(|part| part.len() > DIGITS) {
            return Err(D::Error::custom("a number of more than 2000 digits"));
        }
        // Decimals are for people.
        let value = parse_rational(&text).filter(|_| !text.contains('.'));
        value
            .map(Number)
            .ok_or_else(|| D::Error::custom(format!("{text:?} is not a rational number")))
    }
}
