//! Motions that are polynomial in the eight coefficients of a dual quaternion: every point of the body runs on a rational curve.
//!
//! A span is a Bézier curve `(p, r)` of degree n in R⁸, read along the fibers of the quadric: the rotation is `p`, the translation
//! `2 Im(r p̄)/|p|²`. In homogeneous coordinates a point x of the body is at `[2 Im(r p̄) + p x p̄, |p|²]`, of degree 2n
//! (`docs/math/motions.md#fiber-projection`).

use super::decoupled::angular_jet;
use super::dual_quat::DualQuat;
use super::leaves_chords::LeavesChords;
use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::span_of;
use super::study_form::ROUNDED;
use super::swings::Swings;
use super::timed_pose::HalfTurns;
use crate::base::bernstein;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial, jet_of_homogeneous};
use crate::warning::{MotionWarning, Warning};

/// A span is halved so often at most until its weights are good; `|p|²` is nowhere zero, so a few halvings do.
const HALVINGS: u32 = 60;

/// A motion over rising times, in spans each of which is polynomial in the coefficients of a dual quaternion.
///
/// Made by [`conic`](Self::conic), [`quartic`](Self::quartic), [`spline`](Self::spline), [`CubicMotions`](crate::motion::CubicMotions).
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{Pose, RationalMotion, TimedPose}};
/// let at = |time: f64, z: f64| TimedPose {
///     time,
///     pose: Pose::new(Quat::new(1.0, 0.0, 0.0, time), Vec3::new(time, 0.0, z)).unwrap(),
/// };
/// let motion = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 2.0), at(3.0, 1.0)])?;
/// assert!((motion.pose(1.0).translation() - Vec3::new(1.0, 0.0, 2.0)).length() < 1e-15);
/// let path = motion.trajectory(Point3::new(0.0, 5.0, 0.0))?; // exact
/// assert_eq!((path.degree(), path.span_count()), (6, 2));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalMotion {
    /// Rising, one more than spans.
    times: Vec<f64>,
    spans: Vec<MotionSpan>,
    /// What the translations are relative to.
    centre: Vec3,
    /// What the dual parts are multiplied by.
    unit: f64,
    /// What its poses are off, in their size, to be of the kind that they were taken for; 0 if nothing was left out.
    left_out: f64,
    /// When it takes the poses that it was made through, rising.
    pose_times: Vec<f64>,
    /// Of a spline through poses: where it runs beyond them.
    swings: Option<Swings>,
    /// Of a spline through poses: where its turns carry it away from the chords.
    leaves_chords: Option<LeavesChords>,
    /// Poses to which both ways round are as short, where the sign of a rotation decides.
    half_turns: Option<HalfTurns>,
}

/// The Bernstein coefficients of one span: real part, then dual part.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MotionSpan(pub(super) Vec<[f64; 8]>);

impl RationalMotion {
    /// The motion of these spans, about a center and in a unit. Real parts vanish nowhere.
    pub(super) fn of_spans(times: Vec<f64>, spans: Vec<MotionSpan>, centre: Vec3, unit: f64) -> Self {
        Self {
            times,
            spans,
            centre,
            unit,
            left_out: 0.0,
            pose_times: Vec::new(),
            swings: None,
            leaves_chords: None,
            half_turns: None,
        }
    }

    /// The same, made through poses at these times.
    pub(super) fn through(self, mut pose_times: Vec<f64>) -> Self {
        pose_times.sort_by(f64::total_cmp);
        Self { pose_times, ..self }
    }

    /// The same, a spline that swings there and leaves its chords there.
    pub(super) fn swinging(self, swings: Option<Swings>, leaves_chords: Option<LeavesChords>) -> Self {
        Self { swings, leaves_chords, ..self }
    }

    /// The same, where the sign of a rotation decides which way round the body goes.
    pub(super) fn half_turning(self, half_turns: Option<HalfTurns>) -> Self {
        Self { half_turns, ..self }
    }

    /// The same, with what was left out of the poses for rounding.
    pub(super) fn leaving_out(self, off: f64) -> Self {
        Self { left_out: off, ..self }
    }

