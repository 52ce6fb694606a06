//! What is reported of motions.

use cyclide::{
    Vec3,
    motion::{
        Motion, MotionDeviation, MotionJet, MotionPlace, MotionReversal, MovingBody, OffChords, PoseTimes, Schedule,
        SpeedPeak, TimeLaw,
    },
};
use serde::Serialize;

use super::fast::FastReport;
use super::figures::{Line, plural, short};
use super::motion_poses::{DeviationReport, MotionClosingReport, OffChordsReport, larger};
use super::range::RangeReport;

/// Where a law gives no velocity at a joint, that so far beside it is taken, in parts of the span: nearer to it the terms of accelerations cancel.
const BESIDE: f64 = 1e-4;
/// So many times of poses are in the text; all of them are in JSON.
const POSES_SHOWN: usize = 12;
/// The same of places that are too fast.
const PLACES_SHOWN: usize = 12;
/// Turns up to this, in radians, close a motion.
const CLOSES: f64 = 1e-9;
/// Turns of the way where a motion closes up to this, in radians, are no corner,
const CORNER: f64 = 1e-6;
/// and jumps up to this part of the largest speed are none.
const NO_JUMP: f64 = 1e-6;
/// A motion this part of its length from the lines between its poses is straight.
const STRAIGHT: f64 = 1e-9;
/// A figure that varies by no more than this part of itself is the largest nowhere.
const CONSTANT: f64 = 1e-9;

/// The report on a motion: path length and rotation to rounding, extremes to 1e-6 of themselves ([`Schedule::extremes`]; unbounded values
/// are infinite, `null` in JSON). Lengths are in the units of the document, times in seconds.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let report = ObjectReport::new(&document.build()?[0], None);
/// let GeometryReport::Motion(found) = report.geometry else { unreachable!("by its type") };
/// assert!((found.length - 30.0).abs() < 1e-9 && (found.speed.max - 30.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionReport {
    /// How it moves from pose to pose: `rational`, `screws`, or `place and turn apart`.
    pub form: &'static str,
    /// True if points follow rational curves.
    pub rational: bool,
    /// Degree of these curves.
    pub degree: Option<usize>,
    /// Number of spans between poses; one if it does not consist of spans.
    pub spans: usize,
    /// Its duration.
    pub duration: f64,
    /// When it passes its poses, in seconds from the start, if a law, a duration, `times` or a motion of one span may have changed the
    /// times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pose_times: Option<Vec<f64>>,
    /// Length of the path of the tool.
    pub length: f64,
    /// The total angle of rotation, in radians.
    pub turn: f64,
    /// The angle between the final and the initial rotation of the body, in radians, if its origin returns to its start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub closing_turn: Option<f64>,
    /// How the end continues to the beginning, if it closes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub closing: Option<MotionClosingReport>,
    /// The largest distance of the origin of the body from the straight lines between its poses, for motions through
    /// poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub off_chords: Option<OffChordsReport>,
    /// Its deviation from its poses, if it was smoothed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<DeviationReport>,
    /// Speed of the tool.
    pub speed: RangeReport,
    /// Where it is the largest.
    pub speed_at: PlaceReport,
    /// Angular speed, radians per second.
    pub angular_speed: RangeReport,
    /// Where it is the largest.
    pub angular_speed_at: PlaceReport,
    /// Largest acceleration of the tool between poses.
    pub acceleration: f64,
    /// Where.
    pub acceleration_at: PlaceReport,
    /// Largest jerk of the tool between poses.
    pub jerk: f64,
    /// Where.
    pub jerk_at: PlaceReport,
    /// Where the speed of the tool, or the angular speed, is the largest multiple of its average over the same span.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak: Option<PeakReport>,
    /// Where the path reverses under a law by path length: the velocity jumps there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reversals: Vec<ReversalReport>,
    /// Largest jump of the velocity of the tool, between spans or where the path reverses; at such a jump the acceleration is unbounded.
    pub velocity_jump: f64,
    /// Largest jump of the acceleration of the tool between spans; at such a jump the jerk is unbounded.
    pub acceleration_jump: f64,
    /// Largest jump of the angular velocity between spans, in radians per second.
    pub angular_velocity_jump: f64,
    /// The intervals in which given speed limits are exceeded, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fast: Option<FastReport>,
}

