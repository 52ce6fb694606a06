//! Why a pose, or a list of them, was refused.

use crate::table::table;

table! {
    /// Why a pose, or a list of them, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::PoseError};
    /// let error: Error = PoseError::ZeroRotation { index: 1 }.into();
    /// assert_eq!(error.reason(), "zero-rotation");
    /// ```
    pub enum PoseError: Error {
        /// A rotation quaternion is zero.
        ZeroRotation {
            /// Which rotation, from 0.
            index: usize,
        }
        reason "zero-rotation";
        at *index;
        says "rotation {index} is zero, must be a nonzero quaternion";

        /// A matrix is not a displacement: its columns are not orthonormal and right-handed, or its last row is not `0 0 0 1`.
        NotARotation {
            /// Largest deviation of a length, a scalar product, the determinant or an entry of the last row.
            off: f64,
            /// Deviations above this are refused.
            limit: f64,
        }
        reason "not-a-rotation";
        says "the matrix is not a displacement: its first three columns must be orthonormal and right-handed and its \
            last row 0 0 0 1; they are off by {off}, limit {limit}; write more decimals, without scaling or \
            mirroring";

        /// A dual quaternion is not a displacement: its parts are not perpendicular.
        NotOnStudyQuadric {
            /// `|p·r| / (|p| |r|)`.
            product: f64,
            /// Products above this are refused.
            limit: f64,
        }
        reason "not-on-study-quadric";
        says "the dual quaternion is not a displacement: its parts are not perpendicular, relative product \
            {product}, limit {limit}";

        /// The number of poses does not suit the motion.
        WrongPoseCount {
            /// Number of poses given.
            given: usize,
            /// Number of poses needed.
            needed: usize,
            /// True if more are accepted.
            or_more: bool,
        }
        reason "wrong-pose-count";
        when *or_more, says "{given} poses given, at least {needed} needed";
        says "{given} poses given, {needed} needed";

        /// The time of a pose is not after that of the previous one.
        ParametersNotIncreasing {
            /// Which parameter, from 0.
            index: usize,
            /// Its value.
            value: f64,
            /// The value before it.
            before: f64,
        }
        reason "parameters-not-increasing";
        at *index;
        entry "parameters";
        says "the parameters do not increase: number {index} is {value}, the previous one {before}";
    }
}
