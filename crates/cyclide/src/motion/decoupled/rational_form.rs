//! Motions as ones whose points run on rational curves: exact where place and turn are polynomials, else within a bound.
//!
//! A turn of constant speed about an axis `l` is no rational function of time. On a part that is turned by `4a` the quadratic quaternion with the Bézier
//! points `e^{-la}`, `a/sin a`, `e^{la}` has the right rotation and angular velocity at both ends, and between them an angle that is off by the order of `a⁵`
//! (`docs/math/motions.md#place-and-turn-apart`). The place on a curve is replaced by polynomials of degree 5 with its derivatives at both ends.

use super::DecoupledMotion;
use super::span::{PlaceSpan, TurnSpan};
use crate::base::bernstein;
use crate::base::vector::Vec3;
use crate::error::{MotionError, Result};
use crate::motion::any_motion::Motion;
use crate::motion::rational_motion::{MotionSpan, RationalMotion};
use crate::rational::{Polynomial, QuatPolynomial};
use std::borrow::Cow;

/// Quarters of the turn of a part, radians: it is off by 1e-9 at most.
const QUARTER: f64 = 0.038;
/// Places between the ends of a part of a curve at which its error is looked for.
const PLACES: u32 = 16;
/// A place on a curve is off by this part of the extent of all poses at most,
const OFF: f64 = 1e-9;
/// in so many parts of a span at most.
const MOST_PARTS: usize = 256;

/// A motion whose points run on rational curves, and how far it is from the one that it stands for.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{DecoupledMotion, Motion, Pose, TimedPose}};
/// let at = |time: f64, x: f64, turn: f64| TimedPose {
///     time,
///     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, turn), Vec3::X * x).unwrap(),
/// };
/// let motion = Motion::from(DecoupledMotion::linear(&[at(0.0, 0.0, 0.0), at(1.0, 50.0, 2.0)], None, 0.0)?);
/// let form = motion.to_rational()?;
/// assert!(form.bound(0.0) == 0.0 && form.bound(10.0) < 1e-8);
/// let path = form.motion().trajectory(Point3::new(10.0, 0.0, 0.0))?;
/// assert_eq!(path.degree(), 6);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalForm<'a> {
    motion: Cow<'a, RationalMotion>,
    place: f64,
    angle: f64,
}

impl RationalForm<'_> {
    /// The motion.
    #[must_use]
    pub fn motion(&self) -> &RationalMotion {
        &self.motion
    }

    /// How far points of the body up to so far from its origin run from where they should, as looked for at places between; 0 where it is exact.
    #[must_use]
    pub fn bound(&self, reach: f64) -> f64 {
        self.place + self.angle * reach
    }
}

impl Motion {
    /// The motion as one whose points run on rational curves, within a [bound](RationalForm::bound) where it is none.
    ///
    /// # Errors
    /// `motion-not-rational` of screws.
    pub fn to_rational(&self) -> Result<RationalForm<'_>> {
        match self {
            Self::Rational(motion) => Ok(RationalForm { motion: Cow::Borrowed(motion), place: 0.0, angle: 0.0 }),
            Self::Decoupled(motion) => Ok(motion.rational_form()),
            Self::Screw(_) => Err(MotionError::NotRational.into()),
        }
    }
}

impl DecoupledMotion {
    /// Whether points run on rational curves: no span is turned by slerp, and none is on a curve.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        let turned = |turn: &TurnSpan| matches!(turn, TurnSpan::Slerp { half_angle, .. } if *half_angle > 0.0);
        let on_curve = |place: &PlaceSpan| matches!(place, PlaceSpan::OnCurve { .. });
        !self.turns.iter().any(turned) && !self.places.iter().any(on_curve)
    }

    fn rational_form(&self) -> RationalForm<'static> {
        let count = self.pose_places.len() as f64;
        let centre = self.pose_places.iter().fold(Vec3::ZERO, |sum, place| sum + *place / count);
        let extent = self.pose_places.iter().map(|place| (*place - centre).length()).fold(0.0, f64::max);
        let unit = if extent > 0.0 { 0.5 * extent } else { 1.0 };
        let (mut times, mut spans) = (vec![self.times[0]], Vec::new());
        let (mut off_place, mut off_angle) = (0.0_f64, 0.0_f64);
        for (i, ends) in self.times.windows(2).enumerate() {
            let turn = &self.turns[i];
            let parts = turn_parts(turn).max(self.place_parts(i, OFF * extent));
            for part in 0..parts {
                let from_to = [part, part + 1].map(|k| k as f64 / parts as f64);
                let (p, angle) = quaternion(turn, from_to);
                let (place, off) = self.polynomial_place(i, from_to);
                (off_place, off_angle) = (off_place.max(off), off_angle.max(angle));
                let moved: Vec<[f64; 3]> = place.iter().map(|p| (Vec3::from(*p) - centre).to_array()).collect();
                spans.push(span(&p, &moved, unit));
                times.push(if part + 1 == parts { ends[1] } else { ends[0] + (ends[1] - ends[0]) * from_to[1] });
            }
        }
        let motion = RationalMotion::of_spans(times, spans, centre, unit);
        RationalForm { motion: Cow::Owned(motion), place: off_place, angle: off_angle }
    }

    /// Into how many parts a span is cut so that its place is a polynomial within the limit.
    fn place_parts(&self, i: usize, limit: f64) -> usize {
        let mut parts = 1;
        while let PlaceSpan::OnCurve { .. } = self.places[i]
            && parts < MOST_PARTS
        {
            let ends = |part: usize| [part, part + 1].map(|k| k as f64 / parts as f64);
            if (0..parts).all(|part| self.polynomial_place(i, ends(part)).1 <= limit) {
                break;
            }
            parts *= 2;
        }
        parts
    }

    /// Bézier points of the place over a part of a span, and how far it is off.
    fn polynomial_place(&self, i: usize, [from, to]: [f64; 2]) -> (Vec<[f64; 3]>, f64) {
        if let PlaceSpan::Polynomial(points) = &self.places[i] {
            let mut points = points.clone();
            if from > 0.0 || to < 1.0 {
                bernstein::restrict(&mut points, [from, to]);
            }
            return (points, 0.0);
        }
        let length = to - from;
        let jet = |u: f64| self.places[i].jet(u, self.curve.as_ref()).scaled(length);
        let [start, end] = [jet(from), jet(to)];
        let [a, b] = [start.point.to_vec(), end.point.to_vec()];
        let points = [
            a,
            a + start.d1 / 5.0,
            a + start.d1 * 0.4 + start.d2 / 20.0,
            b - end.d1 * 0.4 + end.d2 / 20.0,
            b - end.d1 / 5.0,
            b,
        ];
        let points: Vec<[f64; 3]> = points.map(Vec3::to_array).to_vec();
        let off = |k: u32| {
            let u = f64::from(k) / f64::from(PLACES);
            let right = self.places[i].place(from + length * u, self.curve.as_ref());
            (Vec3::from(bernstein::eval(&points, u)) - right).length()
        };
        let most = (1..PLACES).map(off).fold(0.0, f64::max);
        (points, most)
    }
}

