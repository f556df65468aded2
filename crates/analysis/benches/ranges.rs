//! Exact ranges and degree ladders: `cargo bench -p refinable-analysis`.
//!
//! The last group prints how the time grows with the level beside how the output does.

// Times are measured here, nothing is decided.
#![allow(clippy::disallowed_types)]

use std::time::Instant;

use divan::Bencher;
use refinable_algebra::Parameter;
use refinable_analysis::{Budget, NormRange, degrees, norm_range};
use refinable_scheme::Scheme;

fn main() {
    divan::main();
    growth();
}

fn range(scheme: &Scheme, continuity: usize, level: u32) -> NormRange {
    let alpha = Parameter::new("alpha");
    norm_range(scheme.mask(), &alpha, continuity, level, Budget::default()).expect("small enough")
}

#[divan::bench(args = [("a4", 0, 6), ("a12", 5, 6), ("a12", 0, 6)])]
fn exact_range(bencher: Bencher<'_, '_>, (name, continuity, level): (&str, usize, u32)) {
    let scheme = Scheme::resolve(name, 2).expect("in the catalogue");
    bencher.bench(|| range(&scheme, continuity, level));
}

#[divan::bench(args = ["a5", "a43"])]
fn degree_ladder(bencher: Bencher<'_, '_>, name: &str) {
    let scheme = Scheme::resolve(name, 2).expect("in the catalogue");
    bencher.bench(|| degrees(scheme.mask()));
}

/// The size of `c_n^1, …, c_n^L` together (rows times terms, `Σ 2^l (l+1)`), and the time for the range.
fn growth() {
    for (name, continuity) in [("a4", 0), ("a12", 5)] {
        let scheme = Scheme::resolve(name, 2).expect("in the catalogue");
        println!("\ngrowth of {name}, C^{continuity}: level, size, milliseconds");
        let mut points = Vec::new();
        for level in 4..=9 {
            let size: f64 = (1..=level).map(|l| f64::from(1_u32 << l) * f64::from(l + 1)).sum();
            let seconds = fastest(|| range(&scheme, continuity, level));
            println!("{level:>6} {size:>13} {:>13.2}", 1e3 * seconds);
            points.push((size.ln(), seconds.ln()));
        }
        println!("exponent of the time against the size: {:.2}", slope(&points));
    }
}

fn fastest<T>(work: impl Fn() -> T) -> f64 {
    let time = |_| {
        let start = Instant::now();
        divan::black_box(work());
        start.elapsed().as_secs_f64()
    };
    (0..5).map(time).fold(f64::INFINITY, f64::min)
}

/// The slope of the least-squares line.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let above: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    above / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}
