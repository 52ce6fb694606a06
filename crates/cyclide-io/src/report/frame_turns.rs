//! Turns of frames between neighboring samples that are too large to be followed.

use cyclide::{ShortNumber, Vec3, curve::ArcLength};
use serde::Serialize;

/// Turns between neighboring samples above this are reported: between such frames there is no nearest way.
const LARGEST: f64 = std::f64::consts::FRAC_PI_2 + 1e-6;
/// Halvings of the interval between two samples in search of a jump.
const HALVINGS: usize = 40;

/// The axes of a frame.
pub(super) type Axes = [Vec3; 3];

/// Neighboring samples between which the frame turns by more than 90 degrees.
///
/// ```
/// use cyclide_io::{Document, report::{CurveSamples, SampleOptions, SamplePlaces, Spacing}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "polyline", "points": [[-1, 0, 1], [1, 0, 1]]}}}"#;
/// let built = text.parse::<Document>()?.build()?;
/// let places = SamplePlaces::Count { count: 4, spacing: Spacing::Parameter };
/// // Straight below, a camera that keeps its upper side up turns over.
/// let frames = Some(cyclide::curve::FrameRule::LookAt { target: cyclide::Point3::ORIGIN, up: cyclide::Vec3::Z });
/// let samples = CurveSamples::new(&built[0], &SampleOptions { places, frames })?;
/// let turn = samples.contours[0].frame_turns[0];
/// assert!((turn.t - 0.5).abs() < 1e-9 && turn.jump && (turn.angle - std::f64::consts::PI).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FrameTurn {
    /// The sample before it, from 0.
    pub sample: usize,
    /// Where the frame turns most between the two samples: the global parameter.
    pub t: f64,
    /// Its arc length from the start of the contour.
    pub station: f64,
    /// The angle between the frames of the two samples or, for a jump, on both sides of it, in radians.
    pub angle: f64,
    /// True if the frame jumps there; otherwise it turns continuously, but too far for the distance of the samples.
    pub jump: bool,
}

impl FrameTurn {
    /// The large turns between neighbors of `frames`, which are at the parameters `places`; `at` gives the frame anywhere.
    /// Samples without a frame are passed over, also round the start of a closed curve.
    pub(super) fn find(
        places: &[f64],
        frames: &[Option<Axes>],
        at: impl Fn(f64) -> Option<Axes>,
        lengths: &ArcLength<'_>,
        closed: bool,
    ) -> Vec<Self> {
        let known: Vec<(usize, Axes)> = frames.iter().enumerate().filter_map(|(i, axes)| Some((i, (*axes)?))).collect();
        let turns = known.windows(2).filter(|pair| angle(&pair[0].1, &pair[1].1) > LARGEST);
        let mut found: Vec<Self> = turns
            .map(|pair| {
                let [(sample, before), (next, after)] = [pair[0], pair[1]];
                let (t, jump) = halved([places[sample], places[next]], [before, after], &at);
                let angle = jump.unwrap_or_else(|| angle(&before, &after));
                Self { sample, t, station: lengths.station(t), angle, jump: jump.is_some() }
            })
            .collect();
        let starts_without = closed && frames.first().is_some_and(Option::is_none);
        if let (true, [(_, first), .., (sample, last)]) = (starts_without, known.as_slice()) {
            let angle = angle(last, first);
            if angle > LARGEST {
                found.push(Self { sample: *sample, t: 0.0, station: 0.0, angle, jump: true });
            }
        }
        found
    }

    /// What a user should know of the turns of a contour.
    pub(super) fn note(turns: &[Self], frames: &str) -> Option<String> {
        let first = turns.iter().find(|turn| turn.jump).or(turns.first())?;
        let (t, station) = (ShortNumber(first.t), ShortNumber(first.station));
        let degrees = ShortNumber(round(first.angle.to_degrees()));
        let (what, remedy) = if first.jump {
            ("jumps", "start or end the curve there, or choose another direction or rule")
        } else {
            ("turns", "use more samples")
        };
        let count = match turns.len() {
            1 => String::new(),
            n => format!("{n} pairs of neighboring frames differ by more than 90 degrees; "),
        };
        Some(format!(
            "{count}the {frames} frame {what} by {degrees} degrees at station {station} (t = {t}), between samples {} and {}: {remedy} [frame-jumps]",
            first.sample,
            first.sample + 1
        ))
    }
}

/// To a tenth.
fn round(degrees: f64) -> f64 {
    (10.0 * degrees).round() / 10.0
}

/// The angle of the rotation from one frame to another.
fn angle(a: &Axes, b: &Axes) -> f64 {
    let trace: f64 = (0..3).map(|k| a[k].dot(b[k])).sum();
    (0.5 * (trace - 1.0)).clamp(-1.0, 1.0).acos()
}

/// Where between two places the frame turns most, and by how much it jumps there, if it does.
fn halved(
    [mut from, mut to]: [f64; 2],
    [mut before, mut after]: [Axes; 2],
    at: &impl Fn(f64) -> Option<Axes>,
) -> (f64, Option<f64>) {
    for _ in 0..HALVINGS {
        let places = [0.5, 0.4375, 0.5625].map(|part| from + (to - from) * part);
        // At the very place of a jump there may be no frame.
        let found = places.into_iter().filter(|t| *t > from && *t < to).find_map(|t| Some((t, at(t)?)));
        let Some((t, middle)) = found else { break };
        if angle(&before, &middle) > angle(&middle, &after) {
            (to, after) = (t, middle);
        } else {
            (from, before) = (t, middle);
        }
        if angle(&before, &after) <= LARGEST {
            return (0.5 * (from + to), None);
        }
    }
    (0.5 * (from + to), Some(angle(&before, &after)))
}
