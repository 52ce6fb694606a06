//! Two cylinders or cones as lines of the space of balls, and the motion of this space from two skew cylinders to them
//! (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`).
//!
//! The balls in a cylinder or cone with their centers on the axis, radii counted negative, are a line; a ball touches from outside where it is at a null distance from
//! that. Two lines with directions in a spacelike plane, and a common perpendicular that is spacelike too, are moved to the axes of two cylinders. With the part of the axis of
//! radii across both directions for the axis of their radii cylinders do not change, and cones lose no more digits than their tapers take. The radius of a ball is a linear form
//! of the ball of these cylinders, and those of one radius are
//! ```text
//! a sin²(A - A1) + b sin²(B - B1) = (a + b - c)/2
//! ```

use super::ball_space::{BallMotion, BallVector};
use super::center_surface::{WeightedBall, rational};
use super::{CanalPatch, NaturalQuadric, RollingBall, SkewCylinders};
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Vec3;
use crate::error::{BallError, Result};
use crate::rational::RationalBezierSurface;
use crate::surface::TorusPiece;
use std::f64::consts::PI;

/// A loop that is not closed by less than this, in parts of its size, is one that reaches all round but for rounding.
const ROUNDING: f64 = 1e-12;

/// The balls in a cylinder or a cone: one of them, and the difference to others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallLine {
    pub(crate) through: BallVector,
    pub(crate) direction: BallVector,
}

impl BallLine {
    pub(super) fn of_quadric(surface: &NaturalQuadric) -> Self {
        let through = BallVector { center: surface.origin().to_vec(), radius: -surface.radius() };
        // The balls of a cone grow into it.
        let direction = BallVector { center: surface.axis(), radius: -surface.half_angle().sin() };
        Self { through, direction }
    }
}

/// Two lines of the space of balls as the image of two skew cylinders, whose radii may be zero or negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MovedCylinders {
    still: SkewCylinders,
    motion: BallMotion,
}

/// The balls of one radius: a closed curve of places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RadiusLoop {
    middle: Point2,
    /// Sines of how far it reaches from there.
    reach: [f64; 2],
}

impl RadiusLoop {
    /// The place at an angle of the loop.
    pub(crate) fn place(&self, theta: f64) -> Point2 {
        let ((sin, cos), [a, b]) = (theta.sin_cos(), self.reach);
        Point2::new(self.middle.x + (a * cos).asin(), self.middle.y + (b * sin).asin())
    }

    /// The rate of the place by the angle.
    pub(crate) fn rate(&self, theta: f64) -> Vec2 {
        let ((sin, cos), [a, b]) = (theta.sin_cos(), self.reach);
        let slope = |reach: f64, along: f64| reach / ((1.0 - reach * along) * (1.0 + reach * along)).sqrt();
        Vec2::new(-slope(a, cos) * sin, slope(b, sin) * cos)
    }
}

impl MovedCylinders {
    /// `None` unless the plane of their directions and their common perpendicular are spacelike.
    pub(crate) fn new([first, second]: [BallLine; 2]) -> Option<Self> {
        let e1 = first.direction.spacelike_unit()?;
        let along = e1.dot(second.direction);
        let e2 = (second.direction - e1 * along).spacelike_unit()?;
        let across = e2.dot(second.direction);
        // The square of what is left of the axis of radii is -1 or below.
        let time = BallVector { center: Vec3::ZERO, radius: 1.0 };
        let ahead = time - e1 * e1.dot(time) - e2 * e2.dot(time);
        let g = ahead * (1.0 / (-ahead.dot(ahead)).sqrt());
        let between = second.through - first.through;
        let [p, q] = [e1, e2].map(|e| e.dot(between));
        let perpendicular = between - e1 * p - e2 * q;
        let growth = -g.dot(perpendicular);
        let gap = perpendicular - g * growth;
        let e3 = gap.spacelike_unit()?;
        let half_gap = 0.5 * e3.dot(gap);
        let middle = first.through + e1 * (p - q / across * along) + perpendicular * 0.5;
        // From the balls of radius zero on.
        let reach = -middle.radius / g.radius;
        let motion = BallMotion::new(middle + g * reach, [e1, e2, e3, g]);
        // The first axis may have been turned about.
        let cosine = motion.axes[0].dot(second.direction);
        let radii = [reach + 0.5 * growth, reach - 0.5 * growth];
        let still = SkewCylinders::unchecked(radii, half_gap, (-cosine).atan2(across));
        (half_gap.is_finite() && still.sides().into_iter().all(|side| side > 0.0)).then_some(Self { still, motion })
    }

    /// The cylinders before the motion.
    pub(crate) fn still(&self) -> &SkewCylinders {
        &self.still
    }

    /// The motion from their balls to those of the pair.
    pub(crate) fn motion(&self) -> &BallMotion {
        &self.motion
    }

