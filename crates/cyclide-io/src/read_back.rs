//! Reading our own files: the way from the bytes back to geometry, by which every export is checked.

use crate::deviation::{View, deviation_within};
use crate::export::Exported;
use crate::format::Format;
use crate::{csv_samples, dxf, nurbs_json, step, svg};
use cyclide::{CurveChain, Model, SurfaceMesh};

/// Why bytes could not be read back.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The format holds no geometry.
    #[error("{format} holds no geometry to read back")]
    NoGeometry {
        /// Name of the format.
        format: &'static str,
    },
    /// The text breaks the rules of its format.
    #[error("not readable at {place}: {detail}")]
    Syntax {
        /// Where: a line, a byte or an entity.
        place: String,
        /// What was wrong.
        detail: String,
    },
    /// Something that our writers do not write.
    #[error("{what} at {place} is not something that this program writes")]
    Unsupported {
        /// The thing.
        what: String,
        /// Where.
        place: String,
    },
    /// The numbers describe no curve.
    #[error("no curve at {place}: {source}")]
    Geometry {
        /// Where.
        place: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// The file holds another number of connected curves than the model.
    #[error("{found} connected curves in the file, {expected} in the model")]
    CurveCount {
        /// In the file.
        found: usize,
        /// In the model.
        expected: usize,
    },
    /// A curve is closed in the model and open in the file, or the other way round.
    #[error("curve {curve} is {} in the file and {} in the model", openness(*.found), openness(!*.found))]
    Closedness {
        /// Which connected curve, from 0.
        curve: usize,
        /// Closed in the file.
        found: bool,
    },
}

fn openness(closed: bool) -> &'static str {
    if closed { "closed" } else { "open" }
}

impl ReadError {
    pub(crate) fn syntax(place: impl Into<String>, detail: impl Into<String>) -> Self {
        Self::Syntax { place: place.into(), detail: detail.into() }
    }
    pub(crate) fn unsupported(what: impl Into<String>, place: impl Into<String>) -> Self {
        Self::Unsupported { what: what.into(), place: place.into() }
    }
}

/// What a file of ours holds.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct FileContent {
    /// The connected curves, in file order.
    pub curves: Vec<CurveChain>,
    /// The meshes of formats that have them: one per body, in file order; in STL one for all.
    pub meshes: Vec<SurfaceMesh>,
}

impl From<Vec<CurveChain>> for FileContent {
    fn from(curves: Vec<CurveChain>) -> Self {
        Self { curves, ..Self::default() }
    }
}

/// Reads a file that [`export`](crate::export()) wrote.
///
/// # Errors
/// [`ReadError`]; never panics, whatever the bytes are.
pub fn read_back(format: Format, bytes: &[u8]) -> Result<FileContent, ReadError> {
    match format {
        Format::Step => step::read(bytes).map(FileContent::from),
        Format::Dxf => dxf::read(bytes).map(FileContent::from),
        Format::Svg => svg::read(bytes).map(FileContent::from),
        Format::Csv => csv_samples::read(bytes).map(FileContent::from),
        Format::Json => nurbs_json::read(bytes).map(FileContent::from),
        Format::Glb | Format::Obj | Format::Stl | Format::Png => Err(ReadError::NoGeometry { format: format.name() }),
    }
}

/// The largest distance between what a file holds and the model, recomputed from the file's bytes.
///
/// SVG is a drawing of the plane: there both are compared as seen along the third axis.
///
/// # Errors
/// [`ReadError`] if the bytes cannot be read, or hold other things than the model.
pub fn file_deviation(model: &Model, format: Format, file: &Exported) -> Result<f64, ReadError> {
    let view = match format {
        Format::Svg => View::Plan,
        // In DXF: curves of ARC and LINE entities.
        Format::Csv | Format::Dxf => View::Points,
        Format::Step | Format::Json | Format::Png | Format::Glb | Format::Obj | Format::Stl => View::Space,
    };
    deviation_within(model, &read_back(format, &file.bytes)?.curves, view)
}
