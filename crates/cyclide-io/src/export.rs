//! The front door of the writers: a model in, the bytes of a file out, with what was kept and what was promised.

use crate::export_error::ExportError;
use crate::exported::Exported;
use crate::format::Format;
use crate::job::Job;
use crate::options::ExportOptions;
use crate::{csv_samples, dxf, glb, nurbs_json, obj, png, step, stl, svg};
use cyclide::Model;

/// Makes the content of a file. The same model and options give the same bytes.
///
/// # Errors
/// [`ExportError`], naming the object and contour at fault.
pub fn export(model: &Model, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
    let job = Job::new(model, options)?;
    let left_out = job.left_out(format)?;
    let file = match format {
        Format::Step => step::write(&job),
        Format::Dxf => dxf::write(&job),
        Format::Svg => svg::write(&job),
        Format::Csv => csv_samples::write(&job),
        Format::Json => nurbs_json::write(&job),
        Format::Png => png::write(&job),
        Format::Glb => glb::write(&job),
        Format::Obj => obj::write(&job),
        Format::Stl => stl::write(&job),
    };
    let mut file = file?;
    file.notes.extend(left_out);
    Ok(file)
}
