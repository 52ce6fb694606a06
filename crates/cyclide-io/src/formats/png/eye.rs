//! Where a model is looked at from.

use crate::export::camera::Camera;
use cyclide::{Point3, Vec3};

/// Up in the world.
pub(super) const UP: Vec3 = Vec3::Z;
/// Where a model with heights is looked at from, in order of preference: front right, front left, and turned further.
const EYES: [(f64, f64); 6] = [(0.5, -0.8), (-0.5, -0.8), (0.92, -0.2), (-0.92, -0.2), (0.2, -0.92), (-0.2, -0.92)];
/// Height of the eye that goes with these.
const STEEPNESS: f64 = 0.55;
/// A view is left for a later one only if that shows this much more.
const BETTER: f64 = 1.5;

/// Right, up and toward the eye: as asked for, else from above, or from the side and above if there are heights.
pub(super) fn axes(points: &[Point3], heights: bool, camera: Option<Camera>) -> [Vec3; 3] {
    match camera {
        Some(camera) => camera.axes(),
        None if heights => from_side(points, STEEPNESS),
        None => from_above(),
    }
}

/// The axes of the view from above.
pub(super) fn from_above() -> [Vec3; 3] {
    [Vec3::X, Vec3::Y, UP]
}

/// The axes of the view from a side and above that shows the most.
pub(super) fn from_side(points: &[Point3], steepness: f64) -> [Vec3; 3] {
    let toward = eye(points, steepness);
    let right = UP.cross(toward).unit().unwrap_or(Vec3::X);
    [right, toward.cross(right), toward]
}

/// The direction to look from: a curve close to a plane must not be seen edge on.
fn eye(points: &[Point3], steepness: f64) -> Vec3 {
    let mut best = (UP, 0.0);
    for eye in EYES.into_iter().filter_map(|(x, y)| Vec3::new(x, y, steepness).unit()) {
        let spread = spread(points, eye);
        if best.0 == UP || spread > BETTER * best.1 {
            best = (eye, spread);
        }
    }
    best.0
}

/// How broad the points look: the smaller axis of their ellipse of inertia in the view.
fn spread(points: &[Point3], toward: Vec3) -> f64 {
    let right = UP.cross(toward).unit().unwrap_or(Vec3::X);
    let up = toward.cross(right);
    let first = points.first().copied().unwrap_or(Point3::ORIGIN);
    let flat = points.iter().map(|p| ((*p - first).dot(right), (*p - first).dot(up)));
    let n = points.len().max(1) as f64;
    let (x, y) = flat.clone().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for (u, v) in flat {
        let (u, v) = (u - x, v - y);
        (xx, xy, yy) = (xx + u * u, xy + u * v, yy + v * v);
    }
    let least = 0.5 * (xx + yy - (xx - yy).hypot(2.0 * xy));
    (least.max(0.0) / n).sqrt()
}
