//! `interproximate`: tensions of their own at every control point.

use refinable_algebra::{Parameter, Rational, Ring, decimal};
use refinable_analysis::TensionChoice;
use refinable_refine::{
    Coordinate, Ends, Interproximate, Net, PointTable, Polygon, Tensions, Weights,
};
use refinable_scheme::{Diagnostic, Scheme};
use serde_json::{Map, Value, json};

use crate::grid::{Cell, Document, Grid};
use crate::points::expect_finite;

/// The tensions of a member of a family, one for each of its parameters in their order.
pub type Member = Vec<Rational>;

/// A family with the members that the points of a polygon or a net take.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// The members in use.
    pub members: Vec<Member>,
    /// Which of them each vertex takes.
    pub vertices: Vec<usize>,
    /// Which of them the edge after each vertex takes.
    pub edges: Vec<usize>,
    /// Which of them new points take.
    pub approximating: usize,
}

impl Assignment {
    /// The vertices with these numbers are interpolated by one member, all others approximated by another;
    /// edges take what the vertices before them take.
    ///
    /// # Errors
    /// Code `tensions` if there is no such vertex.
    pub fn of_vertices(
        count: usize,
        interpolated: &[usize],
        interpolating: Member,
        approximating: Member,
    ) -> Result<Self, Diagnostic> {
        Assignment::expect_points(count, interpolated)?;
        let vertices: Vec<usize> =
            (0..count).map(|i| usize::from(interpolated.contains(&i))).collect();
        let members = vec![approximating, interpolating];
        Ok(Assignment { members, edges: vertices.clone(), vertices, approximating: 0 })
    }

    /// Whether there are control points of these numbers.
    ///
    /// # Errors
    /// Code `tensions` if one is missing.
    pub fn expect_points(count: usize, numbers: &[usize]) -> Result<(), Diagnostic> {
        let Some(beyond) = numbers.iter().find(|i| **i >= count) else { return Ok(()) };
        let message = format!("there is no control point {beyond}");
        let hint = format!("they are numbered from 0 to {}", count - 1);
        Err(Diagnostic::new("tensions", message).with_hint(hint))
    }

    /// A member for each vertex and for the edge after each; new points take `approximating`, or, if it is
    /// not given, the only member of the vertices that are not interpolated.
    ///
    /// # Errors
    /// Code `tensions` if that is not a single one; `pole` for a member that is not there.
    pub fn of_members(
        family: &Scheme,
        vertices: &[Member],
        edges: &[Member],
        approximating: Option<Member>,
    ) -> Result<Self, Diagnostic> {
        let mut members: Vec<Member> = Vec::new();
        let mut number = |member: &Member| {
            members.iter().position(|known| known == member).unwrap_or_else(|| {
                members.push(member.clone());
                members.len() - 1
            })
        };
        let vertices: Vec<usize> = vertices.iter().map(&mut number).collect();
        let edges: Vec<usize> = edges.iter().map(&mut number).collect();
        let given = approximating.as_ref().map(&mut number);
        let approximating = match given {
            Some(member) => member,
            None => only_approximating(family, &members, &vertices)?,
        };
        Ok(Assignment { members, vertices, edges, approximating })
    }

    /// The scheme of this assignment.
    ///
    /// # Errors
    /// Code `pole` for a member that is not there; those of [`Interproximate::new`].
    pub fn scheme<T: Coordinate>(&self, family: &Scheme) -> Result<Interproximate<T>, Diagnostic> {
        Interproximate::new(family_weights(family, &self.members)?, self.approximating)
    }

    /// The vertices that the limit interpolates: those whose own rule keeps them, on every level.
    ///
    /// # Errors
    /// Those of [`scheme`](Self::scheme).
    pub fn interpolated(&self, family: &Scheme) -> Result<Vec<usize>, Diagnostic> {
        let scheme = self.scheme::<Rational>(family)?;
        let kept = self.vertices.iter().enumerate().filter(|(_, member)| scheme.keeps(**member));
        Ok(kept.map(|(i, _)| i).collect())
    }

    /// The refined polygon.
    ///
    /// # Errors
    /// Those of [`Interproximate::refine`].
    pub fn refine<T: Coordinate>(
        &self,
        family: &Scheme,
        polygon: &Polygon<T>,
        levels: u32,
        ends: Ends,
    ) -> Result<Polygon<T>, Diagnostic> {
        let tensions = Tensions { vertices: self.vertices.clone(), edges: self.edges.clone() };
        let refined = self.scheme(family)?.refine(polygon, &tensions, levels, ends)?;
        expect_finite(refined.values())?;
        Ok(refined)
    }

