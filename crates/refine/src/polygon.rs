//! Control polygons and control nets.

use refinable_scheme::Diagnostic;

use crate::coordinate::Coordinate;

/// The largest number of coordinates of a point.
pub const LARGEST_DIMENSION: usize = 64;

/// Points `f_0, …, f_{n-1}` of one dimension; in a closed polygon `f_n` is `f_0` again, and is not
/// repeated.
#[derive(Clone, PartialEq, Debug)]
pub struct Polygon<T> {
    dimension: usize,
    values: Vec<T>,
    closed: bool,
}

impl<T: Coordinate> Polygon<T> {
    /// The polygon whose points follow each other in `values`, coordinate by coordinate.
    ///
    /// # Errors
    /// Code `points` if there is none, or if the values make up no points of this dimension;
    /// `dimension` beyond [`LARGEST_DIMENSION`].
    pub fn new(dimension: usize, values: Vec<T>, closed: bool) -> Result<Self, Diagnostic> {
        check_dimension(dimension)?;
        if values.is_empty() {
            return Err(Diagnostic::new("points", "there is no point"));
        }
        if !values.len().is_multiple_of(dimension) {
            let message = format!("{} numbers are no points of {dimension}", values.len());
            return Err(Diagnostic::new("points", message));
        }
        Ok(Polygon { dimension, values, closed })
    }

    /// How many coordinates a point has.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The coordinates, point after point.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// The points.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &[T]> {
        self.values.chunks_exact(self.dimension)
    }

    /// How many points there are; never none.
    pub fn count(&self) -> usize {
        self.values.len() / self.dimension
    }

    /// Whether the last point is followed by the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }
}

/// Points `f_{ij}`, row `i` after row `j`, all of one dimension, perhaps closed in a direction.
#[derive(Clone, PartialEq, Debug)]
pub struct Net<T> {
    dimension: usize,
    columns: usize,
    values: Vec<T>,
    closed: [bool; 2],
}

/// The direction from row to row.
pub const ACROSS: usize = 0;
/// The direction along a row.
pub const ALONG: usize = 1;

impl<T: Coordinate> Net<T> {
    /// The net whose points follow each other row by row. `closed[ACROSS]`: the last row is followed
    /// by the first; `closed[ALONG]`: the last point of each row is followed by its first.
    ///
    /// # Errors
    /// Code `points` if there is none, or if the values make up no rows; `dimension` beyond
    /// [`LARGEST_DIMENSION`].
    pub fn new(
        dimension: usize,
        columns: usize,
        values: Vec<T>,
        closed: [bool; 2],
    ) -> Result<Self, Diagnostic> {
        check_dimension(dimension)?;
        let row = columns.saturating_mul(dimension);
        if values.is_empty() || row == 0 {
            return Err(Diagnostic::new("points", "there is no point"));
        }
        if !values.len().is_multiple_of(row) {
            let points = values.len() / dimension;
            let message = format!("{points} points are no rows of {columns}");
            let hint = "all rows of a net are as long";
            return Err(Diagnostic::new("points", message).with_hint(hint));
        }
        Ok(Net { dimension, columns, values, closed })
    }

    /// How many coordinates a point has.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// How many points a row has.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.values.len() / (self.dimension * self.columns)
    }

    /// The coordinates, row after row, point after point.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// The point in row `i` and column `j`.
    ///
    /// # Panics
    /// If there is none.
    pub fn point(&self, i: usize, j: usize) -> &[T] {
        &self.values[(i * self.columns + j) * self.dimension..][..self.dimension]
    }

    /// In which directions the net is closed.
    pub fn closed(&self) -> [bool; 2] {
        self.closed
    }

    /// The net with rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let (rows, columns) = (self.rows(), self.columns);
        let points = (0..columns).flat_map(|j| (0..rows).map(move |i| (i, j)));
        let values = points.flat_map(|(i, j)| self.point(i, j).iter().cloned()).collect();
        let closed = [self.closed[ALONG], self.closed[ACROSS]];
        Net { dimension: self.dimension, columns: rows, values, closed }
    }
}

fn check_dimension(dimension: usize) -> Result<(), Diagnostic> {
    if (1..=LARGEST_DIMENSION).contains(&dimension) {
        return Ok(());
    }
    let message = format!("points have {dimension} coordinates");
    let hint = format!("from 1 to {LARGEST_DIMENSION} are possible");
    Err(Diagnostic::new("dimension", message).with_hint(hint))
}
