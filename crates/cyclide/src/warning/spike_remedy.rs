//! What helps against a motion that gets very fast in a moment.

/// What helps against a motion that gets very fast in a moment.
///
/// ```
/// use cyclide::{MotionWarning, MovingBody, Pose, Quat, RationalMotion, SpikeRemedy, TimedPose, Vec3, Warning};
/// let at = |time: f64, rotation: [f64; 4], place: [f64; 3]| TimedPose { time, pose: Pose::new(Quat::from(rotation), Vec3::from(place)).unwrap() };
/// // The body turns over in a moment, a hundred times as fast as on average.
/// let motion = RationalMotion::conic(&[
///     at(0.0, [0.4, -0.3, -0.9, -0.6], [-5.8, 1.4, -1.3]),
///     at(1.0, [0.1, -0.4, 0.5, -0.1], [-6.4, 4.2, 3.4]),
///     at(2.0, [-0.1, -0.1, -0.6, -0.1], [-0.1, -5.5, 8.9]),
/// ])?;
/// let warnings = MovingBody::new(motion.into()).warnings();
/// assert!(warnings.iter().any(|w| matches!(w, Warning::Motion(MotionWarning::SpeedSpike { remedy: SpikeRemedy::Spline, .. }))));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpikeRemedy {
    /// A motion of least degree has no freedom, a spline has.
    Spline,
    /// Times of poses do not fit the ways.
    Times,
    /// A curve has a parameter of its own, and a law goes by the way.
    Law,
    /// The law counts turns for too little.
    LargerArm,
    /// The law counts turns for too much.
    SmallerArm,
}

impl SpikeRemedy {
    /// The advice in words.
    pub(super) fn advice(self) -> &'static str {
        match self {
            Self::Spline => "take a spline, or other times",
            Self::Times => "give times that fit the ways and turns, or a pose more there",
            Self::Law => "give it a law that goes by the way, as `constant-speed`",
            Self::LargerArm => {
                "the tool hardly moves there while the body turns: give an `arm`, the length by which turns count as way, or a larger one"
            }
            Self::SmallerArm => "the body hardly turns there while the tool moves: give a smaller `arm`",
        }
    }
}
