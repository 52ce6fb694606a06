//! Where a law that goes by the way runs on over a place at which the way turns back: its speed stays, and the velocity turns over in no time.
//!
//! There the speed of the way by the motion's own time vanishes, so that its quadrature has cells that end next to the place
//! (`docs/math/motions.md#laws-of-time`).

use super::moving_body::Schedule;
use super::timing::TimeLaw;
use crate::base::golden_section::GoldenSection;
use crate::base::vector::Vec3;

/// A place where the way is gone slower than this part of its average over the span may be one where it turns back.
const SLOW: f64 = 1e-4;
/// Directions are taken so far beside the place, in parts of the span.
const BESIDE: f64 = 1e-6;
/// Sections of a bracket: to the rounding of its ends.
const SECTIONS: u32 = 72;
/// Places nearer to the end of a span, in parts of it, are the joint.
const AT_JOINT: f64 = 1e-9;

/// A place where a law that goes by the way has the velocity turn over in no time, as the way turns back there: within a span, or where one
/// comes to a stand at its end.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimeLaw, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let motion = RationalMotion::conic(&[at(0.0, 1.0), at(1.0, 0.0), at(2.0, 1.0)])?; // x = (t - 1)²
/// let body = MovingBody::new(motion.into()).with_law(TimeLaw::ConstantSpeed, 4.0)?;
/// let reversals = body.schedule()?.reversals();
/// assert!(reversals.len() == 1 && reversals[0].inside);
/// assert!((reversals[0].time - 2.0).abs() < 1e-6 && (reversals[0].velocity_jump - 1.0).abs() < 1e-6);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MotionReversal {
    /// The span, from 0; at a joint the one that starts there.
    pub span: usize,
    /// The time, from the start of the motion.
    pub time: f64,
    /// By how much the velocity of the tool jumps.
    pub velocity_jump: f64,
    /// By how much the angular velocity jumps, radians per unit of time.
    pub angular_velocity_jump: f64,
    /// True within a span, false where one starts.
    pub inside: bool,
}

impl Schedule<'_> {
    /// Where the law has the velocity turn over, in the order of time; none by the times of the poses.
    #[must_use]
    pub fn reversals(&self) -> Vec<MotionReversal> {
        if self.timing().law() == TimeLaw::AsGiven {
            return Vec::new();
        }
        let mut found = Vec::new();
        let mut arrived: Option<SpanEnd> = None;
        for (span, speeds) in self.timing().speeds_of_spans() {
            let [Some(&(from, at_start)), Some(&(to, at_end))] = [speeds.first(), speeds.last()] else { continue };
            let cells: Vec<f64> = speeds.iter().map(|place| place.0).collect();
            let beside = BESIDE * (to - from);
            let average = self.timing().way_between(from, to) / (to - from);
            let slow = |speed: f64| speed <= SLOW * average;
            if let Some(end) = arrived.filter(|end| end.slow && slow(at_start)) {
                found.extend(self.turned_over(span, [end.time - end.beside, from, from + beside], false));
            }
            for k in 0..speeds.len() {
                let (before, after) = (k.saturating_sub(1), (k + 1).min(speeds.len() - 1));
                let speed = speeds[k].1;
                if !slow(speed) || speed > speeds[before].1 || speed >= speeds[after].1 && after != k {
                    continue;
                }
                let in_span = |time: f64| self.timing().way_speed_at(time.min(to.next_down()));
                let place = GoldenSection::lowest(in_span, [cells[before], cells[after]], SECTIONS);
                if place - from > AT_JOINT * (to - from) && to - place > AT_JOINT * (to - from) {
                    let sides = [(place - beside).max(from), place, (place + beside).min(to.next_down())];
                    found.extend(self.turned_over(span, sides, true));
                }
            }
            arrived = Some(SpanEnd { time: to, beside, slow: slow(at_end) });
        }
        found
    }

    /// A reversal at the middle one of three times of the motion, if the directions at the others are opposite rather than the same.
    fn turned_over(&self, span: usize, [before, place, after]: [f64; 3], inside: bool) -> Option<MotionReversal> {
        let timing = self.timing();
        let ([v0, w0], [v1, w1]) = (timing.by_way(before), timing.by_way(after));
        let arm = timing.arm();
        let turns_over = v0.dot(v1) + w0.dot(w1) * arm * arm < 0.0;
        let fraction = timing.fraction_at(place);
        let speed = timing.way_by_part(fraction) / self.duration();
        let [velocity_jump, angular_velocity_jump] = [v1 - v0, w1 - w0].map(Vec3::length).map(|jump| jump * speed);
        let time = fraction * self.duration();
        turns_over.then_some(MotionReversal { span, time, velocity_jump, angular_velocity_jump, inside })
    }
}

/// How a body comes to the end of a span.
#[derive(Clone, Copy)]
struct SpanEnd {
    time: f64,
    beside: f64,
    slow: bool,
}
