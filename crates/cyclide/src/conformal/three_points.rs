//! The Möbius map that takes three points to three points (`docs/math/conformal.md#three-points-to-three-points`).

use super::mobius::Mobius;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// Points nearer than this part of the largest distance are one; a sine below it is a straight line.
const LIMIT: f64 = 1e-12;

/// Three points that are to be mapped, or mapped to, seen from the last one.
struct Triple {
    origin: Point3,
    /// The largest distance from the last point.
    size: f64,
    /// The inverse of the first point, in units of the size.
    first: Vec3,
    /// Direction and distance from there to the inverse of the second point.
    along: Vec3,
    distance: f64,
    /// Unit normal of the plane of the three.
    normal: Vec3,
}

impl Triple {
    fn new([a0, a1, a2]: [Point3; 3], up: Option<Vec3>, what: ErrorItem) -> Result<Self> {
        let points = [a0, a1, a2];
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec()).map_err(|e| e.in_field(what.word()))?;
        }
        let largest = a0.distance(a1).max(a1.distance(a2)).max(a2.distance(a0));
        for (first, second) in [(0, 1), (0, 2), (1, 2)] {
            let (distance, limit) = (points[first].distance(points[second]), LIMIT * largest);
            if distance <= limit {
                let error: Error = PointError::CoincidentPoints { first, second, distance, limit }.into();
                return Err(error.in_field(what.word()));
            }
        }
        let size = a0.distance(a2).max(a1.distance(a2));
        let [x0, x1] = [a0, a1].map(|p| (p - a2) / size);
        let inverse = |x: Vec3| x / -x.length_squared();
        let (first, way) = (inverse(x0), inverse(x1) - inverse(x0));
        let cross = (a1 - a0).cross(a2 - a0);
        let sine = cross.length() / (a0.distance(a1) * a0.distance(a2));
        let line = (a1 - a0).unit().unwrap_or(Vec3::X);
        let across = match up {
            _ if sine > LIMIT => cross,
            Some(up) if up.is_finite() => up - line * up.dot(line),
            Some(_) => return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: 0 }.into()),
            None => return Err(PointError::CollinearNeedsUp { what, measured: sine, limit: LIMIT }.into()),
        };
        let length = up.filter(|_| sine <= LIMIT).map_or(1.0, |up| across.length() / up.length());
        let normal = across.unit().filter(|_| length > LIMIT);
        let normal = normal.ok_or(PointError::ZeroAxis { what: ErrorItem::Normal, index: 0, length, limit: LIMIT })?;
        let along = way.unit().unwrap_or(line);
        Ok(Self { origin: a2, size, first, along, distance: way.length(), normal })
    }
}

impl Mobius {
    /// The map that takes three points to three points and keeps the orientation, `turn` radians about the circle of the images from the one that
    /// takes the plane of the first three to that of the others, side to side. Without a turn it is unique; the normal of a plane is that of
    /// `(a1 - a0) × (a2 - a0)`, and of three points on a line it has to be given: by its part across the line. Of three points that are on no line
    /// a given normal is not used.
    ///
    /// ```
    /// use cyclide::{Point3, conformal::Mobius};
    /// let from = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
    /// let to = [[2.0, 0.0, 0.0], [0.0, 3.0, 1.0], [0.0, 0.0, 5.0]].map(Point3::from);
    /// let map = Mobius::from_three_points(from, to, 0.5, [None, None])?;
    /// for (p, image) in from.into_iter().zip(to) {
    ///     assert!(map.map_point(p).expect("it is finite").distance(image) < 1e-14);
    /// }
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `coincident-points`, `collinear-needs-up`, `zero-axis` (a normal along the line).
    pub fn from_three_points(
        from: [Point3; 3],
        to: [Point3; 3],
        turn: f64,
        normals: [Option<Vec3>; 2],
    ) -> Result<Self> {
        if !turn.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Turn, index: 0 }.into());
        }
        let (source, target) =
            (Triple::new(from, normals[0], ErrorItem::From)?, Triple::new(to, normals[1], ErrorItem::To)?);
        let (sine, cosine) = turn.sin_cos();
        let normal = target.normal * cosine + target.along.cross(target.normal) * sine;
        let r = rotation([source.along, source.normal], [target.along, normal]);
        // Between the inverses the map is a similarity.
        let scale = target.distance / source.distance;
        let shift = Quat::from(target.first) - r * Quat::from(source.first) * r.conj() * scale;
        let shift = Quat::from(shift.vector());
        let entries = [r * target.size, Quat::ZERO, shift * r, r * (scale * source.size)];
        Ok(Self::between(source.origin, target.origin, entries, target.size * scale * source.size))
    }
}

