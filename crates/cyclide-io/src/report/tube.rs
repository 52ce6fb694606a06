//! The report on a tube of changing radius.

use cyclide::{ShortNumber, model::Exactness};
use serde::Serialize;

use super::range::RangeReport;
use crate::document::TubeFacts;
use crate::document::kinds::RadiusOf;

/// The report on a tube.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 3], [20, 5, 0, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.tubes[0].proof == "exact" && found.tubes[0].within == 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TubeReport {
    /// The radii of its balls or sections.
    pub radius: RangeReport,
    /// What the radii belong to: `sections` across its curve, or `balls`.
    pub radius_of: RadiusOf,
    /// Pieces that it consists of: arcs of balls, or of sections.
    pub arcs: usize,
    /// Its distance from the tube of the law along the curve.
    pub within: f64,
    /// The basis of that distance: `exact`, `proved` or `sampled`.
    pub proof: &'static str,
}

impl From<&TubeFacts> for TubeReport {
    fn from(facts: &TubeFacts) -> Self {
        let [min, max] = facts.radii;
        let proof = match facts.within {
            Exactness::Exact => "exact",
            Exactness::Proved(_) => "proved",
            Exactness::Sampled(_) => "sampled",
        };
        Self {
            radius: RangeReport { min, max },
            radius_of: facts.radius_of,
            arcs: facts.arcs,
            within: facts.within.bound(),
            proof,
        }
    }
}

impl TubeReport {
    /// What the text says of it.
    pub(super) fn text(&self, units: &str) -> String {
        let [min, max, within] = [self.radius.min, self.radius.max, self.within].map(|x| ShortNumber(x).to_string());
        let off = match self.proof {
            "exact" => "exact".to_owned(),
            proof => format!("within {within} {units} of its law, {proof}"),
        };
        let pieces = match self.radius_of {
            RadiusOf::Balls => format!("{} arcs of balls", self.arcs),
            RadiusOf::Sections if self.arcs == 1 => "1 piece of cross-section circles".to_owned(),
            RadiusOf::Sections => format!("{} pieces of cross-section circles", self.arcs),
        };
        format!("radius {min} to {max} {units}, {pieces}, {off}")
    }
}
