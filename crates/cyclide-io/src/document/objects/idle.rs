//! Fields that have no effect.
//!
//! Where it is cheap the curve is made again without the field and compared; so the answer needs no rule of its own for what
//! a construction does with a field.

use cyclide::{
    curve::{bounds, corners_by_angle},
    model::CurveObject,
};

use crate::document::angle::Angle;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::contours::Contour;

/// The reason of warnings about fields and options without effect.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": "free", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].remarks[0].reason, cyclide_io::document::NO_EFFECT);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
pub const NO_EFFECT: &str = "no-effect";

pub(in crate::document) const NO_ENDS: &str = "a closed curve has no ends";

pub(in crate::document) const NO_CORNER: &str = "the curve turns by no more at any point";

/// Part of a curve's size that rounding may move it by.
const ROUNDING: f64 = 1e-12;

/// A field, and why it has no effect.
pub(in crate::document) type Idle = (&'static str, &'static str);

impl Builder<'_> {
    /// Says which fields have no effect.
    pub(in crate::document) fn remark_on_idle(&mut self, idle: Vec<Idle>) {
        for (field, why) in idle {
            let place = self.place_of([Step::from(field)]);
            self.remark(NO_EFFECT, None, None, place, format!("`{field}` has no effect: {why}"));
        }
    }
}

/// True if two curves of one construction are the same, piece by piece and parameter by parameter.
pub(in crate::document) fn is_same(a: &CurveObject, b: &CurveObject) -> bool {
    let (a, b) = (a.as_curve(), b.as_curve());
    let limit = ROUNDING * bounds(b).diagonal();
    let near = |piece: usize, s: f64| a.piece_point(piece, s).distance(b.piece_point(piece, s)) <= limit;
    a.piece_count() == b.piece_count()
        && (0..a.piece_count()).all(|piece| [0.0, 0.2, 0.5, 0.8, 1.0].into_iter().all(|s| near(piece, s)))
}

pub(in crate::document) fn found(tests: &[(&'static str, bool, &'static str)]) -> Vec<Idle> {
    tests.iter().filter(|(_, idle, _)| *idle).map(|(field, _, why)| (*field, *why)).collect()
}

pub(in crate::document) fn has_no_corner(angle: Option<Angle>, closed: bool, at: &Contour<'_>) -> bool {
    angle.is_some_and(|angle| corners_by_angle(&at.list.points, closed, angle.radians()).is_empty())
}
