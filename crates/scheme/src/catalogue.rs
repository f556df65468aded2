//! The schemes that have names.

use refinable_algebra::{Integer, Laurent, ParameterPolynomial, Rational, Ring, binomial, integer};

use crate::construction::{Construction, constructions};
use crate::derivation::Derivation;
use crate::diagnostic::Diagnostic;
use crate::displacement::{even_family, interpolatory_family, odd_family};
use crate::mask::Mask;

/// The largest `N` of the families by recursion and of the Deslauriers-Dubuc schemes.
const LARGEST_N: u32 = 100;
/// The largest degree of the B-splines.
const LARGEST_SPLINE: u32 = 400;
/// The most letters of a misspelt name that are compared with the catalogue.
const LONGEST_COMPARED: usize = 20;

/// A row of the catalogue: schemes that share the letters of their names.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    letters: &'static str,
    first: u32,
    step: u32,
    last: u32,
    description: &'static str,
    source: &'static str,
    build: fn(u32) -> Origin,
}

/// Where a named mask comes from.
enum Origin {
    Recursion(Derivation),
    Formula(Laurent<ParameterPolynomial>),
}

const FAMILIES: &str = "Hameed and Mustafa, Recursive process for constructing the refinement rules of new combined subdivision schemes";

const ENTRIES: [Entry; 5] = [
    Entry {
        letters: "a",
        first: 2,
        step: 2,
        last: 2 * LARGEST_N + 2,
        description: "the relaxed (2N+2)-point schemes with parameter alpha",
        source: FAMILIES,
        build: |points| Origin::Recursion(even_family((points - 2) / 2)),
    },
    Entry {
        letters: "a",
        first: 3,
        step: 2,
        last: 2 * LARGEST_N + 3,
        description: "the relaxed (2N+3)-point schemes with parameters alpha and beta",
        source: FAMILIES,
        build: |points| Origin::Recursion(odd_family((points - 3) / 2)),
    },
    Entry {
        letters: "i",
        first: 4,
        step: 2,
        last: 2 * LARGEST_N + 4,
        description: "the interpolatory (2N+4)-point schemes with parameter beta",
        source: FAMILIES,
        build: |points| Origin::Recursion(interpolatory_family((points - 4) / 2)),
    },
    Entry {
        letters: "dd",
        first: 2,
        step: 2,
        last: 2 * LARGEST_N + 2,
        description: "Deslauriers-Dubuc schemes by number of points",
        source: "Deslauriers and Dubuc 1989",
        build: |points| Origin::Formula(deslauriers_dubuc(points / 2)),
    },
    Entry {
        letters: "bspline",
        first: 1,
        step: 1,
        last: LARGEST_SPLINE,
        description: "B-splines by degree",
        source: "Schoenberg 1946; Lane and Riesenfeld 1980",
        build: |degree| Origin::Formula(b_spline(degree)),
    },
];

/// The rows of the catalogue. All of its schemes are binary.
///
/// ```
/// let names: Vec<_> = refinable_scheme::catalogue().iter().map(|row| row.names()).collect();
/// assert_eq!(names[0], "a2 a4 a6 … a202");
/// ```
pub fn catalogue() -> &'static [Entry] {
    &ENTRIES
}

impl Entry {
    /// The first names and the last, such as `a2 a4 a6 … a202`.
    pub fn names(&self) -> String {
        let name = |k: u32| format!("{}{}", self.letters, self.first + k * self.step);
        let last = format!("{}{}", self.letters, self.last);
        format!("{} {} {} … {last}", name(0), name(1), name(2))
    }

    /// What the schemes are.
    pub fn description(&self) -> &'static str {
        self.description
    }

    /// Where they come from.
    pub fn source(&self) -> &'static str {
        self.source
    }

    fn contains(&self, number: u32) -> bool {
        number >= self.first && (number - self.first).is_multiple_of(self.step)
    }

    /// The number of a scheme of this row that is closest to `number`.
    fn closest(&self, number: u32) -> u32 {
        let beyond = number.clamp(self.first, self.last) - self.first;
        self.first + beyond / self.step * self.step
    }
}

/// The row of a name, the mask, and its derivation if it has one.
///
/// # Errors
/// `unknown-scheme`, listing the catalogue and the nearest spelling; `budget` beyond its end.
pub(crate) fn look_up(
    name: &str,
) -> Result<(&'static Entry, Mask, Option<Derivation>), Diagnostic> {
    let (letters, digits) = split(name);
    let number = canonical(digits).ok_or_else(|| unknown(name))?;
    let mut rows = ENTRIES.iter().filter(|row| row.letters == letters);
    // Beyond u32 the parity is the last digit's, but every row has ended long before.
    let row = match number {
        Some(number) => rows.find(|row| row.contains(number)),
        None => rows.next(),
    };
    let row = row.ok_or_else(|| unknown(name))?;
    match number.filter(|number| *number <= row.last) {
        Some(number) => {
            built((row.build)(number)).map(|(mask, derivation)| (row, mask, derivation))
        }
        None => Err(beyond_end(row)),
    }
}

