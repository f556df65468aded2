//! The transcription of Hameed and Mustafa's paper, against the printed one.

use refinable_papers::{Assertion, Bound, Cell, Claim, Over, Paper, Statement, Trait};

fn paper() -> Paper {
    Paper::builtin().expect("the transcription follows the format")
}

fn cell(table: &str, row: &str, column: &str) -> Cell {
    let cell = paper().table(table).and_then(|table| table.cell(row, column).cloned());
    cell.unwrap_or_else(|| panic!("no cell {row}, {column} in {table}"))
}

fn assertions(cell: &Cell) -> Vec<&Assertion> {
    fn checkable(claim: &Claim) -> Option<&Assertion> {
        match claim {
            Claim::Checkable(assertion) => Some(assertion),
            Claim::NotChecked { .. } => None,
        }
    }
    cell.claims.iter().filter_map(checkable).collect()
}

fn only_assertion(cell: &Cell) -> Assertion {
    let [assertion] = assertions(cell)[..] else { panic!("one assertion in {cell:?}") };
    assertion.clone()
}

/// Parameter, left end and right end of a cell's one continuity range, after its order.
fn range(cell: &Cell) -> (u32, String, String, String) {
    let Statement::Continuity(claimed) = only_assertion(cell).statement else {
        panic!("a continuity claim in {cell:?}")
    };
    let interval = claimed.interval.expect("a range");
    (claimed.order, interval.parameter, interval.left, interval.right)
}

/// The numbers of cells and claims, counted on the printed page.
#[test]
fn every_table_is_complete() {
    let found: Vec<(String, usize, usize)> = paper()
        .tables
        .into_iter()
        .map(|table| {
            let claims = table.cells.iter().map(|cell| cell.claims.len()).sum();
            (table.id, table.cells.len(), claims)
        })
        .collect();
    let expected = [
        ("masks-a-even", 6, 6),
        ("remark-dd", 6, 6),
        ("masks-a-odd", 3, 3),
        ("continuity-a-even", 33, 33),
        ("properties-a-even", 18, 18),
        ("special-a-even", 18, 18),
        ("continuity-a-odd", 33, 33),
        ("properties-a-odd", 27, 27),
        ("properties-interpolatory", 21, 21),
        ("theorems", 132, 132),
        ("norms", 6, 6),
        ("comparison-dd", 20, 100),
        ("comparison-all", 88, 88),
        ("conclusion", 66, 66),
    ]
    .map(|(id, cells, claims)| (id.to_owned(), cells, claims));
    assert_eq!(found, expected);
}

#[test]
fn only_foreign_schemes_and_an_approximate_order_are_not_checked() {
    let not_checked = |id: &str| -> usize {
        let table = paper().table(id).cloned().expect("a table");
        let claims = table.cells.into_iter().flat_map(|cell| cell.claims);
        claims.filter(|claim| matches!(claim, Claim::NotChecked { .. })).count()
    };
    let found: Vec<_> = paper()
        .tables
        .iter()
        .map(|table| (table.id.clone(), not_checked(&table.id)))
        .filter(|(_, count)| *count > 0)
        .collect();
    let expected = [("remark-dd".to_owned(), 1), ("comparison-all".to_owned(), 48)];
    assert_eq!(found, expected);
}

/// A mask of the (2N+2)-point scheme reaches from -(2N+2) to 2N+2, of the (2N+3)-point scheme
/// from -(2N+3) to 2N+3, and is printed symmetric.
#[test]
fn masks_have_the_printed_length_and_symmetry() {
    for (id, least) in [("masks-a-even", 5), ("masks-a-odd", 7)] {
        for (n, cell) in paper().table(id).expect("a table").cells.iter().enumerate() {
            let Statement::Mask { mask } = only_assertion(cell).statement else {
                panic!("a mask in {cell:?}")
            };
            let (_, list) = mask.split_once('[').expect("a list");
            let entries: Vec<_> = list.trim_end_matches(']').split(", ").collect();
            assert_eq!(entries.len(), least + 4 * n, "{mask}");
            assert!(entries.iter().eq(entries.iter().rev()), "{mask}");
        }
    }
}

