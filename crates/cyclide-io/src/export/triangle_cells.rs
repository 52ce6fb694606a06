//! The parts of a triangle that the cells of a mesh of it stand for: two triangles, or one at the side.

use cyclide::mesh::MeshSource;

/// Barycentric coordinates of the corners of a part, whole numbers.
pub(crate) type Part = [[f64; 3]; 3];

/// A cell of a triangle that is cut into N² parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TriangleCell {
    /// The number of parts N of a side, which is the sum of the coordinates.
    pub(crate) divisions: usize,
    i: usize,
    j: usize,
}

impl TriangleCell {
    /// The cell whose first two coordinates have the ranges of a source.
    pub(crate) fn of(source: &MeshSource) -> Self {
        let n = (1.0 / (source.s[1] - source.s[0])).round();
        let at = |v: f64| (v * n).round() as usize;
        Self { divisions: n as usize, i: at(source.s[0]), j: at(source.t[0]) }
    }

    /// The part that points as the whole does, and the one between its neighbors unless the cell is at the side: in the order of the
    /// mesh.
    pub(crate) fn parts(self) -> impl Iterator<Item = Part> {
        let Self { divisions, i, j } = self;
        let k = divisions.saturating_sub(1 + i + j);
        let upright = [[i + 1, j, k], [i, j + 1, k], [i, j, k + 1]];
        let between = (k > 0).then(|| [[i, j + 1, k], [i + 1, j, k], [i + 1, j + 1, k - 1]]);
        std::iter::once(upright).chain(between).map(|part| part.map(|at| at.map(|v| v as f64)))
    }
}

/// True if cells are all of one triangle, once and in order.
pub(crate) fn are_whole(cells: &[&MeshSource]) -> bool {
    let Some(first) = cells.first() else { return false };
    let n = TriangleCell::of(first).divisions;
    if n == 0 || Some(cells.len()) != n.checked_mul(n + 1).map(|twice| twice / 2) {
        return false;
    }
    let range = |i: usize| [i, i + 1].map(|v| (v as f64 / n as f64).to_bits());
    let places = (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j)));
    let is_at = |((i, j), cell): ((usize, usize), &&MeshSource)| {
        cell.s.map(f64::to_bits) == range(i) && cell.t.map(f64::to_bits) == range(j)
    };
    places.zip(cells).all(is_at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{
        Point3,
        surface::{SphereBlend, TriangleSurface},
    };

    /// Against the kernel's meshes: every vertex is the point at the coordinates of its part.
    #[test]
    fn parts_are_those_of_the_mesh() {
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 3.0, 1.0]].map(Point3::from);
        let control = [[2.0, 1.0, 3.0], [2.0, 1.0, 2.0], [1.0, 1.0, 2.5]].map(Point3::from);
        let surface = TriangleSurface::from(SphereBlend::from_control_points(corners, control).unwrap());
        let made = surface.tessellate_within(0.01, 10_000).unwrap();
        let patch = surface.patch(0).unwrap();
        let cells: Vec<&[MeshSource]> = made.mesh.sources.chunk_by(|a, b| a == b).collect();
        assert!(made.divisions > 3 && are_whole(&cells.iter().map(|own| &own[0]).collect::<Vec<_>>()));
        let mut faces = made.mesh.faces.iter();
        for own in cells {
            let parts: Vec<Part> = TriangleCell::of(&own[0]).parts().collect();
            assert_eq!(parts.len(), own.len());
            for part in parts {
                for (at, corner) in part.iter().zip(faces.next().unwrap().corners()) {
                    assert_eq!(patch.point(*at).unwrap(), made.mesh.positions[corner.position]);
                }
            }
        }
    }
}
