//! Blends of a ring, a torus, with a plate or a sphere about its axis: exact, tori themselves (`docs/math/contact-blends.md#rings`).
//!
//! A plane through the axis cuts all of it in circles and lines. The centers of the balls of one radius that touch both are where a circle about that of the ring's tube meets
//! a line or a circle about the center of the sphere: two places, the corner round the ring and that in its hole.

use super::ball_centers::BallCenters;
use super::{MadeContactBlend, Revolution, TeeBlendFacts};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, Circle};
use crate::error::{ContactError, ErrorItem, PipeError, Result, TorusError};
use crate::topology::EdgeCurve;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A plate reaches this part of its radius or more beyond the blend.
const LEAST_REST: f64 = 1e-3;

/// A ring about the z axis: a torus with a hole.
///
/// ```
/// use cyclide::construct::BlendRing;
/// let ring = BlendRing { radius: 30.0, tube: 8.0, height: 5.0 };
/// assert!(ring.tube < ring.radius);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlendRing {
    /// Radius of the circle about the axis in the middle of its tube.
    pub radius: f64,
    /// Radius of its tube, less than that.
    pub tube: f64,
    /// Height of that circle above the origin.
    pub height: f64,
}

/// What a ring stands on.
#[derive(Debug, Clone, Copy, PartialEq)]
enum RingBase {
    /// The plane z = 0 about the origin, as far as this radius.
    Disk(f64),
    /// The sphere about the origin.
    Sphere(f64),
}

/// A ring blended with a round plate or a sphere by a ball of one radius, in the corner round it and in that of its hole.
///
/// All faces are parts of planes, cylinders, spheres and tori, tangent along circles.
///
/// ```
/// use cyclide::construct::{BlendRing, RingBlend};
/// let ring = BlendRing { radius: 30.0, tube: 8.0, height: 5.0 };
/// let made = RingBlend::on_plate(ring, 60.0, 4.0)?.with_thickness(6.0)?.made()?;
/// assert!(made.body.is_solid());
/// assert_eq!(made.blend.radii, [4.0, 4.0]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingBlend {
    ring: BlendRing,
    base: RingBase,
    ball: f64,
    thickness: Option<f64>,
}

impl RingBlend {
    /// On the plane z = 0, as a round plate of this radius about the axis: an open surface, or with a [thickness](Self::with_thickness) a solid.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `parameter-out-of-range`, `not-a-ring-torus`.
    pub fn on_plate(ring: BlendRing, radius: f64, ball: f64) -> Result<Self> {
        Self::new(ring, RingBase::Disk(radius), [radius, ball])
    }

    /// On the sphere of this radius about the origin: a solid.
    ///
    /// # Errors
    /// As [`on_plate`](Self::on_plate).
    pub fn on_sphere(ring: BlendRing, radius: f64, ball: f64) -> Result<Self> {
        Self::new(ring, RingBase::Sphere(radius), [radius, ball])
    }

    fn new(ring: BlendRing, base: RingBase, [other, ball]: [f64; 2]) -> Result<Self> {
        let base_is = match base {
            RingBase::Sphere(_) => ErrorItem::Sphere,
            RingBase::Disk(_) => ErrorItem::Plate,
        };
        let radii =
            [(ErrorItem::Ring, ring.radius), (ErrorItem::Blend, ball), (base_is, other), (ErrorItem::Ring, ring.tube)];
        for (what, radius) in radii {
            range::check_radius(what, 0, radius)?;
        }
        range::check_point(0, Vec3::Z * ring.height)?;
        if !(ring.tube < ring.radius) {
            return Err(TorusError::NotARingTorus { major: ring.radius, minor: ring.tube }.into());
        }
        Ok(Self { ring, base, ball, thickness: None })
    }

    /// The same with a plate of this thickness; on a sphere it changes nothing.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `not-finite`.
    pub fn with_thickness(self, thickness: f64) -> Result<Self> {
        range::check_thickness(thickness)?;
        Ok(Self { thickness: Some(thickness), ..self })
    }

