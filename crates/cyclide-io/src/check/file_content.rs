//! What a file of ours holds when it is read back.

use crate::check::bodies::{FileBody, FilePatch, FileVolume};
use crate::check::file_sample::FileSample;
use crate::check::labels::FileLabels;
use cyclide::{mesh::SurfaceMesh, model::CurveChain};

/// The contents of a file written by this crate.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let content = read_back(Format::Json, &export(&model, Format::Json, &ExportOptions::default())?.bytes)?;
/// assert!(content.curves.len() == 1 && content.bodies.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct FileContent {
    /// The connected curves, in file order.
    pub curves: Vec<CurveChain>,
    /// The bodies of formats that have them, in file order.
    pub bodies: Vec<FileBody>,
    /// The meshes of formats that have them: one per body, in file order; in STL and PLY one for all.
    pub meshes: Vec<SurfaceMesh>,
    /// The rational patches of JSON, VTU, MFEM and G+Smo, in file order.
    pub patches: Vec<FilePatch>,
    /// The rational volumes of VTU, MFEM and G+Smo, in file order.
    pub volumes: Vec<FileVolume>,
    /// The lines that represent surfaces in a drawing, in file order.
    pub lines: Vec<CurveChain>,
    /// The further columns of the points of each curve in tables, in file order.
    pub samples: Vec<Vec<FileSample>>,
    /// The lines on the vertices of each mesh, as pairs of positions.
    pub mesh_lines: Vec<Vec<[usize; 2]>>,
    /// The unit and the names.
    pub labels: FileLabels,
}

impl From<Vec<CurveChain>> for FileContent {
    fn from(curves: Vec<CurveChain>) -> Self {
        Self { curves, ..Self::default() }
    }
}
