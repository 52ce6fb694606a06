//! What the user should know of an object: warnings of the kernel with their place, and what reading and making it remarked.

use cyclide::{ShortNumber, Warning, model::Units};

use crate::document::locate::{Step, path_text};
use crate::document::objects::Builder;
use crate::error::hints::words_of_warning;

/// A warning with its place in the input.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "points": [[0, 0], [1, 1], [1, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!((built[0].remarks[0].reason, built[0].remarks[0].index), ("points-merged", Some(2)));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Remark {
    /// Stable kebab-case name.
    pub reason: &'static str,
    /// The contour, from 0, if it concerns one.
    pub contour: Option<usize>,
    /// Which point (or the segment that starts there), from 0, as the input counts them.
    pub index: Option<usize>,
    /// `file:line` or the path in the document, where known.
    pub place: Option<String>,
    /// The sentence.
    pub message: String,
    /// The warning of the kernel with its measures, if any.
    pub warning: Option<Warning>,
}

impl From<Warning> for Remark {
    fn from(warning: Warning) -> Self {
        Self {
            reason: warning.reason(),
            contour: None,
            index: warning.index(),
            place: None,
            message: words_of_warning(&warning),
            warning: Some(warning),
        }
    }
}

impl Builder<'_> {
    /// Adds what is no warning of the kernel.
    pub(in crate::document) fn remark(
        &mut self,
        reason: &'static str,
        contour: Option<usize>,
        index: Option<usize>,
        place: Option<String>,
        message: String,
    ) {
        self.remarks.push(Remark { reason, contour, index, place, message, warning: None });
    }

    /// Adds how a file was read.
    pub(in crate::document) fn note_all(&mut self, file: &str, notes: &[String]) {
        self.notes.extend(notes.iter().map(|note| format!("{file}: {note}")));
    }

    /// Asks whether an angle of more than a turn is meant in degrees, and says how these are written.
    pub(in crate::document) fn ask_about_turns(&mut self, angle: f64, place: Option<String>, remedy: &str) {
        let turns = ShortNumber(angle / std::f64::consts::TAU);
        let message = format!("the angle {angle} is interpreted as radians, {turns} turns: for degrees, {remedy}");
        self.remark("more-than-a-turn", None, None, place, message);
    }

    /// Warns of columns whose names speak of another unit than that of the model.
    pub(in crate::document) fn remark_units(&mut self, file: &str, hints: &[(String, Units)]) {
        let units = self.document.units;
        let mut other = hints.iter().filter(|(_, hint)| *hint != units);
        let names: Vec<&str> = other.clone().map(|(name, _)| name.as_str()).collect();
        if let Some((_, hint)) = other.next() {
            let message = format!(
                "the unit in the columns {} is {}, but that of the model is {}; coordinates are not converted",
                names.join(", "),
                hint.symbol(),
                units.symbol()
            );
            self.remark("units-differ", None, None, Some(file.to_owned()), message);
        }
    }

    /// Adds a warning about a field.
    pub(in crate::document) fn warn_at(&mut self, field: &str, contour: Option<usize>, warning: Warning) {
        let place = self.place_of([Step::from(field)]);
        self.remarks.push(Remark { contour, place, ..warning.into() });
    }

    /// Path of a value of this object, of a document that has a text.
    pub(in crate::document) fn place_of(&self, steps: impl IntoIterator<Item = Step>) -> Option<String> {
        (!self.document.text.is_empty()).then(|| path_text(&self.path(steps)))
    }
}
