//! Curves of several kinds through or near the same points, side by side: measures, and a page to choose by.

mod drawing;
mod measures;
mod page;
mod plot;
mod table;

use cyclide::model::{CurveObject, Units};
use serde::Serialize;

use crate::document::BuiltObject;
pub use measures::CurveMeasures;

/// Curves of several kinds from the same points.
///
/// ```
/// use cyclide_io::{Document, compare::Comparison};
/// let text = r#"{"cyclide": 1, "objects": {
///     "polygon": {"type": "polyline", "points": [[0, 0], [4, 1], [5, 4], [2, 6]]},
///     "fair-spline": {"type": "fair-spline", "points": [[0, 0], [4, 1], [5, 4], [2, 6]]}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let kinds = vec![("fair-spline".to_owned(), Ok(built[1].clone()))];
/// let comparison = Comparison::new("points.csv", document.units, &built[0], kinds, 0.01);
/// let measures = comparison.kinds[0].measures.as_ref().expect("it was made");
/// assert!(measures.jumps == 0 && measures.longer > 0.0);
/// assert!(comparison.html().contains("<svg") && comparison.csv().starts_with("kind,"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// Where the points come from.
    pub source: String,
    /// Symbol of the unit of all lengths.
    pub units: &'static str,
    /// True if the curves are closed.
    pub closed: bool,
    /// The tolerance of fits, and of arcs in place of curves.
    pub tolerance: f64,
    /// Number of points, after merging.
    pub points: usize,
    /// Length of the polygon of the points.
    pub polygon_length: f64,
    /// The kinds, in their order.
    pub kinds: Vec<ComparedKind>,
    #[serde(skip)]
    polygon: Vec<CurveObject>,
}

/// One kind of curve in a comparison.
///
/// ```
/// use cyclide_io::{Document, compare::Comparison};
/// let text = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [4, 1], [5, 4]]}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let refused = vec![("arc-fit".to_owned(), Err("no arcs".to_owned()))];
/// let comparison = Comparison::new("points.csv", document.units, &built[0], refused, 0.01);
/// assert_eq!((comparison.kinds[0].refused.as_deref(), comparison.points), (Some("no arcs"), 3));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedKind {
    /// The word of its type.
    pub kind: String,
    /// Its measures, if it could be made.
    pub measures: Option<CurveMeasures>,
    /// Why it could not be made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
    /// Warnings about it.
    pub warnings: Vec<String>,
    #[serde(skip)]
    curves: Vec<CurveObject>,
}

impl Comparison {
    /// Compares curves of several kinds with the polygon that they were made from; for kinds that could not be made, it
    /// contains the reason.
    #[must_use]
    pub fn new(
        source: &str,
        units: Units,
        polygon: &BuiltObject,
        kinds: Vec<(String, Result<BuiltObject, String>)>,
        tolerance: f64,
    ) -> Self {
        let sides = polygon.item.curves();
        let compare = |(kind, made): (String, Result<BuiltObject, String>)| match made {
            Ok(built) => ComparedKind {
                kind,
                measures: Some(CurveMeasures::new(&built, sides, tolerance)),
                refused: None,
                warnings: built.remarks.iter().map(|r| format!("{} [{}]", r.message, r.reason)).collect(),
                curves: built.item.curves().to_vec(),
            },
            Err(why) => {
                ComparedKind { kind, measures: None, refused: Some(why), warnings: Vec::new(), curves: Vec::new() }
            }
        };
        Self {
            source: source.to_owned(),
            units: units.symbol(),
            closed: sides.iter().all(|side| side.as_curve().is_closed()),
            tolerance,
            points: polygon.contours.iter().map(|contour| contour.points).sum(),
            polygon_length: sides.iter().map(|side| cyclide::curve::length(side.as_curve())).sum(),
            kinds: kinds.into_iter().map(compare).collect(),
            polygon: sides.to_vec(),
        }
    }

    /// The table for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        table::text(self)
    }

    /// The table as CSV, one line per kind.
    #[must_use]
    pub fn csv(&self) -> String {
        table::csv(self)
    }

    /// The comparison as JSON; values that are not finite are `null`.
    #[must_use]
    pub fn json(&self) -> String {
        // Numbers and words only: nothing that could fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// A self-contained page with the table, and a drawing and a plot of the curvature for each kind.
    #[must_use]
    pub fn html(&self) -> String {
        page::html(self)
    }
}
