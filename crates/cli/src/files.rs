//! Files, written whole or not at all.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use refinable_certificate::{Certificate, LARGEST_FILE, MapCertificate};
use refinable_report::{CertificateStore, MapStore, Measurements, Site, png};
use tempfile::NamedTempFile;

use crate::failure::Failure;

/// Writes every file of a site below `dir`: first all of them beside their places, then, when none
/// has failed, each is moved over the old one.
///
/// # Errors
/// A directory or file that cannot be written; then no file has changed.
pub fn write_site(dir: &Path, site: &Site) -> Result<(), Failure> {
    write_all(dir, site.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))
}

/// Where a file is really written: what a link points to, and never a directory or a device.
///
/// # Errors
/// A place that is no regular file.
pub fn target(path: &Path) -> Result<PathBuf, Failure> {
    if !path.exists() {
        return Ok(path.to_path_buf());
    }
    let path = path.canonicalize().map_err(|error| Failure::file(path, &error))?;
    if path.is_file() {
        return Ok(path);
    }
    let what = if path.is_dir() { "a directory" } else { "a device" };
    let message = format!("{} is {what}, not a file", path.display());
    Err(Failure::new("file", message, "move it away, or choose another place"))
}

fn write_all<'a>(
    dir: &Path,
    files: impl Iterator<Item = (&'a str, &'a [u8])>,
) -> Result<(), Failure> {
    let mut staged: Vec<(NamedTempFile, PathBuf)> = Vec::new();
    for (name, bytes) in files {
        let path = target(&dir.join(name))?;
        let parent = path.parent().unwrap_or(dir);
        fs::create_dir_all(parent).map_err(|error| Failure::file(parent, &error))?;
        staged.push((stage(&path, &|out| out.write_all(bytes))?, path));
    }
    for (file, path) in staged {
        publish(file, &path)?;
    }
    Ok(())
}

/// How the names of temporary files begin and end. A process that is killed leaves its own behind; nobody else
/// removes it, as it may belong to one that is still at work.
const TEMPORARY: (&str, &str) = (".refinable-", ".tmp");

/// A finished temporary file beside the place for which it is meant.
fn stage(
    path: &Path,
    write: &dyn Fn(&mut dyn Write) -> io::Result<()>,
) -> Result<NamedTempFile, Failure> {
    let parent = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let builder = &mut tempfile::Builder::new();
    let file = builder.prefix(TEMPORARY.0).suffix(TEMPORARY.1).tempfile_in(parent);
    let file = file.map_err(|error| Failure::file(parent, &error))?;
    let mut out = BufWriter::new(file.as_file());
    let written = write(&mut out).and_then(|()| out.flush());
    drop(out);
    written
        .and_then(|()| file.as_file().sync_all())
        .map_err(|error| Failure::file(path, &error))?;
    Ok(file)
}

/// Moves a finished temporary file to its place, readable by all like any other file.
fn publish(file: NamedTempFile, path: &Path) -> Result<(), Failure> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let readable = fs::Permissions::from_mode(0o644);
        file.as_file().set_permissions(readable).map_err(|e| Failure::file(path, &e))?;
    }
    file.persist(path).map(drop).map_err(|error| Failure::file(path, &error.error))
}

/// Whether a place is a directory, or at least can become one: asked before work that takes long.
///
/// # Errors
/// A place that is something else.
pub fn expect_directory(dir: &Path, or_nothing: bool) -> Result<(), Failure> {
    if dir.is_dir() || (or_nothing && !dir.exists()) {
        return Ok(());
    }
    let hint = format!("`refinable report build {}` writes one", dir.display());
    let message = format!("{} is no directory", dir.display());
    Err(Failure::new("file", message, if or_nothing { "name a directory".into() } else { hint }))
}

/// How a directory differs from a site: one line for each file that is missing, different, or
/// stands among the generated ones without belonging there.
///
/// # Errors
/// A directory that cannot be read.
pub fn differences(dir: &Path, site: &Site) -> Result<Vec<String>, Failure> {
    let mut lines = Vec::new();
    for (name, text) in site {
        match fs::read_to_string(dir.join(name)) {
            Ok(found) if found == *text => {}
            Ok(found) => lines.push(first_difference(name, &found, text)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                lines.push(format!("{name}: missing"));
            }
            Err(error) => lines.push(format!("{name}: {error}")),
        }
    }
    let folders: BTreeSet<&str> =
        site.keys().filter_map(|name| name.rsplit_once('/')).map(|(folder, _)| folder).collect();
    for folder in folders {
        lines.extend(strangers(dir, folder, site)?);
    }
    Ok(lines)
}

