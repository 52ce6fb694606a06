//! Places of motions that are faster than asked for.

use cyclide::{
    ShortNumber,
    motion::{MovingBody, SpeedKind},
};
use serde::Serialize;

use super::warning::WarningReport;

/// The reason of warnings about motions that exceed the given speed limits.
///
/// ```
/// assert_eq!(cyclide_io::report::FASTER_THAN_LIMIT, "faster-than-limit");
/// ```
pub const FASTER_THAN_LIMIT: &str = "faster-than-limit";

/// An interval in which a motion is faster than a limit, with its fastest moment; times in seconds from the start.
///
/// ```
/// use cyclide_io::{Document, Report, report::{GeometryReport, SpeedLimits}};
/// let text = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [4, 0]}], "kind": "conic"}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let limits = SpeedLimits { speed: Some(3.0), angular_speed: None };
/// let report = Report::new(document.units, &built, None).with_speed_limits(&built, limits);
/// let GeometryReport::Motion(found) = &report.objects["m"].geometry else { unreachable!("by its type") };
/// let place = &found.fast.as_ref().expect("it was asked for").places[0];
/// assert!((place.value - 4.0).abs() < 1e-9 && (place.from - 1.5).abs() < 1e-9 && !place.turning);
/// assert_eq!(report.objects["m"].warnings[0].reason, "faster-than-limit");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FastPlaceReport {
    /// True for the angular speed, false for the speed of the tool.
    pub turning: bool,
    /// The largest speed in the interval.
    pub value: f64,
    /// The span in which it occurs, from 0.
    pub span: usize,
    /// When.
    pub time: f64,
    /// Start of the interval.
    pub from: f64,
    /// When it ends.
    pub to: f64,
}

/// Speed limits of a machine, in the length units of the document, seconds and radians.
///
/// ```
/// assert!(cyclide_io::report::SpeedLimits::default().speed.is_none());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct SpeedLimits {
    /// Largest speed of the tool.
    pub speed: Option<f64>,
    /// Largest angular speed.
    pub angular_speed: Option<f64>,
}

/// The intervals in which a motion exceeds speed limits.
///
/// ```
/// use cyclide_io::{Document, Report, report::{GeometryReport, SpeedLimits}};
/// let text = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [1, 0]}]}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let limits = SpeedLimits { speed: Some(3.0), angular_speed: Some(1.0) };
/// let report = Report::new(document.units, &built, None).with_speed_limits(&built, limits);
/// let GeometryReport::Motion(found) = &report.objects["m"].geometry else { unreachable!("by its type") };
/// assert!(found.fast.as_ref().is_some_and(|fast| fast.places.is_empty()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FastReport {
    /// The limits.
    pub limits: SpeedLimits,
    /// The intervals, those of the tool first, each in the order of time.
    pub places: Vec<FastPlaceReport>,
}

impl FastReport {
    /// Looks along a motion.
    pub(super) fn new(body: &MovingBody, limits: SpeedLimits) -> Self {
        let asked = [(SpeedKind::Tool, limits.speed), (SpeedKind::Turn, limits.angular_speed)];
        let mut places = Vec::new();
        if let Ok(schedule) = body.schedule() {
            for (kind, limit) in asked.into_iter().filter_map(|(kind, limit)| limit.map(|limit| (kind, limit))) {
                places.extend(schedule.faster_than(kind, limit).into_iter().map(|place| FastPlaceReport {
                    turning: kind == SpeedKind::Turn,
                    value: place.value,
                    span: place.span,
                    time: place.time,
                    from: place.from,
                    to: place.to,
                }));
            }
        }
        Self { limits, places }
    }

    /// A warning for each place.
    pub(super) fn warnings(&self, units: &str) -> Vec<WarningReport> {
        let warning = |place: &FastPlaceReport| WarningReport {
            reason: FASTER_THAN_LIMIT,
            message: format!("{}, faster than {}", place.words(units), self.limits.words(place.turning, units)),
            contour: None,
            index: Some(place.span),
            place: None,
        };
        self.places.iter().map(warning).collect()
    }
}

impl FastPlaceReport {
    /// Speed and times.
    pub(super) fn words(&self, units: &str) -> String {
        let [value, time, from, to] = [self.value, self.time, self.from, self.to].map(ShortNumber);
        let (what, unit) = kind(self.turning, units);
        format!("{what} {value} {unit} at {time} s, span {} (from {from} to {to} s)", self.span)
    }
}

impl SpeedLimits {
    /// One of them.
    fn words(&self, turning: bool, units: &str) -> String {
        let limit = if turning { self.angular_speed } else { self.speed };
        format!("{} {}", ShortNumber(limit.unwrap_or(f64::INFINITY)), kind(turning, units).1)
    }

    /// Those that there are.
    pub(super) fn all(&self, units: &str) -> String {
        let given = [(false, self.speed), (true, self.angular_speed)].into_iter().filter(|(_, limit)| limit.is_some());
        given.map(|(turning, _)| self.words(turning, units)).collect::<Vec<_>>().join(" or ")
    }
}

fn kind(turning: bool, units: &str) -> (&'static str, String) {
    if turning { ("angular speed", "rad/s".to_owned()) } else { ("speed", format!("{units}/s")) }
}
