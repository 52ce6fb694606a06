//! Splines on a torus run backwards and moved.

use super::spline::{TorusSegment, TorusSpline};
use crate::base::planar::Point2;
use crate::base::vector::Vec3;
use crate::conformal::mobius::Mobius;
use crate::error::Result;

impl TorusSpline {
    /// The same points run backwards over the same interval of knots.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let (n, [first, last]) = (self.pieces.len(), [self.knots[0], self.knots[self.pieces.len()]]);
        // The mirror image of each end is the other end, to the bit.
        let mirrored = |(i, k): (usize, &f64)| {
            if i == n {
                first
            } else if i == 0 {
                last
            } else {
                first + (last - k)
            }
        };
        let mut knots: Vec<f64> = self.knots.iter().enumerate().map(mirrored).collect();
        knots.reverse();
        let segment = |s: &TorusSegment| TorusSegment { pieces: n - s.pieces.end..n - s.pieces.start, ..s.clone() };
        Self {
            pieces: self.pieces.iter().rev().map(super::piece::TorusPiece::reversed).collect(),
            knots,
            joints: self.joints.iter().rev().copied().collect(),
            unrolled: self.unrolled.iter().rev().copied().collect(),
            segments: self.segments.iter().rev().map(segment).collect(),
            ..*self
        }
    }

    /// The image under a similarity or a reflection, with the same knots.
    ///
    /// # Errors
    /// As [`Torus::similar`](super::Torus::similar).
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        let torus = self.torus.similar(map)?;
        let (frame, origin) = (self.torus.frame(), self.torus.frame().origin());
        let image = |v: Vec3| map.push_forward(origin, v).unwrap_or(v);
        let turned = image(frame.x()).cross(image(frame.y())).dot(image(frame.z())) < 0.0;
        let mut moved = Self { torus, ..self.clone() };
        if turned {
            moved.pieces.iter_mut().for_each(|piece| *piece = piece.mirrored());
            moved.unrolled.iter_mut().for_each(|place| *place = Point2::new(-place.x, place.y));
        }
        for (joint, place) in moved.joints.iter_mut().zip(&moved.unrolled) {
            *joint = torus.point(*place);
        }
        if let (true, Some(first)) = (self.closed, moved.joints.first().copied()) {
            moved.joints.pop();
            moved.joints.push(first);
        }
        Ok(moved)
    }
}