    /// For a line with the direction `d` the products of it with the origin and with both axes across the common perpendicular: where a ball is along the line.
    pub(crate) fn along(&self, direction: BallVector) -> [f64; 3] {
        let [e1, e2, _, _] = self.motion.axes;
        [self.motion.origin, e1, e2].map(|v| v.dot(direction))
    }

    pub(super) fn ball(&self, place: Point2) -> Result<RollingBall> {
        Ok(self.motion.ball(&self.still.ball(place)?))
    }

    /// Coefficients of the balls at the places with `B - A` and `B + A` between these angles.
    ///
    /// # Errors
    /// As [`SkewCylinders::center_surface`].
    pub(super) fn weighted_balls(&self, u: [f64; 2], v: [f64; 2]) -> Result<Vec<WeightedBall>> {
        let moved = |(ball, weight)| (self.motion.weighted(ball, weight), weight);
        Ok(self.still.weighted_balls(u, v)?.into_iter().map(moved).collect())
    }

    /// The centers of the same.
    ///
    /// # Errors
    /// As [`SkewCylinders::center_surface`].
    pub(crate) fn center_surface(&self, u: [f64; 2], v: [f64; 2]) -> Result<RationalBezierSurface> {
        rational(self.weighted_balls(u, v)?)
    }

    /// The canal along a piece, and the same before the motion.
    pub(crate) fn patches(&self, piece: &TorusPiece) -> Result<[CanalPatch; 2]> {
        let still = CanalPatch::along(&self.still, piece)?;
        Ok([self.motion.patch(&still), still])
    }

    fn radius_form(&self) -> RadiusForm {
        let ([e1, e2, e3, g], width) = (self.motion.axes.map(|e| e.radius), self.still.width());
        let ([first, second], (sin, cos)) = (self.still.radii(), self.still.angle().sin_cos());
        let (gap, d) = (2.0 * self.still.half_gap(), second - first);
        RadiusForm {
            c: gap * g - e3 * d,
            s: width * (e2 + e1 * cos / sin),
            t: width * e1 / sin,
            z: 0.5 * (gap * e3 - g * d),
            shift: 0.5 * g * (first + second) - self.motion.origin.radius,
        }
    }

    /// The radius of the smallest ball outside both; negative where the surfaces overlap. `None` where there is none: they do so without end.
    pub(crate) fn smallest_radius(&self) -> Option<f64> {
        let form = self.radius_form();
        form.smallest().map(|x| x - form.shift)
    }

    /// The loop of the balls of a radius.
    ///
    /// # Errors
    /// `radius-too-small`, `sphere-at-infinity` (it is not closed).
    pub(crate) fn radius_loop(&self, radius: f64) -> Result<RadiusLoop> {
        let form = self.radius_form();
        let smallest = form.smallest().ok_or(BallError::SphereAtInfinity { measured: -1.0, limit: 0.0 })?;
        let (limit, x) = (smallest - form.shift, radius + form.shift);
        if !(radius >= limit) {
            return Err(BallError::RadiusTooSmall { radius, limit, works: None }.into());
        }
        let RadiusForm { s, t, z, .. } = form;
        let ([a, b], [a0, b0]) = (form.sides(x), form.sides(smallest));
        // (a + b - c)/2 by differences of squares.
        let excess =
            0.5 * (radius - limit) * ((x + smallest - 2.0 * z) / (a + a0) + (x + smallest + 2.0 * z) / (b + b0));
        let left = 1.0 - excess / a.min(b);
        if !(left > -ROUNDING) {
            return Err(BallError::SphereAtInfinity { measured: left, limit: 0.0 }.into());
        }
        let middle = 0.5 * (-t).atan2(-z - x);
        Ok(RadiusLoop {
            middle: Point2::new(0.5 * (-s).atan2(x - z), if middle < 0.0 { middle + PI } else { middle }),
            reach: [a, b].map(|of| (excess / of).clamp(0.0, 1.0).sqrt()),
        })
    }
}

/// `X0 (R + shift) = c + z (cos 2A + cos 2B) + s sin 2A + t sin 2B` for the radius R of a ball.
#[derive(Debug, Clone, Copy)]
struct RadiusForm {
    c: f64,
    s: f64,
    t: f64,
    z: f64,
    shift: f64,
}

impl RadiusForm {
    /// `a` and `b` for `x = R + shift`.
    fn sides(&self, x: f64) -> [f64; 2] {
        [self.s.hypot(x - self.z), self.t.hypot(x + self.z)]
    }

    /// Where `a + b = c`, a quadratic in x.
    fn smallest(&self) -> Option<f64> {
        let Self { c, s, t, z, .. } = *self;
        let (k, cc) = (s * s - t * t, c * c);
        let square = (c - 2.0 * z) * (c + 2.0 * z);
        let constant = (z * z + 0.5 * (s * s + t * t) - 0.25 * cc) * cc - 0.25 * k * k;
        let discriminant = k * z * (k * z) - square * constant;
        (square > 0.0 && discriminant >= 0.0).then(|| (discriminant.sqrt() - k * z) / square)
    }
}