    /// What should be known of it: that its poses are planar, spherical, translated or of one motion of degree 2 but for the digits they are
    /// written with, and were taken for that (`poses-rounded`); that a spline swings out between its poses (`motion-swings`) or is carried away from the
    /// straight lines between them by its turns (`leaves-chords`); or that a pose is half a
    /// turn away from the one before, and the sign of its rotation decides (`half-turn`).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let rounded = (self.left_out > 0.0)
            .then_some(Warning::Motion(MotionWarning::PosesRounded { off: self.left_out, limit: ROUNDED }));
        let half_turns = self.half_turns.map(HalfTurns::warning);
        let leaves = self.leaves_chords.map(LeavesChords::warning);
        rounded.into_iter().chain(self.swings.map(Swings::warning)).chain(leaves).chain(half_turns).collect()
    }

    /// The times at which spans start, and the end.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The times at which it takes the poses that it was made through, rising: those given, but for the two in the middle of a cubic. None along a
    /// curve.
    #[must_use]
    pub fn pose_times(&self) -> &[f64] {
        &self.pose_times
    }

    /// Degree of the dual quaternion; trajectories have twice that.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.spans.iter().map(|span| span.0.len() - 1).max().unwrap_or(0)
    }

    /// The dual quaternion at a time, clamped to those of the motion: of any length, and on the fiber of the displacement.
    #[must_use]
    pub fn dual_quat(&self, time: f64) -> DualQuat {
        let (span, s) = self.place_of(time);
        let at = DualQuat::from_array(bernstein::eval(&self.spans[span].0, s));
        let dual = at.dual * self.unit + Quat::from(self.centre * 0.5) * at.real;
        DualQuat { real: at.real, dual }
    }

    /// The pose at a time, clamped to those of the motion.
    #[must_use]
    pub fn pose(&self, time: f64) -> Pose {
        let (span, s) = self.place_of(time);
        self.span_pose(span, s)
    }

    fn span_pose(&self, span: usize, s: f64) -> Pose {
        let at = DualQuat::from_array(bernstein::eval(&self.spans[span].0, s));
        let length = at.real.norm();
        // The unit of the quaternion divides both: |p|² may be tiny.
        let p = at.real * (1.0 / length);
        let translation = (at.dual * (1.0 / length) * p.conj()).vector() * (2.0 * self.unit);
        Pose::of_unit(p, translation + self.centre)
    }

    /// What the body and one of its points do at a time. At a joint, on the span that starts there.
    #[must_use]
    pub fn jet(&self, time: f64, point: Point3) -> MotionJet {
        self.jet_in_span(span_of(&self.times, time), time, point)
    }

    /// The same on a span that the time is in or at an end of.
    pub(super) fn jet_in_span(&self, span: usize, time: f64, point: Point3) -> MotionJet {
        let s = self.place_in_span(span, time);
        let duration = self.times[span + 1] - self.times[span];
        let rows: [[f64; 8]; 4] = bernstein::derivatives(&self.spans[span].0, s);
        let at = rows.map(DualQuat::from_array);
        let p = at.map(|d| d.real);
        let scale = 1.0 / p[0].norm();
        let p = p.map(|q| q * scale);
        let r = at.map(|d| d.dual * scale);
        let x = Quat::from(point);
        let moved = p.map(|q| q * x);
        let homogeneous: [[f64; 4]; 4] = std::array::from_fn(|k| {
            let translation = leibniz(&r, &p, k).vector() * (2.0 * self.unit);
            let way = translation + leibniz(&moved, &p, k).vector();
            [way.x, way.y, way.z, leibniz(&p, &p, k).w]
        });
        let mut jet = jet_of_homogeneous(homogeneous).scaled(1.0 / duration);
        jet.point += self.centre;
        // p has length 1 here.
        let [omega, alpha, beta] = angular_jet(p);
        MotionJet {
            pose: self.span_pose(span, s),
            point: jet,
            angular_velocity: omega / duration,
            angular_acceleration: alpha / (duration * duration),
            angular_jerk: beta / duration.powi(3),
        }
    }

    /// Velocity of a point of the body, and the angular velocity: as [`jet_in_span`](Self::jet_in_span), for less.
    pub(super) fn velocities_in_span(&self, span: usize, time: f64, point: Point3) -> [Vec3; 2] {
        let s = self.place_in_span(span, time);
        let per_time = 1.0 / (self.times[span + 1] - self.times[span]);
        let rows: [[f64; 8]; 2] = bernstein::derivatives(&self.spans[span].0, s);
        let [at, by] = rows.map(DualQuat::from_array);
        let scale = 1.0 / at.real.norm();
        let back = at.real.conj() * scale;
        // With |p| = 1: ω = 2 Im q of q = p' p̄, and (r p⁻¹)' = r' p̄ − r p̄ q.
        let q = by.real * back * scale;
        let slide = by.dual * back * scale - at.dual * back * scale * q;
        let omega = q.vector() * (2.0 * per_time);
        let arm = (at.real * scale).rotate(point.to_vec());
        [slide.vector() * (2.0 * self.unit * per_time) + omega.cross(arm), omega]
    }

    fn place_of(&self, time: f64) -> (usize, f64) {
        let span = span_of(&self.times, time);
        (span, self.place_in_span(span, time))
    }

    fn place_in_span(&self, span: usize, time: f64) -> f64 {
        let [from, to] = [self.times[span], self.times[span + 1]];
        ((time - from) / (to - from)).clamp(0.0, 1.0)
    }

    /// The same motion with spans cut where `|p|²` has Bernstein coefficients that are no [weights](bernstein::are_weights): then every curve and surface made of
    /// a span has positive weights, if what is moved has.
    #[must_use]
    pub(crate) fn with_positive_weights(&self) -> Self {
        let (mut times, mut spans) = (vec![self.times[0]], Vec::new());
        for (span, ends) in self.spans.iter().zip(self.times.windows(2)) {
            span.positive_parts([ends[0], ends[1]], HALVINGS, &mut |part, end| {
                spans.push(part);
                times.push(end);
            });
        }
        Self { times, spans, pose_times: self.pose_times.clone(), ..*self }
    }

    /// The same motion without the spans at rest, at times that are as much shorter: for what it runs over, a rest is nothing. One that rests all along
    /// is itself.
    #[must_use]
    pub(crate) fn without_rests(&self) -> Self {
        let resting = self.spans.iter().filter(|span| span.rests()).count();
        if resting == 0 || resting == self.spans.len() {
            return self.clone();
        }
        let (mut times, mut spans) = (vec![self.times[0]], Vec::new());
        let mut end = self.times[0];
        for (span, ends) in self.spans.iter().zip(self.times.windows(2)).filter(|(span, _)| !span.rests()) {
            end += ends[1] - ends[0];
            times.push(end);
            spans.push(span.clone());
        }
        Self { times, spans, pose_times: Vec::new(), ..*self }
    }

    /// Over each span the homogeneous path, of twice the degree, of a point of the body in homogeneous coordinates `[wx, wy, wz, w]`.
    pub(crate) fn homogeneous_paths(&self, row: [f64; 4]) -> impl Iterator<Item = PolynomialRow> {
        self.homogeneous_paths_about_centre(row).map(|path| path.moved(self.centre))
    }

    /// What the motion is about: the paths of points near the body's origin are near it.
    pub(super) fn centre(&self) -> Vec3 {
        self.centre
    }

    /// As [`homogeneous_paths`](Self::homogeneous_paths), in coordinates from the [center](Self::centre): a product with it would cost, far from
    /// the origin, the digits that a weight is smaller than the squares it is summed of.
    pub(super) fn homogeneous_paths_about_centre(&self, [x, y, z, w]: [f64; 4]) -> impl Iterator<Item = PolynomialRow> {
        let point = QuatPolynomial::constant(Quat::new(0.0, x, y, z));
        self.spans.iter().map(move |span| {
            let column = |d: usize| Polynomial::new(span.0.iter().map(|row| row[d]).collect());
            let p = QuatPolynomial(std::array::from_fn(column));
            let r = QuatPolynomial(std::array::from_fn(|d| &column(d + 4) * (2.0 * self.unit * w)));
            let moved = &r + &(&p * &point);
            let QuatPolynomial([_, x, y, z]) = &moved * &p.conj();
            PolynomialRow([x, y, z, &p.dot(&p) * w])
        })
    }
}

