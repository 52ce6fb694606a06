//! Möbius maps of patches: the homogeneous pairs map linearly, so the image is a patch with the same parameters.

use super::CyclidePatch;
use super::pole::check_no_pole;
use crate::conformal::mapped_pairs::MappedPairs;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::Result;

impl Conformal for CyclidePatch {
    /// The image under a Möbius map `y -> (a y + b)(c y + d)^-1`, with the same parameters: corners by the map, weights
    /// `(c a_k + d) w_k` up to a common factor (`docs/math/patches.md#offsets-and-images`). The speeds keep their
    /// signs: a map that reverses orientation turns `V1` and `V2` round and keeps `V3`. Its
    /// [`unit_normal`](CyclidePatch::unit_normal) is then the opposite of the pushed forward one.
    ///
    /// # Errors
    /// `point-at-infinity` if a corner goes to infinity, or is nearer than 6e-8 of the patch's size to the point that
    /// does (then nothing of the image's size is known, nor the sign of its weights), `patch-through-infinity` if an inner point does,
    /// `parameter-out-of-range` (coordinates above 1e150), `below-rounding-of-place` (the image is smaller than
    /// rounding), `not-in-space` if rounding destroyed the result.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let image = self.image(map)?;
        image.check_place()?;
        Ok(image)
    }
}

impl CyclidePatch {
    /// The image, however small it is at its place: it may be a part of a larger one.
    ///
    /// # Errors
    /// As [`transformed`](Self::transformed), but for `below-rounding-of-place`.
    pub(crate) fn image(&self, map: &Mobius) -> Result<Self> {
        let MappedPairs { corners, weights, size } = map.map_pairs(self.corners, self.weights, self.scale)?;
        let lambda = map.determinant();
        let sign = 1.0_f64.copysign(lambda);
        let mut image = Self::from_weights_unchecked(corners, weights, self.v[0] * sign, self.v[1] * sign);
        if image.scale == 0.0 {
            image.check_place()?;
        }
        check_no_pole(&image.weights)?;
        image.check_in_space(self.corner_rounding() + image.corner_rounding())?;
        // The speeds scale by the determinant: zeros and signs stay.
        let factor = lambda.abs() / size / size;
        image.polar.q1 = self.polar.q1.map(|q| q * factor);
        image.polar.q2 = self.polar.q2.map(|q| q * factor);
        Ok(image)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::quat::Quat;
    use crate::base::vector::{Point3, Vec3};
    use crate::surface::ParamSurface as _;

    fn patch() -> CyclidePatch {
        // Corners on the circle of radius 2 in the plane z = 1.
        let at = |angle: f64| Point3::new(2.0 * angle.cos(), 2.0 * angle.sin(), 1.0);
        let v1 = Vec3::new(-0.3, 0.9, 0.2).unit().unwrap();
        let v2 = v1.cross(Vec3::new(0.1, 0.3, 1.0)).unit().unwrap();
        CyclidePatch::from_corners_and_frame([at(0.0), at(0.7), at(5.5), at(2.0)], v1, v2).unwrap()
    }

    #[test]
    fn images_of_points_and_their_derivatives() {
        let patch = patch();
        let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap();
        let inversion = Mobius::inversion(Point3::new(0.5, -4.0, 7.0), 3.0).unwrap();
        let mirror = Mobius::reflection(Point3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
        for map in [turn, inversion, mirror, turn.after(&inversion), inversion.after(&mirror)] {
            let image = patch.transformed(&map).unwrap();
            for i in 0..=4 {
                for j in 0..=4 {
                    let (s, t) = (f64::from(i) / 4.0, f64::from(j) / 4.0);
                    let (before, after) = (patch.jet(s, t), image.jet(s, t));
                    assert!(after.point.distance(map.map_point(before.point).unwrap()) < 1e-13);
                    for (v, w) in [(before.ds, after.ds), (before.dt, after.dt)] {
                        assert!((map.push_forward(before.point, v).unwrap() - w).length() < 1e-12 * w.length());
                    }
                    let along = patch.moving_frame(s, t)[2];
                    let normal = map.push_forward(before.point, along).unwrap().unit().unwrap();
                    let sign = map.determinant().signum();
                    assert!((normal * sign - image.unit_normal(s, t)).length() < 1e-12);
                }
            }
            // Signs of the speeds stay.
            for (q, p) in patch.q1().into_iter().zip(image.q1()).chain(patch.q2().into_iter().zip(image.q2())) {
                assert!((q > 0.0) == (p > 0.0));
            }
        }
    }

    #[test]
    fn centres_of_inversion_on_the_patch_are_refused() {
        let patch = patch();
        let at = |p: Point3| patch.transformed(&Mobius::inversion(p, 1.0).unwrap()).unwrap_err().reason();
        assert_eq!(at(patch.corners()[2]), "point-at-infinity");
        assert_eq!(at(patch.point(0.4, 0.7)), "patch-through-infinity");
    }
}
