//! Files of claims are read or refused, without a panic and soon.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_papers::Claims;

fuzz_target!(|text: &str| {
    let _ = Claims::parse(text);
});
