//! Warnings about motions through poses and their time laws.

use crate::shape_change::degrees;
use crate::table::table;
use crate::warning::{SpikeRemedy, SwingPart};

table! {
    /// Warnings about motions through poses and their time laws.
    ///
    /// ```
    /// use cyclide::{Warning, warning::MotionWarning};
    /// let warning: Warning = MotionWarning::RestsPassedOver { span: 2, count: 2 }.into();
    /// assert_eq!(warning.reason(), "rests-passed-over");
    /// ```
    pub enum MotionWarning {
        /// The motion becomes very fast within a span: a body on a motion of lowest degree passes near infinity there, or turns over suddenly.
        SpeedSpike {
            /// The span, from 0.
            span: usize,
            /// The time from the start of the motion.
            time: f64,
            /// The speed there, relative to the average over the span.
            ratio: f64,
            /// True for the angular speed, false for the speed of the tool.
            turning: bool,
            /// Ratios above this are reported.
            limit: f64,
            /// What helps.
            remedy: SpikeRemedy,
        }
        reason "speed-spike";
        at *span;
        says "span {span}: {time} seconds from the start of the motion the body {} {ratio} times as fast as on \
            average over the span; {}", if *turning { "rotates" } else { "moves" }, remedy.advice();

        /// Under a law by path length a body rotates in a span with a short path, which takes little time.
        TurnsNearlyInPlace {
            /// The span, from 0.
            span: usize,
            /// By how much it turns there, radians.
            turn: f64,
            /// How long that takes.
            seconds: f64,
            /// How many times as fast as on average over the motion.
            ratio: f64,
            /// Ratios above this are reported.
            limit: f64,
        }
        reason "turns-nearly-in-place";
        at *span;
        says "span {span}, from pose {span} to the next: the body rotates by {} degrees within {seconds} seconds, \
            {ratio} times as fast as on average, since the law goes by the path of the tool, which is very short \
            there; give an `arm`, the characteristic length that weights rotation against translation, or a larger \
            one", degrees(*turn);

        /// Under a law by path length a body does not rest between equal poses.
        RestsPassedOver {
            /// The first such span, from 0.
            span: usize,
            /// How many there are.
            count: usize,
        }
        reason "rests-passed-over";
        at *span;
        says "the body rests in {count} span(s), the first from pose {span} to the next, but a law by path length \
            gives no time to a rest and does not stop there; use the times of the poses (`as-given`), or make a \
            motion of each part";

        /// Under a law by path length a body keeps its speed where the path turns back.
        Reverses {
            /// The first such span, from 0.
            span: usize,
            /// When, from the start of the motion.
            time: f64,
            /// How many such locations there are.
            count: usize,
            /// By how much the velocity of the tool jumps there.
            velocity_jump: f64,
        }
        reason "motion-reverses";
        at *span;
        says "the path of the tool turns back at {count} location(s), the first {time} seconds from the start of the \
            motion, on span {span}: a law by path length keeps the speed, so the velocity jumps by {velocity_jump}; \
            use times of the poses that fit the path lengths (`as-given`), or change the poses";

        /// A spline motion starts or ends a span much faster than it moves there on average: it overshoots the poses.
        Swings {
            /// The span with the largest ratio, from 0.
            span: usize,
            /// How many such spans there are.
            count: usize,
            /// How many times as fast; infinite where the two poses are equal.
            ratio: f64,
            /// Which part of the motion overshoots.
            part: SwingPart,
            /// How far it overshoots the poses there: a length, or radians.
            beyond: f64,
            /// Ratios above this are reported.
            limit: f64,
        }
        reason "motion-swings";
        at *span;
        when ratio.is_finite(), says "the motion overshoots its poses in {count} span(s), most from pose {span} to \
            the next, where {} starts or ends {ratio} times as fast as on average, and overshoots by {beyond}{}: use \
            the kind `linear`, which goes straight from pose to pose, times that fit the path lengths, or an extra \
            pose (the same pose twice is a rest)", part.words(), part.unit();
        says "the motion overshoots its poses in {count} span(s), most from pose {span} to the next, where {} is the \
            same at both poses but moves by {beyond}{} in between: use the kind `linear`, which goes straight from \
            pose to pose, times that fit the path lengths, or an extra pose (the same pose twice is a rest)",
            part.words(),
            part.unit();

        /// Rotation carries the origin of a spline motion away from the straight lines between its poses, as on an arc about the
        /// axis of rotation, by more than its positions alone do.
        LeavesChords {
            /// The span where it gets farthest away, from 0.
            span: usize,
            /// How many such spans there are.
            count: usize,
            /// How far from the straight line.
            distance: f64,
            /// Length of that line.
            chord: f64,
            /// Parts of the longest chord beside a span above this are reported.
            limit: f64,
        }
        reason "leaves-chords";
        at *span;
        says "the rotation of the body carries its origin off the straight line between the poses in {count} \
            span(s), most from pose {span} to the next, by {distance} over a distance of {chord}: use the kind \
            `linear`, which goes straight from pose to pose, or add poses in between";

        /// Blends at the poses of a motion are shorter than the given radius: they take at most half of the time to the next pose.
        BlendsShortened {
            /// The pose where the blend is the shortest, from 0.
            pose: usize,
            /// How many such poses there are.
            count: usize,
            /// The radius there.
            radius: f64,
            /// The given radius.
            asked: f64,
        }
        reason "blends-shortened";
        at *pose;
        says "the blends at {count} pose(s) are shorter than the radius of {asked}, since a blend takes at most half \
            of the time to the next pose: radius {radius} at pose {pose}; give a smaller radius, or move the poses \
            apart";

        /// A pose differs from the previous one by half a turn, for which both directions are equally short.
        HalfTurn {
            /// The first such pose, from 0.
            pose: usize,
            /// How many there are.
            count: usize,
            /// The difference from half a turn there, radians.
            off: f64,
            /// Angles up to this are reported.
            limit: f64,
        }
        reason "half-turn";
        at *pose;
        says "{count} pose(s), the first is pose {pose}, differ from the previous one by half a turn, up to \
            rounding: both directions are equally short, and the sign or the last digit of the input decides; add a \
            pose in between";

        /// Poses that are planar, spherical, translated or on one motion of degree 2, except for the rounding of their digits,
        /// were treated as such.
        PosesRounded {
            /// Their deviation, relative to their size.
            off: f64,
            /// Study forms up to this are taken for rounding.
            limit: f64,
        }
        reason "poses-rounded";
        says "except for {off} of their size the poses are planar, spherical, translated or on one motion of degree \
            2, and are treated as such (Study forms of up to {limit} count as rounding)";
    }
}
