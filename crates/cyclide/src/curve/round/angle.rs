//! The angle of two circles or lines (source: `004`, (35), which is that of circles with a common point only).

use super::{CircleOrLine, LIMIT};
use crate::base::elimination::rank;
use crate::base::vector::{Point3, Vec3};

/// A cosine above 1 by no more is rounding.
const ROUNDING: f64 = 1e-12;

/// What Möbius maps keep of two circles or lines.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, CircleOrLine}};
/// let circle = |x: f64, r: f64| Circle::from_radius(Point3::new(x, 0.0, 0.0), Vec3::Z, r).map(CircleOrLine::Circle);
/// // Two circles in a plane that do not meet: there is no angle.
/// let apart = circle(0.0, 1.0)?.angle_with(&circle(0.0, 2.0)?);
/// assert!(apart.cosine == 1.25 && apart.angle.is_none() && apart.cospherical);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CircleAngle {
    /// The cosine of the angle of the oriented tangents at every common point. Without one it is a product of two invariants, and may be above 1.
    pub cosine: f64,
    /// The angle, from 0 to π; `None` where the cosine is none of one.
    pub angle: Option<f64>,
    /// True if one sphere or plane holds both.
    pub cospherical: bool,
    /// True if both are one, in either direction.
    pub same: bool,
}

impl CircleOrLine {
    /// The angle with another circle or line, in closed form (`docs/math/conformal.md#meetings`).
    #[must_use]
    pub fn angle_with(&self, other: &Self) -> CircleAngle {
        let cosine = match (self, other) {
            (Self::Circle(a), Self::Circle(b)) => {
                let (way, r, s) = (b.center() - a.center(), a.radius(), b.radius());
                let (m, n) = (a.normal(), b.normal());
                let mean = 0.5 * (r * r + s * s - way.length_squared());
                (mean * m.dot(n) + m.dot(way) * n.dot(way)) / (r * s)
            }
            (Self::Circle(circle), Self::Line(line)) | (Self::Line(line), Self::Circle(circle)) => {
                circle.normal().dot(line.direction().cross(circle.center() - line.point())) / circle.radius()
            }
            (Self::Line(a), Self::Line(b)) => a.direction().dot(b.direction()),
        };
        let rank = self.rank_with(other);
        let angle = (cosine.abs() <= 1.0 + ROUNDING).then(|| cosine.clamp(-1.0, 1.0).acos());
        CircleAngle { cosine, angle, cospherical: rank <= 3, same: rank == 2 }
    }

    /// How many independent spheres and planes hold one of both: two each, less what they share.
    fn rank_with(&self, other: &Self) -> usize {
        let size = |curve: &Self| match curve {
            Self::Circle(circle) => (circle.center(), circle.radius()),
            Self::Line(line) => (line.point(), 0.0),
        };
        let ((p, r), (q, s)) = (size(self), size(other));
        let unit = r.max(s).max(0.5 * p.distance(q));
        let unit = if unit > 0.0 { unit } else { 1.0 };
        let [[a, b], [c, d]] = [self, other].map(|curve| curve.spheres(p, unit));
        rank([a, b, c, d], LIMIT)
    }

    /// Two spheres or planes that hold it as functions `a |x|² + b·x + c` of the place from an origin, in a unit; of length 1.
    fn spheres(&self, origin: Point3, unit: f64) -> [[f64; 5]; 2] {
        let plane =
            |normal: Vec3, point: Point3| [0.0, normal.x, normal.y, normal.z, -normal.dot((point - origin) / unit)];
        let both = match self {
            Self::Circle(circle) => {
                let (c, r) = ((circle.center() - origin) / unit, circle.radius() / unit);
                let rest = (c.length() - r) * (c.length() + r);
                [plane(circle.normal(), circle.center()), [1.0, -2.0 * c.x, -2.0 * c.y, -2.0 * c.z, rest]]
            }
            Self::Line(line) => {
                let g = line.direction();
                let across = g.cross(if g.x.abs() < 0.6 { Vec3::X } else { Vec3::Y }).unit().unwrap_or(Vec3::Z);
                [plane(across, line.point()), plane(g.cross(across), line.point())]
            }
        };
        both.map(|f| {
            let length = f.iter().map(|x| x * x).sum::<f64>().sqrt();
            f.map(|x| x / length)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformal::{Line, Mobius};
    use crate::curve::{Circle, ParamCurve as _};

    fn through(points: [[f64; 3]; 3]) -> Circle {
        Circle::through_points(points.map(Point3::from)).unwrap()
    }

    /// Of circles with a common point it is the angle of their tangents, and maps keep it; of others maps keep the cosine.
    #[test]
    fn moebius_maps_keep_it() {
        let a = through([[1.0, 0.0, 0.0], [0.0, 1.0, 0.3], [-1.0, 0.2, 0.5]]);
        let meeting = through([[1.0, 0.0, 0.0], [0.4, 2.0, 1.0], [3.0, 0.5, -1.0]]);
        let apart = through([[5.0, 0.0, 0.0], [5.5, 1.0, 0.0], [5.0, 2.0, 0.7]]);
        let p = Point3::new(1.0, 0.0, 0.0);
        let want = a.tangent_at(p).unwrap().angle(meeting.tangent_at(p).unwrap());
        let angle = |a: Circle, b: Circle| CircleOrLine::Circle(a).angle_with(&CircleOrLine::Circle(b));
        assert!((angle(a, meeting).angle.unwrap() - want).abs() < 1e-14);
        let map = Mobius::inversion(Point3::new(0.3, -2.0, 1.5), 2.0).unwrap();
        let image = |c: Circle| {
            let places = [0.0, 0.3, 0.6].map(|t| map.map_point(c.point(t)).unwrap());
            Circle::through_points(places).unwrap()
        };
        for b in [meeting, apart] {
            let (before, after) = (angle(a, b), angle(image(a), image(b)));
            assert!((before.cosine - after.cosine).abs() < 1e-13, "{before:?} {after:?}");
            assert_eq!((before.cospherical, before.same), (after.cospherical, after.same));
        }
    }

    #[test]
    fn one_sphere_and_one_circle() {
        let at =
            |c: [f64; 3], n: Vec3, r: f64| CircleOrLine::Circle(Circle::from_radius(Point3::from(c), n, r).unwrap());
        // Two parallels and a meridian of one sphere, at three sizes.
        for unit in [1e-7, 1.0, 1e7] {
            let parallel = at([0.0, 0.0, 0.6 * unit], Vec3::Z, 0.8 * unit);
            let meridian = at([0.0; 3], Vec3::X, unit);
            let found = parallel.angle_with(&meridian);
            assert!(found.cospherical && !found.same && found.cosine.abs() < 1e-15);
            assert!(!parallel.angle_with(&at([0.0, 0.0, 0.1 * unit], Vec3::Y, unit)).cospherical);
            let turned = parallel.angle_with(&at([0.0, 0.0, 0.6 * unit], -Vec3::Z, 0.8 * unit));
            assert!(turned.same && turned.cospherical && turned.angle == Some(std::f64::consts::PI));
        }
        let line = |d: Vec3| CircleOrLine::Line(Line::new(Point3::new(1.0, 2.0, 3.0), d).unwrap());
        assert!(line(Vec3::X).angle_with(&line(Vec3::Y)).cospherical);
        assert!(line(Vec3::X).angle_with(&line(-Vec3::X)).same);
    }
}
