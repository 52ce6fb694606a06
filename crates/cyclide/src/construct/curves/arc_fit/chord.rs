//! The chord frame of a span: origin at the middle of the chord, first axis along it, unit half the chord, so that
//! the ends are (-1, 0) and (1, 0) and every formula is free of offsets and of scale
//! (`docs/math/arc-fitting.md#feasible-bulges`).

use super::input;
use crate::base::planar::{Point2, Vec2};
use crate::error::{Error, PointError, Result};

/// Chord frame of the span from the first to the last point.
pub(super) struct ChordFrame {
    middle: Point2,
    axis: Vec2,
    /// Half the chord: the unit of the frame.
    pub half: f64,
}

impl ChordFrame {
    /// # Errors
    /// `too-few-points`, `not-finite`, `coincident-points` (first and last point equal).
    pub fn new(points: &[Point2]) -> Result<Self> {
        input::check_points(points, 2)?;
        let (a, b) = (points[0], points[points.len() - 1]);
        let half = 0.5 * a.distance(b);
        let coincident = Error::Point(PointError::CoincidentPoints {
            first: 0,
            second: points.len() - 1,
            distance: 2.0 * half,
            limit: 0.0,
        });
        let axis = (b - a).unit().ok_or(coincident)?;
        Ok(Self { middle: a + (b - a) * 0.5, axis, half })
    }

    /// A point in chord coordinates.
    pub fn local(&self, p: Point2) -> Vec2 {
        let v = p - self.middle;
        Vec2::new(self.axis.dot(v) / self.half, self.axis.cross(v) / self.half)
    }
}

/// Mirror image in the chord: the two orientations are always treated as two separate problems, never by a sign
/// inside the formulas.
pub(super) fn mirrored(v: Vec2) -> Vec2 {
    Vec2::new(v.x, -v.y)
}