fn built(origin: Origin) -> Result<(Mask, Option<Derivation>), Diagnostic> {
    match origin {
        Origin::Recursion(derivation) => Ok((derivation.mask()?, Some(derivation))),
        Origin::Formula(symbol) => Ok((Mask::from_symbol(2, symbol)?, None)),
    }
}

/// The letters and the digits at the end.
fn split(name: &str) -> (&str, &str) {
    name.split_at(name.trim_end_matches(|c: char| c.is_ascii_digit()).len())
}

/// The number that the digits write without leading zeros, `Some(None)` if it exceeds `u32`.
fn canonical(digits: &str) -> Option<Option<u32>> {
    let canonical = !digits.is_empty() && !digits.starts_with('0');
    canonical.then(|| digits.parse().ok())
}

fn beyond_end(row: &Entry) -> Diagnostic {
    let message = format!("the catalogue ends at {}{}", row.letters, row.last);
    Diagnostic::new("budget", message)
}

fn unknown(name: &str) -> Diagnostic {
    let shown: String = name.chars().take(2 * LONGEST_COMPARED).collect();
    let more = if shown.len() < name.len() { "…" } else { "" };
    let names: Vec<_> = ENTRIES.iter().map(Entry::names).collect();
    let nearest = nearest(name).map_or_else(String::new, |near| format!("did you mean `{near}`? "));
    let error = Diagnostic::new("unknown-scheme", format!("there is no scheme `{shown}{more}`"));
    // The name of a construction, without what it is made of.
    let begun = |c: &&Construction| c.signature().split('(').next() == Some(name);
    if let Some(construction) = constructions().iter().find(begun) {
        return error.with_hint(format!("write `{}`", construction.signature()));
    }
    error.with_hint(format!(
        "{nearest}the catalogue has {}, and constructions such as `fourpoint(w)`; or type a mask such as \
         `[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]`",
        names.join(", ")
    ))
}

/// The catalogue name with the most similar letters and the closest number.
fn nearest(name: &str) -> Option<String> {
    let (letters, digits) = split(name);
    if letters.len() > LONGEST_COMPARED {
        return None;
    }
    let letters = letters.to_ascii_lowercase();
    let number = digits.parse().unwrap_or(0);
    let distance_to = |row: &&Entry| {
        let other_initial = letters.chars().next() != row.letters.chars().next();
        let off = row.closest(number).abs_diff(number);
        (distance(&letters, row.letters), other_initial, off)
    };
    let row = ENTRIES.iter().min_by_key(distance_to)?;
    // Half of the letters wrong is no misspelling any more.
    let similar = 2 * distance(&letters, row.letters) <= letters.len().max(row.letters.len());
    similar.then(|| format!("{}{}", row.letters, row.closest(number)))
}

/// The edit distance of Levenshtein: insertions, deletions and replacements of letters.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// The symbol of the `2n`-point scheme: old points stay, and `f'_{2i+1}` is the value at `1/2` of the
/// polynomial of degree `2n-1` through `(j, f_{i+j})`, `j = -n+1, …, n`.
///
/// # Source
/// G. Deslauriers, S. Dubuc, *Symmetric iterative interpolation processes*, Constr. Approx. 5 (1989).
fn deslauriers_dubuc(n: u32) -> Laurent<ParameterPolynomial> {
    let n = i64::from(n);
    let nodes = -n + 1..=n;
    let weights: Vec<Rational> =
        nodes.clone().map(|j| lagrange_at_half(nodes.clone(), j)).collect();
    // The weight of f_{i+j} is a_{1-2j}; the weights are symmetric about j = 1/2.
    let edge = Laurent::new(-n + 1, weights).dilated(2).shifted(-1);
    let symbol = edge.plus(&Laurent::one());
    symbol.map(|c| ParameterPolynomial::constant(c.clone()))
}

/// `Π_{k≠j} (1/2 - k)/(j - k)`, over one denominator.
fn lagrange_at_half(nodes: impl Iterator<Item = i64>, j: i64) -> Rational {
    let (mut above, mut below) = (Integer::one(), Integer::one());
    for k in nodes.filter(|k| *k != j) {
        above *= integer(1 - 2 * k);
        below *= integer(2 * (j - k));
    }
    Rational::new(above, below)
}

/// `(1+z)^(d+1) / 2^d`, centred: the first index is `-⌊(d+2)/2⌋`.
fn b_spline(degree: u32) -> Laurent<ParameterPolynomial> {
    let scale = integer(1) << degree;
    let coefficients = (0..=degree + 1).map(|k| {
        let c = Rational::new(binomial(degree + 1, k), scale.clone());
        ParameterPolynomial::constant(c)
    });
    Laurent::new(-i64::from((degree + 2) / 2), coefficients.collect())
}
