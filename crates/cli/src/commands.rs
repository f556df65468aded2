//! One function for each command.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use indicatif::ProgressBar;
use refinable_algebra::{parse_rational, rational};
use refinable_analysis::{Budget, Fineness, Map, Options, Sharpness, continuity_at, regularity};
use refinable_certificate::Certificate;
use refinable_papers::{Claims, Paper, Table};
use refinable_report::{
    Audit, CERTIFICATES, CertificateStore, Checked, Effort, Explorer, ExplorerOptions, FamilyMaps,
    HolderMap, Language, MapStore, Maps, Quantity, Scan, Site, Sweep, analyze, any_range_table,
    check, check_json, compare, degree_table, expected_file, export, norm_table, range_table,
    regularity_table, report_site, rule_picture, schemes, sharp_range, show,
};
use refinable_scheme::{Diagnostic, Scheme, SchemeFile, Substitution};

use crate::arguments::{
    Arguments, AuditArguments, Command, FinenessArguments, Format, FormatArgument, MapArguments,
    Mapped, ReportAction, SchemeArguments, Target, What,
};
use crate::failure::Failure;
use crate::files::Image;
use crate::{drawing, files, manual, output, scanning, verifying};

/// Runs the command that was typed.
///
/// # Errors
/// Anything wrong with the input; nothing has been written then.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    match &arguments.command {
        Command::Show { scheme, derive: true, format, .. } => derive(scheme, *format)?,
        Command::Show { scheme, output: Some(path), .. } => {
            let image = Image::of(path)?;
            image.write(path, &rule_picture(&resolve(scheme)?))?;
        }
        Command::Show { scheme, format, .. } => {
            output::print(&show(&resolve(scheme)?), format.format)?;
        }
        Command::Degrees { scheme, format } => {
            output::print(&degree_table(&resolve(scheme)?), format.format)?;
        }
        Command::Range { scheme, continuity, level, gap, format } => {
            let scheme = resolve(scheme)?;
            let continuity = usize::from(*continuity);
            let document = match level {
                Some(level) => range_table(&scheme, continuity, *level, Budget::default())?,
                None => any_range_table(&scheme, continuity, &sharpness(gap)?)?,
            };
            output::print(&document, format.format)?;
        }
        Command::Regularity { scheme, sweep: Some(sweep), output, format } => {
            let picture = picture(output.as_deref())?;
            let scheme = resolve(scheme)?;
            let sweep = Sweep::new(&scheme, sweep, &Options::default())?;
            if let Some((path, image)) = picture {
                image.write(path, &sweep.picture())?;
            }
            output::print(&sweep.document(), format.format)?;
        }
        Command::Regularity { scheme, sweep: None, format, .. } => {
            let scheme = resolve(scheme)?;
            let found = regularity(scheme.name(), scheme.mask(), &Options::default())?;
            output::print(&regularity_table(&scheme, &found), format.format)?;
        }
        Command::Map { scheme, map, drawing, certificate, format }
            if map.what == Mapped::Holder =>
        {
            let curves = drawing.curves.is_empty() && drawing.marks.is_empty();
            if map.continuity.is_some() || certificate.is_some() || !curves {
                let message =
                    "--continuity, --certificate, --curve and --mark are for --what continuity";
                let hint = "leave them out, or leave out --what holder";
                return Err(Failure::new("usage", message, hint));
            }
            let picture = picture(drawing.output.as_deref())?;
            let holder = HolderMap::new(&resolve(scheme)?, map.fineness.window.as_deref())?;
            if let Some((path, image)) = picture {
                image.write(path, &holder.picture())?;
            }
            output::print(&holder.document(), format.format)?;
        }
        Command::Map { scheme, map, drawing, certificate, format } => {
            let picture = picture(drawing.output.as_deref())?;
            let fineness = fineness(&map.fineness)?;
            let scheme = resolve(scheme)?;
            let orders = orders(map)?;
            let maps = Maps::new(&scheme, orders, map.fineness.window.as_deref(), &fineness)?;
            if let Some((path, image)) = picture {
                image.write(path, &maps.picture(&drawing.curves, &drawing.marks)?)?;
            }
            if let Some(path) = certificate {
                let text = format!("{}\n", only_map(&maps)?.certificate.to_json());
                files::write_file(path, text.as_bytes())?;
            }
            output::print(&maps.document(), format.format)?;
        }
        Command::Explore { scheme, fineness, output } => explore(scheme, fineness, output)?,
        Command::Scan { scheme, grid, what, continuity, level, json_lines, output, resume } => {
            let quantity = match what {
                What::Continuity => Quantity::Continuity,
                What::Holder => Quantity::Holder,
                What::Generation => Quantity::Generation,
                What::Reproduction => Quantity::Reproduction,
                What::Norm => {
                    Quantity::Norm { continuity: usize::from(*continuity), level: *level }
                }
            };
            let SchemeArguments { scheme: name, set, arity } = scheme;
            let version = env!("CARGO_PKG_VERSION");
            let signature = format!(
                "{version}: {name} {set:?} arity {arity}, {grid}, {quantity:?}, lines {json_lines}\n"
            );
            let scan = Scan::new(&resolve(scheme)?, grid, quantity)?;
            scanning::write(&scan, &signature, output.as_deref(), *json_lines, *resume)?;
        }
        Command::Curve(arguments) => drawing::curve(arguments)?,
        Command::Surface(arguments) => drawing::surface(arguments)?,
        Command::Basis { scheme, levels, derivatives, output, format } => {
            let order = derivatives.map(usize::from);
            drawing::basis(&resolve(scheme)?, *levels, order, output.as_deref(), format.format)?;
        }
        Command::Interproximate(arguments) => drawing::interproximate(arguments)?,
        Command::Certify { scheme, continuity, output } => {
            let certificate = certify(&resolve(scheme)?, *continuity)?;
            write_text(output.as_deref(), &format!("{}\n", certificate.to_json()))?;
        }
        Command::Analyze { scheme, format } => {
            output::print(&analyze(&resolve(scheme)?), format.format)?;
        }
        Command::Schemes { format } => output::print(&schemes(), format.format)?,
        Command::Compare { schemes, arity, format } => {
            let resolved = schemes.iter().map(|text| resolve_text(text, *arity, &[]));
            output::print(&compare(&resolved.collect::<Result<Vec<_>, _>>()?), format.format)?;
        }
        Command::Check { files, format } => return check_files(files, format.format),
        Command::Expect { scheme } => output::print_text(&expected_file(&resolve(scheme)?))?,
        Command::Export { scheme, to, output } => {
            let language = match to {
                Target::Sympy => Language::SymPy,
                Target::Mathematica => Language::Mathematica,
                Target::Maple => Language::Maple,
                Target::Matlab => Language::Matlab,
                Target::Latex => Language::Latex,
            };
            let code = export(&resolve(scheme)?, &scheme.set, language);
            write_text(output.as_deref(), &code)?;
        }
        Command::Schema => output::print_text(&SchemeFile::json_schema())?,
        Command::Completions { shell } => output::print_text(&manual::completions(*shell))?,
        Command::Man { dir } => {
            files::expect_directory(dir, true)?;
            files::write_site(dir, &manual::pages())?;
        }
        Command::Verify { files } => return verifying::run(files),
        Command::Norm { scheme, continuity, level, format } => {
            let scheme = resolve(scheme)?;
            let document =
                norm_table(&scheme, usize::from(*continuity), *level, Budget::default())?;
            output::print(&document, format.format)?;
        }
        Command::Tables { audit, claims, tables, format } => {
            let all = match claims {
                Some(path) => read_claims(path)?,
                None => Paper::builtin()?.tables,
            };
            let known = known_certificates(audit)?;
            let audit = run_audit(&select(all, tables)?, audit, known)?;
            output::print(&audit.document(), format.format)?;
        }
        Command::Report { action } => return report(action),
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes text to a file, or prints it.
fn write_text(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match path {
        Some(path) => files::write_file(path, text.as_bytes()),
        None => output::print_text(text),
    }
}

