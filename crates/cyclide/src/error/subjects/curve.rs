//! Why a curve of any kind was refused.

use crate::table::table;

table! {
    /// Why a curve of any kind was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::CurveError};
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
        says "pieces {piece} and {next} are not connected: gap {gap}, limit {limit}";

        /// A curve passes through infinity, or so near it that doubles cannot resolve it.
        ThroughInfinity {
            /// Near which parameter.
            t: f64,
        }
        reason "curve-through-infinity";
        says "the curve passes through infinity near parameter {t}: change the parameters, move a point, or use a \
            Moebius spline";

        /// The distance of a part of a curve from its chord is not proved to be within the tolerance, however short the chord.
        NotWithinTolerance {
            /// Which smooth piece, from 0.
            piece: usize,
            /// The bound that is proved for the shortest chord.
            bound: f64,
            /// The tolerance asked for.
            tolerance: f64,
        }
        reason "not-within-tolerance";
        at *piece;
        says "piece {piece}: the proved bound of its distance from a polyline is {bound}, tolerance {tolerance}; use \
            a larger tolerance";

        /// A curve has no frame at a parameter: a vector that determines it vanishes there.
        NoFrame {
            /// What vanishes.
            what: &'static str,
            /// The global parameter, in `[0, 1]`.
            t: f64,
            /// Its size.
            measured: f64,
            /// Sizes up to this are refused.
            limit: f64,
        }
        reason "no-frame";
        says "there is no frame at parameter {t}: {what} is {measured}, limit {limit}";

        /// A construction along arcs and segments was given another kind of curve.
        NotOfArcs {
            /// Kinds of curves that consist of them.
            wanted: &'static str,
        }
        reason "not-of-arcs";
        field "of";
        says "the curve does not consist of arcs and segments: give the tolerance within which arcs may replace it, \
            or use a curve of arcs ({wanted})";

        /// An interval of a curve's parameter is empty, or negligible against the whole: knots repeat or decrease.
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
        entry "knots";
        says "interval {index} of the parameter has length {length}, must be above {limit}";
    }
}
