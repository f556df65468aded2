//! Tables of points: floats and exact numbers make the same table, and exact ones are printed and read
//! again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use refinable_algebra::Rational;
use refinable_refine::{Coordinate, PointTable};

fuzz_target!(|text: &str| {
    let exact = PointTable::<Rational>::parse(text);
    if let Ok(table) = &exact {
        assert_eq!(table.rows.iter().sum::<usize>() * table.dimension, table.values.len());
        for x in &table.values {
            assert_eq!(Rational::parse(&x.text()).as_ref(), Some(x));
        }
    }
    // One kind may refuse what the other reads: numbers beyond all floats, or with powers beyond 10^400.
    if let (Ok(floats), Ok(exact)) = (PointTable::<f64>::parse(text), exact) {
        assert_eq!((floats.dimension, floats.rows), (exact.dimension, exact.rows));
    }
});
