//! How a patch is twisted along its diagonals.

use super::CyclidePatch;
use crate::surface::ParamSurface as _;

impl CyclidePatch {
    /// The angle by which the normal turns about a diagonal between its ends, the larger one of both diagonals, radians: 0 for
    /// parts of planes and spheres. Along its sides, lines of curvature, no patch is twisted.
    #[must_use]
    pub fn twist(&self) -> f64 {
        let along = |[from, to]: [(f64, f64); 2]| {
            let chord = (self.point(to.0, to.1) - self.point(from.0, from.1)).unit()?;
            let across = |(s, t)| {
                let normal = self.unit_normal(s, t);
                (normal - chord * normal.dot(chord)).unit()
            };
            let (a, b) = (across(from)?, across(to)?);
            Some(a.cross(b).length().atan2(a.dot(b)))
        };
        let diagonals = [[(0.0, 0.0), (1.0, 1.0)], [(1.0, 0.0), (0.0, 1.0)]];
        diagonals.into_iter().filter_map(along).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};

    #[test]
    fn a_cylinder_is_twisted_along_its_diagonals() {
        let at = |a: f64, z: f64| Point3::new(a.cos(), a.sin(), z);
        let corners = [at(0.0, 0.0), at(0.8, 0.0), at(0.0, 1.0), at(0.8, 1.0)];
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        // The angle between the planes of the diagonal and the normals at its ends, by the products of these three directions.
        let d = (corners[3] - corners[0]).unit().unwrap();
        let (n, m) = (Vec3::X, Vec3::new(0.8_f64.cos(), 0.8_f64.sin(), 0.0));
        let want = d.dot(n.cross(m)).abs().atan2(n.dot(m) - n.dot(d) * m.dot(d));
        assert!((patch.twist() - want).abs() < 1e-14 && want > 0.5);
    }

    #[test]
    fn a_sphere_is_not() {
        let at = |x: f64, y: f64| Point3::new(0.6 * x, 0.6 * y, (1.0 - 0.72_f64).sqrt());
        let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0)];
        let normal = corners[0].to_vec();
        let along = Vec3::X - normal * normal.x;
        let patch = CyclidePatch::from_corners_and_frame(corners, along, normal.cross(along)).unwrap();
        assert!(patch.twist() < 1e-14);
    }
}
