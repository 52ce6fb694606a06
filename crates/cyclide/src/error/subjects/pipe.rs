//! Why a pipe, or a neck or cone of one, was refused.

use crate::error::ErrorItem;
use crate::error::words::at_least;
use crate::table::table;

table! {
    /// Why a pipe, or a neck or cone of one, was refused.
    ///
    /// ```
    /// use cyclide::{Error, PipeError};
    /// let error: Error = PipeError::ConeReachesApex { apex: 0.5, reached: 0.5 }.into();
    /// assert_eq!(error.reason(), "radius-not-positive");
    /// ```
    pub enum PipeError: Error {
        /// The legs of a corner are too short for its arc beside those of the neighbours, or turn back on each other.
        BendDoesNotFit {
            /// Index of the point.
            corner: usize,
            /// Radius asked for.
            radius: f64,
            /// How much of the leg the arcs at both ends take.
            needed: f64,
            /// Length of the leg.
            length: f64,
        }
        reason "bend-does-not-fit";
        at *corner;
        says "the bend at point {corner} does not fit: with radius {radius} and that of its neighbour the arcs need \
            {} of a leg of length {length}; use smaller radii or move the points apart", at_least(*needed);

        /// A pipe is as wide as an arc that it follows.
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
        says "the pipe's radius {radius} must be below the radius of piece {piece} of its curve, {limit}, or the \
            inner side folds; use a thinner pipe or wider bends";

        /// A corner of a pipe that no mitre joins: it is next to an arc, or turns back.
        CornerNotMitred {
            /// Which piece begins there, from 0.
            joint: usize,
            /// Its turn, radians.
            turn: f64,
            /// Joints up to here are smooth.
            smooth: f64,
            /// Corners of segments up to here are mitred.
            limit: f64,
        }
        reason "corner-not-mitred";
        at *joint;
        when *limit <= *smooth, says "the tube's curve has a corner of {turn} rad before piece {joint}, maximum \
            {smooth} rad; round it (polyline with radius), use a smooth curve, or a pipe, which has mitres";
        says "the pipe's curve has a corner of {turn} rad before piece {joint}: corners between segments are mitred \
            up to {limit} rad, other joints must be smooth to {smooth} rad; round it (polyline with radius), or use \
            a smooth curve";

        /// A segment of a pipe is shorter than its mitres need.
        MitreDoesNotFit {
            /// Which segment, from 0.
            piece: usize,
            /// Length that the mitres at both ends take.
            needed: f64,
            /// Length of the segment.
            length: f64,
        }
        reason "mitre-does-not-fit";
        at *piece;
        says "segment {piece} of the pipe's curve has length {length}, but its mitres need more than {needed}; use a \
            thinner pipe or round the corners";

        /// Parts of a pipe that are no neighbours run into each other.
        MeetsItself {
            /// Which piece of the arcs and segments along it, or which ball, from 0.
            first: usize,
            /// The other one; the same if it is an arc that comes round.
            second: usize,
            /// In the middle between both.
            point: [f64; 3],
            /// Distance of both.
            distance: f64,
            /// Twice the radius.
            limit: f64,
        }
        reason "pipe-meets-itself";
        at *second;
        when *distance > CROSSING * *limit, says "the pipe intersects itself at {point}: the arcs or segments \
            {first} and {second} along it are {distance} apart from center to center, minimum {limit}, the sum of \
            their radii; use a thinner pipe or move the curve apart";
        says "the pipe intersects itself at {point}: the arcs or segments {first} and {second} along it are \
            {distance} apart from center to center, minimum {limit}, the sum of their radii; they cross: move the \
            curve apart";

        /// The ends of a pipe are not in order.
        EndsReversed {
            /// Which pipe, from 0; of a tee the main pipe.
            pipe: usize,
            /// The first end.
            start: f64,
            /// The second, which must be above it.
            end: f64,
        }
        reason "pipe-ends-reversed";
        says "the ends of pipe {pipe} are at {start} and {end}: the lower one must come first";

        /// A cone has its apex before the last place where something of it is needed: its radius there would not be positive.
        ConeReachesApex {
            /// Where the apex is along its axis; within a wall, that of the bore.
            apex: f64,
            /// The position along its axis up to which it is needed.
            reached: f64,
        }
        reason "radius-not-positive";
        says "the cone (its bore, if it has a wall) reaches its apex at {apex} along its axis, but is needed up to \
            {reached}; use a smaller taper, a larger radius, or a shorter pipe";

        /// A ball that is to roll inside a pipe is as large as the pipe.
        BallDoesNotFit {
            /// Radius of the ball.
            radius: f64,
            /// The radius of the ball that touches the pipe all round: those that fit are smaller.
            limit: f64,
        }
        reason "ball-does-not-fit";
        says "a ball of radius {radius} does not fit into the pipe or the hole: the radius must be below {limit}";

        /// A solid with the neck of a ball larger than the bends of its path: its surface would self-intersect.
        NeckFolds {
            /// Radius of the ball.
            radius: f64,
            /// Smallest radius of curvature of the path of its center.
            limit: f64,
        }
        reason "neck-folds";
        says "the neck self-intersects on the side to which the pipe leans, so it bounds no solid: the ball has \
            radius {radius}, but its path bends with radius {limit}; use a smaller ball";

        /// A plate that ends within the neck or bore at it.
        PlateTooSmall {
            /// What it must reach beyond: neck or bore.
            what: ErrorItem,
            /// How far it reaches.
            reach: f64,
            /// How far it must.
            needed: f64,
        }
        reason "plate-too-small";
        says "the plate is too small: it extends {reach} from the axis of the pipe, the {what} {needed}";
    }
}

/// What comes nearer to itself than this part of its width crosses itself.
const CROSSING: f64 = 1e-6;
