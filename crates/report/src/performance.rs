//! How time grows, and how it compares with that of others: a page and pictures from committed measurements.
//!
//! Nothing is measured here. `benches/peers/growth` and `benches/peers/run` write the files, with the machine described in
//! lines that begin with `#`; the page is a function of them.

use refinable_algebra::{Rational, parse_rational};
use refinable_reals::logarithm;
use refinable_scheme::Diagnostic;

use crate::growth_picture::growth_picture;
use crate::site::Site;
use crate::svg::place;

/// What has been measured, as the files of a report's folder `performance` say.
#[derive(Clone, Debug)]
pub struct Measurements {
    files: [String; 3],
    growth: Vec<Series>,
    /// `task,unit,tool,median,least,most,ratio,ratio_least,ratio_most,result`
    peers: Vec<Vec<String>>,
}

/// The times of one task for growing sizes.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    axis: String,
    pub task: String,
    command: String,
    /// Ascending.
    pub points: Vec<Point>,
}

/// A size, and the times it took.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    size: Rational,
    /// Least, median and greatest, in milliseconds.
    times: [Rational; 3],
}

/// What grows: the name in the file, the title, what the axis says.
const AXES: [[&str; 3]; 4] = [
    ["order", "The place N of a scheme in its family", "N"],
    ["rows", "The level L of a norm, by its 2^L rows", "rows 2^L"],
    ["points", "Points", "points"],
    ["nodes", "Nodes of a map, the pieces it is cut into and those they come from", "nodes"],
];

impl Measurements {
    /// The folder of a report.
    pub const FOLDER: &'static str = "performance";
    /// The files in it that are read: growth, the comparison with others, and what people say about both.
    pub const FILES: [&'static str; 3] = ["growth.csv", "peers.csv", "limits.md"];

    /// Reads the texts of the files.
    ///
    /// # Errors
    /// Code `measurements` for a line that is no measurement.
    pub fn new(files: [String; 3]) -> Result<Self, Diagnostic> {
        let mut growth: Vec<Series> = Vec::new();
        for record in records(&files[0], Self::FILES[0])? {
            let (name, point) = measurement(&record)
                .ok_or_else(|| malformed(Self::FILES[0], format!("`{}`", record.join(","))))?;
            match growth.last_mut() {
                Some(last) if [&last.axis, &last.task, &last.command] == name.each_ref() => {
                    last.points.push(point);
                }
                _ => {
                    let [axis, task, command] = name;
                    growth.push(Series { axis, task, command, points: vec![point] });
                }
            }
        }
        for series in &growth {
            if series.points.len() < 3 || !series.points.is_sorted_by(|a, b| a.size < b.size) {
                let message = format!("`{}` has not three sizes, ascending", series.task);
                return Err(malformed(Self::FILES[0], message));
            }
        }
        let peers = records(&files[1], Self::FILES[1])?;
        Ok(Measurements { files, growth, peers })
    }

    /// Adds the page, its pictures and the files themselves to a site.
    pub(crate) fn publish(&self, site: &mut Site) {
        let mut add =
            |name: &str, text: String| site.insert(format!("{}/{name}", Self::FOLDER), text);
        for [axis, title, label] in AXES {
            let series = self.along(axis);
            if !series.is_empty() {
                add(&format!("{axis}.svg"), growth_picture(title, label, &series));
            }
        }
        add("README.md", self.page());
        for (name, text) in Self::FILES.iter().zip(&self.files) {
            add(name, text.clone());
        }
    }

    fn along(&self, axis: &str) -> Vec<&Series> {
        self.growth.iter().filter(|series| series.axis == axis).collect()
    }

    /// The page in Markdown.
    pub(crate) fn page(&self) -> String {
        let [growth, peers, limits] = &self.files;
        let mut text = format!(
            "# Speed\n\n## How time grows\n\n{}\nWritten by `benches/peers/growth` as [growth.csv](growth.csv). The \
             exponent is the slope of the line of least squares\nthrough the medians of the larger half of the sizes, both \
             as logarithms.\n\n",
            notes(growth)
        );
        for [axis, title, _] in AXES {
            let series = self.along(axis);
            if series.is_empty() {
                continue;
            }
            text.push_str(&format!(
                "### {title}\n\n![{title}]({axis}.svg)\n\n| task | command | sizes | least, ms | median, ms | greatest, ms \
                 | exponent |\n|---|---|---|---|---|---|---|\n"
            ));
            series.iter().for_each(|series| text.push_str(&series.line()));
            text.push('\n');
        }
        text.push_str(&format!(
            "## Beside others\n\n{}\nWritten by `benches/peers/run --csv` as [peers.csv](peers.csv). Ratios are to refinable in \
             the same turn, all with\ntheir least and greatest value.\n\n",
            notes(peers)
        ));
        text.push_str(
            "| task | tool | time | least..greatest | ratio | least..greatest |\n|---|---|---|---|---|---|\n",
        );
        self.peers.iter().for_each(|row| text.push_str(&comparison_line(row)));
        text.push('\n');
        text.push_str(limits);
        text
    }
}

impl Series {
    /// The exponent with which the time grows.
    pub fn exponent(&self) -> f64 {
        let larger = &self.points[(self.points.len() / 2).min(self.points.len() - 3)..];
        let places: Vec<[f64; 2]> = larger.iter().map(Point::place).collect();
        let mean = |k: usize| places.iter().map(|p| p[k]).sum::<f64>() / places.len() as f64;
        let [x, y] = [mean(0), mean(1)];
        let (products, squares) = places.iter().fold((0.0, 0.0), |(products, squares), p| {
            (products + (p[0] - x) * (p[1] - y), squares + (p[0] - x) * (p[0] - x))
        });
        products / squares
    }

