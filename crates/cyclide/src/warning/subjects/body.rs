//! Warnings about bodies of revolution, bodies between two curves, and necks.

use crate::shape_change::degrees;
use crate::table::table;

table! {
    /// Warnings about bodies of revolution, bodies between two curves, and necks.
    ///
    /// ```
    /// use cyclide::{Warning, warning::BodyWarning};
    /// let warning: Warning = BodyWarning::OpenPart { angle: 0.5 }.into();
    /// assert_eq!(warning.reason(), "open-body");
    /// ```
    pub enum BodyWarning {
        /// The ball of a neck is larger than the bends of its path: the neck self-intersects.
        NeckFolds {
            /// Radius of the ball.
            radius: f64,
            /// Smallest radius of curvature of the path of its center.
            limit: f64,
        }
        reason "neck-folds";
        says "the neck self-intersects on the side to which the pipe leans: the ball has radius {radius}, but its \
            path bends with radius {limit}; use a smaller ball";

        /// The ellipses of a bridge cross: it self-intersects beside the crossings.
        EllipsesCross {
            /// By how much the semi-axis of the second ellipse is larger along x.
            along_x: f64,
            /// The same along y.
            along_y: f64,
        }
        reason "ellipses-cross";
        says "the ellipses cross: the semi-axes of the second are larger by {along_x} along x and by {along_y} along \
            y, and the bridge self-intersects beside the crossings; put one ellipse inside the other";

        /// The ends of a profile were near the axis of revolution, and were snapped to it.
        MovedToAxis {
            /// The largest distance of them.
            distance: f64,
            /// Ends up to this distance are snapped.
            limit: f64,
        }
        reason "moved-to-axis";
        says "the ends of the profile, up to {distance} off the axis, were snapped to it (tolerance {limit}); write \
            more digits, or start farther out for a bore";

        /// A partial revolution of a profile that encloses an area has no end faces.
        OpenPart {
            /// The angle of the turn, radians.
            angle: f64,
        }
        reason "open-body";
        says "the body is open at both ends of its turn by {} degrees: end faces need contours in a plane through the \
            axis that intersect neither themselves nor each other; a full turn is a solid", degrees(*angle);

        /// A full turn of a profile that encloses no area: the surface is open where its ends are off the axis.
        OpenProfile {
            /// Distance of its start from the axis.
            start: f64,
            /// Distance of its end.
            end: f64,
        }
        reason "open-body";
        when *start > 0.0 && *end > 0.0, says "the surface is open: its profile starts {start} and ends {end} off \
            the axis; a solid needs a closed profile, or both ends on the axis";
        when *start > 0.0, says "the surface is open: its profile starts {start} off the axis; a solid needs a \
            closed profile, or both ends on the axis";
        says "the surface is open: its profile ends {end} off the axis; a solid needs a closed profile, or both \
            ends on the axis";

        /// A closed profile touches the axis in one point: the solid is pinched there, its inside on both sides of one vertex.
        Pinched {
            /// The height of the point along the axis.
            height: f64,
        }
        reason "pinched";
        says "the closed profile touches the axis at height {height}, where the solid meets itself in a single point \
            and many programs reject it; keep the profile off the axis, or run it along the axis";

        /// A profile lies in a plane perpendicular to the axis of revolution: the swept surface is a part of that plane.
        FlatRevolution
        reason "flat-revolution";
        says "the profile lies in a plane perpendicular to the axis, so the surface is flat; for a body give it \
            heights along the axis (points [r, 0, z] for the axis z), or use an axis in its plane";

        /// A surface between two curves has kinks where pieces of the curves join smoothly.
        KinksAtJoints {
            /// Joints at which its normals differ by more than the limit.
            count: usize,
            /// The joint of the curves with the largest angle, from 0.
            joint: usize,
            /// That angle, radians.
            angle: f64,
            /// Angles above this are reported, radians.
            limit: f64,
        }
        reason "kinks-at-joints";
        at *joint;
        says "the surface has kinks at {count} joint(s) where both curves are smooth, the largest of {} degrees at \
            joint {joint} (limit {}): the speeds of the two curves jump there by different factors; use curves with \
            pieces of similar lengths on both sides, or of one piece", degrees(*angle), degrees(*limit);

        /// Arcs between two curves start nearly opposite to their chords, so they are nearly full circles with radii of many chords.
        NearlyFullArcs {
            /// The piece of the curves with the smallest such angle, from 0.
            piece: usize,
            /// The angle between the tangent and the direction back along the chord there, radians.
            angle: f64,
            /// Angles below this are reported, radians.
            limit: f64,
        }
        reason "nearly-full-arcs";
        at *piece;
        says "the arcs of piece {piece} start {angle} radians from the direction back along their chords (limit \
            {limit}): they are nearly full circles with radii of ten chords and more, and other programs may find \
            their edges off the faces; lean the tangent farther to one side";
    }
}
