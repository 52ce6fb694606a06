//! Two cylinders with skew axes, and the surface of the centers of balls that touch both
//! (`docs/math/canal-blends.md#balls-between-two-skew-cylinders`; source: `002`, section 4, for axes at right angles).
//!
//! With radii `r1`, `r2`, axes `2h` apart at the angle `w`, `d = r2 - r1`, `k+ = 2h + d`, `k- = 2h - d`, the places `(A, B)` of the plane of a torus give
//! ```text
//! X0 = cos 2A - cos 2B = 2 sin(B-A) sin(B+A),   E = sqrt(k+ k-)
//! center = (x, E sin 2A/X0, (2h cos 2A - d)/X0 - h),   x sin w = (E sin 2B + E sin 2A cos w)/X0,   R + r1 = (2h - d cos 2A)/X0
//! tan(f1/2) = sqrt(k+/k-) tan A,   tan(f2/2) = sqrt(k+/k-) tan B
//! ```
//! `f1`, `f2` are the angles of the contacts about the axes, from the third axis; towards y about the first, towards `(sin w, -cos w, 0)` about the second.

use super::RollingBall;
use crate::base::planar::Point2;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{BallError, ErrorItem, NumberError, Result};
use std::f64::consts::{FRAC_PI_2, PI};

/// Products of sines up to this are rounding of `cos 2A = cos 2B`.
const AT_INFINITY: f64 = 1e-15;

/// Two cylinders with skew axes, so far apart that the balls touching both form a torus: the first along x through `(0, 0, -h)`, the second through
/// `(0, 0, h)`, along y or at another [angle](Self::with_angle).
///
/// Balls are told by places `(A, B)` of the plane of a torus, radians: inside the diamond `|A| < B < pi - |A|` they touch both from outside;
/// in its middle `(0, pi/2)` is the smallest. A negative radius is that of a cylinder that the balls touch from inside.
///
/// ```
/// use cyclide::{Point2, surface::SkewCylinders};
/// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?;
/// let ball = pair.ball(Point2::new(0.1, 1.4))?;
/// let from_axis = ball.center.y.hypot(ball.center.z + 2.0);
/// assert!((from_axis - (1.0 + ball.radius)).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkewCylinders {
    radii: [f64; 2],
    half_gap: f64,
    /// What the angle of the axes is more than a right one, between minus and plus a right one.
    lean: f64,
}

