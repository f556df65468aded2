//! From bytes to a certificate and back.

use serde::de::DeserializeOwned;

use crate::error::Unreadable;
use crate::limits;
use crate::model::{Certificate, FORMAT, VERSION};

impl Certificate {
    /// Reads a certificate. Nothing is checked but its form and its size.
    ///
    /// # Errors
    /// [`Unreadable`] if it has not the right form or is too large.
    pub fn read(bytes: &[u8]) -> Result<Certificate, Unreadable> {
        let certificate: Certificate = parse(bytes)?;
        if certificate.format != FORMAT {
            return Err(Unreadable::Malformed(format!("the format is not {FORMAT:?}")));
        }
        if certificate.version != VERSION {
            return Err(Unreadable::Malformed(format!("the version is not {VERSION}")));
        }
        limits::check(&certificate).map_err(|what| Unreadable::TooLarge(what.into()))?;
        Ok(certificate)
    }

    /// The certificate as JSON, in one line; the same text for the same certificate.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("every field has a JSON form")
    }
}

/// JSON of bounded size and depth.
pub(crate) fn parse<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Unreadable> {
    if bytes.len() > limits::FILE {
        return Err(Unreadable::TooLarge("a file of more than 64 MiB".into()));
    }
    scan(bytes).map_err(|what| Unreadable::TooLarge(what.into()))?;
    serde_json::from_slice(bytes)
        .map_err(|error| Unreadable::Malformed(shortened(&error.to_string())))
}

/// Checks, without any memory, that the nesting is not too deep, no string or number too long and
/// the number of values not too large. Text that is not JSON is for the parser to refuse.
fn scan(bytes: &[u8]) -> Result<(), &'static str> {
    let (mut depth, mut values, mut token) = (0_usize, 0_usize, 0_usize);
    let (mut in_string, mut escaped) = (false, false);
    for &byte in bytes {
        token += 1;
        if token > limits::TOKEN {
            return Err("a string or number of more than 4000 characters");
        }
        if in_string {
            in_string = escaped || byte != b'"';
            escaped = !escaped && byte == b'\\';
            continue;
        }
        match byte {
            b'[' | b'{' => {
                depth += 1;
                values += 1;
            }
            b']' | b'}' => depth = depth.saturating_sub(1),
            b',' => values += 1,
            b'"' => in_string = true,
            b':' | b' ' | b'\t' | b'\r' | b'\n' => {}
            _ => continue,
        }
        token = 0;
        if depth > limits::DEPTH {
            return Err("a nesting deeper than 16");
        }
        if values > limits::VALUES {
            return Err("more than ten million values");
        }
    }
    Ok(())
}

/// The message of the parser, which may quote the file.
fn shortened(message: &str) -> String {
    const LONGEST: usize = 200;
    match message.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &message[..end]),
        None => message.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What stands in strings is no structure, and what separates ends a token.
    #[test]
    fn only_structure_outside_of_strings_counts() {
        let deep = "[".repeat(limits::DEPTH + 1);
        for text in [
            format!("{{\"a\": \"{deep}\"}}"),
            format!("\"\\\"{deep}\""),
            format!("\"\\\\\" , \"{deep}\""),
        ] {
            assert_eq!(scan(text.as_bytes()), Ok(()), "{text}");
        }
        for text in [deep.clone(), format!("\"\\\\\" , {deep}"), format!("\"\\\"\" : {deep}")] {
            assert!(scan(text.as_bytes()).is_err(), "{text}");
        }
        assert_eq!(scan(&deep.as_bytes()[1..]), Ok(()));
        let long = "7".repeat(limits::TOKEN);
        assert_eq!(scan(long.as_bytes()), Ok(()));
        assert!(scan(format!("{long}7").as_bytes()).is_err());
        assert!(scan(format!("\"{long}\"").as_bytes()).is_err());
        let spread: String = "12: \t\r\n\"x\", ".repeat(limits::TOKEN);
        assert_eq!(scan(spread.as_bytes()), Ok(()));
        assert_eq!(scan(" ".repeat(2 * limits::TOKEN).as_bytes()), Ok(()));
    }
}
