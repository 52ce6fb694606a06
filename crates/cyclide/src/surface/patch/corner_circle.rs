//! The circle of a quad's corners: are they four points on one, in order?

use super::largest_distance;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{PatchError, PointError, Result};

/// Corners closer than this part of the largest distance coincide.
const COINCIDENT_LIMIT: f64 = 1e-12;
/// Largest distance of the fourth corner from the circle of the others, and along it from their arc, relative to the
/// size, beyond the rounding of the corners.
const CONCIRCULAR_LIMIT: f64 = 1e-9;
/// Rounding of the four corners together, relative to the largest coordinate.
const CORNER_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The corners of a quad seen from the first one, after an inversion there that takes their circle to a line.
pub(super) struct CornerCircle {
    /// `b_k = (x_k - x_0)^-1` of the corners 1, 2, 3 with `x` in units of the size; the last between the others.
    pub(super) inverses: [Vec3; 3],
    /// The last corner, moved onto the circle of the others and to the end of their arc if rounding put it beyond.
    pub(super) corner: Point3,
    /// Where it was on the inverted arc: 0 at corner 1, 1 at corner 2.
    position: f64,
}

/// Largest distance between the corners, if those are distinct that must be (the last may be that of a neighbor).
///
/// # Errors
/// `parameter-out-of-range`, `coincident-points`.
pub(super) fn distinct(corners: &[Point3; 4]) -> Result<f64> {
    let scale = largest_distance(corners);
    range::check_distance(scale)?;
    for (first, second) in [(0, 1), (0, 2), (0, 3), (1, 2)] {
        let (distance, limit) = (corners[first].distance(corners[second]), COINCIDENT_LIMIT * scale);
        if distance <= limit {
            return Err(PointError::CoincidentPoints { first, second, distance, limit }.into());
        }
    }
    Ok(scale)
}

/// The foot of the last corner on the circle of the others.
struct Foot {
    /// Inverses of the corners 1 and 2, and of the foot.
    inverses: [Vec3; 3],
    corner: Point3,
    /// On the inverted arc: 0 at corner 1, 1 at corner 2.
    position: f64,
    /// Distance of the last corner from it, and how far rounding of the others turns the circle there, both relative to the size.
    measured: f64,
    rounding: f64,
}

fn foot(corners: &[Point3; 4], scale: f64) -> Foot {
    // b_k = (a_k - a0)^-1 = -x/|x|², imaginary.
    let inverse = |k: usize| {
        let x = (corners[k] - corners[0]) / scale;
        x / -x.length_squared()
    };
    let (b1, b2) = (inverse(1), inverse(2));
    // The foot of b3 on the line b1 b2, counted from the shorter of the two: the other one, of a corner close to the
    // first, would leave no more digits than the distance between these has.
    let side = b2 - b1;
    let part_from = |b: Vec3| (inverse(3) - b).dot(side) / side.length_squared();
    let (position, b3) = if b1.length_squared() <= b2.length_squared() {
        let x = part_from(b1);
        (x, b1 + side * x)
    } else {
        let y = part_from(b2);
        (1.0 + y, b2 + side * y)
    };
    let corner = corners[0] + b3 * (-scale / b3.length_squared());
    // Rounding of the ends turns the circle about the first corner by itself over the distance to them.
    let nearest = corners[0].distance(corners[1]).min(corners[0].distance(corners[2]));
    let (measured, rounding) = (corner.distance(corners[3]) / scale, rounding_of(corners) / nearest);
    Foot { inverses: [b1, b2, b3], corner, position, measured, rounding }
}

/// Rounding of the corners, a length.
fn rounding_of(corners: &[Point3; 4]) -> f64 {
    CORNER_ROUNDING * corners.iter().map(|a| a.to_vec().max_abs()).fold(0.0, f64::max)
}

/// The corners on their circle, if they are in the order a0, a1, a3, a2 on one
/// (`docs/math/patches.md#admissible-input`).
///
/// # Errors
/// `not-concircular`, `crossing-quad`.
pub(super) fn corner_circle(corners: &[Point3; 4], scale: f64) -> Result<CornerCircle> {
    let coincide = |i: usize| corners[i].distance(corners[3]) <= COINCIDENT_LIMIT * scale;
    let Foot { inverses: [b1, b2, b3], corner, position: x, measured, rounding } = foot(corners, scale);
    let at_1 = |position| CornerCircle { inverses: [b1, b2, b1], corner: corners[1], position };
    let at_2 = |position| CornerCircle { inverses: [b1, b2, b2], corner: corners[2], position };
    if coincide(1) {
        return Ok(at_1(0.0));
    }
    if coincide(2) {
        return Ok(at_2(1.0));
    }
    let limit = CONCIRCULAR_LIMIT + rounding;
    if !(measured <= limit) {
        return Err(PatchError::NotConcircular { measured, limit }.into());
    }
    if (0.0..=1.0).contains(&x) {
        return Ok(CornerCircle { inverses: [b1, b2, b3], corner, position: x });
    }
    // Beyond an end of the arc, as far as is seen in space: the inversion makes what is near a short side near.
    let (end, snapped) = if x < 0.0 { (corners[1], at_1(x)) } else { (corners[2], at_2(x)) };
    if corner.distance(end) <= CONCIRCULAR_LIMIT * scale + rounding_of(corners) {
        Ok(snapped)
    } else {
        Err(PatchError::CrossingQuad { position: x }.into())
    }
}

/// The last corner of a quad, moved onto the circle of the others.
///
/// # Errors
/// `parameter-out-of-range`, `coincident-points`, `not-concircular`, `crossing-quad`.
pub(crate) fn on_corner_circle(corners: &[Point3; 4]) -> Result<Point3> {
    Ok(corner_circle(corners, distinct(corners)?)?.corner)
}

/// Refuses a quad whose corners follow from `given` others, of faces up to the size `whole`: each of these may be off its circle by what
/// is allowed of a quad, which adds up.
///
/// # Errors
/// `parameter-out-of-range`, `coincident-points`, `not-concircular`.
pub(crate) fn check_following_quad(corners: &[Point3; 4], given: usize, whole: f64) -> Result<()> {
    let scale = distinct(corners)?;
    let Foot { measured, rounding, .. } = foot(corners, scale);
    let limit = given as f64 * (CONCIRCULAR_LIMIT * (whole / scale) + rounding);
    // A corner on a neighbor is on any circle through it.
    let collapsed = [1, 2].into_iter().any(|k| corners[k].distance(corners[3]) <= COINCIDENT_LIMIT * scale);
    if measured <= limit || collapsed { Ok(()) } else { Err(PatchError::NotConcircular { measured, limit }.into()) }
}

/// Refuses a quad of a net unless its corners are distinct and on one circle, strictly in order.
///
/// # Errors
/// `parameter-out-of-range`, `coincident-points`, `not-concircular`, `crossing-quad`.
pub(in crate::surface) fn check_quad(corners: &[Point3; 4]) -> Result<()> {
    let scale = distinct(corners)?;
    for first in [1, 2] {
        let (distance, limit) = (corners[first].distance(corners[3]), COINCIDENT_LIMIT * scale);
        if distance <= limit {
            return Err(PointError::CoincidentPoints { first, second: 3, distance, limit }.into());
        }
    }
    // Nets keep their vertices, so rounding must not put one beyond the next either.
    let position = corner_circle(corners, scale)?.position;
    if (0.0..=1.0).contains(&position) { Ok(()) } else { Err(PatchError::CrossingQuad { position }.into()) }
}
