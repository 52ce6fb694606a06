//! The edges of the patches as segments between corners of their mesh.

use cyclide::{MeshCorner, SurfaceMesh};
use std::collections::HashMap;

/// Sides of polygons that have no other polygon of the same patch beside them, each once, in the order of the mesh.
pub(super) fn of_patches(mesh: &SurfaceMesh) -> Vec<[MeshCorner; 2]> {
    // Sides by their two positions: the patch they belong to, and whether another one was met.
    let mut sides: HashMap<[usize; 2], usize> = HashMap::new();
    let mut found: Vec<([MeshCorner; 2], (usize, usize), bool)> = Vec::new();
    for (face, source) in mesh.faces.iter().zip(&mesh.sources) {
        let patch = (source.shell, source.face);
        let corners = face.corners();
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            let key = [from.position.min(to.position), from.position.max(to.position)];
            let index = *sides.entry(key).or_insert(found.len());
            match found.get_mut(index) {
                Some((_, first, inner)) => *inner = *first == patch,
                None => found.push(([from, to], patch, false)),
            }
        }
    }
    found.into_iter().filter(|(_, _, inner)| !inner).map(|(side, _, _)| side).collect()
}
