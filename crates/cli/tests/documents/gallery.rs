//! The gallery: every picture is what its command draws.

use std::collections::BTreeSet;
use std::fs;

use tempfile::TempDir;

use crate::{blocks, printed, root};

/// Where the commands of the gallery write.
const PLACE: &str = "docs/gallery/";

/// The commands run with another place for what they write, and the bytes are the same; no picture is
/// without a command.
#[test]
fn pictures_are_what_their_commands_draw() {
    let text = fs::read_to_string(root().join(PLACE).join("README.md")).unwrap();
    let directory = TempDir::new().unwrap();
    for block in blocks(&text, "sh").iter().filter(|block| block.contains(PLACE)) {
        printed(&block.replace(PLACE, &format!("{}/", directory.path().display())), &root());
    }
    let names = |directory: &std::path::Path| -> BTreeSet<String> {
        let entries = fs::read_dir(directory).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name != "README.md").collect()
    };
    let drawn = names(directory.path());
    assert_eq!(names(&root().join(PLACE)), drawn);
    for name in drawn {
        let [kept, new] = [root().join(PLACE), directory.path().into()]
            .map(|dir| fs::read(dir.join(&name)).unwrap());
        assert!(kept == new, "{name} is not what its command draws");
        assert!(text.contains(&format!("]({name})")), "{name} is not shown");
    }
}

/// Pictures and pages that Markdown files link to are there.
#[test]
fn links_lead_somewhere() {
    for file in ["README.md", "docs/gallery/README.md", "ARCHITECTURE.md", "docs/scheme-files.md"] {
        let path = root().join(file);
        let text = fs::read_to_string(&path).unwrap();
        let links = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for link in links.filter(|link| !link.starts_with("http") && !link.starts_with('#')) {
            let target = link.split('#').next().expect("a path");
            assert!(path.with_file_name("").join(target).exists(), "{file}: {link}");
        }
    }
}