impl MotionSpan {
    /// Whether the body stands still, to the bit: a spline makes such spans between poses that are the same.
    fn rests(&self) -> bool {
        self.0.windows(2).all(|pair| (0..8).all(|k| (pair[1][k] - pair[0][k]).abs() <= 0.0))
    }

    /// Hands on the parts of a span over which the coefficients of `|p|²` are good weights, each with the time of its end.
    fn positive_parts(&self, [from, to]: [f64; 2], halvings: u32, take: &mut impl FnMut(Self, f64)) {
        let column = |d: usize| Polynomial::new(self.0.iter().map(|row| row[d]).collect());
        let p = QuatPolynomial(std::array::from_fn(column));
        let middle = 0.5 * (from + to);
        if halvings == 0 || !(middle > from && middle < to) || bernstein::are_weights(p.dot(&p).coefficients()) {
            return take(self.clone(), to);
        }
        let (left, right) = bernstein::split(&self.0, 0.5);
        Self(left).positive_parts([from, middle], halvings - 1, take);
        Self(right).positive_parts([middle, to], halvings - 1, take);
    }
}

/// The derivative of order `k` of `a b̄`.
fn leibniz(a: &[Quat; 4], b: &[Quat; 4], k: usize) -> Quat {
    const BINOMIALS: [[f64; 4]; 4] =
        [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];
    (0..=k).fold(Quat::ZERO, |sum, j| sum + a[j] * b[k - j].conj() * BINOMIALS[k][j])
}
