//! The frame a fit works in: its origin among the data and lengths near 1, so that neither big offsets nor tiny or
//! huge scales cost digits; planar data lie in `z = 0`.

use crate::base::frame::Frame;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::{diameter, plane};
use crate::construct::curves::canonical_start::{canonical_start, in_axes};

/// A similarity from the user's coordinates.
pub(super) struct WorkingFrame {
    origin: Point3,
    plane: Option<Frame>,
    /// A power of two: scaling by it is exact.
    scale: f64,
}

impl WorkingFrame {
    /// The frame of points that differ. It does not depend on their order, to the last digit.
    pub fn new(points: &[Point3], tolerance: f64) -> Self {
        let exponent = diameter(points).log2().floor().clamp(-1000.0, 1000.0);
        let mut sorted = points.to_vec();
        sorted.sort_unstable_by(|a, b| in_axes(*a, *b));
        let origin = canonical_start(&sorted);
        sorted.swap(0, origin);
        Self { origin: sorted[0], plane: plane(&sorted, tolerance), scale: (-exponent).exp2() }
    }

    /// The frame of points with the axes they have, planar or not.
    pub fn in_axes(points: &[Point3]) -> Self {
        Self { plane: None, ..Self::new(points, 0.0) }
    }

    pub fn planar(&self) -> bool {
        self.plane.is_some()
    }

    pub fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    pub fn to_local(&self, p: Point3) -> Point3 {
        let local = match &self.plane {
            Some(plane) => {
                let (p, _) = plane.to_local(p);
                Vec3::new(p.x, p.y, 0.0)
            }
            None => p - self.origin,
        };
        Point3::ORIGIN + local * self.scale
    }

    pub fn to_world(&self, p: Point3) -> Point3 {
        let local = p.to_vec() / self.scale;
        match &self.plane {
            Some(plane) => plane.to_world(Point2::new(local.x, local.y)),
            None => self.origin + local,
        }
    }

    pub fn direction_to_world(&self, v: Vec3) -> Vec3 {
        match &self.plane {
            Some(plane) => plane.vector_to_world(Vec2::new(v.x, v.y)),
            None => v,
        }
    }
}
