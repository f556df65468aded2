//! The workspace against the table of arrows in `ARCHITECTURE.md`, and the rules that go with it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};

/// For each crate the crates it depends on.
type Arrows = BTreeMap<String, BTreeSet<String>>;

/// The crates in which no float decides anything.
const EXACT: [&str; 5] = ["algebra", "reals", "scheme", "analysis", "certificate"];

fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("the workspace").to_path_buf()
}

fn metadata() -> Metadata {
    let manifest = root().join("Cargo.toml");
    let mut command = MetadataCommand::new();
    command.manifest_path(manifest).no_deps().exec().expect("cargo metadata runs")
}

/// `refinable-scheme` is the room `scheme`; the facade has the name of the house.
fn role(package: &str) -> Option<String> {
    let room =
        if package == "refinable" { Some(package) } else { package.strip_prefix("refinable-") };
    room.map(String::from)
}

/// The rows under `## Arrows`, the header and its rule left out.
fn documented() -> Arrows {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let lines = text.lines().skip_while(|line| line.trim() != "## Arrows").skip(1);
    let rows: Vec<&str> =
        lines.take_while(|line| !line.starts_with('#')).filter(|l| l.starts_with('|')).collect();
    let (header, rows) = rows.split_first().expect("a table under `## Arrows`");
    assert_eq!(cells(header)[..2], ["crate", "depends on"]);
    rows.iter().skip(1).map(|row| arrow(row)).collect()
}

fn arrow(row: &str) -> (String, BTreeSet<String>) {
    let cells = cells(row);
    let [name, targets, ..] = cells.as_slice() else { panic!("two columns in {row}") };
    let targets = targets.split(',').map(plain).filter(|name| !["", "-", "—"].contains(name));
    (plain(name).to_string(), targets.map(String::from).collect())
}

fn cells(row: &str) -> Vec<&str> {
    row.trim().trim_matches('|').split('|').map(str::trim).collect()
}

fn plain(name: &str) -> &str {
    name.trim().trim_matches('`')
}

/// What the manifests say: normal dependencies between members of the workspace.
fn actual() -> Arrows {
    let metadata = metadata();
    let members = metadata.workspace_packages();
    let names: BTreeSet<&str> = members.iter().map(|package| package.name.as_str()).collect();
    members
        .iter()
        .filter_map(|package| {
            let normal = package.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal);
            let inside = normal.filter(|d| names.contains(d.name.as_str()));
            Some((role(&package.name)?, inside.filter_map(|d| role(&d.name)).collect()))
        })
        .collect()
}

#[test]
fn the_manifests_have_the_arrows_of_the_table() {
    let documented = documented();
    let mut actual = actual();
    // The crate of these tests is no room of the building, unless the table says so.
    if !documented.contains_key("tests") {
        actual.remove("tests");
    }
    assert_eq!(actual, documented);
}

#[test]
fn no_arrow_leads_back() {
    let mut rest = actual();
    while !rest.is_empty() {
        let lowest: Vec<String> = rest
            .iter()
            .filter(|(_, targets)| targets.iter().all(|target| !rest.contains_key(target)))
            .map(|(name, _)| name.clone())
            .collect();
        assert!(!lowest.is_empty(), "a cycle among {:?}", rest.keys());
        lowest.iter().for_each(|name| drop(rest.remove(name)));
    }
}

/// Every directory below `crates` is a member named after it.
#[test]
fn packages_are_named_after_their_directories() {
    let names: BTreeSet<String> = actual().into_keys().collect();
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let directory = entry.unwrap().file_name().into_string().unwrap();
        assert!(names.contains(&directory), "crates/{directory}");
    }
}

/// The Rust files below a directory.
fn sources(directory: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut todo = vec![directory.to_path_buf()];
    while let Some(directory) = todo.pop() {
        for entry in fs::read_dir(&directory).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                todo.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found
}

/// Whether the text names one of the crates, as a word of its own.
fn names_one_of(text: &str, crates: &BTreeSet<String>) -> bool {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    words.into_iter().any(|word| crates.contains(word))
}

/// The representation of numbers is a secret of one file.
#[test]
fn only_one_file_names_the_crates_for_numbers() {
    let metadata = metadata();
    let mut crates = BTreeSet::new();
    for package in metadata.workspace_packages() {
        let numeric = package.dependencies.iter().filter(|d| d.name.starts_with("num-"));
        for dependency in numeric {
            assert_eq!(
                package.name.as_str(),
                "refinable-algebra",
                "depends on {}",
                dependency.name
            );
            crates.insert(dependency.name.replace('-', "_"));
        }
    }
    assert!(crates.contains("num_bigint"), "{crates:?}");
    let crates_directory = root().join("crates");
    let files = sources(&crates_directory).into_iter();
    let naming = files.filter(|file| names_one_of(&fs::read_to_string(file).unwrap(), &crates));
    let naming: Vec<PathBuf> = naming.collect();
    assert_eq!(naming, [crates_directory.join("algebra/src/number.rs")]);
}

#[test]
fn exact_crates_forbid_floats() {
    for name in EXACT {
        let path = root().join("crates").join(name).join("clippy.toml");
        let text = fs::read_to_string(&path).unwrap_or_else(|_| panic!("{}", path.display()));
        for float in ["f32", "f64"] {
            assert!(text.contains(&format!("path = \"{float}\"")), "{name} allows {float}");
        }
    }
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    assert!(manifest.contains("disallowed_types = \"warn\""), "the lint is off");
    for name in EXACT {
        let manifest = root().join("crates").join(name).join("Cargo.toml");
        let text = fs::read_to_string(manifest).unwrap();
        assert!(text.contains("[lints]\nworkspace = true"), "{name} has lints of its own");
    }
}
