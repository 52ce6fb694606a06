//! Why no curve was interpolated.

use crate::error::words::points_in_words;
use crate::table::table;

table! {
    /// Why no curve was interpolated.
    ///
    /// ```
    /// use cyclide::{Error, error::InterpolationError};
    /// let error: Error = InterpolationError::EvenPointCount { given: 2 }.into();
    /// assert_eq!(error.reason(), "even-point-count");
    /// ```
    pub enum InterpolationError: Error {
        /// A curve of degree n takes an odd number of conditions, `2n + 1`.
        EvenPointCount {
            /// Number of conditions given: points, and derivatives at them.
            given: usize,
        }
        reason "even-point-count";
        says "{given} conditions given, but a curve of degree n needs an odd number, 2n + 1; add or remove a point, \
            or use a Moebius spline, which takes any number";

        /// Two points, or two poses, have the same parameter.
        RepeatedParameter {
            /// Which of them, from 0.
            first: usize,
            /// The other one.
            second: usize,
            /// The parameter of the second; that of the first is equal to it, up to rounding on the scale of all.
            value: f64,
        }
        reason "repeated-parameter";
        at *second;
        entry "parameters";
        says "parameters {first} and {second} are both {value}; they must differ";

        /// The only curve of the degree that fits the other points, at their parameters, misses these.
        UnattainablePoint {
            /// Which points, from 0, rising.
            points: Vec<usize>,
            /// The relative weight of the first one, or its distance from the curve relative to the size of the data.
            measured: f64,
            /// The weight must be above this, the distance below it.
            limit: f64,
        }
        reason "unattainable-point";
        at points.first().copied();
        says "{} cannot be reached: at their parameters, the other points lie on a curve of lower degree that misses \
            them (measured {measured}, limit {limit}); move a point or change the parameters", points_in_words(&points);

        /// The circular arcs that leave two points along their tangents have opposite directions, so none is halfway.
        OppositeArcs {
            /// Length of the sum of their unit tangents at the start.
            measured: f64,
            /// Lengths below this are refused.
            limit: f64,
        }
        reason "opposite-arcs";
        says "the circles along the two tangents run in opposite directions (length of the sum of their unit tangents \
            {measured}, minimum {limit}): turn a tangent, or add a point in between";
    }
}
