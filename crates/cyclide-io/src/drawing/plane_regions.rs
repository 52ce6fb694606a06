//! Faces that are parts of one plane side by side: what lies between them is no line of a drawing.

use cyclide::{FaceGeometry as _, Shell, ShellFace, Side};

/// Normals of the same plane differ by less than this.
const SAME_NORMAL: f64 = 1e-6;

/// For each face the first one of its plane; itself for a face that is no plane between straight lines.
pub(crate) fn plane_regions(shell: &Shell) -> Vec<usize> {
    let faces = shell.faces();
    let is_plane: Vec<bool> = faces.iter().map(|face| face.surface.is_plane_quad()).collect();
    let mut first: Vec<usize> = (0..faces.len()).collect();
    for along in shell.faces_along_edges() {
        let &[(a, _), (b, _)] = along.as_slice() else { continue };
        if is_plane[a] && is_plane[b] && same_normal(&faces[a], &faces[b]) {
            let (a, b) = (root(&mut first, a), root(&mut first, b));
            first[a.max(b)] = a.min(b);
        }
    }
    (0..faces.len()).map(|face| root(&mut first, face)).collect()
}

/// For each edge whether a drawing shows it: unless it is inside a plane.
pub(crate) fn drawn_edges(shell: &Shell) -> Vec<bool> {
    let region = plane_regions(shell);
    let is_inside = |along: &[(usize, Side)]| matches!(along, [(a, _), (b, _)] if a != b && region[*a] == region[*b]);
    shell.faces_along_edges().iter().map(|along| !is_inside(along)).collect()
}

fn same_normal(a: &ShellFace, b: &ShellFace) -> bool {
    let normal = |face: &ShellFace| face.outer_normal(0.5, 0.5);
    normal(a).zip(normal(b)).is_some_and(|(n, m)| (n - m).length() <= SAME_NORMAL)
}

/// The first of a region; the way to it is made short.
fn root(first: &mut [usize], mut face: usize) -> usize {
    while first[face] != face {
        first[face] = first[first[face]];
        face = first[face];
    }
    face
}
