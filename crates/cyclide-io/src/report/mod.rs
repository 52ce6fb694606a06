//! What was made and what was written: measured on the curves and on the bytes, never taken from the plan.

mod text;

use std::path::Path;

use cyclide::{Aabb, CurveObject, Lower, Model, Units, bounds, extreme_curvature, joints, length};
use indexmap::IndexMap;
use serde::Serialize;

use crate::document::{BuiltObject, Remark};
use crate::export::{ExportOptions, Exported, Job, default_tolerance};
use crate::format::Format;
use crate::read_back::{ReadError, file_deviation};

/// Joints that turn by more than this (radians) count as corners.
const CORNER_ANGLE: f64 = 1e-3;

/// Part of the model's size that reading numbers back and comparing points may cost: what foreign readers are held to.
const READ_BACK_ROUNDING: f64 = 1e-9;

/// The report on a model and the files made of it. As JSON, values that are not finite are `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// Symbol of the unit of all lengths: `mm`, `m`, ….
    pub units: &'static str,
    /// The objects by name, in the model's order.
    pub objects: IndexMap<String, ObjectReport>,
    /// The files, in the order asked for; empty if none was.
    pub files: Vec<FileReport>,
}

/// The report on one object; largest values are over all its contours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ObjectReport {
    /// The document's word for the construction.
    pub r#type: String,
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
    /// Weights of the exact rational form (within the default tolerance for curves that have none); 1 for arcs.
    /// `None` if there is no such form.
    pub weights: Option<WeightReport>,
    /// What the user should know.
    pub warnings: Vec<WarningReport>,
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

/// The range of the weights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WeightReport {
    /// Smallest weight.
    pub min: f64,
    /// Largest weight.
    pub max: f64,
}

/// A warning with its place in the input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct WarningReport {
    /// Stable kebab-case name.
    pub reason: &'static str,
    /// The sentence; it counts points after repeated ones were merged.
    pub message: String,
    /// The contour, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contour: Option<usize>,
    /// The point (or the segment that starts there), from 0, as the input counts them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub index: Option<usize>,
    /// `file:line` or the path in the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
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

/// The report on one file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FileReport {
    /// Path as given.
    pub path: String,
    /// Name of the format.
    pub format: &'static str,
    /// True if the file's curves are the objects' curves up to rounding.
    pub exact: bool,
    /// Distance between the file's curves and the objects', recomputed from the bytes; `None` for a picture.
    pub deviation: Option<f64>,
    /// The distance that was promised; 0 if exact.
    pub bound: f64,
    /// Size of the file.
    pub bytes: usize,
    /// What the user should know about the file.
    pub notes: Vec<String>,
}

/// A file that does not keep its promise: a fault of this program, not of the input.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The bytes could not be read back.
    #[error("{path}: the bytes made cannot be read back: {source}")]
    Unreadable {
        /// The file.
        path: String,
        /// What the reader said.
        source: ReadError,
    },
    /// The curves read back are farther from the objects than promised.
    #[error("{path}: the curves read back deviate by {deviation:e}, promised was {bound:e}")]
    BeyondBound {
        /// The file.
        path: String,
        /// The distance measured.
        deviation: f64,
        /// The distance promised.
        bound: f64,
    },
}

impl Report {
    /// The report on a model's objects, without files. `tolerance` is for the weights of curves that have no exact
    /// rational form; `None` takes that of the exports.
    #[must_use]
    pub fn new(units: Units, objects: &[BuiltObject], tolerance: Option<f64>) -> Self {
        let reports = objects.iter().map(|built| (built.item.name.clone(), ObjectReport::new(built, tolerance)));
        Self { units: units.symbol(), objects: reports.collect(), files: Vec::new() }
    }
}

impl ObjectReport {
    /// Measures an object.
    #[must_use]
    pub fn new(built: &BuiltObject, tolerance: Option<f64>) -> Self {
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
            r#type: built.item.kind.clone(),
            length: curves().map(length).sum(),
            pieces: curves().map(cyclide::ParamCurve::piece_count).sum(),
            closed: curves().all(cyclide::ParamCurve::is_closed),
            joints: joint,
            curvature,
            weights: weights(&built.item.contours, tolerance),
            warnings: built.remarks.iter().map(WarningReport::from).collect(),
            contours: built.item.contours.len(),
            points: built.contours.iter().map(|c| c.points).sum(),
            fit: fit(built),
        }
    }
}

/// The range of the weights over the contours' rational forms.
fn weights(contours: &[CurveObject], tolerance: Option<f64>) -> Option<WeightReport> {
    let size = contours.iter().map(|c| bounds(c.as_curve())).reduce(Aabb::union)?;
    let tolerance = tolerance.unwrap_or_else(|| default_tolerance(size));
    let mut range = WeightReport { min: f64::INFINITY, max: 0.0 };
    for curve in contours {
        let (chain, _) = curve.to_chain(tolerance).ok()?;
        let (min, max) = chain.weight_range();
        range = WeightReport { min: range.min.min(min), max: range.max.max(max) };
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

impl From<&Remark> for WarningReport {
    fn from(remark: &Remark) -> Self {
        let Remark { reason, contour, index, place, message } = remark.clone();
        Self { reason, message, contour, index, place }
    }
}

impl FileReport {
    /// Reads the bytes of a file back, measures how far its curves are from the model's, and holds that against the
    /// promise.
    ///
    /// # Errors
    /// [`CheckError`]: the file must not be written.
    pub fn new(path: &Path, format: Format, model: &Model, exported: &Exported) -> Result<Self, CheckError> {
        let path = path.display().to_string();
        let bound = exported.bound;
        let deviation = if format.has_geometry() {
            match file_deviation(model, format, exported) {
                Ok(deviation) => Some(deviation),
                Err(source) => return Err(CheckError::Unreadable { path, source }),
            }
        } else {
            None
        };
        let limit = bound + READ_BACK_ROUNDING * extent(model);
        if let Some(deviation) = deviation.filter(|d| !(*d <= limit)) {
            return Err(CheckError::BeyondBound { path, deviation, bound });
        }
        Ok(Self {
            path,
            format: format.name(),
            exact: exported.exact,
            deviation,
            bound,
            bytes: exported.bytes.len(),
            notes: exported.notes.clone(),
        })
    }
}

/// Size of the model and its distance from the origin, whichever is larger: rounding is relative to coordinates.
fn extent(model: &Model) -> f64 {
    let options = ExportOptions::default();
    Job::new(model, &options).map_or(0.0, |job| job.bounds.diagonal().max(job.bounds.max_abs()))
}
