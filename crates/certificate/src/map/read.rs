//! From bytes to a map and back.

use serde::Deserialize;

use crate::error::Unreadable;
use crate::map::model::{MAP_FORMAT, MapCertificate};
use crate::model::VERSION;
use crate::read::parse;

/// The beginning of a certificate of any kind.
#[derive(Deserialize)]
struct Head {
    format: String,
}

impl MapCertificate {
    /// Whether a file says that it is a map, which it may fail to be.
    pub fn is_meant(bytes: &[u8]) -> bool {
        parse::<Head>(bytes).is_ok_and(|head| head.format == MAP_FORMAT)
    }

    /// Reads a map. Nothing is checked but its form and its size.
    ///
    /// # Errors
    /// [`Unreadable`] if it has not the right form or is too large.
    pub fn read(bytes: &[u8]) -> Result<MapCertificate, Unreadable> {
        let map: MapCertificate = parse(bytes)?;
        if map.format != MAP_FORMAT {
            return Err(Unreadable::Malformed(format!("the format is not {MAP_FORMAT:?}")));
        }
        if map.version != VERSION {
            return Err(Unreadable::Malformed(format!("the version is not {VERSION}")));
        }
        Ok(map)
    }

    /// The map as JSON, in one line; the same text for the same map.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("every field has a JSON form")
    }
}
