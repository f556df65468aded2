//! The committed pages, read as a browser would read them. That they are what the program writes is checked by
//! `refinable report check reports`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use scraper::{ElementRef, Html, Selector};

/// The pages by their path from the folder of the report.
fn pages() -> BTreeMap<PathBuf, String> {
    let root = root();
    let mut pages = BTreeMap::new();
    let mut todo = vec![root.clone()];
    while let Some(folder) = todo.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                todo.push(path);
            } else if path.extension().is_some_and(|end| end == "html") {
                let text = fs::read_to_string(&path).expect("text");
                pages.insert(path.strip_prefix(&root).expect("below").to_path_buf(), text);
            }
        }
    }
    pages
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports")
}

fn selected<'a>(html: &'a Html, selector: &str) -> Vec<ElementRef<'a>> {
    html.select(&Selector::parse(selector).expect("a selector")).collect()
}

fn text(element: ElementRef<'_>) -> String {
    element.text().collect::<String>().trim().to_string()
}

/// A path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => assert!(normal.pop(), "{} leaves the report", path.display()),
            Component::CurDir => {}
            other => normal.push(other),
        }
    }
    normal
}

fn ids(text: &str) -> BTreeSet<String> {
    let html = Html::parse_document(text);
    selected(&html, "[id]").iter().map(|e| e.attr("id").expect("selected").to_string()).collect()
}

#[test]
fn pages_are_valid_and_named() {
    let pages = pages();
    assert!(pages.len() > 20, "{:?}", pages.keys());
    for (path, text) in &pages {
        let html = Html::parse_document(text);
        assert!(html.errors.is_empty(), "{}: {:?}", path.display(), html.errors);
        let names: Vec<&str> =
            selected(&html, "[id]").iter().map(|e| e.attr("id").expect("selected")).collect();
        let distinct: BTreeSet<&&str> = names.iter().collect();
        assert_eq!(names.len(), distinct.len(), "{}: an id stands twice", path.display());
        for selector in ["html[lang]", "title", "main h1", "meta[name=viewport]", "a.skip"] {
            assert_eq!(selected(&html, selector).len(), 1, "{}: {selector}", path.display());
        }
        for image in selected(&html, "img") {
            assert!(image.attr("alt").is_some_and(|alt| !alt.is_empty()), "{}", path.display());
        }
        for table in selected(&html, "main > .scroll > table, section > .scroll > table") {
            assert!(table.select(&Selector::parse("caption").expect("a selector")).count() == 1);
        }
    }
}

/// Files and folders that links lead to exist, and so do the places on their pages.
#[test]
fn every_link_leads_somewhere() {
    let (root, pages) = (root(), pages());
    let places: BTreeMap<&PathBuf, BTreeSet<String>> =
        pages.iter().map(|(path, text)| (path, ids(text))).collect();
    let (mut certificates, mut anchors) = (BTreeSet::new(), 0);
    for (path, text) in &pages {
        let html = Html::parse_document(text);
        for element in selected(&html, "[href], [src]") {
            let link = element.attr("href").or(element.attr("src")).expect("selected");
            if link.starts_with("https://") {
                assert_eq!(element.value().name(), "a", "{}: {link} is loaded", path.display());
                continue;
            }
            let (file, place) = link.split_once('#').map_or((link, None), |(f, p)| (f, Some(p)));
            let target = match file {
                "" => path.clone(),
                _ => normal(&path.parent().expect("a file").join(file)),
            };
            assert!(root.join(&target).exists(), "{}: {link}", path.display());
            if let Some(place) = place {
                let known = places.get(&target).is_some_and(|ids| ids.contains(place));
                assert!(known, "{}: {link}", path.display());
                anchors += 1;
            }
            if target.starts_with("certificates") {
                certificates.insert(target);
            }
        }
    }
    assert!(certificates.len() > 100 && anchors > 900, "{} {anchors}", certificates.len());
}

/// Nothing is loaded but pictures beside the page.
#[test]
fn pages_need_no_network_and_no_script() {
    for (path, text) in pages() {
        let html = Html::parse_document(&text);
        let loaded = "script, link, iframe, object, embed, base, [srcset], [onclick], [onload]";
        assert!(selected(&html, loaded).is_empty(), "{}", path.display());
        let style: String = selected(&html, "style").into_iter().map(text_of).collect();
        assert!(!style.is_empty() && !style.contains("url(") && !style.contains("@import"));
    }
}

