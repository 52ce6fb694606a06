//! What a piece of a curve is, where it has a closed form.

use super::arc::Arc;
use super::circle::Circle;

/// The shape of one smooth piece, with the piece's own parameter: measures are exact for arcs and circles and
/// numerical for the rest.
///
/// ```
/// use cyclide::{Point3, curve::{Arc, ParamCurve, PieceForm}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0))?;
/// assert!(matches!(segment.piece_form(0), PieceForm::Arc(_)));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PieceForm {
    /// The piece is this arc or straight segment, point for point at equal parameters.
    Arc(Arc),
    /// The piece is this full circle, at constant speed.
    Circle(Circle),
    /// Anything else: known by its jets only.
    Free,
}
