//! Closed curves of two-type biarcs through points with given speeds, as in the loops of `002` Figs. 2 and 3.

use super::spline_data::{check_places, check_rate, shortest_step};
use super::two_type::TwoTypeBiarc;
use crate::base::planar::{Point2, Vec2};
use crate::error::{Error, ErrorItem, NumberError, Result, TorusError};
use crate::surface::CircleFamily::{Meridian, MirrorVillarceau, Parallel, Villarceau};
use crate::surface::{CircleFamily, QuarticType, SegmentMethod, Torus, TorusChain, TorusSpline, within_a_turn};

/// The types of a quarter, by their families: two for each sense of turning.
const QUARTERS: [[[CircleFamily; 2]; 2]; 4] = [
    [[Villarceau, Meridian], [Parallel, Villarceau]],
    [[Parallel, MirrorVillarceau], [MirrorVillarceau, Meridian]],
    [[MirrorVillarceau, Meridian], [Parallel, MirrorVillarceau]],
    [[Parallel, Villarceau], [Villarceau, Meridian]],
];

impl TorusSpline {
    /// The closed curve through places with given speeds, one quarter from each to the next: two quartic pieces of two types that share a
    /// Villarceau coordinate, so that tangents may be along parallels and meridians in turn, where no quarter has one type. Knots
    /// 0, 1, 2, ....
    ///
    /// ```
    /// use cyclide::{Frame, Point2, Vec2, surface::{Torus, TorusSpline}};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let places = [[0.0, 0.4], [0.5, 0.0], [0.0, -0.4], [-0.5, 0.0]].map(Point2::from); // clockwise, on the outer side
    /// let rates = [[0.7, 0.0], [0.0, -0.6], [-0.7, 0.0], [0.0, 0.6]].map(|[a, b]| Vec2::new(a, b));
    /// let ring = TorusSpline::two_type_loop(&torus, &places, &rates)?;
    /// assert_eq!((ring.pieces().len(), ring.winding()), (8, Some([0, 0])));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `too-few-points` (below 2), `count-differs`, `not-finite`, `zero-tangent`, `parameter-out-of-range` (angles above 1e6),
    /// `no-two-type-solution` with the segment: take [`through_places`](Self::through_places), which has always one.
    pub fn two_type_loop(torus: &Torus, places: &[Point2], rates: &[Vec2]) -> Result<Self> {
        let n = places.len();
        check_places(places, 2)?;
        if rates.len() != n {
            return Err(NumberError::CountDiffers { what: ErrorItem::Tangent, given: rates.len(), needed: n }.into());
        }
        rates.iter().enumerate().try_for_each(|(index, rate)| check_rate(index, *rate))?;
        let places: Vec<Point2> = places.iter().copied().map(within_a_turn).collect();
        let mut chain = TorusChain::starting_at(0.0);
        for (segment, start) in places.iter().enumerate() {
            let next = (segment + 1) % n;
            let step = shortest_step(*start, places[next]);
            let best = quarter(*start, step, [rates[segment], rates[next]], segment)?;
            let [first, second] = best.pieces();
            chain.push(first, segment as f64 + 0.5);
            chain.push(second, segment as f64 + 1.0);
            let speeds = [rates[segment], best.middle().1, rates[next], step].map(Vec2::length);
            let (least, most) =
                (speeds.into_iter().fold(f64::INFINITY, f64::min), speeds.into_iter().fold(0.0, f64::max));
            chain.end_segment(SegmentMethod::TwoTypes, least / most);
        }
        Ok(chain.into_spline(torus, true, places[0]))
    }
}

/// The quarter that stays nearest to the middle of its step.
fn quarter(start: Point2, step: Vec2, rates: [Vec2; 2], segment: usize) -> Result<TwoTypeBiarc> {
    let types = QUARTERS.map(|pair| pair.map(|[one, other]| QuarticType::between(one, other)));
    let mut best: Result<TwoTypeBiarc> = Err(TorusError::NoTwoTypeSolution { segment, cosine: f64::INFINITY }.into());
    for kinds in types {
        let [Some(first), Some(second)] = kinds else { continue };
        let found = match TwoTypeBiarc::all([first, second], start, step, rates, [0.5; 2]) {
            Ok(found) => found,
            Err(Error::Torus(TorusError::NoTwoTypeSolution { cosine, .. })) if best.is_err() && cosine.is_finite() => {
                best = Err(TorusError::NoTwoTypeSolution { segment, cosine }.into());
                continue;
            }
            Err(_) => continue,
        };
        for biarc in found {
            if best.as_ref().is_err() || best.as_ref().is_ok_and(|b| biarc.detour(step) < b.detour(step)) {
                best = Ok(biarc);
            }
        }
    }
    best
}
