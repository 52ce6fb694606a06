//! Warnings about grids that were made circular.

use crate::shape_change::{ShapeChange, degrees};
use crate::table::table;

table! {
    /// Warnings about grids that were made circular.
    ///
    /// ```
    /// use cyclide::{Warning, warning::CircularWarning};
    /// let warning: Warning = CircularWarning::AcrossCurvatureLines { angle: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(warning.reason(), "across-curvature-lines");
    /// ```
    pub enum CircularWarning {
        /// The lines of a grid to be made circular do not follow the curvature lines of its surface.
        AcrossCurvatureLines {
            /// Mean angle to the curvature lines, weighted by the difference of the principal curvatures, radians.
            angle: f64,
            /// Angles above this are reported, radians.
            limit: f64,
        }
        reason "across-curvature-lines";
        says "the grid lines are {} degrees off the curvature lines of the surface on average (limit {}): circular \
            quads follow curvature lines", degrees(*angle), degrees(*limit);

        /// The shape of a grid changed when it was made circular.
        ShapeChanged {
            /// What was measured.
            change: ShapeChange,
        }
        reason "shape-changed";
        says "the shape changed: {}", change.changed();

        /// A vertex moved far when its grid was made circular: the grid does not follow the curvature lines of its surface.
        MovedFar {
            /// The vertex, s fastest.
            vertex: usize,
            /// Length of its move.
            distance: f64,
            /// Moves above this are reported: two median edges.
            limit: f64,
        }
        reason "moved-far";
        at *vertex;
        says "vertex {vertex} moved by {distance} (limit {limit}): align the grid with the curvature lines first";

        /// A vertex left the surface of its grid when it was made circular.
        LeftSurface {
            /// The vertex, s fastest.
            vertex: usize,
            /// Its distance from the input surface.
            distance: f64,
            /// Distances above this are reported: the median edge.
            limit: f64,
        }
        reason "left-surface";
        at *vertex;
        says "vertex {vertex} is {distance} off the input surface (limit {limit})";

        /// Grid lines zigzag from vertex to vertex: the grid is noisy or too coarse.
        Zigzag {
            /// Correlation of neighboring turns: 1 for smooth lines, -2/3 for independent errors of the vertices.
            agreement: f64,
            /// Mean turn at a vertex, radians.
            turn: f64,
        }
        reason "zigzag";
        says "the grid lines zigzag: they turn by {:.1} degrees at a vertex on average, and neighboring turns \
            correlate by {:.2} (smooth lines: 1); smooth or refine the grid first", turn.to_degrees(), *agreement;
    }
}
