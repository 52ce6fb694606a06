//! What is reported of motions.

use cyclide::{Motion, MotionJet, MovingBody, TimeLaw, Vec3};
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
    /// Largest acceleration of the tool.
    pub acceleration: f64,
    /// Largest jerk of the tool.
    pub jerk: f64,
    /// Largest jump of the velocity of the tool from span to span.
    pub velocity_jump: f64,
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
            angular_velocity_jump: 0.0,
        };
        // The body was measured when it was made: what it cannot be measured by was refused.
        if let Ok(schedule) = body.schedule() {
            report.measure(motion, |fraction| schedule.jet(fraction), body);
        }
        report
    }

    fn measure(&mut self, motion: &Motion, at: impl Fn(f64) -> MotionJet, body: &MovingBody) {
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
        let own = self.duration / (motion.domain()[1] - motion.domain()[0]);
        if body.law() == TimeLaw::AsGiven {
            for time in &motion.times()[1..self.spans] {
                let [left, right] = [time.next_down(), *time].map(|t| motion.jet(t, body.tool()));
                let jump = |f: fn(&MotionJet) -> Vec3| (f(&right) - f(&left)).length() / own;
                self.velocity_jump = self.velocity_jump.max(jump(|jet| jet.point.d1));
                self.angular_velocity_jump = self.angular_velocity_jump.max(jump(|jet| jet.angular_velocity));
            }
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
        line("at most", format!("acceleration {acceleration} {units}/s², jerk {jerk} {units}/s³"))?;
        if let Some(degree) = self.degree {
            line("degree", format!("{degree} of the paths of points, exact"))?;
        }
        Ok(())
    }
}
