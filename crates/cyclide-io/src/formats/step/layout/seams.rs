//! Seams: where a face goes all the way round its surface, its loop runs along a line between its borders or poles, and back.
//!
//! A seam is a chain of edges of the shell along one parameter line, so that readers compare it with the surface as they do borders.

use super::half_edges::{HalfEdge, HalfEdges};
use super::parameters::{Developed, angle_between, periodic, place, pole};
use super::regions::Region;
use cyclide::{curve::Arc, surface::PatchKind, topology::Shell};
use std::collections::{HashMap, HashSet};

/// An edge along which an angle changes by no more than this is a parameter line.
const ALONG: f64 = 1e-9;
/// Places at which an edge is looked at.
const PLACES: u32 = 4;

/// A way to make a region a face with one outer loop.
#[derive(Debug, Clone, Default)]
pub(super) struct Seam {
    /// The edges that become parts of the face's loop.
    pub(super) edges: Vec<usize>,
    /// The vertices at its ends, without poles.
    pub(super) ends: Vec<usize>,
}

/// An end of a seam: the vertices of a loop, or a pole.
type End = HashSet<usize>;

/// What is known of the region.
struct Inside<'a> {
    shell: &'a Shell,
    arcs: &'a [Option<Arc>],
    kind: &'a PatchKind,
    /// Of each vertex the edges there that are inside.
    edges_at: HashMap<usize, Vec<usize>>,
    on_loops: HashSet<usize>,
}

