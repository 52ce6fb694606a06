//! Which faces of a shell lie side by side on one and the same plane, cylinder, cone, sphere or torus.

use super::half_edges::HalfEdges;
use super::parameters::outward;
use cyclide::{
    surface::{ParamSurface as _, PatchKind},
    topology::{FaceGeometry as _, Shell, ShellFace},
};

/// How far a face may be from the surface of another one that it is made one with: the first of the model's size, the second, rounding, of
/// coordinates and radii. Far below the tolerance of readers, 1e-7, and near the rounding of points.
const LIMIT: (f64, f64) = (1e-12, 64.0 * f64::EPSILON);
/// Places per parameter at which faces are held against a surface.
const PLACES: u32 = 5;
/// Least cosine of the angle between the normal of a face and the direction that tells the outer side of its surface: cones may be flat.
const SIDE: f64 = 1e-4;
/// The surfaces of so many faces are tried for all of them.
const MOST_TRIED: usize = 8;

/// Faces on one surface, connected by edges.
#[derive(Debug, Clone)]
pub(super) struct Region {
    /// The surface.
    pub(super) kind: PatchKind,
    /// True if the shell's outer side is that of the surface's own normal.
    pub(super) outward: bool,
    /// The faces, ascending.
    pub(super) faces: Vec<usize>,
}

impl Region {
    /// An area in the parameters seen from the shell's outer side.
    pub(super) fn signed(&self, area: f64) -> f64 {
        if self.outward { area } else { -area }
    }
}

/// How far points may be from a surface, or a curve, through these.
pub(super) fn limit(size: f64, largest: f64) -> f64 {
    LIMIT.0 * size + LIMIT.1 * largest
}

/// All faces in regions, in the order of their first faces; `kinds` are the surfaces of the faces, `size` is that of the model.
pub(super) fn regions(shell: &Shell, half_edges: &HalfEdges, kinds: &[PatchKind], size: f64) -> Vec<Region> {
    let faces = shell.faces();
    let senses: Vec<Option<bool>> = faces.iter().zip(kinds).map(|(face, kind)| sense(face, kind)).collect();
    let mut largest_first: Vec<usize> = (0..faces.len()).collect();
    let extents: Vec<f64> = faces.iter().map(extent).collect();
    // The larger a face, the better its surface is known.
    largest_first.sort_by(|&a, &b| extents[b].total_cmp(&extents[a]).then(a.cmp(&b)));
    let mut is_taken = vec![false; faces.len()];
    let mut regions = Vec::new();
    for &seed in &largest_first {
        if std::mem::replace(&mut is_taken[seed], true) {
            continue;
        }
        let mut region = vec![seed];
        if kinds[seed] != PatchKind::Cyclide && senses[seed].is_some() {
            let mut next = 0;
            while let Some(&face) = region.get(next) {
                next += 1;
                for half in half_edges.of_face(face) {
                    for other in half_edges.faces_along(half.edge) {
                        let is_one = !is_taken[other]
                            && std::mem::discriminant(&kinds[other]) == std::mem::discriminant(&kinds[seed])
                            && sense(&faces[other], &kinds[seed]) == senses[seed]
                            && distance(&faces[other], &kinds[seed], size) <= 1.0;
                        if is_one {
                            is_taken[other] = true;
                            region.push(other);
                        }
                    }
                }
            }
        }
        regions.push(of(shell, kinds, region, size));
    }
    regions.sort_by_key(|region| region.faces[0]);
    regions
}

/// The region of these faces, on the surface of one of the first of them from which the others are the least far.
fn of(shell: &Shell, kinds: &[PatchKind], mut faces: Vec<usize>, size: f64) -> Region {
    let seed = faces[0];
    let mut best = kinds[seed];
    if faces.len() > 1 {
        let worst =
            |kind: &PatchKind| faces.iter().map(|&f| distance(&shell.faces()[f], kind, size)).fold(0.0, f64::max);
        let tried = faces.iter().take(MOST_TRIED).map(|&f| (worst(&kinds[f]), f));
        let found = tried.min_by(|a, b| a.0.total_cmp(&b.0));
        best = found.filter(|(worst, _)| *worst <= 1.0).map_or(best, |(_, face)| kinds[face]);
    }
    faces.sort_unstable();
    let outward = sense(&shell.faces()[seed], &best).unwrap_or(shell.faces()[seed].same_sense);
    Region { kind: best, outward, faces }
}

/// Whether the outer side of a face is that of the own normal of a surface on which it lies; `None` of surfaces without, and where the face
/// has no normal.
pub(super) fn sense(face: &ShellFace, kind: &PatchKind) -> Option<bool> {
    let normal = face.surface.normal(0.5, 0.5)?;
    let along = normal.dot(outward(kind, face.surface.point(0.5, 0.5))?.unit()?);
    (along.abs() > SIDE).then_some((along > 0.0) == face.same_sense)
}

/// The largest distance of a face from a surface, as part of what is allowed.
fn distance(face: &ShellFace, kind: &PatchKind, size: f64) -> f64 {
    let place = |i: u32| f64::from(i) / f64::from(PLACES - 1);
    let radius = match kind {
        PatchKind::Sphere { radius, .. } | PatchKind::Cylinder { radius, .. } | PatchKind::Cone { radius, .. } => {
            *radius
        }
        PatchKind::Torus { major_radius, minor_radius, .. } => major_radius + minor_radius,
        PatchKind::Plane { .. } | PatchKind::Cyclide => 0.0,
    };
    let points = (0..PLACES * PLACES).map(|k| face.surface.point(place(k % PLACES), place(k / PLACES)));
    let off = points.map(|p| kind.distance(p).unwrap_or(f64::INFINITY) / limit(size, p.to_vec().max_abs() + radius));
    // Not `max`: what is no number is too far.
    off.fold(0.0, |largest, off| if off > largest || off.is_nan() { off } else { largest })
}

/// The longer diagonal of a face.
fn extent(face: &ShellFace) -> f64 {
    let [a, b, c, d] = face.surface.corners();
    a.distance(d).max(b.distance(c))
}
