//! A surface between two rails, with what should be known of it.

use crate::topology::Body;
use crate::warning::Warning;

/// A surface of [straight lines](Self::ruled) or [arcs](Self::circular) between two curves, exact, with what should be known of it. Those who
/// want the body alone take [`Body::ruled`] and [`Body::circular`].
///
/// ```
/// use cyclide::{Point3, construct::RailSurface, curve::Arc};
/// // One rail runs through its middle joint at the same speed, the other one three times as fast behind it.
/// let rail = |y: f64, ends: [f64; 3]| {
///     let [a, b, c] = ends.map(|x| Point3::new(x, y, y * x));
///     Ok::<_, cyclide::Error>([Arc::segment(a, b)?.into(), Arc::segment(b, c)?.into()])
/// };
/// let made = RailSurface::ruled([&rail(0.0, [0.0, 1.0, 2.0])?, &rail(1.0, [0.0, 1.0, 4.0])?], false)?;
/// assert_eq!(made.body().outer.faces().len(), 2);
/// assert_eq!(made.warnings()[0].reason(), "kinks-at-joints");
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RailSurface {
    pub(super) body: Body,
    pub(super) warnings: Vec<Warning>,
}

impl RailSurface {
    /// The body: one face for each piece of the rails, or part of it.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The body, without a copy.
    #[must_use]
    pub fn into_body(self) -> Body {
        self.body
    }

    /// What should be known of it: where both rails run smoothly from piece to piece, but speeds change there by different factors, the
    /// surface has a kink (`kinks-at-joints`, above a thousandth of a radian); arcs that start within 0.05 radians of the way back along their chord turn
    /// nearly all round (`nearly-full-arcs`).
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