    /// The refined net; edges take what the vertices before them take.
    ///
    /// # Errors
    /// Those of [`Interproximate::refine_net`].
    pub fn refine_net<T: Coordinate>(
        &self,
        family: &Scheme,
        net: &Net<T>,
        levels: u32,
        ends: [Ends; 2],
    ) -> Result<Net<T>, Diagnostic> {
        let refined = self.scheme(family)?.refine_net(net, &self.vertices, levels, ends)?;
        expect_finite(refined.values())?;
        Ok(refined)
    }
}

/// The free parameters of a family, in the order in which members give their values.
pub fn tensions_of(family: &Scheme) -> Vec<Parameter> {
    family.mask().parameters().into_iter().collect()
}

/// The rules of members.
///
/// # Errors
/// Those of [`Normalised::at`](refinable_scheme::Normalised::at).
pub(crate) fn family_weights<T: Coordinate>(
    family: &Scheme,
    members: &[Member],
) -> Result<Vec<Weights<T>>, Diagnostic> {
    members.iter().map(|member| Weights::new(&family.mask().at(member)?)).collect()
}

/// The member of all vertices that are not interpolated; if there is none, that of all vertices.
fn only_approximating(
    family: &Scheme,
    members: &[Member],
    vertices: &[usize],
) -> Result<usize, Diagnostic> {
    let scheme = Interproximate::new(family_weights::<Rational>(family, members)?, 0)?;
    let only = |mut members: Vec<usize>| {
        members.sort_unstable();
        members.dedup();
        match members[..] {
            [member] => Some(member),
            _ => None,
        }
    };
    let others = vertices.iter().copied().filter(|member| !scheme.keeps(*member)).collect();
    only(others).or_else(|| only(vertices.to_vec())).ok_or_else(|| {
        let message = "it is not clear which tensions new points take";
        let hint = "name them, for example --approximating 'alpha=1/8,beta=0'";
        Diagnostic::new("tensions", message).with_hint(hint)
    })
}

/// What was chosen, and what is proved of it.
pub fn choice_text(family: &Scheme, choice: &TensionChoice) -> String {
    let spelled = |member: &Member| {
        let values = tensions_of(family).into_iter().zip(member);
        values.map(|(p, x)| format!("{p} = {x}")).collect::<Vec<_>>().join(", ")
    };
    format!(
        "approximating: {}, the smoothest member found, Hölder exponent at least {}\n\
         interpolating: {}; at interpolated points the exponent is at least {}",
        spelled(&choice.approximating),
        floored(&choice.regularity.lower),
        spelled(&choice.interpolating),
        floored((&choice.at_vertices).min(&choice.regularity.lower)),
    )
}

/// Four decimals, rounded down.
pub(crate) fn floored(x: &Rational) -> String {
    let scale = Rational::from_i64(10_000);
    decimal(&((x * &scale).floor() / scale), 8)
}

/// A table of points with columns of tensions, taken apart.
#[derive(Clone, Debug)]
pub struct TensionTable {
    /// The points alone.
    pub points: PointTable<Rational>,
    /// The member of each vertex, if there are columns with the names of all parameters.
    pub vertices: Option<Vec<Member>>,
    /// The member of the edge after each vertex, from columns such as `edge_beta` where there are some.
    pub edges: Option<Vec<Member>>,
}

