//! Offsets of nets.

use super::CyclidicNet;
use super::same_vertices::SameVertices;
use crate::base::range;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, NumberError, PatchError, Result};
use crate::surface::patch::CyclidePatch;

/// Centers of curvature are as near as each other up to this part of their distance.
const SAME_LIMIT: f64 = 1e-9;

impl CyclidicNet {
    /// Refuses a distance between which and the net patches have centers of curvature: with the quad that has the nearest, and the distance of that.
    /// 0 of a patch that is singular inside.
    ///
    /// # Errors
    /// `offset-not-regular`.
    pub(crate) fn check_offset_regular(&self, h: f64) -> Result<()> {
        let limit = |patch: &CyclidePatch| {
            let limit = if patch.offset_is_regular(0.0) { patch.offset_limit(h) } else { 0.0 };
            limit.clamp(-h.abs(), h.abs())
        };
        let beyond = self.patches_with_quads().filter(|(_, patch)| !patch.offset_is_regular(h));
        let limits: Vec<(usize, f64)> = beyond.map(|(quad, patch)| (self.number(quad), limit(&patch))).collect();
        let nearest = limits.iter().map(|(_, limit)| limit.abs()).fold(f64::INFINITY, f64::min);
        // The first of those that have the same but for rounding, as of a torus.
        match limits.into_iter().find(|(_, limit)| limit.abs() <= nearest * (1.0 + SAME_LIMIT)) {
            Some((quad, limit)) => Err(Error::from(PatchError::OffsetNotRegular { distance: h, limit }).in_quad(quad)),
            None => Ok(()),
        }
    }

    /// The net at the signed distance `h` along the normals `D V3 D^-1`: the same weights over the vertices
    /// `a + h w V3 w^-1`, so every patch is the exact offset of its patch
    /// (`docs/math/cyclides-and-nets.md#offsets-and-thickness`). An offset beyond a curvature center is made all the
    /// same and keeps the normals, so that distances add up: [`singular_patches`](Self::singular_patches) and
    /// [`flipped_patches`](Self::flipped_patches) tell.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `offset-on-focal-set` with the quad (a patch
    /// shrinks to a curve or a point), `below-rounding-of-place`.
    pub fn offset(&self, h: f64) -> Result<Self> {
        if !h.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::OffsetDistance, index: 0 }.into());
        }
        let [m, n] = self.grid.size();
        let places = (0..n).flat_map(|j| (0..m).map(move |i| (i, j)));
        let moved = |(i, j)| self.grid.point(i, j) + self.vertex_frame(i, j)[2] * h;
        let mut points: Vec<Point3> = places.map(moved).collect();
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        // An edge of one point has one vertex, bit for bit.
        let mut same = SameVertices::new(m * n);
        for ([i, j], patch) in self.patches_with_quads() {
            patch.check_not_focal(h).map_err(|error| error.in_quad(self.number([i, j])))?;
            let corners = self.grid.corners(i, j);
            for [a, b] in patch.offset_points(h).into_iter().flatten() {
                same.join(corners[a], corners[b]);
            }
        }
        for k in 0..m * n {
            points[k] = points[same.first(k)];
        }
        let grid = self.grid.with_points(points)?;
        grid.check_place()?;
        Ok(Self::from_weights_unchecked(grid, self.weights.clone(), self.v, self.turn))
    }
}
