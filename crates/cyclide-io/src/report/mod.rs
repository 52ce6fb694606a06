//! What was made and what was written: measured on the curves and on the bytes, never taken from the plan.

mod curvature;
mod curves;
mod fairness;
mod polyhedron;
mod seam;
mod smooth;
mod surface;
mod text;

use std::path::Path;

use cyclide::{Model, ShortNumber, SurfaceObject, Units};
use indexmap::IndexMap;
use serde::Serialize;

use crate::deviation::{Beyond, READ_BACK_ROUNDING};
use crate::document::{BuiltObject, Remark};
use crate::exported::Exported;
use crate::exporter::Exporter;
use crate::file_content::ReadError;
use crate::format::Format;
use crate::read_back::deviations_of;
pub use curvature::CurvatureRangeReport;
pub use curves::{CurvatureReport, CurvesReport, FitPieces, FitReport, JointReport};
pub use fairness::FairnessReport;
pub use polyhedron::PolyhedronReport;
pub use seam::SeamReport;
pub(crate) use seam::measured_seams;
pub use smooth::{ComparisonReport, SmoothReport};
pub use surface::{
    CircularReport, PartReport, PatchPlace, ShapeReport, SingularPatchReport, SurfaceJointReport, SurfaceReport,
};

/// Part of a bound, and of that rounding, by which it may be exceeded without a word: the printed bound is raised.
const LAST_DIGITS: f64 = 1e-5;
/// A file that is off by more than this part of the model's size has lost its shape, whatever tolerance was asked for.
const FAR_OFF: f64 = 0.02;
/// Part of the tolerance by which rounding may be above it without a word.
const ABOVE_ASKED: f64 = 0.05;

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

/// The report on one object.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ObjectReport {
    /// The document's word for the construction.
    pub r#type: String,
    /// True for construction geometry, which is in no file.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub construction: bool,
    /// Its curves or its surfaces.
    #[serde(flatten)]
    pub geometry: GeometryReport,
    /// What the user should know.
    pub warnings: Vec<WarningReport>,
}

/// What is said about an object's geometry, by its kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GeometryReport {
    /// Curves.
    Curves(CurvesReport),
    /// Surfaces.
    Surface(SurfaceReport),
    /// A smooth surface over triangles.
    Smooth(SmoothReport),
}

/// Smallest and largest value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RangeReport {
    /// Smallest.
    pub min: f64,
    /// Largest.
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

/// The report on one file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FileReport {
    /// Path as given.
    pub path: String,
    /// Name of the format.
    pub format: &'static str,
    /// True if the file's curves are the objects' curves up to rounding.
    pub exact: bool,
    /// Distance between the file's curves or meshes and the objects, recomputed from the bytes; `None` for a picture.
    pub deviation: Option<f64>,
    /// The distance that was promised; 0 if exact.
    pub bound: f64,
    /// What the promise rests on: `exact`, `proved` or `sampled`.
    pub proof: &'static str,
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
        source: Box<ReadError>,
    },
    /// What was read back is farther from the objects than promised.
    #[error(
        "{path}: {part}: what was read back deviates by {}, promised was {}, limit {}",
        ShortNumber(*.deviation), ShortNumber(*.bound), ShortNumber(*.limit)
    )]
    BeyondBound {
        /// The file.
        path: String,
        /// The curve or the body that it is about.
        part: String,
        /// The distance measured.
        deviation: f64,
        /// The distance promised.
        bound: f64,
        /// The largest distance accepted: with the rounding of the numbers.
        limit: f64,
    },
    /// The format's numbers have too few digits for the part: its centre is far away, or its weights are very different.
    /// No fault of the writer.
    #[error(
        "{path}: {part}: the digits of the format's numbers leave it {} off, more than {}: allow a larger tolerance, \
         write another format, or keep the object away from infinity",
        ShortNumber(*.deviation), ShortNumber(*.limit)
    )]
    TooFewDigits {
        /// The file.
        path: String,
        /// The curve or the body that it is about.
        part: String,
        /// The distance measured.
        deviation: f64,
        /// The largest distance accepted.
        limit: f64,
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
        let geometry = if built.item.surfaces.is_empty() {
            GeometryReport::Curves(CurvesReport::new(built, tolerance))
        } else if let Some(triangles) = built.item.surfaces.iter().find_map(SurfaceObject::as_triangles) {
            GeometryReport::Smooth(SmoothReport::new(built, triangles))
        } else {
            GeometryReport::Surface(SurfaceReport::new(built))
        };
        let warnings = built.remarks.iter().map(WarningReport::from).collect();
        Self { r#type: built.item.kind.clone(), construction: built.construction, geometry, warnings }
    }
}

