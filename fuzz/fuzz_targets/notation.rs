//! The mask language: what is read is printed and read again as the same mask; errors point into the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_scheme::{Expression, Mask, Substitution};

fuzz_target!(|text: &str| {
    for arity in [2, 3] {
        match Mask::parse(text, arity) {
            Ok(mask) => {
                assert!(mask.check_invariants(), "{mask}");
                let again = Mask::parse(&mask.to_string(), arity);
                assert_eq!(again.expect("what is printed can be read"), mask);
                assert_eq!(mask.rule().mask().expect("its own rule"), mask);
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
    if let Ok(value) = Expression::parse(text).and_then(|expression| expression.evaluate()) {
        let again = Expression::parse(&value.to_string()).and_then(|e| e.evaluate());
        assert_eq!(again.expect("what is printed can be read"), value);
    }
    let _ = Substitution::parse(text);
});
