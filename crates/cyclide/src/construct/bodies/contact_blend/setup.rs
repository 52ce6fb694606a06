//! A tube and what it is blended with in the axes of the tube, and the contact heights of balls of one radius
//! (`docs/math/contact-blends.md#contact-heights`).

use super::{BlendBase, BlendTube};
use crate::base::frame::Frame;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{BallError, ContactError, Error, ErrorItem, NumberError, PipeError, Result};
use crate::rational::{Polynomial, PolynomialRow};

/// An axis nearer to the center of a sphere than this part of the lengths passes through it.
const THROUGH: f64 = 1e-14;
/// Lines of the tube along the tangent plane, as the sine of the angle between them, are refused up to this.
const PARALLEL: f64 = 1e-9;

/// What the tube is blended with, in its axes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Base {
    /// A plane through the origin with the normal `(n0, 0, n1)`.
    Plane([f64; 2]),
    /// A sphere about `(e, 0, 0)`; its radius is negative where the ball is inside.
    Sphere { e: f64, r: f64 },
}

/// A tube about the z axis of its frame: at height z its surface has the radius `rho + z tan`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Setup {
    pub(super) frame: Frame,
    pub(super) rho: f64,
    pub(super) sin: f64,
    pub(super) cos: f64,
    pub(super) tan: f64,
    /// Where the tube ends.
    pub(super) end: f64,
    /// How much lower the origin is than the place that the tube was given at.
    pub(super) shift: f64,
    pub(super) base: Base,
    /// 1 for a ball outside the tube, -1 for one inside.
    pub(super) sigma: f64,
    pub(super) ball: f64,
}

impl Setup {
    /// # Errors
    /// `parallel-contact` (the axis is parallel to the plane), `contact-tube-too-short` never.
    pub(super) fn new(tube: &BlendTube, base: &BlendBase, sigma: f64, ball: f64) -> Result<Self> {
        let z = tube.direction.unit().ok_or(Error::zero_axis(ErrorItem::Direction))?;
        let (origin, x, base) = match base {
            BlendBase::Plane(_) => {
                let lean = z.x.hypot(z.y);
                if !(z.z > PARALLEL) {
                    return Err(BallError::ParallelContact { measured: z.z, limit: PARALLEL }.into());
                }
                let origin = tube.through - z * (tube.through.z / z.z);
                let x = if lean > 0.0 { Vec3::new(-z.x / lean * z.z, -z.y / lean * z.z, lean) } else { Vec3::X };
                (Point3::new(origin.x, origin.y, 0.0), x, Base::Plane([lean, z.z]))
            }
            BlendBase::Sphere { radius } => {
                let from = tube.through.to_vec();
                let across = z.cross(from.cross(z));
                let e = across.length();
                let coaxial = e <= THROUGH * (from.length() + radius);
                let x = if coaxial { z.any_perpendicular() } else { across * (-1.0 / e) };
                let origin = if coaxial { Vec3::ZERO } else { across };
                let base = Base::Sphere { e: if coaxial { 0.0 } else { e }, r: radius * sigma };
                (Point3::ORIGIN + origin, x, base)
            }
        };
        let shift = (tube.through - origin).dot(z);
        let (sin, cos) = (-tube.taper).sin_cos();
        let tan = sin / cos;
        let frame = Frame::of_axes(origin, [x, z.cross(x), z]);
        let (rho, end) = (tube.radius - shift * tan, tube.length + shift);
        Ok(Self { frame, rho, sin, cos, tan, end, shift, base, sigma, ball })
    }

    /// Distance from the axis of a ball whose contact is in the plane of the origin.
    pub(super) fn center_at_origin(&self) -> f64 {
        self.rho + self.ball * self.sigma * self.cos
    }

    /// Whether all contacts are at one height: blends are tori then.
    pub(super) fn is_level(&self) -> bool {
        matches!(self.base, Base::Plane([0.0, _]) | Base::Sphere { e: 0.0, .. })
    }

    /// The height of the contact of the ball with the tube at an angle, and its derivative by the angle.
    ///
    /// # Errors
    /// `contact-loop-open` where no such ball touches both, `radius-not-positive` where it does beyond the apex.
    pub(super) fn height(&self, angle: f64) -> Result<[f64; 2]> {
        let height = self.height_on_lines(angle)?;
        if self.radius_at(0.0, height[0]) > 0.0 { Ok(height) } else { Err(self.beyond_apex(0.0, height[0])) }
    }