impl TensionTable {
    /// Takes the columns with the names of the family's parameters for tensions of vertices, and those with
    /// `edge_` before them for tensions of the edges after them; without the latter edges take the
    /// tensions of the vertices.
    ///
    /// # Errors
    /// Code `tensions` if only some parameters have columns, `points` if no coordinates are left.
    pub fn new(family: &Scheme, table: &PointTable<Rational>) -> Result<Self, Diagnostic> {
        let names = table.names.clone().unwrap_or_default();
        let parameters = tensions_of(family);
        let columns = |prefix: &str| -> Vec<Option<usize>> {
            let column = |p: &Parameter| names.iter().position(|n| *n == format!("{prefix}{p}"));
            parameters.iter().map(column).collect()
        };
        let (own, edges) = (columns(""), columns("edge_"));
        if let Some(twice) = (1..names.len()).find(|&k| names[..k].contains(&names[k])) {
            let message = format!("two columns are called `{}`", names[twice]);
            return Err(Diagnostic::new("tensions", message).with_hint("name each of them once"));
        }
        if own.iter().all(Option::is_none) && edges.iter().any(Option::is_some) {
            let message = "edges have columns of tensions, and vertices have none";
            let hint = format!("name a column {}", parameters[0]);
            return Err(Diagnostic::new("tensions", message).with_hint(hint));
        }
        let is_coordinate = |k: &usize| !own.iter().chain(&edges).any(|column| column == &Some(*k));
        let coordinates: Vec<usize> = (0..table.dimension).filter(is_coordinate).collect();
        if coordinates.is_empty() {
            return Err(Diagnostic::new(
                "points",
                "all columns are tensions, and none a coordinate",
            ));
        }
        let rows = || table.values.chunks_exact(table.dimension);
        let values = rows().flat_map(|row| coordinates.iter().map(|&k| row[k].clone())).collect();
        let own = match own.iter().flatten().count() {
            0 => None,
            _ => Some(own.iter().copied().collect::<Option<Vec<usize>>>().ok_or_else(|| {
                let names: Vec<String> = parameters.iter().map(ToString::to_string).collect();
                let hint = format!("name columns {}", names.join(", "));
                Diagnostic::new("tensions", "a column of tensions is missing").with_hint(hint)
            })?),
        };
        let members = |columns: &[usize]| -> Vec<Member> {
            rows().map(|row| columns.iter().map(|&k| row[k].clone()).collect()).collect()
        };
        // A parameter without a column for edges is that of the vertex.
        let edges = own.as_ref().map(|own| {
            members(
                &own.iter().zip(&edges).map(|(own, edge)| edge.unwrap_or(*own)).collect::<Vec<_>>(),
            )
        });
        let points = PointTable {
            names: None,
            dimension: coordinates.len(),
            values,
            rows: table.rows.clone(),
        };
        Ok(TensionTable { points, vertices: own.as_deref().map(members), edges })
    }
}

/// What an interproximate scheme was made of, as a table and as JSON, the points among it.
pub fn assignment_document(
    family: &Scheme,
    assignment: &Assignment,
    points: Value,
    levels: u32,
) -> Document {
    // An assignment whose members cannot be made is not refined, and comes here no more.
    let interpolated = assignment.interpolated(family).unwrap_or_default();
    let parameters = tensions_of(family);
    let names: Vec<String> = parameters.iter().map(ToString::to_string).collect();
    let row = |(i, (vertex, edge)): (usize, (&usize, &usize))| {
        let spelled = |member: usize| {
            let values = parameters.iter().zip(&assignment.members[member]);
            values.map(|(p, x)| format!("{p} = {x}")).collect::<Vec<_>>().join(", ")
        };
        let how = if interpolated.contains(&i) { "interpolated" } else { "approximated" };
        [i.to_string(), how.into(), spelled(*vertex), spelled(*edge)].map(Cell::text).to_vec()
    };
    let pairs = assignment.vertices.iter().zip(&assignment.edges);
    let json_member = |member: usize| -> Value {
        let values = parameters.iter().zip(&assignment.members[member]);
        values.map(|(p, x)| (p.to_string(), json!(x.to_string()))).collect::<Map<_, _>>().into()
    };
    let new_points = &assignment.members[assignment.approximating];
    let new_points: Vec<String> =
        names.iter().zip(new_points).map(|(n, x)| format!("{n} = {x}")).collect();
    let grid = Grid {
        id: "interproximate".into(),
        caption: format!("Tensions of {} at the control points", family.name()),
        header: ["point", "is", "vertex", "edge after it"].map(String::from).to_vec(),
        rows: pairs.enumerate().map(row).collect(),
        remarks: vec![
            format!("new points take {}", new_points.join(", ")),
            "interpolated points are kept exactly on every level, unless the ends are trimmed off"
                .into(),
            "the edge after a point takes its tensions: the order of the points matters".into(),
        ],
    };
    let json = json!({
        "scheme": family.name(),
        "levels": levels,
        "interpolated": interpolated,
        "vertices": assignment.vertices.iter().map(|m| json_member(*m)).collect::<Value>(),
        "edges": assignment.edges.iter().map(|m| json_member(*m)).collect::<Value>(),
        "approximating": json_member(assignment.approximating),
        "points": points,
    });
    Document { grids: vec![grid], summary: None, json }
}
