//! Why a torus, or a point, curve or seam on one, was refused.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a torus, or a point, curve or seam on one, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::TorusError};
    /// let error: Error = TorusError::ZeroCoordinate { index: 1 }.into();
    /// assert_eq!(error.reason(), "zero-coordinate");
    /// ```
    pub enum TorusError: Error {
        /// The radius of the tube of a torus is not below that of its center circle.
        NotARingTorus {
            /// Radius of the center circle of the tube.
            major: f64,
            /// Radius of the tube: must be above 0 and below the other.
            minor: f64,
        }
        reason "not-a-ring-torus";
        says "not a ring torus: the radius {minor} of the tube must be above 0 and below the radius {major} of its \
            center circle";

        /// A complex coordinate of a point of a torus is zero.
        ZeroCoordinate {
            /// Which of the four, from 0.
            index: usize,
        }
        reason "zero-coordinate";
        at *index;
        says "complex coordinate {index} of a point on the torus is zero, must be nonzero";

        /// A point is on the axis of a torus, where the longitude is undefined.
        PointOnAxis {
            /// Which point, from 0.
            index: usize,
            /// Its distance from the axis.
            distance: f64,
            /// Distances up to this are refused.
            limit: f64,
        }
        reason "point-on-axis";
        at *index;
        says "point {index} is on the axis of the torus, where the longitude is undefined: distance {distance}, \
            limit {limit}";

        /// A point is on the center circle of the tube of a torus, where the angle round the tube is undefined.
        PointOnCoreCircle {
            /// Which point, from 0.
            index: usize,
            /// Its distance from the circle.
            distance: f64,
            /// Distances up to this are refused.
            limit: f64,
        }
        reason "point-on-core-circle";
        at *index;
        says "point {index} is on the center circle of the tube, where the angle round the tube is undefined: \
            distance {distance}, limit {limit}";

        /// A point that should lie on a torus does not.
        PointOffTorus {
            /// Which point, from 0.
            index: usize,
            /// Its distance from the torus.
            distance: f64,
            /// Largest distance accepted.
            limit: f64,
        }
        reason "point-off-torus";
        at *index;
        says "point {index} is {distance} off the torus, limit {limit}";

        /// A coordinate that must be monotone would turn back, or stop at an end of a step.
        NotMonotone {
            /// Which of the two coordinates, from 0.
            coordinate: usize,
            /// The step over the span, radians.
            step: f64,
            /// The derivatives at its ends, by the parameter of the curve.
            slopes: [f64; 2],
        }
        reason "not-monotone";
        says "coordinate {coordinate} would have to turn back or stop: step {step}, slopes {} and {} at its ends",
            ShortNumber(slopes[0]), ShortNumber(slopes[1]);

        /// A coordinate changes by more than half a turn within one span.
        SpanTooLarge {
            /// Which of the two coordinates, from 0.
            coordinate: usize,
            /// The step, radians.
            step: f64,
            /// Steps must be below this.
            limit: f64,
        }
        reason "span-too-large";
        says "coordinate {coordinate} changes by {step} radians in one span, must be below {limit}: add a point in \
            between";

        /// No two pieces of the given types join the ends of a segment.
        NoTwoTypeSolution {
            /// Which segment, from 0.
            segment: usize,
            /// The cosine of the angle at the joint; within 1, or infinite, where no solution has the given directions.
            cosine: f64,
        }
        reason "no-two-type-solution";
        at *segment;
        field "method";
        when cosine.abs() > 1.0 && cosine.is_finite(), says "no two pieces of these types join the ends of segment \
            {segment}: the angle at their joint would have the cosine {cosine}, maximum 1; move a point";
        says "no two pieces of these types join the ends of segment {segment} in the given directions: each \
            coordinate of a type must keep one direction, that of its speeds at both ends";

        /// The numbers of turns about the axis and round the tube have a common divisor: the curve would retrace itself.
        NotCoprime {
            /// The turns.
            turns: [i32; 2],
            /// Their greatest common divisor; 0 if both are 0.
            divisor: u32,
        }
        reason "not-coprime";
        field "turns";
        says "{} and {} turns have greatest common divisor {divisor}, must be 1: the curve would retrace itself, or \
            not move at all", turns[0], turns[1];

        /// A seam along a curve on a torus is too wide for a bend of the curve.
        SeamTooWide {
            /// Which piece of the curve, from 0.
            piece: usize,
            /// The point on it.
            point: [f64; 3],
            /// Width of the seam.
            width: f64,
            /// The largest width that fits everywhere.
            limit: f64,
        }
        reason "seam-too-wide";
        field "width";
        says "the seam is {width} wide, maximum {limit}: it folds on the inner side of the bend of its curve at \
            {point}, in piece {piece}; use a narrower seam, or a curve that bends less along the torus";

        /// Non-adjacent parts of a seam along a curve on a torus overlap.
        SeamMeetsItself {
            /// Which piece of the curve, from 0.
            first: usize,
            /// The other one; the same if it closes up.
            second: usize,
            /// A point of both parts.
            point: [f64; 3],
            /// Distance of the curve from itself there.
            distance: f64,
            /// Width of the seam.
            width: f64,
        }
        reason "seam-meets-itself";
        at *second;
        field "width";
        says "the seam intersects itself at {point}: pieces {first} and {second} of its curve are {distance} apart \
            there, and it is {width} wide; use a narrower seam, or a curve that stays away from itself";
    }
}
