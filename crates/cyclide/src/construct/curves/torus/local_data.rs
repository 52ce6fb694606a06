//! The data of a quartic in the coordinates of its type.

use super::projective_biarc::ProjectiveBiarc;
use crate::base::planar::{Point2, Vec2};
use crate::error::Result;
use crate::surface::{Course, QuarticType, TorusPiece};

/// Step and slopes at both ends of each coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalData {
    pub(super) steps: [f64; 2],
    pub(super) slopes: [[f64; 2]; 2],
}

impl LocalData {
    pub(super) fn new(kind: QuarticType, step: Vec2, rates: [Vec2; 2]) -> Self {
        let (steps, [start, end]) = (kind.local(step), rates.map(|rate| kind.local(rate)));
        Self { steps, slopes: [[start[0], end[0]], [start[1], end[1]]] }
    }

    /// Both pieces, over lengths of the parameter.
    pub(super) fn pieces(&self, kind: QuarticType, start: Point2, lengths: [f64; 2]) -> Result<[TorusPiece; 2]> {
        let coordinate = |i: usize| ProjectiveBiarc::of_coordinate(i, 0.0, self.steps[i], self.slopes[i], lengths);
        let [p, q] = [coordinate(0)?, coordinate(1)?];
        let courses = |piece: usize| -> [Course; 2] { [p.courses()[piece], q.courses()[piece]] };
        let middle = start + kind.back([p.mid_offset(), q.mid_offset()]);
        Ok([TorusPiece::new(kind, start, courses(0)), TorusPiece::new(kind, middle, courses(1))])
    }
}