    /// The same on lines that go on beyond the apex.
    fn height_on_lines(&self, angle: f64) -> Result<[f64; 2]> {
        let ((s, c), open) =
            (angle.sin_cos(), |measured| Error::Contact(ContactError::LoopOpen { ring: false, angle, measured }));
        let (from_axis, down) = (self.center_at_origin(), self.ball * self.sigma * self.sin);
        match self.base {
            Base::Plane([n0, n1]) => {
                let rise = n1 + n0 * self.tan * c;
                if !(rise > PARALLEL) {
                    return Err(open(rise));
                }
                let height = (self.ball + n1 * down - n0 * from_axis * c) / rise;
                Ok([height, n0 * s * (from_axis + height * self.tan) / rise])
            }
            Base::Sphere { e, r } => {
                let a = 1.0 + self.tan * self.tan;
                let b = self.tan * (from_axis - e * c) - down;
                let reach = r + self.ball;
                let k = from_axis * (from_axis - 2.0 * e * c) + (e * e + down * down - reach * reach);
                let square = b * b - a * k;
                if !(square > 0.0) {
                    return Err(open(square));
                }
                let root = self.sigma * square.sqrt();
                let height = (root - b) / a;
                Ok([height, -e * s * (from_axis + height * self.tan) / root])
            }
        }
    }

    /// The radius of the ball that touches the tube all round from inside, and the plane or the sphere: larger ones do not fit.
    pub(super) fn ball_on_axis(&self) -> Option<f64> {
        // A ball with its center at the height z on the axis touches the tube with the radius `level + z sin`.
        let level = self.rho * self.cos;
        let height = match self.base {
            Base::Plane([_, n1]) => level / (n1 - self.sin),
            Base::Sphere { e, r } => {
                let reach = level + r;
                let square = reach * reach - e * e * self.cos * self.cos;
                (reach * self.sin - square.sqrt()) / (self.cos * self.cos)
            }
        };
        Some(level + height * self.sin).filter(|radius| radius.is_finite())
    }

    /// The radius of the tube at a depth below its surface and a height.
    pub(super) fn radius_at(&self, depth: f64, height: f64) -> f64 {
        self.rho + height * self.tan - depth / self.cos
    }

    /// What is said of a height at which the radius at a depth is not positive. Of a cylinder it is that radius: a wall as thick as it.
    pub(super) fn beyond_apex(&self, depth: f64, height: f64) -> Error {
        let apex = (depth / self.cos - self.rho) / self.tan;
        if apex.is_finite() {
            Error::Pipe(PipeError::ConeReachesApex { pipe: 0, apex: apex - self.shift, reached: height - self.shift })
        } else {
            Error::Number(NumberError::RadiusNotPositive {
                what: ErrorItem::Tube,
                index: 0,
                radius: self.radius_at(depth, height),
            })
        }
    }

    /// The sphere at a depth: its signed radius along the normals of contacts.
    pub(super) fn sphere_at(&self, r: f64, depth: f64) -> f64 {
        r - self.sigma * depth
    }

    /// A row in space.
    pub(super) fn placed(&self, [x, y, z, w]: [Polynomial; 4]) -> PolynomialRow {
        let frame = self.frame;
        let o = frame.origin();
        let entry = |o: f64, a: f64, b: f64, c: f64| &(&(&w * o) + &(&x * a)) + &(&(&y * b) + &(&z * c));
        let (u, v, t) = (frame.x(), frame.y(), frame.z());
        PolynomialRow([entry(o.x, u.x, v.x, t.x), entry(o.y, u.y, v.y, t.y), entry(o.z, u.z, v.z, t.z), w.clone()])
    }

    /// A point in space.
    pub(super) fn point(&self, [x, y, z]: [f64; 3]) -> Point3 {
        self.frame.origin() + self.frame.x() * x + self.frame.y() * y + self.frame.z() * z
    }

    /// The turn of the axes of space into the frame `(ruling, round, normal)` of the contact at angle 0, in the axes of the tube.
    pub(super) fn contact_turn(&self) -> Quat {
        let normal = Vec3::new(self.cos, 0.0, -self.sin) * self.sigma;
        let ruling = Vec3::new(self.sin, 0.0, self.cos);
        Frame::of_axes(Point3::ORIGIN, [ruling, normal.cross(ruling), normal]).rotation()
    }
}