    fn line(&self) -> String {
        let cells = |of: &dyn Fn(&Point) -> &Rational| {
            let all: Vec<String> = self.points.iter().map(|p| place(of(p)).to_string()).collect();
            all.join(", ")
        };
        format!(
            "| {} | `{}` | {} | {} | {} | {} | {:.1} |\n",
            self.task,
            self.command,
            cells(&|p| &p.size),
            cells(&|p| &p.times[0]),
            cells(&|p| &p.times[1]),
            cells(&|p| &p.times[2]),
            self.exponent()
        )
    }
}

impl Point {
    /// Decimal logarithms of the size and of the median; the floats are rounded from exact bounds.
    pub fn place(&self) -> [f64; 2] {
        [&self.size, &self.times[1]].map(|x| place(&logarithm(x, 10, 40).0))
    }
}

/// `axis,task,command` and a point; `None` if the record is something else.
fn measurement(record: &[String]) -> Option<([String; 3], Point)> {
    let [axis, task, command, size, times @ ..] = record else { return None };
    let positive = |text: &String| parse_rational(text).filter(|x| *x > Rational::default());
    let times: Vec<Rational> = times.iter().map(positive).collect::<Option<_>>()?;
    let point = Point { size: positive(size)?, times: times.try_into().ok()? };
    let known = AXES.iter().any(|[name, ..]| name == axis);
    known.then(|| ([axis, task, command].map(String::clone), point))
}

/// A line of the table beside others; times that are only bounded say their unit themselves.
fn comparison_line(row: &[String]) -> String {
    let cell = |k: usize| row.get(k).map_or(String::new(), |text| text.replace('|', "\\|"));
    let spread = |k: usize| match cell(k) {
        low if low.is_empty() => low,
        low => format!("{low}..{}", cell(k + 1)),
    };
    let unit = if cell(3).starts_with('>') { String::new() } else { format!(" {}", cell(1)) };
    let [task, tool, time, ratio] = [cell(0), cell(2), cell(3), cell(6)];
    format!("| {task} | {tool} | {time}{unit} | {} | {ratio} | {} |\n", spread(4), spread(7))
}

/// The records of a CSV file without its header.
fn records(text: &str, name: &str) -> Result<Vec<Vec<String>>, Diagnostic> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let read = |record: Result<csv::StringRecord, csv::Error>| match record {
        Ok(record) => Ok(record.iter().map(String::from).collect()),
        Err(error) => Err(malformed(name, error.to_string())),
    };
    reader.records().map(read).collect()
}

/// The lines that begin with `#`, as a list.
fn notes(text: &str) -> String {
    text.lines()
        .filter_map(|line| line.strip_prefix('#'))
        // The name of a processor is no formula.
        .map(|line| format!("*{}\n", line.replace("x86_64", "`x86_64`")))
        .collect()
}

fn malformed(name: &str, message: String) -> Diagnostic {
    Diagnostic::new("measurements", format!("{name}: {message}"))
        .with_hint("benches/peers/growth and benches/peers/run --csv write such files")
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "axis,task,command,size,least,median,most\n";

    fn read(growth: &str) -> Result<Measurements, Diagnostic> {
        let peers = "task,unit,tool,median,least,most,ratio,ratio_least,ratio_most,result\n";
        Measurements::new([
            format!("# a machine\n{HEADER}{growth}"),
            peers.into(),
            "# Limits\n".into(),
        ])
    }

    /// `size²/8` in all but the smaller half.
    #[test]
    fn the_exponent_of_squares_is_two() {
        let lines = [(1, "7"), (2, "9"), (4, "2"), (8, "8"), (16, "32"), (32, "128")];
        let line = |(size, ms): (i32, &str)| format!("points,scan,scan K,{size},{ms},{ms},{ms}\n");
        let measured = read(&lines.map(line).concat()).expect("measurements");
        assert!((measured.growth[0].exponent() - 2.0).abs() < 1e-9);
        let mut site = Site::new();
        measured.publish(&mut site);
        let names: Vec<&str> = site.keys().map(String::as_str).collect();
        let expected = ["README.md", "growth.csv", "limits.md", "peers.csv", "points.svg"];
        assert_eq!(names, expected.map(|name| format!("performance/{name}")));
        let page = &site["performance/README.md"];
        assert!(page.contains("* a machine\n") && page.contains("| 2.0 |\n"), "{page}");
        assert!(page.ends_with("# Limits\n"));
    }

    #[test]
    fn what_is_no_measurement_is_refused() {
        for lines in [
            "points,scan,scan K,1,2,3\n",
            "points,scan,scan K,0,1,1,1\npoints,scan,scan K,2,1,1,1\npoints,scan,scan K,3,1,1,1\n",
            "points,scan,scan K,1,1,1,1\npoints,scan,scan K,2,1,1,1\n",
            "points,scan,scan K,2,1,1,1\npoints,scan,scan K,1,1,1,1\npoints,scan,scan K,3,1,1,1\n",
            "years,scan,scan K,1,1,1,1\npoints,scan,scan K,2,1,1,1\npoints,scan,scan K,3,1,1,1\n",
        ] {
            let error = read(lines).expect_err(lines);
            assert!(error.to_string().contains("growth.csv"), "{error}");
        }
    }
}
