//! Kinks of a surface between two rails, where both run smoothly.
//!
//! From one piece to the next the speed along each rail changes by a factor of its own. At a joint where both rails keep their
//! tangents the derivative across an arc or ruling is, on the next piece, that of other parts of both: with equal factors the
//! tangent planes go on, with others they turn between the rails.

use crate::curve::ParamCurve as _;
use crate::topology::{Body, EdgeCurve, surface_joints};
use crate::warning::{BodyWarning, Warning};

/// Rails run smoothly through a joint if their tangents turn there by less than this, radians.
const SMOOTH: f64 = 1e-6;
/// Angles of a surface from which on they are reported, radians.
const KINK: f64 = 1e-3;

/// The warning of a surface whose faces stand in bands of as many as there are `starts`: each has the joint of the rails that its
/// face starts from, if it does from one.
pub(super) fn kinks(rails: [&[EdgeCurve]; 2], closed: bool, body: &Body, starts: &[Option<usize>]) -> Option<Warning> {
    let count = starts.len();
    let mut angles = vec![0.0_f64; rails[0].len()];
    for found in surface_joints(&body.outer) {
        let [a, b] = found.faces;
        let (band, first, last) = (a / count, (a % count).min(b % count), (a % count).max(b % count));
        let start = match (band == b / count, last - first) {
            (true, 1) => last,
            (true, gap) if gap + 1 == count => 0,
            _ => continue,
        };
        if let Some(joint) = starts[start]
            && is_smooth(rails, closed, joint)
        {
            angles[joint] = angles[joint].max(found.angle);
        }
    }
    let count = angles.iter().filter(|angle| **angle > KINK).count();
    let (joint, &angle) = angles.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1))?;
    (count > 0).then_some(Warning::Body(BodyWarning::KinksAtJoints { count, joint, angle, limit: KINK }))
}

/// Whether both rails keep their tangents at a joint.
fn is_smooth(rails: [&[EdgeCurve]; 2], closed: bool, joint: usize) -> bool {
    rails.into_iter().all(|rail| {
        let before = if joint > 0 { Some(joint - 1) } else { closed.then(|| rail.len() - 1) };
        let from = before.and_then(|before| rail[before].piece_jet(0, 1.0).limit_tangent(-1.0));
        let to = rail[joint].piece_jet(0, 0.0).limit_tangent(1.0);
        from.zip(to).is_some_and(|(from, to)| from.angle(to) <= SMOOTH)
    })
}
