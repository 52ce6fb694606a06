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
        says "the bend at point {corner} does not fit: with the radius {radius} and that of its neighbour the arcs \
            take {} of a leg of length {length}; take smaller radii or move the points apart", at_least(*needed);

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
        says "the pipe's radius {radius} is not below that of piece {piece} of its curve, {limit}: the inner side \
            would fold; take a thinner pipe or wider bends";

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
        when *limit <= *smooth, says "the tube's curve has a corner of {turn} rad before piece {joint}: tubes \
            follow curves whose joints are smooth, up to {smooth} rad; round it (polyline with radius), take a \
            smooth curve, or a pipe, which has mitres";
        says "the pipe's curve has a corner of {turn} rad before piece {joint}: only corners between segments are \
            mitred, up to {limit} rad, and joints are smooth up to {smooth} rad; round it (polyline with radius), \
            or take a smooth curve";

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
        says "segment {piece} of the pipe's curve has the length {length}, its mitres need more than {needed}; take \
            a thinner pipe or round the corners";

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
        when *distance > CROSSING * *limit, says "the pipe meets itself at {point}: parts {first} and {second} of \
            it, of the arcs and segments along it, come as near as {distance} from center to center, and the sum \
            of their radii is {limit}; take a thinner pipe or move the curve apart";
        says "the pipe meets itself at {point}: parts {first} and {second} of it, of the arcs and segments along \
            it, come as near as {distance} from center to center, and the sum of their radii is {limit}; they \
            cross: move the curve apart";

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
        says "the ends of pipe {pipe} are at {start} and {end}: the lower place comes first";

        /// A cone has its apex before the last place where something of it is needed: its radius there would not be positive.
        ConeReachesApex {
            /// Where the apex is along its axis; within a wall, that of the bore.
            apex: f64,
            /// The place along its axis that it is needed as far as.
            reached: f64,
        }
        reason "radius-not-positive";
        says "the cone, within its wall if it has one, comes to its apex at {apex} along its axis, and is needed as \
            far as {reached}; take a smaller taper, a larger radius, or a shorter pipe";

        /// A ball that is to roll inside a pipe is as large as the pipe.
        BallDoesNotFit {
            /// Radius of the ball.
            radius: f64,
            /// The radius of the ball that touches the pipe all round: those that fit are smaller.
            limit: f64,
        }
        reason "ball-does-not-fit";
        says "a ball of radius {radius} does not fit into the pipe or the hole: its radius must be below {limit}";

        /// A solid with the neck of a ball larger than the bends of its way: its surface would run through itself.
        NeckFolds {
            /// Radius of the ball.
            radius: f64,
            /// Smallest radius of curvature of the way of its centre.
            limit: f64,
        }
        reason "neck-folds";
        says "the neck runs through itself on the side to which the pipe leans and bounds no solid: a ball of \
            radius {radius} rolls through bends of radius {limit}; take a smaller ball";

        /// A plate that ends within what is to stand on it.
        PlateTooSmall {
            /// What it must reach beyond: neck or bore.
            what: ErrorItem,
            /// How far it reaches.
            reach: f64,
            /// How far it must.
            needed: f64,
        }
        reason "plate-too-small";
        says "the plate is too small: it reaches {reach} from the axis of the pipe, the {what} {needed}";
    }
}

/// What comes nearer to itself than this part of its width crosses itself.
const CROSSING: f64 = 1e-6;
