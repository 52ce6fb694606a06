//! Readers and writers of cyclide: model documents and point lists in, exchange files and reports out.
//!
//! Everything works on text and bytes; only the few functions documented to do so access the file system. Writers are pure functions from a
//! [`Model`](cyclide::model::Model) to bytes ([`export()`]). Each format has a reader for the files of this crate ([`read_back`]), so every export
//! is checked from the bytes written ([`file_deviation`]).
//!
//! # By topic
//!
//! | topic | items |
//! |---|---|
//! | documents | [`Document`] ([`DOCUMENT_VERSION`]), [`document_schema`]; [`ObjectSpec`], one of the [`kinds`], with the fields of each; [`KindPage`], the manual of each |
//! | numbers of documents | [`Angle`], [`Coordinates`], [`Directions`], [`Lists`], [`PointSource`] ([`PointFile`]) |
//! | built objects | [`ModelBuilder`], [`BuiltObject`] ([`Facts`]: [`NetFacts`], [`BlendFacts`], [`CellFacts`]; [`ContourFacts`], [`Fitted`], [`InterpolationFacts`], [`RoundedPolyhedron`], [`SmoothChoice`], [`TubeFacts`], [`UnrolledPlane`]), [`Remark`], [`NO_EFFECT`] |
//! | lists of points | [`read_points`] ([`PointTable`], [`PointList`], [`PointRemark`], [`PointColumns`], [`ColumnUnit`], [`unit_of_columns`]) |
//! | meshes | [`read_quad_grid`] ([`ObjGrid`]), [`read_quads`] ([`ObjQuads`], [`ObjLayout`], [`MendedQuads`]), [`MeshFormat`] |
//! | formats | [`Format`], [`InputKind`], [`Exporter`], [`export()`], [`Exported`], [`ExportOptions`] ([`DxfVersion`], [`StepEdges`], [`StepFaces`], [`StepProducts`], [`VtuCells`], [`VtuEncoding`], [`Camera`], [`PictureColour`], [`DEFAULT_MOST_PIECES`]), [`Provenance`] ([`GivenSurface`], [`LaidField`]), [`vtk_multi_block`] |
//! | files read back | [`read_back`], [`FileContent`] ([`FileBody`], [`FileShell`], [`FileFace`], [`FileSurface`], [`FilePatch`], [`FileVolume`], [`FileEdge`], [`FileCurve`], [`FileSample`], [`FileLabels`], [`FileName`]), [`file_deviation`] |
//! | reports | [`Report`] ([`ObjectReport`], [`GeometryReport`], [`FileReport`], [`WarningReport`], [`RangeReport`], [`JointReport`], [`PartReport`], [`ShapeReport`], [`CheckError`]), of curves [`CurvesReport`] ([`CurvatureReport`], [`FairnessReport`], [`FitReport`], [`FitPieces`], [`TorusReport`], [`SegmentCounts`], [`UnrolledReport`], [`PrincipalReport`] ([`GridPieceReport`], [`UmbilicReport`]), [`TightReport`] ([`TightPlaceReport`], [`TIGHTER_THAN_RADIUS`])), of surfaces [`SurfaceReport`] ([`CurvatureRangeReport`], [`SurfaceJointReport`], [`SeamReport`], [`SingularPatchReport`], [`PatchPlace`], [`CircularReport`] ([`ClosingReport`], [`RoundReport`]), [`PolyhedronReport`], [`TeeBlendReport`], [`TubeReport`]), of smooth meshes [`SmoothReport`] ([`ComparisonReport`]), of curves through points [`QbReport`], of volumes [`VolumeReport`] ([`FoldsReport`], [`CellsReport`], [`CellLawReport`], [`CellPlace`]), [`sample_cells`], of motions [`MotionReport`] ([`PlaceReport`], [`PeakReport`], [`ReversalReport`], [`OffChordsReport`], [`MotionClosingReport`], [`DeviationReport`], [`FastReport`], [`FastPlaceReport`], [`SpeedLimits`], [`FASTER_THAN_LIMIT`]), [`MotionSamples`] ([`MotionSample`]) |
//! | samples | [`sample`] ([`SampleOptions`], [`SamplePlaces`], [`Spacing`]), [`CurveSamples`] ([`ContourSamples`], [`CurveSample`], [`FrameTurn`]) |
//! | comparison of kinds of curve | [`Comparison`] ([`ComparedKind`], [`CurveMeasures`]) |
//! | lists for a workshop | [`WorkshopSchedule`] ([`ScheduleOptions`], [`NotScheduled`], [`ScheduleError`]) |
//! | files and streams | with the feature `files`: `read_input`, `read_head`, `read_standard_input`, `MOST_INPUT_BYTES`, `ReadFolder`, `write_file`, `write_files`, `WriteOptions`, `StagedFiles`, `WriteError`, `NotDurable`, `Abandoned`, `is_folder_name`, `same_file`, `leads_to_standard_input`, `leads_to_standard_output` |
//! | errors | [`Error`], [`Result`], [`ReadError`], [`ExportError`], [`Diagnostic`] ([`Source`], [`decode`]), [`did_you_mean`], [`similar`] |
//! | control characters made visible | [`escaped`], [`escaped_lines`], [`escaped_json`] |