    /// The body, with what is known of its blends. A ring on a plate without a thickness is an open surface.
    ///
    /// # Errors
    /// `contact-loop-open` (the ring is out of reach of the ball, or within the plate or the sphere), `ball-does-not-fit` (into the hole of the ring), `contact-blend-folds`,
    /// `plate-too-small`.
    pub fn made(&self) -> Result<MadeContactBlend> {
        let balls = self.balls()?;
        let corners = balls.map(|ball| Corner {
            ball,
            radius: self.ball,
            to_ring: angle(ball, self.middle()),
            to_base: self.towards_base(ball),
        });
        let tightest = corners.iter().map(Corner::left).fold(f64::INFINITY, f64::min);
        // Balls that overlap leave nothing between both blends where these reach the middle.
        let [across, apart] = [angle(balls[0], balls[1]), (balls[1][0] - balls[0][0]).hypot(balls[1][1] - balls[0][1])];
        let between = if corners[0].passes(across) { 1.0 - 2.0 * self.ball / apart } else { 1.0 };
        let left = tightest.min(between);
        if !(left > 0.0) {
            return Err(ContactError::BlendFolds { angle: 0.0, left }.into());
        }
        let profile = self.profile(corners)?;
        let body = Revolution::new(Point3::ORIGIN, Vec3::Z, TAU)?.body(&profile, false)?;
        let blend = TeeBlendFacts { radii: [self.ball; 2], deviation: 0.0, pieces: 8, tightest, tightest_at: 0.0 };
        let circle = |ball: [f64; 2]| {
            let middle = Point3::new(0.0, 0.0, ball[1]);
            Circle::from_center(middle, Vec3::Z, point(ball))?.to_nurbs()
        };
        let paths = balls.into_iter().map(circle).collect::<Result<Vec<_>>>()?;
        Ok(MadeContactBlend { body, blend, centers: BallCenters::new(paths, None) })
    }

    /// The middle of the tube in the half plane `(distance from the axis, height)`.
    fn middle(&self) -> [f64; 2] {
        [self.ring.radius, self.ring.height]
    }

    /// The centers of the balls in the hole and round the ring.
    fn balls(&self) -> Result<[[f64; 2]; 2]> {
        let ([a, h], reach) = (self.middle(), self.ring.tube + self.ball);
        // From the foot of the middle on the line, or on the line of both centers, so far to both sides.
        let (foot, way, square) = match self.base {
            RingBase::Disk(_) => {
                let up = h - self.ball;
                ([a, self.ball], [1.0, 0.0], (reach - up) * (reach + up))
            }
            RingBase::Sphere(r) => {
                let (apart, both) = (a.hypot(h), r + self.ball);
                let along = 0.5 * (apart + (both - reach) * (both + reach) / apart);
                let [x, z] = [a / apart, h / apart];
                ([along * x, along * z], [z, -x], (both - along) * (both + along))
            }
        };
        if !(square > 0.0) {
            return Err(ContactError::LoopOpen { ring: true, angle: 0.0, measured: square }.into());
        }
        let half = square.sqrt();
        let balls = [-half, half].map(|t| [foot[0] + t * way[0], foot[1] + t * way[1]]);
        if balls.iter().any(|ball| !(ball[0] > 0.0)) {
            return Err(PipeError::BallDoesNotFit { radius: self.ball, limit: self.largest_ball() }.into());
        }
        Ok(balls)
    }

    /// The ball that touches ring and base from the axis.
    fn largest_ball(&self) -> f64 {
        let ([a, h], b) = (self.middle(), self.ring.tube);
        match self.base {
            RingBase::Disk(_) => (a * a + (h - b) * (h + b)) / (2.0 * (b + h)),
            RingBase::Sphere(r) => [h - r, -h - r]
                .into_iter()
                .filter(|up| up + b > 0.0)
                .map(|up| (a * a + (up - b) * (up + b)) / (2.0 * (up + b)))
                .fold(f64::INFINITY, f64::min),
        }
    }

    /// The angle of the way from a ball to its contact with the base.
    fn towards_base(&self, ball: [f64; 2]) -> f64 {
        match self.base {
            RingBase::Disk(_) => -FRAC_PI_2,
            RingBase::Sphere(_) => angle(ball, [0.0, 0.0]),
        }
    }

