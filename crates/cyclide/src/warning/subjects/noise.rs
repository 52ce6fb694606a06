//! Warnings about the noise of points to which a curve was fitted.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about the noise of points to which a curve was fitted.
    ///
    /// ```
    /// use cyclide::{Warning, warning::NoiseWarning};
    /// let warning: Warning = NoiseWarning::ToleranceBelowNoise { fraction: 0.5 }.into();
    /// assert_eq!(warning.reason(), "tolerance-below-noise");
    /// ```
    pub enum NoiseWarning {
        /// The tolerance is below the noise of the data, or exact data are too coarse for it: nearly every span has two edges
        /// or fewer.
        ToleranceBelowNoise {
            /// Fraction of such spans.
            fraction: f64,
        }
        reason "tolerance-below-noise";
        says "{:.0} % of the arcs span two edges or fewer: the tolerance is below the noise of the points, or the \
            points are too far apart for it", *fraction * 100.0;

        /// A smooth curve within the tolerance needs nearly as many nodes as there are points, which change between left and right
        /// like noise.
        NoisyNodes {
            /// Nodes of the curve.
            nodes: usize,
            /// Points it was fitted to; more than a third as many nodes are reported.
            points: usize,
            /// How often the points do, more than a third of them.
            changes: usize,
        }
        reason "tolerance-below-noise";
        says "{nodes} nodes for {points} points, which change {changes} times between left and right, like noise: \
            the tolerance is below their noise";

        /// The fairest curve lies along the bounds of the tolerance: for noisy data a curve closer to them is closer to the
        /// measured shape.
        LeansOnWalls {
            /// Root mean square of the distances of the points from the curve.
            rms: f64,
            /// Values above this are reported.
            limit: f64,
            /// How far the points scatter from one to the next about any smooth curve: the standard deviation of their noise.
            /// `None` where there are too few points to a node to distinguish noise from shape.
            scatter: Option<f64>,
        }
        reason "leans-on-walls";
        says "the curve lies along the bounds of the tolerance, as the fairest one does: the root mean square of the \
            distances is {rms} (limit {limit}); {}", nearer_to_points(*scatter, *limit);

        /// A curve within a tolerance removes more than the noise of its points.
        BeyondNoise {
            /// Root mean square of the distances of the points from the curve.
            rms: f64,
            /// Standard deviation of the noise across the curve, estimated from the points.
            noise: f64,
        }
        reason "beyond-noise";
        says "the curve removes more than noise: the root mean square of the distances is {rms}, and the noise of \
            the points has a standard deviation of about {noise}, so the curve may be farther from the measured \
            shape than the points are; use a strength that follows the noise";

        /// The given noise is not that of the points.
        Contradicted {
            /// The standard deviation that was given.
            given: f64,
            /// That of the points.
            found: f64,
        }
        reason "noise-contradicted";
        when *given < *found, says "the noise is given as {given}, but the points scatter by {found}: the curve \
            follows their noise; let it be estimated from the points, or give less certain heights a noise of their \
            own";
        says "the noise is given as {given}, but the points scatter by {found}: the curve may omit bends that they \
            show";

        /// Few points were read as noisy ones, but may be corners.
        FewPoints {
            /// How many there are.
            points: usize,
            /// The estimated standard deviation of the noise.
            noise: f64,
            /// The typical distance of neighbors.
            apart: f64,
        }
        reason "few-for-noise";
        says "{points} points, typically {apart} apart, are read as measured with a noise of {noise}; so few may \
            also be the corners of an outline: if they are, give a tolerance or a corner angle";

        /// Where the smoothed curve bends sharply, points are off it by more than their noise: corners may be rounded off.
        CornersRounded {
            /// The point with the largest distance.
            point: usize,
            /// How far.
            distance: f64,
            /// How many points are off by more than 4.5 deviations.
            count: usize,
            /// Standard deviation of the noise of most points.
            noise: f64,
        }
        reason "corners-rounded";
        at *point;
        says "corners may be rounded off: where the curve bends sharply, {count} points are off it by more than their \
            noise (standard deviation {noise}), point {point} by {distance}; mark the corners (a corner angle), or use \
            denser points";

        /// Heights step from one point to the next, as at a wall or a kerb: they are smoothed on each side alone.
        HeightStep {
            /// The point before the largest step.
            point: usize,
            /// How high it is.
            height: f64,
            /// How many steps there are.
            count: usize,
        }
        reason "height-step";
        at *point;
        when *count == 1, says "the heights step by {height} after point {point}, as at a wall: they are smoothed on each side \
            separately, and the curve climbs between the two points";
        says "the heights step in {count} places, by up to {height} after point {point}, as at a wall: they are smoothed between \
            the steps separately, and the curve climbs between the two points of each step";

        /// Points next to each other are farther from the smoothed curve than their noise.
        PointsLeft {
            /// The first of two.
            point: usize,
            /// How far the nearer of them is.
            distance: f64,
            /// Standard deviation of the noise of the points.
            noise: f64,
        }
        reason "corners-rounded";
        at *point;
        says "a corner may be rounded off: point {point} and the next are both {distance} or more from the curve, and the \
            noise of the points has a standard deviation of {noise}; mark the corner, or use denser points";

        /// Straight runs of points meet between two of them: there is a corner that no point measures.
        CornersInserted {
            /// The point before the first of them.
            point: usize,
            /// Where the first of them is.
            at: [f64; 3],
            /// How far one of them is from the edge between its points, at most.
            distance: f64,
            /// How many there are.
            count: usize,
        }
        reason "corners-inserted";
        at *point;
        when *count == 1, says "a corner was inserted after point {point}, at {},{},{}: straight runs of points meet there, \
            {distance} from the edge between two points; if the shape is rounded there, use a tolerance as the strength",
            ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);
        says "{count} corners were inserted where straight runs of points meet between two of them, up to {distance} \
            from the edge between these: the first after point {point}, at {},{},{}; if the shape is rounded there, use \
            a tolerance as the strength", ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);

        /// The closest locations of some points step back along the curve: distances are bounded in one direction only.
        FeetNotMonotone {
            /// The first point whose closest location is before that of its predecessor.
            point: usize,
            /// How many there are.
            count: usize,
        }
        reason "feet-not-monotone";
        at *point;
        says "point {point} lies behind the previous point along the curve ({count} such points): the points are \
            closer together than their noise, so only the distance from the curve to the polyline is bounded, not \
            that from the polyline to the curve";

        /// A point is an outlier: it is far from the curve of the other points.
        Outlier {
            /// The point.
            point: usize,
            /// How far it is from the curve of the other points.
            distance: f64,
            /// Standard deviation of the noise of these.
            noise: f64,
            /// True if it was left out, as requested; otherwise it is kept.
            dropped: bool,
            /// How many there are.
            count: usize,
        }
        reason "outlier";
        at *point;
        when *dropped, says "point {point} is an outlier ({count} in all): it is {distance} from the curve of the \
            other points, whose noise has a standard deviation of {noise}; left out";
        says "point {point} is an outlier ({count} in all): it is {distance} from the curve of the other points, \
            whose noise has a standard deviation of {noise}; kept";
    }
}