impl SkewCylinders {
    /// With perpendicular axes, from the radii and half the distance of the axes.
    ///
    /// # Errors
    /// `not-finite`, `zero-radius`, `parameter-out-of-range` (beyond 1e-150 to 1e150), `not-timelike-pair` (unless
    /// `2h > |r1 - r2|`).
    pub fn new(radii: [f64; 2], half_gap: f64) -> Result<Self> {
        for (index, radius) in radii.into_iter().enumerate() {
            if !radius.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Radius, index }.into());
            }
            if radius == 0.0 {
                return Err(NumberError::ZeroRadius { radius, limit: 0.0 }.into());
            }
            range::check_distance(radius.abs())?;
        }
        if !half_gap.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Distance, index: 0 }.into());
        }
        let (measured, limit) = (2.0 * half_gap, (radii[0] - radii[1]).abs());
        if !(measured > limit) {
            return Err(BallError::NotTimelikePair { measured, limit }.into());
        }
        range::check_distance(half_gap)?;
        Ok(Self { radii, half_gap, lean: 0.0 })
    }

    /// Of radius zero, perpendicular.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (half the distance beyond 1e-150 to 1e150).
    pub(crate) fn axes(half_gap: f64) -> Result<Self> {
        if !half_gap.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Distance, index: 0 }.into());
        }
        range::check_distance(half_gap)?;
        Ok(Self::unchecked([0.0; 2], half_gap, 0.0))
    }

    /// The same with these radii.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(crate) fn with_radii(self, radii: [f64; 2]) -> Result<Self> {
        Ok(Self { lean: self.lean, ..Self::new(radii, self.half_gap)? })
    }

    /// Of any radii, zero as well, with an angle of the axes that is a right one and this much more.
    pub(super) fn unchecked(radii: [f64; 2], half_gap: f64, lean: f64) -> Self {
        Self { radii, half_gap, lean }
    }

    /// The same with the second axis along `(cos angle, sin angle, 0)`, for an angle in radians.
    ///
    /// ```
    /// use cyclide::{Point2, surface::SkewCylinders};
    /// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?.with_angle(1.0)?;
    /// let ball = pair.ball(Point2::new(0.1, 1.4))?;
    /// let [sin, cos] = [1_f64.sin(), 1_f64.cos()];
    /// let from_axis = (ball.center.x * sin - ball.center.y * cos).hypot(ball.center.z - 2.0);
    /// assert!((from_axis - (1.5 + ball.radius)).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` unless the angle is between 0 and pi.
    pub fn with_angle(self, angle: f64) -> Result<Self> {
        if !angle.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        let lean = angle - FRAC_PI_2;
        if !(angle > 0.0 && lean < FRAC_PI_2) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Angle, value: angle, min: 0.0, max: PI }.into()
            );
        }
        Ok(Self { lean, ..self })
    }

    /// The angle of the axes, radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        FRAC_PI_2 + self.lean
    }

    /// The direction of the second axis, and the one across it that its angles go towards.
    #[must_use]
    pub(crate) fn second_axis(&self) -> [Vec3; 2] {
        let (sin, cos) = self.lean.sin_cos();
        [Vec3::new(-sin, cos, 0.0), Vec3::new(cos, sin, 0.0)]
    }

    /// Cosine and sine of half of what the angle is more than a right one.
    pub(super) fn half_lean(&self) -> [f64; 2] {
        let (sin, cos) = (0.5 * self.lean).sin_cos();
        [cos, sin]
    }

    /// The radii.
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        self.radii
    }

    /// Half the distance of the axes.
    #[must_use]
    pub fn half_gap(&self) -> f64 {
        self.half_gap
    }

    /// `r2 - r1`.
    pub(super) fn difference(&self) -> f64 {
        self.radii[1] - self.radii[0]
    }

    /// `E`.
    pub(crate) fn width(&self) -> f64 {
        let [plus, minus] = self.sides();
        plus.sqrt() * minus.sqrt()
    }

    /// `2h + d` and `2h - d`.
    pub(crate) fn sides(&self) -> [f64; 2] {
        let (gap, d) = (2.0 * self.half_gap, self.difference());
        [gap + d, gap - d]
    }

    /// The ball of a place. Its radius is negative for a ball inside both cylinders, which touches from there.
    ///
    /// # Errors
    /// `not-finite`, `sphere-at-infinity` (on the border of the diamond), `wrong-side` (outside).
    pub fn ball(&self, place: Point2) -> Result<RollingBall> {
        if !place.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        let ((sin_a, cos_a), (sin_b, cos_b)) = (place.x.sin_cos(), place.y.sin_cos());
        let sines = (place.y - place.x).sin() * (place.y + place.x).sin();
        if sines.abs() <= AT_INFINITY {
            return Err(BallError::SphereAtInfinity { measured: sines, limit: AT_INFINITY }.into());
        }
        if sines < 0.0 {
            return Err(BallError::WrongSide { surface: 0, measured: sines }.into());
        }
        let [plus, minus] = self.sides();
        let (h, x0, root) = (self.half_gap, 2.0 * sines, plus.sqrt() * minus.sqrt());
        // 2h - d cos 2A = k- cos² A + k+ sin² A,  2h cos 2A - d = k- cos² A - k+ sin² A.
        let from_axis = (minus * cos_a * cos_a + plus * sin_a * sin_a) / x0;
        let height = (minus * cos_a * cos_a - plus * sin_a * sin_a) / x0 - h;
        // Across either axis.
        let [second, first] = [sin_b * cos_b, sin_a * cos_a].map(|product| 2.0 * root * product / x0);
        let [along, across] = self.second_axis();
        let center = Point3::new((second - first * across.y) / across.x, first, height);
        let direction = |sin: f64, cos: f64| {
            let (p, q) = (plus.sqrt() * sin, minus.sqrt() * cos);
            let n = p * p + q * q;
            [2.0 * p * q / n, (q - p) * (q + p) / n]
        };
        let ([s1, c1], [s2, c2]) = (direction(sin_a, cos_a), direction(sin_b, cos_b));
        let normals = [Vec3::new(0.0, s1, c1), across * s2 + Vec3::Z * c2];
        let axes = [
            Point3::new(center.x, 0.0, -h),
            Point3::new(0.0, 0.0, h) + along * (center.x * along.x + center.y * along.y),
        ];
        let contacts = [0, 1].map(|i| axes[i] + normals[i] * self.radii[i]);
        Ok(RollingBall { center, radius: from_axis - self.radii[0], contacts, normals })
    }

    /// The place of the ball that touches the cylinders in these directions from their axes, in the diamond: the inverse of
    /// [`ball`](Self::ball) by its normals.
    #[must_use]
    pub fn place_of_normals(&self, normals: [Vec3; 2]) -> Point2 {
        let [plus, minus] = self.sides().map(f64::sqrt);
        let half = |sin: f64, cos: f64| {
            let angle = 0.5 * sin.atan2(cos);
            (minus * angle.sin()).atan2(plus * angle.cos())
        };
        let (a, b) = (half(normals[0].y, normals[0].z), half(normals[1].dot(self.second_axis()[1]), normals[1].z));
        Point2::new(a, if b < 0.0 { b + PI } else { b })
    }

    /// The place of a ball of a given radius, at an angle `theta` of the closed curve of all such balls
    /// (`docs/math/canal-blends.md#constant-radius`): `sin A = sqrt(K/2q) cos theta`, `cos B = -sqrt(K/2p) sin theta` with `p = r1 + R`, `q = r2 + R`,
    /// `K = p + q - 2h`. This curve is not rational.
    ///
    /// # Errors
    /// `not-finite`, `radius-too-small` (below half the gap between the cylinders), `wrong-side` (not above the radius of a cylinder that the
    /// balls touch from inside).
    pub fn place_of_radius(&self, radius: f64, theta: f64) -> Result<Point2> {
        for (what, value) in [(ErrorItem::Radius, radius), (ErrorItem::Angle, theta)] {
            if !value.is_finite() {
                return Err(NumberError::NotFinite { what, index: 0 }.into());
            }
        }
        let limit = self.smallest_radius();
        let excess = 2.0 * (radius - limit);
        if !(excess >= 0.0) {
            return Err(BallError::RadiusTooSmall { radius, limit, works: None }.into());
        }
        let [p, q] = self.radii.map(|r| r + radius);
        if let Some(surface) = [p, q].into_iter().position(|distance| !(distance > 0.0)) {
            return Err(BallError::WrongSide { surface, measured: p.min(q) }.into());
        }
        let (sin, cos) = theta.sin_cos();
        let part = |distance: f64, of: f64| ((0.5 * excess / distance).sqrt() * of).clamp(-1.0, 1.0).asin();
        Ok(Point2::new(part(q, cos), FRAC_PI_2 + part(p, sin)))
    }

    /// Half the gap between the cylinders, the radius of the smallest ball outside both; negative where they overlap.
    #[must_use]
    pub fn smallest_radius(&self) -> f64 {
        self.half_gap - 0.5 * (self.radii[0] + self.radii[1])
    }
}
