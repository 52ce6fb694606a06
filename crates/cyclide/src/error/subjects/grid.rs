//! Why a grid or layout of quads was refused, or could not be made circular.

use crate::error::{GridCellFault, LayoutFault};
use crate::shape_change::ShapeChange;
use crate::table::table;

table! {
    /// Why a grid or layout of quads was refused, or could not be made circular.
    ///
    /// ```
    /// use cyclide::{Error, error::GridError};
    /// let error: Error = GridError::CollapsedOnCurve { first: 0, second: 1 }.into();
    /// assert_eq!(error.reason(), "collapsed-on-curve");
    /// ```
    pub enum GridError: Error {
        /// The cells left in a grid cannot be built, or a construction needs all of them.
        CellsUnfit {
            /// What is wrong.
            fault: GridCellFault,
            /// A quad where it is, s fastest, from 0.
            index: usize,
        }
        reason "cells-unfit";
        at *index;
        field "of";
        says "{}", fault.words(*index);

        /// The quads of a mesh do not form regular grids that join round its irregular vertices.
        NotAQuadLayout {
            /// What is wrong.
            fault: LayoutFault,
            /// The quad or vertex where it is, from 0.
            index: usize,
        }
        reason "not-a-quad-layout";
        at *index;
        says "{}", fault.words(*index);

        /// A frame that is carried round an irregular vertex comes back turned by more than quarter turns.
        RingDoesNotClose {
            /// The vertex of the mesh.
            vertex: usize,
            /// The rotation beyond quarter turns, radians.
            angle: f64,
            /// The largest angle that is accepted.
            limit: f64,
        }
        reason "ring-does-not-close";
        at *vertex;
        says "the net is not smooth round irregular vertex {vertex}: a frame carried round it comes back turned by \
            {angle} rad more than quarter turns, limit {limit}";

        /// The quads of a grid cannot be made circular.
        NotConverged {
            /// Steps made.
            step: usize,
            /// Largest residual of a quad (dimensionless).
            residual: f64,
            /// Largest residual accepted.
            limit: f64,
        }
        reason "not-converged";
        says "the grid is not circular after {step} steps: largest residual {residual}, limit {limit}";

        /// A grid that was made circular has lost the shape of the given surface.
        ShapeLost {
            /// What was measured.
            change: Box<ShapeChange>,
        }
        reason "shape-lost";
        says "the shape is lost: {}", change.lost();

        /// Two neighboring vertices of a side moved to the same point of the curve on which the side slides.
        CollapsedOnCurve {
            /// The first vertex, s fastest.
            first: usize,
            /// The second vertex.
            second: usize,
        }
        reason "collapsed-on-curve";
        says "vertices {first} and {second} coincide on the curve of their side: use a curve that runs along the \
            whole side";

        /// Two curves on which the sides of a grid slide do not meet at the corner between them.
        BorderCurvesApart {
            /// The corner of the grid, s fastest.
            vertex: usize,
            /// Distance of the curves beside the corner.
            distance: f64,
            /// Largest distance accepted.
            limit: f64,
        }
        reason "border-curves-apart";
        says "the curves of the two sides at vertex {vertex} do not meet near it: distance {distance}, limit {limit}";
    }
}
