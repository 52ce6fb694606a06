//! What should be known of a motion through poses, and of its time law.

use crate::shape_change::degrees;
use crate::table::table;
use crate::warning::{SpikeRemedy, SwingPart};

table! {
    /// What should be known of a motion through poses, and of its time law.
    ///
    /// ```
    /// use cyclide::{MotionWarning, Warning};
    /// let warning: Warning = MotionWarning::RestsPassedOver { span: 2, count: 2 }.into();
    /// assert_eq!(warning.reason(), "rests-passed-over");
    /// ```
    pub enum MotionWarning {
        /// The motion gets very fast within a span: a body on a motion of least degree runs near infinity there, or turns over in a moment.
        SpeedSpike {
            /// The span, from 0.
            span: usize,
            /// The time from the start of the motion.
            time: f64,
            /// How many times as fast as on average over the span.
            ratio: f64,
            /// True of the angular speed, false of the speed of the tool.
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

        /// Under a law by path length a body turns in a span with a short path, which takes little time.
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

        /// Under a law by path length a body does not rest between poses that are the same.
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
            /// How many such places there are.
            count: usize,
            /// By how much the velocity of the tool jumps there.
            velocity_jump: f64,
        }
        reason "motion-reverses";
        at *span;
        says "the path of the tool turns back at {count} location(s), the first {time} seconds from the start of the \
            motion, on span {span}: a law by path length keeps the speed, so the velocity jumps by {velocity_jump}; \
            use times of the poses that fit the path lengths (`as-given`), or change the poses";

        /// A spline motion starts or ends a span much faster than it goes there on average: it runs beyond the poses and back in between.
        Swings {
            /// The span where it is most so, from 0.
            span: usize,
            /// How many spans there are of which that is true.
            count: usize,
            /// How many times as fast; infinite where the poses are one.
            ratio: f64,
            /// Of which part that is true.
            part: SwingPart,
            /// How far it runs beyond the poses there: a length, or radians of a turn.
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

        /// Turns carry the origin of a spline motion away from the straight lines between its poses, as on an arc about the axis of
        /// a turn, by more than its places do by themselves.
        LeavesChords {
            /// The span where it gets farthest away, from 0.
            span: usize,
            /// How many spans there are of which that is true.
            count: usize,
            /// How far from the straight line.
            distance: f64,
            /// How long that is.
            chord: f64,
            /// Parts of the longest chord beside a span above this are reported.
            limit: f64,
        }
        reason "leaves-chords";
        at *span;
        says "the rotation of the body carries its origin off the straight line between the poses in {count} \
            span(s), most from pose {span} to the next, by {distance} over a distance of {chord}: use the kind \
            `linear`, which goes straight from pose to pose, or add poses in between";

        /// Blends at the poses of a motion are shorter than the radius that was asked for: they take half of the path to the next
        /// pose at most.
        BlendsShortened {
            /// The pose where the blend is the shortest, from 0.
            pose: usize,
            /// How many poses there are of which that is true.
            count: usize,
            /// The radius there.
            radius: f64,
            /// The radius that was asked for.
            asked: f64,
        }
        reason "blends-shortened";
        at *pose;
        says "the blends at {count} pose(s) are shorter than the radius of {asked}, since a blend takes at most half \
            of the path to the next pose: radius {radius} at pose {pose}; give a smaller radius, or move the poses \
            apart";

        /// A pose is turned by half a turn against the one before, for which both directions are equally short.
        HalfTurn {
            /// The first such pose, from 0.
            pose: usize,
            /// How many there are.
            count: usize,
            /// How much is missing to half a turn there, radians.
            off: f64,
            /// Angles up to this are reported.
            limit: f64,
        }
        reason "half-turn";
        at *pose;
        says "{count} pose(s), the first is pose {pose}, differ from the previous one by half a turn, up to \
            rounding: both directions are equally short, and the sign or the last digit of the input decides; add a \
            pose in between";

        /// Poses that are planar, spherical, translated or of one motion of degree 2 except for the rounding of their digits were
        /// taken for that.
        PosesRounded {
            /// What they are off, in their size.
            off: f64,
            /// Study forms up to this are taken for rounding.
            limit: f64,
        }
        reason "poses-rounded";
        says "except for {off} of their size the poses are planar, spherical, translated or on one motion of degree \
            2, and are treated as such (Study forms of up to {limit} count as rounding)";
    }
}
