//! What can be typed.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

mod points;

pub use points::{
    Closed, CurveArguments, EndsArgument, InterproximateArguments, PointsArguments,
    SurfaceArguments,
};

/// Exact analysis of subdivision schemes.
#[derive(Debug, Parser)]
#[command(name = "refinable", version, about, max_term_width = 100)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print a scheme's mask, support and type
    Show {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// Write a sketch of the rules, SVG or PNG
        #[arg(long, short, value_name = "FILE", conflicts_with = "derive")]
        output: Option<PathBuf>,
        /// Print the derivation step by step (schemes a2, a3, …, i4, …)
        #[arg(long)]
        derive: bool,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Degrees of polynomial generation and reproduction, for all parameter values
    Degrees {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Where C^n holds over one parameter and where it fails, with exact ends, proved from both sides
    Range {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// The order n of C^n
        #[arg(long, short = 'n', value_name = "N", value_parser = clap::value_parser!(u16))]
        continuity: u16,
        /// Use norms up to this level only: the exact set that they prove, and nothing refuted
        #[arg(long, value_name = "L", value_parser = clap::value_parser!(u32).range(1..))]
        level: Option<u32>,
        /// How wide, against the length of the range, an undecided gap at an end may be where the end
        /// cannot be proved exactly
        #[arg(long, value_name = "WIDTH", default_value = "1/1000000", conflicts_with = "level")]
        gap: String,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// The Hölder exponent of a scheme, certified; or over one parameter with --sweep
    Regularity {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// Sweep the free parameter over an interval, 'alpha=0..1/16' or 'alpha=0..1/16:64' with a number
        /// of steps; prints CSV unless another format is asked for
        #[arg(long, value_name = "NAME=FROM..TO[:STEPS]", allow_hyphen_values = true)]
        sweep: Option<String>,
        /// Write the sweep as a picture, SVG or PNG
        #[arg(long, short, value_name = "FILE", requires = "sweep")]
        output: Option<PathBuf>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Where C^n holds over two parameters and where it fails, proved piece by piece; or how the Hölder
    /// exponent runs, with --what holder
    Map {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        map: MapArguments,
        #[command(flatten)]
        drawing: DrawingArguments,
        /// Write the certificate of the map, of a single order
        #[arg(long, value_name = "FILE.json")]
        certificate: Option<PathBuf>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Write a page to explore a family: certified smoothness and degrees at every point, and live curves; it
    /// opens from disk
    Explore {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        fineness: FinenessArguments,
        /// Where to write it
        #[arg(long, short, value_name = "FILE.html")]
        output: PathBuf,
    },
    /// A quantity at every point of a grid over two parameters, as CSV or JSON lines
    Scan {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// The grid, with numbers of steps: 'alpha=0..1/8:200,beta=-1/10..0:200'
        #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
        grid: String,
        /// What to find at every point
        #[arg(long, value_enum, default_value_t = What::Continuity)]
        what: What,
        /// The order n of the norm
        #[arg(long, short = 'n', value_name = "N", default_value_t = 0)]
        continuity: u16,
        /// The level of the norm
        #[arg(long, value_name = "L", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
        level: u32,
        /// One JSON object in each line
        #[arg(long)]
        json_lines: bool,
        /// Where to write it; to standard output if left out
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
        /// Go on with a scan of the same command that was interrupted
        #[arg(long, requires = "output")]
        resume: bool,
    },
    /// Refine a polygon towards the limit curve; as points, or as a picture with -o
    Curve(CurveArguments),
    /// Refine a net towards the limit surface; as points, or as a mesh or a picture with -o
    Surface(SurfaceArguments),
    /// The basic limit function and its derivatives, exactly
    Basis {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// Values at all multiples of 1/2^L, or of 1/m^L for arity m
        #[arg(long, short, value_name = "L", default_value_t = 5)]
        levels: u32,
        /// The highest derivative; up to the second, as far as it is continuous, if left out
        #[arg(long, value_name = "N")]
        derivatives: Option<u16>,
        /// Write a picture, SVG or PNG, or the values, CSV or JSON
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Refine a polygon or a net so that some points are interpolated and the others approximated
    Interproximate(InterproximateArguments),
    /// Write a certificate: of C^n over one parameter or at a value, or of the regularity
    Certify {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// Certify where C^n holds and fails; without it, the regularity
        #[arg(long, short = 'n', value_name = "N", value_parser = clap::value_parser!(u16))]
        continuity: Option<u16>,
        /// Where to write it; to standard output if left out
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Everything about one scheme on one page
    Analyze {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// The table with which papers set schemes side by side
    Compare {
        /// The schemes, each as for other commands
        #[arg(value_name = "SCHEME", required = true)]
        schemes: Vec<String>,
        /// The arity of inline masks and symbols
        #[arg(long, value_name = "M", default_value_t = 2, value_parser = clap::value_parser!(u32).range(2..=64))]
        arity: u32,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// The schemes that have names, and the constructions
    Schemes {
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Check scheme files against what they expect: exit code 0 as expected, 1 something differs, 2 unreadable
    Check {
        /// The files, *.scheme.toml
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Print a scheme file that expects what is found now
    Expect {
        #[command(flatten)]
        scheme: SchemeArguments,
    },
    /// Write a scheme as code of another program, or as LaTeX, with exact coefficients
    Export {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// The language
        #[arg(long, value_enum, value_name = "LANGUAGE")]
        to: Target,
        /// Where to write it; to standard output if left out
        #[arg(long, short, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print the JSON Schema of scheme files, for editors
    Schema,
    /// Check certificates: exit code 0 valid, 1 invalid, 2 unreadable
    Verify {
        /// The files
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
    },
    /// The norm of a difference scheme as a formula in the parameters
    Norm {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// The order n of C^n that the norm decides
        #[arg(long, short = 'n', value_name = "N", value_parser = clap::value_parser!(u16))]
        continuity: u16,
        /// The level L: L steps of refinement at once
        #[arg(long, value_name = "L", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
        level: u32,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Rebuild a paper's tables and give a verdict on every cell
    Tables {
        #[command(flatten)]
        audit: AuditArguments,
        /// Claims to check instead of the built-in paper's
        #[arg(long, value_name = "FILE")]
        claims: Option<PathBuf>,
        /// Only this table; may be repeated
        #[arg(long = "table", value_name = "ID")]
        tables: Vec<String>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Write or check a report directory
    Report {
        /// What to do with it.
        #[command(subcommand)]
        action: ReportAction,
    },
}

/// What can be done with a report directory.
#[derive(Debug, Subcommand)]
pub enum ReportAction {
    /// Write the report into DIR; files written by hand are left alone
    Build {
        /// The directory
        dir: PathBuf,
        #[command(flatten)]
        audit: AuditArguments,
    },
    /// Recompute the report and compare it with DIR; exit code 1 if it differs
    Check {
        /// The directory
        dir: PathBuf,
        #[command(flatten)]
        audit: AuditArguments,
    },
}

/// How much work an audit may do.
#[derive(Args, Clone, Debug)]
pub struct AuditArguments {
    /// Certificates to use where they hold, instead of searching for proofs; ignored if there is no
    /// such directory
    #[arg(long, value_name = "DIR", default_value = "reports/certificates")]
    pub certificates: PathBuf,
    /// Search for all proofs afresh, which takes minutes
    #[arg(long)]
    pub fresh: bool,
    /// The highest level of the norms
    #[arg(long, value_name = "L", default_value_t = 6, value_parser = clap::value_parser!(u32).range(1..))]
    pub level: u32,
}

/// A scheme with some of its parameters set.
#[derive(Args, Debug)]
pub struct SchemeArguments {
    /// A name such as a4, a5, i4, dd6, bspline3; a construction such as 'pseudo(4, 1)' or 'smooth(dd4, 2)'; a file
    /// *.scheme.toml; a mask such as '[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]'; rules such as 'even: [a, 1-2a, a];
    /// odd: [1/2, 1/2]'; or a symbol such as '1/8*z^-2*(1+z)^4'
    #[arg(value_name = "SCHEME", allow_hyphen_values = true)]
    pub scheme: String,
    /// Set a parameter, exactly: alpha=1/8, beta=0.05, 'beta=(8*alpha-1)/(16*(1-alpha))'; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    /// The arity of an inline mask or symbol
    #[arg(long, value_name = "M", default_value_t = 2, value_parser = clap::value_parser!(u32).range(2..=64))]
    pub arity: u32,
}

impl SchemeArguments {
    /// The words by which the scheme was named, to be used in further commands.
    pub fn words(&self) -> Vec<String> {
        let mut words = vec![self.scheme.clone()];
        for setting in &self.set {
            words.extend(["--set".into(), setting.clone()]);
        }
        if self.arity != 2 {
            words.extend(["--arity".into(), self.arity.to_string()]);
        }
        words
    }
}

/// The languages to which schemes are exported.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Target {
    /// Python with SymPy
    Sympy,
    /// The Wolfram Language
    Mathematica,
    /// Maple
    Maple,
    /// MATLAB with its Symbolic Math Toolbox; plain MATLAB or Octave if there is no parameter
    Matlab,
    /// Formulas in LaTeX, for amsmath
    Latex,
}

/// Which map, and how fine.
#[derive(Args, Clone, Debug)]
pub struct MapArguments {
    /// What to map
    #[arg(long, value_enum, default_value_t = Mapped::Continuity)]
    pub what: Mapped,
    /// The order n of C^n, or several: 2, 0..5
    #[arg(long, short = 'n', value_name = "N[..M]")]
    pub continuity: Option<String>,
    #[command(flatten)]
    pub fineness: FinenessArguments,
}

/// Which box is mapped, and how finely.
#[derive(Args, Clone, Debug)]
pub struct FinenessArguments {
    /// The box, 'alpha=-1/4..3/4,beta=-1/2..1/2'; one that shows the set if left out
    #[arg(long = "box", value_name = "BOX", allow_hyphen_values = true)]
    pub window: Option<String>,
    /// Which part of the proved area may be left undecided
    #[arg(long, value_name = "PART", default_value = "1/160")]
    pub undecided: String,
    /// Cut nothing any more beyond this number of nodes, undecided or not
    #[arg(long, value_name = "N", default_value_t = 8000, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub nodes: u32,
}

/// What to draw.
#[derive(Args, Clone, Debug)]
pub struct DrawingArguments {
    /// Write the map as a picture, SVG or PNG
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Draw a curve over the map, 'beta=(8*alpha-1)/(16*(1-alpha))'; repeatable
    #[arg(long = "curve", value_name = "NAME=EXPRESSION", requires = "output")]
    pub curves: Vec<String>,
    /// Mark a point of the map, 'alpha=1/10,beta=-49/1152'; repeatable
    #[arg(long = "mark", value_name = "POINT", requires = "output")]
    pub marks: Vec<String>,
}

/// What a map shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Mapped {
    /// Where C^n is proved and refuted
    Continuity,
    /// The Hölder exponent, approximately, and the smoothest members, proved
    Holder,
}

/// What a scan finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum What {
    /// The largest n for which C^n is proved, and whether the next is refuted
    Continuity,
    /// Bounds for the Hölder exponent
    Holder,
    /// The degree of polynomial generation
    Generation,
    /// The degree of polynomial reproduction
    Reproduction,
    /// The norm of a difference scheme
    Norm,
}

/// How to print.
#[derive(Args, Clone, Copy, Debug)]
pub struct FormatArgument {
    /// The output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// The output formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables for the terminal
    Text,
    /// JSON with exact numbers as text
    Json,
    /// Comma-separated values
    Csv,
    /// Markdown
    Md,
    /// LaTeX with booktabs
    Latex,
}
