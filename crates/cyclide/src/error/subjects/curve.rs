//! Why a curve as such was refused, whatever its kind.

use crate::table::table;

table! {
    /// Why a curve as such was refused, whatever its kind.
    ///
    /// ```
    /// use cyclide::{CurveError, Error};
    /// let error: Error = CurveError::ThroughInfinity { t: 0.5 }.into();
    /// assert_eq!(error.reason(), "curve-through-infinity");
    /// ```
    pub enum CurveError: Error {
        /// Consecutive pieces of a path do not meet.
        Disconnected {
            /// The piece that ends.
            piece: usize,
            /// The piece that should start there.
            next: usize,
            /// Distance between the two ends.
            gap: f64,
            /// Largest gap accepted.
            limit: f64,
        }
        reason "disconnected";
        at *piece;
        says "pieces {piece} and {next} do not meet: gap {gap}, limit {limit}";

        /// A curve passes through infinity, or runs so far out that doubles do not tell.
        ThroughInfinity {
            /// Near which parameter.
            t: f64,
        }
        reason "curve-through-infinity";
        says "the curve passes through infinity near the parameter {t}: change the parameters, move a point, or \
            take a Moebius spline";

        /// A part of a curve is not proved to be within the tolerance of its chord, however short.
        NotWithinTolerance {
            /// Which smooth piece, from 0.
            piece: usize,
            /// What is proved at the shortest chord.
            bound: f64,
            /// The tolerance asked for.
            tolerance: f64,
        }
        reason "not-within-tolerance";
        at *piece;
        says "piece {piece}: the curve is not proved to be within {tolerance} of a polyline, only within {bound}; \
            use a larger tolerance";

        /// A frame does not exist at a place of a curve: what it would be made from vanishes there.
        NoFrame {
            /// What vanishes.
            what: &'static str,
            /// The place, a global parameter in `[0, 1]`.
            t: f64,
            /// Its size.
            measured: f64,
            /// Sizes up to this are refused.
            limit: f64,
        }
        reason "no-frame";
        says "there is no frame at the parameter {t}: {what} is {measured}, more than {limit} is needed";

        /// What follows arcs and segments was given a curve of another kind.
        NotOfArcs {
            /// Kinds of curves that are.
            wanted: &'static str,
        }
        reason "not-of-arcs";
        says "the curve is not made of arcs and segments: give the tolerance within which arcs may replace it, or \
            take a curve of arcs ({wanted})";

        /// An interval of a curve's parameter without length, or with one that is lost beside the whole: knots that repeat or go back.
        EmptyInterval {
            /// Which interval, from 0.
            index: usize,
            /// Its length.
            length: f64,
            /// It must be above this.
            limit: f64,
        }
        reason "empty-interval";
        at *index;
        says "interval {index} of the parameter has the length {length}, which must be above {limit}";
    }
}
