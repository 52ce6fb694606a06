//! The front door of the writers: a model in, the bytes of files out, with what was kept and what was promised.

use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::Exported;
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::ExportOptions;
use crate::export::parts::BodyOf;
use crate::export::provenance::Provenance;
use crate::export::ready::ReadyModel;
use crate::formats::Format;
use crate::formats::entry::Entry;
use crate::formats::read_back::deviations_of;
use cyclide::model::{Geometry, Item, Model};

/// Generates the content of a file. The same model and options give the same bytes. For several files of one model,
/// [`Exporter`] does shared work only once.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let file = export(&model, Format::Dxf, &ExportOptions::default())?;
/// assert!(file.exact && file.bytes.starts_with(b"  0\nSECTION"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ExportError`], which names the object and contour at fault.
pub fn export(model: &Model, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
    Exporter::new(model)?.expecting([format], options).export(format, options)
}

/// Writes a model in several formats and checks the files. What the files share is computed once: bodies, the size of the model,
/// and curves as arcs and splines. Each form is kept until the last of the [expected](Self::expecting) files that needs it is
/// written.
///
/// ```
/// use cyclide::{Point3, curve::{Arc, ArcPath}, model::{Model, Units}};
/// use cyclide_io::{ExportOptions, Exporter, Format};
/// let path = ArcPath::new(vec![Arc::segment(Point3::ORIGIN, Point3::new(2.0, 1.0, 0.0))?], false)?;
/// let model = Model::new(Units::Metre).with_curve("path", path);
/// let (formats, options) = ([Format::Dxf, Format::Svg], ExportOptions::default());
/// let exporter = Exporter::new(&model)?.expecting(formats, &options);
/// for format in formats {
///     let file = exporter.export(format, &options)?;
///     assert!(file.exact && exporter.deviation(format, &file)? < 1e-15);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Exporter<'a> {
    pub(crate) ready: ReadyModel<'a>,
}

impl std::fmt::Debug for Exporter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ReadyModel { model, bounds, .. } = &self.ready;
        f.debug_struct("Exporter").field("model", model).field("bounds", bounds).finish_non_exhaustive()
    }
}

impl<'a> Exporter<'a> {
    /// Prepares a model: sews its bodies and measures its size.
    ///
    /// # Errors
    /// [`ExportError`] for a model that has nothing to write, exceeds the largest coordinates, or has a surface
    /// without a body.
    pub fn new(model: &'a Model) -> Result<Self, ExportError> {
        Self::with_provenance(model, &[])
    }

    /// Like [`new`](Self::new), with the provenance of the first objects of the model: files name it, and pictures show the
    /// points of fits. Other objects are described by their geometry.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_provenance(model: &'a Model, provenance: &'a [Provenance]) -> Result<Self, ExportError> {
        Ok(Self { ready: ReadyModel::new(model, provenance)? })
    }

    /// The same, with the list of all files that will be exported, each once. Forms of curves, which are as large as files,
    /// are then dropped after the last file that needs them; otherwise they are kept as long as the exporter.
    #[must_use]
    pub fn expecting(self, formats: impl IntoIterator<Item = Format>, options: &ExportOptions) -> Self {
        let forms: Vec<Forms> = formats.into_iter().map(|format| (format.entry().forms)(options)).collect();
        self.ready.lowered.expect(&forms);
        self
    }

    /// As [`export`](crate::formats::export).
    ///
    /// # Errors
    /// As [`export`](crate::formats::export).
    pub fn export(&self, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
        let job = Job::new(&self.ready, options)?;
        let entry = format.entry();
        check_exact_form(&self.ready.bodies, entry)?;
        let left_out = left_out(self.ready.model, entry)?;
        let made = (entry.write)(&job);
        self.ready.lowered.made((entry.forms)(options));
        let mut file = made?;
        file.notes.extend(left_out);
        job.title().clone_into(&mut file.title);
        file.written.tolerance = job.tolerance;
        file.written.asked = options.tolerance;
        Ok(file)
    }

    /// As [`file_deviation`](crate::formats::file_deviation).
    ///
    /// # Errors
    /// As [`file_deviation`](crate::formats::file_deviation).
    pub fn deviation(&self, format: Format, file: &Exported) -> Result<f64, ReadError> {
        Ok(deviations_of(&self.ready, format, file)?.largest())
    }
}

const ONLY_MOTIONS: &str = "motions: write GLB, or add a `trajectory` or a `swept-surface` of the motion, which are geometry; `cyclide sample` writes the poses as CSV or JSON";

