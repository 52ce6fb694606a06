//! Curves so small and so far from the origin that rounding is their shape.

use cyclide::{
    Vec3,
    curve::{Arc, BlendSegment, bounds},
    error::{ErrorItem, PointError},
    model::CurveObject,
};

use crate::document::objects::Builder;
use crate::error::Result;

/// Roundings (of the largest coordinate) that a bent curve is across at least, as surfaces are: each point is off by one,
/// a ten thousandth of what files promise of such a curve by default.
const SMALLEST_IN_PLACE: f64 = 65536.0 * f64::EPSILON;

/// Roundings that the image of a curve without bends is across at least: below it its vertices are one point.
const SMALLEST_IMAGE: f64 = 16.0 * f64::EPSILON;

impl Builder<'_> {
    /// Refuses a curve that has no shape where it is.
    pub(in crate::document) fn check_place_of(&self, curve: &CurveObject, contour: usize) -> Result<()> {
        match self.roundings_of_place(curve, contour) {
            Some(roundings) => check_in_place(curve, roundings).map_err(|e| self.refused(&e, None)),
            None => Ok(()),
        }
    }

    /// How many roundings of its coordinates a curve must be across; `None` for one that is its vertices. An image is not: of
    /// bends that a map made too small straight segments are left.
    fn roundings_of_place(&self, curve: &CurveObject, contour: usize) -> Option<f64> {
        if !is_its_vertices(curve) {
            return Some(SMALLEST_IN_PLACE);
        }
        if !self.kind.is_image() || matches!(curve, CurveObject::Circle(_)) {
            return None;
        }
        let original = self.sources.first().and_then(|source| source.item.curves().get(contour));
        Some(if original.is_none_or(is_its_vertices) { SMALLEST_IMAGE } else { SMALLEST_IN_PLACE })
    }
}

/// True if the curve has no bends that rounding could be: polylines, which are their vertices, and circles, which are
/// center and radius, say what they are at any place.
fn is_its_vertices(curve: &CurveObject) -> bool {
    let runs_straight = |segment: &BlendSegment| {
        let along =
            |tangent: Vec3| (segment.end() - segment.start()).unit().is_some_and(|u| (tangent - u).length() <= 1e-9);
        along(segment.start_tangent()) && along(segment.end_tangent())
    };
    match curve {
        CurveObject::Circle(_) => true,
        CurveObject::Arc(arc) => arc.is_straight(),
        CurveObject::ArcPath(path) => path.arcs().iter().all(Arc::is_straight),
        CurveObject::CircleSpline(spline) => spline.segments().iter().all(runs_straight),
        _ => false,
    }
}

/// Refuses curves that are not across more than so many roundings of the largest coordinate.
///
/// # Errors
/// `below-rounding-of-place`.
fn check_in_place(curve: &CurveObject, roundings: f64) -> cyclide::Result<()> {
    let curve = curve.as_curve();
    let first = curve.piece_point(0, 0.0);
    let place = first.to_vec().max_abs();
    let limit = roundings * place;
    // Most curves are known by their first piece, so that this costs nothing.
    let far = |piece: usize| [0.5, 1.0].into_iter().any(|s| curve.piece_point(piece, s).distance(first) > 2.0 * limit);
    if place == 0.0 || (0..curve.piece_count()).any(far) {
        return Ok(());
    }
    let size = bounds(curve).diagonal();
    if size > limit {
        return Ok(());
    }
    Err(PointError::BelowRoundingOfPlace { what: ErrorItem::Curve, size, place, limit }.into())
}
