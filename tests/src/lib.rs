//! Oracles: slow, simple algorithms that share nothing with the ones under test.
