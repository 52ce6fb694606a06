//! Faces that are parts of one surface side by side: what lies between them is no line of a drawing.

use cyclide::{
    surface::PatchKind,
    topology::{FaceGeometry as _, FaceSurface, Shell, ShellFace, Side},
};

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

/// For each edge whether a drawing shows it: unless it is inside a plane, or between the strips into which a blend divides a pipe that it touches (the
/// borders of patches of cyclides are shown: they are what a skin is made of).
pub(crate) fn drawn_edges(shell: &Shell) -> Vec<bool> {
    let region = plane_regions(shell);
    let kind = |face: &ShellFace| match &face.surface {
        FaceSurface::Rational(surface) => Some(surface.recognize()),
        FaceSurface::Cyclide(_) => None,
    };
    let kinds: Vec<Option<PatchKind>> = shell.faces().iter().map(kind).collect();
    let is_inside = |along: &[(usize, Side)]| match along {
        [(a, _), (b, _)] if a != b => {
            let strips = kinds[*a].as_ref().zip(kinds[*b].as_ref());
            region[*a] == region[*b] || strips.is_some_and(|(a, b)| continue_each_other(a, b))
        }
        _ => false,
    };
    shell.faces_along_edges().iter().map(|along| !is_inside(along)).collect()
}

/// True if surfaces with a line in common are one plane, cylinder or cone.
fn continue_each_other(a: &PatchKind, b: &PatchKind) -> bool {
    let alike = |x: f64, y: f64| (x - y).abs() <= SAME_NORMAL * x.abs().max(y.abs());
    let parallel = |n: cyclide::Vec3, m: cyclide::Vec3| n.cross(m).length() <= SAME_NORMAL;
    match (a, b) {
        (PatchKind::Plane { frame: a }, PatchKind::Plane { frame: b }) => parallel(a.z(), b.z()),
        (PatchKind::Cylinder { frame: a, radius, .. }, PatchKind::Cylinder { frame: b, radius: other, .. }) => {
            parallel(a.z(), b.z()) && alike(*radius, *other)
        }
        (PatchKind::Cone { frame: a, half_angle, .. }, PatchKind::Cone { frame: b, half_angle: other, .. }) => {
            parallel(a.z(), b.z()) && alike(*half_angle, *other)
        }
        _ => false,
    }
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use cyclide::construct::{PipeTee, TeeBranch, TeeMain};

    /// Of a rounded tee the blend is drawn with its arcs and both borders, and round each end; nothing on the pipes themselves.
    #[test]
    fn strips_of_a_pipe_are_no_lines() {
        let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-90.0, 90.0] };
        let made = PipeTee::new(main, vec![TeeBranch::upright(18.0, 80.0, 5.0)]).unwrap().made().unwrap();
        let body = made.body;
        let shell = body.shells().next().unwrap();
        let drawn = drawn_edges(shell);
        let along = shell.faces_along_edges();
        let kind = |face: usize| match &shell.faces()[face].surface {
            FaceSurface::Rational(surface) => surface.recognize(),
            FaceSurface::Cyclide(patch) => patch.recognize(),
        };
        let is_blend = |face: usize| kind(face) == PatchKind::Cyclide;
        let (mut of_blends, mut at_ends) = (0, 0);
        for (edge, faces) in along.iter().enumerate() {
            let on_blend = faces.iter().any(|(face, _)| is_blend(*face));
            let planes = faces.iter().filter(|(face, _)| matches!(kind(*face), PatchKind::Plane { .. })).count();
            let at_end = planes == 1;
            of_blends += usize::from(on_blend);
            at_ends += usize::from(!on_blend && drawn[edge]);
            assert!(drawn[edge] || !on_blend, "an edge of the blend");
            assert!(!drawn[edge] || on_blend || at_end || faces.len() < 2, "edge {edge} is on a pipe");
        }
        assert!(of_blends > 30 && at_ends > 30, "{of_blends} {at_ends}");
    }
}
