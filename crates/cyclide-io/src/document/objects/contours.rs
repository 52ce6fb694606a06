//! Contours: their points after merging, and what is known of the curve that is made of them.

use cyclide::{
    Warning,
    construct::{FairFitCertificate, FitCertificate},
    curve::corners_by_angle,
    error::{ErrorItem, NumberError},
    model::CurveObject,
    surface::Torus,
};

use crate::document::angle::Angle;
use crate::document::objects::facts::InterpolationFacts;
use crate::input::points::PointList;

/// What is known about a contour besides its curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!((built[0].contours[0].points, built[0].contours[0].fit), (4, None));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContourFacts {
    /// Points it was made from, after merging; 0 if it was not made from a list.
    pub points: usize,
    /// The certificate of a fit.
    pub fit: Option<Fitted>,
    /// The largest distance by which points were moved onto the torus that the curve lies on.
    pub moved: Option<f64>,
    /// The torus whose normals go with it, of a curve parallel to one of a torus: that on which it lies.
    pub torus: Option<Torus>,
    /// What is known of a curve of lowest degree through points.
    pub interpolation: Option<InterpolationFacts>,
}

/// What is proved about a fitted contour.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[0, 0], [1, 0.05], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let Some(cyclide_io::document::Fitted::Arcs(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.deviation <= 0.1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fitted {
    /// By arcs and lines.
    Arcs(FitCertificate),
    /// By a fair spline.
    Fair(FairFitCertificate),
}

/// A contour's points after merging.
pub(in crate::document) struct Contour<'a> {
    pub(in crate::document) index: usize,
    pub(in crate::document) list: &'a PointList,
    /// The index, in the list as given, of each point.
    pub(in crate::document) kept: &'a [usize],
}

/// A curve, what is known about it, and what its construction remarked.
pub(in crate::document) type Made = cyclide::Result<(CurveObject, ContourFacts, Vec<Warning>)>;

impl Contour<'_> {
    pub(in crate::document) fn facts(&self, fit: Option<Fitted>) -> ContourFacts {
        ContourFacts { points: self.list.points.len(), fit, ..ContourFacts::default() }
    }
}

/// The corners marked in the file, and those that turn by more than the angle given.
pub(in crate::document) fn corners(
    at: &Contour<'_>,
    closed: bool,
    angle: Option<Angle>,
) -> cyclide::Result<Vec<usize>> {
    let mut corners = at.list.corners.clone();
    if let Some(angle) = angle.map(Angle::radians) {
        let max = std::f64::consts::PI;
        if !(angle > 0.0 && angle <= max) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::CornerAngle, value: angle, min: 0.0, max }.into()
            );
        }
        corners.extend(corners_by_angle(&at.list.points, closed, angle));
        corners.sort_unstable();
        corners.dedup();
    }
    Ok(corners)
}
