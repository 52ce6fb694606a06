//! How far a patch is from flat: its height over the plane of its corners, and its twist along the diagonals.

use super::CyclidePatch;
use crate::base::vector::Vec3;
use crate::surface::ParamSurface as _;

/// Places per direction from which the highest one is searched: heights over a patch have few humps.
const PLACES: u32 = 12;
/// Steps of the search at most; each doubles the digits.
const STEPS: usize = 24;
/// Corners closer than this part of the patch are one.
const ONE_POINT: f64 = 1e-9;

impl CyclidePatch {
    /// Largest distance of the patch from the plane of its corners, which is that of their circle: the depth of its mould.
    /// 0 where corners have no plane.
    ///
    /// ```
    /// use cyclide::{CyclidePatch, Point3, Vec3};
    /// // A square of the unit sphere about its pole.
    /// let at = |x: f64, y: f64| Point3::new(0.6 * x, 0.6 * y, (1.0 - 0.72_f64).sqrt());
    /// let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0)];
    /// let normal = corners[0].to_vec();
    /// let along = Vec3::X - normal * normal.x;
    /// let patch = CyclidePatch::from_corners_and_frame(corners, along, normal.cross(along))?;
    /// assert!((patch.sagitta() - (1.0 - 0.28_f64.sqrt())).abs() < 1e-12 && patch.twist() < 1e-12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn sagitta(&self) -> f64 {
        let [a0, a1, a2, a3] = self.corners;
        let crosses = [(a1 - a0).cross(a2 - a0), (a1 - a0).cross(a3 - a0), (a2 - a0).cross(a3 - a0)];
        let largest = crosses.into_iter().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
        let Some(normal) = largest.filter(|n| n.length() > ONE_POINT * self.scale * self.scale).and_then(Vec3::unit)
        else {
            return 0.0;
        };
        let height = |s: f64, t: f64| (self.point(s, t) - a0).dot(normal);
        let places = || (0..=PLACES).flat_map(|i| (0..=PLACES).map(move |j| (i, j)));
        let places = || places().map(|(i, j)| (f64::from(i) / f64::from(PLACES), f64::from(j) / f64::from(PLACES)));
        let [top, bottom] = [1.0, -1.0].map(|side| {
            let best = places().max_by(|a, b| (side * height(a.0, a.1)).total_cmp(&(side * height(b.0, b.1))));
            best.map_or(0.0, |(s, t)| self.climbed(normal * side, s, t))
        });
        top.max(bottom).max(0.0)
    }

    /// The largest height along `up` over the first corner that Newton's steps find from a place, within the patch.
    fn climbed(&self, up: Vec3, mut s: f64, mut t: f64) -> f64 {
        let mut best = (self.point(s, t) - self.corners[0]).dot(up);
        for _ in 0..STEPS {
            let jet = self.jet(s, t);
            let (gs, gt) = (jet.ds.dot(up), jet.dt.dot(up));
            let (hss, hst, htt) = (jet.dss.dot(up), jet.dst.dot(up), jet.dtt.dot(up));
            // A side that it would leave holds it: then along that side.
            let held = |x: f64, g: f64| (x <= 0.0 && g < 0.0) || (x >= 1.0 && g > 0.0);
            let (ds, dt) = match (held(s, gs), held(t, gt)) {
                (true, true) => break,
                (true, false) => (0.0, if htt < 0.0 { -gt / htt } else { 0.0 }),
                (false, true) => (if hss < 0.0 { -gs / hss } else { 0.0 }, 0.0),
                (false, false) => {
                    let det = hss * htt - hst * hst;
                    if !(det > 0.0 && hss < 0.0) {
                        break;
                    }
                    ((hst * gt - htt * gs) / det, (hst * gs - hss * gt) / det)
                }
            };
            let (next_s, next_t) = ((s + ds).clamp(0.0, 1.0), (t + dt).clamp(0.0, 1.0));
            let height = (self.point(next_s, next_t) - self.corners[0]).dot(up);
            if !(height > best) {
                break;
            }
            (best, s, t) = (height, next_s, next_t);
        }
        best
    }

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
    use crate::base::vector::Point3;

    #[test]
    fn the_height_is_the_largest_of_a_fine_grid() {
        let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
        let (v1, v2) = (Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0));
        let patch = CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap();
        let places = (0..=400).flat_map(|i| (0..=400).map(move |j| (f64::from(i) / 400.0, f64::from(j) / 400.0)));
        let seen = places.map(|(s, t)| patch.point(s, t).z.abs()).fold(0.0, f64::max);
        let found = patch.sagitta();
        // Between places of the grid it may be higher by the square of their distance.
        assert!(found >= seen && found < seen * (1.0 + 1e-4), "{found} {seen}");
    }

    #[test]
    fn a_cylinder_is_twisted_along_its_diagonals() {
        let at = |a: f64, z: f64| Point3::new(a.cos(), a.sin(), z);
        let corners = [at(0.0, 0.0), at(0.8, 0.0), at(0.0, 1.0), at(0.8, 1.0)];
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        assert!((patch.sagitta() - (1.0 - 0.4_f64.cos())).abs() < 1e-14);
        // The normals at both ends are at 0.4 from the middle, in a plane across the axis: the angle between their planes
        // with the diagonal, by the products of these three directions.
        let d = (corners[3] - corners[0]).unit().unwrap();
        let (n, m) = (Vec3::X, Vec3::new(0.8_f64.cos(), 0.8_f64.sin(), 0.0));
        let want = d.dot(n.cross(m)).abs().atan2(n.dot(m) - n.dot(d) * m.dot(d));
        assert!((patch.twist() - want).abs() < 1e-14 && want > 0.5);
    }
}
