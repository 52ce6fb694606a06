//! Readers and writers of cyclide: model documents and point lists in, exchange files and reports out.
//!
//! Everything works on text and bytes; the only functions that touch the file system are the few that say so.
//! Writers are pure functions from a [`Model`](cyclide::Model) to bytes ([`export()`]); each format has a reader of
//! our own files ([`read_back`]), so that every export is checked from the bytes written ([`file_deviation`]).

mod bodies;
mod camera;
mod csv_samples;
mod deviation;
mod document;
mod drawing;
mod dxf;
mod error;
mod export;
mod export_error;
mod exported;
mod exporter;
mod file;
mod file_content;
mod format;
mod glb;
mod input_file;
mod input_kind;
mod job;
mod labels;
mod lines;
mod mesh;
mod number;
mod nurbs_json;
mod obj;
mod options;
mod palette;
mod parameter_circles;
mod patch_edges;
mod pieces;
mod place;
mod plane_regions;
mod ply;
mod png;
mod points;
mod read_back;
mod report;
mod sample;
mod shape;
mod step;
mod stl;
mod suggest;
mod svg;
mod triangle_cells;
mod triangle_mesh;

pub use bodies::{FileBody, FileEdge, FileFace, FilePatch, FileShell, FileSurface};
pub use camera::Camera;
pub use document::{
    Angle, ArcFitSpec, ArcSpec, ArcSplineSpec, BiarcSpec, BorderCurves, BorderSpec, BorderWord, BuiltObject,
    CircleSpec, CircleSplineSpec, ClampedEnds, Comment, ContourFacts, Coordinates, CyclidePatchSpec, CyclideSpec,
    CyclidicNetSpec, DOCUMENT_VERSION, Document, EffortWord, EndWord, EndsSpec, FairEndPair, FairEndSpec, FairEndWord,
    FairEndsSpec, FairFitSpec, FairSplineSpec, Fitted, FrameSpec, GridSource, Lists, MakeCircularOptions,
    MakeCircularSpec, MeshFile, ModelBuilder, NO_EFFECT, NormalsSpec, ObjectSpec, OffsetSpec, PipeSpec, PlaneSpec,
    PointFile, PointSource, PolyhedronFile, PolylineSpec, RadiiSpec, Remark, RevolutionSpec, RotationSpec,
    RoundedPolyhedron, RuleWord, ScaleSpec, SmoothChoice, SmoothMeshSpec, SmoothPolyhedronSpec, SphereBlendSpec,
    SphereSpec, StepSpec, StraightWord, TargetWord, TransformSpec, TriangleMeshFile, TypeWord, UnitWord, VariantWord,
    document_schema,
};
pub use error::{Error, Result};
pub use export::export;
pub use export_error::ExportError;
pub use exported::Exported;
pub use exporter::Exporter;
pub use file::{
    NotDurable, StagedFiles, WriteOptions, leads_to_standard_input, leads_to_standard_output, same_file, write_file,
    write_files,
};
pub use file_content::{FileContent, FileSample, ReadError};
pub use format::Format;
pub use input_file::{MOST_INPUT_BYTES, read_head, read_input, read_standard_input};
pub use input_kind::InputKind;
pub use labels::{FileLabels, FileName};
pub use obj::{ObjGrid, read_quad_grid};
pub use options::{DEFAULT_MOST_PIECES, DxfVersion, ExportOptions, StepEdges, StepProducts};
pub use place::{Diagnostic, Source, decode};
pub use points::{ColumnUnit, PointColumns, PointList, PointRemark, PointTable, read_points, unit_of_columns};
pub use read_back::{file_deviation, read_back};
pub use report::{
    CheckError, CircularReport, ComparisonReport, CurvatureRangeReport, CurvatureReport, CurvesReport, FairnessReport,
    FileReport, FitPieces, FitReport, GeometryReport, JointReport, ObjectReport, PartReport, PatchPlace,
    PolyhedronReport, RangeReport, Report, SeamReport, ShapeReport, SingularPatchReport, SmoothReport,
    SurfaceJointReport, SurfaceReport, WarningReport,
};
pub use sample::{Spacing, sample};
pub use suggest::{did_you_mean, similar};

/// The example of the README is compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
