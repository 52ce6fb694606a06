//! The range of a figure.

use serde::Serialize;

/// Smallest and largest value.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.weights.min > 0.0 && found.weights.min <= found.weights.max);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RangeReport {
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
}

impl RangeReport {
    /// The range of no value yet.
    pub(crate) const EMPTY: Self = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };

    /// The smallest range that holds both.
    pub(crate) fn with(self, min: f64, max: f64) -> Self {
        Self { min: self.min.min(min), max: self.max.max(max) }
    }
}
