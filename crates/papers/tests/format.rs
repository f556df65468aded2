//! What a claims file may and may not contain.

use refinable_papers::{Claims, ClaimsError, Statement};

/// A file with one table, whose cells are given.
fn file(cells: &str) -> String {
    format!("[[table]]\nid = 'mine'\ntitle = 'Mine'\nlocator = 'Table 1'\n{cells}")
}

/// A cell in row `r` and column `c` that makes one claim, given by its fields.
fn cell(claim: &str) -> String {
    format!(
        "[[table.cell]]\nrow = 'r'\ncolumn = 'c'\nprinted = 'p'\n[[table.cell.claim]]\n{claim}\n"
    )
}

fn message(text: &str) -> String {
    Claims::parse(text).expect_err("the file is wrong").to_string()
}

/// The message about a claim with these fields, less the place where it stands.
fn claim_message(claim: &str) -> String {
    let message = message(&file(&cell(claim)));
    let place = "table `mine`, row `r`, column `c`, claim at line 9: ";
    message.strip_prefix(place).unwrap_or_else(|| panic!("no place in: {message}")).to_owned()
}

const WIDTH: &str = "kind = 'support-width'\nscheme = 'a2'\nvalue = 4";

#[test]
fn the_example_of_the_documentation_is_read() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/claims.md");
    let text = std::fs::read_to_string(path).expect("docs/claims.md");
    let (_, after) = text.split_once("```toml\n").expect("an example");
    let (example, _) = after.split_once("```").expect("an end of the example");
    let tables = Claims::parse(example).expect("the example follows the format");
    assert_eq!(tables.len(), 1);
    assert_eq!(tables[0].cells.len(), 5);
}

#[test]
fn several_tables_are_read_in_order() {
    let second = file(&cell(WIDTH)).replace("'mine'", "'yours-2'");
    let tables = Claims::parse(&(file(&cell(WIDTH)) + &second)).expect("two tables");
    let ids: Vec<_> = tables.iter().map(|table| table.id.as_str()).collect();
    assert_eq!(ids, ["mine", "yours-2"]);
}

#[test]
fn a_claim_may_be_an_inline_table() {
    let inline = file(
        "[[table.cell]]\nrow = 'r'\ncolumn = 'c'\nprinted = 'p'\n\
         claim = [{ kind = 'support-width', scheme = 'a2', value = 4 }]",
    );
    assert_eq!(Claims::parse(&inline), Claims::parse(&file(&cell(WIDTH))));
}

#[test]
fn text_that_is_not_toml_is_rejected_with_its_line() {
    let message = message("a claim\n");
    assert!(message.starts_with("TOML parse error at line 1, column 3"), "{message}");
}

#[test]
fn an_empty_file_is_rejected() {
    assert_eq!(message(""), "no `[[table]]` in the file");
}

#[test]
fn an_unknown_field_of_a_cell_is_rejected_with_its_line() {
    let message = message(&file(&cell(WIDTH).replace("printed", "prints")));
    assert!(message.contains("line 8, column 1"), "{message}");
    assert!(message.contains("unknown field `prints`"), "{message}");
}

#[test]
fn an_unknown_field_of_a_table_is_rejected() {
    let message = message(&file(&cell(WIDTH)).replace("title", "titel"));
    assert!(message.contains("unknown field `titel`, expected one of"), "{message}");
}

#[test]
fn an_id_that_is_not_kebab_case_is_rejected() {
    for id in ["Mine", "my table", "mine-", "-mine", ""] {
        let text = file(&cell(WIDTH)).replace("'mine'", &format!("'{id}'"));
        assert_eq!(message(&text), format!("table id `{id}` is not in kebab-case"));
    }
}

#[test]
fn two_tables_with_one_id_are_rejected() {
    assert_eq!(message(&file(&cell(WIDTH)).repeat(2)), "two tables have the id `mine`");
}

#[test]
fn a_table_without_cells_is_rejected() {
    assert_eq!(message(&file("")), "table `mine` has no `[[table.cell]]`");
}

