//! What is reported of motions.

use cyclide::{Motion, MotionJet, MovingBody, Vec3};
use serde::Serialize;

use super::RangeReport;
use super::text::{Line, plural, short};

/// Places looked at on each span.
const PLACES: usize = 128;

/// The report on a motion: measured at 129 places of each span, ends included. Lengths are in the document's units, times in
/// seconds.
///
/// ```
/// use cyclide_io::{Document, GeometryReport, ObjectReport};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let report = ObjectReport::new(&document.build()?[0], None);
/// let GeometryReport::Motion(found) = report.geometry else { unreachable!("by its type") };
/// assert!((found.length - 30.0).abs() < 1e-9 && (found.speed.max - 30.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionReport {
    /// True if points run on rational curves.
    pub rational: bool,
    /// Degree of these curves.
    pub degree: Option<usize>,
    /// Spans from pose to pose; one if it is not made of spans.
    pub spans: usize,
    /// How long it takes.
    pub duration: f64,
    /// Length of the way of the tool.
    pub length: f64,
    /// The angle by which the body turns in all, radians.
    pub turn: f64,
    /// Speed of the tool.
    pub speed: RangeReport,
    /// Angular speed, radians per second.
    pub angular_speed: RangeReport,
    /// Largest acceleration of the tool between poses.
    pub acceleration: f64,
    /// Largest jerk of the tool between poses.
    pub jerk: f64,
    /// Largest jump of the velocity of the tool from span to span: where there is one, the acceleration has no bound.
    pub velocity_jump: f64,
    /// Largest jump of the acceleration of the tool from span to span: where there is one, the jerk has no bound.
    pub acceleration_jump: f64,
    /// Largest jump of the angular velocity from span to span, radians per second.
    pub angular_velocity_jump: f64,
}

impl MotionReport {
    /// Measures a moving body.
    #[must_use]
    pub fn new(body: &MovingBody) -> Self {
        let motion = body.motion();
        let degree = match motion {
            Motion::Rational(motion) => Some(2 * motion.degree()),
            Motion::Screw(_) => None,
        };
        let spans = motion.times().len() - 1;
        let mut report = Self {
            rational: degree.is_some(),
            degree,
            spans,
            duration: body.duration(),
            length: 0.0,
            turn: 0.0,
            speed: RangeReport::EMPTY,
            angular_speed: RangeReport::EMPTY,
            acceleration: 0.0,
            jerk: 0.0,
            velocity_jump: 0.0,
            acceleration_jump: 0.0,
            angular_velocity_jump: 0.0,
        };
        // The body was measured when it was made: what it cannot be measured by was refused.
        if let Ok(schedule) = body.schedule() {
            report.measure(motion, |fraction| schedule.jet(fraction), |fraction| schedule.timing().time_at(fraction));
        }
        report
    }

    /// Measures what the body does when a part of the duration is over, and what time of the motion it is then.
    fn measure(&mut self, motion: &Motion, at: impl Fn(f64) -> MotionJet, own_time: impl Fn(f64) -> f64) {
        let count = PLACES * self.spans;
        let step = self.duration / count as f64;
        let mut before: Option<MotionJet> = None;
        for k in 0..=count {
            let jet = at(k as f64 / count as f64);
            let (speed, turning) = (jet.point.speed(), jet.angular_velocity.length());
            self.speed = self.speed.with(speed, speed);
            self.angular_speed = self.angular_speed.with(turning, turning);
            self.acceleration = self.acceleration.max(jet.point.d2.length());
            self.jerk = self.jerk.max(jet.point.d3.length());
            if let Some(before) = before {
                // Simpson's rule over the step, with the middle looked at too.
                let middle = at((k as f64 - 0.5) / count as f64);
                let mean = |f: fn(&MotionJet) -> f64| (f(&before) + 4.0 * f(&middle) + f(&jet)) / 6.0 * step;
                self.length += mean(|jet| jet.point.speed());
                self.turn += mean(|jet| jet.angular_velocity.length());
            }
            before = Some(jet);
        }
        for time in &motion.times()[1..self.spans] {
            let [left, right] = beside(|fraction| own_time(fraction) < *time).map(&at);
            let jump = |f: fn(&MotionJet) -> Vec3| (f(&right) - f(&left)).length();
            self.velocity_jump = self.velocity_jump.max(jump(|jet| jet.point.d1));
            self.acceleration_jump = self.acceleration_jump.max(jump(|jet| jet.point.d2));
            self.angular_velocity_jump = self.angular_velocity_jump.max(jump(|jet| jet.angular_velocity));
        }
    }

    pub(super) fn facts(&self, facts: &mut Vec<String>) {
        facts.push(if self.rational { "rational" } else { "screws" }.to_owned());
        facts.push(plural(self.spans, "span"));
    }

    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> std::fmt::Result {
        line("duration", format!("{} s", short(self.duration)))?;
        line("way", format!("{} {units}, turns by {} rad", short(self.length), short(self.turn)))?;
        let speed = super::text::range(&self.speed);
        line("speed", format!("{speed} {units}/s, angular {} rad/s", super::text::range(&self.angular_speed)))?;
        let (acceleration, jerk) = (short(self.acceleration), short(self.jerk));
        let between = if self.spans > 1 { " between poses" } else { "" };
        line("at most", format!("acceleration {acceleration} {units}/s², jerk {jerk} {units}/s³{between}"))?;
        if self.spans > 1 {
            let [velocity, acceleration] = [self.velocity_jump, self.acceleration_jump].map(short);
            let angular = short(self.angular_velocity_jump);
            line(
                "jumps",
                format!(
                    "velocity {velocity} {units}/s, angular {angular} rad/s, acceleration {acceleration} {units}/s² at poses"
                ),
            )?;
        }
        if let Some(degree) = self.degree {
            line("degree", format!("{degree} of the paths of points, exact"))?;
        }
        Ok(())
    }
}

/// The parts of the duration next to where something ends that holds from 0 on: the last with it, the first without.
fn beside(holds: impl Fn(f64) -> bool) -> [f64; 2] {
    // Positive numbers are in the order of their bits.
    let (mut with, mut without) = (0.0_f64.to_bits(), 1.0_f64.to_bits());
    while without - with > 1 {
        let middle = with + (without - with) / 2;
        if holds(f64::from_bits(middle)) {
            with = middle;
        } else {
            without = middle;
        }
    }
    [with, without].map(f64::from_bits)
}
