//! Refinement: `cargo bench -p refinable-refine`. The rivals are in `benches/peers/numpy/refine.py`.
//!
//! Items are points of the last level, so that divan prints points per second; `copy` is a plain copy of
//! the result into fresh memory.

use divan::Bencher;
use divan::counter::ItemsCount;
use refinable_algebra::Rational;
use refinable_refine::{Coordinate, Ends, Net, Polygon, Surface, Weights, refine, refine_net};
use refinable_scheme::{Scheme, Substitution};

fn main() {
    divan::main();
}

/// `S_a5` at `α = 1/16`, `β = -1/48`.
fn scheme<T: Coordinate>() -> Weights<T> {
    let family = Scheme::resolve("a5", 2).expect("a name of the catalogue");
    let sets = ["alpha=1/16", "beta=-1/48"].map(|set| Substitution::parse(set).expect("numbers"));
    Weights::new(family.with(&sets).expect("its parameters").mask())
        .expect("no parameters are left")
}

fn wave(i: usize) -> f64 {
    ((i * i) % 1013) as f64 / 7.0
}

/// 2-D, 1000 points, ten levels.
#[divan::bench(sample_count = 30)]
fn curve(bencher: Bencher) {
    let rule = scheme::<f64>();
    let polygon = Polygon::new(2, (0..2000).map(wave).collect(), true).expect("points");
    let refined = || refine(&polygon, &[&rule; 10], Ends::Trim).expect("closed");
    bencher.counter(ItemsCount::new(refined().count())).bench(refined);
}

/// The same result, copied.
#[divan::bench(sample_count = 30)]
fn curve_copy(bencher: Bencher) {
    let values: Vec<f64> = (0..2 * 1_024_000).map(wave).collect();
    bencher.counter(ItemsCount::new(values.len() / 2)).bench(|| values.clone());
}

/// 3-D, 100 × 100 points, five levels.
#[divan::bench(sample_count = 10)]
fn surface(bencher: Bencher) {
    let rule = scheme::<f64>();
    let net = Net::new(3, 100, (0..30_000).map(wave).collect(), [true; 2]).expect("points");
    let chain = [&rule; 5];
    let refined = || refine_net(&net, [&chain, &chain], [Ends::Trim; 2]).expect("closed");
    bencher.counter(ItemsCount::new(3200_u64 * 3200)).bench(refined);
}

/// The same, row by row, without the whole in memory.
#[divan::bench(sample_count = 10)]
fn surface_rows(bencher: Bencher) {
    let rule = scheme::<f64>();
    let net = Net::new(3, 100, (0..30_000).map(wave).collect(), [true; 2]).expect("points");
    let chain = [&rule; 5];
    let sum = || {
        let made = Surface::new(&net, [&chain, &chain], [Ends::Trim; 2]).expect("closed");
        let mut sum = 0.0;
        let each = made.each_row(|row| -> Result<(), ()> {
            sum += row[0];
            Ok(())
        });
        each.map(|()| sum)
    };
    bencher.counter(ItemsCount::new(3200_u64 * 3200)).bench(sum);
}

/// The same result, copied.
#[divan::bench(sample_count = 10)]
fn surface_copy(bencher: Bencher) {
    let values: Vec<f64> = (0..3 * 3200 * 3200).map(wave).collect();
    bencher.counter(ItemsCount::new(values.len() / 3)).bench(|| values.clone());
}

/// Exact, 2-D, 100 points, six levels.
#[divan::bench(sample_count = 10)]
fn exact(bencher: Bencher) {
    let rule = scheme::<Rational>();
    let values = (0..200).map(|i| Rational::from_integer((i * i % 1013).into())).collect();
    let polygon = Polygon::new(2, values, true).expect("points");
    let refined = || refine(&polygon, &[&rule; 6], Ends::Trim).expect("closed");
    bencher.counter(ItemsCount::new(refined().count())).bench(refined);
}
