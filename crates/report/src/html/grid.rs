//! Any table of the program.

use maud::{Markup, html};

use super::page::scrolling;
use super::typeset::typeset;
use crate::grid::{Cell, Grid};

/// Tables with more columns than these are printed in small letters.
const MANY: usize = 8;

/// A table with its remarks below.
pub(super) fn grid(grid: &Grid) -> Markup {
    let caption = format!("{}-caption", grid.id);
    let header = grid.header.iter().zip(grid.sizes());
    let table = html! {
        table.grid.wide[grid.header.len() > MANY] {
            caption #(caption) { (typeset(&grid.caption)) }
            thead {
                tr {
                    @for (title, size) in header {
                        th scope="col" style={ "min-width: " (size.div_ceil(2)) "ch" } { (typeset(title)) }
                    }
                }
            }
            @for group in grid.rows.chunk_by(|_, next| next.first().is_some_and(is_blank)) { (self::group(group)) }
        }
    };
    html! { (scrolling(&caption, &table)) (remarks(&grid.remarks)) }
}

fn is_blank(cell: &Cell) -> bool {
    cell.plain.is_empty()
}

/// A row with those that go on with it: the cells below which these are blank from the left on stand for all of them.
fn group(rows: &[Vec<Cell>]) -> Markup {
    let (count, continued) = (rows.len(), &rows[1..]);
    let blanks = continued.iter().map(|row| row.iter().take_while(|cell| is_blank(cell)).count());
    let common = blanks.min().unwrap_or(1);
    let span = (count > 1).then_some(count);
    html! {
        tbody {
            tr {
                @for (k, cell) in rows[0].iter().enumerate() {
                    @let span = span.filter(|_| k < common);
                    @if k == 0 {
                        th scope=(if count > 1 { "rowgroup" } else { "row" }) rowspan=[span] { (typeset(&cell.plain)) }
                    } @else {
                        td rowspan=[span] { (typeset(&cell.plain)) }
                    }
                }
            }
            @for row in continued { tr { @for cell in &row[common..] { td { (typeset(&cell.plain)) } } } }
        }
    }
}

/// More remarks than a few are folded away.
const FEW: usize = 8;

fn remarks(remarks: &[String]) -> Markup {
    let list = html! { ul.remarks { @for remark in remarks { li { (typeset(remark)) } } } };
    match remarks.len() {
        0 => html! {},
        1..=FEW => list,
        many => {
            html! { details { summary { (many) " remarks on what proves and what refutes" } (list) } }
        }
    }
}
