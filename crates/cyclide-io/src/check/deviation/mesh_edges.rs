//! The edges of patches that are drawn on a mesh.

use crate::check::read_error::ReadError;
use crate::drawing::patch_edges::patch_edges;
use crate::drawing::plane_regions::plane_regions;
use crate::export::mesh_plan::{Cell, MeshPlan};
use crate::export::parts::BodyOf;
use cyclide::mesh::{MeshFace, SurfaceMesh};
use std::collections::HashSet;

/// A vertex as readers know it: the bits of its coordinates.
type Vertex = [u64; 3];

/// Holds the lines on the meshes of a file, one mesh per body, against the edges of the patches: every side of triangles
/// that has no other triangle of the same patch beside it has one line, if edges were asked for. Which patch a triangle is
/// of is known from the plan, and that it lies on it was measured before.
///
/// # Errors
/// [`ReadError::MeshEdges`].
pub(crate) fn check_mesh_edges(
    bodies: &[BodyOf<'_>],
    meshes: &[SurfaceMesh],
    lines: &[Vec<[usize; 2]>],
    plan: &MeshPlan,
    drawn: bool,
) -> Result<(), ReadError> {
    let regions: Vec<Vec<Vec<usize>>> =
        bodies.iter().map(|body| body.body.shells().map(plane_regions).collect()).collect();
    // Parts of one plane are one.
    let patch_of = |cell: &Cell| {
        let (shell, face) = (cell.source.shell, cell.source.face);
        let region = regions.get(cell.body).and_then(|shells| shells.get(shell)?.get(face));
        std::iter::repeat_n((shell, region.copied().unwrap_or(face)), cell.polygons)
    };
    let mut patches = plan.cells.iter().flat_map(patch_of);
    for ((body, mesh), lines) in bodies.iter().zip(meshes).zip(lines) {
        let bits = |position: usize| mesh.positions[position].to_array().map(f64::to_bits);
        let side = |a: Vertex, b: Vertex| if a <= b { [a, b] } else { [b, a] };
        let mut left: HashSet<[Vertex; 2]> = HashSet::new();
        if drawn {
            let corners = |face: &MeshFace| face.corners().first_chunk().map(|own| own.map(|c| bits(c.position)));
            let triangles: Vec<[Vertex; 3]> = mesh.faces.iter().filter_map(corners).collect();
            let own = patches.by_ref().take(mesh.faces.len()).zip(triangles.iter().copied());
            let ends = |(triangle, from): (usize, usize)| [from, (from + 1) % 3].map(|i| triangles[triangle][i]);
            left.extend(patch_edges(own).into_iter().map(ends).map(|[a, b]| side(a, b)));
        }
        let strange = lines.iter().filter(|[a, b]| !left.remove(&side(bits(*a), bits(*b)))).count();
        if strange > 0 || !left.is_empty() {
            return Err(ReadError::MeshEdges { object: body.label(), strange, missing: left.len() });
        }
    }
    Ok(())
}
