//! Vertices on the edges of a shell, which its faces share, with the normals there.

use super::cuts::Cuts;
use super::strips::Strips;
use crate::base::vector::{Point3, Vec3};
use crate::mesh::surface_mesh::SurfaceMesh;
use crate::topology::{Shell, ShellFace};

/// Normals that differ by less than this (radians) are one.
const SAME_NORMAL: f64 = 1e-6;
/// Normals at a vertex with which a new one is compared. All cells round the tip of a cone meet in one vertex, each with its
/// own normal: they must not all be compared. The faces that meet in a vertex of a net are fewer.
const COMPARED: usize = 16;

/// The vertices of a shell and those on its edges, in a mesh; points to which parameter lines shrink are one.
pub(super) struct BorderVertices {
    /// Index of the shell's first vertex among the positions; the edges' inner ones follow.
    base: usize,
    /// Index of the first inner vertex of each edge.
    edges: Vec<usize>,
    /// Ends of each edge.
    ends: Vec<[usize; 2]>,
    /// For each vertex the one that stands for it.
    stands: Vec<usize>,
    /// Head of the list of normals at each vertex, one more than the index of the entry: the first, then from the newest
    /// to the second.
    heads: Vec<usize>,
    /// Normals with the next entry of the list.
    lists: Vec<(usize, usize)>,
}

impl BorderVertices {
    /// Appends the positions to the mesh.
    pub(super) fn new(shell: &Shell, strips: &Strips, cuts: &Cuts, mesh: &mut SurfaceMesh) -> Self {
        let base = mesh.positions.len();
        mesh.positions.extend_from_slice(shell.vertices());
        let mut edges = Vec::with_capacity(shell.edges().len());
        for (edge, &place) in shell.edges().iter().zip(&strips.edges) {
            edges.push(mesh.positions.len());
            let cuts = cuts.at(place);
            mesh.positions.extend(cuts[1..cuts.len() - 1].iter().map(|&u| edge.curve.point(u)));
        }
        let count = mesh.positions.len() - base;
        let ends = shell.edges().iter().map(|e| [base + e.start, base + e.end]).collect();
        Self { base, edges, ends, stands: (base..base + count).collect(), heads: vec![0; count], lists: Vec::new() }
    }

    /// The vertex at cut `k` of `last` of a side of a face; `None` for a side that is one point.
    pub(super) fn on_side(&self, face: &ShellFace, side: usize, k: usize, last: usize) -> Option<usize> {
        let side = face.sides[side]?;
        let k = if side.forward { k } else { last - k };
        let vertex = match k {
            0 => self.ends[side.edge][0],
            _ if k == last => self.ends[side.edge][1],
            _ => self.edges[side.edge] + k - 1,
        };
        Some(self.standing(vertex))
    }

    fn standing(&self, mut vertex: usize) -> usize {
        while self.stands[vertex - self.base] != vertex {
            vertex = self.stands[vertex - self.base];
        }
        vertex
    }

    /// Makes two vertices one; true if they were two.
    pub(super) fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.standing(a), self.standing(b));
        self.stands[a.max(b) - self.base] = a.min(b);
        a != b
    }

    /// The index of a normal at a vertex: of an equal one among the first and the newest, or of a new one.
    pub(super) fn normal(&mut self, vertex: usize, normal: Vec3, normals: &mut Vec<Vec3>) -> usize {
        let head = self.heads[vertex - self.base];
        let mut entry = head;
        for _ in 0..COMPARED {
            if entry == 0 {
                break;
            }
            let (index, next) = self.lists[entry - 1];
            if (normals[index] - normal).length_squared() <= SAME_NORMAL * SAME_NORMAL {
                return index;
            }
            entry = next;
        }
        normals.push(normal);
        let second = if head > 0 { self.lists[head - 1].1 } else { 0 };
        self.lists.push((normals.len() - 1, second));
        let entry = self.lists.len();
        if head > 0 {
            self.lists[head - 1].1 = entry;
        } else {
            self.heads[vertex - self.base] = entry;
        }
        normals.len() - 1
    }
}

/// Drops the positions from `base` on that no polygon uses.
pub(super) fn compact(mesh: &mut SurfaceMesh, base: usize) {
    let mut used = vec![false; mesh.positions.len() - base];
    let corners = |mesh: &SurfaceMesh| -> Vec<usize> {
        mesh.faces.iter().flat_map(|f| f.corners().iter().map(|c| c.position)).filter(|&p| p >= base).collect()
    };
    for p in corners(mesh) {
        used[p - base] = true;
    }
    let mut next = base;
    let new: Vec<usize> = used
        .iter()
        .map(|&used| {
            next += usize::from(used);
            next - usize::from(used)
        })
        .collect();
    let kept: Vec<Point3> =
        mesh.positions[base..].iter().zip(&used).filter(|(_, used)| **used).map(|(&p, _)| p).collect();
    mesh.positions.truncate(base);
    mesh.positions.extend(kept);
    for face in &mut mesh.faces {
        for corner in face.corners_mut() {
            if corner.position >= base {
                corner.position = new[corner.position - base];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_compared_with_the_first_and_the_newest() {
        let mut border = BorderVertices {
            base: 0,
            edges: Vec::new(),
            ends: Vec::new(),
            stands: vec![0],
            heads: vec![0],
            lists: Vec::new(),
        };
        // The cells round the tip of a cone.
        let around = |k: u32| Vec3::new((f64::from(k) * 1e-3).cos(), (f64::from(k) * 1e-3).sin(), 0.0);
        let mut normals = Vec::new();
        for k in 0..1000 {
            assert_eq!(border.normal(0, around(k), &mut normals), k as usize);
        }
        for k in [0, 999, 990] {
            assert_eq!(border.normal(0, around(k), &mut normals), k as usize);
        }
        assert_eq!(border.normal(0, around(500), &mut normals), 1000, "the way to the older ones is not taken");
    }
}
