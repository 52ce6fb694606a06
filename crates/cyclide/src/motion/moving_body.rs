//! A body on its way: a motion with a point of the body, a time law and a duration.

use super::any_motion::Motion;
use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::pose_times::PoseTimes;
use super::reversals::MotionReversal;
use super::span_cells::KnownCells;
use super::speed_peak::{FastTurn, SpeedPeak};
use super::timing::{TimeLaw, Timing};
use crate::base::jet::CurveJet;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, MeshError, NumberError, Result};
use crate::warning::{MotionWarning, SpikeRemedy, Warning};

/// How long a motion may take: the cube of it divides a jerk.
const DURATIONS: [f64; 2] = [1e-90, 1e90];
/// A body that gets so many times as fast as on average over the same span is told of.
const PEAK: f64 = 30.0;

/// A moving body: what a motion is with a tool, a time law and a duration.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimeLaw, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let slide = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 8.0)])?;
/// let body = MovingBody::new(slide.into()).with_law(TimeLaw::Eased, 2.0)?;
/// let half_way = body.schedule()?.jet(0.5);
/// assert!((half_way.point.point.x - 4.0).abs() < 1e-9);
/// assert!((half_way.point.speed() - 8.0 * 1.875 / 2.0).abs() < 1e-9); // the law is 15/8 as fast in the middle
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MovingBody {
    motion: Motion,
    tool: Point3,
    arm: f64,
    law: TimeLaw,
    duration: f64,
    pose_times: PoseTimes,
    mesh: Option<BodyMesh>,
    cells: KnownCells,
}

/// The shape of a moving body for files that animate: triangles in the frame of the body.
///
/// ```
/// use cyclide::{Point3, motion::BodyMesh};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from).to_vec();
/// let mesh = BodyMesh::new(points, vec![[0, 1, 2]])?;
/// assert_eq!(mesh.triangles().len(), 1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BodyMesh {
    points: Vec<Point3>,
    triangles: Vec<[usize; 3]>,
}

impl BodyMesh {
    /// Triangles between points.
    ///
    /// # Errors
    /// `no-triangles`, `not-finite`, `no-such-vertex`.
    pub fn new(points: Vec<Point3>, triangles: Vec<[usize; 3]>) -> Result<Self> {
        if triangles.is_empty() {
            return Err(MeshError::NoTriangles { vertices: points.len(), needed: 1 }.into());
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Vertex, index }.into());
        }
        let count = points.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(vertex) = corners.iter().copied().find(|corner| *corner >= count) {
                return Err(MeshError::NoSuchVertex { triangle, vertex, count }.into());
            }
        }
        Ok(Self { points, triangles })
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// The triangles, as indices of points.
    #[must_use]
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }
}

impl MovingBody {
    /// A body that moves by the times of its motion, its origin the tool.
    #[must_use]
    pub fn new(motion: Motion) -> Self {
        let [first, last] = motion.domain();
        Self {
            motion,
            tool: Point3::ORIGIN,
            arm: 0.0,
            law: TimeLaw::AsGiven,
            duration: last - first,
            pose_times: PoseTimes::Uniform,
            mesh: None,
            cells: KnownCells::default(),
        }
    }

    /// With a point of the body that is measured, and the arm by which turns count beside its way (see [`Timing`]).
    ///
    /// # Errors
    /// As [`Timing::new`].
    pub fn with_tool(self, tool: Point3, arm: f64) -> Result<Self> {
        Self { tool, arm, cells: KnownCells::default(), ..self }.checked()
    }

