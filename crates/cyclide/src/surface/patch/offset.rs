//! The offset surface, which keeps the weights (`docs/math/patches.md#offsets-and-images`).

use super::CyclidePatch;
use super::polar::at_half;
use super::singular::roots;
use crate::base::range;
use crate::base::vector::Vec3;
use crate::error::{ErrorItem, NumberError, PatchError, Result};

/// An offset side is one point if its radius cancels to this part of the distance and of the radius before.
const COLLAPSED: f64 = 64.0 * f64::EPSILON;

/// The same for all lines of one family: the offset is a curve or a point. Patches of nets and of given corners are in
/// space to about 1e-13.
const FOCAL: f64 = 1e-12;

impl CyclidePatch {
    /// The surface at the signed distance `h` along [`unit_normal`](Self::unit_normal), with the same parameters:
    /// `f_h = f + h N` exactly. Weights and frame are the same, corners `a_k + h w_k V3 w_k^-1`, speeds
    /// `q1 + 2h m·V2` and `q2 - 2h m*·V1` (`docs/math/patches.md#offsets-and-images`). An offset beyond a curvature
    /// center is made all the same; [`offset_is_regular`](Self::offset_is_regular) tells. It keeps the normal, which is
    /// then against its `f_s × f_t` if one of the two centers was passed: distances add up.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `offset-on-focal-set` (all curvature centers
    /// of one family are at that distance: of a sphere by its radius, of a torus by that of its tube), `below-rounding-of-place`.
    pub fn offset(&self, h: f64) -> Result<Self> {
        if !h.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::OffsetDistance, index: 0 }.into());
        }
        self.check_not_focal(h)?;
        let (q1, q2) = self.offset_speeds(h);
        let mut corners = std::array::from_fn(|k| {
            let w = self.weights[k];
            self.corners[k] + (w * (1.0 / w.norm())).rotate(self.v[2]) * h
        });
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        // A side of one point has one corner, bit for bit.
        for [from, to] in self.offset_points(h).into_iter().flatten() {
            corners[to] = corners[from];
        }
        range::check_place(ErrorItem::Surface, &corners)?;
        let mut patch = Self::from_weights_unchecked(corners, self.weights, self.v[0], self.v[1]);
        (patch.polar.q1, patch.polar.q2) = (q1, q2);
        Ok(patch)
    }

    /// True if no curvature center lies on the way from the patch to its [`offset`](Self::offset), ends included:
    /// the speeds of the offset have the signs of `q1`, `q2` all over the patch, so it has no cuspidal edge and the
    /// same side up. Sides that are one point may stay so. False for a patch that is singular inside itself.
    #[must_use]
    pub fn offset_is_regular(&self, h: f64) -> bool {
        let rounding = [self.speed_rounding(0.0), self.speed_rounding(h)];
        let same_sign = |direction: usize, before: [f64; 3], after: [f64; 3]| {
            let (p, q) = (at_half(&before), at_half(&after));
            let regular = |speed, rounding: [[f64; 3]; 2]| roots(speed, rounding[direction]).is_empty();
            regular(before, rounding[0])
                && regular(after, rounding[1])
                && ((p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0))
        };
        let (q1, q2) = self.offset_speeds(h);
        same_sign(0, self.polar.q1, q1) && same_sign(1, self.polar.q2, q2)
    }

    /// The corners of the sides t=0, t=1, s=0, s=1 of the offset that are one point.
    pub(in crate::surface) fn offset_points(&self, h: f64) -> [Option<[usize; 2]>; 4] {
        let (q1, q2) = self.offset_speeds(h);
        let sides = [(q1[0], [0, 1]), (q1[2], [2, 3]), (q2[0], [0, 2]), (q2[2], [1, 3])];
        sides.map(|(speed, corners)| (speed == 0.0).then_some(corners))
    }

    /// Refuses an offset in which all lines of one family shrink to points.
    ///
    /// # Errors
    /// `offset-on-focal-set`.
    pub(in crate::surface) fn check_not_focal(&self, h: f64) -> Result<()> {
        let lines = self.offset_lines(h);
        let Some(family) = lines.iter().find(|lines| lines.iter().all(|[speed, terms]| speed.abs() <= FOCAL * terms))
        else {
            return Ok(());
        };
        // Of a side that is one point there are no terms.
        let left = family.iter().filter(|[_, terms]| *terms > 0.0).map(|[speed, terms]| speed.abs() / terms);
        Err(PatchError::OffsetOnFocalSet { distance: h, measured: left.fold(0.0, f64::max), limit: FOCAL }.into())
    }

    /// How far the surface may be offset to the side of `h` before it meets a center of curvature, with the sign of `h`: infinite
    /// where there is none, 0 for a patch that is singular inside.
    pub(crate) fn offset_limit(&self, h: f64) -> f64 {
        if !self.is_regular() {
            return 0.0;
        }
        let bends = [self.k1_range(), self.k2_range()].concat();
        h.signum() / bends.into_iter().map(|k| k * h.signum()).fold(0.0, f64::max)
    }

    /// Speeds of the offset; those of sides that are one point are exactly zero.
    fn offset_speeds(&self, h: f64) -> ([f64; 3], [f64; 3]) {
        let settled = |lines: [[f64; 2]; 3]| {
            std::array::from_fn(|i| {
                let [speed, terms] = lines[i];
                if i != 1 && speed.abs() <= COLLAPSED * terms { 0.0 } else { speed }
            })
        };
        let [q1, q2] = self.offset_lines(h);
        (settled(q1), settled(q2))
    }

    /// Bernstein coefficients of both speeds of the offset, each with the size of its terms: `|q| + 2|h m|`, so that
    /// their quotient is that of the radius of a line to the radius before and the distance.
    fn offset_lines(&self, h: f64) -> [[[f64; 2]; 3]; 2] {
        let polar = &self.polar;
        let shifted = |speed: [f64; 3], bend: [f64; 3], m: [Vec3; 3]| {
            std::array::from_fn(|i| [speed[i] + 2.0 * h * bend[i], speed[i].abs() + 2.0 * h.abs() * m[i].length()])
        };
        [shifted(polar.q1, polar.bend1(self.v[1]), polar.m), shifted(polar.q2, polar.bend2(self.v[0]), polar.m_star)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::Point3;
    use crate::surface::ParamSurface as _;

    /// An octant of the unit sphere about (2, 0, 0) with its pole at a2 = a3, normal outward.
    fn octant() -> CyclidePatch {
        let at = |x: f64, y: f64, z: f64| Point3::new(2.0 + x, y, z);
        let corners = [at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0), at(0.0, 0.0, 1.0)];
        CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap()
    }

    #[test]
    fn every_point_moves_along_its_normal() {
        let patch = octant();
        let offset = patch.offset(0.25).unwrap();
        for i in 0..=8 {
            for j in 0..=8 {
                let (s, t) = (f64::from(i) / 8.0, f64::from(j) / 8.0);
                let want = patch.point(s, t) + patch.unit_normal(s, t) * 0.25;
                assert!(offset.point(s, t).distance(want) < 1e-15);
            }
        }
        assert_eq!(offset.corners()[2], offset.corners()[3], "the pole stays one point");
        assert!(offset.is_regular());
    }

    #[test]
    fn the_centre_is_the_limit() {
        let patch = octant();
        assert!(patch.offset_is_regular(-0.999) && patch.offset_is_regular(1e9));
        assert!(!patch.offset_is_regular(-1.001) && !patch.offset_is_regular(f64::NAN));
        assert_eq!(patch.offset(-1.0).unwrap_err().reason(), "offset-on-focal-set");
        assert_eq!(patch.offset(f64::INFINITY).unwrap_err().reason(), "not-finite");
        assert_eq!(patch.offset(1e200).unwrap_err().reason(), "parameter-out-of-range");
    }
}
