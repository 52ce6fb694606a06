//! The place of a point on or near a torus, and the speed of a tangent vector there.
//!
//! ```text
//! A = atan2(y, x)/2,   2B = atan2(c sin phi, a cos phi + b)      phi: direction from the middle of the tube
//! A' = (x v_y - y v_x)/(2 rho²),   phi' = (-sin phi v_rho + cos phi v_z)/b,   B' = c phi'/(2 (a + b cos phi))
//! ```
//! `a cos phi + b` is written as `a sin² phi/(1 - cos phi) - (a - b)` on the inner side, where it cancels
//! (`docs/math/torus-splines.md#the-plane-of-the-torus`).

use super::Torus;
use super::class::UnitPair;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result, TorusError};

/// Distances from the axis and from the middle of the tube below this part of the major radius are rounding: there is no direction.
const NO_DIRECTION: f64 = 1e-14;

impl Torus {
    /// The place of the point of the torus nearest to `p`, each angle in `(-pi/2, pi/2]`, if it is within `tolerance` of the torus.
    ///
    /// # Errors
    /// `not-finite`, `tolerance-not-positive` (below 0 or NaN), `point-on-axis`, `point-on-core-circle` (within 1e-14 of the major
    /// radius), `point-off-torus`.
    pub fn locate(&self, p: Point3, tolerance: f64) -> Result<Point2> {
        self.locate_numbered(0, p, tolerance)
    }

    /// As [`locate`](Self::locate) for each of many points, whose number errors name.
    ///
    /// ```
    /// use cyclide::{Frame, Point3, surface::Torus};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let error = torus.locate_all(&[[4.0, 0.0, 0.0], [5.0, 0.0, 0.0]].map(Point3::from), 0.1).unwrap_err();
    /// assert_eq!((error.reason(), error.index()), ("point-off-torus", Some(1)));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`locate`](Self::locate).
    pub fn locate_all(&self, points: &[Point3], tolerance: f64) -> Result<Vec<Point2>> {
        points.iter().enumerate().map(|(index, p)| self.locate_numbered(index, *p, tolerance)).collect()
    }

    /// As [`locate`](Self::locate) for one of many points.
    fn locate_numbered(&self, index: usize, p: Point3, tolerance: f64) -> Result<Point2> {
        if !p.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into());
        }
        if !(tolerance >= 0.0) {
            return Err(NumberError::ToleranceNotPositive { tolerance }.into());
        }
        let (plane, height) = self.frame().to_local(p);
        let (x, y, z) = (plane.x / self.major_radius(), plane.y / self.major_radius(), height / self.major_radius());
        let radius = Vec2::new(x, y).length();
        let from_core = Vec2::new(radius - 1.0, z);
        let reach = from_core.length();
        let limit = NO_DIRECTION * self.major_radius();
        if radius <= NO_DIRECTION {
            return Err(TorusError::PointOnAxis { index, distance: radius * self.major_radius(), limit }.into());
        }
        if reach <= NO_DIRECTION {
            return Err(TorusError::PointOnCoreCircle { index, distance: reach * self.major_radius(), limit }.into());
        }
        let distance = (reach - self.shape.tube).abs() * self.major_radius();
        if !(distance <= tolerance) {
            return Err(TorusError::PointOffTorus { index, distance, limit: tolerance }.into());
        }
        let (cos, sin) = (from_core.x / reach, from_core.y / reach);
        let across = if cos < 0.0 { sin * sin / (1.0 - cos) - self.shape.thin } else { cos + self.shape.tube };
        Ok(Point2::new(0.5 * y.atan2(x), 0.5 * (self.shape.root * sin).atan2(across)))
    }

    /// The speed in the plane of the torus of a curve that passes a place with this velocity in space; what it has across the
    /// surface is left out.
    ///
    /// ```
    /// use cyclide::{Frame, Point2, Vec2, surface::Torus};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let (place, rate) = (Point2::new(0.4, 1.2), Vec2::new(0.7, -2.0));
    /// assert!((torus.rate(place, torus.tangent(place, rate)) - rate).length() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn rate(&self, place: Point2, velocity: Vec3) -> Vec2 {
        let at = UnitPair::at(place);
        let (e, n, radius) = (at.longitude(), self.shape.normal(&at), self.shape.radius(&at));
        let frame = self.frame();
        let v = velocity / self.major_radius();
        let (x, y, z) = (v.dot(frame.x()), v.dot(frame.y()), v.dot(frame.z()));
        let (outward, around) = (x * e.re + y * e.im, y * e.re - x * e.im);
        let (cos, sin) = (n.x * e.re + n.y * e.im, n.z);
        let meridian = (cos * z - sin * outward) / self.shape.tube;
        Vec2::new(0.5 * around / radius, 0.5 * self.shape.root * meridian / radius)
    }
}
