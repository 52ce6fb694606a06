//! What helps against a motion that becomes very fast suddenly.

/// What helps against a motion that becomes very fast suddenly.
///
/// ```
/// use cyclide::{Quat, Vec3, Warning, motion::{MovingBody, Pose, RationalMotion, TimedPose}, warning::{MotionWarning, SpikeRemedy}};
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
    /// A motion of lowest degree has no freedom: use a spline.
    Spline,
    /// The times of the poses do not fit the path lengths.
    Times,
    /// The motion follows the parameter of a curve: use a law by path length.
    Law,
    /// The law weights rotation too little.
    LargerArm,
    /// The law weights rotation too much.
    SmallerArm,
}

impl SpikeRemedy {
    /// The advice in words.
    pub(super) fn advice(self) -> &'static str {
        match self {
            Self::Spline => "use a spline, or other times",
            Self::Times => "give times that fit the path lengths and rotations, or add a pose there",
            Self::Law => "give it a law by path length, such as `constant-speed`",
            Self::LargerArm => {
                "the tool hardly moves there while the body rotates: give an `arm`, the characteristic length that weights rotation against translation, or a larger one"
            }
            Self::SmallerArm => "the body hardly rotates there while the tool moves: give a smaller `arm`",
        }
    }
}
