//! Warnings about grids along the lines of curvature of a surface.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about grids along the lines of curvature of a surface.
    ///
    /// ```
    /// use cyclide::{Warning, warning::PrincipalGridWarning};
    /// let warning: Warning = PrincipalGridWarning::UmbilicsSmoothed { count: 2, turn: 0.5 }.into();
    /// assert_eq!(warning.reason(), "umbilics-smoothed");
    /// ```
    pub enum PrincipalGridWarning {
        /// Directions of curvature were smoothed more than usual to remove umbilics.
        UmbilicsSmoothed {
            /// How many were removed.
            count: usize,
            /// By how much that turned the directions on average, radians.
            turn: f64,
        }
        reason "umbilics-smoothed";
        says "{count} umbilic(s) were smoothed away, which turned the directions by {} degrees on average: a net \
            over the grid leaves the surface there", degrees(*turn);

        /// A surface is covered by several grids, or only partly by one.
        Pieces {
            /// How many.
            count: usize,
            /// The part of the surface that they cover.
            coverage: f64,
        }
        reason "pieces";
        says "{count} grid(s) beside umbilics or cuts cover {} % of the surface; they do not share borders",
            percent(*coverage);

        /// Grids do not cover all of their surface.
        PartlyCovered {
            /// The part of the surface's area that they cover.
            coverage: f64,
            /// The part below which it is reported.
            limit: f64,
            /// True if each grid is a rectangle, as was asked for; false if it consists of all complete cells, or these cover no more.
            rectangles: bool,
            /// How many umbilics the surface has.
            umbilics: usize,
        }
        reason "partly-covered";
        when *rectangles, says "{} % of the surface is covered, less than {} %: use a border in steps (`staircase`) \
            and shorter edges to cover more", percent(*coverage), ShortNumber(100.0 * *limit);
        when *umbilics == 0, says "{} % of the surface is covered, less than {} %: use shorter edges to cover more, \
            or the border `cover` to cover all of it", percent(*coverage), ShortNumber(100.0 * *limit);
        says "{} % of the surface is covered, less than {} %: shorter edges may cover more, and umbilics `smooth`, which \
            leave the surface around them; or model the parts around the umbilics as separate patches",
            percent(*coverage), ShortNumber(100.0 * *limit);

        /// One mesh of quads round umbilics includes only some of them.
        UmbilicsLeftOut {
            /// How many are left out.
            count: usize,
            /// Where the first is.
            at: [f64; 3],
        }
        reason "umbilics-left-out";
        says "{count} umbilic(s) are not in the mesh, the first at {at}: the mesh ends before them, near the border \
            or where coordinates fold";

        /// A mesh of quads round umbilics does not follow the lines of curvature on a part of its surface.
        OffCurvatureLines {
            /// That part, as a fraction of the surface where the principal curvatures differ clearly.
            part: f64,
            /// Angles above this count, radians.
            angle: f64,
            /// Parts above this are reported.
            limit: f64,
        }
        reason "off-curvature-lines";
        says "on {} % of the surface (where its curvatures differ) the grid is more than {} degrees off the lines of \
            curvature: a net leaves the surface there", percent(*part), degrees(*angle);

        /// The lines of curvature of a tube are spirals: a grid that is closed along them leaves them.
        SpiralLines {
            /// By how much they come back higher.
            shift: f64,
            /// Length of an edge of the grid.
            edge: f64,
        }
        reason "spiral-lines";
        says "the lines of curvature are spirals that come back {shift} higher or lower (edge length {edge}): a \
            closed net leaves the surface by about half of that";

        /// The edges of a grid along lines of curvature are of very different lengths.
        UnevenEdges {
            /// Which grid, from 0.
            piece: usize,
            /// The shortest and the longest.
            edges: [f64; 2],
            /// Largest ratio that is not reported.
            limit: f64,
        }
        reason "uneven-edges";
        at *piece;
        says "the edges of grid {piece} are {} to {} long, which differ by more than a factor of {limit}: lines of \
            curvature converge there", ShortNumber(edges[0]), ShortNumber(edges[1]);
    }
}

/// A part of a whole, in percent with one decimal.
fn percent(part: f64) -> ShortNumber {
    ShortNumber((1000.0 * part).round() / 10.0)
}
