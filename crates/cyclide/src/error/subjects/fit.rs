//! Why no curve was fitted to the points.

use crate::error::ErrorItem;
use crate::error::words::points_in_words;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why no curve was fitted to the points.
    ///
    /// ```
    /// use cyclide::{Error, error::FitError};
    /// let error: Error = FitError::NoG1SplineInTube { vertex: 2, tolerance: 0.5 }.into();
    /// assert_eq!(error.reason(), "no-g1-spline-in-tube");
    /// ```
    pub enum FitError: Error {
        /// No tangent-continuous arc spline stays within the tolerance of the polyline near this vertex.
        NoG1SplineInTube {
            /// Vertex of the input where the search failed.
            vertex: usize,
            /// The tolerance.
            tolerance: f64,
        }
        reason "no-g1-spline-in-tube";
        at *vertex;
        says "no G1 arc spline stays within {tolerance} of the polyline near vertex {vertex}: smooth noisy \
            points first, use a larger tolerance, the target `polyline` to keep the edges, or a corner angle below \
            the turn there";

        /// Arcs within the tolerance exist, but none that satisfy a limit of the machine.
        ArcLimitNotKept {
            /// Point of the input at the arc that misses the limit by most.
            vertex: usize,
            /// The limit: `min_radius` or `min_arc_length`.
            name: ErrorItem,
            /// The value of that arc.
            value: f64,
            /// The limit's value.
            limit: f64,
            /// The other limit, if arcs miss that as well, with the smallest value of one.
            also: Option<(ErrorItem, f64)>,
        }
        reason "arc-limit-not-kept";
        at *vertex;
        when also.is_some(), says "no arcs within the tolerance satisfy `{name}` {limit}: the worst, at point {vertex}, \
            has {} {}; use a larger tolerance, or both {} and {}", measured(*name), ShortNumber::no_more(*value),
            limit_that_works(*name, *value),
            also.map_or_else(String::new, |(name, value)| limit_that_works(name, value));
        says "no arcs within the tolerance satisfy `{name}` {limit}: the worst, at point {vertex}, has {} {}; use a \
            larger tolerance, or {}", measured(*name), ShortNumber::no_more(*value), limit_that_works(*name, *value);

        /// No curve of the kind was found within the tolerance of these points.
        ToleranceNotReached {
            /// The points outside, in the user's numbering.
            points: Vec<usize>,
            /// Largest distance of one of them.
            deviation: f64,
            /// The tolerance.
            tolerance: f64,
        }
        reason "tolerance-not-reached";
        at points.first().copied();
        says "tolerance {tolerance} not reached: {} stay outside, up to {deviation} away; use a larger tolerance, or \
            mark corners where the data turn sharply", points_in_words(&points);

        /// The curve within the tolerance would swing out between two points, by far more than their distance.
        CurveLost {
            /// The first of the two, in the user's numbering.
            point: usize,
            /// How far the curve would be from their edge.
            distance: f64,
            /// The tolerance.
            tolerance: f64,
        }
        reason "curve-lost";
        at *point;
        says "after point {point} the fairest curve within {tolerance} of the points would swing out by {distance}: \
            use a smaller tolerance, or mark corners (a corner angle)";

        /// A tolerance is not reached because of outliers.
        OutliersOutside {
            /// Each of them, in the user's numbering, and how far it is from the curve of the other points.
            points: Vec<(usize, f64)>,
            /// Standard deviation of the noise of the other points.
            noise: f64,
            /// The tolerance.
            tolerance: f64,
        }
        reason "outliers";
        at points.first().map(|p| p.0);
        says "tolerance {tolerance} not reached because of {} outlier(s): {} from the curve of the other points, \
            whose noise has a standard deviation of {noise}; leave them out, or use a larger tolerance",
            points.len(), outliers(&points);

        /// No curve follows the points without their noise.
        NoiseNotSmoothed {
            /// The points it leaves by too much, in the user's numbering.
            points: Vec<usize>,
            /// Largest distance of one of them, without its noise, from the curve.
            deviation: f64,
            /// Standard deviation of the noise.
            noise: f64,
        }
        reason "noise-not-smoothed";
        at points.first().copied();
        says "no curve follows the points without their noise, whose standard deviation is about {noise}: it is up \
            to {deviation} away from {}; use fewer points, farther apart than their noise, or give a tolerance",
            points_in_words(&points);
    }
}

/// What an arc has that a limit is for.
fn measured(limit: ErrorItem) -> &'static str {
    if limit == ErrorItem::MinRadius { "radius" } else { "length" }
}

/// The limit as the arcs keep it.
fn limit_that_works(name: ErrorItem, value: f64) -> String {
    format!("`{}` {}", name.word(), ShortNumber::no_more(value))
}

/// Outliers that are named one by one.
const NAMED_OUTLIERS: usize = 20;

/// The first of some outliers with their distances, and how many more there are.
fn outliers(points: &[(usize, f64)]) -> String {
    let named = points.iter().take(NAMED_OUTLIERS);
    let named: Vec<_> = named.map(|(point, away)| format!("point {point} ({} away)", ShortNumber(*away))).collect();
    let more = points.len() - named.len();
    named.join(", ") + &if more > 0 { format!(" and {more} more") } else { String::new() }
}
