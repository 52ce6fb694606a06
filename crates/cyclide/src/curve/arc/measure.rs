//! Measuring arcs: length, constant speed, closest point, bounding box.

use super::Arc;
use crate::base::bounds::Aabb;
use crate::base::roots::projective_quadratic;
use crate::base::vector::{Point3, Vec3};

/// The point of a curve nearest to a given point.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle};
/// let found = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?.closest_point(Point3::new(5.0, 0.0, 0.0));
/// assert_eq!((found.point, found.distance), (Point3::new(2.0, 0.0, 0.0), 3.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ClosestPoint {
    /// Parameter in `[0, 1]`.
    pub t: f64,
    /// The nearest point.
    pub point: Point3,
    /// Its distance.
    pub distance: f64,
}

impl Arc {
    /// `alpha/sin(alpha)` with `sin(alpha) = |p|/|w|`, by series near lines.
    fn alpha_over_sine(&self) -> f64 {
        let alpha = self.alpha();
        if alpha < 1e-4 {
            // Next term 7 alpha^4/360: below 2e-18.
            1.0 + alpha * alpha / 6.0
        } else {
            alpha * self.n / self.pn
        }
    }

    /// Arc length `|c| alpha/sin(alpha)`.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.c.length() * self.alpha_over_sine()
    }

    /// Arc length from the start to parameter `t`: `(|c||w|/|p|) atan2(t|p|, X)`, its limit on lines.
    #[must_use]
    pub fn length_to(&self, t: f64) -> f64 {
        let (x, _) = self.denominator(t);
        let (y, l) = (t * self.pn, self.c.length());
        // atan(z)/z = 1 - z²/3 near 0 (next term below 2e-18), where the quotient |w|/|p| may overflow.
        let angle_over_p =
            if x > 0.0 && y < 1e-4 * x { t / x * (1.0 - (y / x) * (y / x) / 3.0) } else { y.atan2(x) / self.pn };
        l * self.n * angle_over_p
    }

    /// Angle swept up to parameter `t`, radians.
    #[must_use]
    pub fn angle_to(&self, t: f64) -> f64 {
        let (x, _) = self.denominator(t);
        2.0 * (t * self.pn).atan2(x)
    }

    /// `sin(l alpha)/sin(alpha)` and `sin((1-l) alpha)/sin(alpha)`, with the limits `l`, `1-l`.
    fn sine_ratios(&self, l: f64) -> (f64, f64) {
        let (alpha, sine) = (self.alpha(), self.pn / self.n);
        if alpha < 1e-4 {
            // sin(l a)/sin(a) = l (1 + a²(1-l²)/6), next term of order a^4
            let q = |l: f64| l * (1.0 + alpha * alpha * (1.0 - l * l) / 6.0);
            (q(l), q(1.0 - l))
        } else {
            ((l * alpha).sin() / sine, ((1.0 - l) * alpha).sin() / sine)
        }
    }

    /// The parameter `t` of the point at the fraction `l` in `[0, 1]` of the length.
    #[must_use]
    pub fn parameter_at_length(&self, l: f64) -> f64 {
        let (a, b) = self.sine_ratios(l);
        // t = sin(l a)/(sin(l a) + |w| sin((1-l) a)); exact at both ends
        a / (a + self.n * b)
    }

    /// The point at the fraction `l` in `[0, 1]` of the length (constant speed).
    #[must_use]
    pub fn point_at_length(&self, l: f64) -> Point3 {
        if l > 0.5 {
            return self.reversed().point_at_length(1.0 - l);
        }
        if self.is_straight() {
            return self.p0 + self.c * l;
        }
        let (a, _) = self.sine_ratios(l);
        let (s, c) = ((1.0 - l) * self.alpha()).sin_cos();
        // c × u with u = p/|p|
        self.p0 + (self.c * c + self.cp * (s / self.pn)) * a
    }

    /// Parameters of the stationary points of one quadratic `A sigma² + 2 B sigma t + C t²` with
    /// `A = r g + k`, `B = n² g`, `C = n² (r g - k)` and the discriminant in its form without cancellation.
    fn stationary(&self, g: f64, k: f64) -> [Option<f64>; 2] {
        let n2 = self.n * self.n;
        let root = self.n * (self.pn * g).hypot(k);
        projective_quadratic(self.r * g + k, n2 * g, n2 * (self.r * g - k), root)
    }

    /// The point of the arc nearest to `p`; on the axis, where all points are equally near, the start.
    #[must_use]
    pub fn closest_point(&self, p: Point3) -> ClosestPoint {
        // Scaled by the chord so that products neither overflow nor vanish.
        let at = |t: f64| {
            let point = self.point(t);
            ClosestPoint { t, point, distance: point.distance(p) }
        };
        let l = self.c.max_abs();
        if l == 0.0 {
            return at(0.0);
        }
        let m = ((p - self.p0) * 0.5 + (p - self.p1) * 0.5) / l;
        let (c, cp) = (self.c / l, self.cp / l);
        let (g, k) = (m.dot(c), m.dot(cp) + 0.5 * self.r * c.dot(c));
        let mut best = at(0.0);
        for candidate in self.stationary(g, k).into_iter().flatten().chain([1.0]).map(at) {
            if candidate.distance < best.distance {
                best = candidate;
            }
        }
        best
    }

    /// The smallest box around the arc.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::of_point(self.p0).including(self.p1);
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            for t in self.stationary(self.c.dot(axis), self.cp.dot(axis)).into_iter().flatten() {
                bounds = bounds.including(self.point(t));
            }
        }
        bounds
    }
}
