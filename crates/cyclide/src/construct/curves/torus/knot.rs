//! Torus knots: closed curves that run evenly round the axis and round the tube.
//!
//! In the plane of the torus they are straight lines. A piece whose coordinates run along chords of the unit circle, from `1` to
//! `e^(iD)`, has the same speed at both ends, so that equal pieces join C1; all pieces of a knot are one piece turned
//! (`docs/math/torus-splines.md#torus-knots`).

use super::projective_biarc::within;
use super::spline_data::check_angles;
use super::spline_span::best_type;
use crate::base::complex::Complex;
use crate::base::planar::{Point2, Vec2};
use crate::error::{Error, ErrorItem, Result};
use crate::surface::{CircleFamily, Course, SegmentMethod, Torus, TorusChain, TorusPiece, TorusSpline};
use std::f64::consts::PI;

/// Largest step of a coordinate over one piece, radians: the speed varies by 6 % over it, and the curve is off the straight line in
/// its plane by less than 2e-3 radians.
const STEP: f64 = 0.5;

/// Most turns of either kind.
const MOST_TURNS: u32 = 10_000;

impl TorusSpline {
    /// The closed curve that runs `turns[0]` times round the axis and `turns[1]` times round the tube, evenly, from a place: a torus
    /// knot, C1, of equal quartic pieces exactly on the torus. `[±1, 0]`, `[0, ±1]` and `[±1, ±1]` are circles.
    ///
    /// ```
    /// use cyclide::{Frame, Torus, TorusSpline};
    /// let trefoil = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
    /// assert_eq!(trefoil.winding(), Some([2, 3]));
    /// assert!(trefoil.to_nurbs()?.weights().iter().all(|w| *w > 0.0));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-coprime` (also `[0, 0]` and several turns of one kind alone), `not-finite`, `parameter-out-of-range` (more than 10,000
    /// turns, angles above 1e6).
    pub fn knot(torus: &Torus, turns: [i32; 2], start: Point2) -> Result<Self> {
        check(turns, start)?;
        let whole = Vec2::new(PI * f64::from(turns[0]), PI * f64::from(turns[1]));
        // The type does not depend on the length of the step, as long as it is short.
        let small = whole * (0.1 / whole.length());
        let (kind, _) = best_type(small, [small; 2]).ok_or(Error::NotCoprime { turns, divisor: 0 })?;
        let largest = kind.local(whole).into_iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let n = (largest / STEP).ceil();
        let step = whole * (1.0 / n);
        let course = |step: f64| {
            if step == 0.0 { Course::STILL } else { Course { step, ratio: Complex::at_angle(step) } }
        };
        let courses = kind.local(step).map(course);
        let rate = kind.back(courses.map(|c| c.ratio.im));
        let quality = super::spline_span::quality(kind, step, [rate; 2], 1.0);
        let mut chain = TorusChain::starting_at(0.0);
        for i in 0..n as u32 {
            let place = start + whole * (f64::from(i) / n);
            chain.push(TorusPiece::new(kind, place, courses), f64::from(i + 1));
            chain.end_segment(SegmentMethod::Direct, quality);
        }
        Ok(chain.into_spline(torus, true, start))
    }
}

impl TorusSpline {
    /// The circle of a family through a place as a spline of arcs, from there and to there; along Villarceau circles the longitude
    /// rises.
    ///
    /// ```
    /// use cyclide::{CircleFamily, Frame, Torus, TorusSpline, length};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let round = TorusSpline::circle(&torus, CircleFamily::Villarceau, Default::default())?;
    /// assert!((length(&round) - 6.0 * std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (angles above 1e6).
    pub fn circle(torus: &Torus, family: CircleFamily, place: Point2) -> Result<Self> {
        let turns = match family {
            CircleFamily::Parallel => [1, 0],
            CircleFamily::Villarceau => [1, 1],
            CircleFamily::MirrorVillarceau => [1, -1],
            CircleFamily::Meridian => [0, 1],
        };
        Self::knot(torus, turns, place)
    }
}

fn check(turns: [i32; 2], start: Point2) -> Result<()> {
    check_angles(0, start)?;
    let [p, q] = turns.map(i32::unsigned_abs);
    within(ErrorItem::Winding, f64::from(p.max(q)), [0.0, f64::from(MOST_TURNS)])?;
    let divisor = greatest_common_divisor(p, q);
    if divisor == 1 { Ok(()) } else { Err(Error::NotCoprime { turns, divisor }) }
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
