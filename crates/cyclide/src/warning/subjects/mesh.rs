//! Warnings about smooth surfaces over triangles.

use crate::table::table;

table! {
    /// Warnings about smooth surfaces over triangles.
    ///
    /// ```
    /// use cyclide::{Warning, warning::MeshWarning};
    /// let warning: Warning = MeshWarning::SpheresNearlyOpposite { length: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(warning.reason(), "spheres-nearly-opposite");
    /// ```
    pub enum MeshWarning {
        /// The smooth surface folds back at edges of a mesh: faces are too thin or too long for their normals, or the points noisy.
        FoldsBack {
            /// Ends of the edge at which it turns most.
            vertices: [usize; 2],
            /// A triangle there, from 0.
            triangle: usize,
            /// The angle between the normal of the derivatives and that of the surface there, radians: half a turn where it is folded.
            angle: f64,
            /// How many such edges there are.
            count: usize,
        }
        reason "folds-back";
        at *triangle;
        says "the surface folds back at {count} edge(s), the worst between vertices {} and {} in triangle \
            {triangle}: its normal turns by {:.0} degrees there; use `crease_angle` to keep edges, or a finer or \
            smoother mesh", vertices[0], vertices[1], angle.to_degrees();

        /// Sharp edges of a mesh became smooth, since no crease angle was given.
        SharpEdgesSmoothed {
            /// Ends of the sharpest.
            vertices: [usize; 2],
            /// The angle between its triangles, radians.
            angle: f64,
            /// How many there are.
            count: usize,
            /// Angles above this are reported, radians.
            limit: f64,
        }
        reason "sharp-edges-smoothed";
        says "{count} edge(s) that bend by more than {:.0} degrees were smoothed, by up to {:.1} degrees, between \
            vertices {} and {}: `crease_angle` keeps them",
            limit.to_degrees(),
            angle.to_degrees(),
            vertices[0],
            vertices[1];

        /// Border edges of a mesh coincide without being joined.
        LooseBorders {
            /// Ends of the first one.
            vertices: [usize; 2],
            /// How many there are.
            count: usize,
            /// Border edges of the mesh.
            borders: usize,
            /// The largest distance of the middle of one from the nearest other one; a hundredth of its length at most.
            gap: f64,
        }
        reason "open-seam";
        says "{count} of {borders} border edges lie within {gap} of another one, the first between vertices {} and \
            {}: weld points that should be one, or cut an edge where a vertex of its neighbor lies inside it",
            vertices[0], vertices[1];

        /// Normals of a mesh point to the back of a face at their vertex: the smooth surface folds over there.
        NormalFacesBackward {
            /// The first triangle with such a corner, from 0.
            triangle: usize,
            /// The vertex of it.
            vertex: usize,
            /// How many corners there are.
            count: usize,
        }
        reason "normal-faces-backward";
        at *triangle;
        says "{count} normal(s) point to the back of an adjacent triangle, the first at vertex {vertex} in triangle \
            {triangle}, so the surface folds over; reverse the normals or the triangles, or refine the mesh";

        /// Spheres at the corners of a triangle are nearly opposite: between them the patch swings round within a small part of
        /// the triangle.
        SpheresNearlyOpposite {
            /// Length of the blended sphere there, 1 where all agree.
            length: f64,
            /// Lengths up to this are reported.
            limit: f64,
        }
        reason "spheres-nearly-opposite";
        says "the spheres at the corners nearly cancel: where the blended one has length {length} (limit {}) the \
            patch swings far out within a small part of the triangle, and meshes of it need many triangles", *limit;
    }
}
