//! How the patches of a surface meet.

use cyclide::{
    curve::CORNER_ANGLE,
    topology::{Shell, surface_joints},
};
use serde::Serialize;

/// How patches meet, measured along every edge that two share.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.joints.gap < 1e-12 && found.joints.creases == 0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
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
