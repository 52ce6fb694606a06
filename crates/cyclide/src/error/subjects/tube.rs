//! Why a tube along a curve or through balls was refused.

use crate::table::table;

table! {
    /// Why a tube along a curve or through balls was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::TubeError};
    /// let error: Error = TubeError::TurnsBack { ball: 2 }.into();
    /// assert_eq!(error.reason(), "tube-turns-back");
    /// ```
    pub enum TubeError: Error {
        /// One of two neighboring balls of a tube contains the other.
        BallsNested {
            /// Which ball, from 0.
            first: usize,
            /// Its neighbor.
            second: usize,
            /// Distance of their centers.
            distance: f64,
            /// Difference of their radii.
            limit: f64,
        }
        reason "balls-nested";
        at *second;
        says "one of balls {first} and {second} contains the other: their centers are {distance} apart, their radii \
            differ by {limit}; move them apart, or use more similar radii";

        /// No smooth tube continues at a ball.
        TurnsBack {
            /// Which ball, from 0.
            ball: usize,
        }
        reason "tube-turns-back";
        at *ball;
        says "no smooth tube continues at ball {ball}: its neighbors lie on one side, or the radii change too fast \
            for the turn; add balls in between";

        /// The radius of a tube falls to zero or below between two balls with positive radii.
        RadiusVanishes {
            /// Which piece, or the ball at its start, from 0.
            piece: usize,
            /// The least radius.
            radius: f64,
        }
        reason "tube-radius-vanishes";
        at *piece;
        says "the radius of the tube falls to {radius} between ball {piece} and the next one, though both radii are \
            positive: add a ball in between, or let the radii change less";

        /// A tube is too wide for the bends of its path, or for the change of its radius.
        Folds {
            /// Which piece of its spine, or which pair of balls, from 0.
            piece: usize,
            /// Where in it or in one of its arcs, 0 to 1.
            at: f64,
            /// Its width there on the inner side of the bend, relative to that on a straight path: not positive.
            left: f64,
        }
        reason "tube-folds";
        at *piece;
        says "the tube folds in piece {piece} at {at}, where it bends or changes its radius too fast for its width \
            (width factor {left}, must be above 0); use smaller radii, wider bends or a slower change of the radius";

        /// The radius of a tube changes as fast as the path length: its balls contain each other.
        RadiusGrowsTooFast {
            /// Which piece of its spine, from 0.
            piece: usize,
            /// Change of the radius per unit of path length.
            rate: f64,
            /// The rate must be below this.
            limit: f64,
        }
        reason "radius-grows-too-fast";
        at *piece;
        says "the radius changes by {rate} per unit of path length in piece {piece}, must be below {limit}: the \
            balls would contain each other; spread the change over more of the length";

        /// A closed tube starts and ends with different radii.
        RadiusNotClosed {
            /// Radius at the start.
            first: f64,
            /// Radius at the end.
            last: f64,
        }
        reason "radius-not-closed";
        says "the curve is closed, but the radius starts at {first} and ends at {last}: make both equal";
    }
}
