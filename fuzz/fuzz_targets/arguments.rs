//! Command lines, a word in each line, end in a command that is understood or in a message.
#![no_main]

use std::ffi::OsString;
use std::os::unix::ffi::OsStringExt;

use libfuzzer_sys::fuzz_target;
use refinable_cli::examine;

fuzz_target!(|bytes: &[u8]| {
    let typed = bytes.split(|byte| *byte == b'\n').map(|word| OsString::from_vec(word.to_vec()));
    let words: Vec<OsString> = std::iter::once("refinable".into()).chain(typed).collect();
    if let Err(message) = examine(&words) {
        assert!(!message.is_empty());
    }
});
