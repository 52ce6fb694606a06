//! How the faces of a polyhedron hang together: across their sides, and round their vertices.

use crate::error::{ErrorItem, PolyhedronError, Result, ShellError};
use std::collections::HashMap;

/// A side of a face, from its corner of the same number to the next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct FaceSide {
    pub(super) face: usize,
    pub(super) side: usize,
}

/// Closed loops of vertices, counter-clockwise from outside, that meet two by two along their sides.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Faces {
    loops: Vec<Vec<usize>>,
    /// For each side of each face the same side as the neighbor has it.
    across: Vec<Vec<FaceSide>>,
}

impl Faces {
    /// The faces over so many vertices.
    ///
    /// # Errors
    /// `not-a-face`, `not-closed`, `not-a-shell` (several parts).
    pub(super) fn new(loops: Vec<Vec<usize>>, vertices: usize) -> Result<Self> {
        for (face, corners) in loops.iter().enumerate() {
            check_corners(face, corners, vertices)?;
        }
        let across = neighbors(&loops)?;
        let faces = Self { loops, across };
        faces.check_connected()?;
        Ok(faces)
    }

    pub(super) fn loops(&self) -> &[Vec<usize>] {
        &self.loops
    }

    /// The same side as the neighbor has it.
    pub(super) fn across(&self, at: FaceSide) -> FaceSide {
        self.across[at.face][at.side]
    }

    /// All sides of all faces: every edge twice.
    pub(super) fn sides(&self) -> impl Iterator<Item = FaceSide> + '_ {
        let of = |(face, corners): (usize, &Vec<usize>)| (0..corners.len()).map(move |side| FaceSide { face, side });
        self.loops.iter().enumerate().flat_map(of)
    }

    /// Every edge once, as a side of the face with the smaller number.
    pub(super) fn edges(&self) -> impl Iterator<Item = FaceSide> + '_ {
        self.sides().filter(|&at| at.face < self.across(at).face)
    }

    /// Start and end of a side.
    pub(super) fn ends(&self, at: FaceSide) -> [usize; 2] {
        let corners = &self.loops[at.face];
        [corners[at.side], corners[(at.side + 1) % corners.len()]]
    }

    /// The side that ends where another one starts.
    pub(super) fn before(&self, at: FaceSide) -> FaceSide {
        let n = self.loops[at.face].len();
        FaceSide { side: (at.side + n - 1) % n, ..at }
    }

    /// For each vertex the sides that start there, counter-clockwise from outside: after a face comes the one with the side
    /// that leads back from the vertex. None for vertices that no face has.
    ///
    /// # Errors
    /// `not-a-shell` for a vertex in which parts touch alone.
    pub(super) fn fans(&self, vertices: usize) -> Result<Vec<Vec<FaceSide>>> {
        let mut fans: Vec<Vec<FaceSide>> = vec![Vec::new(); vertices];
        let mut uses = vec![0_usize; vertices];
        for at in self.sides() {
            let [vertex, _] = self.ends(at);
            uses[vertex] += 1;
            if fans[vertex].is_empty() {
                let mut next = at;
                loop {
                    fans[vertex].push(next);
                    next = self.across(self.before(next));
                    if next == at {
                        break;
                    }
                }
            }
        }
        match (0..vertices).find(|&v| fans[v].len() != uses[v]) {
            Some(index) => Err(ShellError::NotAShell {
                item: ErrorItem::Vertex,
                index,
                detail: "parts of the surface touch only at it",
            }
            .into()),
            None => Ok(fans),
        }
    }

    fn check_connected(&self) -> Result<()> {
        let mut reached = vec![false; self.loops.len()];
        let mut open = vec![0];
        if let Some(first) = reached.first_mut() {
            *first = true;
        } else {
            return Err(ShellError::NotAShell { item: ErrorItem::Face, index: 0, detail: "there is none" }.into());
        }
        while let Some(face) = open.pop() {
            for next in &self.across[face] {
                if !std::mem::replace(&mut reached[next.face], true) {
                    open.push(next.face);
                }
            }
        }
        match reached.iter().position(|reached| !reached) {
            Some(index) => {
                Err(ShellError::NotAShell { item: ErrorItem::Face, index, detail: "it is not connected to face 0" }
                    .into())
            }
            None => Ok(()),
        }
    }
}

fn check_corners(face: usize, corners: &[usize], vertices: usize) -> Result<()> {
    let fail = |detail| Err(PolyhedronError::NotAFace { face, detail }.into());
    if corners.len() < 3 {
        return fail("it has fewer than three corners");
    }
    if corners.iter().any(|&v| v >= vertices) {
        return fail("one of its corners does not exist");
    }
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    if sorted.windows(2).any(|w| w[0] == w[1]) {
        return fail("it has the same corner twice");
    }
    Ok(())
}

/// The neighbors of all sides.
fn neighbors(loops: &[Vec<usize>]) -> Result<Vec<Vec<FaceSide>>> {
    let count: usize = loops.iter().map(Vec::len).sum();
    // Directed edges with the first side along them and their number.
    let mut along: HashMap<[usize; 2], (FaceSide, usize)> = HashMap::with_capacity(count);
    let ends = |corners: &[usize], k: usize| [corners[k], corners[(k + 1) % corners.len()]];
    for (face, corners) in loops.iter().enumerate() {
        for side in 0..corners.len() {
            along.entry(ends(corners, side)).or_insert((FaceSide { face, side }, 0)).1 += 1;
        }
    }
    let neighbor = |[first, second]: [usize; 2]| {
        let uses = |ends: [usize; 2]| along.get(&ends).map_or(0, |(_, count)| *count);
        match (uses([first, second]), along.get(&[second, first])) {
            (1, Some(&(side, 1))) => Ok(side),
            (forward, back) => {
                let back = back.map_or(0, |(_, count)| *count);
                Err(PolyhedronError::NotClosed { first, second, forward, back }.into())
            }
        }
    };
    loops.iter().map(|corners| (0..corners.len()).map(|k| neighbor(ends(corners, k))).collect()).collect()
}
