//! Scans that may be interrupted at any moment and go on.
//!
//! Rows are appended to `FILE.part`, in their order; `FILE.scan` says which scan it is. At the end the
//! part becomes the file. Whatever was written of a last row that is not whole is cut off.

use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;
use refinable_report::Scan;

use crate::failure::Failure;
use crate::{files, output};

/// Points that are in memory at once.
const CHUNK: u64 = 2048;

/// Writes all rows to a file, or to standard output.
///
/// # Errors
/// A file that cannot be written; what is there already is kept and can be continued.
pub fn write(
    scan: &Scan,
    signature: &str,
    path: Option<&Path>,
    json: bool,
    resume: bool,
) -> Result<(), Failure> {
    let bar = output::progress_bar(scan.count(), "points");
    let Some(path) = path else {
        if !json {
            output::print_text(&scan.header())?;
        }
        return rows(scan, 0, json, &bar, output::print_text);
    };
    let path = &files::target(path)?;
    let (part, note) = (beside(path, "part"), beside(path, "scan"));
    let done = if resume { continued(&part, &note, signature, json)? } else { None };
    let (mut file, from) = match done {
        Some((file, rows)) => (file, rows),
        None => (begun(&part, &note, signature, scan, json)?, 0),
    };
    if from > scan.count() {
        let hint = format!("remove {} and start again", part.display());
        return Err(Failure::new("resume", "there are more rows than points", hint));
    }
    bar.set_position(from);
    let failed = |error: std::io::Error| Failure::file(&part, &error);
    rows(scan, from, json, &bar, |text| {
        file.write_all(text.as_bytes()).and_then(|()| file.sync_data()).map_err(failed)
    })?;
    drop(file);
    fs::rename(&part, path).map_err(|error| Failure::file(path, &error))?;
    fs::remove_file(&note).map_err(|error| Failure::file(&note, &error))
}

fn rows(
    scan: &Scan,
    from: u64,
    json: bool,
    bar: &ProgressBar,
    mut put: impl FnMut(&str) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let mut next = from;
    while next < scan.count() {
        let last = (next + CHUNK).min(scan.count());
        put(&scan.rows(next, last, json))?;
        bar.inc(last - next);
        next = last;
    }
    bar.finish_and_clear();
    Ok(())
}

fn beside(path: &Path, extension: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(extension);
    name.into()
}

/// A new part with its note.
fn begun(
    part: &Path,
    note: &Path,
    signature: &str,
    scan: &Scan,
    json: bool,
) -> Result<File, Failure> {
    if part.exists() {
        let message = format!("{} is an unfinished scan", part.display());
        let hint = "continue it with --resume, or remove it";
        return Err(Failure::new("resume", message, hint));
    }
    files::write_file(note, signature.as_bytes())?;
    let mut file = File::create_new(part).map_err(|error| Failure::file(part, &error))?;
    if !json {
        file.write_all(scan.header().as_bytes()).map_err(|error| Failure::file(part, &error))?;
    }
    Ok(file)
}

/// An unfinished part, cut after its last whole row, and how many rows it has; `None` if there is none
/// that has begun.
fn continued(
    part: &Path,
    note: &Path,
    signature: &str,
    json: bool,
) -> Result<Option<(File, u64)>, Failure> {
    if !part.exists() {
        return Ok(None);
    }
    let known = fs::read_to_string(note).map_err(|error| Failure::file(note, &error))?;
    if known != signature {
        let hint = format!("it was begun as: {}", known.trim_end());
        return Err(Failure::new("resume", "the unfinished scan is another one", hint));
    }
    let failed = |error: std::io::Error| Failure::file(part, &error);
    let mut file = OpenOptions::new().read(true).write(true).open(part).map_err(failed)?;
    let (mut lines, mut whole) = (0_u64, 0_u64);
    let mut reader = BufReader::new(&file);
    let mut line = Vec::new();
    while reader.read_until(b'\n', &mut line).map_err(failed)? > 0 {
        if line.last() != Some(&b'\n') {
            break;
        }
        lines += 1;
        whole += line.len() as u64;
        line.clear();
    }
    drop(reader);
    let header = u64::from(!json);
    if lines < header {
        fs::remove_file(part).map_err(failed)?;
        return Ok(None);
    }
    file.set_len(whole).map_err(failed)?;
    file.seek(SeekFrom::End(0)).map_err(failed)?;
    Ok(Some((file, lines - header)))
}
