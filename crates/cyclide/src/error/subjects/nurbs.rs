//! Why a rational curve or surface was refused.

use crate::table::table;

table! {
    /// Why a rational curve or surface was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::NurbsError};
    /// let error: Error = NurbsError::WeightNotPositive { index: 1, weight: 0.5 }.into();
    /// assert_eq!(error.reason(), "weight-not-positive");
    /// ```
    pub enum NurbsError: Error {
        /// A knot is less than the one before.
        KnotsDecrease {
            /// Which knot, from 0.
            index: usize,
            /// Its value.
            knot: f64,
            /// The knot before, which it must not be below.
            before: f64,
        }
        reason "knots-decrease";
        at *index;
        entry "knots";
        says "knot {index} is {}, less than the previous one, {}: knots must not decrease", *knot, *before;

        /// A knot's multiplicity is so high that the curve is disconnected there, or a control point has no effect.
        KnotMultiplicity {
            /// The first knot of that value, from 0.
            index: usize,
            /// Its multiplicity.
            multiplicity: usize,
            /// Largest multiplicity accepted.
            limit: usize,
        }
        reason "knot-multiplicity";
        at *index;
        entry "knots";
        says "the knot at {index} has multiplicity {multiplicity}, maximum {limit}: the curve would be disconnected \
            there";

        /// The knots, weights and points of a spline are inconsistent.
        NotASpline {
            /// What is inconsistent.
            detail: &'static str,
        }
        reason "not-a-spline";
        field "knots";
        says "not a valid spline: {detail}";

        /// A rational weight that must be positive is not.
        WeightNotPositive {
            /// Which weight, from 0.
            index: usize,
            /// Its value.
            weight: f64,
        }
        reason "weight-not-positive";
        at *index;
        entry "weights";
        says "weight {index} is {weight}: rational weights must be positive here";

        /// Weights of a rational curve differ so much that its points cannot be distinguished by their parameters.
        WeightsUneven {
            /// One of the two weights, from 0.
            first: usize,
            /// The other one.
            second: usize,
            /// The larger over the smaller one.
            ratio: f64,
            /// The largest ratio accepted: 1e9 from one to the next, 1e18 over two steps, and 1e150 of any two.
            limit: f64,
        }
        reason "weights-uneven";
        at *second;
        entry "weights";
        says "weights {first} and {second} differ by a factor of {ratio}, maximum {limit}: double precision cannot \
            resolve the curve between them; reduce the ratio (weights far above their neighbors pull the curve onto \
            the control polygon: use segments for that)";

        /// The degree of a surface is too high for other programs.
        DegreeTooHigh {
            /// The degree needed.
            degree: usize,
            /// Largest degree allowed.
            limit: usize,
        }
        reason "degree-too-high";
        field "degree";
        says "the degree would be {degree}, maximum {limit}: use fewer points, or curves of lower degrees (segments \
            have 1, arcs 2, fair splines 4)";
    }
}