/// The scheme that was typed, with what was set.
///
/// # Errors
/// Whatever is wrong with it.
pub fn resolve(arguments: &SchemeArguments) -> Result<Scheme, Failure> {
    resolve_text(&arguments.scheme, arguments.arity, &arguments.set)
}

/// The scheme that a text means, after settings.
///
/// # Errors
/// Whatever is wrong with it.
pub fn resolve_text(text: &str, arity: u32, set: &[String]) -> Result<Scheme, Failure> {
    let mut substitutions = Vec::new();
    for text in set {
        substitutions.push(Substitution::parse(text)?);
    }
    if text.ends_with(SCHEME_FILE) {
        return Ok(read_scheme(Path::new(text))?.0.scheme.with(&substitutions)?);
    }
    Ok(Scheme::resolve_with(text, arity as usize, &substitutions)?)
}

/// How the names of scheme files end.
const SCHEME_FILE: &str = ".toml";

/// The scheme of a file, and its text for errors that point into it.
fn read_scheme(path: &Path) -> Result<(SchemeFile, String), Failure> {
    let text = files::read_text(path, "docs/scheme-files.md describes the format")?;
    match SchemeFile::parse(&text) {
        Ok(file) => Ok((file, text)),
        Err(error) => Err(error.in_file(&path.display().to_string(), &text).into()),
    }
}

