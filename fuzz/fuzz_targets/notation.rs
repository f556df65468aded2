//! The mask language: what is read is printed and read again as the same mask; errors point into the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_scheme::{Diagnostic, Expression, Mask, Substitution};

fuzz_target!(|text: &str| {
    for arity in [2, 3] {
        match Mask::parse(text, arity) {
            Ok(mask) => {
                assert!(mask.check_invariants(), "{mask}");
                same(Mask::parse(&mask.to_string(), arity), &mask);
                same(mask.rule().mask(), &mask);
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
    if let Ok(value) = Expression::parse(text).and_then(|expression| expression.evaluate()) {
        same(Expression::parse(&value.to_string()).and_then(|e| e.evaluate()), &value);
    }
    let _ = Substitution::parse(text);
});

/// What is printed is read as the same again, and a mask's rule has the same mask, unless the sums exceed the
/// budget: each coefficient brings the common denominator.
fn same<T: PartialEq + std::fmt::Debug>(again: Result<T, Diagnostic>, value: &T) {
    match again {
        Ok(again) => assert_eq!(&again, value),
        Err(error) => assert_eq!(error.code(), "budget", "{error}"),
    }
}
