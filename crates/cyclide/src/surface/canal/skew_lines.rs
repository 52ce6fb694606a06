//! Two cylinders or cones as lines of the space of balls, and the motion of this space from two lines of ordinary space to them
//! (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`).
//!
//! The balls in a cylinder or cone with their centres on the axis, radii counted negative, are a line; a ball touches from outside where it is at a null distance from
//! that. Two lines with a common perpendicular that is spacelike, in a plane of directions that is too, are moved to lines of ordinary space: cylinders
//! of radius zero, at an angle `w`, `2h` apart. The radius of a ball is then a linear form of their balls, and those of one radius are
//! ```text
//! a sin²(A - A1) + b sin²(B - B1) = (a + b - 2h g)/2
//! ```

use super::ball_space::{BallMotion, BallVector};
use super::{CanalPatch, NaturalQuadric, RollingBall, SkewCylinders};
use crate::base::planar::{Point2, Vec2};
use crate::error::{Error, Result};
use crate::surface::TorusPiece;
use std::f64::consts::PI;

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

/// Two lines of the space of balls as the image of two skew lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SkewLines {
    lines: SkewCylinders,
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

impl SkewLines {
    /// `None` unless the plane of their directions and their common perpendicular are spacelike.
    pub(crate) fn new([first, second]: [BallLine; 2]) -> Option<Self> {
        let e1 = first.direction.spacelike_unit()?;
        let along = e1.dot(second.direction);
        let e2 = (second.direction - e1 * along).spacelike_unit()?;
        let across = e2.dot(second.direction);
        let between = second.through - first.through;
        let [p, q] = [e1, e2].map(|e| e.dot(between));
        let gap = between - e1 * p - e2 * q;
        let e3 = gap.spacelike_unit()?;
        // What is left of the axis of radii, whose square is -1 or below.
        let time = BallVector { center: crate::base::vector::Vec3::ZERO, radius: 1.0 };
        let ahead = [e1, e2, e3].into_iter().fold(time, |rest, e| rest - e * e.dot(time));
        let g = ahead * (1.0 / (-ahead.dot(ahead)).sqrt());
        let half_gap = 0.5 * e3.dot(gap);
        let foot = first.through + e1 * (p - q / across * along);
        let motion = BallMotion::new(foot + gap * 0.5, [e1, e2, e3, g]);
        // The first axis may have been turned about.
        let cosine = motion.axes[0].dot(second.direction);
        let lines = SkewCylinders::of_lines(half_gap, (-cosine).atan2(across));
        (half_gap.is_finite() && half_gap > 0.0).then_some(Self { lines, motion })
    }

    /// The skew lines in ordinary space.
    pub(crate) fn lines(&self) -> &SkewCylinders {
        &self.lines
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
        Ok(self.motion.ball(&self.lines.ball(place)?))
    }

    /// The canal along a piece, and the same before the motion.
    pub(crate) fn patches(&self, piece: &TorusPiece) -> Result<[CanalPatch; 2]> {
        let still = CanalPatch::along(&self.lines, piece)?;
        Ok([self.motion.patch(&still), still])
    }

    /// `2h g`, and the coefficients of the sines of 2A and 2B and the shift along the gap in `X0 (R - r)`, r that of the origin.
    fn radius_form(&self) -> [f64; 4] {
        let ([e1, e2, e3, g], gap) = (self.motion.axes.map(|e| e.radius), 2.0 * self.lines.half_gap());
        let (sin, cos) = self.lines.angle().sin_cos();
        [gap * g, gap * (e2 + e1 * cos / sin), gap * e1 / sin, 0.5 * gap * e3]
    }

    /// The radius of the smallest ball outside both; negative where the surfaces overlap. `None` where there is none: they do so without end.
    ///
    /// With `x = R - r` it is where `|(x - z, s)| + |(x + z, t)| = c`, a quadratic in x.
    pub(crate) fn smallest_radius(&self) -> Option<f64> {
        let [c, s, t, z] = self.radius_form();
        let (k, cc) = (s * s - t * t, c * c);
        let square = (c - 2.0 * z) * (c + 2.0 * z);
        let linear = k * z;
        let constant = (z * z + 0.5 * (s * s + t * t) - 0.25 * cc) * cc - 0.25 * k * k;
        let discriminant = linear * linear - square * constant;
        (square > 0.0 && discriminant >= 0.0)
            .then(|| self.motion.origin.radius + (discriminant.sqrt() - linear) / square)
    }

    /// The loop of the balls of a radius.
    ///
    /// # Errors
    /// `radius-too-small`, `sphere-at-infinity` (it is not closed).
    pub(crate) fn radius_loop(&self, radius: f64) -> Result<RadiusLoop> {
        let limit = self.smallest_radius().ok_or(Error::SphereAtInfinity { measured: -1.0, limit: 0.0 })?;
        if !(radius >= limit) {
            return Err(Error::RadiusTooSmall { radius, limit });
        }
        let ([c, s, t, z], x) = (self.radius_form(), radius - self.motion.origin.radius);
        let (a, b) = (s.hypot(x - z), t.hypot(x + z));
        let excess = (0.5 * (a + b - c)).max(0.0);
        let left = 1.0 - excess / a.min(b);
        if !(left > 0.0) {
            return Err(Error::SphereAtInfinity { measured: left, limit: 0.0 });
        }
        let middle = 0.5 * (-t).atan2(-z - x);
        Ok(RadiusLoop {
            middle: Point2::new(0.5 * (-s).atan2(x - z), if middle < 0.0 { middle + PI } else { middle }),
            reach: [a, b].map(|of| (excess / of).sqrt()),
        })
    }
}
