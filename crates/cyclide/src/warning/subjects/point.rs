//! Warnings about the points from which a curve was made.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about the points from which a curve was made.
    ///
    /// ```
    /// use cyclide::{Warning, warning::PointWarning};
    /// let warning: Warning = PointWarning::ClosingPointMerged { index: 1, distance: 0.0 }.into();
    /// assert_eq!(warning.reason(), "closing-point-merged");
    /// ```
    pub enum PointWarning {
        /// Chords are so short for their coordinates that the rounding to doubles changes their directions.
        RoundedDirections {
            /// The first of the segments, from 0.
            segment: usize,
            /// How many there are.
            count: usize,
            /// The largest uncertainty of their directions, radians.
            angle: f64,
            /// Values above this are reported, radians.
            limit: f64,
        }
        reason "rounded-directions";
        at *segment;
        says "{count} chord(s), the first is segment {segment}, are so short for coordinates this large that \
            rounding turns them by up to {} degrees (limit {}): move the points to the origin before they are \
            written, or merge them", degrees(*angle), degrees(*limit);

        /// Neighboring chords differ much in length, which makes interpolating curves bulge.
        UnevenSpacing {
            /// Index of the point between the two chords.
            node: usize,
            /// Longer over shorter chord.
            ratio: f64,
            /// Ratios above this are reported.
            limit: f64,
        }
        reason "uneven-spacing";
        at *node;
        when *ratio >= NEARLY_REPEATED, says "point {node}: neighboring chords differ by a factor of {:.0}: two \
            points nearly coincide there, and the curve may loop; remove one of them", *ratio;
        says "point {node}: neighboring chords differ by a factor of {:.1} (limit {}), so the curve may bulge",
            *ratio,
            *limit;

        /// Points that were measured at a standstill count as one point.
        StopMerged {
            /// The first of them.
            first: usize,
            /// The last.
            last: usize,
            /// How many there are.
            count: usize,
            /// Their mean.
            at: [f64; 3],
            /// The largest distance from it.
            radius: f64,
        }
        reason "stop";
        at *first;
        says "points {first} to {last} are a stop: {count} points within {radius} of {},{},{} that were measured at \
            a standstill; they count as one point", ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);

        /// Points that coincide with their neighbor were merged.
        PointsMerged {
            /// Index of the first one dropped.
            first: usize,
            /// How many were dropped.
            count: usize,
            /// Distances up to this count as equal.
            limit: f64,
        }
        reason "points-merged";
        at *first;
        when *count == 1, says "point {first} repeats the previous one (closer than {limit}): left out";
        says "{count} points repeat the previous ones (closer than {limit}): left out, the first is point {first}";

        /// The last points of a closed curve repeat its first one and were merged with it.
        ClosingPointMerged {
            /// Index of the first one dropped.
            index: usize,
            /// The largest distance of one dropped from the first point.
            distance: f64,
        }
        reason "closing-point-merged";
        at *index;
        when *distance > 0.0, says "point {index} repeats the first point of the closed curve (distance {}): merged \
            with it", ShortNumber(*distance);
        says "point {index} repeats the first point of the closed curve: merged with it";
    }
}

/// From this factor on the shorter chord joins nearly coincident points.
const NEARLY_REPEATED: f64 = 1000.0;
