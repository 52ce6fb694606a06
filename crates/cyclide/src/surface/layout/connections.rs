//! How the quads of a mesh meet.

use crate::error::{GridError, LayoutFault, Result};
use std::collections::{HashMap, VecDeque};

/// An edge by its ends, the smaller first.
pub(super) fn side(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// Quads that meet two by two along their sides, all turned as the first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Connections {
    /// Their corners in cyclic order; the first corner is the one given.
    pub(super) quads: Vec<[usize; 4]>,
    /// The one or two quads at each side.
    sides: HashMap<[usize; 2], (usize, Option<usize>)>,
    /// A quad at each vertex.
    at_vertex: Vec<Option<usize>>,
}

impl Connections {
    pub(super) fn new(vertices: usize, quads: &[[usize; 4]]) -> Result<Self> {
        let refused = |fault, index| Err(GridError::NotAQuadLayout { fault, index }.into());
        if quads.is_empty() {
            return refused(LayoutFault::NoQuads, 0);
        }
        let mut sides: HashMap<[usize; 2], (usize, Option<usize>)> = HashMap::new();
        let mut at_vertex = vec![None; vertices];
        for (index, quad) in quads.iter().enumerate() {
            if quad.iter().any(|v| *v >= vertices) {
                return refused(LayoutFault::NoSuchVertex, index);
            }
            if (0..4).any(|i| (0..i).any(|j| quad[i] == quad[j])) {
                return refused(LayoutFault::RepeatedCorner, index);
            }
            for k in 0..4 {
                at_vertex[quad[k]].get_or_insert(index);
                match sides.entry(side(quad[k], quad[(k + 1) % 4])).or_insert((index, None)) {
                    (first, None) if *first == index => {}
                    (_, second @ None) => *second = Some(index),
                    _ => return refused(LayoutFault::ThirdQuad, index),
                }
            }
        }
        let mut connections = Self { quads: quads.to_vec(), sides, at_vertex };
        connections.turn_alike()?;
        Ok(connections)
    }

    /// Turns the quads as the first one: neighbors run along their side in opposite directions.
    fn turn_alike(&mut self) -> Result<()> {
        let mut reached = vec![false; self.quads.len()];
        reached[0] = true;
        let mut open = VecDeque::from([0]);
        while let Some(quad) = open.pop_front() {
            for k in 0..4 {
                let [a, b] = [self.quads[quad][k], self.quads[quad][(k + 1) % 4]];
                let Some(next) = self.across(quad, [a, b]) else { continue };
                let corners = &mut self.quads[next];
                let against = (0..4).any(|k| corners[k] == b && corners[(k + 1) % 4] == a);
                if !std::mem::replace(&mut reached[next], true) {
                    if !against {
                        corners.swap(1, 3);
                    }
                    open.push_back(next);
                } else if !against {
                    return Err(GridError::NotAQuadLayout { fault: LayoutFault::OneSided, index: next }.into());
                }
            }
        }
        match reached.iter().position(|reached| !reached) {
            Some(index) => Err(GridError::NotAQuadLayout { fault: LayoutFault::Apart, index }.into()),
            None => Ok(()),
        }
    }

    /// The quad on the other side of an edge.
    pub(super) fn across(&self, quad: usize, [a, b]: [usize; 2]) -> Option<usize> {
        match *self.sides.get(&side(a, b))? {
            (first, Some(second)) => Some(if first == quad { second } else { first }),
            (_, None) => None,
        }
    }

    /// All edges, and whether each is on the border.
    pub(super) fn edges(&self) -> impl Iterator<Item = ([usize; 2], bool)> {
        self.sides.iter().map(|(edge, quads)| (*edge, quads.1.is_none()))
    }

    /// The quads at an edge.
    pub(super) fn at_edge(&self, a: usize, b: usize) -> impl Iterator<Item = usize> {
        self.sides.get(&side(a, b)).into_iter().flat_map(|(first, second)| [Some(*first), *second]).flatten()
    }

    /// The corner after `v` round a quad, and the one before it.
    pub(super) fn beside(&self, quad: usize, v: usize) -> Option<[usize; 2]> {
        let corners = self.quads[quad];
        let k = corners.iter().position(|corner| *corner == v)?;
        Some([corners[(k + 1) % 4], corners[(k + 3) % 4]])
    }

    /// The vertex after `b` straight on from `a`: there is a quad on one side at least that goes along all the way, and one edge
    /// of it between; `None` at the border.
    pub(super) fn onward(&self, a: usize, b: usize) -> Option<usize> {
        let other =
            |quad: usize, not: usize| self.beside(quad, b).and_then(|pair| pair.into_iter().find(|v| *v != not));
        self.at_edge(a, b).find_map(|quad| {
            let between = other(quad, a)?;
            let next = self.across(quad, [b, between])?;
            other(next, between)
        })
    }

    /// The quads round an inner vertex, counter-clockwise: of each, the corner after the vertex and the one opposite. `None` of a
    /// vertex on the border or of none.
    pub(super) fn round(&self, v: usize) -> Option<Vec<(usize, [usize; 2])>> {
        let first = self.at_vertex[v]?;
        let (mut quad, mut fan) = (first, Vec::new());
        loop {
            let [after, before] = self.beside(quad, v)?;
            let opposite = self.quads[quad].into_iter().find(|w| ![v, after, before].contains(w))?;
            fan.push((quad, [after, opposite]));
            quad = self.across(quad, [v, before])?;
            if quad == first {
                return Some(fan);
            }
        }
    }

    /// Refuses vertices at which parts of the mesh touch, and those of the border that no grid has; the others of the border.
    pub(super) fn check_vertices(&self) -> Result<Vec<bool>> {
        let mut border_edges = vec![0usize; self.at_vertex.len()];
        let mut quads = vec![0usize; self.at_vertex.len()];
        self.quads.iter().flatten().for_each(|v| quads[*v] += 1);
        for (edge, on_border) in self.edges() {
            edge.into_iter().for_each(|v| border_edges[v] += usize::from(on_border));
        }
        for (index, (&edges, &quads)) in border_edges.iter().zip(&quads).enumerate() {
            let closed_twice = edges == 0 && quads > 0 && self.round(index).is_none_or(|fan| fan.len() != quads);
            if edges > 2 || closed_twice {
                return Err(GridError::NotAQuadLayout { fault: LayoutFault::Touching, index }.into());
            }
            if edges == 2 && quads > 3 {
                return Err(GridError::NotAQuadLayout { fault: LayoutFault::Border, index }.into());
            }
        }
        Ok(border_edges.into_iter().map(|edges| edges > 0).collect())
    }
}
