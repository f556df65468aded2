//! Interproximate refinement: some control points are interpolated, the others approximated.

use std::ops::Range;

use refinable_algebra::{Rational, Ring};
use refinable_scheme::Diagnostic;

use crate::cascade::Cascade;
use crate::coordinate::Coordinate;
use crate::ends::Ends;
use crate::memory;
use crate::polygon::{ACROSS, ALONG, Net, Polygon};
use crate::step::combine;
use crate::weights::{Stencil, Weights};

/// Members of a family, one for each pair of tensions in use, of which every vertex and every edge of
/// a control polygon takes one.
///
/// The vertex rule at vertex `i` is that of the member of the vertex, the edge rules between `i` and
/// `i + 1` those of the member of the edge. On the next level a vertex that its rule keeps, and the
/// edge after it, keep their members; all others, old or new, take the approximating member.
///
/// # Source
/// Section 6 of Hameed and Mustafa, where the edge `(i, i+1)` takes the pair of vertex `i`.
#[derive(Clone, Debug)]
pub struct Interproximate<T> {
    members: Vec<Weights<T>>,
    approximating: usize,
    /// Stencils as long as the longest of all members.
    hull: Weights<T>,
}

/// Which members the vertices of a control polygon take, and the edges after them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Tensions {
    /// For each vertex.
    pub vertices: Vec<usize>,
    /// For each edge, that after vertex `i` at `i`; what stands at the end of an open polygon is not
    /// used.
    pub edges: Vec<usize>,
}

impl Tensions {
    /// Edges that take what the vertices before them take.
    pub fn of_vertices(vertices: Vec<usize>) -> Self {
        Tensions { edges: vertices.clone(), vertices }
    }
}

/// The member of a point and those of the edges after it, `edges[ACROSS]` and `edges[ALONG]`.
#[derive(Clone, Copy)]
struct Tag {
    vertex: usize,
    edges: [usize; 2],
}

impl Tag {
    fn of(member: usize) -> Self {
        Tag { vertex: member, edges: [member; 2] }
    }
}

/// Points that follow each other in one direction, the first of index `first`.
struct Line<T> {
    first: i64,
    values: Vec<T>,
    tags: Vec<Tag>,
}

impl<T: Coordinate> Interproximate<T> {
    /// The members, and which of them is the approximating one.
    ///
    /// # Errors
    /// Code `arity` if the members have different ones or there is no such member.
    pub fn new(members: Vec<Weights<T>>, approximating: usize) -> Result<Self, Diagnostic> {
        let same = members.windows(2).all(|pair| pair[0].arity() == pair[1].arity());
        let Some(member) = members.get(approximating).filter(|_| same) else {
            return Err(Diagnostic::new("arity", "members of one family have one arity"));
        };
        let class = |class: usize| {
            let stencils = || members.iter().map(move |member| &member.stencils()[class]);
            // The point that a new one stems from is needed for its tag.
            let first = stencils().map(Stencil::first).fold(0, i64::min);
            let end = stencils().map(Stencil::end).fold(1, i64::max);
            Stencil { first, weights: vec![Rational::one(); (end - first) as usize] }
        };
        let stencils = (0..member.arity()).map(class).collect();
        let hull = Weights::of(stencils, member.shift().clone());
        Ok(Interproximate { members, approximating, hull })
    }

    /// Whether the vertex rule of a member keeps the old points.
    ///
    /// # Panics
    /// If there is no such member.
    pub fn keeps(&self, member: usize) -> bool {
        let vertex = &self.members[member].stencils()[0];
        vertex.first == 0 && vertex.weights == [T::from_rational(&Rational::one())]
    }

