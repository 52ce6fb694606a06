//! The plane of a curve, if it has one.

use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve;

/// A curve lies in a plane if its points leave it by no more than this part of its extent,
const FLATNESS: f64 = 1e-11;
/// or by this part of its coordinates.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Places looked at on each piece.
const PLACES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

/// The unit normal of a planar curve, turned so that its largest coordinate is positive: `z` in planes `z = const`, so
/// that curvature signed by it is positive where the curve turns left seen from above. Of a straight curve that of any plane
/// through it, `z` if it may be. `None` for a curve that leaves every plane by more than 1e-11 of its extent or 64
/// roundings of its coordinates.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, plane_normal}};
/// let clockwise = Circle::from_radius(Point3::new(3.0, 1.0, 7.0), -Vec3::Z, 2.0)?;
/// let normal = plane_normal(&clockwise).expect("it is planar");
/// assert!((normal - Vec3::Z).length() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn plane_normal(curve: &dyn ParamCurve) -> Option<Vec3> {
    let normal = plane_of(curve)?;
    let along = curve.piece_point(curve.piece_count() - 1, 1.0) - curve.piece_point(0, 0.0);
    let is_straight = crate::curve::extreme_curvature(curve).max == 0.0;
    if is_straight && along.z.abs() <= FLATNESS * along.length() {
        return Some(Vec3::Z);
    }
    let [x, y, z] = normal.to_array();
    let largest = if z.abs() >= x.abs().max(y.abs()) {
        z
    } else if y.abs() >= x.abs() {
        y
    } else {
        x
    };
    Some(if largest < 0.0 { -normal } else { normal })
}

/// The unit normal of a curve's plane; of any plane through a straight one; `None` in space.
///
/// It is that of three points: the first, the farthest from it, and the farthest from the line of both.
pub(super) fn plane_of(curve: &dyn ParamCurve) -> Option<Vec3> {
    let n = curve.piece_count();
    let points = || {
        let inner = (0..n).flat_map(|i| PLACES.map(|s| curve.piece_point(i, s)));
        inner.chain([curve.piece_point(n - 1, 1.0)])
    };
    let first = curve.piece_point(0, 0.0);
    let farthest = |distance: &dyn Fn(Point3) -> f64| {
        let start = (first, 0.0);
        points().map(|p| (p, distance(p))).fold(start, |best, next| if next.1 > best.1 { next } else { best })
    };
    let (second, extent) = farthest(&|p| p.distance(first));
    let Some(along) = (second - first).unit() else {
        return Some(Vec3::Z);
    };
    let size = points().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let limit = (FLATNESS * extent).max(ROUNDING * size);
    let across = |p: Point3| (p - first) - along * (p - first).dot(along);
    let (third, height) = farthest(&|p| across(p).length());
    if height <= limit {
        return Some(along.any_perpendicular());
    }
    let normal = along.cross(across(third)).unit()?;
    let leaves = points().map(|p| (p - first).dot(normal).abs()).fold(0.0, f64::max);
    // The normal itself is as uncertain as the three points, times how far others are from them.
    (leaves <= limit * (1.0 + extent / height)).then_some(normal)
}
