//! Why a spherical cube, or the block in it, was refused.

use crate::error::words::parameters;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a spherical cube, or the block in it, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::VolumeError};
    /// let error: Error = VolumeError::ThroughInfinity { at: [1.0, 2.0, 0.0] }.into();
    /// assert_eq!(error.reason(), "volume-through-infinity");
    /// ```
    pub enum VolumeError: Error {
        /// The first corner of a spherical cube and its three neighbors are on one circle: the eighth corner is not determined.
        ConcircularCube {
            /// Twice the area of the triangle of the neighbors, inverted at the first corner.
            measured: f64,
            /// Areas up to this are zero.
            limit: f64,
        }
        reason "concircular-cube";
        says "the first corner and its three neighbors lie on one circle, so the eighth corner is not determined: \
            the triangle of the neighbors, inverted at the first corner, has area {measured}, limit {limit}";

        /// A face of a volume crosses itself: one of its sides runs backwards.
        CrossingFace {
            /// Direction of the side: 0, 1, 2 for s, t, u.
            axis: usize,
            /// Where it is: its positions in the two other directions, in order, each 0 or 1.
            at: [f64; 2],
            /// Speed of the side, a length.
            speed: f64,
            /// Speeds must be above this.
            limit: f64,
        }
        reason "crossing-face";
        says "two faces self-intersect: their common side along {} at {} = {}, {} = {} runs backwards (speed \
            {speed}, limit {limit}); move the corners closer to those of a box",
            parameters(*axis)[0],
            parameters(*axis)[1],
            ShortNumber(at[0]),
            parameters(*axis)[2],
            ShortNumber(at[1]);

        /// Three faces of a block of circles that leave its last corner open.
        DegenerateBlock {
            /// How independent their corners are as pairs: 0 where they are dependent.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "degenerate-block";
        says "the three faces at the first corner leave the last corner of the block open (independence {measured}, limit \
            {limit}), as those of a box with directions along its edges do; turn a direction, change a twist, or use a volume of Dupin \
            cyclides";

        /// A volume contains the point at infinity.
        ThroughInfinity {
            /// Where: s, t, u.
            at: [f64; 3],
        }
        reason "volume-through-infinity";
        says "the volume passes through infinity near s = {}, t = {}, u = {}: its sides are nearly full circles \
            there", ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);

        /// Lines of a volume run backwards in a part of it, which a solid must not have.
        Folded {
            /// Where: s, t, u.
            at: [f64; 3],
        }
        reason "folded-volume";
        says "lines of the volume run backwards near s = {}, t = {}, u = {}, so it folds and bounds no solid; use a \
            frame closer to the sides, or none", ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);
    }
}
