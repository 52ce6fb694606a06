//! Binary STL: triangles of surfaces, for printing.

use crate::export::{ExportError, Exported, Job};

/// Writes the model.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let object = job.model.items.first().map(|i| i.name.clone()).unwrap_or_default();
    Err(ExportError::NotInFormat { object, format: "stl", detail: "this format is not written yet" })
}
