//! What helps against a motion that gets very fast in a moment.

/// What helps against a motion that gets very fast in a moment.
///
/// ```
/// use cyclide::{MovingBody, Pose, Quat, RationalMotion, SpikeRemedy, TimedPose, Vec3, Warning};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// // 99 of the way of 100 in a hundredth of a second.
/// let motion = RationalMotion::quartic(&[at(0.0, 0.0), at(1.0, 0.5), at(1.01, 99.5), at(1.02, 99.6), at(60.0, 100.0)])?;
/// let warnings = MovingBody::new(motion.into()).warnings();
/// assert!(warnings.iter().any(|w| matches!(w, Warning::SpeedSpike { remedy: SpikeRemedy::Spline, .. })));
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
