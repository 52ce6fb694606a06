//! Readers and writers of cyclide: model documents and point lists in, exchange files and reports out.
//!
//! Everything works on text and bytes; the only functions that touch the file system are the few that say so.
//! Writers are pure functions from a [`Model`](cyclide::Model) to bytes ([`export()`]); each format has a reader of
//! our own files ([`read_back`]), so that every export is checked from the bytes written ([`file_deviation`]).

mod check;
mod document;
mod drawing;
mod error;
mod export;
#[cfg(feature = "files")]
mod file;
mod formats;
mod input;
mod measure;
mod report;
mod text;

pub use check::bodies::{FileBody, FileEdge, FileFace, FilePatch, FileShell, FileSurface};
pub use check::file_content::{FileContent, ReadError};
pub use check::file_sample::FileSample;
pub use check::labels::{FileLabels, FileName};
pub use document::{
    Angle, AnglePairs, ArcFitSpec, ArcSpec, ArcSplineSpec, BiarcSpec, BlendTubeSpec, BorderCurves, BorderSpec,
    BorderWord, BuiltObject, CircleSpec, CircleSplineSpec, CircularSurfaceSpec, ClampedEnds, Comment, ContactBlendSpec,
    ContourFacts, Coordinates, CrossingPipeSpec, CyclidePatchSpec, CyclideSpec, CyclidicNetSpec, DOCUMENT_VERSION,
    Directions, DiskSpec, Document, EllipseBridgeSpec, EndsSpec, FairEndPair, FairEndSpec, FairEndWord, FairEndsSpec,
    FairFitSpec, FairSplineSpec, FamilySpec, Fitted, FrameSpec, FreeOr, GridSource, Lists, MakeCircularOptions,
    MakeCircularSpec, MeshFile, ModelBuilder, NO_EFFECT, NormalsSpec, ObjectSpec, OffsetSpec, PipeCrossingSpec,
    PipeSpec, PipeTeeSpec, PlaneSpec, PlateSpec, PlateWithNeckSpec, PointFile, PointSource, PolygonMeshFile,
    PolylineSpec, RadiiSpec, RadiusLawSpec, RatePairs, Remark, RevolutionSpec, RotationSpec, RoundedPolyhedron,
    RuledSpec, ScaleSpec, SmoothChoice, SmoothMeshSpec, SmoothPolyhedronSpec, SphereBlendSpec, SphereSpec, StepSpec,
    StraightWord, SupportStructureSpec, TeeBlendSpec, TeeBranchSpec, TeeLawSpec, TeeMainSpec, TeeRadiusSpec,
    TorusCircleSpec, TorusKnotSpec, TorusMethod, TorusSeamSpec, TorusSource, TorusSpec, TorusSplineSpec, TransformSpec,
    TubeFacts, TubeSpec, TypeWord, UnrolledPlane, UnrolledSpec, WindingSpec, document_schema,
};
pub use error::{Error, Result};
pub use export::camera::Camera;
pub use export::error::ExportError;
pub use export::exported::Exported;
pub use export::options::{DEFAULT_MOST_PIECES, DxfVersion, ExportOptions, StepEdges, StepProducts};
pub use export::provenance::Provenance;
#[cfg(feature = "files")]
pub use file::{
    NotDurable, StagedFiles, WriteOptions, leads_to_standard_input, leads_to_standard_output, same_file, write_file,
    write_files,
};
pub use formats::{
    Exporter, Format, InputKind, MeshFormat, ObjGrid, export, file_deviation, read_back, read_quad_grid,
};
#[cfg(feature = "files")]
pub use input::file::{MOST_INPUT_BYTES, read_head, read_input, read_standard_input};
pub use input::points::{ColumnUnit, PointColumns, PointList, PointRemark, PointTable, read_points, unit_of_columns};
pub use measure::joints::SurfaceJointReport;
pub use report::{
    CheckError, CircularReport, ComparisonReport, CurvatureRangeReport, CurvatureReport, CurvesReport, FairnessReport,
    FileReport, FitPieces, FitReport, GeometryReport, JointReport, ObjectReport, PartReport, PatchPlace,
    PolyhedronReport, RangeReport, Report, SeamReport, SegmentCounts, ShapeReport, SingularPatchReport, SmoothReport,
    Spacing, SurfaceReport, TeeBlendReport, TorusReport, TubeReport, UnrolledReport, WarningReport, sample,
};
pub use text::place::{Diagnostic, Source, decode};
pub use text::suggest::{did_you_mean, similar};

/// The example of the README is compiled and run with the documentation tests.
#[cfg(all(doctest, feature = "circular-mesh"))]
#[doc = include_str!("../../../README.md")]
struct Readme;