/// Into how many parts a span is cut so that its turn is rational within 1e-9 radians.
fn turn_parts(turn: &TurnSpan) -> usize {
    match turn {
        TurnSpan::Slerp { half_angle, .. } => ((0.5 * half_angle / QUARTER).ceil() as usize).max(1),
        TurnSpan::Cubic(_) => 1,
    }
}

/// The quaternion over a part of a span as Bézier points, and how far the angle of its rotation is off.
fn quaternion(turn: &TurnSpan, [from, to]: [f64; 2]) -> (Vec<[f64; 4]>, f64) {
    match turn {
        TurnSpan::Slerp { half_angle, .. } if !(*half_angle > 0.0) => (vec![turn.rotation(0.0).to_array()], 0.0),
        TurnSpan::Slerp { half_angle, .. } => {
            let a = 0.5 * half_angle * (to - from);
            let sinc = a.sin() / a;
            let middle = turn.rotation(0.5 * (from + to)) * (1.0 / sinc);
            let points = vec![turn.rotation(from).to_array(), middle.to_array(), turn.rotation(to).to_array()];
            // The error is a(u) = c u (1 - u²)² on [-1, 1], c ~ a⁵, up to a relative a²: largest at 1/√5.
            let u = 0.2_f64.sqrt();
            let real = 0.5 * (a.cos() * (1.0 + u * u) + (1.0 - u * u) / sinc);
            (points, 2.0 * ((u * a.sin()).atan2(real) - a * u).abs())
        }
        TurnSpan::Cubic(points) => {
            let mut points = points.to_vec();
            if from > 0.0 || to < 1.0 {
                bernstein::restrict(&mut points, [from, to]);
            }
            (points, 0.0)
        }
    }
}

/// `p + ε τ p/2` with the place τ in units of `unit`.
fn span(p: &[[f64; 4]], place: &[[f64; 3]], unit: f64) -> MotionSpan {
    let column = |d: usize| Polynomial::new(p.iter().map(|row| row[d]).collect());
    let p = QuatPolynomial(std::array::from_fn(column));
    let coordinate = |d: usize| Polynomial::new(place.iter().map(|row| row[d] * (0.5 / unit)).collect());
    let half = QuatPolynomial([Polynomial::constant(0.0), coordinate(0), coordinate(1), coordinate(2)]);
    let r = &half * &p;
    let degree = r.0.iter().map(Polynomial::degree).max().unwrap_or(0);
    let raised = |q: &QuatPolynomial| q.0.each_ref().map(|column| column.elevated(degree));
    let [p, r] = [raised(&p), raised(&r)];
    let row =
        |k: usize| std::array::from_fn(|d| if d < 4 { p[d].coefficients()[k] } else { r[d - 4].coefficients()[k] });
    MotionSpan((0..=degree).map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::quat::Quat;

    #[test]
    fn quadratics_turn_as_slerp_does() {
        let ends = [Quat::ONE, Quat::from_axis_angle(Vec3::Y, 1.7)];
        let turn = TurnSpan::slerp(ends);
        let parts = turn_parts(&turn);
        for part in 0..parts {
            let [from, to] = [part, part + 1].map(|k| k as f64 / parts as f64);
            let (points, off) = quaternion(&turn, [from, to]);
            assert!(off > 0.0 && off < 1e-9, "{off}");
            for k in 0..=40 {
                let u = f64::from(k) / 40.0;
                let got = Quat::from(bernstein::eval(&points, u));
                let between = got * (1.0 / got.norm()) * turn.rotation(from + (to - from) * u).conj();
                assert!(2.0 * between.vector().length() <= 1.01 * off + 1e-15, "{part} {u}");
            }
        }
    }
}
