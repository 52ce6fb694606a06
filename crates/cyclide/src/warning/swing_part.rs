//! Which part of a motion overshoots its poses.

/// Which part of a motion overshoots its poses.
///
/// ```
/// use cyclide::{Quat, Vec3, Warning, motion::{Pose, RationalMotion, TimedPose}, warning::{MotionWarning, SwingPart}};
/// let at = |time: f64, x: f64, degrees: f64| TimedPose {
///     time,
///     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, f64::to_radians(degrees)), Vec3::X * x).unwrap(),
/// };
/// // It turns on while it slides, though it is turned alike at both ends of the slide.
/// let motion = RationalMotion::spline(&[at(0.0, 0.0, 0.0), at(1.0, 1.0, 60.0), at(5.0, 5.0, 60.0), at(6.0, 6.0, 120.0)])?;
/// assert!(matches!(motion.warnings()[..], [Warning::Motion(MotionWarning::Swings { span: 1, part: SwingPart::Turn, .. })]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SwingPart {
    /// The body as a whole.
    All,
    /// The position of its origin, while it turns.
    Place,
    /// Its orientation, while it moves.
    Turn,
}

impl SwingPart {
    /// It in words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::All => "it",
            Self::Place => "its position",
            Self::Turn => "its orientation",
        }
    }

    /// The unit of how far it runs; lengths have none.
    pub(super) fn unit(self) -> &'static str {
        if self == Self::Turn { " rad" } else { "" }
    }
}
