//! Reading our own files: the way from the bytes back to geometry, by which every export is checked.

use crate::deviation::{
    Deviations, SampleCheck, View, bodies_deviation, check_mesh_edges, curves_deviation, lines_deviation,
    mesh_deviation,
};
use crate::export_error::ExportError;
use crate::exported::{Exported, Written};
use crate::exporter::Exporter;
use crate::file_content::{FileContent, ReadError};
use crate::format::Format;
use crate::labels::{FileLabels, Named};
use crate::{csv_samples, dxf, glb, nurbs_json, obj, step, stl, svg};
use cyclide::Model;

/// Reads a file that [`export`](crate::export()) wrote.
///
/// # Errors
/// [`ReadError`]; never panics, whatever the bytes are.
pub fn read_back(format: Format, bytes: &[u8]) -> Result<FileContent, ReadError> {
    match format {
        Format::Step => step::read(bytes),
        Format::Dxf => dxf::read(bytes).map(dxf::Drawing::into_content),
        Format::Svg => svg::read(bytes),
        Format::Csv => csv_samples::read_whole(bytes),
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
    Exporter::new(model).map_err(not_ready)?.deviation(format, file)
}

/// As [`file_deviation`], of a model made ready, part by part.
pub(crate) fn deviations_of(exporter: &Exporter<'_>, format: Format, file: &Exported) -> Result<Deviations, ReadError> {
    let Exporter { model, bodies, bounds, .. } = exporter;
    let Written { curves: written, mesh, lines, mesh_edges, .. } = &file.written;
    let view = match format {
        Format::Svg => View::Plan,
        // In DXF: curves of ARC and LINE entities.
        Format::Csv | Format::Dxf | Format::Glb | Format::Obj => View::Points,
        Format::Step | Format::Json | Format::Png | Format::Stl => View::Space,
    };
    let (content, labels) = read_with_labels(exporter, format, file)?;
    let curves = match format {
        Format::Stl => Vec::new(),
        _ => curves_deviation(model, &content.curves, written, view)?,
    };
    let bodies = match format {
        Format::Step => bodies_deviation(bodies, &content.bodies, bounds.diagonal())?,
        Format::Glb | Format::Obj | Format::Stl => mesh_deviation(format, bodies, &content.meshes, mesh)?,
        Format::Json => nurbs_json::patch_deviation(bodies, &content.patches)?,
        Format::Svg | Format::Dxf | Format::Csv | Format::Png => Vec::new(),
    };
    if format == Format::Glb {
        check_mesh_edges(&exporter.bodies, &content.meshes, &content.mesh_lines, mesh, *mesh_edges)?;
    }
    let lines =
        if format == Format::Svg { lines_deviation(&exporter.bodies, lines, &content.lines)? } else { Vec::new() };
    labels.map_or(Ok(()), |labels| content.labels.check(&labels))?;
    Ok(Deviations { curves, bodies, lines })
}

/// What a file holds, and the labels that the model's file has.
fn read_with_labels(
    exporter: &Exporter<'_>,
    format: Format,
    file: &Exported,
) -> Result<(FileContent, Option<FileLabels>), ReadError> {
    let Exporter { model, bodies, .. } = exporter;
    let named = Named { model, title: &file.title };
    if format == Format::Dxf {
        let counts: Vec<usize> = file.written.curves.iter().map(|curve| curve.parts.piece_count()).collect();
        let drawing = dxf::read(&file.bytes)?.regrouped(&counts);
        let labels = drawing.labels(model).ok_or_else(|| ReadError::unsupported("this version", "$ACADVER"))?;
        return Ok((drawing.into_content(), Some(labels)));
    }
    if format == Format::Csv {
        let mut check = SampleCheck::new(model, &file.written.curves);
        let content = csv_samples::read(&file.bytes, |curve, sample| check.row(curve, &sample))?;
        check.finish()?;
        return Ok((content, Some(csv_samples::labels(model))));
    }
    let content = read_back(format, &file.bytes)?;
    let labels = match format {
        Format::Step => Some(step::labels(named, bodies, &content.labels)),
        Format::Svg => Some(svg::labels(named, &file.written)),
        Format::Json => Some(nurbs_json::labels(model, bodies, &file.written)),
        Format::Glb => Some(glb::labels(named, bodies, &content.mesh_lines)),
        Format::Obj => Some(obj::labels(model, bodies)),
        Format::Stl => Some(stl::labels(named)),
        Format::Csv | Format::Dxf | Format::Png => None,
    };
    Ok((content, labels))
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
