//! Why no motion was put through the poses, or none was timed.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why no motion was put through the poses, or none was timed.
    ///
    /// ```
    /// use cyclide::{Error, MotionError};
    /// let error: Error = MotionError::StudyFormVanishes { measured: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "study-form-vanishes");
    /// ```
    pub enum MotionError: Error {
        /// No motion of this kind takes a pose at its time together with the others.
        UnattainablePose {
            /// Which pose, from 0.
            index: usize,
            /// The factor of the pose against the largest, below the limit; or by how much the pose is missed, above it.
            share: f64,
            /// The limit.
            limit: f64,
        }
        reason "unattainable-pose";
        at *index;
        when *share > *limit, says "no motion of this degree takes all poses: pose {index} is missed by {share} of \
            the size, limit {limit}";
        says "no motion of this degree takes pose {index} with the others: its factor against the largest is \
            {share}, limit {limit}; take a spline, or another time for it";

        /// On its way a motion comes to where a dual quaternion is no displacement: the body would go through infinity.
        ThroughExceptionalPoint {
            /// When.
            time: f64,
            /// The share `|p|²/(|p|² + |r|²)` there, with lengths in units of the size of the poses.
            share: f64,
            /// What is left of the dual quaternion there, squared, against the sum of the lengths of what it is summed of: 0 where
            /// both of its parts vanish.
            remainder: f64,
            /// Shares and remainders up to this are refused.
            limit: f64,
        }
        reason "motion-through-exceptional-point";
        when *share <= *limit, says "the motion of least degree runs out to infinity at {time}: the share of the \
            rotation there is {share}, limit {limit}; take a spline, or other times";
        says "the motion of least degree has no pose at {time}: its terms cancel there, what is left of them is \
            {remainder} of their squares, limit {limit}; take a spline, or other times";

        /// Between two poses the rotation is so large that its direction is lost.
        RotationTooLarge {
            /// Which span, from 0.
            span: usize,
            /// Smallest length of the quaternion on the way.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "rotation-too-large";
        at *span;
        says "span {span} turns so far that its direction is lost: the quaternion gets as short as {length}, limit \
            {limit}; insert a pose";

        /// No motion of degree 3 takes the four poses one after the other (at the cross-ratio asked for).
        NoCubicMotion {
            /// Discriminant of the equation of the cross-ratio; negative: there is none.
            discriminant: f64,
            /// The cross-ratios at which there are motions; those between 0 and 1 take the poses one after the other.
            roots: Vec<f64>,
        }
        reason "no-cubic-motion";
        when roots.is_empty(), says "no motion of degree 3 takes these four poses, at whatever times: the \
            discriminant of its equation is {discriminant}, at least 0 is needed";
        says "no motion of degree 3 takes these four poses one after the other at this cross-ratio of times: there \
            are some at {} only, and between 0 and 1 is needed", joined(&roots);

        /// Poses are planar, spherical or translated against each other: what should follow from how they screw is not determined.
        StudyFormVanishes {
            /// Largest value of the Study form between two poses, over their size.
            measured: f64,
            /// Values up to this are zero.
            limit: f64,
        }
        reason "study-form-vanishes";
        says "the poses are planar, spherical or moved without a turn against each other (Study form {measured}, \
            limit {limit}): motions of degree 3 are not determined by them; take a spline";

        /// What needs a rational motion is asked of one that is not: the points of a screw motion run on helices.
        NotRational
        reason "motion-not-rational";
        says "the points of a screw motion run on helices, which no rational curve is; take a spline";

        /// A time law by the way of a point is asked of a motion that does not move it.
        AtRest {
            /// Length of the whole way.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "motion-at-rest";
        says "the motion is at rest: the way that should be gone is {length} long, which must be above {limit}: \
            name a point that moves, or an arm";

        /// A time law by the way of a point, or times by it, have no time for a span on which the body turns on the spot, or rests.
        SpanWithoutWay {
            /// Which span, from 0.
            span: usize,
            /// By how much the body turns there, radians.
            turn: f64,
            /// Length of the way.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "span-without-way";
        at *span;
        when *turn > 0.0, says "span {span}, from pose {span} to the next, turns by {} degrees on the spot: its way \
            is {length} long, which must be above {limit}, and what goes by the way has no time for it: give an \
            `arm`, the length by which a turn counts as way, or name a `tool` that moves", degrees(*turn);
        says "span {span}, from pose {span} to the next, rests: its way is {length} long, which must be above \
            {limit}, and what goes by the way has no time for it: give times";
    }
}

/// Numbers in a row.
fn joined(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| ShortNumber(*x).to_string()).collect();
    numbers.join(" and ")
}
