//! The report on curves.

use cyclide::{
    Aabb,
    curve::{ArcLength, CORNER_ANGLE, bounds, extreme_curvature, joints, length},
    model::{CurveObject, Lower},
};
use serde::Serialize;

use super::qb::QbReport;
use super::range::RangeReport;
use super::{FairnessReport, PrincipalReport, TightReport, TorusReport, UnrolledReport};
use crate::document::{BuiltObject, Fitted};
use crate::export::job::default_tolerance;

/// The report on the curves of an object; largest values are over all its contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert!((found.length - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CurvesReport {
    /// Length of all contours together.
    pub length: f64,
    /// Smooth pieces of all contours together.
    pub pieces: usize,
    /// True if every contour is closed.
    pub closed: bool,
    /// How the pieces meet.
    pub joints: JointReport,
    /// The largest curvature and its location.
    pub curvature: CurvatureReport,
    /// How evenly the curves bend.
    pub fairness: FairnessReport,
    /// Weights of the exact rational form (or of one within the default tolerance for curves without an exact form);
    /// 1 for arcs. `None` if there is no such form.
    pub weights: Option<RangeReport>,
    /// Largest distance from the true curve, if it has no rational form and is approximated: a helix.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub within: Option<f64>,
    /// Number of connected curves.
    pub contours: usize,
    /// Points the object was made from, after merging repeated ones; 0 if it was not made from a list.
    pub points: usize,
    /// The certificate of a fit, over all contours.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<FitReport>,
    /// The parts that are tighter than a given radius, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tight: Option<TightReport>,
    /// For curves of quaternion pairs: their degree, and how they meet their points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub qb: Option<Box<QbReport>>,
    /// For splines on a torus: the torus, and how they run on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torus: Option<TorusReport>,
    /// For curves unrolled with their torus: the change of their lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unrolled: Option<UnrolledReport>,
    /// For the lines of grids along lines of curvature: the umbilics and grids that were found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub principal: Option<Box<PrincipalReport>>,
}

/// Continuity, measured at every joint (the closing one included).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.joints.count == 2 && found.joints.angle < 1e-12 && (found.joints.curvature_jump - 0.5).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct JointReport {
    /// Largest distance between an end and the start that follows.
    pub gap: f64,
    /// Largest angle between the tangents, radians.
    pub angle: f64,
    /// Largest difference of the curvature vectors, in 1/length.
    pub curvature_jump: f64,
    /// Number of joints.
    pub count: usize,
    /// Joints where the direction changes by more than a thousandth of a radian.
    pub corners: usize,
    /// Largest angle at the other joints, radians.
    pub smooth_angle: f64,
    /// Largest difference of the curvature vectors at the other joints, in 1/length.
    pub smooth_curvature_jump: f64,
}

/// The largest curvature.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert!((found.curvature.max - 0.5).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CurvatureReport {
    /// Its value, in 1/length; infinite at a cusp.
    pub max: f64,
    /// Where it is: global parameter of the contour.
    pub t: f64,
    /// Its arc length from the start of the contour.
    pub station: f64,
    /// The contour, from 0.
    pub contour: usize,
    /// The point.
    pub point: [f64; 3],
}

/// The result of a fit; largest values over all contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[0, 0], [1, 0.05], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.fit.is_some_and(|fit| fit.tolerance.is_some_and(|tolerance| fit.deviation <= tolerance)));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FitReport {
    /// The requested bound, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// The deviation that the tolerance limits: of the points from the curve, and for an arc fit also between arcs and
    /// polyline in both directions.
    pub deviation: f64,
    /// Bound on the distance between the curve and the polyline of the points in both directions; for a fair fit that
    /// is not monotone, only of the curve from the polyline.
    pub polyline_deviation: f64,
    /// True if points and curve advance together everywhere.
    pub monotone: bool,
    /// What the curve is made of.
    #[serde(flatten)]
    pub made: FitPieces,
}

/// What a fitted curve is made of, over all contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[0, 0], [1, 0.05], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let fit = found.fit.expect("it is one");
/// assert!(matches!(fit.made, cyclide_io::report::FitPieces::Arcs { .. }));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum FitPieces {
    /// For an arc fit.
    Arcs {
        /// Circular arcs.
        arcs: usize,
        /// Straight segments.
        lines: usize,
        /// Largest angle at a joint, corners excepted, radians.
        max_kink: f64,
        /// Total angle by which the arcs and corners turn, in radians.
        turning: f64,
        /// The largest total angle of the data within the tolerance, in radians.
        turning_limit: f64,
    },
    /// For a fair fit.
    Fair {
        /// Nodes of the splines.
        nodes: usize,
        /// Largest root mean square of a contour's distances of points from the curve.
        rms: f64,
        /// Standard deviation of the noise of the points, if the tolerance follows it.
        #[serde(skip_serializing_if = "Option::is_none")]
        noise: Option<f64>,
        /// The same of their heights, if these have a separate one.
        #[serde(skip_serializing_if = "Option::is_none")]
        noise_z: Option<f64>,
        /// Bound on the deviation in z, if it has a separate tolerance.
        #[serde(skip_serializing_if = "Option::is_none")]
        deviation_z: Option<f64>,
    },
}

