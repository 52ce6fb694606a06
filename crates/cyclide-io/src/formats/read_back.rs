//! Reading our own files: the way from the bytes back to geometry, by which every export is checked.

use crate::check::deviation::Deviations;
use crate::check::file_content::FileContent;
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::Exported;
use crate::export::ready::ReadyModel;
use crate::formats::Format;
use crate::formats::entry::Reading;
use cyclide::model::Model;

/// Reads a file that [`export`](crate::formats::export) wrote.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// assert_eq!(read_back(Format::Step, &file.bytes)?.curves.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`]; never panics, for any bytes.
pub fn read_back(format: Format, bytes: &[u8]) -> Result<FileContent, ReadError> {
    (reading(format)?.read)(bytes)
}

/// The largest distance between the contents of a file and the model, recomputed from the bytes of the file.
///
/// SVG is a plane drawing: both are compared in the view along the third axis, and surfaces by the drawn edges and
/// parameter circles. For a file of [`Exporter::with_provenance`](crate::Exporter::with_provenance) use
/// [`Exporter::deviation`](crate::Exporter::deviation), which knows how the objects are named.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, file_deviation}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let file = export(&model, Format::Svg, &ExportOptions::default())?;
/// assert!(file_deviation(&model, Format::Svg, &file)? < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`] if the bytes cannot be read, or do not contain the model.
pub fn file_deviation(model: &Model, format: Format, file: &Exported) -> Result<f64, ReadError> {
    Ok(deviations_of(&ReadyModel::new(model, &[]).map_err(not_ready)?, format, file)?.largest())
}

/// As [`file_deviation`], of a model made ready, part by part.
pub(crate) fn deviations_of(ready: &ReadyModel<'_>, format: Format, file: &Exported) -> Result<Deviations, ReadError> {
    (reading(format)?.compare)(&Made { ready, file })
}

/// The way back from a file of a format that holds geometry.
fn reading(format: Format) -> Result<&'static Reading, ReadError> {
    format.entry().reading.as_ref().ok_or(ReadError::NoGeometry { format: format.name() })
}

/// A model that cannot be written, as one whose surface has no body, cannot be compared.
fn not_ready(error: ExportError) -> ReadError {
    match error {
        ExportError::Lowering { object, source, .. } | ExportError::Surface { object, source, .. } => {
            ReadError::Geometry { place: object, source }
        }
        other => ReadError::syntax("the model", other.to_string()),
    }
}
