//! How the patches of a surface meet.

use cyclide::{CORNER_ANGLE, Shell, surface_joints};
use serde::Serialize;

/// How patches meet, measured along every edge that two share.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct SurfaceJointReport {
    /// Number of such edges.
    pub count: usize,
    /// Largest distance between the two patches, at equal parameters.
    pub gap: f64,
    /// Edges at which the normals differ by more than a thousandth of a radian.
    pub creases: usize,
    /// Largest angle between the normals at the creases, radians.
    pub crease_angle: f64,
    /// Largest angle between the normals at the other edges, radians.
    pub angle: f64,
}

impl SurfaceJointReport {
    /// Measures the edges of shells that two patches share.
    pub(crate) fn new<'a>(shells: impl Iterator<Item = &'a Shell>) -> Self {
        let mut report = Self::default();
        for joint in shells.flat_map(surface_joints) {
            report.count += 1;
            report.gap = report.gap.max(joint.gap);
            if joint.angle > CORNER_ANGLE {
                report.creases += 1;
                report.crease_angle = report.crease_angle.max(joint.angle);
            } else {
                report.angle = report.angle.max(joint.angle);
            }
        }
        report
    }
}
