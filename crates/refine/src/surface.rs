//! Tensor product surfaces.

use rayon::prelude::*;
use refinable_scheme::Diagnostic;

use crate::cascade::{BAND, Cascade};
use crate::coordinate::Coordinate;
use crate::ends::Ends;
use crate::memory;
use crate::polygon::{ACROSS, ALONG, Net};
use crate::weights::Weights;

/// Bands that are in memory at once while rows are handed out.
const BANDS: usize = 8;

/// A refined net whose rows are made when they are asked for.
///
/// A net is a polygon of rows, and a row is a point of many coordinates: its rows are refined along
/// first, to the last level, which is cheap as there are few of them; then the rows are refined across.
pub struct Surface<'a, T> {
    dimension: usize,
    columns: usize,
    closed: [bool; 2],
    across: Cascade<'a, T>,
    /// The rows that are needed, refined along.
    control: Vec<T>,
}

impl<'a, T: Coordinate> Surface<'a, T> {
    /// The surface after the rules `rules[ACROSS]` from row to row and `rules[ALONG]` in each row, the
    /// first of each list first. The lists may be of different lengths.
    ///
    /// # Errors
    /// Those of [`refine`](crate::refine); code `memory` for the control rows alone.
    pub fn new(
        net: &Net<T>,
        rules: [&[&'a Weights<T>]; 2],
        ends: [Ends; 2],
    ) -> Result<Self, Diagnostic> {
        let (dimension, closed) = (net.dimension(), net.closed());
        let cascade = |direction: usize, count| {
            Cascade::new(rules[direction].to_vec(), count, closed[direction], ends[direction])
        };
        let along = cascade(ALONG, net.columns())?;
        let across = cascade(ACROSS, net.rows())?;
        let rows = across.control();
        let values = (along.count() as u64).saturating_mul((rows.end - rows.start) as u64);
        memory::check(rules[ALONG], values.saturating_mul(dimension as u64))?;
        let width = along.count() * dimension;
        let refined = net.values().par_chunks(net.columns() * dimension).map(|row| {
            let needed = along.control();
            let control = ends[ALONG].extend(row, dimension, closed[ALONG], &needed);
            along.descend(&control, dimension)
        });
        let refined = refined.flatten_iter().collect::<Vec<T>>();
        let control = ends[ACROSS].extend(&refined, width, closed[ACROSS], &rows);
        Ok(Surface { dimension, columns: along.count(), closed, across, control })
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.across.count()
    }

    /// How many points a row has.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// How many coordinates a point has.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// In which directions it is closed.
    pub fn closed(&self) -> [bool; 2] {
        self.closed
    }

    /// Hands out all rows in their order, a few bands of them in memory at a time.
    ///
    /// # Errors
    /// The first error of `sink`.
    pub fn each_row<E>(&self, mut sink: impl FnMut(&[T]) -> Result<(), E>) -> Result<(), E> {
        let width = self.columns * self.dimension;
        let most = BANDS * BAND;
        let mut bands = vec![T::origin(); self.rows().min(most) * width];
        for start in (0..self.rows()).step_by(most) {
            bands.truncate((self.rows() - start) * width);
            bands.par_chunks_mut(BAND * width).enumerate().for_each(|(k, band)| {
                let first = self.across.last().start + (start + k * BAND) as i64;
                let last = first + (band.len() / width) as i64;
                self.across.block(&self.control, width, &(first..last), band);
            });
            bands.chunks_exact(width).try_for_each(&mut sink)?;
        }
        Ok(())
    }

    /// The whole net.
    ///
    /// # Errors
    /// Code `memory` if it is too large.
    pub fn net(&self) -> Result<Net<T>, Diagnostic> {
        let width = self.columns * self.dimension;
        memory::check(self.across.rules(), (self.rows() as u64).saturating_mul(width as u64))?;
        let values = self.across.descend(&self.control, width);
        Net::new(self.dimension, self.columns, values, self.closed)
    }
}

/// The net after some levels of a tensor product scheme: [`Surface::net`] of [`Surface::new`].
///
/// # Errors
/// Theirs.
pub fn refine_net<T: Coordinate>(
    net: &Net<T>,
    rules: [&[&Weights<T>]; 2],
    ends: [Ends; 2],
) -> Result<Net<T>, Diagnostic> {
    Surface::new(net, rules, ends)?.net()
}
