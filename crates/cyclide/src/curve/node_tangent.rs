//! Chords and the tangent of the circle through three neighboring points, the only use made of the third point.

use crate::base::vector::{Point3, Vec3};

/// Two unit chords whose sum is at most this long turn back on themselves: no circle, a cusp
/// (`docs/math/circle-blends.md#node-tangent`).
const CUSP_LIMIT: f64 = 1e-9;

/// Direction and length of the way from one point to the next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chord {
    /// Unit direction; zero if the points are equal.
    pub(crate) unit: Vec3,
    /// Length.
    pub(crate) length: f64,
}

impl Chord {
    /// Unit chords whose sum is at most this long turn back.
    pub(crate) const CUSP_LIMIT: f64 = CUSP_LIMIT;

    /// The chord from `a` to `b`, scaled before squaring so that tiny and huge data neither under- nor overflow.
    pub(crate) fn new(a: Point3, b: Point3) -> Self {
        let d = b - a;
        let size = d.max_abs();
        if !(size > 0.0) {
            return Self { unit: Vec3::ZERO, length: size };
        }
        let v = d / size;
        let r = v.length_squared().sqrt();
        Self { unit: v / r, length: size * r }
    }

    /// Turn from this chord to the next, radians in `[0, pi]`.
    pub(crate) fn turn(&self, next: &Self) -> f64 {
        self.unit.angle(next.unit)
    }

    /// The unit tangent at the point between this chord and the next of the circle through their three points
    /// (a line needs no special case); `None` at a cusp, where there is no such circle.
    ///
    /// ```text
    /// tau = unit(inv(e) + inv(d)) = unit(|e| u_d + |d| u_e)
    /// ```
    /// (`docs/math/circle-blends.md#node-tangent`), divided by the longer length: no overflow, no cancellation away
    /// from cusps.
    pub(crate) fn tangent_to(&self, next: &Self) -> Option<Vec3> {
        if (self.unit + next.unit).length_squared() <= CUSP_LIMIT * CUSP_LIMIT {
            return None;
        }
        let longest = self.length.max(next.length);
        let v = next.unit * (self.length / longest) + self.unit * (next.length / longest);
        v.unit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangent_is_that_of_the_circle_at_every_scale() {
        // Points at angles 0.3, 1.1, 1.2 of a circle: the tangent at the middle one is perpendicular to its spoke.
        for s in [1e-160, 1e-6, 1.0, 1e6, 1e150] {
            let at = |a: f64| Point3::new(s * a.cos(), s * a.sin(), 0.0);
            let (p, q, r) = (at(0.3), at(1.1), at(1.2));
            let tau = Chord::new(p, q).tangent_to(&Chord::new(q, r)).unwrap();
            // Rounding of the short chord (0.1 of the radius): a few eps/0.1.
            assert!((tau - Vec3::new(-1.1_f64.sin(), 1.1_f64.cos(), 0.0)).length() < 1e-14, "{s}");
        }
    }

    #[test]
    fn turning_back_is_a_cusp_and_nearly_turning_back_is_not() {
        let (p, q) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let back = |h: f64| Chord::new(p, q).tangent_to(&Chord::new(q, Point3::new(0.5, h, 0.0)));
        assert!(back(0.0).is_none() && back(1e-10).is_none());
        assert!(back(1e-8).is_some());
        assert!(Chord::new(p, q).tangent_to(&Chord::new(q, p)).is_none(), "x0 = x2 is a cusp too");
    }
}
