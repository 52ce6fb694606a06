//! Why a triangle, or a patch over one, was refused.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a triangle, or a patch over one, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::TriangleError};
    /// let error: Error = TriangleError::Degenerate { area: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "degenerate-triangle");
    /// ```
    pub enum TriangleError: Error {
        /// The corners of a triangle lie on one line, or nearly.
        Degenerate {
            /// Twice the area, relative to the square of the longest edge.
            area: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "degenerate-triangle";
        says "the corners of the triangle lie on one line: twice its area is {area} of its longest edge squared, \
            limit {limit}";

        /// A control point lies on the circle through the corners of its triangle and determines no sphere.
        ControlPointOnCircumcircle {
            /// The corner whose sphere it is, from 0.
            corner: usize,
            /// How far it is off, relative to the circle and its distance.
            distance: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "control-point-on-circumcircle";
        says "control point {corner} lies on the circle through the corners: relative distance {distance}, limit \
            {limit}";

        /// The blended spheres cancel.
        OppositeSpheres {
            /// The first two barycentric coordinates of the location.
            at: [f64; 2],
            /// Length of the blended sphere, 1 where all agree.
            length: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "opposite-spheres";
        says "the spheres of the corners cancel near lambda = {}, {}: their blend has length {length}, limit {limit}",
            ShortNumber(at[0]), ShortNumber(at[1]);

        /// A normal runs along an edge that must be perpendicular to it.
        NormalAlongEdge {
            /// The corner of the triangle, from 0.
            corner: usize,
            /// The part of the line perpendicular to the normal, relative to its length.
            across: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "normal-along-edge";
        says "the normal at corner {corner} runs along an edge or a transversal line of its triangle: relative \
            perpendicular part {across}, limit {limit}";

        /// The normals at the ends of an edge cancel between them.
        OppositeNormals {
            /// The corner of the triangle, from 0.
            corner: usize,
            /// Length of the blended normal across the edge.
            length: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "opposite-normals";
        says "the normals at the ends of the side opposite to corner {corner} cancel between them: length {length}, \
            limit {limit}";
    }
}
