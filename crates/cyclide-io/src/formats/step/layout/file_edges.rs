//! The edges of a shell as edges of the file: chains of arcs of one circle and of parts of one line are one.

use super::bridgeheads::Bridgeheads;
use super::chains::{ChainCurve, continues, joined};
use super::half_edges::HalfEdge;
use super::{Draft, EdgeForm, LayoutEdge, LoopEdge, Merging};
use cyclide::{
    curve::{Arc, Circle},
    surface::PatchKind,
    topology::Shell,
};
use std::collections::HashMap;

/// Of each vertex the kept edges there, one that begins and ends there twice.
pub(super) fn edges_at(shell: &Shell, is_kept: &[bool]) -> HashMap<usize, Vec<usize>> {
    let mut at: HashMap<usize, Vec<usize>> = HashMap::new();
    for (index, edge) in shell.edges().iter().enumerate().filter(|(index, _)| is_kept[*index]) {
        at.entry(edge.start).or_default().push(index);
        at.entry(edge.end).or_default().push(index);
    }
    at
}

/// Whether two edges at a vertex are parts of one line or circle.
pub(super) fn go_on(
    shell: &Shell,
    arcs: &[Option<Arc>],
    (a, b): (usize, usize),
    vertex: usize,
    (size, circles): (f64, bool),
) -> bool {
    let to = |edge: usize, is_end: bool| {
        let arc = arcs[edge]?;
        Some(if (shell.edges()[edge].end == vertex) == is_end { arc } else { arc.reversed() })
    };
    let pair = to(a, true).zip(to(b, false));
    a != b && pair.is_some_and(|(a, b)| continues(&a, &b, size, circles))
}

/// The edges of the shell as edges of the file.
pub(super) struct Chains {
    pub(super) edges: Vec<LayoutEdge>,
    /// Of each kept edge of the shell the edge of the file, and whether this runs along it.
    of_edge: Vec<Option<(usize, bool)>>,
}

impl Chains {
    pub(super) fn new(
        shell: &Shell,
        drafts: &[Draft],
        is_kept: &[bool],
        (arcs, merging): (&[Option<Arc>], Option<&Merging<'_>>),
        heads: &Bridgeheads,
    ) -> Self {
        let mut chains = Self { edges: Vec::new(), of_edge: vec![None; shell.edges().len()] };
        let Some(merging) = merging else {
            (0..shell.edges().len()).for_each(|edge| chains.own(shell, edge));
            return chains;
        };
        // Edges of rational faces have the parameter of these.
        let mut is_single = vec![false; shell.edges().len()];
        for draft in drafts {
            if draft.region.kind == PatchKind::Cyclide {
                draft.loops.iter().flatten().for_each(|half| is_single[half.edge] = true);
            }
            draft.single_edges.iter().for_each(|&edge| is_single[edge] = true);
        }
        let at = edges_at(shell, is_kept);
        let size = merging.size;
        let next = |edge: usize, vertex: usize| match at.get(&vertex).map(Vec::as_slice) {
            Some(&[a, b]) if !is_single[a] && !is_single[b] && !heads.vertices.contains(&vertex) => {
                let other = if a == edge { b } else { a };
                go_on(shell, arcs, (edge, other), vertex, (size, merging.circles)).then_some(other)
            }
            _ => None,
        };
        let other_end = |edge: usize, vertex: usize| {
            let edge = &shell.edges()[edge];
            if edge.start == vertex { edge.end } else { edge.start }
        };
        for first in (0..shell.edges().len()).filter(|&edge| is_kept[edge]) {
            if chains.of_edge[first].is_some() {
                continue;
            }
            // Back to where the chain begins, or all the way round.
            let (mut edge, mut from) = (first, shell.edges()[first].start);
            while let Some(before) = next(edge, from).filter(|&before| before != first) {
                (from, edge) = (other_end(before, from), before);
            }
            let begin = from;
            let mut chain = vec![edge];
            let mut to = other_end(edge, from);
            while let Some(after) = next(edge, to).filter(|after| !chain.contains(after)) {
                chain.push(after);
                (to, edge) = (other_end(after, to), after);
            }
            let is_closed = begin == to;
            chains.add(shell, arcs, (&chain, begin, is_closed), &is_single, (merging, heads));
        }
        chains
    }

    /// An edge of the shell as it is.
    fn own(&mut self, shell: &Shell, edge: usize) {
        self.of_edge[edge] = Some((self.edges.len(), true));
        self.edges.push(LayoutEdge { ends: ends(shell, edge), form: EdgeForm::Own(edge) });
    }

    /// A chain that begins at a vertex as one edge; as several where it is none.
    fn add(
        &mut self,
        shell: &Shell,
        arcs: &[Option<Arc>],
        (chain, begin, is_closed): (&[usize], usize, bool),
        is_single: &[bool],
        (merging, heads): (&Merging<'_>, &Bridgeheads),
    ) {
        let is_own = |edge: usize| is_single[edge] || shell.edges()[edge].curve.arc().is_some() || !merging.circles;
        if let [one] = *chain
            && is_own(one)
        {
            return self.own(shell, one);
        }
        let mut run = Vec::with_capacity(chain.len());
        let mut at = begin;
        for &edge in chain {
            let [start, end] = ends(shell, edge);
            let forward = start == at;
            at = if forward { end } else { start };
            let Some(arc) = arcs[edge] else { return chain.iter().for_each(|&edge| self.own(shell, edge)) };
            run.push((edge, forward, if forward { arc } else { arc.reversed() }));
        }
        let pieces: Vec<Arc> = run.iter().map(|(_, _, arc)| *arc).collect();
        let Some(curve) = joined(&pieces, is_closed, merging.size) else {
            return chain.iter().for_each(|&edge| self.own(shell, edge));
        };
        for &(edge, forward, _) in &run {
            self.of_edge[edge] = Some((self.edges.len(), forward));
        }
        let (mut ends, mut curve) = ([begin, at], curve);
        // A whole circle begins where a seam ends that is not at a vertex.
        let head = run.iter().find_map(|(edge, ..)| heads.on_edge.get(edge)).filter(|_| is_closed);
        if let (Some(&head), ChainCurve::Circle(circle)) = (head, &curve)
            && let Ok(moved) = Circle::from_center(circle.center(), circle.normal(), heads.point(head))
        {
            (ends, curve) = ([head; 2], ChainCurve::Circle(moved));
        }
        self.edges.push(LayoutEdge { ends, form: EdgeForm::Joined(curve) });
    }

    /// A loop in edges of the file.
    pub(super) fn of_loop(&self, shell: &Shell, own: &[HalfEdge]) -> Vec<LoopEdge> {
        let of = |half: &HalfEdge| self.of_edge[half.edge].map(|(edge, along)| (edge, along == half.forward));
        let begins = |half: &HalfEdge| {
            let [start, end] = ends(shell, half.edge);
            let at = if half.forward { start } else { end };
            of(half).is_none_or(|(edge, _)| self.edges[edge].ends.contains(&at))
        };
        let first = own.iter().position(begins).unwrap_or(0);
        let mut found: Vec<LoopEdge> = Vec::new();
        for half in own[first..].iter().chain(&own[..first]) {
            let side = (half.face, half.side);
            match found.last_mut() {
                Some(last) if !begins(half) => last.sides.push(side),
                _ => found.extend(of(half).map(|(edge, forward)| LoopEdge { edge, forward, sides: vec![side] })),
            }
        }
        found
    }
}

/// The vertices of an edge.
fn ends(shell: &Shell, edge: usize) -> [usize; 2] {
    let edge = &shell.edges()[edge];
    [edge.start, edge.end]
}
