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
        says "span {span}: {time} seconds from its start the body {} {ratio} times as fast as on average over the \
            span: the motion has a spike there; {}", if *turning { "turns" } else { "runs" }, remedy.advice();

        /// Under a law that goes by the way a body turns on a span with little way, which takes little time.
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
        says "span {span}, from pose {span} to the next: the body turns by {} degrees within {seconds} seconds, \
            {ratio} times as fast as on average, as its tool has hardly a way there, by which the law goes: give \
            an `arm`, the length by which turns count as way, or a larger one", degrees(*turn);

        /// Under a law that goes by the way a body does not rest between poses that are the same.
        RestsPassedOver {
            /// The first such span, from 0.
            span: usize,
            /// How many there are.
            count: usize,
        }
        reason "rests-passed-over";
        at *span;
        says "in {count} span(s) the body rests, first from pose {span} to the next: a law that goes by the way has \
            no time for that, and it does not stop there; go by the times of the poses (`as-given`), or make a \
            motion of each part";

        /// Under a law that goes by the way a body runs on at its speed where the way turns back.
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
        says "in {count} place(s) the way of the tool turns back, first {time} seconds from its start, on span \
            {span}: a law that goes by the way keeps its speed there, and the velocity jumps by {velocity_jump}; \
            go by times of the poses that fit the ways (`as-given`), or change the poses";

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
        when ratio.is_finite(), says "in {count} span(s) the motion runs beyond its poses and back, most from pose \
            {span} to the next, where {} starts or ends {ratio} times as fast as it goes on average, and runs \
            {beyond}{} beyond: the kind `linear` goes straight from pose to pose; or give times that fit the ways, \
            or a pose more (the same pose twice is a rest)", part.words(), part.unit();
        says "in {count} span(s) the motion runs beyond its poses and back, most from pose {span} to the next, \
            where {} goes on though it is the same at both, by {beyond}{}: the kind `linear` goes straight from \
            pose to pose; or give times that fit the ways, or a pose more (the same pose twice is a rest)",
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
        says "in {count} span(s) the turns of the body carry its origin away from the straight line between the \
            poses, most from pose {span} to the next, by {distance} on a distance of {chord}: the kind `linear` \
            goes straight from pose to pose; or give poses in between";

        /// Blends at the poses of a motion are shorter than the radius that was asked for: they take half of the way to the next
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
        says "the blends at {count} pose(s) are shorter than the radius of {asked}: they take half of the way to \
            the next pose at most, at pose {pose} {radius}; give a smaller radius, or poses farther apart";

        /// A pose is turned by half a turn against the one before, for which both ways round are as short.
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
        says "{count} pose(s), first pose {pose}, are turned by half a turn against the one before, up to rounding: \
            both ways round are as short, and which one the body takes hangs on the sign or the last digit of what \
            the pose is written with; give a pose in between";

        /// Poses that are planar, spherical, translated or of one motion of degree 2 but for the digits they are written with were
        /// taken for that.
        PosesRounded {
            /// What they are off, in their size.
            off: f64,
            /// Study forms up to this are taken for rounding.
            limit: f64,
        }
        reason "poses-rounded";
        says "but for {off} of their size the poses are planar, spherical, moved without a turn or of one motion of \
            degree 2, and are taken for that (Study forms of up to {limit} count as rounded digits)";
    }
}
