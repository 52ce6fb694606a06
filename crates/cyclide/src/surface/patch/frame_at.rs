//! The patch whose frame is given at any of its corners.

use super::{CyclidePatch, largest_distance};
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// The opposite corner may coincide with a neighbor up to this part of the largest distance: then the frame goes the
/// other way round.
const COINCIDENT_LIMIT: f64 = 1e-12;

impl CyclidePatch {
    /// As [`from_corners_and_frame`](Self::from_corners_and_frame), with the unit directions `v1` of growing s and `v2`
    /// of growing t at corner `at` (0 to 3). Frames move along an edge by reflection in its perpendicular bisector
    /// plane, the direction along the edge changing its sign (`docs/math/patches.md#admissible-input`); the way does
    /// not matter.
    ///
    /// # Errors
    /// As [`from_corners_and_frame`](Self::from_corners_and_frame); `parameter-out-of-range` for `at` above 3.
    pub fn from_corners_and_frame_at(corners: [Point3; 4], at: usize, v1: Vec3, v2: Vec3) -> Result<Self> {
        let reflected = |i: usize, j: usize, v: Vec3| -> Result<Vec3> {
            let coincident =
                || Error::Point(PointError::CoincidentPoints { first: i, second: j, distance: 0.0, limit: 0.0 });
            let d = (corners[j] - corners[i]).unit().ok_or_else(coincident)?;
            Ok(v - d * (2.0 * d.dot(v)))
        };
        let (v1, v2) = match at {
            0 => (v1, v2),
            1 => (-reflected(0, 1, v1)?, reflected(0, 1, v2)?),
            2 => (reflected(0, 2, v1)?, -reflected(0, 2, v2)?),
            3 => {
                let pole = corners[1].distance(corners[3]) <= COINCIDENT_LIMIT * largest_distance(&corners);
                let via = if pole { 2 } else { 1 };
                let back = |v: Vec3| reflected(0, via, reflected(via, 3, v)?).map(|v| -v);
                (back(v1)?, back(v2)?)
            }
            _ => {
                return Err(NumberError::ParameterOutOfRange {
                    name: ErrorItem::FrameCorner,
                    value: at as f64,
                    min: 0.0,
                    max: 3.0,
                }
                .into());
            }
        };
        Self::from_corners_and_frame(corners, v1, v2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::ParamSurface as _;

    #[test]
    fn a_frame_at_any_corner_gives_the_same_patch() {
        let point = |a: f64| Point3::new(2.0 * a.cos(), 2.0 * a.sin(), 0.5);
        let [p0, p1, p3, p2] = [0.1, 1.4, 2.9, 5.0].map(point);
        let v1 = Vec3::new(0.3, 0.9, 0.4).unit().unwrap();
        let v2 = v1.cross(Vec3::new(1.0, -0.2, 0.7)).unit().unwrap();
        let sphere_corner = Vec3::X; // an octant: its last two corners are one point
        let octant = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v);
        for (corners, v1, v2) in [([p0, p1, p2, p3], v1, v2), (octant, Vec3::Y, sphere_corner.cross(Vec3::Y))] {
            let patch = CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap();
            for (at, (s, t)) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].into_iter().enumerate() {
                let [u1, u2, _] = patch.moving_frame(s, t);
                let again = CyclidePatch::from_corners_and_frame_at(corners, at, u1, u2).unwrap();
                // Two reflections of unit vectors: a few units in the last place, times the condition of the patch.
                assert!(patch.point(0.4, 0.7).distance(again.point(0.4, 0.7)) < 1e-13, "{at}");
                assert!((patch.unit_normal(0.4, 0.7) - again.unit_normal(0.4, 0.7)).length() < 1e-13, "{at}");
            }
        }
    }

    #[test]
    fn there_are_four_corners() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
        let error = CyclidePatch::from_corners_and_frame_at(corners, 4, Vec3::X, Vec3::Y).unwrap_err();
        assert_eq!(error.reason(), "parameter-out-of-range");
        let same = [corners[0]; 4];
        for at in 1..4 {
            let error = CyclidePatch::from_corners_and_frame_at(same, at, Vec3::X, Vec3::Y).unwrap_err();
            assert_eq!(error.reason(), "coincident-points");
        }
    }
}
