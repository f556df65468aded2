//! From bytes to a map and back.

use crate::error::Unreadable;
use crate::map::model::{MAP_FORMAT, MapCertificate};
use crate::model::VERSION;
use crate::read::parse;

impl MapCertificate {
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
