//! The block of a volume as a solid: six patches with shared edges.

use super::{Body, Sewing};
use crate::error::Result;
use crate::volume::CyclideVolume;

impl CyclideVolume {
    /// The block as a solid of its six [faces](Self::faces): s = 0, s = 1, t = 0, t = 1, u = 0, u = 1, outside outwards.
    ///
    /// # Errors
    /// As [`Shell::new`](super::Shell::new); `coincident-points` where a side is one point.
    pub fn to_body(&self) -> Result<Body> {
        let mut sewing = Sewing::default();
        let vertices = self.corners().map(|p| sewing.vertex(p));
        // Sides along s, t, u, each by its start in the two other directions, binary order.
        let mut sides = [[0; 4]; 3];
        for (axis, sides) in sides.iter_mut().enumerate() {
            for (k, side) in sides.iter_mut().enumerate() {
                let place = [(k & 1) as f64, (k >> 1) as f64];
                let (start, step) = (Self::corner_of(axis, 0, k), 1 << axis);
                *side = sewing.edge(vertices[start], vertices[start + step], self.line(axis, place)?);
            }
        }
        for (k, face) in self.faces().into_iter().enumerate() {
            let (axis, end) = (k / 2, k % 2);
            // The directions of the face, and its sides at t = 0, t = 1, s = 0, s = 1.
            let edges = match axis {
                0 => [sides[1][end], sides[1][end + 2], sides[2][end], sides[2][end + 2]],
                1 => [sides[0][end], sides[0][end + 2], sides[2][2 * end], sides[2][2 * end + 1]],
                _ => [sides[0][2 * end], sides[0][2 * end + 1], sides[1][2 * end], sides[1][2 * end + 1]],
            };
            // Of the second direction the face's normal s x u runs against it.
            let along = (axis != 1) == self.is_right_handed();
            sewing.face(face, edges.map(Some), along == (end == 1));
        }
        sewing.finish_body()
    }
}
