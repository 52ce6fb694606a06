//! The report on the blends of a tee.

use cyclide::{ShortNumber, construct::TeeBlendFacts};
use serde::Serialize;

use super::range::RangeReport;

/// A blend of a branch with its main pipe.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": 3}]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// // One radius to a thousandth.
/// assert!((found.blends[0].radius.min - 3.0).abs() < 3e-3 + 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TeeBlendReport {
    /// The radii of its balls, to a proved bound.
    pub radius: RangeReport,
    /// The largest difference from the requested radius or law.
    pub deviation: f64,
    /// Pieces of its loop.
    pub pieces: usize,
    /// How close it comes to folding: 1 where the ball rolls straight, 0 where the blend would intersect itself.
    pub tightest: f64,
    /// The angle around the branch at which this occurs, in radians.
    pub tightest_at: f64,
}

impl From<&TeeBlendFacts> for TeeBlendReport {
    fn from(facts: &TeeBlendFacts) -> Self {
        let [min, max] = facts.radii;
        let TeeBlendFacts { deviation, pieces, tightest, tightest_at, .. } = *facts;
        Self { radius: RangeReport { min, max }, deviation, pieces, tightest, tightest_at }
    }
}

impl TeeBlendReport {
    /// What the text says of it.
    pub(super) fn text(&self, units: &str) -> String {
        let [min, max, off, tightest, at] =
            [self.radius.min, self.radius.max, self.deviation, self.tightest, self.tightest_at]
                .map(|x| ShortNumber(x).to_string());
        format!(
            "radius {min} to {max} {units}, deviation {off} from the requested radius, {} pieces, tightest {tightest} at {at} rad",
            self.pieces
        )
    }
}
