//! Why no surface was built between two curves.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why no surface was built between two curves.
    ///
    /// ```
    /// use cyclide::{Error, error::BridgeError};
    /// let error: Error = BridgeError::EllipsesCross { along_x: 0.5, along_y: 0.5 }.into();
    /// assert_eq!(error.reason(), "ellipses-cross");
    /// ```
    pub enum BridgeError: Error {
        /// Two ellipses cross, so no solid lies between them.
        EllipsesCross {
            /// Difference of the semi-axes along x, of the other sign than that along y.
            along_x: f64,
            /// Difference of the semi-axes along y.
            along_y: f64,
        }
        reason "ellipses-cross";
        says "the ellipses cross: the semi-axes of the second are larger by {along_x} along x and by {along_y} along \
            y; a solid needs one ellipse inside the other";

        /// Two curves whose pieces are joined one by one have different numbers of pieces.
        PieceCountsDiffer {
            /// Pieces of the first curve.
            first: usize,
            /// Pieces of the second.
            second: usize,
        }
        reason "piece-counts-differ";
        says "the first curve has {first} piece(s), the second {second}: pieces are joined one by one in order, so \
            the numbers must be equal";

        /// Straight lines between two curves cross or coincide: the surface has no normal there.
        RulingsCross {
            /// Which piece, from 0.
            piece: usize,
            /// The parameter of the piece, and the fraction of the distance from the first curve to the second.
            at: [f64; 2],
            /// Length of the normal there, relative to its largest possible length.
            normal: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "rulings-cross";
        at *piece;
        says "the straight lines between piece {piece} of the two curves cross or coincide: at {} of the piece and \
            {} of the distance between the curves the surface has no normal (relative length {normal}, limit \
            {limit}); check the direction of the second curve", ShortNumber(at[0]), ShortNumber(at[1]);

        /// The arcs between two curves cross their neighbors: the surface has no normal there, and self-intersects beside it.
        ArcsCross {
            /// Which piece of the curves, from 0.
            piece: usize,
            /// Near which part of the piece, and of the arcs.
            at: [f64; 2],
        }
        reason "arcs-cross";
        at *piece;
        says "the arcs between piece {piece} of the two curves cross near {} of the piece and {} of the arcs, so the \
            surface self-intersects or folds back; check the directions of the second curve and of the tangent",
            ShortNumber(at[0]),
            ShortNumber(at[1]);

        /// The directions of arcs at neighboring joints of a curve are opposite, so none is halfway between them.
        OppositeTangents {
            /// The first one, from 0.
            first: usize,
            /// The next one; of closed curves the first of all again.
            second: usize,
            /// Least length of the direction between them, relative to the longer one.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "opposite-tangents";
        at *first;
        field "tangents";
        says "tangents {first} and {second} are opposite, so the direction vanishes between them (relative length \
            {length}, must be above {limit}); turn one of them sideways";
    }
}
