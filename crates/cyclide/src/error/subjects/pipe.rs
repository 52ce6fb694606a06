//! Why a pipe, or a neck or cone of one, was refused.

use crate::error::ErrorItem;
use crate::error::words::at_least;
use crate::table::table;

table! {
    /// Why a pipe, or a neck or cone of one, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::PipeError};
    /// let error: Error = PipeError::ConeReachesApex { pipe: 0, apex: 0.5, reached: 0.5 }.into();
    /// assert_eq!(error.reason(), "radius-not-positive");
    /// ```
    pub enum PipeError: Error {
        /// The legs of a corner are too short for its arc and those of its neighbors, or turn back on each other.
        BendDoesNotFit {
            /// Index of the point.
            corner: usize,
            /// The given radius.
            radius: f64,
            /// Length of the leg that the arcs at both ends need.
            needed: f64,
            /// Length of the leg.
            length: f64,
        }
        reason "bend-does-not-fit";
        at *corner;
        says "the bend at point {corner} does not fit: with radius {radius} and that of its neighbor the arcs need \
            {} of a leg of length {length}; use smaller radii or move the points apart", at_least(*needed);

        /// The radius of a pipe is not below that of an arc along it.
        TooWide {
            /// Which arc of the path, from 0.
            piece: usize,
            /// Radius of the pipe.
            radius: f64,
            /// Radius of the arc.
            limit: f64,
        }
        reason "pipe-too-wide";
        at *piece;
        field "radius";
        says "the pipe's radius {radius} must be below the radius of piece {piece} of its curve, {limit}, or the \
            inner side folds; use a thinner pipe or wider bends";

        /// A corner of a pipe cannot be mitered: it is next to an arc, or turns back.
        CornerNotMitred {
            /// Which piece begins there, from 0.
            joint: usize,
            /// Its turn, radians.
            turn: f64,
            /// Joints up to here are smooth.
            smooth: f64,
            /// Corners of segments up to here are mitered.
            limit: f64,
        }
        reason "corner-not-mitred";
        at *joint;
        field "of";
        when *limit <= *smooth, says "the tube's curve has a corner of {turn} rad before piece {joint}, maximum \
            {smooth} rad; round it (polyline with radius), use a smooth curve, or a pipe, which has mitres";
        says "the pipe's curve has a corner of {turn} rad before piece {joint}: corners between segments are mitred \
            up to {limit} rad, other joints must be smooth to {smooth} rad; round it (polyline with radius), or use \
            a smooth curve";

        /// A segment of a pipe is shorter than its miters need.
        MitreDoesNotFit {
            /// Which segment, from 0.
            piece: usize,
            /// Length that the miters at both ends need.
            needed: f64,
            /// Length of the segment.
            length: f64,
        }
        reason "mitre-does-not-fit";
        at *piece;
        field "radius";
        says "segment {piece} of the pipe's curve has length {length}, but its mitres need more than {needed}; use a \
            thinner pipe or round the corners";

        /// Non-adjacent parts of a pipe intersect.
        MeetsItself {
            /// Which piece of the arcs and segments along it, or which ball, from 0.
            first: usize,
            /// The other one; the same if it is an arc that closes up.
            second: usize,
            /// The midpoint between both.
            point: [f64; 3],
            /// Distance of both.
            distance: f64,
            /// Twice the radius.
            limit: f64,
        }
        reason "pipe-meets-itself";
        at *second;
        field "radius";
        when *distance > CROSSING * *limit, says "the pipe intersects itself at {point}: the arcs or segments \
            {first} and {second} along it are {distance} apart from center to center, minimum {limit}, the sum of \
            their radii; use a thinner pipe or move the curve apart";
        says "the pipe intersects itself at {point}: the arcs or segments {first} and {second} along it are \
            {distance} apart from center to center, minimum {limit}, the sum of their radii; they cross: move the \
            curve apart";

        /// The ends of a pipe are in the wrong order.
        EndsReversed {
            /// Which pipe, from 0; of a tee the main pipe.
            pipe: usize,
            /// The first end.
            start: f64,
            /// The second, which must be above it.
            end: f64,
        }
        reason "pipe-ends-reversed";
        at *pipe;
        entry "pipes";
        says "the ends of pipe {pipe} are at {start} and {end}: the lower one must come first";

        /// A cone has its apex before the last position where it is needed: its radius there would not be positive.
        ConeReachesApex {
            /// Which pipe, from 0.
            pipe: usize,
            /// Position of the apex along its axis; with a wall, that of the bore.
            apex: f64,
            /// The position along its axis up to which it is needed.
            reached: f64,
        }
        reason "radius-not-positive";
        at *pipe;
        entry "pipes";
        says "the cone (its bore, if it has a wall) reaches its apex at {apex} along its axis, but is needed up to \
            {reached}; use a smaller taper, a larger radius, or a shorter pipe";

        /// A ball that is to roll inside a pipe does not fit into it.
        BallDoesNotFit {
            /// Radius of the ball.
            radius: f64,
            /// The radius of the ball that touches the pipe all round: it must be below this.
            limit: f64,
        }
        reason "ball-does-not-fit";
        field "blend";
        says "a ball of radius {radius} does not fit into the pipe or the hole: the radius must be below {limit}";

        /// A solid has a neck whose ball is larger than the bends of its path: its surface would self-intersect.
        NeckFolds {
            /// Radius of the ball.
            radius: f64,
            /// Smallest radius of curvature of the path of its center.
            limit: f64,
        }
        reason "neck-folds";
        field "blend";
        says "the neck self-intersects on the side to which the pipe leans, so it bounds no solid: the ball has \
            radius {radius}, but its path bends with radius {limit}; use a smaller ball";

        /// A plate ends within its neck or bore.
        PlateTooSmall {
            /// What it must extend beyond: neck or bore.
            what: ErrorItem,
            /// How far it extends.
            reach: f64,
            /// How far it must extend.
            needed: f64,
        }
        reason "plate-too-small";
        field "plate";
        says "the plate is too small: it extends {reach} from the axis of the pipe, but the {what} extends {needed}";
    }
}

/// A pipe closer to itself than this fraction of its width crosses itself.
const CROSSING: f64 = 1e-6;