/// Refuses surfaces without an exact form where the format holds exact ones only.
fn check_exact_form(bodies: &[BodyOf<'_>], format: &Entry) -> Result<(), ExportError> {
    match bodies.iter().find(|body| body.body.triangles().is_some()) {
        Some(body) if format.holds_exact_only => {
            Err(ExportError::NoExactForm { object: body.object.to_owned(), format: format.title })
        }
        _ => Ok(()),
    }
}

/// A note on the objects that a format has no place for; refused where nothing remains.
fn left_out(model: &Model, format: &Entry) -> Result<Option<String>, ExportError> {
    let what = |item: &Item| format.loses(&item.geometry);
    let lost: Vec<(&str, &str)> =
        model.items.iter().filter_map(|item| Some((what(item)?, item.name.as_str()))).collect();
    let Some((first_kind, first)) = lost.first().copied() else {
        return Ok(None);
    };
    let is_empty = |item: &Item| match &item.geometry {
        Geometry::Curves(contours) => contours.is_empty(),
        Geometry::Surfaces(surfaces) => surfaces.is_empty(),
        Geometry::Volumes(volumes) => volumes.is_empty(),
        Geometry::Grids(_) | Geometry::Motion(_) => false,
    };
    if !model.items.iter().any(|item| what(item).is_none() && !is_empty(item)) {
        let detail = if first_kind == "motions" { ONLY_MOTIONS } else { first_kind };
        return Err(ExportError::NotInFormat { object: first.to_owned(), format: format.title, detail });
    }
    let of_kind =
        |kind: &str| lost.iter().filter(|(own, _)| *own == kind).map(|(_, name)| *name).collect::<Vec<_>>().join(", ");
    let kinds =
        ["curves", "surfaces", "volumes", "motions"].into_iter().filter(|kind| lost.iter().any(|(own, _)| own == kind));
    let notes = kinds.map(|kind| format!("{kind} are left out ({} cannot hold them): {}", format.title, of_kind(kind)));
    Ok(Some(notes.collect::<Vec<_>>().join("; ")))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use cyclide::{
        Point3,
        construct::FairSplineOptions,
        curve::{Arc, ArcPath, CircleSpline},
        model::CurveObject,
    };

    /// A fair spline and a polygon.
    fn model() -> Model {
        let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [6.0, 5.0, 0.0], [2.0, 6.0, 0.0]].map(Point3::from);
        let options = FairSplineOptions { closed: true, ..Default::default() };
        let spline = CurveObject::CircleSpline(CircleSpline::fair(&points, &options).unwrap());
        let polygon = (0..4).map(|k| Arc::segment(points[k], points[(k + 1) % 4]).unwrap()).collect();
        let polygon = CurveObject::ArcPath(ArcPath::new(polygon, true).unwrap());
        let item = Item::new("it", vec![spline, polygon]);
        Model { items: vec![item], ..Model::default() }
    }

    #[test]
    fn each_form_of_a_contour_is_made_once_and_kept_while_it_is_needed() {
        use Format::{Dxf, Json, Step, Svg};
        let (model, options) = (model(), ExportOptions::default());
        let alone = |format| export(&model, format, &options).unwrap().bytes;
        let files = [Step, Dxf, Json, Svg];
        let kept = [[2, 0], [2, 2], [0, 2], [0, 0]];
        let exporter = Exporter::new(&model).unwrap().expecting(files, &options);
        let open = Exporter::new(&model).unwrap();
        for (format, kept) in files.into_iter().zip(kept) {
            let bytes = alone(format);
            assert_eq!(exporter.export(format, &options).unwrap().bytes, bytes);
            assert_eq!(exporter.ready.lowered.counts()[1], kept, "after {format:?}");
            assert_eq!(open.export(format, &options).unwrap().bytes, bytes);
        }
        assert_eq!([&exporter, &open].map(|exporter| exporter.ready.lowered.counts()[0]), [[2, 2]; 2]);
        // Nothing is known of more: the first keeps nothing for it.
        for exporter in [&exporter, &open] {
            assert_eq!(exporter.export(Svg, &options).unwrap().bytes, alone(Svg));
        }
        assert_eq!(
            [exporter.ready.lowered.counts(), open.ready.lowered.counts()],
            [[[2, 4], [0, 0]], [[2, 2], [2, 2]]]
        );
    }

    #[test]
    fn another_tolerance_is_another_form() {
        let model = model();
        let exporter = Exporter::new(&model).unwrap();
        for (tolerance, made) in [(0.1, 2), (0.01, 4), (0.01, 4)] {
            let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
            let bytes = exporter.export(Format::Dxf, &options).unwrap().bytes;
            assert_eq!(bytes, export(&model, Format::Dxf, &options).unwrap().bytes);
            assert_eq!(exporter.ready.lowered.counts()[0], [0, made]);
        }
    }
}