#[test]
fn a_cell_without_claims_is_rejected() {
    let text = file("[[table.cell]]\nrow = 'r'\ncolumn = 'c'\nprinted = 'p'");
    let expected = "table `mine`, row `r`, column `c`: no `[[table.cell.claim]]`";
    assert_eq!(message(&text), expected);
}

#[test]
fn two_cells_in_one_place_are_rejected() {
    let expected = "table `mine`, row `r`, column `c`: the cell occurs twice";
    assert_eq!(message(&file(&cell(WIDTH).repeat(2))), expected);
}

#[test]
fn a_wrong_claim_is_named_by_its_place() {
    let error = Claims::parse(&file(&cell("kind = 'beauty'\nscheme = 'a2'"))).unwrap_err();
    let ClaimsError::Claim { place, line, message } = error else { panic!("{error:?}") };
    assert_eq!((&*place.table, &*place.row, &*place.column, line), ("mine", "r", "c", 9));
    assert!(message.starts_with("unknown variant `beauty`, expected one of `mask`"), "{message}");
}

#[test]
fn fields_of_a_claim_are_checked() {
    let cases = [
        ("", "missing field `scheme`"),
        ("kind = 'support-width'\nvalue = 4", "missing field `scheme`"),
        ("scheme = 'a2'\nvalue = 4", "missing field `kind`"),
        ("kind = 'support-width'\nscheme = 'a2'", "missing field `value`"),
        ("kind = 'mask'\nscheme = 'a2'\nmasc = ''", "unknown field `masc`, expected `mask`"),
        ("kind = 'generation'\nscheme = 'a2'\nvalue = 1\nlevel = 1", "unknown field `level`"),
        ("kind = 'generation'\nscheme = 'a2'\nvalue = -1", "invalid value: integer `-1`"),
        ("kind = 'generation'\nscheme = 'a2'\nvalue = 1\nover = 'many'", "unknown variant `many`"),
        ("kind = 'type'\nscheme = 'a2'\ntraits = []", "the list is empty"),
        ("kind = 'type'\nscheme = 'a2'\ntraits = ['fair']", "unknown variant `fair`"),
        ("kind = 'norm'\nscheme = 'a2'\ncontinuity = 0\nlevel = 1\nrows = []", "the list is empty"),
        ("kind = 'norm'\nscheme = 'a2'\ncontinuity = 0\nlevel = 1\nrows = [[]]", "a row is empty"),
        ("kind = 'not-checked'", "missing field `reason`"),
        ("kind = 'not-checked'\nreason = 'r'\nscheme = 'a2'", "unknown field `scheme`"),
    ];
    for (fields, expected) in cases {
        let found = claim_message(fields);
        assert!(found.starts_with(expected), "{fields}\n{found}");
    }
}

#[test]
fn a_range_and_its_parameter_come_together() {
    let continuity = "kind = 'continuity'\nscheme = 'a2'\ncontinuity = 0\n";
    let message = |fields: &str| claim_message(&format!("{continuity}{fields}"));
    assert!(message("parameter = 'alpha'").starts_with("field `parameter` needs"));
    assert!(message("range = ['0', '1']").starts_with("field `range` needs"));
    assert!(message("parameter = 'alpha'\nrange = ['0']").starts_with("invalid length 1"));
    assert!(message("depth = 1").starts_with("unknown field `depth`"));
}

#[test]
fn expressions_are_not_read() {
    let claim = "kind = 'mask'\nscheme = 'no such scheme'\nset = ['?']\nmask = '[1, '";
    let tables = Claims::parse(&file(&cell(claim))).expect("the structure is right");
    let refinable_papers::Claim::Checkable(assertion) = &tables[0].cells[0].claims[0] else {
        panic!("a checkable claim")
    };
    assert_eq!(assertion.set, ["?"]);
    assert_eq!(assertion.statement, Statement::Mask { mask: "[1, ".to_owned() });
}