/// Files in a generated folder that the report does not have.
fn strangers(dir: &Path, folder: &str, site: &Site) -> Result<Vec<String>, Failure> {
    let path = dir.join(folder);
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(&path).map_err(|error| Failure::file(&path, &error))? {
        let entry = entry.map_err(|error| Failure::file(&path, &error))?;
        names.insert(format!("{folder}/{}", entry.file_name().to_string_lossy()));
    }
    let unknown = names.into_iter().filter(|name| !site.contains_key(name));
    Ok(unknown.map(|name| format!("{name}: not part of the report")).collect())
}

fn first_difference(name: &str, found: &str, expected: &str) -> String {
    let pairs = found.lines().zip(expected.lines()).enumerate();
    match pairs.into_iter().find(|(_, (a, b))| a != b) {
        Some((k, (a, b))) => format!("{name}: line {}\n  - {a}\n  + {b}", k + 1),
        None => match [found, expected].map(|text| text.lines().count()) {
            [a, b] if a == b => format!("{name}: the ends of lines differ"),
            [a, b] => format!("{name}: {a} lines, should be {b}"),
        },
    }
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// A place that cannot be written.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_with(path, &|out| out.write_all(bytes))
}

/// The same for what is too long to be in memory as a whole.
///
/// # Errors
/// A place that cannot be written.
pub fn write_with(
    path: &Path,
    write: &dyn Fn(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    if path.file_name().is_none() {
        let hint = "name a file, not a directory";
        return Err(Failure::new("file", format!("{} is no file", path.display()), hint));
    }
    let dir = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !dir.is_dir() {
        let hint = "make the directory first";
        return Err(Failure::new("file", format!("{} is no directory", dir.display()), hint));
    }
    let path = target(path)?;
    publish(stage(&path, write)?, &path)
}

/// The format of a picture, told by the end of its name.
#[derive(Clone, Copy, Debug)]
pub enum Image {
    /// `.svg`
    Svg,
    /// `.png`
    Png,
}

impl Image {
    /// The format of the picture to be written there.
    ///
    /// # Errors
    /// Any other end.
    pub fn of(path: &Path) -> Result<Image, Failure> {
        let end = path.extension().map(|end| end.to_string_lossy().to_lowercase());
        match end.as_deref() {
            Some("svg") => Ok(Image::Svg),
            Some("png") => Ok(Image::Png),
            _ => {
                let message = format!("{} does not end in .svg or .png", path.display());
                Err(Failure::new("picture", message, "pictures are written as SVG or PNG"))
            }
        }
    }

    /// Writes a picture, whole or not at all.
    ///
    /// # Errors
    /// A place that cannot be written.
    pub fn write(self, path: &Path, svg: &str) -> Result<(), Failure> {
        match self {
            Image::Svg => write_file(path, svg.as_bytes()),
            Image::Png => write_file(path, &png(svg)),
        }
    }
}

/// The contents of a file that may come from a stranger: no more than a checker reads.
///
/// # Errors
/// A file that cannot be read.
pub fn read_limited(path: &Path) -> Result<Vec<u8>, Failure> {
    let file = fs::File::open(path).map_err(|error| Failure::file(path, &error))?;
    let mut bytes = Vec::new();
    // One byte more is enough to see that a file is too large.
    let most = LARGEST_FILE as u64 + 1;
    file.take(most).read_to_end(&mut bytes).map_err(|error| Failure::file(path, &error))?;
    Ok(bytes)
}

/// The text of a file that may come from a stranger.
///
/// # Errors
/// A file that cannot be read, is too large or no text.
pub fn read_text(path: &Path, hint: &str) -> Result<String, Failure> {
    let bytes = read_limited(path)?;
    let refused = |what: &str| Failure::new("file", format!("{}: {what}", path.display()), hint);
    if bytes.len() > LARGEST_FILE {
        return Err(refused("a file of more than 64 MiB"));
    }
    String::from_utf8(bytes).map_err(|_| refused("this is no text"))
}

/// What a report directory says about speed; nothing if it has no folder for it.
///
/// # Errors
/// A file that is missing there or no measurement.
pub fn measurements(dir: &Path) -> Result<Option<Measurements>, Failure> {
    let folder = dir.join(Measurements::FOLDER);
    if !folder.is_dir() {
        return Ok(None);
    }
    let mut texts = Vec::new();
    for name in Measurements::FILES {
        let path = folder.join(name);
        texts.push(fs::read_to_string(&path).map_err(|error| Failure::file(&path, &error))?);
    }
    let texts = texts.try_into().expect("a text for each file");
    Ok(Some(Measurements::new(texts)?))
}

/// The readable certificates of a directory, by name; none if there is no such directory. What does
/// not hold is found out when it is used.
///
/// # Errors
/// A directory or file that cannot be read.
pub fn certificates(dir: &Path) -> Result<CertificateStore, Failure> {
    read_all(dir, |bytes| Certificate::read(bytes).ok())
}

/// The readable certificates of maps.
///
/// # Errors
/// A directory or file that cannot be read.
pub fn map_certificates(dir: &Path) -> Result<MapStore, Failure> {
    read_all(dir, |bytes| MapCertificate::read(bytes).ok())
}

fn read_all<T>(
    dir: &Path,
    read: impl Fn(&[u8]) -> Option<T>,
) -> Result<BTreeMap<String, T>, Failure> {
    let mut store = BTreeMap::new();
    if !dir.is_dir() {
        return Ok(store);
    }
    for entry in fs::read_dir(dir).map_err(|error| Failure::file(dir, &error))? {
        let path = entry.map_err(|error| Failure::file(dir, &error))?.path();
        if path.extension().is_some_and(|extension| extension == "json")
            && let Some(name) = path.file_stem()
            && let Some(certificate) = read(&read_limited(&path)?)
        {
            store.insert(name.to_string_lossy().into_owned(), certificate);
        }
    }
    Ok(store)
}

#[cfg(test)]
mod tests {
    use std::env;
    use std::process::{Command, Stdio};
    use std::thread::sleep;
    use std::time::Duration;

    use tempfile::TempDir;

    use super::*;

    /// Where the process that is killed writes.
    const PLACE: &str = "REFINABLE_TEST_PLACE";

    /// Some files in which everything tells their generation.
    fn site(generation: usize) -> Site {
        let line = format!("{generation}\n");
        (0..20)
            .map(|k| (format!("folder-{}/{k}.txt", k % 3), line.repeat(2_000 + 500 * k)))
            .collect()
    }

    /// Not a test: what the next one runs and kills.
    #[test]
    #[ignore = "it runs until it is killed"]
    fn writes_until_it_is_killed() {
        let Some(place) = env::var_os(PLACE) else { return };
        for generation in 1.. {
            write_site(Path::new(&place), &site(generation)).expect("writable");
        }
    }

    /// Killed while it does nothing but write: each file is whole, all are of one generation or of two, and
    /// what else is there has the name of a temporary file.
    #[test]
    fn a_site_whose_writer_is_killed() {
        let dir = TempDir::new().expect("a directory");
        write_site(dir.path(), &site(0)).expect("writable");
        for round in 0..12_u64 {
            let mut writer = Command::new(env::current_exe().expect("this program"))
                .args(["--ignored", "--exact", "files::tests::writes_until_it_is_killed"])
                .env(PLACE, dir.path())
                .stdout(Stdio::null())
                .spawn()
                .expect("this program runs");
            sleep(Duration::from_micros(60_000 + 7_919 * round));
            writer.kill().and_then(|()| writer.wait()).expect("it is killed");
            let mut generations = BTreeSet::new();
            for (name, first) in site(0) {
                let text = fs::read_to_string(dir.path().join(&name)).expect("it is there");
                let line = text.lines().next().expect("not empty");
                assert_eq!(text, format!("{line}\n").repeat(first.lines().count()), "{name}");
                generations.insert(line.parse::<usize>().expect("a number"));
            }
            assert!(generations.len() <= 2, "{generations:?}");
        }
        let strangers: Vec<String> = differences(dir.path(), &site(0)).expect("readable");
        let strangers =
            strangers.iter().filter_map(|line| line.strip_suffix(": not part of the report"));
        for stranger in strangers {
            let name = stranger.rsplit('/').next().unwrap_or_default();
            assert!(name.starts_with(TEMPORARY.0) && name.ends_with(TEMPORARY.1), "{stranger}");
        }
    }
}
