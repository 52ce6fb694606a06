//! How a motion keeps to its poses: how far it leaves the lines between them, how it closes, and how far a smoothed one is from them.

use cyclide::{
    Vec3,
    motion::{MotionJet, MovingBody, Schedule},
};
use serde::Serialize;

/// The distance of the origin of a body from the straight lines between its poses.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "kind": "linear", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// assert_eq!(found.off_chords.expect("it has poses").distance, 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OffChordsReport {
    /// The distance.
    pub distance: f64,
    /// When, seconds from the start.
    pub time: f64,
}

/// How a motion that returns to its first pose continues from its end to its beginning.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let poses = r#"[{"position": [0, 0]}, {"position": [30, 0]}, {"position": [30, 30]}]"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"m": {{"type": "motion", "closed": true, "poses": {poses}}}}}}}"#);
/// let document: Document = text.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// assert!(found.closing.expect("it closes").corner < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MotionClosingReport {
    /// The angle by which the path of the tool turns there, in radians.
    pub corner: f64,
    /// The jump of its velocity.
    pub velocity_jump: f64,
    /// The jump of the angular velocity, in radians per second.
    pub angular_velocity_jump: f64,
}

impl MotionClosingReport {
    /// Of a motion that closes.
    pub(super) fn new(schedule: &Schedule<'_>, body: &MovingBody) -> Self {
        let motion = body.motion();
        // The directions do not depend on a law, under which the body may stop at both ends.
        let [first, last] = motion.domain();
        let [start, end] = [motion.jet(first, body.tool()), motion.jet(last, body.tool())].map(|jet| jet.point.d1);
        let corner = start.cross(end).length().atan2(start.dot(end));
        let spans = motion.times().len() - 1;
        let [start, end] = [schedule.jet_in_span(0, 0.0), schedule.jet_in_span(spans - 1, 1.0)];
        let jump = |f: fn(&MotionJet) -> Vec3| larger(0.0, (f(&start) - f(&end)).length());
        Self {
            corner,
            velocity_jump: jump(|jet| jet.point.d1),
            angular_velocity_jump: jump(|jet| jet.angular_velocity),
        }
    }
}

/// The deviation of a smoothed motion from its poses, at their times.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let poses = r#"[{"position": [0, 0]}, {"position": [10, 1]}, {"position": [20, 0]}, {"position": [30, 1]}]"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"m": {{"type": "motion", "tolerance": {{"place": 0.6}}, "poses": {poses}}}}}}}"#);
/// let document: Document = text.parse()?;
/// let GeometryReport::Motion(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// assert!(found.deviation.expect("it is smoothed").place <= 0.6);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DeviationReport {
    /// The largest distance of the origin of the body from its position in a pose.
    pub place: f64,
    /// The largest angle from the rotation of a pose, in radians.
    pub angle: f64,
}

/// The larger one. What is not finite is no figure: a law that goes by the way passes no place in no time where the way stands still.
pub(super) fn larger(most: f64, value: f64) -> f64 {
    if value.is_finite() { most.max(value) } else { most }
}
