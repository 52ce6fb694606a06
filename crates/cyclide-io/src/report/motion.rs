//! What is reported of motions.

use cyclide::{Motion, MotionJet, MovingBody, Schedule, Vec3};
use serde::Serialize;

use super::RangeReport;
use super::text::{Line, plural, short};

/// Steps between the places looked at on each span.
const PLACES: usize = 128;

/// The report on a motion: way and turn to rounding, the others measured at 129 places of each span, ends included. Lengths are in the document's units, times in
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
    /// By which angle the body is turned in the end against how it began, radians, if its origin comes back to where it began.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub closing_turn: Option<f64>,
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
            length: motion.way(body.tool()),
            turn: motion.turn(),
            closing_turn: motion.closing_turn(),
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
            report.measure(&schedule);
        }
        report
    }

    /// Looks at what the body does on each span, one after the other: at a joint all but its place may jump.
    fn measure(&mut self, schedule: &Schedule<'_>) {
        let mut arrived: Option<MotionJet> = None;
        for (span, ends) in schedule.timing().joints().windows(2).enumerate() {
            // A law that goes by the way has no time for a span without one.
            if ends[1] <= ends[0] {
                continue;
            }
            for k in 0..=PLACES {
                let part = k as f64 / PLACES as f64;
                let fraction = if k < PLACES { ends[0] + (ends[1] - ends[0]) * part } else { ends[1] };
                let jet = schedule.jet_in_span(span, fraction);
                if let Some(before) = arrived.as_ref().filter(|_| k == 0) {
                    let jump = |f: fn(&MotionJet) -> Vec3| (f(&jet) - f(before)).length();
                    self.velocity_jump = larger(self.velocity_jump, jump(|jet| jet.point.d1));
                    self.acceleration_jump = larger(self.acceleration_jump, jump(|jet| jet.point.d2));
                    self.angular_velocity_jump = larger(self.angular_velocity_jump, jump(|jet| jet.angular_velocity));
                }
                let (speed, turning) = (jet.point.speed(), jet.angular_velocity.length());
                if speed.is_finite() && turning.is_finite() {
                    self.speed = self.speed.with(speed, speed);
                    self.angular_speed = self.angular_speed.with(turning, turning);
                }
                self.acceleration = larger(self.acceleration, jet.point.d2.length());
                self.jerk = larger(self.jerk, jet.point.d3.length());
                arrived = Some(jet);
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
        if let Some(turn) = self.closing_turn {
            line("closes", format!("turned by {} rad against how it began", short(turn)))?;
        }
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

/// The larger one. What is not finite is no figure: a law that goes by the way passes no place in no time where the way stands still.
fn larger(most: f64, value: f64) -> f64 {
    if value.is_finite() { most.max(value) } else { most }
}
