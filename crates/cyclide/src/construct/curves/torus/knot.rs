//! Torus knots: closed curves that run evenly round the axis and round the tube.
//!
//! In the plane of the torus they are straight lines, which cross all parallels at one angle. A piece whose coordinates run along chords of the unit circle, from `1` to
//! `e^(iD)`, has the same speed at both ends, so that equal pieces join C1; all pieces of a knot are one piece turned
//! (`docs/math/torus-splines.md#torus-knots`).

use super::projective_biarc::within;
use super::spline_data::check_angles;
use crate::base::complex::Complex;
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, Result, TorusError};
use crate::surface::{
    CircleFamily, Course, QuarticType, SegmentMethod, Torus, TorusChain, TorusPiece, TorusSpline, within_a_turn,
};
use std::f64::consts::PI;

/// Largest step of a coordinate over one piece, radians: the speed varies by 6 % over it.
const STEP: f64 = 0.5;

/// The angle at which the curve crosses parallels changes by no more, radians.
const WOBBLE: f64 = 4e-3;

/// Rounds in which pieces become more; one or two are needed.
const ROUNDS: usize = 30;

/// Most turns of either kind.
const MOST_TURNS: u32 = 10_000;

impl TorusSpline {
    /// The closed curve that runs `turns[0]` times round the axis and `turns[1]` times round the tube, evenly, from a place: a torus
    /// knot, C1, of equal quartic pieces exactly on the torus. `[±1, 0]`, `[0, ±1]` and `[±1, ±1]` are circles.
    ///
    /// ```
    /// use cyclide::{Frame, surface::{Torus, TorusSpline}};
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
        let Even { kind, pieces: n } = Even::best(torus, whole);
        let step = whole * (1.0 / n);
        let course = |step: f64| {
            if step == 0.0 { Course::STILL } else { Course { step, ratio: Complex::at_angle(step) } }
        };
        let courses = kind.local(step).map(course);
        let rate = kind.back(courses.map(|c| c.ratio.im));
        let quality = super::spline_span::quality(kind, step, [rate; 2], 1.0);
        let start = within_a_turn(start);
        // Half turns are left out as whole numbers, so that the last piece of a long knot has the digits of the first.
        let half_turns = |turns: i32, i: u32| (i64::from(turns) * i64::from(i) % n as i64) as f64 / n;
        let mut chain = TorusChain::starting_at(0.0);
        for i in 0..n as u32 {
            let place = start + Vec2::new(PI * half_turns(turns[0], i), PI * half_turns(turns[1], i));
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
    /// use cyclide::{Frame, curve::length, surface::{CircleFamily, Torus, TorusSpline}};
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

/// A type, and how many equal pieces of it run evenly enough.
struct Even {
    kind: QuarticType,
    pieces: f64,
}

impl Even {
    /// An arc of a circle where a coordinate stands still; else the type that needs the fewest pieces, of these the one that wobbles less.
    fn best(torus: &Torus, whole: Vec2) -> Self {
        let rated = QuarticType::ALL.map(|kind| {
            let stands = kind.local(whole).contains(&0.0);
            let pieces = Self::pieces(torus, kind, whole);
            (!stands, pieces, wobble(torus, kind, whole * (1.0 / pieces)), Self { kind, pieces })
        });
        let [first, rest @ ..] = rated;
        let better = |a: &(bool, f64, f64, Self), b: &(bool, f64, f64, Self)| {
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2)).is_lt()
        };
        rest.into_iter().fold(first, |best, next| if better(&next, &best) { next } else { best }).3
    }

    /// The least number of pieces of a type, nearly: the wobble is as the square of the step.
    fn pieces(torus: &Torus, kind: QuarticType, whole: Vec2) -> f64 {
        let largest = kind.local(whole).into_iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let mut pieces = (largest / STEP).ceil();
        for _ in 0..ROUNDS {
            let wobble = wobble(torus, kind, whole * (1.0 / pieces));
            if wobble <= WOBBLE {
                break;
            }
            pieces = (pieces * (wobble / WOBBLE).sqrt()).ceil().max(pieces + 1.0);
        }
        pieces
    }
}

/// How far the directions at the ends and in the middle of a piece are apart on the torus, where the curve turns to one side and back: its coordinates have the
/// speeds `sin D` there, and `2 tan D/2` here.
fn wobble(torus: &Torus, kind: QuarticType, step: Vec2) -> f64 {
    let local = kind.local(step);
    let (a, b) = (torus.major_radius(), torus.minor_radius());
    let upright = b / ((a - b) * (a + b)).sqrt();
    let on_torus = |rate: Vec2| Vec2::new(rate.x, rate.y * upright);
    let end = on_torus(kind.back(local.map(f64::sin)));
    let middle = on_torus(kind.back(local.map(|d| 2.0 * (0.5 * d).tan())));
    end.cross(middle).atan2(end.dot(middle)).abs()
}

fn check(turns: [i32; 2], start: Point2) -> Result<()> {
    check_angles(0, start)?;
    let [p, q] = turns.map(i32::unsigned_abs);
    within(ErrorItem::Winding, f64::from(p.max(q)), [0.0, f64::from(MOST_TURNS)])?;
    let divisor = greatest_common_divisor(p, q);
    if divisor == 1 { Ok(()) } else { Err(TorusError::NotCoprime { turns, divisor }.into()) }
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
