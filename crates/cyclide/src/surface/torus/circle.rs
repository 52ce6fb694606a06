//! The circles of a torus and arcs of them (`docs/math/torus-splines.md#four-families-of-circles`).

use super::Torus;
use super::class::UnitPair;
use super::family::CircleFamily;
use crate::base::complex::Complex;
use crate::base::planar::Point2;
use crate::base::vector::Vec3;
use crate::curve::{Arc, Circle};
use crate::error::{ErrorItem, NumberError, Result};
use std::f64::consts::PI;

impl Torus {
    /// The circle of a family through a place, which starts there and runs as the coordinate of the family rises. Villarceau
    /// circles have the major radius.
    ///
    /// # Errors
    /// `not-finite`; as [`Circle::from_center`], if the torus is too small for its place.
    pub fn circle(&self, family: CircleFamily, place: Point2) -> Result<Circle> {
        check_place(place)?;
        let (center, normal) = self.center_and_normal(family, place);
        let local = |v: Vec3| self.frame().x() * v.x + self.frame().y() * v.y + self.frame().z() * v.z;
        Circle::from_center(self.world_point(center), local(normal), self.point(place))
    }

    /// The arc of the circle of a family from a place, over a step of the coordinate of the family, radians: half a turn of
    /// the circle or less for `|step| <= pi/2`, nearly all of it near pi.
    ///
    /// # Errors
    /// `not-finite`, `angle-out-of-range` (zero, or pi and more: take [`circle`](Self::circle)); as [`Arc::from_start_tangent`].
    pub fn arc(&self, family: CircleFamily, place: Point2, step: f64) -> Result<Arc> {
        check_place(place)?;
        if !(step.abs() > 0.0 && step.abs() < PI) {
            return Err(NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle: step, min: -PI, max: PI }.into());
        }
        let direction = family.direction() * step;
        Arc::from_start_tangent(self.point(place), self.point(place + direction), self.tangent(place, direction))
    }

    /// In the axes of the torus and units of its major radius.
    fn center_and_normal(&self, family: CircleFamily, place: Point2) -> (Vec3, Vec3) {
        let (shape, at) = (&self.shape, UnitPair::at(place));
        let villarceau = |d: f64, sign: f64| {
            let e = Complex::at_angle(2.0 * d);
            let tube = shape.tube;
            (Vec3::new(tube * e.re, tube * e.im, 0.0), Vec3::new(sign * tube * e.im, -sign * tube * e.re, shape.root))
        };
        match family {
            CircleFamily::Parallel => (Vec3::new(0.0, 0.0, shape.point(&at).z), Vec3::Z),
            CircleFamily::Villarceau => villarceau(place.x - place.y, 1.0),
            CircleFamily::MirrorVillarceau => villarceau(place.x + place.y, -1.0),
            CircleFamily::Meridian => {
                let e = at.longitude();
                (Vec3::new(e.re, e.im, 0.0), Vec3::new(e.im, -e.re, 0.0))
            }
        }
    }
}

/// Refuses a place that is not finite.
pub(super) fn check_place(place: Point2) -> Result<()> {
    if place.is_finite() { Ok(()) } else { Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into()) }
}
