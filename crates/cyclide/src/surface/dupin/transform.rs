//! Möbius maps of whole cyclides: a bounded image is a whole cyclide.
//!
//! A cyclide touches each sphere of two families along a circle: about the points of an ellipse and of a hyperbola,
//! ```text
//! centre (a cos θ, b sin θ, 0), radius mu - c cos θ      centre (c, 0, b sin ψ)/cos ψ, radius mu - a/cos ψ
//! ```
//! (`docs/math/cyclides-and-nets.md#spheres-of-a-cyclide`: `p - N/|k|`). In the linear coordinates `(w, v, k, h)` of
//! oriented spheres, with the product `|v|² - w k - h²`, both are `E0 + E1 cos + E2 sin` with `E0, E1, E2`
//! perpendicular and of squares `-b², b², b²`. Maps are linear there and keep this, up to a factor, so what is left of
//! a map is to turn the image's `E0, E1, E2` to the position in which only `E0` has a `w`: center, `mu` and `c`, `a`,
//! `b` with their axes are read from it. It exists for the family in which no image is a plane, which is always one of
//! the two: inside and outside may change places.

use super::DupinCyclide;
use crate::base::frame::Frame;
use crate::base::vector::Vec3;
use crate::conformal::lie_sphere::LieSphere;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, Result};

/// Rounding of the image's size against that of the largest sphere.
const SIZE_ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Conformal for DupinCyclide {
    /// The image, a whole cyclide again: ring, horn and spindle may change into each other as far as they have the
    /// same nodes (a ring stays a ring). In its frame the long axis is along x, as always; parameters and angles
    /// on the surface are not kept: see [`CyclidicNet`](crate::surface::CyclidicNet) for that.
    ///
    /// # Errors
    /// `point-at-infinity` if the map takes a point of the surface to infinity; as [`new`](DupinCyclide::new) if
    /// one is so near to it that the parameters of the image are out of range.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let [source, target] = map.origins();
        let place = self.frame.origin() - source;
        let families = self.families().map(|family| family.map(|e| e.translated(place).mapped(map)));
        let [first, second] = families.each_ref().map(square_of_w);
        let [e0, e1, e2] = if first >= second { families[0] } else { families[1] };
        let square = first.max(second);
        if !(square > SIZE_ROUNDING * e0.w * e0.w) {
            return Err(Error::at_infinity(ErrorItem::Surface, 0));
        }
        // The Lorentz rotation to w = (omega, 0, 0), over omega: spheres with w = 1.
        let (omega, rho) = (square.sqrt(), e1.w.hypot(e2.w));
        let (x, y) = if rho > 0.0 { (e1.w / rho, e2.w / rho) } else { (1.0, 0.0) };
        let combined = |p: f64, q: f64, r: f64| {
            let sum = |part: fn(&LieSphere) -> f64| (p * part(&e0) + q * part(&e1) + r * part(&e2)) / square;
            (e0.v * (p / square) + e1.v * (q / square) + e2.v * (r / square), sum(|e| e.h))
        };
        let (center, mu) = combined(e0.w, -e1.w, -e2.w);
        let (along, h1) = combined(-rho, e0.w * x, e0.w * y);
        let (across, h2) = combined(0.0, -omega * y, omega * x);
        let (b, c) = (self.b() * map.determinant().abs() / omega, h1.hypot(h2));
        // The direction in which the spheres become smaller, oriented so that mu is not negative.
        let turned = -c.copysign(mu);
        let (cos, sin) = if c > 0.0 { (h1 / turned, h2 / turned) } else { (1.0, 0.0) };
        let long: Vec3 = along * cos + across * sin;
        let short: Vec3 = across * cos - along * sin;
        let frame = Frame::from_normal(target + center, long.cross(short), long)?;
        Ok(Self::new(b.hypot(c), c, mu.abs())?.placed(frame))
    }
}

impl DupinCyclide {
    /// The smaller half axis of the ellipse.
    fn b(&self) -> f64 {
        ((self.a - self.c) * (self.a + self.c)).sqrt()
    }

    /// `E0, E1, E2` of both families of spheres, relative to the center.
    fn families(&self) -> [[LieSphere; 3]; 2] {
        let Self { a, c, mu, frame } = *self;
        let b = self.b();
        let sphere = |w: f64, v: Vec3, k: f64, h: f64| LieSphere { w, v, k, h };
        let elliptic = [
            sphere(1.0, Vec3::ZERO, (b - mu) * (b + mu), mu),
            sphere(0.0, frame.x() * a, 2.0 * mu * c, -c),
            sphere(0.0, frame.y() * b, 0.0, 0.0),
        ];
        let hyperbolic = [
            sphere(0.0, frame.x() * c, 2.0 * mu * a, -a),
            sphere(1.0, Vec3::ZERO, -b * b - mu * mu, mu),
            sphere(0.0, frame.z() * b, 0.0, 0.0),
        ];
        [elliptic, hyperbolic]
    }
}

/// `w0² - w1² - w2²`: positive if no sphere `E0 + E1 cos + E2 sin` is a plane.
fn square_of_w([e0, e1, e2]: &[LieSphere; 3]) -> f64 {
    let rho = e1.w.hypot(e2.w);
    (e0.w - rho) * (e0.w + rho)
}
