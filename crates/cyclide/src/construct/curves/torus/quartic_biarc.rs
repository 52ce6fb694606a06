//! Two quartic pieces of one type between two places with given speeds: a [`ProjectiveBiarc`] in each coordinate, with one
//! junction for both (`docs/math/torus-splines.md#quartic-pieces`).

use super::projective_biarc::ProjectiveBiarc;
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, NumberError, Result};
use crate::surface::{Course, QuarticType, SegmentMethod, Torus, TorusChain, TorusPiece, TorusSpline, within_a_turn};

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

impl TorusSpline {
    /// The two pieces of one type from a place by a step, with the given speeds at both ends, over two lengths of the knot parameter
    /// from 0. In both coordinates of the type the step and both speeds must run in one direction, or all be zero.
    ///
    /// ```
    /// use cyclide::{CircleFamily, Frame, Point2, QuarticType, Torus, TorusSpline, Vec2};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
    /// let (start, step) = (Point2::new(0.1, 0.2), Vec2::new(0.8, 0.6));
    /// let curve = TorusSpline::quartic_biarc(&torus, kind, start, step, [Vec2::new(1.0, 0.3), Vec2::new(0.4, 1.2)], [0.5, 0.5])?;
    /// assert!((curve.unrolled_rate(1, 1.0) - Vec2::new(0.4, 1.2)).length() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `not-monotone`, `span-too-large`, `empty-interval`, `parameter-out-of-range`, as [`ProjectiveBiarc::new`].
    pub fn quartic_biarc(
        torus: &Torus,
        kind: QuarticType,
        start: Point2,
        step: Vec2,
        rates: [Vec2; 2],
        lengths: [f64; 2],
    ) -> Result<Self> {
        if !start.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        let start = within_a_turn(start);
        let [first, second] = LocalData::new(kind, step, rates).pieces(kind, start, lengths)?;
        let mut chain = TorusChain::starting_at(0.0);
        chain.push(first, lengths[0]);
        chain.push(second, lengths[0] + lengths[1]);
        chain.end_segment(
            SegmentMethod::Direct,
            super::spline_span::quality(kind, step, rates, lengths[0] + lengths[1]),
        );
        Ok(chain.into_spline(torus, false, start + step))
    }
}