/// A moment of a motion.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "law": "eased", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// assert!(found.speed_at.span == 0 && (found.speed_at.time - 0.5).abs() < 1e-6);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PlaceReport {
    /// The span, from 0: from the pose with this number to the next.
    pub span: usize,
    /// Seconds from the start.
    pub time: f64,
}

impl From<MotionPlace> for PlaceReport {
    fn from(MotionPlace { span, time }: MotionPlace) -> Self {
        Self { span, time }
    }
}

/// Where the path reverses under a law by path length.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let poses = r#"[{"position": [1, 0]}, {"position": [0, 0]}, {"position": [1, 0]}]"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"m": {{"type": "motion", "kind": "conic", "law": "constant-speed", "poses": {poses}}}}}}}"#);
/// let document: Document = text.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// assert!((found.reversals[0].time - 1.0).abs() < 1e-6 && (found.reversals[0].velocity_jump - 2.0).abs() < 1e-6);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ReversalReport {
    /// The span, from 0; at a pose, the one that starts there.
    pub span: usize,
    /// Seconds from the start.
    pub time: f64,
    /// The jump of the velocity of the tool.
    pub velocity_jump: f64,
    /// The jump of the angular velocity, in radians per second.
    pub angular_velocity_jump: f64,
}

/// Where a body is fast relative to the average over the span.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "law": "eased", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// let peak = found.peak.expect("it moves");
/// assert!((peak.time - 0.5).abs() < 1e-6 && (peak.ratio - 1.875).abs() < 1e-9 && !peak.turning);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PeakReport {
    /// The span, from 0.
    pub span: usize,
    /// Seconds from the start.
    pub time: f64,
    /// The ratio to the average speed.
    pub ratio: f64,
    /// True for the angular speed.
    pub turning: bool,
}

impl MotionReport {
    /// Measures a moving body.
    #[must_use]
    pub fn new(body: &MovingBody) -> Self {
        let motion = body.motion();
        let degree = match motion {
            Motion::Rational(motion) => Some(2 * motion.degree()),
            // The origin at least runs on polynomials: paths of points have the degree of their form.
            Motion::Decoupled(motion) if motion.is_rational() => {
                body.motion().to_rational().ok().map(|form| 2 * form.motion().degree())
            }
            Motion::Screw(_) | Motion::Decoupled(_) => None,
        };
        let deviation = match motion {
            Motion::Decoupled(motion) => {
                motion.deviation().map(|MotionDeviation { place, angle }| DeviationReport { place, angle })
            }
            _ => None,
        };
        let spans = motion.times().len() - 1;
        let form = match motion {
            Motion::Rational(_) => "rational",
            Motion::Screw(_) => "screws",
            Motion::Decoupled(_) => "place and turn apart",
        };
        let mut report = Self {
            form,
            rational: degree.is_some(),
            degree,
            spans,
            duration: body.duration(),
            pose_times: None,
            length: motion.way(body.tool()),
            turn: motion.turn(),
            closing_turn: motion.closing_turn(),
            closing: None,
            off_chords: None,
            deviation,
            speed: RangeReport::EMPTY,
            speed_at: PlaceReport::default(),
            angular_speed: RangeReport::EMPTY,
            angular_speed_at: PlaceReport::default(),
            acceleration: 0.0,
            acceleration_at: PlaceReport::default(),
            jerk: 0.0,
            jerk_at: PlaceReport::default(),
            peak: None,
            reversals: Vec::new(),
            velocity_jump: 0.0,
            acceleration_jump: 0.0,
            angular_velocity_jump: 0.0,
            fast: None,
        };
        // The body was measured when it was made: what it cannot be measured by was refused.
        if let Ok(schedule) = body.schedule() {
            report.measure(&schedule);
            if report.closing_turn.is_some_and(|turn| turn <= CLOSES) {
                report.closing = Some(MotionClosingReport::new(&schedule, body));
            }
            let seconds = |time: f64| schedule.timing().fraction_at(time) * body.duration();
            report.off_chords = motion
                .off_chords()
                .map(|OffChords { distance, time }| OffChordsReport { distance, time: seconds(time) });
            let [first, last] = motion.domain();
            let as_given = body.law() == TimeLaw::AsGiven && (last - first - body.duration()).abs() <= 0.0;
            let times = motion.pose_times();
            // One span through more than its ends may have chosen their times itself.
            let chosen = body.pose_times() != PoseTimes::Uniform || spans == 1;
            if times.len() > 2 && (!as_given || chosen) {
                // The inverse of a law that begins at rest is off by a rounding there.
                let passed = |time: &f64| {
                    if *time <= first { 0.0 } else { schedule.timing().fraction_at(*time) * body.duration() }
                };
                report.pose_times = Some(times.iter().map(passed).collect());
            }
        }
        report
    }

