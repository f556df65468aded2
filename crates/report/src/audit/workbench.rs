//! What the checks of many cells share: schemes, ladders and norm ranges, each computed once.

use std::collections::{BTreeMap, HashMap};
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock};

use refinable_algebra::{Parameter, Rational};
use refinable_analysis::{
    Budget, ContinuityRange, Degrees, PointVerdict, Sharpness, certified_range, certified_verdict,
    continuity_at, continuity_range, degrees, norm_values,
};
use refinable_certificate::Certificate;
use refinable_scheme::{Diagnostic, Scheme, Substitution};

/// How much work an audit may spend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effort {
    /// The highest level of norms.
    pub level: u32,
    /// The size of one computation.
    pub budget: Budget,
}

/// Certificates by name.
pub type CertificateStore = BTreeMap<String, Certificate>;

/// A result and the name of the certificate that proves it.
pub type Certified<T> = (T, String);

/// Shared results of an audit, keyed by scheme and substitutions.
pub struct Workbench {
    /// What may be spent.
    pub effort: Effort,
    ladders: Memo<String, Degrees>,
    ranges: Memo<(String, usize), Certified<ContinuityRange>>,
    verdicts: Memo<(String, usize), Certified<PointVerdict>>,
    norms: Memo<(String, usize), Option<Vec<Rational>>>,
    known: CertificateStore,
    used: Mutex<CertificateStore>,
}

impl Workbench {
    /// A workbench with certificates from earlier.
    pub fn new(effort: Effort, known: CertificateStore) -> Self {
        Workbench {
            effort,
            ladders: Memo::default(),
            ranges: Memo::default(),
            verdicts: Memo::default(),
            norms: Memo::default(),
            known,
            used: Mutex::default(),
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

    /// Where C^n holds over the one free parameter of a scheme.
    ///
    /// # Errors
    /// As for [`continuity_range`].
    pub fn range(
        &self,
        scheme: &Scheme,
        parameter: &Parameter,
        continuity: usize,
    ) -> Result<Arc<Certified<ContinuityRange>>, Diagnostic> {
        self.ranges.get((key(scheme), continuity), || {
            let name = certificate_name(scheme, continuity);
            let mask = scheme.mask();
            let range = match certified(&self.known, scheme, parameter, continuity) {
                Some(range) => range,
                None => {
                    let sharpness = Sharpness::default();
                    continuity_range(scheme.name(), mask, parameter, continuity, &sharpness)?
                }
            };
            self.record(&name, &range.certificate);
            Ok((range, name))
        })
    }

    /// Whether a scheme without free parameters is C^n.
    ///
    /// # Errors
    /// As for [`continuity_at`].
    pub fn verdict(
        &self,
        scheme: &Scheme,
        continuity: usize,
    ) -> Result<Arc<Certified<PointVerdict>>, Diagnostic> {
        self.verdicts.get((key(scheme), continuity), || {
            let name = certificate_name(scheme, continuity);
            let mask = scheme.mask();
            let earlier = self.known.get(&name).and_then(|known| {
                Some((certified_verdict(mask, continuity, known)?, known.clone()))
            });
            let (verdict, certificate) = match earlier {
                Some(found) => found,
                None => continuity_at(scheme.name(), mask, continuity, &Sharpness::default())?,
            };
            self.record(&name, &certificate);
            Ok((verdict, name))
        })
    }

    fn record(&self, name: &str, certificate: &Certificate) {
        let mut used = self.used.lock().expect("nothing panics under the lock");
        used.insert(name.to_string(), certificate.clone());
    }

    /// The certificates that were asked for.
    pub fn used(&self) -> CertificateStore {
        self.used.lock().expect("nothing panics under the lock").clone()
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
        self.norms.get((key(scheme), continuity), || {
            norm_values(scheme.mask(), continuity, self.effort.level, self.effort.budget)
        })
    }
}

/// The range of C^n that one of the certificates proves.
pub(crate) fn certified(
    known: &CertificateStore,
    scheme: &Scheme,
    parameter: &Parameter,
    continuity: usize,
) -> Option<ContinuityRange> {
    let certificate = known.get(&certificate_name(scheme, continuity))?;
    certified_range(scheme.mask(), parameter, continuity, certificate)
}

/// Equal masks have equal results, whatever the schemes are called.
fn key(scheme: &Scheme) -> String {
    let mask = scheme.mask();
    let coefficients: Vec<String> = mask.coefficients().map(|(_, c)| c.to_string()).collect();
    format!("{} {} {}", mask.arity(), mask.support().0, coefficients.join(","))
}

/// `a3-1f3a9c02-C3`: the name, a fingerprint of the mask, the order.
fn certificate_name(scheme: &Scheme, continuity: usize) -> String {
    // FNV-1a over the mask: the same on every machine.
    let hash = key(scheme).bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let name: String = scheme.name().chars().filter(char::is_ascii_alphanumeric).take(12).collect();
    format!("{name}-{:08x}-C{continuity}", hash >> 32)
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
        // Only threads that want this very result wait here.
        slot.get_or_init(|| compute().map(Arc::new)).clone()
    }
}
