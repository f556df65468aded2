//! What the checks of many cells share: schemes, ladders and norm ranges, each computed once.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock};

use refinable_algebra::{Parameter, Rational};
use refinable_analysis::{Budget, Degrees, NormRange, degrees, norm_range, norm_values};
use refinable_scheme::{Diagnostic, Scheme, Substitution};

/// How much work an audit may spend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effort {
    /// The highest level of norms.
    pub level: u32,
    /// The size of one computation.
    pub budget: Budget,
}

/// Shared results of an audit, keyed by scheme and substitutions.
pub struct Workbench {
    /// What may be spent.
    pub effort: Effort,
    ladders: Memo<String, Degrees>,
    ranges: Memo<(String, usize), NormRange>,
    values: Memo<(String, usize), Option<Vec<Rational>>>,
}

impl Workbench {
    /// An empty workbench.
    pub fn new(effort: Effort) -> Self {
        Workbench {
            effort,
            ladders: Memo::default(),
            ranges: Memo::default(),
            values: Memo::default(),
        }
    }

    /// The scheme of a claim with its substitutions made.
    ///
    /// # Errors
    /// Whatever is wrong with the text.
    pub fn scheme(&self, text: &str, set: &[String]) -> Result<Scheme, Diagnostic> {
        let substitutions: Result<Vec<Substitution>, Diagnostic> =
            set.iter().map(|text| Substitution::parse(text)).collect();
        Scheme::resolve_with(text, 2, &substitutions?)
    }

    /// The degree ladder of a scheme.
    pub fn degrees(&self, scheme: &Scheme) -> Arc<Degrees> {
        let result = self.ladders.get(key(scheme), || Ok(degrees(scheme.mask())));
        result.expect("degrees exist for every normalised mask")
    }

    /// What norms prove about C^n over the one free parameter of a scheme.
    ///
    /// # Errors
    /// As for [`norm_range`].
    pub fn range(
        &self,
        scheme: &Scheme,
        parameter: &Parameter,
        continuity: usize,
    ) -> Result<Arc<NormRange>, Diagnostic> {
        self.ranges.get((key(scheme), continuity), || {
            norm_range(scheme.mask(), parameter, continuity, self.effort.level, self.effort.budget)
        })
    }

    /// The norms of a scheme without free parameters.
    ///
    /// # Errors
    /// As for [`norm_values`].
    pub fn norms(
        &self,
        scheme: &Scheme,
        continuity: usize,
    ) -> Result<Arc<Option<Vec<Rational>>>, Diagnostic> {
        self.values.get((key(scheme), continuity), || {
            norm_values(scheme.mask(), continuity, self.effort.level, self.effort.budget)
        })
    }
}

/// Equal masks have equal results, whatever the schemes are called.
fn key(scheme: &Scheme) -> String {
    let mask = scheme.mask();
    let coefficients: Vec<String> = mask.coefficients().map(|(_, c)| c.to_string()).collect();
    format!("{} {} {}", mask.arity(), mask.support().0, coefficients.join(","))
}

/// A table of results, each computed by the first thread that asks for it.
struct Memo<K, V>(Mutex<HashMap<K, Slot<V>>>);

type Slot<V> = Arc<OnceLock<Result<Arc<V>, Diagnostic>>>;

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Memo(Mutex::new(HashMap::new()))
    }
}

impl<K: Hash + Eq, V> Memo<K, V> {
    fn get(
        &self,
        key: K,
        compute: impl FnOnce() -> Result<V, Diagnostic>,
    ) -> Result<Arc<V>, Diagnostic> {
        let mut slots = self.0.lock().expect("no computation runs under the lock");
        let slot = slots.entry(key).or_default().clone();
        drop(slots);
        // Only threads that want this very result wait here; `compute` starts no parallel work.
        slot.get_or_init(|| compute().map(Arc::new)).clone()
    }
}