/// Checks one file after the other; exit code 1 if something differs.
fn check_files(paths: &[PathBuf], format: Format) -> Result<ExitCode, Failure> {
    let mut differs = false;
    let mut documents = Vec::new();
    for path in paths {
        let (file, text) = read_scheme(path)?;
        let in_file = |error: Diagnostic| error.in_file(&path.display().to_string(), &text);
        let checked = check(&file).map_err(in_file)?;
        let missed: Vec<&Checked> = checked.iter().filter(|c| !c.holds()).collect();
        differs |= !missed.is_empty();
        if format == Format::Json {
            documents.push((file.scheme.name().to_string(), checked));
            continue;
        }
        let mut text = format!(
            "{}: {} of {} as expected\n",
            path.display(),
            checked.len() - missed.len(),
            checked.len()
        );
        for c in missed {
            let source =
                c.source.as_ref().map_or_else(String::new, |source| format!(" ({source})"));
            text.push_str(&format!("  {}{source}\n  - {}\n  + {}\n", c.what, c.expected, c.found));
        }
        output::print_text(&text)?;
    }
    if format == Format::Json {
        output::print_text(&check_json(&documents))?;
    }
    Ok(ExitCode::from(u8::from(differs)))
}

/// Where a picture goes, and how: asked before work that takes long.
fn picture(path: Option<&Path>) -> Result<Option<(&Path, Image)>, Failure> {
    path.map(|path| Ok((path, Image::of(path)?))).transpose()
}

/// Writes the page of an explorer.
fn explore(
    arguments: &SchemeArguments,
    fineness: &FinenessArguments,
    path: &Path,
) -> Result<(), Failure> {
    if path.extension().is_none_or(|end| !end.eq_ignore_ascii_case("html")) {
        let message = format!("{} does not end in .html", path.display());
        return Err(Failure::new("page", message, "the explorer is a page, for example a5.html"));
    }
    let scheme = resolve(arguments)?;
    let options = ExplorerOptions {
        words: arguments.words(),
        window: fineness.window.clone(),
        fineness: self::fineness(fineness)?,
    };
    let spinner = spinner();
    let explorer = Explorer::new(&scheme, &options, &|step| spinner.set_message(step.to_string()));
    spinner.finish_and_clear();
    files::write_file(path, explorer?.page().as_bytes())
}

fn orders(arguments: &MapArguments) -> Result<&str, Failure> {
    arguments.continuity.as_deref().ok_or_else(|| {
        let hint = "for example --continuity 2 or --continuity 0..5";
        Failure::new("continuity", "which C^n is to be mapped?", hint)
    })
}

/// How fine a map is to be.
///
/// # Errors
/// A part that is no number between 0 and 1.
pub fn fineness(arguments: &FinenessArguments) -> Result<Fineness, Failure> {
    let part = parse_rational(&arguments.undecided);
    let Some(undecided) = part.filter(|x| *x > rational(0, 1) && *x < rational(1, 1)) else {
        let hint = "give a number between 0 and 1, for example --undecided 1/160";
        return Err(Failure::new("undecided", "the part is not such a number", hint));
    };
    Ok(Fineness { undecided, nodes: arguments.nodes as usize })
}

fn only_map(maps: &Maps) -> Result<&Map, Failure> {
    let [map] = &maps.maps[..] else {
        let hint = "give one order: --continuity N";
        return Err(Failure::new("continuity", "a certificate is about one order", hint));
    };
    Ok(map)
}

/// How sharp a range is to be.
///
/// # Errors
/// A gap that is no number between 0 and 1/2.
pub fn sharpness(gap: &str) -> Result<Sharpness, Failure> {
    let gap = parse_rational(gap).filter(|gap| *gap > rational(0, 1) && *gap < rational(1, 2));
    let Some(gap) = gap else {
        let hint = "give a positive number below 1/2, for example --gap 1/1000000";
        return Err(Failure::new("gap", "the gap is not such a number", hint));
    };
    let spectral = Options { gap, ..Options::default() };
    Ok(Sharpness { spectral, ..Sharpness::default() })
}

