//! The schema of scheme files: it is the one in `docs`, and it refuses what the reader refuses.

use std::fs;
use std::path::Path;

use jsonschema::Validator;
use refinable_scheme::SchemeFile;
use serde_json::Value;

fn schema() -> Value {
    serde_json::from_str(&SchemeFile::json_schema()).expect("JSON")
}

fn validator() -> Validator {
    let schema = schema();
    assert!(jsonschema::draft202012::meta::is_valid(&schema));
    jsonschema::draft202012::new(&schema).expect("a schema")
}

/// TOML seen as JSON.
fn data(text: &str) -> Value {
    toml::from_str(text).expect("TOML")
}

#[test]
fn the_published_schema_is_the_one_of_the_reader() {
    let published = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/scheme.schema.json");
    let published = fs::read_to_string(published).expect("readable");
    assert_eq!(published, SchemeFile::json_schema(), "`refinable schema` prints it");
}

#[test]
fn the_catalogue_is_valid() {
    let validator = validator();
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("catalogue");
    let mut count = 0;
    for entry in fs::read_dir(dir).expect("a directory") {
        let path = entry.expect("an entry").path();
        let file = data(&fs::read_to_string(&path).expect("readable"));
        if let Err(error) = validator.validate(&file) {
            panic!("{}: {error}", path.display());
        }
        count += 1;
    }
    assert!(count >= 37, "{count} files");
}

/// Every field with a value, once.
const WHOLE: &str = r#"
name = "four-point scheme"
arity = 2
mask = "fourpoint(w)"
set = ["w=1/16"]
source = "Dyn, Gregory and Levin 1987"

[parameters]
w = "1/16"

[[expect]]
set = []
source = "they"
mask = "dd4"
support = [-3, 3]
type = ["primal"]
generation = 3
reproduction = 3
continuity = 1
converges = true
holder = "2"

[[expect]]
range = { continuity = 1, proved = "(0, 1)", only = false }
"#;

/// Pairs of what to replace in the file above, and by what.
const BROKEN: [(&str, &str); 20] = [
    ("name =", "nam ="),
    ("name = \"four-point scheme\"", ""),
    ("mask = \"fourpoint(w)\"", ""),
    ("mask = \"fourpoint(w)\"", "mask = \"dd4\"\nrules = \"even: [1]; odd: [1/2, 1/2]\""),
    ("mask = \"fourpoint(w)\"", "mask = [1, 2, 1]"),
    ("arity = 2", "arity = \"2\""),
    ("arity = 2", "arity = -2"),
    ("set = [\"w=1/16\"]", "set = \"w=1/16\""),
    ("source = \"Dyn, Gregory and Levin 1987\"", "source = 1987"),
    ("source = \"Dyn, Gregory and Levin 1987\"", "source = 1987-01-01"),
    ("w = \"1/16\"", "w = 0.0625"),
    ("[parameters]\nw", "parameters"),
    ("support = [-3, 3]", "support = [-3]"),
    ("support = [-3, 3]", "support = [-3, 0, 3]"),
    ("support = [-3, 3]", "support = [-3.5, 3]"),
    ("type = [\"primal\"]", "type = \"primal\""),
    ("generation = 3", "generation = -1"),
    ("converges = true", "converges = \"yes\""),
    ("proved = \"(0, 1)\", ", ""),
    ("only = false", "olny = false"),
];

#[test]
fn what_is_broken_is_refused_by_the_schema_and_by_the_reader() {
    let validator = validator();
    assert!(validator.is_valid(&data(WHOLE)));
    SchemeFile::parse(WHOLE).expect("a scheme file");
    for (old, new) in BROKEN {
        assert!(WHOLE.contains(old), "{old}");
        let broken = WHOLE.replacen(old, new, 1);
        assert!(!validator.is_valid(&data(&broken)), "the schema admits {new:?}");
        let error = SchemeFile::parse(&broken).expect_err(new);
        assert_eq!(error.code(), "file", "{new}: {error}");
    }
}

/// What the schema leaves to the reader; the documentation says so.
#[test]
fn what_the_schema_cannot_express() {
    let validator = validator();
    for (old, new) in [
        ("fourpoint(w)", "fourpoint(w"),
        ("fourpoint(w)", "[1, 1, 1]"),
        ("w=1/16", "v=1/16"),
        ("w=1/16", "w"),
        ("arity = 2\nmask = \"fourpoint(w)\"", "arity = 1\nmask = \"[w, 1, 1-w]\""),
        // 2.0 is an integer in JSON Schema, and a float in TOML.
        ("arity = 2", "arity = 2.0"),
    ] {
        let file = WHOLE.replacen(old, new, 1);
        assert!(validator.is_valid(&data(&file)), "{new}");
        assert!(SchemeFile::parse(&file).is_err(), "{new}");
    }
}
