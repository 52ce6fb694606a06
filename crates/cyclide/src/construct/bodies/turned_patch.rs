//! Faces that two circles about one axis bound, as principal patches: parts of planes, cylinders, cones, spheres and tori, which
//! files name as such.
//!
//! What an arc with the denominator `D(t)` sweeps when it turns by `x(s) = 1 - s + s u` has the denominator `x(s) D(t)`, and at its corners the
//! weights `1, u, w, u w` (see `revolution`). A face whose edges have these ratios is that patch if its points are, and if its lines are those of
//! curvature: the bilinear face between four segments has the same points as that with weights of 1, but only as a rectangle
//! its normals and curvatures.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::rational::RationalBezierSurface;
use crate::surface::{CyclidePatch, ParamSurface as _};
use crate::topology::has_ratio;

/// Points of a patch and of a face that are the same differ by rounding: by less than this part of the face and of the coordinates.
const SAME: f64 = 1e-13;
/// Derivatives of both differ by so many times as much.
const DERIVATIVES: f64 = 1e2;
/// Places in both directions where they are compared: more than the degrees of both together.
const PLACES: usize = 9;

/// The patch with these corners and the same points at the same parameters as a face of degree up to 4, if its edges along s (at t = 0 and 1) and along t (at s = 0
/// and 1) are arcs and it is one. An edge is left out where the side is one point.
pub(super) fn turned_patch(
    surface: &RationalBezierSurface,
    corners: [Point3; 4],
    along_s: [Option<&Arc>; 2],
    along_t: [Option<&Arc>; 2],
) -> Option<CyclidePatch> {
    // The lines along s are turned copies of each other, or those along t.
    [true, false].into_iter().find_map(|turned_along_s| {
        let (first, left) = (along_s[0].or(along_s[1])?, along_t[0].or(along_t[1])?);
        let (u, w) = (first.weight_ratio(), left.weight_ratio());
        let (last, far_s, far_t) =
            if turned_along_s { (u * w, u, u * w * u.inverse()?) } else { (w * u, w * u * w.inverse()?, w) };
        // Of short arcs beside long ones the points alone do not tell: shells want the ratios of their edges.
        let far = [(along_s, far_s), (along_t, far_t)];
        if far.iter().any(|(edges, ratio)| matches!(edges, [Some(_), Some(far)] if !has_ratio(far, *ratio))) {
            return None;
        }
        let (v1, v2) = (first.start_tangent()?, left.start_tangent()?);
        let patch = CyclidePatch::from_weights(corners, [Quat::ONE, u, w, last], v1, across(v1, v2)?).ok()?;
        let size = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
        let limit = SAME * (size + corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max));
        let places = || (0..=PLACES).map(|k| k as f64 / PLACES as f64);
        let same = || places().all(|s| places().all(|t| is_same_at(&patch, surface, [s, t], limit)));
        (on_one_circle(corners, size, limit) && same()).then_some(patch)
    })
}

/// Whether both have the same point and normal there, and the lines of the face are perpendicular.
fn is_same_at(patch: &CyclidePatch, surface: &RationalBezierSurface, [s, t]: [f64; 2], limit: f64) -> bool {
    let (jet, normal) = (surface.jet(s, t), patch.unit_normal(s, t));
    let off = jet.ds.dot(normal).abs().max(jet.dt.dot(normal).abs());
    let longer = jet.ds.length().max(jet.dt.length());
    patch.point(s, t).distance(jet.point) <= limit
        && off <= DERIVATIVES * limit
        && jet.ds.dot(jet.dt).abs() <= DERIVATIVES * limit * longer
}

/// Whether the corners lie on a circle or a line, or two of them are one: where the product of the sides as quaternions is real.
fn on_one_circle([a, b, c, d]: [Point3; 4], size: f64, limit: f64) -> bool {
    let sides = [b - a, d - b, c - d, a - c].map(|side| Quat::from(side * (1.0 / size)));
    let product = sides[0] * sides[1] * sides[2] * sides[3];
    product.vector().length() <= DERIVATIVES * limit / size
}

/// A direction made perpendicular to another to the last digit, if it nearly is.
fn across(v1: Vec3, v2: Vec3) -> Option<Vec3> {
    let part = v2.dot(v1);
    if part.abs() > SAME { None } else { (v2 - v1 * part).unit() }
}
