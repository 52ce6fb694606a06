//! Borders of open nets that nearly coincide.

use crate::measure::seams::measured_seams;
use cyclide::surface::{CyclidicNet, Seam, SeamMeasure};
use serde::Serialize;

/// Two opposite borders of an open net that nearly coincide, as in a tube that was cut open. They do if at every vertex of one, in the grid
/// as given or as made, the distance to the opposite vertex is at most the mean length of the edges that lead to both.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.seams.is_empty());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SeamReport {
    /// The borders: `column` (s = 0 and s = 1) or `row` (t = 0 and t = 1).
    pub border: &'static str,
    /// True if they run in opposite directions, as in a Möbius strip.
    pub reversed: bool,
    /// Largest distance of a point of one border from the other one.
    pub gap: f64,
    /// Largest angle between the normals there, radians.
    pub angle: f64,
}

impl SeamReport {
    /// The seams of a net, those of the grid it was made from among them.
    pub(super) fn all(net: &CyclidicNet, given: &[Seam]) -> Vec<Self> {
        let report = |(seam, measure): (Seam, SeamMeasure)| Self {
            border: ["column", "row"][seam.direction],
            reversed: seam.reversed,
            gap: measure.gap,
            angle: measure.angle,
        };
        measured_seams(net, given).into_iter().map(report).collect()
    }
}
