//! Why no grid was made along the lines of curvature of a surface.

use crate::error::{JoinFault, SurfaceFault};
use crate::table::table;

table! {
    /// Why no grid was made along the lines of curvature of a surface.
    ///
    /// ```
    /// use cyclide::{Error, error::PrincipalGridError};
    /// let error: Error = PrincipalGridError::SpiralLines { shift: 0.5, edge: 0.5 }.into();
    /// assert_eq!(error.reason(), "spiral-lines");
    /// ```
    pub enum PrincipalGridError: Error {
        /// The triangles are not one connected surface with a border.
        NotASurface {
            /// What is wrong.
            fault: SurfaceFault,
            /// A triangle where it is, from 0.
            index: usize,
        }
        reason "not-a-surface";
        at *index;
        says "the mesh is not one connected surface with a border: {}", fault.words(*index);

        /// A surface has no lines of curvature: it is a plane or a sphere.
        FlatSurface {
            /// Median difference of the principal curvatures.
            difference: f64,
            /// Smallest difference that determines directions.
            limit: f64,
            /// The distance of the vertices from a smooth surface, where noise alone explains that difference.
            noise: Option<f64>,
        }
        reason "flat-surface";
        when noise.is_some(), says "the surface is flat or spherical, except for noise of {noise}: its principal \
            curvatures differ by {difference} (median), must be more than {limit} to distinguish lines of curvature \
            from noise; smooth the mesh first, or use one with longer edges";
        says "the surface is flat or spherical: its principal curvatures differ by {difference} (median), must be \
            more than {limit} to determine lines of curvature; every curve on a plane or a sphere is one";

        /// Umbilics remain however much the directions are smoothed.
        UmbilicsRemain {
            /// How many.
            count: usize,
            /// Where the first is.
            at: [f64; 3],
            /// How many half turns the lines of curvature make round it.
            halves: i32,
            /// The smoothing that was tried last with so few left.
            smoothing: f64,
        }
        reason "umbilics-remain";
        says "{count} umbilic(s) remain after smoothing by {smoothing}, the first at ({at}) (index {}), which a \
            single grid cannot contain: use several grids beside them, one mesh joined round them with a border \
            inside the surface or in steps, or cut a hole round them", index_of_halves(*halves);

        /// No single mesh of quads continues through an umbilic.
        UmbilicsNotJoined {
            /// Where it is.
            at: [f64; 3],
            /// What prevents it.
            fault: JoinFault,
        }
        reason "umbilics-not-joined";
        says "no single mesh of quads continues through the umbilic at ({at}): {}; use separate grids beside it",
            fault.words();

        /// Lines of curvature come back reversed after one loop round a hole, so no coordinates follow them all round.
        FieldNotOrientable {
            /// A point on the border of the hole.
            at: [f64; 3],
            /// How many half turns the lines make round in the hole.
            halves: i32,
        }
        reason "field-not-orientable";
        says "the lines of curvature come back reversed after one loop round the hole at ({at}) (index {}): use \
            separate grids beside it", index_of_halves(*halves);

        /// The lines of curvature of a tube are spirals: closing them would change the shape.
        SpiralLines {
            /// By how much they come back higher.
            shift: f64,
            /// Length of an edge of the grid, the limit.
            edge: f64,
        }
        reason "spiral-lines";
        says "the lines of curvature are spirals that come back {shift} higher or lower (edge length {edge}): \
            closing them changes the shape of the surface; close them anyway, or leave the grid open";

        /// No grid fits on the surface.
        NoGrid {
            /// Length of its edges.
            edge: f64,
            /// Cells along each side at least.
            least: usize,
        }
        reason "no-grid";
        says "no grid of {least} by {least} cells with edges of {edge} fits on the surface: use shorter edges";
    }
}

/// The index of an umbilic or hole, from the half turns of the lines round it.
fn index_of_halves(halves: i32) -> String {
    let sign = if halves < 0 { "-" } else { "+" };
    let size = halves.unsigned_abs();
    if size.is_multiple_of(2) { format!("{sign}{}", size / 2) } else { format!("{sign}{size}/2") }
}
