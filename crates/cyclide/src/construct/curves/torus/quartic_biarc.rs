//! Two quartic pieces of one type between two places with given speeds: a [`ProjectiveBiarc`] in each coordinate, with one
//! junction for both (`docs/math/torus-splines.md#quartic-pieces`).

use super::local_data::LocalData;
use super::spline_span::quality;
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, NumberError, Result};
use crate::surface::{QuarticType, SegmentMethod, Torus, TorusChain, TorusSpline, within_a_turn};

impl TorusSpline {
    /// The two pieces of one type from a place by a step, with the given speeds at both ends, over two lengths of the knot parameter
    /// from 0. In both coordinates of the type the step and both speeds must run in one direction, or all be zero.
    ///
    /// ```
    /// use cyclide::{Frame, Point2, Vec2, surface::{CircleFamily, QuarticType, Torus, TorusSpline}};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
    /// let (start, step) = (Point2::new(0.1, 0.2), Vec2::new(0.8, 0.6));
    /// let curve = TorusSpline::quartic_biarc(&torus, kind, start, step, [Vec2::new(1.0, 0.3), Vec2::new(0.4, 1.2)], [0.5, 0.5])?;
    /// assert!((curve.unrolled_rate(1, 1.0) - Vec2::new(0.4, 1.2)).length() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `not-monotone`, `span-too-large`, `empty-interval`, `parameter-out-of-range`, as [`ProjectiveBiarc::new`](crate::construct::ProjectiveBiarc::new).
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
        chain.end_segment(SegmentMethod::Direct, quality(kind, step, rates, lengths[0] + lengths[1]));
        Ok(chain.into_spline(torus, false, start + step))
    }
}
