//! Closed quartics of one type: both coordinates of the type run once round their projective line, each projectively in the other.
//!
//! With `z_i = e^(iu)` the other is `z_j = cos u + i k sin u`, a linear image of it, over `u` from 0 to `pi`. Cut into equal steps of `u`
//! both are linear over the chord of each (`docs/math/torus-splines.md#closed-quartics`).

use super::projective_biarc::within;
use super::spline_data::check_angles;
use crate::base::complex::Complex;
use crate::base::planar::Point2;
use crate::error::{ErrorItem, Result, TorusError};
use crate::surface::{
    CircleFamily, Course, QuarticType, SegmentMethod, Torus, TorusChain, TorusPiece, TorusSpline, within_a_turn,
};
use std::f64::consts::PI;

/// Steps of half a turn.
const STEPS: u32 = 16;
/// Ratios accepted, and their inverses: beyond, speeds vary by more than a thousand.
const MOST_RATIO: f64 = 32.0;

impl TorusSpline {
    /// The closed quartic of a type through a point: there its second coordinate runs `ratio` times as fast as the first (backwards for a
    /// negative ratio); halfway around the ratio is the inverse. `1` and `-1` keep both even, which gives circles or knots.
    ///
    /// ```
    /// use cyclide::{Frame, surface::{CircleFamily, QuarticType, Torus, TorusSpline}};
    /// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let quartic = TorusSpline::closed_quartic(&torus, kind, Default::default(), 2.5)?;
    /// assert_eq!((quartic.to_nurbs()?.degree(), quartic.winding()), (4, Some([1, 1])));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (angles above 1e6, a size of the ratio outside 1/32 to 32), `not-coprime` (`1` and `-1` of both
    /// Villarceau families: a circle run twice).
    pub fn closed_quartic(torus: &Torus, kind: QuarticType, start: Point2, ratio: f64) -> Result<Self> {
        check_angles(0, start)?;
        within(ErrorItem::Ratio, ratio.abs(), [1.0 / MOST_RATIO, MOST_RATIO])?;
        let villarceau = QuarticType::between(CircleFamily::Villarceau, CircleFamily::MirrorVillarceau);
        #[expect(clippy::float_cmp, reason = "the ratios 1 and -1 alone are circles")]
        if Some(kind) == villarceau && ratio.abs() == 1.0 {
            let turns = if ratio > 0.0 { [2, 0] } else { [0, 2] };
            return Err(TorusError::NotCoprime { turns, divisor: 2 }.into());
        }
        let step = PI / f64::from(STEPS);
        let at = |k: u32, ratio: f64| {
            let (sin, cos) = (step * f64::from(k)).sin_cos();
            Complex::new(cos, ratio * sin)
        };
        // The ratio of the ends, whose argument is the step: less than a quarter of a turn.
        let course = |k: u32, ratio: f64| {
            let from = at(k, ratio);
            let ratio = at(k + 1, ratio) * from.conj() * (1.0 / from.norm_squared());
            Course { step: ratio.im.atan2(ratio.re), ratio }
        };
        let start = within_a_turn(start);
        let mut chain = TorusChain::starting_at(0.0);
        let mut moved = [0.0; 2];
        for k in 0..STEPS {
            let courses = [course(k, 1.0), course(k, ratio)];
            let place = start + kind.back(moved);
            chain.push(TorusPiece::new(kind, place, courses), f64::from(k + 1));
            chain.end_segment(SegmentMethod::Direct, 1.0);
            moved = [0, 1].map(|i| moved[i] + courses[i].step);
        }
        Ok(chain.into_spline(torus, true, start))
    }
}