impl CurvesReport {
    /// Measures an object.
    pub(super) fn new(built: &BuiltObject, tolerance: Option<f64>) -> Self {
        let curves = || built.item.curves().iter().map(CurveObject::as_curve);
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
        let mut curvature =
            CurvatureReport { max: f64::NEG_INFINITY, t: 0.0, station: 0.0, contour: 0, point: [0.0; 3] };
        for (contour, curve) in curves().enumerate() {
            let extreme = extreme_curvature(curve);
            if extreme.max > curvature.max {
                let point = extreme.point.to_array();
                curvature = CurvatureReport { max: extreme.max, t: extreme.t, station: 0.0, contour, point };
            }
        }
        if let Some(curve) = curves().nth(curvature.contour) {
            curvature.station = ArcLength::new(curve).station(curvature.t);
        }
        let fit = fit(built);
        Self {
            length: curves().map(length).sum(),
            pieces: curves().map(cyclide::curve::ParamCurve::piece_count).sum(),
            closed: curves().all(cyclide::curve::ParamCurve::is_closed),
            joints: joint,
            curvature,
            fairness: FairnessReport::new(built),
            weights: weights(built.item.curves(), tolerance),
            within: built.tolerance.filter(|_| fit.is_none()),
            contours: built.item.curves().len(),
            points: built.contours.iter().map(|c| c.points).sum(),
            fit,
            tight: None,
            qb: QbReport::new(built).map(Box::new),
            torus: TorusReport::new(built),
            unrolled: built.facts.unrolled().map(UnrolledReport::from),
            principal: PrincipalReport::new(built),
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
    let tolerance = built.tolerance;
    built
        .contours
        .iter()
        .filter_map(|facts| facts.fit)
        .map(|fit| FitReport::new(tolerance, &fit))
        .reduce(FitReport::with)
}

/// The larger of two figures that may not be known.
fn larger(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::max)
}

impl FitReport {
    /// The report on one contour.
    fn new(tolerance: Option<f64>, fit: &Fitted) -> Self {
        match fit {
            Fitted::Arcs(c) => Self {
                tolerance,
                deviation: c.deviation,
                polyline_deviation: c.polyline_deviation,
                monotone: c.monotone,
                made: FitPieces::Arcs {
                    arcs: c.arcs,
                    lines: c.lines,
                    max_kink: c.max_kink,
                    turning: c.turning,
                    turning_limit: c.turning_limit,
                },
            },
            Fitted::Fair(c) => Self {
                tolerance,
                deviation: c.deviation,
                polyline_deviation: c.polyline_deviation,
                monotone: c.monotone,
                made: FitPieces::Fair {
                    nodes: c.nodes,
                    rms: c.rms,
                    noise: c.noise,
                    noise_z: c.noise_z,
                    deviation_z: c.deviation_z,
                },
            },
        }
    }

    /// Together with another contour of the object, which was fitted the same way.
    fn with(self, other: Self) -> Self {
        let made = match (self.made, other.made) {
            (
                FitPieces::Arcs { arcs, lines, max_kink, turning, turning_limit },
                FitPieces::Arcs { arcs: a, lines: l, max_kink: k, turning: t, turning_limit: limit },
            ) => FitPieces::Arcs {
                arcs: arcs + a,
                lines: lines + l,
                max_kink: max_kink.max(k),
                turning: turning + t,
                turning_limit: turning_limit + limit,
            },
            (
                FitPieces::Fair { nodes, rms, noise, noise_z, deviation_z },
                FitPieces::Fair { nodes: n, rms: r, noise: of_other, noise_z: z_of_other, deviation_z: off },
            ) => FitPieces::Fair {
                nodes: nodes + n,
                rms: rms.max(r),
                noise: larger(noise, of_other),
                noise_z: larger(noise_z, z_of_other),
                deviation_z: larger(deviation_z, off),
            },
            (made, _) => made,
        };
        Self {
            tolerance: self.tolerance,
            deviation: self.deviation.max(other.deviation),
            polyline_deviation: self.polyline_deviation.max(other.polyline_deviation),
            monotone: self.monotone && other.monotone,
            made,
        }
    }
}
