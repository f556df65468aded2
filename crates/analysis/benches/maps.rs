//! Maps over two parameters: `cargo bench -p refinable-analysis --bench maps`.

use divan::Bencher;
use refinable_analysis::{Fineness, default_window, map};
use refinable_scheme::Scheme;

fn main() {
    divan::main();
}

/// The whole of `refinable map SCHEME -n N` but for printing: the box, the search, the check. With more
/// nodes less is undecided; the time of one should not change.
#[divan::bench(args = [("a3", 0, 8000), ("a3", 1, 8000), ("a5", 3, 1000), ("a5", 3, 2000)], sample_count = 3)]
fn maps(bencher: Bencher, (name, continuity, nodes): (&str, usize, usize)) {
    let scheme = Scheme::resolve(name, 2).expect("a name of the catalogue");
    let fineness = Fineness { nodes, ..Fineness::default() };
    bencher.bench(|| {
        let window = default_window(name, scheme.mask(), continuity).expect("two parameters");
        map(name, scheme.mask(), continuity, &window, &fineness).expect("a map")
    });
}
