//! A model made ready for its files: bodies sewn, size measured and held against the limits, once for all formats.

use std::path::Path;

use crate::export_error::ExportError;
use crate::exported::Exported;
use crate::file_content::ReadError;
use crate::format::Format;
use crate::job::{BodyOf, Job, bodies, boxes, contours};
use crate::options::ExportOptions;
use crate::read_back::deviations_of;
use crate::report::{CheckError, FileReport};
use crate::{csv_samples, dxf, glb, nurbs_json, obj, png, step, stl, svg};
use cyclide::{Aabb, Model};

/// Largest coordinate that is written: products of two of them must not overflow.
const LARGEST_COORDINATE: f64 = 1e120;
/// Smallest size of a curve that is written: its shortest pieces are points that differ by no less than 1e-150.
const SMALLEST_CURVE: f64 = 1e-130;
/// The same of a body, whose faces are of one size.
const SMALLEST_BODY: f64 = 1e-140;

/// Writes a model into several formats and checks the files.
pub struct Exporter<'a> {
    pub(crate) model: &'a Model,
    /// The bodies of all surfaces, in the model's order.
    pub(crate) bodies: Vec<BodyOf<'a>>,
    /// The smallest box around all curves and surfaces.
    pub(crate) bounds: Aabb,
    pub(crate) extents: Extents,
}

impl std::fmt::Debug for Exporter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exporter").field("model", &self.model).field("bounds", &self.bounds).finish_non_exhaustive()
    }
}

/// Size of each part of a model and its distance from the origin, whichever is larger: rounding is relative to
/// coordinates.
#[derive(Default)]
pub(crate) struct Extents {
    pub(crate) curves: Vec<f64>,
    pub(crate) bodies: Vec<f64>,
}

impl<'a> Exporter<'a> {
    /// Makes a model ready.
    ///
    /// # Errors
    /// [`ExportError`] for a model without anything to write, beyond the largest coordinates, or with a surface that has
    /// no body.
    pub fn new(model: &'a Model) -> Result<Self, ExportError> {
        let bodies = bodies(model)?;
        let mut total: Option<Aabb> = None;
        let mut curves = Vec::new();
        let count = contours(model).count();
        for (index, (object, own)) in boxes(model, &bodies).enumerate() {
            curves.push(extent(own));
            if !(own.max_abs() <= LARGEST_COORDINATE) {
                let object = object.to_owned();
                return Err(ExportError::TooLarge { object, value: own.max_abs(), limit: LARGEST_COORDINATE });
            }
            let (size, limit) = (own.diagonal(), if index < count { SMALLEST_CURVE } else { SMALLEST_BODY });
            if size > 0.0 && size < limit {
                return Err(ExportError::TooSmall { object: object.to_owned(), size, limit });
            }
            total = Some(total.map_or(own, |b| b.union(own)));
        }
        // Those of the bodies stand behind those of the curves.
        let of_bodies = curves.split_off(count);
        let extents = Extents { curves, bodies: of_bodies };
        Ok(Self { model, bodies, bounds: total.ok_or(ExportError::Empty)?, extents })
    }

    /// As [`export`](crate::export()).
    ///
    /// # Errors
    /// As [`export`](crate::export()).
    pub fn export(&self, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
        let job = Job::new(self, options)?;
        job.check_exact_form(format)?;
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
        job.title().clone_into(&mut file.title);
        file.written.tolerance = job.tolerance;
        file.written.asked = options.tolerance;
        Ok(file)
    }

    /// As [`file_deviation`](crate::file_deviation).
    ///
    /// # Errors
    /// As [`file_deviation`](crate::file_deviation).
    pub fn deviation(&self, format: Format, file: &Exported) -> Result<f64, ReadError> {
        Ok(deviations_of(self, format, file)?.largest())
    }

    /// As [`FileReport::new`].
    ///
    /// # Errors
    /// As [`FileReport::new`].
    pub fn check(&self, path: &Path, format: Format, file: &Exported) -> Result<FileReport, CheckError> {
        FileReport::of(self, path, format, file)
    }

    /// Size of the model and its distance from the origin, whichever is larger: rounding is relative to coordinates.
    pub(crate) fn extent(&self) -> f64 {
        extent(self.bounds)
    }
}

fn extent(bounds: Aabb) -> f64 {
    bounds.diagonal().max(bounds.max_abs())
}
