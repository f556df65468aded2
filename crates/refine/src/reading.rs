//! Control points from text.
//!
//! **Tables**: a point on each line, its coordinates separated by commas, semicolons, tabs or blanks,
//! the same on all lines. A blank line ends a row of a net. What follows a `#` is a comment. A first
//! line that begins with a letter names the columns. **JSON**: `[[x, y], …]`, rows of a net one bracket
//! deeper, or such a list as `"points"` of an object, beside which `"columns"` may name them. Numbers are `7`, `-0.05`, `2.5e-3`, `1/3`; in JSON
//! the last one as text, and what has more digits than a float.

use refinable_scheme::Diagnostic;
use serde_json::Value;

use crate::coordinate::{Coordinate, LONGEST};
use crate::polygon::LARGEST_DIMENSION;

/// Points as they were written down: all of them have as many coordinates.
#[derive(Clone, PartialEq, Debug)]
pub struct PointTable<T> {
    /// The names of the columns, if there are some.
    pub names: Option<Vec<String>>,
    /// How many numbers a point has.
    pub dimension: usize,
    /// The numbers, point after point.
    pub values: Vec<T>,
    /// How many points each row of a net has; a single row if nothing separates them.
    pub rows: Vec<usize>,
}

/// Digits that a float keeps.
const SURE_DIGITS: usize = 15;
/// Letters of a text that an error shows.
const SHOWN: usize = 24;

impl<T: Coordinate> PointTable<T> {
    /// Reads a table or JSON.
    ///
    /// # Errors
    /// Code `points`, with the number of the line: text that is no number or not finite, lines with
    /// different numbers of coordinates, too many of them, no point at all.
    ///
    /// ```
    /// use refinable_refine::PointTable;
    /// let table = PointTable::<f64>::parse("x, y\n0, 0\n1, 1/2\n").unwrap();
    /// assert_eq!((table.dimension, table.values), (2, vec![0.0, 0.0, 1.0, 0.5]));
    /// let error = PointTable::<f64>::parse("0, 0\n1, nan\n").unwrap_err();
    /// assert_eq!(error.message(), "line 2: `nan` is no number");
    /// ```
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let table = match text.trim_start().as_bytes().first() {
            Some(b'[' | b'{') => from_json(text)?,
            _ => from_lines(text)?,
        };
        if table.values.is_empty() {
            let hint = "write a point on each line, for example 1, 2.5";
            return Err(Diagnostic::new("points", "there is no point").with_hint(hint));
        }
        Ok(table)
    }

    fn empty() -> Self {
        PointTable { names: None, dimension: 0, values: Vec::new(), rows: Vec::new() }
    }

    /// Adds a point to the last row.
    fn push(&mut self, point: &[T], place: &dyn Fn() -> String) -> Result<(), Diagnostic> {
        if self.dimension == 0 {
            self.dimension = point.len();
        }
        if point.len() != self.dimension {
            let message =
                format!("{}: {} numbers, but {} before", place(), point.len(), self.dimension);
            let hint = "every point has the same number of coordinates";
            return Err(Diagnostic::new("points", message).with_hint(hint));
        }
        self.values.extend_from_slice(point);
        if let Some(row) = self.rows.last_mut() {
            *row += 1;
        }
        Ok(())
    }
}

fn from_lines<T: Coordinate>(text: &str) -> Result<PointTable<T>, Diagnostic> {
    let mut table = PointTable::empty();
    let mut separator = None;
    let mut ended = true;
    for (k, line) in text.lines().enumerate() {
        let place = || format!("line {}", k + 1);
        let is_comment = line.trim_start().starts_with('#');
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() {
            ended |= !is_comment;
            continue;
        }
        let separator = *separator.get_or_insert_with(|| separator_of(line));
        let fields = split(line, separator);
        check_count(fields.len(), &place)?;
        if table.values.is_empty() && table.names.is_none() && is_header(&fields) {
            table.dimension = fields.len();
            table.names = Some(fields.into_iter().map(String::from).collect());
            continue;
        }
        if ended {
            table.rows.push(0);
            ended = false;
        }
        let number = |field: &&str| T::parse(field).ok_or_else(|| no_number(field, &place()));
        let point: Vec<T> = fields.iter().map(number).collect::<Result<_, _>>()?;
        table.push(&point, &place)?;
    }
    Ok(table)
}

