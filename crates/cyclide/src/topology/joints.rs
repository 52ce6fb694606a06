//! How the faces of a shell meet at their common edges.

use super::{Shell, ShellFace};
use crate::base::vector::{Point3, Vec3};
use crate::surface::ParamSurface as _;

/// Samples along an edge, both ends included.
const SAMPLES: usize = 9;

/// What was measured along an edge between two faces.
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[must_use]
pub fn surface_joints(shell: &Shell) -> Vec<SurfaceJoint> {
    let mut users: Vec<Vec<(usize, usize, bool)>> = vec![Vec::new(); shell.edges().len()];
    for (index, face) in shell.faces().iter().enumerate() {
        for (side, edge) in face.sides.iter().enumerate() {
            if let Some(edge) = edge {
                users[edge.edge].push((index, side, edge.forward));
            }
        }
    }
    let joint = |(edge, users): (usize, &Vec<(usize, usize, bool)>)| {
        let &[a, b] = users.as_slice() else { return None };
        let mut joint = SurfaceJoint { edge, faces: [a.0, b.0], gap: 0.0, angle: 0.0 };
        for i in 0..SAMPLES {
            let x = i as f64 / (SAMPLES - 1) as f64;
            let on_edge = shell.edges()[edge].arc.point(x);
            let (p, n) = at(&shell.faces()[a.0], a, x);
            let (q, m) = at(&shell.faces()[b.0], b, x);
            joint.gap = joint.gap.max(p.distance(q)).max(p.distance(on_edge)).max(q.distance(on_edge));
            joint.angle = joint.angle.max(n.cross(m).length().atan2(n.dot(m)));
        }
        Some(joint)
    };
    users.iter().enumerate().filter_map(joint).collect()
}

/// Point and outer normal of a face on one of its sides, by the parameter of the edge.
fn at(face: &ShellFace, (_, side, forward): (usize, usize, bool), x: f64) -> (Point3, Vec3) {
    let x = if forward { x } else { 1.0 - x };
    let (s, t) = [(x, 0.0), (x, 1.0), (0.0, x), (1.0, x)][side];
    let normal = face.patch.normal(s, t).unwrap_or_default();
    (face.patch.point(s, t), if face.same_sense { normal } else { -normal })
}