/// The seams with which the region is a face, one of which is to be taken; one without edges where none is needed, and no seam at all where there
/// is none.
pub(super) fn seams(
    shell: &Shell,
    half_edges: &HalfEdges,
    region: &Region,
    loops: &[Vec<HalfEdge>],
    arcs: &[Option<Arc>],
) -> Vec<Seam> {
    let kind = &region.kind;
    if periodic(kind) == [false, false] {
        return vec![Seam::default()];
    }
    let Some(turns) = loops.iter().map(|own| turns(shell, region, own)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let inside = Inside::new(shell, half_edges, region, loops, arcs);
    let vertices = |own: &Vec<HalfEdge>| -> End {
        own.iter().flat_map(|half| [shell.edges()[half.edge].start, shell.edges()[half.edge].end]).collect()
    };
    let round = |parameter: usize| -> Vec<End> {
        loops.iter().zip(&turns).filter(|(_, turns)| turns[parameter] != 0).map(|(own, _)| vertices(own)).collect()
    };
    let (mut round_u, round_v) = (round(0), round(1));
    round_u.extend(inside.poles());
    match (round_u.as_slice(), round_v.as_slice()) {
        ([], []) if matches!(kind, PatchKind::Torus { .. }) && has_handle(shell, half_edges, region, loops.len()) => {
            inside.both()
        }
        ([], []) => vec![Seam::default()],
        ([from, to], []) => inside.between(0, from, to),
        ([], [from, to]) => inside.between(1, from, to),
        _ => Vec::new(),
    }
}

fn turns(shell: &Shell, region: &Region, own: &[HalfEdge]) -> Option<[i32; 2]> {
    let edges = own.iter().map(|half| (&shell.edges()[half.edge].curve, half.forward));
    Developed::new(&region.kind, edges, region.outward)?.turns()
}

/// Whether a region is a ring in both directions, by Euler's number.
fn has_handle(shell: &Shell, half_edges: &HalfEdges, region: &Region, loops: usize) -> bool {
    let (mut vertices, mut edges) = (HashSet::new(), HashSet::new());
    for half in region.faces.iter().flat_map(|&face| half_edges.of_face(face)) {
        edges.insert(half.edge);
        vertices.extend([shell.edges()[half.edge].start, shell.edges()[half.edge].end]);
    }
    vertices.len() + region.faces.len() + loops == edges.len()
}

impl<'a> Inside<'a> {
    fn new(
        shell: &'a Shell,
        half_edges: &HalfEdges,
        region: &'a Region,
        loops: &[Vec<HalfEdge>],
        arcs: &'a [Option<Arc>],
    ) -> Self {
        let borders: HashSet<usize> = loops.iter().flatten().map(|half| half.edge).collect();
        let ends = |edge: usize| [shell.edges()[edge].start, shell.edges()[edge].end];
        let on_loops = borders.iter().flat_map(|&edge| ends(edge)).collect();
        let mut edges_at: HashMap<usize, Vec<usize>> = HashMap::new();
        for half in region.faces.iter().flat_map(|&face| half_edges.of_face(face)) {
            // Each edge inside has two half-edges: the one along it.
            if half.forward && !borders.contains(&half.edge) {
                for vertex in ends(half.edge) {
                    edges_at.entry(vertex).or_default().push(half.edge);
                }
            }
        }
        Self { shell, arcs, kind: &region.kind, edges_at, on_loops }
    }

    /// The vertices inside at poles, each as an end.
    fn poles(&self) -> Vec<End> {
        let is_pole = |vertex: usize| {
            !self.on_loops.contains(&vertex) && pole(self.kind, self.shell.vertices()[vertex]).is_some()
        };
        let mut found: Vec<usize> = self.edges_at.keys().copied().filter(|&vertex| is_pole(vertex)).collect();
        found.sort_unstable();
        found.into_iter().map(|vertex| End::from([vertex])).collect()
    }

    /// All chains of edges along which a parameter stays the same, from one end to another.
    fn between(&self, constant: usize, from: &End, to: &End) -> Vec<Seam> {
        let mut starts: Vec<usize> = from.iter().copied().collect();
        starts.sort_unstable();
        let mut found = Vec::new();
        for start in starts {
            for &first in self.edges_at.get(&start).into_iter().flatten() {
                if let Some((edges, end)) = self.chain(constant, start, first, |vertex| to.contains(&vertex)) {
                    let is_on_loop = |vertex: &usize| self.on_loops.contains(vertex);
                    found.push(Seam { edges, ends: [start, end].into_iter().filter(is_on_loop).collect() });
                }
            }
        }
        found
    }

    /// Both circles through each vertex of a whole torus.
    fn both(&self) -> Vec<Seam> {
        let mut starts: Vec<usize> = self.edges_at.keys().copied().filter(|v| !self.on_loops.contains(v)).collect();
        starts.sort_unstable();
        let circle = |constant: usize, start: usize| {
            let firsts = self.edges_at.get(&start).into_iter().flatten();
            firsts.copied().find_map(|first| self.chain(constant, start, first, |vertex| vertex == start))
        };
        let both = |start: usize| {
            let edges = [circle(0, start)?.0, circle(1, start)?.0].concat();
            Some(Seam { edges, ends: vec![start] })
        };
        starts.into_iter().filter_map(both).collect()
    }

    /// The chain that begins with an edge and goes on along the same parameter line until it is at an end.
    fn chain(
        &self,
        constant: usize,
        start: usize,
        first: usize,
        is_end: impl Fn(usize) -> bool,
    ) -> Option<(Vec<usize>, usize)> {
        let value = self.value(constant, first)?;
        let (mut edges, mut at, mut edge) = (Vec::new(), start, first);
        loop {
            edges.push(edge);
            let ends = &self.shell.edges()[edge];
            at = if ends.start == at { ends.end } else { ends.start };
            if is_end(at) {
                return Some((edges, at));
            }
            // A pole, a border in between, or the same place again.
            if self.on_loops.contains(&at) || pole(self.kind, self.shell.vertices()[at]).is_some() || at == start {
                return None;
            }
            let goes_on = |&&other: &&usize| {
                other != edge
                    && !edges.contains(&other)
                    && self.value(constant, other).is_some_and(|own| angle_between(value, own).abs() <= ALONG)
            };
            edge = *self.edges_at.get(&at)?.iter().find(goes_on)?;
        }
    }

    /// The parameter that stays the same along an edge, which is a line or a circle.
    fn value(&self, constant: usize, edge: usize) -> Option<f64> {
        let arc = self.arcs[edge].as_ref()?;
        let points = (0..=PLACES).map(|i| arc.point(f64::from(i) / f64::from(PLACES)));
        let mut values = points.filter(|p| constant == 1 || pole(self.kind, *p).is_none());
        let value = |p| place(self.kind, p).map(|place| place[constant]);
        let first = value(values.next()?)?;
        let is_same = |p| value(p).is_some_and(|own| angle_between(first, own).abs() <= ALONG);
        values.all(is_same).then_some(first)
    }
}
