//! What was made and what was written: measured on the curves and on the bytes, never taken from the plan.
//!
//! | topic | names |
//! |---|---|
//! | the whole | [`Report`], [`ObjectReport`], [`GeometryReport`], [`FileReport`], [`WarningReport`], [`RangeReport`], [`JointReport`], [`PartReport`], [`ShapeReport`], [`CheckError`] |
//! | curves | [`CurvesReport`], [`CurvatureReport`], [`FairnessReport`], [`FitReport`], [`FitPieces`], [`TorusReport`], [`SegmentCounts`], [`UnrolledReport`], [`PrincipalReport`], [`GridPieceReport`], [`UmbilicReport`], [`TightReport`], [`TightPlaceReport`], [`TIGHTER_THAN_RADIUS`] |
//! | surfaces | [`SurfaceReport`], [`CurvatureRangeReport`], [`SurfaceJointReport`], [`SeamReport`], [`SingularPatchReport`], [`PatchPlace`], [`CircularReport`], [`ClosingReport`], [`RoundReport`], [`PolyhedronReport`], [`TeeBlendReport`], [`TubeReport`] |
//! | smooth meshes | [`SmoothReport`], [`ComparisonReport`] |
//! | curves through points | [`QbReport`] |
//! | volumes | [`VolumeReport`], [`FoldsReport`], [`CellsReport`], [`CellLawReport`], [`CellPlace`], [`sample_cells`] |
//! | motions | [`MotionReport`], [`PlaceReport`], [`PeakReport`], [`ReversalReport`], [`OffChordsReport`], [`MotionClosingReport`], [`DeviationReport`], [`FastReport`], [`FastPlaceReport`], [`SpeedLimits`], [`FASTER_THAN_LIMIT`], [`MotionSamples`], [`MotionSample`] |
//! | samples | [`sample`], [`SampleOptions`], [`SamplePlaces`], [`Spacing`], [`CurveSamples`], [`ContourSamples`], [`CurveSample`], [`FrameTurn`] |

mod cell_laws;
mod closing;
mod curvature;
mod curve_sample;
mod curves;
mod fairness;
mod fast;
mod figures;
mod file;
mod frame_turns;
mod motion;
mod motion_poses;
mod motion_sample;
mod polyhedron;
mod principal;
mod qb;
mod range;
mod sample;
mod sampling;
mod seam;
mod smooth;
mod surface;
mod tee;
mod text;
mod tight;
mod torus;
mod tube;
mod volume;
mod warning;

pub use crate::measure::joints::SurfaceJointReport;

use cyclide::model::{Geometry, SurfaceObject, Units};
use indexmap::IndexMap;
use serde::Serialize;

use crate::document::BuiltObject;
pub use cell_laws::CellLawReport;
pub use closing::{ClosingReport, RoundReport};
pub use curvature::CurvatureRangeReport;
pub use curve_sample::{ContourSamples, CurveSample, CurveSamples, SampleOptions};
pub use curves::{CurvatureReport, CurvesReport, FitPieces, FitReport, JointReport};
pub use fairness::FairnessReport;
pub use fast::{FASTER_THAN_LIMIT, FastPlaceReport, FastReport, SpeedLimits};
pub use file::{CheckError, FileReport};
pub use frame_turns::FrameTurn;
pub use motion::{MotionReport, PeakReport, PlaceReport, ReversalReport};
pub use motion_poses::{DeviationReport, MotionClosingReport, OffChordsReport};
pub use motion_sample::{MotionSample, MotionSamples};
pub use polyhedron::PolyhedronReport;
pub use principal::{GridPieceReport, PrincipalReport, UmbilicReport};
pub use qb::QbReport;
pub use range::RangeReport;
pub use sample::{sample, sample_cells};
pub use sampling::{SamplePlaces, Spacing};
pub use seam::SeamReport;
pub use smooth::{ComparisonReport, SmoothReport};
pub use surface::{CircularReport, PartReport, PatchPlace, ShapeReport, SingularPatchReport, SurfaceReport};
pub use tee::TeeBlendReport;
pub use tight::{TIGHTER_THAN_RADIUS, TightPlaceReport, TightReport};
pub use torus::{SegmentCounts, TorusReport, UnrolledReport};
pub use tube::TubeReport;
pub use volume::{CellPlace, CellsReport, FoldsReport, VolumeReport};
pub use warning::WarningReport;

