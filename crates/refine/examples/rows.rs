//! A surface that does not fit into memory, row by row: eight levels on a net of 100 × 100.
//!
//! `cargo run --release -p refinable-refine --example rows` prints how many points there were, and their bounds.

use refinable_refine::{Ends, Net, Surface, Weights};
use refinable_scheme::Scheme;

fn main() {
    let scheme = Scheme::resolve("bspline3", 2).expect("a name of the catalogue");
    let rule = Weights::<f64>::new(scheme.mask()).expect("no parameters");
    let height = |i: usize, j: usize| ((i * i + 3 * j) % 17) as f64;
    let point = |k: usize| [(k / 100) as f64, (k % 100) as f64, height(k / 100, k % 100)];
    let net = Net::new(3, 100, (0..10_000).flat_map(point).collect(), [true; 2]).expect("points");
    let chain = [&rule; 8];
    let surface = Surface::new(&net, [&chain, &chain], [Ends::Trim; 2]).expect("closed");
    let (mut points, mut low, mut high) = (0_u64, f64::INFINITY, f64::NEG_INFINITY);
    let each = surface.each_row(|row| -> Result<(), ()> {
        points += row.len() as u64 / 3;
        for z in row.iter().skip(2).step_by(3) {
            (low, high) = (low.min(*z), high.max(*z));
        }
        Ok(())
    });
    each.expect("nothing stops it");
    println!("{points} points, heights from {low:.6} to {high:.6}");
}