    /// The polygon after some levels. Ghost points reflect the tensions as well, or are approximated if
    /// the ends are extrapolated.
    ///
    /// # Errors
    /// Those of [`refine`](crate::refine); code `tensions` if there are not as many as points.
    pub fn refine(
        &self,
        polygon: &Polygon<T>,
        tensions: &Tensions,
        levels: u32,
        ends: Ends,
    ) -> Result<Polygon<T>, Diagnostic> {
        let (count, width) = (polygon.count(), polygon.dimension());
        self.check(tensions, count)?;
        let closed = polygon.is_closed();
        let rules = self.hull.repeated(levels)?;
        let cascade = Cascade::new(rules.clone(), count, closed, ends)?;
        memory::check(&rules, (cascade.count() as u64).saturating_mul(2 * width as u64))?;
        let ranges = cascade.ranges(cascade.last());
        let tags = tensions.vertices.iter().zip(&tensions.edges);
        let tags: Vec<Tag> =
            tags.map(|(&vertex, &edge)| Tag { vertex, edges: [edge; 2] }).collect();
        let mut line = Line {
            first: ranges[0].start,
            values: ends.extend(polygon.values(), width, closed, &ranges[0]),
            tags: self.extended(&tags, ALONG, closed, ends, &ranges[0]),
        };
        for range in &ranges[1..] {
            line = self.step(&line, ALONG, true, range, width);
        }
        Polygon::new(width, line.values, closed)
    }

    /// The net after some levels, with members for its points, row by row, which the edges after them
    /// take as well. On each level every row is refined, and then every column of the result.
    ///
    /// # Errors
    /// As for [`refine`](Self::refine).
    pub fn refine_net(
        &self,
        net: &Net<T>,
        members: &[usize],
        levels: u32,
        ends: [Ends; 2],
    ) -> Result<Net<T>, Diagnostic> {
        let (counts, closed) = ([net.rows(), net.columns()], net.closed());
        self.check(&Tensions::of_vertices(members.to_vec()), counts[0] * counts[1])?;
        let rules = self.hull.repeated(levels)?;
        let cascade = |d: usize| Cascade::new(rules.clone(), counts[d], closed[d], ends[d]);
        let cascades = [cascade(ACROSS)?, cascade(ALONG)?];
        let points = (cascades[0].count() as u64).saturating_mul(cascades[1].count() as u64);
        let width = net.dimension();
        memory::check(&rules, points.saturating_mul(2 * width as u64))?;
        let [rows, columns] = cascades.each_ref().map(|cascade| cascade.ranges(cascade.last()));
        let mut lines = self.control_lines(net, members, ends, [&rows[0], &columns[0]]);
        for (old_rows, (rows, columns)) in rows.iter().zip(rows[1..].iter().zip(&columns[1..])) {
            let along = lines.iter().map(|line| self.step(line, ALONG, false, columns, width));
            let turned = transposed(&along.collect::<Vec<_>>(), old_rows.start, width);
            let across = turned.iter().map(|line| self.step(line, ACROSS, true, rows, width));
            lines = transposed(&across.collect::<Vec<_>>(), columns.start, width);
        }
        let values = lines.into_iter().flat_map(|line| line.values).collect();
        Net::new(width, cascades[ALONG].count(), values, closed)
    }

    fn check(&self, tensions: &Tensions, count: usize) -> Result<(), Diagnostic> {
        let lists = [&tensions.vertices, &tensions.edges];
        let known = |list: &Vec<usize>| list.iter().all(|&member| member < self.members.len());
        if let Some(list) = lists.into_iter().find(|list| list.len() != count || !known(list)) {
            let message = format!("there are tensions for {} of {count} points", list.len());
            return Err(Diagnostic::new("tensions", message).with_hint("give them for every point"));
        }
        Ok(())
    }

