//! The report on curves.

use cyclide::{Aabb, CORNER_ANGLE, CurveObject, Lower, bounds, extreme_curvature, joints, length};
use serde::Serialize;

use super::{FairnessReport, RangeReport};
use crate::document::BuiltObject;
use crate::job::default_tolerance;

/// The report on the curves of an object; largest values are over all its contours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurvesReport {
    /// Length of all contours together.
    pub length: f64,
    /// Smooth pieces of all contours together.
    pub pieces: usize,
    /// True if every contour is closed.
    pub closed: bool,
    /// How the pieces meet.
    pub joints: JointReport,
    /// The largest curvature and its place.
    pub curvature: CurvatureReport,
    /// How evenly the curves bend.
    pub fairness: FairnessReport,
    /// Weights of the exact rational form (within the default tolerance for curves that have none); 1 for arcs.
    /// `None` if there is no such form.
    pub weights: Option<RangeReport>,
    /// Number of connected curves.
    pub contours: usize,
    /// Points the object was made from, after merging repeated ones; 0 if it was not made from a list.
    pub points: usize,
    /// The certificate of an arc fit, over all contours.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<FitReport>,
}

/// Continuity, measured at every joint (the closing one included).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct JointReport {
    /// Largest distance between an end and the start that follows.
    pub gap: f64,
    /// Largest angle between the tangents, radians.
    pub angle: f64,
    /// Largest difference of the curvature vectors, in 1/length.
    pub curvature_jump: f64,
    /// Number of joints.
    pub count: usize,
    /// Joints that turn by more than a thousandth of a radian.
    pub corners: usize,
    /// Largest angle at the other joints, radians.
    pub smooth_angle: f64,
    /// Largest difference of the curvature vectors at the other joints, in 1/length.
    pub smooth_curvature_jump: f64,
}

/// The largest curvature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CurvatureReport {
    /// Its value, in 1/length; infinite at a cusp.
    pub max: f64,
    /// Where it is: global parameter of the contour.
    pub t: f64,
    /// The contour, from 0.
    pub contour: usize,
    /// The point.
    pub point: [f64; 3],
}

/// What an arc fit achieved; largest values over all contours.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FitReport {
    /// The bound that was asked for.
    pub tolerance: f64,
    /// The deviation it binds: of the points from the arcs, or both ways between arcs and polyline.
    pub deviation: f64,
    /// Largest distance between the arcs and the polyline of the points, both ways.
    pub polyline_deviation: f64,
    /// Circular arcs.
    pub arcs: usize,
    /// Straight segments.
    pub lines: usize,
    /// Largest angle at a joint, corners excepted, radians.
    pub max_kink: f64,
    /// True if points and arcs advance together everywhere.
    pub monotone: bool,
}

impl CurvesReport {
    /// Measures an object.
    pub(super) fn new(built: &BuiltObject, tolerance: Option<f64>) -> Self {
        let curves = || built.item.contours.iter().map(CurveObject::as_curve);
        let mut joint = JointReport::default();
        for j in curves().flat_map(joints) {
            joint.count += 1;
            joint.gap = joint.gap.max(j.gap);
            joint.angle = joint.angle.max(j.angle);
            joint.curvature_jump = joint.curvature_jump.max(j.curvature_jump);
            if j.angle > CORNER_ANGLE {
                joint.corners += 1;
            } else {
                joint.smooth_angle = joint.smooth_angle.max(j.angle);
                joint.smooth_curvature_jump = joint.smooth_curvature_jump.max(j.curvature_jump);
            }
        }
        let mut curvature = CurvatureReport { max: f64::NEG_INFINITY, t: 0.0, contour: 0, point: [0.0; 3] };
        for (contour, curve) in curves().enumerate() {
            let extreme = extreme_curvature(curve);
            if extreme.max > curvature.max {
                let point = extreme.point.to_array();
                curvature = CurvatureReport { max: extreme.max, t: extreme.t, contour, point };
            }
        }
        Self {
            length: curves().map(length).sum(),
            pieces: curves().map(cyclide::ParamCurve::piece_count).sum(),
            closed: curves().all(cyclide::ParamCurve::is_closed),
            joints: joint,
            curvature,
            fairness: FairnessReport::new(built),
            weights: weights(&built.item.contours, tolerance),
            contours: built.item.contours.len(),
            points: built.contours.iter().map(|c| c.points).sum(),
            fit: fit(built),
        }
    }
}

/// The range of the weights over the contours' rational forms.
fn weights(contours: &[CurveObject], tolerance: Option<f64>) -> Option<RangeReport> {
    let size = contours.iter().map(|c| bounds(c.as_curve())).reduce(Aabb::union)?;
    let tolerance = tolerance.unwrap_or_else(|| default_tolerance(size));
    let mut range = RangeReport::EMPTY;
    for curve in contours {
        let (chain, _) = curve.to_chain(tolerance).ok()?;
        let (min, max) = chain.weight_range();
        range = range.with(min, max);
    }
    Some(range)
}

fn fit(built: &BuiltObject) -> Option<FitReport> {
    let mut total: Option<FitReport> = None;
    for c in built.contours.iter().filter_map(|facts| facts.fit) {
        let sum = total.get_or_insert(FitReport {
            tolerance: built.item.tolerance.unwrap_or_default(),
            deviation: 0.0,
            polyline_deviation: 0.0,
            arcs: 0,
            lines: 0,
            max_kink: 0.0,
            monotone: true,
        });
        sum.deviation = sum.deviation.max(c.deviation);
        sum.polyline_deviation = sum.polyline_deviation.max(c.polyline_deviation);
        sum.max_kink = sum.max_kink.max(c.max_kink);
        sum.arcs += c.arcs;
        sum.lines += c.lines;
        sum.monotone &= c.monotone;
    }
    total
}
