//! What can be typed about points, and about what is made of them.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{FormatArgument, SchemeArguments};

/// Control points, and how often they are refined.
#[derive(Args, Clone, Debug)]
pub struct PointsArguments {
    /// Control points: a file of CSV, of numbers between blanks, or JSON; - for standard input
    #[arg(value_name = "POINTS", default_value = "-")]
    pub points: PathBuf,
    /// How many times to refine
    #[arg(long, short, value_name = "L", default_value_t = 5)]
    pub levels: u32,
    /// How an open polygon goes on beyond its ends: not at all (the default, but for interproximate), so that
    /// it gets shorter; reflected at them; or extrapolated by polynomials as high as the scheme
    /// reproduces, at most cubic
    #[arg(long, value_enum)]
    pub ends: Option<EndsArgument>,
    /// Where to write it; the end of the name tells the format
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub format: FormatArgument,
}

/// What happens at the ends of what is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EndsArgument {
    /// Only points that the control points determine: the pure scheme
    Trim,
    /// Ghost points 2 f_0 - f_j
    Reflect,
    /// Ghost points on polynomials
    Extrapolate,
}

/// The arguments of `curve`.
#[derive(Args, Debug)]
pub struct CurveArguments {
    /// The scheme.
    #[command(flatten)]
    pub scheme: SchemeArguments,
    /// The points.
    #[command(flatten)]
    pub points: PointsArguments,
    /// The last point is followed by the first
    #[arg(long)]
    pub closed: bool,
    /// Move the points onto the limit curve
    #[arg(long)]
    pub limit: bool,
    /// Draw a curvature comb on the limit curve, for planar curves of schemes that are C^2
    #[arg(long, requires = "output", conflicts_with = "exact")]
    pub comb: bool,
    /// Refine exactly, in rational numbers
    #[arg(long)]
    pub exact: bool,
}

/// The arguments of `surface`.
#[derive(Args, Debug)]
pub struct SurfaceArguments {
    /// The scheme.
    #[command(flatten)]
    pub scheme: SchemeArguments,
    /// The points.
    #[command(flatten)]
    pub points: PointsArguments,
    /// Another scheme from row to row; 'tensor(S, T)' as the scheme says the same of S and T
    #[arg(long, value_name = "SCHEME", allow_hyphen_values = true)]
    pub across: Option<String>,
    /// Set a parameter of the scheme from row to row; repeatable
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub set_across: Vec<String>,
    /// How many points a row has, where no blank lines or brackets tell
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub columns: Option<u32>,
    /// In which directions the net is closed
    #[arg(long, value_enum, default_value_t = Closed::Neither)]
    pub closed: Closed,
    /// Move the points onto the limit surface
    #[arg(long)]
    pub limit: bool,
    /// Refine exactly, in rational numbers
    #[arg(long)]
    pub exact: bool,
}

/// In which directions a net is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Closed {
    /// In none
    Neither,
    /// Each row: its last point is followed by its first
    Rows,
    /// Each column: the last row is followed by the first
    Columns,
    /// In both, like a torus
    Both,
}

/// The arguments of `interproximate`.
#[derive(Args, Debug)]
pub struct InterproximateArguments {
    /// The family.
    #[command(flatten)]
    pub scheme: SchemeArguments,
    /// The points.
    #[command(flatten)]
    pub points: PointsArguments,
    /// Control points that are interpolated, by their numbers from 0. The edge after a point takes its tensions, so
    /// that the order of the points matters
    #[arg(long, value_name = "I,J,…", value_delimiter = ',')]
    pub interpolate: Vec<usize>,
    /// The tensions of points that are interpolated: 'alpha=0,beta=-1/20'
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true, requires = "interpolate")]
    pub interpolating: Option<String>,
    /// The tensions of all other points, and of new ones: 'alpha=1/8,beta=0'
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    pub approximating: Option<String>,
    /// The polygon is closed, or, with --surface, --closed=rows, --closed=columns or --closed=both
    #[arg(
        long,
        value_enum,
        value_name = "DIRECTIONS",
        num_args = 0..=1,
        require_equals = true,
        default_value_t = Closed::Neither,
        default_missing_value = "rows"
    )]
    pub closed: Closed,
    /// The points make up a net
    #[arg(long)]
    pub surface: bool,
    /// How many points a row of the net has, where no blank lines or brackets tell
    #[arg(long, value_name = "N", requires = "surface", value_parser = clap::value_parser!(u32).range(1..))]
    pub columns: Option<u32>,
}