#[test]
fn ranges_are_the_printed_ones() {
    let cases = [
        ("continuity-a-even", "N=0", "C^0", (0, "alpha", "-1/4", "3/4")),
        ("continuity-a-even", "N=3", "C^4", (4, "alpha", "29/50000", "41/50000")),
        ("continuity-a-even", "N=5", "C^5", (5, "alpha", "1/10160", "1/7240")),
        ("continuity-a-odd", "N=1, in beta", "C^3", (3, "beta", "-2/121", "-1/248")),
        ("continuity-a-odd", "N=2, in alpha", "C^4", (4, "alpha", "1/128", "31/3072")),
        ("properties-interpolatory", "C^1", "N=0", (1, "beta", "(2-sqrt(6))/8", "(1-sqrt(3))/8")),
        ("properties-interpolatory", "C^3", "N=2", (3, "beta", "-157/20000", "-43/20000")),
    ];
    for (table, row, column, (order, parameter, left, right)) in cases {
        let found = range(&cell(table, row, column));
        let expected = (order, parameter.to_owned(), left.to_owned(), right.to_owned());
        assert_eq!(found, expected, "{table}, {row}, {column}");
    }
}

/// "C^4 at beta = 1/26, where alpha is on its curve": no interval is left.
#[test]
fn a_value_on_a_curve_is_set_after_the_curve() {
    let assertion = only_assertion(&cell("continuity-a-odd", "N=0, in beta", "C^4"));
    assert_eq!(assertion.scheme, "a3");
    assert_eq!(assertion.set, ["alpha=(1/8)*((16*beta+1)/(2*beta+1))", "beta=1/26"]);
    assert!(matches!(assertion.statement, Statement::Continuity(claimed)
        if claimed.order == 4 && claimed.interval.is_none()));
}

#[test]
fn degrees_keep_their_quantifiers() {
    let cell = cell("comparison-dd", "(2N+3)-point schemes", "GD");
    assert_eq!(cell.printed, "2N+5 at specific values");
    let found: Vec<_> = assertions(&cell)
        .into_iter()
        .map(|assertion| match &assertion.statement {
            Statement::Generation(degree) => (&*assertion.scheme, degree.value, degree.over),
            other => panic!("a degree, not {other:?}"),
        })
        .collect();
    let some = |scheme, degree| (scheme, degree, Over::Some);
    assert_eq!(
        found,
        [some("a3", 5), some("a5", 7), some("a7", 9), some("a9", 11), some("a11", 13)]
    );
}

#[test]
fn theorems_bound_from_below_and_tables_are_exact() {
    let degree = |cell: &Cell| match only_assertion(cell).statement {
        Statement::Reproduction(degree) => (degree.value, degree.over, degree.bound),
        other => panic!("a degree, not {other:?}"),
    };
    let theorem = cell("theorems", "Reproduction, S_{a_{2N+3}}", "N=10");
    assert_eq!(degree(&theorem), (21, Over::All, Bound::AtLeast));
    let table = cell("properties-a-even", "Reproduction", "N=5");
    assert_eq!(degree(&table), (11, Over::All, Bound::Equal));
}

#[test]
fn types_are_the_printed_abbreviations() {
    let cell = cell("comparison-dd", "(2N+2)-point schemes", "Type");
    assert_eq!(cell.printed, "Pr/Cm/Re");
    for assertion in assertions(&cell) {
        let expected = vec![Trait::Primal, Trait::Combined, Trait::Relaxed];
        assert_eq!(assertion.statement, Statement::Type { traits: expected });
    }
}

#[test]
fn the_norm_of_the_three_point_scheme_has_two_rows() {
    let cell = cell("norms", "S_{a_3}", "Condition");
    let rows = vec![
        vec!["2*(2*alpha-4*beta*(1-alpha))".to_owned()],
        vec!["2*(2*beta*(1-alpha))".to_owned(), "1+4*beta*(1-alpha)-4*alpha".to_owned()],
    ];
    let expected = Statement::Norm { continuity: 1, level: 1, rows };
    assert_eq!(only_assertion(&cell).statement, expected);
}