fn certify(scheme: &Scheme, continuity: Option<u16>) -> Result<Certificate, Failure> {
    let Some(continuity) = continuity else {
        let found = regularity(scheme.name(), scheme.mask(), &Options::default())?;
        return found.certificate.ok_or_else(|| {
            let hint = "without stable shifts only a lower bound holds; try -n N";
            Failure::new(
                "stability",
                "the shifts of the basic limit function are not shown to be stable",
                hint,
            )
        });
    };
    let (continuity, sharpness) = (usize::from(continuity), Sharpness::default());
    if scheme.mask().parameters().is_empty() {
        return Ok(continuity_at(scheme.name(), scheme.mask(), continuity, &sharpness)?.1);
    }
    Ok(sharp_range(scheme, continuity, &sharpness)?.certificate)
}

fn derive(arguments: &SchemeArguments, format: FormatArgument) -> Result<(), Failure> {
    if format.format != Format::Text {
        let hint = "leave out --format, or leave out --derive";
        return Err(Failure::new("format", "a derivation is printed as text only", hint));
    }
    let scheme = resolve(arguments)?;
    let Some(derivation) = scheme.derivation() else {
        let hint = "a2 a4 …, a3 a5 … and i4 i6 … are derived step by step, with no parameter set";
        let message = format!("{} is given by its mask, not by a derivation", scheme.name());
        return Err(Failure::new("derivation", message, hint));
    };
    // What is printed has been recomputed from the recorded steps, each from the ones before.
    derivation.replay()?;
    output::print_text(&format!("{derivation}\n"))
}

fn read_claims(path: &Path) -> Result<Vec<Table>, Failure> {
    Ok(Claims::parse(&files::read_text(path, "docs/claims.md describes the format")?)?)
}

fn select(all: Vec<Table>, ids: &[String]) -> Result<Vec<Table>, Failure> {
    if let Some(unknown) = ids.iter().find(|id| all.iter().all(|table| table.id != **id)) {
        let known: Vec<&str> = all.iter().map(|table| table.id.as_str()).collect();
        let hint = format!("the tables are {}", known.join(", "));
        return Err(Failure::new("table", format!("there is no table `{unknown}`"), hint));
    }
    Ok(all.into_iter().filter(|t| ids.is_empty() || ids.contains(&t.id)).collect())
}

fn known_certificates(arguments: &AuditArguments) -> Result<CertificateStore, Failure> {
    if arguments.fresh {
        Ok(CertificateStore::new())
    } else {
        files::certificates(&arguments.certificates)
    }
}

/// Audits with a progress bar.
fn run_audit(
    tables: &[Table],
    arguments: &AuditArguments,
    known: CertificateStore,
) -> Result<Audit, Failure> {
    let cells: usize = tables.iter().map(|table| table.cells.len()).sum();
    let bar = output::progress_bar(cells as u64, "cells");
    let effort = Effort { level: arguments.level, budget: Budget::default() };
    let audit = Audit::new(tables, effort, known, &|| bar.inc(1));
    bar.finish_and_clear();
    Ok(audit?)
}

/// What is being worked on, on a terminal; nothing elsewhere.
fn spinner() -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let spinner = ProgressBar::new_spinner();
    spinner.enable_steady_tick(Duration::from_millis(100));
    spinner
}

fn report(action: &ReportAction) -> Result<ExitCode, Failure> {
    let (ReportAction::Build { dir, audit } | ReportAction::Check { dir, audit }) = action;
    let paper = Paper::builtin()?;
    files::expect_directory(dir, matches!(action, ReportAction::Build { .. }))?;
    let measured = files::measurements(dir)?;
    // Certificates that hold need not be searched for again; those that do not are.
    let (mut known, mut maps) = (CertificateStore::new(), MapStore::new());
    if !audit.fresh {
        for dir in [&audit.certificates, &dir.join(CERTIFICATES)] {
            known.extend(files::certificates(dir)?);
            maps.extend(files::map_certificates(dir)?);
        }
    }
    let audited = run_audit(&paper.tables, audit, known)?;
    let bar = output::progress_bar(FamilyMaps::count()? as u64, "maps");
    let families = FamilyMaps::all(&paper.tables, &maps, &|| bar.inc(1));
    bar.finish_and_clear();
    let site: Site = report_site(&paper, &audited, &families?, measured.as_ref())?;
    if let ReportAction::Build { .. } = action {
        files::write_site(dir, &site)?;
        output::say(&format!("{} files written to {}\n", site.len(), dir.display()));
        return Ok(ExitCode::SUCCESS);
    }
    let differences = files::differences(dir, &site)?;
    if differences.is_empty() {
        output::say(&format!("{}: {} files, none differs\n", dir.display(), site.len()));
        return Ok(ExitCode::SUCCESS);
    }
    output::print_text(&format!("{}\n", differences.join("\n")))?;
    Ok(ExitCode::from(1))
}
