//! Warnings as reports have them.

use serde::Serialize;

use crate::document::Remark;

/// A warning with its location in the input.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "points": [[0, 0], [1, 1], [1, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// assert_eq!(report.warnings[0].reason, "points-merged");
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct WarningReport {
    /// Stable kebab-case name.
    pub reason: &'static str,
    /// The message; its point numbers count points after repeated ones were merged.
    pub message: String,
    /// The contour, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contour: Option<usize>,
    /// The point (or the segment that starts there), from 0, as the input counts them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub index: Option<usize>,
    /// `file:line` or the path in the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
}

impl From<&Remark> for WarningReport {
    fn from(remark: &Remark) -> Self {
        let Remark { reason, contour, index, place, message, warning: _ } = remark.clone();
        Self { reason, message, contour, index, place }
    }
}