    /// With a time law, and how long the motion takes.
    ///
    /// # Errors
    /// `parameter-out-of-range` (a duration that is not positive, or beyond 1e-90 to 1e90, where a jerk is no number); as [`Timing::new`].
    pub fn with_law(self, law: TimeLaw, duration: f64) -> Result<Self> {
        let [least, most] = DURATIONS;
        if !(duration > least && duration < most) {
            // What is no duration at all is told so.
            let [min, max] = if duration > 0.0 { DURATIONS } else { [0.0, f64::MAX] };
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Duration, value: duration, min, max }.into()
            );
        }
        Self { law, duration, cells: KnownCells::default(), ..self }.checked()
    }

    /// With the rule that the times of its poses are from, for reports.
    #[must_use]
    pub fn with_pose_times(self, pose_times: PoseTimes) -> Self {
        Self { pose_times, ..self }
    }

    /// The rule that the times of its poses are from; uniform also where they were given.
    #[must_use]
    pub fn pose_times(&self) -> PoseTimes {
        self.pose_times
    }

    /// With its shape, for files that animate.
    #[must_use]
    pub fn with_mesh(self, mesh: BodyMesh) -> Self {
        Self { mesh: Some(mesh), ..self }
    }

    fn checked(self) -> Result<Self> {
        self.schedule()?;
        Ok(self)
    }

    /// The motion.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The point of the body that is measured.
    #[must_use]
    pub fn tool(&self) -> Point3 {
        self.tool
    }

    /// How it runs along its motion.
    #[must_use]
    pub fn law(&self) -> TimeLaw {
        self.law
    }

    /// How long it takes.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Its shape, if it was given one.
    #[must_use]
    pub fn mesh(&self) -> Option<&BodyMesh> {
        self.mesh.as_ref()
    }

    /// The arm by which turns count beside the way of the tool.
    #[must_use]
    pub fn arm(&self) -> f64 {
        self.arm
    }

    /// What should be known of it: of its [motion](Motion::warnings); where it gets more than 30 times as fast as on average over the same span
    /// (`speed-spike`); and under a law that goes by the way rests that it has no time for (`rests-passed-over`), spans on which the body turns more
    /// than 30 times as fast as on average (`turns-nearly-in-place`), and where the way turns back (`motion-reverses`).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.motion.warnings();
        let Ok(schedule) = self.schedule() else { return warnings };
        if self.law != TimeLaw::AsGiven
            && let [span, ..] = *schedule.timing.at_rest()
        {
            warnings
                .push(Warning::Motion(MotionWarning::RestsPassedOver { span, count: schedule.timing.at_rest().len() }));
        }
        let spans = schedule.span_cells();
        let turn = schedule.fastest_turn(spans).filter(|turn| turn.ratio > PEAK);
        let peak = schedule.speed_peak(spans).filter(|peak| peak.ratio > PEAK);
        // A span that is fast all over has been named.
        let named = |peak: &SpeedPeak| turn.is_some_and(|turn| turn.span == peak.span && peak.turning);
        if let Some(SpeedPeak { span, time, ratio, turning }) = peak.filter(|peak| !named(peak)) {
            let remedy = self.spike_remedy(turning);
            warnings.push(Warning::Motion(MotionWarning::SpeedSpike {
                span,
                time,
                ratio,
                turning,
                limit: PEAK,
                remedy,
            }));
        }
        if let Some(FastTurn { span, turn, seconds, ratio }) = turn {
            warnings.push(Warning::Motion(MotionWarning::TurnsNearlyInPlace {
                span,
                turn,
                seconds,
                ratio,
                limit: PEAK,
            }));
        }
        let reversals = schedule.reversals();
        if let Some(&MotionReversal { span, time, velocity_jump, .. }) = reversals.first() {
            warnings.push(Warning::Motion(MotionWarning::Reverses {
                span,
                time,
                count: reversals.len(),
                velocity_jump,
            }));
        }
        warnings
    }

    /// What helps where it gets very fast.
    fn spike_remedy(&self, turning: bool) -> SpikeRemedy {
        match (self.law, &self.motion) {
            (TimeLaw::AsGiven, Motion::Rational(motion)) if motion.pose_times().is_empty() => SpikeRemedy::Law,
            (TimeLaw::AsGiven, Motion::Rational(motion)) if motion.times().len() < motion.pose_times().len() => {
                SpikeRemedy::Spline
            }
            (TimeLaw::AsGiven, _) => SpikeRemedy::Times,
            _ if turning => SpikeRemedy::LargerArm,
            _ => SpikeRemedy::SmallerArm,
        }
    }

    /// The way measured, for poses at times.
    ///
    /// # Errors
    /// As [`Timing::new`].
    pub fn schedule(&self) -> Result<Schedule<'_>> {
        let timing = Timing::new(&self.motion, self.law, self.tool, self.arm)?;
        Ok(Schedule { body: self, timing })
    }
}

impl From<Motion> for MovingBody {
    fn from(motion: Motion) -> Self {
        Self::new(motion)
    }
}

/// A moving body with its way measured.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let body = MovingBody::new(RationalMotion::spline(&[at(0.0, 0.0), at(4.0, 8.0)])?.into());
/// assert_eq!(body.schedule()?.pose(0.5).translation(), Vec3::X * 4.0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug)]
pub struct Schedule<'a> {
    body: &'a MovingBody,
    timing: Timing<'a>,
}

