//! Reading our own files: the way from the bytes back to geometry, by which every export is checked.

use crate::deviation::{View, bodies_deviation, curves_deviation, lines_deviation, mesh_deviation};
use crate::export_error::ExportError;
use crate::exported::Exported;
use crate::exporter::Exporter;
use crate::file_content::{FileContent, ReadError};
use crate::format::Format;
use crate::{csv_samples, dxf, glb, nurbs_json, obj, step, stl, svg};
use cyclide::{Correspondence, Model};

/// Reads a file that [`export`](crate::export()) wrote.
///
/// # Errors
/// [`ReadError`]; never panics, whatever the bytes are.
pub fn read_back(format: Format, bytes: &[u8]) -> Result<FileContent, ReadError> {
    match format {
        Format::Step => step::read(bytes),
        Format::Dxf => dxf::read(bytes).map(FileContent::from),
        Format::Svg => svg::read(bytes),
        Format::Csv => csv_samples::read(bytes).map(FileContent::from),
        Format::Json => nurbs_json::read(bytes),
        Format::Glb => glb::read(bytes),
        Format::Obj => obj::read_back(bytes),
        Format::Stl => stl::read(bytes),
        Format::Png => Err(ReadError::NoGeometry { format: format.name() }),
    }
}

/// The largest distance between what a file holds and the model, recomputed from the file's bytes.
///
/// SVG is a drawing of the plane: there both are compared as seen along the third axis, surfaces by the edges and
/// parameter circles that are drawn.
///
/// # Errors
/// [`ReadError`] if the bytes cannot be read, or hold other things than the model.
pub fn file_deviation(model: &Model, format: Format, file: &Exported) -> Result<f64, ReadError> {
    deviation_of(&Exporter::new(model).map_err(not_ready)?, format, file)
}

/// As [`file_deviation`], of a model made ready.
pub(crate) fn deviation_of(exporter: &Exporter<'_>, format: Format, file: &Exported) -> Result<f64, ReadError> {
    let Exporter { model, bodies, bounds } = exporter;
    let view = match format {
        Format::Svg => View::Plan,
        // In DXF: curves of ARC and LINE entities.
        Format::Csv | Format::Dxf | Format::Glb | Format::Obj => View::Points,
        Format::Step | Format::Json | Format::Png | Format::Stl => View::Space,
    };
    let mut content = read_back(format, &file.bytes)?;
    if format == Format::Dxf {
        let counts: Vec<usize> = file.curves.iter().map(Correspondence::piece_count).collect();
        content.curves = dxf::regrouped(content.curves, &counts);
    }
    let curves = match format {
        Format::Stl => 0.0,
        _ => curves_deviation(model, &content.curves, &file.curves, view)?,
    };
    Ok(curves.max(match format {
        Format::Step => bodies_deviation(bodies, &content.bodies, bounds.diagonal())?,
        Format::Glb | Format::Obj | Format::Stl => mesh_deviation(format, bodies, &content.meshes, &file.mesh)?,
        Format::Json => nurbs_json::patch_deviation(bodies, &content.patches)?,
        Format::Svg => lines_deviation(&file.lines, &content.lines)?,
        Format::Dxf | Format::Csv | Format::Png => 0.0,
    }))
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
