//! Certificates of both kinds are unreadable, invalid or valid, and what they state can be said, without a panic and soon.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_cli::verdict_on;

fuzz_target!(|bytes: &[u8]| {
    let _ = verdict_on(bytes);
});
