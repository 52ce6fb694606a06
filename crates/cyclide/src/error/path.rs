//! Where in the input of a construction a fault is.

use std::fmt;

use crate::error::{CurveError, Error, PartError};

/// Where in the input of a construction a fault is, as the constructions name their input: `weights[3]`, `branches[2].radius`,
/// `tolerance`; `[4]` is an entry of its main list, the points of a curve.
///
/// ```
/// use cyclide::{Error, error::{ErrorItem, NumberError, PointError}};
/// let error: Error = PointError::ZeroTangent { index: 3 }.into();
/// assert_eq!(error.path().to_string(), "tangents[3]");
/// let error: Error = NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius: -1.0 }.into();
/// assert_eq!(error.in_branch(2, ErrorItem::Radius).path().to_string(), "branches[2].radius");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct FieldPath {
    /// The list and its entry that the rest is part of.
    pub part: Option<(&'static str, usize)>,
    /// The field; the main list without one.
    pub field: Option<&'static str>,
    /// The entry of the field, where that is a list.
    pub index: Option<usize>,
}

impl fmt::Display for FieldPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((list, entry)) = self.part {
            write!(f, "{list}[{entry}].")?;
        }
        f.write_str(self.field.unwrap_or_default())?;
        self.index.map_or(Ok(()), |index| write!(f, "[{index}]"))
    }
}

impl Error {
    /// Where in the input it is, as far as it is known.
    #[must_use]
    pub fn path(&self) -> FieldPath {
        if let Self::Part(PartError::InBranch { branch, what, .. }) = self {
            return FieldPath { part: Some(("branches", *branch)), field: Some(what.word()), index: None };
        }
        if let Self::Part(PartError::InQuad { cause, .. }) = self
            && let path @ FieldPath { field: Some(_), index: None, .. } = cause.path()
        {
            return path;
        }
        if let Self::Curve(CurveError::EmptyInterval { index, .. }) = self {
            // The knot at its end.
            return FieldPath { field: Some("knots"), index: Some(index + 1), part: None };
        }
        let (field, is_list) = self.field();
        FieldPath { part: None, field, index: self.index().filter(|_| is_list) }
    }
}
