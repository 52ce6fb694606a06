//! Motions of rigid bodies: dual quaternions, poses, screws, and motions whose points run on rational curves.

mod along_qb;
mod any_motion;
mod cubic;
mod decoupled;
mod dual_quat;
mod exceptional;
mod extremes;
mod fast_places;
mod fibre_spline;
mod leaves_chords;
mod motion_jet;
mod moving_body;
mod odd_poses;
mod off_chords;
mod pose;
mod pose_times;
mod rational_motion;
mod reversals;
mod screw_motion;
mod span_cells;
mod speed_peak;
mod study_form;
mod study_point;
mod swings;
mod timed_pose;
mod timing;
mod trajectory;

pub use any_motion::Motion;
pub use cubic::CubicMotions;
pub use decoupled::{DecoupledMotion, MotionDeviation, MotionTolerance, PoseLimit, RationalForm};
pub use dual_quat::DualQuat;
pub use extremes::{MotionExtremes, MotionPlace};
pub use fast_places::{FastPlace, SpeedKind};
pub use motion_jet::MotionJet;
pub use moving_body::{BodyMesh, MovingBody, Schedule};
pub use off_chords::OffChords;
pub use pose::Pose;
pub use pose_times::PoseTimes;
pub use rational_motion::RationalMotion;
pub use reversals::MotionReversal;
pub use screw_motion::ScrewMotion;
pub use speed_peak::SpeedPeak;
pub use study_point::StudyPoint;
pub use timed_pose::TimedPose;
pub use timing::{TimeLaw, Timing};

/// The span of rising times that a time is in: at a joint the one that starts there, outside the first or last.
fn span_of(times: &[f64], time: f64) -> usize {
    let last = times.len() - 1;
    // Most poses are evenly apart: then the time tells its span, and nothing is searched.
    let guess = (time - times[0]) / (times[last] - times[0]) * last as f64;
    let guess = (guess.max(0.0) as usize).min(last - 1);
    if times[guess] <= time && time < times[guess + 1] {
        return guess;
    }
    times.partition_point(|t| *t <= time).clamp(1, times.len() - 1) - 1
}