/// The report on a model and the files made from it. As JSON, values that are not finite are `null`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::Report::new(document.units, &built, None);
/// assert_eq!((report.units, report.objects.len()), ("mm", 1));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Report {
    /// Symbol of the unit of all lengths: `mm`, `m`, ….
    pub units: &'static str,
    /// The objects by name, in the model's order.
    pub objects: IndexMap<String, ObjectReport>,
    /// The files, in the requested order.
    pub files: Vec<FileReport>,
}

/// The report on one object.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// assert_eq!((report.r#type.as_str(), report.warnings.len()), ("circle", 0));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ObjectReport {
    /// The document's word for the construction.
    pub r#type: String,
    /// True for construction geometry, which is not written to files.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub construction: bool,
    /// Its curves, its surfaces, its volumes or its motion.
    #[serde(flatten)]
    pub geometry: GeometryReport,
    /// The warnings.
    pub warnings: Vec<WarningReport>,
    /// How input files were interpreted, if not obvious.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// The report on the geometry of an object, by its kind.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.closed);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GeometryReport {
    /// Curves, or the lines of grids.
    Curves(Box<CurvesReport>),
    /// Surfaces.
    Surface(SurfaceReport),
    /// A smooth surface over triangles.
    Smooth(SmoothReport),
    /// Volumes.
    Volume(Box<VolumeReport>),
    /// A motion.
    Motion(Box<MotionReport>),
}

impl Report {
    /// The report on the objects of a model, without files. `tolerance` is for the weights of curves that have no
    /// exact rational form; `None` uses that of the exports.
    #[must_use]
    pub fn new(units: Units, objects: &[BuiltObject], tolerance: Option<f64>) -> Self {
        let reports = objects.iter().map(|built| (built.item.name.clone(), ObjectReport::new(built, tolerance)));
        Self { units: units.symbol(), objects: reports.collect(), files: Vec::new() }
    }

    /// Adds the parts of all curves that are tighter than a radius, in the reports of these objects and as warnings.
    ///
    /// # Errors
    /// As [`cyclide::curve::tight_places`].
    pub fn with_min_radius(mut self, objects: &[BuiltObject], radius: f64) -> cyclide::Result<Self> {
        for built in objects {
            let found = TightReport::new(built, radius)?;
            if let Some(report) = self.objects.get_mut(&built.item.name)
                && let GeometryReport::Curves(curves) = &mut report.geometry
            {
                report.warnings.extend(found.warnings(curves.contours > 1, self.units));
                curves.tight = Some(found);
            }
        }
        Ok(self)
    }
}

impl Report {
    /// Adds the intervals in which motions exceed speed limits, in the reports of these objects and as warnings.
    #[must_use]
    pub fn with_speed_limits(mut self, objects: &[BuiltObject], limits: SpeedLimits) -> Self {
        for built in objects {
            if let Some(body) = built.item.motion()
                && let Some(report) = self.objects.get_mut(&built.item.name)
                && let GeometryReport::Motion(motion) = &mut report.geometry
            {
                let found = FastReport::new(body, limits);
                report.warnings.extend(found.warnings(self.units));
                motion.fast = Some(found);
            }
        }
        self
    }
}

impl ObjectReport {
    /// Measures an object.
    #[must_use]
    pub fn new(built: &BuiltObject, tolerance: Option<f64>) -> Self {
        let geometry = match &built.item.geometry {
            Geometry::Curves(_) | Geometry::Grids(_) => {
                GeometryReport::Curves(Box::new(CurvesReport::new(built, tolerance)))
            }
            Geometry::Surfaces(surfaces) => match surfaces.iter().find_map(SurfaceObject::as_triangles) {
                Some(triangles) => GeometryReport::Smooth(SmoothReport::new(built, triangles)),
                None => GeometryReport::Surface(SurfaceReport::new(built)),
            },
            Geometry::Volumes(volumes) => {
                let facts = built.facts.cells();
                let quality = facts.map(|facts| facts.quality);
                let mut found = VolumeReport::of(volumes, built.provenance.places.as_ref().zip(quality));
                if let (Some(cells), Some(facts)) = (&mut found.cells, facts) {
                    cells.laws = facts.laws.each_ref().map(CellLawReport::new).to_vec();
                }
                GeometryReport::Volume(Box::new(found))
            }
            Geometry::Motion(body) => GeometryReport::Motion(Box::new(MotionReport::new(body))),
        };
        let warnings = built.remarks.iter().map(WarningReport::from).collect();
        Self {
            r#type: built.provenance.kind.to_owned(),
            construction: built.construction,
            geometry,
            warnings,
            notes: built.notes.clone(),
        }
    }
}
