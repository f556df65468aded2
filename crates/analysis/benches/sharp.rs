//! Sharp ranges and regularity: `cargo bench -p refinable-analysis --bench sharp`.
//!
//! Afterwards the size of each proof is printed, which does not depend on the machine.

use divan::Bencher;
use refinable_algebra::Parameter;
use refinable_analysis::{ContinuityRange, Options, Sharpness, continuity_range, regularity};
use refinable_certificate::verify;
use refinable_scheme::{Scheme, Substitution};

const RANGES: [(&str, &str, usize); 7] = [
    ("i4", "beta", 1),
    ("a6", "alpha", 3),
    ("a8", "alpha", 5),
    ("i8", "beta", 3),
    ("a10", "alpha", 6),
    ("a12", "alpha", 0),
    ("a12", "alpha", 6),
];

fn main() {
    divan::main();
    println!("\nscheme, order: lemmas, bytes of the certificate");
    for case in RANGES {
        let certificate = range(case).certificate;
        let bytes = certificate.to_json().len();
        println!("{}, C^{}: {}, {bytes}", case.0, case.2, certificate.lemmas.len());
    }
}

fn range((name, parameter, continuity): (&str, &str, usize)) -> ContinuityRange {
    let scheme = Scheme::resolve(name, 2).expect("in the catalogue");
    let parameter = Parameter::new(parameter);
    continuity_range(name, scheme.mask(), &parameter, continuity, &Sharpness::default())
        .expect("a line of masks")
}

#[divan::bench(args = RANGES, sample_count = 3)]
fn sharp_range(bencher: Bencher<'_, '_>, case: (&str, &str, usize)) {
    bencher.bench(|| range(case));
}

#[divan::bench(args = RANGES, sample_count = 3)]
fn checking(bencher: Bencher<'_, '_>, case: (&str, &str, usize)) {
    let certificate = range(case).certificate;
    bencher.bench(|| verify(&certificate).expect("it was found"));
}

/// The joint spectral radius to 1e-9; the last leads with a complex pair.
#[divan::bench(args = [("dd4", ""), ("dd16", ""), ("a12", "alpha=231/4194304"), ("a10", "alpha=37/100000")], sample_count = 10)]
fn exponent(bencher: Bencher<'_, '_>, (name, set): (&str, &str)) {
    let substitution = |set: &str| Substitution::parse(set).expect("well-formed");
    let set: Vec<Substitution> =
        Some(set).filter(|set| !set.is_empty()).map(substitution).into_iter().collect();
    let scheme = Scheme::resolve_with(name, 2, &set).expect("in the catalogue");
    bencher.bench(|| regularity(name, scheme.mask(), &Options::default()).expect("converges"));
}
