//! Binary glTF 2.0: meshes of surfaces and lines of curves, for rendering and browsers.

use crate::export::{ExportError, Exported, Job};

/// Writes the model.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let object = job.model.items.first().map(|i| i.name.clone()).unwrap_or_default();
    Err(ExportError::NotInFormat { object, format: "glb", detail: "this format is not written yet" })
}
