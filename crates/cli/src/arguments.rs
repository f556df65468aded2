//! What can be typed.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

mod examples;
mod points;

pub use points::{
    Closed, CurveArguments, EndsArgument, InterproximateArguments, PointsArguments,
    SurfaceArguments,
};

/// Exact analysis of families of subdivision schemes
///
/// What is smooth, for which values of a parameter, and what is not: proved from both sides, in exact
/// arithmetic, with certificates that an independent checker reads. Data goes to standard output, everything
/// else to standard error. Exit codes: 0 done, holds, valid; 1 differs, invalid; 2 bad usage or input.
#[derive(Debug, Parser)]
#[command(name = "refinable", version, max_term_width = 100, after_help = examples::REFINABLE)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print a scheme's mask, support and type
    ///
    /// The mask over its support, the support width, and whether the scheme is primal, dual or interpolatory. With -o
    /// the rules as a sketch: old points, new points, and the weights between them.
    #[command(after_help = examples::SHOW)]
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
    ///
    /// A scheme generates degree d if it maps data from polynomials of degree d to such data, and reproduces it if the
    /// polynomials are the same. Over a family the degrees are those for all values first, then the curves and
    /// points on which they rise.
    #[command(after_help = examples::DEGREES)]
    Degrees {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Where C^n holds over one parameter and where it fails, with exact ends, proved from both sides
    ///
    /// The whole line of the one free parameter is divided into what is proved, refuted and undecided; ends are
    /// rational numbers or roots of integer polynomials. With --level only what norms of difference schemes prove, as
    /// in most papers.
    #[command(after_help = examples::RANGE)]
    Range {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// The order n of C^n
        #[arg(long, short = 'n', value_name = "N", value_parser = clap::value_parser!(u16))]
        continuity: u16,
        /// Use norms up to this level only: the exact set that they prove, and nothing refuted
        #[arg(long, value_name = "L", value_parser = clap::value_parser!(u32).range(1..))]
        level: Option<u32>,
        /// How wide, against the length of the range, an undecided gap is to be at an end that cannot be proved exactly; where
        /// proofs would grow too large, it stays wider
        #[arg(long, value_name = "WIDTH", default_value = "1/1000000", conflicts_with = "level")]
        gap: String,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// The Hölder exponent of a scheme, certified; or over one parameter with --sweep
    ///
    /// Exact where the joint spectral radius is known exactly, else between two bounds. It holds for schemes whose basic
    /// limit function has stable integer shifts; for others it is said what remains.
    #[command(after_help = examples::REGULARITY)]
    Regularity {
        #[command(flatten)]
        scheme: SchemeArguments,
        /// Sweep the free parameter over an interval, 'alpha=0..1/16' or 'alpha=0..1/16:64' with a number
        /// of steps
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
    ///
    /// The box of the parameters is cut into convex pieces, and C^n is proved or refuted on each as a whole; what is left
    /// undecided is said, and drawn in red.
    #[command(after_help = examples::MAP)]
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
    ///
    /// The page needs neither a server nor a network. For families of two parameters, one, or none. Maps of long masks take a
    /// minute; a wider --undecided or fewer --nodes make them coarser and faster.
    #[command(after_help = examples::EXPLORE)]
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
    ///
    /// Every point is decided on its own and exactly. With -o the scan is written as it goes, and --resume goes on with one
    /// that was interrupted.
    #[command(after_help = examples::SCAN)]
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
    ///
    /// Points are read as CSV, as numbers between blanks, or as JSON, from a file or from standard input. A mask applied to
    /// values instead of points works as well.
    #[command(after_help = examples::CURVE)]
    Curve(CurveArguments),
    /// Refine a net towards the limit surface; as points, or as a mesh or a picture with -o
    ///
    /// The tensor product of a scheme with itself, or with another one --across. The end of the file's name tells the format:
    /// obj, ply, stl, svg, png, csv, json.
    #[command(after_help = examples::SURFACE)]
    Surface(SurfaceArguments),
    /// The basic limit function and its derivatives, exactly
    ///
    /// The limit for one control value 1 among zeros, at all m-adic points of a level: rational values, from the eigenvectors
    /// of products of matrices.
    #[command(after_help = examples::BASIS)]
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
    ///
    /// Every vertex and every edge takes tensions of its own: from columns of the file, from --interpolating and
    /// --approximating, or chosen as smooth as possible, which takes a minute.
    #[command(after_help = examples::INTERPROXIMATE)]
    Interproximate(InterproximateArguments),
    /// Write a certificate: of C^n over one parameter or at a value, or of the regularity
    ///
    /// The theorem and the lemmas it follows from, in integers, as JSON. docs/certificates.md describes the format, and
    /// all that a checker has to do.
    #[command(after_help = examples::CERTIFY)]
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
    ///
    /// Mask, type, support, degrees, smoothness, shape of limits, and which known scheme it is.
    #[command(after_help = examples::ANALYZE)]
    Analyze {
        #[command(flatten)]
        scheme: SchemeArguments,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// The table with which papers set schemes side by side
    ///
    /// Support width, type, degrees, smoothness and shape of each.
    #[command(after_help = examples::COMPARE)]
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
    ///
    /// Every name with its source; constructions take numbers, parameters, or other schemes.
    #[command(after_help = examples::SCHEMES)]
    Schemes {
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Check scheme files against what they expect: exit code 0 as expected, 1 something differs, 2 unreadable
    ///
    /// docs/scheme-files.md describes the format. What differs is printed with what was expected, what was found, and the
    /// source of the expectation.
    #[command(after_help = examples::CHECK)]
    Check {
        /// The files, *.scheme.toml
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
        #[command(flatten)]
        format: FormatArgument,
    },
    /// Print a scheme file that expects what is found now
    ///
    /// A start for a file of your own: add the source, and take away what you do not vouch for.
    #[command(after_help = examples::EXPECT)]
    Expect {
        #[command(flatten)]
        scheme: SchemeArguments,
    },
    /// Write a scheme as code of another program, or as LaTeX, with exact coefficients
    ///
    /// The parameters, the mask, its symbol and the rules, with the conventions, and how to get to others, in comments.
    #[command(after_help = examples::EXPORT)]
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
    ///
    /// Draft 2020-12, of scheme files seen as JSON.
    #[command(after_help = examples::SCHEMA)]
    Schema,
    /// Print the completions of a shell
    ///
    /// To be sourced, or put where the shell looks for them; the README says where that is.
    #[command(after_help = examples::COMPLETIONS)]
    Completions {
        /// The shell
        #[arg(value_enum, value_name = "SHELL")]
        shell: Shell,
    },
    /// Write manual pages into a directory, one for each command
    ///
    /// Made of the same definitions as the help texts: refinable.1, refinable-range.1 and so on.
    #[command(after_help = examples::MAN)]
    Man {
        /// The directory, made if there is none
        #[arg(value_name = "DIR")]
        dir: PathBuf,
    },
    /// Check certificates: exit code 0 valid, 1 invalid, 2 unreadable
    ///
    /// The checker shares nothing with the search but the arithmetic. Certificates of maps are checked as well.
    #[command(after_help = examples::VERIFY)]
    Verify {
        /// The files
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
    },
    /// The norm of a difference scheme as a formula in the parameters
    ///
    /// The maximum over the rows of sums of absolute values of polynomials; below 1 it proves C^n.
    #[command(after_help = examples::NORM)]
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
    ///
    /// Of Hameed and Mustafa's paper, or of the claims in a file as docs/claims.md describes it. Committed certificates are
    /// checked and used; where there is none that holds, a proof is searched for.
    #[command(after_help = examples::TABLES)]
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
    ///
    /// All tables, figures and maps of the paper with their verdicts, as Markdown, CSV, LaTeX, JSON and SVG; the same bytes on
    /// every machine.
    #[command(after_help = examples::REPORT)]
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
    ///
    /// All of it or, if anything fails, nothing.
    #[command(after_help = examples::REPORT_BUILD)]
    Build {
        /// The directory
        dir: PathBuf,
        #[command(flatten)]
        audit: AuditArguments,
    },
    /// Recompute the report and compare it with DIR; exit code 1 if it differs
    ///
    /// The first line that differs of each file, and files that are missing or too many.
    #[command(after_help = examples::REPORT_CHECK)]
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
    /// The box, 'alpha=-1/4..3/4,beta=-1/2..1/2'; if left out one around what was found of the set, which may be cut where it
    /// is thin or goes on for ever
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