fn text_of(element: ElementRef<'_>) -> String {
    element.text().collect()
}

/// Verdicts and columns of the cells of the data, by table: what a page is to say.
fn audited() -> BTreeMap<String, Vec<(String, String)>> {
    let mut audited = BTreeMap::new();
    for entry in fs::read_dir(root().join("tables")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|end| end == "csv") {
            let mut reader = csv::Reader::from_path(&path).expect("a table");
            let cell = |record: csv::StringRecord| (record[4].to_string(), record[1].to_string());
            let cells = reader.records().map(|record| cell(record.expect("a row"))).collect();
            audited.insert(path.file_stem().expect("a name").to_string_lossy().into_owned(), cells);
        }
    }
    audited
}

/// What comes behind the sign of a verdict.
fn word(element: ElementRef<'_>) -> String {
    text(element).split_whitespace().last().expect("a word").to_string()
}

#[test]
fn pages_have_the_verdicts_of_the_data() {
    let (pages, audited) = (pages(), audited());
    for (id, cells) in &audited {
        let page = &pages[Path::new(&format!("tables/{id}.html"))];
        let html = Html::parse_document(page);
        let shown: Vec<String> =
            selected(&html, "table.cells td .verdict").into_iter().map(word).collect();
        let expected: Vec<&String> = cells.iter().map(|(verdict, _)| verdict).collect();
        assert_eq!(shown.iter().collect::<Vec<_>>(), expected, "{id}");
        // At a glance, where there are several columns: each cell once, with a link to its place.
        let glance = selected(&html, "table.glance td a");
        if glance.is_empty() {
            let columns: BTreeSet<&String> = cells.iter().map(|cell| &cell.1).collect();
            assert_eq!(columns.len(), 1, "{id}");
            continue;
        }
        assert_eq!(glance.len(), cells.len(), "{id}");
        for verdict in ["agrees", "stronger", "not-checked", "undecided", "disagrees"] {
            let marked = glance.iter().filter(|mark| {
                let classes = mark.attr("class").unwrap_or_default();
                classes.split_whitespace().any(|class| class == verdict)
            });
            let count = expected.iter().filter(|word| **word == verdict).count();
            assert_eq!(marked.count(), count, "{id}: {verdict}");
        }
    }
}

#[test]
fn the_index_counts_what_the_pages_have() {
    let (pages, audited) = (pages(), audited());
    let index = Html::parse_document(&pages[Path::new("index.html")]);
    let header: Vec<String> =
        selected(&index, "table.tables thead .verdict").into_iter().map(word).collect();
    assert_eq!(header.len(), 5);
    let rows = selected(&index, "table.tables tbody tr, table.tables tfoot tr");
    assert_eq!(rows.len(), audited.len() + 1);
    let all: Vec<&(String, String)> = audited.values().flatten().collect();
    for row in rows {
        let numbers = Selector::parse("td.number").expect("a selector");
        let numbers: Vec<usize> =
            row.select(&numbers).map(|cell| text(cell).parse().expect("a number")).collect();
        let link = row.select(&Selector::parse("a").expect("a selector")).next();
        let cells: Vec<&(String, String)> = match link.and_then(|link| link.attr("href")) {
            Some(link) => {
                let id = link.trim_start_matches("tables/").trim_end_matches(".html");
                audited[id].iter().collect()
            }
            None => all.clone(),
        };
        let expected = header.iter().map(|word| cells.iter().filter(|(v, _)| v == word).count());
        let expected: Vec<usize> = [cells.len()].into_iter().chain(expected).collect();
        assert_eq!(numbers, expected);
    }
    let counts = selected(&index, "table.verdicts td.number");
    let sum: usize = counts.into_iter().map(|n| text(n).parse::<usize>().expect("a number")).sum();
    assert_eq!(sum, all.len());
}

/// The errata list the cells that disagree, all of them and nothing else.
#[test]
fn the_errata_are_the_cells_that_disagree() {
    let (pages, audited) = (pages(), audited());
    let html = Html::parse_document(&pages[Path::new("errata.html")]);
    let shown: Vec<String> =
        selected(&html, "table.cells td .verdict").into_iter().map(word).collect();
    let count = audited.values().flatten().filter(|(verdict, _)| verdict == "disagrees").count();
    assert!(count > 0 && shown.len() == count, "{} of {count}", shown.len());
    assert!(shown.iter().all(|word| word == "disagrees"));
    assert!(selected(&html, ".notes h3").len() >= 5, "the notes are not there");
}