    /// The extremes, and at the ends of each span, one after the other, the jumps: at a joint all but the place may jump.
    fn measure(&mut self, schedule: &Schedule<'_>) {
        let found = schedule.extremes();
        let range = |[min, max]: [f64; 2]| RangeReport { min, max };
        self.speed = range(found.speed);
        self.angular_speed = range(found.angular_speed);
        (self.acceleration, self.jerk) = (found.acceleration, found.jerk);
        (self.speed_at, self.angular_speed_at) = (found.speed_at.into(), found.angular_speed_at.into());
        (self.acceleration_at, self.jerk_at) = (found.acceleration_at.into(), found.jerk_at.into());
        self.peak =
            found.peak.map(|SpeedPeak { span, time, ratio, turning, .. }| PeakReport { span, time, ratio, turning });
        let mut arrived: Option<MotionJet> = None;
        for (span, ends) in schedule.timing().joints().windows(2).enumerate() {
            // A law that goes by the way has no time for a span without one.
            if ends[1] <= ends[0] {
                continue;
            }
            let length = ends[1] - ends[0];
            let [starts, ends] = [(ends[0], BESIDE), (ends[1], -BESIDE)].map(|(fraction, beside)| {
                let jet = schedule.jet_in_span(span, fraction);
                // A law that goes by the way knows no velocity where the way turns back, but next to it.
                if jet.point.d1.is_finite() { jet } else { schedule.jet_in_span(span, fraction + beside * length) }
            });
            if let Some(before) = &arrived {
                let jump = |f: fn(&MotionJet) -> Vec3| (f(&starts) - f(before)).length();
                self.velocity_jump = larger(self.velocity_jump, jump(|jet| jet.point.d1));
                self.acceleration_jump = larger(self.acceleration_jump, jump(|jet| jet.point.d2));
                self.angular_velocity_jump = larger(self.angular_velocity_jump, jump(|jet| jet.angular_velocity));
            }
            arrived = Some(ends);
        }
        for MotionReversal { span, time, velocity_jump, angular_velocity_jump, .. } in schedule.reversals() {
            self.reversals.push(ReversalReport { span, time, velocity_jump, angular_velocity_jump });
            self.velocity_jump = larger(self.velocity_jump, velocity_jump);
            self.angular_velocity_jump = larger(self.angular_velocity_jump, angular_velocity_jump);
        }
    }

    pub(super) fn facts(&self, facts: &mut Vec<String>) {
        facts.push(self.form.to_owned());
        facts.push(plural(self.spans, "span"));
    }

