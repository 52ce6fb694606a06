//! Warnings about curves that were fitted to points.

use crate::table::table;
use crate::warning::{NoiseWarning, Warning};

table! {
    /// Warnings about curves that were fitted to points.
    ///
    /// ```
    /// use cyclide::{Warning, warning::FitWarning};
    /// let warning: Warning = FitWarning::SamplesTooCoarse { sagitta: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(warning.reason(), "samples-too-coarse");
    /// ```
    pub enum FitWarning {
        /// Corners of the input were kept as corners.
        CornerKept {
            /// Index of the first of the points.
            vertex: usize,
            /// How many there are.
            count: usize,
            /// Least turn at one of them, radians.
            least: f64,
            /// Largest turn at one of them, radians.
            most: f64,
        }
        reason "corner-kept";
        at *vertex;
        when *count == 1, says "point {vertex}: corner of {:.1} degrees kept", most.to_degrees();
        says "{count} corners of {} degrees kept, the first at point {vertex}", turns_from(*least, *most);

        /// The samples are too far apart for the tolerance, unless the edges themselves are the shape.
        SamplesTooCoarse {
            /// Median sagitta of the edges.
            sagitta: f64,
            /// Largest sagitta an arc over two vertices can have.
            limit: f64,
        }
        reason "samples-too-coarse";
        says "the median sagitta of the edges is {sagitta}, the limit for an arc over two edges is {limit}: if the \
            points are samples of a smooth curve, use the target `points`";

        /// A fair fit is bound to edges that are farther from a smooth curve through their points than the tolerance.
        EdgesTooCoarse {
            /// Median sagitta of the edges.
            sagitta: f64,
            /// The tolerance.
            limit: f64,
        }
        reason "samples-too-coarse";
        says "the median sagitta of the edges is {sagitta}, above the tolerance of {limit} that they are bound to: if \
            the points are samples of a smooth curve, leave `polyline` out, or use a larger tolerance";

        /// Arcs of a fit are much tighter than any circle of the data near them: they may hide a corner.
        TightArc {
            /// The piece that is tightest against its data, from 0.
            piece: usize,
            /// Index of the point at its start.
            vertex: usize,
            /// Its radius.
            radius: f64,
            /// Radius of the tightest circle of the data near it.
            data: f64,
            /// Radii below this are reported.
            limit: f64,
            /// How many arcs are that tight.
            count: usize,
        }
        reason "tight-arc";
        at *vertex;
        says "{count} arc(s) are much tighter than the data, the tightest is piece {piece} at point {vertex}: radius \
            {radius}, the tightest circle of the data there has {data} (limit {limit})";

        /// A fit turns more than its data do within the tolerance: it oscillates between the points.
        TurnsMoreThanData {
            /// Total turning of the fit, radians.
            turning: f64,
            /// The most that the data turn within the tolerance, radians.
            limit: f64,
        }
        reason "turns-more-than-data";
        says "the fit turns by {:.2} radians in total, its data by at most {:.2}: smooth the points or raise the \
            tolerance", *turning, *limit;

        /// A smooth curve within the tolerance needs nearly as many nodes as there are points.
        ManyNodes {
            /// Nodes of the curve.
            nodes: usize,
            /// Points it was fitted to; more than a third as many nodes are reported.
            points: usize,
        }
        reason "many-nodes";
        says "{nodes} nodes for {points} points: the points are too few, or the tolerance too small, for fewer \
            nodes; corners take few nodes only if they are marked (a corner angle)";

        /// A tolerance is large compared with the size of the points: a smaller one gave a better curve.
        WideTolerance {
            /// The tolerance asked for.
            tolerance: f64,
            /// The tolerance that the curve keeps: the given one for an arc fit.
            used: f64,
        }
        reason "wide-tolerance";
        when *used >= *tolerance, says "the tolerance {tolerance} is large compared with the size of the points: \
            bends and corners smaller than it may be lost";
        says "the tolerance {tolerance} is large compared with the size of the points: the curve stays within {used}, \
            where it is fairer or swings out less";

        /// The tolerance is so large that bends or loops are lost: the curve is less than 0.8 times as long as its points indicate.
        ShapeSmoothedAway {
            /// Length of the curve.
            curve: f64,
            /// Length of the line through the points after their noise has been smoothed.
            data: f64,
        }
        reason "shape-smoothed-away";
        says "the curve is {curve} long, but its points indicate {data}: bends or loops smaller than the tolerance \
            are lost";

        /// A fair fit has more or fewer nodes than requested.
        NodesNotReached {
            /// Requested nodes of each smooth piece.
            asked: usize,
            /// Nodes of the piece that differs most.
            reached: usize,
            /// What decided: `tolerance`, `budget`, `max-fits`, `fewest` (no curve has fewer) or `first-fit` (the tolerance
            /// was reached with fewer).
            why: &'static str,
        }
        reason "nodes-not-reached";
        says "{asked} nodes were requested, the curve has {reached}: {}", what_decided(&why);

        /// A fit swung out between its points, far from their polyline, as at a corner that is not marked.
        SwingsOut {
            /// How far the curve was from the polyline.
            distance: f64,
            /// The distance that samples of a smooth curve explain (see `FairFit::new`; for arcs twice the tolerance and the largest
            /// sagitta): larger ones are reported.
            limit: f64,
            /// It was fitted again with locations on the edges, and does not swing out any more.
            held: bool,
            /// It is an arc fit, which can take the edges as they are.
            has_target: bool,
            /// Outliers among the points are kept, which pull it.
            outliers: bool,
        }
        reason "swings-out";
        says "between the points the curve {} up to {distance} from their polyline (limit {limit}){}; {}",
            if *held { "would swing out" } else { "swings out" },
            if *held { ", so it is held to locations on the edges too" } else { "" },
            if *has_target {
                    "if the edges are intended, the target `polyline` keeps all of them; smooth scattered points first"
                } else if *outliers {
                    "the outliers may pull it there: leave them out"
                } else {
                    "if the points have corners, give a corner angle"
                };

        /// Edges between measured points are far longer than those near them: straight sides of an outline, or gaps in a curve.
        LongEdges {
            /// The point from which the first of them runs.
            point: usize,
            /// How many there are.
            count: usize,
            /// The curve is held to them as straight sides; else it is free there.
            held: bool,
        }
        reason "long-edges";
        at *point;
        says "{} far longer than the edges near {}: {}; if that is wrong, measure points there",
            if *count == 1 {
                format!("the edge after point {point} is")
            } else {
                format!("{count} edges, the first after point {point}, are")
            },
            if *count == 1 { "it" } else { "them" },
            match (*held, *count) {
                (true, 1) => "treated as a straight side, which the curve follows",
                (true, _) => "treated as straight sides, which the curve follows",
                (false, 1) => "treated as a gap, where the curve is free",
                (false, _) => "treated as gaps, where the curve is free",
            };

        /// Points with large turns were read as samples of a smooth curve, but may be corners.
        ReadAsCurve {
            /// How many there are.
            count: usize,
            /// Largest turn at one of them, radians.
            turn: f64,
            /// How far the curve is from their polyline.
            distance: f64,
            /// A fit that has the target `polyline`.
            has_target: bool,
        }
        reason "read-as-curve";
        when *has_target, says "{count} points that turn by up to {:.1} degrees are read as samples of a curve, \
            which leaves their polyline by {distance}: if its edges are intended, the target `polyline` keeps all of \
            them, a smaller corner angle those between larger turns", turn.to_degrees();
        says "{count} points that turn by up to {:.1} degrees are read as samples of a curve, which leaves their \
            polyline by {distance}: if its edges are intended, a smaller corner angle keeps the larger turns as \
            corners", turn.to_degrees();
    }
}

/// A range of turns, in degrees.
fn turns_from(least: f64, most: f64) -> String {
    let (least, most) = (format!("{:.1}", least.to_degrees()), format!("{:.1}", most.to_degrees()));
    if least == most { most } else { format!("{least} to {most}") }
}

/// What decided on the number of nodes.
fn what_decided(why: &str) -> &'static str {
    match why {
        "tolerance" => "the tolerance needs them",
        "budget" => "fewer would exceed the fairness budget: raise it",
        "max-fits" => "the limit on fits for removing nodes was reached: allow more",
        "first-fit" => "these reach the tolerance",
        _ => "a curve cannot have fewer",
    }
}

impl FitWarning {
    /// Of a curve with nearly as many nodes as points. Points that change between left and right more than once in three do so as noise does.
    pub(crate) fn of_many_nodes(nodes: usize, points: usize, changes: usize) -> Warning {
        if 3 * changes > points {
            NoiseWarning::NoisyNodes { nodes, points, changes }.into()
        } else {
            Self::ManyNodes { nodes, points }.into()
        }
    }
}
