//! How the faces of a shell meet at their common edges.

use super::{Shell, ShellFace, Side};
use crate::base::vector::{Point3, Vec3};
use crate::surface::ParamSurface as _;

/// Samples along an edge, both ends included.
const SAMPLES: usize = 9;

/// What was measured along an edge between two faces.
///
/// ```
/// use cyclide::{Point3, construct::ConvexPolyhedron, topology::surface_joints};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let rounded = ConvexPolyhedron::hull(&corners)?.offset(0.1)?;
/// assert!(surface_joints(&rounded.outer).iter().all(|joint| joint.angle < 1e-7 && joint.gap < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SurfaceJoint {
    /// Index of the edge.
    pub edge: usize,
    /// Indices of the two faces.
    pub faces: [usize; 2],
    /// Largest distance between the faces, and of either from the edge, at equal parameters.
    pub gap: f64,
    /// Largest angle between the outer normals, radians.
    pub angle: f64,
}

/// Every edge that two faces share, measured at nine places of each: faces that share an edge have its parameter.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::Body};
/// let ring = Body { outer: DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?, voids: Vec::new() };
/// assert!(cyclide::topology::surface_joints(&ring.outer).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn surface_joints(shell: &Shell) -> Vec<SurfaceJoint> {
    let joint = |(edge, users): (usize, &Vec<(usize, Side)>)| {
        let &[a, b] = users.as_slice() else { return None };
        let mut joint = SurfaceJoint { edge, faces: [a.0, b.0], gap: 0.0, angle: 0.0 };
        for i in 0..SAMPLES {
            let x = i as f64 / (SAMPLES - 1) as f64;
            let on_edge = shell.edges()[edge].curve.point(x);
            let (p, n) = at(&shell.faces()[a.0], a.1, x);
            let (q, m) = at(&shell.faces()[b.0], b.1, x);
            joint.gap = joint.gap.max(p.distance(q)).max(p.distance(on_edge)).max(q.distance(on_edge));
            joint.angle = joint.angle.max(n.cross(m).length().atan2(n.dot(m)));
        }
        Some(joint)
    };
    shell.faces_along_edges().iter().enumerate().filter_map(joint).collect()
}

/// Point and outer normal of a face on one of its sides, by the parameter of the edge.
fn at(face: &ShellFace, side: Side, x: f64) -> (Point3, Vec3) {
    let (s, t) = side.place(face.side(side).map_or(x, |edge| edge.turned(x)));
    (face.surface.point(s, t), face.outer_normal(s, t).unwrap_or_default())
}
