//! What was written: measured on the bytes of the file, held against what was promised.

use std::path::Path;

use cyclide::{ShortNumber, model::Model};
use serde::Serialize;

use crate::check::deviation::{Beyond, READ_BACK_ROUNDING};
use crate::check::read_error::ReadError;
use crate::export::exported::Exported;
use crate::export::ready::ReadyModel;
use crate::formats::{Exporter, Format, deviations_of};

/// Part of a bound, and of that rounding, by which it may be exceeded without a word: the printed bound is raised.
const LAST_DIGITS: f64 = 1e-5;
/// A file that is off by more than this part of the model's size has lost its shape, whatever tolerance was asked for.
const FAR_OFF: f64 = 0.02;
/// Part of the tolerance by which rounding may be above it without a word.
const ABOVE_ASKED: f64 = 0.05;

/// The report on one file.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{Model, Units}};
/// use cyclide_io::{ExportOptions, Exporter, Format};
/// let ring = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
/// let model = Model::new(Units::Millimetre).with_curve("ring", ring);
/// let exporter = Exporter::new(&model)?;
/// let file = exporter.export(Format::Step, &ExportOptions::default())?;
/// let report = exporter.check("ring.step".as_ref(), Format::Step, &file)?;
/// assert!(report.exact && report.bound == 0.0 && report.deviation < Some(1e-12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FileReport {
    /// Path as given.
    pub path: String,
    /// Name of the format.
    pub format: &'static str,
    /// True if the curves in the file equal those of the objects up to rounding, or if the file only names other
    /// files.
    pub exact: bool,
    /// Distance between the curves or meshes in the file and the objects, recomputed from the bytes; `None` for a picture and for a file
    /// that names others.
    pub deviation: Option<f64>,
    /// The bound on that distance; 0 if exact.
    pub bound: f64,
    /// The basis of the bound: `exact`, `proved` or `sampled`.
    pub proof: &'static str,
    /// Size of the file.
    pub bytes: usize,
    /// Notes on the file.
    pub notes: Vec<String>,
}

/// A file that violates its bound: a bug in this program, not a fault of the input.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{Model, Units}};
/// use cyclide_io::{ExportOptions, Exporter, Format, report::CheckError};
/// let ring = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
/// let model = Model::new(Units::Millimetre).with_curve("ring", ring);
/// let exporter = Exporter::new(&model)?;
/// let file = exporter.export(Format::Step, &ExportOptions::default())?;
/// // A file that was damaged on its way.
/// let mut damaged = file.clone();
/// damaged.bytes.truncate(500);
/// let error = exporter.check("ring.step".as_ref(), Format::Step, &damaged).unwrap_err();
/// assert!(matches!(error, CheckError::Unreadable { .. }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The bytes could not be read back.
    #[error("{path}: the file contents cannot be read back: {source}")]
    Unreadable {
        /// The file.
        path: String,
        /// The error of the reader.
        source: Box<ReadError>,
    },
    /// The contents read back deviate from the objects by more than the bound.
    #[error(
        "{path}: {part}: the contents read back deviate by {} from the object (bound {}, limit {})",
        ShortNumber(*.deviation), ShortNumber(*.bound), ShortNumber(*.limit)
    )]
    BeyondBound {
        /// The file.
        path: String,
        /// The curve or body.
        part: String,
        /// The distance measured.
        deviation: f64,
        /// The bound.
        bound: f64,
        /// The largest accepted distance, including the rounding of the numbers.
        limit: f64,
    },
    /// The numbers of the format have too few digits for the part: its center is far away, or its weights differ
    /// greatly. Not a fault of the writer.
    #[error(
        "{path}: {part}: the precision of the numbers in this format causes a deviation of {}, more than {}: use a \
         larger tolerance, write another format, or keep the object away from infinity",
        ShortNumber(*.deviation), ShortNumber(*.limit)
    )]
    TooFewDigits {
        /// The file.
        path: String,
        /// The curve or body.
        part: String,
        /// The distance measured.
        deviation: f64,
        /// The largest distance accepted.
        limit: f64,
    },
    /// A surface over triangles bends so sharply between the points at which its mesh was measured that the mesh deviates by more
    /// than the bound; its vertices are correct. Not a fault of the writer.
    #[error(
        "{path}: {part}: the surface bends too sharply between the points at which its mesh was measured: deviation \
         {}, more than {}; use another tolerance, check the normals, or keep sharp edges as creases",
        ShortNumber(*.deviation), ShortNumber(*.limit)
    )]
    BendsTooSharply {
        /// The file.
        path: String,
        /// The body.
        part: String,
        /// The distance measured.
        deviation: f64,
        /// The largest distance accepted.
        limit: f64,
    },
}

