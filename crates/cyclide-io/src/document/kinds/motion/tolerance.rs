//! How closely a motion follows noisy poses.

use cyclide::motion::{MotionTolerance, PoseLimit};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::forms::forms;
use crate::document::kinds::{AutoWord, FairTolerance};

/// How closely a motion follows noisy poses: the word `auto`, as their noise calls for, or a bound for each part.
///
/// ```
/// use cyclide_io::document::kinds::PoseTolerance;
/// let auto: PoseTolerance = serde_json::from_str(r#""auto""#)?;
/// assert_eq!(auto, PoseTolerance::AUTO);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged)]
#[non_exhaustive]
pub enum PoseTolerance {
    /// One for positions, one for rotations.
    Each(PoseTolerances),
    /// Both as their noise calls for.
    Auto(AutoWord),
}

/// How far a motion may be from noisy poses. A part whose bound is omitted is interpolated.
///
/// ```
/// use cyclide_io::document::kinds::{FairTolerance, PoseTolerances};
/// let tolerance: PoseTolerances = serde_json::from_str(r#"{"place": 5, "angle": {"degrees": 1}}"#)?;
/// assert_eq!(tolerance.place, Some(FairTolerance::Within(5.0)));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseTolerances {
    /// For the positions, a length, or `"auto"`.
    pub place: Option<FairTolerance>,
    /// For the rotations, an angle up to a right angle, or `"auto"`.
    pub angle: Option<AngleTolerance>,
}

/// How closely a motion follows noisy rotations.
///
/// ```
/// use cyclide_io::document::{Angle, kinds::AngleTolerance};
/// let angle: AngleTolerance = serde_json::from_str("0.02")?;
/// assert_eq!(angle, AngleTolerance::Within(Angle::Radians(0.02)));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged)]
#[non_exhaustive]
pub enum AngleTolerance {
    /// Largest angle from a rotation.
    Within(Angle),
    /// As closely as the noise of the rotations requires.
    Auto(AutoWord),
}

forms! {
    PoseTolerance: "\"auto\", or `{\"place\": …, \"angle\": …}`";
    word AutoWord => PoseTolerance::Auto;
    object PoseTolerances => PoseTolerance::Each;
}

forms! {
    AngleTolerance: "an angle or \"auto\"";
    word AutoWord => AngleTolerance::Auto;
    number f64 => |angle| AngleTolerance::Within(Angle::Radians(angle));
    object Angle => AngleTolerance::Within;
}

impl PoseTolerance {
    /// The word.
    pub const AUTO: Self = Self::Auto(AutoWord::Auto);

    /// As the kernel takes it.
    pub(super) fn limits(self) -> MotionTolerance {
        let Self::Each(PoseTolerances { place, angle }) = self else {
            return MotionTolerance { place: Some(PoseLimit::ByNoise), angle: Some(PoseLimit::ByNoise) };
        };
        MotionTolerance {
            place: place.map(|place| place.within().map_or(PoseLimit::ByNoise, PoseLimit::Within)),
            angle: angle.map(|angle| match angle {
                AngleTolerance::Within(angle) => PoseLimit::Within(angle.radians()),
                AngleTolerance::Auto(_) => PoseLimit::ByNoise,
            }),
        }
    }
}