    /// How it goes on where it closes.
    fn closing_words(&self, units: &str) -> String {
        let mut words = "in its initial rotation".to_owned();
        let Some(MotionClosingReport { corner, velocity_jump, angular_velocity_jump }) = self.closing else {
            return words;
        };
        let [speed, turning] = [self.speed.max, self.angular_speed.max].map(|most| NO_JUMP * most);
        let mut faults = Vec::new();
        if corner > CORNER {
            faults.push(format!("a corner of {} rad", short(corner)));
        }
        if velocity_jump > speed {
            faults.push(format!("a velocity jump of {} {units}/s", short(velocity_jump)));
        }
        if angular_velocity_jump > turning {
            faults.push(format!("an angular velocity jump of {} rad/s", short(angular_velocity_jump)));
        }
        if !faults.is_empty() {
            words.push_str(", with ");
            words.push_str(&faults.join(", "));
            words.push_str(match &self.off_chords {
                Some(off) if off.distance <= STRAIGHT * self.length => " (a `blend_radius` rounds its corners)",
                Some(_) => " (`closed` joins it smoothly)",
                None => "",
            });
        }
        words
    }

    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> std::fmt::Result {
        line("duration", format!("{} s", short(self.duration)))?;
        if let Some(times) = &self.pose_times {
            let shown: Vec<String> = times.iter().take(POSES_SHOWN).map(|t| short(*t)).collect();
            let more = if times.len() > POSES_SHOWN { ", …" } else { "" };
            line("poses", format!("passed at {}{more} s", shown.join(", ")))?;
        }
        line("path", format!("{} {units}, total rotation {} rad", short(self.length), short(self.turn)))?;
        if let Some(turn) = self.closing_turn {
            let (word, text) = match turn {
                turn if turn <= CLOSES => ("closes", self.closing_words(units)),
                turn => (
                    "comes back",
                    format!("its origin returns, with the body rotated by {} rad against its start", short(turn)),
                ),
            };
            line(word, text)?;
        }
        if let Some(OffChordsReport { distance, time }) = self.off_chords {
            let when = if distance > 0.0 { format!(" (at {} s)", short(time)) } else { String::new() };
            line(
                "off chords",
                format!("up to {} {units} from the straight lines between the poses{when}", short(distance)),
            )?;
        }
        if let Some(DeviationReport { place, angle }) = self.deviation {
            line("smoothed", format!("up to {} {units} and {} rad from the poses", short(place), short(angle)))?;
        }
        let of_range = |range: &RangeReport, unit: &str, at: PlaceReport| {
            let text = match range {
                RangeReport { min, max } if max.is_infinite() => format!("{} to infinity,", short(*min)),
                range => super::figures::range(range),
            };
            let varies = range.max - range.min > CONSTANT * range.max;
            if varies { format!("{text} {unit} (at {} s)", short(at.time)) } else { format!("{text} {unit}") }
        };
        let speed = of_range(&self.speed, &format!("{units}/s"), self.speed_at);
        line("speed", format!("{speed}, angular {}", of_range(&self.angular_speed, "rad/s", self.angular_speed_at)))?;
        let of_most = |value: f64, unit: &str, at: PlaceReport| match value {
            value if value.is_infinite() => format!("without bound, {unit} (at {} s)", short(at.time)),
            value if value > 0.0 => format!("{} {unit} (at {} s)", short(value), short(at.time)),
            value => format!("{} {unit}", short(value)),
        };
        let acceleration = of_most(self.acceleration, &format!("{units}/s²"), self.acceleration_at);
        let jerk = of_most(self.jerk, &format!("{units}/s³"), self.jerk_at);
        let between = if self.spans > 1 { " between poses" } else { "" };
        line("at most", format!("acceleration {acceleration}, jerk {jerk}{between}"))?;
        if self.spans > 1 || !self.reversals.is_empty() {
            let [velocity, acceleration] = [self.velocity_jump, self.acceleration_jump].map(short);
            let angular = short(self.angular_velocity_jump);
            let places = if self.spans > 1 { " at poses" } else { "" };
            line(
                "jumps",
                format!(
                    "velocity {velocity} {units}/s, angular {angular} rad/s, acceleration {acceleration} {units}/s²{places}"
                ),
            )?;
        }
        if !self.reversals.is_empty() {
            let times =
                self.reversals.iter().take(POSES_SHOWN).map(|reversal| short(reversal.time)).collect::<Vec<_>>();
            let more = if self.reversals.len() > POSES_SHOWN { ", …" } else { "" };
            line("turns back", format!("at {}{more} s, where the velocity jumps", times.join(", ")))?;
        }
        if let Some(fast) = &self.fast {
            let limits = fast.limits.all(units);
            match fast.places.len() {
                0 => line("fast", format!("never faster than {limits}"))?,
                count => line("fast", format!("{} faster than {limits}", plural(count, "interval")))?,
            }
            for place in fast.places.iter().take(PLACES_SHOWN) {
                line("", place.words(units))?;
            }
            if fast.places.len() > PLACES_SHOWN {
                line("", format!("and {} more", fast.places.len() - PLACES_SHOWN))?;
            }
        }
        if let Some(degree) = self.degree {
            line("degree", format!("{degree} of the paths of points, exact"))?;
        }
        Ok(())
    }
}