impl Exporter<'_> {
    /// As [`FileReport::new`].
    ///
    /// # Errors
    /// As [`FileReport::new`].
    pub fn check(&self, path: &Path, format: Format, file: &Exported) -> Result<FileReport, CheckError> {
        FileReport::of(&self.ready, path, format, file)
    }
}

impl FileReport {
    /// For a file that only names others, such as the index of VTU files (`vtm`).
    #[must_use]
    pub fn of_index(path: &Path, bytes: usize) -> Self {
        let (path, notes) = (path.display().to_string(), Vec::new());
        Self { path, format: "vtm", exact: true, deviation: None, bound: 0.0, proof: "exact", bytes, notes }
    }

    /// Reads the bytes of a file back, measures the deviation of its curves from those of the model, and compares it with
    /// the bound. For a file of [`Exporter::with_provenance`] use [`Exporter::check`], which knows how the objects are
    /// named.
    ///
    /// # Errors
    /// [`CheckError`]: the file must not be written.
    pub fn new(path: &Path, format: Format, model: &Model, exported: &Exported) -> Result<Self, CheckError> {
        match ReadyModel::new(model, &[]) {
            Ok(ready) => Self::of(&ready, path, format, exported),
            Err(error) => {
                let source = Box::new(ReadError::syntax("the model", error.to_string()));
                Err(CheckError::Unreadable { path: path.display().to_string(), source })
            }
        }
    }

    /// As [`new`](Self::new), of a model made ready.
    fn of(ready: &ReadyModel<'_>, path: &Path, format: Format, exported: &Exported) -> Result<Self, CheckError> {
        let path = path.display().to_string();
        let bound = exported.bound;
        let deviation = if let Some(reading) = &format.entry().reading {
            let deviations = match deviations_of(ready, format, exported) {
                Ok(deviations) => deviations,
                Err(source) => return Err(CheckError::Unreadable { path, source: Box::new(source) }),
            };
            if let Some(Beyond { part, deviation, bound, limit, by_digits, sampled }) =
                deviations.beyond(ready, reading.rounds_by_model, &exported.written)
            {
                return Err(if by_digits {
                    CheckError::TooFewDigits { path, part, deviation, limit }
                } else if sampled {
                    CheckError::BendsTooSharply { path, part, deviation, limit }
                } else {
                    CheckError::BeyondBound { path, part, deviation, bound, limit }
                });
            }
            Some(deviations.largest())
        } else {
            None
        };
        let rounding = READ_BACK_ROUNDING * ready.extent();
        // What rounding has added belongs to the bound that is printed; of an exact file it is what "exact" leaves open,
        // unless its digits do not suffice.
        let beyond = deviation.filter(|d| *d > if exported.exact { rounding } else { bound });
        let exact = exported.exact && beyond.is_none();
        let last_digits = (1.0 + LAST_DIGITS) * bound + LAST_DIGITS * rounding;
        let mut notes = exported.notes.clone();
        let size = ready.bounds.diagonal();
        if let Some(deviation) = deviation.filter(|deviation| *deviation > FAR_OFF * size) {
            let (deviation, size) = (ShortNumber(deviation), ShortNumber(size));
            let remedy = if exported.written.plain_cells {
                "divide its blocks into more `cells`"
            } else {
                "use a smaller tolerance"
            };
            notes.push(format!("the file deviates by {deviation} from a model of size {size}: {remedy}"));
        }
        // A picture is as fine as its pixels, whatever tolerance was asked for, of a fit often.
        let asked = exported.written.asked.filter(|_| format.entry().reading.is_some());
        if let Some(asked) = asked.filter(|asked| !exact && bound > (1.0 + ABOVE_ASKED) * asked) {
            let (bound, asked) = (ShortNumber(bound), ShortNumber(asked));
            notes.push(format!(
                "the tolerance {asked} is not met: with the rounding of the numbers the bound is {bound}"
            ));
        }
        let seen = beyond.filter(|beyond| *beyond > last_digits);
        if let Some(beyond) = seen {
            let beyond = ShortNumber(beyond);
            notes.push(format!("the bound includes the rounding of the numbers: {beyond} in total, as measured"));
        }
        Ok(Self {
            path,
            format: format.name(),
            exact,
            deviation,
            bound: beyond.unwrap_or(bound),
            proof: match exported {
                _ if exact => "exact",
                Exported { sampled: false, .. } if seen.is_none() => "proved",
                _ => "sampled",
            },
            bytes: exported.bytes.len(),
            notes,
        })
    }
}
