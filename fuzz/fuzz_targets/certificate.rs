//! Certificates are unreadable, invalid or valid, without a panic and soon.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_certificate::{Certificate, verify};

fuzz_target!(|bytes: &[u8]| {
    if let Ok(certificate) = Certificate::read(bytes) {
        let _ = verify(&certificate);
    }
});