impl Schedule<'_> {
    /// Length of the way, with turns counted by the arm.
    #[must_use]
    pub fn way(&self) -> f64 {
        self.timing.way()
    }

    /// The law with the way measured.
    #[must_use]
    pub fn timing(&self) -> &Timing<'_> {
        &self.timing
    }

    /// The pose when the part `fraction` of the duration is over.
    #[must_use]
    pub fn pose(&self, fraction: f64) -> Pose {
        self.body.motion.pose(self.timing.time_at(fraction))
    }

    /// What the body and its tool do then, by the time that the body takes; at a joint, on the span that starts there. Not finite where a law
    /// goes by a way that stands still.
    #[must_use]
    pub fn jet(&self, fraction: f64) -> MotionJet {
        let own = self.body.motion.jet(self.timing.time_at(fraction), self.body.tool);
        by_rates(own, self.rates(&own, fraction))
    }

    /// As [`jet`](Self::jet) on a span of the motion, of which the part is one of those from where it starts to where it ends: at its end as the
    /// body arrives there.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, ScrewMotion, TimedPose}};
    /// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
    /// let body = MovingBody::new(ScrewMotion::new(&[at(0.0, 0.0), at(1.0, 8.0), at(4.0, 2.0)])?.into());
    /// let schedule = body.schedule()?;
    /// assert_eq!(schedule.timing().joints(), [0.0, 0.25, 1.0]);
    /// let [arrives, leaves] = [0, 1].map(|span| schedule.jet_in_span(span, 0.25).point.d1.x);
    /// assert!((arrives - 8.0).abs() < 1e-14 && (leaves + 2.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Panics
    /// If there is no such span.
    #[must_use]
    pub fn jet_in_span(&self, span: usize, fraction: f64) -> MotionJet {
        let own = self.own_jet(span, fraction);
        by_rates(own, self.rates(&own, fraction))
    }

    /// What the body and its tool do by the time of the motion, on a span of it.
    fn own_jet(&self, span: usize, fraction: f64) -> MotionJet {
        self.body.motion.jet_in_span(span, self.timing.time_at(fraction), self.body.tool)
    }

    /// As [`jet_in_span`](Self::jet_in_span), with the lengths of the terms that acceleration and jerk of the tool are summed of.
    pub(super) fn jet_with_terms(&self, span: usize, fraction: f64) -> (MotionJet, [f64; 2]) {
        let own = self.own_jet(span, fraction);
        let rates = self.rates(&own, fraction);
        let [d1, d2, d3] = [own.point.d1, own.point.d2, own.point.d3].map(Vec3::length);
        let [u1, u2, u3] = rates;
        let first = d2 * u1 * u1 + d1 * u2.abs();
        let second = d3 * u1.abs().powi(3) + 3.0 * d2 * (u1 * u2).abs() + d1 * u3.abs();
        (by_rates(own, rates), [first, second])
    }

    /// How long the body takes.
    pub(super) fn duration(&self) -> f64 {
        self.body.duration
    }

    /// What is known of the cells of the body.
    pub(super) fn known_cells(&self) -> &KnownCells {
        &self.body.cells
    }

    /// The motion that it runs along.
    pub(super) fn motion(&self) -> &Motion {
        &self.body.motion
    }

    /// The point that is measured.
    pub(super) fn tool(&self) -> Point3 {
        self.body.tool
    }

    /// The derivatives of the motion's time by the body's.
    fn rates(&self, own: &MotionJet, fraction: f64) -> [f64; 3] {
        let [first, last] = self.body.motion.domain();
        match self.body.law {
            TimeLaw::AsGiven => [(last - first) / self.body.duration, 0.0, 0.0],
            TimeLaw::ConstantSpeed => self.rates_by_way(own, [1.0, 0.0, 0.0]),
            TimeLaw::Eased => {
                let x = fraction.clamp(0.0, 1.0);
                let first = 30.0 * x * x * (1.0 - x) * (1.0 - x);
                let second = 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x);
                let third = 60.0 * (1.0 - 6.0 * x * (1.0 - x));
                self.rates_by_way(own, [first, second, third])
            }
        }
    }

    /// They, from the derivatives of the part of the way that is done: with the speed `g` of the way, `g² = |v|² + a²|ω|²` has the derivatives
    /// `2 g g'` and `2 (g'² + g g″)`.
    fn rates_by_way(&self, own: &MotionJet, law: [f64; 3]) -> [f64; 3] {
        let MovingBody { arm, duration, .. } = self.body;
        let [s1, s2, s3] = [1, 2, 3].map(|k| law[k as usize - 1] * self.way() / duration.powi(k));
        let CurveJet { d1, d2, d3, .. } = own.point;
        let turns = [own.angular_velocity, own.angular_acceleration, own.angular_jerk];
        let [omega, alpha, beta] = turns.map(|v| v * *arm);
        let g = d1.length().hypot(omega.length());
        let g1 = (d1.dot(d2) + omega.dot(alpha)) / g;
        let second = d2.dot(d2) + d1.dot(d3) + alpha.dot(alpha) + omega.dot(beta);
        let g2 = (second - g1 * g1) / g;
        let u1 = s1 / g;
        let u2 = (s2 - g1 * u1 * u1) / g;
        let u3 = (s3 - g2 * u1 * u1 * u1 - 3.0 * g1 * u1 * u2) / g;
        [u1, u2, u3]
    }
}

/// A jet by another time, of which the own one has these derivatives.
fn by_rates(own: MotionJet, [u1, u2, u3]: [f64; 3]) -> MotionJet {
    let CurveJet { point, d1, d2, d3 } = own.point;
    let (omega, alpha, beta) = (own.angular_velocity, own.angular_acceleration, own.angular_jerk);
    MotionJet {
        pose: own.pose,
        point: CurveJet {
            point,
            d1: d1 * u1,
            d2: d2 * (u1 * u1) + d1 * u2,
            d3: d3 * (u1 * u1 * u1) + d2 * (3.0 * u1 * u2) + d1 * u3,
        },
        angular_velocity: omega * u1,
        angular_acceleration: alpha * (u1 * u1) + omega * u2,
        angular_jerk: beta * (u1 * u1 * u1) + alpha * (3.0 * u1 * u2) + omega * u3,
    }
}
