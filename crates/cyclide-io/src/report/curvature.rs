//! Ranges of principal curvatures, which may have no bounds.

use std::fmt;

use cyclide::ShortNumber;
use serde::Serialize;

/// Smallest and largest principal curvature of an object along one family of lines. An unbounded side is infinite
/// (`null` in JSON), with the reason; a finite bound holds everywhere.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// // Of the tube, whose radius is 1.
/// let [s, t] = [found.curvature_s, found.curvature_t].map(|range| range.max.abs().max(range.min.abs()));
/// assert!((s.max(t) - 1.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CurvatureRangeReport {
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
    /// Why a side is unbounded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unbounded: Option<&'static str>,
}

impl CurvatureRangeReport {
    /// The range of no value yet.
    pub(super) const EMPTY: Self = Self { min: f64::INFINITY, max: f64::NEG_INFINITY, unbounded: None };

    /// The smallest range that holds both.
    pub(super) fn with(self, [min, max]: [f64; 2]) -> Self {
        let (min, max) = (self.min.min(min), self.max.max(max));
        let unbounded = match (min == f64::NEG_INFINITY, max == f64::INFINITY) {
            (false, false) => None,
            (true, false) => Some("below: towards the points named in `singular`"),
            (false, true) => Some("above: towards the points named in `singular`"),
            (true, true) => Some("below and above: towards the points named in `singular`"),
        };
        Self { min, max, unbounded }
    }

    /// The range as the text report has it.
    pub(super) fn text(&self, units: &str) -> String {
        Text { range: self, units }.to_string()
    }
}

struct Text<'a> {
    range: &'a CurvatureRangeReport,
    units: &'a str,
}

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (units, [min, max]) = (self.units, [self.range.min, self.range.max]);
        let [low, high] = [min, max].map(|k| ShortNumber(k).to_string());
        match (min.is_finite(), max.is_finite()) {
            (true, true) if low == high => write!(f, "{low} 1/{units}"),
            (true, true) => write!(f, "{low} to {high} 1/{units}"),
            (true, false) => write!(f, "{low} 1/{units} and more, unbounded at singular points"),
            (false, true) => write!(f, "{high} 1/{units} and less, unbounded at singular points"),
            (false, false) => write!(f, "unbounded above and below at singular points"),
        }
    }
}
