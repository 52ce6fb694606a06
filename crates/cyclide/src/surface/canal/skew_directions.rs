//! Balls between two skew cylinders told by their radius and the direction that they are in, seen along the common normal of the axes
//! (`docs/math/pipe-crossings.md#balls-by-direction`).
//!
//! With the angle `w` of the axes, `p = r1 + R`, `q = r2 + R`, `K/2 = R - R0`, a direction `phi` and
//! ```text
//! sin A = a cos θ,  cos B = -b sin θ,   a² = K/2q,  b² = K/2p
//! sin 2A : sin 2B = sin phi : sin(w - phi) = Y : X
//! u = sin² θ:   (Y² b⁴ - X² a⁴) u² + (X² a² (2a² - 1) - Y² b²) u + X² a² (1 - a²) = 0
//! ```
//! there is one such u between 0 and 1.

use super::SkewCylinders;
use crate::base::planar::{Point2, Vec2};
use crate::error::{BallError, Result};
use std::f64::consts::{FRAC_PI_2, PI};

/// A ball in a direction, with its rates by the angle of that.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DirectedBall {
    /// Its place in the plane of the torus, and the rate of that.
    pub(crate) place: Point2,
    pub(crate) rate: Vec2,
    /// For both cylinders the contact: its place along the axis, and the angle round it, each counted from where the other cylinder is nearest.
    pub(crate) contacts: [[f64; 2]; 2],
    /// The rates of these.
    pub(crate) contact_rates: [[f64; 2]; 2],
}

impl SkewCylinders {
    /// The ball of a radius in a direction from the common normal of the axes, counted from the first axis, where the radius has this slope by the angle.
    ///
    /// # Errors
    /// `radius-too-small`, `wrong-side` as [`place_of_radius`](Self::place_of_radius).
    pub(crate) fn towards(&self, [radius, slope]: [f64; 2], angle: f64) -> Result<DirectedBall> {
        let limit = self.smallest_radius();
        let excess = radius - limit;
        if !(excess > 0.0) {
            return Err(BallError::RadiusTooSmall { radius, limit, works: None }.into());
        }
        let [p, q] = self.radii().map(|r| r + radius);
        if let Some(surface) = [p, q].into_iter().position(|distance| !(distance > 0.0)) {
            return Err(BallError::WrongSide { surface, measured: p.min(q) }.into());
        }
        let [way, across] = self.second_axis();
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (across.x * cos + across.y * sin, sin);
        let (aa, bb) = (excess / q, excess / p);
        // The squares of sine and cosine of θ, each as the root of its own quadratic, which keeps small ones.
        let s = square_sine(x * x, y * y, aa, bb).sqrt().copysign(-x);
        let c = square_sine(y * y, x * x, bb, aa).sqrt().copysign(y);
        let place =
            Point2::new((aa.sqrt() * c).clamp(-1.0, 1.0).asin(), FRAC_PI_2 + (bb.sqrt() * s).clamp(-1.0, 1.0).asin());
        let ((sin_a, cos_a), (sin_b, cos_b)) = (place.x.sin_cos(), place.y.sin_cos());
        let [double_a, double_b] = [(sin_a, cos_a), (sin_b, cos_b)].map(|(s, c)| [2.0 * s * c, (c - s) * (c + s)]);
        // q sin² A + p cos² B = K/2, and the direction, derived.
        let (x_rate, y_rate) = (across.y * cos - across.x * sin, cos);
        let first = [q * double_a[0], -p * double_b[0], slope * (sin_b - sin_a) * (sin_b + sin_a)];
        let second = [double_a[1] * x, -double_b[1] * y, 0.5 * (double_b[0] * y_rate - double_a[0] * x_rate)];
        let det = first[0] * second[1] - first[1] * second[0];
        let rate = Vec2::new(
            (first[2] * second[1] - first[1] * second[2]) / det,
            (first[0] * second[2] - first[2] * second[0]) / det,
        );
        // Across the first axis and across the second, and their rates.
        let [plus, minus] = self.sides();
        let root = plus.sqrt() * minus.sqrt();
        let weight = 2.0 * (place.y - place.x).sin() * (place.y + place.x).sin();
        let weight_rate = 2.0 * (double_b[0] * rate.y - double_a[0] * rate.x);
        let rate_of = |double: [f64; 2], rate: f64| {
            root * (2.0 * double[1] * rate * weight - double[0] * weight_rate) / (weight * weight)
        };
        let along = |eta: f64, xi: f64| {
            let x = (xi - eta * across.y) / across.x;
            [x, x * way.x + eta * way.y]
        };
        let [first, second] = along(root * double_a[0] / weight, root * double_b[0] / weight);
        let [first_rate, second_rate] = along(rate_of(double_a, rate.x), rate_of(double_b, rate.y));
        let angle = |s: f64, c: f64| 2.0 * (plus.sqrt() * s).atan2(minus.sqrt() * c);
        let turn = |s: f64, c: f64, rate: f64| 2.0 * root * rate / (minus * c * c + plus * s * s);
        Ok(DirectedBall {
            place,
            rate,
            contacts: [[first, angle(sin_a, cos_a)], [second, PI - angle(sin_b, cos_b)]],
            contact_rates: [[first_rate, turn(sin_a, cos_a, rate.x)], [second_rate, -turn(sin_b, cos_b, rate.y)]],
        })
    }
}

/// The root between 0 and 1 of the quadratic.
fn square_sine(xx: f64, yy: f64, aa: f64, bb: f64) -> f64 {
    let (square, linear, constant) =
        (yy * bb * bb - xx * aa * aa, xx * aa * (2.0 * aa - 1.0) - yy * bb, xx * aa * (1.0 - aa));
    let discriminant = (linear * linear - 4.0 * square * constant).max(0.0).sqrt();
    let root =
        if linear < 0.0 { 2.0 * constant / (discriminant - linear) } else { -(linear + discriminant) / (2.0 * square) };
    root.clamp(0.0, 1.0)
}