    /// From the axis out on a plate, from above down on a sphere: outside is to the left.
    fn profile(&self, [inner, outer]: [Corner; 2]) -> Result<Vec<EdgeCurve>> {
        let (middle, tube) = (self.middle(), self.ring.tube);
        let top = match self.base {
            RingBase::Disk(_) => FRAC_PI_2,
            RingBase::Sphere(_) => middle[1].atan2(middle[0]),
        };
        let [inside, outside] = [inner, outer].map(|corner| corner.to_ring + PI);
        // Over the ring in two arcs, clockwise by way of the top.
        let over = [turn(inside - top), turn(top - outside)];
        let crest = at(middle, tube, top);
        let ends = [inner, outer].map(|corner| [corner.on_ring(), corner.on_base()]);
        let mut profile = Vec::new();
        let [[ring_in, base_in], [ring_out, base_out]] = ends;
        if let RingBase::Sphere(r) = self.base {
            profile.push(through(
                point([0.0, r]),
                at([0.0; 2], r, 0.5 * (FRAC_PI_2 + shorter(inner.to_base + PI))),
                base_in,
            )?);
        } else {
            profile.push(Arc::segment(Point3::ORIGIN, base_in)?.into());
        }
        profile.push(through(base_in, inner.middle(), ring_in)?);
        profile.push(through(ring_in, at(middle, tube, top + 0.5 * over[0]), crest)?);
        profile.push(through(crest, at(middle, tube, top - 0.5 * over[1]), ring_out)?);
        profile.push(through(ring_out, outer.middle(), base_out)?);
        match self.base {
            RingBase::Sphere(r) => {
                let middle = 0.5 * (shorter(outer.to_base + PI) - FRAC_PI_2);
                profile.push(through(base_out, at([0.0; 2], r, middle), point([0.0, -r]))?);
            }
            RingBase::Disk(radius) => {
                let needed = base_out.x;
                if !(radius > needed * (1.0 + LEAST_REST)) {
                    return Err(PipeError::PlateTooSmall { what: ErrorItem::Blend, reach: radius, needed }.into());
                }
                let mut corners = vec![base_out, point([radius, 0.0])];
                if let Some(thickness) = self.thickness {
                    corners.extend([point([radius, -thickness]), point([0.0, -thickness])]);
                }
                for pair in corners.windows(2) {
                    profile.push(Arc::segment(pair[0], pair[1])?.into());
                }
            }
        }
        Ok(profile)
    }
}

/// A ball in a corner between the ring and its base.
#[derive(Debug, Clone, Copy)]
struct Corner {
    ball: [f64; 2],
    radius: f64,
    /// The angles of the ways to its contacts.
    to_ring: f64,
    to_base: f64,
}

impl Corner {
    fn on_ring(&self) -> Point3 {
        at(self.ball, self.radius, self.to_ring)
    }

    fn on_base(&self) -> Point3 {
        at(self.ball, self.radius, self.to_base)
    }

    /// The turn from the second to the first along the shorter arc.
    fn turn(&self) -> f64 {
        shorter(self.to_ring - self.to_base)
    }

    /// The middle of that arc.
    fn middle(&self) -> Point3 {
        at(self.ball, self.radius, self.to_base + 0.5 * self.turn())
    }

    /// Whether a direction is within it.
    fn passes(&self, angle: f64) -> bool {
        turn(angle - self.to_base.min(self.to_base + self.turn())) < self.turn().abs()
    }

    /// What is left of the width of the blend where it is nearest to the axis: its distance from that in parts of the ball's.
    fn left(&self) -> f64 {
        let nearest = if self.passes(PI) { self.ball[0] - self.radius } else { self.on_ring().x.min(self.on_base().x) };
        (nearest / self.ball[0]).min(1.0)
    }
}

fn point([x, z]: [f64; 2]) -> Point3 {
    Point3::new(x, 0.0, z)
}

/// The point of a circle at an angle from the direction away from the axis.
fn at([x, z]: [f64; 2], radius: f64, angle: f64) -> Point3 {
    let (sin, cos) = angle.sin_cos();
    point([x + radius * cos, z + radius * sin])
}

/// The angle of the way from a place to another.
fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// An angle in `[0, 2π)`.
fn turn(angle: f64) -> f64 {
    angle.rem_euclid(TAU)
}

/// An angle in `[-π, π)`.
fn shorter(angle: f64) -> f64 {
    turn(angle + PI) - PI
}

fn through(start: Point3, middle: Point3, end: Point3) -> Result<EdgeCurve> {
    Ok(Arc::from_three_points(start, middle, end)?.into())
}