/// The first of comma, semicolon and tab that a line has, else blanks.
fn separator_of(line: &str) -> Option<char> {
    [',', ';', '\t'].into_iter().find(|c| line.contains(*c))
}

fn split(line: &str, separator: Option<char>) -> Vec<&str> {
    match separator {
        Some(c) => line.split(c).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}

/// Names begin with letters, and none of them is a spelling of what is no number.
fn is_header(fields: &[&str]) -> bool {
    let is_name = |field: &&str| {
        let lower = field.to_lowercase();
        let not_finite = ["nan", "inf", "infinity"].contains(&lower.as_str());
        !not_finite && field.starts_with(|c: char| c.is_alphabetic() || c == '_')
    };
    fields.iter().all(is_name)
}

fn check_count(count: usize, place: &dyn Fn() -> String) -> Result<(), Diagnostic> {
    if count <= LARGEST_DIMENSION {
        return Ok(());
    }
    let message = format!("{}: {count} numbers", place());
    let hint = format!("a point has at most {LARGEST_DIMENSION} coordinates, and a line one point");
    Err(Diagnostic::new("points", message).with_hint(hint))
}

fn no_number(field: &str, place: &str) -> Diagnostic {
    let mut shown: String = field.chars().take(SHOWN).collect();
    if shown.len() < field.len() {
        shown.push('…');
    }
    let message = match field {
        "" => format!("{place}: a number is missing"),
        _ if field.len() > LONGEST => {
            format!("{place}: `{shown}` has more than {LONGEST} characters")
        }
        _ => format!("{place}: `{shown}` is no number"),
    };
    Diagnostic::new("points", message).with_hint("numbers are written 7, -0.05, 2.5e-3 or 1/3")
}

fn from_json<T: Coordinate>(text: &str) -> Result<PointTable<T>, Diagnostic> {
    let value: Value = serde_json::from_str(text).map_err(|error| {
        let message = format!("line {}, column {}: this is no JSON", error.line(), error.column());
        Diagnostic::new("points", message).with_hint(error.to_string())
    })?;
    let points = value.get("points").unwrap_or(&value);
    let list = points.as_array().ok_or_else(no_list)?;
    let is_net = |list: &[Value]| {
        list.first()
            .and_then(Value::as_array)
            .and_then(|row| row.first())
            .is_some_and(Value::is_array)
    };
    let mut table = PointTable::empty();
    let names = value.get("columns").and_then(Value::as_array);
    table.names = names.map(|names| {
        names.iter().map(|name| name.as_str().unwrap_or_default().to_string()).collect()
    });
    table.dimension = table.names.as_ref().map_or(0, Vec::len);
    if is_net(list) {
        for (i, row) in list.iter().enumerate() {
            read_row(&mut table, row.as_array().ok_or_else(no_list)?, &format!("row {}, ", i + 1))?;
        }
    } else {
        read_row(&mut table, list, "")?;
    }
    Ok(table)
}

fn read_row<T: Coordinate>(
    table: &mut PointTable<T>,
    points: &[Value],
    prefix: &str,
) -> Result<(), Diagnostic> {
    table.rows.push(0);
    for (k, point) in points.iter().enumerate() {
        let place = || format!("{prefix}point {}", k + 1);
        let list = point.as_array().ok_or_else(no_list)?;
        if list.is_empty() {
            return Err(no_number("", &place()));
        }
        check_count(list.len(), &place)?;
        let number = |value: &Value| {
            let text = match value {
                Value::String(text) => text.clone(),
                other => other.to_string(),
            };
            // What has more digits than a float has lost some already.
            let digits = text.chars().filter(char::is_ascii_digit).count();
            if T::EXACT && value.is_f64() && digits > SURE_DIGITS {
                let message = format!("{}: a number has too many digits", place());
                let hint = "where every digit counts write it as text, \"0.12345678901234567890\"";
                return Err(Diagnostic::new("points", message).with_hint(hint));
            }
            T::parse(text.trim()).ok_or_else(|| no_number(&text, &place()))
        };
        let point: Vec<T> = list.iter().map(number).collect::<Result<_, _>>()?;
        table.push(&point, &place)?;
    }
    Ok(())
}

fn no_list() -> Diagnostic {
    Diagnostic::new("points", "the JSON is no list of points")
        .with_hint("write [[0, 0], [1, 2.5]], or {\"points\": [[0, 0], [1, 2.5]]}")
}

#[cfg(test)]
mod tests {
    use refinable_algebra::{Rational, rational};

    use super::*;

    fn floats(text: &str) -> Result<PointTable<f64>, String> {
        PointTable::parse(text).map_err(|error| error.message().to_string())
    }

    #[test]
    fn tables_in_many_hands() {
        let expected = floats("0,0\n1,2.5\n").unwrap();
        for text in [
            "\u{feff}0,0\r\n1,2.5\r\n",
            "0 0\n1\t5/2",
            "0;0\n1;2.5",
            "# a comment\n\n0\t0  # the first\n# another\n1\t25e-1\n\n\n",
            "[[0, 0], [1, 2.5]]",
            "{\"points\": [[0, 0], [\"1\", \"5/2\"]]}",
            "[[0.0, 0e5], [1.0, 2.5]]",
        ] {
            assert_eq!(floats(text).unwrap(), expected, "{text:?}");
        }
        let named = floats("x,y,alpha\n1,2,0\n").unwrap();
        assert_eq!(named.names.unwrap(), ["x", "y", "alpha"]);
        let net = floats("0 0\n1 0\n\n0 1\n1 1\n").unwrap();
        assert_eq!(net.rows, [2, 2]);
        assert_eq!(floats("[[[0,0],[1,0]],[[0,1],[1,1]]]").unwrap(), net);
        let exact = PointTable::<Rational>::parse("0.1, 1/3\n1e2, -1.5E-1").unwrap();
        let numbers = [(1, 10), (1, 3), (100, 1), (-3, 20)].map(|(p, q)| rational(p, q));
        assert_eq!(exact.values, numbers);
        // The last digit counts, in each notation.
        for text in ["9.476348876953125", "0.1", "5e-324", "1.7976931348623157e308"] {
            let value: f64 = text.parse().unwrap();
            for text in [text.to_string(), format!("[[{text}]]")] {
                assert_eq!(floats(&text).unwrap().values, [value], "{text}");
            }
        }
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        let wide = "1,".repeat(1_000_000) + "1";
        let long = format!("1/{}", "7".repeat(2000));
        for (text, expected) in [
            ("", "there is no point"),
            ("\r\n \n", "there is no point"),
            ("x,y\n", "there is no point"),
            ("[]", "there is no point"),
            ("1,2\n3\n", "line 2: 1 numbers, but 2 before"),
            ("x,y\n1,2,3\n", "line 2: 3 numbers, but 2 before"),
            ("1,2\n3,\n", "line 2: a number is missing"),
            ("1,2\n\n3,inf\n", "line 3: `inf` is no number"),
            ("nan,2\n", "line 1: `nan` is no number"),
            ("1,2\n1e999,2\n", "line 2: `1e999` is no number"),
            ("1,2\n0x10,2\n", "line 2: `0x10` is no number"),
            ("1,2\n1/0,2\n", "line 2: `1/0` is no number"),
            (&long, "line 1: `1/7777777777777777777777…` has more than 2000 characters"),
            (
                "1,2\n3,abcdefghijklmnopqrstuvwxyz\n",
                "line 2: `abcdefghijklmnopqrstuvwx…` is no number",
            ),
            ("[[1, 2], [3]]", "point 2: 1 numbers, but 2 before"),
            ("[[], [1, 2]]", "point 1: a number is missing"),
            ("[[1, null]]", "point 1: `null` is no number"),
            ("[[[1, 2]], [3]]", "the JSON is no list of points"),
            ("[[1, 2", "line 1, column 6: this is no JSON"),
            ("{\"a\": 1}", "the JSON is no list of points"),
            (&wide, "line 1: 1000001 numbers"),
        ] {
            let shown: String = text.chars().take(40).collect();
            assert_eq!(floats(text).unwrap_err(), expected, "{shown:?}");
        }
    }
}
