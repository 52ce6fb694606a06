//! The sides of faces as half-edges, and the loops round faces that are made one.

use cyclide::topology::{FaceEdge, Shell, Side};

/// A side of a face on an edge, as the loop of the face has it, seen from the shell's outer side.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfEdge {
    pub(super) face: usize,
    pub(super) side: Side,
    pub(super) edge: usize,
    /// Whether the loop runs along the edge from its start to its end.
    pub(super) forward: bool,
}

/// All half-edges of a shell.
pub(super) struct HalfEdges {
    /// Of each face its loop.
    of_face: Vec<Vec<HalfEdge>>,
    /// Of each edge the faces along it with the place in the loop of each.
    uses: Vec<Vec<(usize, usize)>>,
}

impl HalfEdges {
    pub(super) fn new(shell: &Shell) -> Self {
        let mut uses = vec![Vec::new(); shell.edges().len()];
        let half = |face: usize| {
            move |(side, edge, forward): (Side, FaceEdge, bool)| {
                let edge = edge.edge;
                HalfEdge { face, side, edge, forward }
            }
        };
        let of_face: Vec<Vec<HalfEdge>> = shell
            .faces()
            .iter()
            .enumerate()
            .map(|(index, face)| face.edge_loop(face.same_sense).into_iter().map(half(index)).collect())
            .collect();
        for (face, own) in of_face.iter().enumerate() {
            for (place, half) in own.iter().enumerate() {
                uses[half.edge].push((face, place));
            }
        }
        Self { of_face, uses }
    }

    /// The faces along an edge, a face on both sides of it twice.
    pub(super) fn faces_along(&self, edge: usize) -> impl Iterator<Item = usize> + '_ {
        self.uses[edge].iter().map(|&(face, _)| face)
    }

    /// The loop of a face.
    pub(super) fn of_face(&self, face: usize) -> &[HalfEdge] {
        &self.of_face[face]
    }

    /// The loops of kept edges round some faces; edges that are not kept have these faces on both sides.
    pub(super) fn loops(&self, faces: &[usize], is_kept: impl Fn(usize) -> bool) -> Vec<Vec<HalfEdge>> {
        let mut seen: std::collections::HashSet<(usize, usize)> = std::collections::HashSet::new();
        let mut loops = Vec::new();
        for &face in faces {
            for place in 0..self.of_face[face].len() {
                if !is_kept(self.of_face[face][place].edge) || seen.contains(&(face, place)) {
                    continue;
                }
                let (mut at, mut round) = ((face, place), Vec::new());
                while seen.insert(at) {
                    round.push(self.of_face[at.0][at.1]);
                    at = self.next(at, &is_kept);
                }
                loops.push(round);
            }
        }
        loops
    }

    /// The next half-edge of a loop: round the vertex at the end of this one over the edges that are not kept.
    fn next(&self, (face, place): (usize, usize), is_kept: &impl Fn(usize) -> bool) -> (usize, usize) {
        let after = |(face, place): (usize, usize)| (face, (place + 1) % self.of_face[face].len());
        let mut at = after((face, place));
        // Each half-edge is passed once at most.
        while !is_kept(self.of_face[at.0][at.1].edge) {
            let edge = self.of_face[at.0][at.1].edge;
            let Some(&twin) = self.uses[edge].iter().find(|&&other| other != at) else { return at };
            at = after(twin);
            if at == (face, place) {
                break;
            }
        }
        at
    }
}
