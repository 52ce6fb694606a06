//! Warnings about curves through points.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;
use crate::warning::WaverRemedy;

table! {
    /// Warnings about curves through points.
    ///
    /// ```
    /// use cyclide::{Warning, warning::CurveWarning};
    /// let warning: Warning = CurveWarning::Cusp { node: 2 }.into();
    /// assert_eq!(warning.reason(), "cusp");
    /// ```
    pub enum CurveWarning {
        /// The curve turns back on itself at a node: its tangents are one-sided, and the joint is only continuous (G0).
        Cusp {
            /// Index of the point.
            node: usize,
        }
        reason "cusp";
        at *node;
        says "point {node}: the curve turns back on itself (cusp), so the joint is connected but not smooth";

        /// The velocity of a curve vanishes within a piece or at a joint, and its direction jumps there.
        CuspInside {
            /// How many such locations there are.
            count: usize,
            /// The parameter of the first, from 0 to 1.
            t: f64,
            /// The point there.
            at: [f64; 3],
            /// The turn there, radians: half a turn within a piece.
            angle: f64,
        }
        reason "cusp";
        says "the curve stops and turns by {} degrees (cusp) at {count} location(s), the first at t = {t}, point \
            {at}", degrees(*angle);

        /// A turn close to half a turn: the circle through the node is very large.
        SharpTurn {
            /// Index of the point.
            node: usize,
            /// Turn at the point, radians.
            angle: f64,
            /// Turns above this are reported, radians.
            limit: f64,
        }
        reason "sharp-turn";
        at *node;
        says "point {node}: the points turn back by {:.2} degrees (limit {:.0}): the circle through it and its \
            neighbors is very large, and the curve swings out; if a corner is intended, mark it",
            angle.to_degrees(),
            limit.to_degrees();

        /// A turn close to half a turn, where a smooth curve would swing out: the point became a corner (G0).
        SharpTurnCut {
            /// Index of the point.
            node: usize,
            /// Turn at the point, radians.
            angle: f64,
            /// Turns above this become corners, radians.
            limit: f64,
        }
        reason "sharp-turn-cut";
        at *node;
        says "point {node}: the points turn back by {:.2} degrees (limit {:.0}): a smooth curve would swing out, so \
            the point became a corner", angle.to_degrees(), limit.to_degrees();

        /// Segments of a fair spline are less fair than requested, because the fairest curve does not exist or swings out
        /// far there; its curvature is continuous nevertheless.
        Relaxed {
            /// Segments, from 0, rising, each with its blend: 1 is the fairest, 0 follows its neighbors alone.
            segments: Vec<(usize, f64)>,
        }
        reason "relaxed";
        at segments.first().map(|(segment, _)| *segment);
        says "{}", relaxed(&segments);

        /// The blend takes the longer path between its two circles.
        LongWay {
            /// Segment, from 0; it starts at the point of the same index.
            segment: usize,
        }
        reason "long-way";
        at *segment;
        says "segment {segment}: the blend takes the longer path between its circles";

        /// The two circles of a segment run in opposite directions: a small change of the data moves the curve a lot.
        OppositeCircles {
            /// Segment, from 0.
            segment: usize,
        }
        reason "opposite-circles";
        at *segment;
        says "segment {segment}: its circles run in opposite directions, so small changes move the curve a lot";

        /// A curve reaches a point only in a spike: it runs there and back within a short interval of the parameter.
        SpikeNearPoint {
            /// Index of the point.
            point: usize,
            /// Width of the spike, as a fraction of the parameter's range.
            width: f64,
            /// Widths below this are reported.
            limit: f64,
        }
        reason "spike-near-point";
        at *point;
        says "the curve reaches point {point} only in a spike, over {width} of its parameter: the other points lie \
            nearly on a curve that misses it; change the parameters or use a Moebius spline";

        /// A curve runs far away from its points in between.
        LargeExcursion {
            /// Its largest distance from the center of the points, relative to their size.
            reach: f64,
            /// The parameter there.
            t: f64,
            /// Values above this are reported.
            limit: f64,
        }
        reason "large-excursion";
        says "near parameter {t} the curve is {reach} times as far from the center of its points as they are (limit \
            {limit}); change the parameters or use a Moebius spline";

        /// A curve turns back between two of its points: they lie nearly on a curve of lower degree, along which it runs back
        /// and forth.
        TurnsBack {
            /// The parameter of the first location, from 0 to 1.
            t: f64,
            /// How many such locations there are.
            count: usize,
            /// Length of the curve on which it turns, at most, in spacings of the points.
            within: f64,
            /// Lengths up to this are reported.
            limit: f64,
        }
        reason "turns-back";
        says "at {count} location(s), the first near parameter {t}, the curve turns back within {limit} of the \
            spacing of the points: they lie nearly on a curve of lower degree, along which it runs back and forth; \
            change the parameters or use a Moebius spline";

        /// A curve changes between left and right far more often than its data.
        Wavers {
            /// Changes of the curve.
            curve: usize,
            /// Changes of the polygon through its nodes.
            data: usize,
            /// Those and three for each end of a straight run: the changes that the data explain.
            explained: usize,
            /// What helps.
            remedy: WaverRemedy,
        }
        reason "wavers";
        when *explained > *data, says "the curve changes {} between left and right, its points {} ({explained} with \
            the ends of their straight runs), so it wiggles between them (the comb of a picture shows where); {}",
            times(*curve),
            times(*data),
            remedy.advice();
        says "the curve changes {} between left and right, its points {}, so it wiggles between them (the comb of a \
            picture shows where); {}", times(*curve), times(*data), remedy.advice();

        /// The points change between left and right like noise, and so must a curve through all of them.
        DataWaver {
            /// Changes of the polygon through the nodes.
            changes: usize,
            /// Nodes, corners and ends excepted.
            nodes: usize,
        }
        reason "data-waver";
        says "the points change {changes} times between left and right at {nodes} nodes, like noise, and the curve \
            passes through all of them; a fit within a tolerance is smoother";

        /// The points turn sharply between straight runs, and the curve rounds a corner that was not marked.
        CornerNotMarked {
            /// Index of the first of these points.
            node: usize,
            /// How many there are.
            count: usize,
            /// The largest turn, radians.
            angle: f64,
            /// How far the curve is from the edges beside them.
            distance: f64,
        }
        reason "corner-not-marked";
        at *node;
        says "{count} point(s) turn by up to {:.1} degrees between straight runs, the first is point {node}: the \
            curve rounds them and leaves the runs by up to {distance}; if corners are intended, mark them (a corner \
            angle)", angle.to_degrees();

        /// Settings for ends were given, but a closed curve has none.
        EndsWithoutEffect
        reason "no-effect";
        says "a closed curve has no ends: the settings for its ends have no effect";
    }
}

/// A number of changes in words.
fn times(count: usize) -> String {
    if count == 1 { "once".to_owned() } else { format!("{count} times") }
}

/// The relaxed segments by the points they join, with the range of their blends.
fn relaxed(segments: &[(usize, f64)]) -> String {
    let place = match segments {
        [] => return "no segment is relaxed".to_owned(),
        [(one, _)] => format!("after point {one}"),
        [(first, _), .., (last, _)] => {
            format!("on {} segments, after points {first} to {last},", segments.len())
        }
    };
    let least = ShortNumber(segments.iter().map(|(_, e)| *e).fold(1.0, f64::min));
    let largest = ShortNumber(segments.iter().map(|(_, e)| *e).fold(0.0, f64::max));
    let blends = if least == largest { least.to_string() } else { format!("{least} to {largest}") };
    format!(
        "{place} the fairest curve would swing out, so it is less fair there (blend {blends}, 1 is the fairest); \
         if the points are intended to turn sharply, mark them as corners"
    )
}
