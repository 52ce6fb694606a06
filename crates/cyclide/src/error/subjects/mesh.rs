//! Why a mesh of triangles was refused.

use crate::table::table;

table! {
    /// Why a mesh of triangles was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::MeshError};
    /// let error: Error = MeshError::NoTriangles { vertices: 2, needed: 3 }.into();
    /// assert_eq!(error.reason(), "no-triangles");
    /// ```
    pub enum MeshError: Error {
        /// A mesh without a triangle.
        NoTriangles {
            /// Number of vertices, of which none has a face.
            vertices: usize,
            /// Number of triangles needed.
            needed: usize,
        }
        reason "no-triangles";
        says "the mesh has no triangles: {vertices} vertices and 0 triangles given, at least {needed} needed";

        /// A triangle names a vertex that does not exist.
        NoSuchVertex {
            /// Which triangle, from 0.
            triangle: usize,
            /// The index it names.
            vertex: usize,
            /// Number of vertices.
            count: usize,
        }
        reason "no-such-vertex";
        at *triangle;
        says "triangle {triangle} refers to vertex {vertex}, but there are {count} vertices, counted from 0";

        /// More than two triangles share an edge.
        NonManifoldEdge {
            /// Ends of the edge, the lower index first.
            vertices: [usize; 2],
            /// The first of the triangles, from 0.
            triangle: usize,
            /// How many there are.
            count: usize,
        }
        reason "non-manifold-edge";
        at *triangle;
        says "{count} triangles, one of them triangle {triangle}, share the edge from vertex {} to vertex {}, \
            maximum 2", vertices[0], vertices[1];

        /// Two adjacent triangles have opposite orientations.
        InconsistentOrientation {
            /// Start and end of the edge.
            vertices: [usize; 2],
            /// The triangles, from 0.
            triangles: [usize; 2],
        }
        reason "inconsistent-orientation";
        at triangles[1];
        says "triangles {} and {} both run from vertex {} to vertex {}: reverse one of them, or remove it if it is a \
            duplicate", triangles[0], triangles[1], vertices[0], vertices[1];

        /// The normals of the faces around a vertex cancel.
        UndefinedNormal {
            /// Which vertex, from 0.
            vertex: usize,
            /// Length of the weighted mean of the normals of its faces, or of the normal given.
            length: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "undefined-normal";
        at *vertex;
        when *limit <= 0.0, says "vertex {vertex} has no normal: the given one is zero";
        says "vertex {vertex} has no normal: the normals of its faces cancel, or the given one runs along its circle \
            (length {length}, limit {limit})";
    }
}
