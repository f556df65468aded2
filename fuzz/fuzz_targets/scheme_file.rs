//! Scheme files end in a file or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_scheme::SchemeFile;

fuzz_target!(|text: &str| {
    if let Err(error) = SchemeFile::parse(text) {
        assert!(!error.to_string().is_empty());
    }
});