/// The unit quaternion that turns two perpendicular unit vectors to two others.
fn rotation([e, n]: [Vec3; 2], [f, m]: [Vec3; 2]) -> Quat {
    let pairs = [(e, f), (n, m), (e.cross(n), f.cross(m))];
    // Each of these is a multiple of it, or zero.
    let candidate = |g: Quat| pairs.iter().fold(g, |sum, (a, b)| sum - Quat::from(*b) * g * Quat::from(*a));
    let all = [Quat::ONE, Quat::from(e), Quat::from(n), Quat::from(e.cross(n))].map(candidate);
    let longest = all.into_iter().max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared())).unwrap_or(Quat::ONE);
    longest * (1.0 / longest.norm())
}

#[cfg(test)]
mod tests {
    use super::*;

    const FROM: [[f64; 3]; 3] = [[0.3, 1.0, -0.2], [2.0, 0.1, 0.4], [-1.0, 0.7, 3.0]];
    const TO: [[f64; 3]; 3] = [[5.0, -1.0, 2.0], [4.0, 0.0, 2.5], [4.2, -0.3, -1.0]];

    fn made(turn: f64) -> Mobius {
        Mobius::from_three_points(FROM.map(Point3::from), TO.map(Point3::from), turn, [None, None]).unwrap()
    }

    #[test]
    fn takes_the_points_and_the_plane_whatever_the_turn() {
        for turn in [0.0, 1.0, -2.5, 7.0] {
            let map = made(turn);
            assert!(map.determinant() > 0.0);
            for (p, image) in FROM.into_iter().zip(TO) {
                assert!(map.map_point(Point3::from(p)).unwrap().distance(Point3::from(image)) < 1e-14);
            }
            // And back.
            let back =
                Mobius::from_three_points(TO.map(Point3::from), FROM.map(Point3::from), -turn, [None, None]).unwrap();
            let p = Point3::new(0.7, -0.4, 1.1);
            assert!(back.map_point(map.map_point(p).unwrap()).unwrap().distance(p) < 1e-13);
        }
        // A whole turn is none, and without one planes go to planes: a point of the one is in the other.
        let p = Point3::new(0.7, -0.4, 1.1);
        assert!(made(std::f64::consts::TAU).map_point(p).unwrap().distance(made(0.0).map_point(p).unwrap()) < 1e-13);
        let [a, b, c] = FROM.map(Point3::from);
        let inside = a + (b - a) * 0.4 + (c - a) * 0.3;
        let [d, e, f] = TO.map(Point3::from);
        let normal = (e - d).cross(f - d).unit().unwrap();
        assert!((made(0.0).map_point(inside).unwrap() - d).dot(normal).abs() < 1e-14);
        assert!((made(0.5).map_point(inside).unwrap() - d).dot(normal).abs() > 1e-3);
    }

    #[test]
    fn lines_need_a_normal() {
        let line = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
        let to = TO.map(Point3::from);
        let reason = |up| Mobius::from_three_points(line, to, 0.0, [up, None]).unwrap_err().reason();
        assert_eq!(reason(None), "collinear-needs-up");
        assert_eq!(reason(Some(Vec3::X)), "zero-axis");
        assert_eq!(reason(Some(Vec3::new(0.0, f64::NAN, 1.0))), "not-finite");
        let map = Mobius::from_three_points(line, to, 0.0, [Some(Vec3::new(5.0, 0.0, 2.0)), None]).unwrap();
        assert!(map.map_point(line[1]).unwrap().distance(to[1]) < 1e-14);
    }
}
