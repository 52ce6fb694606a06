//! Why a patch, a net of patches or an offset of it was refused.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a patch, a net of patches or an offset of it was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::PatchError};
    /// let error: Error = PatchError::CrossingQuad { position: 0.5 }.into();
    /// assert_eq!(error.reason(), "crossing-quad");
    /// ```
    pub enum PatchError: Error {
        /// The four corners of a quad are not on one circle (or line).
        NotConcircular {
            /// Distance of the last corner from the circle of the others, relative to the quad's size.
            measured: f64,
            /// Largest distance accepted.
            limit: f64,
        }
        reason "not-concircular";
        at 3;
        says "the corners do not lie on one circle: relative distance {measured}, limit {limit}";

        /// The corners of a quad are on a circle but not in the order a0, a1, a3, a2.
        CrossingQuad {
            /// Position of the opposite corner on the inverted arc between its neighbors, outside `[0, 1]`.
            position: f64,
        }
        reason "crossing-quad";
        at 3;
        says "the sides cross: the corner opposite to the first is outside the arc between its neighbors (position \
            {position}, must be 0 to 1)";

        /// The directions of a frame, which may have any length but zero, are not perpendicular.
        FrameNotOrthonormal {
            /// Cosine of the angle between them; 1 where one of them is zero.
            measured: f64,
            /// Largest cosine accepted.
            limit: f64,
        }
        reason "frame-not-orthonormal";
        field "frame";
        says "the directions of the frame are not perpendicular: cosine {measured}, limit {limit}";

        /// The weights take the surface out of three-space.
        NotInSpace {
            /// Largest real part of the quotient, relative to the size.
            defect: f64,
            /// Largest defect accepted.
            limit: f64,
        }
        reason "not-in-space";
        says "the weights take the patch out of three-space: relative defect {defect}, limit {limit}";

        /// The patch contains the point at infinity.
        ThroughInfinity {
            /// First parameter.
            s: f64,
            /// Second parameter.
            t: f64,
        }
        reason "patch-through-infinity";
        says "the patch passes through infinity near s = {s}, t = {t}";

        /// The circle of a side, given by its direction at the first corner, runs through the opposite corner: no patch has both.
        EdgeCircleThroughCorner {
            /// The side at the first corner: 0 along s, 1 along t.
            side: usize,
            /// Sine of the angle between the direction and the circle through the first corner, the end of the side and the opposite corner.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "edge-circle-through-corner";
        at *side;
        field "directions";
        says "the circle of the side along {} runs through the opposite corner (sine of the angle {measured}, limit \
            {limit}): no patch of circles has both; turn that direction",
            if *side == 0 { 's' } else { 't' };

        /// Corners and directions leave more than one number free.
        TwistNotUnique
        reason "twist-not-unique";
        field "twist";
        says "one twist does not say the patch: corners and directions lie on one sphere or plane, or a side is a single \
            point; give a vector for the corner instead";

        /// Four arcs that bound no patch of circles.
        ArcsDoNotClose {
            /// The angle by which the turns along both ways to the opposite corner differ, radians.
            holonomy: f64,
            /// Largest angle accepted.
            limit: f64,
        }
        reason "arcs-do-not-close";
        field "arcs";
        says "the four arcs bound no patch of circles: a frame carried along both ways to the opposite corner is off by \
            {holonomy} radians, limit {limit}";

        /// Four arcs of which one has to run the other way round its circle.
        ArcsNeedComplement {
            /// The angle by which the turns along both ways to the opposite corner differ, radians: half a turn.
            holonomy: f64,
        }
        reason "arcs-need-complement";
        field "arcs";
        says "the four arcs bound no patch of circles as they run, but they do where one of them runs the other way round \
            its circle (the two ways to the opposite corner differ by {holonomy} radians): turn its tangent round";

        /// The last weight that follows from four arcs is not positive: the patch would pass through infinity.
        WeightNotPositive {
            /// Its factor.
            ratio: f64,
        }
        reason "weight-not-positive";
        field "arcs";
        says "the patch over these four arcs passes through infinity: the factor of its last weight is {ratio}, and must be \
            positive";

        /// Four arcs that leave the last weight free: they are on one sphere, or all their circles run through one point.
        UndeterminedWeight {
            /// The larger of the two terms whose quotient it is.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "undetermined-weight";
        field "arcs";
        says "the four arcs do not determine a patch: they lie on one sphere, or their circles run through one point \
            ({measured}, limit {limit}); give corners, directions and a corner vector";

        /// A frame that is carried once round a closed net does not return to itself.
        NetDoesNotClose {
            /// The closed direction: 0 for s, 1 for t.
            direction: usize,
            /// The pinned row or column along it that causes this, from 0, where it is one.
            line: Option<usize>,
            /// Angle of the rotation from the initial frame to the returned one, radians.
            angle: f64,
            /// Ratio of the parameter speeds on both sides of the seam, minus 1.
            stretch: f64,
            /// Largest angle and stretch accepted.
            limit: f64,
        }
        reason "net-does-not-close";
        says "the net does not close along {}: after one turn{} the frame is off by {angle} radians{}, limit {limit}",
            if *direction == 0 { 's' } else { 't' },
            along_pinned(*direction, *line),
            speed_ratio(*stretch, *limit);

        /// The directions of the edges of a net determine no frame.
        AmbiguousFrame {
            /// Strength of the second common direction of the edges, relative to the first: 0 where there is only one.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "ambiguous-frame";
        says "the edges of the net do not determine a frame (relative strength of their second direction {measured}, \
            limit {limit}): give a frame at the first vertex";

        /// A construction needs four proper sides, and one is a single point.
        CollapsedSide {
            /// The side: `s = 0`, `s = 1`, `t = 0` or `t = 1`.
            side: &'static str,
            /// What cannot be made.
            cannot: &'static str,
        }
        reason "collapsed-side";
        says "the side {side} of the net is a single point: {cannot}";

        /// An offset that shrinks to a curve or a point.
        OffsetOnFocalSet {
            /// Signed distance of the offset.
            distance: f64,
            /// Largest speed of a line of the family that shrinks, relative to the terms of which it is the sum.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "offset-on-focal-set";
        field "distance";
        says "the offset at distance {distance} lies on the focal set: all centers of curvature of one family of \
            lines are at that distance, so the surface shrinks to a curve or a point (relative speed of the lines \
            {measured}, limit {limit})";

        /// A solid between a surface and its offset would self-intersect.
        OffsetNotRegular {
            /// Signed distance of the offset.
            distance: f64,
            /// Signed distance of the first center of curvature on that side: smaller ones are accepted. 0 where the surface itself
            /// is folded or singular.
            limit: f64,
        }
        reason "offset-not-regular";
        field "distance";
        when *limit == 0.0, says "a solid between the surface and its offset at distance {distance} would \
            self-intersect: the surface itself is singular or folded there, so that no distance is accepted";
        says "a solid between the surface and its offset at distance {distance} would self-intersect: a center of \
            curvature lies between them, or on one of them, limit {}",
            ShortNumber(nearer(*limit));
    }
}

/// The pinned line of a net that does not close: rows run along s, columns along t.
fn along_pinned(direction: usize, line: Option<usize>) -> String {
    let name = if direction == 0 { "row" } else { "column" };
    line.map_or(String::new(), |line| format!(" along pinned {name} {line}"))
}

/// The ratio of speeds `1 + stretch` in words, where it is worth any.
fn speed_ratio(stretch: f64, limit: f64) -> String {
    if stretch.abs() <= limit {
        return String::new();
    }
    let sign = if stretch < 0.0 { '-' } else { '+' };
    format!(" and the speed of the transversal lines by the factor 1 {sign} {}", ShortNumber(stretch.abs()))
}

/// A limit as it is shown, rounded towards zero unless it is as short as that: what is read can be taken.
fn nearer(limit: f64) -> f64 {
    let shown = |x: f64| ShortNumber(x).to_string().parse::<f64>().map_or(x.abs(), f64::abs);
    let parts = [0.0, 1e-4, 1e-3, 1e-2].into_iter().map(|part| limit * (1.0 - part));
    // What is off by less is rounding of the limit itself.
    parts.into_iter().find(|x| shown(*x) <= limit.abs() * (1.0 + 1e-9)).unwrap_or(limit)
}