/// Points that scatter by more than this fraction of the limit are noisy.
const SCATTER: f64 = 0.15;

fn is_noisy(scatter: f64, limit: f64) -> bool {
    scatter > SCATTER * limit
}

impl NoiseWarning {
    /// Whether a curve leans on the bounds of a tolerance about points that scatter like noisy ones: then a strength that follows their
    /// noise comes nearer to what was measured.
    ///
    /// ```
    /// use cyclide::warning::NoiseWarning;
    /// let leans = |scatter: Option<f64>| NoiseWarning::LeansOnWalls { rms: 0.6, limit: 0.55, scatter };
    /// assert!(leans(Some(0.4)).is_of_noisy_points() && !leans(Some(0.01)).is_of_noisy_points());
    /// ```
    #[must_use]
    pub fn is_of_noisy_points(&self) -> bool {
        matches!(self, Self::LeansOnWalls { scatter: Some(scatter), limit, .. } if is_noisy(*scatter, *limit))
    }
}

/// What comes nearer to points of which a curve leans on the bounds of the tolerance.
fn nearer_to_points(scatter: Option<f64>, limit: f64) -> String {
    match scatter {
        Some(scatter) if is_noisy(scatter, limit) => format!(
            "the points scatter by {} from one to the next: if that is noise, a strength that follows it is closer to what was measured",
            ShortNumber(scatter)
        ),
        Some(scatter) => format!(
            "the points scatter by at most {} from one to the next: use a smaller tolerance, or a `centre` of 1, to come closer to them",
            ShortNumber(scatter)
        ),
        None => "use a smaller tolerance, or a `centre` of 1, to come closer to the points".to_owned(),
    }
}
