//! What a search may cost, counted in steps and not by a clock: it ends alike on every machine.

use std::sync::atomic::{AtomicU64, Ordering};

/// The products of floats that growing polytopes may still take.
#[derive(Debug)]
pub(crate) struct Work(AtomicU64);

impl Work {
    /// So many. Only where polytopes are grown one after the other it does not depend on the number of threads
    /// which of them is the last.
    pub fn of(products: u64) -> Self {
        Work(AtomicU64::new(products))
    }

    /// More than any search takes.
    pub fn unbounded() -> Self {
        Work::of(u64::MAX)
    }

    /// What is left.
    pub fn left(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }

    /// Takes something off, or all of it.
    pub fn spend(&self, products: u64) {
        let rest = |left: u64| Some(left.saturating_sub(products));
        let _ = self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, rest);
    }
}