impl RangeReport {
    /// The range of no value yet.
    pub(crate) const EMPTY: Self = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };

    /// The smallest range that holds both.
    pub(crate) fn with(self, min: f64, max: f64) -> Self {
        Self { min: self.min.min(min), max: self.max.max(max) }
    }
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
        match Exporter::new(model) {
            Ok(exporter) => Self::of(&exporter, path, format, exported),
            Err(error) => {
                let source = Box::new(ReadError::syntax("the model", error.to_string()));
                Err(CheckError::Unreadable { path: path.display().to_string(), source })
            }
        }
    }

    /// As [`new`](Self::new), of a model made ready.
    pub(crate) fn of(
        exporter: &Exporter<'_>,
        path: &Path,
        format: Format,
        exported: &Exported,
    ) -> Result<Self, CheckError> {
        let path = path.display().to_string();
        let bound = exported.bound;
        let deviation = if format.has_geometry() {
            let deviations = match deviations_of(exporter, format, exported) {
                Ok(deviations) => deviations,
                Err(source) => return Err(CheckError::Unreadable { path, source: Box::new(source) }),
            };
            if let Some(Beyond { part, deviation, bound, limit, by_digits }) =
                deviations.beyond(exporter, format, &exported.written)
            {
                return Err(if by_digits {
                    CheckError::TooFewDigits { path, part, deviation, limit }
                } else {
                    CheckError::BeyondBound { path, part, deviation, bound, limit }
                });
            }
            Some(deviations.largest())
        } else {
            None
        };
        let rounding = READ_BACK_ROUNDING * exporter.extent();
        // What rounding has added belongs to the bound that is printed; of an exact file it is what "exact" leaves open,
        // unless its digits do not suffice.
        let beyond = deviation.filter(|d| *d > if exported.exact { rounding } else { bound });
        let exact = exported.exact && beyond.is_none();
        let last_digits = (1.0 + LAST_DIGITS) * bound + LAST_DIGITS * rounding;
        let mut notes = exported.notes.clone();
        let size = exporter.bounds.diagonal();
        if let Some(deviation) = deviation.filter(|deviation| *deviation > FAR_OFF * size) {
            let (deviation, size) = (ShortNumber(deviation), ShortNumber(size));
            notes.push(format!("the file is off by {deviation}, the model is {size} large: use a smaller tolerance"));
        }
        let asked = exported.written.asked;
        if let Some(asked) = asked.filter(|asked| !exact && bound > (1.0 + ABOVE_ASKED) * asked) {
            let (bound, asked) = (ShortNumber(bound), ShortNumber(asked));
            notes.push(format!("the tolerance {asked} is not reached: with the rounding of the numbers it is {bound}"));
        }
        let seen = beyond.filter(|beyond| *beyond > last_digits);
        if let Some(beyond) = seen {
            let beyond = ShortNumber(beyond);
            notes.push(format!("the rounding of the numbers is part of the bound: {beyond} in all, as measured"));
        }
        Ok(Self {
            path,
            format: format.name(),
            exact,
            deviation,
            bound: beyond.unwrap_or(bound),
            proof: match exported {
                _ if exact => "exact",
                Exported { sampled: false, .. } if seen.is_none() => "proved",
                _ => "sampled",
            },
            bytes: exported.bytes.len(),
            notes,
        })
    }
}
