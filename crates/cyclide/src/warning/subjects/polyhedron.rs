//! Warnings about polyhedra.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about polyhedra.
    ///
    /// ```
    /// use cyclide::{Warning, warning::PolyhedronWarning};
    /// let warning: Warning = PolyhedronWarning::FlatnessRaised { asked: 0.5, used: 0.5 }.into();
    /// assert_eq!(warning.reason(), "flatness-raised");
    /// ```
    pub enum PolyhedronWarning {
        /// No faces of the hull are planar within the default flatness, so it was raised until some are.
        FlatnessRaised {
            /// The default, 1e-9 of the diameter.
            asked: f64,
            /// The flatness used.
            used: f64,
        }
        reason "flatness-raised";
        says "the points do not lie in planes within {asked}, 1e-9 of their diameter: {used} is used, as for rounded \
            points; give the rounding of the points as `flatness`";

        /// Faces merged within the given flatness formed no convex body, and a smaller one was used: nearly equal planes meet far
        /// from the points.
        FlatnessLowered {
            /// The given flatness.
            asked: f64,
            /// The flatness used.
            used: f64,
        }
        reason "flatness-lowered";
        says "faces merged within the flatness {asked} form no convex body, since it is hardly thicker; the flatness \
            {used} is used instead";

        /// Faces of a polyhedron are nearly coplanar at edges, as where coordinates have few digits.
        ShallowEdges {
            /// Ends of the edge that bends least.
            ends: [usize; 2],
            /// How many there are.
            count: usize,
            /// The least angle between the normals of two faces, radians.
            angle: f64,
            /// Angles below this are reported, radians.
            limit: f64,
            /// How far the corners of one face are off the plane of the other one at most.
            off: f64,
        }
        reason "shallow-edges";
        says "{count} edge(s) bend by less than {limit} radians, the least between points {} and {}, by {angle}: if \
            their faces should be in one plane, give the rounding of the points as `flatness`, about {}; corners are \
            up to {off} off the plane beside them",
            ends[0],
            ends[1],
            ShortNumber(IN_ONE_PLANE * *off);

        /// Edges of a polyhedron are so short that their ends differ only by rounding.
        ShortEdges {
            /// Ends of the shortest one.
            ends: [usize; 2],
            /// How many there are.
            count: usize,
            /// Length of the shortest one.
            length: f64,
            /// Lengths up to this are reported; a hull merges such points.
            limit: f64,
        }
        reason "short-edges";
        says "{count} edge(s) are at most {limit} long, so that their ends differ only by rounding, the shortest \
            between points {} and {}, of length {length}: merge their ends, or use the hull, which merges them",
            ends[0], ends[1];
    }
}

/// Times the distance of corners from the plane beside them, a flatness with which faces of rounded points are in one plane: of a box of
/// points whose digits are cut, with 99 of 100.
const IN_ONE_PLANE: f64 = 4.0;
