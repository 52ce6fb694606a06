//! How a blend moves when its data do: first derivatives, in closed form.
//!
//! The tangent runs along a great circle from `t1` to `t2`, so what it does when those move is a Jacobi field of the unit sphere:
//! the part along the great circle follows the angle, and the part across it is
//! `(sin(theta - phi) n1 + sin(phi) n2)/sin(theta)` at the angle `phi`, with `n1`, `n2` the parts of the ends across it. (Own derivation.)

use super::segment::BlendSegment;
use crate::base::vector::Vec3;

/// Derivatives of the data of a blend by a parameter on which they depend; the start point stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BlendVariation {
    /// Of the end point.
    pub(crate) end: Vec3,
    /// Of the start tangent of the first arc, which stays a unit vector.
    pub(crate) start_tangent: Vec3,
    /// Of the start tangent **at the start point** of the second arc.
    pub(crate) end_tangent: Vec3,
}

impl BlendSegment {
    /// Derivatives of the point at `l` of a segment that was not cut: by `l`, and by the parameter of the variation.
    ///
    /// Where the circles run in opposite directions the curve jumps with its data; there the second one is that within the
    /// plane of the half turn.
    pub(crate) fn first_derivatives(&self, l: f64, by: &BlendVariation) -> [Vec3; 2] {
        let m = 1.0 - l;
        let [c, s, q] = self.law.at(l);
        let (t, along) = (self.t1 * (c / q) + self.b * (s / q), self.b * (c / q) - self.t1 * (s / q));
        let n = self.u * l + t * m;
        let nn = n.length_squared();
        let g = n / nn;
        let moved = |dn: Vec3| (dn - g * (2.0 * n.dot(dn))) / nn;

        let by_l = moved(self.u - t + along * (m * self.law.rate(l)));
        let growth = self.u.dot(by.end);
        let chord = (by.end - self.u * growth) / self.length;
        let by_data = moved(chord * l + self.tangent_variation(l, by) * m);
        [(g + by_l * l) * self.length, (g * growth + by_data * self.length) * l]
    }

    /// The Jacobi field at `l`.
    fn tangent_variation(&self, l: f64, by: &BlendVariation) -> Vec3 {
        let (share, [cos, sin]) = (self.law.share(l), self.law.full());
        let b = self.across();
        let on_circle = |[c, s]: [f64; 2]| b * c - self.t1 * s;
        let (first, second, normal) = (by.start_tangent, by.end_tangent, self.t1.cross(b));
        let phi = self.law.angle(l);
        let [near, far] = if sin != 0.0 {
            [(self.law.theta - phi).sin() / sin, phi.sin() / sin]
        } else if self.law.theta < 1.0 {
            [1.0 - share, share]
        } else {
            [0.0; 2]
        };
        let parallel = first.dot(b) * (1.0 - share) + second.dot(on_circle([cos, sin])) * share;
        let (s, c) = phi.sin_cos();
        on_circle([c, s]) * parallel + normal * (first.dot(normal) * near + second.dot(normal) * far)
    }

    /// A unit vector across `t1` in the plane of the great circle. Where that is known to rounding only, the field does not depend
    /// on it, but the vector must be across.
    fn across(&self) -> Vec3 {
        let across = self.b - self.t1 * self.b.dot(self.t1);
        across.unit().filter(|_| across.length() > 0.5).unwrap_or_else(|| self.t1.any_perpendicular())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::Point3;
    use crate::curve::blend::{BlendLaw, BlendTangents};
    use crate::curve::node_tangent::Chord;

    /// Data that move with `h`: the end point, and both tangents turning about their own axes.
    fn at(h: f64, law: BlendLaw, second: Vec3) -> BlendSegment {
        let turned = |v: Vec3, axis: Vec3| v.unit().unwrap() * h.cos() + axis.cross(v.unit().unwrap()) * h.sin();
        let x2 = Point3::new(1.0 + h, 2.0 * h, 0.3 - h);
        let (t1, t2) = (turned(Vec3::new(0.2, 1.0, 0.0), Vec3::Z), turned(second, second.any_perpendicular()));
        let tangents = BlendTangents { start: t1, end: t2, magnification: 0.0 };
        let x1 = Point3::new(-0.4, 0.2, 0.1);
        BlendSegment::from_tangents([x1, x2], &Chord::new(x1, x2), &tangents, law, 0).unwrap()
    }

    /// One arc, whose plane is rounding: all turns about the start point in the plane, or out of it.
    #[test]
    fn derivatives_of_an_arc_that_turns_are_those_of_the_turn() {
        let (x1, x2) = (Point3::new(0.3, -0.2, 0.1), Point3::new(1.4, 0.5, -0.3));
        let chord = Chord::new(x1, x2);
        let t1 = Vec3::new(1.0, 0.2, 0.5).unit().unwrap();
        // Exactly one circle, and one but for rounding, also of the length.
        let seconds = [t1, t1 * (1.0 + 3e-16), t1 + Vec3::new(1e-16, -2e-16, 1e-16), t1 + Vec3::new(0.0, 1e-12, 0.0)];
        for end in seconds {
            let tangents = BlendTangents { start: t1, end, magnification: 0.0 };
            let law = BlendLaw::Trigonometric { order: 2 };
            let segment = BlendSegment::from_tangents([x1, x2], &chord, &tangents, law, 0).unwrap();
            for axis in [Vec3::X, Vec3::new(0.3, -0.4, 0.9), t1] {
                let turn = axis.cross(t1);
                let by = BlendVariation { end: axis.cross(x2 - x1), start_tangent: turn, end_tangent: turn };
                for l in [0.1, 0.5, 0.8, 1.0] {
                    let [_, by_data] = segment.first_derivatives(l, &by);
                    let want = axis.cross(segment.point(l) - x1);
                    // 1e-12 of a tangent, times the derivatives.
                    assert!((by_data - want).length() < 4e-12, "{end:?} {axis:?} {l}: {by_data:?} {want:?}");
                }
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_finite_differences() {
        let laws = [
            BlendLaw::Trigonometric { order: 2 },
            BlendLaw::Trigonometric { order: 3 },
            BlendLaw::Rational { order: 2 },
            BlendLaw::Fair { blend: 0.4 },
        ];
        // Short way, nearly one circle, and the long way.
        let seconds = [Vec3::new(0.5, 0.3, 0.9), Vec3::new(0.2001, 1.0, 0.0), Vec3::new(-0.8, -0.1, -0.5)];
        let mut long = 0;
        for law in laws {
            for second in seconds {
                let h = 1e-5;
                let [before, middle, after] = [-h, 0.0, h].map(|h| at(h, law, second));
                long += usize::from(middle.long_way());
                let unit = second.unit().unwrap();
                let by = BlendVariation {
                    end: Vec3::new(1.0, 2.0, -1.0),
                    start_tangent: Vec3::Z.cross(middle.t1),
                    end_tangent: second.any_perpendicular().cross(unit),
                };
                for l in [0.05, 0.3, 0.5, 0.77, 0.99] {
                    let [by_l, by_data] = middle.first_derivatives(l, &by);
                    let want = (after.point(l) - before.point(l)) / (2.0 * h);
                    // Truncation h² times third derivatives of some hundreds, rounding 1e-16/h.
                    assert!((by_data - want).length() < 1e-7, "{law:?} {second:?} {l}: {by_data:?} {want:?}");
                    assert!((by_l - middle.jet(l).d1).length() < 1e-12 * by_l.length().max(1.0), "{law:?} {l}");
                }
            }
        }
        assert!(long > 0, "one of them goes the long way");
    }
}
