//! Why no motion through the poses, or no time law of it, was made.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why no motion through the poses, or no time law of it, was made.
    ///
    /// ```
    /// use cyclide::{Error, error::MotionError};
    /// let error: Error = MotionError::StudyFormVanishes { measured: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "study-form-vanishes");
    /// ```
    pub enum MotionError: Error {
        /// No motion of this kind passes through a pose at its time and through the other poses.
        UnattainablePose {
            /// Which pose, from 0.
            index: usize,
            /// The factor of the pose relative to the largest, below the limit; or the relative distance by which the pose is missed, above it.
            share: f64,
            /// The limit.
            limit: f64,
        }
        reason "unattainable-pose";
        at *index;
        when *share > *limit, says "no motion of this degree passes through all poses: it misses pose {index} by \
            {share} of the size, limit {limit}; use a spline, or other times";
        says "no motion of this degree passes through pose {index} and the other poses: its relative factor is \
            {share}, limit {limit}; use a spline, or another time for it";

        /// A motion passes a dual quaternion that is not a displacement: the body would pass through infinity.
        ThroughExceptionalPoint {
            /// When.
            time: f64,
            /// The share `|p|²/(|p|² + |r|²)` there, with lengths in units of the size of the poses.
            share: f64,
            /// Square of the dual quaternion there, relative to the sum of the squares of its terms: 0 where both of its parts vanish.
            remainder: f64,
            /// Shares and remainders up to this are refused.
            limit: f64,
        }
        reason "motion-through-exceptional-point";
        when *share <= *limit, says "the motion of lowest degree passes through infinity at time {time}: the \
            rotation has a share of {share} there, limit {limit}; use a spline, or other times";
        says "the motion of lowest degree has no pose at time {time}: its terms cancel to {remainder} of their \
            squares there, limit {limit}; use a spline, or other times";

        /// The rotation between two poses is so large that its direction is undefined.
        RotationTooLarge {
            /// Which span, from 0.
            span: usize,
            /// Smallest length of the quaternion in the span.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "rotation-too-large";
        at *span;
        says "span {span} rotates so far that its direction is undefined: the quaternion shrinks to length {length}, \
            limit {limit}; insert a pose";

        /// No motion of degree 3 passes through the four poses in order (at the requested cross-ratio).
        NoCubicMotion {
            /// Discriminant of the equation of the cross-ratio; negative: there is none.
            discriminant: f64,
            /// The cross-ratios at which motions exist; those between 0 and 1 pass through the poses in order.
            roots: Vec<f64>,
        }
        reason "no-cubic-motion";
        when roots.is_empty(), says "no motion of degree 3 passes through these four poses at any times: the \
            discriminant is {discriminant}, must be at least 0; use a spline";
        when !roots.iter().any(|x| (0.0..1.0).contains(x)), says "no motion of degree 3 passes through these four poses \
            in order at any times: motions exist only at the cross-ratio(s) {} of the times, which must be between 0 \
            and 1; use a spline", joined(&roots);
        says "no motion of degree 3 passes through these four poses in order at this cross-ratio of times: motions \
            exist only at {}; use one between 0 and 1", joined(&roots);

        /// The relative motions of the poses are planar, spherical or translations, which do not determine a motion of degree 3.
        StudyFormVanishes {
            /// Largest value of the Study form between two poses, over their size.
            measured: f64,
            /// Values up to this are zero.
            limit: f64,
        }
        reason "study-form-vanishes";
        says "the relative motions of the poses are planar, spherical or translations (Study form {measured}, limit \
            {limit}), so they do not determine a motion of degree 3; use a spline";

        /// A rational motion is required, and this one is not: the points of a screw motion move on helices.
        NotRational
        reason "motion-not-rational";
        says "the motion is not rational: the points of a screw motion move on helices; use a spline";

        /// A time law by the path length of a point is given for a motion that does not move the point.
        AtRest {
            /// Length of the whole path.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
            /// True if the body does not turn either: no other point of it moves.
            still: bool,
        }
        reason "motion-at-rest";
        when *still, says "the body is at rest all the time: path length {length} must exceed {limit}; give poses that \
            differ, or use the time law `as-given`, which allows a rest";
        says "the motion is at rest: path length {length} must exceed {limit}; name a point that moves, or give an \
            `arm`";

        /// A time law by the path length of a point, or times by it, give no time to a span in which the body rotates in place or rests.
        SpanWithoutWay {
            /// Which span, from 0.
            span: usize,
            /// By how much the body turns there, radians.
            turn: f64,
            /// Length of the path.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "span-without-way";
        at *span;
        when *turn > 0.0, says "span {span}, from pose {span} to the next, rotates by {} degrees in place: its path \
            length {length} must exceed {limit}, or a law by path length gives it no time; give an `arm`, the \
            characteristic length that weights rotation against translation, or name a `tool` that moves",
            degrees(*turn);
        says "span {span}, from pose {span} to the next, is at rest: its path length {length} must exceed {limit}, \
            or a law by path length gives it no time; give each pose a time instead, or leave one of the two out";
    }
}

/// Numbers in a row.
fn joined(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| ShortNumber(*x).to_string()).collect();
    numbers.join(" and ")
}
