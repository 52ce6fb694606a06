//! Why a polyhedron, plane or spherical, was refused.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a polyhedron, plane or spherical, was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::PolyhedronError};
    /// let error: Error = PolyhedronError::Flat { thickness: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "flat-polyhedron");
    /// ```
    pub enum PolyhedronError: Error {
        /// A loop of vertices is not a valid face.
        NotAFace {
            /// Which face, from 0.
            face: usize,
            /// What is wrong with it.
            detail: &'static str,
        }
        reason "not-a-face";
        at *face;
        says "face {face}: {detail}";

        /// An edge of a polyhedron does not have one face on each side.
        NotClosed {
            /// Start of the edge.
            first: usize,
            /// Its end.
            second: usize,
            /// Faces along it in this direction.
            forward: usize,
            /// Faces along it in the other direction.
            back: usize,
        }
        reason "not-closed";
        when *forward + *back == 2, says "the faces do not close: {forward} of them run from point {first} to point \
            {second} and {back} in the opposite direction; there must be one each: reverse one of the two";
        says "the faces do not close: {forward} of them run from point {first} to point {second} and {back} in the \
            opposite direction; there must be one each";

        /// A corner of a face of a polyhedron is off its plane.
        NonPlanarFace {
            /// Which face, from 0.
            face: usize,
            /// The point that is farthest off.
            vertex: usize,
            /// Its distance.
            distance: f64,
            /// Largest distance accepted.
            limit: f64,
        }
        reason "non-planar-face";
        at *face;
        says "face {face} is not planar: point {vertex} is {distance} off its plane, limit {limit}";

        /// A polyhedron has a reflex edge.
        NotConvex {
            /// Start of the most reflex edge.
            first: usize,
            /// Its end.
            second: usize,
            /// The angle between its normals, radians: not positive.
            angle: f64,
            /// How many edges are reflex.
            reflex: usize,
            /// How many there are.
            edges: usize,
        }
        reason "not-convex";
        when *reflex == *edges, says "not convex: {reflex} of {edges} edges are reflex, the worst between points \
            {first} and {second}, by {} radians, limit 0; reverse the faces if they are clockwise as seen from \
            outside",
            ShortNumber(-*angle);
        says "not convex: {reflex} of {edges} edges are reflex, the worst between points {first} and {second}, by {} \
            radians, limit 0", ShortNumber(-*angle);

        /// The points lie in one plane and bound no body.
        Flat {
            /// Their largest distance from it.
            thickness: f64,
            /// Largest distance that counts as in the plane: the flatness, half of it where such points are merged, or rounding.
            limit: f64,
        }
        reason "flat-polyhedron";
        says "the points bound no body: all lie within {thickness} of one plane, must be more than {limit}";

        /// Directions that are not the corners of a convex polygon in an open half of the sphere.
        NotInOpenHemisphere {
            /// Which side, from 0; `None` for all together.
            side: Option<usize>,
            /// Its angle about the middle, radians, or that of all together; 0 where there is no middle.
            measured: f64,
            /// The angle of one side must be above this, or that of all together at most this.
            limit: f64,
        }
        reason "not-in-open-hemisphere";
        when side.is_some(), says "the corners do not lie counter-clockwise in an open half of the sphere: side \
            {side} turns by {measured} radians about the middle, must be between 0 and pi";
        says "the corners do not lie counter-clockwise in an open half of the sphere: all sides together turn by \
            {measured} radians about the middle, must be 2 pi";

        /// After merging, the planes of a polyhedron are far from a given point, or a corner of them is far from the given faces.
        PlanesMissPoint {
            /// The point, or the given point that became the corner.
            vertex: usize,
            /// Its distance from the other surface.
            distance: f64,
            /// Largest distance accepted.
            limit: f64,
        }
        reason "planes-miss-point";
        at *vertex;
        says "after merging nearly coplanar faces, the surface is {distance} off at point {vertex}, limit {limit}";
    }
}