mod check;
mod compare;
mod document;
mod drawing;
mod error;
mod export;
#[cfg(feature = "files")]
mod file;
mod formats;
mod input;
mod manual;
mod measure;
mod report;
mod schedule;
mod text;

pub use check::bodies::{FileBody, FileCurve, FileEdge, FileFace, FilePatch, FileShell, FileSurface, FileVolume};
pub use check::file_content::FileContent;
pub use check::file_sample::FileSample;
pub use check::labels::{FileLabels, FileName};
pub use check::read_error::ReadError;
pub use compare::{ComparedKind, Comparison, CurveMeasures};
pub use document::kinds;
pub use document::{
    Angle, BlendFacts, BuiltObject, CellFacts, ContourFacts, Coordinates, DOCUMENT_VERSION, Directions, Document,
    Facts, Fitted, InterpolationFacts, Lists, ModelBuilder, NO_EFFECT, NetFacts, ObjectSpec, PointFile, PointSource,
    Remark, RoundedPolyhedron, SmoothChoice, TubeFacts, UnrolledPlane, document_schema,
};
pub use error::{Error, Result};
pub use export::camera::Camera;
pub use export::error::ExportError;
pub use export::exported::Exported;
pub use export::given_surface::{GivenSurface, LaidField};
pub use export::options::{
    DEFAULT_MOST_PIECES, DxfVersion, ExportOptions, PictureColour, StepEdges, StepFaces, StepProducts, VtuCells,
    VtuEncoding,
};
pub use export::provenance::Provenance;
#[cfg(feature = "files")]
pub use file::{
    Abandoned, NotDurable, StagedFiles, WriteError, WriteOptions, is_folder_name, leads_to_standard_input,
    leads_to_standard_output, same_file, write_file, write_files,
};
pub use formats::{
    Exporter, Format, InputKind, MendedQuads, MeshFormat, ObjGrid, ObjLayout, ObjQuads, export, file_deviation,
    read_back, read_quad_grid, read_quads, vtk_multi_block,
};
#[cfg(feature = "files")]
pub use input::confined::ReadFolder;
#[cfg(feature = "files")]
pub use input::file::{MOST_INPUT_BYTES, read_head, read_input, read_standard_input};
pub use input::points::{ColumnUnit, PointColumns, PointList, PointRemark, PointTable, read_points, unit_of_columns};
pub use manual::KindPage;
pub use measure::joints::SurfaceJointReport;
pub use report::{
    CellLawReport, CellPlace, CellsReport, CheckError, CircularReport, ClosingReport, ComparisonReport, ContourSamples,
    CurvatureRangeReport, CurvatureReport, CurveSample, CurveSamples, CurvesReport, DeviationReport, FASTER_THAN_LIMIT,
    FairnessReport, FastPlaceReport, FastReport, FileReport, FitPieces, FitReport, FoldsReport, FrameTurn,
    GeometryReport, GridPieceReport, JointReport, MotionClosingReport, MotionReport, MotionSample, MotionSamples,
    ObjectReport, OffChordsReport, PartReport, PatchPlace, PeakReport, PlaceReport, PolyhedronReport, PrincipalReport,
    QbReport, RangeReport, Report, ReversalReport, RoundReport, SampleOptions, SamplePlaces, SeamReport, SegmentCounts,
    ShapeReport, SingularPatchReport, SmoothReport, Spacing, SpeedLimits, SurfaceReport, TIGHTER_THAN_RADIUS,
    TeeBlendReport, TightPlaceReport, TightReport, TorusReport, TubeReport, UmbilicReport, UnrolledReport,
    VolumeReport, WarningReport, sample, sample_cells,
};
pub use schedule::{NotScheduled, ScheduleError, ScheduleOptions, WorkshopSchedule};
pub use text::escape::{escaped, escaped_json, escaped_lines};
pub use text::place::{Diagnostic, Source, decode};
pub use text::suggest::{did_you_mean, similar};

/// The examples of the README and of the book are compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
#[doc = include_str!("../../../docs/guide/rust.md")]
struct Book;

/// So is the example of the package's page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
