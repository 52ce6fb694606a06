//! The front door of the writers: a model in, the bytes of a file out, with what was kept and what was promised.

use crate::export_error::ExportError;
use crate::exported::Exported;
use crate::exporter::Exporter;
use crate::format::Format;
use crate::options::ExportOptions;
use cyclide::Model;

/// Makes the content of a file. The same model and options give the same bytes. For several files of one model
/// [`Exporter`] does once what they share.
///
/// # Errors
/// [`ExportError`], naming the object and contour at fault.
pub fn export(model: &Model, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
    Exporter::new(model)?.export(format, options)
}
