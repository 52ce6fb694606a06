//! What a file says besides its geometry: the unit of its lengths, and what its parts are called.
//!
//! A file that is off by 25.4 or has the names of two objects exchanged has the right coordinates: it is found out here.

use crate::check::read_error::ReadError;
use cyclide::model::{Model, Units};

/// Units that differ by less than this part of their length are one: their factors are written as decimals, and some
/// are quotients of two of them.
const SAME_UNIT: f64 = 1e-9;

/// The unit and the names in a file.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let content = read_back(Format::Step, &export(&model, Format::Step, &ExportOptions::default())?.bytes)?;
/// assert!(content.labels.names.iter().any(|name| name.name == "line"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct FileLabels {
    /// Length of one unit of the coordinates in millimeters; `None` if the file does not state it.
    pub unit: Option<f64>,
    /// The names, in a fixed order of each format.
    pub names: Vec<FileName>,
}

/// A name in a file.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let content = read_back(Format::Step, &export(&model, Format::Step, &ExportOptions::default())?.bytes)?;
/// assert!(content.labels.names.iter().any(|name| name.name == "line"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileName {
    /// What it is the name of: `layer`, `node`, ….
    pub of: &'static str,
    /// The name as written in the file, with the replacements and escapes of the format.
    pub name: String,
    /// The number of consecutive curves, bodies or other parts with this name.
    pub count: usize,
}

impl FileName {
    pub(crate) fn new(of: &'static str, name: impl Into<String>, count: usize) -> Self {
        Self { of, name: name.into(), count }
    }
}

/// What the files of a model are called by.
#[derive(Clone, Copy)]
pub(crate) struct Named<'a> {
    pub(crate) model: &'a Model,
    /// The name of the whole.
    pub(crate) title: &'a str,
}

impl FileLabels {
    /// Labels of a file of the model that says its unit.
    pub(crate) fn new(units: Units, names: Vec<FileName>) -> Self {
        Self { unit: Some(units.in_millimetres()), names }
    }

    /// Holds what was read against what the model's labels are.
    ///
    /// # Errors
    /// [`ReadError::Unit`], [`ReadError::Name`], [`ReadError::NameCount`].
    pub(crate) fn check(&self, expected: &Self) -> Result<(), ReadError> {
        if let Some(unit) = expected.unit {
            let same = |found: f64| (found - unit).abs() <= SAME_UNIT * unit;
            if !self.unit.is_some_and(same) {
                return Err(ReadError::Unit { found: self.unit, expected: unit });
            }
        }
        let longer = self.names.len().max(expected.names.len());
        for index in 0..longer {
            let (found, expected) = (self.names.get(index), expected.names.get(index));
            if found == expected {
                continue;
            }
            let of = expected.or(found).map_or("", |name| name.of);
            let number = self.names[..index.min(self.names.len())].iter().filter(|name| name.of == of).count();
            return Err(match (found, expected) {
                (Some(a), Some(b)) if a.of == b.of && a.name == b.name => {
                    ReadError::NameCount { of, name: a.name.clone(), found: a.count, expected: b.count }
                }
                _ => {
                    let name =
                        |name: Option<&FileName>| name.filter(|name| name.of == of).map(|name| name.name.clone());
                    ReadError::Name { of, number, found: name(found), expected: name(expected) }
                }
            });
        }
        Ok(())
    }
}

/// Adds a name, or counts it with the one before where that is the same.
pub(crate) fn push_counted(names: &mut Vec<FileName>, of: &'static str, name: &str) {
    match names.last_mut() {
        Some(last) if last.of == of && last.name == name => last.count += 1,
        _ => names.push(FileName::new(of, name, 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_differs_is_named() {
        let labels = |unit, names: &[(&'static str, &str, usize)]| FileLabels {
            unit,
            names: names.iter().map(|&(of, name, count)| FileName::new(of, name, count)).collect(),
        };
        let right = labels(Some(25.4), &[("layer", "a", 2), ("layer", "b", 1)]);
        let message = |found: &FileLabels| found.check(&right).unwrap_err().to_string();
        assert_eq!(right.check(&right), Ok(()));
        assert_eq!(message(&labels(Some(1.0), &[])), "the unit of the file is 1 mm, that of the model 25.4 mm");
        assert_eq!(message(&labels(None, &[])), "the file does not state its unit; that of the model is 25.4 mm");
        assert_eq!(
            message(&labels(Some(25.4), &[("layer", "b", 2), ("layer", "a", 1)])),
            "layer 0 is `b` in the file, `a` in the model"
        );
        assert_eq!(
            message(&labels(Some(25.4), &[("layer", "a", 1), ("layer", "b", 2)])),
            "layer `a` has 1 parts in the file, 2 in the model"
        );
        assert_eq!(message(&labels(Some(25.4), &[("layer", "a", 2)])), "layer 1, `b`, is not in the file");
        let more = labels(Some(25.4), &[("layer", "a", 2), ("layer", "b", 1), ("group", "c", 1)]);
        assert_eq!(message(&more), "group 0, `c`, is only in the file");
    }
}
