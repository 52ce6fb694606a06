//! Whether the data of a run lie in one plane: then there is one unknown per node, always
//! (`docs/math/fair-splines.md#newtons-method`).

use crate::base::bounds::Aabb;
use crate::base::frame::Frame;
use crate::base::vector::{Point3, Vec3};

/// Points within this part of the diagonal of their box are in a plane, and within this many roundings.
const PLANE_LIMIT: f64 = 1e-12;
const PLANE_ROUNDINGS: f64 = 16.0;
/// Given tangents may lean out of the plane by this much.
const TANGENT_LIMIT: f64 = 1e-12;

/// The plane of points and unit tangents, with the coordinate axes for data in `z` constant; `None` if they need space.
pub(super) fn common_plane(points: &[Point3], tangents: &[Vec3]) -> Option<Frame> {
    let origin = *points.first()?;
    let level = points.iter().all(|p| p.z.total_cmp(&origin.z).is_eq()) && tangents.iter().all(|t| t.z == 0.0);
    if level {
        return Some(Frame::WORLD);
    }
    let bounds = Aabb::of_points(points.iter().copied())?;
    let limit = (PLANE_LIMIT * bounds.diagonal()).max(PLANE_ROUNDINGS * f64::EPSILON * bounds.max_abs());
    let farthest = |measure: &dyn Fn(Vec3) -> f64| {
        let offsets = points.iter().map(|p| *p - origin);
        offsets.max_by(|a, b| measure(*a).total_cmp(&measure(*b))).unwrap_or(Vec3::ZERO)
    };
    let along = farthest(&|v| v.length()).unit()?;
    let height = |v: Vec3| v.cross(along).length();
    let across = farthest(&height);
    let normal = if height(across) > limit {
        along.cross(across)
    } else {
        // On a line: a tangent across it decides, or any plane will do.
        let sideways = tangents.iter().copied().max_by(|a, b| height(*a).total_cmp(&height(*b)));
        sideways.filter(|t| height(*t) > TANGENT_LIMIT).map_or(along.any_perpendicular(), |t| along.cross(t))
    };
    let frame = Frame::from_normal(origin, normal.unit()?, along).ok()?;
    let flat = points.iter().all(|p| (*p - origin).dot(frame.z()).abs() <= limit)
        && tangents.iter().all(|t| t.dot(frame.z()).abs() <= TANGENT_LIMIT);
    flat.then_some(frame)
}