    /// One step in a direction: each new point by the stencil of the vertex or the edge it stems from. Old points
    /// take other members when the level ends: in a net they are refined in both directions before.
    fn step(
        &self,
        old: &Line<T>,
        direction: usize,
        ends_level: bool,
        new: &Range<i64>,
        width: usize,
    ) -> Line<T> {
        let m = self.hull.arity() as i64;
        let count = (new.end - new.start) as usize;
        let mut values = vec![T::origin(); count * width];
        let mut tags = Vec::with_capacity(count);
        for (i, point) in new.clone().zip(values.chunks_exact_mut(width)) {
            let (parent, class) = (i.div_euclid(m), i.rem_euclid(m) as usize);
            let tag = old.tags[(parent - old.first) as usize];
            let member = if class == 0 { tag.vertex } else { tag.edges[direction] };
            let stencil = &self.members[member].stencils()[class];
            let first = parent + stencil.first - old.first;
            let row = |k: i64| &old.values[(first + k) as usize * width..][..width];
            combine(&stencil.weights, row, point);
            let kept = class == 0 && (!ends_level || self.keeps(tag.vertex));
            tags.push(if kept { tag } else { Tag::of(self.approximating) });
        }
        Line { first: new.start, values, tags }
    }

    /// The rows of a net with ghost points in both directions.
    fn control_lines(
        &self,
        net: &Net<T>,
        members: &[usize],
        ends: [Ends; 2],
        [rows, columns]: [&Range<i64>; 2],
    ) -> Vec<Line<T>> {
        let (width, closed) = (net.dimension(), net.closed());
        let row = |(values, members): (&[T], &[usize])| {
            let tags: Vec<Tag> = members.iter().map(|&member| Tag::of(member)).collect();
            Line {
                first: columns.start,
                values: ends[ALONG].extend(values, width, closed[ALONG], columns),
                tags: self.extended(&tags, ALONG, closed[ALONG], ends[ALONG], columns),
            }
        };
        let values = net.values().chunks_exact(net.columns() * width);
        let given: Vec<Line<T>> =
            values.zip(members.chunks_exact(net.columns())).map(row).collect();
        let column = |line: Line<T>| Line {
            first: rows.start,
            values: ends[ACROSS].extend(&line.values, width, closed[ACROSS], rows),
            tags: self.extended(&line.tags, ACROSS, closed[ACROSS], ends[ACROSS], rows),
        };
        let turned: Vec<Line<T>> = transposed(&given, 0, width).into_iter().map(column).collect();
        transposed(&turned, columns.start, width)
    }

    /// The tags of points with ghosts: reflected where the points are, the edge that mirrors an edge
    /// taking its tag, else approximating.
    fn extended(
        &self,
        tags: &[Tag],
        direction: usize,
        closed: bool,
        ends: Ends,
        range: &Range<i64>,
    ) -> Vec<Tag> {
        let n = tags.len() as i64;
        let tag = |i: i64| {
            if closed {
                return tags[i.rem_euclid(n) as usize];
            }
            if ends != Ends::Reflect {
                let given = usize::try_from(i).ok().and_then(|i| tags.get(i));
                return given.copied().unwrap_or_else(|| Tag::of(self.approximating));
            }
            // Twice the middle of an edge is odd, and mirrored like twice a point.
            let edge = (folded(2 * i + 1, 2 * (n - 1)) - 1) / 2;
            let mut tag = tags[folded(i, n - 1) as usize];
            tag.edges[direction] = tags[edge.clamp(0, n - 1) as usize].edges[direction];
            tag
        };
        range.clone().map(tag).collect()
    }
}

/// `i` reflected at `0` and at `end`, until it lies between them.
fn folded(i: i64, end: i64) -> i64 {
    if end <= 0 {
        return 0;
    }
    let i = i.rem_euclid(2 * end);
    if i > end { 2 * end - i } else { i }
}

/// Lines in the other direction, through the points of those given, which are the points from `first`
/// on of each of them.
fn transposed<T: Coordinate>(lines: &[Line<T>], first: i64, width: usize) -> Vec<Line<T>> {
    let count = lines.first().map_or(0, |line| line.tags.len());
    let column = |j: usize| Line {
        first,
        values: lines.iter().flat_map(|line| line.values[j * width..][..width].to_vec()).collect(),
        tags: lines.iter().map(|line| line.tags[j]).collect(),
    };
    (0..count).map(column).collect()
}
